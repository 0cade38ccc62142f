"""The stand-in's shapes of a pendulum, which keep their measures as VPython's do.

The other things are only for show: they store what a program sets, and do nothing.
"""

from collections.abc import Iterator
from math import pi, sqrt
from operator import attrgetter
from typing import Any

from support.headless_vector import nothing, vector
from support.waits import heard

# The vectors of a thing before a program sets them.
FIRST = {
    "pos": (0, 0, 0),
    "axis": (1, 0, 0),
    "up": (0, 1, 0),
    "size": (1, 1, 1),
    "color": (1, 1, 1),
}


def _own_vector(name: str) -> Any:
    """Return a property: a vector of a shape.

    Setting it copies a vector; reading it returns the shape's own vector.
    """

    def set_vector(shape: "standardAttributes", v: vector) -> None:
        own = getattr(shape, name)
        own.value = v
        own.on_change()

    return property(attrgetter(name), set_vector)


def _component_of(own_vector: str, name: str) -> Any:
    """Return a property: the component with this name of a vector of a shape."""

    def set_component(shape: "standardAttributes", value: float) -> None:
        setattr(getattr(shape, own_vector), name, value)

    return property(attrgetter(f"{own_vector}.{name}"), set_component)


class standardAttributes:
    _first = FIRST
    _has_long_axis = True  # the axis is as long as the shape (not so for a sphere)
    _axis: vector
    _pos: vector
    _size: vector
    _up: vector
    pos = _own_vector("_pos")
    axis = _own_vector("_axis")
    up = _own_vector("_up")
    size = _own_vector("_size")
    length = _component_of("_size", "x")
    height = _component_of("_size", "y")
    width = _component_of("_size", "z")
    color = _own_vector("_color")
    red = _component_of("_color", "x")
    green = _component_of("_color", "y")
    blue = _component_of("_color", "z")
    texture = None
    shininess = 0.6
    opacity = 1.0
    emissive = False
    visible = True
    pickable = True
    make_trail = False
    trail_type = "curve"
    trail_color = property(attrgetter("_color"), nothing)
    trail_radius = property(lambda shape: shape.height / 10, nothing)
    interval = 0
    retain = -1
    frame = None
    delete = clear_trail = bounding_box = nothing

    def __init__(self, **attributes: Any) -> None:
        for name, components in self._first.items():
            setattr(self, f"_{name}", vector(*components))
        if self._has_long_axis:
            self._axis.on_change = self._fit_size
            self._size.on_change = self._fit_axis
        self.canvas = scene
        for name in FIRST:  # before the numbers, such as radius
            if name in attributes:
                value = attributes.pop(name)
                if not isinstance(value, vector):
                    raise AttributeError(f"{name} must be a vector")
                setattr(self, name, value)
        self._set(attributes)
        self.canvas._made.append(self)

    def _set(self, attributes: dict[str, Any]) -> None:
        for name, value in attributes.items():
            setattr(self, name, value)

    def _fit_size(self) -> None:
        self._size._x = self._axis.mag

    def _fit_axis(self) -> None:
        self._axis.value = self._axis.hat * self._size._x

    def clone(self, **attributes: Any) -> Any:
        """Return a copy of the shape, with these attributes."""
        names = [*FIRST, "texture", "opacity", "shininess", "emissive", "pickable"]
        copy = type(self)(**{name: getattr(self, name) for name in names})
        copy._set(attributes)
        return copy

    def rotate(self, angle: float, axis: Any = None, origin: Any = None) -> None:
        """Turn the shape by angle (rad) about axis through origin.

        Without them, it turns about its own axis through its pos.
        """
        axis = vector(axis or self._axis)
        origin = vector(origin or self._pos)
        self._pos.value = origin + (self._pos - origin).rotate(angle, axis)
        self._axis.value = self._axis.rotate(angle, axis)
        self._up.value = self._up.rotate(angle, axis)


class box(standardAttributes):
    pass


class _Round(standardAttributes):
    @property
    def radius(self) -> float:
        return self._size._y / 2

    @radius.setter
    def radius(self, value: float) -> None:
        length = self._size._x if self._has_long_axis else 2 * value
        self.size = vector(length, 2 * value, 2 * value)


class sphere(_Round):
    _first = FIRST | {"size": (2, 2, 2)}
    _has_long_axis = False


class cylinder(_Round):
    _first = FIRST | {"size": (1, 2, 2)}


class baseObj:
    """A thing that is only for show: it stores its attributes, and its methods do nothing."""

    def __init__(self, *_: object, **attributes: Any) -> None:
        for name, value in attributes.items():
            setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        """Copy a vector: arrow(pos=bob.pos) must not share the bob's own pos."""
        super().__setattr__(name, vector(value) if isinstance(value, vector) else value)

    def __getattr__(self, name: str) -> Any:
        """Return an attribute that nobody has set: its first vector, or a thing for show."""
        if name.startswith("_"):
            raise AttributeError(name)
        setattr(self, name, vector(*FIRST[name]) if name in FIRST else baseObj())
        return getattr(self, name)

    def __call__(self, *_: object, **__: object) -> "baseObj":
        return baseObj()

    def __iter__(self) -> Iterator:
        return iter(())

    def __bool__(self) -> bool:
        return type(self) is not baseObj  # an attribute that nobody has set is as good as None


class canvas(baseObj):
    width = 640
    height = 400
    range = 1
    fov = pi / 3
    pause = heard("scene.pause", baseObj)
    waitfor = heard("scene.waitfor", baseObj)

    def __init__(self, **attributes: Any) -> None:
        self.center = vector(0, 0, 0)
        self.forward = vector(0, 0, -1)
        self.background = vector(0, 0, 0)
        self.mouse = baseObj(ray=vector(0, 0, -1), pick=None)
        self.camera = baseObj(pos=vector(0, 0, sqrt(3)), axis=vector(0, 0, -sqrt(3)))
        self._made: list = []  # all shapes, also those that a program has hidden or lost
        super().__init__(**attributes)

    @property
    def objects(self) -> list:
        """The visible shapes, in the order in which they were made."""
        return [shape for shape in self._made if shape.visible]


scene = canvas()
