"""The fast path: many ticks in one call, on plain numbers.

It is an equivalent of the loop of main in src/visualize_cradle_run.py: the same result, to the last
bit. The programs take it only where this is certain. tests/project/test_many_ticks.py compares the
two.
"""

from collections.abc import Callable, Mapping
from heapq import heappop, heappush
from itertools import pairwise
from math import cos, sin, sqrt
from typing import Any

from vpython import mag, vector

from support.cradle.certainty import are_plain, CONSTANT_NAMES, Constants, is_certain, obstacle
from support.cradle.hits import Hit
from support.pendulum import arm, contact_distance, Pendulum, show_pendulum

MOST_TICKS = 1000  # it looks at a pair of bobs after this many ticks, or earlier


def many_ticks(
    scope: Mapping[str, Any], pend_list: list[Pendulum], ticks: int, rule: dict[str, bool]
) -> list[Hit] | None:
    """Do the same as `ticks` calls of newton_cradle_tick; return the hits, in their order.

    scope has the functions and constants of the handout by name (Cradle.scope). rule has the
    keywords of newton_cradle_tick: none, or approaching_only. Here, Hit.tick counts from 1 on.
    Hit.speed is negative if the two bobs moved apart.

    Return None, and change nothing, if the same result is not certain; the caller must then do
    single ticks. This includes overflows and divisions by 0: single ticks then raise the error in
    the function that causes it.
    """
    try:
        constants = Constants(*(scope[name] for name in CONSTANT_NAMES))
        is_known = is_certain(scope) and rule.keys() <= {"approaching_only"}
        if not (is_known and are_plain(pend_list, constants)):
            return None
        approaching_only = rule.get("approaching_only", False)
        pendula = PlainPendula(pend_list, constants, approaching_only, scope["handle_collision"])
        pendula.advance(ticks)
    except (ArithmeticError, LookupError, OSError, TypeError, ValueError):
        return None
    if ticks:
        pendula.show()
    return pendula.hits


def slow_remark(scope: Mapping[str, Any]) -> str:
    """Return why the programs do single ticks although nobody has changed a function, or ""."""
    found = obstacle(scope)
    return found and f"{found} So the program does one tick at a time, which is much slower."


