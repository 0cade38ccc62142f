"""What a page needs a program of its own for: its first picture, what disturbs it, its end."""

import re

import pages
import programs
import pytest
from pages import (
    bob_angles,
    open_cradle,
    pause,
    press,
    slide,
    violations,
    wait_for_angles,
    wait_for_cradle,
    wait_for_throw,
)
from programs import wait_until

from support.constants import R_PARAM
from support.page.scene.scenery import TO_BASE


@pytest.fixture
def started(page, program):
    """The process of a program whose cradle the page shows."""
    with programs.running(program, "--angle", "45", folder=program.parents[1]) as process:
        open_cradle(page, programs.first_lines(process))
        yield process


@pytest.mark.parametrize("page", ["firefox"], indirect=True)
def test_in_firefox_the_cradle_swings_and_a_bob_is_dragged_until_the_tab_is_closed(page, started):
    wait_for_throw(page)
    picture = picture_of(page)
    # And then the first one again
    page.wait_for_function(f"positions()[0][0] < {-0.1 - R_PARAM / 4}")
    assert picture_of(page) != picture

    pause(page)
    slide(page, "Bobs lifted", 0)
    wait_for_angles(page, 0, 0, 0, 0, 0)
    pages.drag(page, 3, 20, 40)
    wait_until(lambda: bob_angles(page)[3] == pytest.approx(40, abs=1))
    assert 38 < bob_angles(page)[4] < 50  # it was in the way
    page.mouse.up()
    page.keyboard.press("Space")
    wait_until(lambda: bob_angles(page)[0] < -15)
    page.close()
    assert programs.end(started) == programs.CLOSED


def picture_of(page):
    """Return a picture of the canvas (PNG)."""
    pages.draw(page, True)
    picture = page.locator("canvas").first.screenshot()
    pages.draw(page, False)
    return picture


def test_a_page_that_loses_the_graphics_driver_says_so_and_draws_again(page, started):
    context = "one('canvas').getContext('webgl2')"
    driver = page.evaluate_handle(f"{context}.getExtension('WEBGL_lose_context')")
    driver.evaluate("driver => driver.loseContext()")
    message = page.get_by_text("The browser cannot draw the cradle now.")
    message.wait_for()
    driver.evaluate("driver => driver.restoreContext()")
    message.wait_for(state="hidden")
    wait_for_cradle(page)
    picture = picture_of(page)
    wait_until(lambda: picture_of(page) != picture)


def test_a_browser_without_webgl_says_so(page, shared):
    page.add_init_script("""
        const { prototype } = HTMLCanvasElement;
        const { getContext } = prototype;
        prototype.getContext = function (kind) {
          return kind === "webgl2" ? null : getContext.call(this, kind);
        };
    """)
    page.goto(shared.url)
    page.get_by_text("This browser cannot draw the cradle (WebGL 2)").wait_for()
    pages.wait_for_moves(shared)


def test_the_canvas_says_what_it_shows_and_the_keys_are_listed(shared):
    words = re.compile("Newton's cradle: t,.* s.*energy,.* %, .*bob . at .* degrees (left|right)")
    shared.get_by_role("img", name=words).wait_for()
    press(shared, "Keys")
    shared.get_by_text("answer a question").wait_for()
    assert violations(shared) == {}


def test_a_bob_has_a_shadow_which_is_paler_when_it_is_lifted(whole):
    """The same wood is looked at with a bob above it, and without."""
    pause(whole)
    pages.draw(whole, True)
    x, y = pages.axle(0)
    below = y - TO_BASE * R_PARAM
    places = [pages.plane_pixel(whole, x - aside, below) for aside in (0, R_PARAM / 2**0.5)]

    def is_paler():
        found = []
        for lifted in (0, 1):
            whole.evaluate("lifted => set('lifted', lifted)", lifted)
            wait_for_angles(whole, -45 * lifted, 0, 0, 0, 0)
            found.append(whole.evaluate("places => lights(places)", places))
        (hanging, bare_aside), (bare, lifted) = found
        return 1.2 * hanging / bare < lifted / bare_aside < 0.95

    wait_until(is_paler)  # the shadows come after the first picture
