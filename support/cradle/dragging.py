"""Drag a bob with the mouse: it pushes its neighbours aside, and they push theirs.

A single pendulum has one cord, a double pendulum has two. The angles of a pendulum are the angles
of its cords from straight down (rad), the upper cord first.
"""

from collections.abc import Iterator
from math import acos, atan2, ceil, copysign, cos, hypot, pi, remainder, sin

from vpython import cross, dot, mag, sphere, vector

from support.pendulum import (
    contact_distance,
    cord_angles,
    Pendulum,
    show_double_pendulum,
    show_pendulum,
)

STRAIGHT = 0.1  # rad: two cords with a smaller bend between them are straight
LARGEST_TURN = 0.02  # rad: of a cord at once, or its bob could jump over its neighbour
FINGER = 1.5  # radii from a bob's centre at which a finger, or the mouse, still grabs it
MOST_PUSHES = 4  # a pendulum, on the average: then there is no room


# --- one pendulum follows the mouse, the others give way -----------------------------------------


def drag_bob(
    pend_list: list[Pendulum], held: int, bob: int, x: float, y: float, r_param: float
) -> None:
    """Turn the cords of the held pendulum (an index): its bob comes as near as possible to (x, y).

    bob is 0 for the upper bob, 1 for the lower one. x and y (m) are in the plane of swing, r_param
    (m) is the length of a cord. A dragged lower bob pulls the upper bob along. A dragged upper bob
    does not change the direction of the lower cord.
    """
    axle = pend_list[held]["objects"][0].pos
    angles = cord_angles(pend_list[held])
    aside = x - axle.x
    down = axle.y - y
    direction = atan2(aside, down)
    if bob == 0:
        angles[0] = direction
    else:
        # The two cords and the line from the axle to the bob form an isosceles triangle. Bent cords
        # stay bent to the same side. Straight cords bend so that the upper bob moves down.
        bent = remainder(angles[1] - angles[0], 2 * pi)
        side = bent if abs(bent) > STRAIGHT else direction
        bend = copysign(acos(min(1, hypot(aside, down) / (2 * r_param))), side)
        angles = [direction - bend, direction + bend]
    drag_pendulum(pend_list, held, angles, r_param)


def drag_pendulum(
    pend_list: list[Pendulum], held: int, angles: list[float], r_param: float
) -> None:
    """Turn the held pendulum (an index) to these angles (rad), the short way round.

    It pushes others out of its way. If these cannot give way, it stops. r_param (m) is the length
    of a cord. Pendula that were moved are at rest.
    """
    pend = pend_list[held]
    start = cord_angles(pend)
    turns = [remainder(angle - old, 2 * pi) for angle, old in zip(angles, start, strict=True)]
    steps = ceil(max(map(abs, turns)) / LARGEST_TURN)
    for step in range(1, steps + 1):
        before = [cord_angles(other) for other in pend_list]
        angles = [old + turn * step / steps for old, turn in zip(start, turns, strict=True)]
        move(pend, angles, r_param)
        if not push_others(pend_list, held, r_param):
            move_back(pend_list, before, r_param)
            break


def move_back(pend_list: list[Pendulum], before: list[list[float]], r_param: float) -> None:
    """Turn the pendula that have moved back to their angles before it (rad)."""
    for pend, angles in zip(pend_list, before, strict=True):
        if cord_angles(pend) != angles:
            move(pend, angles, r_param)


def push_others(pend_list: list[Pendulum], held: int, r_param: float) -> bool:
    """Turn pendula out of the way of the held one (an index), and others out of their way.

    Return whether all could give way.
    """
    pushers = [held]
    most = MOST_PUSHES * len(pend_list)
    for pusher in pushers:  # the loop adds each pushed pendulum
        for other, pend in enumerate(pend_list):
            has_turn = other not in (held, pusher) and len(pushers) < most
            if has_turn and give_way(pend, pend_list[pusher], r_param):
                pushers.append(other)
    return not any(touches_others(pend_list, pusher, r_param) for pusher in set(pushers))


