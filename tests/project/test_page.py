"""The controls of the page, in Chromium."""

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
    wait_for_restart,
    wait_for_time,
)
from programs import wait_until
from shared_page import ASK, EDGES, is_whole, wait_for_text
from whole_cradles import FIVE_CSV, GOOD, HEADER


def test_keys_and_buttons_control_the_cradle_and_do_not_scroll_the_page(shared):
    slide(shared, "Speed", 1.1)
    wait_until(lambda: button(shared, "Step").is_disabled())
    shared.keyboard.press("Space")
    button(shared, "Run").wait_for()
    shared.keyboard.press("r")
    wait_for_angles(shared, -45, 0, 0, 0, 0)
    slide(shared, "Bobs lifted", 5)
    wait_for_angles(shared, -45, -45, -45, -45, -45)
    shared.keyboard.press("3")
    wait_for_angles(shared, -45, -45, -45, 0, 0)
    shared.set_viewport_size({"width": 1000, "height": 300})  # so that the panel can scroll
    shared.keyboard.press("ArrowRight")
    wait_for_time(shared)
    press(shared, "Restart")
    wait_for_restart(shared)
    press(shared, "Step")
    wait_for_time(shared)
    shared.keyboard.press("Space")
    button(shared, "Pause").wait_for()
    panel = shared.locator(".panel")
    assert panel.evaluate("e => [scrollY, e.scrollTop]") == [0, 0]
    assert panel.evaluate("e => e.scrollHeight > e.clientHeight + 100")  # it could have scrolled


# Press a key as on another keyboard.
PRESS = """([key, code]) => document.body.dispatchEvent(
    new KeyboardEvent('keydown', { key, code, bubbles: true }))"""


def test_what_you_type_counts_and_on_another_alphabet_the_place_of_the_key(shared):
    wait_for_time(shared)
    pause(shared)
    before = readout(shared, "t")
    for key in ("ContextMenu", "AudioVolumeUp", "Meta", "AltGraph", "F1", "x", "Control", "Meta+2"):
        shared.keyboard.press(key)
    for key in (("o", "KeyR"), ("Process", "KeyR"), ("Unidentified", ""), ("к", "")):
        shared.evaluate(PRESS, key)
    shared.keyboard.press("ArrowRight")
    wait_until(lambda: readout(shared, "t") > before)
    # None of the other keys has done anything
    texts = slider_texts(shared, "speed", "lifted", "release_angle")
    assert texts == ["1.0x", "1 of 5", "45°"]
    # On a Russian keyboard, and on one in Dvorak's order
    for key in (("к", "KeyR"), ("r", "KeyO")):
        shared.evaluate(PRESS, key)
        wait_for_restart(shared)
        shared.keyboard.press("ArrowRight")
        wait_for_time(shared)
    shared.evaluate(ASK)
    shared.keyboard.press("2")  # hands may be counted: no digit ends the question
    for key in (("и", ""), ("и", "KeyB")):
        shared.evaluate(PRESS, key)
    wait_for_text(shared, "You said: B")  # the first answer stays


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
    shared.locator(".details summary").click()
    menu(shared, "All graphs").select_option("Phase 5")
    shared.locator(".y").get_by_text("omega (degrees/s)").wait_for()
    shared.locator(".x").get_by_text("theta (degrees)").wait_for()
    assert menu(shared, "Graph").input_value() == "Phase 5"
    menu(shared, "Graph").select_option("no graph")
    plot.wait_for(state="hidden")


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
        pages.drag(sharp, 0, -30)
        wait_until(lambda: bob_angles(sharp)[0] == pytest.approx(-30, abs=1))
        sharp.wait_for_function(HAS_CURSOR, arg="grabbing")
        sharp.mouse.move(20, 230, steps=3)  # below the canvas
        wait_until(lambda: -32 < bob_angles(sharp)[0] < -20)
        sharp.mouse.up()
        wait_until(lambda: "1-2-3-4-5" in sharp.locator(".impacts").text_content())
        sharp.mouse.move(20, 20)
        sharp.wait_for_function(HAS_CURSOR, arg="auto")


# --- the CSV, experiments and the table ------------------------------------------------------


