"""The controls of the page: keys, mouse, touch and text reach the program, and it answers."""

import re
from itertools import pairwise

import pages
import pytest
from pages import (
    bob_angles,
    button,
    menu,
    pause,
    pixel,
    press,
    readout,
    slide,
    slider_texts,
    tick,
    violations,
    wait_for_angles,
    wait_for_rest,
    wait_for_time,
)
from programs import wait_until
from shared_page import ASK, is_whole, wait_for_text
from whole_cradles import FIVE_CSV, GOOD


def test_keys_control_the_cradle_and_do_not_scroll_the_page(shared):
    shared.locator("h1").click()  # no control has the keys
    shared.keyboard.press("Space")
    button(shared, "Run").wait_for()
    shared.keyboard.press("R")
    wait_for_angles(shared, -45, 0, 0, 0, 0)
    shared.set_viewport_size({"width": 1000, "height": 300})  # so that the panel can scroll
    shared.keyboard.press("ArrowRight")
    wait_for_time(shared)
    for key in ("F1", "x", "2", "Meta+h"):
        shared.keyboard.press(key)
    shared.keyboard.press("Space")
    button(shared, "Pause").wait_for()
    panel = shared.locator(".panel")
    assert panel.evaluate("e => [scrollY, e.scrollTop]") == [0, 0]
    assert panel.evaluate("e => e.scrollHeight > e.clientHeight + 100")  # it could have scrolled
    assert slider_texts(shared, "lifted") == ["1 of 5"]
    assert not shared.evaluate("state.controls.slow_hits.value")
    shared.evaluate(ASK)
    shared.keyboard.press("b")
    wait_for_text(shared, "You said: B")


def test_a_control_has_its_own_keys_if_you_reach_it_by_keys(shared):
    slider = shared.get_by_role("slider", name="Bobs lifted")
    slider.press("ArrowRight")  # lifts one bob more
    wait_until(lambda: slider.get_attribute("aria-valuetext") == "2 of 5")
    button(shared, "Pause").press("Space")  # once, not twice
    wait_for_rest(shared)


def test_after_a_click_on_a_control_the_keys_are_the_pages(shared):
    tick(shared, "Measure")
    shared.keyboard.press("Space")
    wait_for_rest(shared)
    assert shared.get_by_role("checkbox", name="Measure").is_checked()
    menu(shared, "Graph").select_option("Momenta")
    shared.keyboard.press("Space")
    button(shared, "Pause").wait_for()


def test_the_graph_has_even_ticks_and_a_choice(shared):
    plot = shared.locator(".plot")
    ticks = shared.locator(".yAxis .tickLabel")

    def numbers():
        return sorted(map(float, ticks.all_inner_texts()))

    plot.get_by_text("potential").wait_for()
    wait_until(lambda: numbers()[:1] == [0])  # %
    menu(shared, "Graph").select_option("Angles theta")
    plot.get_by_text("potential").wait_for(state="detached")
    wait_until(lambda: ticks.count() > 2)
    steps = [after - before for before, after in pairwise(numbers())]
    assert steps == pytest.approx([steps[0]] * len(steps))  # no tick is rounded
    assert numbers()[0] <= -40  # degrees: the first bob was released at -45
    menu(shared, "Graph").select_option("no graph")
    plot.wait_for(state="hidden")


# The values of all controls.
SETTINGS = """() => [
    find("select, input:not([type=checkbox])").map(control => control.value),
    find("input[type=checkbox]").map(box => box.checked),
    find("output").map(output => output.value),
]"""


def test_two_tabs_show_one_cradle_with_the_settings_of_both_and_each_has_its_camera(shared):
    """Also after a reload, and the cradle swings on meanwhile."""
    with pages.new_page(shared.context.browser) as second:
        pages.open_cradle(second, shared.url)
        slide(second, "Speed", 2)
        slide(second, "Release angle", 70)
        menu(second, "Graph").select_option("no graph")
        tick(shared, "Arrows")
        for tab in (shared, second):
            tab.wait_for_function("() => glowObjs.some(o => kindOf(o) === 'arrow' && o.visible)")
            sliders = tab, "speed", "release_angle"
            wait_until(lambda names=sliders: slider_texts(*names) == ["2.0x", "70°"])
        second.mouse.move(100, 100)
        second.mouse.down(button="right")
        second.mouse.move(160, 100, steps=3)
        second.mouse.up(button="right")
        button(second, "Reset view").wait_for()  # the camera has moved
        assert not button(shared, "Reset view").is_visible()
        time = readout(shared, "t")
        second.reload()
        pages.wait_for_cradle(second)
        pages.wait_for_moves(second)
        assert readout(second, "t") > time
        assert not button(second, "Reset view").is_visible()
        pause(shared)
        wait_until(lambda: second.evaluate(SETTINGS) == shared.evaluate(SETTINGS))
        wait_until(lambda: bob_angles(second) == bob_angles(shared))


