"""What is drawn on the cradle: arrows, masses, a dial, slow hits; and which bob a mouse moves."""

from math import atan2, degrees, sqrt

import pytest
from rig import Rig
from vpython import diff_angle, vector
from whole_cradles import GOOD, HEADER, PERIOD, velocities

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.real_time import FRAME
from support.energy import momentum
from support.page.scene.marks import LONGEST_ARROW


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_velocities_and_bars_horizontal_momenta(csv, kind):
    """Also for a later cradle."""
    rig = Rig(csv, *[30] * kind.cord_count, kind=kind)
    rig.give("arrows", True)
    rig.give("momenta", True)
    rig.save(HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD)
    rig.give("restart")
    rig.wait(0.15)  # the first pendulum is on its way to the second one
    moves = velocities(rig.cradle.pend_list[0])
    for arrow, bob, velocity in zip(rig.marks("arrows"), rig.cradle.bobs(), moves, strict=False):
        assert arrow.pos.x == bob.pos.x
        assert arrow.axis.value == pytest.approx((PERIOD / 20 * velocity).value)
    assert len(rig.marks("arrows")) == len(moves)

    # A full bar is the most momentum that all masses M can have with the energy E, sqrt(2 M E)
    largest = sqrt(2 * 4.0 * kind.cord_count * sum(rig.cradle.energies()))
    p = 3.0 * sum(velocity.x for velocity in moves)
    chart = rig.state["bars"]
    assert chart["title"] == "Horizontal momentum (kg m/s)"
    bar = [f"{p:+.2f}", "rgb(0, 0, 255)", pytest.approx(p / largest, abs=0.001)]
    assert chart["bars"][0] == [1, *bar]
    assert [text for _, text, *_ in chart["bars"]] == [bar[0], "0.00", bar[0]]
    rig.wait(2 * PERIOD)
    caption = rig.state["motion"]["horizontal momentum"]  # what was seen of the hits
    assert ("hits keep it" in caption) == (kind is Cradle)


def test_the_number_of_each_axle_is_above_it_and_in_view(rig):
    highest = max(y for _, y, _ in rig.state["view"]["points"])
    numbers = rig.marks("numbers")
    assert [number.text for number in numbers] == [*"12345"]
    for number, axle in zip(numbers, rig.cradle.axles(), strict=True):
        assert number.pos.x == axle.pos.x
        assert axle.pos.y + axle.height / 2 < number.pos.y < highest


def test_masses_that_differ_are_below_the_bobs_and_heavier_bobs_have_wider_belts(rig):
    assert rig.marks("below") == []
    assert rig.marks("belts") == []
    rig.give("edit", 0, "mass", 3.375)
    rig.give("edit", 1, "mass", 8)
    labels = rig.marks("below")
    assert [label.text for label in labels] == ["3.375 kg", "8 kg", *["1 kg"] * 3]
    bobs = rig.cradle.bobs()
    for label, bob in zip(labels, bobs, strict=True):
        assert label.pos.x == bob.pos.x
        assert bob.radius < bob.pos.y - label.pos.y < 1.5 * bob.radius
    belts = rig.marks("belts")
    for belt, bob, height in zip(belts, bobs[:2], (0.5, 1.0), strict=True):
        assert belt.axis.y == pytest.approx(height * bob.radius)  # a ball's size minus 1
        middle = belt.pos + belt.axis / 2
        assert middle.value == pytest.approx(bob.pos.value)


def test_a_dial_angles_and_speeds_can_be_measured(csv):
    """The marks are behind the outer cords, where a cord at their angle is."""
    rig = Rig(csv, 45)
    rig.give("measure", True)
    axles = rig.cradle.axles()
    angles = []
    for mark in rig.marks("dial"):
        axle = axles[0] if mark.axis.x < 0 else axles[4]
        assert diff_angle(mark.pos - axle.pos, mark.axis) == pytest.approx(0, abs=0.02)
        angles.append(round(degrees(atan2(mark.axis.x, -mark.axis.y))))
    assert angles == [*range(-80, 81, 10)]
    assert [number.text for number in rig.marks("degrees")] == ["60°", "30°", "30°", "60°"]
    rig.wait(0.2 * PERIOD)
    for label, pend in zip(rig.marks("below"), rig.cradle.pend_list, strict=True):
        angle, speed, unit = label.text.split("\n")
        assert angle == f"{abs(degrees(pend['theta'])):.0f}°"
        assert float(speed) == pytest.approx(abs(pend["omega"]) * R_PARAM, abs=0.006)
        assert unit == "m/s"
    rig.give("measure", False)
    assert rig.marks("dial") == rig.marks("degrees") == rig.marks("below") == []
    assert "half swings" not in rig.state["motion"]


