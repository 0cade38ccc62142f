"""What is printed: letters that the output lacks, and readers that go away."""

import errno
import os
import sys
from contextlib import contextmanager


@contextmanager
def while_it_is_read():
    """Run the body of the with statement. If the reader of its output goes away, as after `| head`, end it quietly."""
    try:
        yield
    except OSError as error:
        # Windows has no error of its own for that.
        is_unread = sys.platform == "win32" and error.errno == errno.EINVAL and error.filename is None
        if not (is_unread or isinstance(error, BrokenPipeError)):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def spell_out_letters() -> None:
    """Print a letter that the output lacks, as a pipe on Windows may, as its number: \\u03c9."""
    if hasattr(sys.stdout, "reconfigure"):  # not in IDLE's shell, which has all letters
        sys.stdout.reconfigure(errors="backslashreplace")
