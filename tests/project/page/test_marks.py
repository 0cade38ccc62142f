"""What is drawn on the cradle: arrows, numbers, masses, and a dial."""

from math import atan2, degrees

import pytest
from rig import Rig
from vpython import diff_angle
from whole_cradles import GOOD, HEADER, PERIOD, velocities

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_velocities(csv, kind):
    """Also of a later cradle, with fewer bobs."""
    rig = Rig(csv, *[30] * kind.cord_count, kind=kind)
    rig.give("arrows", True)
    rig.save(HEADER + GOOD * 2)
    rig.give("restart")
    rig.wait(0.15)  # the first pendulum is on its way to the second one
    moves = velocities(rig.cradle.pend_list[0])
    arrows = rig.marks("arrows")
    assert len(arrows) == len(moves)
    for arrow, bob, velocity in zip(arrows, rig.cradle.bobs(), moves, strict=False):
        assert arrow.pos.x == bob.pos.x
        assert arrow.axis.value == pytest.approx((PERIOD / 20 * velocity).value)


def test_the_number_of_each_axle_is_above_it_and_in_view(rig):
    highest = max(y for _, y, _ in rig.state["view"]["points"])
    numbers = rig.marks("numbers")
    assert [number.text for number in numbers] == [*"12345"]
    for number, axle in zip(numbers, rig.cradle.axles(), strict=True):
        assert number.pos.x == axle.pos.x
        assert axle.pos.y + axle.height / 2 < number.pos.y < highest


def test_masses_that_differ_are_below_the_bobs_and_heavier_bobs_have_wider_belts(rig):
    assert rig.marks("below") == rig.marks("belts") == []
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
    first, *_ = rig.cradle.pend_list
    angle, speed, unit = rig.marks("below")[0].text.split("\n")
    assert angle == f"{abs(degrees(first['theta'])):.0f}°"
    assert float(speed) == pytest.approx(abs(first["omega"]) * R_PARAM, abs=0.006)
    assert unit == "m/s"
