"""Printed output: letters that the output does not have, and readers that stop early."""

import errno
import os
import sys
from contextlib import contextmanager


@contextmanager
def while_it_is_read():
    """Run the body of the with statement. If the reader of its output stops, as in `| head`, end it quietly."""
    try:
        yield
    except OSError as error:
        # Windows has no special error for this.
        is_unread = sys.platform == "win32" and error.errno == errno.EINVAL and error.filename is None
        if not (is_unread or isinstance(error, BrokenPipeError)):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def spell_out_letters() -> None:
    """Print letters that the output does not have as numbers, like \\u03c9: a pipe on Windows lacks some."""
    if hasattr(sys.stdout, "reconfigure"):  # not in IDLE's shell, which has all letters
        sys.stdout.reconfigure(errors="backslashreplace")
