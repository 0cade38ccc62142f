"""The page of a single cradle: its widgets, what they show, and where its bobs are."""

from math import atan2, cos, degrees, radians, sin

import pytest
from programs import BOBS, pause, press, readout, wait_until

from support.constants import R_PARAM

SPEED, LIFTED, ANGLE = range(3)  # the sliders, in their order
SEPARATING = "Separating bobs collide too"  # a checkbox below the title Advanced

# Where a point of the plane of swing is seen: pixels in the window.
PIXEL = """([x, y]) => {
    const scene = glowObjs[0], forward = scene.forward.norm();
    const sideways = forward.cross(scene.up).norm(), upwards = sideways.cross(forward);
    const arm = vec(x, y, 0).sub(scene.center), distance = scene.range / Math.tan(scene.fov / 2);
    const pixels = Math.min(scene.width, scene.height) / 2 / scene.range * distance / (distance + arm.dot(forward));
    const canvas = document.querySelector("canvas").getBoundingClientRect();
    return [canvas.x + scene.width / 2 + pixels * arm.dot(sideways),
            canvas.y + scene.height / 2 - pixels * arm.dot(upwards)];
}"""


def csv_of(program):
    """Return the CSV of the project to which this program belongs."""
    return program.parents[1] / "newton_cradle_pends.csv"


def lifts(page):
    """Return the angles of the bobs in degrees."""
    return [
        degrees(atan2(x - (-0.1 + R_PARAM / 4 * i), R_PARAM / 5 - y)) for i, (x, y) in enumerate(page.evaluate(BOBS))
    ]


def wait_for_lifts(page, *expected):
    wait_until(lambda: lifts(page) == pytest.approx(expected, abs=0.01))


def menu(page, name):
    """Return this menu of the panel."""
    return page.get_by_role("combobox", name=name, exact=True)


def unfold(page, title):
    """Open the part of the panel that is folded away below this title."""
    page.locator("summary", has_text=title).evaluate("summary => summary.parentElement.open = true")


def slide(page, slider, part):
    """Click into a slider, this part of its length from the left."""
    box = page.locator(".ui-slider").nth(slider).bounding_box()
    page.mouse.click(box["x"] + part * box["width"], box["y"] + box["height"] / 2)


def from_start(page):
    """Restart the cradle, and let it run from t = 0."""
    pause(page)
    press(page, "Restart")
    wait_until(lambda: readout(page, "t") == 0)
    press(page, "Run")


def values(page):
    """Return the texts behind the sliders."""
    return page.locator(".value").all_inner_texts()


def pixel(page, bob, theta):
    """Return where this bob's centre is seen if its cord is at theta (degrees)."""
    x, y = -0.1 + R_PARAM / 4 * bob + R_PARAM * sin(radians(theta)), R_PARAM / 5 - R_PARAM * cos(radians(theta))
    return page.evaluate(PIXEL, [x, y])
