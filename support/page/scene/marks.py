"""What the page draws to show why the cradle moves so: arrows, ghosts, rings, a dial, and texts."""

from collections.abc import Sequence
from math import degrees, hypot, pi, radians, sqrt
from typing import Any, NamedTuple

from vpython import arrow, cylinder, ring, sphere, vector

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.energy import bob_motions, momentum
from support.page.scene.slow_hits import SlowHit
from support.pendulum import arm, cord_angles, make_shape, Pendulum

# s: an arrow is as long as its bob's way in a ninth of a small swing.
ARROW_TIME = 2 * pi * sqrt(R_PARAM / G) / 9
# m/s: a slower bob has no arrow. A bob that comes down from 2 degrees gets as fast.
STILL = 0.035 * sqrt(R_PARAM * G)
LONGEST = 0.8  # the arrow of the largest change of momentum, in reaches of the cradle
# The dial: where its marks begin, and their length, in lengths of a cord.
DIAL = 0.76
MARK = 0.08

GREEN = vector(0.0, 0.62, 0.45)  # of the arrows
MAGENTA = vector(0.8, 0.1, 0.5)  # of the arrows of a hit
ORANGE = vector(0.9, 0.4, 0.0)  # of the rings
GREY = vector(0.5, 0.5, 0.53)  # of the dial
# A ghost is so far from its bob (in radii), and hidden by it if both are at the same angle: it is
# behind the bob in the direction in which the page looks (FORWARD in camera.js).
BEHIND = 2.2 * vector(0, -0.2, -1)


class Label(NamedTuple):
    """A text in the picture, its place (m), and its kind: camera.js has a style for each."""

    x: float
    y: float
    text: str
    kind: str


