"""Read a CSV, and check that it describes a cradle.

Each mistake raises a ValueError with a one-line message.
"""

import csv
import errno
import io
import os
import re
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from decimal import Decimal
from functools import cached_property
from math import isfinite, nan
from pathlib import Path
from stat import S_ISREG
from tempfile import TemporaryDirectory

from support.constants import COLOR_MAP, TEXTURE_MAP

LARGEST = 10_000_000  # bytes of a file
MOST_PENDULA = 1000  # of a cradle
POLL = 0.2  # s between two looks at a file while you edit it
LONGEST_FOUND = 300  # letters of a file in a message
# The first bytes of .xlsx, .ods and .numbers, and of .xls
WORKBOOKS = b"PK\3\4", b"\xd0\xcf\x11\xe0"
# What to do if this stands between the names, which are then one cell.
HINTS = {
    ";": "separate cells with commas, not semicolons",
    "\t": "separate cells with commas, not tabs",
    ",": "take away the quotes around each line",
}
OTHER_COMMAS = {"\uff0c", "\u3001", "\u060c"}  # full-width, ideographic, and Arabic


def read_file(filepath) -> bytes:
    """Return the content of a file; raises an OSError if it cannot be read, or is larger than
    LARGEST.

    It raises one for a pipe, which may have no writer, and for a device, which may have no end, and
    never waits.
    """
    if Path(filepath).is_dir():  # Windows would only say that the permission is denied
        raise OSError(errno.EISDIR, "found a folder, allowed is a file")
    # Without it, which Windows does not have, a pipe would wait for its writer
    at_once = getattr(os, "O_NONBLOCK", 0)
    path = Path(filepath)  # it takes no number, which would be an open file
    with open(path, "rb", opener=lambda path, flags: os.open(path, flags | at_once)) as file:
        if not S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(errno.EINVAL, "found a pipe or a device, allowed is a file")
        data = file.read(LARGEST + 1)
    if len(data) > LARGEST:
        raise OSError(
            errno.EFBIG,
            f"found more than {LARGEST // 10**6} MB, allowed are at most {LARGEST // 10**6} MB",
        )
    return data


def reason(error) -> str:
    """Return what an OSError says; Windows does not say that Excel keeps others from a file."""
    may_be_held = sys.platform == "win32" and isinstance(error, PermissionError)
    return f"{error.strerror}{'; another program may have it open' * may_be_held}"


class Snapshot:
    """The content of a file at one moment, read once.

    The functions below take it in place of the file's path.
    """

    def __init__(self, filepath, data=None):
        """Read the file; or take data (bytes) in place of its content."""
        self.filepath, self.data, self.error = filepath, data or b"", None
        if data is None:
            try:
                self.data = read_file(filepath)
            except OSError as error:
                self.error = error

    def __str__(self) -> str:
        return str(self.filepath)

    def __eq__(self, other) -> bool:
        return (self.data, str(self.error)) == (other.data, str(other.error))

    @cached_property
    def rows(self) -> list[tuple[int, list[str]]]:
        """The rows of read_cells."""
        rows = list(self.each_row())
        if not rows:
            raise ValueError(f"{self}: is empty, the first line must name the columns")
        width = max(number for number, name in enumerate(rows[0][1], start=1) if name)
        for line, cells in rows:
            if any(cells[width:]):
                found = f"found {len(cells)} cells, allowed are at most {width}, as in line {rows[0][0]}"
                raise ValueError(
                    f"{self}, line {line}: {found}; a comma starts a new cell, also inside a number"
                )
            del cells[width:]
        return rows

    def each_row(self) -> Iterator[tuple[int, list[str]]]:
        """Yield the rows of read_cells one by one, of any width."""
        reader = csv.reader(io.StringIO(self.text(), newline=""), skipinitialspace=True)
        line = 1
        try:
            for cells in reader:
                cells = [cell.strip() for cell in cells]
                values = [*filter(None, cells)]
                # That line is for Excel
                if values and not (line == 1 and re.fullmatch("(?i)sep=.?", "".join(values))):
                    yield line, cells
                line = reader.line_num + 1
        except csv.Error as error:
            raise ValueError(f"{self}, line {line}: {error}") from error

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
        place, found = self.data.find(b"\0"), "a zero byte"
        try:
            text = self.data.decode("utf-8")
        except UnicodeDecodeError as error:
            place, found = error.start, f"byte 0x{self.data[error.start]:02x}"
        if place >= 0:
            line = self.data.count(b"\n", 0, place) + 1
            raise ValueError(
                f"{self}, line {line}: found {found}, allowed is text only, saved as UTF-8"
            )
        return text.replace("\ufeff", "").rstrip("\x1a\r\n")


