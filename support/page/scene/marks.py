"""What the page draws to show why the cradle moves so: arrows, ghosts, rings, a dial, and texts."""

from collections.abc import Iterator, Mapping, Sequence
from math import degrees, hypot, pi, radians, sqrt
from typing import Any, NamedTuple

from vpython import arrow, cylinder, ring, sphere, vector

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.energy import bob_motions, momentum
from support.page.scene.slow_hits import SlowHits
from support.pendulum import arm, cord_angles, Pendulum

# s: an arrow is as long as its bob's way in a twentieth of a small swing.
ARROW_TIME = 2 * pi * sqrt(R_PARAM / G) / 20
# m/s: a slower bob has no arrow. A bob that comes down from 2 degrees gets as fast.
SLOWEST_WITH_ARROW = 0.035 * sqrt(R_PARAM * G)
# In lengths of the cords: an arrow of the largest momentum. A change can be twice as large.
LONGEST_ARROW = 0.4
ABOVE = 1.7  # the height of these arrows above their bobs, in radii
# The height of a belt, in radii: the least and the largest one.
NARROWEST = 0.2
WIDEST = 1.2
# The dial: where its marks begin, and their length, in lengths of a cord.
DIAL = 0.76
MARK = 0.08

GREEN = vector(0.0, 0.62, 0.45)  # of the arrows
PINK = vector(0.8, 0.1, 0.5)  # of the arrows of a hit
ORANGE = vector(0.9, 0.4, 0.0)  # of the rings
GREY = vector(0.5, 0.5, 0.53)  # of the dial
DARK = vector(0.15, 0.15, 0.17)  # of the belts
# The direction from a bob to the camera (FORWARD in camera.js).
TO_CAMERA = vector(0, 0.2, 1)
# From a bob to its ghost, in radii: the bob hides the ghost if both are at the same angle.
BEHIND = -0.5 * TO_CAMERA


class Label(NamedTuple):
    """A text in the picture, its place (m), and its kind: camera.js has a style for each."""

    x: float
    y: float
    text: str
    kind: str
    answer: int | None = None  # of its ghosts, if it is their name


class GhostPoses(NamedTuple):
    """Where ghosts are: the angles (rad) of cords from straight down, by the pendulum's index."""

    poses: Mapping[int, Sequence[float]]
    name: str  # above them
    answer: int | None = None  # whose they are: ghosts.js shows those of yours


