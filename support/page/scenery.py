"""The scenery around the pendula: frame, base, light, and a camera that shows the whole swing."""

from math import inf, tan
from typing import NamedTuple

from vpython import box, cross, cylinder, distant_light, dot, label, mag, norm, scene, textures, vector

from support.pendulum import discard, make_shape

STEEL = vector(0.75, 0.76, 0.78)
BACKGROUND = vector(241, 242, 244) / 255  # the same as in panel.css, so that the canvas has no visible edge
FORWARD = vector(-0.25, -0.18, -1)  # the camera looks a little from the left and from above
NEAREST, FARTHEST = 0.1, 3.0  # of the range with which the whole cradle fills the canvas
MOVED = 1e-3  # the least part of the range, or turn (rad), by which a camera has moved
MARGIN = 1.04  # the view is larger than the cradle by this factor
INK = vector(0.5, 0.5, 0.53)  # of the numbers on the axles, on a pale and on a dark page
TEXT = 1 / 30  # height of the numbers, in heights of the canvas
SMALLEST = 12  # pixels
LETTER = 0.55  # width of a letter, in heights of the text


class Space(NamedTuple):
    """The space that a cradle needs, all in m."""

    left: float  # the first axle
    right: float  # the last axle
    top: float  # the axles
    depth: float  # from rail to rail
    reach: float  # from an axle to the centre of the lowest bob at rest
    radius: float  # of the bobs
    lines: int  # of text above the axles


class Scenery:
    """The canvas with its light, the frame around a cradle, and the camera's view of it."""

    def __init__(self):
        """Set soft light and a distant camera; panel.js sets the size of the canvas, and its color on a dark page."""
        scene.background = BACKGROUND
        scene.forward = FORWARD
        scene.fov = 0.25  # rad: a distant camera; a near one distorts shapes off the centre
        scene.lights = []
        scene.ambient = vector(0.45, 0.45, 0.45)
        distant_light(direction=vector(0.3, 0.6, 0.9), color=vector(0.5, 0.5, 0.5))
        distant_light(direction=vector(-0.6, 0.3, 0.4), color=vector(0.25, 0.25, 0.25))
        self.frame: list = []
        self.space = Space(0, 0, 0, 0, 0, 0, 0)
        self.whole_circles = False  # whether the view has space for bobs that swing above the frame
        self.below, self.lines = 0.0, 0  # in view, too: m below the base, and lines of text above the cradle
        self.home = scene.center, scene.range  # of the camera that shows the whole cradle
        self.axles: list = []
        self.masses: list[float] = []  # kg; empty if all are equal
        self.labels: list = []  # VPython keeps every label for ever, so a new cradle takes those of the old one

    def surround(self, axles, bobs, reach, masses) -> None:
        """Put a frame around the cradle with these axles and bobs, from left to right, and point the camera at it.

        The axles carry their numbers, and the masses (kg) if these differ; reach (m) is that of a Space. If the new
        cradle needs the same space, the camera stays as you turned it, but comes as near as before keep_in_view.
        """
        self.axles, self.masses = axles, masses if len({*masses}) > 1 else []
        first, last = axles[0], axles[-1]
        space = Space(first.pos.x, last.pos.x, first.pos.y, first.width, reach, bobs[0].radius, 2 if self.masses else 1)
        if space != self.space:
            discard(self.frame)
            self.frame = make_frame(space)
        elif not self.whole_circles:
            self.number_axles()
            return
        self.space, self.whole_circles = space, False
        self.point_camera()

    def keep_in_view(self, bobs) -> None:
        """Move the camera back as soon as a bob swings above the frame."""
        if not self.whole_circles and any(bob.pos.y > self.space.top for bob in bobs):
            self.whole_circles = True
            self.point_camera()

    def point_camera(self) -> None:
        """Point the camera at the frame and at all swings up to the horizontal, or at whole circles."""
        space = self.space
        swing = space.reach + space.radius
        left, right, bottom = frame_corners(space)
        top = space.top + (swing if self.whole_circles else space.radius)
        depth, ground = space.depth / 2 + space.reach / 10, bottom - space.reach / 20  # the base stands out a little
        ground -= self.below
        corners = [vector(x, y, z) for x in (left, right) for y in (space.top, ground) for z in (-depth, depth)]
        swings = [vector(x, y, 0) for x in (space.left - swing, space.right + swing) for y in (space.top, top)]
        # The canvas is about 1.1 times as high as the frame.
        writing = space.radius / 2 + (space.lines + self.lines + 0.5) * 1.3 * TEXT * 1.1 * (space.top - ground)
        texts = [vector(x, space.top + writing, 0) for x in (space.left, space.right)]
        view(corners + swings + texts)
        self.home = scene.center, scene.range
        self.number_axles()

    def bottom(self) -> float:
        """Return the height of the base (m)."""
        return frame_corners(self.space)[2]

    def leave_space(self, below, lines) -> None:
        """Leave space for this much (m) below the base, and for these lines of text above the cradle."""
        self.below, self.lines = below, lines
        self.point_camera()

    def reset_view(self) -> None:
        """Point the camera at the cradle as at the start."""
        scene.forward, scene.up = FORWARD, vector(0, 1, 0)
        self.point_camera()

    def bring_camera_back(self) -> bool:
        """Return whether you have moved the camera; bring it back if nothing of the cradle is seen."""
        center, distance = self.home
        if not NEAREST * distance <= scene.range <= FARTHEST * distance:
            scene.range = min(max(scene.range, NEAREST * distance), FARTHEST * distance)
        if mag(scene.center - center) > 1.001 * distance:
            scene.center = center + norm(scene.center - center) * distance
        turned = mag(norm(scene.forward) - norm(FORWARD)) > MOVED
        return turned or max(abs(scene.range - distance), mag(scene.center - center)) > MOVED * distance

    def number_axles(self) -> None:
        """Write the numbers of the pendula, and their masses if these differ, above as many axles as they fit."""
        texts = [[str(number)] for number in range(1, len(self.axles) + 1)]
        for text, mass in zip(texts, self.masses, strict=False):
            text.append(f"{mass:g}")
        height = max(SMALLEST, TEXT * scene.height)
        widest = LETTER * height * (0.4 + max(len(line) for text in texts for line in text))  # pixels, with a gap
        apart = (self.space.right - self.space.left) / max(1, len(texts) - 1)
        widest *= 2 * scene.range / min(scene.width, scene.height)  # m
        step = next((step for step in (1, 5, 10, 50) if step * apart >= widest), inf)
        shown = [(self.axles[i].pos, text) for i, text in enumerate(texts) if i == 0 or (i + 1) % step == 0]
        if self.masses:
            shown.append((self.axles[0].pos - vector(max(widest, apart), 0, 0), [" ", "kg"]))
        while len(self.labels) < len(shown):
            self.labels.append(label(box=False, line=False, opacity=0, color=INK, yoffset=1))
        for mark, (place, text) in zip(self.labels, shown, strict=False):
            mark.pos, mark.text = place + vector(0, self.space.radius / 2, 0), "\n".join(text)
            mark.height, mark.visible = height, True
        for mark in self.labels[len(shown) :]:
            mark.visible = False


