"""Keep a solution's process to its own folder, and from starting others, by an audit hook of Python.

This holds off mistakes and simple tricks. It is no sandbox: code in C does not tell Python what it does.
https://docs.python.org/3/library/audit_events.html
"""

import os
import signal
import sys
from contextlib import suppress

CHANGES = 1000  # of files, also by the grader, which writes CSVs
# The beginnings of events.
REFUSED = (
    *("ctypes.", "os.exec", "os.fork", "os.posix_spawn", "os.spawn", "os.startfile", "os.system", "pty.", "socket."),
    "subprocess.",
)
CHANGING = (
    *("os.chmod", "os.chown", "os.link", "os.mkdir", "os.remove", "os.rename", "os.rmdir", "os.symlink"),
    *("os.truncate", "os.utime"),
)
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND


class Guard:
    """Refuses what a solution does not need, with a PermissionError."""

    def __init__(self, folder, hidden):
        """folder is the solution's folder; it must not read the hidden folders, with the answers for instance."""
        self.folder = within(folder)
        # Python's own folders may be in a hidden one.
        self.libraries = tuple(within(path) for path in {sys.prefix, sys.base_prefix, *sys.path[1:]} if path)
        self.hidden = tuple(map(within, [*hidden, os.path.dirname(folder)]))
        self.left = CHANGES

    def hook(self, event, arguments) -> None:
        """Take an event of Python into account."""
        if event == "open":
            path, _, flags = arguments
            if not isinstance(path, int) and path != os.devnull:
                self.change("writing", path) if flags & WRITING else self.read(path)
        elif event in CHANGING:
            # The last arguments are the folders of relative paths, as open files; -1 is the working directory.
            paths = [path for path in arguments if isinstance(path, (str, bytes, os.PathLike))]
            numbers = [number for number in arguments[1:] if isinstance(number, int)] if event != "os.truncate" else []
            self.change(event, *(path_in(*pair) for pair in zip(paths, numbers[-len(paths) :] or [-1], strict=False)))
        elif event in ("os.kill", "os.killpg"):
            if arguments[0] != os.getpid():
                refuse("signals to other processes")
        elif event.startswith(REFUSED) and event != "socket.__new__":
            refuse(event)

    def change(self, what, *paths) -> None:
        """Take a change of files into account."""
        self.left -= 1
        if self.left < 0:
            refuse(f"more than {CHANGES} changes of files")
        for path in paths:
            if not within(path).startswith(self.folder):
                refuse(f"{what} outside of the project's folder: {path}")

    def read(self, path) -> None:
        """Take the reading of a file into account."""
        real = within(path)
        if real.startswith(self.hidden) and not real.startswith((self.folder, *self.libraries)):
            refuse(f"reading outside of the project's folder: {path}")


def close_back_doors() -> None:
    """Refuse two functions that tell the audit hook nothing."""
    with suppress(ImportError):  # Windows has neither
        import _posixsubprocess

        _posixsubprocess.fork_exec = lambda *_: refuse("new processes")
    signal.pidfd_send_signal = lambda *_: refuse("signals to other processes")


def path_in(path, number) -> str:
    """Return the path of a file in the folder with the number of an open file, or -1."""
    if number < 0 or sys.platform != "linux":
        return path
    return os.path.join(os.readlink(f"/proc/self/fd/{number}"), os.fsdecode(path))


def within(path) -> str:
    """Return the beginning of the paths in this folder."""
    return os.path.realpath(os.fsdecode(path)) + os.sep


def refuse(what) -> None:
    raise PermissionError(f"the grader refuses {what}")
