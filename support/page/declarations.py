"""The controls and commands of the page: each is declared here, once.

page.html has a place for each control, by its name; state.py has their values.
"""

from typing import Any, TYPE_CHECKING

from support.columns import SETTABLE
from support.page.actions import Actions, SLOWLY
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
from support.page.graph import SPANS
from support.pendulum import angle_to_outwards

if TYPE_CHECKING:
    from support.page.viewer import Viewer

SPEEDS = (0.1, 2.0)  # times real time: the ends of the slider
MOST_BOBS = 9  # of the slider, if the CSV has no more
MASSES = (0.5, 10.0)  # kg: the ends of the slider, if the bob's mass is between them
ANGLES_IN_WORDS = {
    "release_angle": "Release angle: theta, from straight down",
    "angle_theta": "Angle theta: of the upper cord, from straight down",
    "angle_phi": "Angle phi: how far the lower cord is bent outwards, from the upper one",
}


def declare_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of the page; page.html has a place for each name."""
    return [
        *experiment_controls(viewer),
        *cradle_controls(viewer),
        *bob_controls(viewer),
        *show_controls(viewer),
    ]


def experiment_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of the experiments."""
    experiment = Menu(
        name="experiment",
        label="Experiment",
        get=viewer.chooser.name,
        set=viewer.actions.choose,
        choices=viewer.chooser.names,
    )
    ask_first = Switch(
        name="ask_first",
        label="Predict first",
        get=lambda: viewer.questions.ask_first,
        set=viewer.actions.set_ask_first,
    )
    return [experiment, ask_first]


def cradle_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of how the cradle is released, and how it moves."""
    cradle = viewer.cradle
    speed = Slider(
        name="speed",
        label="Speed",
        get=lambda: round(viewer.speed_now(), 2),
        set=viewer.actions.set_speed,
        limits=lambda: SPEEDS,
        as_text=lambda speed: f"{speed:.1f}x",
        step=0.1,
        help="Speed: 1x is real time",
    )
    count = Slider(
        name="count",
        label="Bobs",
        get=lambda: len(cradle.pend_list),
        set=viewer.actions.set_count,
        limits=lambda: (1, max(MOST_BOBS, viewer.chooser.count())),
        as_text=str,
        is_whole=True,
        help="Bobs: the balls. Your file stays as it is",
    )
    lifted = Slider(
        name="lifted",
        label="Bobs lifted",
        get=viewer.actions.lifted_now,
        set=viewer.actions.set_lifted,
        limits=lambda: (0, len(cradle.pend_list)),
        as_text=lambda lifted: f"{lifted} of {len(cradle.pend_list)}",
        is_whole=True,
        help="Bobs lifted: from the left. Keys: 1 to 9",
    )
    angles = [release_angle(viewer, cord, name) for cord, name in enumerate(cradle.angle_limits)]
    return [speed, count, lifted, *angles]


def bob_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of the bobs, and of how they collide."""
    cradle = viewer.cradle

    def mass_limits() -> tuple[float, float]:
        mass = cradle.values("mass")[0]
        return min(mass, MASSES[0]), max(mass, MASSES[1])

    mass = Slider(
        name="mass",
        label="Bob 1: mass",
        get=lambda: cradle.values("mass")[0],
        set=lambda mass: viewer.actions.edit(0, "mass", f"{mass:g}"),
        limits=mass_limits,
        as_text=lambda mass: f"{mass:g} kg",
        step=0.5,
        help="Bob 1: the first bob from the left",
    )

    def e_as_text(most: float) -> str:
        least = min(cradle.values("e"))
        return f"{most:g}" if least == most else f"{least:g} to {most:g}"

    e = Slider(
        name="e",
        label="Elasticity e",
        get=lambda: max(cradle.values("e")),
        set=lambda e: viewer.actions.set_collision(cradle.uniform_e(e)),
        limits=lambda: (0, 1),
        as_text=e_as_text,
        step=0.01,
        help="e, the coefficient of restitution of all bobs: 1 = the bobs part as fast as they "
        "met, 0 = they stay together",
        is_enabled=lambda: cradle.can_set_e,
    )
    collision = Menu(
        name="collision",
        label="Collisions",
        get=lambda: viewer.actions.name_on_page(cradle.collision),
        set=lambda name: viewer.actions.set_collision(viewer.actions.collisions()[name]),
        choices=lambda: list(viewer.actions.collisions()),
    )
    separating = Switch(
        name="separating",
        label="Separating bobs collide too",
        get=lambda: viewer.separating,
        set=viewer.actions.set_separating,
        is_enabled=lambda: cradle.takes_rule,
    )
    controls: list[Control] = [mass, e, collision]
    if cradle.has_rule:
        controls.append(separating)
    return controls