class Marks:
    """The marks of one cradle; the next cradle takes the same shapes."""

    def __init__(self) -> None:
        self.has_arrows = False
        self.measures = False  # whether the dial, the angles and the speeds are shown
        self.answers: list[int | None] = []  # of the ghosts: their answers
        self.shapes: dict[str, list] = {}  # all that were made, by their name

    def surround(self, cradle: Cradle, digits: int) -> None:
        """Take a cradle: a new one, or one in which a bob was dragged.

        A speed has this number of digits behind the point.
        """
        self.cradle = cradle
        self.digits = digits
        self.place_dial()

    def take(self, name: str, count: int, kind: type, **attributes: Any) -> list:
        """Return the first shapes with this name; make those that are missing, and hide the rest.

        They never become parts of a cradle, and no part becomes one: in the browser, a shape stays
        pickable, or not. ghosts.js knows ghosts by the order in which they were made.
        """
        shapes = self.shapes.setdefault(name, [])
        while len(shapes) < count:
            shapes.append(kind(**attributes))
        for number, shape in enumerate(shapes):
            is_needed = number < count
            if shape.visible != is_needed:  # VPython would send it again
                shape.visible = is_needed
        return shapes[:count]

    def switch_arrows(self, is_shown: bool) -> None:
        """Show the velocities as arrows, or not."""
        self.has_arrows = is_shown

    def switch_measures(self, is_shown: bool) -> None:
        """Show the dial, angles, speeds and the half swings, or not."""
        self.measures = is_shown
        self.place_dial()

    def show(self, slow_hits: SlowHits, ghosts: Sequence[GhostPoses]) -> list[Label]:
        """Show all marks: as in the current slow hit, or as it is now. Return the texts.

        During a slow hit, there are no ghosts: they cover its arrows.
        """
        pend_list = slow_hits.shown_pendula()
        self.show_arrows(pend_list)
        self.show_belts()
        self.show_hit(slow_hits)
        names = self.show_ghosts([] if slow_hits.waits() else ghosts)
        return [*self.bob_labels(pend_list), *self.dial_labels(), *names]

    # --- the motion --------------------------------------------------------------------------

    def show_arrows(self, pend_list: Sequence[Pendulum]) -> None:
        """Show the velocities of these pendula, or hide all arrows."""
        if not self.has_arrows:
            self.take("arrows", 0, arrow)
            return
        motions = [motion for pend in pend_list for motion in bob_motions(pend, R_PARAM)]
        moving = []  # the bobs that move, and their velocities (m/s)
        for bob, (_, vx, vy) in zip(self.cradle.bobs(), motions, strict=True):
            if hypot(vx, vy) > SLOWEST_WITH_ARROW:
                moving.append((bob, vector(vx, vy, 0)))
        arrows = self.take("arrows", len(moving), arrow, color=GREEN)
        for pointer, (bob, velocity) in zip(arrows, moving, strict=True):
            pointer.pos = bob.pos + bob.radius * TO_CAMERA
            pointer.axis = ARROW_TIME * velocity
            pointer.shaftwidth = bob.radius / 3

    def show_belts(self) -> None:
        """Show a dark belt around each bob that is heavier than the lightest one.

        The width of a belt follows from the size of a ball with this mass. The bobs themselves keep
        the radius with which they collide.
        """
        masses = self.cradle.shown("mass")
        lightest = min((mass for mass in masses if mass), default=1.0)
        belted = []
        for pend, mass in zip(self.cradle.pend_list, masses, strict=True):
            width = min(WIDEST, ((mass or lightest) / lightest) ** (1 / 3) - 1)
            if width > 0:
                belted += [(bob, width) for bob in pend["objects"][1::2]]
        belts = self.take("belts", len(belted), cylinder, color=DARK)
        for belt, (bob, width) in zip(belts, belted, strict=True):
            height = max(NARROWEST, width) * bob.radius
            belt.pos = bob.pos - vector(0, height / 2, 0)
            belt.axis = vector(0, height, 0)
            belt.radius = 1.02 * bob.radius

    def bob_labels(self, pend_list: Sequence[Pendulum]) -> list[Label]:
        """Return texts below the bobs: the mass, if masses differ; and what is measured."""
        masses = self.cradle.shown("mass")
        has_masses = len({*masses}) > 1
        labels = []
        for pend, mass in zip(pend_list, masses, strict=True):
            motions = bob_motions(pend, R_PARAM)
            bobs = pend["objects"][1::2]
            for bob, angle, (_, vx, vy) in zip(bobs, cord_angles(pend), motions, strict=True):
                lines = []
                if has_masses:
                    lines.append("? kg" if mass is None else f"{mass:g} kg")
                if self.measures:  # bobs are near each other: the unit has its own line
                    lines += [
                        f"{abs(degrees(angle)):.0f}°",
                        f"{hypot(vx, vy):.{self.digits}f}",
                        "m/s",
                    ]
                below = bob.pos.y - 1.15 * bob.radius
                if lines:
                    labels.append(Label(bob.pos.x, below, "\n".join(lines), "bob"))
        return labels

    # --- a hit that is shown slowly ------------------------------------------------------------

    def show_hit(self, slow_hits: SlowHits) -> None:
        """Put rings around the pair of a hit, and show how it changed momenta; or hide both."""
        slow_hit = slow_hits.current
        pair = (slow_hit.hit.left, slow_hit.hit.right) if slow_hit else ()
        bobs: list = []
        for number in pair:
            bobs += self.cradle.pend_list[number]["objects"][1::2]
        rings = self.take("rings", len(bobs), ring, color=ORANGE, axis=vector(0, 0, 1))
        for circle, bob in zip(rings, bobs, strict=True):
            circle.pos = bob.pos + bob.radius * TO_CAMERA
            circle.radius = 1.05 * bob.radius
            circle.thickness = 0.08 * bob.radius
        count = len(pair) if self.cradle.shows("momentum") else 0
        arrows = self.take("changes", count, arrow, color=PINK, pickable=False)
        if not slow_hit or not arrows:
            return
        for pointer, number, old, new in zip(
            arrows, pair, slow_hit.hit.before, slow_hit.hit.after, strict=True
        ):
            bob = self.cradle.pend_list[number]["objects"][1]
            change = momentum([new], R_PARAM) - momentum([old], R_PARAM)
            pointer.pos = bob.pos + vector(0, ABOVE * bob.radius, 0)
            part = change / slow_hits.motion.most_momentum
            pointer.axis = vector(LONGEST_ARROW * self.cradle.cords_length * part, 0, 0)
            pointer.shaftwidth = bob.radius / 2

    # --- ghosts: of each answer, or of a file ----------------------------------------------------

    def show_ghosts(self, all_poses: Sequence[GhostPoses]) -> list[Label]:
        """Show ghosts of bobs and cords, or none; return their names, one above all ghosts of it.

        Nobody can pick a ghost. So it is no bob for the page. ghosts.js makes it pale, and hides
        those of other answers.
        """
        self.answers = []
        for ghosts in all_poses:
            self.answers += [ghosts.answer] * sum(map(len, ghosts.poses.values()))
        count = len(self.answers)
        bobs = self.take("ghosts", count, sphere, shininess=0, pickable=False)
        threads = self.take("threads", count, cylinder, pickable=False)
        shapes = zip(bobs, threads, strict=True)
        names = []
        for ghosts in all_poses:
            places = self.place_ghosts(ghosts, shapes)
            if places:
                x = sum(place.x for place in places) / len(places)
                y = max(place.y for place in places) + self.cradle.bobs()[0].radius
                names.append(Label(x, y, ghosts.name, "name", ghosts.answer))
        return names

    def place_ghosts(self, ghosts: GhostPoses, shapes: Iterator) -> list[vector]:
        """Place the next of these pairs, a ghost and its thread; return the places of ghosts."""
        places = []
        for index, angles in ghosts.poses.items():
            axle, *parts = self.cradle.pend_list[index]["objects"]
            end = axle.pos + parts[0].radius * BEHIND
            for angle, bob, cord in zip(angles, parts[::2], parts[1::2], strict=False):
                ghost, thread = next(shapes)
                axis = arm(angle, R_PARAM)
                thread.pos = end
                thread.axis = axis
                thread.radius = 0.9 * cord.radius
                thread.color = cord.color
                end = end + axis
                ghost.pos = end
                ghost.radius = 0.97 * bob.radius  # hidden by the bob, where both are in one place
                ghost.color = bob.color
                places.append(end)
        return places

    # --- measurements --------------------------------------------------------------------------

    def place_dial(self) -> None:
        """Put marks, 10 degrees apart, behind the outer upper cords; or hide them."""
        marks = [radians(angle) for angle in range(-80, 81, 10)] if self.measures else []
        axles = self.cradle.axles()
        lines = self.take("dial", len(marks), cylinder, color=GREY, radius=R_PARAM / 300)
        for line, theta in zip(lines, marks, strict=True):
            axle = axles[0] if theta < 0 else axles[-1]
            line.pos = axle.pos + arm(theta, DIAL * R_PARAM) - vector(0, 0, R_PARAM / 100)
            line.axis = arm(theta, MARK * R_PARAM)

    def dial_labels(self) -> list[Label]:
        """Return the numbers (degrees) on the dial."""
        if not self.measures:
            return []
        labels = []
        axles = self.cradle.axles()
        for axle, side in ((axles[0], -1), (axles[-1], 1)):
            for angle in (30, 60):
                place = axle.pos + arm(side * radians(angle), 0.68 * R_PARAM)
                labels.append(Label(place.x, place.y, f"{angle}°", "dial"))
        return labels