def test_half_swings_are_counted_from_the_first_stop_and_again_after_a_drag(csv):
    """A tap moves no bob.

    By the series of the period's elliptic integral, a swing of 45 degrees takes 1.0400 as long as a
    small one.
    """
    rig = Rig(csv, 45)
    rig.give("measure", True)

    def counted():
        count, _, seconds, _ = rig.state["motion"]["half swings"].split()
        return int(count), float(seconds)

    rig.wait(1.8 * PERIOD)
    assert counted() == (3, pytest.approx(1.5 * 1.04 * PERIOD, abs=0.01))
    for pend in rig.cradle.pend_list:
        pend["theta"] = 0.0
        pend["omega"] = 1.0
    rig.viewer.stopwatch.restart(rig.time())
    rig.wait(0.7 * PERIOD)
    assert counted() == (0, 0)
    rig.wait(2 * PERIOD)
    for place, is_kept in ((None, True), (vector(1, 0, 0), False)):
        rig.mouse("grab", rig.cradle.bobs()[4].pos)
        if place:
            rig.mouse("drag", rig.cradle.axles()[4].pos + place)
        rig.give("let_go")
        assert (counted() != (0, 0)) == is_kept


# --- slow hits ------------------------------------------------------------------------------


def wait_for_hit(rig):
    """Wait for a hit; return the rows of its two pendula in the table."""
    while not rig.viewer.slow_hits.current:
        rig.wait(FRAME)
    return rig.state["hits"][-1]["bobs"]


def test_each_hit_waits_in_the_order_of_the_calls(rig):
    """With rings, equal and opposite changes of momentum, and the arrows after the hit."""
    rig.give("slow_hits", True)
    rig.give("arrows", True)
    rig.give("lifted", 2)
    moving = {0, 1}
    for left in (1, 0, 2, 1, 3, 2):
        assert [int(bob["no."]) - 1 for bob in wait_for_hit(rig)] == [left, left + 1]
        places = [bob.pos.x for bob in rig.cradle.bobs()]
        assert [ring.pos.x for ring in rig.marks("rings")] == places[left : left + 2]
        moving ^= {left, left + 1}
        arrows = [arrow.pos.x for arrow in rig.marks("arrows")]
        assert arrows == [places[bob] for bob in sorted(moving)]
        backwards, forwards = [arrow.axis.x for arrow in rig.marks("changes")]
        # Two such bobs have the largest momentum
        assert forwards == pytest.approx(LONGEST_ARROW * R_PARAM / 2, rel=0.01)
        assert backwards == pytest.approx(-forwards)
        time = rig.time()
        rig.wait(1)
        assert rig.time() == time
        rig.give("step")


def test_run_takes_the_rest_into_the_table_and_goes_on_to_the_next_series(rig):
    """Step goes to a first hit, also while paused. While you drag a bob, there is no hit."""
    rig.give("slow_hits", True)
    for left in "14":
        rig.give("pause")
        rig.give("step")
        assert wait_for_hit(rig)[0]["no."] == left
        assert [hit["now"] for hit in rig.state["hits"]] == [True]
        rig.give("pause")
        rig.wait(PERIOD / 8)
        assert [hit["now"] for hit in rig.state["hits"]] == [False] * 4
        assert not rig.marks("rings")
    wait_for_hit(rig)
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    rig.mouse("drag", rig.cradle.axles()[4].pos + vector(1, 0, 0))
    assert rig.state["hits"] == []
    rig.give("restart")  # nobody holds a bob of the new cradle
    rig.wait(0.1)
    assert rig.time() > 0


