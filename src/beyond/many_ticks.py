"""The fast path: many ticks in one call, on plain numbers, for many pendula and for recordings.

It replaces the loop of main in src/visualize_cradle_run.py, with the same result to the last bit. It knows the
functions that the loop calls. If one of them changes, in its file or by a patch, the programs do single ticks.
"""

import ast
from collections.abc import Callable
from hashlib import sha256
from heapq import heappop, heappush
from itertools import pairwise
from math import cos, isfinite, sin, sqrt
from operator import is_
from pathlib import Path
from types import BuiltinFunctionType, CodeType, FunctionType
from typing import Any, NamedTuple

from vpython import box, cylinder, mag, sphere, vector

from support.pendulum import arm, show_pendulum

# The digests of the functions that the loop calls; each function comes after its caller.
STANDS_IN_FOR = {
    "main": "c99083a299fc",
    "newton_cradle_tick": "323afff2bef0",
    "full_swing_update": "85dbb842620c",
    "swing_update": "0e9220734880",
    "angle_update": "f0268fc034c0",
    "show_pendulum": "cf46e388cd28",
    "arm": "076650c7b917",
    "handle_two_bobs": "3711cb9b2d0c",
    "handle_collision": "0495dce4e06b",
}
MEANT = {"cos": cos, "mag": mag, "pairwise": pairwise, "sin": sin, "vector": vector}  # globals that must match
CODE_PARTS = (
    *("co_code", "co_flags", "co_names", "co_varnames", "co_freevars", "co_cellvars"),
    *("co_argcount", "co_posonlyargcount", "co_kwonlyargcount", "co_exceptiontable"),
)
VPYTHONS = {"vpython.cyvector", "vpython.vector", "support.headless_vpython"}  # modules whose vector and mag are known
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

    Return None, and change nothing, if the same result is not certain; the caller must then do single ticks. This
    includes overflows and divisions by 0: single ticks then raise the error in the function that causes it.
    """
    law = known_law(scope)
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


class Loop:
    """The functions that main and its calls run, and the other globals that they read."""

    def __init__(self, scope):
        """Find main in scope, and each other function in the globals of its caller."""
        self.functions: dict[str, Any] = {"main": scope.get("main")}
        self.read: dict[tuple[str, str], Any] = {}  # (the function's name, the global's name) -> value
        for name in STANDS_IN_FOR:
            function = self.functions.get(name)
            if isinstance(function, FunctionType):
                names = scope if name == "main" else function.__globals__
                for other in function.__code__.co_names:  # names of globals, and of attributes
                    if other in STANDS_IN_FOR:
                        self.functions[other] = names.get(other)
                    else:
                        self.read[name, other] = names.get(other)

    def facts(self) -> list:
        """Return the objects that determine the loop: while all of them are the same objects, the loop is the same."""
        functions = [function for function in self.functions.values() if isinstance(function, FunctionType)]
        parts = [(function.__code__, function.__defaults__, function.__kwdefaults__) for function in functions]
        return [*self.functions.values(), *self.read.values(), *(fact for part in parts for fact in part)]

    def is_known(self) -> bool:
        """Return whether all functions are those of STANDS_IN_FOR, and their globals are those in MEANT."""
        return (
            all(is_shipped(name, self.functions.get(name)) for name in STANDS_IN_FOR)
            and all(value is MEANT.get(name, value) for (_, name), value in self.read.items())
            and all(type(function) is BuiltinFunctionType for function in (sin, cos))
            and {vector.__module__, mag.__module__} <= VPYTHONS
        )

    def law(self) -> Law:
        """Return the Law of a known loop."""
        r_param, dt, g = (self.read["main", name] for name in ("R_PARAM", "DT", "G"))
        return Law(r_param, dt, g, self.read["handle_two_bobs", "BUFFER"], self.functions["handle_collision"])


last: dict[str, Any] = {"facts": [], "is_known": False}  # of the last loop


def known_law(scope) -> Law | None:
    """Return the Law of the loop in scope, or None if the loop is not known; fast if nothing has changed."""
    loop = Loop(scope)
    facts = loop.facts()
    if len(facts) != len(last["facts"]) or not all(map(is_, facts, last["facts"])):
        last.update(facts=facts, is_known=loop.is_known())
    return loop.law() if last["is_known"] else None


def is_shipped(name, function) -> bool:
    """Return whether this function is the one in STANDS_IN_FOR.

    The digest comes from the syntax tree in the function's file. The file may have changed after the import, so the
    function's code must also equal the code compiled from that tree.
    """
    if type(function) is not FunctionType or type(function.__globals__) is not dict:
        return False
    path = function.__code__.co_filename
    try:
        tree = ast.parse(Path(path).read_bytes())
        module = compile(tree, path, "exec", dont_inherit=True)
    except (OSError, SyntaxError, ValueError):
        return False
    trees = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == name]
    codes = [code for code in module.co_consts if isinstance(code, CodeType) and code.co_name == name]
    if not trees or len(codes) != 1 or digest(trees[0]) != STANDS_IN_FOR[name]:
        return False
    defaults = tuple(ast.literal_eval(default) for default in trees[0].args.defaults) or None
    is_plain_call = repr(function.__defaults__) == repr(defaults) and function.__kwdefaults__ is None
    return is_plain_call and what_it_does(function.__code__) == what_it_does(codes[0])


def what_it_does(code) -> list:
    """Return all parts of code that have an effect, not its line numbers. Constants are text: 1 == 1.0 == True."""
    return [getattr(code, part, None) for part in CODE_PARTS] + [repr(code.co_consts)]


def digest(tree) -> str:
    """Return a short digest of a function's syntax tree, the same in each version of Python from 3.10 on."""
    return sha256(canonical(tree).encode()).hexdigest()[:12]


def canonical(part) -> str:
    """Return a part of a syntax tree as text, without docstrings, comments, annotations and empty fields."""
    if isinstance(part, list):
        return f"[{', '.join(map(canonical, part))}]"
    if not isinstance(part, ast.AST):
        return repr(part)
    fields = dict(ast.iter_fields(part))
    if isinstance(part, ast.FunctionDef) and ast.get_docstring(part) is not None:
        fields["body"] = part.body[1:]
    kept = {name: value for name, value in fields.items() if name not in ("annotation", "ctx", "returns")}
    texts = [f"{name}={canonical(value)}" for name, value in kept.items() if value is not None and value != []]
    return f"{type(part).__name__}({', '.join(texts)})"


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
        self.checks = {0: list(pairs)}  # tick -> the pairs to check in it
        self.check_ticks = [0]  # the keys of checks, as a heap
        self.due = {pair: 0 for pair in pairs}  # the tick in which to check a pair
        self.contacts: list[tuple[int, int, int, bool, float]] = []

    def advance(self, ticks) -> None:
        """Let all pendula swing and collide until `ticks` ticks are done."""
        while self.check_ticks and self.check_ticks[0] < ticks:
            tick = heappop(self.check_ticks)
            for left in sorted(self.checks.pop(tick)):
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
        if tick not in self.checks:
            self.checks[tick] = []
            heappush(self.check_ticks, tick)
        self.checks[tick].append(left)

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
