"""The cradles of the programs: main makes and moves them; these classes release them, and measure
them.
"""

import sys
from collections import ChainMap
from collections.abc import Mapping, Sequence
from inspect import signature
from itertools import accumulate
from math import pi, sqrt
from pathlib import Path
from typing import Any

from vpython import dot, mag, vector

from support.constants import DOUBLE_DT, DT, G, R_PARAM
from support.cradle.dragging import Hand, move, push_others
from support.cradle.impacts import Hits
from support.energy import bob_motions, energies, momentum
from support.files.cradle_csv import Snapshot
from support.pendulum import cord_angles, discard
from support.start.mistake import MistakeError, require_list, require_numbers, require_pendula
from support.start.preview import unwritten_in

AS_MADE = "as in the CSV"  # how bobs collide: each pendulum keeps its own e

SRC = Path(__file__).resolve().parents[2] / "src"


def loaded_modules() -> list[dict[str, Any]]:
    """Return the names in each imported module of src/, and of files that you have added there or
    beside it.
    """
    found = []
    for module in [*sys.modules.values()]:
        # Not module.__file__: that would import a deferred module
        names = getattr(module, "__dict__", {})
        file = Path(names.get("__file__") or "")
        if SRC.name in file.parts or file.parent.name == SRC.parent.name:
            folders = file.resolve().parents
            if SRC in folders or SRC.parent == folders[0]:
                found.append(names)
    return found


UNIFORM_E = "uniform_e_newton_cradle"


