"""Hold a bob, and drag it with the mouse: it pushes its neighbours aside, and they push theirs.

A single pendulum has one cord, a double pendulum has two. The angles of a pendulum are the angles
of its cords from straight down (rad), the upper cord first.
"""

from math import acos, atan2, ceil, copysign, cos, hypot, pi, remainder, sin

from vpython import cross, dot, mag

from support.constants import R_PARAM
from support.pendulum import contact_distance, cord_angles, show_double_pendulum, show_pendulum

STRAIGHT = 0.1  # rad: two cords with a smaller bend between them count as straight
# rad: the largest turn of a cord in one step; in a larger one, its bob could jump over its
# neighbour
STEP = 0.02
# Radii from a bob's centre at which a finger, or the mouse, still grabs it; canvas.js knows it, too
FINGER = 1.5
HEAVY = 1e9  # kg: the mass of a held bob; others bounce off it as off a wall


class Hand:
    """Holds one bob of a cradle, or none."""

    def __init__(self, cradle):
        self.cradle = cradle
        self.held: int | None = None  # the index of the held bob in cradle.bobs()
        # The held pendulum's mass and angles, while the cradle ticks
        self.kept: tuple | None = None

    def place(self) -> tuple[int, int]:
        """Return the index of the held pendulum, and the number of the held bob in it, counted from
        above (0 or 1).
        """
        # Each cord has one release angle and one bob
        return divmod(self.held or 0, len(self.cradle.angles))

    def pend(self) -> dict:
        return self.cradle.pend_list[self.place()[0]]

    def hold(self, bob) -> None:
        """Hold this bob (an index) and its pendulum in their place, at rest, until held is None."""
        self.held = bob
        move(self.pend(), cord_angles(self.pend()), R_PARAM)

    def drag(self, x, y) -> None:
        """Turn the held pendulum until its bob is as near as possible to x, y (m) in the plane of
        swing.
        """
        drag_bob(self.cradle.pend_list, *self.place(), x, y, R_PARAM)

    def grip(self) -> None:
        """Make the held pendulum heavy, before a few ticks."""
        if self.held is not None:
            self.kept = self.pend()["mass"], cord_angles(self.pend())
            self.pend()["mass"] = HEAVY

    def put_back(self) -> None:
        """Put the held pendulum back into its place, at rest, after these ticks."""
        if self.kept:
            self.pend()["mass"], angles = self.kept
            move(self.pend(), angles, R_PARAM)
            self.kept = None


def drag_bob(pend_list, held, bob, x, y, r_param) -> None:
    """Turn the cords of the held pendulum (an index) to bring its bob (0 upper, 1 lower) as near as
    possible to (x, y).

    x and y (m) are in the plane of swing, r_param (m) is the length of a cord. A dragged lower bob
    pulls the upper bob along. A dragged upper bob does not change the direction of the lower cord.
    """
    axle, angles = pend_list[held]["objects"][0].pos, cord_angles(pend_list[held])
    x, down = x - axle.x, axle.y - y
    direction = atan2(x, down)
    if bob == 0:
        angles[0] = direction
    else:
        # The two cords and the line from the axle to the bob form an isosceles triangle. Bent cords
        # stay bent to the same side. Straight cords bend so that the upper bob moves down.
        bent = remainder(angles[1] - angles[0], 2 * pi)
        bend = copysign(
            acos(min(1, hypot(x, down) / (2 * r_param))),
            bent if abs(bent) > STRAIGHT else direction,
        )
        angles = [direction - bend, direction + bend]
    drag_pendulum(pend_list, held, angles, r_param)


def drag_pendulum(pend_list, held, angles, r_param) -> None:
    """Turn the held pendulum (an index) to these angles (rad), the short way round, and push others
    out of its way.

    If these cannot give way, it stops. r_param (m) is the length of a cord. Pendula that were moved
    are at rest.
    """
    pend = pend_list[held]
    before = cord_angles(pend)
    turns = [remainder(angle - old, 2 * pi) for angle, old in zip(angles, before, strict=True)]
    steps = ceil(max(map(abs, turns)) / STEP)
    for step in range(1, steps + 1):
        places = [cord_angles(other) for other in pend_list]
        move(
            pend,
            [old + turn * step / steps for old, turn in zip(before, turns, strict=True)],
            r_param,
        )
        if not push_others(pend_list, held, r_param):
            for other, angles in zip(pend_list, places, strict=True):
                if cord_angles(other) != angles:
                    move(other, angles, r_param)
            break


