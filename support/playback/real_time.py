"""The pace of a simulation, in step with the clock on the wall."""

import time
from math import inf

# One picture (s): the page asks for new positions about sixty times a second.
FRAME = 1 / 60

# Ticking takes at most this much of a frame (s), so that the threads that serve the page get their turn as well.
BUSY = 0.75 * FRAME

# How far behind the clock the simulation may be (s). A hiccup up to this long is made up for; what is beyond (a slow
# machine, a laptop that slept) is dropped.
MAX_BEHIND = 0.25

# A tick may seem to be this much slower than in the frame before, and no more: a frame in which the machine was busy
# with something else says little about the next one.
SLOWER = 1.25

# Which part of the time single ticks may take: the page's threads and the browser take theirs.
ENOUGH_TIME = 0.5

# In how many frames it is measured what a tick costs, before that counts as too much.
ENOUGH = 10

# Over how long (s) it is measured how well the machine keeps up.
KEPT_UP_OVER = 1.0


class RealTime:
    """Lets a simulated second, of 1/dt ticks, last a second on the wall, or 1/speed seconds.

    A machine too slow for that shows slow motion. VPython's rate() can do neither: it is off by a tenth and more, and
    it waits by keeping a processor core busy.
    """

    def __init__(self, dt, clock=time.perf_counter, sleep=time.sleep):
        """Begin now; dt (s) is one tick. clock() and sleep(seconds) may be replaced by a test's."""
        self.dt, self.clock, self.sleep = dt, clock, sleep
        self.speed = 1.0
        self.tick_cost, self.least_cost, self.measured = 0.0, inf, 0
        self.forget_costs()
        self.restart()

    def restart(self) -> None:
        """Begin anew at this moment, owing no ticks."""
        self.frame_start = self.span_start = self.clock()
        self.owed = 0.0  # ticks, and the fraction of one
        self.span_due = self.span_done = 0.0  # ticks
        self.kept_up = 1.0  # the part of the ticks due that the machine did over the last KEPT_UP_OVER

    def due(self) -> int:
        """Begin a frame, and return how many ticks must be done in it; call did(ticks) after them."""
        now = self.clock()
        per_second = self.speed / self.dt
        due = (now - self.frame_start) * per_second
        self.frame_start = now
        self.owed = min(self.owed + due, MAX_BEHIND * per_second)
        ticks = int(min(self.owed, max(1, BUSY / self.tick_cost) if self.tick_cost else 1))
        self.owed -= ticks
        self.span_due += due
        self.span_done += ticks
        if now - self.span_start >= KEPT_UP_OVER:
            self.kept_up = self.span_done / self.span_due
            self.span_start = now
            self.span_due = self.span_done = 0.0
        return ticks

    def did(self, ticks) -> None:
        """Learn what ticks cost: so many, more than none, have been done since due()."""
        cost = max(self.clock() - self.frame_start, 1e-9) / ticks
        self.tick_cost = min(cost, SLOWER * self.tick_cost) if self.tick_cost else cost
        self.least_cost = min(cost, self.least_cost)
        self.measured += 1

    def is_too_slow(self) -> bool:
        """Return whether ticks cost too much for this speed, the least in ENOUGH frames: others may have disturbed."""
        return self.measured >= ENOUGH and self.least_cost * self.speed / self.dt > ENOUGH_TIME

    def forget_costs(self) -> None:
        """Forget what ticks cost: they will be others."""
        self.tick_cost = 0.0  # s, 0 as long as it is not known
        self.least_cost, self.measured = inf, 0  # s, and in how many frames it was measured

    def rest(self) -> None:
        """Sleep until the next frame is due."""
        self.sleep(max(0, self.frame_start + FRAME - self.clock()))

    def remark(self) -> str:
        """Return which part of the speed the machine reaches, as in x0.6, or nothing where it keeps up."""
        return f"x{self.kept_up:.1f}" if self.kept_up < 0.95 else ""
