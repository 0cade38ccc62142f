"""The keys of the page, and what has the focus."""

from pages import (
    button,
    menu,
    tick,
    violations,
    wait_for_angles,
    wait_for_rest,
    wait_for_time,
)
from programs import wait_until


def test_keys_control_the_cradle_and_do_not_scroll_the_page(shared):
    shared.locator("h1").click()  # no control has the keys
    shared.keyboard.press("Space")
    button(shared, "Run").wait_for()
    shared.keyboard.press("R")
    wait_for_angles(shared, -45, 0, 0, 0, 0)
    shared.set_viewport_size({"width": 1000, "height": 300})  # so that the panel can scroll
    shared.keyboard.press("ArrowRight")
    wait_for_time(shared)
    shared.keyboard.press("Meta+h")
    shared.keyboard.press("Space")
    button(shared, "Pause").wait_for()
    panel = shared.locator(".panel")
    assert panel.evaluate("e => [scrollY, e.scrollTop]") == [0, 0]
    assert panel.evaluate("e => e.scrollHeight > e.clientHeight + 100")  # it could have scrolled
    assert not shared.evaluate("state.controls.slow_hits.value")
    tick(shared, "Ask")
    shared.keyboard.press("n")
    shared.wait_for_function("state.question")
    shared.keyboard.press("b")
    shared.wait_for_function("state.question.replies.asked === 1")  # the word of it soon goes
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
