"""Printed output: messages in one line, a bar of progress, letters that it lacks, its end."""

import errno
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import NoReturn, TextIO, TypeAlias

from support.start.early import forget_program, is_in_session

Progress: TypeAlias = Callable[[float], object]

BAR_AFTER = 2.0  # s before a bar shows the progress
BAR_STEP = 0.05  # s from one bar to the next


@contextmanager
def while_it_is_read() -> Iterator[None]:
    """Run a program: the body of the with statement, or the decorated function.

    Its output may be closed or full. If the reader of the output stops, as in `| head`, end the
    program quietly. If an OSError reaches this place, for instance because the output is full, name
    its cause in one line, and exit with status 2.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        # closed, as after `>&-`: now nobody reads the output, and the input is empty
        if getattr(sys, name) is None:
            nothing = open(os.devnull, mode, encoding="utf-8", errors="replace")  # noqa: SIM115
            setattr(sys, name, nothing)  # it stays open
    # Not in IDLE's shell, which has all letters; a pipe on Windows lacks some
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        yield
        sys.stdout.flush()  # here: at the end of Python, an error would be a traceback
    except OSError as error:
        if not is_unread(error):
            place = error.filename2 or error.filename or "The output"
            refuse(f"{place}: {error.strerror or error}")
    finally:
        for stream in (sys.stdout, sys.stderr):
            try:
                stream.flush()
            except OSError:  # Python would try again, and fail
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        if is_in_session():
            forget_program()


def is_unread(error: BaseException) -> bool:
    """Return whether an error says that the reader of the output has stopped."""
    if not isinstance(error, OSError) or error.filename is not None:
        return False
    is_said_by_windows = sys.platform == "win32" and error.errno == errno.EINVAL
    return isinstance(error, BrokenPipeError) or is_said_by_windows


def in_one_line(text: object) -> str:
    """Return a text in one line.

    Its line breaks, and other characters that a terminal does not show, are numbers, like \\x1b.
    """
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode()
        for letter in str(text)
    )


def say(text: str, file: TextIO | None = None, end: str = "\n") -> None:
    """Print a text to this file, by default on stdout.

    If this fails, the program goes on without it.
    """
    with suppress(OSError):
        print(text, end=end, file=file, flush=True)


def complain(message: object) -> None:
    """Print a message in one line on stderr. If this fails, the program goes on without it."""
    say(in_one_line(message), sys.stderr)


def refuse(message: object) -> NoReturn:
    """Print a message in one line on stderr, and exit with status 2."""
    complain(message)
    sys.exit(2)


def switch_on_escapes() -> None:
    """Let an older console of Windows understand the codes that move the cursor."""
    if sys.platform == "win32":
        os.system("")


@contextmanager
def progress_bar(clock: Callable[[], float] = time.monotonic) -> Iterator[Progress]:
    """Yield progress(done), which takes the part that is done, 0 to 1.

    If it takes long, a terminal shows it as a bar.
    """
    start = clock()
    next_bar = start + BAR_AFTER

    def progress(done: float) -> None:
        nonlocal next_bar
        if clock() > next_bar and sys.stderr.isatty():
            next_bar = clock() + BAR_STEP
            left = (clock() - start) * (1 - done) / done
            width = max(1, min(40, shutil.get_terminal_size().columns - 25))
            bar = "#" * int(done * width)
            say(f"\r[{bar:<{width}}] {done:4.0%}, {left:.0f} s left ", sys.stderr, end="")

    try:
        yield progress
    finally:
        if next_bar > start + BAR_AFTER:
            switch_on_escapes()
            say("\r\x1b[K", sys.stderr, end="")