def test_the_table_has_both_rates_of_double_pendula_and_the_momentum_of_their_bobs(csv):
    rig = Rig(csv, 30, 20, kind=DoubleCradle)
    rig.give("slow_hits", True)
    left, _ = wait_for_hit(rig)
    hit, *_ = rig.viewer.slow_hits.current
    for pend, side in ((hit.before[0], 0), (hit.after[0], -1)):
        v, p = rig.cradle.velocity(pend), momentum([pend], R_PARAM)
        found = [float(text.split()[side]) for text in left.values()]
        assert found == pytest.approx([1, pend["omega"], pend["phi_omega"], v, p], abs=0.006)


def test_slow_hits_say_why_they_are_empty(csv, write):
    """A tick can do without the function that lets two bobs collide."""
    write("make_newton_cradle", "newton_cradle_tick = full_swing_update")
    rig = Rig(csv)
    rig.wait(0.1)
    assert rig.state["remark"] == ""
    rig.give("slow_hits", True)
    why = "The tick does not call handle_two_bobs: there are no hits to show."
    assert rig.state["remark"] == why


# --- dragging --------------------------------------------------------------------------------

# The direction of the view: onto the row, along it, and slanting
AHEAD = (0, 0, -1)
ALONG = (-1, 0, 0)
SLANTING = (-0.3, -0.2, -1)


@pytest.mark.parametrize(("kind", "bob"), [(Cradle, 4), (DoubleCradle, 9)])
def test_a_bob_is_dragged_while_the_time_stands_and_swings_from_there(csv, kind, bob):
    """Also in a slanting view, and where no point in the plane of swing is under the mouse."""
    rig = Rig(csv, *[0] * kind.cord_count, kind=kind)
    pend = rig.cradle.pend_list[4]
    axle = rig.cradle.axles()[4].pos
    bob = rig.cradle.bobs()[bob]
    for key in kind.rate_keys:
        rig.cradle.pend_list[0][key] = pend[key] = 1.0
    rig.mouse("grab", bob.pos + vector(bob.radius / 2, 0, 0), SLANTING)
    time = rig.time()
    first = dict(rig.cradle.pend_list[0])
    rig.mouse("drag", axle + vector(3, -3, 0), SLANTING)  # far away
    rig.mouse("drag", vector(1, 1, 1), ALONG)
    rig.give("pause")
    rig.give("step")
    rig.give("pause")
    rig.wait(0.5)
    assert rig.time() == time
    assert rig.cradle.pend_list[0] == first  # it still moves
    assert rig.bob_angles()[4] == 45
    side = kind.cord_count * R_PARAM / 2**0.5
    assert (bob.pos - axle).value == pytest.approx([side, -side, 0])
    assert rig.state["motion"]["energy"] == "100.0 %"
    assert not any(pend[key] for key in kind.rate_keys)
    rig.give("let_go")
    rig.mouse("drag", axle)
    rig.wait(0.1)
    assert rig.time() > time
    assert rig.bob_angles()[4] < 45


@pytest.mark.parametrize("is_held", [True, False])
def test_while_paused_the_graph_ends_at_the_energy_of_a_bob_that_was_dragged(rig, is_held):
    """Also if it was let go in the same picture. In the graph, this energy is 100 %."""
    rig.give("pause")
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    far = rig.cradle.axles()[4].pos + vector(3, -3, 0)
    rig.tell("drag", far.value, [0, 0, -1])
    if not is_held:
        rig.tell("let_go")
    rig.wait()
    assert rig.bob_angles()[4] == 45
    rig.give("graph", "Energies")
    assert rig.state["curves"]["columns"]["total"] == [100]


@pytest.mark.parametrize(
    ("bob", "radii", "direction", "taken"),
    [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)],
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(
    rig, bob, radii, direction, taken
):
    """A finger may be beside it."""
    rig.give("lifted", 0)
    bob = rig.cradle.bobs()[bob]
    rig.mouse("grab", bob.pos + vector(radii * bob.radius, 0, 0), direction)
    assert rig.viewer.held_bob.index == taken
