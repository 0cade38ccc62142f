"""Files that are written whole, or not at all."""

import errno
import os
import shutil
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path

# Windows: how often to try to replace a file that a program has open, and how long to wait in between (s).
TRIES, PAUSE = 20, 0.05


@contextmanager
def whole_file(filepath):
    """Yield a text file to write to, which takes filepath's place once it is complete on the disk.

    After a crash, on a full disk, or if the body of the with statement ends early, what was there before still is.
    Raises an OSError if filepath cannot be written.
    """
    target = Path(os.path.realpath(filepath))  # behind a link: the link is to stay
    unfinished = target.parent / f".{target.name}.{os.getpid()}.tmp"
    try:
        if target.exists() and not (target.is_file() and os.access(target, os.W_OK)):
            raise OSError(errno.EACCES, "it is not a file, or is write-protected")
        with open(unfinished, "w", encoding="utf-8", newline="") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        if target.exists():
            shutil.copymode(target, unfinished)
        replace(unfinished, target)
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(filepath)) from error
    finally:
        with suppress(OSError):  # it has its final name by now, or was never there
            unfinished.unlink()


def replace(unfinished, target) -> None:
    """Put the unfinished file in the target's place.

    Windows refuses that while a program has the target open. A cradle closes its file within moments; if another
    program keeps it open, the OSError says so.
    """
    for _ in range(TRIES - 1 if sys.platform == "win32" else 0):
        try:
            return os.replace(unfinished, target)
        except PermissionError:
            time.sleep(PAUSE)
    try:
        return os.replace(unfinished, target)
    except PermissionError as error:
        if sys.platform != "win32":
            raise
        raise OSError(error.errno, "another program has it open") from error
