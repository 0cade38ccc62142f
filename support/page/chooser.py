"""What main makes the cradle from: your CSV with what you have set on the page, or an experiment."""

import csv
import io
from typing import NamedTuple

from support.columns import REQUIRED, to_number
from support.files.cradle_csv import Snapshot
from support.files.experiments import Experiment, EXPERIMENTS, read_experiments, YOUR_CSV
from support.files.valid_cradle import are_in_range, IN_RANGE, require_cradle


class Settings(NamedTuple):
    """The CSV of a cradle, and the settings that replace parts of it. None is as main makes it."""

    csv: Snapshot
    angles: list[float | None]  # rad
    lifted: int | None
    collision: str  # a key of the cradle's collisions
    mass: float | None  # kg


class Chooser:
    """Keeps the settings of the present cradle (now), and of your CSV during an experiment (own).

    It writes no file.
    """

    def __init__(self, settings, cradle):
        """Begin with your CSV, in these settings of the cradle."""
        self.now = self.own = settings
        self.plain = next(iter(cradle.collisions))  # as in the CSV
        self.cords = len(cradle.angle_keys)
        experiments, self.mistakes = read_experiments(EXPERIMENTS / cradle.kind, self.cords)
        self.experiments = {experiment.name: experiment for experiment in experiments}
        self.experiment: Experiment | None = None  # None stands for your CSV
        self.is_changed = False  # whether the cradle is no longer that of the experiment
        # The angles of each pendulum at the release, if an experiment sets them
        self.poses: list | None = None
        # "row,column" of the table -> (the text, what is allowed)
        self.refused: dict[str, tuple[str, str]] = {}

    def names(self) -> list[str]:
        """Return the names that you can choose."""
        return [YOUR_CSV, *self.experiments]

    def menu(self) -> list[str]:
        """Return the names in the menu: a changed experiment has one more, so that you can choose
        its own one again.
        """
        return [*self.names(), self.name()] if self.is_changed else self.names()

    def name(self) -> str:
        """Return the name of what is chosen."""
        chosen = self.experiment.name if self.experiment else YOUR_CSV
        return f"{chosen}, changed" if self.is_changed else chosen

    def next_name(self) -> str:
        """Return the name of the next experiment, after the last one the first."""
        names = [*self.experiments] or [YOUR_CSV]
        return names[(names.index(self.experiment.name) + 1) % len(names) if self.experiment else 0]

    def set(self, **values) -> None:
        """Change some of the settings."""
        self.now = self.now._replace(**values)

    def choose(self, name) -> None:
        """Take what has this name in the menu."""
        if not self.experiment:
            self.own = self.now
        self.experiment = self.experiments.get(name)
        self.now, self.poses, self.is_changed = self.own, None, False
        if self.experiment:
            self.now = Settings(self.experiment.csv, [None] * self.cords, None, self.plain, None)
            self.poses = self.experiment.angles
        self.refused.clear()

    def take(self, snapshot) -> None:
        """Take your saved CSV; raises a ValueError with a one-line message if it has a mistake."""
        require_cradle(snapshot, self.cords)
        self.choose(YOUR_CSV)
        self.set(csv=snapshot)

    def edit(self, row, column, text, numbers) -> bool:
        """Take this number (a text) for a row of the table, or refuse it; return whether it is
        taken.

        numbers are the masses (kg) and e that the pendula have now, by column: they stay.
        """
        words = REQUIRED[column].allowed()
        self.refused.pop(f"{row},{column}", None)
        # No longer there: you may type faster than the page shows a new table
        if row >= len(numbers[column]):
            return False
        fits = REQUIRED[column].allows(text.strip())
        if fits:
            numbers[column][row] = float(text)
            if column == "mass" and self.cords == 2:
                fits, words = are_in_range(numbers["mass"]), IN_RANGE
        if fits:
            self.set(csv=with_numbers(self.now.csv, numbers), mass=None, collision=self.plain)
        else:
            self.refused[f"{row},{column}"] = text, f"{column}: allowed is {words}"
        return fits


def with_numbers(original, columns) -> Snapshot:
    """Return the Snapshot with other numbers in these columns, a list by its name; an equal number
    keeps its text.
    """
    header, *rows = [[*cells] for _, cells in original.rows]  # the Snapshot keeps its own
    for column, numbers in columns.items():
        place = header.index(column)
        # Main may have made its pendula from something else
        for cells, number in zip(rows, numbers, strict=False):
            if to_number(cells[place]) != number:
                cells[place] = repr(float(number))
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([header, *rows])
    return Snapshot(original.filepath, text.getvalue().encode())
