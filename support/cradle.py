"""What a cradle is to the programs that show it."""

from collections.abc import Mapping
from typing import Any, Protocol


class Cradle(Protocol):
    """What the programs are told about a cradle and ask of it. What is inside a pendulum is none of their business."""

    dt: float  # one tick (s)
    reach: float  # how far below its axle a pendulum hangs (m)
    angles: Mapping[str, tuple[float, float]]  # its release angles by name: the least and the largest (degrees)
    collisions: dict[str, Any]  # the names of the ways in which it can collide are the keys
    collision: str  # the present one of them
    held: int | None  # which of its bobs is held

    def load(self, csv) -> None:
        """Build the cradle anew from a Snapshot, or raise a ValueError and stay as it was."""

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (degrees), let the others hang, all at rest."""

    def collide(self, collision) -> None:
        """Collide from now on in this way, one of collisions."""

    def advance(self, ticks, approaching_only) -> list[tuple[int, int, int]]:
        """Move on by so many ticks; return the contacts as (tick, left, right), indices of pendula."""

    def axles(self) -> list:
        """Return the axles, from left to right."""

    def bobs(self) -> list:
        """Return all bobs, which can be dragged, from left to right."""

    def cords(self) -> list:
        """Return all cords."""

    def thetas(self) -> list[float]:
        """Return the angles of the pendula (rad), from left to right; of double ones, those of their upper cords."""

    def hold(self, bob) -> None:
        """Hold this bob, an index into bobs, where it is."""

    def drag(self, bob, x, y) -> None:
        """Drag this bob, which is held, as near as it can come to x, y (m) in the plane of swing."""

    def let_go(self) -> None:
        """Let go of the bob that is held, if there is one."""

    def energies(self) -> tuple[float, float]:
        """Return the kinetic and the potential energy (J)."""

    def velocities(self) -> list[float]:
        """Return the velocities of the pendula's bobs to the right (m/s); of double ones, the mean of their two."""

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""

    def coordinates(self) -> dict[str, float]:
        """Return where all pendula are (rad) and how fast they turn (rad/s), each by its name."""