def show_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of what the page shows with the cradle."""
    slow = Switch(
        name="slow",
        label="Slow motion",
        get=lambda: viewer.speed_now() <= SLOWLY,
        set=viewer.actions.slow_down,
    )
    arrows = Switch(
        name="arrows",
        label="Arrows",
        get=lambda: viewer.marks.has_arrows,
        set=viewer.actions.show_arrows,
        help="Velocities as arrows, momenta as bars",
    )
    measure = Switch(
        name="measure",
        label="Measure",
        get=lambda: viewer.marks.measures,
        set=viewer.actions.measure,
        help="Angle and speed (m/s) at each bob, a dial, and a stopwatch",
    )
    slow_hits = Switch(
        name="slow_hits",
        label="Slow hits",
        get=lambda: viewer.looks_at_hits,
        set=viewer.actions.slow_down_hits,
        help="Key: H",
    )
    graph = Menu(
        name="graph",
        label="Graph",
        get=lambda: viewer.graph.chosen,
        set=viewer.graph.show,
        choices=lambda: [*viewer.graph.choices],
        help="theta: the angle of a cord from straight down; omega: how fast it changes",
    )
    span = Menu(
        name="span",
        label="Time of the graph",
        get=lambda: viewer.graph.span,
        set=viewer.actions.set_span,
        choices=lambda: [*SPANS],
    )
    return [slow, arrows, measure, slow_hits, graph, span]


def release_angle(viewer: "Viewer", cord: int, name: str) -> Slider:
    """Return the control of the release angle of this cord (0 upper, 1 lower)."""

    def get() -> float:
        return angle_to_outwards(viewer.cradle.release_angles(viewer.settings.angles)[cord])

    return Slider(
        name=name,
        label=name.replace("_", " ").capitalize(),
        get=get,
        set=lambda degrees: viewer.actions.set_release_angle(cord, degrees),
        limits=lambda: viewer.cradle.angle_limits[name],
        as_text=lambda degrees: f"{degrees:.4g}°",
        help=ANGLES_IN_WORDS[name],
    )


def declare_commands(actions: Actions) -> dict[str, Command]:
    """Return the commands that have no control with a value, by their names."""
    return {
        "pause": Command(actions.pause),
        "step": Command(actions.do_step),
        "tick": Command(actions.do_one_tick),
        "restart": Command(actions.viewer.want_cradle),
        "reset": Command(actions.reset),
        "next": Command(actions.choose_next),
        "repeat": Command(actions.repeat, (is_switch,)),
        "answer": Command(actions.answer, (is_text, is_answer)),
        "vote": Command(actions.questions.vote, (is_text, is_count, is_switch)),
        "edit": Command(actions.edit, (is_count, is_in_table, is_text)),
        "grab": Command(actions.grab, (is_point, is_direction)),
        "drag": Command(actions.drag, (is_point, is_direction)),
        "let_go": Command(actions.let_go),
        "load_ghosts": Command(actions.show_ghosts, (is_text, is_file)),
        "remove_ghosts": Command(actions.remove_ghosts),
    }


def is_answer(value: Any) -> bool:
    return value is None or is_count(value)


def is_file(value: Any) -> bool:
    return type(value) is str


def is_in_table(value: Any) -> bool:
    return value in SETTABLE
