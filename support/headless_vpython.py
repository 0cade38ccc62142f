"""A stand-in for VPython that needs no VPython and no browser: vector, box, sphere and cylinder as
plain numbers.

After `import support.headless_vpython`, `import vpython` finds this module. It has the names of
VPython 7.6.5, and treats vectors and the shapes of a pendulum as VPython does; the project's tests
compare the two. One difference: `axis` and `up` do not turn each other. The rest of VPython is only
for show, and here nothing is shown: it stores the attributes that a program sets, its methods do
nothing, and nothing waits.
"""

import colorsys
import sys
from math import *  # noqa: F403  VPython exports these, too
from math import acos, cos, pi, sin, sqrt
from math import comb as combin  # noqa: F401  VPython's name for it
from operator import attrgetter
from random import random
from time import perf_counter as clock  # noqa: F401  VPython's name for it

sys.modules["vpython"] = sys.modules[__name__]


def _nothing(*_, **__):
    """Do nothing: a function or method of VPython that waits, or only changes the picture."""


def _number(value) -> float:
    """Return value as a float; raise a TypeError if it is no number, or is text."""
    if isinstance(value, str):
        raise TypeError("must be real number, not str")
    return float(value)


def _component(attribute):
    """Return a property: a component of a vector, stored in this attribute.

    Setting it calls on_change.
    """

    def set_component(v, value):
        setattr(v, attribute, _number(value))
        v.on_change()

    return property(attrgetter(attribute), set_component)


class vector:
    """A vector of three floats.

    Setting x, y, z or mag calls on_change, with which its shape follows.
    """

    __slots__ = ("_x", "_y", "_z", "on_change")
    x, y, z = _component("_x"), _component("_y"), _component("_z")

    def __init__(self, *components):
        if len(components) == 1 and isinstance(components[0], vector):
            components = components[0].value
        if len(components) != 3:
            raise TypeError("A vector needs 3 components.")
        self._x, self._y, self._z = map(_number, components)
        self.on_change = _nothing

    @staticmethod
    def random():
        """Return a vector with components from -1 to 1."""
        return vector(2 * random() - 1, 2 * random() - 1, 2 * random() - 1)

    @property
    def value(self):
        """The components as a list.

        Setting it copies the components of a vector, without a call of on_change.
        """
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

    def norm(self):
        length = self.mag
        return self / length if length > 0 else vector(0, 0, 0)

    hat = property(norm)

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
        """Return this vector turned by angle (rad) about axis, by default z (Rodrigues' rotation
        formula).
        """
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
# VPython's functions dot(A, B), ... do the same as the methods.
dot, cross, comp, proj = vector.dot, vector.cross, vector.comp, vector.proj
diff_angle, rotate, norm, hat = vector.diff_angle, vector.rotate, vector.norm, vector.norm
mag, mag2 = (vars(vector)[name].fget for name in ("mag", "mag2"))


class color:
    black, white = vector(0, 0, 0), vector(1, 1, 1)
    red, green, blue = vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)
    yellow, cyan, magenta = vector(1, 1, 0), vector(0, 1, 1), vector(1, 0, 1)
    orange, purple = vector(1, 0.6, 0), vector(0.4, 0.2, 0.6)

    gray = staticmethod(lambda luminance: vector(luminance, luminance, luminance))
    rgb_to_hsv = staticmethod(lambda v: vector(*colorsys.rgb_to_hsv(*v.value)))
    hsv_to_rgb = staticmethod(lambda v: vector(*colorsys.hsv_to_rgb(*v.value)))
    rgb_to_grayscale = staticmethod(lambda v: color.gray(0.21 * v.x + 0.71 * v.y + 0.07 * v.z))


_TEXTURES = "flower granite gravel earth metal rock rough rug stones stucco wood wood_old"
textures = type("textures", (), {name: f":{name}_texture.jpg" for name in _TEXTURES.split()})


def _own_vector(name):
    """Return a property: a vector of a shape.

    Setting it copies a vector; reading it returns the shape's own vector.
    """

    def set_vector(shape, v):
        own = getattr(shape, name)
        own.value = v
        own.on_change()

    return property(attrgetter(name), set_vector)


def _part(whole, name):
    """Return a property: the component with this name of a vector of a shape."""
    return property(
        attrgetter(f"{whole}.{name}"),
        lambda shape, value: setattr(getattr(shape, whole), name, value),
    )


