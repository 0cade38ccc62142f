"""The page to play with, in Chromium: what each control does, read from the readout and from where the bobs are.

Keys and dragging, which browsers do each in their own way, are tested in Firefox too.
"""

import re
from contextlib import ExitStack
from itertools import pairwise
from math import atan2, cos, degrees, inf, radians, sin

import pytest
from programs import (
    BOBS,
    end,
    first_lines,
    in_both_browsers,
    MOVES,
    needs_vpython,
    open_cradle,
    pause,
    press,
    QUIETLY,
    readout,
    running,
    SECONDS,
    wait_until,
)
from whole_cradles import FIVE_CSV, GOOD, HEADER, PERIOD

from support.constants import R_PARAM
from support.playback.real_time import FRAME

pytestmark = needs_vpython

SPEED, LIFTED, ANGLE = range(3)  # the sliders, in their order
SEPARATING, GRAPH = range(2)  # the checkboxes

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

# What the readout says whenever it changes, and the time on the wall (s) at that moment, for a second.
READINGS = """async () => {
    const says = () => document.querySelector(".readout").innerText;
    const readings = [], start = performance.now();
    for (let before = says(); performance.now() - start < 1000;) {
        await new Promise(requestAnimationFrame);
        if (says() !== before) readings.push([before = says(), performance.now() / 1000]);
    }
    return readings;
}"""


@pytest.fixture
def play(page, program):
    """A function that starts the program with these arguments, and returns the process once the page shows it."""
    with ExitStack() as stack:

        def play(*arguments):
            angle = () if "--angle" in arguments else ("--angle", "45")
            process = stack.enter_context(running(program, *arguments, *angle))
            open_cradle(page, first_lines(process), csv_of(program).read_text().count("\n") - 1)
            return process

        yield play


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


def slide(page, slider, part):
    """Click into a slider, this part of its length from the left."""
    box = page.locator(".ui-slider").nth(slider).bounding_box()
    page.mouse.click(box["x"] + part * box["width"], box["y"] + box["height"] / 2)


def from_start(page):
    """Let the bobs go anew, and return when the time is counted from there."""
    pause(page)
    press(page, "Restart")
    wait_until(lambda: readout(page, "t") == 0)
    press(page, "Run")


def values(page):
    """Return what stands behind the sliders."""
    return page.locator(".value").all_inner_texts()


def pixel(page, bob, theta):
    """Return where this bob's centre is seen if its cord is at theta (degrees)."""
    x, y = -0.1 + R_PARAM / 4 * bob + R_PARAM * sin(radians(theta)), R_PARAM / 5 - R_PARAM * cos(radians(theta))
    return page.evaluate(PIXEL, [x, y])


# --- buttons and keys ------------------------------------------------------------------------------------------------


def test_pause_stops_and_run_goes_on(page, play):
    play()
    pause(page)
    paused = readout(page, "t")
    press(page, "Run")
    wait_until(lambda: readout(page, "t") > paused + 0.2)
    assert page.evaluate(MOVES) > 0


def test_step_moves_once_while_paused(page, play):
    play()
    assert page.get_by_role("button", name="Step").is_disabled()
    pause(page)
    t, bobs = readout(page, "t"), page.evaluate(BOBS)
    press(page, "Step")
    wait_until(lambda: page.evaluate(BOBS) != bobs and readout(page, "t") != t)
    assert page.evaluate(MOVES) == 0
    assert readout(page, "t") - t == pytest.approx(FRAME, abs=0.01)


def test_restart_begins_anew(page, play):
    play()
    wait_until(lambda: readout(page, "t") > 0.3)
    pause(page)
    press(page, "Restart")
    wait_for_lifts(page, -45, 0, 0, 0, 0)
    wait_until(lambda: readout(page, "t") == 0)
    assert page.locator(".impacts").inner_text().strip() == "Impacts"


@in_both_browsers
def test_keys(page, play):
    """Also right after a slider or a button was used with the mouse; and they do not scroll the page."""
    play()
    page.set_viewport_size({"width": 1000, "height": 400})  # so that there would be something to scroll
    slide(page, SPEED, 0.5)
    page.keyboard.press("Space")
    page.get_by_role("button", name="Run").wait_for()
    page.keyboard.press("r")
    wait_for_lifts(page, -45, 0, 0, 0, 0)
    page.keyboard.press("3")
    wait_for_lifts(page, -45, -45, -45, 0, 0)
    page.keyboard.press("ArrowRight")
    wait_until(lambda: readout(page, "t") > 0)
    assert page.evaluate("scrollY") == 0
    press(page, "Run")
    scrolled = page.evaluate("scrollY")  # in Firefox a little, by the test's click
    page.keyboard.press("Space")
    page.get_by_role("button", name="Run").wait_for()
    assert page.evaluate("scrollY") == scrolled
    assert page.evaluate("document.documentElement.scrollHeight > innerHeight + 100")


