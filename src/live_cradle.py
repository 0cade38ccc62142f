"""The cradle as the viewer plays with it: built from a CSV, let go, advanced, dragged by a bob, and weighed."""

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import accumulate
from math import copysign, cos, radians

from src.dragging import cord_angles, drag_bob, move
from src.pds_helper import extract_and_convert
from src.special_cradles import (
    elastic_newton_cradle,
    inelastic_newton_cradle,
    make_newton_cradle,
    uniform_e_newton_cradle,
    uniform_mass_newton_cradle,
)
from support.audit import kinetic_energy, momentum, potential_energy
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.cradle_csv import check_cradle
from support.shapes import discard

HAND = 1e9  # kg: a bob that is held throws others back like a wall
GRIP = 10  # ticks after which it is put back to where it is held; until then it falls by less than 0.01 degrees


class LiveCradle:
    """A cradle of single pendula with the shipped constants, as support/cradle.py wants a cradle to be."""

    dt = DT
    reach = R_PARAM
    angles: Mapping[str, tuple[float, float]] = {"Release angle": (0, 180)}
    coordinate_keys: Sequence[str] = ("theta", "omega")

    def __init__(self, advance, options):
        """advance is advance_cradle; options has elastic, inelastic, e and mass, as support/options.py reads them."""
        self.advance_pendula, self.mass = advance, options.mass
        self.collisions = {
            "as in the CSV": extract_and_convert,
            "elastic, e = 1": elastic_newton_cradle,
            "inelastic, e = 0": inelastic_newton_cradle,
        }
        self.collision = list(self.collisions)[1 if options.elastic else 2 if options.inelastic else 0]
        if options.e is not None:
            self.collision = f"e = {options.e:g}"
            self.collisions[self.collision] = partial(uniform_e_newton_cradle, e_val=options.e)
        self.pend_list: list = []
        self.held: int | None = None  # the index of the bob that is held

    def load(self, csv) -> None:
        """Build the cradle anew from a CSV (a Snapshot). If it makes none, raise a ValueError and stay as it was."""
        check_cradle(csv)
        for pend in self.pend_list:
            discard(pend["objects"])
        self.csv, self.held = csv, None
        self.pend_list = self.make(csv)
        if self.mass is not None:
            self.adopt("mass", uniform_mass_newton_cradle(csv, self.mass))
        self.collide(self.collision)

    def make(self, csv) -> list:
        """Return the pend_list of a CSV."""
        return make_newton_cradle(csv, R_PARAM, THETA_INIT)

    def adopt(self, key, others) -> None:
        """Give each pendulum the value that its counterpart in others has for key."""
        for pend, other in zip(self.pend_list, others, strict=True):
            pend[key] = other[key]

    def collide(self, collision) -> None:
        """Collide from now on in this way, one of collisions."""
        self.collision = collision
        self.adopt("e", self.collisions[collision](self.csv))

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (degrees, outwards), let the others hang, all at rest.

        There is one angle for each cord of a pendulum, that of a lower one from the direction of the upper one.
        """
        outwards = copysign(1, THETA_INIT)
        lifted_angles = list(accumulate(outwards * radians(angle) for angle in angles))
        for i, pend in enumerate(self.pend_list):
            move(pend, lifted_angles if i < lifted else [0.0] * len(angles), R_PARAM)

    def advance(self, ticks, approaching_only) -> list[tuple[int, int, int]]:
        """Move on by so many ticks; return the contacts as (tick, left, right), indices of pendula.

        While a bob is held there are none.
        """
        if self.held is None:
            return self.advance_pendula(self.pend_list, R_PARAM, self.dt, G, ticks, approaching_only)
        pend = self.pend_list[self.whose(self.held)[0]]
        mass, angles = pend["mass"], cord_angles(pend)
        pend["mass"] = HAND
        for start in range(0, ticks, GRIP):
            self.advance_pendula(self.pend_list, R_PARAM, self.dt, G, min(GRIP, ticks - start), approaching_only)
            move(pend, angles, R_PARAM)
        pend["mass"] = mass
        return []

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

    def velocities(self) -> list[float]:
        """Return the velocities of the bobs to the right (m/s)."""
        return [R_PARAM * pend["omega"] * cos(pend["theta"]) for pend in self.pend_list]

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
