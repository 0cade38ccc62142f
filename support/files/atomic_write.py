"""Write a file whole, or not at all."""

import errno
import os
import re
import shutil
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path

# Windows: the number of tries to replace a file that a program has open, and the pause between two tries (s).
TRIES, PAUSE = 20, 0.05

# Windows: the time (s) after which a file that no program has open is left over.
OLD = 60.0


@contextmanager
def whole_file(filepath):
    """Yield a text file to write to; when it is complete on the disk, it replaces filepath.

    After a crash, on a full disk, or if the body of the with statement ends early, the old file is still there.
    Raises an OSError if filepath cannot be written.
    """
    target = Path(os.path.realpath(filepath))  # the file behind a link: the link must stay
    with naming_errors(filepath):
        if target.exists() and not (target.is_file() and os.access(target, os.W_OK)):
            raise OSError(errno.EACCES, "it is not a file, or is write-protected")
        with unfinished_file(target) as file:
            yield file
            complete(file)
            if target.exists():
                shutil.copymode(target, file.name)
            replace(file.name, target)


def write_new_file(paths, write) -> Path:
    """Let write(file) write a text file; return its path: the first one of paths (an iterator) that no file has.

    No file is replaced, and no path has a half written file, also if two programs do this at the same time. Raises an
    OSError if the file cannot be written.
    """
    target = next(path for path in paths if not path.exists())
    with naming_errors(target), unfinished_file(target) as file:
        write(file)
        complete(file)
        while not give_name(file.name, target):
            target = next(paths)
    return target


@contextmanager
def naming_errors(filepath):
    """Replace each OSError in the body of the with statement by one that says that filepath cannot be written."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(filepath)) from error


@contextmanager
def unfinished_file(target):
    """Yield a text file beside target, with a hidden name; if it still has this name in the end, it is deleted."""
    remove_left_over(target)
    unfinished = target.parent / f".{target.name}.{os.getpid()}.tmp"
    try:
        with open(unfinished, "w", encoding="utf-8", newline="") as file:
            yield file
    finally:
        with suppress(OSError):  # it already has its final name, or was never there
            unfinished.unlink()


def complete(file) -> None:
    """Close a file when all of it is on the disk."""
    file.flush()
    os.fsync(file.fileno())
    file.close()


def remove_left_over(target) -> None:
    """Remove the unfinished files of programs that were killed while they wrote target.

    Also those of targets with other numbers in their names: write_new_file chooses a number.
    """
    names = re.sub(r"\d+", r"\\d+", re.escape(target.name))
    with suppress(OSError):  # a missing folder, for instance: opening the file raises the error
        for name in os.listdir(target.parent):
            match = re.fullmatch(rf"\.{names}\.(\d{{1,9}})\.tmp", name)
            with suppress(OSError):
                if match and is_left_over(target.parent / name, int(match[1])):
                    os.unlink(target.parent / name)


def is_left_over(unfinished, process) -> bool:
    """Return whether the process with this number, which made the unfinished file, has ended."""
    if sys.platform == "win32":  # os.kill would end it; but Windows deletes no file that a program has open
        return time.time() - unfinished.stat().st_mtime > OLD
    try:
        os.kill(process, 0)  # sends no signal
    except ProcessLookupError:
        return True
    return False


def give_name(unfinished, target) -> bool:
    """Give the unfinished file this name, and return True, unless a file already has the name."""
    try:
        os.link(unfinished, target)
    except FileExistsError:
        return False
    except OSError:  # a disk without links, such as FAT: take the name with an empty file, and replace that
        try:
            open(target, "x").close()
        except FileExistsError:
            return False
        try:
            replace(unfinished, target)
        except OSError:
            target.unlink()
            raise
    return True


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
