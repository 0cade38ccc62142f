"""The controls and commands of the page: each is declared here, once.

A control appears in its place of page.html by itself.
"""

from collections.abc import Callable
from typing import Any

from support.columns import SETTABLE
from support.cradle.cradle import Cradle
from support.cradle.settings import NextCradle
from support.page.chooser import Chooser
from support.page.controls import (
    Command,
    Control,
    is_count,
    is_direction,
    is_point,
    is_switch,
    is_text,
    Menu,
    Slider,
    Switch,
)
from support.page.cradle_settings import CradleSettings
from support.page.ghost_file import GhostFile
from support.page.graph import Graph
from support.page.lesson import Lesson
from support.page.names import Commands
from support.page.playback import Playback
from support.page.questions import Questions
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


def experiment_menu(chooser: Chooser, lesson: Lesson) -> Menu:
    """Return the control of what is chosen: your CSV, or an experiment."""
    return Menu(
        name="experiment",
        place="gallery",
        label="Experiment",
        get=chooser.name,
        set=lesson.choose,
        choices=chooser.names,
    )


def cradle_controls(
    cradle: Cradle, next_cradle: NextCradle, settings: CradleSettings
) -> list[Control]:
    """Return the controls of how the cradle is released, and of its bobs."""

    def first_mass() -> float | None:
        return cradle.shown("mass")[0]

    def mass_limits() -> tuple[float, float]:
        mass = first_mass() or MASSES[0]
        return min(mass, MASSES[0]), max(mass, MASSES[1])

    def largest_e() -> float | None:
        es = cradle.shown("e")
        return None if None in es else max(es)

    def is_open() -> bool:
        return not cradle.hidden  # else, only the release can be changed

    def e_as_text(most: float | None) -> str:
        if most is None:
            return "?"
        least = min(cradle.values("e"))
        return f"{most:g}" if least == most else f"{least:g} to {most:g}"

    count = Slider(
        name="count",
        place="settings",
        label="Bobs",
        get=lambda: len(cradle.pend_list),
        set=settings.set_count,
        limits=lambda: (1, max(MOST_BOBS, settings.most_bobs())),
        as_text=str,
        is_whole=True,
        is_enabled=is_open,
        help="Bobs: the balls. Your file stays as it is",
    )
    lifted = Slider(
        name="lifted",
        place="settings",
        label="Bobs lifted",
        get=settings.lifted,
        set=settings.set_lifted,
        limits=lambda: (0, len(cradle.pend_list)),
        as_text=lambda lifted: f"{lifted} of {len(cradle.pend_list)}",
        is_whole=True,
        help="Bobs lifted: from the left",
    )
    angles = [release_angle(cradle, settings, *angle) for angle in enumerate(cradle.angle_limits)]
    mass = Slider(
        name="mass",
        place="settings",
        label="Bob 1: mass",
        get=first_mass,
        set=lambda mass: settings.edit(0, "mass", f"{mass:g}"),
        limits=mass_limits,
        as_text=lambda mass: "?" if mass is None else f"{mass:g} kg",
        step=0.5,
        is_enabled=is_open,
        help="Bob 1: the first bob from the left",
    )
    e = Slider(
        name="e",
        place="settings",
        label="Elasticity e",
        get=largest_e,
        set=settings.set_e,
        limits=lambda: (0, 1),
        as_text=e_as_text,
        step=0.01,
        help="e, the coefficient of restitution of all bobs: 1 = the bobs part as fast as they "
        "met, 0 = they stay together",
        is_enabled=is_open,
    )
    separating = Switch(
        name="separating",
        place="programmers",
        label="Separating bobs collide too",
        get=lambda: next_cradle.separating,
        set=settings.set_separating,
    )
    controls: list[Control] = [count, lifted, *angles, mass, e]
    if cradle.cord_count == 1:  # the double cradle has this rule itself
        controls.append(separating)
    return controls


