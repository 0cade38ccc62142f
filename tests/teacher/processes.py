"""The processes that this program starts, and that none of them is left."""

import ctypes
import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import suppress
from math import inf
from pathlib import Path

NO_CTRL_C = (
    {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
    if os.name == "nt"
    else {"start_new_session": True}
)
SUBREAPER = 36  # prctl's number: what the children of this process leave behind becomes its child
PATIENCE = 5  # s, to find processes that are left
LOOK_AT_PROCESS = 0.1  # s from one look at a process to the next


class Processes:
    """The processes that this program starts, each with those that it starts itself."""

    def __init__(self):
        self.lock = threading.Lock()
        self.own: set[int] = set()  # the numbers of those that it has started itself
        if sys.platform == "linux":
            ctypes.CDLL(None).prctl(SUBREAPER, 1, 0, 0, 0)

    def run(self, *command, seconds=inf, stop=lambda: False, **options) -> int | None:
        """Run a command to its end, and end what it leaves; return its exit status.

        Return None after these seconds, and once stop returns True. It is asked again and again.
        """
        with self.lock:
            job = ctypes.windll.kernel32.CreateJobObjectW(None, None) if os.name == "nt" else None
            process = subprocess.Popen(command, **NO_CTRL_C, **options)
            self.own.add(process.pid)
        try:
            if job:  # from now on, all that it starts is in its job, also after it has ended
                ctypes.windll.kernel32.AssignProcessToJobObject(job, int(process._handle))
            return wait(process, seconds, stop)
        finally:
            if job:
                ctypes.windll.kernel32.TerminateJobObject(job, 1)
                ctypes.windll.kernel32.CloseHandle(job)
            end(process)
            with self.lock:
                self.end_orphans()  # one could trace the process, and keep it
            with suppress(subprocess.TimeoutExpired):
                process.wait(PATIENCE)
            with self.lock:
                self.own.remove(process.pid)
                self.end_orphans()

    def end_orphans(self) -> None:
        """End the processes that others have left; on other systems than Linux, nobody finds them.

        They are stopped before they are killed: as long as one is there, another one cannot be made
        in its place.
        """
        deadline = time.monotonic() + PATIENCE
        stopped: set[int] = set()
        while (left := {*self.orphans()}) and time.monotonic() < deadline:
            if left <= stopped:
                send(signal.SIGKILL, left)
            send(signal.SIGSTOP, left - stopped)
            stopped |= left
            for pid in left:
                with suppress(OSError):
                    os.waitpid(pid, os.WNOHANG)  # one that has not ended yet comes again

    def orphans(self) -> list[int]:
        """Return the processes that others have left, and those below them."""
        found = [pid for pid in children("self") if pid not in self.own]
        for pid in found:
            found += children(pid)
        return found


def wait(process, seconds, stop) -> int | None:
    """Return the exit status of a process.

    Return None if it takes longer than these seconds, or if stop returns True.
    """
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline and not stop():
        with suppress(subprocess.TimeoutExpired):
            return process.wait(LOOK_AT_PROCESS)
    return None


def end(process) -> None:
    """End a process, and those of its group."""
    process.kill()
    # macOS refuses it for a process that has just ended; Windows has no groups
    with suppress(OSError, AttributeError):
        os.killpg(process.pid, signal.SIGKILL)


def send(number, processes) -> None:
    """Send a signal to processes."""
    for pid in processes:
        with suppress(OSError):  # it has ended
            os.kill(pid, number)


def children(process) -> list[int]:
    """Return the numbers of the processes whose parent is this one. Linux has them."""
    found = []
    for file in Path(f"/proc/{process}/task").glob("*/children"):
        with suppress(OSError):  # the thread has ended
            found += map(int, file.read_text().split())
    return found
