"""Write a file whole or not at all."""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TextIO

written: dict[Path, int] = {}  # ns: when this process has written a file last


@contextmanager
def whole_file(filepath: str | Path) -> Iterator[TextIO]:
    """Yield a text file to write to; at the end of the with statement, it replaces filepath.

    After an error, the old file is still there. Raises an OSError with filepath if this cannot be
    written.
    """
    target = Path(filepath)
    if target.exists() and not target.is_file():  # or a file would take the place of /dev/null
        raise OSError(errno.EINVAL, "found a folder or a device, allowed is a file", str(filepath))
    unfinished = target.parent / f".{target.name}.{os.getpid()}.tmp"
    try:
        with open(unfinished, "w", encoding="utf-8", newline="") as file:
            yield file
        os.replace(unfinished, target)
        written[target.resolve()] = target.stat().st_mtime_ns
    except OSError as error:
        if error.filename in (None, str(unfinished)):  # else it is of another file
            error.filename = str(filepath)
        raise
    finally:
        with suppress(OSError):  # it already has its final name, or was never there
            unfinished.unlink()


def has_written(filepath: str | Path) -> bool:
    """Return whether this process was the last one that has written this file."""
    file = Path(filepath).resolve()
    return file.exists() and written.get(file) == file.stat().st_mtime_ns
