"""The terminal's screen: its lines, and how the program takes it and gives it back."""

import os
import shutil
import sys
import textwrap
from contextlib import contextmanager

WIDTH = 80  # columns, at most
TRAINS = 4  # of impacts, a line for each
LOW = 18  # lines; a terminal with fewer lines shows no impacts


def screen(motion, picture, speed, remark="") -> list[str]:
    """Return the lines of the screen, for the present size of the terminal.

    speed is a remark about the speed, remark is a remark about the cradle.
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
    """Let an older console of Windows understand the codes that move the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def own_screen():
    """Use a separate screen, without a cursor; afterwards, the terminal shows its old lines again."""
    switch_on_escapes()
    print("\x1b[?1049h\x1b[?25l", end="")
    try:
        yield
    finally:
        print("\x1b[?25h\x1b[?1049l", end="", flush=True)
