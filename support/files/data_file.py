"""Write a file whole or not at all, for instance the data of a cradle's motion."""

import errno
import os
import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from secrets import token_hex
from stat import S_ISREG
from typing import TextIO

from support.files.cradle_csv import LARGEST_FILE, naming, reason

RUN_LINE = "<!doctype html><!-- A run of Newton's cradle -->"  # the first one of a saved run
INDEX_LINE = "<!doctype html><!-- Runs of Newton's cradle -->"  # of a page with links to runs
EVERY = 0.01  # s from sample to sample, or the nearest whole number of ticks


@contextmanager
def whole_file(filepath: str | Path) -> Iterator[TextIO]:
    """Yield a text file to write to; when it is complete on the disk, it replaces filepath.

    Otherwise, the old file is still there. Raises an OSError if filepath cannot be written.
    """
    target = Path(os.path.realpath(filepath))  # the file behind a link: the link must stay
    unfinished = target.parent / f".{target.name}.{token_hex(4)}.tmp"
    try:
        with naming(filepath, target, unfinished):
            can_be_written = target.is_file() and os.access(target, os.W_OK)
            if target.exists() and not can_be_written:
                raise OSError(errno.EACCES, "it is not a file, or is write-protected")
            # Not tempfile: a new file of that module is for you alone, and stays so under its final
            # name.
            with open(unfinished, "x", encoding="utf-8", newline="") as file:
                yield file
                file.flush()
                os.fsync(file.fileno())
            if target.exists():
                shutil.copymode(target, unfinished)
            os.replace(unfinished, target)
    finally:
        with suppress(OSError):  # it already has its final name, or was never there
            unfinished.unlink()


def has_data(line: bytes) -> bool:
    """Return whether this is the first line of a file with data of a cradle."""
    names = rb"t,theta_1,(.*,)?momentum|t(,theta_\d+)+(,omega_\d+)+"
    return re.fullmatch(names, line) is not None


def is_run(line: bytes) -> bool:
    """Return whether this is the first line of a saved run."""
    return line == RUN_LINE.encode()


def is_index(line: bytes) -> bool:
    """Return whether this is the first line of a page with links to runs."""
    return line == INDEX_LINE.encode()


def require_replaceable(
    option: str, filepath: str, is_ours: Callable[[bytes], bool], what: str
) -> None:
    """Raise a ValueError if this file of an option exists, and is not one to replace.

    is_ours(its first line) says whether it is; `what` names what is in such a file. The message has
    one line.
    """
    try:
        if not S_ISREG(Path(filepath).stat().st_mode):
            return  # whole_file will raise the error
        # Opened to write, too: another program may have it open
        with open(filepath, "r+b") as file:
            line = file.readline(LARGEST_FILE).strip()
    except FileNotFoundError:
        return  # a new file; if its folder is missing, whole_file will raise the error
    except OSError as error:
        raise ValueError(f"{option}: {filepath}: {reason(error)}") from error
    if line and not is_ours(line):
        raise ValueError(
            f"{option}: found '{filepath}', which has something else in it; "
            f"allowed is a new file, or one with {what}, to replace it"
        )
