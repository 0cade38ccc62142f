"""The collisions of the double cradle: the bobs that touch, and their velocities after a hit.

theta, phi, alpha, beta, m1, m2, R and the kinetic energy T mean the same as in
src/double_cradle.py; x' is the rate of x, dx/dt.

Hit
    A hit takes no time: gravity changes nothing, and the pull of the cords does no work. The two
    bobs exchange an impulse p along n, the unit vector from one centre to the other. Let q =
    (alpha, beta). A bob's velocity along n is v = J q', where
        J = R (n.a, 0)    for an upper bob,    a = (cos(alpha), sin(alpha)),
        J = R (n.a, n.b)  for a lower bob,     b = (cos(beta), sin(beta)),
    because the ends of the cords move in the directions a and b. The momenta conjugate to q are
        dT/dq' = M q'  with  M = R^2 ( m1 + m2      m2 cos(phi) )
                                     ( m2 cos(phi)  m2          )
    By Lagrange's equations, integrated over the hit, an impulse p along n adds p J to these
    momenta. So q' changes by p M^-1 J, and v by p w with w = J M^-1 J. Through M^-1, the cords pass
    part of the impulse on to the other bob of the same pendulum.

    Let n point from pendulum 1 to pendulum 2. Pendulum 1 gets -p, pendulum 2 gets p: v1 falls by p
    w1, v2 grows by p w2. If the bobs approach at u = v1 - v2 before the hit, the impulse
        p = (1 + e) u / (w1 + w2)
    makes v2 - v1 = e u after it. The energy changes by -p u + p^2 (w1 + w2) / 2 = -(1 - e^2) u^2 /
    (w1 + w2) / 2. With e = 1 it stays the same, and it never grows.
"""

from collections.abc import Iterator
from itertools import islice
from math import cos, hypot, sin
from typing import NamedTuple

from support.pendulum import contact_distance, DoublePendulumEntry

# Distances, as fractions of the largest distance at which bobs touch. keep_apart pushes resting
# bobs out to CLOSEST. Bobs closer than OVERLAPPED_AT_START already overlapped when the cradle was
# made: keep_apart does not move them.
CLOSEST = 0.98
OVERLAPPED_AT_START = 0.95

ROUNDING = 1e-9  # m/s: a slower approach or separation is a rounding error

# One hit can push a bob towards another. So a tick looks at the touching pairs at most this many
# times.
SWEEPS = 3


class Bob(NamedTuple):
    """The place of a bob, and its radius (m)."""

    x: float
    y: float
    radius: float


class Response(NamedTuple):
    """How a bob of a double pendulum moves along a line, and answers to an impulse along it."""

    v: float  # the bob's velocity (m/s)
    # What an impulse of 1 N s adds to v (m/s), to alpha' and to beta' (rad/s): the last two are
    # M^-1 J (see above).
    w: float
    turn1: float
    turn2: float


class Touch(NamedTuple):
    """Two touching bobs."""

    distance: float  # m, between their centres
    most: float  # m: the largest distance at which they touch
    # Along the line from the first bob to the second
    response1: Response
    response2: Response


def bobs_of(pend_dict: DoublePendulumEntry, r_param: float) -> tuple[Bob, Bob]:
    """Return the upper and the lower bob, where theta and phi say that they are."""
    alpha = pend_dict["theta"]
    beta = alpha + pend_dict["phi"]
    axle, bob1, _, bob2, _ = pend_dict["objects"]  # type: ignore[misc]
    x = axle.pos.x + r_param * sin(alpha)
    y = axle.pos.y - r_param * cos(alpha)
    upper = Bob(x, y, bob1.radius)
    return upper, Bob(x + r_param * sin(beta), y - r_param * cos(beta), bob2.radius)


def touching_bobs(
    pend1: DoublePendulumEntry, pend2: DoublePendulumEntry, r_param: float
) -> Iterator[Touch]:
    """Yield each touch of two bobs, one of pend1 and one of pend2.

    The places of the bobs follow from theta and phi; VPython's objects only show them. All places
    are those before the first touch; each response is that of its moment, after the hits before it.
    """
    bobs1 = bobs_of(pend1, r_param)
    bobs2 = bobs_of(pend2, r_param)
    for number1, bob1 in enumerate(bobs1):
        for number2, bob2 in enumerate(bobs2):
            distance = hypot(bob2.x - bob1.x, bob2.y - bob1.y)
            most = contact_distance(bob1.radius, bob2.radius)
            if 0 < distance <= most:
                x = (bob2.x - bob1.x) / distance
                y = (bob2.y - bob1.y) / distance
                response1 = response_of(pend1, number1, x, y, r_param)
                response2 = response_of(pend2, number2, x, y, r_param)
                yield Touch(distance, most, response1, response2)


