"""The stand-in's vectors and colors: they compute as VPython's."""

import colorsys
from math import acos, cos, sin, sqrt
from operator import attrgetter
from random import random
from typing import Any


def nothing(*_: object, **__: object) -> None:
    """Do nothing: a function or method of VPython that waits, or only changes the picture."""


def _number(value: Any) -> float:
    """Return value as a float; raise a TypeError if it is no number, or is text."""
    if isinstance(value, str):
        raise TypeError("must be real number, not str")
    return float(value)


def _component(attribute: str) -> Any:
    """Return a property: a component of a vector, stored in this attribute.

    Setting it calls on_change.
    """

    def set_component(v: "vector", value: Any) -> None:
        setattr(v, attribute, _number(value))
        v.on_change()

    return property(attrgetter(attribute), set_component)


class vector:
    """A vector of three floats.

    Setting x, y, z or mag calls on_change, with which its shape follows.
    """

    __slots__ = ("_x", "_y", "_z", "on_change")
    x = _component("_x")
    y = _component("_y")
    z = _component("_z")

    def __init__(self, *components: Any) -> None:
        if len(components) == 1 and isinstance(components[0], vector):
            components = components[0].value
        if len(components) != 3:
            raise TypeError("A vector needs 3 components.")
        self._x, self._y, self._z = map(_number, components)
        self.on_change: Any = nothing

    @staticmethod
    def random() -> "vector":
        """Return a vector with components from -1 to 1."""
        return vector(2 * random() - 1, 2 * random() - 1, 2 * random() - 1)

    @property
    def value(self) -> Any:
        """The components as a list.

        Setting it copies the components of a vector, without a call of on_change.
        """
        return [self._x, self._y, self._z]

    @value.setter
    def value(self, other: "vector") -> None:
        self._x = other._x
        self._y = other._y
        self._z = other._z

    @property
    def mag2(self) -> float:
        return self._x**2 + self._y**2 + self._z**2

    @property
    def mag(self) -> float:
        return sqrt(self.mag2)

    @mag.setter
    def mag(self, length: float) -> None:
        self.value = self.hat * length
        self.on_change()

    def norm(self) -> "vector":
        length = self.mag
        return self / length if length > 0 else vector(0, 0, 0)

    hat = property(norm)

    def dot(self, other: "vector") -> float:
        return self._x * other._x + self._y * other._y + self._z * other._z

    def cross(self, other: "vector") -> "vector":
        return vector(
            self._y * other._z - self._z * other._y,
            self._z * other._x - self._x * other._z,
            self._x * other._y - self._y * other._x,
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

    def equals(self, other: "vector") -> bool:
        return self.value == other.value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, vector) and self.equals(other)

    __hash__ = None  # type: ignore[assignment]  # a vector can change, so it cannot be a key

    def __neg__(self) -> "vector":
        return vector(-self._x, -self._y, -self._z)

    def __pos__(self) -> "vector":
        return self

    def __add__(self, other: "vector") -> "vector":
        if not isinstance(other, vector):
            return NotImplemented
        return vector(self._x + other._x, self._y + other._y, self._z + other._z)

    def __sub__(self, other: "vector") -> "vector":
        if not isinstance(other, vector):
            return NotImplemented
        return vector(self._x - other._x, self._y - other._y, self._z - other._z)

    def __mul__(self, factor: float) -> "vector":
        if not isinstance(factor, (int, float)):
            return NotImplemented
        return vector(self._x * factor, self._y * factor, self._z * factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: float) -> "vector":
        if not isinstance(divisor, (int, float)):
            return NotImplemented
        return vector(self._x / divisor, self._y / divisor, self._z / divisor)

    def __str__(self) -> str:
        return f"<{self._x:.6g}, {self._y:.6g}, {self._z:.6g}>"

    def __repr__(self) -> str:
        return f"vector({self._x:.6g}, {self._y:.6g}, {self._z:.6g})"


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
    def rgb_to_hsv(v: vector) -> vector:
        return vector(*colorsys.rgb_to_hsv(*v.value))

    @staticmethod
    def hsv_to_rgb(v: vector) -> vector:
        return vector(*colorsys.hsv_to_rgb(*v.value))

    @staticmethod
    def rgb_to_grayscale(v: vector) -> vector:
        return color.gray(0.21 * v.x + 0.71 * v.y + 0.07 * v.z)