class Marks:
    """The marks of one cradle; the next cradle takes the same shapes."""

    def __init__(self) -> None:
        self.has_arrows = False
        self.measures = False  # whether the dial, the angles and the speeds are shown
        self.momenta: list[float] = []  # kg m/s: of the pendula, while there are arrows
        self.ghosts: list = []
        self.ghost_labels: list[Label] = []
        self.shapes: dict[str, list] = {}  # all that were made, by their name

    def surround(self, cradle: Cradle) -> None:
        """Take a new cradle."""
        self.cradle = cradle
        # The largest momentum (kg m/s): its bar has the full length.
        speeds = zip(cradle.pend_list, cradle.top_speeds(), strict=True)
        self.largest = sum(cradle.whole_mass(pend) * speed for pend, speed in speeds) or 1.0
        self.place_dial()

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

    # --- the motion --------------------------------------------------------------------------

    def show_arrows(self, pend_list: Sequence[Pendulum]) -> None:
        """Show the velocities of these pendula, and note their momenta; or hide all arrows."""
        if not self.has_arrows:
            self.take("arrows", 0, arrow)
            self.momenta = []
            return
        bobs = self.cradle.bobs()
        width = bobs[0].radius / 3
        arrows = self.take("arrows", len(bobs), arrow, color=GREEN, shaftwidth=width)
        motions = [motion for pend in pend_list for motion in bob_motions(pend, R_PARAM)]
        for pointer, bob, (_, vx, vy) in zip(arrows, bobs, motions, strict=True):
            moves = hypot(vx, vy) > STILL
            if pointer.visible != moves:
                pointer.visible = moves
            if moves:
                pointer.pos = bob.pos + vector(0, 0, bob.radius)
                pointer.axis = vector(ARROW_TIME * vx, ARROW_TIME * vy, 0)
        self.momenta = [momentum([pend], R_PARAM) for pend in pend_list]
        # A light bob that bounces back gives more than it had.
        self.largest = max(self.largest, *map(abs, self.momenta))

    def labels(self, pend_list: Sequence[Pendulum]) -> list[Label]:
        """Return the texts in the picture, for these pendula."""
        return [*self.mass_labels(), *self.measured_labels(pend_list), *self.ghost_labels]

    def mass_labels(self) -> list[Label]:
        """Return the masses (kg) on the bobs, if they differ."""
        masses = self.cradle.values("mass")
        lightest = min(masses)
        labels = []
        for pend in self.cradle.pend_list:
            for bob in pend["objects"][1::2]:
                kind = "heavy" if pend["mass"] > lightest else "light"
                labels.append(Label(bob.pos.x, bob.pos.y, f"{pend['mass']:g} kg", kind))
        return labels if max(masses) > lightest else []

    # --- a hit that is shown slowly ------------------------------------------------------------

    def show_hit(self, slow_hit: SlowHit | None) -> None:
        """Put rings around the pair of a hit, and show the changes of their momenta; or hide them.

        The page lets the arrows fade (light.js).
        """
        pair = (slow_hit.hit.left, slow_hit.hit.right) if slow_hit else ()
        bobs: list = []
        for number in pair:
            bobs += self.cradle.pend_list[number]["objects"][1::2]
        rings = self.take("rings", len(bobs), ring, color=ORANGE, axis=vector(0, 0, 1))
        for circle, bob in zip(rings, bobs, strict=True):
            circle.pos = bob.pos + vector(0, 0, bob.radius)
            circle.radius = 1.05 * bob.radius
            circle.thickness = 0.08 * bob.radius
        arrows = self.take("changes", len(pair), arrow, color=MAGENTA, pickable=False)
        if not slow_hit:
            return
        for pointer, number, old, new in zip(
            arrows, pair, slow_hit.hit.before, slow_hit.hit.after, strict=True
        ):
            bob = self.cradle.pend_list[number]["objects"][1]
            change = momentum([new], R_PARAM) - momentum([old], R_PARAM)
            pointer.pos = bob.pos + vector(0, 0, 1.2 * bob.radius)
            pointer.axis = vector(LONGEST * self.cradle.reach * change / self.largest, 0, 0)
            pointer.shaftwidth = bob.radius / 2

    # --- the answer ----------------------------------------------------------------------------

    def show_ghosts(self, thetas: Sequence[float], name: str) -> None:
        """Show a ghost of an upper bob and its cord at each of these angles (rad), or none.

        The one that is farthest out has this name. What cannot be picked is no bob for the page
        (canvas.js), and looks transparent (light.js).
        """
        ghosts = self.take("ghosts", len(thetas), sphere, shininess=0, pickable=False)
        threads = self.take("threads", len(thetas), cylinder, pickable=False)
        self.ghosts = ghosts
        farthest = max(thetas, key=abs, default=0.0)
        self.ghost_labels = []
        for i, theta in enumerate(thetas):
            axle, bob, cord = self.cradle.pend_list[i]["objects"][:3]
            axis = arm(theta, R_PARAM)
            behind = bob.radius * BEHIND
            ghosts[i].pos = axle.pos + axis + behind
            ghosts[i].radius = 0.97 * bob.radius  # hidden by the bob, where this is as predicted
            ghosts[i].color = bob.color
            threads[i].pos = axle.pos + behind
            threads[i].axis = axis
            threads[i].radius = 0.9 * cord.radius
            if theta == farthest and not self.ghost_labels:
                place = axle.pos + axis
                self.ghost_labels = [Label(place.x, place.y - 1.6 * bob.radius, name, "note")]

    # --- measurements --------------------------------------------------------------------------

    def place_dial(self) -> None:
        """Put marks, 10 degrees apart, behind the outer upper cords; or hide them."""
        marks = dial_marks() if self.measures else []
        axles = self.cradle.axles()
        lines = self.take("dial", len(marks), cylinder, color=GREY, radius=R_PARAM / 300)
        for line, theta in zip(lines, marks, strict=True):
            axle = axles[0] if theta < 0 else axles[-1]
            line.pos = axle.pos + arm(theta, DIAL * R_PARAM) - vector(0, 0, R_PARAM / 100)
            line.axis = arm(theta, MARK * R_PARAM)

    def measured_labels(self, pend_list: Sequence[Pendulum]) -> list[Label]:
        """Return the angle (degrees) and the speed (m/s) of each bob, and numbers on the dial."""
        if not self.measures:
            return []
        labels = []
        for pend in pend_list:
            bobs = pend["objects"][1::2]
            for bob, angle, (_, vx, vy) in zip(
                bobs, cord_angles(pend), bob_motions(pend, R_PARAM), strict=True
            ):
                text = f"{abs(degrees(angle)):.0f}°\n{hypot(vx, vy):.2f}"
                labels.append(Label(bob.pos.x, bob.pos.y - 1.9 * bob.radius, text, "light"))
        axles = self.cradle.axles()
        for axle, side in ((axles[0], -1), (axles[-1], 1)):
            for angle in (30, 60):
                place = axle.pos + arm(side * radians(angle), 0.68 * R_PARAM)
                labels.append(Label(place.x, place.y, f"{angle}°", "note"))
        return labels


def dial_marks() -> list[float]:
    """Return the angles (rad) of the marks of the dial."""
    return [radians(angle) for angle in range(-80, 81, 10)]
