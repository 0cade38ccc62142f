"""What the page shows outside VPython's canvas: the state, which a tab gets by the names in it."""

from typing import Any, TYPE_CHECKING

from support.columns import SETTABLE
from support.page import readout
from support.page.controls import state_of
from support.page.graph import to_css
from support.page.setup import setup

if TYPE_CHECKING:
    from support.page.viewer import Viewer


def state_of_page(viewer: "Viewer") -> dict[str, Any]:
    """Return what the page shows outside VPython's canvas, by name, all texts plain."""
    cradle = viewer.cradle
    remarks = [remark for remark in (viewer.given_remark, cradle.remark()) if remark]
    return {
        **setup(viewer),
        **state_of(viewer.controls),
        "ghosts": viewer.ghosts.name,
        "mistake_in_ghosts": viewer.ghosts.mistake,
        "title": cradle.title,
        "constants": readout.constants(cradle),
        "remark": " ".join(remarks),
        "error": viewer.error,
        "mistakes": viewer.chooser.mistakes,
        "pictures": dict(viewer.chooser.pictures),
        "changed": viewer.chooser.has_changes(),
        "ended": None,
        "paused": viewer.is_paused,
        "running": viewer.is_time_running(),
        "question": viewer.questions.state(),
        "word": viewer.questions.word,
        "hit": viewer.slow_hits.state(),
        "motion": numbers(viewer),
        "summary": viewer.motion.summary(),
        "bars": bars(viewer),
        "impacts": viewer.motion.impacts.lines(),
        "colors": [to_css(color) for color in cradle.colors()],
        "curves": viewer.graph.state(viewer.motion.start_energy),
        "columns": SETTABLE,
        "keys": [*cradle.angle_keys, *cradle.rate_keys],
        "table": {column: cradle.values(column) for column in SETTABLE},
        "refused": {place: refusal._asdict() for place, refusal in viewer.chooser.refused.items()},
        "tick_lines": viewer.tick_lines,
        "now": {name: f"{number:.6f}" for name, number in cradle.coordinates().items()},
    }


def numbers(viewer: "Viewer") -> dict[str, str]:
    """Return the numbers of the panel as text, by their names."""
    found = readout.readout(viewer.motion, viewer.pace, viewer.shown_pendula())
    if viewer.marks.measures:
        found["half swings"] = str(viewer.stopwatch)
    return found | viewer.ghosts.readout()


def bars(viewer: "Viewer") -> dict[str, Any] | None:
    """Return a title, and bars of the momenta and the energy; None without arrows.

    While the picture rests after a measurement, most bobs stop for a moment: the bars are then
    those after the last hits.
    """
    marks = viewer.marks
    if not marks.has_arrows:
        return None
    momenta = marks.momenta
    title = "Momentum (kg m/s)"
    if viewer.questions.rest_end is not None and viewer.after_hits:
        momenta = viewer.after_hits
        title = "Momentum after the hits (kg m/s)"
    found = readout.momentum_bars(momenta, marks.largest, viewer.cradle.colors())
    energy = viewer.motion.percents(viewer.shown_pendula())["energy"]
    found.append(readout.energy_bar(energy))
    return {"title": title, "bars": [bar._asdict() for bar in found]}
