"""The fast path: many ticks in one call, on plain numbers.

It is an equivalent of the loop of main in src/visualize_cradle_run.py: the same result, to the last
bit. The programs take it only where this is certain. tests/project/test_many_ticks.py compares the
two.
"""

import sys
from functools import cache
from hashlib import sha256
from heapq import heappop, heappush
from itertools import pairwise
from math import cos, isfinite, sin, sqrt
from pathlib import Path
from types import CodeType, FunctionType

from vpython import box, cylinder, mag, sphere, vector

from support.pendulum import arm, BUFFER, contact_distance, show_pendulum

MOST_TICKS = 1000  # a pair of bobs gets a check after this many ticks, or earlier
# Cord lengths from the origin; farther away, the rounding errors of a place are too large
FARTHEST = 1e5


def many_ticks(scope, pend_list, ticks, rule) -> list[tuple[int, int, int, bool, float]] | None:
    """Same result as `ticks` calls of newton_cradle_tick; return the contacts (tick, left, right,
    rightwards, speed).

    scope is main.__globals__. rule has the keywords of newton_cradle_tick: none, or
    approaching_only. tick counts from 0, left and right are indices into pend_list. rightwards is
    True if the sum of the two velocities before the contact points to the right. speed (m/s) is
    that of the two bobs' approach, negative if they moved apart.

    Return None, and change nothing, if the same result is not certain; the caller must then do
    single ticks. This includes overflows and divisions by 0: single ticks then raise the error in
    the function that causes it.
    """
    try:
        constants = scope["R_PARAM"], scope["DT"], scope["G"]
        if not (
            is_certain(scope)
            and rule.keys() <= {"approaching_only"}
            and are_plain(pend_list, constants)
        ):
            return None
        run = Run(
            pend_list, constants, rule.get("approaching_only", False), scope["handle_collision"]
        )
        run.advance(ticks)
    except (ArithmeticError, LookupError, OSError, TypeError, ValueError):
        return None
    if ticks:
        run.show()
    return run.contacts


# The files of the motion, and a digest of their text. If you change one of them, the programs do
# single ticks. If you change it for good, change the fast path as well, and put the new digest
# here.
FILES = "support/pendulum.py", "src/swinging.py", "src/visualize_cradle_run.py"
DIGEST = "9dabbfe16f57f9ed"
# What their functions use, beside each other.
BESIDE = {
    "BUFFER": BUFFER,
    "cos": cos,
    "mag": mag,
    "pairwise": pairwise,
    "sin": sin,
    "vector": vector,
}


@cache
def shipped_code() -> dict[str, CodeType]:
    """Return the code of each function in FILES by its name, or nothing if their text is not that
    of DIGEST.
    """
    # Any line ends
    texts = [(Path(__file__).parents[2] / file).read_text(encoding="utf-8") for file in FILES]
    if sha256("".join(texts).encode()).hexdigest()[:16] != DIGEST:
        return {}
    parts = [
        part for text in texts for part in compile(text, "", "exec", dont_inherit=True).co_consts
    ]
    return {part.co_name: part for part in parts if isinstance(part, CodeType)}


def is_certain(scope) -> bool:
    """Return whether main in scope, and all functions that it ticks with, are those of FILES, and
    nobody watches.
    """
    monitoring = getattr(sys, "monitoring", None)  # from Python 3.12 on; it has the tools 0 to 5
    if (
        sys.gettrace()
        or sys.getprofile()
        or (monitoring and any(map(monitoring.get_tool, range(6))))
    ):
        return False  # a debugger, a tracer or a profiler must meet each call of a function
    codes = shipped_code()
    used = [("main", scope.get("main")), ("contact_distance", contact_distance)]
    for name, function in used:  # it grows
        if (
            type(function) is not FunctionType
            or function.__code__ != codes.get(name)
            or function.__kwdefaults__
        ):
            return False
        codes[name] = function.__code__  # the next time, they are the same object: this is faster
        for other in function.__code__.co_names:  # of globals, and of attributes
            value = function.__globals__.get(other)
            if other in codes:
                used.append((other, value))
            elif BESIDE.get(other, value) is not value:
                return False
    return all(function.__defaults__ in (None, (False,)) for _, function in used)


def are_plain(pend_list, constants) -> bool:
    """Return whether the pendula are as make_newton_cradle makes them, with finite ints and floats;
    may raise.
    """
    parts = [pend_dict["objects"] for pend_dict in pend_list]
    numbers = [
        *constants,
        *(pend_dict[key] for pend_dict in pend_list for key in ("mass", "e", "theta", "omega")),
    ]
    return (
        {type(pend_list), *map(type, pend_list)} <= {list, dict}
        and {(type(objects), *map(type, objects)) for objects in parts}
        <= {(tuple, box, sphere, cylinder)}
        and set(map(type, numbers)) <= {int, float}
        and all(map(isfinite, [*numbers, *(bob.radius for _, bob, _ in parts)]))
        and all(
            abs(place) <= FARTHEST * abs(constants[0])
            for axle, *_ in parts
            for place in axle.pos.value
        )
        # VPython turns any other up in each tick
        and all(cord.up.value == [0, 0, 1] for *_, cord in parts)
        # Or one moves twice
        and len({id(shape) for _, *moved in parts for shape in moved}) == 2 * len(parts)
    )