def touches_others(pend_list: list[Pendulum], index: int, r_param: float) -> bool:
    """Return whether a bob of this pendulum reaches into a bob of another one."""
    pend = pend_list[index]
    others = [other for other in pend_list if other is not pend]
    return any(any(touching_angles(other, pend, r_param)) for other in others)


def give_way(pend: Pendulum, pusher: Pendulum, r_param: float) -> bool:
    """Turn each cord of pend whose bob reaches into a bob of pusher; return whether one turned."""
    has_moved = False
    for cord, angle in touching_angles(pend, pusher, r_param):
        angles = cord_angles(pend)
        angles[cord] = angle
        move(pend, angles, r_param)
        has_moved = True
    return has_moved


def touching_angles(
    pend: Pendulum, pusher: Pendulum, r_param: float
) -> Iterator[tuple[int, float]]:
    """Yield (cord, touching_angle), from above, for each bob of pend that reaches into pusher's."""
    for cord in range(len(cord_angles(pend))):
        for bob in pusher["objects"][1::2]:
            angle = touching_angle(pend, cord, bob, r_param)
            if angle is not None:
                yield cord, angle


def touching_angle(pend: Pendulum, cord: int, other: sphere, r_param: float) -> float | None:
    """Return the angle (rad) of this cord (0 or 1) at which its bob just touches another bob.

    Of two such angles, it is that on the side where the bob is. Return None if the two bobs do not
    reach into each other. From the upper end of the cord, other is at the distance L, in the
    direction psi. R is the length of the cord, D the distance at which bobs collide. The two bobs
    touch at the angles psi - delta and psi + delta, and reach into each other between them. By the
    law of cosines,
        D^2 = R^2 + L^2 - 2 R L cos(delta)
    """
    pivot = pend["objects"][cord]  # a lower cord hangs from the upper bob
    bob = pend["objects"][1 + 2 * cord]
    aside = other.pos.x - pivot.pos.x
    down = pivot.pos.y - other.pos.y
    distance = hypot(aside, down)
    psi = atan2(aside, down)
    from_psi = cord_angles(pend)[cord] - psi
    squares = r_param**2 + distance**2
    product = 2 * r_param * distance
    touching = contact_distance(bob.radius, other.radius)
    if product * cos(from_psi) < squares - touching**2:
        return None
    outside = touching * (1 + 1e-9)  # just outside: at the distance touching, bobs still hit
    return psi + copysign(acos((squares - outside**2) / product), sin(from_psi))


def move(pend: Pendulum, angles: list[float], r_param: float) -> None:
    """Turn a pendulum to these angles (rad), at rest."""
    pend["theta"] = angles[0]
    pend["omega"] = 0.0
    if len(angles) == 1:
        show_pendulum(pend, r_param)
    else:
        pend["phi"] = angles[1] - angles[0]
        pend["phi_omega"] = 0.0
        show_double_pendulum(pend, r_param)


# --- the mouse: a ray is a point on it, and its direction ----------------------------------------


def bob_at(bobs: list[sphere], place: vector, direction: vector) -> int | None:
    """Return the index of the foremost bob on this ray.

    If it meets none, return that of the nearest bob within FINGER radii, or None.
    """
    met: list[tuple[float, int]] = []  # how far behind place, and the index
    near: list[tuple[float, int]] = []  # how many radii from the ray
    for index, bob in enumerate(bobs):
        radii = mag(cross(bob.pos - place, direction)) / mag(direction) / bob.radius
        if radii <= 1:
            met.append((dot(bob.pos - place, direction), index))
        elif radii <= FINGER:
            near.append((radii, index))
    candidates = met or near
    return min(candidates)[1] if candidates else None


def point_in_plane(place: vector, direction: vector) -> vector | None:
    """Return the point where this ray meets the plane of swing, z = 0.

    Return None if the plane is seen from the side, as a line.
    """
    if abs(direction.z) <= 0.01 * mag(direction):
        return None
    return place - direction * (place.z / direction.z)
