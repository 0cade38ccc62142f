"""Limits for students' functions: of time, of memory, and of what they can do to the process.

They cannot wait for input, or end the grader's process. This is for mistakes. It is no protection
from a student who means harm.
"""

import errno
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, ExitStack
from pathlib import Path
from types import FrameType
from typing import Any
from unittest.mock import patch

from grading.begin import ROOT

from grading.handout import PROGRAM
from grading.present import present
from support.constants import NC_FP

PATIENCE = 5.0  # s of processor time; then the grader stops a function
WAITING = 10  # a function that only waits is stopped after this many times PATIENCE, by the clock
LOOK_AT_LIMITS = 0.05  # s from one look at these times to the next
NEXT_INTERRUPT = 0.5  # s until a function that catches the interrupt gets the next one
MOST_INTERRUPTS = 20  # then pytest ends: nothing else stops this function
MOST_MEMORY = 1000  # MB

MEMORY_IN_USE = Path("/proc/self/statm")  # Linux has it; its sixth number counts the pages of data

CLOCK, PROCESSOR = "clock", "processor"  # the time by which the grader stops a function

# Errors for want of something that other programs use as well
SHARED = errno.EAGAIN, errno.EDQUOT, errno.ENFILE, errno.ENOMEM, errno.ENOSPC
# These now: pytest takes the input and the output away later, and a check must not end the process.
HAS_TERMINAL = sys.stdin is not None and sys.stdin.isatty()
try:
    STDERR = os.dup(2)
except OSError:  # it is closed
    STDERR = os.open(os.devnull, os.O_WRONLY)
end_process = os._exit


@contextmanager
def limited_memory(megabytes: int | None = None) -> Iterator[None]:
    """Raise a MemoryError if the body of the with statement takes more than this, on Linux.

    The default is MOST_MEMORY.
    """
    if not MEMORY_IN_USE.exists():
        yield
        return
    import resource  # Windows has none

    in_use = int(MEMORY_IN_USE.read_text().split()[5]) * resource.getpagesize()
    before = resource.getrlimit(resource.RLIMIT_DATA)
    allowed = [limit for limit in before if limit != resource.RLIM_INFINITY]
    spare = bytearray(2**18)  # for the message about a call that took all its memory
    if megabytes is None:
        megabytes = MOST_MEMORY
    most = in_use + megabytes * 10**6
    resource.setrlimit(resource.RLIMIT_DATA, (min([most, *allowed]), before[1]))
    try:
        yield
    finally:
        del spare  # first: without it, the next line could raise a MemoryError, too
        resource.setrlimit(resource.RLIMIT_DATA, before)


def refuse_real_csv(event: str, arguments: tuple) -> None:
    """Raise a PermissionError if something opens, moves or deletes the real CSV in a check.

    Only the program may read it, with a path of its own.
    """
    if not present.is_in_check or event not in ("open", "os.rename", "os.remove", "os.truncate"):
        return
    for path in arguments:
        if isinstance(path, (str, os.PathLike)) and os.path.realpath(path) == NC_FP:
            is_read = event == "open" and not arguments[2] & (os.O_WRONLY | os.O_RDWR)
            if is_read and present.watched_function == PROGRAM:
                present.has_read_real_csv = True
                return
            message = "checks have a CSV of their own: use the path that they give, or NC_FP"
            raise PermissionError(errno.EACCES, message)


sys.addaudithook(refuse_real_csv)


@contextmanager
def without_ends() -> Iterator[None]:
    """In the body of the with statement, os._exit raises a SystemExit, and input an EOFError.

    The output stays open, and the real CSV is out of reach. A process that the body starts can end
    as it likes. A debugger has its prompt in a terminal; without one, breakpoint does nothing.
    """
    process = os.getpid()
    answer = input

    def refused_exit(status: int) -> None:
        if os.getpid() != process:
            end_process(status)
        raise SystemExit(f"os._exit({status})")

    def refused_input(*prompt: object) -> str:
        if sys._getframe(1).f_globals.get("__name__") == "cmd":  # the prompt of a debugger
            present.is_debugged = True
            return answer(*prompt)
        raise EOFError("input() waits for somebody, but nobody answers in a check")

    def nothing(*_: Any, **__: Any) -> None:
        pass

    changed = {
        "builtins.input": refused_input,
        "os._exit": refused_exit,
        "grading.present.present.is_in_check": True,
        "sys.stdout.close": nothing,  # pytest prints there later
        "sys.stderr.close": nothing,
    }
    if not HAS_TERMINAL:
        changed["sys.breakpointhook"] = nothing
        changed["pdb.set_trace"] = nothing
    with ExitStack() as stack:
        for name, function in changed.items():
            stack.enter_context(patch(name, function))
        yield


