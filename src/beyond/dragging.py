"""Drag a bob with the mouse: it pushes its neighbours aside, and they push theirs.

A single pendulum has one cord, a double pendulum has two. The angles of a pendulum are the angles of its cords from
straight down (rad), the upper cord first.
"""

from math import acos, atan2, ceil, copysign, cos, hypot, pi, remainder, sin

from src.double_cradle import show_double_pendulum
from support.constants import BUFFER
from support.pendulum import show_pendulum

STRAIGHT = 0.1  # rad: two cords with a smaller bend between them count as straight
STEP = 0.02  # rad: the largest turn of a cord in one step; after a larger one, its bob could be past its neighbour


def drag_bob(pend_list, held, bob, x, y, r_param) -> None:
    """Turn the cords of the held pendulum (an index) until its bob (0 upper, 1 lower) is as near as possible to (x, y).

    x and y (m) are in the plane of swing, r_param (m) is the length of a cord. A dragged lower bob takes the upper bob
    along. A dragged upper bob does not change the direction of the lower cord.
    """
    axle, angles = pend_list[held]["objects"][0].pos, cord_angles(pend_list[held])
    x, down = x - axle.x, axle.y - y
    direction = atan2(x, down)
    if bob == 0:
        angles[0] = direction
    else:
        # The two cords and the line from the axle to the bob form an isosceles triangle. Bent cords stay bent to the
        # same side. Straight cords bend so that the upper bob moves down.
        bent = remainder(angles[1] - angles[0], 2 * pi)
        bend = copysign(acos(min(1, hypot(x, down) / (2 * r_param))), bent if abs(bent) > STRAIGHT else direction)
        angles = [direction - bend, direction + bend]
    drag_pendulum(pend_list, held, angles, r_param)


def drag_pendulum(pend_list, held, angles, r_param) -> None:
    """Turn the held pendulum (an index) to these angles (rad), the short way round; it pushes others out of its way.

    It stops if they have no room. r_param (m) is the length of a cord. Moved pendula end at rest.
    """
    pend = pend_list[held]
    before = cord_angles(pend)
    turns = [remainder(angle - old, 2 * pi) for angle, old in zip(angles, before, strict=True)]
    steps = ceil(max(map(abs, turns)) / STEP)
    for step in range(1, steps + 1):
        places = [cord_angles(other) for other in pend_list]
        move(pend, [old + turn * step / steps for old, turn in zip(before, turns, strict=True)], r_param)
        if not push_others(pend_list, held, r_param):
            for other, angles in zip(pend_list, places, strict=True):
                if cord_angles(other) != angles:
                    move(other, angles, r_param)
            break


def push_others(pend_list, held, r_param) -> bool:
    """Turn pendula out of the way of the held one, and then others out of their way; return whether all have room."""
    pushers = [held]
    for pusher in pushers:  # the loop adds each pushed pendulum
        for other, pend in enumerate(pend_list):
            is_pushed = other not in (held, pusher) and len(pushers) < 4 * len(pend_list)
            if is_pushed and give_way(pend, pend_list[pusher], r_param):
                pushers.append(other)
    return not any(
        reaches_into(pend, pend_list[pusher], r_param)
        for pusher in set(pushers)
        for other, pend in enumerate(pend_list)
        if other != pusher
    )


def reaches_into(pend, other, r_param) -> bool:
    """Return whether a bob of pend reaches into a bob of other; r_param (m) is the length of a cord."""
    cords, bobs = range(len(cord_angles(pend))), other["objects"][1::2]
    return any(touching_angle(pend, cord, bob, r_param) is not None for cord in cords for bob in bobs)


def give_way(pend, pusher, r_param) -> bool:
    """Turn each cord of pend whose bob reaches into a bob of pusher; return whether any cord turned."""
    moved = False
    for cord in range(len(cord_angles(pend))):
        for bob in pusher["objects"][1::2]:
            angle = touching_angle(pend, cord, bob, r_param)
            if angle is not None:
                angles = cord_angles(pend)
                angles[cord] = angle
                move(pend, angles, r_param)
                moved = True
    return moved


def touching_angle(pend, cord, other, r_param) -> float | None:
    """Return the angle (rad) of this cord (0 or 1) at which its bob just touches the bob other, on its present side.

    Return None if its bob does not reach into other now. Seen from the upper end of the cord, L is the distance and psi
    the direction of other. R is the length of the cord, D the distance at which bobs collide. The bob touches other at
    the angles psi - delta and psi + delta, and reaches into it between them. By the law of cosines,
        D^2 = R^2 + L^2 - 2 R L cos(delta)
    """
    pivot, bob = pend["objects"][cord], pend["objects"][1 + 2 * cord]  # a lower cord hangs from the upper bob
    x, down = other.pos.x - pivot.pos.x, pivot.pos.y - other.pos.y
    distance, psi = hypot(x, down), atan2(x, down)
    from_psi = cord_angles(pend)[cord] - psi
    squares, product, touching = r_param**2 + distance**2, 2 * r_param * distance, BUFFER * (bob.radius + other.radius)
    if product * cos(from_psi) < squares - touching**2:
        return None
    outside = touching * (1 + 1e-9)  # just outside: at the distance touching, bobs still hit
    return psi + copysign(acos((squares - outside**2) / product), sin(from_psi))


def cord_angles(pend) -> list[float]:
    """Return the angles (rad) of a pendulum's cords from straight down, the upper one first."""
    theta = pend["theta"]
    return [theta] if len(pend["objects"]) == 3 else [theta, theta + pend["phi"]]


def move(pend, angles, r_param) -> None:
    """Turn a pendulum to these angles (rad), at rest."""
    pend["theta"], pend["omega"] = angles[0], 0.0
    if len(angles) == 1:
        show_pendulum(pend, r_param)
    else:
        pend["phi"], pend["phi_omega"] = angles[1] - angles[0], 0.0
        show_double_pendulum(pend, r_param)
