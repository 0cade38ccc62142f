"""The scenery around the pendula: light, stand and base; and what each tab's camera must show."""

from collections.abc import Iterable, Sequence
from itertools import product
from math import ceil, pi

from vpython import box, color, cylinder, distant_light, scene, simple_sphere, textures, vector

from support.cradle.dragging import FINGER
from support.page.scene.marks import TO_CAMERA
from support.pendulum import arm, discard, make_shape

# Images in web/
# What a rod reflects, around it: the sky, the horizon, the ground.
CHROME = {"texture": ":chrome.jpg", "shininess": 0}
# White, with the shadow of the base in its middle; on the upper side alone.
GROUND = {"file": ":ground.jpg", "place": "right"}
DARK = vector(0.8, 0.62, 0.55)  # of the wood
WHITE = vector(3, 3, 3)  # the other sides, in any light
FLAT = 1e-4  # m: the height of the ground, and of the board upon the base
# In lengths of the cords
TO_POSTS = 0.86  # from the outer axles: a bob at 45 degrees is inside
TO_BASE = 1.25  # from the axles down to the base
BASE = 0.1  # the height of the base
OVERHANG = 0.06  # of the base beyond the posts
SHADOW = 0.04  # of the base, in front of it: the view has space for it
BOB = 0.12  # the radius of the bobs, at most
NUMBERS = 0.14  # from the axles up to the end of their numbers
# Of the ground, in lengths and in depths of the base
GROUND_LENGTH = 1.3
GROUND_DEPTH = 2.2


class Scenery:
    """The light on VPython's canvas, and the stand around a cradle. Each tab has its own camera."""

    def __init__(self) -> None:
        """Set the lights, and a distant camera.

        One light is above on the left, and a weak one on the right. On a white page, the edges of
        bobs must be dark.
        """
        scene.autoscale = False
        scene.fov = 0.25  # rad: a distant camera; a near one distorts shapes off the centre
        scene.ambient = color.gray(0.4)
        scene.lights = []
        distant_light(direction=vector(-0.5, 0.9, 0.7), color=color.gray(0.82))
        distant_light(direction=vector(0.9, 0.1, 0.6), color=color.gray(0.2))
        self.stand: list = []
        # On the base. The page paints the shadows of the bobs on it (light.js), and finds it by
        # `pickable`.
        self.board = box(texture=textures.wood, color=DARK, pickable=False)
        self.ground = box(axis=vector(0, 1, 0), texture=GROUND, color=WHITE)

    def surround(
        self,
        axles: Sequence,
        cords_length: float,
        masses: Sequence[float],
        swing: float = 0.0,
    ) -> None:
        """Put a stand around these axles; masses (kg) are those of the pendula.

        cords_length (m) is from an axle to the centre of the lowest bob at rest. swing (rad) is
        the largest angle of ghosts that may come.
        """
        self.first, self.last = axles[0].pos, axles[-1].pos
        self.cords_length = cords_length
        discard(self.stand)
        self.stand = make_stand(self.first, self.last, axles[0].width, cords_length)
        base = self.stand[-1]
        half = vector(0, base.height / 2, 0)
        self.board.pos = base.pos + half
        self.board.size = vector(base.length, FLAT, base.width)
        self.ground.pos = base.pos - half
        self.ground.size = vector(FLAT, GROUND_LENGTH * base.length, GROUND_DEPTH * base.width)
        if len({*masses}) > 1:  # they will probably swing wide
            swing = max(swing, pi / 2)
        # m, above the axles: the view has space for bobs up to there
        self.highest = arm(swing, cords_length).y

    def keep_in_view(self, places: Iterable[vector]) -> None:
        """Let the view have space for bobs at these places (m), also outside of the stand."""
        for place in places:
            self.highest = max(self.highest, place.y - self.first.y)

    def view(self) -> dict:
        """Return what the camera of a tab must know, in metres.

        It shows all points: those of the stand, of the axles' numbers, and of all swings.
        """
        base = self.stand[-1]
        low, high = base.pos - base.size / 2, base.pos + base.size / 2
        top = self.first.y
        bottom = low.y - SHADOW * self.cords_length
        points = [*product((low.x, high.x), (bottom, top), (low.z, high.z))]
        aside, above = 0.0, NUMBERS * self.cords_length
        quarter = self.cords_length / 4  # so the view does not grow in each picture
        height = quarter * ceil(self.highest / quarter)
        if height > -2 * quarter:  # out of the stand
            aside = (1 + BOB) * self.cords_length
            above += max(height, 0.0) + BOB * self.cords_length  # also for the name of ghosts
        points.append((self.first.x - aside, top + above, 0.0))
        points.append((self.last.x + aside, top + above, 0.0))
        lowest = bottom - TO_CAMERA.y * high.z  # what is in front appears lower
        return {
            "center": [base.pos.x, (lowest + top + above) / 2, 0.0],
            "points": points,
            "finger": FINGER,
        }


def make_stand(first: vector, last: vector, depth: float, cords_length: float) -> list:
    """Return two rails with four posts, and the base.

    first and last are the places of the outer axles, depth (m) is from rail to rail.
    """
    left, right = first.x - TO_POSTS * cords_length, last.x + TO_POSTS * cords_length
    top, bottom = first.y, first.y - TO_BASE * cords_length
    thickness = cords_length / 25
    stand = []
    beside = (depth + thickness) / 2  # the axles end at the rails
    for z in (-beside, beside):
        stand.append(make_rod(vector(left, top, z), vector(right - left, 0, 0), thickness))
        for x in (left, right):
            stand.append(make_rod(vector(x, bottom, z), vector(0, top - bottom, 0), thickness))
            place = vector(x, top, z)
            stand.append(make_shape(simple_sphere, pos=place, radius=thickness / 2, **CHROME))
    overhang = 2 * OVERHANG * cords_length
    size = vector(right - left + overhang, BASE * cords_length, depth + overhang)
    middle = vector((left + right) / 2, bottom - size.y / 2, 0)
    base = make_shape(box, pos=middle, size=size, texture=textures.wood, color=DARK)
    return [*stand, base]


def make_rod(pos: vector, axis: vector, thickness: float) -> cylinder:
    return make_shape(cylinder, pos=pos, axis=axis, radius=thickness / 2, **CHROME)
