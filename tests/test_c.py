"""C tests: how one pendulum swings, and then all of them."""

from math import cos, pi, sin

import pytest
from cradles import components, hang, R, row

from src import swinging

# omega, theta, r_param, dt, g -> omega_new, theta_new; by hand from the appendix's two formulas.
STEPS = [
    (2.0, pi / 6, 0.5, 0.1, 10.0, 1.0, pi / 6 + 0.1),  # omega falls by 10 * 0.5 / 0.5 * 0.1 = 1
    (2.0, -pi / 6, 0.5, 0.1, 10.0, 3.0, -pi / 6 + 0.3),  # to the left of straight down it pulls the other way
    (0.0, pi / 2, 2.0, 0.01, 9.8, -0.049, pi / 2 - 0.00049),  # from rest, with the whole of g
    (1.5, 0.0, 0.2, 0.01, 9.81, 1.5, 0.015),  # straight down nothing pulls
    (0.0, 0.0, 0.2, 0.01, 9.81, 0.0, 0.0),  # at rest it stays
    (1.0, pi, 0.3, 0.5, 9.81, 1.0, pi + 0.5),  # straight up nothing pulls either
    (-1.0, 5 * pi / 6, 0.25, 0.2, 5.0, -3.0, 5 * pi / 6 - 0.6),  # more than 90 degrees: sin, not the angle itself
    (1.0, pi / 6, 0.5, 0.0, 10.0, 1.0, pi / 6),  # no time, no change
    (1.0, pi / 6, 0.5, 0.1, 0.0, 1.0, pi / 6 + 0.1),  # no gravity: the angle moves on by itself
]


@pytest.mark.parametrize(("omega", "theta", "r_param", "dt", "g", "omega_new", "theta_new"), STEPS)
def test_angle_update(omega, theta, r_param, dt, g, omega_new, theta_new):
    """angle_update returns a tuple of the new (omega, theta): omega by gravity, then theta by the new omega."""
    result = swinging.angle_update(omega, theta, r_param, dt, g)
    assert isinstance(result, tuple)
    assert result == pytest.approx((omega_new, theta_new), abs=1e-12)


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
    ends = sorted([components(cord.pos), components(cord.pos + cord.axis)])  # it may be drawn from either end
    assert ends[0] == pytest.approx(min(axle_end, bob_end), abs=1e-12)
    assert ends[1] == pytest.approx(max(axle_end, bob_end), abs=1e-12)


def test_swing_update_leaves_everything_else():
    """The pend_dict is updated and nothing is returned."""
    pend_dict = hang(theta=0.4, omega=1.0, mass=2.0, e=0.5)
    before = {name: pend_dict[name] for name in ("mass", "e", "color", "texture")}
    assert swinging.swing_update(pend_dict, R, 0.01, 9.81) is None
    assert {name: pend_dict[name] for name in before} == before


def test_full_swing_update_swings_every_pendulum_once():
    """full_swing_update uses the helper function swing_update on each pendulum in the Newton's cradle."""
    thetas, omegas = (pi / 6, -pi / 6, pi / 2, 0.0), (2.0, 2.0, 0.0, 1.5)
    pend_list = [
        hang(theta=theta, omega=omega, axle=(i * 0.1, 0, 0), r_param=0.5)
        for i, (theta, omega) in enumerate(zip(thetas, omegas, strict=True))
    ]
    swinging.full_swing_update(pend_list, 0.5, 0.1, 10.0)
    assert [pend["omega"] for pend in pend_list] == pytest.approx([1.0, 3.0, -2.0, 1.5])
    assert [pend["theta"] for pend in pend_list] == pytest.approx([pi / 6 + 0.1, -pi / 6 + 0.3, pi / 2 - 0.2, 0.15])
    for i, pend in enumerate(pend_list):
        expected = (i * 0.1 + 0.5 * sin(pend["theta"]), -0.5 * cos(pend["theta"]), 0)
        assert components(pend["objects"][1].pos) == pytest.approx(expected, abs=1e-12)


def test_full_swing_update_is_no_collision():
    """A swing alone leaves bobs that overlap to the collision functions."""
    pend_list = row(3, omega=0.0)
    for pend_dict, omega in zip(pend_list, (1.0, -1.0, 0.5), strict=True):
        pend_dict["omega"] = omega
    swinging.full_swing_update(pend_list, R, 1e-9, 9.81)
    assert [pend_dict["omega"] for pend_dict in pend_list] == pytest.approx([1.0, -1.0, 0.5])


@pytest.mark.parametrize("count", [0, 1])
def test_full_swing_update_of_few_pendula(count):
    """A cradle may have any number of pendula."""
    pend_list = row(count, theta=pi / 2)
    swinging.full_swing_update(pend_list, R, 0.1, 10.0)
    assert [pend_dict["omega"] for pend_dict in pend_list] == pytest.approx([-2.5] * count)
