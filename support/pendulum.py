"""A pendulum: its dictionary, and the VPython objects that show it."""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from math import cos, degrees, radians, sin
from typing import Any, TypedDict

from vpython import box, color, cylinder, scene, sphere, vector

# Two bobs touch if their centres are at most BUFFER times the sum of their radii apart: a
# little buffer.
BUFFER = 1.05

DARK_GREY = vector(0.3, 0.3, 0.32)
GREY = vector(0.45, 0.45, 0.47)


class PendulumEntry(TypedDict, total=False):
    """One pendulum of a pend_list.

    extract_and_convert adds the CSV's columns, make_newton_cradle the rest.
    """

    mass: float  # of the bob, kg
    # The coefficient of restitution of a hit with the next pendulum: 0 (inelastic) to 1 (elastic).
    e: float
    theta: float  # angle of the cord from straight down, rad, positive to the right
    omega: float  # angular velocity, rad/s
    color: str  # a key of COLOR_MAP
    texture: str  # a key of TEXTURE_MAP
    # The axle, the bob and the cord; of a double pendulum also the lower bob and cord.
    objects: tuple[box, sphere, cylinder] | tuple[box, sphere, cylinder, sphere, cylinder]


class DoublePendulumEntry(PendulumEntry, total=False):
    """One double pendulum; its theta and omega belong to the upper cord."""

    phi: float  # angle of the lower cord from the direction of the upper one, rad
    phi_omega: float  # angular velocity of phi, rad/s


Pendulum = dict[str, Any]  # either of them, for functions that choose the keys


# --- angles and distances ------------------------------------------------------------------------


def outwards_to_angle(outwards: float) -> float:
    """Return the angle (rad, positive to the right) of a cord that is lifted outwards.

    outwards (degrees) is the angle to the left, where the first pendula have no neighbour.
    """
    return -radians(outwards)


def angle_to_outwards(angle: float) -> float:
    """Return how far outwards (degrees) a cord is lifted; angle (rad) is positive to the right."""
    return round(degrees(0 - angle), 9)  # 45, not 45.00000000000001; 0, not -0


def contact_distance(radius1: float, radius2: float) -> float:
    """Return the largest distance (m) of two centres at which bobs with these radii (m) touch."""
    return BUFFER * (radius1 + radius2)


def arm(theta: float, r_param: float) -> vector:
    """Return the vector (m) from the upper to the lower end of a cord.

    theta is its angle (rad), r_param its length (m).
    """
    return vector(r_param * sin(theta), -r_param * cos(theta), 0)


def cord_angles(pend_dict: Mapping[str, Any]) -> list[float]:
    """Return the angles (rad) of a pendulum's cords from straight down, the upper one first."""
    theta = pend_dict["theta"]
    if len(pend_dict["objects"]) == 3:
        return [theta]
    return [theta, theta + pend_dict["phi"]]


# --- show a pendulum -----------------------------------------------------------------------------


def show_pendulum(pend_dict: Mapping[str, Any], r_param: float) -> None:
    """Move the bob and the cord of a pendulum to its theta; r_param (m) is the cord length."""
    axle, bob, cord = pend_dict["objects"]
    axis = arm(pend_dict["theta"], r_param)
    bob.pos = axle.pos + axis
    cord.axis = axis


def show_double_pendulum(pend_dict: Mapping[str, Any], r_param: float) -> None:
    """Move the bobs and cords of a double pendulum to its theta and phi; r_param as above."""
    axle, bob1, cord1, bob2, cord2 = pend_dict["objects"]
    upper, lower = (arm(angle, r_param) for angle in cord_angles(pend_dict))
    bob1.pos = cord2.pos = axle.pos + upper
    bob2.pos = bob1.pos + lower
    cord1.axis = upper
    cord2.axis = lower


def make_pendulum(
    axle_pos: vector, r_param: float, theta: float, color: vector, texture: str | None
) -> tuple[box, sphere, cylinder]:
    """Return the VPython objects (axle, bob, cord) of a pendulum.

    It hangs from axle_pos (a vector, m) at the angle theta (rad) from straight down. r_param (m) is
    the cord length, color a VPython color (a vector), and texture a VPython texture or None.
    """
    size = vector(r_param / 16, r_param / 32, r_param / 2)
    axle = make_shape(box, pos=axle_pos, size=size, color=DARK_GREY)
    return axle, *make_bob_and_cord(axle_pos, r_param, theta, color, texture)


def make_bob_and_cord(
    place: vector, r_param: float, theta: float, color: vector, texture: str | None
) -> tuple[sphere, cylinder]:
    """Return a bob and its cord, which hangs from place (a vector, m).

    The other parameters are as in make_pendulum.
    """
    # Axles are r_param/4 apart. With this radius, bobs at rest are a little further apart than
    # their contact_distance. Otherwise, every tick would exchange their velocities.
    radius = 0.9995 * r_param / 8 / BUFFER
    axis = arm(theta, r_param)
    bob = make_shape(
        sphere, pos=place + axis, radius=radius, color=color, texture=texture, shininess=1
    )
    # up is at right angles to the plane of swing. VPython would turn any other up with each axis,
    # which is slow.
    up = vector(0, 0, 1)
    cord = make_shape(cylinder, pos=place, axis=axis, up=up, radius=r_param / 200, color=GREY)
    return bob, cord


# --- shapes are used again -----------------------------------------------------------------------

# VPython's default values. make_shape gives them to a used shape first.
PLAIN = {
    "color": color.white,
    "texture": None,
    "shininess": 0.6,
    "visible": True,
}

# VPython keeps every shape for ever, so a new cradle takes the shapes of the old one.
discarded: defaultdict[type, list] = defaultdict(list)  # kind -> shapes
in_use: dict[int, Any] = {}  # the other shapes that make_shape has made, by their id


def make_shape(kind: type, **attributes: Any) -> Any:
    """Return a shape of this kind (box, ...) with these attributes: a used one, or a new one."""
    if discarded[kind]:
        shape = discarded[kind].pop()
        for name, value in {**PLAIN, **attributes}.items():
            setattr(shape, name, value)
    else:
        shape = kind(**attributes)
    in_use[id(shape)] = shape
    return shape


def discard(shapes: Iterable) -> None:
    """Hide these shapes, and let make_shape use them again."""
    for shape in shapes:
        shape.visible = False
        discarded[type(shape)].append(shape)
        in_use.pop(id(shape), None)


def discard_all(but: Iterable) -> None:
    """Discard the shapes of make_shape, and hide all others, but not these."""
    kept = {*map(id, but)}
    # The last discarded one is used again first.
    discard([shape for shape in reversed([*in_use.values()]) if id(shape) not in kept])
    for shape in scene.objects:
        if id(shape) not in kept:
            shape.visible = False