def response_of(
    pend_dict: DoublePendulumEntry, bob: int, x: float, y: float, r_param: float
) -> Response:
    """Return the response of a bob (0 upper, 1 lower) along the unit vector (x, y)."""
    alpha = pend_dict["theta"]
    beta = alpha + pend_dict["phi"]
    alpha_rate = pend_dict["omega"]
    beta_rate = alpha_rate + pend_dict["phi_omega"]
    j1 = r_param * (x * cos(alpha) + y * sin(alpha))
    j2 = r_param * (x * cos(beta) + y * sin(beta)) if bob == 1 else 0.0
    c = cos(beta - alpha)
    # Both bobs have the mass m. So M^-1 = (1 -c) / divisor
    #                                      (-c 2)
    divisor = pend_dict["mass"] * r_param**2 * (2 - c * c)
    turn1 = (j1 - c * j2) / divisor
    turn2 = (2 * j2 - c * j1) / divisor
    return Response(j1 * alpha_rate + j2 * beta_rate, j1 * turn1 + j2 * turn2, turn1, turn2)


def change_rates(pend_dict: DoublePendulumEntry, impulse: float, response: Response) -> None:
    """Add to the rates of a pendulum's cords what an impulse (N s) adds to alpha' and beta'."""
    turn1 = impulse * response.turn1
    pend_dict["omega"] += turn1
    pend_dict["phi_omega"] += impulse * response.turn2 - turn1


def turn_cords(pend_dict: DoublePendulumEntry, push: float, response: Response) -> None:
    """Turn a pendulum's cords in the ratio in which an impulse changes their rates."""
    turn1 = push * response.turn1
    pend_dict["theta"] += turn1
    pend_dict["phi"] += push * response.turn2 - turn1


def handle_two_double_bobs(
    pend1: DoublePendulumEntry, pend2: DoublePendulumEntry, r_param: float
) -> bool:
    """Let two double pendula, pend1 left of pend2, collide where their bobs touch.

    e is pend1's. Each bob of pend1 can touch each bob of pend2. Touching bobs that move apart do
    not collide. Return whether any bobs collided.
    """
    collided = False
    for _, _, response1, response2 in touching_bobs(pend1, pend2, r_param):
        approach = response1.v - response2.v
        if approach > ROUNDING:
            impulse = (1 + pend1["e"]) * approach / (response1.w + response2.w)
            change_rates(pend1, -impulse, response1)
            change_rates(pend2, impulse, response2)
            collided = True
    return collided


def keep_apart(pend1: DoublePendulumEntry, pend2: DoublePendulumEntry, r_param: float) -> bool:
    """Move bobs of two double pendula that rest on each other apart, to CLOSEST.

    Bobs with e below 1 can come to rest on each other. Then each tick presses them a little further
    into each other: after some time, they would pass through each other. e is pend1's; with e = 1,
    nothing moves. The cords turn in the ratio in which an impulse between the two bobs turns them.
    Each call adds at most 1e-5 of the energy at DOUBLE_DT, with few exceptions, and up to 1e-3 with
    ticks of 1 ms. Return whether any bobs were moved.
    """
    if pend1["e"] >= 1:
        return False
    moved = False
    # A hundredth of w1 + w2 without cords: with less, the cords hold the bobs.
    least_w = 0.01 * (1 / pend1["mass"] + 1 / pend2["mass"])
    for distance, most, response1, response2 in touching_bobs(pend1, pend2, r_param):
        w = response1.w + response2.w
        if OVERLAPPED_AT_START < distance / most < CLOSEST and w > least_w:
            push = (CLOSEST * most - distance) / w
            turn_cords(pend1, -push, response1)
            turn_cords(pend2, push, response2)
            moved = True
    return moved


def touching_pairs(pend_list: list[DoublePendulumEntry], r_param: float) -> list[tuple[int, int]]:
    """Return the indices (left, right) of each pair of touching double pendula, from left to right.

    The bobs are sorted by x, to compare only near ones: along x, touching bobs are at most as far
    apart as two of the largest ones.
    """
    bobs = sorted(
        (*bob, i) for i, pend_dict in enumerate(pend_list) for bob in bobs_of(pend_dict, r_param)
    )
    largest = max((radius for _, _, radius, _ in bobs), default=0)
    furthest = contact_distance(largest, largest)
    pairs = set()
    for number, (x1, y1, radius1, i) in enumerate(bobs, start=1):
        for x2, y2, radius2, j in islice(bobs, number, None):
            if x2 - x1 > furthest:
                break
            if i != j and hypot(x2 - x1, y2 - y1) <= contact_distance(radius1, radius2):
                pairs.add((min(i, j), max(i, j)))
    return sorted(pairs)