def test_an_edited_csv_shows_up_or_its_mistake(shared, file):
    file.write_text(HEADER + GOOD * 7)
    slider = shared.get_by_role("slider", name="Bobs lifted")
    wait_until(lambda: slider.evaluate("e => [e.value, e.max]") == ["1", "7"])
    pages.wait_for_cradle(shared, bobs=7)
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error").first
    error.get_by_text(f"{file}, line 7, column mass: found '-1', allowed is ").wait_for()
    shared.set_viewport_size({"width": 1000, "height": 300})
    shared.locator(".programmers summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


def test_a_slow_double_click_on_a_picture_chooses_no_answer(shared):
    """Here, the pictures are where an answer comes."""
    shared.set_viewport_size({"width": 1366, "height": 768})
    shared.add_style_tag(content="#gallery { margin-right: 0; margin-top: 3rem; }")
    shared.evaluate("set('ask_first', true)")
    pages.choose(shared, "Two against one")
    answers = shared.locator(".answers").evaluate(EDGES)
    pages.choose(shared, "My cradle")
    shared.locator(".question").wait_for(state="detached")
    shared.locator(".choose").click()
    left, top, right, bottom = button(shared, "Two against one").evaluate(EDGES)
    place = (left + right) / 2, (max(top, answers[1]) + min(bottom, answers[3])) / 2
    assert answers[0] < place[0] < answers[2]
    shared.mouse.click(*place)
    shared.locator(".choice").first.wait_for()
    shared.mouse.click(*place)
    shared.keyboard.press("c")
    wait_for_text(shared, "You said: C")


def test_hands_are_counted_by_clicks_and_by_typing_when_they_are_shown(shared):
    """The field keeps the keys. The picture of the question stays."""
    pages.choose(shared, "Two bobs")
    tick(shared, "Predict first")
    hands = shared.get_by_label("Hands for B")
    shared.locator(".choice").first.wait_for()
    assert not hands.is_visible()
    question = shared.locator(".question")
    question.evaluate("element => element.isSame = true")
    press(shared, "Count hands")
    button(shared, "One hand more for B").press("Space")
    shared.keyboard.press("Space")  # the button still has the keys
    wait_until(lambda: hands.input_value() == "2")
    button(shared, "One hand fewer for B").click()
    wait_until(lambda: hands.input_value() == "1")
    hands.fill("12")
    hands.press("Tab")
    for wrong in ("-1", "1.5", "1000", "many"):
        hands.fill(wrong)
        hands.press("Tab")
        wait_until(lambda: hands.input_value() == "12")
    shared.wait_for_function("() => state.question.votes.predicted[1] === 12")
    # A screen reader says what is new in the question
    status = shared.get_by_role("status").and_(shared.locator(":has(> .question)"))
    assert status.get_attribute("aria-atomic") == "false"
    assert question.evaluate("element => element.isSame")
    press(shared, "Run")
    wait_for_text(shared, "You said: B")
    texts = "scene().__overlay_objects.objects.map(label => label.text)"
    shared.wait_for_function(f"() => {texts}.includes('12 of you')")  # above the ghosts


# The least width or height of a button, or a field, for hands.
SMALLEST_HAND = """() => Math.min(...find(".hands").flatMap(hand => {
    const { width, height } = hand.getBoundingClientRect();
    return [width, height];
}))"""
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
    hands = ["\u2212", "+"]
    ways = ["‹", "›", "Two bobs\nExperiments ▾"]
    only = [*answers, *hands * 4, *ways, "Run", "×"]
    wait_until(lambda: sorted(shared.evaluate(CONTROLS)) == sorted(only))
    assert violations(shared) == {}
    wait_for_rest(shared)
    assert shared.evaluate(SMALLEST_HAND) >= 40  # pixels: a finger hits it
    button(shared, "One hand more for C").tap()
    button(shared, answers[0]).tap()
    question.get_by_text("What did you see?").wait_for()
    assert not shared.locator(".readout").is_visible()
    assert shared.evaluate(SHAPES) == [0, 6, 5 + 5]  # with the ghosts of A
    assert not shared.evaluate("state.running")
    button(shared, "Again").tap()
    question.get_by_text("What did you see?").wait_for()
    for letter in "BCC":
        button(shared, f"One hand more for {letter}").tap()
    button(shared, "Run").tap()
    question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
    assert question.get_by_text("You said: A, One bob, twice as fast.").is_visible()
    assert question.get_by_text("You saw: C.").is_visible()
    for name in ("C, predicted: 1", "B, seen: 1", "C, seen: 2"):
        assert question.get_by_role("img", name=name).is_visible()
    shared.get_by_label("Arrows").tap()
    shared.get_by_label("Slow hits").tap()
    shared.locator(".hit-part").get_by_text("m/s").first.wait_for()
    # Of the velocities of the two bobs that move, and of the changes of momentum
    wait_until(lambda: shared.evaluate(SHAPES)[0] == 4)
    shared.keyboard.press("h")
    assert not shared.locator(".plot").is_visible()
    shared.get_by_label("Graph", exact=True).and_(shared.get_by_role("checkbox")).tap()
    shared.locator(".plot").get_by_text("potential").wait_for()
    button(shared, "Pause").tap()
    shared.get_by_text("Paused", exact=True).wait_for()
    button(shared, "3").tap()
    wait_for_angles(shared, -45, -45, -45, 0, 0)
    button(shared, "Step").tap()
    shared.wait_for_function("() => parseFloat(state.motion.t) > 0")
    shared.get_by_label("Slow motion").tap()
    wait_until(lambda: shared.evaluate("state.controls.speed.value") == 0.1)
    button(shared, "Next experiment").tap()
    question.get_by_text("Three bobs come in, and two hang.").wait_for()
    button(shared, "End the presentation").tap()
    button(shared, "Previous experiment").tap()
    question.get_by_text("Two bobs come in.").wait_for()
    assert violations(shared) == {}


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
    assert not shared.locator(".picture, .readout").first.is_visible()
    pages_of_paper = shared.pdf(format="A4").count(b"/Type /Page\n")
    assert pages_of_paper == (len(names) + 1) // 2
    shared.evaluate("dispatchEvent(new Event('afterprint'))")
    assert sheets.count() == 0
    shared.emulate_media(media="screen")


def test_a_hidden_mass_is_found_with_what_the_page_shows(shared):
    """From the velocities before and after the first hit, in which bob 2 hangs still."""
    tick(shared, "Slow hits")
    pages.choose(shared, "An unknown mass")
    press(shared, "Run")
    hit = shared.locator(".hit-part td")
    hit.first.wait_for()
    (before, after), (_, other) = [
        map(float, hit.nth(cell).inner_text().split(" → ")) for cell in (3, 5)
    ]
    mass = other / (before - after)
    shared.get_by_label("mass of bob 1 =").fill("heavy")
    press(shared, "Check")
    wait_for_text(shared, "Type a number, such as 1.5.")
    shared.get_by_label("mass of bob 1 =").fill(f"{mass:.2f}")
    press(shared, "Check")
    wait_for_text(shared, "Bob 2 gets the momentum that bob 1 loses")
    assert violations(shared) == {}


def test_the_table_shows_theta_and_takes_a_mass(shared):
    mass = shared.get_by_label("mass of pendulum 2", exact=True)
    assert not mass.is_visible()
    shared.locator(".programmers summary").click()
    pause(shared)
    press(shared, "Restart")
    theta = shared.locator(".pendula .now").first
    wait_until(lambda: theta.inner_text() == "-0.785398")
    press(shared, "One tick")
    wait_for_text(shared, "[0] theta -0.785398 -> ")
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
    wait_until(lambda: "1-2-3-4-5" in shared.locator(".impacts").text_content())
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


def test_controls_have_names_and_values_and_keep_their_keys(shared):
    words = re.compile("Newton's cradle: t = .* s, energy .* %, bob . at .* degrees (left|right)")
    shared.get_by_role("img", name=words).wait_for()
    slider = shared.get_by_role("slider", name="Bobs lifted")
    slider.press("ArrowRight")  # lifts one bob more
    wait_until(lambda: slider.get_attribute("aria-valuetext") == "2 of 5")
    button(shared, "Pause").press("Space")  # once, not twice
    wait_for_rest(shared)
    press(shared, "Keys")
    wait_for_text(shared, "answer a question")
    assert violations(shared) == {}
