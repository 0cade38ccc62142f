"""The page that is loaded again, opened twice, or left by its program, in Chromium."""

import signal

import pytest
from pages import ANGLE, LIFTED, lifts, menu, SEPARATING, slide, SPEED, unfold, values
from programs import (
    BOBS,
    copy_project,
    end,
    first_lines,
    in_both_browsers,
    MOVES,
    needs_vpython,
    new_page,
    open_cradle,
    pause,
    press,
    QUIETLY,
    readout,
    running,
    wait_for_cradle,
    wait_until,
)
from whole_cradles import FIVE_CSV

from support.page.local_server import RETURN

pytestmark = needs_vpython

VIEW = "(s => [s.forward.x, s.forward.y, s.forward.z, s.center.x, s.center.y, s.range])(glowObjs[0])"
WIDGETS = """[$(".ui-slider").toArray().map(slider => $(slider).slider("value")),
              $("select").toArray().map(menu => menu.value),
              $("input[type=checkbox]").toArray().map(box => box.checked), $("button").text()]"""


@pytest.fixture
def started(page, program):
    """The process of a program whose cradle the page shows."""
    with running(program, "--angle", "45") as process:
        open_cradle(page, first_lines(process))
        yield process


def reload(page):
    page.reload()
    wait_for_cradle(page)


def is_greyed_out(page):
    """Return whether the canvas and the widgets are pale."""
    return page.evaluate("Number(getComputedStyle(document.querySelector('.glowscript')).opacity)") < 0.5


@in_both_browsers
def test_a_reload_restarts_the_cradle_and_keeps_what_is_set(page, started):
    """As you have set it with the mouse: VPython itself never sends that to a page."""
    view = page.evaluate(VIEW)
    for slider, part in ((SPEED, 0.99), (LIFTED, 0.38), (ANGLE, 0.4)):
        slide(page, slider, part)
    wait_until(lambda: values(page)[:2] == ["2.0x", "2 of 5"] and values(page)[ANGLE] != "45°")
    menu(page, "Collisions").select_option("inelastic, e = 0")
    menu(page, "Graph").select_option("no graph")
    unfold(page, "Advanced")
    page.get_by_role("checkbox", name=SEPARATING).check()
    wait_until(lambda: not page.locator(".glowscript-graph").is_visible())
    wait_until(lambda: readout(page, "t") > 0.2)
    pause(page)
    page.evaluate("glowObjs[0].forward = vec(1, 0, -1)")
    said, widgets = values(page), page.evaluate(WIDGETS)

    reload(page)
    wait_until(lambda: readout(page, "t") == 0 and page.evaluate(WIDGETS) == widgets)
    assert values(page) == said
    angle = float(said[ANGLE].rstrip("°"))
    assert lifts(page) == pytest.approx([-angle, -angle, 0, 0, 0], abs=0.01)
    assert page.evaluate(MOVES) == 0
    assert page.evaluate(VIEW)[:3] == pytest.approx(view[:3])
    assert not page.locator(".glowscript-graph").is_visible()

    press(page, "Run")
    wait_until(lambda: readout(page, "t") > 0.5)
    pause(page)
    left = lifts(page)[:2]
    assert left[0] == pytest.approx(left[1], abs=5)  # and with e = 0, they all hang together
    started.send_signal(signal.SIGINT)
    assert end(started) == QUIETLY


def test_a_reload_while_it_runs_lets_it_run(page, started):
    view = page.evaluate(VIEW)
    for _ in range(2):
        unfold(page, "Pendula")
        page.get_by_label("mass of pendulum 1", exact=True).wait_for()
        wait_until(lambda: readout(page, "t") > 0.2)
        reload(page)
        page.get_by_role("button", name="Pause").wait_for()
        wait_until(lambda: page.evaluate(MOVES) > 0)
        assert page.evaluate(VIEW)[:3] == pytest.approx(view[:3])
    page.close()
    assert end(started) == QUIETLY


