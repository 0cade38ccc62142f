"""The controls and commands of the page: each is declared here, once.

page.html has a place for each control, by its name; Viewer.state has their values.
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


def declare_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of the page; page.html has a place for each name."""
    return [*experiment_controls(viewer), *cradle_controls(viewer), *show_controls(viewer)]


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
        name="ask first",
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
    )
    lifted = Slider(
        name="lifted",
        label="Bobs lifted",
        get=viewer.actions.lifted_now,
        set=viewer.actions.set_lifted,
        limits=lambda: (0, len(cradle.pend_list)),
        as_text=lambda lifted: f"{lifted} of {len(cradle.pend_list)}",
        is_whole=True,
        help="Keys: 1 to 9",
    )
    angles = [release_angle(viewer, cord, name) for cord, name in enumerate(cradle.angle_limits)]
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
    controls: list[Control] = [speed, lifted, *angles, collision]
    if cradle.has_rule:
        controls.append(separating)
    return controls


def show_controls(viewer: "Viewer") -> list[Control]:
    """Return the controls of what the page shows beside the cradle."""
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
        name="slow hits",
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
        label=name.capitalize(),
        get=get,
        set=lambda degrees: viewer.actions.set_release_angle(cord, degrees),
        limits=lambda: viewer.cradle.angle_limits[name],
        as_text=lambda degrees: f"{degrees:.4g}°",
    )


def declare_commands(actions: Actions) -> dict[str, Command]:
    """Return the commands that have no control with a value, by their names."""
    return {
        "pause": Command(actions.pause),
        "step": Command(actions.do_step),
        "tick": Command(actions.do_one_tick),
        "restart": Command(actions.viewer.want_cradle),
        "next": Command(actions.choose_next),
        "again": Command(actions.repeat, (is_switch,)),
        "answer": Command(actions.answer, (is_text, is_answer)),
        "vote": Command(actions.questions.vote, (is_text, is_count)),
        "edit": Command(actions.edit, (is_count, is_in_table, is_text)),
        "grab": Command(actions.grab, (is_point, is_direction)),
        "drag": Command(actions.drag, (is_point, is_direction)),
        "let go": Command(actions.let_go),
    }


def is_answer(value: Any) -> bool:
    return value is None or is_count(value)


def is_in_table(value: Any) -> bool:
    return value in SETTABLE
