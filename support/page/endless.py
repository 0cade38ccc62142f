"""Find a function that does not return; it is stopped when you save a file."""

import sys
import threading
from collections.abc import Callable
from ctypes import c_ulong, py_object, pythonapi
from types import FrameType
from typing import Any

from support.cradle.player import PLAYER_FILE
from support.simulation import OverError
from support.start.mistake import is_in_src, place_of

LOOK = 1 / 8  # s from look to look
TOO_LONG = 3.0  # s after which a function that has not returned is named
STAYS = (
    f"the program has been here for {TOO_LONG:.0f} s. If it asks in the terminal, answer there. "
    "If a loop never ends here, mend it, and save the file."
)


class Watch:
    """Watches a program's loop from another thread."""

    def __init__(
        self,
        progress: Callable[[], Any],
        tell: Callable[[dict[str, str]], object],
        is_wanted: Callable[[], bool],
    ):
        """Watch the loop in this thread.

        progress() returns what changes with each tick and each frame. tell gets a sentence about
        the function that does not return, and an empty one when it has. is_wanted() returns
        whether another run is wanted, as after a save: the function is then stopped.
        """
        self.progress = progress
        self.tell = tell
        self.is_wanted = is_wanted
        self.thread = threading.get_ident()
        self.last = progress()
        self.looks = 0  # since this has changed last
        # Of functions of src/ that have not returned since then, the innermost one first
        self.frames: list[FrameType] = []
        self.words = ""
        self.has_ended = threading.Event()  # whether nothing is to be watched any more

    def start(self) -> None:
        """Look again and again, in a thread of its own, until stop."""
        self.watcher = threading.Thread(target=self.keep_looking, daemon=True)
        self.watcher.start()

    def stop(self) -> None:
        self.has_ended.set()
        self.watcher.join()

    def keep_looking(self) -> None:
        while not self.has_ended.wait(LOOK):
            self.look()

    def look(self) -> None:
        """Tell which function has not returned for TOO_LONG seconds, or that it has.

        It counts looks, not time: a process that was stopped, or a laptop that slept, has not run.
        """
        progress = self.progress()
        frames = running(self.thread)
        if progress != self.last or not self.frames:
            self.last = progress
            self.looks = 0
            self.frames = frames
            self.say("")
            return
        self.looks += 1
        self.frames = [frame for frame in self.frames if frame in frames]
        if self.frames and self.looks == round(TOO_LONG / LOOK):
            stays = self.frames[0]
            place = place_of(stays.f_code.co_filename, stays.f_lineno)
            self.say(f"{place}: {STAYS}")
        # Again and again: a bare except can catch it.
        if self.words and self.is_wanted() and running(self.thread):
            raise_in(self.thread, OverError)

    def say(self, words: str) -> None:
        if words != self.words:
            self.words = words
            self.tell({"endless": words})


def raise_in(thread: int, error: type[BaseException]) -> None:
    """Raise this error in a thread, as soon as it runs a line of Python."""
    pythonapi.PyThreadState_SetAsyncExc(c_ulong(thread), py_object(error))


def running(thread: int) -> list[FrameType]:
    """Return the Python frames of src/ in this thread, the innermost one first.

    There are none while the loop waits for the player.
    """
    frames = []
    frame = sys._current_frames().get(thread)
    while frame and frame.f_code.co_filename != PLAYER_FILE:
        if is_in_src(frame.f_code.co_filename):
            frames.append(frame)
        frame = frame.f_back
    return frames if frame else []
