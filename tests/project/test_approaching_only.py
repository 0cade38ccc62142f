"""The programs' rule that only approaching bobs collide: handle_two_bobs with approaching_only=True.

By default, handle_two_bobs follows the handout to the letter; tests/test_b.py tests that. test_physics.py tests whole
cradles with both rules.
"""

from math import pi

import pytest

from grading.cradles import hang, R
from src.visualize_cradle_run import handle_two_bobs

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
        (2.5, 1.0, 0.0, False),  # above the axle, a bob with positive omega moves to the left ...
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
