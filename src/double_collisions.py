"""The collisions of the double cradle: which bobs of double pendula touch, and their velocities afterwards.

Words: theta, phi, alpha, beta, m1, m2 and R, and the kinetic energy T, are those of src/double_cradle.py; ' is d/dt.

Hit
    A hit takes no time: gravity does nothing in it, and the cords' pulls do no work. The two bobs give each other an
    impulse p along the unit vector n from one centre to the other. Let q = (alpha, beta). A bob's velocity along n is
    v = J q', where
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

from support.constants import BUFFER

# Parts of the distance at which bobs touch. Bobs that lie on one another must not sink in deeper than CLOSEST. Bobs
# that are closer than PUT_THERE were put there (a start can do so) and are left to themselves.
CLOSEST, PUT_THERE = 0.98, 0.95

ROUNDING = 1e-9  # m/s: bobs that approach or separate more slowly than that do so by rounding errors

# How often a tick goes through the touching pairs, at most: a hit may make another pair approach.
SWEEPS = 3


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

    theta and phi say where the bobs are; VPython's objects only show them.
    """
    places1, places2 = bob_places(pend1, r_param), bob_places(pend2, r_param)
    radii1, radii2 = ([bob.radius for bob in pend["objects"][1::2]] for pend in (pend1, pend2))
    for bob1, (x1, y1) in enumerate(places1):
        for bob2, (x2, y2) in enumerate(places2):
            distance, touching = hypot(x2 - x1, y2 - y1), BUFFER * (radii1[bob1] + radii2[bob2])
            if 0 < distance <= touching:
                yield Touch(bob1, bob2, (x2 - x1) / distance, (y2 - y1) / distance, distance, touching)


def response(pend_dict, bob, touch, r_param) -> tuple[float, float, float, float]:
    """Return v, w and M^-1 J (see above) of a bob (0 or 1) of a double pendulum in the direction of a touch.

    v is the bob's velocity (m/s). An impulse of 1 N s changes it by w (m/s), and alpha' and beta' by M^-1 J (rad/s).
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
    """Add turn1 and turn2 to alpha and beta, if upper and lower are the keys theta and phi, or to their rates."""
    pend_dict[upper] += turn1
    pend_dict[lower] += turn2 - turn1


def handle_two_double_bobs(pend1, pend2, r_param, approaching_only=True) -> bool:
    """Let two double pendula, pend1 left of pend2, collide where their bobs touch; e is pend1's.

    Each bob of the one may touch each of the other. With approaching_only (here the default, as the handout has no rule
    for double pendula), bobs that touch but move apart are left alone. Return whether any collided.
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


def keep_apart(pend1, pend2, r_param) -> bool:
    """If e is below 1, turn the cords of two double pendula whose bobs are a little closer than CLOSEST apart to there.

    Return whether any were; e is pend1's. Bobs with e below 1 may come to lie on one another. Each tick then presses
    them a little way in. The impulse at its end takes their speed, but leaves them there, and in time they would pass
    through each other. The cords turn in the proportions in which an impulse between the two bobs turns them. Nobody
    does the work of this: it can add some 1e-5 of the energy at DOUBLE_DT, but 1e-3 with ticks of 1 ms, in which hits
    get deeper than CLOSEST, too.
    """
    if pend1["e"] >= 1:
        return False
    moved = False
    held_by_cords = 0.01 * (1 / pend1["mass"] + 1 / pend2["mass"])  # a hundredth of w1 + w2 without cords
    for touch in touching_bobs(pend1, pend2, r_param):
        _, w1, *turns1 = response(pend1, touch.bob1, touch, r_param)
        _, w2, *turns2 = response(pend2, touch.bob2, touch, r_param)
        if PUT_THERE < touch.distance / touch.touching < CLOSEST and w1 + w2 > held_by_cords:
            push = (CLOSEST * touch.touching - touch.distance) / (w1 + w2)
            turn_cords(pend1, "theta", "phi", *(-push * turn for turn in turns1))
            turn_cords(pend2, "theta", "phi", *(push * turn for turn in turns2))
            moved = True
    return moved


def collide_pairs(pend_list, r_param, approaching_only) -> list[tuple[int, int]]:
    """Let double pendula whose bobs touch collide, pair by pair from left to right.

    Not only neighbours are pairs: a lower bob gets past its neighbour's cord, to the bobs behind it. With
    approaching_only the pairs have their turn again as long as any collide, up to SWEEPS times. Return the pairs that
    have collided as (left, right), indices of pendula, in order of time.
    """
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
