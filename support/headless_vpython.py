"""A stand-in for VPython that needs no VPython and no browser: vector, box, sphere and cylinder as plain numbers.

After install(), `import vpython` finds this module. It shows nothing. Otherwise it treats the objects of a pendulum as
VPython 7.6.5 does; the project's tests compare the two. One difference: `up` does not turn with `axis`. The parts of
the page that the viewer uses (canvas, light, widgets, graph) only store their attributes.
"""

import sys
from math import *  # noqa: F403  VPython exports these, too
from math import acos, cos, pi, sin, sqrt


def install() -> None:
    """Let `import vpython` find this module, in this process, from now on."""
    sys.modules["vpython"] = sys.modules[__name__]


# --- vectors ---------------------------------------------------------------------------------------------------------


def number(value) -> float:
    """Return value as a float; raise a TypeError if it is no number, or is text."""
    if isinstance(value, str):
        raise TypeError("must be real number, not str")
    return float(value)


class vector:
    """A vector of three floats. Setting x, y or z calls on_change, with which its shape follows."""

    __slots__ = ("_x", "_y", "_z", "on_change")

    def __init__(self, *components):
        if len(components) == 1 and isinstance(components[0], vector):
            components = components[0].value
        if len(components) != 3:
            raise TypeError("A vector needs 3 components.")
        self._x, self._y, self._z = map(number, components)
        self.on_change = lambda: None

    @property
    def x(self):
        return self._x

    @x.setter
    def x(self, value):
        self._x = number(value)
        self.on_change()

    @property
    def y(self):
        return self._y

    @y.setter
    def y(self, value):
        self._y = number(value)
        self.on_change()

    @property
    def z(self):
        return self._z

    @z.setter
    def z(self, value):
        self._z = number(value)
        self.on_change()

    @property
    def value(self):
        """The components as a list. Setting it copies the components of a vector, without a call of on_change."""
        return [self._x, self._y, self._z]

    @value.setter
    def value(self, other):
        self._x, self._y, self._z = other._x, other._y, other._z

    @property
    def mag2(self):
        return self._x**2 + self._y**2 + self._z**2

    @property
    def mag(self):
        return sqrt(self.mag2)

    @mag.setter
    def mag(self, length):
        self.value = self.hat * length
        self.on_change()

    @property
    def hat(self):
        length = self.mag
        return self / length if length > 0 else vector(0, 0, 0)

    def norm(self):
        return self.hat

    def dot(self, other):
        return self._x * other._x + self._y * other._y + self._z * other._z

    def cross(self, other):
        return vector(
            self._y * other._z - self._z * other._y,
            self._z * other._x - self._x * other._z,
            self._x * other._y - self._y * other._x,
        )

    def comp(self, other):
        return self.dot(other.hat)

    def proj(self, other):
        return other.hat * self.comp(other)

    def diff_angle(self, other):
        return acos(max(-1, min(1, self.hat.dot(other.hat))))

    def rotate(self, angle=0.0, axis=None):
        """Return this vector turned by angle (rad) about axis, by default z (Rodrigues' rotation formula)."""
        k = vector(0, 0, 1) if axis is None else axis.hat
        return self * cos(angle) + k.cross(self) * sin(angle) + k * (k.dot(self) * (1 - cos(angle)))

    def equals(self, other):
        return self.value == other.value

    def __eq__(self, other):
        return isinstance(other, vector) and self.equals(other)

    __hash__ = None  # type: ignore[assignment]  # a vector can change, so it cannot be a key

    def __neg__(self):
        return vector(-self._x, -self._y, -self._z)

    def __pos__(self):
        return self

    def __add__(self, other):
        if not isinstance(other, vector):
            return NotImplemented
        return vector(self._x + other._x, self._y + other._y, self._z + other._z)

    def __sub__(self, other):
        if not isinstance(other, vector):
            return NotImplemented
        return vector(self._x - other._x, self._y - other._y, self._z - other._z)

    def __mul__(self, factor):
        if not isinstance(factor, (int, float)):
            return NotImplemented
        return vector(self._x * factor, self._y * factor, self._z * factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor):
        if not isinstance(divisor, (int, float)):
            return NotImplemented
        return vector(self._x / divisor, self._y / divisor, self._z / divisor)

    def __str__(self):
        return f"<{self._x:.6g}, {self._y:.6g}, {self._z:.6g}>"

    def __repr__(self):
        return f"vector({self._x:.6g}, {self._y:.6g}, {self._z:.6g})"


vec = vector


def checked(value) -> vector:
    """Return value if it is a vector; raise a TypeError otherwise."""
    if not isinstance(value, vector):
        raise TypeError(f"expected a vector, got {type(value).__name__}")
    return value


def mag(A):
    return checked(A).mag


def mag2(A):
    return checked(A).mag2


def hat(A):
    return checked(A).hat


norm = hat


def dot(A, B):
    return checked(A).dot(checked(B))


def cross(A, B):
    return checked(A).cross(checked(B))


def comp(A, B):
    return checked(A).comp(checked(B))


def proj(A, B):
    return checked(A).proj(checked(B))


def diff_angle(A, B):
    return checked(A).diff_angle(checked(B))


def rotate(A, angle=0.0, axis=None):
    return checked(A).rotate(angle, axis)


# --- shapes ----------------------------------------------------------------------------------------------------------


