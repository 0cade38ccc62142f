"""What main makes the cradle from: your CSV with your settings, or an experiment."""

import csv
import io
from typing import NamedTuple

from support.columns import CHECKED, to_number
from support.cradle.collision import AS_MADE
from support.cradle.player import Player
from support.cradle.settings import Settings
from support.files.cradle_csv import Snapshot
from support.files.experiments import (
    COLORS,
    Experiment,
    EXPERIMENTS,
    read_experiments,
    YOUR_CSV,
)
from support.files.valid_cradle import are_in_range, IN_RANGE, require_cradle
from support.page.gallery import at_rest, gallery_picture
from support.signs import odd_sign

Numbers = dict[str, list[float]]  # the numbers of all pendula, by their column


class Refusal(NamedTuple):
    """A number that you have typed into the table, but that is not allowed."""

    text: str
    message: str


class Chooser:
    """Changes the settings of a player, and keeps those of your CSV during an experiment.

    It writes no file.
    """

    def __init__(self, player: Player):
        """Begin with your CSV, in the settings of this player."""
        self.player = player
        self.saved = player.settings.csv  # your CSV, as it is in the file
        self.first = player.settings  # those of your CSV at the start
        self.yours = self.first  # of your CSV
        self.cords = player.cradle.cord_count
        folder = EXPERIMENTS / player.cradle.kind
        experiments, self.mistakes = read_experiments(folder, self.cords)
        self.experiments: dict[str, Experiment] = {}  # by their names
        self.experiment: Experiment | None = None  # None stands for your CSV
        self.is_changed = False  # whether the cradle is no longer that of the experiment
        # The angles of each pendulum at the release (rad), if an experiment sets them.
        self.poses: list[list[float]] | None = None
        self.pictures = {YOUR_CSV: at_rest(self.saved, self.cords)}
        for experiment in experiments:
            self.add(experiment)
        self.refused: dict[str, Refusal] = {}  # by "row,column" of the table

    def add(self, experiment: Experiment) -> None:
        """Let the menu have this experiment, maybe in place of one with its name."""
        self.experiments[experiment.name] = experiment
        self.pictures[experiment.name] = gallery_picture(experiment.csv, experiment.poses)

    def names(self) -> list[str]:
        """Return the names that you can choose."""
        return [YOUR_CSV, *self.experiments]

    def name(self) -> str:
        """Return the name of what is chosen."""
        return self.experiment.name if self.experiment else YOUR_CSV

    def whole_experiment(self) -> Experiment | None:
        """Return the experiment that is chosen; None once it was changed, and for your CSV."""
        return None if self.is_changed else self.experiment

    def next_name(self) -> str:
        """Return the name of the next experiment, after the last one the first."""
        names = [*self.experiments] or [YOUR_CSV]
        if not self.experiment:
            return names[0]
        return names[(names.index(self.experiment.name) + 1) % len(names)]

    def choose(self, name: str) -> None:
        """Choose what has this name in the menu."""
        if not self.experiment:
            self.yours = self.player.settings
            if name == YOUR_CSV:  # again: without what you have changed on the page
                self.yours = self.yours._replace(csv=self.saved)
        self.experiment = self.experiments.get(name)
        self.is_changed = False
        self.refused.clear()
        if self.experiment:
            angles: list[float | None] = [None] * self.cords
            self.player.settings = Settings(self.experiment.csv, angles, None, AS_MADE, None)
            self.poses = self.experiment.poses
        else:
            self.player.settings = self.yours
            self.poses = None

    def choose_first(self) -> None:
        """Choose your CSV, with its settings at the start."""
        self.experiment = None
        self.player.settings = self.first
        self.choose(YOUR_CSV)

    def choose_saved(self, snapshot: Snapshot) -> None:
        """Choose your CSV as you have saved it.

        Raises a ValueError with a one-line message if it has a mistake.
        """
        require_cradle(snapshot, self.cords)
        self.choose(YOUR_CSV)
        self.saved = snapshot
        self.pictures[YOUR_CSV] = at_rest(snapshot, self.cords)
        self.player.change(csv=snapshot)

    def original(self) -> Snapshot:
        """Return the CSV of what is chosen, without changes on the page."""
        return self.experiment.csv if self.experiment else self.saved

    def count(self) -> int:
        """Return the larger number of pendula: of the present CSV, or without changes."""
        return max(len(csv.rows) - 1 for csv in (self.original(), self.player.settings.csv))

    def is_edited(self) -> bool:
        """Return whether you have changed numbers, or the number, of the pendula on the page."""
        return self.player.settings.csv != self.original()

    def has_changes(self) -> bool:
        """Return whether the cradle is no longer as it was when it was chosen."""
        if self.experiment:
            return self.is_changed or self.is_edited()
        return self.player.settings != self.first._replace(csv=self.saved)

    def set_count(self, count: int) -> None:
        """Let the cradle have this number of pendula; they come and go at the right end.

        Those of the CSV come first. Each later one is like the one before it, with the next color
        of the experiments.
        """
        present = self.player.settings.csv
        header, *rows = [row.cells for row in present.rows]
        rows += [row.cells for row in self.original().rows[1 + len(rows) :]]
        place = header.index("color")
        while len(rows) < count:
            added = [*rows[-1]]
            added[place] = COLORS[len(rows) % len(COLORS)]
            rows.append(added)
        self.refused.clear()
        self.player.change(csv=with_rows(present, [header, *rows[:count]]))

    def edit(self, row: int, column: str, text: str, numbers: Numbers) -> bool:
        """Take this number (a text) for a row of the table; return False if it is refused.

        numbers are the masses (kg) and e that the pendula have now: the others of them stay.
        """
        place = f"{row},{column}"
        self.refused.pop(place, None)
        if row >= len(numbers[column]):  # you may type faster than the page shows a new table
            return False
        allowed = CHECKED[column].allowed()
        fits = CHECKED[column].allows(text.strip())
        if fits:
            numbers[column][row] = float(text)
            if column == "mass" and self.cords == 2:
                allowed = IN_RANGE
                fits = are_in_range(numbers[column])
        if not fits:
            self.refused[place] = Refusal(text, f"{column}: allowed is {allowed}{odd_sign(text)}")
            return False
        edited = with_numbers(self.player.settings.csv, numbers)
        self.player.change(csv=edited, mass=None, collision=AS_MADE)
        return True


def with_numbers(original: Snapshot, numbers: Numbers) -> Snapshot:
    """Return the Snapshot with these numbers in its columns; an equal number keeps its text."""
    header, *rows = [[*row.cells] for row in original.rows]  # the Snapshot keeps its own
    for column, values in numbers.items():
        place = header.index(column)
        # main may have made its pendula from something else.
        for cells, value in zip(rows, values, strict=False):
            if to_number(cells[place]) != value:
                cells[place] = repr(float(value))
    return with_rows(original, [header, *rows])


def with_rows(original: Snapshot, rows: list[list[str]]) -> Snapshot:
    """Return a Snapshot of the same path with these rows, the header first."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return Snapshot(original.filepath, text.getvalue().encode())
