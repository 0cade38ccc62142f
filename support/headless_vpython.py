"""A stand-in for VPython that needs no VPython and no browser: vector, box, sphere and cylinder as plain numbers.

After install(), `import vpython` finds this module. It has the names of VPython 7.6.5, and treats the objects of a
pendulum as VPython does; the project's tests compare the two. One difference: `up` does not turn with `axis`. The rest
of VPython is only for show, and here nothing is shown: other shapes and the page (canvas, label, widgets, graph) store
their attributes, most of their methods do nothing, and nothing waits.
"""

import colorsys
import sys
from copy import deepcopy
from math import *  # noqa: F403  VPython exports these, too
from math import acos, cos, pi, sin, sqrt, tan
from random import random
from time import perf_counter as clock  # noqa: F401  VPython's name for it


def install() -> None:
    """Let `import vpython` find this module, in this process, from now on."""
    sys.modules["vpython"] = sys.modules[__name__]


def _nothing(*_, **__):
    """Do nothing: a function or method of VPython that only changes what is shown."""


def _no_points(*_, **__) -> list:
    """Return no points: a function of VPython that makes an outline."""
    return []


# --- vectors ---------------------------------------------------------------------------------------------------------


def _number(value) -> float:
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
        self._x, self._y, self._z = map(_number, components)
        self.on_change = lambda: None

    @staticmethod
    def random():
        """Return a vector with components from -1 to 1."""
        return vector(2 * random() - 1, 2 * random() - 1, 2 * random() - 1)

    @property
    def x(self):
        return self._x

    @x.setter
    def x(self, value):
        self._x = _number(value)
        self.on_change()

    @property
    def y(self):
        return self._y

    @y.setter
    def y(self, value):
        self._y = _number(value)
        self.on_change()

    @property
    def z(self):
        return self._z

    @z.setter
    def z(self, value):
        self._z = _number(value)
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


def _checked(value) -> vector:
    """Return value if it is a vector; raise a TypeError otherwise."""
    if not isinstance(value, vector):
        raise TypeError(f"expected a vector, got {type(value).__name__}")
    return value


def mag(A):
    return _checked(A).mag


def mag2(A):
    return _checked(A).mag2


def hat(A):
    return _checked(A).hat


norm = hat


def dot(A, B):
    return _checked(A).dot(_checked(B))


def cross(A, B):
    return _checked(A).cross(_checked(B))


def comp(A, B):
    return _checked(A).comp(_checked(B))


def proj(A, B):
    return _checked(A).proj(_checked(B))


def diff_angle(A, B):
    return _checked(A).diff_angle(_checked(B))


def rotate(A, angle=0.0, axis=None):
    return _checked(A).rotate(angle, axis)


# --- shapes ----------------------------------------------------------------------------------------------------------


class baseObj:
    """The base of all that is on the page. It stores its attributes; a test can read and set them."""

    def __init__(self, **attributes):
        vars(self).update(attributes)

    @staticmethod
    def empty():
        """Return whether the page has fetched all changes: there are none."""
        return True

    delete = _nothing


