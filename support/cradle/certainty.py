"""Is the result of the fast path (many_ticks.py) certain to be that of single ticks?"""

import ast
import sys
from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from itertools import pairwise
from math import cos, isfinite, sin
from types import CodeType, FunctionType
from typing import Any, NamedTuple

from vpython import box, cylinder, mag, sphere, vector

from support.pendulum import contact_distance, Pendulum
from support.root import ROOT

FARTHEST = 1e5  # cord lengths from the origin: farther away, a place has too large rounding errors


class Constants(NamedTuple):
    """The constants of a cradle, in the order of angle_update's parameters."""

    r_param: float  # m
    dt: float  # s
    g: float  # m/s^2


CONSTANT_NAMES = ("R_PARAM", "DT", "G")  # in the order of Constants
# The functions of a tick, the files in which they are, and the digest of their code. If you change
# one of them, the programs do single ticks. If you change it for good, change the fast path as
# well, and put the new digest here.
FUNCTIONS = {
    "angle_update",
    "arm",
    "contact_distance",
    "full_swing_update",
    "handle_collision",
    "handle_two_bobs",
    "main",
    "newton_cradle_tick",
    "show_pendulum",
    "swing_update",
}
FILES = ("support/pendulum.py", "src/swinging.py", "src/visualize_cradle_run.py")
DIGEST = "a26e171bacac97a9"
# What else these functions use, by name.
USED = {
    "BUFFER": 1.05,
    "cos": cos,
    "mag": mag,
    "pairwise": pairwise,
    "sin": sin,
    "vector": vector,
}
# The fields of a syntax tree that are no code: types, and the u before a text.
NO_CODE = {"annotation", "kind", "returns", "type_comment", "type_params"}


def texts_of_files() -> list[str]:
    """Return the text of each of FILES, with any line ends."""
    return [(ROOT / file).read_text(encoding="utf-8") for file in FILES]


def digest_of(texts: list[str]) -> str:
    """Return the digest of the code of FUNCTIONS in the texts of Python files.

    It is that of their syntax trees: docstrings, comments, line breaks and types change nothing.
    """
    codes = []
    for text in texts:
        for statement in ast.parse(text).body:
            if isinstance(statement, ast.FunctionDef) and statement.name in FUNCTIONS:
                codes.append(code_as_text(statement))
    return sha256("\n".join(codes).encode()).hexdigest()[:16]


def code_as_text(node: Any) -> str:
    """Return the code of a syntax tree, or of a part of one; it is the same in every Python."""
    if isinstance(node, list):
        return "; ".join(map(code_as_text, node))
    if not isinstance(node, ast.AST):
        return repr(node)
    if isinstance(node, ast.AnnAssign) and node.value:
        node = ast.Assign([node.target], node.value)
    parts = [type(node).__name__]
    for name, value in ast.iter_fields(node):
        if name == "body" and isinstance(node, ast.FunctionDef) and ast.get_docstring(node):
            value = value[1:]
        if name not in NO_CODE and value not in (None, []):
            parts.append(f"{name}={code_as_text(value)}")
    return f"({', '.join(parts)})"


@cache
def shipped_code() -> dict[str, CodeType]:
    """Return the code of each of FUNCTIONS by its name.

    Return nothing if their digest is not DIGEST.
    """
    texts = texts_of_files()
    if digest_of(texts) != DIGEST:
        return {}
    codes = {}
    for text in texts:
        for constant in compile(text, "", "exec", dont_inherit=True).co_consts:
            if isinstance(constant, CodeType) and constant.co_name in FUNCTIONS:
                codes[constant.co_name] = constant
    return codes


def obstacle(scope: Mapping[str, Any]) -> str:
    """Return a sentence if nobody has changed FUNCTIONS in their files, but they are not certain.

    Return "" otherwise.
    """
    if not shipped_code():
        return ""
    if is_watched():
        return "A debugger, a tracer or a profiler watches each call."
    replaced = replaced_name(scope)
    if replaced:
        return f"Something in this Python has replaced {replaced}."
    for name in CONSTANT_NAMES:
        if type(scope[name]) not in (int, float):
            return f"{name} is no plain number, but a {type(scope[name]).__name__}."
    return ""


def is_certain(scope: Mapping[str, Any]) -> bool:
    """Return whether main in scope, and all functions that it ticks with, are those of FILES.

    Nobody may watch them, either.
    """
    return not is_watched() and not replaced_name(scope)


def replaced_name(scope: Mapping[str, Any]) -> str:
    """Return the name of a function or a constant that main ticks with, and that is not shipped.

    Return "" if there is none.
    """
    codes = shipped_code()
    used = [("main", scope.get("main")), ("contact_distance", contact_distance)]
    for name, function in used:  # it grows
        if type(function) is not FunctionType or function.__code__ != codes.get(name):
            return name
        if function.__kwdefaults__ or function.__defaults__ not in (None, (False,)):
            return name
        for other in function.__code__.co_names:  # of globals, and of attributes
            value = function.__globals__.get(other)
            if other in codes:
                used.append((other, value))
            elif other in USED and USED[other] != value:
                return other
    return ""


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
