"""The bob that you grab with the mouse or a finger, and hold."""

from collections.abc import Sequence

from vpython import vector

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.dragging import bob_at, drag_bob, move, point_in_plane
from support.pendulum import cord_angles, Pendulum

HEAVY = 1e9  # kg: the mass of a held bob; others bounce off it as off a wall


class HeldBob:
    """The bob of a cradle that you have grabbed, and hold once you have moved it; or none.

    A ray of the mouse is a point on it (m), and its direction.
    """

    def __init__(self, cradle: Cradle):
        self.cradle = cradle
        self.grabbed: int | None = None  # the index of the grabbed bob in cradle.bobs()
        self.index: int | None = None  # the same, once you have moved it
        self.has_moved = False  # whether you have moved a bob of this cradle
        # The held pendulum while the cradle ticks, and its mass (kg) and angles (rad) without this.
        self.heavy_pend: Pendulum | None = None
        self.kept_mass = 0.0
        self.kept_angles: list[float] = []

    def forget(self) -> None:
        """Hold nothing: the cradle goes, and a new one comes."""
        self.let_go()
        self.has_moved = False

    def grab(self, place: Sequence[float], direction: Sequence[float]) -> None:
        """Grab the bob on this ray, if there is one. A tap that moves nothing changes nothing."""
        self.grabbed = bob_at(self.cradle.bobs(), vector(*place), vector(*direction))

    def drag(self, place: Sequence[float], direction: Sequence[float]) -> None:
        """Bring the grabbed bob as near as possible to this ray, in the plane of swing.

        Once it has moved, it is held: it stays at rest while the cradle ticks.
        """
        point = point_in_plane(vector(*place), vector(*direction))
        if point is None or self.grabbed is None:
            return
        before = cord_angles(self.pend_of(self.grabbed))
        pend_index, bob = divmod(self.grabbed, self.cradle.cord_count)
        drag_bob(self.cradle.pend_list, pend_index, bob, point.x, point.y, R_PARAM)
        if cord_angles(self.pend_of(self.grabbed)) != before:
            self.index = self.grabbed
            self.has_moved = True

    def let_go(self) -> bool:
        """Let the bob swing on; return whether you have held one."""
        was_held = self.index is not None
        self.grabbed = None
        self.index = None
        return was_held

    def pend_of(self, index: int) -> Pendulum:
        """Return the pendulum of the bob with this index."""
        return self.cradle.pend_list[index // self.cradle.cord_count]

    # --- while the cradle ticks ----------------------------------------------------------------

    def make_heavy(self) -> None:
        """Make the held pendulum heavy, before a few ticks."""
        if self.index is not None:
            pend = self.pend_of(self.index)
            self.heavy_pend = pend
            self.kept_mass = pend["mass"]
            self.kept_angles = cord_angles(pend)
            pend["mass"] = HEAVY

    def put_back(self) -> None:
        """Put the held pendulum back into its place, at rest, after these ticks."""
        if self.heavy_pend is not None:
            self.heavy_pend["mass"] = self.kept_mass
            move(self.heavy_pend, self.kept_angles, R_PARAM)
            self.heavy_pend = None
