"""Limits for students' functions: of time and of memory. They cannot wait for input.

This is for mistakes. It is no protection from a student who means harm.
"""

import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, ExitStack
from dataclasses import dataclass
from pathlib import Path
from traceback import walk_stack
from types import FrameType
from unittest.mock import patch

from grading.raised import own_frames, place_at

MEMORY_IN_USE = Path("/proc/self/statm")  # Linux has it; its sixth number counts the pages of data
CLOCK, PROCESSOR = "clock", "processor"  # the time by which a function is stopped
# Modules whose code runs while Python frees an object: an error in it is lost, with a warning
CALLBACKS = "_weakrefset", "weakref"


@dataclass
class Limits:
    """A context manager for one performance of a check, which is its body.

    The body gets a KeyboardInterrupt if it takes too long. If it is not over after that, pytest
    ends. In a debugger, there is no limit of time. If somebody presses Ctrl+C, a KeyboardInterrupt
    comes at the end, also if the body catches it.

    In the body, input raises an EOFError. Without a terminal, breakpoint does nothing.
    """

    has_terminal: bool  # somebody can debug
    end: Callable[[str], None]  # shows a line and ends pytest; called in another thread
    patience: float = 5.0  # s of processor time: on a busy machine, the clock says nothing
    waiting: float = 50.0  # s by the clock, for a body that only waits
    grace: float = 1.0  # s by the clock, for a body that goes on after its interrupt
    memory: int = 1000  # MB

    stopped_by = ""  # CLOCK or PROCESSOR if its limit has passed
    is_pressed = False  # somebody pressed Ctrl+C

    def __enter__(self) -> "Limits":
        self.over = threading.Event()
        self.before = signal.signal(signal.SIGINT, self.on_interrupt)  # also if it was ignored
        self.is_debugged = is_debugged()
        self.answer = input
        self.changes = ExitStack()
        self.changes.enter_context(patch("builtins.input", self.refuse_input))
        if not self.has_terminal:
            self.changes.enter_context(patch("sys.breakpointhook"))  # a mock, which does nothing
            self.changes.enter_context(patch("pdb.set_trace"))
        self.thread = threading.get_ident()  # the main one: no other one gets signals
        self.timer = threading.Thread(target=self.watch_time, daemon=True)
        self.timer.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.over.set()
        self.timer.join()
        self.changes.close()
        signal.signal(signal.SIGINT, self.before)
        if self.is_pressed:
            raise KeyboardInterrupt

    def on_interrupt(self, _: int, frame: FrameType | None) -> None:
        """Raise a KeyboardInterrupt if the body runs: one that is over was in time."""
        if not self.stopped_by:
            self.is_pressed = True
        if not self.over.is_set() and module_in(frame) not in CALLBACKS:
            raise KeyboardInterrupt

    def refuse_input(self, *prompt: object) -> str:
        """Take the place of input."""
        if module_in(sys._getframe(1)) == "cmd":  # the prompt of a debugger
            self.is_debugged = True
            return self.answer(*prompt)
        raise EOFError("input() waits for somebody, but nobody answers in a check")

    def watch_time(self) -> None:
        """Stop the body when a time has passed."""
        end_of_patience = time.process_time() + self.patience
        end_of_waiting = time.monotonic() + self.waiting
        left = min(self.patience, self.waiting)
        while left > 0:
            if self.over.wait(left) or self.is_debugged:
                return
            left = min(end_of_patience - time.process_time(), end_of_waiting - time.monotonic())
        self.stopped_by = CLOCK if time.process_time() < end_of_patience else PROCESSOR
        self.stop()

    def stop(self) -> None:
        """Interrupt the body; end pytest if a student's code goes on after it."""
        self.interrupt()
        if not self.over.wait(self.grace):
            self.interrupt()  # the first one is lost if it comes while Python frees an object
        while not self.over.wait(self.grace):
            frames = own_frames(walk_stack(sys._current_frames()[self.thread]))
            if frames:
                place = place_at(*frames[0])
                self.end(f"{place} still runs after it was stopped, so pytest ends here.")

    def interrupt(self) -> None:
        """Raise a KeyboardInterrupt in the main thread. It also ends a sleep."""
        if hasattr(signal, "pthread_kill"):
            signal.pthread_kill(self.thread, signal.SIGINT)
        else:  # on Windows, any thread can send the signal
            signal.raise_signal(signal.SIGINT)

    def over_limit(self, error: BaseException) -> str:
        """Return how a call that raised this error went over a limit, or "" if it did not."""
        if isinstance(error, MemoryError):
            return f"took more than {self.memory} MB of memory"
        if self.stopped_by == CLOCK:
            return f"waited longer than {self.waiting:g} s"
        if self.stopped_by:
            return f"took longer than {self.patience:g} s"
        return ""


def module_in(frame: FrameType | None) -> str:
    """Return the name of the module whose code runs in a frame."""
    return frame.f_globals.get("__name__", "") if frame else ""


def is_debugged() -> bool:
    """Return whether a debugger is at work."""
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on
    tool = monitoring and monitoring.get_tool(monitoring.DEBUGGER_ID)
    return bool(tool or sys.gettrace())


@contextmanager
def limited_memory(megabytes: int) -> Iterator[None]:
    """Raise a MemoryError if the body of the with statement takes more than this, on Linux."""
    if not MEMORY_IN_USE.exists():
        yield
        return
    import resource  # Windows has none

    in_use = int(MEMORY_IN_USE.read_text().split()[5]) * resource.getpagesize()
    before = resource.getrlimit(resource.RLIMIT_DATA)
    most = in_use + megabytes * 10**6
    resource.setrlimit(resource.RLIMIT_DATA, (most, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, before)
