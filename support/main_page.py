"""What main asks of the page that shows its cradle."""

from collections.abc import Callable
from typing import Protocol


class Page(Protocol):
    """Shows a cradle, and says when to tick: in the browser, in the terminal, or as data in a file.

    support/cradle/player.py has what all three do.
    """

    @property
    def csv(self) -> str:
        """The path of a CSV of the cradle: your file, or one with what an experiment or the page
        has in its place.
        """

    @property
    def rule(self) -> dict[str, bool]:
        """The last argument of newton_cradle_tick: approaching_only by its name, or nothing."""

    def show(self, pend_list: list) -> None:
        """Show a new cradle."""

    def is_running(self) -> bool:
        """Wait until the next tick is due; return False when the cradle must not tick any more."""


Loop = Callable[[Page], None]  # main, or a loop in its place
