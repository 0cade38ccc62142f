"""Show the cradle in the terminal, as a moving picture or as lines, or write its data to a file."""

import csv
import os
import shutil
import signal
import sys
import textwrap
from argparse import Namespace
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stdout
from math import inf
from typing import Any

from support.cradle.cradle import Cradle
from support.cradle.impacts import in_line
from support.cradle.motion import Motion
from support.cradle.player import Player, run
from support.cradle.settings import Settings
from support.files.data_file import whole_file
from support.main_page import Loop
from support.start.output import in_one_line, Progress, progress_bar, say, switch_on_escapes
from support.terminal.text_picture import TextPicture

TICKS_A_FRAME = 1000  # ticks from one report of a recording's progress to the next
WIDTH = 80  # columns, at most
ROWS = 24  # of a terminal that does not know its size
SERIES = 4  # of impacts, a line for each
LOW = 18  # lines; a terminal with fewer lines shows no impacts
OWN_SCREEN, OLD_SCREEN = "\x1b[?1049h\x1b[?25l", "\x1b[?25h\x1b[?1049l"  # the first has no cursor


def has_terminal() -> bool:
    """Return whether the output is a terminal that can show pictures.

    IDLE's shell claims to be one, but cannot.
    """
    return sys.stdout.isatty() and sys.stdout is sys.__stdout__ and os.environ.get("TERM") != "dumb"


@contextmanager
def own_screen(last_lines: Callable[[], list[str]]) -> Iterator[None]:
    """Use a separate screen, without a cursor.

    Afterwards, the terminal shows its old lines again, and last_lines().
    """
    switch_on_escapes()
    # Ctrl+Z would leave this screen to the shell; Windows has no signal for it
    if hasattr(signal, "SIGTSTP"):
        signal.signal(signal.SIGTSTP, signal.SIG_IGN)
    print(OWN_SCREEN, end="")
    try:
        yield
    finally:
        say(OLD_SCREEN + "\n".join(last_lines()))  # if the terminal is not closed


def screen(motion: Motion, picture: TextPicture, speed: str, remark: str = "") -> list[str]:
    """Return the lines of the screen for the size of the terminal.

    speed and remark are texts, maybe empty.
    """
    size = shutil.get_terminal_size()
    # Python 3.10 returns 0 for a terminal that does not know its size
    columns = min(WIDTH, size.columns or WIDTH)
    rows = size.lines or ROWS
    above = [motion.reading(), *textwrap.wrap(remark, columns), speed]
    below = []
    if rows >= LOW:
        impacts = motion.impacts.lines(columns)
        free = [""] * (SERIES - len(impacts))
        below = ["", "Impacts", *impacts, *free, "", "Ctrl+C ends it."]
    cradle = picture.lines(motion.cradle, columns, rows - len(above) - len(below))
    lines = above + cradle + below
    return [line[:columns].rstrip() for line in lines[:rows]]


class TextPlayer(Player):
    """Plays a cradle in step with the clock.

    It shows the cradle at the start, every step_seconds, and at the end.
    """

    step_seconds: float

    def __init__(self, cradle: Cradle, settings: Settings, options: Namespace) -> None:
        """Play the cradle of these settings; options has the seconds of read_text_options."""
        super().__init__(cradle, settings, SERIES, self.step_seconds)
        ticks = options.seconds / cradle.dt
        self.last = ticks if ticks == inf else round(ticks)  # tick

    def show_new_cradle(self) -> None:
        self.take_sample()
        self.pace.restart()

    def frame(self) -> None:
        """Rest, and plan the ticks that are due; at the end, show the cradle again."""
        self.is_over = self.motion.ticks >= self.last
        if not self.is_over:
            self.pace.rest()
            self.keep_time(self.last - self.motion.ticks)
        elif self.last % self.step:
            self.take_sample()


class Pictures(TextPlayer):
    """Shows the cradle as a moving picture."""

    step_seconds = 1 / 20

    def __init__(
        self, cradle: Cradle, settings: Settings, options: Namespace, remark: str = ""
    ) -> None:
        """Show the remark, if there is one, above the picture; the rest is as in TextPlayer."""
        super().__init__(cradle, settings, options)
        self.picture = TextPicture()
        self.own_remark = remark
        self.last_lines: list[str] = []  # of the last picture

    def take_sample(self) -> None:
        """Show a picture.

        Go to the top left corner; clear each line, and at the end all lines below.
        """
        remark = self.own_remark or self.cradle.remark()
        self.last_lines = screen(self.motion, self.picture, self.pace.remark(), remark)
        text = "\n".join("\x1b[K" + line for line in self.last_lines)
        print(f"\x1b[H{text}\x1b[J", end="", flush=True)


class Lines(TextPlayer):
    """Prints a line every half second."""

    step_seconds = 0.5

    def take_sample(self) -> None:
        print(in_line(self.motion.summary(), WIDTH), flush=True)
        self.motion.impacts.clear()


class DataRecorder(Player):
    """Writes a row of data for every options.every seconds, as fast as the machine can.

    These are seconds of simulated time. The last row is not later than options.seconds.
    """

    def __init__(
        self,
        cradle: Cradle,
        settings: Settings,
        options: Namespace,
        writer: Any,
        progress: Progress,
    ) -> None:
        """Write with a csv.writer, and call progress(done), 0 to 1, again and again.

        options are those of read_text_options.
        """
        super().__init__(cradle, settings, 1, options.every)
        ticks = int(options.seconds / cradle.dt + 1e-6)  # 10 / 0.001 could be 9999.999999999999
        self.last = ticks - ticks % self.step  # the tick of the last row
        self.writer = writer
        self.progress = progress

    def show_new_cradle(self) -> None:
        self.writer.writerow(self.motion.shown_sample())  # its names
        self.take_sample()

    def frame(self) -> None:
        """Report the progress, and plan the next ticks."""
        self.is_over = self.motion.ticks >= self.last
        if self.motion.ticks:
            self.progress(self.motion.ticks / self.last)
        self.plan(min(TICKS_A_FRAME, self.last - self.motion.ticks))

    def take_sample(self) -> None:
        self.writer.writerow(self.motion.shown_sample().values())


def record(
    loop: Loop, cradle: Cradle, settings: Settings, options: Namespace, remark: str = ""
) -> None:
    """Write the data of options.seconds to the file options.record, whole or not at all.

    The name - stands for the output.
    """
    if options.record == "-":
        rows = csv.writer(sys.stdout, lineterminator="\n")
        # Words are no data, also those of a student's function
        with redirect_stdout(sys.stderr):
            if remark:
                print(remark)
            run(loop, DataRecorder(cradle, settings, options, rows, progress=lambda done: None))
        return
    with whole_file(options.record) as file, progress_bar() as progress:
        rows = csv.writer(file, lineterminator="\n")
        recorder = DataRecorder(cradle, settings, options, rows, progress)
        run(loop, recorder)
    if remark:
        print(remark)
    count = recorder.last // recorder.step + 1
    end = f"{recorder.motion.time():.15g} s"
    print(in_one_line(f"{count} rows, from t = 0 to {end}, are in {options.record}"))
