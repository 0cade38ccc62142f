"""The double Newton's cradle: each of its elements is a double pendulum, a second one hung from the first one's bob.

Words
    theta       the upper cord's angle from straight down (rad), omega its rate (rad/s); both positive to the right
    phi         the lower cord's angle from the direction of the upper one (rad), phi_omega its rate (rad/s)
    alpha, beta the angles of the two cords from straight down, alpha = theta and beta = theta + phi
    m1, m2      the masses of the upper and the lower bob (kg); R the length of each cord (m); ' is d/dt

Swing
    The upper bob moves with the velocity R alpha' along its arc, and the lower one with R beta' along its own on top of
    that; beta - alpha = phi is the angle between the two. So by the law of cosines the energies are
        T = (m1 + m2) R^2 alpha'^2 / 2  +  m2 R^2 beta'^2 / 2  +  m2 R^2 alpha' beta' cos(phi)
        V = -(m1 + m2) g R cos(alpha)  -  m2 g R cos(beta)
    Lagrange's equations are d/dt dL/dq' = dL/dq with L = T - V, for q = alpha and for q = beta. For alpha
        dL/dalpha' = (m1 + m2) R^2 alpha' + m2 R^2 beta' cos(phi)
        dL/dalpha  = m2 R^2 alpha' beta' sin(phi) - (m1 + m2) g R sin(alpha)
    and d/dt cos(phi) = -sin(phi) (beta' - alpha'), so that what has alpha' beta' in it cancels; for beta likewise. What
    is left, divided by (m1 + m2) R^2 and by m2 R^2, and with mu = m2 / (m1 + m2), is
        alpha''           + mu cos(phi) beta'' =  mu sin(phi) beta'^2 - g/R sin(alpha)
        cos(phi) alpha''  +             beta'' =    - sin(phi) alpha'^2 - g/R sin(beta)
    two linear equations for alpha'' and beta'' (double_accelerations). Source of L: Landau and Lifshitz, Mechanics,
    section 5, problem 1, with both lengths R.

    The motion is chaotic, and semi-implicit Euler, whose error goes with dt, would not keep the energy to 1e-6; so a
    tick is a step of the classical Runge-Kutta method, whose error goes with dt^4. It needs four accelerations instead
    of one, no memory of the ticks before, in which there may have been a hit, and no equation to be solved.

Hit
    A hit is over in no time, so gravity does nothing in it, and the cords' pulls do no work. What counts is the impulse
    p that the two bobs give each other along the unit vector n from one centre to the other. Let q = (alpha, beta). A
    bob's velocity along n is v = J q', where
        J = R (n.a, 0)    for an upper bob,    a = (cos(alpha), sin(alpha)),
        J = R (n.a, n.b)  for a lower bob,     b = (cos(beta), sin(beta)),
    since a and b are the directions in which the ends of the cords move. The momenta that belong to q are
        dT/dq' = M q'  with  M = R^2 ( m1 + m2      m2 cos(phi) )
                                     ( m2 cos(phi)  m2          )
    and Lagrange's equations, integrated over the hit, say that an impulse p along n adds p J to them. So q' jumps by
    p M^-1 J, and v by p w with w = J M^-1 J: M^-1 is how a bob's cords hand part of the impulse on to the other bob.

    With n from pendulum 1 to pendulum 2, the one gets -p and the other p: v1 falls by p w1, v2 grows by p w2. If they
    approach at u = v1 - v2,
        p = (1 + e) u / (w1 + w2)
    makes v2 - v1 = e u. The energy changes by -p u + p^2 (w1 + w2) / 2 = -(1 - e^2) u^2 / (w1 + w2) / 2: not at all if
    e = 1, and never up.
"""

from itertools import islice
from math import cos, hypot, sin
from typing import NamedTuple

from vpython import box, cylinder, sphere, vector

from src.pds_helper import extract_and_convert
from src.special_cradles import axle_place, looks
from support.constants import BUFFER
from support.cradle_csv import check_cradle
from support.pendulum import DoublePendulumEntry, make_bob_and_cord, make_pendulum

# Of the distance at which bobs touch: bobs that lie on one another are not to sink in deeper than the first, and bobs
# that are closer than the second have been put there (a start can do so) and are left to themselves.
CLOSEST, PUT_THERE = 0.98, 0.95

ROUNDING = 1e-9  # m/s: bobs that approach or separate more slowly than that do so by rounding errors

# How often the touching pairs of a tick are gone through, at most: a hit may make another pair approach.
SWEEPS = 3


