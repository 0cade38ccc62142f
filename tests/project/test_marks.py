"""Arrows, bars, slow hits, and bobs that a mouse drags; on the stand-in."""

from itertools import pairwise
from math import sqrt

import pytest
from rig import Rig
from vpython import scene, vector
from whole_cradles import GOOD, HEADER, PERIOD, velocities

from src import visualize_cradle_run
from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.energy import momentum
from support.page.scene.marks import ARROW_TIME, FLAT, YELLOW
from support.page.scene.slow_hits import EACH


def visible(rig, name):
    return [shape for shape in rig.viewer.marks.shapes.get(name, []) if shape.visible]


def lowest(rig):
    """Return the height (m) of the lowest point that each camera shows."""
    return min(y for _, y, _ in rig.state["view"]["points"])


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_the_velocities_of_the_bobs_that_move_and_bars_all_momenta(csv, kind):
    """Also for a later cradle; the view has room for the bars, and for the words beside them."""
    rig = Rig(csv, *[30] * kind.cord_count, kind=kind)
    ground = lowest(rig)
    rig.give("arrows", True)
    rig.save(HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD)
    rig.give("restart")
    rig.wait(0.15)  # the first pendulum is on its way to the second one
    cradle = rig.cradle
    marks = rig.viewer.marks
    arrows = visible(rig, "arrows")
    moves = velocities(cradle.pend_list[0])
    assert len(arrows) == len(moves)
    assert pytest.approx(PERIOD / 9) == ARROW_TIME
    for arrow, bob, velocity in zip(arrows, cradle.bobs(), moves, strict=False):
        assert arrow.pos.value[:2] == bob.pos.value[:2]
        assert arrow.axis.value == pytest.approx((ARROW_TIME * velocity).value)

    # The bar of the largest momentum, sqrt(2 m E) of the only pendulum that moves, is a full one
    mass = 3.0 * kind.cord_count
    assert marks.largest == pytest.approx(sqrt(2 * mass * sum(cradle.energies())), rel=0.001)
    bars = visible(rig, "bars")
    first, second = [momentum([pend], R_PARAM) for pend in cradle.pend_list]
    for bar, p in zip(bars, (first, second, first + second), strict=True):
        height = marks.height * p / marks.largest
        assert bar.size.y == pytest.approx(max(abs(height), FLAT * marks.height))
        assert bar.pos.y == pytest.approx(marks.level + height / 2)
    assert [bar.pos.x for bar in bars[:-1]] == [axle.pos.x for axle in cradle.axles()]
    assert [bar.color for bar in bars[:-1]] == cradle.colors()
    left, right = rig.state["view"]["labels"]
    assert left["text"] == "momentum\n(up = right)"
    assert left["y"] == marks.level
    places = [left["x"], *(bar.pos.x for bar in bars), right["x"]]
    assert places == sorted(places)
    assert lowest(rig) < marks.level - marks.height
    assert marks.level + marks.height < ground

    rig.give("arrows", False)
    assert not any(shape.visible for shape in arrows + bars)
    assert rig.state["view"]["labels"] == []
    assert lowest(rig) == ground


def reversed_order(pend_list, r_param, dt, g):
    """Let the pairs collide from right to left, as a student may have written it."""
    visualize_cradle_run.full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in reversed([*pairwise(pend_list)]):
        visualize_cradle_run.handle_two_bobs(pend1, pend2, r_param, approaching_only=True)


@pytest.mark.parametrize(
    ("tick", "pairs"),
    [
        (visualize_cradle_run.newton_cradle_tick, "23 12 34 23 45 34"),
        (reversed_order, "23 34 12 45 23 34"),
    ],
)
def test_slow_hits_show_each_pair_in_the_order_of_the_calls_and_then_the_swing_goes_on(
    csv, monkeypatch, tick, pairs
):
    """With its speeds, its halos and the arrows after it."""
    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", tick)
    rig = Rig(csv, 45, lifted=2)
    rig.give("slow hits", True)
    rig.give("arrows", True)
    pendula = [id(pend) for pend in rig.cradle.pend_list]
    rig.wait(PERIOD / 4 + EACH / 4)
    moving = {1, 2}
    for number, pair in enumerate(pairs.split(), start=1):
        left, right = map(int, pair)
        assert rig.state["hit"] == {
            "title": f"Hit {number}: bobs {left} and {right}",
            "lines": [f"bob {left}: +1.07 → +0.00 m/s", f"bob {right}: +0.00 → +1.07 m/s"],
            "note": "This order is the model's: a tick takes one pair after the other.",
        }
        places = [bob.pos.x for bob in rig.cradle.bobs()]
        assert [halo.pos.x for halo in visible(rig, "halos")] == places[left - 1 : right]
        moving.remove(left)
        moving.add(right)
        arrows = [arrow.pos.x for arrow in visible(rig, "arrows")]
        assert arrows == [places[bob - 1] for bob in sorted(moving)]
        ticks = rig.viewer.motion.ticks
        rig.wait(EACH / 2)
        assert rig.viewer.motion.ticks == ticks  # the time holds
        rig.wait(EACH / 2)
    assert rig.state["hit"] is None
    assert not any(shape.color == YELLOW for shape in scene.objects)
    assert rig.viewer.motion.ticks > ticks
    assert [id(pend) for pend in rig.cradle.pend_list] == pendula  # no copies


