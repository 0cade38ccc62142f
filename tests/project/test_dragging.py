"""A dragged bob pushes its neighbours aside, and they push theirs."""

import random
from itertools import pairwise
from math import asin, cos, hypot, pi, remainder, sin

import pytest
from vpython import mag
from whole_cradles import components, distances, hang_double

from grading.cradles import hang, R, row
from src.beyond.dragging import cord_angles, drag_bob, drag_pendulum, touching_angle


def drag(pend_list, held, theta):
    """Drag the held pendulum to theta in one step; return the thetas of all pendula."""
    drag_pendulum(pend_list, held, [theta], R)
    return [pend["theta"] for pend in pend_list]


def gaps(pend_list):
    """Return the distance of each pair of neighbouring bobs; at 1, they collide."""
    bobs = [pend["objects"][1] for pend in pend_list]
    return [mag(b.pos - a.pos) / (1.05 * (a.radius + b.radius)) for a, b in pairwise(bobs)]


@pytest.mark.parametrize("held", range(5))
@pytest.mark.parametrize("theta", [-1.5, -1.0, -0.3, -0.001, 0.001, 0.3, 1.0, 1.5])
def test_those_in_its_way_go_along_and_the_others_stay(held, theta):
    """The thetas stay in order from left to right, no bobs overlap, and pushed bobs just touch."""
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
    """The held bob goes to the left, away from its neighbour, and on over its axle."""
    assert drag(row(2), 0, -3.0) == pytest.approx([-3.0, 0])


def test_a_bob_on_the_axle_of_another_pendulum_is_out_of_its_reach():
    """There is no direction and no angle to the axle."""
    pend, other = row(2)
    other["objects"][1].pos = pend["objects"][0].pos
    assert touching_angle(pend, 0, other["objects"][1], R) is None


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize("turns", [-2, 0, 1])
def test_it_touches_where_the_law_of_cosines_says(side, turns):
    """By hand: two axles in one place, equal cords, D = 2 R sin(delta / 2)."""
    pend, other = hang(0.5 + 0.01 * side + 2 * pi * turns), hang(0.5)["objects"][1]
    delta = 2 * asin(1.05 * 2 * other.radius / (2 * R))
    angle = touching_angle(pend, 0, other, R)
    assert remainder(angle, 2 * pi) == pytest.approx(0.5 + side * delta)
    pend["theta"] = 0.5 + side * (delta - 1e-6)
    assert touching_angle(pend, 0, other, R) == pytest.approx(angle)
    pend["theta"] = 0.5 + side * (delta + 1e-6)
    assert touching_angle(pend, 0, other, R) is None


def test_it_goes_the_short_way_round():
    """The mouse crosses the top from one side to the other; the neighbours below stay."""
    pend_list = row(3)
    pend_list[1]["theta"] = 3.0
    assert drag(pend_list, 1, -3.0) == pytest.approx([0, 2 * pi - 3.0, 0])


def test_there_and_back_leaves_the_pushed_where_they_were_pushed_to():
    pend_list = row(2)
    there = drag(pend_list, 0, 0.6)
    assert drag(pend_list, 0, 0.0) == pytest.approx([0.0, there[1]])


def test_a_bob_that_comes_round_over_the_top_pushes_the_others_from_their_other_side():
    """A person drags the first bob up on the left, over its axle and down on the right: it meets the last bob first."""
    pend_list = row(3)
    for theta in (-2.0, -3.1, 2.2, 1.0, 0.5):
        before = [pend["theta"] for pend in pend_list]
        after = drag(pend_list, 0, theta)
        assert all(gap > 1 for gap in distances(pend_list))
        assert all(abs(new - old) < 1 for new, old in zip(after[1:], before[1:], strict=True))
    assert after[1] < 0  # pushed on to the left


def test_a_bob_that_is_dragged_to_where_it_is_moves_nobody():
    assert drag(row(2), 0, 0.0) == [0, 0]


def test_a_bob_that_has_been_round_is_pushed_from_its_side():
    pend_list = row(2)
    pend_list[1]["theta"] = -2 * pi
    assert sin(drag(pend_list, 0, 0.5)[1]) > 0.4


# --- double pendula --------------------------------------------------------------------------------------------------


def double_row(count):
    """Return double pendula that hang straight down, R / 4 apart, and move."""
    return [hang_double(axle=(i * R / 4, 0), omega=2.0, phi_omega=-1.0, r_param=R) for i in range(count)]


