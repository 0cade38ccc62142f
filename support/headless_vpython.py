"""A stand-in for VPython that needs no VPython and no browser.

After `import support.headless_vpython`, `import vpython` finds this module. It has the names of
VPython 7.6.5. Vectors and the shapes of a pendulum have what a cradle needs, and compute as
VPython's do; the project's tests compare the two. Differences: `axis` and `up` do not turn each
other, `size` is a copy, and a round shape takes its radius in place of a size. The rest of VPython
is only for show: here nothing is shown, and only rate waits, in the loop of a program.
"""

# ruff: noqa: F401  VPython exports all these names

import colorsys
import math
import sys
from math import *  # noqa: F403
from math import acos, cos, sin, sqrt
from math import comb as combin
from operator import attrgetter
from random import random
from time import perf_counter as clock
from typing import Any

from support.simulation import rate

sys.modules["vpython"] = sys.modules[__name__]

# --- vectors -------------------------------------------------------------------------------------


class vector:
    """A vector of three floats."""

    __slots__ = ("x", "y", "z")

    def __init__(self, *components: Any) -> None:
        if len(components) == 1 and isinstance(components[0], vector):
            components = components[0].value
        if len(components) != 3:
            raise TypeError("A vector needs 3 components.")
        self.x, self.y, self.z = map(float, components)

    @property
    def value(self) -> Any:
        """The components as a list."""
        return [self.x, self.y, self.z]

    @property
    def mag2(self) -> float:
        return self.x**2 + self.y**2 + self.z**2

    @property
    def mag(self) -> float:
        return sqrt(self.mag2)

    @mag.setter
    def mag(self, length: float) -> None:
        self.x, self.y, self.z = (self.hat * length).value

    def norm(self) -> "vector":
        length = self.mag
        return self / length if length > 0 else vector(0, 0, 0)

    hat = property(norm)

    def dot(self, other: "vector") -> float:
        return self.x * other.x + self.y * other.y + self.z * other.z

    def cross(self, other: "vector") -> "vector":
        return vector(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )

    def comp(self, other: "vector") -> float:
        return self.dot(other.hat)

    def proj(self, other: "vector") -> "vector":
        return other.hat * self.comp(other)

    def diff_angle(self, other: "vector") -> float:
        return acos(max(-1, min(1, self.hat.dot(other.hat))))

    def rotate(self, angle: float = 0.0, axis: Any = None) -> "vector":
        """Return this vector turned by angle (rad) about axis, by default z.

        This is Rodrigues' rotation formula.
        """
        k = vector(0, 0, 1) if axis is None else axis.hat
        return self * cos(angle) + k.cross(self) * sin(angle) + k * (k.dot(self) * (1 - cos(angle)))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, vector) and self.value == other.value

    equals = __eq__

    def __neg__(self) -> "vector":
        return self * -1

    def __add__(self, other: "vector") -> "vector":
        if not isinstance(other, vector):
            return NotImplemented
        return vector(self.x + other.x, self.y + other.y, self.z + other.z)

    def __sub__(self, other: "vector") -> "vector":
        if not isinstance(other, vector):
            return NotImplemented
        return vector(self.x - other.x, self.y - other.y, self.z - other.z)

    def __mul__(self, factor: float) -> "vector":
        if not isinstance(factor, (int, float)):
            return NotImplemented
        return vector(self.x * factor, self.y * factor, self.z * factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: float) -> "vector":
        if not isinstance(divisor, (int, float)):
            return NotImplemented
        return vector(self.x / divisor, self.y / divisor, self.z / divisor)

    def __str__(self) -> str:
        return f"<{self.x:.6g}, {self.y:.6g}, {self.z:.6g}>"

    def __repr__(self) -> str:
        return f"vector({self.x:.6g}, {self.y:.6g}, {self.z:.6g})"


vec = vector
# VPython's functions dot(A, B), ... do the same as the methods and properties.
dot = vector.dot
cross = vector.cross
comp = vector.comp
proj = vector.proj
diff_angle = vector.diff_angle
rotate = vector.rotate
norm = hat = vector.norm
mag = attrgetter("mag")
mag2 = attrgetter("mag2")


class color:
    black = vector(0, 0, 0)
    white = vector(1, 1, 1)
    red = vector(1, 0, 0)
    green = vector(0, 1, 0)
    blue = vector(0, 0, 1)
    yellow = vector(1, 1, 0)
    cyan = vector(0, 1, 1)
    magenta = vector(1, 0, 1)
    orange = vector(1, 0.6, 0)
    purple = vector(0.4, 0.2, 0.6)

    @staticmethod
    def gray(luminance: float) -> vector:
        return vector(luminance, luminance, luminance)

    @staticmethod
    def hsv_to_rgb(v: vector) -> vector:
        return vector(*colorsys.hsv_to_rgb(*v.value))