class standardAttributes(baseObj):
    """The base of the shapes. Setting a vector copies it; reading it returns the shape's own vector."""

    _default_size: tuple[float, float, float] = (1, 1, 1)
    _sizing = True  # the axis is as long as the shape (not so for a sphere)
    _more_vectors: tuple[str, ...] = ()  # other attributes that must be vectors
    texture, shininess, opacity, emissive, visible, pickable = None, 0.6, 1.0, False, True, True
    make_trail, trail_type, interval, retain, pps, frame = False, "curve", 0, -1, 0, None
    clear_trail = _nothing

    def __init__(self, **attributes):
        self._pos, self._up, self._color = vector(0, 0, 0), vector(0, 1, 0), vector(1, 1, 1)
        self._axis, self._size = vector(1, 0, 0), vector(*self._default_size)
        self._axis.on_change, self._size.on_change = self._fit_size, self._fit_axis
        vectors = [name for name in ("pos", "color", "axis", "size", "up", *self._more_vectors) if name in attributes]
        for name in vectors:
            if not isinstance(attributes[name], vector):
                raise AttributeError(f"{name} must be a vector")
        for name in vectors + [name for name in attributes if name not in vectors]:
            setattr(self, name, attributes[name])
        self.canvas = attributes.get("canvas") or canvas.selected
        self._show()

    def _show(self):
        self.canvas._made.append(self)

    def _fit_size(self):
        if self._sizing:
            self._size._x = self._axis.mag

    def _fit_axis(self):
        if self._sizing:
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
        self._fit_size()

    @property
    def size(self):
        return self._size

    @size.setter
    def size(self, value):
        self._size.value = value
        self._fit_axis()

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

    @property
    def red(self):
        return self._color._x

    @red.setter
    def red(self, value):
        self._color.x = value

    @property
    def green(self):
        return self._color._y

    @green.setter
    def green(self, value):
        self._color.y = value

    @property
    def blue(self):
        return self._color._z

    @blue.setter
    def blue(self, value):
        self._color.z = value

    def clone(self, **attributes):
        """Return a copy of the shape, with these attributes."""
        made = deepcopy(self, {id(self.canvas): self.canvas})
        made._show()
        for name, value in {"visible": True, **attributes}.items():
            setattr(made, name, value)
        return made

    def bounding_box(self):
        """Return the eight corners of the smallest box around the shape."""
        x, y = self._axis.hat, self._up.hat
        z = x.cross(y)
        middle = self._pos if isinstance(self, _CENTERED) else self._pos + x * (self._size._x / 2)
        length, height, width = self._size.value
        return [
            middle + x * (i * length / 2) + y * (j * height / 2) + z * (k * width / 2)
            for i in (-1, 1)
            for j in (-1, 1)
            for k in (-1, 1)
        ]

    def rotate(self, angle, axis=None, origin=None):
        """Turn the shape by angle (rad) about axis (its own by default) through origin (its pos by default)."""
        axis, origin = vector(axis or self._axis), vector(origin or self._pos)
        self._pos.value = origin + (self._pos - origin).rotate(angle, axis)
        self._axis.value = self._axis.rotate(angle, axis)
        self._up.value = self._up.rotate(angle, axis)

    @property
    def trail_color(self):
        return self._color

    @trail_color.setter
    def trail_color(self, value):
        self._color_of_trail = value

    trail_radius = property(lambda self: 0.1 * self._size._y, _nothing)


class box(standardAttributes):
    pass


class sphere(standardAttributes):
    _default_size = (2, 2, 2)
    _sizing = False

    @property
    def radius(self):
        return self._size._y / 2

    @radius.setter
    def radius(self, value):
        self.size = vector(2 * value, 2 * value, 2 * value)


class _Round(standardAttributes):
    """A shape with a length and a radius."""

    _default_size = (1, 2, 2)

    @property
    def radius(self):
        return self._size._y / 2

    @radius.setter
    def radius(self, value):
        self.size = vector(self._size._x, 2 * value, 2 * value)


class cylinder(_Round):
    pass


# --- shapes that are only for show -----------------------------------------------------------------------------------


class simple_sphere(sphere):
    pass


class pyramid(standardAttributes):
    pass


class cone(_Round):
    pass


class helix(_Round):
    coils, ccw, thickness = 5, True, 1 / 20


class ellipsoid(_Round):
    _default_size = (1, 1, 1)


class ring(standardAttributes):
    _default_size, _sizing = (0.2, 2.2, 2.2), False

    @property
    def thickness(self):
        return self._size._x / 2

    @thickness.setter
    def thickness(self, value):
        outer = 2 * (self.radius + value)
        self.size = vector(2 * value, outer, outer)

    @property
    def radius(self):
        return (self._size._y - self._size._x) / 2

    @radius.setter
    def radius(self, value):
        outer = 2 * (value + self.thickness)
        self.size = vector(self._size._x, outer, outer)


class arrow(standardAttributes):
    _default_size = (1, 0.2, 0.2)
    round, shaftwidth, headwidth, headlength, scale = False, 0, 0, 0, 1
    start = stop = _nothing


def attach_arrow(o, attr, **attributes):
    """Return an arrow; it does not follow the vector that o has as this attribute."""
    if not isinstance(getattr(o, attr), vector):
        raise AttributeError(f'The attach_arrow attribute "{attr}" is not a vector.')
    return arrow(attr=attr, pickable=False, **{"color": o.color, "shaftwidth": 0.5 * o.size.y, **attributes})


class attach_trail(standardAttributes):
    type, trail_radius = "curve", None
    start = stop = clear = _nothing

    def __init__(self, obj, **attributes):
        super().__init__(**{"radius": 0 if callable(obj) else 0.1 * obj.size.y, **attributes})


class label(standardAttributes):
    _more_vectors = ("background", "linecolor")
    text, font, height, align, xoffset, yoffset = " ", "sans", 13, None, 0, 0
    background, linecolor, linewidth, border = None, None, 1, 5
    box, line, space, pixel_pos, trail_radius = True, True, 0, False, None


