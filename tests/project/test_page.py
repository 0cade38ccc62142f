"""The controls of the page: keys, mouse, touch and text reach the program, and it answers."""

import re

import pages
import pytest
from pages import (
    bob_angles,
    button,
    menu,
    pause,
    pixel,
    press,
    slide,
    slider_texts,
    tick,
    violations,
    wait_for_angles,
    wait_for_rest,
    wait_for_time,
)
from programs import wait_until
from shared_page import is_whole, wait_for_text
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
    tick(shared, "Ask")
    shared.keyboard.press("n")
    shared.wait_for_function("state.question")
    shared.keyboard.press("b")
    wait_for_text(shared, "You said: B")
    assert violations(shared) == {}


def test_a_control_has_its_own_keys_if_you_reach_it_by_keys(shared):
    slider = shared.get_by_role("slider", name="Bobs lifted")
    shared.keyboard.press("Tab")
    slider.press("ArrowRight")  # lifts one bob more
    wait_until(lambda: slider.get_attribute("aria-valuetext") == "2 of 5")
    button(shared, "Pause").press("Space")  # once, not twice
    wait_for_rest(shared)


def test_after_a_click_on_the_menu_or_the_box_of_the_graph_the_keys_are_the_pages(shared):
    plot = shared.locator(".plot")
    menu(shared, "Graph").select_option("Energies")
    plot.get_by_text("potential").wait_for()
    shared.keyboard.press("Space")
    wait_for_rest(shared)
    box = shared.get_by_role("checkbox", name="Graph")
    box.click()
    plot.wait_for(state="hidden")
    shared.keyboard.press("Space")
    button(shared, "Pause").wait_for()
    assert not box.is_checked()
    box.click()
    plot.wait_for()


def test_the_view_is_turned_with_the_right_button_and_put_back(shared):
    shared.mouse.move(100, 100)
    shared.mouse.down(button="right")
    shared.mouse.move(160, 100, steps=3)
    shared.mouse.up(button="right")
    press(shared, "Reset view")
    button(shared, "Reset view").wait_for(state="hidden")


def test_the_cursor_shows_that_a_bob_can_be_grabbed_and_it_is_let_go_outside_of_the_canvas(shared):
    """In a second tab, which is then moved to a display with twice the pixels.

    The canvas has them, too.
    """
    with pages.new_page(shared.context.browser) as sharp:
        pages.open_cradle(sharp, shared.url)
        display = {"width": 1000, "height": 700, "deviceScaleFactor": 2, "mobile": False}
        sharp.context.new_cdp_session(sharp).send("Emulation.setDeviceMetricsOverride", display)
        sharp.wait_for_function("scene().width === 2 * one('.canvas canvas').clientWidth")
        sharp.wait_for_function("scene().__overlay_objects.objects[0].height === 28")
        slide(sharp, "Bobs lifted", 0)
        wait_for_angles(sharp, 0, 0, 0, 0, 0)
        sharp.mouse.move(*pixel(sharp, 0, 0))
        sharp.wait_for_function("cursor() === 'grab'")
        pages.drag(sharp, 0, -15)
        wait_until(lambda: bob_angles(sharp)[0] == pytest.approx(-15, abs=1))
        sharp.wait_for_function("cursor() === 'grabbing'")
        sharp.mouse.move(20, 230, steps=3)  # below the canvas
        wait_until(lambda: -32 < bob_angles(sharp)[0] < -20)
        sharp.mouse.up()
        wait_until(lambda: bob_angles(sharp)[4] > 15)
        sharp.mouse.move(20, 20)
        sharp.wait_for_function("cursor() === 'auto'")


# --- the CSV, experiments and the table ------------------------------------------------------


def test_a_mistake_in_the_csv_is_shown_and_stays_in_view_until_it_is_corrected(shared, file):
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error").first
    error.get_by_text(f"{file.name}, line 7, column mass: found '-1', allowed is ").wait_for()
    shared.set_viewport_size({"width": 1000, "height": 300})
    shared.locator(".bobs summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


def test_a_slow_hit_is_in_the_table_and_a_screen_reader_hears_it(shared):
    tick(shared, "Slow hits")
    for place in (".hits .now", ".summary"):
        shared.locator(place).get_by_text("1. handle_two_bobs(pend_list[").wait_for()


def test_all_sheets_are_printed_at_once_two_on_a_page(shared):
    """Nothing else is on the paper."""
    shared.evaluate("window.print = () => {}")
    shared.locator(".choose").click()
    press(shared, "Print the sheets of all experiments")
    shared.emulate_media(media="print")
    sheets = shared.locator("article")
    names = shared.evaluate("state.sheets.map(([name]) => name)")
    assert sheets.locator("h2").all_inner_texts() == names
    for line in ("Name", "Date", "I predict", "I saw"):
        assert sheets.first.get_by_text(line).is_visible()
    measured = sheets.filter(has_text="I measured").locator("h2").all_inner_texts()
    assert measured == [name for name in names if "unknown" in name]
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


def test_the_table_shows_theta_and_takes_a_mass_and_saves_a_csv(shared):
    mass = shared.get_by_label("mass of pend_list[1]", exact=True)
    shared.locator(".bobs summary").click()
    pause(shared)
    press(shared, "Restart")
    theta = shared.locator(".pendula td:nth-child(4)").first
    wait_until(lambda: theta.inner_text() == "-0.785398")
    for text, message in (("-3", "Type a number from 0.001 to 1000."), ("2,5", "")):
        mass.fill(text)
        mass.press("Tab")
        assert mass.evaluate("field => field.validationMessage") == message
    wait_until(lambda: mass.input_value() == "2.5")
    assert violations(shared) == {}
    name, path = pages.saved(shared, "Save as CSV")
    assert name == "My cradle.csv"
    assert path.read_text().splitlines()[2] == "2.5,1.0,red,metal"


def test_a_faster_hit_is_louder_and_only_if_you_ask_for_sound(shared):
    wait_until(lambda: bob_angles(shared)[4] > 15)  # there was a hit
    assert shared.evaluate("peak()") is None
    shared.evaluate("one('#sound').checked = true")  # as Firefox does after F5
    shared.keyboard.press("v")
    shared.wait_for_function("() => peak() > 0.1")  # a hit of the cradle
    pause(shared)
    peaks = []
    for speed in (0.1, 2, 100):
        shared.wait_for_function("peak() === 0")
        shared.evaluate("speed => { state.sound = { speed }; update('sound'); }", speed)
        peaks.append(shared.wait_for_function("peak()").json_value())
    slow, fast, fastest = peaks
    assert 0 < slow < 0.8 * fast
    assert fastest < 1.2 * fast
    shared.get_by_role("checkbox", name="Sound").uncheck()
    shared.wait_for_function("() => audio.state === 'suspended'")


def test_the_canvas_says_what_it_shows_and_the_keys_are_listed(shared):
    words = re.compile("Newton's cradle: t,.* s.*energy,.* %, .*bob . at .* degrees (left|right)")
    shared.get_by_role("img", name=words).wait_for()
    press(shared, "Keys")
    wait_for_text(shared, "answer a question")
    assert violations(shared) == {}
