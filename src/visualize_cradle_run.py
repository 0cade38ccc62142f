"""Newton's cradle in the browser: collisions, the tick, and the program that shows newton_cradle_pends.csv."""

import os
import sys
from itertools import pairwise
from math import cos
from pathlib import Path

if __name__ == "__main__":  # started as a file, from any folder: the project's own modules are one folder up
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from support.page import end_on_interrupt

    end_on_interrupt()  # the imports below take a moment, in which Ctrl+C would print a traceback

from vpython import mag

from src.special_cradles import make_newton_cradle
from src.swinging import full_swing_update
from support.closed_doors import page_sockets
from support.constants import DT, G, NC_FP, R_PARAM, THETA_INIT
from support.cradle_csv import check_cradle
from support.page import open_page
from support.real_time import keep_real_time


def handle_collision(e, omega1, omega2, m1, m2, r_param) -> tuple[float, float]:
    """Return (new_omega1, new_omega2), the angular velocities (rad/s) of two bobs after they hit.

    e is the coefficient of restitution (0 to 1), omega1 and omega2 (rad/s) are the velocities before, m1 and m2 (kg)
    the masses, r_param (m) the cord length. Handout, appendix (momentum is kept, e is the ratio of the speeds):
        v1_new = (m1 v1 + m2 v2 - m2 e (v1 - v2)) / (m1 + m2)
        v2_new = (m1 v1 + m2 v2 + m1 e (v1 - v2)) / (m1 + m2)
    """
    v1, v2 = r_param * omega1, r_param * omega2
    momentum = m1 * v1 + m2 * v2
    v1_new = (momentum - m2 * e * (v1 - v2)) / (m1 + m2)
    v2_new = (momentum + m1 * e * (v1 - v2)) / (m1 + m2)
    return v1_new / r_param, v2_new / r_param


def handle_two_bobs(pend1, pend2, r_param, approaching_only=False) -> None:
    """Let two neighbouring pendula, pend1 left of pend2, collide if their bobs touch; e is pend1's.

    They touch where their centres are within 1.05 x the sum of the radii. With approaching_only, bobs that touch but
    are on their way apart already are left alone.
    """
    m1, m2 = pend1["mass"], pend2["mass"]
    bob1, bob2 = pend1["objects"][1], pend2["objects"][1]
    omega1, omega2 = pend1["omega"], pend2["omega"]
    if mag(bob1.pos - bob2.pos) > 1.05 * (bob1.radius + bob2.radius):
        return
    # Bobs that touch hang at nearly one angle, side by side: what counts is v along x, r_param omega cos(theta).
    if approaching_only and omega1 * cos(pend1["theta"]) <= omega2 * cos(pend2["theta"]):
        return
    pend1["omega"], pend2["omega"] = handle_collision(pend1["e"], omega1, omega2, m1, m2, r_param)


def newton_cradle_tick(pend_list, r_param, dt, g, approaching_only=False) -> None:
    """Move the whole cradle on by dt (s): swing all pendula, then let each collide with the one to its right."""
    full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in pairwise(pend_list):
        handle_two_bobs(pend1, pend2, r_param, approaching_only)


def main() -> None:
    """Show the cradle of newton_cradle_pends.csv until the tab is closed; status 2 if the file makes no cradle."""
    try:
        check_cradle(NC_FP)  # make_newton_cradle does so too, but by then a browser has been opened
        sockets = page_sockets(int(os.environ.get("VPYTHON_HTTP_PORT", "0")))
    except ValueError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
    with open_page(sockets):
        from support.scenery import add_scenery  # needs VPython's canvas, which all of the above does without

        pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
        add_scenery(pend_list, R_PARAM)
        keep_real_time(lambda: newton_cradle_tick(pend_list, R_PARAM, DT, G, approaching_only=True), DT)


if __name__ == "__main__":
    main()
