"""What the CSV of a cradle must have; the checked CSV, and the file with it for pandas."""

import csv
from argparse import Namespace
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from support.columns import CHECKED, SETTABLE, to_number
from support.files.cradle_csv import Snapshot
from support.found import found, in_short

MOST_PENDULA = 1000  # of a cradle
Numbers = dict[str, list[float]]  # the numbers of all pendula, by their column


class CradleCsv(NamedTuple):
    """The CSV of a cradle, parsed and checked: all that comes later takes its cells from here."""

    filepath: str | Path
    columns: list[str]  # their names
    pendula: list[list[str]]  # the cells of each row, one for each column


def read_cradle(snapshot: Snapshot) -> CradleCsv:
    """Return the checked CSV of a cradle.

    Raises a ValueError for the first mistake. It names the file, the line, the column, the value
    found and the allowed values.
    """
    rows = snapshot.rows()  # one by one: those of 6 MB would take a gigabyte of memory
    header = next(rows)
    require_columns(f"{snapshot}, line {header.line}", header.cells)
    pendula: list[list[str]] = []
    for row in rows:
        if len(pendula) == MOST_PENDULA:
            raise ValueError(
                f"{snapshot}, line {row.line}: found pendulum {MOST_PENDULA + 1}, allowed are at "
                f"most {MOST_PENDULA}, which already move in slow motion on the page"
            )
        require_allowed_cells(f"{snapshot}, line {row.line}", header.cells, row.cells)
        pendula.append(row.cells)
    if not pendula:
        raise ValueError(
            f"{snapshot}: names columns but has no pendulum, "
            "a cradle needs at least one row below them"
        )
    return CradleCsv(snapshot.filepath, header.cells, pendula)


def is_cradle(filepath: str) -> bool:
    """Return whether a file is the CSV of a cradle."""
    try:
        read_cradle(Snapshot(filepath))
    except ValueError:
        return False
    return True


def require_columns(place: str, names: list[str]) -> None:
    """Raise a ValueError if the names at this place lack a column of a cradle, or repeat one."""
    for column in CHECKED:
        count = names.count(column)
        if count != 1:
            columns = f"{count} columns" if count else "no column"
            all_names = in_short(", ".join(map(repr, names)))
            raise ValueError(
                f"{place} must name the columns: found {columns} {column} in {all_names}; "
                f"a cradle needs one column of each of {', '.join(CHECKED)}"
            )


def require_allowed_cells(place: str, names: list[str], cells: list[str]) -> None:
    """Raise a ValueError if a cell of the row at this place is not allowed in its column."""
    for name, text in zip(names, cells, strict=True):
        column = CHECKED.get(name)
        if column and not column.allows(text):
            raise ValueError(f"{place}, column {name}: {found(text, column.allowed())}")


def numbers_in(csv: CradleCsv, column: str) -> list[float]:
    place = csv.columns.index(column)
    return [to_number(cells[place]) for cells in csv.pendula]


def with_numbers(csv: CradleCsv, numbers: Numbers) -> CradleCsv:
    """Return the CSV with these numbers in its columns."""
    pendula = [[*cells] for cells in csv.pendula]
    for column, values in numbers.items():
        place = csv.columns.index(column)
        # A program may have made its pendula from something else.
        for cells, value in zip(pendula, values, strict=False):
            cells[place] = repr(float(value))
    return csv._replace(pendula=pendula)


def with_options(csv: CradleCsv, options: Namespace) -> CradleCsv:
    """Return the CSV with the mass (kg) and the e that options give to all pendula."""
    given = {"mass": options.mass, "e": options.e}
    count = len(csv.pendula)
    return with_numbers(
        csv, {name: [value] * count for name, value in given.items() if value is not None}
    )


@contextmanager
def file_for_pandas(cradle: CradleCsv) -> Iterator[str]:
    """Yield the path of a file for the handout's functions, for the body of the with statement.

    It is the CSV itself if a plain pd.read_csv finds in it what was checked, else a copy. A CSV
    that is saved in the next milliseconds reaches the functions unchecked; LiveFile then notices
    it.
    """
    columns = zip(*cradle.pendula, strict=True)
    table = [*map(values_in, cradle.columns, columns)]
    if has_for_pandas(cradle, table):
        yield str(cradle.filepath)
        return
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        copy = Path(folder) / Path(cradle.filepath).name
        with open(copy, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(cradle.columns)
            writer.writerows(zip(*table, strict=True))
        yield str(copy)


def values_in(column: str, cells: Iterable[str]) -> list:
    """Return the numbers, or else the texts, in these cells of a column with this name."""
    return [*map(to_number, cells)] if column in SETTABLE else [*cells]


def has_for_pandas(cradle: CradleCsv, table: list[list]) -> bool:
    """Return whether pandas finds the columns of this table in the CSV itself, as it is now."""
    import pandas as pd  # late: the page opens before it is there

    try:
        frame = pd.read_csv(cradle.filepath)
    except (OSError, ValueError):  # an experiment has no CSV
        return False
    if [*frame.columns] != cradle.columns:
        return False
    return all(
        frame[name].tolist() == values
        for name, values in zip(cradle.columns, table, strict=True)
        if name in CHECKED
    )