def test_keys_that_mean_nothing_are_no_news(page, play):
    """VPython prints a traceback for those that it has no name for."""
    process = play()
    for key in ("ContextMenu", "AudioVolumeUp", "Meta", "AltGraph", "F1", "x", "Control"):
        page.keyboard.press(key)
    for code in (0, 173, 229):  # as of a keyboard for another language
        page.evaluate(f"document.body.dispatchEvent(new KeyboardEvent('keydown', {{keyCode: {code}, bubbles: true}}))")
    page.keyboard.press("Meta+2")  # another tab, on a Mac
    page.keyboard.press("Space")  # which comes after them
    page.get_by_role("button", name="Run").wait_for()
    assert values(page)[LIFTED] == "1 of 5"
    page.close()
    assert end(process) == QUIETLY


def test_a_widget_reached_by_keyboard_keeps_its_keys(page, play):
    play()
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.innerText") == "Pause"
    page.keyboard.press("Space")  # once, not twice
    page.get_by_role("button", name="Run").wait_for()
    assert page.evaluate(MOVES) == 0
    while "ui-slider-handle" not in page.evaluate("document.activeElement.className"):
        page.keyboard.press("Tab")
    page.keyboard.press("ArrowRight")
    wait_until(lambda: values(page)[SPEED] == "1.1x")
    page.keyboard.press("ArrowRight")
    wait_until(lambda: values(page)[SPEED] == "1.2x")


# --- settings --------------------------------------------------------------------------------------------------------


def test_angle_lift_and_their_values(page, play):
    play()
    pause(page)
    assert values(page) == ["1.0x", "1 of 5", "45°"]
    slide(page, ANGLE, 0.5)  # the first click that this slider gets, of which VPython says nothing by itself
    wait_for_lifts(page, -90, 0, 0, 0, 0)
    slide(page, LIFTED, 0.38)
    wait_for_lifts(page, -90, -90, 0, 0, 0)
    wait_until(lambda: values(page) == ["1.0x", "2 of 5", "90°"])
    wait_until(lambda: page.evaluate("$('.ui-slider').eq(1).slider('value')") == pytest.approx(2 / 5))


def test_a_slider_can_be_put_back_to_where_it_was_before_a_key_was_pressed(page, play):
    """VPython would say nothing of it, as it said the same the last time."""
    play()
    for _ in range(2):
        slide(page, LIFTED, 0.99)
        wait_until(lambda: values(page)[LIFTED] == "5 of 5")
        page.keyboard.press("1")
        wait_until(lambda: values(page)[LIFTED] == "1 of 5")


def test_the_view_is_turned_and_zoomed_with_the_mouse(page, play):
    play()
    view = "[glowObjs[0].forward.x, glowObjs[0].range]"
    turned, zoomed = page.evaluate(view)
    page.mouse.move(50, 50)
    page.mouse.down(button="right")
    page.mouse.move(120, 60, steps=5)
    page.mouse.up(button="right")
    wait_until(lambda: page.evaluate(view)[0] != turned)
    page.mouse.wheel(0, -300)
    wait_until(lambda: page.evaluate(view)[1] < 0.97 * zoomed)


def test_collisions(page, play):
    """Elastic, the first train leaves four of five bobs behind; inelastic, all five go on together."""
    play()
    slide(page, SPEED, 0.25)  # so that there is time to look
    from_start(page)
    wait_until(lambda: lifts(page)[4] > 20)
    assert max(map(abs, lifts(page)[:4])) < 2
    slide(page, SPEED, 0.99)
    page.locator("select").select_option("inelastic, e = 0")
    from_start(page)
    wait_until(lambda: readout(page, "t") > 0.45 * PERIOD)
    together = lifts(page)
    assert max(together) - min(together) < 2
    assert readout(page, "energy") == pytest.approx(20, abs=0.5)  # five times the mass, a fifth of the speed


