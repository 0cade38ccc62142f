"""Newton's cradle in the browser: collisions, the tick, and the program to play with."""

import sys
from itertools import pairwise
from math import cos, sin, sqrt
from pathlib import Path

if __name__ == "__main__":  # started as a file, from any folder: the project's own modules are one folder up
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from support.page import end_on_interrupt

    end_on_interrupt()  # the imports below take a moment, in which Ctrl+C would print a traceback

from vpython import mag

from src.live_cradle import LiveCradle
from src.swinging import angle_update, full_swing_update
from support.closed_doors import page_sockets
from support.cradle_csv import check_cradle
from support.live_file import LiveFile
from support.options import check_lift, read_options
from support.page import open_page


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


def advance_cradle(pend_list, r_param, dt, g, ticks, approaching_only=False) -> list[tuple[int, int]]:
    """Do what so many calls of newton_cradle_tick do, and return the contacts as (tick, index of the left bob).

    Ticks count from 0, and a contact is told of where it changes the velocities. The ticks are done on plain numbers,
    and shown at the end, which is five times faster; tests/test_advance.py holds the two ways together.
    """
    thetas, omegas = ([pend_dict[key] for pend_dict in pend_list] for key in ("theta", "omega"))
    axles = [pend_dict["objects"][0].pos for pend_dict in pend_list]
    axle_places = [(pos.x, pos.y) for pos in axles]
    pairs = []  # for two neighbours each: index of the left one, reach, depth (z), e, masses
    for left, (pend1, pend2) in enumerate(pairwise(pend_list)):
        reach = 1.05 * (pend1["objects"][1].radius + pend2["objects"][1].radius)
        depth = axles[left].z - axles[left + 1].z
        pairs.append((left, reach, depth, pend1["e"], pend1["mass"], pend2["mass"]))

    contacts = []
    for tick in range(ticks):
        for i, theta in enumerate(thetas):
            omegas[i], thetas[i] = angle_update(omegas[i], theta, r_param, dt, g)
        places = [
            (x + r_param * sin(theta), y - r_param * cos(theta))
            for (x, y), theta in zip(axle_places, thetas, strict=True)
        ]
        for left, reach, depth, e, m1, m2 in pairs:
            (x1, y1), (x2, y2) = places[left], places[left + 1]
            if sqrt((x1 - x2) ** 2 + (y1 - y2) ** 2 + depth**2) > reach:
                continue
            omega1, omega2 = omegas[left], omegas[left + 1]
            if approaching_only and omega1 * cos(thetas[left]) <= omega2 * cos(thetas[left + 1]):
                continue
            omegas[left], omegas[left + 1] = handle_collision(e, omega1, omega2, m1, m2, r_param)
            if omegas[left] != omega1:
                contacts.append((tick, left))

    if ticks:
        for pend_dict, theta, omega in zip(pend_list, thetas, omegas, strict=True):
            pend_dict["theta"], pend_dict["omega"] = theta, omega
        full_swing_update(pend_list, r_param, 0, g)  # no time passes, but all are shown where they are now
    return contacts


def main() -> None:
    """Show a cradle in the browser until the tab is closed; status 2 if an option or the CSV is refused."""
    options = read_options(
        "Newton's cradle in the browser, to play with. Save its CSV, and the page shows the new one."
    )
    file = LiveFile(options.csv)
    try:
        check_cradle(file.current)  # the viewer does so too, but by then a browser has been opened
        check_lift(options.lift, file.current)
        sockets = page_sockets(options.port)
    except ValueError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
    with open_page(sockets, options.browser):
        from support.viewer import Viewer  # needs VPython's canvas and widgets, which all of the above does without

        Viewer(LiveCradle(advance_cradle, options), file, [options.angle], options.lift).run()


if __name__ == "__main__":
    main()
