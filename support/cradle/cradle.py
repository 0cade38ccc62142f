"""The cradle of a program, which makes and moves it; this class releases and measures it."""

import re
from collections.abc import Mapping, Sequence
from itertools import accumulate
from math import isclose, pi, sqrt
from typing import Any

from vpython import vector

from support.columns import SETTABLE
from support.constants import DT, G, R_PARAM
from support.cradle.dragging import move, push_others
from support.energy import bob_motions, energies
from support.files.experiments import Hidden
from support.files.valid_cradle import CradleCsv, numbers_in
from support.pendulum import cord_angles, Pendulum
from support.start.mistake import MistakeError, require_numbers, require_pendula

COUNT = "the number of bobs"
# Times the largest angle: earlier hits may have left a smaller one to a pendulum that hangs.
HANGS = 0.02

# Names of values that would give a hidden mass, or a hidden e, away at once
TELLING = re.compile("energ|kinetic|potential|total|moment", re.IGNORECASE)


class Cradle:
    """A cradle of single pendula with the project's constants; its lists go from left to right."""

    title = "Newton's cradle"
    kind = "single"  # the name of the folder with its experiments
    theta_bob = "bob"  # what a sentence calls the one at the end of the cord with theta
    dt = DT  # s
    cord_count = 1  # of a pendulum; each cord has one bob
    # For each cord, the name of its release angle, and the least and the largest one (degrees).
    angle_limits: Mapping[str, tuple[float, float]] = {"release_angle": (0, 180)}
    # A pendulum's keys of its angles (rad), the upper cord first, and of their rates (rad/s).
    angle_keys: Sequence[str] = ("theta",)
    rate_keys: Sequence[str] = ("omega",)
    # The names of the functions of this cradle.
    make_name = "make_newton_cradle"
    tick_name = "newton_cradle_tick"
    # Of these, the first one in the tick's module lets two pendula collide.
    collide_names: Sequence[str] = ("handle_two_bobs",)

    def __init__(self) -> None:
        # From an axle to the centre of the lowest bob at rest (m)
        self.cords_length = self.cord_count * R_PARAM
        self.pend_list: list[Pendulum] = []
        self.count = 0  # the number of pendula
        self.hidden: Hidden | None = None  # a class finds it
        self.set_by_program: list[str] = []  # COUNT, or columns of the CSV
        self.made_angles: list[float] = []  # rad: their release angle
        self.lifted = 0  # the number of lifted pendula, at the release or by hand
        self.period = 2 * pi * sqrt(R_PARAM / G)  # s: of a small swing
        # s: the longest time between two hits of one series. A tick can let a hit go on by only
        # one bob.
        self.series_pause = max(self.period / 180, 3 * self.dt)
        self.find_functions({})

    # --- a new cradle --------------------------------------------------------------------------

    def find_functions(self, names: dict[str, Any]) -> None:
        """Find the functions that make and move the pendula, among the names of a program."""
        self.make_function = names.get(self.make_name, self.make_name)
        self.tick_function = names.get(self.tick_name, self.tick_name)
        # The names of the tick's module, in which it finds the function that collides
        self.tick_names = getattr(self.tick_function, "__globals__", names)
        found = [name for name in self.collide_names if name in self.tick_names]
        self.collide_name = (found or self.collide_names)[0]

    def accept(self, pend_list: list[Pendulum]) -> None:
        """Take pend_list as the new cradle.

        It is the list of the program, which the ticks change. Raises a MistakeError if it is no
        list of complete pendula.
        """
        keys = (*SETTABLE, *self.angle_keys, *self.rate_keys)
        require_pendula(self.make_function, pend_list, keys, 1 + 2 * self.cord_count)
        self.pend_list = pend_list
        self.count = len(pend_list)
        self.note_made_angles()

    def differences_from(self, csv: CradleCsv) -> list[str]:
        """Return where the cradle differs from this CSV: COUNT, and names of columns."""
        found = [COUNT] if len(self.pend_list) != len(csv.pendula) else []
        for name in SETTABLE:
            pairs = zip(self.values(name), numbers_in(csv, name), strict=False)
            # An older pandas reads the last digit of a long number in another way
            if not all(isclose(value, number) for value, number in pairs):
                found.append(name)
        return found

    def require_same_pendula(self) -> None:
        """Raise a MistakeError if a tick has changed the number of pendula, or spoilt one."""
        now = len(self.pend_list)
        if now != self.count:
            message = f"made {now} pendula from {self.count}; it must keep their number."
            raise MistakeError(self.tick_function, message)
        keys = (*self.angle_keys, *self.rate_keys)
        require_numbers(self.tick_function, self.pend_list, keys)

    # --- the release ---------------------------------------------------------------------------

    def note_made_angles(self) -> None:
        """Take the present angles of the pendula as those with which the cradle was made."""
        upper, *lower = cord_angles(self.pend_list[0])
        self.made_angles = [upper, *(angle - upper for angle in lower)]
        self.note_lifted()

    def release_angles(self, angles: Sequence[float | None]) -> list[float]:
        """Return these angles (rad), with that of the program for each None."""
        return [
            made if angle is None else angle
            for angle, made in zip(angles, self.made_angles, strict=True)
        ]

    def note_lifted(self) -> None:
        """Count the pendula that are lifted now."""
        angles = [max(map(abs, cord_angles(pend))) for pend in self.pend_list]
        self.lifted = sum(angle > HANGS * max(angles) for angle in angles)

    def release(self, angles: Sequence[float | None], lifted: int | None) -> None:
        """Lift the first `lifted` pendula to these angles (rad); the others hang, all are at rest.

        angles has one angle for each cord of a pendulum; that of a lower cord is measured from the
        upper one. None stands for the angle, or the number, with which the cradle was made. If all
        are None, nothing moves. Pendula that are in the way give way.
        """
        if lifted is None and all(angle is None for angle in angles):
            return
        if lifted is None:
            lifted = max(1, self.lifted)
        self.lifted = count = min(lifted, len(self.pend_list))
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
        """Return the speed (m/s) at which the bobs of two pendula approach each other.

        Of double pendula, it is that of the upper or of the lower bobs, the larger one.
        """
        bobs = zip(bob_motions(left, R_PARAM), bob_motions(right, R_PARAM), strict=True)
        return max(bob1.vx - bob2.vx for bob1, bob2 in bobs)

    def axles(self) -> list:
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self) -> list:
        """Return all bobs, the upper one of a pendulum before its lower one."""
        return [bob for pend in self.pend_list for bob in pend["objects"][1::2]]

    def colors(self) -> list[vector]:
        """Return the color of each pendulum's upper bob."""
        return [pend["objects"][1].color for pend in self.pend_list]

    def index_of(self, value: Any) -> int | None:
        """Return the index of a pendulum; of another value, None."""
        for index, pend in enumerate(self.pend_list):
            if pend is value:
                return index
        return None

    def values(self, key: str) -> list:
        """Return pend[key] of each pendulum."""
        return [pend[key] for pend in self.pend_list]

    def without_hidden(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return these values, by their names, without those that give a hidden value away.

        Recorded data, the lines in the terminal and the page's state (unknown.py) pass through it.
        """
        is_hiding = self.hidden is not None
        return {name: values[name] for name in values if not (is_hiding and TELLING.search(name))}

    def shown(self, key: str) -> list:
        """Return pend[key] of each pendulum, to be drawn: None stands for a hidden value."""
        values = self.values(key)
        if self.hidden and self.hidden.column == key:
            for row in self.hidden.rows:
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
