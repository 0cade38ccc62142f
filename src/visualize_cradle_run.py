"""Newton's cradle in the browser: collisions, the tick, and the program to play with."""

if __name__ == "__main__":
    import begin_page

from itertools import pairwise
from math import cos

from vpython import mag

from src.special_cradles import make_newton_cradle
from src.swinging import full_swing_update
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.main_page import Page


def handle_collision(e, omega1, omega2, m1, m2, r_param) -> tuple[float, float]:
    """Return (new_omega1, new_omega2), the angular velocities (rad/s) of two bobs after a hit.

    e is the coefficient of restitution (0 to 1), omega1 and omega2 (rad/s) are the velocities
    before, m1 and m2 (kg) the masses, r_param (m) the cord length. Handout, appendix (a hit keeps
    the momentum; the bobs part at e times the speed of their approach):
        v1_new = (m1 v1 + m2 v2 - m2 e (v1 - v2)) / (m1 + m2)
        v2_new = (m1 v1 + m2 v2 + m1 e (v1 - v2)) / (m1 + m2)
    """
    v1, v2 = r_param * omega1, r_param * omega2
    momentum = m1 * v1 + m2 * v2
    v1_new = (momentum - m2 * e * (v1 - v2)) / (m1 + m2)
    v2_new = (momentum + m1 * e * (v1 - v2)) / (m1 + m2)
    return v1_new / r_param, v2_new / r_param


def handle_two_bobs(pend1, pend2, r_param, approaching_only=False) -> None:
    """Let two neighbouring pendula, pend1 left of pend2, collide if their bobs touch.

    They touch if the distance of their centres is at most 1.05 times the sum of their radii. The
    coefficient of restitution is pend1's.

    With approaching_only, touching bobs that move apart do not collide.
    """
    m1, m2 = pend1["mass"], pend2["mass"]
    bob1, bob2 = pend1["objects"][1], pend2["objects"][1]
    omega1, omega2 = pend1["omega"], pend2["omega"]
    e = pend1["e"]
    if mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius):
        # Touching bobs hang side by side, at nearly the same angle. So compare their velocities
        # along x, r_param omega cos(theta).
        are_separating = omega1 * cos(pend1["theta"]) <= omega2 * cos(pend2["theta"])
        if approaching_only and are_separating:
            return
        pend1["omega"], pend2["omega"] = handle_collision(e, omega1, omega2, m1, m2, r_param)


def newton_cradle_tick(pend_list, r_param, dt, g, approaching_only=False) -> None:
    """Advance the whole cradle by dt (s).

    This swings all pendula, then lets each one collide with its right neighbour.
    """
    full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in pairwise(pend_list):
        if approaching_only:
            handle_two_bobs(pend1, pend2, r_param, approaching_only=True)
        else:  # the handout's call, which a student's function can take as well
            handle_two_bobs(pend1, pend2, r_param)


def main(page: Page) -> None:
    """Make the cradle, show it, and let it tick until the page stops it.

    page shows the cradle, in the browser or in the terminal, and says when to tick. The program
    calls main again for each new cradle.
    """
    pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
    page.show(pend_list)
    while page.is_running():  # in step with the clock, until the page wants another cradle
        newton_cradle_tick(pend_list, R_PARAM, DT, G, **page.rule)


if __name__ == "__main__":
    from src import special_cradles
    from support.cradle import many_ticks
    from support.page.show_cradle import show_cradle

    show_cradle(main, special_cradles, many_ticks)
