"""Find a function that never returns: its loop asks the player nothing any more."""

import sys
import threading
from pathlib import Path
from types import FrameType

from support.cradle.player import Player
from support.page.tabs import LOOK_AT_TABS
from support.start.mistake import is_handout_file, is_player_file

TOO_LONG = 3.0  # s after which a function that has not returned is named


class Watch:
    """Watches the loop of a player from another thread."""

    def __init__(self, player: Player):
        """Watch this player, whose loop is in this thread."""
        self.player = player
        self.thread = threading.get_ident()
        self.progress = (-1, 0.0)  # what changes with each tick and each frame
        self.looks = 0  # since this has changed last
        # Of the handout's functions that have not returned since then, the innermost one first
        self.frames: list = []
        self.words = ""

    def look(self) -> str:
        """Return which function has not returned for TOO_LONG seconds, or nothing.

        Call it each LOOK_AT_TABS seconds.

        It counts looks, not time: a process that was stopped, or a laptop that slept, has not run.
        """
        progress = self.player.motion.ticks, self.player.pace.frame_start
        frames = running(self.thread)
        if progress != self.progress:
            self.progress = progress
            self.looks = 0
            self.frames = frames
            self.words = ""
            return ""
        self.looks += 1
        self.frames = [frame for frame in self.frames if frame in frames]
        if self.looks * LOOK_AT_TABS == TOO_LONG and self.frames:
            innermost = self.frames[0]
            name = Path(innermost.f_code.co_filename).name
            place = f"{innermost.f_code.co_name} in src/{name}, line {innermost.f_lineno}"
            self.words = (
                f"{place}, has been running for {TOO_LONG:.0f} s and has not returned. If a loop "
                "in it never ends, press Ctrl+C in the terminal, and mend it."
            )
        return self.words


def running(thread: int) -> list[FrameType]:
    """Return the frames of the handout's functions that the player's loop in this thread is in, the
    innermost first.

    There are none while the loop waits for the player.
    """
    frames = []
    frame = sys._current_frames().get(thread)
    while frame and not is_player_file(frame.f_code.co_filename):
        if is_handout_file(frame.f_code.co_filename):
            frames.append(frame)
        frame = frame.f_back
    return frames if frame else []
