"""The controls and commands of the page: each is declared here, once.

A control appears in its place of page.html by itself.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from support.columns import SETTABLE
from support.cradle.cradle import COUNT, Cradle
from support.page.chooser import Chooser
from support.page.controls import (
    Command,
    Control,
    is_count,
    is_direction,
    is_number,
    is_point,
    is_text,
    Menu,
    Slider,
    Switch,
)
from support.page.cradle_editor import CradleEditor
from support.page.ghost_file import GhostFile
from support.page.graph import Graph
from support.page.lesson import Lesson
from support.page.names import Commands
from support.page.readout import Bars
from support.page.scene.marks import Marks
from support.page.scene.slow_hits import SlowHits
from support.page.unknown import Unknown

SPEEDS = (0.1, 2.0)  # times real time: the ends of the slider
MOST_BOBS = 9  # of the slider, if the CSV has no more
MASSES = (0.5, 10.0)  # kg: the ends of the slider
ANGLES_IN_WORDS = {
    "release_angle": "Release angle: theta, from straight down",
    "angle_theta": "Angle theta: of the upper cord, from straight down",
    "angle_phi": "Angle phi: how far the lower cord is bent outwards, from the upper one",
}


def controls(
    cradle: Cradle,
    chooser: Chooser,
    editor: CradleEditor,
    lesson: Lesson,
    marks: Marks,
    bars: Bars,
    slow_hits: SlowHits,
    graph: Graph,
) -> dict[str, Control]:
    """Return the controls by their names; those of a place stand in this order."""

    def with_owner(text: str, name: str) -> str:
        """Return the text of a slider, which says so if the program sets its value itself."""
        return f"{text}, set by the program" if name in cradle.set_by_program else text

    def count_limits() -> tuple[int, int]:
        yours = len(chooser.unchanged().csv.pendula)
        return 1, max(MOST_BOBS, yours)

    def e_as_text(first: float) -> str:
        es = cradle.values("e")
        least, most = min(es), max(es)
        text = f"{most:g}" if least == most else f"{least:g} to {most:g}"
        return with_owner(text, "e")

    # Each has its place, its label, its help, and what gets and sets its value.
    found: dict[str, Control] = {
        "experiment": Menu(
            "gallery",
            "Experiment",
            "",
            chooser.name,
            lesson.choose,
            choices=chooser.names,
        ),
        "ask": Switch(
            "lesson",
            "Ask",
            "An experiment asks what will happen, and what you saw, before it explains",
            lambda: lesson.asks,
            lesson.set_asks,
        ),
        "arrows": Switch(
            "shows",
            "Arrows",
            "Velocities as arrows",
            lambda: marks.has_arrows,
            partial(setattr, marks, "has_arrows"),
        ),
        "momenta": Switch(
            "shows",
            "Momenta",
            "Horizontal momenta as bars",
            lambda: bars.is_on,
            partial(setattr, bars, "is_on"),
        ),
        "measure": Switch(
            "shows",
            "Measure",
            "Angle and speed (m/s) at each bob, a dial, and a stopwatch",
            lambda: marks.measures,
            partial(setattr, marks, "measures"),
        ),
        "slow_hits": Switch(
            "shows",
            "Slow hits",
            "The time stands at each hit, until Next hit. Key: H",
            lambda: slow_hits.is_on,
            slow_hits.switch,
        ),
        "graph": Menu(
            "graph",
            "Graph",
            "theta: the angle of a cord from straight down; omega: how fast it changes",
            graph.name,
            partial(setattr, graph, "chosen"),
            choices=graph.names,
        ),
        "speed": Slider(
            "settings",
            "Speed",
            "Speed: 1x is real time",
            lesson.speed_now,
            lesson.set_speed,
            limits=lambda: SPEEDS,
            as_text="{:.1f}x".format,
            step=0.1,
        ),
        "count": Slider(
            "settings",
            "Bobs",
            "Bobs: the balls. Your file stays as it is",
            lambda: cradle.count,
            editor.set_count,
            limits=count_limits,
            as_text=lambda count: with_owner(f"{count}", COUNT),
            is_enabled=partial(editor.can_change, COUNT),
        ),
        "lifted": Slider(
            "controls",
            "Bobs lifted",
            "Bobs lifted: from the left",
            lambda: cradle.lifted,
            lambda lifted: editor.release(lifted=lifted),
            limits=lambda: (0, cradle.count),
            as_text=lambda lifted: f"{lifted} of {cradle.count}",
        ),
    }
    for cord, name in enumerate(cradle.angle_limits):
        found[name] = Slider(
            "settings",
            name.replace("_", " ").capitalize(),
            ANGLES_IN_WORDS[name],
            partial(editor.release_angle, cord),
            partial(editor.set_release_angle, cord),
            limits=partial(cradle.angle_limits.__getitem__, name),
            as_text="{:.4g}°".format,
        )
    found["mass"] = Slider(
        "settings",
        "Bob 1: mass",
        "Bob 1: the first bob from the left",
        lambda: cradle.shown("mass")[0],
        lambda mass: editor.edit(0, "mass", mass),
        limits=lambda: MASSES,
        as_text=lambda mass: with_owner(f"{mass:g} kg", "mass"),
        step=0.5,
        is_enabled=partial(editor.can_change, "mass"),
    )
    found["e"] = Slider(
        "settings",
        "Elasticity e",
        "e, the coefficient of restitution of all bobs: 1 = the bobs part as fast as they "
        "met, 0 = they stay together",
        lambda: cradle.shown("e")[0],
        editor.set_e,
        limits=lambda: (0, 1),
        as_text=e_as_text,
        step=0.01,
        is_enabled=partial(editor.can_change, "e"),
    )
    if cradle.cord_count == 1:  # the double cradle has this rule itself
        found["separating"] = Switch(
            "bobs",
            "Separating bobs collide too",
            "The assignment lets two bobs collide in each tick in which they touch, also when "
            "they already move apart. A second hit then undoes a part of the first one: bobs with "
            "e below 1 stick together",
            lambda: editor.next_cradle.settings.separating,
            lambda separating: editor.change(separating=separating),
        )
    return found


def commands(
    controls: Mapping[str, Control],
    lesson: Lesson,
    unknown: Unknown,
    editor: CradleEditor,
    ghost_file: GhostFile,
    grab: Callable[..., None],
    drag: Callable[..., None],
    let_go: Callable[[], None],
    restart: Callable[[], None],
) -> Commands:
    """Return what each command does, by its name."""

    def set_control(name: str, value: Any) -> None:
        if name in controls and controls[name].takes(value):
            controls[name].set(value)

    return {
        "set": Command(set_control, (is_text, lambda value: True)),  # the control looks at it
        "pause": Command(lesson.pause),
        "step": Command(lesson.step),
        "restart": Command(restart),
        "next": Command(partial(lesson.choose_neighbour, 1)),
        "previous": Command(partial(lesson.choose_neighbour, -1)),
        "repeat": Command(lesson.repeat),
        "answer": Command(lesson.answer, (is_text, is_count)),
        "check": Command(unknown.check, (is_text,)),
        "edit": Command(editor.edit, (is_count, lambda name: name in SETTABLE, is_number)),
        "save_csv": Command(editor.save_csv, (is_number,)),
        "grab": Command(grab, (is_point, is_direction)),
        "drag": Command(drag, (is_point, is_direction)),
        "let_go": Command(let_go),
        "load_ghosts": Command(partial(ghost_file.load, restart), (is_text, is_text)),
        "remove_ghosts": Command(ghost_file.remove),
    }
