"""Show the cradle in the terminal, as a moving picture or as lines of text, or write its data to a
file.
"""

import os
import shutil
import signal
import sys
import textwrap
from contextlib import contextmanager, redirect_stdout
from csv import writer
from math import atan2, degrees, inf, pi, remainder

from support.cradle.impacts import in_line
from support.cradle.motion import in_words
from support.cradle.player import Player, run
from support.files.data_file import whole_file
from support.start.output import in_one_line, progress_bar, say, switch_on_escapes

PART = 1000  # ticks from one report of a recording's progress to the next
CORD = 16  # length of a cord in columns if they fit; neighbouring bobs are then four columns apart
STROKES = "-\\|/"  # a line to the right, and lines turned down from it by 45, 90 and 135 degrees
WIDTH = 80  # columns, at most
ROWS = 24  # of a terminal that does not know its size
TRAINS = 4  # of impacts, a line for each
LOW = 18  # lines; a terminal with fewer lines shows no impacts
OWN_SCREEN, OLD_SCREEN = "\x1b[?1049h\x1b[?25l", "\x1b[?25h\x1b[?1049l"  # the first has no cursor


def has_terminal() -> bool:
    """Return whether the output is a terminal that can show pictures.

    IDLE's shell claims to be one, but cannot.
    """
    return sys.stdout.isatty() and sys.stdout is sys.__stdout__ and os.environ.get("TERM") != "dumb"


