"""The pendula as a table on the page: what you can edit, what moves, and one tick in detail. table.js draws it."""

import json
from html import escape
from pathlib import Path

from vpython import button, winput, wtext

from support.constants import COLOR_MAP
from support.files.cradle_csv import are_in_range, IN_RANGE, RULES
from support.files.edited_csv import values_of, with_cell
from support.page.commands import Command
from support.page.events import read_json
from support.page.widgets import add_hint, end_row, set_text

HINT = "Row 1 is pend_list[0]. A change restarts the cradle. Your file stays as it is until you write it."


class Table:
    """A row for each pendulum: mass, e and color to edit; the angles (rad) and their rates (rad/s) as they are now.

    While the table is folded away, nothing of it is sent.
    """

    def __init__(self, keys, csv):
        """Begin folded away; keys are those of the numbers that move, csv is the path of your CSV."""
        self.keys, self.csv = keys, csv
        self.is_open = False
        self.mistakes: dict[str, tuple[str, str]] = {}  # "row,column" -> (the text in the cell, what is allowed)

    def add(self, give) -> None:
        """Add the table to the panel; its widgets call give(command, value), in a thread of VPython."""
        self.rows, self.now = wtext(), wtext()
        winput(bind=lambda box: give_command(give, box.text))  # table.js gives commands through it, and hides it
        end_row()
        self.tick = button(text="One tick", bind=lambda: give(Command.TICK))
        self.write = button(text="Write to my CSV", bind=lambda: give(Command.WRITE))
        self.written = wtext()
        end_row()
        add_hint(HINT)
        self.before_and_after = wtext()
        self.refresh()

    def open(self, is_open) -> None:
        """Open the table, or fold it away; a page that was loaded again has a folded, empty table."""
        self.is_open = is_open
        if not is_open:
            set_text(self.rows, "")
            set_text(self.now, "")

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
        set_text(self.rows, as_data("rows", data))

    def show_now(self, coordinates) -> None:
        """Show the present coordinates of the pendula, by their names: theta_1, ..."""
        set_text(self.now, as_data("now", {name: f"{number:.6f}" for name, number in coordinates.items()}))

    def show_written(self, message, failed=False) -> None:
        """Show a message about your CSV: what happened, or, if failed, the reason."""
        set_text(self.written, f'<span class="{"failed" if failed else "hint"}">{escape(message)}</span>')

    def show_tick(self, dt, before, after, calls) -> None:
        """Show what one tick of dt (s) did: the coordinates before and after it, and the calls in it."""
        lines = [f"One tick, {dt:g} s: before -> after"]
        for i in range(len(before) // len(self.keys)):
            names = [(key, f"{key}_{i + 1}") for key in self.keys]
            changes = [f"{key} {before[name]:.6g} -> {after[name]:.6g}".ljust(29) for key, name in names]
            lines.append(f"[{i}] {' '.join(changes)}".rstrip())
        lines += calls
        set_text(self.before_and_after, f'<pre class="tick" tabindex="0">{escape(chr(10).join(lines))}</pre>')

    def refresh(self) -> None:
        """Remove what was said about an earlier cradle."""
        set_text(self.before_and_after, "")
        self.show_written(f"replaces {Path(self.csv).name}")


def as_data(name, data) -> str:
    """Return HTML that shows nothing, and carries data for the page's script."""
    return f'<i class="data" data-name="{name}" data-value="{escape(json.dumps(data))}"></i>'


def give_command(give, text) -> None:
    """Call give(command, value) for a text from the page's script; do nothing for a text that it does not send."""
    match read_json(text):
        case (
            ["TABLE", bool() as value]
            | ["ADD", None as value]
            | ["DELETE", int() as value]
            | ["EDIT", [int(), "mass" | "e" | "color", str()] as value]
            | ["ANSWER", [str(), int() | None] as value]
        ) as command:
            give(Command[command[0]], value)
