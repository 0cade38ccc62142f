"""Print the cradle in the terminal, a line each half second, or write its data to a file."""

import csv
import sys
from argparse import Namespace
from contextlib import nullcontext, redirect_stdout
from math import degrees, inf, pi, remainder
from pathlib import Path
from typing import Any

from support.cradle.cradle import Cradle
from support.cradle.motion import Motion, percent_as_text, Sample
from support.cradle.player import Player, run_for_each_cradle
from support.cradle.settings import Settings
from support.files.data_file import whole_file
from support.start.output import in_one_line, Progress, progress_bar

TICKS_A_FRAME = 1000  # ticks from one report of a recording's progress to the next
HALF_SECOND = 0.5  # s from line to line


def columns_of(motion: Motion) -> dict[str, str]:
    """Return the time, the energy and the angles of the bobs as texts, by the heading of each.

    All have 8 or 16 letters: where a terminal wraps a long line, no number is split.
    """
    angles = []
    for theta in motion.cradle.values("theta"):
        angle = degrees(remainder(theta, 2 * pi))
        angles.append(f"{angle:z8.1f}")  # z: no -0.0
    columns = {
        "   t (s)": f"{motion.time():8.2f}",
        "          energy": percent_as_text(motion.energy_percent()).rjust(16),
        "   angle of each bob (degrees, positive to the right)": "".join(angles),
    }
    return motion.cradle.without_hidden(columns)


class Lines(Player):
    """Prints a line at the start, every half second in step with the clock, and at the end."""

    def __init__(self, cradle: Cradle, settings: Settings, seconds: float) -> None:
        """Play `seconds` (s) of the cradle of these settings; inf has no end."""
        super().__init__(cradle, settings, HALF_SECOND)
        ticks = seconds / cradle.dt
        self.last = ticks if ticks == inf else round(ticks)  # tick
        self.has_remark = False  # whether it has printed one on this run

    def show_new_cradle(self) -> None:
        print_remarks(self)
        print("".join(columns_of(self.motion)))
        self.take_sample()
        self.pace.restart()

    def frame(self) -> None:
        """Rest, and plan the ticks that are due."""
        self.is_over = self.motion.ticks >= self.last
        if not self.is_over:
            self.pace.rest()
            self.keep_time(self.last - self.motion.ticks)
        elif self.last % self.step:
            self.take_sample()

    def take_sample(self) -> None:
        """Print a line, and before it, once, how slow the machine is."""
        remark = self.pace.remark()
        if remark and not self.has_remark:
            print(remark)
            self.has_remark = True
        print("".join(columns_of(self.motion).values()), flush=True)


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
        super().__init__(cradle, settings, options.every)
        ticks = int(options.seconds / cradle.dt + 1e-6)  # 10 / 0.001 could be 9999.999999999999
        self.last = ticks - ticks % self.step  # the tick of the last row
        self.writer = writer
        self.progress = progress

    def show_new_cradle(self) -> None:
        self.writer.writerow(self.shown_sample())  # its names
        self.take_sample()

    def frame(self) -> None:
        """Report the progress, and plan the next ticks."""
        self.is_over = self.motion.ticks >= self.last
        if self.motion.ticks:
            self.progress(self.motion.ticks / self.last)
        self.plan(min(TICKS_A_FRAME, self.last - self.motion.ticks))

    def take_sample(self) -> None:
        self.writer.writerow(self.shown_sample().values())

    def shown_sample(self) -> Sample:
        return self.cradle.without_hidden(self.motion.sample())


def show(file: Path, cradle: Cradle, settings: Settings, options: Namespace) -> None:
    """Print the lines of options.seconds of a program, this file."""
    run_for_each_cradle(file, Lines(cradle, settings, options.seconds))


def record(file: Path, cradle: Cradle, settings: Settings, options: Namespace) -> None:
    """Write the data of options.seconds to the file options.record, whole or not at all.

    The name - stands for the output.
    """
    is_printed = options.record == "-"
    target: Any = nullcontext(sys.stdout) if is_printed else whole_file(options.record)
    # Words are no data, also those of a student's function
    with redirect_stdout(sys.stderr if is_printed else sys.stdout):
        no_bar: Any = nullcontext(lambda done: None)  # it would stand in the rows
        bar = no_bar if is_printed else progress_bar()
        with target as data, bar as progress:
            rows = csv.writer(data, lineterminator="\n")
            recorder = DataRecorder(cradle, settings, options, rows, progress)
            run_for_each_cradle(file, recorder)
        print_remarks(recorder)
    if not is_printed:
        count = recorder.last // recorder.step + 1
        end = f"{recorder.motion.time():.15g} s"
        print(in_one_line(f"{count} rows, from t = 0 to {end}, are in {options.record}"))


def print_remarks(player: Player) -> None:
    """Print what there is to say about a run."""
    for remark in player.remarks:
        print(remark)
