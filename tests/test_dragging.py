"""A bob that is dragged pushes its neighbours aside, and they theirs."""

from itertools import combinations, pairwise
from math import cos, pi, sin

import pytest
from cradles import components, R, row
from vpython import mag

from src.dragging import drag_pendulum


def drag(pend_list, held, theta):
    """Drag the held pendulum to theta in one go; return where all are then."""
    drag_pendulum(pend_list, held, theta, R)
    return [pend["theta"] for pend in pend_list]


def gaps(pend_list):
    """Return how far each pair of neighbouring bobs is apart, 1 being where they begin to collide."""
    bobs = [pend["objects"][1] for pend in pend_list]
    return [mag(b.pos - a.pos) / (1.05 * (a.radius + b.radius)) for a, b in pairwise(bobs)]


@pytest.mark.parametrize("held", range(5))
@pytest.mark.parametrize("theta", [-1.5, -1.0, -0.3, -0.001, 0.001, 0.3, 1.0, 1.5])
def test_those_in_its_way_go_along_and_the_others_stay(held, theta):
    """The thetas stay in order from left to right, no bob reaches into another, and pushed ones just touch."""
    pend_list = row(5)
    thetas = drag(pend_list, held, theta)
    assert thetas[held] == pytest.approx(theta)
    for i, other in enumerate(thetas):
        in_the_way = i > held if theta > 0 else i < held
        if i != held:
            assert (other != 0) == in_the_way or abs(theta) < 0.01  # they hang a little apart
    assert all(gap > 1 for gap in gaps(pend_list))
    if abs(theta) > 0.01:
        pushed = [gap for i, gap in enumerate(gaps(pend_list)) if (i >= held if theta > 0 else i < held)]
        assert pushed == pytest.approx([1] * len(pushed), abs=1e-6)


def test_the_pushed_rest_and_are_shown_where_they_are():
    pend_list = row(3, omega=2.0)
    drag(pend_list, 0, 0.8)
    for pend in pend_list[1:]:
        axle, bob, cord = pend["objects"]
        arm = (R * sin(pend["theta"]), -R * cos(pend["theta"]), 0)
        assert pend["omega"] == 0
        assert components(bob.pos - axle.pos) == pytest.approx(arm)
        assert components(cord.axis) == pytest.approx(arm)


def test_those_out_of_its_way_swing_on():
    pend_list = row(3, omega=2.0)
    drag(pend_list, 1, -0.8)
    assert [pend["omega"] for pend in pend_list] == [0.0, 0.0, 2.0]


def test_larger_bobs_are_pushed_further():
    small, large = row(2), row(2)
    large[1]["objects"][1].radius *= 2
    assert drag(large, 0, 0.5)[1] > drag(small, 0, 0.5)[1] > 0.49
    assert gaps(large) == pytest.approx([1], abs=1e-6)


def test_a_bob_that_hangs_elsewhere_is_not_pushed():
    """The held one is lifted to the left, away from its neighbour, and on over its axle."""
    assert drag(row(2), 0, -3.0) == pytest.approx([-3.0, 0])


def test_it_goes_the_short_way_round():
    """From one side of the top to the other the mouse crosses it; the neighbours below are not touched."""
    pend_list = row(3)
    pend_list[1]["theta"] = 3.0
    assert drag(pend_list, 1, -3.0) == pytest.approx([0, 2 * pi - 3.0, 0])


def test_there_and_back_leaves_the_pushed_where_they_were_pushed_to():
    pend_list = row(2)
    there = drag(pend_list, 0, 0.6)
    assert drag(pend_list, 0, 0.0) == pytest.approx([0.0, there[1]])


def test_a_bob_that_comes_round_over_the_top_pushes_the_others_from_their_other_side():
    """The first one, dragged up on the left, over its axle and down on the right, meets the last one first."""
    pend_list = row(3)
    for theta in (-2.0, -3.1, 2.2, 1.0, 0.5):
        before = [pend["theta"] for pend in pend_list]
        after = drag(pend_list, 0, theta)
        assert all(gap > 1 for gap in gaps_of_all(pend_list))
        assert all(abs(new - old) < 1 for new, old in zip(after[1:], before[1:], strict=True))
    assert after[1] < 0  # pushed on to the left


def gaps_of_all(pend_list):
    """Return how far each two bobs are apart, 1 being where they begin to collide."""
    return [gaps(list(pair))[0] for pair in combinations(pend_list, 2)]
