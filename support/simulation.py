"""The condition of a program's loop: is_running, or VPython's rate in its place.

A program is a file of src/ that makes pend_list and moves it in a loop. The loop asks before each
tick; the player answers.
"""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any, Protocol


class Player(Protocol):
    """Shows a cradle, and says when to tick: the page, the terminal, a data file, or a check."""

    def is_running(self, pend_list: list) -> bool:
        """Wait until the next tick is due; return False when the run is over."""


class OverError(BaseException):
    """Ends a loop that goes on although its run is over; `except Exception` does not catch it."""


class Run:
    """A run of a program: what its loop asks, and who answers."""

    def __init__(self, player: Player) -> None:
        self.player = player
        self.asks_is_running = False  # then rate does nothing
        self.is_over = False

    def ask(self, pend_list: list) -> bool:
        """Return the player's answer; raise an OverError if it was already False."""
        if self.is_over:
            raise OverError
        self.is_over = not self.player.is_running(pend_list)
        return not self.is_over


now: Run | None = None  # the present run


def is_running(pend_list: list) -> bool:
    """Wait until the next tick of pend_list is due; return False when the run is over.

    The first call shows the cradle. For another cradle, the program runs again from its top.
    """
    if now is None:
        raise RuntimeError(
            "is_running needs a program: `import begin_page` begins it, and its loop stands "
            "below if __name__ == '__main__'"
        )
    now.asks_is_running = True
    return now.ask(pend_list)


def rate(*_: Any, **__: Any) -> None:
    """Stand in for VPython's rate: wait until the next tick is due; end the loop after the run.

    It finds pend_list among the names of the loop. In a loop that asks is_running, and while there
    is no pend_list yet, it does nothing.
    """
    if now is None or now.asks_is_running:
        return
    pend_list = pend_list_in(sys._getframe(1))  # the frame of the loop
    if pend_list and not now.ask(pend_list):
        raise OverError


def pend_list_in(frame: FrameType) -> list:
    """Return the first list of pendula among the names in a Python frame, or an empty list."""
    for value in (*frame.f_locals.values(), *frame.f_globals.values()):
        if isinstance(value, list) and value and all(map(is_pendulum, value)):
            return value
    return []


def is_pendulum(value: Any) -> bool:
    """Return whether a value is a pendulum with its objects."""
    return isinstance(value, dict) and "objects" in value


def run(program: Callable[[], Any], player: Player) -> None:
    """Run a program whose loop asks this player."""
    global now
    now = Run(player)
    try:
        program()
    except OverError:
        pass  # the run was over
    finally:
        now = None