def test_a_tab_that_is_closed_and_opened_again_shows_the_cradle(page, started):
    address = page.url
    pause(page)
    slide(page, LIFTED, 0.38)
    wait_until(lambda: values(page)[LIFTED] == "2 of 5")
    with new_page(page.context.browser) as again:  # which takes longer to open than to load the address
        page.close()
        again.goto(address)
        wait_for_cradle(again)
        wait_until(lambda: lifts(again) == pytest.approx([-45, -45, 0, 0, 0], abs=0.01))
        assert values(again) == ["1.0x", "2 of 5", "45°"]
        assert started.poll() is None


def test_back_and_forward_show_the_cradle(page, started):
    address = page.url
    page.goto("about:blank")
    page.go_back()
    wait_for_cradle(page)
    page.go_forward()
    page.go_back()
    wait_for_cradle(page)
    assert page.url == address
    wait_until(lambda: page.evaluate(MOVES) > 0)


def test_a_page_that_the_browser_has_kept_is_loaded_again(page, started):
    """Chromium keeps none here; this event is all that a kept page hears."""
    pause(page)
    press(page, "Run")
    page.evaluate("window.isKept = true")
    page.evaluate("dispatchEvent(new PageTransitionEvent('pageshow', {persisted: true}))")
    page.wait_for_function("() => !window.isKept")
    wait_for_cradle(page)
    assert started.poll() is None


def test_a_page_that_the_browser_keeps_after_you_have_left_it_ends_the_program(page, started):
    page.evaluate("dispatchEvent(new PageTransitionEvent('pagehide', {persisted: true}))")
    assert end(started) == QUIETLY


def test_a_tab_that_is_closed_for_good_ends_the_program_soon(page, started):
    page.close()
    assert RETURN == 3.0  # and a second for the rest, which a busy machine may exceed
    assert started.wait(timeout=RETURN + 7) == 0
    assert end(started) == QUIETLY


def take_over(page):
    with page.expect_navigation():  # the page still has its old cradle
        press(page, "Use it here")
    wait_for_cradle(page)


def test_a_second_tab_says_so_and_can_take_the_cradle_over(page, started):
    address = page.url
    with new_page(page.context.browser) as second:
        second.goto(address)
        second.get_by_text("The cradle is open in another tab.").wait_for()
        assert second.locator("canvas").count() == 0
        wait_until(lambda: page.evaluate(MOVES) > 0)
        assert page.locator(".notice").count() == 0
        take_over(second)
        assert second.url == address
        wait_until(lambda: second.evaluate(MOVES) > 0)

        page.get_by_text("The cradle is open in another tab.").wait_for()
        assert is_greyed_out(page)
        take_over(page)
        second.get_by_text("The cradle is open in another tab.").wait_for()
        reload(page)  # is the same tab, and needs no permission
        page.close()
        assert end(started) == QUIETLY
        press(second, "Use it here")
        second.get_by_text("The program has ended.").wait_for()


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_a_page_whose_program_has_ended_says_so_and_how_to_start_it(page, tmp_path, how):
    program = copy_project(tmp_path, FIVE_CSV) / "src" / "visualize_double_cradle_run.py"
    with running(program, "--phi", "45", folder=tmp_path) as process:
        open_cradle(page, first_lines(process), bobs=10)
        assert page.title() == "Newton's double cradle"
        assert page.locator("link[rel=icon]").get_attribute("href").startswith("data:image/svg+xml,")
        process.send_signal(how)
        page.get_by_text("The program has ended.").wait_for()
        words = page.locator(".notice").inner_text()
        assert "To start it again, type this command in the terminal" in words
        assert words.rstrip().endswith(" src/visualize_double_cradle_run.py --phi 45")
        assert is_greyed_out(page)
        bobs = page.evaluate(BOBS)
        assert page.evaluate(MOVES) == 0
        assert page.evaluate(BOBS) == bobs
