"""The page in windows of many sizes, on a dark screen, for fingers and for screen readers: in Chromium."""

import re

import pytest
from pages import lifts, menu, pixel, SEPARATING, unfold
from programs import (
    copy_project,
    first_lines,
    needs_vpython,
    new_page,
    open_cradle,
    press,
    PROGRAM,
    running,
    SECONDS,
    wait_until,
)
from whole_cradles import FIVE_CSV

pytestmark = needs_vpython

PHONE, TABLET, LAPTOP, PROJECTOR, BOARD = (390, 844), (1024, 768), (1366, 625), (1920, 1080), (2560, 1440)
SMALL = (900, 600)

# The edges of an element, in the window: left, top, right, bottom.
EDGES = "e => (r => [r.left, r.top, r.right, r.bottom])(e.getBoundingClientRect())"


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A paused page in Chromium, with a touch screen. It draws nothing: a large picture takes seconds in software."""
    program = copy_project(tmp_path_factory.mktemp("layout"), FIVE_CSV) / "src" / PROGRAM.name
    with running(program, "--lift", "0", patience=60 * SECONDS) as process, new_page(chromium, has_touch=True) as page:
        open_cradle(page, first_lines(process), small=False)
        page.evaluate("glowObjs[0].visible = false")
        press(page, "Pause")
        yield page


@pytest.fixture
def shared(started):
    """The page in a laptop's window, with all bobs at rest."""
    started.set_viewport_size({"width": LAPTOP[0], "height": LAPTOP[1]})
    started.evaluate("document.documentElement.classList.remove('presenting')")
    started.keyboard.press("v")
    wait_until(lambda: started.evaluate("glowObjs[0].height") == LAPTOP[1])
    return started


def resize(page, size):
    """Make the window this large (pixels), and wait until the canvas has followed."""
    page.set_viewport_size({"width": size[0], "height": size[1]})
    wait_until(lambda: page.evaluate("glowObjs[0].width") == round(edges(page, ".canvas")[2]))


def edges(page, selector):
    return page.locator(selector).first.evaluate(EDGES)


def is_whole(page, selector):
    """Return whether an element is in the window as a whole."""
    left, top, right, bottom = edges(page, selector)
    width, height = page.viewport_size["width"], page.viewport_size["height"]
    return 0 <= left < right <= width and 0 <= top < bottom <= height


@pytest.mark.parametrize("size", [LAPTOP, PROJECTOR, BOARD])
def test_a_wide_window_shows_everything_without_scrolling(shared, size):
    resize(shared, size)
    assert shared.evaluate("(e => e.scrollHeight - e.clientHeight)(document.querySelector('.panel'))") == 0
    for selector in ("canvas", ".readout", ".impacts", ".glowscript-graph", "select", "summary"):
        assert is_whole(shared, selector)
    left, top, right, bottom = edges(shared, "canvas")
    assert (right - left) * (bottom - top) >= 0.45 * size[0] * size[1]
    assert bottom - top == size[1]
    assert right < edges(shared, ".panel")[0] + 1
    letters = shared.locator(".readout").evaluate("e => parseFloat(getComputedStyle(e).fontSize)")
    assert letters >= 0.022 * size[1]


@pytest.mark.parametrize("size", [PHONE, TABLET])
def test_a_tall_window_shows_cradle_and_buttons_and_scrolls_the_rest(shared, size):
    resize(shared, size)
    assert is_whole(shared, "canvas")
    assert edges(shared, "canvas")[2] == size[0]
    for name in ("Run", "Step", "Restart"):
        assert is_whole(shared, f"button:has-text('{name}')")
    assert edges(shared, ".panel")[2] <= size[0]
    assert all(box.evaluate(EDGES)[2] <= size[0] for box in shared.locator(".panel section > *").all())
    shared.locator(".folds").scroll_into_view_if_needed()
    assert is_whole(shared, ".folds")


def test_nothing_in_the_panel_covers_anything_else(shared):
    for size in (PHONE, TABLET, SMALL, LAPTOP, PROJECTOR):
        resize(shared, size)
        boxes = [box.evaluate(EDGES) for box in shared.locator(".panel section").all() if box.is_visible()]
        for number, (left, top, right, bottom) in enumerate(boxes):
            for others_left, others_top, others_right, others_bottom in boxes[:number]:
                overlap = (
                    min(right, others_right) - max(left, others_left),
                    min(bottom, others_bottom) - max(top, others_top),
                )
                assert min(overlap) <= 0


def test_present_leaves_cradle_and_numbers(shared):
    before = shared.locator(".readout").evaluate("e => parseFloat(getComputedStyle(e).fontSize)")
    for enter, leave in (("f", "f"), ("f", "Escape")):
        shared.keyboard.press(enter)
        wait_until(lambda: menu(shared, "Collisions").is_hidden())
        assert edges(shared, ".canvas")[2] == shared.evaluate("innerWidth")
        assert is_whole(shared, ".readout")
        assert shared.locator(".readout").evaluate("e => parseFloat(getComputedStyle(e).fontSize)") > 1.5 * before
        shared.keyboard.press(leave)
        wait_until(lambda: menu(shared, "Collisions").is_visible())
    press(shared, "Present")
    wait_until(lambda: menu(shared, "Collisions").is_hidden())
    shared.get_by_role("button", name="End the presentation").click()
    wait_until(lambda: menu(shared, "Collisions").is_visible())
    assert shared.locator(".leave").is_hidden()


