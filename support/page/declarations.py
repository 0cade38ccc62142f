"""The controls and commands of the page: each is declared here, once.

A control appears in its place of page.html by itself.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from support.cradle.cradle import COUNT, Cradle
from support.cradle.settings import NextCradle
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
from support.page.cradle_settings import CradleSettings, LIMITS
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
MASSES = (0.5, 10.0)  # kg: the ends of the slider, if the bob's mass is between them
ANGLES_IN_WORDS = {
    "release_angle": "Release angle: theta, from straight down",
    "angle_theta": "Angle theta: of the upper cord, from straight down",
    "angle_phi": "Angle phi: how far the lower cord is bent outwards, from the upper one",
}


def controls(
    cradle: Cradle,
    next_cradle: NextCradle,
    chooser: Chooser,
    settings: CradleSettings,
    lesson: Lesson,
    marks: Marks,
    bars: Bars,
    slow_hits: SlowHits,
    graph: Graph,
) -> dict[str, Control]:
    """Return the controls by their names; those of a place stand in this order."""

    def first_mass() -> float | None:
        return cradle.shown("mass")[0]

    def count_limits() -> tuple[int, int]:
        yours = len(chooser.unchanged().csv.pendula)
        return 1, max(MOST_BOBS, yours)

    def mass_limits() -> tuple[float, float]:
        mass = first_mass() or MASSES[0]
        return min(mass, MASSES[0]), max(mass, MASSES[1])

    def mass_as_text(mass: float | None) -> str:
        return "?" if mass is None else with_owner(f"{mass:g} kg", cradle, "mass")

    def largest_e() -> float | None:
        es = cradle.shown("e")
        return None if None in es else max(es)

    def e_as_text(most: float | None) -> str:
        if most is None:
            return "?"
        least = min(cradle.values("e"))
        text = f"{most:g}" if least == most else f"{least:g} to {most:g}"
        return with_owner(text, cradle, "e")

    # Each has its place, its label, and what gets and sets its value.
    found: dict[str, Control] = {
        "experiment": Menu(
            "gallery",
            "Experiment",
            chooser.name,
            lesson.choose,
            choices=chooser.names,
        ),
        "ask": Switch(
            "lesson",
            "Ask",
            lambda: lesson.asks,
            lesson.set_asks,
            help="An experiment asks what will happen, and what you saw, before it explains",
        ),
        "arrows": Switch(
            "shows",
            "Arrows",
            lambda: marks.has_arrows,
            marks.switch_arrows,
            help="Velocities as arrows",
        ),
        "momenta": Switch(
            "shows",
            "Momenta",
            lambda: bars.is_on,
            bars.switch,
            help="Horizontal momenta as bars",
        ),
        "measure": Switch(
            "shows",
            "Measure",
            lambda: marks.measures,
            marks.switch_measures,
            help="Angle and speed (m/s) at each bob, a dial, and a stopwatch",
        ),
        "slow_hits": Switch(
            "shows",
            "Slow hits",
            lambda: slow_hits.is_on,
            slow_hits.switch,
            help="The time stands at each hit, until Next hit. Key: H",
        ),
        "graph": Menu(
            "graph",
            "Graph",
            graph.name,
            graph.choose,
            choices=graph.names,
            help="theta: the angle of a cord from straight down; omega: how fast it changes",
        ),
        "speed": Slider(
            "settings",
            "Speed",
            lambda: round(lesson.speed_now(), 2),
            lesson.set_speed,
            limits=lambda: SPEEDS,
            as_text=lambda speed: f"{speed:.1f}x",
            step=0.1,
            help="Speed: 1x is real time",
        ),
        "count": Slider(
            "settings",
            "Bobs",
            lambda: len(cradle.pend_list),
            settings.set_count,
            limits=count_limits,
            as_text=lambda count: with_owner(f"{count}", cradle, COUNT),
            is_enabled=partial(settings.can_change, COUNT),
            help="Bobs: the balls. Your file stays as it is",
        ),
        "lifted": Slider(
            "controls",
            "Bobs lifted",
            lambda: cradle.lifted,
            lambda lifted: settings.release(lifted=lifted),
            limits=lambda: (0, len(cradle.pend_list)),
            as_text=lambda lifted: f"{lifted} of {len(cradle.pend_list)}",
            help="Bobs lifted: from the left",
        ),
    }
    for cord, name in enumerate(cradle.angle_limits):
        found[name] = release_angle(cradle, settings, cord, name)
    found["mass"] = Slider(
        "settings",
        "Bob 1: mass",
        first_mass,
        lambda mass: settings.edit(0, "mass", mass),
        limits=mass_limits,
        as_text=mass_as_text,
        step=0.5,
        is_enabled=partial(settings.can_change, "mass"),
        help="Bob 1: the first bob from the left",
    )
    found["e"] = Slider(
        "settings",
        "Elasticity e",
        largest_e,
        settings.set_e,
        limits=lambda: (0, 1),
        as_text=e_as_text,
        step=0.01,
        is_enabled=partial(settings.can_change, "e"),
        help="e, the coefficient of restitution of all bobs: 1 = the bobs part as fast as they "
        "met, 0 = they stay together",
    )
    if cradle.cord_count == 1:  # the double cradle has this rule itself
        found["separating"] = Switch(
            "bobs",
            "Separating bobs collide too",
            lambda: next_cradle.settings.separating,
            lambda separating: settings.change(separating=separating),
            help="The assignment lets two bobs collide in each tick in which they touch, also when "
            "they already move apart. A second hit then undoes a part of the first one: bobs with "
            "e below 1 stick together",
        )
    return found


def with_owner(text: str, cradle: Cradle, name: str) -> str:
    """Return the text of a slider, which says so if the program sets its value itself."""
    return f"{text}, set by the program" if name in cradle.own else text


def release_angle(cradle: Cradle, settings: CradleSettings, cord: int, name: str) -> Slider:
    """Return the control of the release angle of this cord (0 upper, 1 lower)."""
    return Slider(
        "settings",
        name.replace("_", " ").capitalize(),
        lambda: settings.release_angle(cord),
        lambda degrees: settings.set_release_angle(cord, degrees),
        limits=lambda: cradle.angle_limits[name],
        as_text=lambda degrees: f"{degrees:.4g}°",
        help=ANGLES_IN_WORDS[name],
    )


def commands(
    controls: Mapping[str, Control],
    lesson: Lesson,
    unknown: Unknown,
    settings: CradleSettings,
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
        "set": Command(set_control, (is_text, is_json)),
        "pause": Command(lesson.pause),
        "step": Command(lesson.step),
        "restart": Command(restart),
        "next": Command(lesson.choose_next),
        "previous": Command(lesson.choose_previous),
        "repeat": Command(lesson.repeat),
        "answer": Command(lesson.answer, (is_text, is_count)),
        "check": Command(unknown.check, (is_text,)),
        "edit": Command(settings.edit, (is_count, is_in_table, is_number)),
        "save_csv": Command(settings.save_csv, (is_number,)),
        "grab": Command(grab, (is_point, is_direction)),
        "drag": Command(drag, (is_point, is_direction)),
        "let_go": Command(let_go),
        "load_ghosts": Command(partial(ghost_file.load, restart), (is_text, is_text)),
        "remove_ghosts": Command(ghost_file.remove),
    }


def is_json(value: object) -> bool:
    return True  # the control looks at it


def is_in_table(value: object) -> bool:
    return value in [*LIMITS]  # a list has no hash
