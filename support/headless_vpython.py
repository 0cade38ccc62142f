"""A stand-in for VPython that needs no VPython and no browser.

After `import support.headless_vpython`, `import vpython` finds this module. It has the names of
VPython 7.6.5, and treats vectors and the shapes of a pendulum as VPython does; the project's tests
compare the two. One difference: `axis` and `up` do not turn each other. The rest of VPython is only
for show, and here nothing is shown: it stores the attributes that a program sets, its methods do
nothing, and nothing waits.
"""

# ruff: noqa: F401  VPython exports all these names

import sys
from math import *  # noqa: F403
from math import comb as combin
from random import random
from time import perf_counter as clock
from typing import Any as _Any

from support.headless_shapes import (
    baseObj,
    box,
    canvas,
    cylinder,
    scene,
    sphere,
    standardAttributes,
)
from support.headless_vector import (
    color,
    comp,
    cross,
    diff_angle,
    dot,
    hat,
    mag,
    mag2,
    norm,
    proj,
    rotate,
    vec,
    vector,
)
from support.headless_vector import (
    nothing as _nothing,
)
from support.waits import heard as _heard

sys.modules["vpython"] = sys.modules[__name__]

_TEXTURES = "flower granite gravel earth metal rock rough rug stones stucco wood wood_old"
textures = type("textures", (), {name: f":{name}_texture.jpg" for name in _TEXTURES.split()})

# Nothing is shown, so there is nothing to wait for
rate = _heard("rate")
sleep = _heard("sleep")
set_browser = _nothing
version = ["7.6.5", "jupyter"]
GSversion = ["3.2", "glowscript"]


def arange(*limits: float, **options: _Any) -> _Any:
    from numpy import arange  # not earlier: its import is slow

    return arange(*limits, **options)


def sign(x: float) -> int:
    if x > 0:
        return 1
    return -1 if x < 0 else 0


_FOR_SHOW = """
Camera GlowWidget Mouse RackOutline ToothOutline addpos adjust_axis adjust_up arrow attach_arrow
attach_light attach_trail bumpmaps button checkbox compound cone controls convert curve curveMethods
distant_light ellipsoid event_return extrusion faces frame gcurve gdots ghbars gobj graph gs_version
gvbars helix keysdown label local_light menu meta_canvas object_rotate path_object paths points
pyramid quad radio rate_control ring rotatecp roundc scalecp shape_object shapes shapespaths
simple_sphere slider text triangle vertex winput wtext
"""
# Those that are no classes
_OBJECTS = "bumpmaps", "gs_version", "paths", "rate_control", "shapes", "shapespaths"


def __getattr__(name: str) -> _Any:
    """Return a thing for show if VPython has this name: Python asks when the module lacks it."""
    if name not in _FOR_SHOW.split():
        raise AttributeError(f"module 'vpython' has no attribute '{name}'")
    thing = baseObj() if name in _OBJECTS else type(name, (baseObj,), {})
    globals()[name] = thing  # from now on, the name means the same thing
    return thing


# The names that `from vpython import *` brings.
__all__ = [name for name in dir() if name[0] != "_" and name != "sys"]
__all__ += _FOR_SHOW.split()
