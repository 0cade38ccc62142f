"""The pace of a simulation, in step with the clock on the wall."""

import time
from math import inf

# One frame (s): the page asks for new positions about sixty times a second.
FRAME = 1 / 60

# Ticks take at most this much of a frame (s): the threads that serve the page need the rest.
BUSY = 0.75 * FRAME

# The simulation makes up for a delay up to this long (s). It drops the rest of a longer delay (a slow machine, a laptop
# that slept).
MAX_BEHIND = 0.25

# From one frame to the next, the measured cost of a tick grows at most by this factor: a frame in which the machine was
# busy with something else says little about the next one.
SLOWER = 1.25

# The part of the time that single ticks may take: the page's threads and the browser need the rest.
ENOUGH_TIME = 0.5

# The cost of a tick counts as too high only after it was measured in this many frames.
ENOUGH = 10

# The time (s) over which kept_up is measured.
KEPT_UP_OVER = 1.0


class RealTime:
    """Makes a simulated second, 1/dt ticks, last 1/speed seconds on the wall.

    A machine that is too slow for this shows slow motion. VPython's rate() is no replacement: it is wrong by a tenth
    and more, and keeps a processor core busy while it waits.
    """

    def __init__(self, dt, clock=time.perf_counter, sleep=time.sleep):
        """Begin now; dt (s) is one tick. A test can replace clock() and sleep(seconds)."""
        self.dt, self.clock, self.sleep = dt, clock, sleep
        self.speed = 1.0
        self.tick_cost, self.least_cost, self.measured = 0.0, inf, 0
        self.forget_costs()
        self.restart()

    def restart(self) -> None:
        """Begin again at this moment, with no ticks due."""
        self.frame_start = self.span_start = self.clock()
        self.owed = 0.0  # ticks, and the fraction of one
        self.span_due = self.span_done = 0.0  # ticks
        self.kept_up = 1.0  # ticks done / ticks due over the last KEPT_UP_OVER

    def due(self, least=1) -> int:
        """Begin a frame, and return the number of ticks to do in it; call did(ticks) after them.

        A slow machine does at least `least` ticks in a frame, if they are due.
        """
        now = self.clock()
        per_second = self.speed / self.dt
        due = (now - self.frame_start) * per_second
        self.frame_start = now
        self.owed = min(self.owed + due, MAX_BEHIND * per_second)
        ticks = int(min(self.owed, max(least, BUSY / self.tick_cost) if self.tick_cost else least))
        self.owed -= ticks
        self.span_due += due
        self.span_done += ticks
        if now - self.span_start >= KEPT_UP_OVER:
            self.kept_up = self.span_done / self.span_due
            self.span_start = now
            self.span_due = self.span_done = 0.0
        return ticks

    def did(self, ticks) -> None:
        """Measure the cost of a tick: `ticks` ticks, at least one, were done since due()."""
        cost = max(self.clock() - self.frame_start, 1e-9) / ticks
        self.tick_cost = min(cost, SLOWER * self.tick_cost) if self.tick_cost else cost
        self.least_cost = min(cost, self.least_cost)
        self.measured += 1

    def is_too_slow(self) -> bool:
        """Return whether ticks cost too much for this speed. The lowest cost counts: other programs may disturb."""
        return self.measured >= ENOUGH and self.least_cost * self.speed / self.dt > ENOUGH_TIME

    def forget_costs(self) -> None:
        """Forget the cost of a tick, because it is about to change."""
        self.tick_cost = 0.0  # s, 0 while it is not known
        self.least_cost, self.measured = inf, 0  # s, and the number of frames in which it was measured

    def rest(self) -> None:
        """Sleep until the next frame is due; a long frame ends with a rest, too."""
        self.sleep(max(FRAME - BUSY, self.frame_start + FRAME - self.clock()))

    def remark(self) -> str:
        """Return the part of the speed that the machine reaches, as in x0.6, or nothing if it keeps up."""
        return f"x{self.kept_up:.1f}" if self.kept_up < 0.95 else ""
