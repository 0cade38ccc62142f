"""Write a file whole, or not at all."""

import errno
import os
import shutil
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path

# Windows: the number of tries to replace a file that a program has open, and the pause between two tries (s).
TRIES, PAUSE = 20, 0.05


@contextmanager
def whole_file(filepath):
    """Yield a text file to write to; when it is complete on the disk, it replaces filepath.

    After a crash, on a full disk, or if the body of the with statement ends early, the old file is still there.
    Raises an OSError if filepath cannot be written.
    """
    target = Path(os.path.realpath(filepath))  # the file behind a link: the link must stay
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
        with suppress(OSError):  # it already has its final name, or was never there
            unfinished.unlink()


def replace(unfinished, target) -> None:
    """Replace target with the unfinished file.

    Windows refuses this while a program has target open. A cradle closes its file within moments. If another program
    keeps it open, raise an OSError that says so.
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
