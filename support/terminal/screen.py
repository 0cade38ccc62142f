"""The terminal's screen: its lines, and how the program takes it and gives it back."""

import os
import shutil
import signal
import sys
import textwrap
from contextlib import contextmanager, suppress

WIDTH = 80  # columns, at most
ROWS = 24  # of a terminal that does not know its size
TRAINS = 4  # of impacts, a line for each
LOW = 18  # lines; a terminal with fewer lines shows no impacts
TAKE, GIVE_BACK = "\x1b[?1049h\x1b[?25l", "\x1b[?25h\x1b[?1049l"  # a separate screen without a cursor; the old one


def screen(motion, picture, speed, remark="") -> list[str]:
    """Return the lines of the screen, for the present size of the terminal.

    speed is a remark about the speed, remark is a remark about the cradle.
    """
    size = shutil.get_terminal_size()
    columns = min(WIDTH, size.columns or WIDTH)  # Python 3.10 returns 0 for a terminal that does not know its size
    rows = size.lines or ROWS
    lines = [f"{motion.reading()}   {speed}", *textwrap.wrap(remark, columns), ""]
    rest = rows - len(lines)
    if rows < LOW:
        lines += picture.lines(motion.cradle, columns, rest)
    else:
        impacts = motion.trains.lines(columns)
        lines += picture.lines(motion.cradle, columns, rest - TRAINS - 4)
        lines += ["", "Impacts", *impacts, *[""] * (TRAINS - len(impacts)), "", "Ctrl+C ends it."]
    return [line[:columns].rstrip() for line in lines[:rows]]


def switch_on_escapes() -> None:
    """Let an older console of Windows understand the codes that move the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def own_screen(last_lines):
    """Use a separate screen, without a cursor; afterwards, the terminal shows its old lines again, and last_lines()."""
    switch_on_escapes()
    with shared_while_stopped():
        print(TAKE, end="")
        try:
            yield
        finally:
            with suppress(OSError):  # the terminal was closed
                print(GIVE_BACK + "\n".join(last_lines()), flush=True)


@contextmanager
def shared_while_stopped():
    """Let Ctrl+Z give the screen back until the program goes on (`fg`). Windows has no signal for this."""
    number = getattr(signal, "SIGTSTP", None)
    if number is None or signal.getsignal(number) != signal.SIG_DFL:  # or it is ignored
        yield
        return

    def stop(*_):
        tell(GIVE_BACK)
        signal.signal(number, signal.SIG_DFL)
        signal.raise_signal(number)  # the program stands still here
        signal.signal(number, stop)
        tell(TAKE)

    def tell(codes):
        """Write these codes at once: print may be at work, and cannot be called inside itself."""
        with suppress(OSError):
            os.write(sys.stdout.fileno(), codes.encode())

    signal.signal(number, stop)
    try:
        yield
    finally:
        signal.signal(number, signal.SIG_DFL)
