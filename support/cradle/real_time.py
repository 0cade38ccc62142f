"""The pace of a simulation, in step with the clock."""

import time
from collections.abc import Callable
from math import inf

FRAME = 1 / 60  # s: a browser draws about sixty pictures a second
# s of a frame, after which no tick begins: the threads that serve the page need the rest.
BUSY = 0.9 * FRAME
# s of a delay that it makes up for; it leaves out the rest (of a laptop that slept).
MAX_BEHIND = 0.25
KEPT_UP_OVER = 1.0  # s over which kept_up is measured


class RealTime:
    """Makes a simulated second, 1/dt ticks, last 1/speed seconds on the clock.

    A machine that is too slow shows slow motion. VPython's rate() is wrong by a tenth and more, and
    keeps a core busy.
    """

    def __init__(
        self,
        dt: float,
        clock: Callable[[], float] = time.perf_counter,
        sleep: Callable[[float], None] = time.sleep,
    ):
        """Begin now; dt (s) is one tick. A test can replace clock() and sleep(seconds)."""
        self.dt = dt
        self.clock = clock
        self.sleep = sleep
        self.speed = 1.0
        self.restart()

    def restart(self) -> None:
        """Begin again at this moment, with no ticks due."""
        self.frame_start = self.clock()
        self.part = 0.0  # of a tick, which is due already
        self.kept_up = 1.0  # ticks done / ticks due over the last KEPT_UP_OVER
        self.begin_span(self.frame_start)

    def begin_span(self, now: float) -> None:
        """Begin to count the ticks over KEPT_UP_OVER."""
        self.span_start = now
        self.span_due = 0.0
        self.span_done = 0.0

    def due(self, most: float = inf) -> int:
        """Begin a frame, and return the number of ticks to do in it, at most `most`."""
        now = self.clock()
        if now - self.span_start >= KEPT_UP_OVER and self.span_due:
            self.kept_up = self.span_done / self.span_due
            self.begin_span(now)
        elapsed = now - self.frame_start
        self.frame_start = now
        per_second = self.speed / self.dt
        due = self.part + min(elapsed, MAX_BEHIND) * per_second
        self.part = due % 1
        ticks = int(min(due, most))
        self.span_due += elapsed * per_second
        self.span_done += ticks
        return ticks

    def leave_out(self, ticks: float) -> None:
        """Count these ticks as not done: the machine was too slow for them."""
        self.span_done -= ticks

    def rest(self) -> None:
        """Sleep until the next frame is due; a long frame ends with a rest, too."""
        self.sleep(max(FRAME - BUSY, self.frame_start + FRAME - self.clock()))

    def remark(self) -> str:
        """Return the speed that the machine reaches, as in 0.6x real time; "" if it keeps up."""
        if self.kept_up >= 0.95:
            return ""
        return f"{self.kept_up * self.speed:.2g}x real time"