def is_debugged() -> bool:
    """Return whether a debugger is at work."""
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on
    has_tool = monitoring is not None and monitoring.get_tool(monitoring.DEBUGGER_ID) is not None
    return has_tool or sys.gettrace() is not None


def is_for_want_of_shared(error: BaseException) -> bool:
    """Return whether an error is for want of something that other programs use as well."""
    number = error.errno if isinstance(error, OSError) else None
    return isinstance(error, MemoryError) or number in SHARED


def over_limit(error: BaseException) -> str:
    """Return how a call that raised this error went over a limit, or "" if it did not."""
    if isinstance(error, KeyboardInterrupt) and present.stopped_by == CLOCK:
        return f"waited longer than {WAITING * PATIENCE:g} s"
    if isinstance(error, KeyboardInterrupt) and present.stopped_by == PROCESSOR:
        return f"took longer than {PATIENCE:g} s"
    if isinstance(error, MemoryError):
        return f"took more than {MOST_MEMORY} MB of memory"
    if isinstance(error, OSError) and error.errno == errno.EFBIG:
        import resource  # Windows has none, and no such limit

        # Pytest keeps in a file what a function prints
        most = resource.getrlimit(resource.RLIMIT_FSIZE)[0]
        return f"printed or wrote more than {most / 10**6:g} MB into a file"
    return ""


def main_thread_id() -> int:
    """Return the number by which Python knows the main thread."""
    thread: Any = threading.main_thread()  # it runs, so it has a number
    return thread.ident


def end_stubborn() -> None:
    """End the process if a student's code runs: it has caught each interrupt. Name its line."""
    frame: FrameType | None = sys._current_frames()[main_thread_id()]
    while frame is not None and not Path(frame.f_code.co_filename).is_relative_to(ROOT / "src"):
        frame = frame.f_back
    if frame is None:
        return
    place = f"{Path(frame.f_code.co_filename).relative_to(ROOT).as_posix()}, line {frame.f_lineno}"
    os.write(STDERR, f"\n{place} catches all that could stop it, so pytest ends here.\n".encode())
    end_process(1)


class Timer(threading.Thread):
    """Interrupts the main thread if something takes too long, until it is over."""

    def __init__(self, seconds: float):
        super().__init__(daemon=True)
        self.seconds = seconds  # of processor time: on a busy machine, the clock says nothing
        self.lock = threading.Lock()
        self.over = threading.Event()

    def run(self) -> None:
        start = time.process_time()
        start_by_clock = time.monotonic()
        stop_by = ""
        while not stop_by:
            if self.over.wait(LOOK_AT_LIMITS):
                return
            if present.is_debugged:
                continue
            if time.process_time() - start > self.seconds:
                stop_by = PROCESSOR
            elif time.monotonic() - start_by_clock > WAITING * self.seconds:
                stop_by = CLOCK
        interrupts = 0
        while not self.over.is_set():
            with self.lock:
                if not self.over.is_set():
                    self.interrupt(stop_by)
            interrupts += 1
            if not self.over.wait(NEXT_INTERRUPT) and interrupts >= MOST_INTERRUPTS:
                end_stubborn()

    def interrupt(self, stop_by: str) -> None:
        """Raise a KeyboardInterrupt in the main thread. It also ends a sleep."""
        present.stopped_by = stop_by
        if stop_by == CLOCK:
            present.shared_was_short = True  # a function may catch the interrupt
        if hasattr(signal, "pthread_kill"):
            signal.pthread_kill(main_thread_id(), signal.SIGINT)
        else:  # on Windows, any thread can send the signal
            signal.raise_signal(signal.SIGINT)

    def stop(self) -> None:
        """Let it end; no interrupt comes after this."""
        with self.lock:
            self.over.set()


@contextmanager
def patience(seconds: float) -> Iterator[None]:
    """Raise a KeyboardInterrupt in the body of the with statement if it takes longer than seconds.

    These are seconds of processor time. A body that only waits is stopped, too. If it catches
    MOST_INTERRUPTS, the process ends. In a debugger, there is no limit. If somebody presses Ctrl+C,
    raise a KeyboardInterrupt at the end, also if the body catches it.
    """

    def on_interrupt(*_: Any) -> None:
        if not present.stopped_by:
            present.is_pressed = True
        raise KeyboardInterrupt

    present.is_debugged = is_debugged()
    before = signal.signal(signal.SIGINT, on_interrupt)  # a background job ignores interrupts
    timer = Timer(seconds)
    timer.start()
    try:
        yield
    finally:
        timer.stop()
        signal.signal(signal.SIGINT, before)
        if present.is_pressed:
            raise KeyboardInterrupt
