"""The scenery around the pendula: light, frame and base; and what each tab's camera must show."""

from collections.abc import Sequence
from math import ceil
from typing import NamedTuple

from vpython import box, color, cylinder, distant_light, scene, textures, vector

from support.cradle.dragging import FINGER
from support.pendulum import discard, make_shape

STEEL = vector(0.75, 0.76, 0.78)
TO_POSTS = 0.86  # from the outer axles, in lengths of the cords: a bob at 45 degrees is inside
OVERHANG = 0.06  # of the base beyond the posts, in lengths of the cords
TEXT = 1 / 30  # the height of the numbers above the axles, in heights of the canvas
LINE_HEIGHT = 1.3  # from line to line, in heights of the text
HIT_LINES = 6  # of text about a slow hit, above the cradle
CANVAS = 1.1  # about the height of the canvas, in heights of the frame


class Size(NamedTuple):
    """The size of a frame (m)."""

    left: float  # x of its ends
    right: float
    top: float  # y of the axles, and of the base
    bottom: float
    depth: float  # from rail to rail
    cords_length: float  # from an axle to the centre of the lowest bob at rest
    radius: float  # of the bobs


class Number(NamedTuple):
    """A text above an axle, and the axle's x (m)."""

    x: float
    text: str


class Scenery:
    """The light on VPython's canvas, and the frame around a cradle. Each tab has its own camera."""

    def __init__(self) -> None:
        """Set the lights, and a distant camera.

        On a pale page, the edges of bobs must be dark, and their middle bright.
        """
        scene.autoscale = False
        scene.fov = 0.25  # rad: a distant camera; a near one distorts shapes off the centre
        scene.ambient = color.gray(0.26)
        scene.lights = []
        distant_light(direction=vector(0.2, 0.4, 1), color=color.gray(0.9))
        distant_light(direction=vector(-0.6, 0.3, 0.4), color=color.gray(0.2))
        self.frame: list = []

    def surround(
        self, axles: Sequence, bobs: Sequence, cords_length: float, masses: Sequence[float]
    ) -> None:
        """Put a frame around these axles and bobs; masses (kg) are those of the pendula.

        cords_length (m) is from an axle to the centre of the lowest bob at rest.
        """
        self.numbers = [Number(axle.pos.x, str(i)) for i, axle in enumerate(axles, start=1)]
        top = axles[0].pos.y
        to_posts = TO_POSTS * cords_length
        self.size = Size(
            left=self.numbers[0].x - to_posts,
            right=self.numbers[-1].x + to_posts,
            top=top,
            bottom=top - 1.3 * cords_length,
            depth=axles[0].width,
            cords_length=cords_length,
            radius=bobs[0].radius,
        )
        discard(self.frame)
        self.frame = make_frame(self.size)
        # Whether the view has space for bobs that swing out of the frame. Bobs with unequal masses
        # probably will.
        self.wide_swings = len({*masses}) > 1
        self.above = 0.0  # m above the axles: the view has space for bobs up to there

    def keep_in_view(self, bobs: Sequence) -> None:
        """Let the view have space for these bobs, or ghosts, also outside of the frame."""
        for bob in bobs:
            if not self.size.left < bob.pos.x < self.size.right:
                self.wide_swings = True
            height = bob.pos.y - self.size.top
            if height > self.above:
                self.wide_swings = True
                quarter = self.size.cords_length / 4  # not in each picture a little
                self.above = quarter * ceil(height / quarter)

    def view(self, has_text_above: bool) -> dict:
        """Return what a tab must know: the points (m) that its camera shows, and the numbers.

        The points are those of the frame, of all swings, and of the text above the cradle, if there
        is some.
        """
        lines = HIT_LINES if has_text_above else 0
        left, right, top, bottom, depth, cords_length, radius = self.size
        ground = bottom - base_height(cords_length) / 2
        # The numbers, a gap, and the lines above them.
        writing = radius / 2 + (lines + 1.5) * LINE_HEIGHT * TEXT * CANVAS * (top - ground)
        points: list[tuple[float, float, float]]
        points = [(self.numbers[0].x, top + writing, 0), (self.numbers[-1].x, top + writing, 0)]
        for x in (left - OVERHANG * cords_length, right + OVERHANG * cords_length):
            for y in (top, ground):
                for side in (-1, 1):
                    points.append((x, y, side * (depth / 2 + OVERHANG * cords_length)))
        if self.wide_swings:
            widest = cords_length + radius
            room = 4 if self.above else 2  # radii: for a bob, and the name of a ghost
            highest = top + self.above + room * radius
            points.append((self.numbers[0].x - widest, highest, 0))
            points.append((self.numbers[-1].x + widest, highest, 0))
        return {
            "points": points,
            "numbers": [number._asdict() for number in self.numbers],
            "top": top + radius / 2,
            "base": {
                "left": left,
                "right": right,
                "height": bottom + base_height(cords_length) / 2,
            },
            "text_height": TEXT,
            "finger": FINGER,
        }


def base_height(cords_length: float) -> float:
    """Return the height (m) of the base of a cradle with cords of this length (m)."""
    return 0.1 * cords_length


def make_frame(size: Size) -> list:
    """Return two rails from left to right, four posts and the base."""
    left, right, top, bottom, depth, cords_length, _ = size
    thickness = cords_length / 50
    length = right - left
    overhang = 2 * OVERHANG * cords_length
    frame = []
    for z in (-depth / 2, depth / 2):
        rail = vector(length + 2 * thickness, 0, 0)
        frame.append(make_bar(vector(left - thickness, top, z), rail, thickness))
        for x in (left, right):
            frame.append(make_bar(vector(x, bottom, z), vector(0, top - bottom, 0), thickness))
    base = make_shape(
        box,
        pos=vector((left + right) / 2, bottom, 0),
        size=vector(length + overhang, base_height(cords_length), depth + overhang),
        texture=textures.wood,
    )
    return [*frame, base]


def make_bar(pos: vector, axis: vector, radius: float) -> cylinder:
    """Return a bar of steel."""
    return make_shape(cylinder, pos=pos, axis=axis, radius=radius, color=STEEL)
