"""The terminal's screen: what stands there in each line, and how it is taken and given back."""

import os
import shutil
import sys
import textwrap
from contextlib import contextmanager

WIDTH = 80  # columns that are used, where there are as many
TRAINS = 4  # of impacts, a line for each
LOW = 18  # lines, and with fewer a terminal has room for the cradle only


def screen(motion, picture, speed, remark="") -> list[str]:
    """Return what is to be seen, line by line, for the terminal as large as it is at this moment.

    speed is the remark about the speed, and remark the one about the cradle.
    """
    size = shutil.get_terminal_size()
    columns = min(WIDTH, size.columns)
    lines = [f"{motion.reading()}   {speed}", *textwrap.wrap(remark, columns), ""]
    rest = size.lines - len(lines)
    if size.lines < LOW:
        lines += picture.lines(motion.cradle, columns, rest)
    else:
        impacts = motion.trains.lines(columns)
        lines += picture.lines(motion.cradle, columns, rest - TRAINS - 4)
        lines += ["", "Impacts", *impacts, *[""] * (TRAINS - len(impacts)), "", "Ctrl+C ends it."]
    return [line[:columns].rstrip() for line in lines[: size.lines]]


def switch_on_escapes() -> None:
    """Let an older console of Windows understand what moves the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def own_screen():
    """Take a screen of one's own, without a cursor; afterwards the terminal is as it was."""
    switch_on_escapes()
    print("\x1b[?1049h\x1b[?25l", end="")
    try:
        yield
    finally:
        print("\x1b[?25h\x1b[?1049l", end="", flush=True)
