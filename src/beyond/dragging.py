"""Dragging a bob by hand: it pushes its neighbours aside, and they push theirs.

A pendulum has one cord or, if it is a double one, two. The angles of a pendulum are those of its cords from straight
down (rad), the upper one first.
"""

from math import acos, atan2, ceil, copysign, cos, hypot, pi, remainder, sin

from src.double_cradle import show_double_pendulum
from support.constants import BUFFER
from support.pendulum import show_pendulum

STRAIGHT = 0.1  # rad: up to here the two cords of a double pendulum count as one line
STEP = 0.02  # rad: a cord is turned no further than this before its bob pushes, or it could get past its neighbour


def drag_bob(pend_list, held, bob, x, y, r_param) -> None:
    """Turn the cords of the held pendulum (an index) until its bob (0, or 1 for a lower one) is nearest to (x, y).

    x and y (m) are in the plane of swing, r_param (m) is the length of a cord. A lower bob that is dragged takes the
    upper one along; an upper one leaves the direction of the lower cord as it is.
    """
    axle, angles = pend_list[held]["objects"][0].pos, cord_angles(pend_list[held])
    x, down = x - axle.x, axle.y - y
    direction = atan2(x, down)
    if bob == 0:
        angles[0] = direction
    else:
        # With the line from the axle to the bob, the two cords make a triangle with two equal sides. They stay bent to
        # the side to which they are; if they are straight, the upper bob gives way downwards.
        bent = remainder(angles[1] - angles[0], 2 * pi)
        bend = copysign(acos(min(1, hypot(x, down) / (2 * r_param))), bent if abs(bent) > STRAIGHT else direction)
        angles = [direction - bend, direction + bend]
    drag_pendulum(pend_list, held, angles, r_param)


def drag_pendulum(pend_list, held, angles, r_param) -> None:
    """Turn the held pendulum (an index) to these angles the short way round; whoever is in its way is pushed along.

    It stops where there is no room for those. r_param is the length of a cord (m). Whoever was moved is at rest then.
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
    """Turn away whoever's bobs reach into those of the held pendulum, and whoever is then in the way of those.

    Return whether there was room for all.
    """
    pushers = [held]
    for pusher in pushers:  # those that are pushed are added meanwhile
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
    """Return whether a bob of pend reaches into a bob of the other pendulum; r_param (m) is the length of a cord."""
    cords, bobs = range(len(cord_angles(pend))), other["objects"][1::2]
    return any(touching_angle(pend, cord, bob, r_param) is not None for cord in cords for bob in bobs)


def give_way(pend, pusher, r_param) -> bool:
    """Turn those cords of pend whose bobs reach into one of the pusher's; return whether there are any."""
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
    """Return the angle at which the bob of this cord just touches the other bob, on the side on which it is now.

    None if it does not reach into the other one as it is. L is the distance and psi the direction of the other bob, as
    seen from where the cord hangs, R the length of the cord, and D the distance at which bobs collide. The bob touches
    the other one at the angles psi - delta and psi + delta, and reaches into it between them. The law of cosines says
        D^2 = R^2 + L^2 - 2 R L cos(delta)
    """
    pivot, bob = pend["objects"][cord], pend["objects"][1 + 2 * cord]  # a lower cord hangs from the upper bob
    x, down = other.pos.x - pivot.pos.x, pivot.pos.y - other.pos.y
    distance, psi = hypot(x, down), atan2(x, down)
    from_psi = cord_angles(pend)[cord] - psi
    squares, product, touching = r_param**2 + distance**2, 2 * r_param * distance, BUFFER * (bob.radius + other.radius)
    if product * cos(from_psi) < squares - touching**2:
        return None
    outside = touching * (1 + 1e-9)  # just outside, as a hit counts up to touching
    return psi + copysign(acos((squares - outside**2) / product), sin(from_psi))


def cord_angles(pend) -> list[float]:
    """Return the angles of a pendulum."""
    theta = pend["theta"]
    return [theta] if len(pend["objects"]) == 3 else [theta, theta + pend["phi"]]


def move(pend, angles, r_param) -> None:
    """Put a pendulum, at rest, where its angles are these."""
    pend["theta"], pend["omega"] = angles[0], 0.0
    if len(angles) == 1:
        show_pendulum(pend, r_param)
    else:
        pend["phi"], pend["phi_omega"] = angles[1] - angles[0], 0.0
        show_double_pendulum(pend, r_param)
