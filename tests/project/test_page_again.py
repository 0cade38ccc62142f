"""Pages of their own, in real browsers: the first one, a reload, a second tab, no WebGL, and the end of the program."""

import shlex
import signal
import subprocess
import time
from collections import Counter, deque

import programs
import pytest
from programs import lifts, open_cradle, pause, press, slide, values, wait_for_cradle, wait_until
from whole_cradles import GOOD, HEADER

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
    page.wait_for_function(f"() => ({programs.BOBS})()[4][0] > {-0.1 + 5 / 4 * R_PARAM}")  # the last bob has been hit
    picture = picture_of(page)
    page.wait_for_function(f"() => ({programs.BOBS})()[0][0] < {-0.1 - R_PARAM / 4}")  # and then the first one again
    assert picture_of(page) != picture

    pause(page)
    slide(page, programs.LIFTED, 0.01)
    programs.wait_for_lifts(page, 0, 0, 0, 0, 0)
    page.mouse.move(*programs.pixel(page, 3, 0))
    page.mouse.down()
    for theta in (20, 40):
        page.mouse.move(*programs.pixel(page, 3, theta), steps=3)
    wait_until(lambda: lifts(page)[3] == pytest.approx(40, abs=0.5) and 38 < lifts(page)[4] < 50)  # it was in the way
    assert lifts(page)[:3] == pytest.approx([0, 0, 0])
    page.mouse.up()
    page.keyboard.press("Space")
    wait_until(lambda: "4-3-2-1" in page.locator(".impacts").inner_text())
    page.close()
    assert programs.end(started) == programs.QUIETLY


# Before the page's own scripts: bobsAtFirst is how many bobs the first picture has; one waits for its texture.
FIRST_PICTURE = """{
    const gl = WebGL2RenderingContext.prototype, draw = gl.drawElements, isBob = o => o?.constructor.name === "sphere";
    gl.drawElements = function (...how) {
        window.bobsAtFirst ??= glowObjs.filter(o => isBob(o) && o.visible && o.ready).length;
        draw.apply(this, how);
    };
}"""


def test_the_first_picture_has_all_bobs_with_their_textures(page, program):
    page.add_init_script(FIRST_PICTURE)
    page.route("**/*.jpg", lambda route: (time.sleep(0.3), route.continue_()))
    with programs.running(program) as process:
        page.goto(programs.first_lines(process))
        wait_until(lambda: page.evaluate("window.bobsAtFirst") == 5)


def picture_of(page):
    """Return a picture of the canvas (PNG)."""
    programs.draw(page, True)
    picture = page.locator("canvas").first.screenshot()
    programs.draw(page, False)
    return picture


def test_a_browser_without_webgl_is_offered_the_terminal_cradle(driver, page, program):
    folder = program.parents[1]
    with programs.running(program, folder=folder) as process:
        address = programs.first_lines(process)
        arguments = ["--no-sandbox", "--disable-3d-apis"]
        with driver.chromium.launch(executable_path=programs.CHROMIUM, args=arguments) as browser:
            blind = browser.new_page()
            blind.set_default_timeout(programs.SECONDS * 1000)
            blind.goto(address, wait_until="commit")
            words = blind.locator("main").inner_text().splitlines()
            assert "This browser cannot draw the cradle: WebGL 2 is missing or switched off." in words
            assert blind.title() == "Newton's cradle"
        done = subprocess.run([*shlex.split(words[-1]), "--seconds", "0.1"], cwd=folder, capture_output=True, text=True)
        assert "t = 0.10 s" in done.stdout
        open_cradle(page, address)


WIDGETS = """[$(".ui-slider").toArray().map(slider => $(slider).slider("value")),
              $("select").toArray().map(menu => menu.value),
              $("input[type=checkbox]").toArray().map(box => box.checked), $("button").text()]"""