def view(points) -> None:
    """Point the camera at the middle of these points, just far enough away to show them all in the canvas.

    The shorter side of the canvas shows 2 scene.range (m) of the plane through the centre. The camera is at the
    distance d = range / tan(fov / 2). A point at the distance x from the axis of view, and z nearer to the camera than
    the centre, appears in that plane at x d / (d - z). So range * side / shorter side must be at least x d / (d - z).
    """
    forward = norm(scene.forward)
    sideways = norm(cross(forward, scene.up))
    upwards = cross(sideways, forward)
    center = vector(0, 0, 0)
    for direction in (forward, sideways, upwards):
        places = [dot(point, direction) for point in points]
        center += direction * (min(places) + max(places)) / 2
    shorter = min(scene.width, scene.height)
    scene.center = center  # only once, because each assignment is sent to the page
    scene.range = MARGIN * max(
        abs(dot(arm, direction)) * shorter / side - dot(arm, forward) * tan(scene.fov / 2)
        for arm in [point - center for point in points]
        for direction, side in ((sideways, scene.width), (upwards, scene.height))
    )


def frame_corners(space) -> tuple[float, float, float]:
    """Return the left and the right end of the frame, and its bottom (m)."""
    return space.left - space.reach, space.right + space.reach, space.top - 1.3 * space.reach


def make_frame(space) -> list:
    """Return two rails from left to right, four posts and the base."""
    left, right, bottom = frame_corners(space)
    thickness = space.reach / 50
    bars = []  # each a place and an axis
    for z in (-space.depth / 2, space.depth / 2):
        bars.append((vector(left - thickness, space.top, z), vector(right - left + 2 * thickness, 0, 0)))
        bars += [(vector(x, bottom, z), vector(0, space.top - bottom, 0)) for x in (left, right)]
    frame = [make_shape(cylinder, pos=pos, axis=axis, radius=thickness, color=STEEL) for pos, axis in bars]
    size = vector(right - left + 10 * thickness, 5 * thickness, space.depth + 10 * thickness)
    base = make_shape(box, pos=vector((left + right) / 2, bottom, 0), size=size, texture=textures.wood)
    return [*frame, base]
