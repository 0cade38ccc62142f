"""swing_update, which the handout provides."""

from math import cos, pi, sin

import pytest
from whole_cradles import components

from grading.cradles import hang, R
from src import swinging


def test_swing_update_updates_the_dictionary():
    """swing_update updates the angle, using the helper function angle_update."""
    pend_dict = hang(theta=pi / 6, omega=2.0, axle=(0.3, 0.1, 0), r_param=0.5)
    swinging.swing_update(pend_dict, 0.5, 0.1, 10.0)
    assert (pend_dict["omega"], pend_dict["theta"]) == pytest.approx((1.0, pi / 6 + 0.1))


def test_swing_update_moves_bob_and_cord():
    """swing_update updates the position of the pendulum components: the axle stays, the cord ends at axle and bob."""
    pend_dict = hang(theta=pi / 6, omega=2.0, axle=(0.3, 0.1, 0), r_param=0.5)
    axle, bob, cord = objects = pend_dict["objects"]
    swinging.swing_update(pend_dict, 0.5, 0.1, 10.0)
    theta = pi / 6 + 0.1
    axle_end, bob_end = (0.3, 0.1, 0.0), (0.3 + 0.5 * sin(theta), 0.1 - 0.5 * cos(theta), 0.0)
    assert pend_dict["objects"] is objects or tuple(pend_dict["objects"]) == objects
    assert components(axle.pos) == pytest.approx(axle_end)
    assert components(bob.pos) == pytest.approx(bob_end, abs=1e-12)
    ends = sorted([components(cord.pos), components(cord.pos + cord.axis)])  # a student may draw it from either end
    assert ends[0] == pytest.approx(min(axle_end, bob_end), abs=1e-12)
    assert ends[1] == pytest.approx(max(axle_end, bob_end), abs=1e-12)


def test_swing_update_leaves_everything_else():
    """The pend_dict is updated and nothing is returned."""
    pend_dict = hang(theta=0.4, omega=1.0, mass=2.0, e=0.5)
    before = {name: pend_dict[name] for name in ("mass", "e", "color", "texture")}
    assert swinging.swing_update(pend_dict, R, 0.01, 9.81) is None
    assert {name: pend_dict[name] for name in before} == before