def test_a_reload_keeps_the_settings_and_the_ended_program_shows_how_to_start_it(page, started):
    """Also the settings that you have chosen with the mouse: VPython itself never sends them to a page."""
    for slider, part in ((programs.SPEED, 0.99), (programs.LIFTED, 0.38), (programs.ANGLE, 0.4)):
        slide(page, slider, part)
    wait_until(lambda: values(page)[:2] == ["2.0x", "2 of 5"] and values(page)[programs.ANGLE] != "45°")
    programs.menu(page, "Collisions").select_option("perfectly inelastic, e = 0")
    programs.menu(page, "Graph").select_option("no graph")
    page.get_by_label(programs.SEPARATING).evaluate("box => box.click()")
    for name in ("Arrows", "Slow hits"):
        page.get_by_role("checkbox", name=name).check()
    wait_until(lambda: not page.locator(".glowscript-graph").is_visible())
    wait_until(lambda: programs.readout(page, "t") > 0.2)
    pause(page)
    texts, widgets = values(page), page.evaluate(WIDGETS)

    page.reload()
    wait_for_cradle(page)
    wait_until(lambda: programs.readout(page, "t") == 0 and page.evaluate(WIDGETS) == widgets)
    assert values(page) == texts
    angle = float(texts[programs.ANGLE].rstrip("°"))
    assert lifts(page) == pytest.approx([-angle, -angle, 0, 0, 0], abs=0.01)
    programs.wait_for_rest(page)
    assert not page.locator(".glowscript-graph").is_visible()

    started.send_signal(signal.SIGINT)
    assert programs.end(started) == programs.QUIETLY
    page.get_by_text("The program has ended.").wait_for()
    assert page.locator(".notice").inner_text().rstrip().endswith(" src/visualize_cradle_run.py --angle 45")
    opacity = page.evaluate("getComputedStyle(document.querySelector('.glowscript')).opacity")
    assert float(opacity) < 0.5  # the canvas and the widgets are pale


def test_back_shows_the_cradle_and_a_page_that_the_browser_keeps_leaves_it(page, started):
    """Chromium keeps no page here; these two events are all that a kept page gets."""
    address = page.url
    page.goto("about:blank")
    page.go_back()
    wait_for_cradle(page)
    assert page.url == address
    page.evaluate("window.isKept = true")
    page.evaluate("dispatchEvent(new PageTransitionEvent('pageshow', {persisted: true}))")
    page.wait_for_function("() => !window.isKept")  # it is loaded again
    wait_for_cradle(page)
    programs.wait_for_moves(page)
    page.evaluate("dispatchEvent(new PageTransitionEvent('pagehide', {persisted: true}))")
    assert programs.end(started) == programs.QUIETLY


def test_the_tab_that_was_loaded_last_shows_the_cradle(page, started):
    elsewhere = "The cradle is open in another tab."
    with programs.new_page(page.context.browser) as second:
        open_cradle(second, page.url)
        page.get_by_text(elsewhere).wait_for()
        programs.wait_for_moves(second)
        assert page.evaluate("glowObjs[0].visible") is False  # an old cradle that is drawn slows the new one down
        with page.expect_navigation():
            press(page, "Use it here")
        wait_for_cradle(page)
        second.get_by_text(elsewhere).wait_for()
        second.close()
        programs.wait_for_moves(page)
        page.close()
        assert programs.end(started) == programs.QUIETLY


# The time on the wall (s) minus the simulated one, at each change of the readout in a second; and when it was read.
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

    A busy machine brings a reading to the page late, and none early: the promptest one of each second counts. Seconds
    in which the program reports that the machine was too busy (0.6x real time) do not count.
    """
    (program.parents[1] / "newton_cradle_pends.csv").write_text(HEADER + GOOD)
    readings = deque(maxlen=8)

    def has_kept_step():
        readings.append(page.evaluate(LATENESS))
        (start, before), (now, after) = readings[0], readings[-1]
        return now - start > 6 and abs(after - before) < 0.05

    with programs.running(program) as process:
        open_cradle(page, programs.first_lines(process), bobs=1)
        wait_until(has_kept_step, 3 * programs.SECONDS)  # a busy machine seldom has seven seconds without a stall
