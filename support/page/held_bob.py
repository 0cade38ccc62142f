"""The bob that you hold with the mouse or a finger."""

from collections.abc import Sequence

from vpython import vector

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.dragging import bob_at, drag_bob, point_in_plane
from support.pendulum import cord_angles


class HeldBob:
    """The bob of a cradle that you hold, or none. While you hold one, the time stands.

    A ray of the mouse is a point on it (m), and its direction.
    """

    def __init__(self, cradle: Cradle):
        self.cradle = cradle
        self.index: int | None = None  # of the held bob in cradle.bobs()
        self.has_moved = False  # whether you have moved it

    def grab(self, place: Sequence[float], direction: Sequence[float]) -> None:
        """Hold the bob on this ray, if there is one."""
        self.index = bob_at(self.cradle.bobs(), vector(*place), vector(*direction))

    def drag(self, place: Sequence[float], direction: Sequence[float]) -> None:
        """Bring the held bob as near as possible to this ray, in the plane of swing.

        It is at rest then, and so are those that it pushes aside.
        """
        point = point_in_plane(vector(*place), vector(*direction))
        if point is None or self.index is None:
            return
        pend_index, bob = divmod(self.index, self.cradle.cord_count)
        pend = self.cradle.pend_list[pend_index]
        before = cord_angles(pend)
        drag_bob(self.cradle.pend_list, pend_index, bob, point.x, point.y, R_PARAM)
        if cord_angles(pend) != before:
            self.has_moved = True
            self.cradle.note_lifted()

    def let_go(self) -> None:
        self.index = None
        self.has_moved = False
