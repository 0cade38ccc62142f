"""The programs' rule that only approaching bobs collide: handle_two_bobs and newton_cradle_tick, approaching_only=True.

By default both are the handout's to the letter; tests/test_b.py and test_a.py hold them to that.
"""

from math import cos, pi

import pytest
from cradles import hang, R, row

from src.visualize_cradle_run import handle_two_bobs, newton_cradle_tick
from support.constants import DT, G

RADIUS = 1.01 * R / 8  # bobs of this radius touch when they hang side by side


def touching(theta, omega1, omega2):
    """Return two pendula, side by side at one angle, that touch."""
    pair = hang(theta, omega1), hang(theta, omega2, axle=(R / 4, 0, 0))
    for pend in pair:
        pend["objects"][1].radius = RADIUS
    return pair


@pytest.mark.parametrize(
    ("theta", "omega1", "omega2", "collide"),
    [
        (0.0, 1.0, 0.0, True),
        (0.0, 0.0, -1.0, True),
        (0.0, 2.0, 1.0, True),
        (0.0, 0.0, 1.0, False),
        (0.0, -2.0, 1.0, False),
        (0.0, 1.0, 1.0, False),
        (1.2, 1.0, 0.0, True),
        (-1.2, 1.0, 0.0, True),
        (2.5, 1.0, 0.0, False),  # above the axle a bob with positive omega moves to the left ...
        (2.5, 0.0, 1.0, True),
        (-2.5, 0.0, 1.0, True),
        (pi, 1.0, 0.0, False),
    ],
)
def test_only_approaching_bobs_collide(theta, omega1, omega2, collide):
    pend1, pend2 = touching(theta, omega1, omega2)
    handle_two_bobs(pend1, pend2, R, approaching_only=True)
    assert (pend1["omega"], pend2["omega"]) == pytest.approx((omega2, omega1) if collide else (omega1, omega2))


def test_bobs_out_of_reach_do_not_collide():
    pend1, pend2 = hang(omega=1.0), hang(axle=(R, 0, 0))
    handle_two_bobs(pend1, pend2, R, approaching_only=True)
    assert (pend1["omega"], pend2["omega"]) == (1.0, 0.0)


def energy(pend_list):
    """Return the energy (J) of pendula with 1 kg bobs and cords of R."""
    return sum((R * pend["omega"]) ** 2 / 2 + G * R * (1 - cos(pend["theta"])) for pend in pend_list)


def tick_until_a_hit(pair):
    """Tick until the difference of the velocities (rad/s) jumps, as gravity alone cannot make it do."""
    while True:
        before = pair[0]["omega"] - pair[1]["omega"]
        newton_cradle_tick(pair, R, DT, G, approaching_only=True)
        if abs(pair[0]["omega"] - pair[1]["omega"] - before) > 0.01:
            return


@pytest.mark.parametrize(("e", "hits"), [(0.9, 6), (0.5, 3), (0.0, 1)])
def test_energy_after_hits_of_two_equal_bobs(e, hits):
    """It is 1/2 + e**(2 k) / 2 of the start after k hits: half is in the common motion, which hits do not change."""
    pair = hang(-0.5, e=e), hang(e=e, axle=(R / 4, 0, 0))
    at_start = energy(pair)
    for k in range(1, hits + 1):
        tick_until_a_hit(pair)
        assert energy(pair) / at_start == pytest.approx(0.5 + e ** (2 * k) / 2, rel=0.005)


def test_an_elastic_cradle_keeps_its_energy():
    """Five equal bobs, ten seconds, energy within 0.1 %."""
    pend_list = row(5)
    pend_list[0]["theta"] = -0.5
    at_start = energy(pend_list)
    for _ in range(round(10 / DT)):
        newton_cradle_tick(pend_list, R, DT, G, approaching_only=True)
    assert energy(pend_list) == pytest.approx(at_start, rel=0.001)