def test_an_upper_bob_leaves_the_direction_of_the_lower_cord():
    pend_list = double_row(1)
    pend_list[0]["phi"] = 0.5
    drag_bob(pend_list, 0, 0, 1.0, -1.0, R)
    assert cord_angles(pend_list[0]) == pytest.approx([pi / 4, 0.5])
    assert (pend_list[0]["omega"], pend_list[0]["phi_omega"]) == (0, 0)


@pytest.mark.parametrize("phi", [0.3, -0.3, 6.0, -6.0])
@pytest.mark.parametrize(("x", "y"), [(0.3, -0.4), (-0.3, -0.2), (0.1, 0.5), (-0.05, -0.05)])
def test_a_lower_bob_follows_the_mouse_and_its_cords_bend_to_the_same_side_as_before(x, y, phi):
    pend_list = double_row(1)
    pend_list[0]["phi"] = phi
    drag_bob(pend_list, 0, 1, x, y, R)
    _, upper, _, lower, _ = pend_list[0]["objects"]
    assert components(lower.pos) == pytest.approx((x, y, 0))
    assert hypot(upper.pos.x, upper.pos.y) == pytest.approx(R)
    assert (sin(pend_list[0]["phi"]) > 0) == (sin(phi) > 0)


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize("turns", [0, 1])
def test_straight_cords_bend_so_that_the_upper_bob_hangs_lower(side, turns):
    """To the left and to the right; also after full turns of the lower cord."""
    pend_list = double_row(1)
    pend_list[0]["phi"] = 2 * pi * turns
    drag_bob(pend_list, 0, 1, side * 0.5, -0.3, R)
    upper, lower = cord_angles(pend_list[0])
    assert 0 < side * upper < pi / 2 < side * sin(lower) + pi / 2
    assert components(pend_list[0]["objects"][3].pos) == pytest.approx((side * 0.5, -0.3, 0))
    assert side * sin(lower - upper) > 0


def test_a_lower_bob_is_stretched_to_where_it_is_nearest():
    pend_list = double_row(1)
    drag_bob(pend_list, 0, 1, 3.0, -4.0, R)
    assert components(pend_list[0]["objects"][3].pos) == pytest.approx((1.2 * R, -1.6 * R, 0))


def test_a_lower_cord_that_turns_alone_does_not_get_past_its_neighbour():
    pend_list = double_row(2)
    drag_bob(pend_list, 0, 1, R * sin(2.0), -R - R * cos(2.0), R)
    assert pend_list[1]["omega"] == 0  # a bob pushed it
    assert min(distances(pend_list)) > 1


def test_a_lower_bob_gives_way_to_the_side_on_which_its_own_cord_is():
    pend = hang_double(1.0, -1.0, r_param=R)
    other = hang(0.2, axle=components(pend["objects"][1].pos))["objects"][1]
    assert touching_angle(pend, 1, other, R) == pytest.approx(-0.05, abs=0.01)


@pytest.mark.parametrize("bob", [0, 1])
@pytest.mark.parametrize("held", range(4))
@pytest.mark.parametrize(("x", "y"), [(0.5, -0.6), (-0.5, -0.6), (0.3, -0.3), (-0.2, -0.5)])
def test_both_bobs_push_those_in_their_way(held, bob, x, y):
    pend_list = double_row(4)
    axle = pend_list[held]["objects"][0].pos
    drag_bob(pend_list, held, bob, axle.x + x, axle.y + y, R)
    assert min(distances(pend_list)) > 1
    moved = [pend["omega"] == 0 for pend in pend_list]
    assert any(moved[:held] if x < 0 else moved[held + 1 :]) == (held != (0 if x < 0 else 3))


def test_a_bob_stops_where_there_is_no_room_for_those_in_its_way():
    """The neighbour's upper bob is stuck between the two bobs of the dragged pendulum."""
    for seed in (26, 47, 55, 57):  # without a stop, bobs overlap at the end
        dice, pend_list = random.Random(seed), double_row(5)
        for _ in range(12):
            held, bob = dice.randrange(5), dice.randrange(2)
            drag_bob(pend_list, held, bob, dice.uniform(-1, 1), dice.uniform(-0.8, 0.2), R)
            assert min(distances(pend_list)) > 0.999


def test_where_there_is_no_room_all_stay_where_they_were(monkeypatch):
    """It does not jump to the next free place, and the other pendula swing on."""
    pend_list, room = double_row(3), iter([False, *[True] * 99])
    monkeypatch.setattr("src.beyond.dragging.push_others", lambda *_: next(room))
    drag_bob(pend_list, 0, 0, 0.3, -0.3, R)
    assert [cord_angles(pend) for pend in pend_list] == [[0, 0]] * 3
    assert [pend["omega"] for pend in pend_list] == [0, 2, 2]
