"""The pendula as a table on the page: what you can change, what moves, and one tick in detail. table.js draws it."""

import csv
import io
import json
from html import escape

from vpython import button, winput, wtext

from support.files.cradle_csv import are_in_range, IN_RANGE, read_cells, RULES, Snapshot, to_number
from support.page.panel import add_hint, change, end_row

HINT = "Row 1 is pend_list[0]. A change of mass or e restarts the cradle. Your file stays as it is."


class Table:
    """Mass, e, angles (rad) and rates (rad/s) of each pendulum, as they are now; nothing is sent while it is folded."""

    def __init__(self, keys):
        """Begin folded away; keys are those of the numbers that move."""
        self.keys = keys
        self.is_open = False
        self.mistakes: dict[str, tuple[str, str]] = {}  # "row,column" -> (the text in the cell, what is allowed)

    def add(self, give) -> None:
        """Add the table to the panel; its widgets call give(command, value), in a thread of VPython."""
        self.rows, self.now = wtext(), wtext()  # table.js knows their order
        winput(bind=lambda box: give_command(give, box.text))  # table.js gives commands through it, and hides it
        end_row()
        self.tick = button(text="One tick", bind=lambda: give("tick"))
        end_row()
        add_hint(HINT)
        self.before_and_after = wtext()

    def open(self, is_open) -> None:
        """Open the table, or fold it away; a page that was loaded again has a folded, empty table."""
        self.is_open = is_open
        if not is_open:
            change(self.rows, text="")
            change(self.now, text="")

    def allows(self, row, column, text, masses) -> bool:
        """Return whether this text is allowed in a cell; if not, show what is, beside the cell.

        masses (kg) has those of all pendula. You may click faster than the page shows a new table: nothing is allowed
        in a row that is no longer there.
        """
        is_allowed, words = RULES[column]
        self.mistakes.pop(f"{row},{column}", None)
        fits = 0 <= row < len(masses) and is_allowed(text.strip())
        if fits and column == "mass" and "phi" in self.keys:
            fits, words = are_in_range([*masses[:row], float(text), *masses[row + 1 :]]), IN_RANGE
        if not fits and row < len(masses):
            self.mistakes[f"{row},{column}"] = text, f"{column}: allowed is {words}"
        return fits

    def show_rows(self, header, rows) -> None:
        """Show these rows of a CSV, with the columns in header."""
        pendula = [dict(zip(header, cells, strict=True)) for cells in rows]
        data = {"rows": pendula, "keys": self.keys, "mistakes": self.mistakes}
        change(self.rows, text=as_data(data))

    def show_now(self, coordinates) -> None:
        """Show the present coordinates of the pendula, by their names: theta_1, ..."""
        change(self.now, text=as_data({name: f"{number:.6f}" for name, number in coordinates.items()}))

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
            | ["edit", [int(), "mass" | "e", str()] as value]
            | ["answer", [str(), int() | None] as value]
            | ["vote", [str(), int()] as value]
            | ["again", bool() as value]
            | ["next", None as value]
        ):
            give(command[0], value)


# --- the CSV of changed pendula, in memory ----------------------------------------------------------------------------


def with_numbers(original, columns) -> Snapshot:
    """Return the Snapshot with other numbers in these columns, a list by its name; an equal number keeps its text.

    There can be fewer numbers or fewer rows: main may have made its pendula from something else.
    """
    header, rows = cells_of(original)
    for column, numbers in columns.items():
        place = header.index(column)
        for cells, number in zip(rows, numbers, strict=False):
            if to_number(cells[place]) != number:
                cells[place] = repr(float(number))
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([header, *rows])
    return Snapshot(original.filepath, text.getvalue().encode())


def cells_of(original) -> tuple[list[str], list[list[str]]]:
    """Return the names of a Snapshot's columns, and the cells of each row; a short row gets empty cells."""
    header, *rows = [cells for _, cells in read_cells(original)]
    return header, [cells + [""] * (len(header) - len(cells)) for cells in rows]