def make_double_pendulum(
    axle_pos, r_param, theta, phi, color, texture
) -> tuple[box, sphere, cylinder, sphere, cylinder]:
    """Return the VPython objects (axle, bob1, cord1, bob2, cord2) of a double pendulum that hangs from axle_pos.

    axle_pos is a vector (m), r_param the length of each cord (m), theta and phi the angles (rad), color a VPython color
    (a vector), and texture a VPython texture or None.
    """
    axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
    bob2, cord2 = make_bob_and_cord(bob1.pos, r_param, theta + phi, color, texture)
    return axle, bob1, cord1, bob2, cord2


def make_double_newton_cradle(relative_filepath, r_param, theta_init, phi_init) -> list[DoublePendulumEntry]:
    """Return the pend_list of a CSV as double pendula: with theta, omega, phi, phi_omega and their five objects.

    The first one is lifted to theta_init and phi_init (rad), the others hang straight down; all are at rest. A row's
    mass is that of each of its two bobs, r_param the length of each cord (m). Raises a ValueError of one line, before
    any object is made, if the CSV makes no cradle.
    """
    check_cradle(relative_filepath)
    pend_list: list = extract_and_convert(relative_filepath)
    for i, pend_dict in enumerate(pend_list):
        theta, phi = (theta_init, phi_init) if i == 0 else (0, 0)
        pend_dict["theta"], pend_dict["phi"] = theta, phi
        pend_dict["omega"] = pend_dict["phi_omega"] = 0
        pend_dict["objects"] = make_double_pendulum(axle_place(i, r_param), r_param, theta, phi, *looks(pend_dict))
    return pend_list


# --- swing -----------------------------------------------------------------------------------------------------------


def double_accelerations(alpha, beta, alpha_rate, beta_rate, k, mu) -> tuple[float, float]:
    """Return alpha'' and beta'' (rad/s^2), from the two equations above.

    alpha and beta are in rad, their rates in rad/s, k = g/R in 1/s^2, and mu = m2/(m1 + m2) is a number.
    """
    s, c = sin(beta - alpha), cos(beta - alpha)
    right1 = mu * s * beta_rate * beta_rate - k * sin(alpha)
    right2 = -s * alpha_rate * alpha_rate - k * sin(beta)
    determinant = 1 - mu * c * c
    return (right1 - mu * c * right2) / determinant, (right2 - c * right1) / determinant


def double_angle_update(omega_theta, omega_phi, theta, phi, r_param, dt, g, m1=1.0, m2=1.0):
    """Return (omega_theta, omega_phi, theta, phi) of a double pendulum after dt (s), in rad/s and rad.

    The first four are the values before, r_param (m) is the length of each cord, g (m/s^2) the gravitational
    acceleration, m1 and m2 (kg) the masses of the upper and the lower bob. One step of the classical Runge-Kutta
    method: the average of four rates, taken at the beginning, twice in the middle (1 : 2 : 2 : 1), and at the end.
    """
    k, mu, half = g / r_param, m2 / (m1 + m2), dt / 2
    a, b, u, v = theta, theta + phi, omega_theta, omega_theta + omega_phi  # alpha, beta, and their rates
    du, dv = double_accelerations(a, b, u, v, k, mu)
    u2, v2 = u + half * du, v + half * dv
    du2, dv2 = double_accelerations(a + half * u, b + half * v, u2, v2, k, mu)
    u3, v3 = u + half * du2, v + half * dv2
    du3, dv3 = double_accelerations(a + half * u2, b + half * v2, u3, v3, k, mu)
    u4, v4 = u + dt * du3, v + dt * dv3
    du4, dv4 = double_accelerations(a + dt * u3, b + dt * v3, u4, v4, k, mu)
    a_new = a + dt / 6 * (u + 2 * (u2 + u3) + u4)
    b_new = b + dt / 6 * (v + 2 * (v2 + v3) + v4)
    u_new = u + dt / 6 * (du + 2 * (du2 + du3) + du4)
    v_new = v + dt / 6 * (dv + 2 * (dv2 + dv3) + dv4)
    return u_new, v_new - u_new, a_new, b_new - a_new


def swing_numbers(pend_dict, r_param, dt, g) -> None:
    """Swing one double pendulum for dt (s): update its omega, phi_omega, theta and phi."""
    mass, omega, phi_omega = pend_dict["mass"], pend_dict["omega"], pend_dict["phi_omega"]
    pend_dict["omega"], pend_dict["phi_omega"], pend_dict["theta"], pend_dict["phi"] = double_angle_update(
        omega, phi_omega, pend_dict["theta"], pend_dict["phi"], r_param, dt, g, mass, mass
    )


