"""A cradle in motion: its data, and what a screen reader says."""

from math import radians

import pytest
from vpython import cylinder, mag2
from whole_cradles import PERIOD, velocities

from grading.cradles import MIXED_CSV
from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.motion import digits_for, signed


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_a_sample_has_all_figures_of_the_moment_by_their_names(swing, kind):
    """The energies and the momentum are sums over the bobs of three unequal pendula."""
    player = swing(MIXED_CSV, kind=kind)
    ticks = round(PERIOD / kind.dt)  # until all bobs move
    player.swing(ticks)
    pend_list = player.cradle.pend_list
    expected = {"t": ticks * kind.dt}
    for key in (*kind.angle_keys, *kind.rate_keys):
        for i, pend in enumerate(pend_list, start=1):
            expected[f"{key}_{i}"] = pend[key]
    kinetic = potential = momentum = 0.0
    for pend in pend_list:
        axle, *bobs = (part.pos.y for part in pend["objects"] if type(part) is not cylinder)
        for cords, (y, v) in enumerate(zip(bobs, velocities(pend), strict=True), start=1):
            kinetic += pend["mass"] * mag2(v) / 2
            potential += pend["mass"] * G * (y - axle + cords * R_PARAM)
            momentum += pend["mass"] * v.x
    total = kinetic + potential
    expected |= {"kinetic": kinetic, "potential": potential, "total": total, "momentum": momentum}
    sample = player.motion.sample()
    assert sample == pytest.approx(expected, rel=1e-12)
    assert list(sample) == list(expected)


def test_the_summary_names_the_farthest_bobs_at_their_angle(swing):
    motion = swing().motion
    assert motion.summary() == "bob 1 at 30 degrees left"
    _, second, third, *_ = motion.cradle.pend_list
    second["theta"] = radians(360 * 3 + 50)  # it has gone round three times
    third["theta"] = radians(48)
    assert motion.summary() == "bobs 2, 3 at 50 degrees right"


@pytest.mark.parametrize(
    ("largest", "number", "text"),
    [
        (0.51, -0.0049, "0.00"),
        (0.045, 0.0049, "+0.0049"),
    ],
)
def test_speeds_and_momenta_have_digits_for_the_largest_one(largest, number, text):
    assert signed(number, digits_for(largest)) == text
