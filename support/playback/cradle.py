"""What a cradle is to the programs that show it."""

from collections.abc import Mapping
from contextlib import contextmanager
from typing import Any, Protocol


class Cradle(Protocol):
    """What the programs are told about a cradle and ask of it. What is inside a pendulum is none of their business."""

    dt: float  # one tick (s)
    reach: float  # how far below its axle a pendulum hangs (m)
    angles: Mapping[str, tuple[float, float]]  # its release angles by name: the least and the largest, in degrees
    collisions: dict[str, Any]  # the names of the ways in which it can collide are the keys
    collision: str  # the present one of them
    held: int | None  # which of its bobs is held
    takes_rule: bool  # whether its tick can be told that only approaching bobs collide
    hits: list[tuple[int, int, bool]]  # noted, and not told yet: the two pendula (indices), whether they moved right

    @contextmanager
    def reading_once(self):
        """Read each file at most once while the body of the with statement makes pendula of it."""
        yield

    def give_back(self) -> None:
        """Hide the objects of the present pendula, so that new ones are made of them."""

    def take(self, pend_list, csv) -> None:
        """Become the cradle of these pendula, made of the file at the path csv; raise a MistakeError if they are none.

        pend_list is the loop's own list, which its ticks change.
        """

    def release(self, angles, lifted) -> None:
        """Lift the first pendula to these angles (rad), let the others hang, all at rest.

        An angle that is None, or a number of lifted ones that is None, is as the cradle was made. If all are None, the
        pendula are left as they were made.
        """

    def as_made(self) -> tuple[list[float], int]:
        """Return the angles (rad) to which the cradle was lifted as it was made, and of how many pendula."""

    def collide(self, collision, csv) -> None:
        """Collide from now on in this way, one of collisions; csv is the path of the cradle's file."""

    @contextmanager
    def held_still(self):
        """Hold the bob that is held, if there is one, while the body of the with statement does a few ticks."""
        yield

    @contextmanager
    def noting_hits(self):
        """Note who hits whom while the body of the with statement does ticks."""
        yield

    def tick_at_once(self, ticks, rule) -> list[tuple[int, int, int, bool]] | None:
        """Do so many ticks with this rule at once, and return the contacts as (tick, left, right, to the right).

        Return None, and do nothing, if that is not certain to be the same as single ticks.
        """

    def check(self) -> None:
        """Raise a MistakeError if a tick has made something of a pendulum that is no number."""

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

    def momentum(self) -> float:
        """Return the momentum to the right (kg m/s)."""

    def coordinates(self) -> dict[str, float]:
        """Return where all pendula are (rad) and how fast they turn (rad/s), each by its name."""