HAS_CURSOR = """cursor =>
    getComputedStyle(document.querySelector('.canvas canvas:last-of-type')).cursor === cursor"""
IS_SHARP = """() => {
    const { width, height, clientWidth, clientHeight } = one(".canvas canvas");
    const [number] = scene().__overlay_objects.objects;
    return width === 2 * clientWidth && height === 2 * clientHeight && number.height === 28;
}"""


def test_the_cursor_shows_that_a_bob_can_be_grabbed_and_it_is_let_go_outside_of_the_canvas(shared):
    """In a second tab, which is then moved to a display with twice the pixels.

    The canvas has them, too.
    """
    with pages.new_page(shared.context.browser) as sharp:
        pages.open_cradle(sharp, shared.url)
        display = {"width": 1000, "height": 700, "deviceScaleFactor": 2, "mobile": False}
        sharp.context.new_cdp_session(sharp).send("Emulation.setDeviceMetricsOverride", display)
        sharp.wait_for_function(IS_SHARP)
        slide(sharp, "Bobs lifted", 0)
        wait_for_angles(sharp, 0, 0, 0, 0, 0)
        sharp.mouse.move(*pixel(sharp, 0, 0))
        sharp.wait_for_function(HAS_CURSOR, arg="grab")
        pages.drag(sharp, 0, -15)
        wait_until(lambda: bob_angles(sharp)[0] == pytest.approx(-15, abs=1))
        sharp.wait_for_function(HAS_CURSOR, arg="grabbing")
        sharp.mouse.move(20, 230, steps=3)  # below the canvas
        wait_until(lambda: -32 < bob_angles(sharp)[0] < -20)
        sharp.mouse.up()
        wait_until(lambda: bob_angles(sharp)[4] > 15)
        sharp.mouse.move(20, 20)
        sharp.wait_for_function(HAS_CURSOR, arg="auto")


# --- the CSV, experiments and the table ------------------------------------------------------


