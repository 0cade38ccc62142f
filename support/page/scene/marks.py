"""What the page draws to show why the cradle moves so: arrows, bars, ghosts and halos."""

from collections.abc import Sequence
from math import hypot, pi, sqrt
from typing import Any, NamedTuple

from vpython import arrow, box, cylinder, sphere, vector

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.energy import bob_motions, momentum
from support.pendulum import arm, make_shape

# s: an arrow is as long as its bob's way in a ninth of a small swing.
ARROW_TIME = 2 * pi * sqrt(R_PARAM / G) / 9
# m/s: a slower bob has no arrow. A bob that comes down from 2 degrees gets as fast.
STILL = 0.035 * sqrt(R_PARAM * G)

# In reaches of the cradle.
BAR = 0.2  # the height of the largest bar
BELOW = 0.17  # its distance from the base
FLAT = 0.01  # the least part of BAR: no shape can have the size 0

GREEN = vector(0.0, 0.62, 0.45)  # of the arrows
YELLOW = vector(1.0, 0.75, 0.0)  # of the halos
GREY = vector(0.5, 0.5, 0.53)  # of the bar of the sum
PALE = vector(0.55, 0.55, 0.55)  # of the ghosts
BOB_IN_GHOST = 0.35  # the part of its bob's color that a ghost has, too


class Label(NamedTuple):
    """A text beside the bars, and its place (m)."""

    x: float
    y: float
    text: str


class Marks:
    """The marks of one cradle; the next cradle takes the same shapes."""

    def __init__(self) -> None:
        self.has_arrows = False
        self.labels: list[Label] = []
        self.depth = 0.0  # m: so far the bars reach below the base
        self.shapes: dict[str, list] = {}  # all that were made, by their name
        # The visible ones of these, and the places (m) of the bars.
        self.arrows: list = []
        self.bars: list = []
        self.xs: list[float] = []

    def surround(self, cradle: Cradle, bottom: float) -> None:
        """Take a new cradle; its base is at the height bottom (m)."""
        self.cradle = cradle
        self.height = BAR * cradle.reach
        # The height (m) of the lower end of a bar that points up.
        self.level = bottom - BELOW * cradle.reach - self.height
        # The largest momentum (kg m/s): its bar has the full height.
        speeds = zip(cradle.pend_list, cradle.top_speeds(), strict=True)
        self.largest = sum(cradle.whole_mass(pend) * speed for pend, speed in speeds) or 1.0
        self.place_arrows()

    def take(self, name: str, count: int, kind: type, **attributes: Any) -> list:
        """Return the first shapes with this name; make those that are missing, and hide the rest.

        They never become parts of a cradle: what makes a ghost a ghost would stay with them.
        """
        shapes = self.shapes.setdefault(name, [])
        while len(shapes) < count:
            shapes.append(make_shape(kind, **attributes))
        for number, shape in enumerate(shapes):
            is_needed = number < count
            if shape.visible != is_needed:  # VPython would send it again
                shape.visible = is_needed
        return shapes[:count]

    def place_arrows(self) -> None:
        """Make an arrow for each bob, a bar below each axle, and one for the sum; or hide all."""
        bobs = self.cradle.bobs()
        reach = self.cradle.reach
        self.xs = [axle.pos.x for axle in self.cradle.axles()]
        first, last = self.xs[0], self.xs[-1]
        self.xs.append(last + reach / 3)  # of the sum
        if self.has_arrows:
            arrow_count = len(bobs)
            bar_count = len(self.xs)
            self.labels = [
                Label(first - reach / 2, self.level, "momentum\n(up = right)"),
                Label(last + 0.6 * reach, self.level, "sum"),
            ]
            self.depth = (BELOW + 2 * BAR) * reach
        else:
            arrow_count = bar_count = 0
            self.labels = []
            self.depth = 0.0
        width = bobs[0].radius / 3
        self.arrows = self.take("arrows", arrow_count, arrow, color=GREEN, shaftwidth=width)
        self.bars = self.take("bars", bar_count, box)
        colors = [*self.cradle.colors(), GREY]
        for bar, color in zip(self.bars, colors, strict=False):
            bar.color = color

    def show_arrows(self, pend_list: Sequence) -> None:
        """Show the velocities and momenta of these pendula; a bar up is a momentum to the right."""
        if not self.has_arrows:
            return
        motions = [motion for pend in pend_list for motion in bob_motions(pend, R_PARAM)]
        for pointer, bob, (_, vx, vy) in zip(self.arrows, self.cradle.bobs(), motions, strict=True):
            moves = hypot(vx, vy) > STILL
            if pointer.visible != moves:
                pointer.visible = moves
            if moves:
                pointer.pos = bob.pos + vector(0, 0, bob.radius)
                pointer.axis = vector(ARROW_TIME * vx, ARROW_TIME * vy, 0)
        momenta = [momentum([pend], R_PARAM) for pend in pend_list]
        momenta.append(sum(momenta))
        # A light bob that bounces back gives more than it had.
        self.largest = max(self.largest, *map(abs, momenta))
        for bar, x, p in zip(self.bars, self.xs, momenta, strict=True):
            height = self.height * p / self.largest
            bar.size = vector(R_PARAM / 8, max(abs(height), FLAT * self.height), R_PARAM / 40)
            bar.pos = vector(x, self.level + height / 2, 0)

    def show_ghosts(self, thetas: Sequence[float]) -> None:
        """Show a pale upper bob and cord at each of these angles (rad), or none for an empty list.

        The page takes each sphere that can be picked for a bob (canvas.js).
        """
        ghosts = self.take("ghosts", len(thetas), sphere, shininess=0, pickable=False)
        threads = self.take("threads", len(thetas), cylinder)
        for i, theta in enumerate(thetas):
            axle, bob, cord = self.cradle.pend_list[i]["objects"][:3]
            axis = arm(theta, R_PARAM)
            color = PALE + BOB_IN_GHOST * bob.color
            # Inside of bob and cord, where these are as predicted.
            ghosts[i].pos = axle.pos + axis
            ghosts[i].radius = 0.97 * bob.radius
            ghosts[i].color = color
            threads[i].pos = axle.pos
            threads[i].axis = axis
            threads[i].radius = 0.9 * cord.radius
            threads[i].color = color

    def show_halos(self, pair: Sequence[int]) -> None:
        """Light up these pendula (indices), or none."""
        bobs: list = []
        for number in pair:
            bobs += self.cradle.pend_list[number]["objects"][1::2]
        halos = self.take("halos", len(bobs), cylinder, color=YELLOW)
        for halo, bob in zip(halos, bobs, strict=True):
            halo.pos = bob.pos - vector(0, 0, bob.radius)
            halo.axis = vector(0, 0, bob.radius / 20)
            halo.radius = 1.3 * bob.radius
