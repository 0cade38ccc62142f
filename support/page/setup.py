"""How to make the cradle of now again: with a command, or from the file of an experiment."""

from math import degrees, pi, remainder

from support.columns import SETTABLE
from support.constants import NC_FP
from support.cradle.held_bob import HeldBob
from support.cradle.motion import Motion
from support.cradle.settings import NextCradle
from support.files.experiments import experiment_text
from support.page.chooser import Chooser
from support.page.names import State
from support.pendulum import angle_to_outwards
from support.root import ROOT
from support.start.commands import python_command

NAME = "My setup"  # of the experiment in the file
FILE = "my_cradle.txt"  # keep.js has this name, too
USE_IT = "This command starts the page with this cradle:"
SAVE_FIRST = (
    f"No options make this cradle. First save the text below as {FILE}, in the folder where you "
    "type this command (the bobs then have the colors of experiments):"
)
HIDDEN = "While a value is hidden, the command and the file are hidden, too."
NO_RULE = "Separating bobs do not collide in it until you tick the box again."


class Setup:
    """The command, and the text of the file."""

    def __init__(
        self, chooser: Chooser, next_cradle: NextCradle, motion: Motion, held_bob: HeldBob, csv: str
    ):
        """csv is the path of your CSV."""
        self.chooser = chooser
        self.next_cradle = next_cradle
        self.motion = motion
        self.held_bob = held_bob
        self.csv = csv
        self.cradle = motion.cradle

    def state(self) -> State:
        """Return a command, what to do with it, and the text of a file.

        All are empty if they would show what is hidden.
        """
        options = self.options()
        if self.cradle.hidden:
            return {"same_cradle": "", "advice": HIDDEN, "setup": ""}
        advice = USE_IT
        if options is None:
            options = [f"--experiment={FILE}"]
            advice = SAVE_FIRST
        if self.next_cradle.separating and self.cradle.takes_rule:
            advice = f"{NO_RULE} {advice}"
        if self.csv != NC_FP:
            options = [self.csv, *options]
        command = python_command(ROOT / self.cradle.page_program, *options)
        return {"same_cradle": command, "advice": advice, "setup": self.file_text()}

    def options(self) -> list[str] | None:
        """Return the options that make the cradle of now, or None if there are none."""
        chooser = self.chooser
        experiment = chooser.whole_experiment()
        if experiment:
            return [f"--experiment={experiment.file}"]
        has_moved = self.held_bob.has_moved
        if chooser.experiment or chooser.is_edited() or has_moved or chooser.error:
            return None
        settings = self.next_cradle.settings
        options = []
        for name, angle in zip(("angle", "phi"), settings.angles, strict=False):
            if angle is not None:
                options.append(f"--{name}={angle_to_outwards(angle):.12g}")
        if settings.lifted is not None:
            lifted = self.cradle.lifted_count(settings.angles, settings.lifted)
            options.append(f"--lift={lifted}")
        if settings.mass is not None:
            options.append(f"--mass={settings.mass:.12g}")
        if settings.e_source:
            options.append(f"--e={self.cradle.values('e')[0]:.12g}")
        return options

    def file_text(self) -> str:
        """Return the text of an experiment with the angles of the last release."""
        lines = {}
        for key, angles in self.motion.start_angles.items():
            lines[key] = [whole_turns_off(angle) for angle in angles]
        lines |= {name: self.cradle.values(name) for name in SETTABLE}
        return experiment_text(NAME, lines)


def whole_turns_off(angle: float) -> float:
    """Return an angle (rad) in degrees, from -180 to 180."""
    return round(degrees(remainder(angle, 2 * pi)), 6) + 0.0  # not -0