class text(standardAttributes):
    _sizing = False
    _more_vectors = ("start_face_color", "end_face_color")
    height, length, depth, align, font, billboard = 1, 1, 0.2, "left", "sans", False
    descender, vertical_spacing, show_start_face, show_end_face = 0.3, 1.3, True, True
    start_face_color = end_face_color = vector(1, 1, 1)
    start = end = upper_left = upper_right = lower_left = lower_right = vector(0, 0, 0)

    def __init__(self, **attributes):
        if "text" not in attributes:
            raise AttributeError("A text object must have a text attribute")
        super().__init__(**attributes)

    text = ""


class curveMethods(standardAttributes):
    """The base of curve and points. A point is a dictionary with pos, and perhaps color, radius, ..."""

    radius, origin = 0, vector(0, 0, 0)
    modify = splice = unshift = _nothing

    def __init__(self, *points, pos=(), **attributes):
        self._points: list[dict] = []
        super().__init__(**attributes)
        self.append(*points, pos=pos)

    @property  # type: ignore[misc]  # cannot be set
    def pos(self):
        raise AttributeError('object does not have a "pos" attribute')

    @property
    def npoints(self):
        return len(self._points)

    def append(self, *points, pos=(), **attributes):
        if len(points) == 1 and isinstance(points[0], (list, tuple)):
            points = tuple(points[0])
        for point in [*points, *([pos] if isinstance(pos, vector) else pos)]:
            place = point if isinstance(point, (dict, vector)) else vector(*point)
            self._points.append({**attributes, **(place if isinstance(place, dict) else {"pos": vector(place)})})

    def pop(self, index=-1):
        return self._points.pop(index) if self._points else None

    def shift(self):
        return self.pop(0)

    def clear(self):
        self._points = []

    def point(self, number):
        return self._points[number]

    def slice(self, start, end):
        return self._points[start:end]


class curve(curveMethods):
    pass


class points(curveMethods):
    size_units, trail_radius = "pixels", 0


class compound(standardAttributes):
    _sizing = False
    compound_idx, obj_idxs, origin = 0, None, vector(0, 0, 0)

    def __init__(self, objects, **attributes):
        super().__init__(**attributes)
        for each in objects:
            each.visible = False  # it is a part now

    def world_to_compound(self, v):
        return vector(v)

    def compound_to_world(self, v):
        return vector(v)


class extrusion(standardAttributes):
    _sizing = False
    smooth, smooth_joints, sharp_joints, twist = 0.95, None, None, 0
    scale = xscale = yscale = 1
    start_face_color = end_face_color = start_normal = end_normal = None
    show_start_face, show_end_face = True, True

    def __init__(self, **attributes):
        if not {"path", "shape"} <= attributes.keys():
            raise AttributeError("An extrusion must have a path and a shape.")
        super().__init__(**attributes)


class vertex(standardAttributes):
    _more_vectors = ("normal", "bumpaxis", "texpos")
    normal, bumpaxis, texpos, trail_radius = vector(0, 0, 1), vector(1, 0, 0), vector(0, 0, 0), None


class triangle(standardAttributes):
    v0 = v1 = v2 = vs = None


class quad(triangle):
    v3 = None


class faces:
    def __init__(self, **attributes):
        raise NameError("faces is no longer supported; use vertex with triangle or quad")


class frame:
    def __init__(self, **attributes):
        raise NameError("frame is not yet implemented")


class _Light(standardAttributes):
    def _show(self):
        self.canvas.lights.append(self)


class distant_light(_Light):
    _more_vectors = ("direction",)
    direction = vector(0, 0, 1)


class local_light(_Light):
    _more_vectors = ("offset",)
    offset, attach_idx = vector(0, 0, 0), None


def attach_light(o, offset=vector(0, 0, 0), **attributes):  # noqa: B008  nobody changes this vector
    """Return a light; it does not follow o."""
    return local_light(pos=o.pos + offset, offset=offset, **{"color": o.color, **attributes})


_CENTERED = box, sphere, ellipsoid, ring, compound


class _Outlines:
    """VPython's outlines, as paths for an extrusion: none has points here."""

    rectangle = cross = trapezoid = circle = line = arc = ellipse = star = ngon = _no_points
    triangle = pentagon = hexagon = _no_points


class path_object(_Outlines):
    pointlist = _no_points


class shape_object(_Outlines):
    points = octagon = gear = rackgear = circframe = nframe = rframe = sframe = trframe = _no_points


