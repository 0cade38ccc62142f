"""Printed output: messages in one line, a bar of progress, letters that the output does not have,
its end.
"""

import errno
import os
import shutil
import sys
import time
from contextlib import contextmanager, suppress

BAR_AFTER = 2.0  # s before a bar shows the progress
BAR_STEP = 0.05  # s from one bar to the next


@contextmanager
def while_it_is_read():
    """Run a program: the body of the with statement, or the decorated function.

    Its output may be closed or full.

    If the reader of the output stops, as in `| head`, end the program quietly. If an OSError
    reaches this place, for instance because the output is full, name its cause in one line, and
    exit with status 2.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        # closed, as after `>&-`: now nobody reads the output, and the input is empty
        if getattr(sys, name) is None:
            file = open(os.devnull, mode, encoding="utf-8", errors="backslashreplace")  # noqa: SIM115  it stays open
            setattr(sys, name, file)
    # Not in IDLE's shell, which has all letters; a pipe on Windows lacks some
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        yield
        sys.stdout.flush()  # here: at the end of Python, an error would be a traceback
    except OSError as error:
        if not is_unread(error):
            refuse(
                f"{error.filename2 or error.filename or 'The output'}: {error.strerror or error}"
            )
    finally:
        for stream in (sys.stdout, sys.stderr):
            try:
                stream.flush()
            except OSError:  # Python would try again, and fail
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def is_unread(error) -> bool:
    """Return whether an error says that the reader of the output has stopped."""
    is_said_by_windows = (
        sys.platform == "win32" and isinstance(error, OSError) and error.errno == errno.EINVAL
    )
    return (isinstance(error, BrokenPipeError) or is_said_by_windows) and error.filename is None


def in_one_line(text) -> str:
    """Return a text with its line breaks and other characters that a terminal does not show as
    numbers, like \\x1b.
    """
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode()
        for letter in str(text)
    )


def say(text, file=None, end="\n") -> None:
    """Print a text to this file, by default on stdout.

    If this fails, the program goes on without it.
    """
    with suppress(OSError):
        print(text, end=end, file=file, flush=True)


def complain(message) -> None:
    """Print a message in one line on stderr. If this fails, the program goes on without it."""
    say(in_one_line(message), sys.stderr)


def refuse(message) -> None:
    """Print a message in one line on stderr, and exit with status 2."""
    complain(message)
    sys.exit(2)


def switch_on_escapes() -> None:
    """Let an older console of Windows understand the codes that move the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def progress_bar(clock=time.monotonic):
    """Yield progress(part), which takes the finished part, 0 to 1.

    If it takes long, a terminal shows it as a bar.
    """
    begin = clock()
    next_look = begin + BAR_AFTER

    def progress(part):
        nonlocal next_look
        if clock() > next_look and sys.stderr.isatty():
            next_look = clock() + BAR_STEP
            left = (clock() - begin) * (1 - part) / part
            width = max(1, min(40, shutil.get_terminal_size().columns - 25))
            say(
                f"\r[{'#' * int(part * width):<{width}}] {part:4.0%}, {left:.0f} s left ",
                sys.stderr,
                end="",
            )

    try:
        yield progress
    finally:
        if next_look > begin + BAR_AFTER:
            switch_on_escapes()
            say("\r\x1b[K", sys.stderr, end="")
