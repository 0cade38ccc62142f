"""How to make the cradle of now again: with a command, or from the file of an experiment."""

from math import degrees, pi, remainder
from typing import TYPE_CHECKING

from support.columns import SETTABLE
from support.constants import NC_FP
from support.files.experiments import experiment_text
from support.pendulum import angle_to_outwards
from support.start.options import command_line

if TYPE_CHECKING:
    from support.page.viewer import Viewer

NAME = "My setup"  # of the experiment in the file
FILE = "my_cradle.txt"  # keep.js has this name, too
USE_IT = "This command starts the page with this cradle:"
SAVE_FIRST = (
    f"No options make this cradle. First save the text below as {FILE}, in the folder where you "
    "type this command (the bobs then have the colors of experiments):"
)
NO_RULE = "Separating bobs do not collide in it until you tick the box again."


def setup(viewer: "Viewer") -> dict[str, str]:
    """Return a command, what to do with it, and the text of a file, by their names in the state."""
    options = options_of(viewer)
    advice = USE_IT
    if options is None:
        options = [f"--experiment={FILE}"]
        advice = SAVE_FIRST
    if viewer.separating and viewer.cradle.takes_rule:
        advice = f"{NO_RULE} {advice}"
    csv = str(viewer.file.filepath)
    if csv != NC_FP:
        options = [csv, *options]
    again = command_line(viewer.cradle.page_program, options)
    return {"same_cradle": again, "advice": advice, "setup": file_text(viewer)}


def options_of(viewer: "Viewer") -> list[str] | None:
    """Return the options that make the cradle of now, or None if there are none."""
    chooser = viewer.chooser
    experiment = chooser.whole_experiment()
    if experiment:
        return [f"--experiment={experiment.file}"]
    if chooser.experiment or chooser.is_edited() or viewer.is_dragged or viewer.error:
        return None
    settings = viewer.settings
    options = []
    for name, angle in zip(("angle", "phi"), settings.angles, strict=False):
        if angle is not None:
            options.append(f"--{name}={angle_to_outwards(angle):.12g}")
    if settings.lifted is not None:
        options.append(f"--lift={viewer.actions.lifted_now()}")
    if settings.mass is not None:
        options.append(f"--mass={settings.mass:.12g}")
    if settings.collision.source:
        options.append(f"--e={viewer.cradle.values('e')[0]:.12g}")
    return options


def file_text(viewer: "Viewer") -> str:
    """Return the text of an experiment with the angles of the last release."""
    lines = {}
    for key, angles in viewer.motion.start_angles.items():
        lines[key] = [whole_turns_off(angle) for angle in angles]
    lines |= {name: viewer.cradle.values(name) for name in SETTABLE}
    return experiment_text(NAME, lines)


def whole_turns_off(angle: float) -> float:
    """Return an angle (rad) in degrees, from -180 to 180."""
    return round(degrees(remainder(angle, 2 * pi)), 6) + 0.0  # not -0
