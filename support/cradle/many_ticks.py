"""The fast path: many ticks in one call, on plain numbers.

It replaces the loop of main in src/visualize_cradle_run.py, with the same result to the last bit. It knows the
functions that the loop calls. If one of them changes, in its file or by a patch, the programs do single ticks.
"""

import ast
import re
import sys
from collections.abc import Callable
from functools import cache
from hashlib import sha256
from heapq import heappop, heappush
from itertools import pairwise
from math import cos, isfinite, sin, sqrt
from pathlib import Path
from types import BuiltinFunctionType, FunctionType
from typing import Any, NamedTuple

from vpython import box, cylinder, mag, sphere, vector

from support.pendulum import arm, show_pendulum

# The digests of the functions that the loop calls; each function comes after its caller.
STANDS_IN_FOR = {
    "main": "9d11caa6b067",
    "newton_cradle_tick": "723535c36ecd",
    "full_swing_update": "046f11da966f",
    "swing_update": "fa2f3f6dc8f0",
    "angle_update": "da5a6cb437cd",
    "show_pendulum": "a437e7a6f2c6",
    "arm": "6efb64f0dea4",
    "handle_two_bobs": "f773924d5c1a",
    "handle_collision": "f3d27f5c33b0",
}
MEANT = {"cos": cos, "mag": mag, "pairwise": pairwise, "sin": sin, "vector": vector}  # globals that must match
VPYTHONS = {"vpython.cyvector", "vpython.vector", "support.headless_vpython"}  # modules whose vector and mag are known
# Parts of a syntax tree's text that not every version of Python writes.
OMITTED = re.compile(r"(, )?\w+=(\[\]|None|Load\(\))(?=[,)])")
MOST_TICKS = 1000  # a pair of bobs gets a check after this many ticks, or earlier
FARTHEST = 1e5  # cord lengths from the origin; farther away, the rounding errors of a place are too large


class Law(NamedTuple):
    """The constants and the collision function of a cradle."""

    r_param: float
    dt: float
    g: float
    buffer: float
    handle_collision: Callable


def many_ticks(scope, pend_list, ticks, rule) -> list[tuple[int, int, int, bool, float]] | None:
    """Same result as `ticks` calls of newton_cradle_tick; return the contacts (tick, left, right, rightwards, speed).

    scope is main.__globals__, with R_PARAM (m), DT (s) and G (m/s^2). rule has the keywords of newton_cradle_tick:
    none, or approaching_only. The contacts are those that change a velocity. tick counts from 0, left and right are
    indices into pend_list. rightwards is True if the sum of the two velocities before the contact points to the right.
    speed (m/s) is that of the two bobs' approach before the contact, negative if they moved apart.

    Return None, and change nothing, if the same result is not certain, or if a debugger watches; the caller must then
    do single ticks. This includes overflows and divisions by 0: single ticks then raise the error in the function that
    causes it.
    """
    law = None if is_watched() else law_of(scope)
    if law is None or not rule.keys() <= {"approaching_only"}:
        return None
    try:
        if not are_plain(pend_list, law):
            return None
        run = Run(pend_list, law, rule.get("approaching_only", False))
        run.advance(ticks)
    except (ArithmeticError, LookupError, TypeError, ValueError):
        return None
    if ticks:
        run.show()
    return run.contacts


# --- is the same result certain? -------------------------------------------------------------------------------------


def is_watched() -> bool:
    """Return whether a debugger, a tracer or a profiler is at work: it must meet each call of a function."""
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on; it has the tools 0 to 5
    has_tool = monitoring and any(map(monitoring.get_tool, range(6)))
    return bool(sys.gettrace() or sys.getprofile() or has_tool)


def law_of(scope) -> Law | None:
    """Return the Law of the loop of main in scope, its globals.

    Return None if main, or a function that it calls, is not that of STANDS_IN_FOR, or reads other globals than MEANT.
    """
    functions: dict[str, Any] = {"main": scope.get("main")}
    read: dict[tuple[str, str], Any] = {}  # (the function's name, the global's name) -> value
    for name, digest in STANDS_IN_FOR.items():
        function = functions.get(name)
        if type(function) is not FunctionType or type(function.__globals__) is not dict or function.__kwdefaults__:
            return None
        if digest_of(function.__code__, repr(function.__defaults__)) != digest:
            return None
        names = scope if name == "main" else function.__globals__
        for other in function.__code__.co_names:  # names of globals, and of attributes
            if other in STANDS_IN_FOR:
                functions[other] = names.get(other)
            else:
                read[name, other] = names.get(other)
    if not (
        all(value is MEANT.get(name, value) for (_, name), value in read.items())
        and all(type(function) is BuiltinFunctionType for function in (sin, cos))
        and {vector.__module__, mag.__module__} <= VPYTHONS
    ):
        return None
    r_param, dt, g = (read["main", name] for name in ("R_PARAM", "DT", "G"))
    return Law(r_param, dt, g, read["handle_two_bobs", "BUFFER"], functions["handle_collision"])


