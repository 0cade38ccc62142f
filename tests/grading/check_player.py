"""The player of the checks: it lets the loop of the program do some ticks."""

from collections.abc import Callable

from grading.words import plural
from support.start.mistake import is_pend_list


class CheckPlayer:
    """Answers is_running or rate in a check of the program, and records what the loop has done."""

    def __init__(self, ticks: int, change: Callable = lambda pend_list: None):
        """ticks is the number of ticks of a run; change(pend_list) is called before the first."""
        self.ticks = ticks
        self.change = change

    def __repr__(self) -> str:
        return plural(self.ticks, "tick", "ticks")

    def begin(self) -> None:
        """A run of the program begins: forget the one before."""
        self.pend_list: list = []
        self.states: list = []  # (omega, theta) of each pendulum, at each question

    def is_running(self, pend_list: list) -> bool:
        if not is_pend_list(pend_list):
            raise TypeError("is_running needs pend_list, a list of dictionaries")
        self.pend_list = pend_list
        if not self.states:
            self.change(pend_list)
        self.states.append([(pend["omega"], pend["theta"]) for pend in pend_list])
        return len(self.states) <= self.ticks
