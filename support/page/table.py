"""The pendula as a table on the page: what you can edit, what moves, and one tick in detail. table.js draws it."""

import csv
import io
import json
from html import escape
from pathlib import Path

from vpython import button, winput, wtext

from support.constants import COLOR_MAP
from support.files.cradle_csv import are_in_range, check_cradle, IN_RANGE, read_cells, RULES, Snapshot, to_number
from support.page.panel import add_hint, change, end_row

HINT = "Row 1 is pend_list[0]. A change restarts the cradle. Your file stays as it is until you write it."


class Table:
    """A row for each pendulum: mass, e and color to edit; the angles (rad) and their rates (rad/s) as they are now.

    While the table is folded away, nothing of it is sent.
    """

    def __init__(self, keys, csv):
        """Begin folded away; keys are those of the numbers that move, csv is the path of your CSV."""
        self.keys, self.csv = keys, csv
        self.is_open = False
        self.news = ""  # about your CSV, for the next cradle
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
        self.refresh()

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
            fits, words = are_in_range(values_of(with_cell(csv, row, column, text.strip()), column)), IN_RANGE
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

    def show_written(self, message, failed=False) -> None:
        """Show a message about your CSV: what happened, or, if failed, the reason."""
        change(self.written, text=f'<span class="{"failed" if failed else "hint"}">{escape(message)}</span>')

    def show_tick(self, dt, before, after, calls) -> None:
        """Show what one tick of dt (s) did: the coordinates before and after it, and the calls in it."""
        lines = [f"One tick, {dt:g} s: before -> after"]
        for i in range(len(before) // len(self.keys)):
            names = [(key, f"{key}_{i + 1}") for key in self.keys]
            changes = [f"{key} {before[name]:.6g} -> {after[name]:.6g}".ljust(29) for key, name in names]
            lines.append(f"[{i}] {' '.join(changes)}".rstrip())
        lines += calls
        change(self.before_and_after, text=f'<pre class="tick" tabindex="0">{escape(chr(10).join(lines))}</pre>')

    def refresh(self) -> None:
        """Remove the texts about an earlier cradle, and show the news, if there are some."""
        change(self.before_and_after, text="")
        self.show_written(self.news or f"replaces {Path(self.csv).name}")
        self.news = ""


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
            | ["add", None as value]
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
    try:
        for each in (csv, other):
            check_cradle(each)
    except ValueError:
        return False
    return all(values_of(csv, column) == values_of(other, column) for column in RULES)


def values_of(csv, column) -> list:
    """Return the values in a column: numbers for mass and e, texts for the others."""
    header, rows = cells_of(csv)
    texts = [cells[header.index(column)] for cells in rows]
    return [to_number(text) for text in texts] if column in ("mass", "e") else texts


def cells_of(original) -> tuple[list[str], list[list[str]]]:
    """Return the names of a Snapshot's columns, and the cells of each row; a short row gets empty cells."""
    header, *rows = [cells for _, cells in read_cells(original)]
    return header, [cells + [""] * (len(header) - len(cells)) for cells in rows]


def with_rows(original, rows) -> Snapshot:
    """Return the Snapshot with these cells of each row in place of all its rows."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([cells_of(original)[0], *rows])
    return Snapshot(original.filepath, text.getvalue().encode())
