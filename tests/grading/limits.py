"""Limits for students' functions: they cannot take all time or memory, wait for input, or end the grader's process.

This is for mistakes. It is no protection from a student who means harm.
"""

import os
import signal
import sys
import threading
import time
from contextlib import contextmanager, ExitStack
from pathlib import Path
from unittest.mock import patch

PATIENCE = 5.0  # s of processor time; then the grader stops a function
WAITING = 6  # a function that only waits is stopped after this many times PATIENCE, by the clock
LOOK = 0.05  # s from one look at these times to the next
MOST_MEMORY = 1000  # MB

MEMORY_IN_USE = Path("/proc/self/statm")  # Linux has it; its sixth number counts the pages of data

LATE = threading.Event()  # set if the grader stopped a check
PRESSED = threading.Event()  # set if somebody pressed Ctrl+C
DEBUGGED = threading.Event()  # set if the present check is in a debugger: no limit of time holds
HAS_TERMINAL = sys.stdin is not None and sys.stdin.isatty()  # now: pytest takes the input away later


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

    A process that the body starts can end as it likes. A debugger has its prompt in a terminal; without one, breakpoint
    does nothing.
    """
    process = os.getpid()
    end, answer = os._exit, input

    def refused_exit(status):
        if os.getpid() != process:
            end(status)
        raise SystemExit(f"os._exit({status})")

    def refused_input(*prompt):
        if sys._getframe(1).f_globals.get("__name__") == "cmd":  # the prompt of a debugger
            DEBUGGED.set()
            return answer(*prompt)
        raise EOFError("input() waits for somebody, but nobody answers in a check")

    with ExitStack() as stack:
        for place, new in (("builtins.input", refused_input), ("os._exit", refused_exit)):
            stack.enter_context(patch(place, new))
        for place in () if HAS_TERMINAL else ("sys.breakpointhook", "pdb.set_trace"):
            stack.enter_context(patch(place, lambda *_, **__: None))
        yield


def is_debugged() -> bool:
    """Return whether the present check is, or was, in a debugger."""
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on
    has_tool = monitoring is not None and monitoring.get_tool(monitoring.DEBUGGER_ID) is not None
    return DEBUGGED.is_set() or has_tool or sys.gettrace() is not None


def over_limit(error) -> str:
    """Return how a call that raised this error went over a limit, or "" if it did not."""
    if isinstance(error, KeyboardInterrupt) and LATE.is_set():
        return f"took longer than {PATIENCE:g} s"
    return f"took more than {MOST_MEMORY} MB of memory" if isinstance(error, MemoryError) else ""


@contextmanager
def patience(seconds):
    """Raise a KeyboardInterrupt in the body of the with statement, and set LATE, if it takes longer than seconds.

    These are seconds of processor time: on a busy machine, the clock says nothing. In a debugger, there is no limit.
    If somebody presses Ctrl+C, set PRESSED, and raise a KeyboardInterrupt at the end, also if the body catches it.
    """
    lock, over = threading.Lock(), threading.Event()
    # It also ends a sleep. On Windows, any thread can send the signal.
    kill = getattr(signal, "pthread_kill", lambda _, number: signal.raise_signal(number))

    def interrupt():
        begin, begin_on_clock = time.process_time(), time.monotonic()
        wait = LOOK
        while not over.wait(wait):
            used, waited = time.process_time() - begin, time.monotonic() - begin_on_clock
            if (used > seconds or waited > WAITING * seconds) and not DEBUGGED.is_set():
                with lock:
                    if not over.is_set():
                        LATE.set()
                        kill(threading.main_thread().ident, signal.SIGINT)
                wait = 0.5  # the solution may catch the first one

    def on_interrupt(*_):
        if not LATE.is_set():
            PRESSED.set()
        raise KeyboardInterrupt

    LATE.clear()
    PRESSED.clear()
    DEBUGGED.clear()
    if is_debugged():
        DEBUGGED.set()
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
