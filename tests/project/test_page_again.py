"""Pages of their own, in real browsers: the first one, three tabs and a reload, hostile texts, the
program's end.
"""

import signal
import time
from collections import Counter, deque

import programs
import pytest
from programs import BOBS, lifts, open_cradle, pause, slide, values, wait_for_cradle, wait_until
from whole_cradles import FIVE_CSV, GOOD, HEADER

from support.constants import R_PARAM


@pytest.fixture
def started(page, program):
    """The process of a program whose cradle the page shows."""
    with programs.running(program, "--angle", "45", folder=program.parents[1]) as process:
        open_cradle(page, programs.first_lines(process))
        yield process


@pytest.mark.parametrize("page", ["chromium", "firefox"], indirect=True)
def test_the_cradle_swings_until_the_tab_is_closed(page, started):
    """It has a frame, the picture changes, and a bob can be dragged."""
    kinds = Counter(page.evaluate("() => glowObjs.filter(o => o).map(o => o.constructor.name)"))
    assert (kinds["box"], kinds["cylinder"], kinds["sphere"]) == (5 + 1, 5 + 6, 5)
    # The last bob has been hit
    page.wait_for_function(f"() => ({BOBS})()[4][0] > {-0.1 + 5 / 4 * R_PARAM}")
    picture = picture_of(page)
    # And then the first one again
    page.wait_for_function(f"() => ({BOBS})()[0][0] < {-0.1 - R_PARAM / 4}")
    assert picture_of(page) != picture

    pause(page)
    slide(page, "Bobs lifted", 0)
    programs.wait_for_lifts(page, 0, 0, 0, 0, 0)
    page.mouse.move(*programs.pixel(page, 3, 0))
    page.mouse.down()
    for theta in (20, 40):
        page.mouse.move(*programs.pixel(page, 3, theta), steps=3)
    # It was in the way
    wait_until(lambda: lifts(page)[3] == pytest.approx(40, abs=1) and 38 < lifts(page)[4] < 50)
    assert lifts(page)[:3] == pytest.approx([0, 0, 0])
    page.mouse.up()
    page.keyboard.press("Space")
    wait_until(lambda: "4-3-2-1" in page.locator(".impacts").inner_text())
    page.close()
    assert programs.end(started) == programs.QUIETLY


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
    lost = iter(["questions.js"])
    page.route(
        "**/questions.js", lambda route: route.abort() if next(lost, None) else route.continue_()
    )
    with programs.running(program) as process:
        page.goto(programs.first_lines(process))
        page.get_by_text("A part of this page did not arrive. It loads again by itself.").wait_for()
        page.wait_for_function("() => typeof shows === 'object' && 'question' in shows")
        programs.wait_for_moves(page)


def picture_of(page):
    """Return a picture of the canvas (PNG)."""
    programs.draw(page, True)
    picture = page.locator("canvas").first.screenshot()
    programs.draw(page, False)
    return picture


@pytest.mark.parametrize("page", ["chromium", "firefox"], indirect=True)
def test_a_page_that_loses_the_graphics_driver_says_so_and_draws_again_when_it_is_back(
    page, started
):
    page.evaluate("""() => {
        glowObjs[0].forward = vec(0.6, -0.2, -1);
        window.driver = one("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
        driver.loseContext();
    }""")
    words = page.get_by_text("The browser cannot draw the cradle now.")
    words.wait_for()
    page.evaluate("driver.restoreContext()")
    words.wait_for(state="hidden")
    wait_for_cradle(page)
    assert page.evaluate("glowObjs[0].forward.x") == 0.6  # from where you have looked at it
    picture = picture_of(page)
    wait_until(lambda: picture_of(page) != picture)