class Run:
    """The pendula of a pend_list as plain numbers.

    Each swings alone while its bob cannot touch another bob.
    """

    def __init__(self, pend_list, constants, approaching_only, handle_collision):
        """Copy the numbers of pend_list; only show changes pend_list."""
        self.pend_list, self.constants, self.r_param = pend_list, constants, constants[0]
        self.approaching_only, self.handle_collision = approaching_only, handle_collision
        self.thetas = [pend_dict["theta"] for pend_dict in pend_list]
        self.omegas = [pend_dict["omega"] for pend_dict in pend_list]
        self.axles, bobs = (
            [pend_dict["objects"][part] for pend_dict in pend_list] for part in (0, 1)
        )
        self.axle_places = [tuple(axle.pos.value) for axle in self.axles]
        self.bob_places = list(self.axle_places)  # until the first swing
        self.reaches = [contact_distance(bob1.radius, bob2.radius) for bob1, bob2 in pairwise(bobs)]
        self.swung = [0] * len(pend_list)  # the number of ticks that each pendulum has swung
        pairs = range(len(self.reaches))  # each is named by its left pendulum
        self.due = dict.fromkeys(pairs, 0)  # the tick in which to check a pair
        # A heap of (tick, pair), with some no longer due
        self.checks = [(0, pair) for pair in pairs]
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
        r_param, dt, g = self.constants
        omega, theta = self.omegas[i], self.thetas[i]
        # The formula of angle_update; a call would double the time
        for _ in range(until - self.swung[i]):
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
        """Let a pair collide in this tick if it touches; return for how many ticks it then cannot
        touch.
        """
        right = left + 1
        for i in (left, right):
            if self.swung[i] <= tick:
                self.swing(i, tick + 1)
        gap = self.gap(left, right)
        if gap > 0:
            states = self.thetas[left], self.thetas[right], self.omegas[left], self.omegas[right]
            return free_ticks(gap, *states, *self.constants)
        self.collide(left, right, tick)
        return 0

    def gap(self, left, right) -> float:
        """Return the distance (m) of a pair from touching; the pair touches if it is 0 or less."""
        (x1, y1, z1) = self.bob_places[left]
        (x2, y2, z2) = self.bob_places[right]
        reach = self.reaches[left]
        gap = sqrt((x1 - x2) ** 2 + (y1 - y2) ** 2 + (z1 - z2) ** 2) - reach
        # Too close to call: VPython's own mag can differ in the last bit
        if abs(gap) <= 1e-12 * (1 + reach):
            bob1, bob2 = (
                self.axles[i].pos + arm(self.thetas[i], self.r_param) for i in (left, right)
            )
            gap = mag(bob1 - bob2) - reach
        return gap

    def collide(self, left, right, tick) -> None:
        """Let two touching bobs collide, and check their pairs with other bobs in the next tick."""
        omega1, omega2 = self.omegas[left], self.omegas[right]
        speed1, speed2 = omega1 * cos(self.thetas[left]), omega2 * cos(self.thetas[right])
        if self.approaching_only and speed1 <= speed2:
            return
        pend1, pend2 = self.pend_list[left], self.pend_list[right]
        values = pend1["e"], omega1, omega2, pend1["mass"], pend2["mass"], self.r_param
        self.omegas[left], self.omegas[right] = self.handle_collision(*values)
        if (self.omegas[left], self.omegas[right]) != (omega1, omega2):
            self.contacts.append(
                (tick, left, right, speed1 + speed2 > 0, (speed1 - speed2) * self.r_param)
            )
            for pair in (left - 1, right):
                if self.due.get(pair, 0) > tick + 1:  # planned with the old velocity
                    self.plan(pair, tick + 1)

    def show(self) -> None:
        """Write the new theta and omega to pend_list, and move its bobs and cords."""
        for i, pend_dict in enumerate(self.pend_list):
            pend_dict["theta"], pend_dict["omega"] = self.thetas[i], self.omegas[i]
            show_pendulum(pend_dict, self.r_param)


def free_ticks(gap, theta1, theta2, omega1, omega2, r_param, dt, g) -> int:
    """Return the number of ticks for which two bobs certainly do not touch; gap (m) is their
    distance from touching.

    theta1, theta2 (rad), omega1 and omega2 (rad/s) belong to the two, r_param (m), dt (s) and g
    (m/s^2) to the cradle. Let k = g / R. Because |sin a - sin b| <= |a - b|, the two omegas differ
    during a time T by at most
        d_omega = (|omega1 - omega2| + k T |theta1 - theta2|) / (1 - k T^2),
    and the thetas by at most d_theta = |theta1 - theta2| + d_omega T. In the same way, the bobs
    approach each other at a speed of at most R (d_omega + (omega + k T) d_theta), with the smaller
    omega. T is a tenth of sqrt(R / g) here.
    """
    k = abs(g / r_param)
    most = int(min(MOST_TICKS, 0.1 / sqrt(k) / abs(dt))) if k * dt else MOST_TICKS
    span = most * abs(dt)
    d_omega = (abs(omega1 - omega2) + k * span * abs(theta1 - theta2)) / (1 - k * span**2)
    d_theta = abs(theta1 - theta2) + d_omega * span
    speed = d_omega + (min(abs(omega1), abs(omega2)) + k * span) * d_theta
    closer = abs(r_param) * speed * span  # m, at most, after the whole span
    # In MOST_TICKS ticks, rounding changes angles by less than 1e-12 of them; 1000 covers places as
    # far as FARTHEST.
    sure = gap - 1e-12 * abs(r_param) * (
        1000 + abs(theta1) + abs(theta2) + (abs(omega1) + abs(omega2)) * span
    )
    if sure <= 0:
        return 0
    return most if closer <= sure else int(most * sure / closer)
