"""The pendula as a table on the page: what you can edit, what moves, and one tick in detail. table.js draws it."""

import csv
import io
import json
from html import escape
from itertools import zip_longest
from math import isnan
from pathlib import Path
from textwrap import shorten

from vpython import button, winput, wtext

from support.constants import COLOR_MAP
from support.files.cradle_csv import are_in_range, check_cradle, IN_RANGE, read_cells, RULES, Snapshot, to_number
from support.page.panel import add_hint, change, end_row

HINT = "Row 1 is pend_list[0]. A change restarts the cradle. Your file stays as it is until you write it."
UNDO = " <button onclick=\"tell('undo', null)\">Undo</button>"
MOST_TOLD, LONGEST_TOLD = 3, 300  # changes of your CSV, and their letters


class Table:
    """A row for each pendulum: mass, e and color to edit; the angles (rad) and their rates (rad/s) as they are now.

    While the table is folded away, nothing of it is sent.
    """

    def __init__(self, keys):
        """Begin folded away; keys are those of the numbers that move."""
        self.keys = keys
        self.is_open = False
        self.news = ""  # about your CSV, to be shown once
        self.mistakes: dict[str, tuple[str, str]] = {}  # "row,column" -> (the text in the cell, what is allowed)

    def add(self, give) -> None:
        """Add the table to the panel; its widgets call give(command, value), in a thread of VPython."""
        self.rows, self.now = wtext(), wtext()  # table.js knows their order
        winput(bind=lambda box: give_command(give, box.text))  # table.js gives commands through it, and hides it
        end_row()
        self.tick = button(text="One tick", bind=lambda: give("tick"))
        self.write = button(text="Write to my CSV", bind=lambda: give("write"))
        self.written = wtext()
        end_row()
        add_hint(HINT)
        self.before_and_after = wtext()

    def open(self, is_open) -> None:
        """Open the table, or fold it away; a page that was loaded again has a folded, empty table."""
        self.is_open = is_open
        if not is_open:
            change(self.rows, text="")
            change(self.now, text="")

    def allows(self, csv, row, column, text) -> bool:
        """Return whether this text is allowed in a cell of csv (a Snapshot); if not, show what is, beside the cell."""
        is_allowed, words = RULES[column]
        self.mistakes.pop(f"{row},{column}", None)
        fits = is_allowed(text.strip())
        if fits and column == "mass" and "phi" in self.keys:
            fits, words = are_in_range(columns_of(with_cell(csv, row, column, text.strip()))[column]), IN_RANGE
        if not fits:
            self.mistakes[f"{row},{column}"] = text, f"{column}: allowed is {words}"
        return fits

    def show_rows(self, header, rows) -> None:
        """Show these rows of a CSV, with the columns in header."""
        pendula = [dict(zip(header, cells, strict=True)) for cells in rows]
        data = {"rows": pendula, "keys": self.keys, "colors": list(COLOR_MAP), "mistakes": self.mistakes}
        change(self.rows, text=as_data(data))

    def show_now(self, coordinates) -> None:
        """Show the present coordinates of the pendula, by their names: theta_1, ..."""
        change(self.now, text=as_data({name: f"{number:.6f}" for name, number in coordinates.items()}))

    def show_written(self, message, failed=False, can_undo=False) -> None:
        """Show a message about your CSV: what a click changes, what happened, or, if failed, the reason; and Undo."""
        kind, undo = "failed" if failed else "hint", UNDO * can_undo
        change(self.written, text=f'<span class="{kind}">{escape(message)}</span>{undo}')

    def show_tick(self, dt, before, after, calls) -> None:
        """Show what one tick of dt (s) did: the coordinates before and after it, and the calls in it."""
        lines = [f"One tick, {dt:g} s: before -> after"]
        for i in range(len(before) // len(self.keys)):
            names = [(key, f"{key}_{i + 1}") for key in self.keys]
            changes = [f"{key} {before[name]:.6g} -> {after[name]:.6g}".ljust(29) for key, name in names]
            lines.append(f"[{i}] {' '.join(changes)}".rstrip())
        lines += calls
        change(self.before_and_after, text=f'<pre class="tick" tabindex="0">{escape(chr(10).join(lines))}</pre>')


def as_data(data) -> str:
    """Return HTML that shows nothing, and carries data for the page's script."""
    return f'<i class="data" data-value="{escape(json.dumps(data))}"></i>'


def give_command(give, text) -> None:
    """Call give(command, value) for a text from the page's script; do nothing for a text that it does not send."""
    try:
        command = json.loads(text)
    except (ValueError, RecursionError):
        return
    match command:
        case (
            ["table", bool() as value]
            | ["add" | "undo", None as value]
            | ["delete", int() as value]
            | ["edit", [int(), "mass" | "e" | "color", str()] as value]
            | ["answer", [str(), int() | None] as value]
            | ["vote", [str(), int()] as value]
            | ["again", bool() as value]
            | ["next", None as value]
        ):
            give(command[0], value)


# --- edits of a CSV in memory; the rows of pendula count from 0 -------------------------------------------------------


def with_cell(original, row, column, text) -> Snapshot:
    """Return the Snapshot with this text in a cell."""
    header, rows = cells_of(original)
    rows[row][header.index(column)] = text
    return with_rows(original, rows)


def with_numbers(original, column, numbers) -> Snapshot:
    """Return the Snapshot with these numbers in a column; a cell with the same number keeps its text.

    There can be fewer numbers or fewer rows: main may have made its pendula from something else.
    """
    header, rows = cells_of(original)
    place = header.index(column)
    for cells, number in zip(rows, numbers, strict=False):
        if to_number(cells[place]) != number:
            cells[place] = repr(float(number))
    return with_rows(original, rows)


def have_same_pendula(csv, other) -> bool:
    """Return whether two Snapshots describe the same cradle: the same masses, e, colors and textures, row by row."""
    one, two = columns_of(csv), columns_of(other)
    return bool(one and two) and all(one[column] == two[column] for column in RULES)


def what_changes(file, csv) -> str:
    """Return in a line what Write to my CSV changes in the file if it writes csv, a cradle; both are Snapshots."""
    name, old, new = Path(str(file)).name, columns_of(file), columns_of(csv)
    if not old:
        return (
            f"replaces all of {name}, which {'cannot be read, so without Undo' if file.error else 'has a mistake now'}"
        )
    told = [f"{'adds' if column in new else 'removes'} column {column}" for column in sorted(old.keys() ^ new.keys())]
    both = [column for column in old if column in new]
    before, after = (zip(*map(columns.get, both), strict=True) for columns in (old, new))
    for row, (a, b) in enumerate(zip_longest(before, after), start=1):
        if not (a and b):
            told.append(f"removes row {row}" if a else f"adds row {row}")
        elif a != b:
            cells = [f"{column} {x} to {y}" for column, x, y in zip(both, a, b, strict=True) if x != y]
            told.append(f"row {row}: {', '.join(cells)}")
    told[MOST_TOLD:] = [f"and {len(told) - MOST_TOLD} more"] * (len(told) > MOST_TOLD)
    return f"changes {name}: {shorten('; '.join(told), LONGEST_TOLD)}" if told else f"{name} has these pendula."


def columns_of(csv) -> dict[str, tuple]:
    """Return the values in each column of a Snapshot: numbers, or else texts; no columns if it is no cradle."""
    try:
        check_cradle(csv)
    except ValueError:
        return {}
    header, rows = cells_of(csv)
    values = [[text if isnan(to_number(text)) else to_number(text) for text in cells] for cells in rows]
    return dict(zip(header, zip(*values, strict=True), strict=True))


def cells_of(original) -> tuple[list[str], list[list[str]]]:
    """Return the names of a Snapshot's columns, and the cells of each row; a short row gets empty cells."""
    header, *rows = [cells for _, cells in read_cells(original)]
    return header, [cells + [""] * (len(header) - len(cells)) for cells in rows]


def with_rows(original, rows) -> Snapshot:
    """Return the Snapshot with these cells of each row in place of all its rows."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([cells_of(original)[0], *rows])
    return Snapshot(original.filepath, text.getvalue().encode())