@contextmanager
def own_screen(last_lines):
    """Use a separate screen, without a cursor; afterwards, the terminal shows its old lines again,
    and last_lines().
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


class TextPicture:
    """Draws a cradle in characters, which are twice as high as wide, always with the same part of
    space in view.
    """

    def __init__(self):
        """Show the space below the axles; once a bob has been above them, show the space up to
        there, too.
        """
        self.above = 0.0  # m

    def lines(self, cradle, columns, rows) -> list[str]:
        """Return the lines of a picture, at most `columns` wide and `rows` high; no line if it does
        not fit.
        """
        axles, bobs = [axle.pos for axle in cradle.axles()], [bob.pos for bob in cradle.bobs()]
        xs, ys = sorted(axle.x for axle in axles), sorted(axle.y for axle in axles)
        self.above = max(self.above, *(bob.y - ys[-1] for bob in bobs))
        left, width = xs[0] - cradle.reach, xs[-1] - xs[0] + 2 * cradle.reach
        top, height = ys[-1] + self.above, ys[-1] - ys[0] + cradle.reach + self.above
        # Columns per metre. Three columns and a row stay free for rounding, and for the brackets of
        # a bob.
        scale = min(CORD / cradle.reach, (columns - 3) / width, 2 * (rows - 1) / height)
        if scale <= 0:
            return []
        apart = (xs[-1] - xs[0]) / max(1, len(axles) - 1)
        # Whole columns from bob to bob: unequal gaps look like groups of bobs
        if apart * scale >= 1:
            scale = int(apart * scale + 1e-9) / apart
        grid = [[" "] * columns for _ in range(round(height * scale / 2) + 1)]

        def cell(place):
            return round((top - place.y) * scale / 2), round((place.x - left) * scale) + 1

        for cord in cradle.cords():
            (row, column), (end_row, end_column) = cell(cord.pos), cell(cord.pos + cord.axis)
            down, aside = end_row - row, end_column - column
            # One stroke per row, or per column
            steps = abs(down) if abs(aside) < 1.5 * abs(down) else abs(aside)
            stroke = STROKES[round(4 * atan2(-cord.axis.y, cord.axis.x) / pi) % 4]
            for step in range(steps):
                grid[row + round(down * step / steps)][column + round(aside * step / steps)] = (
                    stroke
                )

        places = sorted(map(cell, axles), key=lambda place: place[1])
        bar, first, last = places[0][0], places[0][1], places[-1][1]
        grid[bar][first - 1 : last + 2] = "=" * (last - first + 3)
        for row, column in places:
            grid[row][column] = "+"

        names = [f"({number})" for number in range(1, len(bobs) + 1)]
        names_fit = len(axles) == 1 or len(names[-1]) <= apart * scale + 1e-9
        for bob, name in zip(bobs, names if names_fit else "O" * len(bobs), strict=True):
            row, column = cell(bob)
            start = max(0, column - len(name) // 2)
            grid[row][start : start + len(name)] = name
        return ["".join(row)[:columns].rstrip() for row in grid]


def screen(motion, picture, speed, remark="") -> list[str]:
    """Return the lines of the screen for the size of the terminal; speed and remark are texts,
    maybe empty.
    """
    size = shutil.get_terminal_size()
    # Python 3.10 returns 0 for a terminal that does not know its size
    columns = min(WIDTH, size.columns or WIDTH)
    rows = size.lines or ROWS
    lines = [motion.reading(), *textwrap.wrap(remark, columns), speed]
    impacts = motion.trains.lines(columns)
    below = (
        ["", "Impacts", *impacts, *[""] * (TRAINS - len(impacts)), "", "Ctrl+C ends it."]
        if rows >= LOW
        else []
    )
    lines += picture.lines(motion.cradle, columns, rows - len(lines) - len(below)) + below
    return [line[:columns].rstrip() for line in lines[:rows]]


class TextPlayer(Player):
    """Plays a cradle in step with the clock, and shows it at the start, every step_seconds, and at
    the end.
    """

    step_seconds: float

    def __init__(self, cradle, csv, options):
        """Play the cradle of this CSV (a Snapshot); options has angle, lift and seconds, from
        read_text_options.
        """
        super().__init__(cradle, csv, [options.angle], options.lift, TRAINS, self.step_seconds)
        self.last = (
            options.seconds if options.seconds == inf else round(options.seconds / cradle.dt)
        )  # tick

    def show_new_cradle(self) -> None:
        self.note()
        self.pace.restart()

    def frame(self) -> None:
        """Rest, and plan the ticks that are due; at the end, show the cradle again."""
        self.is_over = self.motion.ticks >= self.last
        if not self.is_over:
            self.pace.rest()
            self.keep_time(self.last - self.motion.ticks)
        elif self.last % self.step:
            self.note()


class Pictures(TextPlayer):
    """Shows the cradle as a moving picture."""

    step_seconds = 1 / 20

    def __init__(self, cradle, csv, options, remark=""):
        """Show the remark, if there is one, above the picture; for the other arguments, see
        TextPlayer.
        """
        super().__init__(cradle, csv, options)
        self.picture, self.remark = TextPicture(), remark
        self.seen: list[str] = []  # the lines of the last picture

    def note(self) -> None:
        """Show a picture: go to the top left corner; clear each line, and at the end all lines
        below.
        """
        remark = self.remark or self.cradle.remark()
        self.seen = screen(self.motion, self.picture, self.pace.remark(), remark)
        text = "\n".join("\x1b[K" + line for line in self.seen)
        print(f"\x1b[H{text}\x1b[J", end="", flush=True)


class Lines(TextPlayer):
    """Prints a line every half second."""

    step_seconds = 0.5

    def __init__(self, cradle, csv, options, remark=""):
        """Print the remark, if there is one, above the lines; for the other arguments, see
        TextPlayer.
        """
        super().__init__(cradle, csv, options)
        if remark:
            print(remark)

    def note(self) -> None:
        print(summary(self.motion), flush=True)
        self.motion.trains.clear()


def summary(motion) -> str:
    """Return a line: the time, the energy, the angle and side of the highest bob, and the latest
    train of hits.
    """
    angles = [degrees(remainder(theta, 2 * pi)) for theta in motion.cradle.values("theta")]
    number, angle = max(enumerate(angles, start=1), key=lambda numbered: abs(numbered[1]))
    total = in_words(motion.percents()["energy"]).strip()
    side = "left" if angle < 0 else "right"
    line = f"t = {motion.time():.2f} s, energy {total}, bob {number} at {abs(angle):.0f} degrees {side}"
    trains = motion.trains.trains
    return in_line(f"{line}, hits: {trains[-1]}" if trains else line, WIDTH)


class Recorder(Player):
    """Writes a row of data for every options.every seconds of simulated time, as fast as the
    machine can.

    The last row is the last one that is not later than options.seconds.
    """

    def __init__(self, cradle, csv, options, writer, progress):
        """Write with a csv.writer; call progress(part), 0 to 1, again and again; options: from
        read_text_options.
        """
        super().__init__(cradle, csv, [options.angle], options.lift, 1, options.every)
        ticks = int(options.seconds / cradle.dt + 1e-6)  # 10 / 0.001 could be 9999.999999999999
        self.last = ticks - ticks % self.step  # the tick of the last row
        self.writer, self.progress = writer, progress

    def show_new_cradle(self) -> None:
        self.writer.writerow(self.motion.sample())  # its names
        self.note()

    def frame(self) -> None:
        """Report the progress, and plan the next ticks."""
        self.is_over = self.motion.ticks >= self.last
        if self.motion.ticks:
            self.progress(self.motion.ticks / self.last)
        self.plan(min(PART, self.last - self.motion.ticks))

    def note(self) -> None:
        self.writer.writerow(self.motion.sample().values())


def record(loop, cradle, csv, options, remark="") -> None:
    """Write the data of options.seconds to the file options.record, whole or not at all; or, for -,
    to the output.
    """
    if options.record == "-":
        rows = writer(sys.stdout, lineterminator="\n")
        with redirect_stdout(sys.stderr):  # words are no data, also those of a student's function
            if remark:
                print(remark)
            run(loop, Recorder(cradle, csv, options, rows, progress=lambda part: None))
        return
    with whole_file(options.record) as file, progress_bar() as progress:
        recorder = Recorder(cradle, csv, options, writer(file, lineterminator="\n"), progress)
        run(loop, recorder)
    if remark:
        print(remark)
    rows, end = recorder.last // recorder.step + 1, recorder.motion.time()
    print(in_one_line(f"{rows} rows, from t = 0 to {end:.15g} s, are in {options.record}"))
