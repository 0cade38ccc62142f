"""What stands around the pendula: frame, base, light and camera. It is made once and does not move."""

import time

from vpython import baseObj, box, cylinder, distant_light, scene, textures, vector

STEEL = vector(0.75, 0.76, 0.78)
BACKGROUND = vector(241, 242, 244) / 255  # that of the page, so that the canvas has no edge
CANVAS_WIDTH, CANVAS_HEIGHT = 960, 600  # pixels
CAPTION = "Turn: drag with the right button, or Ctrl and the left. Zoom: the wheel. Closing this tab ends the program."


def add_scenery(pend_list, r_param) -> None:
    """Put the cradle into a frame on a wooden base, light it, and point the camera at all of it.

    Every swing up to the horizontal is in view. pend_list must have its objects; r_param is the cord length (m).
    Returns when the page has fetched all this, so that what moves next is seen from its start.
    """
    axles = [pend_dict["objects"][0] for pend_dict in pend_list]
    left, right = axles[0].pos.x - r_param / 4, axles[-1].pos.x + r_param / 4
    top, bottom = axles[0].pos.y, axles[0].pos.y - 1.35 * r_param
    add_frame(left, right, top, bottom, depth=axles[0].width, thickness=r_param / 50)
    set_scene()

    width = right - left + 1.7 * r_param  # the outer bobs, swung out to the side
    height = top - bottom + 0.5 * r_param  # the frame, seen a little from above
    scene.center = vector((left + right) / 2, (top + bottom) / 2, 0)
    # The range is half the height of the view; seen from the left, the near end of a long cradle looks 5 % larger.
    scene.range = max(height / 2, 1.05 * width / 2 * CANVAS_HEIGHT / CANVAS_WIDTH)
    while not baseObj.empty():
        time.sleep(0.02)


def add_frame(left, right, top, bottom, depth, thickness) -> None:
    """Make two rails from left to right, four posts and the base; all in m."""
    for z in (-depth / 2, depth / 2):
        start, length = left - thickness, right - left + 2 * thickness  # out over the posts
        cylinder(pos=vector(start, top, z), axis=vector(length, 0, 0), radius=thickness, color=STEEL)
        for x in (left, right):
            cylinder(pos=vector(x, bottom, z), axis=vector(0, top - bottom, 0), radius=thickness, color=STEEL)
    size = vector(right - left + 10 * thickness, 5 * thickness, depth + 10 * thickness)
    box(pos=vector((left + right) / 2, bottom, 0), size=size, texture=textures.wood)


def set_scene() -> None:
    """Set the canvas, a pale background, soft light, and a camera that looks a little from the left and above."""
    scene.width, scene.height, scene.caption = CANVAS_WIDTH, CANVAS_HEIGHT, CAPTION
    scene.background = BACKGROUND
    scene.fov = 0.25  # rad: a far camera, since a near one skews what is off the centre
    scene.forward = vector(-0.25, -0.18, -1)
    scene.lights = []
    scene.ambient = vector(0.45, 0.45, 0.45)
    distant_light(direction=vector(0.3, 0.6, 0.9), color=vector(0.5, 0.5, 0.5))
    distant_light(direction=vector(-0.6, 0.3, 0.4), color=vector(0.25, 0.25, 0.25))
