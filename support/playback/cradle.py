"""The protocol of a cradle: its parts that the programs use."""

from collections.abc import Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Protocol


class Cradle(Protocol):
    """Programs use a cradle only through these attributes and methods. They never look inside a pendulum."""

    title: str  # of the page
    kind: str  # the name of the folder with its experiments
    dt: float  # one tick (s)
    reach: float  # from an axle to the centre of the lowest bob at rest (m)
    angles: Mapping[str, tuple[float, float]]  # name of a release angle -> (least, largest), degrees
    collider: str  # the name of the function whose calls noting_calls notes
    angle_keys: Sequence[str]  # a pendulum's keys of its angles (rad), the upper cord first
    rate_keys: Sequence[str]  # the keys of their rates (rad/s), in the same order
    collisions: dict[str, Any]  # the keys are the names of the kinds of collisions
    collision: str  # the present key of collisions
    held: int | None  # the held bob, an index into bobs
    mass: float | None  # the mass (kg) of all bobs, in place of those in the CSV
    takes_rule: bool  # whether its tick has the parameter approaching_only
    hits: list[tuple[int, int, bool, float]]  # new hits: (left, right, rightwards, speed), with indices of pendula

    @contextmanager
    def reading_once(self):
        """Read each file at most once in the body of the with statement."""
        yield

    def give_back(self) -> None:
        """Hide the objects of the present pendula; the next pendula reuse them."""

    def take(self, pend_list, csv) -> None:
        """Take pend_list, made from the file at the path csv, as the new cradle.

        It is the list of main, which the ticks change. Raises a MistakeError if it is no list of complete pendula.
        """

    def options(self) -> dict[str, Any]:
        """Return the options with which the programs make the present collisions and masses: e, mass, ..."""

    def release(self, angles, lifted) -> None:
        """Lift the first `lifted` pendula to these angles (rad) and let the others hang, all at rest.

        None stands for the angle, or the number, with which the cradle was made. If all are None, nothing moves.
        """

    def pose(self, angles) -> None:
        """Turn each pendulum to its own angles, a list (rad) of its cords' angles from straight down, at rest."""

    def write(self, csv, filepath) -> None:
        """Write the pendula of the CSV at the path csv to the file at filepath, with the handout's functions."""

    @contextmanager
    def noting_calls(self):
        """Yield a list; each call of the collision function in the body of the with statement adds it, as text."""
        yield []

    def as_made(self) -> tuple[list[float], int]:
        """Return the release angles (rad) with which the cradle was made, and the number of lifted pendula."""

    def collide(self, collision, csv) -> None:
        """Set how bobs collide from now on (a key of collisions); csv is the path of the cradle's file."""

    @contextmanager
    def held_still(self):
        """Keep the held bob, if any, in its place while the body of the with statement does a few ticks."""
        yield

    @contextmanager
    def noting_hits(self):
        """Record the hits of the ticks in the body of the with statement.

        The speed of a hit is that of the two bobs' approach before it (m/s), negative if they moved apart.
        """
        yield

    def tick_at_once(self, ticks, rule) -> list[tuple[int, int, int, bool, float]] | None:
        """Do `ticks` ticks with this rule in one call; return the contacts as (tick, left, right, rightwards, speed).

        Return None, and do nothing, if the result might differ from that of single ticks.
        """

    def check(self) -> None:
        """Raise a MistakeError if a tick has changed the number of pendula, or set a coordinate to no finite number."""

    def axles(self) -> list:
        """Return the axles, from left to right."""

    def bobs(self) -> list:
        """Return all bobs, from left to right."""

    def cords(self) -> list:
        """Return all cords."""

    def swings_through(self) -> bool:
        """Return whether a bob swings through others, because the tick lets only neighbours collide."""

    def colors(self) -> list:
        """Return the colors (vectors) of the pendula, from left to right."""

    def constants(self) -> str:
        """Return the constants with which main moves the cradle, in words."""

    def masses(self) -> list[float]:
        """Return the masses of the pendula's bobs (kg), from left to right."""

    def restitutions(self) -> list[float]:
        """Return the coefficients of restitution of the pendula, from left to right."""

    def thetas(self) -> list[float]:
        """Return the angles of the pendula (rad), from left to right; of double ones, those of their upper cords."""

    def hold(self, bob) -> None:
        """Hold this bob (an index into bobs) in its place."""

    def drag(self, bob, x, y) -> None:
        """Drag this held bob as near as possible to x, y (m) in the plane of swing."""

    def let_go(self) -> None:
        """Let the held bob go, if there is one."""

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""

    def coordinates(self) -> dict[str, float]:
        """Return the coordinates of all pendula (rad) and their rates (rad/s), by name."""
