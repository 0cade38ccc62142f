"""Write a file whole or not at all, for instance the data of a cradle's motion."""

import errno
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from secrets import token_hex
from stat import S_ISREG
from typing import TextIO

from support.files.cradle_csv import LARGEST, reason

EVERY = 0.01  # s from sample to sample, or the nearest whole number of ticks


@contextmanager
def whole_file(filepath: str | Path) -> Iterator[TextIO]:
    """Yield a text file to write to; when it is complete on the disk, it replaces filepath.

    Otherwise, the old file is still there. Raises an OSError if filepath cannot be written.
    """
    target = Path(os.path.realpath(filepath))  # the file behind a link: the link must stay
    unfinished = target.parent / f".{target.name}.{token_hex(4)}.tmp"
    try:
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
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {reason(error)}", str(filepath)) from error
    finally:
        with suppress(OSError):  # it already has its final name, or was never there
            unfinished.unlink()


def require_replaceable(filepath: str) -> None:
    """Raise a ValueError if this file exists, and has no data of a cradle to replace.

    Its message has one line. The name - stands for the output.
    """
    if filepath == "-":
        return
    try:
        if not S_ISREG(Path(filepath).stat().st_mode):
            return  # whole_file will raise the error
        # Opened to write, too: another program may have it open
        with open(filepath, "r+b") as file:
            header = file.readline(LARGEST).strip()
    except FileNotFoundError:
        return  # a new file; if its folder is missing, whole_file will raise the error
    except OSError as error:
        raise ValueError(f"--record: {filepath}: {reason(error)}") from error
    has_data = header.startswith(b"t,theta_1,") and header.endswith(b",momentum")
    if header and not has_data:
        raise ValueError(
            f"--record: found '{filepath}', which has no data of a cradle; "
            "allowed is a new file, or one with data of a cradle, to replace it"
        )
