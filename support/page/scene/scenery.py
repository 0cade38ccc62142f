"""The scenery around the pendula: light, frame and base; and what each tab's camera must show."""

from collections.abc import Sequence
from typing import NamedTuple

from vpython import box, cylinder, distant_light, scene, textures, vector

from support.cradle.dragging import FINGER
from support.pendulum import discard, make_shape

STEEL = vector(0.75, 0.76, 0.78)
TEXT = 1 / 30  # the height of the numbers above the axles, in heights of the canvas
LINE = 1.3  # from line to line, in heights of the text
CANVAS = 1.1  # about the height of the canvas, in heights of the frame


class Size(NamedTuple):
    """The size of a frame (m)."""

    left: float  # x of its ends
    right: float
    top: float  # y of the axles, and of the base
    bottom: float
    depth: float  # from rail to rail
    reach: float  # from an axle to the centre of the lowest bob at rest
    radius: float  # of the bobs


class Number(NamedTuple):
    """A text above an axle, and the axle's x (m)."""

    x: float
    text: str


class Scenery:
    """The light on VPython's canvas, and the frame around a cradle. Each tab has its own camera."""

    def __init__(self) -> None:
        """Set soft light and a distant camera."""
        scene.autoscale = False
        scene.fov = 0.25  # rad: a distant camera; a near one distorts shapes off the centre
        scene.lights = []
        scene.ambient = vector(0.45, 0.45, 0.45)
        distant_light(direction=vector(0.3, 0.6, 0.9), color=vector(0.5, 0.5, 0.5))
        distant_light(direction=vector(-0.6, 0.3, 0.4), color=vector(0.25, 0.25, 0.25))
        self.frame: list = []
        # In view, too.
        self.below = 0.0  # m, below the base
        self.lines = 0  # of text, above the cradle

    def surround(
        self, axles: Sequence, bobs: Sequence, reach: float, masses: Sequence[float]
    ) -> None:
        """Put a frame around these axles and bobs; masses (kg) are those of the pendula.

        reach (m) is from an axle to the centre of the lowest bob at rest.
        """
        self.numbers = number_axles(axles, masses)
        top = axles[0].pos.y
        self.size = Size(
            left=self.numbers[0].x - reach,
            right=self.numbers[-1].x + reach,
            top=top,
            bottom=top - 1.3 * reach,
            depth=axles[0].width,
            reach=reach,
            radius=bobs[0].radius,
        )
        discard(self.frame)
        self.frame = make_frame(self.size)
        self.whole_circles = False  # whether the view has space for bobs that swing above the frame

    @property
    def bottom(self) -> float:
        """The height of the base (m)."""
        return self.size.bottom

    def keep_in_view(self, bobs: Sequence) -> None:
        """Let the view have space for whole circles as soon as a bob swings above the frame."""
        if any(bob.pos.y > self.size.top for bob in bobs):
            self.whole_circles = True

    def view(self) -> dict:
        """Return what a tab must know: the points (m) that its camera shows, and the numbers.

        The points are those of the frame, of all swings, and of the text above the cradle.
        """
        left, right, top, bottom, depth, reach, radius = self.size
        # The base stands out a little.
        edge = depth / 2 + reach / 10
        ground = bottom - reach / 20 - self.below
        highest = top + radius  # of a swing up to the horizontal
        if self.whole_circles:
            highest += reach
        # The numbers, a gap, and the lines above them.
        lines = self.lines + 1.5
        if "\n" in self.numbers[0].text:
            lines += 1
        writing = radius / 2 + lines * LINE * TEXT * CANVAS * (top - ground)
        points = []
        for x in (left, right):
            for y in (top, ground):
                points += [(x, y, -edge), (x, y, edge)]
        for x in (left - radius, right + radius):
            points += [(x, top, 0), (x, highest, 0)]
        for x in (left + reach, right - reach):
            points.append((x, top + writing, 0))
        return {
            "points": points,
            "numbers": [number._asdict() for number in self.numbers],
            "top": top + radius / 2,
            "text_height": TEXT,
            "finger": FINGER,
        }


def number_axles(axles: Sequence, masses: Sequence[float]) -> list[Number]:
    """Return the axles' numbers, with the masses (kg) below them if these differ."""
    numbers = []
    for i, mass in enumerate(masses):
        text = str(i + 1)
        if len({*masses}) > 1:
            text += f"\n{mass:g}"
        numbers.append(Number(axles[i].pos.x, text))
    return numbers


def make_frame(size: Size) -> list:
    """Return two rails from left to right, four posts and the base."""
    left, right, top, bottom, depth, reach, _ = size
    thickness = reach / 50
    length = right - left
    frame = []
    for z in (-depth / 2, depth / 2):
        rail = vector(length + 2 * thickness, 0, 0)
        frame.append(make_bar(vector(left - thickness, top, z), rail, thickness))
        for x in (left, right):
            frame.append(make_bar(vector(x, bottom, z), vector(0, top - bottom, 0), thickness))
    base = make_shape(
        box,
        pos=vector((left + right) / 2, bottom, 0),
        size=vector(length + 10 * thickness, 5 * thickness, depth + 10 * thickness),
        texture=textures.wood,
    )
    return [*frame, base]


def make_bar(pos: vector, axis: vector, radius: float) -> cylinder:
    """Return a bar of steel."""
    return make_shape(cylinder, pos=pos, axis=axis, radius=radius, color=STEEL)