class standardAttributes:
    _default_size: tuple[float, float, float] = (1, 1, 1)
    _sizing = True  # the axis is as long as the shape (not so for a sphere)
    pos, axis, up = _own_vector("_pos"), _own_vector("_axis"), _own_vector("_up")
    size, color = _own_vector("_size"), _own_vector("_color")
    length, height, width = _part("_size", "x"), _part("_size", "y"), _part("_size", "z")
    red, green, blue = _part("_color", "x"), _part("_color", "y"), _part("_color", "z")
    texture, shininess, opacity, emissive, visible, pickable = None, 0.6, 1.0, False, True, True
    make_trail, trail_type, interval, retain, frame = False, "curve", 0, -1, None
    trail_color = property(attrgetter("_color"), _nothing)
    trail_radius = property(lambda s: s.height / 10, _nothing)
    delete = clear_trail = bounding_box = _nothing

    def __init__(self, **attributes):
        self._pos, self._up, self._color = vector(0, 0, 0), vector(0, 1, 0), vector(1, 1, 1)
        self._axis, self._size = vector(1, 0, 0), vector(*self._default_size)
        if self._sizing:
            self._axis.on_change, self._size.on_change = self._fit_size, self._fit_axis
        self.canvas = scene
        vectors = {
            name: attributes[name]
            for name in ("pos", "color", "axis", "size", "up")
            if name in attributes
        }
        for name, value in (vectors | attributes).items():  # the vectors come first
            if name in vectors and not isinstance(value, vector):
                raise AttributeError(f"{name} must be a vector")
            setattr(self, name, value)
        self.canvas._made.append(self)

    def _fit_size(self):
        self._size._x = self._axis.mag

    def _fit_axis(self):
        self._axis.value = self._axis.hat * self._size._x

    def clone(self, **attributes):
        """Return a copy of the shape, with these attributes."""
        names = (
            "pos",
            "size",
            "axis",
            "up",
            "color",
            "texture",
            "opacity",
            "shininess",
            "emissive",
            "pickable",
        )
        made = type(self)(**{name: getattr(self, name) for name in names})
        for name, value in attributes.items():
            setattr(made, name, value)
        return made

    def rotate(self, angle, axis=None, origin=None):
        """Turn the shape by angle (rad) about axis (its own by default) through origin (its pos by
        default).
        """
        axis, origin = vector(axis or self._axis), vector(origin or self._pos)
        self._pos.value = origin + (self._pos - origin).rotate(angle, axis)
        self._axis.value = self._axis.rotate(angle, axis)
        self._up.value = self._up.rotate(angle, axis)


class box(standardAttributes):
    pass


class _Round(standardAttributes):
    @property
    def radius(self):
        return self._size._y / 2

    @radius.setter
    def radius(self, value):
        self.size = vector(self._size._x if self._sizing else 2 * value, 2 * value, 2 * value)


class sphere(_Round):
    _default_size, _sizing = (2, 2, 2), False


class cylinder(_Round):
    _default_size = (1, 2, 2)


# Everything else is only for show. The vectors that some of these things have before a program sets
# them:
_FIRST = {
    "pos": (0, 0, 0),
    "axis": (1, 0, 0),
    "up": (0, 1, 0),
    "size": (1, 1, 1),
    "color": (1, 1, 1),
}


class baseObj:
    """A thing that is only for show: it stores its attributes, and all calls of it and its methods
    do nothing.
    """

    def __init__(self, *_, **attributes):
        for name, value in attributes.items():
            setattr(self, name, value)

    def __setattr__(self, name, value):
        """Copy a vector: arrow(pos=bob.pos) must not share the bob's own pos."""
        super().__setattr__(name, vector(value) if isinstance(value, vector) else value)

    def __getattr__(self, name):
        """Return an attribute that nobody has set: its first vector, or something that does
        nothing.
        """
        if name.startswith("_"):
            raise AttributeError(name)
        setattr(self, name, vector(*_FIRST[name]) if name in _FIRST else baseObj())
        return getattr(self, name)

    def __call__(self, *_, **__):
        return baseObj()

    def __iter__(self):
        return iter(())

    def __bool__(self):
        return type(self) is not baseObj  # what nobody has set is as good as None


class canvas(baseObj):
    width, height, range, fov = 640, 400, 1, pi / 3

    def __init__(self, **attributes):
        self.center = vector(0, 0, 0)
        self.forward = vector(0, 0, -1)
        self.background = vector(0, 0, 0)
        self.mouse = baseObj(ray=vector(0, 0, -1), pick=None)
        self.camera = baseObj(pos=vector(0, 0, sqrt(3)), axis=vector(0, 0, -sqrt(3)))
        self._made: list = []  # all shapes, also those that a program has hidden or lost
        super().__init__(**attributes)

    @property
    def objects(self):
        """The visible shapes, in the order in which they were made."""
        return [shape for shape in self._made if shape.visible]


scene = canvas()
rate = sleep = set_browser = _nothing  # nothing is shown, so there is nothing to wait for
version, GSversion = ["7.6.5", "jupyter"], ["3.2", "glowscript"]


def arange(*limits, **options):
    from numpy import arange  # not earlier: its import is slow

    return arange(*limits, **options)


def sign(x):
    return 1 if x > 0 else -1 if x < 0 else 0


_FOR_SHOW = """
Camera GlowWidget Mouse RackOutline ToothOutline addpos adjust_axis adjust_up arrow attach_arrow attach_light
attach_trail bumpmaps button checkbox compound cone controls convert curve curveMethods distant_light ellipsoid
event_return extrusion faces frame gcurve gdots ghbars gobj graph gs_version gvbars helix keysdown label local_light
menu meta_canvas object_rotate path_object paths points pyramid quad radio rate_control ring rotatecp roundc scalecp
shape_object shapes shapespaths simple_sphere slider text triangle vertex winput wtext
"""
# Those that are no classes
_OBJECTS = "bumpmaps", "gs_version", "paths", "rate_control", "shapes", "shapespaths"


def __getattr__(name):
    """Python calls this for a name that the module lacks: return a thing for show if VPython has
    this name.
    """
    if name not in _FOR_SHOW.split():
        raise AttributeError(f"module 'vpython' has no attribute '{name}'")
    made = baseObj() if name in _OBJECTS else type(name, (baseObj,), {})
    globals()[name] = made  # from now on, the name means the same thing
    return made


# What `from vpython import *` brings.
__all__ = [
    name for name in dir() if name[0] != "_" and name not in ("attrgetter", "colorsys", "sys")
]
__all__ += _FOR_SHOW.split()
