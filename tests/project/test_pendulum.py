"""The objects that make_pendulum makes."""

from math import cos, sin

import pytest
from vpython import color, mag, textures, vector
from whole_cradles import components

from grading.cradles import row
from support.pendulum import make_pendulum


@pytest.mark.parametrize("theta", [0.0, 0.7, -0.7, 2.0])
@pytest.mark.parametrize("r_param", [0.2, 1.5])
def test_the_bob_hangs_from_the_axle_at_theta(r_param, theta):
    """theta is positive to the right; the cord goes from the centre of the axle to that of the bob."""
    axle, bob, cord = make_pendulum(vector(0.3, 0.1, 0), r_param, theta, color.red, textures.wood)
    arm = (r_param * sin(theta), -r_param * cos(theta), 0)
    assert components(axle.pos) == components(cord.pos) == (0.3, 0.1, 0)
    assert components(bob.pos - axle.pos) == pytest.approx(arm)
    assert components(cord.axis) == pytest.approx(arm)
    assert (components(bob.color), bob.texture) == ((1, 0, 0), textures.wood)


def test_all_sizes_go_with_the_cord():
    small, large = (make_pendulum(vector(0, 0, 0), r_param, 0, color.red, None) for r_param in (0.2, 2.0))
    assert [10 * shape.height for shape in small] == pytest.approx([shape.height for shape in large])
    axle, bob, cord = small
    assert cord.radius < axle.height < bob.radius < axle.width


def test_the_cords_up_is_square_to_the_swing():
    """Otherwise, VPython computes it at each change of the axis, and that takes four times as long."""
    cord = make_pendulum(vector(0, 0, 0), 0.2, 0.7, color.red, None)[2]
    assert components(cord.up) == (0, 0, 1)


def test_bobs_at_rest_are_just_out_of_reach():
    left, right = (pend_dict["objects"][1] for pend_dict in row(2))
    reach, distance = 1.05 * (left.radius + right.radius), mag(right.pos - left.pos)
    assert 0.999 * distance < reach < distance
