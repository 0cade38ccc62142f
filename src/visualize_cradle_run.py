"""Newton's cradle in the browser: collisions, one time step (a tick), and the program."""

# This opens the page. The page then runs this file from its top, once for each new cradle.
if __name__ == "__main__":
    import begin_page

from itertools import pairwise

from vpython import mag

from src.special_cradles import make_newton_cradle
from src.swinging import full_swing_update
from support.constants import DT, G, NC_FP, R_PARAM, THETA_INIT
from support.pendulum import PendulumEntry
from support.simulation import is_running


def handle_collision(
    e: float, omega1: float, omega2: float, m1: float, m2: float, r_param: float
) -> tuple[float, float]:
    """Return (new_omega1, new_omega2), the angular velocities (rad/s) of two bobs after a hit.

    e is the coefficient of restitution (0 to 1), omega1 and omega2 (rad/s) are the velocities
    before, m1 and m2 (kg) the masses, r_param (m) the cord length.
    """
    # The momentum stays the same, and the bobs separate at e times the speed at which they
    # approached (Newton's law of restitution): two equations for the two new velocities.
    v1, v2 = r_param * omega1, r_param * omega2
    momentum = m1 * v1 + m2 * v2
    v1_new = (momentum - m2 * e * (v1 - v2)) / (m1 + m2)
    v2_new = (momentum + m1 * e * (v1 - v2)) / (m1 + m2)
    return v1_new / r_param, v2_new / r_param


def handle_two_bobs(pend1: PendulumEntry, pend2: PendulumEntry, r_param: float) -> None:
    """Let two neighbouring pendula collide if their bobs touch.

    They touch if the distance of their centres is at most 1.05 times the sum of their radii. The
    coefficient of restitution is pend1's.
    """
    m1, m2 = pend1["mass"], pend2["mass"]
    bob1, bob2 = pend1["objects"][1], pend2["objects"][1]
    omega1, omega2 = pend1["omega"], pend2["omega"]
    e = pend1["e"]
    if mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius):
        pend1["omega"], pend2["omega"] = handle_collision(e, omega1, omega2, m1, m2, r_param)


def newton_cradle_tick(pend_list: list[PendulumEntry], r_param: float, dt: float, g: float) -> None:
    """Advance the whole cradle by dt (s).

    This swings all pendula, then lets each one collide with its right neighbour.
    """
    full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in pairwise(pend_list):  # the first and the second, the second and the third
        handle_two_bobs(pend1, pend2, r_param)


if __name__ == "__main__":
    pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
    # is_running shows the pendula, and waits until a tick is due.
    while is_running(pend_list):
        newton_cradle_tick(pend_list, R_PARAM, DT, G)
