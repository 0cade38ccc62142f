"""Printed output: messages in one line, and the progress."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NoReturn, TypeAlias

Progress: TypeAlias = Callable[[float], object]

BAR_AFTER = 2.0  # s before the progress is shown


def in_one_line(text: object) -> str:
    """Return a text in one line.

    Its line breaks, and other characters that a terminal does not show, are numbers, like \\x1b.
    """
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode()
        for letter in str(text)
    )


def complain(message: object) -> None:
    """Print a message in one line on stderr."""
    print(in_one_line(message), file=sys.stderr)


def refuse(message: object) -> NoReturn:
    """Print a message in one line on stderr, and exit with status 2."""
    complain(message)
    sys.exit(2)


@contextmanager
def progress_bar() -> Iterator[Progress]:
    """Yield progress(done), which takes the part that is done, 0 to 1.

    If it takes longer than BAR_AFTER, a terminal shows it in percent.
    """
    start = time.monotonic()
    shown = -1  # percent

    def progress(done: float) -> None:
        nonlocal shown
        percent = int(100 * done)
        if percent > shown and time.monotonic() > start + BAR_AFTER and sys.stderr.isatty():
            shown = percent
            print(f"\r{percent} % ", end="", file=sys.stderr, flush=True)

    try:
        yield progress
    finally:
        if shown >= 0:
            print(file=sys.stderr)
