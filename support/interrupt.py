"""What could end a program with a traceback: Ctrl+C, from the first moment on, and output that cannot be written."""

import errno
import os
import signal
import sys
from contextlib import contextmanager


def end_on_interrupt(status=0) -> None:
    """Let Ctrl+C end the process at once, with this status and no traceback.

    VPython's own handler waits for its servers, which may be waiting for a browser.
    """
    signal.signal(signal.SIGINT, lambda *_: os._exit(status))


@contextmanager
def while_it_is_read():
    """Run the body of the with statement until nobody reads what it prints, as after `| head`."""
    try:
        yield
    except OSError as error:
        # Windows has no error of its own for that.
        is_unread = sys.platform == "win32" and error.errno == errno.EINVAL and error.filename is None
        if not (is_unread or isinstance(error, BrokenPipeError)):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def spell_out_letters() -> None:
    """Let a letter that the output does not have, as in a pipe on Windows, be written as its number."""
    if hasattr(sys.stdout, "reconfigure"):  # not in IDLE's shell, which has all letters
        sys.stdout.reconfigure(errors="backslashreplace")