class Cradle:
    """A cradle of single pendula with the project's constants; its lists go from left to right."""

    title = "Newton's cradle"
    kind = "single"  # the name of the folder with its experiments
    dt = DT  # s
    reach = R_PARAM  # from an axle to the centre of the lowest bob at rest (m)
    # (least, largest), degrees
    angles: Mapping[str, tuple[float, float]] = {"Release angle": (0, 180)}
    # A pendulum's keys of its angles (rad), the upper cord first
    angle_keys: Sequence[str] = ("theta",)
    rate_keys: Sequence[str] = ("omega",)  # the keys of their rates (rad/s)
    # The names, in the handout's modules, of the functions and of the constant of this kind of
    # cradle.
    make_name, tick_name, dt_name = "make_newton_cradle", "newton_cradle_tick", "DT"
    # The first one that exists lets two pendula collide
    collide_names: Sequence[str] = ("handle_two_bobs",)
    shown_name = "handle_collision"  # One tick shows its calls

    def __init__(self, main, special_cradles, options, many_ticks=None):
        """Find the functions that make and move the pendula: in main's module, in special_cradles,
        and in all of src/.

        options has elastic, inelastic, e and mass from support/start/options.py. many_ticks is the
        fast path, or None.
        """
        own = getattr(main, "__globals__", None)
        if own is None:  # a decorator has made main of a class
            own = vars(sys.modules[main.__module__])
        self.scope: ChainMap[str, Any] = ChainMap(own, special_cradles.__dict__, *loaded_modules())
        self.many_ticks, self.mass = many_ticks, options.mass
        # By its name, a function that returns pendula with the e of this kind, and its arguments
        # behind the file.
        self.collisions: dict[str, Any] = {AS_MADE: (None,)}
        self.collision = AS_MADE
        # Functions without which there is no picture
        self.needs = {"extract_and_convert", self.make_name}
        unwritten = unwritten_in("special_cradles")
        for kind, name, is_chosen in (
            ("elastic, e = 1", "elastic_newton_cradle", options.elastic),
            ("perfectly inelastic, e = 0", "inelastic_newton_cradle", options.inelastic),
        ):
            if not {name, UNIFORM_E} & {*unwritten}:
                self.collisions[kind] = (self.scope[name],)
            if is_chosen:
                self.collision = kind
                self.needs |= {name, UNIFORM_E}
        if options.e is not None:
            self.collision = f"e = {options.e:g}"
            self.collisions[self.collision] = self.scope[UNIFORM_E], options.e
            self.needs.add(UNIFORM_E)
        if self.mass is not None:
            self.needs.add("uniform_mass_newton_cradle")
        self.pend_list: list = []
        # The place (m) of each pendulum's axle -> its index
        self.places: dict[tuple[float, ...], int] = {}
        self.period = 2 * pi * sqrt(R_PARAM / G)  # s: of a small swing
        # s: the longest time between two hits of one train. A tick can let a hit go on by only one
        # bob.
        self.gap = max(self.period / 180, 3 * self.dt)
        self.hand, self.hits = Hand(self), Hits(self)
        self.tick = self.scope[self.tick_name]
        self.collide_name = next(
            (name for name in self.collide_names if name in self.scope), self.collide_names[0]
        )
        functions = self.tick, self.scope.get(self.collide_name, self.tick)
        self.takes_rule = all(
            "approaching_only" in signature(function).parameters for function in functions
        )

    def give_back(self) -> None:
        """Hide the objects of the present pendula; the next pendula reuse them."""
        for pend in reversed(self.pend_list):  # the last discarded object is reused first
            discard(pend["objects"])
        self.pend_list, self.hand.held = [], None

    def accept(self, pend_list, csv) -> None:
        """Take pend_list, made from the file at the path csv, as the new cradle.

        It is the list of main, which the ticks change. Raises a MistakeError if it is no list of
        complete pendula.
        """
        keys = ("mass", "e", *self.angle_keys, *self.rate_keys)
        require_pendula(self.scope[self.make_name], pend_list, keys, 1 + 2 * len(self.angles))
        self.pend_list = pend_list
        self.places = {tuple(axle.pos.value): number for number, axle in enumerate(self.axles())}
        self.count = len(pend_list)
        self.known_keys = {*Snapshot(csv).rows[0].cells, *keys, "objects"}
        if self.mass is not None:
            self.adopt("mass", self.scope["uniform_mass_newton_cradle"], csv, self.mass)
        self.es = self.values("e")
        self.collide(self.collision, csv)
        self.note_lifts()

    def check(self) -> None:
        """Raise a MistakeError if a tick has changed the number of pendula, or set a coordinate to
        no finite number.
        """
        now = len(self.pend_list)
        if now != self.count:
            raise MistakeError(
                self.tick, f"made {now} pendula from {self.count}; it must keep their number."
            )
        require_numbers(self.tick, self.pend_list, (*self.angle_keys, *self.rate_keys))

    def remark(self) -> str:
        """Return a sentence that names a key of a pendulum that the handout does not have, or
        nothing.
        """
        for number, pend in enumerate(self.pend_list, start=1):
            for key in pend:
                if key not in self.known_keys:
                    return (
                        f"Pendulum {number} has the key {key!r}, which the handout does not have."
                    )
        return ""

    def note_lifts(self) -> None:
        """Take the present angles of the pendula as those with which the cradle was made."""
        lifted = [any(cord_angles(pend)) for pend in self.pend_list]
        first, *others = cord_angles(self.pend_list[0])
        # The release angles (rad), and the number of lifted pendula.
        self.as_made = [first, *(angle - first for angle in others)], [*lifted, False].index(False)

    def adopt(self, key, make, *arguments) -> None:
        """Set pend[key] of each pendulum to that of the pendula that the function make returns for
        these arguments.

        Raises a MistakeError if it returns no list of pendula, or if a value is no finite number.
        """
        made = make(*arguments)
        require_list(make, made, "return a list of dictionaries; it returned")
        require_numbers(make, made, [key])
        # Main may have read a different file
        for pend, other in zip(self.pend_list, made, strict=False):
            pend[key] = other[key]

    def collide(self, collision, csv) -> None:
        """Set how bobs collide from now on (a key of collisions); csv is the path of the cradle's
        file.
        """
        self.collision = collision
        make, *arguments = self.collisions[collision]
        if make:
            self.adopt("e", make, csv, *arguments)
        else:
            for pend, e in zip(self.pend_list, self.es, strict=True):
                pend["e"] = e

    def release(self, angles, lifted) -> None:
        """Lift the first `lifted` pendula to these angles (rad); the others hang, or give way to
        them. All are at rest.

        angles has one angle for each cord of a pendulum; the angle of a lower cord is measured from
        the upper cord. None stands for the angle, or the number, with which the cradle was made. If
        all are None, nothing moves.
        """
        if lifted is None and all(angle is None for angle in angles):
            return
        made_angles, made_lifted = self.as_made
        chosen = [
            made if angle is None else angle
            for angle, made in zip(angles, made_angles, strict=True)
        ]
        lifted_angles = list(accumulate(chosen))
        count = max(1, made_lifted) if lifted is None else lifted
        for i, pend in enumerate(self.pend_list):
            move(pend, lifted_angles if i < count else [0.0] * len(angles), R_PARAM)
        if len(angles) == 2:  # a lower cord that is bent inwards reaches far
            for i in reversed(range(min(count, len(self.pend_list)))):
                push_others(self.pend_list, i, R_PARAM)

    def pose(self, angles) -> None:
        """Turn each pendulum to its own angles, a list (rad) of its cords' angles from straight
        down, at rest.
        """
        for pend, own in zip(self.pend_list, angles, strict=True):
            move(pend, own, R_PARAM)
        self.note_lifts()

    def velocity(self, pend) -> float:
        """Return the mean velocity of a pendulum's bobs to the right (m/s)."""
        return sum(vx for _, vx, _ in bob_motions(pend, R_PARAM)) / len(self.angles)

    def approach(self, left, right) -> float:
        """Return the speed (m/s) at which the bobs of two pendula approach each other."""
        return self.velocity(left) - self.velocity(right)

    def axles(self) -> list:
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self) -> list:
        return [bob for pend in self.pend_list for bob in pend["objects"][1::2]]

    def colors(self) -> list:
        return [pend["objects"][1].color for pend in self.pend_list]

    def cords(self) -> list:
        return [cord for pend in self.pend_list for cord in pend["objects"][2::2]]

    def values(self, key) -> list:
        """Return pend[key] of each pendulum."""
        return [pend[key] for pend in self.pend_list]

    def coordinates(self) -> dict[str, float]:
        """Return coordinates (rad) and their rates (rad/s) by name: theta_1, theta_2, ..., from
        left to right.
        """
        numbered = list(enumerate(self.pend_list, start=1))
        return {
            f"{key}_{i}": pend[key]
            for key in (*self.angle_keys, *self.rate_keys)
            for i, pend in numbered
        }

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""
        return energies(self.pend_list, R_PARAM, G)

    def top_speeds(self) -> list[float]:
        """Return the speed (m/s) of each pendulum at its lowest point, with the energy that it has
        now.
        """
        return [
            sqrt(2 * sum(energies([p], R_PARAM, G)) / self.whole_mass(p)) for p in self.pend_list
        ]

    def heights(self) -> list[float]:
        """Return the mean height (m) of each pendulum's bobs above hanging at rest."""
        return [
            sum(height for height, _, _ in bob_motions(p, R_PARAM)) / len(self.angles)
            for p in self.pend_list
        ]

    def whole_mass(self, pend) -> float:
        """Return the mass (kg) of all bobs of a pendulum."""
        return pend["mass"] * len(self.angles)

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""
        return momentum(self.pend_list, R_PARAM)

    def constants(self) -> str:
        """Return the constants with which the energy and all speeds are computed, in words."""
        cord = f"R_PARAM = {R_PARAM} m"
        tick = f"{self.dt_name} = {self.dt} s"
        gravity = f"G = {G} m/s^2"
        return f"support/constants.py has {cord} (cord), {tick} (tick) and {gravity} (gravity)."


