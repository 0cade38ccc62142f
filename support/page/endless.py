"""Find a function that never returns: its loop asks the player nothing any more."""

import sys
import threading
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

from support.cradle.player import PLAYER_FILE
from support.start.mistake import is_in_src

LOOK = 0.5  # s from look to look
TOO_LONG = 3.0  # s after which a function that has not returned is named


class Watch:
    """Watches a loop from another thread."""

    def __init__(self, progress: Callable[[], Any], tell: Callable[[str], object]):
        """Watch the loop in this thread.

        progress() returns what changes with each tick and each frame. tell gets a sentence about
        the function that does not return, and an empty one when it has.
        """
        self.progress = progress
        self.tell = tell
        self.thread = threading.get_ident()
        self.last = progress()
        self.looks = 0  # since this has changed last
        # Of the handout's functions that have not returned since then, the innermost one first
        self.frames: list[FrameType] = []
        self.words = ""
        self.has_ended = threading.Event()  # whether nothing is to be watched any more

    def start(self) -> None:
        """Look again and again, in a thread of its own, until stop."""
        threading.Thread(target=self.keep_looking, daemon=True).start()

    def stop(self) -> None:
        self.has_ended.set()

    def keep_looking(self) -> None:
        while not self.has_ended.wait(LOOK):
            self.look()

    def look(self) -> None:
        """Tell which function has not returned for TOO_LONG seconds, or that it has.

        It counts looks, not time: a process that was stopped, or a laptop that slept, has not run.
        """
        progress = self.progress()
        frames = running(self.thread)
        if progress != self.last:
            self.last = progress
            self.looks = 0
            self.frames = frames
            self.say("")
            return
        self.looks += 1
        self.frames = [frame for frame in self.frames if frame in frames]
        if self.looks * LOOK == TOO_LONG and self.frames:
            innermost = self.frames[0]
            name = Path(innermost.f_code.co_filename).name
            place = f"{innermost.f_code.co_name} in src/{name}, line {innermost.f_lineno}"
            self.say(
                f"{place}, has been running for {TOO_LONG:.0f} s and has not returned. If a loop "
                "in it never ends, press Ctrl+C in the terminal, and mend it."
            )

    def say(self, words: str) -> None:
        if words != self.words:
            self.words = words
            self.tell(words)


def running(thread: int) -> list[FrameType]:
    """Return the frames of the handout's functions that the player's loop in this thread is in, the
    innermost first.

    There are none while the loop waits for the player.
    """
    frames = []
    frame = sys._current_frames().get(thread)
    while frame and frame.f_code.co_filename != PLAYER_FILE:
        if is_in_src(frame.f_code.co_filename):
            frames.append(frame)
        frame = frame.f_back
    return frames if frame else []
