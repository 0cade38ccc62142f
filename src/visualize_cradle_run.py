"""Newton's cradle in the browser: collisions, the tick, and the program to play with."""

import sys
from pathlib import Path

if __name__ == "__main__":  # started as a file, from any folder: the project's own modules are one folder up
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from support.interrupt import end_on_interrupt

    end_on_interrupt()  # the imports below take a moment, in which Ctrl+C would print a traceback

# Python 3.9 has no pairwise; support, which comes before, has then said that it is too old.
from heapq import heappop, heappush
from itertools import pairwise
from math import cos, sin, sqrt

from vpython import mag

from src.swinging import angle_update, full_swing_update
from support.constants import BUFFER
from support.options import read_page_options
from support.page import show_cradle
from support.unwritten import end_if_unwritten

LONGEST = 1000  # ticks for which advance_cradle looks ahead, at most


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

    They touch where their centres are within BUFFER (1.05) x the sum of the radii. With approaching_only, bobs that
    touch but are on their way apart already are left alone.
    """
    m1, m2 = pend1["mass"], pend2["mass"]
    bob1, bob2 = pend1["objects"][1], pend2["objects"][1]
    omega1, omega2 = pend1["omega"], pend2["omega"]
    if mag(bob1.pos - bob2.pos) > BUFFER * (bob1.radius + bob2.radius):
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


def advance_cradle(pend_list, r_param, dt, g, ticks, approaching_only=False) -> list[tuple[int, int, int]]:
    """Do what so many calls of newton_cradle_tick do, and return the contacts as (tick, left, right).

    Ticks count from 0, left and right are indices, and a contact is told of where it changes the velocities. This is
    some fifteen times faster, as long as bobs do not cling together: on plain numbers, each pendulum swings by itself
    for as long as its bob cannot touch another (free_ticks), and the objects are set once, at the end.
    tests/project/test_advance.py holds the two ways together, to the last bit.
    """
    thetas, omegas = ([pend_dict[key] for pend_dict in pend_list] for key in ("theta", "omega"))
    axles, bobs = ([pend_dict["objects"][part] for pend_dict in pend_list] for part in (0, 1))
    axle_places = [(axle.pos.x, axle.pos.y, axle.pos.z) for axle in axles]
    bob_places = list(axle_places)  # as of the first swing
    reaches = [BUFFER * (bob1.radius + bob2.radius) for bob1, bob2 in pairwise(bobs)]
    swung = [0] * len(pend_list)  # how many ticks each pendulum has swung
    looks = {0: list(range(len(reaches)))}  # tick -> which pairs, named by their left pendulum, to look at in it
    look_ticks = [0]  # the keys of looks, as a heap
    due = [0] * len(pend_list)  # the tick in which a pair is to be looked at; the last pendulum, or -1, has no pair
    contacts = []

    def swing(i, until):
        """Let a pendulum swing until it has done so many ticks."""
        omega, theta = omegas[i], thetas[i]
        for _ in range(until - swung[i]):
            omega, theta = angle_update(omega, theta, r_param, dt, g)
        omegas[i], thetas[i], swung[i] = omega, theta, until
        x, y, z = axle_places[i]
        bob_places[i] = x + r_param * sin(theta), y - r_param * cos(theta), z

    def plan(left, tick):
        """Look at this pair in this tick, and not in the one that was planned before."""
        due[left] = tick
        if tick not in looks:
            looks[tick] = []
            heappush(look_ticks, tick)
        looks[tick].append(left)

    while look_ticks and look_ticks[0] < ticks:
        tick = heappop(look_ticks)
        for left in sorted(looks.pop(tick)):
            if due[left] != tick:
                continue
            right, free = left + 1, 0
            if swung[left] <= tick:
                swing(left, tick + 1)
            if swung[right] <= tick:
                swing(right, tick + 1)
            (x1, y1, z1), (x2, y2, z2) = bob_places[left], bob_places[right]
            distance = sqrt((x1 - x2) ** 2 + (y1 - y2) ** 2 + (z1 - z2) ** 2)
            theta1, theta2, omega1, omega2 = thetas[left], thetas[right], omegas[left], omegas[right]
            if distance > reaches[left]:
                free = free_ticks(distance - reaches[left], theta1, theta2, omega1, omega2, r_param, dt, g)
            elif not approaching_only or omega1 * cos(theta1) > omega2 * cos(theta2):
                e, m1, m2 = pend_list[left]["e"], pend_list[left]["mass"], pend_list[right]["mass"]
                omegas[left], omegas[right] = handle_collision(e, omega1, omega2, m1, m2, r_param)
                if (omegas[left], omegas[right]) != (omega1, omega2):
                    contacts.append((tick, left, right))
                    if due[left - 1] > tick + 1:  # the plan was made with another velocity
                        plan(left - 1, tick + 1)
                    if due[right] > tick + 1:
                        plan(right, tick + 1)
            plan(left, tick + 1 + free)

    if ticks:
        for i, pend_dict in enumerate(pend_list):
            swing(i, ticks)
            pend_dict["theta"], pend_dict["omega"] = thetas[i], omegas[i]
        full_swing_update(pend_list, r_param, 0, g)  # no time passes, but all are shown where they are now
    return contacts


def free_ticks(gap, theta1, theta2, omega1, omega2, r_param, dt, g) -> int:
    """Return for how many ticks two bobs that are gap (m) out of each other's reach cannot come into it.

    theta1, theta2 (rad), omega1, omega2 (rad/s) are those of the two, r_param (m), dt (s) and g (m/s^2) the cradle's.
    Since |sin a - sin b| <= |a - b|, the two omegas differ during a time T, with k = g / R, by at most
        d_omega = (|omega1 - omega2| + k T |theta1 - theta2|) / (1 - k T^2),
    and so the thetas by at most d_theta = |theta1 - theta2| + d_omega T. In the same way the bobs approach each other
    with at most R (d_omega + (omega + k T) d_theta), omega being the smaller one. T is a tenth of sqrt(R / g) here.
    """
    k = abs(g / r_param)
    most = int(min(LONGEST, 0.1 / sqrt(k) / abs(dt))) if k * dt else LONGEST
    span = most * abs(dt)
    d_omega = (abs(omega1 - omega2) + k * span * abs(theta1 - theta2)) / (1 - k * span**2)
    d_theta = abs(theta1 - theta2) + d_omega * span
    speed = d_omega + (min(abs(omega1), abs(omega2)) + k * span) * d_theta
    closer = abs(r_param) * speed * span  # m, after the whole span
    sure = gap - 1e-9 * abs(r_param)  # m, whatever rounding errors do
    if sure <= 0:
        return 0
    return most if closer <= sure else int(most * sure / closer)


def main() -> None:
    """Show a cradle in the browser until the tab is closed; status 2 if an option or the CSV is refused, or a
    function is not written yet.
    """
    from src.live_cradle import LiveCradle  # only here: the functions above do without it, and all that it brings

    options = read_page_options()
    end_if_unwritten("pds_helper", "special_cradles", "swinging", "visualize_cradle_run")
    show_cradle(LiveCradle(advance_cradle, options), options, [options.angle])


if __name__ == "__main__":
    main()
