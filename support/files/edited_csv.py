"""Edit the CSV of a cradle in memory: each function returns a new Snapshot. The rows of pendula count from 0."""

import csv
import io

from support.files.cradle_csv import check_cradle, read_cells, RULES, Snapshot, to_number


def with_cell(original, row, column, text) -> Snapshot:
    """Return the Snapshot with this text in a cell."""
    header, rows = cells_of(original)
    rows[row][header.index(column)] = text
    return written(original, header, rows)


def with_numbers(original, column, numbers) -> Snapshot:
    """Return the Snapshot with these numbers in a column; a cell with the same number keeps its text.

    There can be fewer numbers or fewer rows: main may have made its pendula from something else.
    """
    header, rows = cells_of(original)
    place = header.index(column)
    for cells, number in zip(rows, numbers, strict=False):
        if to_number(cells[place]) != number:
            cells[place] = repr(float(number))
    return written(original, header, rows)


def with_row(original) -> Snapshot:
    """Return the Snapshot with one more row: a copy of the last one."""
    header, rows = cells_of(original)
    return written(original, header, [*rows, rows[-1]])


def without_row(original, row) -> Snapshot:
    """Return the Snapshot without a row."""
    header, rows = cells_of(original)
    return written(original, header, rows[:row] + rows[row + 1 :])


def have_same_pendula(csv, other) -> bool:
    """Return whether two Snapshots describe the same cradle: the same masses, e, colors and textures, row by row."""
    try:
        for each in (csv, other):
            check_cradle(each)
    except ValueError:
        return False
    columns = [[values_of(each, column) for column in RULES] for each in (csv, other)]
    return columns[0] == columns[1]


def values_of(csv, column) -> list:
    """Return the values in a column: numbers for mass and e, texts for the others."""
    header, rows = cells_of(csv)
    texts = [cells[header.index(column)] for cells in rows]
    return [to_number(text) for text in texts] if column in ("mass", "e") else texts


def cells_of(original) -> tuple[list[str], list[list[str]]]:
    """Return the names of a Snapshot's columns, and the cells of each row; a short row gets empty cells."""
    header, *rows = [cells for _, cells in read_cells(original)]
    return header, [cells + [""] * (len(header) - len(cells)) for cells in rows]


def written(original, header, rows) -> Snapshot:
    """Return a Snapshot with these cells; its path is that of the original."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([header, *rows])
    return Snapshot(original.filepath, text.getvalue().encode())