def test_light_and_dark_follow_the_system(shared):
    for scheme, is_dark in (("dark", True), ("light", False)):
        shared.emulate_media(color_scheme=scheme)
        wait_until(lambda is_dark=is_dark: (shared.evaluate("glowObjs[0].background.x") < 0.3) == is_dark)
        paper, ink = shared.locator(".panel").evaluate(
            "e => [getComputedStyle(e).backgroundColor, getComputedStyle(e).color]"
        )
        assert (brightness(paper) < brightness(ink)) == is_dark
        assert abs(brightness(paper) - brightness(ink)) > 128


def brightness(color):
    """Return the mean of the parts of a CSS color, rgb(r, g, b)."""
    return sum(map(int, re.findall(r"\d+", color)[:3])) / 3


def test_one_finger_drags_a_bob_or_turns_the_camera_and_two_zoom(shared):
    finger = shared.context.new_cdp_session(shared)

    def touch(kind, *points):
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y} for x, y in points]})

    view = "[glowObjs[0].forward.x, glowObjs[0].range]"
    before = shared.evaluate(view)
    x, y = pixel(shared, 4, 0)
    radius = (x - pixel(shared, 3, 0)[0]) / 2.1
    touch("touchStart", (x, y + 1.3 * radius))  # a finger is not exact
    touch("touchMove", pixel(shared, 4, 20))
    touch("touchMove", pixel(shared, 4, 40))
    wait_until(lambda: lifts(shared)[4] == pytest.approx(40, abs=3))
    assert shared.evaluate(view) == before
    touch("touchEnd")
    shared.keyboard.press("0")
    touch("touchStart", (60, 60))
    touch("touchMove", (90, 60))
    touch("touchMove", (140, 60))
    touch("touchEnd")
    wait_until(lambda: shared.evaluate(view)[0] != before[0])
    touch("touchStart", (200, 60), (300, 60))
    for apart in (20, 40, 60, 80):
        touch("touchMove", (200 - apart, 60), (300 + apart, 60))
    touch("touchEnd")
    wait_until(lambda: shared.evaluate(view)[1] != before[1])


def test_a_finger_moves_a_slider(shared):
    left, top, right, bottom = edges(shared, ".ui-slider")
    finger = shared.context.new_cdp_session(shared)
    for kind, part in (("touchStart", 0.5), ("touchMove", 0.7), ("touchMove", 1.0)):
        point = {"x": left + part * (right - left), "y": (top + bottom) / 2}
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [point]})
    finger.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    wait_until(lambda: shared.locator(".value").first.inner_text() in ("1.9x", "2.0x"))  # the handle keeps its offset


def test_the_cursor_shows_that_a_bob_can_be_grabbed(shared):
    cursor = "getComputedStyle(document.querySelector('.canvas canvas:last-of-type')).cursor"
    shared.mouse.move(*pixel(shared, 2, 0))
    wait_until(lambda: shared.evaluate(cursor) == "grab")
    shared.mouse.down()
    shared.mouse.move(*pixel(shared, 2, 5))
    wait_until(lambda: shared.evaluate(cursor) == "grabbing")
    shared.mouse.up()
    shared.mouse.move(20, 20)
    wait_until(lambda: shared.evaluate(cursor) == "auto")


def test_the_camera_stays_above_the_base(shared):
    seen = """async () => {
        glowObjs[0].forward = vec(0, 0.5, -1);
        for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
        return glowObjs[0].forward.y;
    }"""
    wait_until(lambda: shared.evaluate(seen) == 0)


def test_widgets_have_names_and_roles(shared):
    for name in ("Speed", "Bobs lifted", "Release angle"):
        assert shared.get_by_role("slider", name=name).count() == 1
    assert shared.get_by_role("combobox", name="Collisions").count() == 1
    assert shared.evaluate("document.documentElement.lang") == "en"
    assert shared.get_by_role("combobox", name="Graph").count() == 1
    unfold(shared, "Advanced")
    box = shared.get_by_role("checkbox", name=SEPARATING)
    shared.get_by_text(SEPARATING).click()
    assert box.is_checked()
    shared.get_by_text(SEPARATING).click()
    assert not box.is_checked()
    canvas = shared.get_by_role("img", name=re.compile("Newton's cradle with 5 bobs: t .* s, energy .* %"))
    canvas.wait_for()


def test_a_key_lifts_one_bob_more(shared):
    slider = shared.get_by_role("slider", name="Bobs lifted")
    slider.focus()
    slider.press("Home")
    for lifted in (1, 2, 3):
        slider.press("ArrowRight")
        wait_until(lambda lifted=lifted: slider.get_attribute("aria-valuetext") == f"{lifted} of 5")
        assert slider.get_attribute("aria-valuenow") == str(lifted)
    slider.press("Home")
    wait_until(lambda: slider.get_attribute("aria-valuetext") == "0 of 5")
    slider.blur()


def test_forced_colors_leave_the_sliders_visible(shared):
    shared.emulate_media(forced_colors="active")
    slider, part = shared.locator(".ui-slider").first, shared.locator(".ui-slider-range").first
    filled, empty = (place.evaluate("e => getComputedStyle(e).backgroundColor") for place in (part, slider))
    assert filled != empty
    shared.emulate_media(forced_colors="none")
