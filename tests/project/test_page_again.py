"""Pages of their own, in real browsers.

The first one, three tabs and a reload, hostile texts, the program's end.
"""

import signal
import time
from collections import deque

import pages
import programs
import pytest
from pages import (
    bob_angles,
    BOBS,
    menu,
    open_cradle,
    pause,
    slide,
    wait_for_angles,
    wait_for_cradle,
    wait_for_moves,
)
from programs import wait_until
from whole_cradles import FIVE_CSV, GOOD, HEADER

from support.constants import R_PARAM

IN_BOTH_BROWSERS = pytest.mark.parametrize("page", ["chromium", "firefox"], indirect=True)


@pytest.fixture
def started(page, program):
    """The process of a program whose cradle the page shows."""
    with programs.running(program, "--angle", "45", folder=program.parents[1]) as process:
        open_cradle(page, programs.first_lines(process))
        yield process


@IN_BOTH_BROWSERS
def test_the_cradle_swings_until_the_tab_is_closed(page, started):
    """The picture changes, and a bob can be dragged."""
    # The last bob has been hit
    page.wait_for_function(f"() => ({BOBS})()[4][0] > {-0.1 + 5 / 4 * R_PARAM}")
    picture = picture_of(page)
    # And then the first one again
    page.wait_for_function(f"() => ({BOBS})()[0][0] < {-0.1 - R_PARAM / 4}")
    assert picture_of(page) != picture

    pause(page)
    slide(page, "Bobs lifted", 0)
    wait_for_angles(page, 0, 0, 0, 0, 0)
    pages.drag(page, 3, 20, 40)
    wait_until(lambda: bob_angles(page)[3] == pytest.approx(40, abs=1))
    assert 38 < bob_angles(page)[4] < 50  # it was in the way
    page.mouse.up()
    page.keyboard.press("Space")
    wait_until(lambda: "4-3-2-1" in page.locator(".impacts").text_content())
    page.close()
    status, stdout, stderr = programs.end(started)
    assert (status, stderr) == (0, "")
    if stdout:  # Firefox has not said for sure that its tab is closed
        assert stdout.startswith("The page has gone: ")


def test_the_first_picture_has_all_bobs_with_their_textures(page, program):
    # bobsAtFirst is how many bobs the first picture has; one waits for its texture.
    page.add_init_script("""{
        const gl = WebGL2RenderingContext.prototype, draw = gl.drawElements;
        const isBob = o => o?.constructor.name === "sphere";
        gl.drawElements = function (...how) {
            window.bobsAtFirst ??= glowObjs.filter(o => isBob(o) && o.visible && o.ready).length;
            draw.apply(this, how);
        };
    }""")
    page.route("**/*.jpg", lambda route: (time.sleep(0.3), route.continue_()))
    with programs.running(program) as process:
        page.goto(programs.first_lines(process))
        wait_until(lambda: page.evaluate("window.bobsAtFirst") == 5)


def test_a_page_whose_script_did_not_arrive_loads_again(page, program):
    page.route("**/questions.js", lambda route: route.abort(), times=2)
    with programs.running(program) as process:
        page.goto(programs.first_lines(process), wait_until="commit")
        page.get_by_text("A part of this page did not arrive. It loads again by itself.").wait_for()
        wait_for_cradle(page)
        wait_for_moves(page)


def picture_of(page):
    """Return a picture of the canvas (PNG)."""
    pages.draw(page, True)
    picture = page.locator("canvas").first.screenshot()
    pages.draw(page, False)
    return picture


@IN_BOTH_BROWSERS
def test_a_page_that_loses_the_graphics_driver_says_so_and_draws_again(page, started):
    page.evaluate("""() => {
        glowObjs[0].forward = vec(0.6, -0.2, -1);
        window.driver = one("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
        driver.loseContext();
    }""")
    message = page.get_by_text("The browser cannot draw the cradle now.")
    message.wait_for()
    page.evaluate("driver.restoreContext()")
    message.wait_for(state="hidden")
    wait_for_cradle(page)
    assert page.evaluate("glowObjs[0].forward.x") == 0.6  # from where you have looked at it
    picture = picture_of(page)
    wait_until(lambda: picture_of(page) != picture)


# The values of all controls.
CONTROLS = """() => [
    find("select, input:not([type=checkbox])").map(control => control.value),
    find("input[type=checkbox]").map(box => box.checked),
    find("output").map(output => output.value),
]"""


@pytest.fixture
def tabs(page, started):
    """Three tabs with the same cradle, and a process that waits until all are closed."""
    browser = page.context.browser
    with pages.new_page(browser) as second, pages.new_page(browser) as third:
        open_cradle(second, page.url)
        open_cradle(third, page.url)
        yield page, second, third
    page.close()
    assert programs.end(started) == programs.QUIETLY