class LiveFile:
    """Notices when a file has changed, in place or because an editor has replaced it."""

    def __init__(self, filepath, clock=time.monotonic):
        """Watch this file from now on. A test can replace clock()."""
        self.filepath, self.clock = filepath, clock
        self.current = self.candidate = Snapshot(filepath)
        self.next_look = clock() + POLL

    def changed(self) -> bool:
        """Return whether the file has changed since this last returned True; current then has the
        new content.

        A change counts when two looks in a row find the same new content: an editor may be in the
        middle of saving.
        """
        if self.clock() < self.next_look:
            return False
        self.next_look = self.clock() + POLL
        found = Snapshot(self.filepath)
        # No more files can be open: no news
        if getattr(found.error, "errno", None) in (errno.EMFILE, errno.ENFILE):
            return False
        previous, self.candidate = self.candidate, found
        if self.candidate != previous or self.candidate == self.current:
            return False
        self.current = self.candidate
        return True


def read_cells(filepath) -> list[tuple[int, list[str]]]:
    """Return the rows of a CSV, the header first, each row as (line number in the file, cells as
    text).

    Left out are rows without a value, last columns without a name, spaces around a cell, byte-order
    marks, ^Z at the end, and `sep=,` in line 1. Raises a ValueError that names the mistake and its
    place if the file cannot be read, is not UTF-8 text, is empty, or has a row with more cells than
    the header.
    """
    return snapshot_of(filepath).rows


def snapshot_of(filepath) -> Snapshot:
    """Return the Snapshot of a file; filepath may also be a Snapshot."""
    return filepath if isinstance(filepath, Snapshot) else Snapshot(filepath)


