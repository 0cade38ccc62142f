"""The pages of the programs in real browsers: how the tests open, read and operate them."""

import json
import re
import shutil
from contextlib import contextmanager
from math import atan2, cos, degrees, radians, sin
from pathlib import Path

import pytest
from programs import SECONDS, wait_until

from support.constants import R_PARAM

ON_A_MAC = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"


def installed(*names):
    """Return the path of the first of these programs that is there, or None."""
    paths = map(shutil.which, names)
    return next(filter(None, paths), None)


CHROMIUM = installed("chromium", "chromium-browser", "google-chrome", ON_A_MAC)
FIREFOX = installed("firefox-esr", "firefox")
ARGUMENTS = [
    "--no-sandbox",
    "--no-first-run",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    # Without a graphics card it is what slows everything, thirty times
    "--disable-gpu-compositing",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]

TIMEOUT = 1000 * SECONDS  # ms: Playwright waits at most this long, also for a browser to start

FOLDER = Path(__file__).parent
BEFORE_PAGE = FOLDER / "before_page.js"
TOOLS = [(FOLDER / name).read_text() for name in ["page_tools.js", "layout_rules.js"]]


@contextmanager
def new_page(browser, **settings):
    """Open a new tab in this browser, with Playwright's settings, and close it in the end."""
    page = browser.new_page(viewport={"width": 1000, "height": 700}, **settings)
    page.set_default_timeout(TIMEOUT)
    page.add_init_script(f"window.tools = {json.dumps(TOOLS)}")
    page.add_init_script(path=BEFORE_PAGE)
    yield page
    page.close()


def open_cradle(page, address, bobs=5):
    """Open the page, and wait until it shows the cradle."""
    page.goto(address)
    wait_for_cradle(page, bobs)


def wait_for_cradle(page, bobs=5):
    """Wait for the bobs, their numbers, and a camera that fits the canvas.

    Only a test of the picture has it drawn.
    """
    page.wait_for_function(f"window.positions?.().length === {bobs}")
    draw(page, False)
    page.wait_for_function("scene().width === $('.canvas').width() * devicePixelRatio")


def draw(page, drawn):
    """Have the browser draw the canvas, or not.

    Without a graphics card it takes most of the time. It works on VPython's own page, too.
    """
    frames = "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
    page.evaluate(f"drawn => {{ glowObjs[0].visible = drawn; return {frames}; }}", drawn)


def readout(page, name):
    """Return a number of the readout, by the word before it."""
    text = page.locator(".readout").inner_text()
    return float(re.search(rf"^{name}\s+([-+0-9.]+)", text, re.MULTILINE)[1])


def axle(bob):
    """Return the place (m) from which this bob (an index) hangs."""
    return -0.1 + R_PARAM / 4 * bob, R_PARAM / 5


def bob_angles(page):
    """Return the angles of the bobs in degrees."""
    angles = []
    for bob, (x, y) in enumerate(page.evaluate("positions()")):
        axle_x, axle_y = axle(bob)
        angles.append(degrees(atan2(x - axle_x, axle_y - y)))
    return angles


def plane_pixel(page, x, y):
    """Return where a point of the plane of swing (m) is seen: pixels in the window."""
    return page.evaluate("place => pixel(place)", [x, y])


def pixel(page, bob, theta):
    """Return where this bob's centre is seen if its cord is at theta (degrees)."""
    x, y = axle(bob)
    angle = radians(theta)
    return plane_pixel(page, x + R_PARAM * sin(angle), y - R_PARAM * cos(angle))


def drag(page, bob, *thetas):
    """Grab a bob that hangs, and move the mouse to where its cord is at these angles (degrees)."""
    page.mouse.move(*pixel(page, bob, 0))
    page.mouse.down()
    for theta in thetas:
        page.mouse.move(*pixel(page, bob, theta), steps=3)


def wait_for_angles(page, *expected):
    wait_until(lambda: bob_angles(page) == pytest.approx(expected, abs=0.01))


def wait_for_throw(page):
    """Wait until a bob is on the right of all axles: only a hit brings it that far.

    Also on VPython's own page.
    """
    is_far = f"shape?.constructor.name === 'sphere' && shape.pos.x > {-0.1 + 5 / 4 * R_PARAM}"
    page.wait_for_function(f"window.glowObjs?.some(shape => {is_far})")


def wait_for_moves(page):
    wait_until(lambda: page.evaluate("moves()"))


def wait_for_rest(page):
    """Wait until nothing moves any more.

    A click, or a picture of before, can still be on its way.
    """
    wait_until(lambda: not page.evaluate("moves()"))


def button(page, name):
    return page.get_by_role("button", name=name, exact=True)


def menu(page, name):
    return page.get_by_role("combobox", name=name, exact=True)


def press(page, name):
    button(page, name).click()


def saved(page, name):
    """Press the button with this name; return the name and the path of the file that it saves."""
    with page.expect_download() as download:
        press(page, name)
    return download.value.suggested_filename, download.value.path()


def choose(page, name):
    """Choose an experiment by its picture."""
    page.locator(".choose").click()
    button(page, name).click()


def tick(page, name):
    """Tick a box; a state from before the click can untick it for a moment."""
    box = page.get_by_role("checkbox", name=name)
    if not box.is_checked():
        box.click()
    wait_until(box.is_checked)


def pause(page):
    press(page, "Pause")
    button(page, "Run").wait_for()
    wait_for_rest(page)


def wait_for_time(page):
    """Wait until some simulated time has passed."""
    wait_until(lambda: readout(page, "t") > 0)


def slide(page, name, value):
    page.get_by_role("slider", name=name, exact=True).fill(str(value))


def violations(page):
    """Return what axe finds on the page: by each broken rule, the elements that break it."""
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    response = axe.run(page).response
    found = {}
    for rule in response["violations"]:
        found[rule["id"]] = [element["html"] for element in rule["nodes"]]
    # Of white on white, axe only asks whether it is meant.
    for rule in response["incomplete"]:
        for element in rule["nodes"]:
            if "1:1 contrast" in element["failureSummary"]:
                found.setdefault("unseen", []).append(element["html"])
    return found
