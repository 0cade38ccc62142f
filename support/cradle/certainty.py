"""Is the result of the fast path (many_ticks.py) certain to be that of single ticks?"""

import sys
from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from itertools import pairwise
from math import cos, isfinite, sin
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any, NamedTuple

from vpython import box, cylinder, mag, sphere, vector

from support.pendulum import BUFFER, contact_distance, Pendulum

FARTHEST = 1e5  # cord lengths from the origin: farther away, a place has too large rounding errors


class Constants(NamedTuple):
    """The constants of a cradle, in the order of angle_update's parameters."""

    r_param: float  # m
    dt: float  # s
    g: float  # m/s^2


# The files of the motion, and the digest of their code. If you change it, the programs do single
# ticks. If you change it for good, change the fast path as well, and put the new digest here.
FILES = ("support/pendulum.py", "src/swinging.py", "src/visualize_cradle_run.py")
DIGEST = "768329210cbc568e"
# What their functions use, beside each other.
BESIDE = {
    "BUFFER": BUFFER,
    "cos": cos,
    "mag": mag,
    "pairwise": pairwise,
    "sin": sin,
    "vector": vector,
}


def texts_of_files() -> list[str]:
    """Return the text of each of FILES, with any line ends."""
    root = Path(__file__).parents[2]
    return [(root / file).read_text(encoding="utf-8") for file in FILES]


def digest_of(texts: list[str]) -> str:
    """Return the digest of the lines of Python files, without comments and blank lines.

    All from the first # of a line on counts as a comment, in a string, too: FILES have none there.
    """
    lines = []
    for text in texts:
        for line in text.splitlines():
            code = line.partition("#")[0].rstrip()
            if code:
                lines.append(code)
    return sha256("\n".join(lines).encode()).hexdigest()[:16]


@cache
def shipped_code() -> dict[str, CodeType]:
    """Return the code of each function in FILES by its name.

    Return nothing if their digest is not DIGEST.
    """
    texts = texts_of_files()
    if digest_of(texts) != DIGEST:
        return {}
    codes = {}
    for text in texts:
        for constant in compile(text, "", "exec", dont_inherit=True).co_consts:
            if isinstance(constant, CodeType):
                codes[constant.co_name] = constant
    return codes


def is_certain(scope: Mapping[str, Any]) -> bool:
    """Return whether main in scope, and all functions that it ticks with, are those of FILES.

    Nobody may watch them, either.
    """
    if is_watched():
        return False
    codes = shipped_code()
    used = [("main", scope.get("main")), ("contact_distance", contact_distance)]
    for name, function in used:  # it grows
        if type(function) is not FunctionType or function.__code__ != codes.get(name):
            return False
        if function.__kwdefaults__ or function.__defaults__ not in (None, (False,)):
            return False
        for other in function.__code__.co_names:  # of globals, and of attributes
            value = function.__globals__.get(other)
            if other in codes:
                used.append((other, value))
            elif BESIDE.get(other, value) is not value:
                return False
    return True


def is_watched() -> bool:
    """Return whether a debugger, a tracer or a profiler must meet each call of a function."""
    if sys.gettrace() or sys.getprofile():
        return True
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on; it has the tools 0 to 5
    return bool(monitoring and any(map(monitoring.get_tool, range(6))))


def are_plain(pend_list: list[Pendulum], constants: Constants) -> bool:
    """Return whether the pendula are as make_newton_cradle makes them; may raise.

    Their numbers are finite ints and floats.
    """
    if type(pend_list) is not list or not all(type(pend) is dict for pend in pend_list):
        return False
    numbers = list(constants)
    moving = []  # the objects that a tick moves
    for pend in pend_list:
        objects = pend["objects"]
        if type(objects) is not tuple or tuple(map(type, objects)) != (box, sphere, cylinder):
            return False
        axle, bob, cord = objects
        if cord.up.value != [0, 0, 1]:  # VPython turns any other up in each tick
            return False
        if any(abs(place) > FARTHEST * abs(constants.r_param) for place in axle.pos.value):
            return False
        numbers += [pend[key] for key in ("mass", "e", "theta", "omega")]
        if not isfinite(bob.radius):
            return False
        moving += [id(bob), id(cord)]
    if not all(type(number) in (int, float) and isfinite(number) for number in numbers):
        return False
    return len(set(moving)) == len(moving)  # or one moves twice
