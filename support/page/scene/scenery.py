"""The scenery around the pendula: light, frame, base, and the points that each tab's camera must
show (canvas.js).
"""

from vpython import box, cylinder, distant_light, scene, textures, vector

from support.pendulum import discard, make_shape

STEEL = vector(0.75, 0.76, 0.78)
TEXT = 1 / 30  # height of the numbers, in heights of the canvas; canvas.js knows it, too


class Scenery:
    """The light on VPython's canvas, and the frame around a cradle. Each tab has its own camera."""

    def __init__(self):
        """Set soft light and a distant camera."""
        scene.autoscale = False
        scene.fov = 0.25  # rad: a distant camera; a near one distorts shapes off the centre
        scene.lights = []
        scene.ambient = vector(0.45, 0.45, 0.45)
        distant_light(direction=vector(0.3, 0.6, 0.9), color=vector(0.5, 0.5, 0.5))
        distant_light(direction=vector(-0.6, 0.3, 0.4), color=vector(0.25, 0.25, 0.25))
        self.frame: list = []
        # In view, too: m below the base, and lines of text above the cradle
        self.below = 0.0
        self.lines = 0

    def surround(self, axles, bobs, reach, masses) -> None:
        """Put a frame around these axles and bobs; reach (m): from an axle to the centre of the
        lowest bob at rest.
        """
        # The axles carry their numbers, and the masses (kg) if these differ; each text has the x
        # (m) of its axle.
        shown = [f"\n{mass:g}" if len({*masses}) > 1 else "" for mass in masses]
        self.numbers = [(axles[i].pos.x, f"{i + 1}{mass}") for i, mass in enumerate(shown)]
        # M: of the axles, and of the base
        self.top = axles[0].pos.y
        self.bottom = axles[0].pos.y - 1.3 * reach
        # m: the left and the right end of the frame, the depth from rail to rail, the reach, the
        # radius of the bobs.
        self.size = (
            axles[0].pos.x - reach,
            axles[-1].pos.x + reach,
            axles[0].width,
            reach,
            bobs[0].radius,
        )
        discard(self.frame)
        self.frame = make_frame(self.size, self.top, self.bottom)
        self.whole_circles = False  # whether the view has space for bobs that swing above the frame

    def keep_in_view(self, bobs) -> None:
        """Let the view have space for whole circles as soon as a bob swings above the frame."""
        self.whole_circles = self.whole_circles or any(bob.pos.y > self.top for bob in bobs)

    def view(self) -> dict:
        """Return what each tab's camera must show: points (m) of the frame and all swings, and the
        axles' numbers.
        """
        (left, right, depth, reach, radius), top, bottom = self.size, self.top, self.bottom
        lines = 1.5 + any("\n" in text for _, text in self.numbers) + self.lines  # with a gap
        highest = top + radius + reach * self.whole_circles  # else of a swing up to the horizontal
        # The base stands out a little
        edge = depth / 2 + reach / 10
        ground = bottom - reach / 20 - self.below
        corners = [(x, y, z) for x in (left, right) for y in (top, ground) for z in (-edge, edge)]
        swings = [(x, y, 0) for x in (left - radius, right + radius) for y in (top, highest)]
        # The canvas is about 1.1 times as high as the frame.
        writing = radius / 2 + lines * 1.3 * TEXT * 1.1 * (top - ground)
        texts = [(x, top + writing, 0) for x in (left + reach, right - reach)]
        return {
            "points": corners + swings + texts,
            "numbers": self.numbers,
            "top": top + radius / 2,
        }


def make_frame(size, top, bottom) -> list:
    """Return two rails from left to right, four posts and the base."""
    left, right, depth, reach, _ = size
    thickness = reach / 50
    bars = []  # each a place and an axis
    for z in (-depth / 2, depth / 2):
        bars.append((vector(left - thickness, top, z), vector(right - left + 2 * thickness, 0, 0)))
        bars += [(vector(x, bottom, z), vector(0, top - bottom, 0)) for x in (left, right)]
    frame = [
        make_shape(cylinder, pos=pos, axis=axis, radius=thickness, color=STEEL)
        for pos, axis in bars
    ]
    extent = vector(right - left + 10 * thickness, 5 * thickness, depth + 10 * thickness)
    base = make_shape(
        box, pos=vector((left + right) / 2, bottom, 0), size=extent, texture=textures.wood
    )
    return [*frame, base]
