"""The page that the checks of main give to it."""

import atexit
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from grading.cradles import MIXED_CSV

TEMPORARY = TemporaryDirectory(ignore_cleanup_errors=True)
atexit.register(TEMPORARY.cleanup)  # or Python warns of it at the end
FOLDER = Path(TEMPORARY.name)  # for CSV files, until the process ends
CRADLE = FOLDER / "cradle.csv"
CRADLE.write_text(MIXED_CSV)


class CheckPage:
    """The page for main in a check: it says when to tick, and records the result."""

    def __init__(
        self, *ticks: int, change: Callable = lambda pend_list: None, csv: str = str(CRADLE)
    ):
        """ticks has the number of ticks of each cradle.

        change(pend_list) is called when main shows a cradle.
        """
        self.ticks = ticks
        self.change = change
        self.csv = csv
        self.rule: dict = {}
        self.answers = self.answers_of_is_running()
        self.is_shown = False  # whether this cradle is
        self.cradles: list = []  # that were shown
        self.parts: list = []  # the objects of their pendula
        self.states: list = []  # (omega, theta) of the first pendulum at each call of is_running

    def __repr__(self) -> str:
        wishes = ["1 tick" if number == 1 else f"{number} ticks" for number in self.ticks]
        return f"a page that wants {', then a new cradle and '.join(wishes)}"

    def answers_of_is_running(self) -> Iterator[bool]:
        """Yield what is_running returns for each cradle: True for a tick, False at the end."""
        for number in self.ticks:
            for _ in range(number):
                yield True
            yield False

    def show(self, pend_list: Any) -> None:
        if self.is_shown:
            raise RuntimeError("page.show was called again. Show the cradle once, before the loop.")
        self.is_shown = True
        cradle = pend_list if isinstance(pend_list, list) else []
        self.cradles.append(cradle)
        for pend in cradle:
            self.parts += pend.get("objects", ())
        self.change(cradle)

    def is_running(self) -> bool:
        if self.is_shown:
            for pend in self.cradles[-1][:1]:
                self.states.append((pend["omega"], pend["theta"]))
            self.is_shown = next(self.answers, False)
        return self.is_shown
