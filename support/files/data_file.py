"""Write a file whole or not at all."""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import file_digest, sha256
from pathlib import Path
from typing import TextIO

# The digest of what this process has written last into a file; the content can be a gigabyte.
written: dict[Path, bytes] = {}


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
        with open(unfinished, "rb") as whole:
            digest = file_digest(whole, "sha256").digest()
        os.replace(unfinished, target)
        written[target.resolve()] = digest
    except OSError as error:
        if error.filename in (None, str(unfinished)):  # else it is of another file
            error.filename = str(filepath)
        raise
    finally:
        with suppress(OSError):  # it already has its final name, or was never there
            unfinished.unlink()


def has_written(filepath: str | Path, data: bytes) -> bool:
    """Return whether this process has written this content into a file."""
    return written.get(Path(filepath).resolve()) == sha256(data).digest()
