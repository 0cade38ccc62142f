"""Read a CSV as it is at one moment, and notice when it changes.

Each mistake raises a ValueError with a one-line message.
"""

import csv
import errno
import io
import os
import re
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cached_property
from math import isfinite
from pathlib import Path
from stat import S_ISREG
from typing import Any, NamedTuple

from support.columns import to_number

LARGEST_FILE = 10_000_000  # bytes of a file
POLL = 0.2  # s between two looks at a file while you edit it
# The first bytes of .xlsx, .ods and .numbers, and of .xls
WORKBOOKS = b"PK\3\4", b"\xd0\xcf\x11\xe0"
SEPARATOR = re.compile("[,;\t]")  # between the cells of a CSV
# The line with the names, or the end: the first one with a letter, without `sep=;` for Excel
NAMES = re.compile(r"(?im)^(?![^\w\n]*sep=).*\w.*|\Z")


def read_file(filepath: str | Path) -> bytes:
    """Return the content of a file.

    Of one that is larger than LARGEST_FILE, return a part that is larger, too. Raises an OSError if
    the file cannot be read. It never waits: it also raises one for a pipe, which may have no
    writer, and for a device, which may have no end.
    """
    path = Path(filepath)  # it takes no number, which would be an open file
    if path.is_dir():  # Windows would only say that the permission is denied
        raise OSError(errno.EISDIR, "found a folder, allowed is a file")

    def open_at_once(path: str, flags: int) -> int:
        # Without O_NONBLOCK, which Windows does not have, a pipe would wait for its writer.
        return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))

    with open(path, "rb", opener=open_at_once) as file:
        if not S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(errno.EINVAL, "found a pipe or a device, allowed is a file")
        return file.read(LARGEST_FILE + 1)


def reason(error: OSError) -> str:
    """Return what an OSError says; Windows does not say that Excel keeps others from a file."""
    if sys.platform == "win32" and isinstance(error, PermissionError):
        return f"{error.strerror}; another program may have it open"
    return str(error.strerror)


@contextmanager
def naming(filepath: str | Path, *other_names: object) -> Iterator[None]:
    """Let an OSError of the body say that filepath cannot be written.

    It stays as it is if it names another file, which is none of other_names.
    """
    try:
        yield
    except OSError as error:
        if error.filename not in (None, *map(str, other_names)):
            raise
        raise OSError(error.errno, f"cannot be written: {reason(error)}", str(filepath)) from error


class CsvRow(NamedTuple):
    """A row of a CSV."""

    line: int  # the number of its line in the file
    cells: list[str]


class Snapshot:
    """The content of a file at one moment, read once."""

    def __init__(self, filepath: str | Path, data: bytes | None = None) -> None:
        """Read the file; or take data in place of its content."""
        self.filepath = filepath
        self.data = data or b""
        self.error: OSError | None = None
        try:
            if data is None:
                self.data = read_file(filepath)
            if len(self.data) > LARGEST_FILE:
                most = f"{LARGEST_FILE // 10**6} MB"
                raise OSError(errno.EFBIG, f"found more than {most}, allowed are at most {most}")
        except OSError as error:
            self.error = error

    def __str__(self) -> str:
        return str(self.filepath)

    def __eq__(self, other: Any) -> bool:
        """Return whether two have the same content, or could not be read for the same reason."""
        return self.data == other.data and str(self.error) == str(other.error)

    @cached_property
    def rows(self) -> list[CsvRow]:
        """The rows, the header first.

        The first line with names decides what separates cells; a number has a decimal point and a
        plain minus. Left out are rows without a value, last cells without one, spaces around a
        cell, byte-order marks, ^Z at the end, and `sep=,` in line 1. Raises a ValueError that names
        the mistake and its place if the file cannot be read, is not UTF-8 text, is empty, or has a
        row with more cells than the header.
        """
        return list(self.each_row())

    def each_row(self) -> Iterator[CsvRow]:
        """Yield the rows one by one. Raises the same ValueErrors as rows."""
        text = self.text()
        names = next(NAMES.finditer(text))
        separator = separator_in(names[0])
        above = text.count("\n", 0, names.start())  # lines, which are then blank
        lines = io.StringIO("\n" * above + text[names.start() :], newline="")
        reader = csv.reader(lines, delimiter=separator, skipinitialspace=True)
        line = 1
        width = 0  # of the header
        try:
            for row in reader:
                cells = [plain_cell(cell.strip(), separator) for cell in row]
                while cells and not cells[-1]:
                    cells.pop()
                width = width or len(cells)
                if len(cells) > width:
                    raise ValueError(
                        f"{self}, line {line}: found {len(cells)} cells, allowed are at most "
                        f"{width}, as in line {above + 1}; "
                        "a decimal comma needs semicolons or tabs between cells"
                    )
                if cells:
                    yield CsvRow(line, cells)
                line = reader.line_num + 1
        except csv.Error as error:
            raise ValueError(f"{self}, line {line}: {error}") from error
        if not width:
            raise ValueError(f"{self}: is empty, or has no letter; line 1 must name the columns")

    def text(self) -> str:
        """Return the text, without byte-order marks: pandas leaves out only one.

        DOS may end it with ^Z, 0x1a.
        """
        if self.error:
            raise ValueError(f"{self}: cannot be read: {reason(self.error)}") from self.error
        if self.data.startswith(WORKBOOKS):
            raise ValueError(
                f"{self}: is a workbook; open it in Excel or the like, and save it as CSV"
            )
        found = "a zero byte"
        place = self.data.find(b"\0")
        try:
            text = self.data.decode("utf-8")
        except UnicodeDecodeError as error:
            place = error.start
            found = f"byte 0x{self.data[place]:02x}"
        if place >= 0:
            line = self.data.count(b"\n", 0, place) + 1
            raise ValueError(
                f"{self}, line {line}: found {found}, allowed is text only, saved as UTF-8"
            )
        return text.replace("\ufeff", "").rstrip("\x1a\r\n")


def separator_in(line: str) -> str:
    """Return the sign that separates the cells of this line: the first one outside of quotes."""
    first = SEPARATOR.search(re.sub('"[^"]*"', "", line))
    return first[0] if first else ","


def plain_cell(text: str, separator: str) -> str:
    """Return the text of a cell; a number has a decimal point, and a plain minus.

    It can have a decimal comma if something else separates cells.
    """
    number = text.replace("\u2212", "-")
    if separator != ",":
        number = number.replace(",", ".")
    return number if isfinite(to_number(number)) else text


class LiveFile:
    """Notices when a file has changed, in place or because an editor has replaced it."""

    def __init__(self, filepath: str | Path, clock: Callable[[], float] = time.monotonic) -> None:
        """Watch this file from now on. A test can replace clock()."""
        self.filepath = filepath
        self.clock = clock
        self.current = self.candidate = Snapshot(filepath)
        self.next_look = clock() + POLL

    def changed(self) -> bool:
        """Return whether the file has changed since this last returned True.

        current then has the new content. A change is accepted when two looks in a row find the same
        new content: an editor may be in the middle of saving.
        """
        if self.clock() < self.next_look:
            return False
        self.next_look = self.clock() + POLL
        found = Snapshot(self.filepath)
        if found.error and found.error.errno in (errno.EMFILE, errno.ENFILE):
            return False  # no more files can be open: this says nothing about the file
        previous = self.candidate
        self.candidate = found
        if found != previous or found == self.current:
            return False
        self.current = found
        return True
