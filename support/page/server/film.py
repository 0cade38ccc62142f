"""The film of this run: its pictures, to be saved as a file, also without a tab.

A picture has what has changed since the picture before it, the first one has all.
"""

import time
from collections import deque
from collections.abc import Callable
from math import inf
from typing import NamedTuple

from support.page.server.changes import Changes

PICTURE = 0.03  # s from picture to picture, at least
KEPT = 30.0  # s: of a longer run, the film of a page keeps the end
LONGEST_PAUSE = 3.0  # s: the film shortens a longer pause to this


class FilmPicture(NamedTuple):
    """A picture of a film: its time (s since the start of the run), and its changes."""

    time: float
    changes: dict[str, dict]  # as Changes.later returns them


class Film:
    """Takes pictures of all that tabs get."""

    def __init__(self, clock: Callable[[], float] = time.monotonic, kept: float = KEPT):
        """Begin without a picture; clock() returns a time (s). Keep the last `kept` seconds."""
        self.clock = clock
        self.kept = kept
        self.begin()

    def begin(self) -> None:
        self.pictures: deque[FilmPicture] = deque()
        self.delivered = 0  # the number of the last delivery in it
        self.last_look = -inf  # on the clock: when the last picture was taken
        self.time = 0.0  # s of the film, up to this picture

    def take(self, changes: Changes, at_once: bool = False) -> None:
        """Take a picture of what is later than the last one, if it is due, or at once.

        It is due at once if the question has changed: the film stops at each question.
        """
        now = self.clock()
        gap = now - self.last_look
        asked, _ = changes.state.get("question", (0, None))
        is_due = at_once or gap >= PICTURE or asked > self.delivered
        if self.delivered == changes.number or not is_due:
            return
        if self.pictures:
            self.time += min(gap, LONGEST_PAUSE)
        self.pictures.append(FilmPicture(self.time, changes.later(self.delivered)))
        self.delivered = changes.number
        self.last_look = now
        while self.time - self.pictures[0].time > self.kept:
            self.forget_first()

    def forget_first(self) -> None:
        """Begin with the second picture: it then has all."""
        first = self.pictures.popleft().changes
        second = self.pictures[0].changes
        for part, new in second.items():
            old = {key: change for key, change in first[part].items() if key not in new}
            second[part] = old | new