class Shape:
    """The base of box, sphere and cylinder. Setting a vector copies it; reading it returns the shape's own vector."""

    default_size = (1, 1, 1)
    axis_is_length = True  # the axis is as long as the shape (not so for a sphere)

    def __init__(self, **attributes):
        self._pos, self._up, self._color = vector(0, 0, 0), vector(0, 1, 0), vector(1, 1, 1)
        self._axis, self._size = vector(1, 0, 0), vector(*self.default_size)
        self._axis.on_change, self._size.on_change = self.fit_size, self.fit_axis
        self.texture, self.shininess, self.opacity = None, 0.6, 1.0
        self.emissive, self.visible, self.pickable = False, True, True
        vectors: list[str] = [name for name in ("pos", "color", "axis", "size", "up") if name in attributes]
        for name in vectors:
            if not isinstance(attributes[name], vector):
                raise AttributeError(f"{name} must be a vector")
        for name in vectors + [name for name in attributes if name not in vectors]:
            setattr(self, name, attributes[name])

    def fit_size(self):
        if self.axis_is_length:
            self._size._x = self._axis.mag

    def fit_axis(self):
        if self.axis_is_length:
            self._axis.value = self._axis.hat * self._size._x

    @property
    def pos(self):
        return self._pos

    @pos.setter
    def pos(self, value):
        self._pos.value = value

    @property
    def up(self):
        return self._up

    @up.setter
    def up(self, value):
        self._up.value = value

    @property
    def color(self):
        return self._color

    @color.setter
    def color(self, value):
        self._color.value = value

    @property
    def axis(self):
        return self._axis

    @axis.setter
    def axis(self, value):
        self._axis.value = value
        self.fit_size()

    @property
    def size(self):
        return self._size

    @size.setter
    def size(self, value):
        self._size.value = value
        self.fit_axis()

    @property
    def length(self):
        return self._size._x

    @length.setter
    def length(self, value):
        self._size.x = value

    @property
    def height(self):
        return self._size._y

    @height.setter
    def height(self, value):
        self._size.y = value

    @property
    def width(self):
        return self._size._z

    @width.setter
    def width(self, value):
        self._size.z = value

    def rotate(self, angle, axis=None, origin=None):
        """Turn the shape by angle (rad) about axis (its own by default) through origin (its pos by default)."""
        axis, origin = vector(axis or self._axis), vector(origin or self._pos)
        self._pos.value = origin + (self._pos - origin).rotate(angle, axis)
        self._axis.value = self._axis.rotate(angle, axis)
        self._up.value = self._up.rotate(angle, axis)


class box(Shape):
    pass


class sphere(Shape):
    default_size = (2, 2, 2)
    axis_is_length = False

    @property
    def radius(self):
        return self._size._y / 2

    @radius.setter
    def radius(self, value):
        self.size = vector(2 * value, 2 * value, 2 * value)


class cylinder(Shape):
    default_size = (1, 2, 2)

    @property
    def radius(self):
        return self._size._y / 2

    @radius.setter
    def radius(self, value):
        self.size = vector(self._size._x, 2 * value, 2 * value)


# --- the page --------------------------------------------------------------------------------------------------------


class baseObj:
    """VPython's record of changes that the page has not fetched yet; here it is always empty."""

    @staticmethod
    def empty():
        return True


class PageItem:
    """An item of the page that is no shape. It stores its attributes; a test can read and set them."""

    def __init__(self, **attributes):
        vars(self).update(attributes)


class wtext(PageItem):
    text = ""


class label(PageItem):
    text, visible = "", True


class button(PageItem):
    text, disabled = "", False


class checkbox(PageItem):
    text, checked, disabled = "", False, False


class winput(PageItem):
    text = ""


class menu(PageItem):
    selected, disabled = None, False
    choices: list = []

    @property
    def index(self):
        return None if self.selected is None else self.choices.index(self.selected)

    @index.setter
    def index(self, value):
        self.selected = self.choices[value]


class slider(PageItem):
    min, max, disabled = 0, 1, False

    def __init__(self, **attributes):
        super().__init__(**{"value": attributes.get("min", self.min), **attributes})


class graph(PageItem):
    width, height = 640, 400


class gcurve(PageItem):
    data: list = []


class distant_light(PageItem):
    def __init__(self, **attributes):
        super().__init__(**attributes)
        scene.lights.append(self)


class canvas(PageItem):
    width, height, range, fov, caption = 640, 400, 1, pi / 3, ""

    def __init__(self):
        self.center, self.forward, self.up = vector(0, 0, 0), vector(0, 0, -1), vector(0, 1, 0)
        self.mouse = PageItem(ray=vector(0, 0, -1))
        self.lights: list = []
        self.bound: dict = {}  # event -> function

    def append_to_caption(self, text):
        self.caption += text

    def bind(self, events, function):
        self.bound.update(dict.fromkeys(events.split(), function))


scene = canvas()


# --- names -----------------------------------------------------------------------------------------------------------


class color:
    black, white = vector(0, 0, 0), vector(1, 1, 1)
    red, green, blue = vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)
    yellow, cyan, magenta = vector(1, 1, 0), vector(0, 1, 1), vector(1, 0, 1)
    orange, purple = vector(1, 0.6, 0), vector(0.4, 0.2, 0.6)

    @staticmethod
    def gray(luminance):
        return vector(luminance, luminance, luminance)


class textures:
    flower, granite, gravel = ":flower_texture.jpg", ":granite_texture.jpg", ":gravel_texture.jpg"
    earth, metal, rock = ":earth_texture.jpg", ":metal_texture.jpg", ":rock_texture.jpg"
    rough, rug, stones = ":rough_texture.jpg", ":rug_texture.jpg", ":stones_texture.jpg"
    stucco, wood, wood_old = ":stucco_texture.jpg", ":wood_texture.jpg", ":wood_old_texture.jpg"


def rate(frequency):
    """Return immediately: this module shows nothing, so there is nothing to wait for."""
