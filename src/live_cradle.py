"""The cradle as the viewer plays with it: built from a CSV, let go, advanced, dragged by a bob, and weighed."""

from collections.abc import Sequence
from functools import partial
from math import atan2, copysign, cos, radians

from src.dragging import drag_pendulum
from src.pds_helper import extract_and_convert
from src.special_cradles import (
    elastic_newton_cradle,
    inelastic_newton_cradle,
    make_newton_cradle,
    uniform_e_newton_cradle,
    uniform_mass_newton_cradle,
)
from src.swinging import full_swing_update
from support.audit import kinetic_energy, momentum, potential_energy
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.cradle_csv import check_cradle
from support.shapes import discard

HAND = 1e9  # kg: a bob that is held throws others back like a wall
GRIP = 10  # ticks after which it is put back to where it is held; until then it falls by a thousandth of a degree


class LiveCradle:
    """A cradle of single pendula with the shipped constants, as support/cradle.py wants a cradle to be."""

    dt = DT
    reach = R_PARAM
    angles: Sequence[str] = ("Release angle",)

    def __init__(self, advance, options):
        """advance is advance_cradle; options has elastic, inelastic, e and mass, as support/options.py reads them."""
        self.advance_cradle, self.mass = advance, options.mass
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
        self.pend_list = make_newton_cradle(csv, R_PARAM, THETA_INIT)
        if self.mass is not None:
            self.adopt("mass", uniform_mass_newton_cradle(csv, self.mass))
        self.collide(self.collision)

    def adopt(self, key, others) -> None:
        """Give each pendulum the value that its counterpart in others has for key."""
        for pend, other in zip(self.pend_list, others, strict=True):
            pend[key] = other[key]

    def collide(self, collision) -> None:
        """Collide from now on in this way, one of collisions."""
        self.collision = collision
        self.adopt("e", self.collisions[collision](self.csv))

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (one, in degrees, outwards), let the others hang, all at rest."""
        theta_init = copysign(radians(angles[0]), THETA_INIT)
        for i, pend in enumerate(self.pend_list):
            pend["theta"], pend["omega"] = theta_init if i < lifted else 0.0, 0.0
        self.show()

    def show(self) -> None:
        """Show all bobs where they are."""
        full_swing_update(self.pend_list, R_PARAM, 0, G)  # no time passes

    def advance(self, ticks, approaching_only) -> list[tuple[int, int]]:
        """Move on by so many ticks; return the contacts as (tick, index of the left bob), none while a bob is held."""
        if self.held is None:
            return self.advance_cradle(self.pend_list, R_PARAM, DT, G, ticks, approaching_only)
        pend = self.pend_list[self.held]
        theta, mass = pend["theta"], pend["mass"]
        pend["mass"] = HAND
        for start in range(0, ticks, GRIP):
            self.advance_cradle(self.pend_list, R_PARAM, DT, G, min(GRIP, ticks - start), approaching_only)
            pend["theta"], pend["omega"] = theta, 0.0
        pend["mass"] = mass
        self.show()
        return []

    def axles(self) -> list:
        """Return the axles, from left to right."""
        return [pend["objects"][0] for pend in self.pend_list]

    def bobs(self) -> list:
        """Return the bobs, from left to right."""
        return [pend["objects"][1] for pend in self.pend_list]

    def cords(self) -> list:
        """Return the cords, from left to right."""
        return [pend["objects"][2] for pend in self.pend_list]

    def hold(self, bob) -> None:
        """Hold this bob (an index into bobs) where it is, until let_go."""
        self.held = bob
        self.pend_list[bob]["omega"] = 0.0

    def drag(self, bob, x, y) -> None:
        """Turn the pendulum of this bob until the bob is nearest to the point x, y (m) in the plane of swing."""
        axle = self.pend_list[bob]["objects"][0].pos
        drag_pendulum(self.pend_list, bob, atan2(x - axle.x, axle.y - y), R_PARAM)

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
        """Return theta_1, theta_2, ... (rad) and omega_1, omega_2, ... (rad/s), from left to right."""
        named = [(key, i, pend[key]) for key in ("theta", "omega") for i, pend in enumerate(self.pend_list, start=1)]
        return {f"{key}_{i}": value for key, i, value in named}
