"""The cradle of a program: main makes and moves it; this class releases and measures it."""

from argparse import Namespace
from collections import ChainMap
from collections.abc import Callable, Mapping, Sequence
from inspect import signature
from itertools import accumulate, takewhile
from math import pi, sqrt
from types import ModuleType

from vpython import vector

from support.columns import SETTABLE
from support.constants import DT, G, R_PARAM
from support.cradle.dragging import move, push_others
from support.cradle.settings import Source
from support.energy import bob_motions, energies, momentum
from support.files.experiments import Hidden
from support.pendulum import cord_angles, discard, Pendulum
from support.start.mistake import MistakeError, require_list, require_numbers, require_pendula
from support.start.preview import unwritten_in

UNIFORM_E = "uniform_e_newton_cradle"
UNIFORM_MASS = "uniform_mass_newton_cradle"


class Cradle:
    """A cradle of single pendula with the project's constants; its lists go from left to right."""

    title = "Newton's cradle"
    kind = "single"  # the name of the folder with its experiments
    theta_bob = "bob"  # what a sentence calls the one at the end of the cord with theta
    dt = DT  # s
    cord_count = 1  # of a pendulum; each cord has one bob
    cords_length = R_PARAM  # from an axle to the centre of the lowest bob at rest (m)
    # For each cord, the name of its release angle, and the least and the largest one (degrees).
    angle_limits: Mapping[str, tuple[float, float]] = {"release_angle": (0, 180)}
    # A pendulum's keys of its angles (rad), the upper cord first, and of their rates (rad/s).
    angle_keys: Sequence[str] = ("theta",)
    rate_keys: Sequence[str] = ("omega",)
    # The names of the functions of this cradle.
    make_name = "make_newton_cradle"
    tick_name = "newton_cradle_tick"
    # The first one that the tick's module has lets two pendula collide.
    collide_names: Sequence[str] = ("handle_two_bobs",)
    has_rule = True  # whether the handout has a rule for separating bobs

    def __init__(
        self,
        main: Callable,
        special_cradles: ModuleType,
        options: Namespace,
        many_ticks: ModuleType | None = None,
    ):
        """Find the functions that make and move the pendula, in main's module and special_cradles.

        options has elastic, inelastic, e and mass from support/start/options.py. many_ticks is the
        module of the fast path, or None.
        """
        self.scope = ChainMap(main.__globals__, vars(special_cradles))
        self.many_ticks = many_ticks
        self.mass: float | None = options.mass  # kg, at the start
        self.needs = {"extract_and_convert", self.make_name}  # or there is no picture
        if self.mass is not None:
            self.needs.add(UNIFORM_MASS)
        self.can_set_e = UNIFORM_E not in unwritten_in("special_cradles")  # of all pendula
        self.e_source = self.e_source_of(options)  # at the start; None: the e of the CSV

        self.pend_list: list[Pendulum] = []
        self.count = 0  # the number of pendula
        self.hidden: Hidden | None = None  # a class finds it: nothing shows it
        self.made_angles: list[float] = []  # rad: their release angle
        self.made_lifted = 0  # the number of lifted pendula when they were made
        self.known_keys: set[str] = set()  # of a pendulum
        self.places: dict[tuple[float, ...], int] = {}  # of an axle (m) -> the pendulum's index
        self.period = 2 * pi * sqrt(R_PARAM / G)  # s: of a small swing
        # s: the longest time between two hits of one series. A tick can let a hit go on by only
        # one bob.
        self.series_pause = max(self.period / 180, 3 * self.dt)
        self.make_function = self.scope.get(self.make_name, main)
        self.tick_function = self.scope.get(self.tick_name, main)
        # The names of the tick's module, in which it finds the function that collides
        self.tick_names = getattr(self.tick_function, "__globals__", main.__globals__)
        present = [name for name in self.collide_names if name in self.tick_names]
        self.collide_name = (present or self.collide_names)[0]
        collide = self.tick_names.get(self.collide_name, self.tick_function)
        self.takes_rule = takes_rule(self.tick_function) and takes_rule(collide)

    def e_source_of(self, options: Namespace) -> Source | None:
        """Return the source of the e that options name, or None; note which functions it needs."""
        for function, is_chosen in (
            ("elastic_newton_cradle", options.elastic),
            ("inelastic_newton_cradle", options.inelastic),
        ):
            if is_chosen:
                self.needs |= {function, UNIFORM_E}
                return Source(self.scope[function])
        if options.e is None:
            return None
        self.needs.add(UNIFORM_E)
        return self.uniform_e(options.e)

    def uniform_e(self, e: float) -> Source:
        """Return the source of pendula that all have this e."""
        return Source(self.scope[UNIFORM_E], (e,))

    def slow_remark(self) -> str:
        """Return why the program is slow although nobody has changed a function, or nothing."""
        return self.many_ticks.slow_remark(self.scope) if self.many_ticks else ""

    # --- a new cradle --------------------------------------------------------------------------

    def give_back(self) -> None:
        """Hide the objects of the present pendula; the next pendula reuse them."""
        for pend in reversed(self.pend_list):  # the last discarded object is reused first
            discard(pend["objects"])
        self.pend_list = []

    def accept(self, pend_list: list[Pendulum], columns: Sequence[str]) -> None:
        """Take pend_list, made from a CSV with these columns, as the new cradle.

        It is the list of main, which the ticks change. Raises a MistakeError if it is no list of
        complete pendula.
        """
        keys = (*SETTABLE, *self.angle_keys, *self.rate_keys)
        require_pendula(self.make_function, pend_list, keys, 1 + 2 * self.cord_count)
        self.pend_list = pend_list
        self.places = {tuple(axle.pos.value): index for index, axle in enumerate(self.axles())}
        self.count = len(pend_list)
        self.known_keys = {*columns, *keys, "objects"}
        self.note_made_angles()

    def require_same_pendula(self) -> None:
        """Raise a MistakeError if a tick has changed the number of pendula, or spoilt one."""
        now = len(self.pend_list)
        if now != self.count:
            message = f"made {now} pendula from {self.count}; it must keep their number."
            raise MistakeError(self.tick_function, message)
        keys = (*self.angle_keys, *self.rate_keys)
        require_numbers(self.tick_function, self.pend_list, keys)

    def remark(self) -> str:
        """Return a sentence that names a key which the handout does not have, or ""."""
        for number, pend in enumerate(self.pend_list, start=1):
            for key in pend:
                if key not in self.known_keys:
                    return (
                        f"Pendulum {number} has the key {key!r}, which the handout does not have."
                    )
        return ""

    def adopt(self, key: str, source: Source, csv: str) -> None:
        """Set pend[key] of each pendulum to that of the pendula of this source, from this CSV.

        Raises a MistakeError if it makes no list of pendula, or if require_numbers does.
        """
        others = source.make(csv, *source.arguments)
        require_list(source.make, others, "return a list of dictionaries; it returned")
        require_numbers(source.make, others, [key])
        # main may have read a different file.
        for pend, other in zip(self.pend_list, others, strict=False):
            pend[key] = other[key]

    def use_mass(self, mass: float | None, csv: str) -> None:
        """Set the mass (kg) of all pendula, unless it is None; csv is a path."""
        if mass is not None:
            self.adopt("mass", Source(self.scope[UNIFORM_MASS], (mass,)), csv)

    def use_e_of(self, source: Source | None, csv: str) -> None:
        """Set the e of all pendula to those of a source, unless it is None; csv is a path."""
        if source:
            self.adopt("e", source, csv)

    # --- the release ---------------------------------------------------------------------------

    def note_made_angles(self) -> None:
        """Take the present angles of the pendula as those with which the cradle was made."""
        upper, *lower = cord_angles(self.pend_list[0])
        self.made_angles = [upper, *(angle - upper for angle in lower)]
        lifted = (any(cord_angles(pend)) for pend in self.pend_list)
        self.made_lifted = len([*takewhile(bool, lifted)])

    def release_angles(self, angles: Sequence[float | None]) -> list[float]:
        """Return these angles (rad), with that of main for each None."""
        return [
            made if angle is None else angle
            for angle, made in zip(angles, self.made_angles, strict=True)
        ]

    def lifted_count(self, angles: Sequence[float | None], lifted: int | None) -> int:
        """Return how many pendula release lifts."""
        if lifted is not None:
            return min(lifted, len(self.pend_list))
        if all(angle is None for angle in angles):
            return self.made_lifted
        return max(1, self.made_lifted)

    def release(self, angles: Sequence[float | None], lifted: int | None) -> None:
        """Lift the first `lifted` pendula to these angles (rad); the others hang, all are at rest.

        angles has one angle for each cord of a pendulum; that of a lower cord is measured from the
        upper one. None stands for the angle, or the number, with which the cradle was made. If all
        are None, nothing moves. Pendula that are in the way give way.
        """
        if lifted is None and all(angle is None for angle in angles):
            return
        count = self.lifted_count(angles, lifted)
        lifted_angles = list(accumulate(self.release_angles(angles)))
        for pend in self.pend_list[:count]:
            move(pend, lifted_angles, R_PARAM)
        for pend in self.pend_list[count:]:
            move(pend, [0.0] * len(angles), R_PARAM)
        if len(angles) == 2:  # a lower cord that is bent inwards reaches far
            for index in reversed(range(count)):
                push_others(self.pend_list, index, R_PARAM)

    def pose(self, poses: list[list[float]]) -> None:
        """Turn each pendulum to its pose, at rest.

        A pose has the angles of its cords from straight down (rad).
        """
        for pend, angles in zip(self.pend_list, poses, strict=True):
            move(pend, angles, R_PARAM)
        self.note_made_angles()

    # --- measurements --------------------------------------------------------------------------

    def velocity(self, pend: Pendulum) -> float:
        """Return the mean velocity of a pendulum's bobs to the right (m/s)."""
        return sum(motion.vx for motion in bob_motions(pend, R_PARAM)) / self.cord_count

    def approach(self, left: Pendulum, right: Pendulum) -> float:
        """Return the speed (m/s) at which the bobs of two pendula approach each other."""
        return self.velocity(left) - self.velocity(right)

    def axles(self) -> list:
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self) -> list:
        """Return all bobs, the upper one of a pendulum before its lower one."""
        return [bob for pend in self.pend_list for bob in pend["objects"][1::2]]

    def colors(self) -> list[vector]:
        """Return the color of each pendulum's upper bob."""
        return [pend["objects"][1].color for pend in self.pend_list]

    def values(self, key: str) -> list:
        """Return pend[key] of each pendulum."""
        return [pend[key] for pend in self.pend_list]

    def shown(self, key: str) -> list:
        """Return pend[key] of each pendulum, with None for what is hidden."""
        values = self.values(key)
        if self.hidden and self.hidden.column == key:
            for row in self.hidden.rows:
                if row < len(values):
                    values[row] = None
        return values

    def coordinates(self) -> dict[str, float]:
        """Return coordinates (rad) and their rates (rad/s) by name: theta_1, theta_2, ..."""
        found = {}
        for key in (*self.angle_keys, *self.rate_keys):
            for number, pend in enumerate(self.pend_list, start=1):
                found[f"{key}_{number}"] = pend[key]
        return found

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""
        return energies(self.pend_list, R_PARAM, G)

    def top_speeds(self) -> list[float]:
        """Return the speed (m/s) of each pendulum at its lowest point, with its present energy."""
        return [
            sqrt(2 * sum(energies([pend], R_PARAM, G)) / self.whole_mass(pend))
            for pend in self.pend_list
        ]

    def most_momentum(self) -> float:
        """Return a limit (kg m/s): no pendulum, and no sum of them, gets more momentum.

        Equal bobs only pass their speeds on. Of other bobs, one knows the energy E and the mass M:
        their momenta have at most the sum sqrt(2 M E), however both are shared out.
        """
        masses = [self.whole_mass(pend) for pend in self.pend_list]
        if self.cord_count == 1 and len({*masses}) == 1:
            return masses[0] * sum(self.top_speeds())
        return sqrt(2 * sum(masses) * sum(self.energies()))

    def heights(self) -> list[float]:
        """Return the mean height (m) of each pendulum's bobs above hanging at rest."""
        heights = []
        for pend in self.pend_list:
            total = sum(motion.height for motion in bob_motions(pend, R_PARAM))
            heights.append(total / self.cord_count)
        return heights

    def whole_mass(self, pend: Pendulum) -> float:
        """Return the mass (kg) of all bobs of a pendulum."""
        return pend["mass"] * self.cord_count

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""
        return momentum(self.pend_list, R_PARAM)


def takes_rule(function: Callable) -> bool:
    """Return whether a function has the parameter approaching_only."""
    return "approaching_only" in signature(function).parameters
