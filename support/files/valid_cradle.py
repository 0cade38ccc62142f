"""What the CSV of a cradle must have; the checked CSV, and a copy of it for pandas."""

import csv
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from decimal import Decimal
from math import isfinite
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from support.columns import CHECKED, to_number
from support.files.cradle_csv import CsvRow, naming, SEPARATOR, Snapshot
from support.found import found, in_short

MOST_PENDULA = 1000  # of a cradle

# In a double cradle, a light bob between two heavy ones can get so fast that a tick has to be done
# in many small steps (src/double_cradle.py). With these masses, no trial needed more than about two
# hundred.
MOST_TIMES = 1e6
IN_RANGE = "at most 1e6 times the smallest mass, in a double cradle"


class CradleCsv(NamedTuple):
    """The CSV of a cradle, parsed and checked: all that comes later takes its cells from here."""

    filepath: str | Path
    columns: list[str]  # their names
    pendula: list[list[str]]  # the cells of each row, one for each column


def read_cradle(snapshot: Snapshot, cords: int = 1) -> CradleCsv:
    """Return the checked CSV of a cradle.

    cords is the number of cords of a pendulum: 1, or 2 for the double cradle, which needs masses in
    the range of MOST_TIMES, too. Raises a ValueError for the first mistake. It names the file, the
    line, the column, the value found and the allowed values.
    """
    rows = snapshot.each_row()  # one by one: those of 10 MB would take a gigabyte of memory
    header = next(rows)
    require_columns(f"{snapshot}, line {header.line}", header.cells)
    pendula: list[CsvRow] = []
    for row in rows:
        if len(pendula) == MOST_PENDULA:
            raise ValueError(
                f"{snapshot}, line {row.line}: found pendulum {MOST_PENDULA + 1}, allowed are at "
                f"most {MOST_PENDULA}, which already move in slow motion on the page"
            )
        require_allowed_cells(snapshot, header, row)
        pendula.append(row)
    if not pendula:
        raise ValueError(
            f"{snapshot}: names columns but has no pendulum, "
            "a cradle needs at least one row below them"
        )
    if cords == 2:
        require_masses_in_range(snapshot, header, pendula)
    width = len(header.cells)
    filled = [[*row.cells, *[""] * (width - len(row.cells))] for row in pendula]  # last cells
    return CradleCsv(snapshot.filepath, header.cells, filled)


def require_columns(place: str, names: list[str]) -> None:
    """Raise a ValueError if the names at this place lack a column of a cradle, or repeat one."""
    hint = ""
    if len(names) == 1 and SEPARATOR.search(names[0]):
        hint = "; delete the quotes around each line"
    for column in CHECKED:
        count = names.count(column)
        if count != 1:
            columns = f"{count} columns" if count else "no column"
            all_names = in_short(", ".join(repr(name) for name in names if name))
            raise ValueError(
                f"{place} must name the columns: found {columns} {column} in {all_names}; "
                f"a cradle needs one column of each of {', '.join(CHECKED)}{hint}"
            )


def require_allowed_cells(snapshot: Snapshot, header: CsvRow, row: CsvRow) -> None:
    """Raise a ValueError if a cell of this row has a value that its column does not allow."""
    # A short row lacks its last cells.
    pendulum = dict(zip(header.cells, row.cells, strict=False))
    for name, column in CHECKED.items():
        text = pendulum.get(name, "")
        if name in header.cells and not column.allows(text):
            message = found(text, column.allowed())
            if len(row.cells) < len(header.cells):
                last = f"cell {len(row.cells)} of {len(header.cells)}"
                message += f"; the last value in this line is in {last}"
            raise ValueError(f"{snapshot}, line {row.line}, column {name}: {message}")


def require_masses_in_range(snapshot: Snapshot, header: CsvRow, pendula: list[CsvRow]) -> None:
    """Raise a ValueError if these pendula of a double cradle have masses that are too far apart."""
    column = header.cells.index("mass")

    def mass(row: CsvRow) -> float:
        return to_number(row.cells[column])

    lightest = min(pendula, key=mass)
    heaviest = max(pendula, key=mass)
    if not are_in_range([mass(lightest), mass(heaviest)]):
        raise ValueError(
            f"{snapshot}, line {heaviest.line}, column mass: found {heaviest.cells[column]!r}, "
            f"and {lightest.cells[column]!r} in line {lightest.line}, allowed is {IN_RANGE}"
        )


def are_in_range(masses: Iterable[float]) -> bool:
    """Return whether the masses of a double cradle are at most MOST_TIMES the smallest one."""
    return max(masses) <= MOST_TIMES * min(masses)


@contextmanager
def clean_copy(cradle: CradleCsv) -> Iterator[str]:
    """Yield the path of a file with this CSV, for the body of the with statement.

    The handout's functions read this copy: a plain pd.read_csv takes a space for a part of a cell,
    and another program can write the file at any time.
    """
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        copy = Path(folder) / Path(cradle.filepath).name
        with naming(copy), open(copy, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(cradle.columns)
            for cells in cradle.pendula:
                writer.writerow(map(for_pandas, cradle.columns, cells))
        yield str(copy)


def for_pandas(column: str, text: str) -> str:
    """Return the text of a cell, a long number in short.

    pandas 2 reads 17 digits, and counts zeros before them.
    """
    is_number = column in CHECKED and isfinite(to_number(text))
    if is_number and len(text) > 15:
        return f"{Decimal(repr(to_number(text))):e}"
    return text
