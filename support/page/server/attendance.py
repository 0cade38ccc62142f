"""Which pages are there, and which will come: when none will, the program ends.

A page says goodbye when it is left, and whether its tab is closed for sure. When the last page has
gone, the program waits for it, and then ends: after CLOSED, LEFT or LOST seconds. Times are counted
in looks, one each LOOK_AT_TABS seconds: while a laptop sleeps, nobody loses time.
"""

from collections.abc import Callable, Collection
from math import inf

LOOK_AT_TABS = 0.5  # s from one look of the server at the tabs to the next
LOADS = ""  # stands for the name of a page that loads
LOADING = 30.0  # s that a page has from its request to its websocket
# s that a page has to come back
CLOSED = 3.0  # whose tab is closed for sure: a closed tab can be opened again
LEFT = 25.0  # that you have left, or closed: Back or a reload shows it again
LOST = 60.0  # that has said nothing: its line is cut, or its machine sleeps
FLICKER = 3.0  # s after which the terminal says that the page has gone


class Attendance:
    """How long the program still waits for pages that have gone, or that load."""

    def __init__(self, arrived: Callable[[], None]) -> None:
        """Wait for the first page as long as it takes; call arrived() when a page is there."""
        self.arrived = arrived
        self.rests: dict[str, float] = {LOADS: inf}  # s, by the names of the pages
        self.absence = 0.0  # s since the last page has gone
        self.is_missed = False  # whether the terminal says so

    def expect_one_that_loads(self) -> None:
        """Expect a page that has been asked for."""
        self.rests[LOADS] = max(self.rests.get(LOADS, 0.0), LOADING)

    def welcome(self, page_name: str, was: str) -> None:
        """Hear that a page has its websocket: its name, and the one that it had before a reload."""
        for name in (LOADS, page_name, was):
            self.rests.pop(name, None)
        if self.is_missed:
            print("The page is back.", flush=True)
        self.is_missed = False
        self.absence = 0.0
        self.arrived()

    def lose(self, page_name: str, seconds: float) -> None:
        """Hear a goodbye of a page, or that its websocket has ended, one after the other.

        Expect it back for no longer than this.
        """
        self.rests[page_name] = min(self.rests.get(page_name, LOST), seconds)

    def look(self, present: Collection) -> bool:
        """Look at which pages are present; return whether one is, or may still come."""
        rests = {page_name: rest - LOOK_AT_TABS for page_name, rest in self.rests.items()}
        self.rests = {page_name: rest for page_name, rest in rests.items() if rest >= 0}
        if present or LOADS in self.rests:
            return True
        self.absence += LOOK_AT_TABS
        rest = max(self.rests.values(), default=0.0)
        if rest > CLOSED and self.absence >= FLICKER and not self.is_missed:
            self.is_missed = True
            print(
                "The page has gone: you have left or closed it, its line is cut, or its machine "
                f"sleeps. The program waits {int(rest)} s for it. Ctrl+C ends it at once.",
                flush=True,
            )
        return bool(self.rests)
