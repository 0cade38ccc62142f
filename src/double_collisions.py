"""The collisions of the double cradle: find the bobs that touch, and compute their velocities after
a hit.

theta, phi, alpha, beta, m1, m2, R and the kinetic energy T mean the same as in
src/double_cradle.py; ' is d/dt.

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

from itertools import islice
from math import cos, hypot, sin

from support.pendulum import contact_distance

# Distances, as fractions of the largest distance at which bobs touch. keep_apart pushes resting
# bobs out to CLOSEST. Bobs closer than OVERLAPPED_AT_START were placed like that; it leaves them
# alone.
CLOSEST, OVERLAPPED_AT_START = 0.98, 0.95

ROUNDING = 1e-9  # m/s: a slower approach or separation is a rounding error

# A tick goes at most this many times through the touching pairs: a hit can make other pairs
# approach.
SWEEPS = 3


def bob_places(pend_dict, r_param) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Return x, y (from theta and phi) and the radius of the upper and of the lower bob, all in m."""
    alpha, beta = pend_dict["theta"], pend_dict["theta"] + pend_dict["phi"]
    axle, bob1, _, bob2, _ = pend_dict["objects"]
    x, y = axle.pos.x + r_param * sin(alpha), axle.pos.y - r_param * cos(alpha)
    return (x, y, bob1.radius), (x + r_param * sin(beta), y - r_param * cos(beta), bob2.radius)


def touching_bobs(pend1, pend2, r_param):
    """Yield (distance, touching, response1, response2) for each pair of touching bobs, one of pend1
    and one of pend2.

    distance (m) is between their centres, touching (m) is the largest distance at which they touch.
    The responses are those along the line from the first bob to the second. The places of the bobs
    follow from theta and phi; VPython's objects only show them.
    """
    places1, places2 = bob_places(pend1, r_param), bob_places(pend2, r_param)
    for bob1, (x1, y1, radius1) in enumerate(places1):
        for bob2, (x2, y2, radius2) in enumerate(places2):
            distance, touching = hypot(x2 - x1, y2 - y1), contact_distance(radius1, radius2)
            if 0 < distance <= touching:
                x, y = (x2 - x1) / distance, (y2 - y1) / distance
                yield (
                    distance,
                    touching,
                    response(pend1, bob1, x, y, r_param),
                    response(pend2, bob2, x, y, r_param),
                )


def response(pend_dict, bob, x, y, r_param) -> tuple[float, float, float, float]:
    """Return (v, w, turn1, turn2) of a bob (0 upper, 1 lower) of a double pendulum, along the unit
    vector (x, y).

    v is the bob's velocity (m/s). An impulse of 1 N s changes v by w (m/s), alpha' by turn1 and
    beta' by turn2 (rad/s). turn1 and turn2 are M^-1 J (see above).
    """
    alpha, beta = pend_dict["theta"], pend_dict["theta"] + pend_dict["phi"]
    alpha_rate, beta_rate = pend_dict["omega"], pend_dict["omega"] + pend_dict["phi_omega"]
    j1 = r_param * (x * cos(alpha) + y * sin(alpha))
    j2 = r_param * (x * cos(beta) + y * sin(beta)) if bob == 1 else 0.0
    c = cos(beta - alpha)
    # Of M / m; both bobs have the mass m
    determinant = pend_dict["mass"] * r_param**2 * (2 - c * c)
    turn1, turn2 = (j1 - c * j2) / determinant, (2 * j2 - c * j1) / determinant
    return j1 * alpha_rate + j2 * beta_rate, j1 * turn1 + j2 * turn2, turn1, turn2


def turn_cords(pend_dict, upper, lower, turn1, turn2) -> None:
    """Add turn1 to alpha and turn2 to beta (upper "theta", lower "phi"), or to their rates
    ("omega", "phi_omega").
    """
    pend_dict[upper] += turn1
    pend_dict[lower] += turn2 - turn1


def handle_two_double_bobs(pend1, pend2, r_param) -> bool:
    """Let two double pendula, pend1 left of pend2, collide where their bobs touch.

    e is pend1's. Each bob of pend1 can touch each bob of pend2. Touching bobs that move apart do
    not collide. Return whether any bobs collided.
    """
    collided = False
    for _, _, (v1, w1, *turns1), (v2, w2, *turns2) in touching_bobs(pend1, pend2, r_param):
        approach = v1 - v2
        if approach > ROUNDING:
            impulse = (1 + pend1["e"]) * approach / (w1 + w2)
            turn_cords(pend1, "omega", "phi_omega", *(-impulse * turn for turn in turns1))
            turn_cords(pend2, "omega", "phi_omega", *(impulse * turn for turn in turns2))
            collided = True
    return collided


def keep_apart(pend1, pend2, r_param) -> bool:
    """Move bobs of two double pendula that rest on each other apart, to CLOSEST; return whether any
    bobs were moved.

    e is pend1's; with e = 1, nothing moves. Bobs with e below 1 can come to rest on each other.
    Then each tick presses them a little further into each other: after some time, they would pass
    through each other. The cords turn in the ratio in which an impulse between the two bobs turns
    them. This adds energy: at DOUBLE_DT seldom 1e-5 of it, but 1e-3 with ticks of 1 ms.
    """
    if pend1["e"] >= 1:
        return False
    moved = False
    # A hundredth of w1 + w2 without cords
    held_by_cords = 0.01 * (1 / pend1["mass"] + 1 / pend2["mass"])
    for distance, touching, (_, w1, *turns1), (_, w2, *turns2) in touching_bobs(
        pend1, pend2, r_param
    ):
        if OVERLAPPED_AT_START < distance / touching < CLOSEST and w1 + w2 > held_by_cords:
            push = (CLOSEST * touching - distance) / (w1 + w2)
            turn_cords(pend1, "theta", "phi", *(-push * turn for turn in turns1))
            turn_cords(pend2, "theta", "phi", *(push * turn for turn in turns2))
            moved = True
    return moved


def collide_pairs(pend_list, r_param) -> list[tuple[int, int]]:
    """Let touching double pendula collide, pair by pair from left to right.

    Not only neighbours touch: a lower bob swings past its neighbour's cord to the bobs behind it.
    The pairs collide again while there are hits, up to SWEEPS times. Return the pairs that
    collided, in the order of their hits, as (left, right), indices into pend_list.
    """
    pairs = touching_pairs(pend_list, r_param)
    hits: list[tuple[int, int]] = []
    for _ in range(SWEEPS):
        sweep = [
            (left, right)
            for left, right in pairs
            if handle_two_double_bobs(pend_list[left], pend_list[right], r_param)
        ]
        if not sweep:
            break
        hits += sweep
    return hits


def touching_pairs(pend_list, r_param) -> list[tuple[int, int]]:
    """Return the indices (left, right) of each pair of touching double pendula, from left to right.

    The bobs are sorted by x, to compare only near ones: along x, touching bobs are at most as far
    apart as two of the largest ones.
    """
    bobs = sorted(
        (*place, i)
        for i, pend_dict in enumerate(pend_list)
        for place in bob_places(pend_dict, r_param)
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