@cache
def digest_of(code, defaults) -> str:
    """Return a short digest of a function with this code and these defaults (as text), or nothing.

    It comes from the syntax tree in the function's file, without docstrings, comments and annotations, and is the same
    in each version of Python from 3.10 on. The file may have changed after the import: if its code is not this code,
    return nothing.
    """
    try:
        tree = ast.parse(Path(code.co_filename).read_bytes())
        compiled = compile(tree, code.co_filename, "exec", dont_inherit=True)
    except (OSError, SyntaxError, ValueError):
        return ""
    trees = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.lineno == code.co_firstlineno]
    if not trees or code not in compiled.co_consts:
        return ""
    (node,) = trees
    node.returns = None
    node.body = node.body[1:] if ast.get_docstring(node) is not None else node.body
    for parameter in ast.walk(node.args):
        parameter.__dict__.pop("annotation", None)
    text = OMITTED.sub("", ast.dump(node)).replace("(, ", "(")
    return sha256((text + defaults).encode()).hexdigest()[:12]


def are_plain(pend_list, law) -> bool:
    """Return whether the pendula are as make_newton_cradle makes them, and the law's constants are numbers.

    Raises a KeyError for a pendulum without a key, and an OverflowError for an int that is too large for a float.
    """
    if type(pend_list) is not list or not set(map(type, pend_list)) <= {dict}:
        return False
    parts = [pend_dict["objects"] for pend_dict in pend_list]
    kinds = {(type(objects), *map(type, objects)) for objects in parts}
    keys = ("mass", "e", "theta", "omega")
    numbers = [law.r_param, law.dt, law.g, law.buffer, *(pend_dict[key] for pend_dict in pend_list for key in keys)]
    if not (kinds <= {(tuple, box, sphere, cylinder)} and set(map(type, numbers)) <= {int, float}):
        return False
    farthest = FARTHEST * abs(law.r_param)
    vectors = [each for axle, bob, cord in parts for each in (axle.pos, bob.pos, cord.axis)]
    return (
        all(map(isfinite, [*numbers, *(bob.radius for _, bob, _ in parts)]))
        and all(abs(place) <= farthest for axle, _, _ in parts for place in axle.pos.value)
        and not any(getattr(bob, "make_trail", False) for _, bob, _ in parts)  # a trail shows every place of a bob
        and all(cord.up.value == [0, 0, 1] for _, _, cord in parts)  # VPython turns any other up in each tick
        and len(set(map(id, vectors))) == len(vectors)  # a shared vector moves two shapes
    )


# --- the fast path ---------------------------------------------------------------------------------------------------


