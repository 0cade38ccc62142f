"""The cradle's own settings: its release, its number of bobs, their masses, and their e.

The sliders and the table of the page change them. Each change lets the program make a new cradle.
"""

from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

from support.columns import CHECKED, SETTABLE
from support.cradle.cradle import Cradle
from support.files.experiments import COLORS
from support.files.valid_cradle import numbers_in, with_numbers
from support.page.chooser import Chooser
from support.page.names import State
from support.pendulum import angle_to_outwards, outwards_to_angle
from support.start.mistake import report_mistake


class CradleEditor:
    """Changes the settings of the next cradle, and asks for it."""

    def __init__(self, cradle: Cradle, chooser: Chooser):
        """Change what this chooser has chosen; cradle is the one on the page."""
        self.cradle = cradle
        self.next_cradle = chooser.next_cradle
        self.chooser = chooser
        self.motion_keys = [*cradle.angle_keys, *cradle.rate_keys]
        self.saved: dict[str, float | str] = {}  # the answer to the last save_csv

    def change(self, **changed: object) -> None:
        """Let the program make a cradle with these settings, no longer that of an experiment."""
        self.chooser.leave_experiment()
        self.next_cradle.want(**changed)

    # --- the release ---------------------------------------------------------------------------

    def release_angle(self, cord: int) -> float:
        """Return the release angle of this cord (0 upper, 1 lower), in degrees outwards."""
        angles = self.cradle.release_angles(self.next_cradle.settings.angles)
        return angle_to_outwards(angles[cord])

    def set_release_angle(self, cord: int, degrees: float) -> None:
        """Release the bobs with this angle of this cord, in degrees outwards."""
        angles = self.cradle.release_angles(self.next_cradle.settings.angles)
        angles[cord] = outwards_to_angle(degrees)
        self.release(angles=angles)

    def release(self, **changed: object) -> None:
        """Change these settings, and lift the bobs as the sliders say, not as an experiment."""
        cradle = self.cradle
        if self.next_cradle.settings.poses:
            lifted = {"poses": None, "angles": cradle.made_angles, "lifted": cradle.lifted}
            changed = lifted | changed
        self.change(**changed)

    # --- the pendula ---------------------------------------------------------------------------

    def set_count(self, count: int) -> None:
        """Let the cradle have this number of pendula; they come and go at the right end.

        Those of the CSV come first. Each later one is like the one before it, with the next color
        of the experiments.
        """
        csv = self.next_cradle.settings.csv
        pendula = csv.pendula + self.chooser.unchanged().csv.pendula[len(csv.pendula) :]
        color = csv.columns.index("color")
        while len(pendula) < count:
            added = [*pendula[-1]]
            added[color] = COLORS[len(pendula) % len(COLORS)]
            pendula.append(added)
        self.release(csv=csv._replace(pendula=pendula[:count]))

    def can_change(self, name: str) -> bool:
        """Return whether you can change this: COUNT, or a column of the CSV.

        You cannot while a value is hidden, or if the program sets it itself.
        """
        return not self.cradle.hidden and name not in self.cradle.set_by_program

    def edit(self, row: int, column: str, number: float) -> None:
        """Let the program make the cradle with this number in its table, if that is allowed."""
        csv = self.next_cradle.settings.csv
        numbers = numbers_in(csv, column)
        is_there = row < len(numbers)  # you may type faster than the page shows a new table
        if is_there and CHECKED[column].allows(f"{number}") and self.can_change(column):
            numbers[row] = number
            self.change(csv=with_numbers(csv, {column: numbers}))

    def set_e(self, e: float) -> None:
        """Let the bobs collide with this e of all."""
        csv = self.next_cradle.settings.csv
        self.change(csv=with_numbers(csv, {"e": [e] * len(csv.pendula)}))

    def save_csv(self, ticket: float) -> None:
        """Let the program's own write_to_csv write the pendula without their motion.

        The tab that has asked knows the answer by its ticket.
        """
        pendula = [dict(pend) for pend in self.cradle.pend_list]
        for pend in pendula:
            for key in self.motion_keys:
                del pend[key]
        text = mistake = ""
        try:
            write = import_module("src.pds_helper").write_to_csv
            with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
                file = Path(folder, "cradle.csv")
                write(pendula, str(file))
                text = file.read_text(encoding="utf-8")
        except Exception as error:
            mistake = report_mistake(error)
        self.saved = {"ticket": ticket, "text": text, "mistake": mistake}

    def state(self) -> State:
        """Return the table of the pendula, and the answer to the last save_csv."""
        columns = []
        cells = []
        for key in (*SETTABLE, *self.motion_keys):
            can_change = key in SETTABLE and self.can_change(key)
            limits = CHECKED[key].limits if can_change else None
            numbers = self.cradle.shown(key)
            places = "" if key in SETTABLE else ".6f"
            columns.append((key, limits, len(numbers)))
            cells.append(["?" if number is None else f"{number:{places}}" for number in numbers])
        return {"columns": columns, "cells": cells, "saved_csv": self.saved}