TEXTURES = "flower granite gravel earth metal rock rough rug stones stucco wood wood_old"
textures = type("textures", (), {name: f":{name}_texture.jpg" for name in TEXTURES.split()})

# --- the shapes of a pendulum --------------------------------------------------------------------


def own_vector(name: str) -> Any:
    """Return a property: a vector of a shape.

    Setting it copies a vector; reading it returns the shape's own vector.
    """

    def copy_from(shape: "Shape", v: vector) -> None:
        own = getattr(shape, name)
        own.x = v.x
        own.y = v.y
        own.z = v.z

    return property(attrgetter(name), copy_from)


class Shape:
    """A box, a sphere or a cylinder, with its default values; it is as long as its axis."""

    pos = own_vector("_pos")
    axis = own_vector("_axis")
    up = own_vector("_up")
    color = own_vector("_color")
    height = 1.0
    width = 1.0
    texture = None
    shininess = 0.6
    opacity = 1.0
    visible = True

    def __init__(self, **attributes: Any) -> None:
        self._pos = vector(0, 0, 0)
        self._axis = vector(1, 0, 0)
        self._up = vector(0, 1, 0)
        self._color = vector(1, 1, 1)
        for name, value in attributes.items():
            setattr(self, name, value)
        scene.objects.append(self)

    @property
    def length(self) -> float:
        return self.axis.mag

    @length.setter
    def length(self, value: float) -> None:
        self.axis.mag = value

    @property
    def size(self) -> vector:
        return vector(self.length, self.height, self.width)

    @size.setter
    def size(self, v: vector) -> None:
        self.length, self.height, self.width = v.value

    def rotate(self, angle: float, axis: Any = None, origin: Any = None) -> None:
        """Turn the shape by angle (rad) about axis through origin.

        Without them, it turns about its own axis through its pos.
        """
        axis = axis or self.axis
        origin = origin or self.pos
        self.pos = origin + (self.pos - origin).rotate(angle, axis)
        self.axis = self.axis.rotate(angle, axis)
        self.up = self.up.rotate(angle, axis)


class box(Shape):
    pass


class Round(Shape):
    radius = 1.0
    height = width = property(lambda shape: 2 * shape.radius)


class sphere(Round):
    length = Round.height  # its axis says only how it is turned


class cylinder(Round):
    pass


# --- what computes nothing of a cradle -----------------------------------------------------------


def arange(*limits: float, **options: Any) -> Any:
    from numpy import arange  # not earlier: its import is slow

    return arange(*limits, **options)


def sign(x: float) -> int:
    if x > 0:
        return 1
    return -1 if x < 0 else 0


class ForShow:
    """Stands for all that is only for show: it takes any call and any attribute."""

    def __init__(self, **attributes: Any) -> None:
        for name, value in attributes.items():
            setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        """Copy a vector: arrow(pos=bob.pos) must not share the bob's own pos."""
        super().__setattr__(name, vector(value) if isinstance(value, vector) else value)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # Python itself asks for these
            raise AttributeError(name)
        return ForShow()

    def __call__(self, *_: object, **attributes: Any) -> "ForShow":
        return ForShow(**attributes)


scene = ForShow(objects=[])  # all shapes, in the order in which they were made

COMPUTE = """
arange box clock color combin comp cross cylinder diff_angle dot hat mag mag2 norm proj random
rate rotate scene sign sphere textures vec vector
"""
FOR_SHOW = """
Camera GSversion GlowWidget Mouse RackOutline ToothOutline addpos adjust_axis adjust_up arrow
attach_arrow attach_light attach_trail baseObj bumpmaps button canvas checkbox compound cone
controls convert curve curveMethods distant_light ellipsoid event_return extrusion faces frame
gcurve gdots ghbars gobj graph gs_version gvbars helix keysdown label local_light menu meta_canvas
object_rotate path_object paths points pyramid quad radio rate_control ring rotatecp roundc
scalecp set_browser shape_object shapes shapespaths simple_sphere sleep slider standardAttributes
text triangle version vertex winput wtext
"""


def __getattr__(name: str) -> ForShow:
    """Return a thing for show if VPython has this name: Python asks when the module lacks it."""
    if name not in FOR_SHOW.split():
        raise AttributeError(f"module 'vpython' has no attribute '{name}'")
    return ForShow()


# The names that `from vpython import *` brings
__all__ = [*COMPUTE.split(), *FOR_SHOW.split(), *[name for name in dir(math) if name[0] != "_"]]