def show_double_pendulum(pend_dict, r_param) -> None:
    """Move the bobs and cords of a double pendulum to where its theta and phi are."""
    alpha, beta = pend_dict["theta"], pend_dict["theta"] + pend_dict["phi"]
    axle, bob1, cord1, bob2, cord2 = pend_dict["objects"]
    cord1.axis = vector(r_param * sin(alpha), -r_param * cos(alpha), 0)
    cord2.axis = vector(r_param * sin(beta), -r_param * cos(beta), 0)
    bob1.pos = cord2.pos = axle.pos + cord1.axis
    bob2.pos = bob1.pos + cord2.axis


def double_swing_update(pend_dict, r_param, dt, g) -> None:
    """Swing one double pendulum for dt (s): update its angles and their rates, and move its bobs and cords there."""
    swing_numbers(pend_dict, r_param, dt, g)
    show_double_pendulum(pend_dict, r_param)


# --- hits ------------------------------------------------------------------------------------------------------------


def bob_places(pend_dict, r_param) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return x and y (m) of the upper and of the lower bob, from theta and phi."""
    alpha, beta = pend_dict["theta"], pend_dict["theta"] + pend_dict["phi"]
    axle = pend_dict["objects"][0].pos
    x, y = axle.x + r_param * sin(alpha), axle.y - r_param * cos(alpha)
    return (x, y), (x + r_param * sin(beta), y - r_param * cos(beta))


class Touch(NamedTuple):
    """Two bobs that touch, one of each of two double pendula: 0 is the upper one, 1 the lower one."""

    bob1: int
    bob2: int
    x: float  # the unit vector from bob1 to bob2
    y: float
    distance: float  # between the centres (m)
    touching: float  # up to which they touch (m): BUFFER (1.05) x the sum of the radii


def touching_bobs(pend1, pend2, r_param):
    """Yield a Touch for each two bobs of the two double pendula that touch.

    Where the bobs are is told by theta and phi; VPython's objects only show them.
    """
    places1, places2 = bob_places(pend1, r_param), bob_places(pend2, r_param)
    radii1, radii2 = ([bob.radius for bob in pend["objects"][1::2]] for pend in (pend1, pend2))
    for bob1, (x1, y1) in enumerate(places1):
        for bob2, (x2, y2) in enumerate(places2):
            distance, touching = hypot(x2 - x1, y2 - y1), BUFFER * (radii1[bob1] + radii2[bob2])
            if 0 < distance <= touching:
                yield Touch(bob1, bob2, (x2 - x1) / distance, (y2 - y1) / distance, distance, touching)


def response(pend_dict, bob, touch, r_param) -> tuple[float, float, float, float]:
    """Return v, w and M^-1 J, as they are above, of a bob (0 or 1) of a double pendulum in the direction of a touch.

    They are the bob's velocity (m/s), how much an impulse of 1 N s changes it (m/s), and how much that changes alpha'
    and beta' (rad/s).
    """
    alpha, beta = pend_dict["theta"], pend_dict["theta"] + pend_dict["phi"]
    alpha_rate, beta_rate = pend_dict["omega"], pend_dict["omega"] + pend_dict["phi_omega"]
    j1 = r_param * (touch.x * cos(alpha) + touch.y * sin(alpha))
    j2 = r_param * (touch.x * cos(beta) + touch.y * sin(beta)) if bob == 1 else 0.0
    c = cos(beta - alpha)
    determinant = pend_dict["mass"] * r_param**2 * (2 - c * c)  # of M / m, m being the mass of each of the two bobs
    turn1, turn2 = (j1 - c * j2) / determinant, (2 * j2 - c * j1) / determinant
    return j1 * alpha_rate + j2 * beta_rate, j1 * turn1 + j2 * turn2, turn1, turn2


def turn_cords(pend_dict, upper, lower, turn1, turn2) -> None:
    """Add turn1 and turn2 to alpha and beta, or to their rates: to what upper and lower are the keys for."""
    pend_dict[upper] += turn1
    pend_dict[lower] += turn2 - turn1


def handle_two_double_bobs(pend1, pend2, r_param, approaching_only=True) -> bool:
    """Let two double pendula, pend1 left of pend2, collide where their bobs touch; e is pend1's.

    Each bob of the one may touch each of the other. With approaching_only (here the default, as the handout has no rule
    for double pendula), bobs that touch but are on their way apart already are left alone. Return whether any collided.
    """
    collided = False
    for touch in touching_bobs(pend1, pend2, r_param):
        v1, w1, *turns1 = response(pend1, touch.bob1, touch, r_param)
        v2, w2, *turns2 = response(pend2, touch.bob2, touch, r_param)
        approach = v1 - v2
        if approach > ROUNDING or (approach < -ROUNDING and not approaching_only):
            impulse = (1 + pend1["e"]) * approach / (w1 + w2)
            turn_cords(pend1, "omega", "phi_omega", *(-impulse * turn for turn in turns1))
            turn_cords(pend2, "omega", "phi_omega", *(impulse * turn for turn in turns2))
            collided = True
    return collided


def keep_apart(pend1, pend2, r_param) -> None:
    """Move bobs of two double pendula that are a little closer than CLOSEST apart to there.

    Bobs with e below 1 may come to lie on one another. Each tick then presses them a little way in; the impulse at its
    end takes the speed of that, but leaves them there, and in time they would pass through each other. The cords turn
    in the proportions in which an impulse between the two bobs would make them. Nobody does the work of this: it can
    add some 1e-5 of the energy at DOUBLE_DT, but 1e-3 with ticks of 1 ms, in which hits get deeper than CLOSEST too.
    """
    held_by_cords = 0.01 * (1 / pend1["mass"] + 1 / pend2["mass"])  # a hundredth of w1 + w2 without cords
    for touch in touching_bobs(pend1, pend2, r_param):
        _, w1, *turns1 = response(pend1, touch.bob1, touch, r_param)
        _, w2, *turns2 = response(pend2, touch.bob2, touch, r_param)
        if PUT_THERE < touch.distance / touch.touching < CLOSEST and w1 + w2 > held_by_cords:
            push = (CLOSEST * touch.touching - touch.distance) / (w1 + w2)
            turn_cords(pend1, "theta", "phi", *(-push * turn for turn in turns1))
            turn_cords(pend2, "theta", "phi", *(push * turn for turn in turns2))


# --- the cradle ------------------------------------------------------------------------------------------------------


def double_cradle_tick(pend_list, r_param, dt, g, approaching_only=True) -> None:
    """Move the whole cradle on by dt (s): swing all double pendula, then let those collide whose bobs touch.

    The pairs are handled from left to right. Not only neighbours are pairs: a lower bob gets past its neighbour's cord,
    to the bobs behind it. With approaching_only they are gone through again as long as any collide, up to SWEEPS times.
    In the end, pairs that have collided with e below 1 are kept apart.
    """
    advance_double_cradle(pend_list, r_param, dt, g, 1, approaching_only)


def advance_double_cradle(pend_list, r_param, dt, g, ticks, approaching_only=True) -> list[tuple[int, int, int]]:
    """Do what so many calls of double_cradle_tick do; return the hits as (tick, left, right), indices of pendula.

    Ticks count from 0. VPython's objects are moved once, at the end.
    """
    hits = []
    for tick in range(ticks):
        for pend_dict in pend_list:
            swing_numbers(pend_dict, r_param, dt, g)
        hits += [(tick, *pair) for pair in collide_pairs(pend_list, r_param, approaching_only)]
    for pend_dict in pend_list:
        show_double_pendulum(pend_dict, r_param)
    return hits


def collide_pairs(pend_list, r_param, approaching_only) -> list[tuple[int, int]]:
    """Let double pendula whose bobs touch collide, as double_cradle_tick says; return who did, as (left, right)."""
    pairs = touching_pairs(pend_list, r_param)
    hits: list[tuple[int, int]] = []
    for _ in range(SWEEPS if approaching_only else 1):
        sweep = [
            (left, right)
            for left, right in pairs
            if handle_two_double_bobs(pend_list[left], pend_list[right], r_param, approaching_only)
        ]
        if not sweep:
            break
        hits += sweep
    for left, right in sorted(set(hits)):
        if pend_list[left]["e"] < 1:
            keep_apart(pend_list[left], pend_list[right], r_param)
    return hits


def touching_pairs(pend_list, r_param) -> list[tuple[int, int]]:
    """Return the indices (left, right) of each two double pendula whose bobs touch, from left to right.

    To compare few, the bobs are sorted by x: those that touch are no further apart along x than the largest two could.
    """
    bobs = sorted(
        (x, y, i, bob.radius)
        for i, pend_dict in enumerate(pend_list)
        for (x, y), bob in zip(bob_places(pend_dict, r_param), pend_dict["objects"][1::2], strict=True)
    )
    furthest = 2 * BUFFER * max((radius for *_, radius in bobs), default=0)
    pairs = set()
    for number, (x1, y1, i, radius1) in enumerate(bobs, start=1):
        for x2, y2, j, radius2 in islice(bobs, number, None):
            if x2 - x1 > furthest:
                break
            if i != j and hypot(x2 - x1, y2 - y1) <= BUFFER * (radius1 + radius2):
                pairs.add((min(i, j), max(i, j)))
    return sorted(pairs)