paths, shapes = path_object(), shape_object()
ToothOutline = RackOutline = addpos = convert = rotatecp = roundc = scalecp = _no_points


# --- the page --------------------------------------------------------------------------------------------------------


class wtext(standardAttributes):
    text, location = "", None

    def __init__(self, **attributes):
        vars(self).update(attributes)


class controls(baseObj):
    """The base of the widgets. bind is the function that a change calls: here, a test does."""

    disabled = False

    def __init__(self, *, bind=None, **attributes):
        if bind is None:
            raise AttributeError("bind missing")
        super().__init__(bind=bind, **{"canvas": canvas.selected, **attributes})


class button(controls):
    text, color, textcolor, background = "", vector(0, 0, 0), vector(0, 0, 0), vector(1, 1, 1)


class checkbox(controls):
    text, checked = "", False


class radio(controls):
    text, name, checked = "", "", False


class winput(controls):
    text, type, number, width = "", "numeric", None, 100


class menu(controls):
    selected = None
    choices: list = []

    @property
    def index(self):
        return None if self.selected is None else self.choices.index(self.selected)

    @index.setter
    def index(self, value):
        self.selected = self.choices[value]


class slider(controls):
    min, max, vertical, length, width, align = 0, 1, False, 400, 10, "left"
    left = right = top = bottom = 0

    def __init__(self, **attributes):
        low, high = attributes.get("min", self.min), attributes.get("max", self.max)
        super().__init__(**{"value": low, "step": 0.001 * (high - low), **attributes})


class graph(baseObj):
    width, height, align, title, xtitle, ytitle = 640, 400, "none", "", "", ""
    fast, scroll, logx, logy = True, False, False, False
    xmin = xmax = ymin = ymax = None
    foreground, background = vector(0, 0, 0), vector(1, 1, 1)


class gobj(baseObj):
    """The base of curves, dots and bars in a graph; data has their points."""

    color, radius, size, width, label = vector(0, 0, 0), 3, 6, 2, ""
    legend, interval, fast, visible, graph = False, -1, True, True, None
    data: list = []

    def __init__(self, **attributes):
        super().__init__(**{"data": [], **attributes})

    def plot(self, *points, pos=(), data=(), **_):
        """Add points: plot(x, y), plot([x, y], ...), plot([[x, y], ...]), or one of the latter two as pos or data."""
        given = list(points[0] if len(points) == 1 else points) or list(pos or data)
        self.data = self.data + ([list(point) for point in given] if isinstance(given[0], (list, tuple)) else [given])


class gcurve(gobj):
    markers, marker_color, dot, dot_color, dot_radius = False, vector(0, 0, 0), False, vector(0, 0, 0), 3


class gdots(gobj):
    pass


class gvbars(gobj):
    delta = 1


class ghbars(gvbars):
    pass


class Mouse(baseObj):
    """The mouse, which stands in the middle of the canvas."""

    pick, alt, ctrl, shift = None, False, False, False

    def __init__(self):
        super().__init__(pos=vector(0, 0, 0), ray=vector(0, 0, -1))

    def project(self, **_):
        return vector(0, 0, 0)


class Camera:
    """The camera of a canvas, which it shows from center - axis, as in VPython."""

    follow = rotate = _nothing

    def __init__(self, canvas):
        self.canvas = canvas

    @property
    def axis(self):
        return norm(self.canvas.forward) * (self.canvas.range / tan(self.canvas.fov / 2))

    @axis.setter
    def axis(self, value):
        self.canvas.center = self.pos + value
        self.canvas.forward, self.canvas.range = norm(value), mag(value) * tan(self.canvas.fov / 2)

    @property
    def pos(self):
        return self.canvas.center - self.axis

    @pos.setter
    def pos(self, value):
        self.canvas.center = value + self.axis

    @property
    def up(self):
        return self.canvas.up

    @up.setter
    def up(self, value):
        self.canvas.up = value


class event_return:
    """What waitfor and pause return: an event that they did not wait for."""

    def __init__(self, args):
        vars(self).update(args)