def push_others(pend_list, held, r_param) -> bool:
    """Turn pendula out of the way of the held one, and others out of their way; return whether all
    could give way.
    """
    pushers = [held]
    for pusher in pushers:  # the loop adds each pushed pendulum
        for other, pend in enumerate(pend_list):
            is_pushed = other not in (held, pusher) and len(pushers) < 4 * len(pend_list)
            if is_pushed and give_way(pend, pend_list[pusher], r_param):
                pushers.append(other)
    return not any(
        any(touching_angles(pend, pend_list[pusher], r_param))
        for pusher in set(pushers)
        for other, pend in enumerate(pend_list)
        if other != pusher
    )


def give_way(pend, pusher, r_param) -> bool:
    """Turn each cord of pend whose bob reaches into a bob of pusher; return whether any cord
    turned.
    """
    moved = False
    for cord, angle in touching_angles(pend, pusher, r_param):
        angles = cord_angles(pend)
        angles[cord] = angle
        move(pend, angles, r_param)
        moved = True
    return moved


def touching_angles(pend, pusher, r_param):
    """Yield (cord, touching_angle) for each cord of pend whose bob reaches into a bob of pusher,
    from above.
    """
    for cord in range(len(cord_angles(pend))):
        for bob in pusher["objects"][1::2]:
            angle = touching_angle(pend, cord, bob, r_param)
            if angle is not None:
                yield cord, angle


def touching_angle(pend, cord, other, r_param) -> float | None:
    """Return the angle (rad) of this cord (0 or 1) at which its bob just touches another bob, on
    the side where it is.

    Return None if the two bobs do not reach into each other. From the upper end of the cord, other
    (a sphere) is at the distance L, in the direction psi. R is the length of the cord, D the
    distance at which bobs collide. The two bobs touch at the angles psi - delta and psi + delta,
    and reach into each other between them. By the law of cosines,
        D^2 = R^2 + L^2 - 2 R L cos(delta)
    """
    # A lower cord hangs from the upper bob
    pivot = pend["objects"][cord]
    bob = pend["objects"][1 + 2 * cord]
    x, down = other.pos.x - pivot.pos.x, pivot.pos.y - other.pos.y
    distance, psi = hypot(x, down), atan2(x, down)
    from_psi = cord_angles(pend)[cord] - psi
    squares, product = r_param**2 + distance**2, 2 * r_param * distance
    touching = contact_distance(bob.radius, other.radius)
    if product * cos(from_psi) < squares - touching**2:
        return None
    outside = touching * (1 + 1e-9)  # just outside: at the distance touching, bobs still hit
    return psi + copysign(acos((squares - outside**2) / product), sin(from_psi))


def move(pend, angles, r_param) -> None:
    """Turn a pendulum to these angles (rad), at rest."""
    pend["theta"], pend["omega"] = angles[0], 0.0
    if len(angles) == 1:
        show_pendulum(pend, r_param)
    else:
        pend["phi"], pend["phi_omega"] = angles[1] - angles[0], 0.0
        show_double_pendulum(pend, r_param)


def bob_at(bobs, place, direction) -> int | None:
    """Return the index of the foremost bob on the ray through place, or of the nearest within
    FINGER radii, or None.
    """
    found = []
    for number, bob in enumerate(bobs):
        radii = mag(cross(bob.pos - place, direction)) / mag(direction) / bob.radius
        if radii <= FINGER:  # a bob that the ray meets comes before one beside it
            found.append(
                (radii > 1, dot(bob.pos - place, direction) if radii <= 1 else radii, number)
            )
    return min(found)[2] if found else None


def point_in_plane(place, direction):
    """Return the point where this ray meets the plane of swing, z = 0; None if it is seen from the
    side, as a line.
    """
    if abs(direction.z) <= 0.01 * mag(direction):
        return None
    return place - direction * (place.z / direction.z)
