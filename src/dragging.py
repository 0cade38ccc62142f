"""Dragging a bob by hand: it pushes its neighbours aside, and they push theirs."""

from math import acos, atan2, ceil, copysign, hypot, pi, sin

from vpython import mag

from src.swinging import swing_update
from support.constants import BUFFER

STEP = 0.02  # rad: a bob is dragged no further than this before it pushes, or it could get past its neighbour


def drag_pendulum(pend_list, held, theta, r_param) -> None:
    """Turn the held pendulum (an index) to theta (rad) the short way round; whoever is in its way is pushed along.

    r_param is the cord length (m). Whoever was moved is at rest afterwards.
    """
    pend = pend_list[held]
    turn = (theta - pend["theta"] + pi) % (2 * pi) - pi
    steps = ceil(abs(turn) / STEP)
    for _ in range(steps):
        move(pend, pend["theta"] + turn / steps, r_param)
        push_others(pend_list, held, r_param)


def push_others(pend_list, held, r_param) -> None:
    """Turn away whoever's bob reaches into that of the held pendulum, and whoever is then in the way of those."""
    pushers = [held]
    for pusher in pushers:  # those that are pushed are added meanwhile
        for other, pend in enumerate(pend_list):
            theta = None if other in (held, pusher) else touching_theta(pend_list[pusher], pend, r_param)
            if theta is not None and len(pushers) < 4 * len(pend_list):
                move(pend, theta, r_param)
                pushers.append(other)


def touching_theta(pusher, pend, r_param) -> float | None:
    """Return the theta (rad) at which pend's bob just touches the pusher's, on the side on which it is now.

    None if it does not reach into the pusher's as it is. With D the distance at which bobs collide, L the distance and
    psi the direction of the pusher's bob as seen from pend's axle, and R the cord, the law of cosines says
        D^2 = R^2 + L^2 - 2 R L cos(theta - psi)
    """
    axle, bob, _ = pend["objects"]
    other = pusher["objects"][1]
    touching = BUFFER * (bob.radius + other.radius)
    if mag(bob.pos - other.pos) > touching:
        return None
    x, down = other.pos.x - axle.pos.x, axle.pos.y - other.pos.y
    distance, psi = hypot(x, down), atan2(x, down)
    touching *= 1 + 1e-9  # just outside, as a hit counts up to there
    delta = acos((r_param**2 + distance**2 - touching**2) / (2 * r_param * distance))
    return psi + copysign(delta, sin(pend["theta"] - psi))


def move(pend, theta, r_param) -> None:
    """Put a pendulum, at rest, where theta is (rad)."""
    pend["theta"], pend["omega"] = theta, 0.0
    swing_update(pend, r_param, 0, 0)  # no time passes, but the bob is shown there