class canvas(baseObj):
    width, height, range, fov, align, resizable, visible = 640, 400, 1, pi / 3, "none", True, True
    title, caption, autoscale, userzoom, userspin, userpan = "", "", True, True, True, True
    background, ambient = vector(0, 0, 0), vector(0.2, 0.2, 0.2)
    selected: "canvas"  # the one to which new objects belong
    capture = follow = unbind = _nothing

    def __init__(self, **attributes):
        for name in ("background", "ambient", "forward", "up", "center"):
            if not isinstance(attributes.get(name, color.black), vector):
                raise TypeError(name, "must be a vector")
        if "lights" in attributes:
            raise AttributeError("Lights for a canvas can be assigned only after the canvas has been created.")
        canvas.selected = self
        self.center, self.forward, self.up = vector(0, 0, 0), vector(0, 0, -1), vector(0, 1, 0)
        self.mouse, self.camera = Mouse(), Camera(self)
        self.title_anchor, self.caption_anchor = [0, 1], [0, 2]
        self.bound: dict = {}  # event -> function
        self.lights: list = []
        self._made: list = []  # all shapes, also those that a program has hidden or lost
        distant_light(direction=vector(0.22, 0.44, 0.88), color=color.gray(0.8))
        distant_light(direction=vector(-0.88, -0.22, -0.44), color=color.gray(0.3))
        super().__init__(**attributes)

    @property
    def axis(self):
        return self.forward

    @axis.setter
    def axis(self, value):
        self.forward = value

    @property
    def objects(self):
        """The visible shapes, in the order in which they were made."""
        return [shape for shape in self._made if shape.visible]

    @property
    def pixel_to_world(self):
        return 2 * self.range / min(self.width, self.height)

    def select(self):
        canvas.selected = self

    @staticmethod
    def get_selected():
        return canvas.selected

    def append_to_title(self, *words):
        self.title += " ".join(map(str, words))

    def append_to_caption(self, *words):
        self.caption += " ".join(map(str, words))

    def bind(self, events, function):
        self.bound.update(dict.fromkeys(events.split(), function))

    def waitfor(self, event):
        """Return an event immediately, as nobody clicks here."""
        return event_return({"canvas": self, "event": event, "pos": vector(0, 0, 0), "key": "", "which": 1})

    def pause(self, *_):
        return self.waitfor("click")


class GlowWidget:
    handle_msg = handle_close = _nothing


class meta_canvas:
    selected = None


# --- names -----------------------------------------------------------------------------------------------------------


class color:
    black, white = vector(0, 0, 0), vector(1, 1, 1)
    red, green, blue = vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)
    yellow, cyan, magenta = vector(1, 1, 0), vector(0, 1, 1), vector(1, 0, 1)
    orange, purple = vector(1, 0.6, 0), vector(0.4, 0.2, 0.6)

    @staticmethod
    def gray(luminance):
        return vector(luminance, luminance, luminance)

    @staticmethod
    def rgb_to_hsv(v):
        return vector(*colorsys.rgb_to_hsv(*v.value))

    @staticmethod
    def hsv_to_rgb(v):
        return vector(*colorsys.hsv_to_rgb(*v.value))

    @staticmethod
    def rgb_to_grayscale(v):
        return color.gray(0.21 * v.x + 0.71 * v.y + 0.07 * v.z)


class textures:
    flower, granite, gravel = ":flower_texture.jpg", ":granite_texture.jpg", ":gravel_texture.jpg"
    earth, metal, rock = ":earth_texture.jpg", ":metal_texture.jpg", ":rock_texture.jpg"
    rough, rug, stones = ":rough_texture.jpg", ":rug_texture.jpg", ":stones_texture.jpg"
    stucco, wood, wood_old = ":stucco_texture.jpg", ":wood_texture.jpg", ":wood_old_texture.jpg"


class bumpmaps:
    gravel, rock, stones = ":gravel_bumpmap.jpg", ":rock_bumpmap.jpg", ":stones_bumpmap.jpg"
    stucco, wood_old = ":stucco_bumpmap.jpg", ":wood_old_bumpmap.jpg"


scene = canvas()

rate = sleep = _nothing  # nothing is shown, so there is nothing to wait for


def arange(*limits, **options):
    """Return the same as numpy's arange. numpy comes with pandas; its import is slow, so it waits until here."""
    from numpy import arange

    return arange(*limits, **options)


def sign(x):
    return 1 if x > 0 else -1 if x < 0 else 0


def combin(x, y):
    """Return x! / (y! (x - y)!), as a float."""
    return float(comb(x, y))  # noqa: F405


def keysdown():
    return []


set_browser = adjust_axis = adjust_up = object_rotate = _nothing
version, GSversion = ["7.6.5", "jupyter"], ["3.2", "glowscript"]
rate_control = gs_version = shapespaths = baseObj()  # VPython's modules of these names

# What `from vpython import *` brings: VPython's names.
__all__ = [name for name in dir() if name[0] != "_" and name not in ("colorsys", "deepcopy", "install", "sys")]