class DoubleCradle(Cradle):
    """A cradle of double pendula, each with two bobs and two cords of length R_PARAM."""

    title = "Newton's double cradle"
    kind = "double"
    dt = DOUBLE_DT
    reach = 2 * R_PARAM
    angles = {"Angle theta": (0, 180), "Angle phi": (-180, 180)}
    angle_keys = ("theta", "phi")
    rate_keys = ("omega", "phi_omega")
    make_name, tick_name, dt_name = "make_double_newton_cradle", "double_cradle_tick", "DOUBLE_DT"
    # The second one lets only the upper bobs collide
    collide_names = "handle_two_double_bobs", "handle_two_bobs"
    shown_name = "handle_two_double_bobs"

    def approach(self, left, right) -> float:
        """Return the speed (m/s) at which the nearest two bobs of two pendula approach each other."""
        moves = [
            (bob2.pos - bob1.pos, vector(vx1 - vx2, vy1 - vy2, 0))
            for bob1, (_, vx1, vy1) in zip(
                left["objects"][1::2], bob_motions(left, R_PARAM), strict=True
            )
            for bob2, (_, vx2, vy2) in zip(
                right["objects"][1::2], bob_motions(right, R_PARAM), strict=True
            )
        ]
        apart, closer = min(moves, key=lambda move: mag(move[0]))
        return dot(closer, apart) / (mag(apart) or 1.0)  # 0, if one is in the other's place
