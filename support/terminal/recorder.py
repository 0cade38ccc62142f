"""Write a cradle's data to a file, as fast as the machine can."""

import shutil
import sys
import time
from contextlib import contextmanager, suppress

from support.files.recording import data_file
from support.playback.player import Player, run
from support.start.output import in_one_line
from support.terminal.screen import switch_on_escapes

PART = 1000  # ticks from one report of the progress to the next
PATIENCE = 2.0  # s before a bar shows the progress
REFRESH = 0.05  # s from one bar to the next


class Recorder(Player):
    """Writes a row of data for every options.every seconds of simulated time, as fast as the machine can."""

    def __init__(self, cradle, csv, options, writer, progress):
        """Write with writer, made by data_file; call progress(part) again and again with the finished part, 0 to 1.

        options has angle, lift, seconds and every, from read_text_options.
        """
        super().__init__(cradle, csv, [options.angle], options.lift, 1)
        self.at_once, self.step = True, round(options.every / cradle.dt)
        self.count = int(options.seconds / options.every + 1e-9) + 1  # rows
        self.writer, self.progress = writer, progress

    def script(self):
        """Write all rows, the first one before any tick."""
        yield from self.make()
        self.writer.writerow(self.motion.sample())
        self.note()
        last = (self.count - 1) * self.step
        while self.motion.ticks < last:
            yield from self.advance(min(PART, last - self.motion.ticks))
            self.progress(self.motion.ticks / last)

    def note(self) -> None:
        """Write a row."""
        self.writer.writerow(self.motion.sample().values())


def record(loop, cradle, csv, options, remark="") -> None:
    """Write the data of options.seconds to the file options.record, whole or not at all."""
    with data_file(options.record) as writer, progress_bar() as progress:
        recorder = Recorder(cradle, csv, options, writer, progress)
        run(loop, recorder)
    print(remark, end="\n" if remark else "")
    line = f"{recorder.count} rows, from t = 0 to {recorder.motion.time():g} s, are in {options.record}"
    print(in_one_line(line))


@contextmanager
def progress_bar(clock=time.monotonic):
    """Yield progress(part), which takes the finished part, 0 to 1. If it takes long, a terminal shows it as a bar."""
    begin = clock()
    next_look = begin + PATIENCE

    def progress(part):
        nonlocal next_look
        if clock() > next_look and sys.stderr.isatty():
            next_look = clock() + REFRESH
            left = (clock() - begin) * (1 - part) / part
            width = max(1, min(40, shutil.get_terminal_size().columns - 25))
            show_progress(f"\r[{'#' * int(part * width):<{width}}] {part:4.0%}, {left:.0f} s left ")

    try:
        yield progress
    finally:
        if next_look > begin + PATIENCE:
            switch_on_escapes()
            show_progress("\r\x1b[K")


def show_progress(text) -> None:
    """Write text to the terminal, if it still exists: the file does not depend on it."""
    with suppress(OSError):
        print(text, end="", file=sys.stderr, flush=True)