@contextmanager
def clean_copy(filepath):
    """Yield the path (str) of a file with the rows of read_cells, for the body of the with
    statement.

    The handout's functions read this copy: a plain pd.read_csv takes a space for a part of a cell,
    and another program can write the file at any time. Raises the same ValueErrors as read_cells.
    """
    (_, header), *rows = read_cells(filepath)
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        copy = Path(folder) / Path(str(filepath)).name
        with open(copy, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(header)
            writer.writerows(map(for_pandas, header, cells) for _, cells in rows)
        yield str(copy)


def for_pandas(column, text) -> str:
    """Return the text of a cell; a long number in short: pandas 2 reads 17 digits, and counts zeros
    before them.
    """
    if column in ("mass", "e") and len(text) > 15 and isfinite(to_number(text)):
        return f"{Decimal(repr(to_number(text))):e}"
    return text


def in_short(text) -> str:
    """Return the beginning of a long text, for a message: a file that is no cradle may have a line
    of megabytes.
    """
    return text if len(text) <= LONGEST_FOUND else f"{text[:LONGEST_FOUND]}..."


def to_number(text: str) -> float:
    """Return the number in text, or nan; stricter than float(), which also accepts texts like
    1_000.
    """
    try:
        return float(text) if text.isascii() and "_" not in text else nan
    except ValueError:
        return nan


# For each column, a test of a cell's text, and words for the allowed values. The columns theta and
# omega need no rule: the start of a cradle does not depend on them. Floats below 1e-308 have few
# digits: hits would change the energy.
RULES = {
    "mass": (
        lambda text: 1e-300 <= to_number(text) <= 1e6,
        "a number from 1e-300 to 1e6 (kg), such as 1.5",
    ),
    "e": (lambda text: 0 <= to_number(text) <= 1, "a number from 0 to 1, such as 0.9"),
    "color": (COLOR_MAP.__contains__, f"one of {', '.join(COLOR_MAP)}"),
    "texture": (TEXTURE_MAP.__contains__, f"one of {', '.join(TEXTURE_MAP)}"),
}


# In a double cradle, a light bob between two heavy ones can get so fast that a tick has to be done
# in many small steps (src/double_cradle.py). With these masses, no trial needed more than about two
# hundred.
MOST_TIMES = 1e6
IN_RANGE = "at most 1e6 times the smallest mass, in a double cradle"


def are_in_range(masses) -> bool:
    """Return whether the largest of these masses of a double cradle is at most MOST_TIMES the
    smallest one.
    """
    return max(masses) <= MOST_TIMES * min(masses)


def comma_hint(text) -> str:
    """Return a hint, to put behind the allowed values, if another comma than the plain one is in
    this text.
    """
    return "; separate cells with plain commas (,)" if OTHER_COMMAS.intersection(text) else ""


def check_header(place, header) -> None:
    """Raise a ValueError if the header at this place does not name each column of a cradle once."""
    names = in_short(", ".join(map(repr, filter(None, header))))
    allowed = f"a cradle needs one column of each of {', '.join(RULES)}{comma_hint(names)}"
    if not RULES.keys() & {*header}:
        for separator, hint in HINTS.items():
            parts = {part.strip(' "').lower() for part in header[0].split(separator)}
            allowed += f"; {hint}" * (len(RULES.keys() & parts) > 1)
        raise ValueError(f"{place} must name the columns: found {names}; {allowed}")
    for column in RULES:
        count = header.count(column)
        if count != 1:
            found = f"{count} columns" if count else "no column"
            raise ValueError(f"{place}: found {found} {column} in {names}; {allowed}")


def require_cradle(filepath, cords=1) -> None:
    """Raise a ValueError for the first mistake in the CSV of a cradle.

    It names the file, the line, the column, the value found and the allowed values. cords is the
    number of cords of a pendulum: 1, or 2 for the double cradle, which needs masses in the range of
    MOST_TIMES, too.
    """
    snapshot = snapshot_of(filepath)
    # This looks at no later row: the rows of a file of 10 MB would take a gigabyte of memory.
    for number, (line, cells) in enumerate(snapshot.each_row()):
        # Before the rows: a title above the names may have fewer cells than they have
        if number == 0:
            check_header(f"{snapshot}, line {line}", cells)
        if number > MOST_PENDULA:
            allowed = (
                f"allowed are at most {MOST_PENDULA}, which already move in slow motion on the page"
            )
            raise ValueError(f"{snapshot}, line {line}: found pendulum {number}, {allowed}")
    (_, header), *rows = snapshot.rows
    if not rows:
        raise ValueError(
            f"{snapshot}: names columns but has no pendulum, a cradle needs at least one row below them"
        )
    for line, cells in rows:
        pendulum = dict(zip(header, cells, strict=False))  # a short row lacks its last cells
        for column, (is_allowed, allowed) in RULES.items():
            text = pendulum.get(column, "")
            if not is_allowed(text):
                found = f"found {in_short(repr(text))}" if text else "found nothing"
                short = f"; this line has {len(cells)} cells, not {len(header)}" * (
                    len(cells) < len(header)
                )
                words = f"{found}, allowed is {allowed}{short}{comma_hint(text)}"
                raise ValueError(f"{snapshot}, line {line}, column {column}: {words}")
    masses = [(cells[header.index("mass")], line) for line, cells in rows]
    (least, least_line), (most, line) = (
        pick(masses, key=lambda mass: to_number(mass[0])) for pick in (min, max)
    )
    if cords == 2 and not are_in_range([to_number(least), to_number(most)]):
        found = f"found {most!r}, and {least!r} in line {least_line}"
        raise ValueError(f"{snapshot}, line {line}, column mass: {found}, allowed is {IN_RANGE}")
