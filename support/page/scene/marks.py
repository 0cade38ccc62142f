"""What the page draws to show why the cradle moves so: arrows, ghosts, rings, a dial, and texts."""

from collections.abc import Mapping, Sequence
from itertools import zip_longest
from math import degrees, hypot, pi, radians, sqrt
from typing import Any, NamedTuple

from vpython import arrow, color, cylinder, label, ring, sphere, vector

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
# Texts, in the colors of the page (style.css). yoffset 1 is above a place, -1 below it. The letters
# are as high as the page's, but no text is wider than its space (m), if it has one (marks.js):
# VPython itself uses space only for a line.
TEXT = {"background": color.white, "font": "sans-serif", "box": False, "line": False}
PALE = {**TEXT, "color": vector(0.34, 0.38, 0.42), "opacity": 0}
INK = {**TEXT, "color": vector(0.12, 0.14, 0.16), "opacity": 0.7}
APART = R_PARAM / 4  # of the axles
GHOST = 0.45  # of the color of its bob that a ghost has; the rest is white
# The direction from a bob to the camera (FORWARD in camera.js).
TO_CAMERA = vector(0, 0.2, 1)
# From a bob to its ghost, in radii: the bob hides the ghost if both are at the same angle.
BEHIND = -0.5 * TO_CAMERA


class GhostPoses(NamedTuple):
    """Where ghosts are: the angles (rad) of cords from straight down, by the pendulum's index."""

    poses: Mapping[int, Sequence[float]]
    name: str  # above them
    answer: int | None = None  # whose they are: marks.js shows those of yours


