"""The cradle as the programs play with it: made by main's functions, let go, dragged by a bob, and weighed."""

from collections.abc import Mapping, Sequence
from contextlib import contextmanager
from copy import deepcopy
from functools import partial
from inspect import signature
from itertools import accumulate
from math import cos, isfinite
from numbers import Real
from operator import itemgetter
from typing import Any

from src import special_cradles
from src.beyond.dragging import cord_angles, drag_bob, move
from support.constants import DT, G, R_PARAM
from support.energy import kinetic_energy, momentum, potential_energy
from support.playback.mistake import MistakeError
from support.shapes import discard

HAND = 1e9  # kg: a bob that is held throws others back like a wall


class LiveCradle:
    """A cradle of single pendula with the shipped constants, as support/playback/cradle.py wants a cradle to be."""

    dt = DT
    reach = R_PARAM
    angles: Mapping[str, tuple[float, float]] = {"Release angle": (0, 180)}
    coordinate_keys: Sequence[str] = ("theta", "omega")
    rate_keys: Sequence[str] = ("omega",)
    # The functions that make and move the cradle, and let two pendula hit, by their names.
    maker, ticker, meeter = "make_newton_cradle", "newton_cradle_tick", "handle_two_bobs"

    def __init__(self, scope, options, many_ticks=None):
        """Scope has the functions that make and move the pendula: the globals of main.

        options has elastic, inelastic, e and mass, as support/start/options.py reads them. many_ticks is the fast path,
        if there is one.
        """
        self.scope, self.many_ticks, self.mass = scope, many_ticks, options.mass
        self.collisions: dict[str, Any] = {
            "as in the CSV": None,  # as the cradle was made
            "elastic, e = 1": special_cradles.elastic_newton_cradle,
            "inelastic, e = 0": special_cradles.inelastic_newton_cradle,
        }
        self.collision = list(self.collisions)[1 if options.elastic else 2 if options.inelastic else 0]
        if options.e is not None:
            self.collision = f"e = {options.e:g}"
            self.collisions[self.collision] = partial(special_cradles.uniform_e_newton_cradle, e_val=options.e)
        self.pend_list: list = []
        self.held: int | None = None  # the index of the bob that is held
        self.hits: list[tuple[int, int, bool]] = []
        self.takes_rule = all(
            "approaching_only" in signature(function).parameters
            for function in (scope[self.ticker], self.meeting_place().get(self.meeter))
            if function
        )

    # --- made, and moved ---------------------------------------------------------------------------------------------

    @contextmanager
    def reading_once(self):
        """Let extract_and_convert read each file once while the body of the with statement makes cradles of it.

        The special cradles then take e and mass from what make_newton_cradle has read.
        """
        read, readings = vars(special_cradles).get("extract_and_convert"), {}
        if read is None:  # a student's functions may do without
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
        """Hide the objects of the present pendula, so that new ones are made of them."""
        for pend in reversed(self.pend_list):  # what is given back last is used first
            discard(pend["objects"])
        self.pend_list, self.held = [], None

    def take(self, pend_list, csv) -> None:
        """Become the cradle of these pendula, made of the file at the path csv; raise a MistakeError if they are none.

        pend_list is the loop's own list, which its ticks change.
        """
        self.check_made(pend_list)
        self.pend_list = pend_list
        self.numbers = {id(pend): number for number, pend in enumerate(pend_list)}
        if self.mass is not None:
            cradle = special_cradles.uniform_mass_newton_cradle(csv, self.mass)
            self.adopt("mass", [pend["mass"] for pend in cradle])
        self.es = [pend["e"] for pend in pend_list]
        self.collide(self.collision, csv)
        lifted = [any(cord_angles(pend)) for pend in pend_list]
        first, *others = cord_angles(pend_list[0])
        self.made = [first, *(angle - first for angle in others)], [*lifted, False].index(False)

    def check_made(self, pend_list) -> None:
        """Raise a MistakeError if this is no list of pendula with all that a cradle needs."""
        make = self.scope[self.maker]
        if pend_list is None:
            raise MistakeError(make, "returned None; a list of dictionaries is wanted. Is a return missing?")
        if not isinstance(pend_list, list) or not all(isinstance(pend, dict) for pend in pend_list):
            raise MistakeError(make, f"returned a {type(pend_list).__name__}; a list of dictionaries is wanted.")
        if not pend_list:
            raise MistakeError(make, "returned an empty list; a cradle has at least one pendulum.")
        for number, pend in enumerate(pend_list, start=1):
            for key in ("mass", "e", *self.coordinate_keys):
                if not is_number(pend.get(key)):
                    found = repr(pend[key]) if key in pend else "no such key"
                    raise MistakeError(make, f"gave pendulum {number} as {key}: {found}; a number is wanted.")
            parts = pend.get("objects")
            if not isinstance(parts, tuple) or len(parts) != 1 + 2 * len(self.angles):
                found = f"a {type(parts).__name__}" if "objects" in pend else "no such key"
                raise MistakeError(make, f"gave pendulum {number} as objects: {found}; a tuple of its parts is wanted.")

    def check(self) -> None:
        """Raise a MistakeError if a tick has changed the number of pendula, or made what is no number."""
        if len(self.pend_list) != len(self.numbers):
            words = f"made {len(self.pend_list)} pendula of {len(self.numbers)}; a cradle keeps its pendula."
            raise MistakeError(self.scope[self.ticker], words)
        for number, pend in enumerate(self.pend_list, start=1):
            for key in self.coordinate_keys:
                if not is_number(pend.get(key)):
                    words = f"made {key} of pendulum {number} {pend.get(key)!r}; a finite number is wanted."
                    raise MistakeError(self.scope[self.ticker], words)

    def adopt(self, key, values) -> None:
        """Give each pendulum its one of these values for key."""
        for pend, value in zip(self.pend_list, values, strict=False):  # main may have made it of another file
            pend[key] = value

    def collide(self, collision, csv) -> None:
        """Collide from now on in this way, one of collisions; csv is the path of the cradle's file."""
        self.collision, make = collision, self.collisions[collision]
        self.adopt("e", [pend["e"] for pend in make(csv)] if make else self.es)

    def as_made(self) -> tuple[list[float], int]:
        """Return the angles (rad) to which the cradle was lifted as it was made, and of how many pendula."""
        return self.made

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (rad), let the others hang, all at rest.

        There is one angle for each cord of a pendulum, that of a lower one from the direction of the upper one. An
        angle that is None, or a number of lifted ones that is None, is as the cradle was made. If all are None, the
        pendula are left as they were made.
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

    def make_room(self, lifted) -> None:
        """Push aside whoever is in the way of the lifted pendula: nobody, as these are single ones."""

    @contextmanager
    def held_still(self):
        """Hold the bob that is held, if there is one, while the body of the with statement does a few ticks."""
        if self.held is None:
            yield
            return
        pend = self.pend_list[self.whose(self.held)[0]]
        mass, angles = pend["mass"], cord_angles(pend)
        pend["mass"] = HAND
        yield
        move(pend, angles, R_PARAM)
        pend["mass"] = mass

    def tick_at_once(self, ticks, rule) -> list[tuple[int, int, int, bool]] | None:
        """Do so many ticks with this rule at once, and return the contacts as (tick, left, right, to the right).

        Return None, and do nothing, if that is not certain to be the same as single ticks.
        """
        contacts = self.many_ticks(self.scope, self.pend_list, ticks, rule) if self.many_ticks else None
        return [] if contacts is not None and self.held is not None else contacts

    # --- hits --------------------------------------------------------------------------------------------------------

    def meeting_place(self) -> dict[str, Any]:
        """Return where the tick finds the function that lets two pendula hit: the globals of its module."""
        return self.scope

    @contextmanager
    def noting_hits(self):
        """Note who hits whom while the body of the with statement does ticks; nothing while a bob is held.

        A hit is a call of the function for two pendula that changes a velocity. What a whole tick changes says less: a
        train of hits leaves the bobs in the middle as they were.
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
                before1 = None  # these are no pendula, as meet will say
            result = meet(*given, **named)
            if before1 is not None and (rates(pend1) != before1 or rates(pend2) != before2):
                self.note_hit(pend1, pend2, self.velocity(pend1, before1) + self.velocity(pend2, before2))
            return result

        place[self.meeter] = noted
        try:
            yield
        finally:
            place[self.meeter] = meet

    def note_hit(self, pend1, pend2, velocity) -> None:
        """Note that these two have hit each other; velocity is the sum of theirs before, to the right."""
        if id(pend1) in self.numbers and id(pend2) in self.numbers:
            left, right = sorted((self.numbers[id(pend1)], self.numbers[id(pend2)]))
            self.hits.append((left, right, velocity > 0))

    def velocity(self, pend, omega) -> float:
        """Return the velocity of a pendulum's bob to the right (in cord lengths a second) at this omega (rad/s)."""
        return omega * cos(pend["theta"])

    # --- shown, held and weighed -------------------------------------------------------------------------------------

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
        """Hold this bob (an index into bobs), and its pendulum with it, where it is, until let_go."""
        self.held = bob
        pend = self.pend_list[self.whose(bob)[0]]
        move(pend, cord_angles(pend), R_PARAM)

    def whose(self, bob) -> tuple[int, int]:
        """Return the index of this bob's pendulum, and which of its bobs it is, counted from above."""
        return divmod(bob, len(self.angles))  # there is a release angle for each cord, and a bob at its end

    def drag(self, bob, x, y) -> None:
        """Turn the pendulum of this bob until the bob is nearest to the point x, y (m) in the plane of swing."""
        pendulum, number = self.whose(bob)
        drag_bob(self.pend_list, pendulum, number, x, y, R_PARAM)

    def let_go(self) -> None:
        """Let the bob that is held swing from where it is."""
        self.held = None

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""
        return kinetic_energy(self.pend_list, R_PARAM), potential_energy(self.pend_list, R_PARAM, G)

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""
        return momentum(self.pend_list, R_PARAM)

    def thetas(self) -> list[float]:
        """Return the angles of the pendula (rad), from left to right."""
        return [pend["theta"] for pend in self.pend_list]

    def coordinates(self) -> dict[str, float]:
        """Return coordinates (rad) and their rates (rad/s) by name: theta_1, theta_2, ..., from left to right."""
        numbered = list(enumerate(self.pend_list, start=1))
        return {f"{key}_{i}": pend[key] for key in self.coordinate_keys for i, pend in numbered}


def is_number(value) -> bool:
    """Return whether this is a number, and a finite one."""
    return isinstance(value, Real) and isfinite(value)