def test_separating_bobs_collide_too(page, play):
    """Of e = 0.9 little is left then: after one swing 24 % of the energy instead of 48 %."""
    play("--e", "0.9")
    page.get_by_role("checkbox").nth(SEPARATING).check()
    from_start(page)
    assert energy_after(page, 1.1 * PERIOD) < 26
    page.get_by_role("checkbox").nth(SEPARATING).uncheck()
    from_start(page)
    assert energy_after(page, 1.1 * PERIOD) > 29


def energy_after(page, seconds):
    """Return the energy (%) at the first reading after this simulated time."""
    readings = []

    def take():
        text = page.locator(".readout").inner_text()
        readings.append([float(number) for number in re.findall(r"(?:t =|energy) +([0-9.]+)", text)])
        return readings[-1][0] > seconds

    wait_until(take)
    return readings[-1][1]


@pytest.mark.clock
@pytest.mark.parametrize(("part", "speed", "span"), [(0.01, 0.1, 30), (0.475, 1.0, 10), (0.99, 2.0, 10)])
def test_simulated_time_keeps_step_with_the_wall(page, play, program, part, speed, span):
    """Within 0.5 % over a span (s), with one bob: its ticks take little time.

    A busy machine brings a reading to the page late, and none early. So the promptest one of three seconds is held
    against that of the three seconds that are a span later; at speed 0.1 a reading is true to 0.1 s only. Where the
    machine was so busy that the program has dropped time, as it says (x0.6), the test goes on until it finds a span.
    """
    csv_of(program).write_text(HEADER + GOOD)
    play()
    slide(page, SPEED, part)
    wait_until(lambda: values(page)[SPEED] == f"{speed:.1f}x")
    readings = []

    def kept_step():
        """Take the readings of one more second, and return whether the last ones are as they must be."""
        readings.extend(page.evaluate(READINGS))
        end = readings[-1][1]
        last = [(text, wall) for text, wall in readings if wall > end - span - 3]
        if end - readings[0][1] < span + 3 or any("x0." in text for text, _ in last):
            return False
        late = [(wall, wall - float(re.search("t = ([0-9.]+) s", text)[1]) / speed) for text, wall in last]
        before = min((by for at, by in late if at < end - span), default=inf)
        after = min(by for at, by in late if at > end - 3)
        return abs(after - before) < 0.005 * span

    wait_until(kept_step, 4 * SECONDS)


def test_the_readout_and_the_strip_are_there_to_be_read(page, play):
    play()
    from_start(page)
    wait_until(lambda: "s  " in page.locator(".impacts").inner_text())
    assert re.search(r"^t = \d\.\d\d s  1-2", page.locator(".impacts").inner_text(), re.MULTILINE)
    pause(page)
    both = readout(page, "kinetic") + readout(page, "potential")
    assert both == pytest.approx(readout(page, "energy"), abs=0.011) == pytest.approx(100, abs=0.1)


def test_the_graph_can_be_hidden(page, play):
    play()
    graph, box = page.locator(".glowscript-graph"), page.get_by_role("checkbox").nth(GRAPH)
    graph.wait_for(state="visible")
    assert graph.locator(".legend").inner_text().split() == ["kinetic", "potential", "total"]
    wait_until(lambda: graph.locator(".yAxis .tickLabel").count() > 2)
    ticks = [float(tick) for tick in graph.locator(".yAxis .tickLabel").all_inner_texts()]
    steps = [b - a for a, b in pairwise(sorted(ticks))]
    assert steps == pytest.approx([steps[0]] * len(steps))  # which VPython's own, rounded ones are not always
    box.uncheck()
    graph.wait_for(state="hidden")
    box.check()
    graph.wait_for(state="visible")


def test_the_options_are_where_the_controls_begin(page, play, program):
    play("--e", "0.5", "--mass", "2", "--angle", "60", "--lift", "2")
    pause(page)
    press(page, "Restart")
    wait_for_lifts(page, -60, -60, 0, 0, 0)
    assert values(page) == ["1.0x", "2 of 5", "60°"]
    assert page.locator("select").input_value() == "e = 0.5"
    assert csv_of(program).read_text() == FIVE_CSV


# --- mouse -----------------------------------------------------------------------------------------------------------