def test_a_step_goes_on_to_the_next_of_the_slow_hits(rig):
    """Also if a step has brought the first of them."""
    rig.give("slow hits", True)
    rig.wait(0.2)
    rig.give("pause")
    while rig.state["hit"] is None:
        rig.give("step")
    for number in (1, 2, 3):
        rig.wait(3)
        assert f"Hit {number}:" in rig.state["hit"]["title"]
        rig.give("step")
    rig.give("pause")
    rig.wait(1.5)
    assert rig.state["hit"] is None
    assert rig.time() > 0.4


# --- dragging --------------------------------------------------------------------------------

# The direction of the view: onto the row, along it, and slanting
AHEAD = (0, 0, -1)
ALONG = (-1, 0, 0)
SLANTING = (-0.3, -0.2, -1)


@pytest.mark.parametrize("is_paused", [False, True])
@pytest.mark.parametrize(
    ("kind", "bob", "cords"), [(Cradle, 4, 1), (DoubleCradle, 8, 1), (DoubleCradle, 9, 2)]
)
def test_a_bob_is_dragged_along_its_arc_let_go_and_swings_on_with_no_speed(
    csv, kind, bob, cords, is_paused
):
    """Also in a slanting view, and where no point in the plane of swing is under the mouse."""
    rig = Rig(csv, *[0] * kind.cord_count, kind=kind)
    pend = rig.cradle.pend_list[4]
    axle = rig.cradle.axles()[4].pos
    bob = rig.cradle.bobs()[bob]
    if is_paused:
        rig.tabs.give("pause")
    for key in kind.rate_keys:
        pend[key] = 1.0
    rig.mouse("grab", bob.pos + vector(bob.radius / 2, 0, 0), SLANTING)
    rig.mouse("drag", axle + vector(3, -3, 0), SLANTING)  # far away
    rig.mouse("drag", vector(1, 1, 1), ALONG)
    rig.wait(0.5)
    assert rig.bob_angles() == [0, 0, 0, 0, 45]
    side = cords * R_PARAM / 2**0.5
    assert (bob.pos - axle).value == pytest.approx([side, -side, 0])
    assert rig.state["motion"]["energy"] == "100.00 %"
    assert not any(pend[key] for key in kind.rate_keys)
    if is_paused:  # the graph has the same scale, and one row for this time
        [(_, _, _, total)] = rig.state["curves"]["rows"]
        assert total == pytest.approx(100)
    rig.give("let go")
    rig.mouse("drag", axle)
    rig.wait(0.1)
    assert (rig.bob_angles()[4] == 45) == is_paused


def test_a_drag_and_its_end_in_one_picture_are_in_the_graph(rig):
    """The energy is then that of 100 %."""
    rig.give("pause")
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    far = rig.cradle.axles()[4].pos + vector(3, -3, 0)
    rig.tabs.give("drag", far.value, [0, 0, -1])
    rig.give("let go")
    assert rig.bob_angles()[4] == 45
    assert rig.state["curves"]["rows"][-1][3] == pytest.approx(100)


@pytest.mark.parametrize(
    ("bob", "radii", "direction", "taken"),
    [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)],
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(
    rig, bob, radii, direction, taken
):
    """A finger may be beside it. A click that takes none begins no new 100 %."""
    rig.tabs.give("pause")
    rig.give("lifted", 0)
    rig.cradle.pend_list[0]["omega"] = 3.0
    bob = rig.cradle.bobs()[bob]
    rig.mouse("grab", bob.pos + vector(radii * bob.radius, 0, 0), direction)
    assert rig.cradle.held_bob.index == taken
    assert (rig.viewer.motion.start_energy == 0) == (taken is None)