class Run:
    """The pendula of a pend_list as plain numbers. Each swings alone while its bob cannot touch another bob."""

    def __init__(self, pend_list, law, approaching_only):
        """Copy the numbers of pend_list; only show changes pend_list."""
        self.pend_list, self.law, self.approaching_only = pend_list, law, approaching_only
        self.thetas = [pend_dict["theta"] for pend_dict in pend_list]
        self.omegas = [pend_dict["omega"] for pend_dict in pend_list]
        self.axles, bobs = ([pend_dict["objects"][part] for pend_dict in pend_list] for part in (0, 1))
        self.axle_places = [tuple(axle.pos.value) for axle in self.axles]
        self.bob_places = list(self.axle_places)  # until the first swing
        self.reaches = [law.buffer * (bob1.radius + bob2.radius) for bob1, bob2 in pairwise(bobs)]
        self.swung = [0] * len(pend_list)  # the number of ticks that each pendulum has swung
        pairs = range(len(self.reaches))  # each is named by its left pendulum
        self.due = dict.fromkeys(pairs, 0)  # the tick in which to check a pair
        self.checks = [(0, pair) for pair in pairs]  # a heap of (tick, pair), with some no longer due
        self.contacts: list[tuple[int, int, int, bool, float]] = []

    def advance(self, ticks) -> None:
        """Let all pendula swing and collide until `ticks` ticks are done."""
        while self.checks and self.checks[0][0] < ticks:
            tick, left = heappop(self.checks)
            if self.due[left] == tick:
                self.plan(left, tick + 1 + self.check(left, tick))
        for i in range(len(self.pend_list)):
            self.swing(i, ticks)

    def swing(self, i, until) -> None:
        """Let pendulum i swing until it has done `until` ticks."""
        r_param, dt, g, _, _ = self.law
        omega, theta = self.omegas[i], self.thetas[i]
        for _ in range(until - self.swung[i]):  # the formula of angle_update; a call would double the time
            omega = omega - g * sin(theta) / r_param * dt
            theta = theta + omega * dt
        self.omegas[i], self.thetas[i], self.swung[i] = omega, theta, until
        x, y, z = self.axle_places[i]
        self.bob_places[i] = x + r_param * sin(theta), y - r_param * cos(theta), z

    def plan(self, left, tick) -> None:
        """Check this pair in this tick, instead of the tick that was planned before."""
        self.due[left] = tick
        heappush(self.checks, (tick, left))

    def check(self, left, tick) -> int:
        """Let a pair collide in this tick if it touches; return for how many ticks it then cannot touch."""
        right = left + 1
        for i in (left, right):
            if self.swung[i] <= tick:
                self.swing(i, tick + 1)
        gap = self.gap(left, right)
        if gap > 0:
            states = self.thetas[left], self.thetas[right], self.omegas[left], self.omegas[right]
            return free_ticks(gap, *states, *self.law[:3])
        self.collide(left, right, tick)
        return 0

    def gap(self, left, right) -> float:
        """Return the distance (m) of a pair from touching; the pair touches if it is 0 or less."""
        (x1, y1, z1), (x2, y2, z2), reach = self.bob_places[left], self.bob_places[right], self.reaches[left]
        gap = sqrt((x1 - x2) ** 2 + (y1 - y2) ** 2 + (z1 - z2) ** 2) - reach
        if abs(gap) <= 1e-12 * (1 + reach):  # too close to call: VPython's own mag can differ in the last bit
            bob1, bob2 = (self.axles[i].pos + arm(self.thetas[i], self.law.r_param) for i in (left, right))
            gap = mag(bob1 - bob2) - reach
        return gap

    def collide(self, left, right, tick) -> None:
        """Let two touching bobs collide, and check their pairs with other bobs in the next tick."""
        omega1, omega2 = self.omegas[left], self.omegas[right]
        speed1, speed2 = omega1 * cos(self.thetas[left]), omega2 * cos(self.thetas[right])
        if self.approaching_only and speed1 <= speed2:
            return
        pend1, pend2 = self.pend_list[left], self.pend_list[right]
        values = pend1["e"], omega1, omega2, pend1["mass"], pend2["mass"], self.law.r_param
        self.omegas[left], self.omegas[right] = self.law.handle_collision(*values)
        if (self.omegas[left], self.omegas[right]) != (omega1, omega2):
            self.contacts.append((tick, left, right, speed1 + speed2 > 0, (speed1 - speed2) * self.law.r_param))
            for pair in (left - 1, right):
                if self.due.get(pair, 0) > tick + 1:  # planned with the old velocity
                    self.plan(pair, tick + 1)

    def show(self) -> None:
        """Write the new theta and omega to pend_list, and move its bobs and cords."""
        for i, pend_dict in enumerate(self.pend_list):
            pend_dict["theta"], pend_dict["omega"] = self.thetas[i], self.omegas[i]
            show_pendulum(pend_dict, self.law.r_param)


def free_ticks(gap, theta1, theta2, omega1, omega2, r_param, dt, g) -> int:
    """Return the number of ticks for which two bobs certainly do not touch; gap (m) is their distance from touching.

    theta1, theta2 (rad), omega1 and omega2 (rad/s) belong to the two, r_param (m), dt (s) and g (m/s^2) to the cradle.
    Let k = g / R. Because |sin a - sin b| <= |a - b|, the two omegas differ during a time T by at most
        d_omega = (|omega1 - omega2| + k T |theta1 - theta2|) / (1 - k T^2),
    and the thetas by at most d_theta = |theta1 - theta2| + d_omega T. In the same way, the bobs approach each other at
    a speed of at most R (d_omega + (omega + k T) d_theta), with the smaller omega. T is a tenth of sqrt(R / g) here.
    """
    k = abs(g / r_param)
    most = int(min(MOST_TICKS, 0.1 / sqrt(k) / abs(dt))) if k * dt else MOST_TICKS
    span = most * abs(dt)
    d_omega = (abs(omega1 - omega2) + k * span * abs(theta1 - theta2)) / (1 - k * span**2)
    d_theta = abs(theta1 - theta2) + d_omega * span
    speed = d_omega + (min(abs(omega1), abs(omega2)) + k * span) * d_theta
    closer = abs(r_param) * speed * span  # m, at most, after the whole span
    # In MOST_TICKS ticks, rounding changes angles by less than 1e-12 of them; 1000 covers places as far as FARTHEST.
    sure = gap - 1e-12 * abs(r_param) * (1000 + abs(theta1) + abs(theta2) + (abs(omega1) + abs(omega2)) * span)
    if sure <= 0:
        return 0
    return most if closer <= sure else int(most * sure / closer)
