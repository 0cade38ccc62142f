"""The cradle of the programs: make it with the functions of main, release it, drag a bob, measure it."""

from collections.abc import Mapping, Sequence
from contextlib import contextmanager
from copy import deepcopy
from functools import partial
from inspect import signature
from itertools import accumulate
from math import cos, inf, isfinite
from numbers import Real
from operator import itemgetter
from typing import Any

from src import pds_helper, special_cradles
from src.beyond.dragging import cord_angles, drag_bob, move
from support.constants import DT, G, R_PARAM
from support.energy import kinetic_energy, momentum, potential_energy
from support.playback.mistake import MistakeError
from support.shapes import discard

HAND = 1e9  # kg: the mass of a held bob; others bounce off it as off a wall


class LiveCradle:
    """A cradle of single pendula with the project's constants; its protocol is in support/playback/cradle.py."""

    title = "Newton's cradle"
    kind = "single"
    dt = DT
    reach = R_PARAM
    angles: Mapping[str, tuple[float, float]] = {"Release angle": (0, 180)}
    angle_keys: Sequence[str] = ("theta",)
    rate_keys: Sequence[str] = ("omega",)
    tick_name = "DT"  # of the constant, in the globals of main
    # The names of the functions that make the cradle, move it, and let two pendula hit.
    maker, ticker, meeter = "make_newton_cradle", "newton_cradle_tick", "handle_two_bobs"
    collider = "handle_collision"  # whose calls are shown

    def __init__(self, scope, options, many_ticks=None):
        """Find the functions that make and move the pendula in scope, the globals of main.

        options has elastic, inelastic, e and mass from support/start/options.py. many_ticks is the fast path, or None.
        """
        self.scope, self.many_ticks, self.mass, self.e = scope, many_ticks, options.mass, options.e
        self.collisions: dict[str, Any] = {
            "as in the CSV": None,  # each pendulum keeps its own e
            "elastic, e = 1": special_cradles.elastic_newton_cradle,
            "inelastic, e = 0": special_cradles.inelastic_newton_cradle,
        }
        self.collision = list(self.collisions)[1 if options.elastic else 2 if options.inelastic else 0]
        if self.e is not None:
            self.collision = f"e = {self.e:g}"
            self.collisions[self.collision] = partial(special_cradles.uniform_e_newton_cradle, e_val=self.e)
        self.pend_list: list = []
        self.held: int | None = None  # the index of the held bob
        self.hits: list[tuple[int, int, bool, float]] = []
        self.takes_rule = all(
            "approaching_only" in signature(function).parameters
            for function in (scope[self.ticker], self.meeting_place().get(self.meeter))
            if function
        )

    # --- make and move -----------------------------------------------------------------------------------------------

    @contextmanager
    def reading_once(self):
        """Let extract_and_convert read each file only once in the body of the with statement.

        The special cradles then take e and mass from the same rows as make_newton_cradle.
        """
        read, readings = vars(special_cradles).get("extract_and_convert"), {}
        if read is None:  # a student's functions may not use it
            yield
            return

        def extract_and_convert(relative_filepath):
            if relative_filepath not in readings:
                readings[relative_filepath] = read(relative_filepath)
            return deepcopy(readings[relative_filepath])

        special_cradles.extract_and_convert = extract_and_convert
        try:
            yield
        finally:
            special_cradles.extract_and_convert = read

    def give_back(self) -> None:
        """Hide the objects of the present pendula; the next pendula reuse them."""
        for pend in reversed(self.pend_list):  # the last discarded object is reused first
            discard(pend["objects"])
        self.pend_list, self.held = [], None

    def take(self, pend_list, csv) -> None:
        """Take pend_list, made from the file at the path csv, as the new cradle.

        It is the list of main, which the ticks change. Raises a MistakeError if it is no list of complete pendula.
        """
        self.check_made(pend_list)
        self.pend_list = pend_list
        self.numbers = {id(pend): number for number, pend in enumerate(pend_list)}
        if self.mass is not None:
            cradle = special_cradles.uniform_mass_newton_cradle(csv, self.mass)
            self.adopt("mass", [pend["mass"] for pend in cradle])
        self.es = [pend["e"] for pend in pend_list]
        self.collide(self.collision, csv)
        self.note_lifts()

    def note_lifts(self) -> None:
        """Take the present angles of the pendula as those with which the cradle was made."""
        lifted = [any(cord_angles(pend)) for pend in self.pend_list]
        first, *others = cord_angles(self.pend_list[0])
        self.made = [first, *(angle - first for angle in others)], [*lifted, False].index(False)

    def check_made(self, pend_list) -> None:
        """Raise a MistakeError if pend_list is no list of complete pendula."""
        make = self.scope[self.maker]
        if pend_list is None:
            raise MistakeError(make, "returned None; it must return a list of dictionaries. Is a return missing?")
        if not isinstance(pend_list, list) or not all(isinstance(pend, dict) for pend in pend_list):
            raise MistakeError(make, f"returned a {type(pend_list).__name__}; it must return a list of dictionaries.")
        if not pend_list:
            raise MistakeError(make, "returned an empty list; a cradle has at least one pendulum.")
        for number, pend in enumerate(pend_list, start=1):
            for key in ("mass", "e", *self.angle_keys, *self.rate_keys):
                if not is_number(pend.get(key)):
                    found = repr(pend[key]) if key in pend else "nothing"
                    raise MistakeError(make, f"set {key} of pendulum {number} to {found}; it must be a number.")
            parts = pend.get("objects")
            if not isinstance(parts, tuple) or len(parts) != 1 + 2 * len(self.angles):
                found = f"a {type(parts).__name__}" if "objects" in pend else "nothing"
                raise MistakeError(make, f"set objects of pendulum {number} to {found}; it must be a tuple of parts.")

    def check(self) -> None:
        """Raise a MistakeError if a tick has changed the number of pendula, or set a coordinate to no finite number."""
        if len(self.pend_list) != len(self.numbers):
            words = f"made {len(self.pend_list)} pendula from {len(self.numbers)}; it must keep their number."
            raise MistakeError(self.scope[self.ticker], words)
        for number, pend in enumerate(self.pend_list, start=1):
            for key in (*self.angle_keys, *self.rate_keys):
                if not is_number(pend.get(key)):
                    words = f"set {key} of pendulum {number} to {pend.get(key)!r}; it must be a finite number."
                    raise MistakeError(self.scope[self.ticker], words)

    def adopt(self, key, values) -> None:
        """Set pend[key] of each pendulum to its value in values, from left to right."""
        for pend, value in zip(self.pend_list, values, strict=False):  # main may have read a different file
            pend[key] = value

    def collide(self, collision, csv) -> None:
        """Set how bobs collide from now on (a key of collisions); csv is the path of the cradle's file."""
        self.collision, make = collision, self.collisions[collision]
        self.adopt("e", [pend["e"] for pend in make(csv)] if make else self.es)

    def options(self) -> dict[str, Any]:
        """Return the options with which the programs make the present collisions and masses: e, mass, ..."""
        kind = list(self.collisions).index(self.collision)
        e = self.e if kind == 3 else None
        return {"elastic": kind == 1, "inelastic": kind == 2, "e": e, "mass": self.mass}

    def as_made(self) -> tuple[list[float], int]:
        """Return the release angles (rad) with which the cradle was made, and the number of lifted pendula."""
        return self.made

    def release(self, angles, lifted) -> None:
        """Lift the first `lifted` pendula to these angles (rad) and let the others hang, all at rest.

        angles has one angle for each cord of a pendulum; the angle of a lower cord is measured from the upper cord.
        None stands for the angle, or the number, with which the cradle was made. If all are None, nothing moves.
        """
        if lifted is None and all(angle is None for angle in angles):
            return
        made_angles, made_lifted = self.made
        chosen = [made if angle is None else angle for angle, made in zip(angles, made_angles, strict=True)]
        lifted_angles = list(accumulate(chosen))
        count = max(1, made_lifted) if lifted is None else lifted
        for i, pend in enumerate(self.pend_list):
            move(pend, lifted_angles if i < count else [0.0] * len(angles), R_PARAM)
        self.make_room(count)

    def pose(self, angles) -> None:
        """Turn each pendulum to its own angles, a list (rad) of its cords' angles from straight down, at rest."""
        for pend, own in zip(self.pend_list, angles, strict=True):
            move(pend, own, R_PARAM)
        self.note_lifts()

    def write(self, csv, filepath) -> None:
        """Write the pendula of the CSV at the path csv to the file at filepath, with the handout's functions."""
        read, write = pds_helper.extract_and_convert, pds_helper.write_to_csv
        write(read(csv), filepath)

    def make_room(self, lifted) -> None:
        """Push pendula out of the way of the lifted ones: none, because single pendula are never in the way."""

    @contextmanager
    def held_still(self):
        """Keep the held bob, if any, in its place while the body of the with statement does a few ticks."""
        if self.held is None:
            yield
            return
        pend = self.pend_list[self.whose(self.held)[0]]
        mass, angles = pend["mass"], cord_angles(pend)
        pend["mass"] = HAND
        yield
        move(pend, angles, R_PARAM)
        pend["mass"] = mass

    def tick_at_once(self, ticks, rule) -> list[tuple[int, int, int, bool, float]] | None:
        """Do `ticks` ticks with this rule in one call; return the contacts as (tick, left, right, rightwards, speed).

        Return None, and do nothing, if the result might differ from that of single ticks.
        """
        contacts = self.many_ticks(self.scope, self.pend_list, ticks, rule) if self.many_ticks else None
        return [] if contacts is not None and self.held is not None else contacts

    # --- hits --------------------------------------------------------------------------------------------------------

    def meeting_place(self) -> dict[str, Any]:
        """Return the globals in which the tick finds the function that lets two pendula hit."""
        return self.scope

    @contextmanager
    def noting_hits(self):
        """Record the hits of the ticks in the body of the with statement, unless a bob is held.

        A hit is a call of the function for two pendula that changes a velocity. A comparison before and after a whole
        tick would miss hits: after a train of hits, the bobs in the middle have their old velocity.
        """
        place = self.meeting_place()
        if self.meeter not in place or self.held is not None:
            yield
            return
        meet, rates = place[self.meeter], itemgetter(*self.rate_keys)

        def noted(*given, **named):
            try:
                pend1, pend2 = given[0], given[1]
                before1, before2 = rates(pend1), rates(pend2)
            except (TypeError, LookupError):
                before1 = None  # not two pendula: meet raises the error
            result = meet(*given, **named)
            if before1 is not None and (rates(pend1) != before1 or rates(pend2) != before2):
                self.note_hit((pend1, before1), (pend2, before2))
            return result

        place[self.meeter] = noted
        try:
            yield
        finally:
            place[self.meeter] = meet

    @contextmanager
    def noting_calls(self):
        """Yield a list; each call of the collision function in the body of the with statement adds it, as text."""
        calls: list[str] = []
        place = self.meeting_place()
        collide = place.get(self.collider)
        if collide is None:  # a student may not have written it yet
            yield calls
            return

        def noted(*given, **named):
            result = collide(*given, **named)
            arguments = signature(collide).bind(*given, **named).arguments
            texts = [f"{name}={self.in_short(value)}" for name, value in arguments.items()]
            calls.append(f"{self.collider}({', '.join(texts)}) returned {self.in_short(result)}")
            return result

        place[self.collider] = noted
        try:
            yield calls
        finally:
            place[self.collider] = collide

    def in_short(self, value) -> str:
        """Return a value as short text; a pendulum is pend_list[...]."""
        if id(value) in self.numbers:
            return f"pend_list[{self.numbers[id(value)]}]"
        if isinstance(value, tuple):
            return f"({', '.join(map(self.in_short, value))})"
        return f"{value:.6g}" if isinstance(value, float) else repr(value)

    def note_hit(self, *two) -> None:
        """Record a hit of two pendula; each of the two is (pendulum, its rates before the hit in rad/s)."""
        numbers = [self.numbers[id(pend)] for pend, _ in two if id(pend) in self.numbers]
        if len(numbers) == 2:
            (left, one), (right, other) = sorted(zip(numbers, two, strict=True), key=itemgetter(0))
            rightwards = self.velocity(*one) + self.velocity(*other) > 0
            self.hits.append((left, right, rightwards, self.approach(one, other)))

    def approach(self, left, right) -> float:
        """Return the speed (m/s) at which two bobs approached each other; left and right are as in note_hit."""
        return (self.velocity(*left) - self.velocity(*right)) * R_PARAM

    def velocity(self, pend, omega) -> float:
        """Return the velocity of a pendulum's bob to the right (in cord lengths a second) at this omega (rad/s)."""
        return omega * cos(pend["theta"])

    # --- show, hold and measure --------------------------------------------------------------------------------------

    def axles(self) -> list:
        """Return the axles, from left to right."""
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self) -> list:
        """Return the bobs, from left to right."""
        return [bob for pend in self.pend_list for bob in pend["objects"][1::2]]

    def cords(self) -> list:
        """Return the cords, from left to right."""
        return [cord for pend in self.pend_list for cord in pend["objects"][2::2]]

    def hold(self, bob) -> None:
        """Hold this bob (an index into bobs) and its pendulum in their place, at rest, until let_go."""
        self.held = bob
        pend = self.pend_list[self.whose(bob)[0]]
        move(pend, cord_angles(pend), R_PARAM)

    def whose(self, bob) -> tuple[int, int]:
        """Return the index of this bob's pendulum, and the number of the bob in it, counted from above (0 or 1)."""
        return divmod(bob, len(self.angles))  # each cord has one release angle and one bob

    def drag(self, bob, x, y) -> None:
        """Turn the pendulum of this bob until the bob is as near as possible to x, y (m) in the plane of swing."""
        pendulum, number = self.whose(bob)
        drag_bob(self.pend_list, pendulum, number, x, y, R_PARAM)

    def let_go(self) -> None:
        """Let the held bob swing on from its place."""
        self.held = None

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""
        return kinetic_energy(self.pend_list, R_PARAM), potential_energy(self.pend_list, R_PARAM, G)

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""
        return momentum(self.pend_list, R_PARAM)

    def swings_through(self) -> bool:
        """Return whether a bob swings through others: below the axles, two bobs that are not neighbours changed order.

        Above the axles, bobs that swing over the top may be in any order.
        """
        places = [(bob.pos.x, bob.pos.y < axle.pos.y) for axle, bob in zip(self.axles(), self.bobs(), strict=True)]
        rightmost = accumulate((x if is_low else -inf for x, is_low in places), max)
        return any(left > x for left, (x, is_low) in zip(rightmost, places[2:], strict=False) if is_low)

    def colors(self) -> list:
        """Return the colors (vectors) of the pendula, from left to right."""
        return [pend["objects"][1].color for pend in self.pend_list]

    def constants(self) -> str:
        """Return the constants with which main moves the cradle, in words."""
        r_param, dt, g = (self.scope.get(name) for name in ("R_PARAM", self.tick_name, "G"))
        return f"main uses R_PARAM = {r_param} m (cord), {self.tick_name} = {dt} s (tick) and G = {g} m/s^2 (gravity)."

    def masses(self) -> list[float]:
        """Return the masses of the pendula's bobs (kg), from left to right."""
        return [pend["mass"] for pend in self.pend_list]

    def restitutions(self) -> list[float]:
        """Return the coefficients of restitution of the pendula, from left to right."""
        return [pend["e"] for pend in self.pend_list]

    def thetas(self) -> list[float]:
        """Return the angles of the pendula (rad), from left to right."""
        return [pend["theta"] for pend in self.pend_list]

    def coordinates(self) -> dict[str, float]:
        """Return coordinates (rad) and their rates (rad/s) by name: theta_1, theta_2, ..., from left to right."""
        numbered = list(enumerate(self.pend_list, start=1))
        return {f"{key}_{i}": pend[key] for key in (*self.angle_keys, *self.rate_keys) for i, pend in numbered}


def is_number(value) -> bool:
    """Return whether value is a finite number."""
    return isinstance(value, Real) and isfinite(value)