class PlainPendula:
    """The pendula of a pend_list as plain numbers. Each swings alone while its bob touches none."""

    def __init__(
        self,
        pend_list: list[Pendulum],
        constants: Constants,
        approaching_only: bool,
        handle_collision: Callable,
    ):
        """Copy the numbers of pend_list; only show changes pend_list."""
        self.pend_list = pend_list
        self.constants = constants
        self.r_param = constants.r_param
        self.approaching_only = approaching_only
        self.handle_collision = handle_collision
        self.thetas = [pend["theta"] for pend in pend_list]
        self.omegas = [pend["omega"] for pend in pend_list]
        self.axles = [pend["objects"][0] for pend in pend_list]
        self.axle_places = [tuple(axle.pos.value) for axle in self.axles]
        self.bob_places = list(self.axle_places)  # until the first swing
        bobs = [pend["objects"][1] for pend in pend_list]
        self.contacts = [
            contact_distance(bob1.radius, bob2.radius) for bob1, bob2 in pairwise(bobs)
        ]
        self.swung = [0] * len(pend_list)  # the number of ticks that each pendulum has swung
        pairs = range(len(self.contacts))  # each is named by its left pendulum
        self.due = dict.fromkeys(pairs, 0)  # the tick in which to look at a pair
        self.looks = [(0, pair) for pair in pairs]  # a heap of (tick, pair), some no longer due
        self.hits: list[Hit] = []

    def advance(self, ticks: int) -> None:
        """Let all pendula swing and collide until `ticks` ticks are done."""
        while self.looks and self.looks[0][0] < ticks:
            tick, left = heappop(self.looks)
            if self.due[left] == tick:
                free = self.look(left, tick)
                self.plan(left, tick + 1 + free)
        for i in range(len(self.pend_list)):
            self.swing(i, ticks)

    def swing(self, i: int, until: int) -> None:
        """Let pendulum i swing until it has done `until` ticks."""
        r_param, dt, g = self.constants
        omega = self.omegas[i]
        theta = self.thetas[i]
        for _ in range(until - self.swung[i]):
            # The formula of angle_update; a call would double the time.
            omega = omega - g * sin(theta) / r_param * dt
            theta = theta + omega * dt
        self.omegas[i] = omega
        self.thetas[i] = theta
        self.swung[i] = until
        x, y, z = self.axle_places[i]
        self.bob_places[i] = (x + r_param * sin(theta), y - r_param * cos(theta), z)

    def plan(self, left: int, tick: int) -> None:
        """Look at this pair in this tick, instead of the tick that was planned before."""
        self.due[left] = tick
        heappush(self.looks, (tick, left))

    def look(self, left: int, tick: int) -> int:
        """Let a pair collide in this tick if it touches.

        Return for how many ticks it then cannot touch.
        """
        right = left + 1
        for i in (left, right):
            if self.swung[i] <= tick:
                self.swing(i, tick + 1)
        gap = self.gap(left, right)
        if gap > 0:
            thetas = self.thetas[left], self.thetas[right]
            omegas = self.omegas[left], self.omegas[right]
            return free_ticks(gap, *thetas, *omegas, *self.constants)
        self.collide(left, right, tick)
        return 0

    def gap(self, left: int, right: int) -> float:
        """Return the distance (m) of a pair from touching; it touches if this is 0 or less."""
        x1, y1, z1 = self.bob_places[left]
        x2, y2, z2 = self.bob_places[right]
        contact = self.contacts[left]
        gap = sqrt((x1 - x2) ** 2 + (y1 - y2) ** 2 + (z1 - z2) ** 2) - contact
        if abs(gap) <= 1e-12 * (1 + contact):
            # Too close to call: VPython's own mag can differ in the last bit.
            return mag(self.bob_place(left) - self.bob_place(right)) - contact
        return gap

    def bob_place(self, i: int) -> vector:
        """Return the place of a bob as show_pendulum computes it."""
        return self.axles[i].pos + arm(self.thetas[i], self.r_param)

    def collide(self, left: int, right: int, tick: int) -> None:
        """Let two touching bobs collide; look at their pairs with other bobs in the next tick."""
        omega1 = self.omegas[left]
        omega2 = self.omegas[right]
        speed1 = omega1 * cos(self.thetas[left])
        speed2 = omega2 * cos(self.thetas[right])
        if self.approaching_only and speed1 <= speed2:
            return
        pend1 = self.pend_list[left]
        pend2 = self.pend_list[right]
        new_omegas = self.handle_collision(
            pend1["e"], omega1, omega2, pend1["mass"], pend2["mass"], self.r_param
        )
        self.omegas[left], self.omegas[right] = new_omegas
        if new_omegas == (omega1, omega2):
            return
        speed = (speed1 - speed2) * self.r_param
        self.hits.append(Hit(tick + 1, left, right, speed))
        for pair in (left - 1, right):
            if self.due.get(pair, 0) > tick + 1:  # planned with the old velocity
                self.plan(pair, tick + 1)

    def show(self) -> None:
        """Write the new theta and omega to pend_list, and move its bobs and cords."""
        for pend, theta, omega in zip(self.pend_list, self.thetas, self.omegas, strict=True):
            pend["theta"] = theta
            pend["omega"] = omega
            show_pendulum(pend, self.r_param)


def free_ticks(
    gap: float,
    theta1: float,
    theta2: float,
    omega1: float,
    omega2: float,
    r_param: float,
    dt: float,
    g: float,
) -> int:
    """Return the number of ticks for which two bobs certainly do not touch.

    gap (m) is their distance from touching. theta1, theta2 (rad), omega1 and omega2 (rad/s) belong
    to the two, r_param (m), dt (s) and g (m/s^2) to the cradle.

    Let k = g / R. Because |sin a - sin b| <= |a - b|, the two omegas differ during a time T by at
    most
        d_omega = (|omega1 - omega2| + k T |theta1 - theta2|) / (1 - k T^2),
    and the thetas by at most d_theta = |theta1 - theta2| + d_omega T. In the same way, the bobs
    approach each other at a speed of at most R (d_omega + (omega + k T) d_theta), with the smaller
    omega. T is a tenth of sqrt(R / g) here.
    """
    k = abs(g / r_param)
    most = MOST_TICKS
    if k * dt:
        most = int(min(MOST_TICKS, 0.1 / sqrt(k) / abs(dt)))
    span = most * abs(dt)
    d_omega = (abs(omega1 - omega2) + k * span * abs(theta1 - theta2)) / (1 - k * span**2)
    d_theta = abs(theta1 - theta2) + d_omega * span
    speed = d_omega + (min(abs(omega1), abs(omega2)) + k * span) * d_theta
    closer = abs(r_param) * speed * span  # m, at most, after the whole span
    # In MOST_TICKS ticks, rounding changes angles by less than 1e-12 of them; 1000 covers places as
    # far as FARTHEST.
    angles = abs(theta1) + abs(theta2) + (abs(omega1) + abs(omega2)) * span
    sure = gap - 1e-12 * abs(r_param) * (1000 + angles)
    if sure <= 0:
        return 0
    if closer <= sure:
        return most
    return int(most * sure / closer)