def test_three_tabs_show_one_cradle_with_the_settings_of_all(tabs):
    """Also after a reload."""
    first, second, third = tabs
    slide(second, "Speed", 2)
    slide(second, "Bobs lifted", 2)
    slide(second, "Release angle", 70)
    slide(second, "Elasticity e", 0.9)
    menu(second, "Graph").select_option("no graph")
    pages.tick(third, "Arrows")
    third.evaluate("set('ask_first', false)")
    first.locator(".programmers summary").click()
    first.get_by_label("Separating bobs collide too").check()
    for tab in tabs:
        tab.wait_for_function(
            "() => glowObjs.some(o => o?.constructor.name === 'arrow' && o.visible)"
        )
        sliders = tab, "speed", "lifted", "release_angle"
        wait_until(lambda names=sliders: pages.slider_texts(*names) == ["2.0x", "2 of 5", "70°"])
        wait_for_moves(tab)
    pause(first)
    wait_until(lambda: bob_angles(first) == bob_angles(second) == bob_angles(third))
    settings = first.evaluate(CONTROLS)
    third.reload()
    wait_for_cradle(third)
    wait_until(lambda: third.evaluate(CONTROLS) == settings)
    assert second.evaluate(CONTROLS) == settings
    assert not third.locator(".plot").is_visible()


def test_each_tab_has_its_own_camera_and_the_cradle_swings_on_when_one_is_reloaded(tabs):
    first, second, third = tabs
    first.evaluate("window.times = []; show('now', () => times.push(parseFloat(state.motion.t)))")
    second.mouse.move(100, 100)
    second.mouse.down(button="right")
    second.mouse.move(160, 100, steps=3)
    second.mouse.up(button="right")
    # It is there as soon as the camera has moved
    pages.button(second, "Reset view").wait_for()
    third.reload()
    wait_for_cradle(third)
    for tab in tabs:
        wait_for_moves(tab)
    for tab in (first, third):
        assert not pages.button(tab, "Reset view").is_visible()
    second.close()
    wait_for_moves(first)
    times = first.evaluate("times")
    assert times[0] < times[-1]
    assert times == sorted(times)


def test_the_ended_program_shows_how_to_start_it_again(page, started):
    started.send_signal(signal.SIGINT)
    assert programs.end(started) == programs.QUIETLY
    page.get_by_text("The program has ended.").wait_for()
    command = page.locator(".notice code").inner_text()
    assert command.endswith(" src/visualize_cradle_run.py --angle 45")
    # It is pale
    assert float(page.evaluate("getComputedStyle(one('.canvas')).opacity")) < 0.5
    assert pages.violations(page) == {}


def test_hostile_texts_are_shown_as_texts(page, program):
    """In an experiment's name, question, answers and explanation, and in the CSV."""
    evil = "<s><img src onerror>"  # a text that makes elements, where it is HTML
    folder = program.parents[1]
    file = folder / "support" / "experiments" / "single" / "2_two_bobs.txt"
    text = file.read_text().replace("Two bobs", evil)
    file.write_text(text)
    file.with_name("1_one_bob.txt").write_text(text)
    with programs.running(program, folder=folder) as process:
        open_cradle(page, programs.first_lines(process))
        page.get_by_text(f"'{evil}' is the name of another experiment").wait_for()
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


def test_a_page_that_is_left_goes_on_when_back_shows_it_again(page, started):
    """Then a closed tab ends the program, without a word about the page that was left.

    Chromium keeps no page here; two events are all that a kept page gets.
    """
    hide = "dispatchEvent(new PageTransitionEvent('pagehide', {persisted: true}))"
    page.goto("about:blank")
    assert started.stdout.readline().startswith("The page has gone: ")
    page.go_back()
    wait_for_cradle(page)
    page.evaluate("window.isKept = true")
    wait_for_moves(page)
    page.evaluate(hide)
    page.evaluate(hide.replace("pagehide", "pageshow"))
    wait_for_moves(page)
    assert page.evaluate("isKept")
    page.close()
    assert programs.end(started) == (0, "The page is back.\n", "")


# The time on the wall (s) minus the simulated one, at each change of the readout in a second; and
# when it was read.
LATENESS = """async () => {
    const text = () => document.querySelector(".readout").innerText;
    const late = [], start = performance.now();
    let before = text();
    while (performance.now() - start < 1000) {
        await new Promise(requestAnimationFrame);
        if (text() === before) continue;
        before = text();
        late.push(performance.now() / 1000 - before.match(/t\\s+([0-9.]+) s/)[1]);
    }
    return [start / 1000, before.includes("x real time") ? Infinity : Math.min(...late)];
}"""


@pytest.mark.clock
def test_simulated_time_keeps_step_with_the_wall(page, program):
    """Within 0.05 s in 6 s, with one bob: its ticks take little time.

    A busy machine brings a reading to the page late, and none early: the test takes the least late
    one of each second. It leaves out seconds in which the program reports that the machine was too
    busy (0.6x real time).
    """
    (program.parents[1] / "newton_cradle_pends.csv").write_text(HEADER + GOOD)
    readings = deque(maxlen=8)

    def has_kept_step():
        readings.append(page.evaluate(LATENESS))
        (start, before), (now, after) = readings[0], readings[-1]
        return now - start > 6 and abs(after - before) < 0.05

    with programs.running(program) as process:
        open_cradle(page, programs.first_lines(process), bobs=1)
        # A busy machine seldom has seven seconds without a stall
        wait_until(has_kept_step, 3 * programs.SECONDS)