def release_angle(cradle: Cradle, settings: CradleSettings, cord: int, name: str) -> Slider:
    """Return the control of the release angle of this cord (0 upper, 1 lower)."""
    return Slider(
        name=name,
        place="settings",
        label=name.replace("_", " ").capitalize(),
        get=lambda: settings.release_angle(cord),
        set=lambda degrees: settings.set_release_angle(cord, degrees),
        limits=lambda: cradle.angle_limits[name],
        as_text=lambda degrees: f"{degrees:.4g}°",
        help=ANGLES_IN_WORDS[name],
    )


def view_controls(
    lesson: Lesson,
    questions: Questions,
    playback: Playback,
    marks: Marks,
    slow_hits: SlowHits,
    graph: Graph,
) -> list[Control]:
    """Return the controls of how the page shows the cradle; Reset all puts them back."""
    ask_first = Switch(
        name="ask_first",
        place="lesson",
        label="Predict first",
        get=lambda: questions.ask_first,
        set=lesson.set_ask_first,
        help="An experiment first asks what will happen",
    )
    ask_seen = Switch(
        name="ask_seen",
        place="lesson",
        label="Say what you saw",
        get=lambda: questions.ask_seen,
        set=lesson.set_ask_seen,
        help="After the first swing, it asks what has happened, and only then explains it",
    )
    speed = Slider(
        name="speed",
        place="settings",
        label="Speed",
        get=lambda: round(playback.speed_now(), 2),
        set=playback.set_speed,
        limits=lambda: SPEEDS,
        as_text=lambda speed: f"{speed:.1f}x",
        step=0.1,
        help="Speed: 1x is real time",
    )
    arrows = Switch(
        name="arrows",
        place="shows",
        label="Arrows",
        get=lambda: marks.has_arrows,
        set=marks.switch_arrows,
        help="Velocities as arrows, momenta as bars",
    )
    measure = Switch(
        name="measure",
        place="shows",
        label="Measure",
        get=lambda: marks.measures,
        set=marks.switch_measures,
        help="Angle and speed (m/s) at each bob, a dial, and a stopwatch",
    )
    hits = Switch(
        name="slow_hits",
        place="shows",
        label="Slow hits",
        get=lambda: slow_hits.is_on,
        set=slow_hits.switch,
        help="Key: H",
    )
    curves = Menu(
        name="graph",
        place="graph",
        label="Graph",
        get=graph.name,
        set=graph.show,
        choices=lambda: [*graph.choices],
        help="theta: the angle of a cord from straight down; omega: how fast it changes",
    )
    return [ask_first, ask_seen, speed, arrows, measure, hits, curves]


def commands(
    set_control: Callable[[str, Any], None],
    playback: Playback,
    lesson: Lesson,
    questions: Questions,
    unknown: Unknown,
    settings: CradleSettings,
    ghost_file: GhostFile,
    grab: Callable[..., None],
    drag: Callable[..., None],
    let_go: Callable[[], None],
    restart: Callable[[], None],
    reset: Callable[[], None],
) -> Commands:
    """Return what each command does, by its name."""
    return {
        "set": Command(set_control, (is_text, is_json)),
        "pause": Command(playback.pause),
        "step": Command(playback.do_step),
        "restart": Command(restart),
        "reset": Command(reset),
        "next": Command(lesson.choose_next),
        "previous": Command(lesson.choose_previous),
        "repeat": Command(lesson.repeat, (is_switch,)),
        "answer": Command(questions.answer, (is_text, is_count)),
        "check": Command(unknown.check, (is_text,)),
        "edit": Command(settings.edit, (is_count, is_in_table, is_text)),
        "grab": Command(grab, (is_point, is_direction)),
        "drag": Command(drag, (is_point, is_direction)),
        "let_go": Command(let_go),
        "load_ghosts": Command(ghost_file.load, (is_text, is_text)),
        "remove_ghosts": Command(ghost_file.remove),
    }


def is_json(value: object) -> bool:
    return True  # the control looks at it


def is_in_table(value: object) -> bool:
    return value in SETTABLE
