"""Read a CSV as it is at one moment, and notice when it changes.

Each mistake raises a ValueError with a one-line message.
"""

import csv
import io
import time
from collections.abc import Callable, Iterator
from math import isnan
from pathlib import Path
from typing import Any, NamedTuple

from support.columns import to_number

LARGEST_FILE = 6_000_000  # bytes of a file
POLL = 0.1  # s between two looks at files while you edit them


class CsvRow(NamedTuple):
    """A row of a CSV."""

    line: int  # the number of its line in the file
    cells: list[str]  # one for each column


class Snapshot:
    """The content of a file at one moment, read once."""

    def __init__(self, filepath: str | Path, data: bytes | None = None) -> None:
        """Read the file; or take data in place of its content."""
        self.filepath = filepath
        self.data = data or b""
        self.error = ""  # why the file cannot be read
        try:
            size = Path(filepath).stat().st_size if data is None else len(data)
            if size > LARGEST_FILE:
                self.error = f"it has more than {LARGEST_FILE // 10**6} MB"
            elif data is None:
                self.data = Path(filepath).read_bytes()
        except OSError as error:
            self.error = str(error.strerror)

    def __str__(self) -> str:
        return str(self.filepath)

    def __eq__(self, other: Any) -> bool:
        """Return whether two have the same content; a file that cannot be read has none."""
        return self.data == other.data

    def rows(self) -> Iterator[CsvRow]:
        """Yield the rows, the header first.

        Semicolons separate cells if the first line with text has one, or else commas, or else tabs.
        Beside semicolons and tabs, a number can have a decimal comma, which becomes a point. Rows
        without a value are left out, and so are empty cells at the end of a row, and spaces around
        a cell. Raises a ValueError that names the mistake and its place if the file cannot be read,
        is not UTF-8 text, is empty, or has a row with more cells than the header.
        """
        text = self.text()
        first_line = text.lstrip().partition("\n")[0]
        separator = next((letter for letter in ";,\t" if letter in first_line), ",")
        lines = io.StringIO(text, newline="")
        reader = csv.reader(lines, delimiter=separator, skipinitialspace=True)
        header: CsvRow | None = None
        line = 1
        try:
            for row in reader:
                cells = [plain_cell(cell.strip(), separator) for cell in row]
                while cells and not cells[-1]:
                    cells.pop()
                if cells:
                    header = header or CsvRow(line, cells)
                    width = len(header.cells)
                    if len(cells) > width:
                        raise ValueError(
                            f"{self}, line {line}: found {len(cells)} cells, allowed are at most "
                            f"{width}, as in line {header.line}; "
                            "a decimal comma needs semicolons between cells"
                        )
                    missing = [""] * (width - len(cells))
                    yield CsvRow(line, cells + missing)
                line = reader.line_num + 1
        except csv.Error as error:
            raise ValueError(f"{self}, line {line}: {error}") from error
        if not header:
            raise ValueError(f"{self}: is empty, its first line must name the columns")

    def text(self) -> str:
        """Return the text, without a byte-order mark before it."""
        if self.error:
            raise ValueError(f"{self}: cannot be read: {self.error}")
        try:
            return self.data.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            text = error.object[: error.start]
            line = text.count(b"\n") + 1
            byte = error.object[error.start]
            raise ValueError(
                f"{self}, line {line}: found byte 0x{byte:02x}, "
                "allowed is text only, saved as UTF-8"
            ) from error


def plain_cell(text: str, separator: str) -> str:
    """Return the text of a cell; if no commas separate cells, a decimal comma becomes a point."""
    number = text.replace(",", ".")
    return text if separator == "," or isnan(to_number(number)) else number


class Live:
    """Notices when what it reads has changed, in place or because an editor has replaced a file."""

    def __init__(self, read: Callable[[], Any], quiet: float, clock: Callable[[], float]) -> None:
        """Watch from now on what read() returns.

        It counts as changed when it is the same for `quiet` (s): an editor may be in the middle of
        saving. A test can replace clock().
        """
        self.read = read
        self.quiet = quiet
        self.clock = clock
        self.take()

    def take(self) -> None:
        """Take what there is now."""
        self.current = self.candidate = self.read()
        self.since = self.next_look = self.clock()

    def changed(self) -> bool:
        """Return whether there was a change since this last returned True, or since take.

        current then has the new content.
        """
        now = self.clock()
        if now < self.next_look:
            return False
        self.next_look = now + POLL
        found = self.read()
        if found != self.candidate:
            self.candidate = found
            self.since = now
        if found == self.current or now - self.since < self.quiet:
            return False
        self.current = found
        return True


class LiveFile(Live):
    """Notices when you have saved a CSV."""

    def __init__(self, filepath: str | Path, clock: Callable[[], float] = time.monotonic) -> None:
        self.filepath = filepath
        super().__init__(lambda: Snapshot(filepath), POLL / 2, clock)