@in_both_browsers
@pytest.mark.parametrize("paused", [True, False])
def test_a_bob_is_dragged_along_its_arc_pushes_others_and_swings_on(page, play, paused):
    play("--lift", "0")
    if paused:
        pause(page)
    page.mouse.move(*pixel(page, 3, 0))
    page.mouse.down()
    page.mouse.move(*pixel(page, 3, 20), steps=3)
    page.mouse.move(*pixel(page, 3, 40), steps=3)
    wait_until(lambda: lifts(page)[3] == pytest.approx(40, abs=0.5))
    assert lifts(page)[:3] == pytest.approx([0, 0, 0])
    assert 38 < lifts(page)[4] < 50  # it was in the way
    page.mouse.up()
    if paused:
        press(page, "Run")
    wait_until(lambda: lifts(page)[3] < 30)
    wait_until(lambda: "4-3-2-1" in page.locator(".impacts").inner_text())


def test_a_bob_is_let_go_outside_of_the_canvas(page, play):
    play("--lift", "0")
    page.mouse.move(*pixel(page, 0, 0))
    page.mouse.down()
    page.mouse.move(*pixel(page, 0, -30), steps=3)
    wait_until(lambda: lifts(page)[0] == pytest.approx(-30, abs=0.5))
    page.mouse.move(20, 230, steps=3)  # on the panel
    wait_until(lambda: -28 < lifts(page)[0] < -20)
    page.mouse.up()
    wait_until(lambda: "1-2-3-4-5" in page.locator(".impacts").inner_text())


def test_a_resized_canvas_shows_the_whole_swing(page, play):
    play("--angle", "90")
    box = page.locator(".ui-resizable-se").bounding_box()
    page.mouse.move(box["x"] + 5, box["y"] + 5)
    page.mouse.down()
    page.mouse.move(box["x"] - 115, box["y"] - 15, steps=5)  # from wide to nearly square
    page.mouse.up()
    wait_until(lambda: page.evaluate("glowObjs[0].width") < 210)
    canvas = page.locator("canvas").first.bounding_box()

    def is_in_view():
        ends = [pixel(page, 0, -90), pixel(page, 4, 90)]
        return all(canvas["x"] < x < canvas["x"] + canvas["width"] for x, _ in ends)

    wait_until(is_in_view)


# --- data to take away -----------------------------------------------------------------------------------------------


def test_the_data_are_saved_and_the_page_says_where(page, program):
    folder = program.parent
    with running(program, folder=folder) as process:
        open_cradle(page, first_lines(process))
        wait_until(lambda: readout(page, "t") > 1)
        press(page, "Save data")
        saved = page.locator(".saved", has_text="rows are in")
        saved.wait_for()
        assert saved.inner_text().endswith(f" rows are in {folder / 'cradle_data_1.csv'}")
    times = [float(line.partition(",")[0]) for line in (folder / "cradle_data_1.csv").read_text().splitlines()[1:]]
    assert times == pytest.approx([0.01 * i for i in range(len(times))])
    assert times[-1] > 1


# --- live CSV --------------------------------------------------------------------------------------------------------


def test_an_edited_csv_shows_up_and_its_objects_are_used_again(page, play, program):
    play()
    shapes = "glowObjs.filter(o => o && o.constructor.name.match(/box|sphere|cylinder/)).length"
    seven = HEADER + GOOD * 5 + "3.0,1.0,0,0,white,wood\n" * 2
    counts = set()
    for _ in range(3):
        csv_of(program).write_text(seven)
        wait_until(lambda: len(page.evaluate(BOBS)) == 7 and values(page)[LIFTED] == "1 of 7")
        counts.add(page.evaluate(shapes))
        csv_of(program).write_text(FIVE_CSV)
        wait_until(lambda: len(page.evaluate(BOBS)) == 5)
        counts.add(page.evaluate(shapes))
    assert len(counts) == 1
    blue = FIVE_CSV.replace("red", "blue")  # on shapes that were another color before
    csv_of(program).write_text(blue)
    spheres = "glowObjs.filter(o => o && o.constructor.name === 'sphere' && o.visible)"
    colors = f"{spheres}.map(o => [o.color.x, o.color.y, o.color.z])"
    wait_until(lambda: page.evaluate(colors) == [[0, 0, 1]] * 5)


def test_a_broken_csv_shows_its_error_and_the_cradle_goes_on(page, play, program):
    process = play()
    csv_of(program).write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = page.locator(".error")
    error.wait_for(state="visible")
    line = f"{csv_of(program)}, line 7, column mass: found '-1', allowed is a number above 0 and up to 1e6 (kg)"
    assert error.inner_text() == line
    assert page.evaluate(MOVES) > 0
    csv_of(program).write_text(FIVE_CSV)
    error.wait_for(state="hidden")
    page.close()
    assert end(process) == QUIETLY
