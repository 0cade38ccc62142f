"""Limits for students' functions: they cannot take all time or memory, wait for input, or end the grader's process.

This is for mistakes. It is no protection from a student who means harm.
"""

import os
import signal
import threading
from contextlib import contextmanager
from pathlib import Path
from unittest.mock import Mock, patch

PATIENCE = 5.0  # s; then the grader stops a function
MOST_MEMORY = 1000  # MB

MEMORY_IN_USE = Path("/proc/self/statm")  # Linux has it; its sixth number counts the pages of data

LATE = threading.Event()  # set if the grader stopped a check
PRESSED = threading.Event()  # set if somebody pressed Ctrl+C


@contextmanager
def limited_memory():
    """On Linux, raise a MemoryError if the body of the with statement takes more than MOST_MEMORY."""
    if not MEMORY_IN_USE.exists():
        yield
        return
    import resource  # Windows has none

    in_use = int(MEMORY_IN_USE.read_text().split()[5]) * resource.getpagesize()
    before = resource.getrlimit(resource.RLIMIT_DATA)
    allowed = [limit for limit in before if limit != resource.RLIM_INFINITY]
    spare = bytearray(2**18)  # for the message about a call that took all its memory
    resource.setrlimit(resource.RLIMIT_DATA, (min([in_use + MOST_MEMORY * 10**6, *allowed]), before[1]))
    try:
        yield
    finally:
        del spare  # first: without it, the next line could raise a MemoryError, too
        resource.setrlimit(resource.RLIMIT_DATA, before)


@contextmanager
def without_ends():
    """In the body of the with statement, os._exit raises a SystemExit, and input an EOFError.

    A process that the body starts can end as it likes.
    """
    no_answer = EOFError("input() waits for somebody, but nobody answers in a check")
    process, end = os.getpid(), os._exit

    def refused(status):
        if os.getpid() != process:
            end(status)
        raise SystemExit(f"os._exit({status})")

    with patch("builtins.input", Mock(side_effect=no_answer)), patch("os._exit", refused):
        yield


def over_limit(error) -> str:
    """Return how a call that raised this error went over a limit, or "" if it did not."""
    if isinstance(error, KeyboardInterrupt) and LATE.is_set():
        return f"took longer than {PATIENCE:g} s"
    return f"took more than {MOST_MEMORY} MB of memory" if isinstance(error, MemoryError) else ""


@contextmanager
def patience(seconds):
    """Raise a KeyboardInterrupt in the body of the with statement, and set LATE, if it takes longer than seconds.

    If somebody presses Ctrl+C, set PRESSED, and raise a KeyboardInterrupt at the end, also if the body catches it.
    """
    lock, over = threading.Lock(), threading.Event()
    # It also ends a sleep. On Windows, any thread can send the signal.
    kill = getattr(signal, "pthread_kill", lambda _, number: signal.raise_signal(number))

    def interrupt():
        left = seconds
        while not over.wait(left):
            with lock:
                if not over.is_set():
                    LATE.set()
                    kill(threading.main_thread().ident, signal.SIGINT)
            left = 0.5  # the solution may catch the first one

    def on_interrupt(*_):
        if not LATE.is_set():
            PRESSED.set()
        raise KeyboardInterrupt

    LATE.clear()
    PRESSED.clear()
    before = signal.signal(signal.SIGINT, on_interrupt)  # a background job ignores interrupts
    threading.Thread(target=interrupt, daemon=True).start()
    try:
        yield
    finally:
        with lock:
            over.set()
        signal.signal(signal.SIGINT, before)
        if PRESSED.is_set():
            raise KeyboardInterrupt
