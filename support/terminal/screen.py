"""The terminal's screen: the cradle as a picture of ASCII characters, which are twice as high as wide, and its lines.

Also how the program takes the screen and gives it back, and a bar that shows progress.
"""

import os
import shutil
import signal
import sys
import textwrap
import time
from contextlib import contextmanager
from math import atan2, pi

from support.cradle.cradle import Cradle
from support.start.output import say

CORD = 16  # length of a cord in columns if they fit; neighbouring bobs are then four columns apart
STROKES = "-\\|/"  # a line to the right, and lines turned down from it by 45, 90 and 135 degrees
WIDTH = 80  # columns, at most
ROWS = 24  # of a terminal that does not know its size
TRAINS = 4  # of impacts, a line for each
LOW = 18  # lines; a terminal with fewer lines shows no impacts
BAR_AFTER = 2.0  # s before a bar shows the progress
BAR_STEP = 0.05  # s from one bar to the next
OWN_SCREEN, OLD_SCREEN = "\x1b[?1049h\x1b[?25l", "\x1b[?25h\x1b[?1049l"  # the first has no cursor


class TextPicture:
    """Draws a cradle, always with the same part of space in view."""

    def __init__(self):
        """Show the space below the axles; once a bob has been above them, show the space up to there, too."""
        self.above = 0.0  # m

    def lines(self, cradle: Cradle, columns, rows) -> list[str]:
        """Return the lines of a picture, at most `columns` wide and `rows` high; no line if it does not fit."""
        axles, bobs = [axle.pos for axle in cradle.axles()], [bob.pos for bob in cradle.bobs()]
        xs, ys = sorted(axle.x for axle in axles), sorted(axle.y for axle in axles)
        self.above = max(self.above, *(bob.y - ys[-1] for bob in bobs))
        left, width = xs[0] - cradle.reach, xs[-1] - xs[0] + 2 * cradle.reach
        top, height = ys[-1] + self.above, ys[-1] - ys[0] + cradle.reach + self.above
        # Columns per metre. Three columns and a row stay free for rounding, and for the brackets of a bob.
        scale = min(CORD / cradle.reach, (columns - 3) / width, 2 * (rows - 1) / height)
        if scale <= 0:
            return []
        apart = (xs[-1] - xs[0]) / max(1, len(axles) - 1)
        if apart * scale >= 1:  # whole columns from bob to bob: unequal gaps look like groups of bobs
            scale = int(apart * scale + 1e-9) / apart
        grid = [[" "] * columns for _ in range(round(height * scale / 2) + 1)]

        def cell(place):
            return round((top - place.y) * scale / 2), round((place.x - left) * scale) + 1

        for cord in cradle.cords():
            (row, column), (end_row, end_column) = cell(cord.pos), cell(cord.pos + cord.axis)
            down, aside = end_row - row, end_column - column
            steps = abs(down) if abs(aside) < 1.5 * abs(down) else abs(aside)  # one stroke per row, or per column
            stroke = STROKES[round(4 * atan2(-cord.axis.y, cord.axis.x) / pi) % 4]
            for step in range(steps):
                grid[row + round(down * step / steps)][column + round(aside * step / steps)] = stroke

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
    """Return the lines of the screen for the size of the terminal; speed and remark are texts, maybe empty."""
    size = shutil.get_terminal_size()
    columns = min(WIDTH, size.columns or WIDTH)  # Python 3.10 returns 0 for a terminal that does not know its size
    rows = size.lines or ROWS
    lines = [motion.reading(), *textwrap.wrap(remark, columns), speed]
    impacts = motion.trains.lines(columns)
    below = ["", "Impacts", *impacts, *[""] * (TRAINS - len(impacts)), "", "Ctrl+C ends it."] if rows >= LOW else []
    lines += picture.lines(motion.cradle, columns, rows - len(lines) - len(below)) + below
    return [line[:columns].rstrip() for line in lines[:rows]]


def switch_on_escapes() -> None:
    """Let an older console of Windows understand the codes that move the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def own_screen(last_lines):
    """Use a separate screen, without a cursor; afterwards, the terminal shows its old lines again, and last_lines()."""
    switch_on_escapes()
    if hasattr(signal, "SIGTSTP"):  # Ctrl+Z would leave this screen to the shell; Windows has no signal for it
        signal.signal(signal.SIGTSTP, signal.SIG_IGN)
    print(OWN_SCREEN, end="")
    try:
        yield
    finally:
        say(OLD_SCREEN + "\n".join(last_lines()))  # if the terminal is not closed


@contextmanager
def progress_bar(clock=time.monotonic):
    """Yield progress(part), which takes the finished part, 0 to 1. If it takes long, a terminal shows it as a bar."""
    begin = clock()
    next_look = begin + BAR_AFTER

    def progress(part):
        nonlocal next_look
        if clock() > next_look and sys.stderr.isatty():
            next_look = clock() + BAR_STEP
            left = (clock() - begin) * (1 - part) / part
            width = max(1, min(40, shutil.get_terminal_size().columns - 25))
            say(f"\r[{'#' * int(part * width):<{width}}] {part:4.0%}, {left:.0f} s left ", sys.stderr, end="")

    try:
        yield progress
    finally:
        if next_look > begin + BAR_AFTER:
            switch_on_escapes()
            say("\r\x1b[K", sys.stderr, end="")