class Marks:
    """The marks of one cradle; the next cradle takes the same shapes."""

    def __init__(self) -> None:
        self.has_arrows = False
        self.measures = False  # whether the dial, angles, speeds and half swings are shown
        self.shapes: dict[str, list] = {}  # all that were made, by their name

    def surround(self, cradle: Cradle, digits: int) -> None:
        """Take a cradle: a new one, or one in which a bob was dragged.

        A speed has this number of digits behind the point.
        """
        self.cradle = cradle
        self.digits = digits
        numbers = []
        for number, axle in enumerate(cradle.axles(), start=1):
            numbers.append({"pos": axle.pos + vector(0, axle.height, 0), "text": str(number)})
        self.draw("numbers", label, numbers, **PALE, yoffset=1, space=APART)

    def draw(self, name: str, kind: type, shown: Sequence[Mapping], **attributes: Any) -> list:
        """Return the shapes with this name, each with what it shows; hide the others.

        attributes are for all of them, from the start. They never become parts of a cradle, and no
        part becomes one: in the browser, a shape stays pickable, or not.
        """
        shapes = self.shapes.setdefault(name, [])
        while len(shapes) < len(shown):
            shapes.append(kind(**attributes))
        for shape, values in zip_longest(shapes, shown, fillvalue={"visible": False}):
            for key, value in {"visible": True, **values}.items():
                if getattr(shape, key) != value:  # VPython would send it again
                    setattr(shape, key, value)
        return shapes[: len(shown)]

    def show(self, slow_hits: SlowHits, ghosts: Sequence[GhostPoses]) -> dict[int, int | None]:
        """Show all marks: as in the current slow hit, or as it is now.

        During a slow hit, there are no ghosts: they cover its arrows. Return what show_ghosts does.
        """
        pend_list = slow_hits.shown_pendula()
        self.show_dial()
        self.show_arrows(pend_list)
        self.show_belts()
        self.show_hit(slow_hits)
        self.write_below_bobs(pend_list)
        return self.show_ghosts([] if slow_hits.current else ghosts)

    # --- the motion --------------------------------------------------------------------------

    def show_arrows(self, pend_list: Sequence[Pendulum]) -> None:
        """Show the velocities of these pendula, or hide all arrows."""
        motions = [motion for pend in pend_list for motion in bob_motions(pend, R_PARAM)]
        arrows = []
        for bob, (_, vx, vy) in zip(self.cradle.bobs(), motions, strict=True):
            if self.has_arrows and hypot(vx, vy) > SLOWEST_WITH_ARROW:
                place = bob.pos + bob.radius * TO_CAMERA
                axis = ARROW_TIME * vector(vx, vy, 0)
                arrows.append({"pos": place, "axis": axis, "shaftwidth": bob.radius / 3})
        self.draw("arrows", arrow, arrows, color=GREEN)

    def show_belts(self) -> None:
        """Show a dark belt around each bob that is heavier than the lightest one.

        The width of a belt follows from the size of a ball with this mass. The bobs themselves keep
        the radius with which they collide.
        """
        masses = self.cradle.shown("mass")
        lightest = min((mass for mass in masses if mass), default=1.0)
        belts = []
        for pend, mass in zip(self.cradle.pend_list, masses, strict=True):
            width = min(WIDEST, ((mass or lightest) / lightest) ** (1 / 3) - 1)
            for bob in pend["objects"][1::2] if width > 0 else ():
                axis = vector(0, max(NARROWEST, width) * bob.radius, 0)
                place = bob.pos - axis / 2
                belts.append({"pos": place, "axis": axis, "radius": 1.02 * bob.radius})
        self.draw("belts", cylinder, belts, color=DARK)

    def write_below_bobs(self, pend_list: Sequence[Pendulum]) -> None:
        """Write the mass below each bob, if masses differ; and what is measured."""
        masses = self.cradle.shown("mass")
        has_masses = len({*masses}) > 1
        texts = []
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
                if lines:
                    below = bob.pos - vector(0, 1.15 * bob.radius, 0)
                    texts.append({"pos": below, "text": "\n".join(lines)})
        self.draw("below", label, texts, **INK, yoffset=-1, space=APART)

    # --- a hit that is shown slowly ------------------------------------------------------------

    def show_hit(self, slow_hits: SlowHits) -> None:
        """Put rings around the pair of a hit, and show how it changed momenta; or hide both."""
        rings = []
        arrows = []
        if slow_hits.current:
            hit = slow_hits.current.hit
            for number, old, new in zip((hit.left, hit.right), hit.before, hit.after, strict=True):
                bobs = self.cradle.pend_list[number]["objects"][1::2]
                radius = bobs[0].radius
                size = {"radius": 1.05 * radius, "thickness": 0.08 * radius}
                rings += [{"pos": bob.pos + radius * TO_CAMERA, **size} for bob in bobs]
                gain = momentum([new], R_PARAM) - momentum([old], R_PARAM)
                part = gain / slow_hits.motion.most_momentum
                place = bobs[0].pos + vector(0, ABOVE * radius, 0)
                axis = vector(LONGEST_ARROW * self.cradle.cords_length * part, 0, 0)
                arrows.append({"pos": place, "axis": axis, "shaftwidth": radius / 2})
        self.draw("rings", ring, rings, color=ORANGE, axis=vector(0, 0, 1))
        changes = [] if self.cradle.hidden else arrows
        self.draw("changes", arrow, changes, color=PINK, pickable=False)

    # --- ghosts: of each answer, or of a file ----------------------------------------------------

    def show_ghosts(self, all_poses: Sequence[GhostPoses]) -> dict[int, int | None]:
        """Show ghosts of bobs and cords, or none, and their names, one above all ghosts of it.

        They look transparent. VPython's own transparency would distort the whole picture: it draws
        it in 640 x 400 pixels, and stretches it. Nobody can pick a ghost. So it is no bob for the
        page. Return whose they are: the answer, by VPython's number of each shape.
        """
        bobs: list[dict[str, Any]] = []
        threads = []
        names = []
        for poses, name, answer in all_poses:
            places = []
            for index, angles in poses.items():
                axle, *parts = self.cradle.pend_list[index]["objects"]
                end = axle.pos + parts[0].radius * BEHIND
                for angle, bob, cord in zip(angles, parts[::2], parts[1::2], strict=False):
                    axis = arm(angle, R_PARAM)
                    threads.append(
                        {
                            "pos": end,
                            "axis": axis,
                            "radius": 0.9 * cord.radius,
                            "color": pale(cord.color),
                            "answer": answer,
                        }
                    )
                    end = end + axis
                    places.append(end)
                    # A bob hides its ghost, where both are in one place
                    bobs.append(
                        {
                            "pos": end,
                            "radius": 0.97 * bob.radius,
                            "color": pale(bob.color),
                            "answer": answer,
                        }
                    )
            if places:
                x = sum(place.x for place in places) / len(places)
                y = max(place.y for place in places) + self.cradle.bobs()[0].radius
                names.append({"pos": vector(x, y, 0), "text": name, "answer": answer})
        shapes = [
            *self.draw("ghosts", sphere, bobs, answer=None, shininess=0, pickable=False),
            *self.draw("threads", cylinder, threads, answer=None, pickable=False),
            *self.draw("names", label, names, answer=None, **INK, yoffset=1),
        ]
        return {shape.idx: shape.answer for shape in shapes}

    # --- measurements --------------------------------------------------------------------------

    def show_dial(self) -> None:
        """Put marks, 10 degrees apart, behind the outer upper cords, with numbers; or hide them."""
        axles = self.cradle.axles()
        marks = []
        numbers = []
        for angle in range(-80, 81, 10) if self.measures else ():
            theta = radians(angle)
            axle = axles[0] if theta < 0 else axles[-1]
            place = axle.pos + arm(theta, DIAL * R_PARAM) - vector(0, 0, R_PARAM / 100)
            marks.append({"pos": place, "axis": arm(theta, MARK * R_PARAM)})
            if abs(angle) in (30, 60):
                place = axle.pos + arm(theta, 0.68 * R_PARAM)
                numbers.append({"pos": place, "text": f"{abs(angle)}°"})
        self.draw("dial", cylinder, marks, color=GREY, radius=R_PARAM / 300)
        self.draw("degrees", label, numbers, **PALE)


def pale(shade: vector) -> vector:
    """Return the color of the ghost of a part with this color."""
    return GHOST * shade + (1 - GHOST) * color.white
