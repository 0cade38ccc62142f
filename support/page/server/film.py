"""The film of the present run: the pictures that tabs were given, to be saved as a file.

A picture (a frame) is a message to a tab: what has changed since the picture before it. A whole
picture (a key frame) has all, as for a new tab: the film begins with one, and you can begin to look
at each of them.
"""

import time
from collections import deque
from collections.abc import Callable
from math import inf
from typing import NamedTuple

from support.page.server.changes import Changes

PICTURE = 0.03  # s from picture to picture, at least
WHOLE = 5.0  # s from one whole picture to the next one, at least
KEPT = 30.0  # s: of a longer run, the film of a page keeps the end, up to WHOLE more
LONGEST_PAUSE = 3.0  # s: the film shortens a longer pause to this


class FilmPicture(NamedTuple):
    """A picture of a film."""

    time: float  # s since the start of the run
    message: bytes
    is_whole: bool


class Film:
    """Takes pictures of all that tabs get."""

    def __init__(self, clock: Callable[[], float] = time.monotonic, kept: float = KEPT):
        """Begin without a picture; clock() returns a time (s). Keep the last `kept` seconds."""
        self.clock = clock
        self.kept = kept
        self.begin()

    def begin(self) -> None:
        """Begin the film of a new run."""
        self.pictures: deque[FilmPicture] = deque()
        self.has = 0  # the number of the last delivery in it
        self.last_look = -inf  # on the clock: when the last picture was taken
        self.time = 0.0  # s of the film, up to this picture
        self.last_whole = -inf  # s of the film

    def take(self, changes: Changes, at_once: bool = False) -> None:
        """Take a picture if it is due, or at once, of what is later than the last one."""
        now = self.clock()
        gap = now - self.last_look
        if self.has == changes.number or not (at_once or gap >= PICTURE):
            return
        if self.pictures:
            self.time += min(gap, LONGEST_PAUSE)
        is_whole = self.time - self.last_whole >= WHOLE
        message = changes.message(0 if is_whole else self.has)
        self.pictures.append(FilmPicture(self.time, message, is_whole))
        self.has = changes.number
        self.last_look = now
        if is_whole:
            self.last_whole = self.time
            self.forget_start()

    def forget_start(self) -> None:
        """Drop the first pictures, up to a whole one, if the rest is long enough."""
        later = [picture.time for picture in self.pictures if picture.is_whole][1:]
        if later and self.time - later[0] >= self.kept:
            while self.pictures[0].time < later[0]:
                self.pictures.popleft()
