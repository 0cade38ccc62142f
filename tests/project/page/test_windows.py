"""What a window, a system, a browser and fingers change: cradle, text and colors follow."""

import pages
import programs
import pytest
from pages import bob_angles, pause, pixel, slide, wait_for_angles
from programs import wait_until
from shared_page import edges, is_whole, wait_for_text

PHONE, LAPTOP, BOARD = (390, 844), (1366, 625), (2560, 1440)
FRAME = (700, 200)  # in a course page


@pytest.fixture
def at_rest(whole):
    """The page in a laptop's window, with all bobs at rest, and its whole canvas."""
    resize(whole, LAPTOP)
    pause(whole)
    slide(whole, "Bobs lifted", 0)
    wait_for_angles(whole, 0, 0, 0, 0, 0)
    return whole


def resize(page, size):
    """Make the window this large (pixels), and wait until the canvas has followed."""
    page.set_viewport_size({"width": size[0], "height": size[1]})
    wait_until(lambda: page.evaluate("glowObjs[0].width") == round(edges(page, ".canvas")[2]))


@pytest.mark.parametrize("size", [PHONE, LAPTOP, FRAME])
def test_the_whole_swing_is_in_view(at_rest, size):
    resize(at_rest, size)
    assert is_whole(at_rest, "canvas")
    left, _, right, bottom = edges(at_rest, "canvas")
    assert bottom >= min(size) / 2
    wait_until(lambda: left < pixel(at_rest, 0, -45)[0] < pixel(at_rest, 4, 45)[0] < right)
    # The graph follows the window, too
    right = "one('.graph').getBoundingClientRect().right"
    wait_until(lambda: at_rest.evaluate(right) <= size[0])


def test_a_tall_window_has_the_buttons_in_view_and_the_rest_only_below(at_rest):
    resize(at_rest, PHONE)
    for name in ("Run", "Step", "Restart"):
        assert is_whole(at_rest, f".controls button:has-text('{name}')")
    at_rest.locator(".bobs summary").click()
    assert at_rest.evaluate("(e => e.scrollWidth - e.clientWidth)(one('.panel'))") == 0


def test_a_wide_window_has_all_in_view_beside_a_large_cradle(at_rest):
    resize(at_rest, BOARD)
    assert at_rest.evaluate("(e => e.scrollHeight - e.clientHeight)(one('.panel'))") == 0
    assert is_whole(at_rest, ".readout")
    apart = pixel(at_rest, 4, 0)[0] - pixel(at_rest, 3, 0)[0]
    assert 0.95 * apart >= 60 / 1366 * BOARD[0]  # the width of a bob
    letters = "parseFloat(getComputedStyle(one('.readout')).fontSize)"
    assert at_rest.evaluate(letters) >= 0.022 * BOARD[1]


def test_the_text_is_as_large_as_the_reader_has_chosen_and_nothing_is_cut(driver, shared):
    """24 pixels in the settings of the browser.

    The small text follows, and the texts in the canvas.
    """
    arguments = [*pages.ARGUMENTS, "--blink-settings=defaultFontSize=24"]
    with (
        driver.chromium.launch(executable_path=pages.CHROMIUM, args=arguments) as browser,
        pages.new_page(browser) as page,
    ):
        pages.open_cradle(page, shared.url)
        for selector, size in ("body", "24px"), (".hint", "21px"):
            assert page.evaluate(f"getComputedStyle(one('{selector}')).fontSize") == size
        assert page.evaluate("scene().__overlay_objects.objects[0].height") == 21
        pages.tick(page, "Ask")
        page.keyboard.press("n")
        page.locator(".question").wait_for()
        for size in ((1366, 768), PHONE):
            resize(page, size)
            faults = page.evaluate("faults()")
            assert not faults, "\n".join(faults)


def test_curves_keep_their_colors_where_the_system_forces_its_own(at_rest):
    pages.menu(at_rest, "Graph").select_option("Energies")
    at_rest.locator(".plot").get_by_text("potential").wait_for()
    at_rest.emulate_media(forced_colors="active")
    legend = at_rest.evaluate(
        "find('.legendColorBox div div').map(e => getComputedStyle(e).borderColor)"
    )
    assert len(legend) == len({*legend}) == 3


def test_one_finger_drags_a_bob_or_turns_the_camera_and_two_zoom(at_rest):
    fingers = at_rest.context.new_cdp_session(at_rest)

    def touch(kind, *points):
        """Kind is Start, Move or End, with a finger at each of the points (x, y)."""
        points = [{"x": x, "y": y} for x, y in points]
        fingers.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})

    def view():
        return at_rest.evaluate("[glowObjs[0].forward.x, glowObjs[0].range]")

    turn, size = view()
    x, y = pixel(at_rest, 4, 0)
    radius = (x - pixel(at_rest, 3, 0)[0]) / 2.1
    touch("Start", (x, y + 1.3 * radius))  # a finger is not exact
    touch("Move", pixel(at_rest, 4, 20))
    touch("Move", pixel(at_rest, 4, 40))
    wait_until(lambda: bob_angles(at_rest)[4] == pytest.approx(40, abs=3))
    assert view() == [turn, size]
    touch("End")
    touch("Start", (60, 60))
    touch("Move", (90, 60))
    touch("Move", (140, 60))
    touch("End")
    wait_until(lambda: view()[0] != turn)
    touch("Start", (200, 60), (300, 60))
    for apart in (20, 40, 60, 80):
        touch("Move", (200 - apart, 60), (300 + apart, 60))
    touch("End")
    wait_until(lambda: view()[1] != size)
    at_rest.evaluate("glowObjs[0].forward = vec(0, 0.5, -1)")
    at_rest.wait_for_function("() => glowObjs[0].forward.y === 0")  # never below the base


def test_a_browser_without_webgl_says_so(driver, shared):
    arguments = ["--no-sandbox", "--disable-3d-apis"]
    with driver.chromium.launch(executable_path=pages.CHROMIUM, args=arguments) as browser:
        blind = browser.new_page()
        blind.set_default_timeout(programs.SECONDS * 1000)
        blind.goto(shared.url)
        wait_for_text(blind, "This browser cannot draw the cradle (WebGL 2)")
    pages.wait_for_moves(shared)