def test_three_tabs_show_one_cradle_and_one_is_reloaded_and_closed(page, started):
    """The cradle swings on, with the settings that somebody has chosen.

    Each tab has its own camera.
    """
    # The values of all controls.
    controls = """() => [find("select, input:not([type=checkbox])").map(control => control.value),
        find("input[type=checkbox]").map(box => box.checked), find("output").map(output => output.value)]"""
    with (
        programs.new_page(page.context.browser) as second,
        programs.new_page(page.context.browser) as third,
    ):
        tabs = [page, second, third]
        for tab in tabs[1:]:
            open_cradle(tab, page.url)
        for name, value in (("Speed", 2), ("Bobs lifted", 2), ("Release angle", 70)):
            slide(second, name, value)
        programs.menu(second, "Collisions").select_option("elastic, e = 1")
        programs.menu(second, "Graph").select_option("no graph")
        for name in ("Arrows", "Predict first"):
            third.get_by_role("checkbox", name=name).check()
        page.locator("summary").click()
        page.get_by_label("Separating bobs collide too").check()
        for tab in tabs:
            tab.wait_for_function(
                "() => glowObjs.some(o => o?.constructor.name === 'arrow' && o.visible)"
            )
            wait_until(lambda tab=tab: values(tab) == ["2.0x", "2 of 5", "70°"])
            programs.wait_for_moves(tab)
        pause(page)
        wait_until(lambda: lifts(page) == lifts(second) == lifts(third))
        settings = page.evaluate(controls)
        assert [tab.evaluate(controls) for tab in tabs] == [settings] * 3
        page.keyboard.press("Space")

        second.mouse.move(100, 100)
        second.mouse.down(button="right")
        second.mouse.move(160, 100, steps=3)
        second.mouse.up(button="right")
        # It is there as soon as the camera has moved
        second.get_by_role("button", name="Reset view").wait_for()
        page.evaluate("window.times = []; shows.now = () => times.push(parseFloat(state.motion.t))")
        third.reload()
        wait_for_cradle(third)
        for tab in tabs:
            programs.wait_for_moves(tab)
        wait_until(lambda: third.evaluate(controls) == settings)
        assert not third.locator(".plot").is_visible()
        assert [tab.get_by_role("button", name="Reset view").is_visible() for tab in tabs] == [
            False,
            True,
            False,
        ]
        second.close()
        for tab in (page, third):
            programs.wait_for_moves(tab)
        times = page.evaluate("times")
        assert times == sorted(times)
        third.close()
        page.close()
        assert programs.end(started) == programs.QUIETLY


def test_the_ended_program_shows_how_to_start_it_again(page, started):
    started.send_signal(signal.SIGINT)
    assert programs.end(started) == programs.QUIETLY
    page.get_by_text("The program has ended.").wait_for()
    assert (
        page.locator(".notice code")
        .inner_text()
        .endswith(" src/visualize_cradle_run.py --angle 45")
    )
    # It is pale
    assert float(page.locator(".canvas").evaluate("e => getComputedStyle(e).opacity")) < 0.5
    assert programs.violations(page) == {}


def test_hostile_texts_are_shown_as_texts(page, program):
    evil = "<s><img src onerror>"  # a text that makes elements, where it is HTML
    file = program.parents[1] / "support" / "experiments" / "single" / "2_two_bobs.txt"
    # In its name, its question, its answers and its explanation
    text = file.read_text().replace("Two bobs", evil)
    for name in (file.name, "1_one_bob.txt"):
        file.with_name(name).write_text(text)
    with programs.running(program, folder=program.parents[1]) as process:
        open_cradle(page, programs.first_lines(process))
        page.locator("ul.failed").get_by_text(
            f"'{evil}' is the name of another experiment"
        ).wait_for()
        page.get_by_role("checkbox", name="Predict first").check()
        programs.menu(page, "Experiment").select_option(evil)
        question = page.locator(".question")
        for words in (f"{evil} come in.", f"C\u2002{evil}, as far as the two"):
            question.get_by_text(words).wait_for()
        page.keyboard.press("a")
        question.get_by_text(
            f"What happened: C, {evil}, as far as the two. {evil} came in at"
        ).wait_for()
        (program.parents[1] / "newton_cradle_pends.csv").write_text(
            FIVE_CSV.replace("red", evil, 1)
        )
        page.locator(".error").get_by_text(f"found '{evil}'").wait_for()
        assert page.locator("s, [onerror]").count() == 0


def test_back_shows_the_cradle_and_a_page_that_the_browser_keeps_leaves_it_and_comes_back(
    page, started
):
    """Chromium keeps no page here; these two events are all that a kept page gets."""
    address = page.url
    page.goto("about:blank")
    page.go_back()
    wait_for_cradle(page)
    assert page.url == address
    page.evaluate("window.isKept = true")
    programs.wait_for_moves(page)
    for event in ("pagehide", "pageshow"):
        page.evaluate(f"dispatchEvent(new PageTransitionEvent('{event}', {{persisted: true}}))")
    programs.wait_for_moves(page)
    page.evaluate("dispatchEvent(new PageTransitionEvent('pagehide', {persisted: true}))")
    assert page.evaluate("isKept")
    assert programs.end(started) == programs.QUIETLY


# The time on the wall (s) minus the simulated one, at each change of the readout in a second; and
# when it was read.
LATENESS = """async () => {
    const text = () => document.querySelector(".readout").innerText, late = [], start = performance.now();
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

    A busy machine brings a reading to the page late, and none early: the promptest one of each
    second counts. Seconds in which the program reports that the machine was too busy (0.6x real
    time) do not count.
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
