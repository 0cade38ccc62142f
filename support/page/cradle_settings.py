"""The cradle's own settings: its release, its number of bobs, their masses, and their e.

The sliders and the table of the page change them. Each change lets the program make a new cradle.
"""

from typing import NamedTuple

from support.columns import CHECKED, SETTABLE
from support.cradle.cradle import Cradle
from support.cradle.settings import NextCradle
from support.files.experiments import COLORS
from support.files.valid_cradle import are_in_range, CradleCsv, IN_RANGE, with_numbers
from support.page.chooser import Chooser
from support.page.names import State
from support.pendulum import angle_to_outwards, outwards_to_angle


class Refusal(NamedTuple):
    """A number that you have typed into the table, but that is not allowed."""

    text: str
    message: str


class CradleSettings:
    """Changes the settings of the next cradle, and wants it."""

    def __init__(self, cradle: Cradle, next_cradle: NextCradle, chooser: Chooser):
        """Change what this chooser has chosen; cradle is that of now."""
        self.cradle = cradle
        self.next_cradle = next_cradle
        self.chooser = chooser
        self.refused: dict[str, Refusal] = {}  # by "row,column" of the table
        self.refused_in: CradleCsv | None = None  # the table

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
        """Release the bobs with this angle of this cord, outwards."""
        self.leave_poses()
        angles = list(self.next_cradle.settings.angles)
        angles[cord] = outwards_to_angle(degrees)
        self.change(angles=angles)

    def lifted(self) -> int:
        """Return the number of lifted bobs."""
        settings = self.next_cradle.settings
        return self.cradle.lifted_count(settings.angles, settings.lifted)

    def set_lifted(self, lifted: int) -> None:
        """Lift this number of bobs."""
        self.leave_poses()
        self.change(lifted=lifted)

    def leave_poses(self) -> None:
        """Lift the bobs as the sliders say, no more as an experiment says."""
        if self.next_cradle.settings.poses:
            angles = list(self.cradle.made_angles)
            self.change(poses=None, angles=angles, lifted=self.cradle.made_lifted)

    # --- the pendula ---------------------------------------------------------------------------

    def most_bobs(self) -> int:
        """Return the larger number of pendula: of the present CSV, or without changes."""
        return max(
            len(csv.pendula) for csv in (self.chooser.original(), self.next_cradle.settings.csv)
        )

    def set_count(self, count: int) -> None:
        """Let the cradle have this number of pendula; they come and go at the right end.

        Those of the CSV come first. Each later one is like the one before it, with the next color
        of the experiments.
        """
        self.leave_poses()
        csv = self.next_cradle.settings.csv
        pendula = csv.pendula + self.chooser.original().pendula[len(csv.pendula) :]
        color = csv.columns.index("color")
        while len(pendula) < count:
            added = [*pendula[-1]]
            added[color] = COLORS[len(pendula) % len(COLORS)]
            pendula.append(added)
        self.change(csv=csv._replace(pendula=pendula[:count]))

    def edit(self, row: int, column: str, text: str) -> None:
        """Let the program make the cradle with this number in the table, or show why it is refused.

        The other numbers of the table stay as the pendula have them now.
        """
        self.refused = self.refusals()
        place = f"{row},{column}"
        self.refused.pop(place, None)
        numbers = {name: self.cradle.values(name) for name in SETTABLE}
        is_there = row < len(numbers[column])  # you may type faster than the page shows a new table
        if not is_there or self.cradle.hidden:
            return
        allowed = CHECKED[column].allowed()
        fits = CHECKED[column].allows(text.strip())
        if fits:
            numbers[column][row] = float(text)
            if column == "mass" and self.cradle.cord_count == 2:
                allowed = IN_RANGE
                fits = are_in_range(numbers[column])
        if fits:
            edited = with_numbers(self.next_cradle.settings.csv, numbers)
            self.change(csv=edited)
        else:
            self.refused[place] = Refusal(text, f"{column}: allowed is {allowed}")
        self.refused_in = self.next_cradle.settings.csv

    def refusals(self) -> dict[str, Refusal]:
        """Return the numbers that were refused in the present table, by "row,column"."""
        return self.refused if self.refused_in is self.next_cradle.settings.csv else {}

    # --- hits ----------------------------------------------------------------------------------

    def set_e(self, e: float) -> None:
        """Let the bobs collide with this e of all."""
        csv = self.next_cradle.settings.csv
        self.change(csv=with_numbers(csv, {"e": [e] * len(csv.pendula)}))

    def set_separating(self, separating: bool) -> None:
        """Let separating bobs collide, too, or not."""
        self.next_cradle.separating = separating
        self.change()

    def state(self) -> State:
        """Return what the page must know of the pendula, and their table."""
        cradle = self.cradle
        return {
            "columns": SETTABLE,
            "keys": [*cradle.angle_keys, *cradle.rate_keys],
            "table": {column: cradle.shown(column) for column in SETTABLE},
            "refused": {place: refusal._asdict() for place, refusal in self.refusals().items()},
            "now": {name: f"{number:.6f}" for name, number in cradle.coordinates().items()},
        }
