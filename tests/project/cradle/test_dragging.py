"""A dragged bob follows the mouse, and pushes those in its way."""

from itertools import pairwise
from math import pi, sin

import pytest
from whole_cradles import check_places, distances, hang_double

from grading.cradles import hang_row, R
from support.cradle.dragging import drag_bob, drag_pendulum
from support.pendulum import cord_angles


@pytest.mark.parametrize("held", range(5))
@pytest.mark.parametrize("theta", [-1.5, -0.3, -1e-4, 1e-4, 0.3, 1.5])
def test_a_dragged_bob_pushes_those_in_its_way(held, theta):
    """Pushed bobs just touch, at rest; the others swing on.

    So do all if the bob moves less than the gap.
    """
    pend_list = hang_row(5, omega=2.0)
    if abs(theta) < 1:  # far up, a smaller bob slips past
        pend_list[4]["objects"][1].radius *= 0.9
    drag_pendulum(pend_list, held, [theta], R)
    assert pend_list[held]["theta"] == pytest.approx(theta)
    pushed = {i for i in range(5) if abs(theta) > 0.01 and (i - held) * theta > 0}
    for i, pend in enumerate(pend_list):
        check_places(pend, (i * R / 4, 0), R)
        if i in pushed | {held}:
            assert pend["theta"] * theta > 0
            assert pend["omega"] == 0
        else:
            assert pend["theta"] == 0
            assert pend["omega"] == 2
    for left, pair in enumerate(pairwise(pend_list)):
        [distance] = distances(pair)
        assert distance > 1
        if pushed & {left, left + 1}:
            assert distance < 1 + 1e-6


def test_a_dragged_bob_goes_the_short_way_over_the_top():
    first, second = pend_list = hang_row(2)
    first["theta"] = 3.0
    drag_pendulum(pend_list, 0, [-3.0], R)
    assert first["theta"] == pytest.approx(2 * pi - 3.0)
    assert second["theta"] == 0  # it was not in the way


def double_row(count, phi=0.0):
    """Return double pendula R / 4 apart that move; their upper cords hang straight down."""
    return [
        hang_double(phi=phi, axle=(i * R / 4, 0), omega=2.0, phi_omega=-1.0, r_param=R)
        for i in range(count)
    ]


@pytest.mark.parametrize("phi", [0.3, -0.3, 6.0, -6.0, 0.0, 2 * pi])
@pytest.mark.parametrize(("x", "y"), [(0.3, -0.4), (-0.3, -0.2), (0.1, 0.5), (-0.05, -0.05)])
def test_a_lower_bob_follows_the_mouse_and_its_cords_bend_to_the_same_side_as_before(x, y, phi):
    """Straight cords bend so that the upper bob hangs lower than the line to the mouse."""
    [pend] = pend_list = double_row(1, phi)
    drag_bob(pend_list, 0, 1, x, y, R)
    assert pend["objects"][3].pos.value == pytest.approx([x, y, 0])
    check_places(pend, (0, 0), R)
    bend = sin(phi) if phi % (2 * pi) else x
    assert sin(pend["phi"]) * bend > 0


def test_a_bob_stops_if_those_in_its_way_have_no_room():
    """The neighbour's upper bob is stuck between the two bobs of the dragged pendulum.

    A dragged upper bob leaves the direction of its lower cord.
    """
    pend_list = double_row(5)
    for held, bob, x, y in [(3, 0, 0.57, 0.17), (3, 1, -0.27, 0.03)]:
        drag_bob(pend_list, held, bob, x, y, R)
        assert min(distances(pend_list)) > 0.999
        assert bob == 1 or cord_angles(pend_list[held])[1] == pytest.approx(0)
