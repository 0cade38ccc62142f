"""Keep a solution's process to its own folder, and from starting others, by an audit hook of Python.

This holds off mistakes and simple tricks. It is no sandbox: code in C does not tell Python what it does.
https://docs.python.org/3/library/audit_events.html
"""

import os
import sys

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

    def __init__(self, folder, project):
        """folder is the solution's folder; project is the folder with the answers."""
        self.folder = within(folder)
        # Python's own folders may be in the project.
        self.libraries = tuple(within(path) for path in {sys.prefix, sys.base_prefix, *sys.path[1:]} if path)
        self.secret = within(project), within(os.path.dirname(folder))  # also the other solutions
        self.left = CHANGES

    def hook(self, event, arguments) -> None:
        """Take an event of Python into account."""
        if event == "open":
            path, _, flags = arguments
            if not isinstance(path, int) and path != os.devnull:
                self.change("writing", path) if flags & WRITING else self.read(path)
        elif event in CHANGING:
            self.change(event, *(path for path in arguments[:2] if isinstance(path, (str, bytes, os.PathLike))))
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
        if real.startswith(self.secret) and not real.startswith((self.folder, *self.libraries)):
            refuse(f"reading outside of the project's folder: {path}")


def within(path) -> str:
    """Return the beginning of the paths in this folder."""
    return os.path.realpath(os.fsdecode(path)) + os.sep


def refuse(what) -> None:
    raise PermissionError(f"the grader refuses {what}")
