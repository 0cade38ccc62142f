"""A tests: the tick, and a cradle that runs by it."""

from math import pi

import pytest
from cradles import components, FIVE_CSV, hang, R, row
from vpython import mag

from src import special_cradles, visualize_cradle_run


def tick(pend_list, r_param=R, dt=1e-6, g=9.81):
    visualize_cradle_run.newton_cradle_tick(pend_list, r_param, dt, g)


def omegas(pend_list):
    return [pend_dict["omega"] for pend_dict in pend_list]


def test_a_tick_swings_all_pendula():
    """newton_cradle_tick updates the swings of all the pendula, with the r_param, dt and g it is given."""
    pend_list = [hang(theta=pi / 6, omega=2.0, axle=(i * 1.0, 0, 0), r_param=0.5) for i in range(3)]
    tick(pend_list, r_param=0.5, dt=0.1, g=10.0)
    assert omegas(pend_list) == pytest.approx([1.0] * 3)
    assert [pend_dict["theta"] for pend_dict in pend_list] == pytest.approx([pi / 6 + 0.1] * 3)


def touching(*speeds, radius=R / 8):
    """Return pendula that hang straight down and touch, with these angular velocities (rad/s)."""
    pend_list = row(len(speeds))
    for pend_dict, omega in zip(pend_list, speeds, strict=True):
        pend_dict["omega"] = omega
        pend_dict["objects"][1].radius = radius
    return pend_list


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ([3.0, 0.0], [0.0, 3.0]),
        ([3.0, 0.0, 0.0], [0.0, 0.0, 3.0]),  # first pair, then second: the hit runs through in one tick
        ([3.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 3.0]),
        ([0.0, 0.0, 3.0], [0.0, 3.0, 0.0]),  # from the right it gets one place along a tick: the pairs are done once
        ([1.0, 2.0, 3.0], [2.0, 3.0, 1.0]),
        ([3.0], [3.0]),  # one pendulum has no pair
        ([], []),
    ],
)
def test_each_pendulum_is_handled_with_the_one_after_it(before, after):
    """For each pendulum (except the last) handle the pairwise interaction of that pendulum and the one after it."""
    pend_list = touching(*before)
    tick(pend_list)
    assert omegas(pend_list) == pytest.approx(after, abs=1e-4)


def test_only_neighbours_are_pairs():
    """Of that pendulum and the one after it: not of any two, even if the bobs are so big that all of them touch."""
    pend_list = touching(1.0, 2.0, 3.0, radius=R / 3)
    tick(pend_list)
    assert omegas(pend_list) == pytest.approx([2.0, 3.0, 1.0], abs=1e-4)


def test_the_pairs_use_masses_and_restitution():
    """The pairwise interaction is handled with a function you already wrote."""
    pend_list = touching(4.0, 0.0, 0.0)
    pend_list[0]["e"], pend_list[1]["mass"], pend_list[2]["mass"] = 0.5, 3.0, 3.0
    tick(pend_list)
    assert omegas(pend_list) == pytest.approx([-0.5, 0.0, 1.5], abs=1e-4)


def test_bobs_that_do_not_touch_are_left_alone():
    """Only bobs that are in collision get new velocities."""
    pend_list = row(3)
    pend_list[0]["omega"] = -1.0
    tick(pend_list)
    assert omegas(pend_list) == pytest.approx([-1.0, 0.0, 0.0], abs=1e-4)


def test_swings_come_before_collisions():
    """A tick updates the swings first: bobs that the swing brings together collide in the same tick."""
    pend_list = row(2)
    pend_list[0]["theta"], pend_list[0]["omega"] = -0.1, 1.0
    tick(pend_list, dt=0.1, g=0.0)  # theta becomes 0 ...
    assert omegas(pend_list) == pytest.approx([1.0, 0.0])  # ... where the bobs hang side by side, just out of reach
    tick(pend_list, dt=0.01, g=0.0)
    assert omegas(pend_list) == pytest.approx([0.0, 1.0])
    assert pend_list[1]["theta"] == 0  # it was hit after its swing


def test_a_cradle_passes_the_swing_on(tmp_path):
    """The simulation: the first bob falls, the last one rises to about the angle from which the first was let go."""
    file = tmp_path / "five.csv"
    file.write_text(FIVE_CSV)
    pend_list = special_cradles.make_newton_cradle(str(file), 0.2, -pi / 4)
    highest = 0.0
    for _ in range(10_000):  # a second, a bit more than it takes
        tick(pend_list, 0.2, 1e-4, 9.81)
        highest = max(highest, pend_list[-1]["theta"])
    assert highest == pytest.approx(pi / 4, rel=0.02)
    for pend_dict in pend_list:
        axle, bob, _ = pend_dict["objects"]
        assert mag(bob.pos - axle.pos) == pytest.approx(0.2)
        assert components(bob.pos)[2] == 0
