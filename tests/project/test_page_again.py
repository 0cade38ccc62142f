"""What a page needs a program of its own for: its first picture, what disturbs it, its end."""

import time

import pages
import programs
import pytest
from pages import (
    bob_angles,
    open_cradle,
    pause,
    slide,
    wait_for_angles,
    wait_for_cradle,
    wait_for_moves,
    wait_for_throw,
)
from programs import wait_until
from whole_cradles import FIVE_CSV

from support.constants import R_PARAM


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


def test_the_first_picture_has_all_bobs_with_their_textures(page, program):
    page.route("**/*.jpg", lambda route: (time.sleep(0.3), route.continue_()))
    with programs.running(program) as process:
        page.goto(programs.first_lines(process))
        wait_until(lambda: page.evaluate("window.bobsAtFirst") == 5)


def test_a_page_whose_script_did_not_arrive_loads_again(page, program):
    page.route("**/questions.js", lambda route: route.abort())
    with programs.running(program) as process:
        page.goto(programs.first_lines(process), wait_until="commit")
        page.get_by_text("A part of this page did not arrive.").wait_for()
        page.unroute_all(behavior="ignoreErrors")
        wait_for_cradle(page)
        wait_for_moves(page)


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


def test_hostile_texts_are_shown_as_texts(page, program):
    """In an experiment's name, question, answers and explanation, and in the CSV."""
    evil = "<s><img src onerror>"  # a text that makes elements, where it is HTML
    folder = program.parents[1]
    file = folder / "support" / "experiments" / "single" / "02_two_bobs.toml"
    file.write_text(file.read_text().replace("Two bobs", evil))
    with programs.running(program, folder=folder) as process:
        open_cradle(page, programs.first_lines(process))
        pages.choose(page, evil)
        page.get_by_text(f"{evil} come in.").first.wait_for()
        page.get_by_text(f"C\u2002{evil}, as far as the two").wait_for()
        page.keyboard.press("a")
        page.get_by_text("What did you see?").wait_for()
        page.keyboard.press("a")
        page.get_by_text(f"{evil} came in at").first.wait_for()
        (folder / "newton_cradle_pends.csv").write_text(FIVE_CSV.replace("red", evil, 1))
        page.get_by_text(f"found '{evil}'").wait_for()
        assert page.locator("s, [onerror]").count() == 0