def test_a_mistake_in_the_csv_is_shown_and_stays_in_view_until_it_is_corrected(shared, file):
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error").first
    error.get_by_text(f"{file}, line 7, column mass: found '-1', allowed is ").wait_for()
    shared.set_viewport_size({"width": 1000, "height": 300})
    shared.locator(".programmers summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


# How many arrows, boxes and spheres are visible.
SHAPES = """() => ["arrow", "box", "sphere"].map(
    kind => glowObjs.filter(o => o?.constructor.name === kind && o.visible).length)"""
# What one can press.
CONTROLS = """() => find("button, input, select, summary")
    .filter(element => element.checkVisibility()).map(element => element.innerText)
    .filter(text => text)"""


def test_a_lesson_in_present_by_touch_alone_predict_see_and_explain(shared):
    """Only the first experiment comes with a key."""
    question = shared.locator(".question")
    shared.keyboard.press("n")
    for name in ("Say what you saw", "Predict first"):
        tick(shared, name)
    question.get_by_text("One bob comes in.").wait_for()
    shared.locator(".choose").tap()
    button(shared, "Two bobs").tap()
    question.get_by_text("Two bobs come in.").wait_for()
    button(shared, "Present").tap()
    texts = shared.evaluate("state.question.answers")
    answers = [f"{letter}\u2002{text}" for letter, text in zip("ABCD", texts, strict=True)]
    ways = ["‹", "›", "Two bobs\nExperiments ▾"]
    only = [*answers, *ways, "×"]
    wait_until(lambda: sorted(shared.evaluate(CONTROLS)) == sorted(only))
    assert violations(shared) == {}
    wait_for_rest(shared)
    button(shared, answers[0]).tap()
    question.get_by_text("What did you see?").wait_for()
    assert not shared.locator(".readout").is_visible()
    assert shared.evaluate(SHAPES) == [0, 6, 5 + 5]  # with the ghosts of A
    button(shared, "Again").tap()
    question.get_by_text("What did you see?").wait_for()
    button(shared, answers[2]).tap()
    question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
    assert question.get_by_text("You said: A, One bob, twice as fast.").is_visible()
    assert question.get_by_text("You saw: C.").is_visible()
    shared.get_by_label("Arrows").tap()
    shared.get_by_label("Slow hits").tap()
    shared.locator(".hit-part").get_by_text("m/s").first.wait_for()
    # Of the velocities of the two bobs that move, and of the changes of momentum
    wait_until(lambda: shared.evaluate(SHAPES)[0] == 4)
    shared.get_by_label("Graph", exact=True).and_(shared.get_by_role("checkbox")).tap()
    shared.locator(".plot").get_by_text("potential").wait_for()
    button(shared, "Pause").tap()
    shared.get_by_text("Paused", exact=True).wait_for()
    button(shared, "3").tap()
    wait_for_angles(shared, -45, -45, -45, 0, 0)
    button(shared, "Next experiment").tap()
    question.get_by_text("Three bobs come in, and two hang.").wait_for()
    button(shared, "End the presentation").tap()
    button(shared, "Previous experiment").tap()
    question.get_by_text("Two bobs come in.").wait_for()


def test_all_sheets_are_printed_at_once_two_on_a_page(shared):
    """Nothing else is on the paper."""
    shared.evaluate("window.print = () => {}")
    shared.locator(".choose").click()
    press(shared, "Print the sheets of all experiments")
    shared.emulate_media(media="print")
    sheets = shared.locator("article")
    names = shared.evaluate("Object.keys(state.sheets)")
    assert sheets.locator("h2").all_inner_texts() == names
    for line in ("Name", "Date", "I predict", "I saw", "half swings in"):
        assert sheets.first.get_by_text(line).is_visible()
    assert sheets.last.get_by_text("My value").is_visible()
    assert sheets.nth(1).locator("circle").count() == 5
    assert not shared.locator(".readout").is_visible()
    pages_of_paper = shared.pdf(format="A4").count(b"/Type /Page\n")
    assert pages_of_paper == (len(names) + 1) // 2
    shared.evaluate("dispatchEvent(new Event('afterprint'))")
    assert sheets.count() == 0
    shared.emulate_media(media="screen")


def test_a_value_for_a_hidden_mass_is_checked(shared):
    pages.choose(shared, "An unknown mass")
    value = shared.get_by_label("mass of bob 1 =")
    value.fill("2.7")
    press(shared, "Check")
    wait_for_text(shared, "Bob 2 gets the momentum that bob 1 loses")
    assert violations(shared) == {}


def test_the_table_shows_theta_and_takes_a_mass(shared):
    mass = shared.get_by_label("mass of pendulum 2", exact=True)
    shared.locator(".programmers summary").click()
    pause(shared)
    press(shared, "Restart")
    theta = shared.locator(".pendula .now").first
    wait_until(lambda: theta.inner_text() == "-0.785398")
    mass.fill("-3")
    mass.press("Tab")
    message = shared.get_by_text("mass: allowed is a number from ")
    message.wait_for()
    assert mass.get_attribute("aria-invalid") == "true"
    # Where Tab leads
    shared.wait_for_function("() => document.activeElement.ariaLabel === 'e of pendulum 2'")
    assert violations(shared) == {}
    mass.fill("2.5")
    mass.press("Enter")
    message.wait_for(state="detached")
    assert mass.input_value() == "2.5"


# Let the page hear of a hit with this speed (m/s); return the largest sample that follows.
HIT = """async speed => {
    state.sound = { speed };
    update("sound");
    let most = 0;
    for (let look = 0; look < 20; look++) { // a single look can be too early or too late
        await new Promise(resolve => setTimeout(resolve, 50));
        most = Math.max(most, peak());
    }
    return most;
}"""


def test_a_faster_hit_is_louder_and_only_if_you_ask_for_sound(shared):
    wait_until(lambda: bob_angles(shared)[4] > 15)  # there was a hit
    assert shared.evaluate("peak()") is None
    shared.evaluate("one('#sound').checked = true")  # as Firefox does after F5
    shared.keyboard.press("v")
    shared.wait_for_function("() => peak() > 0.1")  # a hit of the cradle
    pause(shared)
    peaks = []
    for speed in (0.1, 2, 100):
        shared.wait_for_function("() => peak() === 0")
        peaks.append(shared.evaluate(HIT, speed))
    slow, fast, fastest = peaks
    assert 0 < slow < 0.8 * fast
    assert fastest < 1.2 * fast
    shared.get_by_role("checkbox", name="Sound").uncheck()
    shared.wait_for_function("() => audio.state === 'suspended'")


def test_the_canvas_says_what_it_shows_and_the_keys_are_listed(shared):
    words = re.compile("Newton's cradle: t = .* s, energy .* %, bob . at .* degrees (left|right)")
    shared.get_by_role("img", name=words).wait_for()
    press(shared, "Keys")
    wait_for_text(shared, "answer a question")
    assert violations(shared) == {}
