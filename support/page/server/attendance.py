"""How long the program waits for a page that has gone, or that loads: then it ends.

Only tabs that command count. Each event sets a deadline, and the latest one counts.
"""

import time
from collections.abc import Callable
from math import inf

# s that a page has
LOADING = 30.0  # from its request to its websocket
CLOSED = 3.0  # whose websocket the browser has closed: you have left, closed or reloaded it
CUT = 65.0  # whose websocket has ended without a word: a cut, or a sleep, of a minute
STANDSTILL = 3.0  # s from one look to the next: the program, or its machine, has stood still


class Attendance:
    """Counts the tabs, and the time without one."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        """Wait for the first page as long as it takes; clock() returns a time (s)."""
        self.clock = clock
        self.count = 0  # tabs
        self.seconds = inf  # of the latest deadline
        self.deadline = inf  # on the clock
        self.last_look = clock()

    def wait(self, seconds: float) -> None:
        """Wait for a page for these seconds. The later of two deadlines counts."""
        deadline = self.clock() + seconds
        if deadline >= self.deadline:
            self.seconds = seconds
            self.deadline = deadline

    def welcome(self) -> None:
        """Count a tab that has come."""
        self.count += 1
        self.seconds = 0.0
        self.deadline = self.clock()

    def lose(self, is_cut: bool) -> None:
        """Count a tab that has gone: its connection was cut, or its browser has closed it."""
        self.count -= 1
        self.wait(CUT if is_cut else CLOSED)

    def look(self) -> bool:
        """Return whether a tab is there, or may still come.

        After a standstill, the time begins again, because no page could come during it.
        """
        now = self.clock()
        if now - self.last_look > STANDSTILL:
            self.deadline = now + self.seconds
        self.last_look = now
        return self.count > 0 or now < self.deadline
