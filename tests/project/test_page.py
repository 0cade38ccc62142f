"""The controls of the page, in Chromium: on one page that the tests share, with all settings put back between them."""

import re
import signal
from itertools import combinations, pairwise

import programs
import pytest
from programs import BOBS, lifts, menu, pause, pixel, press, slide, SPEED, unfold, values, wait_until
from whole_cradles import FIVE_CSV, GOOD, HEADER

# Put the cradle back to its start, with the settings with which the page opens, and let it run. A click by Playwright
# waits for two pictures: slow without a graphics card.
PUT_BACK = """() => {
    for (const menu of document.querySelectorAll(".glowscript select")) {
        if (!menu.selectedIndex || menu.closest("table")) continue;
        menu.selectedIndex = 0;
        menu.dispatchEvent(new Event("change"));
    }
    for (const box of document.querySelectorAll("input[type=checkbox]:checked")) box.click();
    for (const open of document.querySelectorAll("details[open]")) open.open = false;
    document.documentElement.classList.remove("presenting");
    document.activeElement.blur();
    const button = document.querySelector("button");
    if (button.innerText === "Run") button.click();
}"""

# Before the page's own scripts: peak() is the largest sample of the last 0.7 s at the loudspeaker, if it is in use.
LISTEN = """
const connect = AudioNode.prototype.connect;
window.peak = () => null;
AudioNode.prototype.connect = function (to, ...others) {
    if (to === this.context.destination) {
        const tap = new AnalyserNode(this.context, { fftSize: 32768 }), samples = new Float32Array(tap.fftSize);
        connect.call(this, tap);
        window.audio = this.context;
        window.peak = () => {
            tap.getFloatTimeDomainData(samples);
            return samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
        };
    }
    return connect.call(this, to, ...others);
};"""


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A page with a touch screen, and its program's project. In the end, nothing more was printed than at the start."""
    project = programs.copy_project(tmp_path_factory.mktemp("shared"), FIVE_CSV)
    program = project / "src" / programs.PROGRAM.name
    with (
        programs.running(program, "--angle", "45", folder=project, patience=60 * programs.SECONDS) as process,
        programs.new_page(chromium, has_touch=True) as page,
    ):
        page.add_init_script(LISTEN)
        programs.open_cradle(page, programs.first_lines(process))
        yield page, project
        process.send_signal(signal.SIGINT)
        assert programs.end(process) == programs.QUIETLY


@pytest.fixture
def file(started):
    """The CSV of the shared page."""
    return started[1] / "newton_cradle_pends.csv"


@pytest.fixture
def shared(started, file):
    """The shared page as it opens: with its settings and its CSV; the first bob has just been released."""
    page = started[0]
    page.mouse.up()
    if file.read_text() != FIVE_CSV:
        file.write_text(FIVE_CSV)
    page.set_viewport_size({"width": 1000, "height": 700})
    page.evaluate(PUT_BACK)
    for key in "1rv":
        page.keyboard.press(key)
    for slider, text, part in ((SPEED, "1.0x", 0.475), (programs.ANGLE, "45°", 0.25)):
        wait_until(lambda at=slider, text=text, part=part: values(page)[at] == text or slide(page, at, part))
    wait_until(lambda: values(page) == ["1.0x", "1 of 5", "45°"] and len(page.evaluate(BOBS)) == 5)
    page.get_by_role("button", name="Pause").wait_for()
    return page


def test_keys_and_buttons_control_the_cradle_and_do_not_scroll_the_page(shared):
    shared.set_viewport_size({"width": 1000, "height": 300})  # so that the panel can scroll
    wait_until(lambda: shared.get_by_role("button", name="Step").is_disabled())
    slide(shared, SPEED, 0.5)
    shared.keyboard.press("Space")
    shared.get_by_role("button", name="Run").wait_for()
    shared.keyboard.press("r")
    programs.wait_for_lifts(shared, -45, 0, 0, 0, 0)
    for _ in range(2):  # VPython itself sends no value that it has sent before
        slide(shared, programs.LIFTED, 0.99)
        programs.wait_for_lifts(shared, -45, -45, -45, -45, -45)
        shared.keyboard.press("3")
        programs.wait_for_lifts(shared, -45, -45, -45, 0, 0)
    shared.keyboard.press("ArrowRight")
    wait_until(lambda: programs.readout(shared, "t") > 0)
    press(shared, "Restart")
    wait_until(lambda: programs.readout(shared, "t") == 0)
    press(shared, "Step")
    wait_until(lambda: programs.readout(shared, "t") > 0)
    programs.wait_for_rest(shared)
    panel = "document.querySelector('.panel')"
    assert shared.evaluate(f"{panel}.scrollHeight > {panel}.clientHeight + 100")
    assert shared.evaluate(f"[scrollY, {panel}.scrollTop]") == [0, 0]


def test_keys_without_a_meaning_do_nothing(shared):
    """VPython prints a traceback for those that it has no name for."""
    for key in ("ContextMenu", "AudioVolumeUp", "Meta", "AltGraph", "F1", "x", "Control"):
        shared.keyboard.press(key)
    press_code = "keyCode => document.body.dispatchEvent(new KeyboardEvent('keydown', { keyCode, bubbles: true }))"
    for code in (0, 173, 229):  # as of a keyboard for another language
        shared.evaluate(press_code, code)
    shared.keyboard.press("Meta+2")  # another tab, on a Mac
    shared.keyboard.press("Space")
    shared.get_by_role("button", name="Run").wait_for()
    assert values(shared)[programs.LIFTED] == "1 of 5"


def test_the_graph_has_even_ticks_and_a_choice(shared):
    graph = shared.locator(".glowscript-graph")
    graph.get_by_text("potential").wait_for()
    wait_until(lambda: graph.locator(".yAxis .tickLabel").count() > 2)
    ticks = [float(tick) for tick in graph.locator(".yAxis .tickLabel").all_inner_texts()]
    steps = [b - a for a, b in pairwise(sorted(ticks))]
    assert steps == pytest.approx([steps[0]] * len(steps))  # which VPython's own, rounded ones are not always
    assert min(ticks) == 0
    menu(shared, "Graph").select_option("Angles theta")
    graph.get_by_text("potential").wait_for(state="detached")
    menu(shared, "Graph").select_option("Phase 5")
    wait_until(lambda: shared.locator(".axis").all_inner_texts() == ["theta (rad)", "omega (rad/s)"])
    menu(shared, "Graph").select_option("no graph")
    graph.wait_for(state="hidden")


def test_the_cursor_shows_that_a_bob_can_be_grabbed_and_it_is_let_go_outside_of_the_canvas(shared):
    cursor = "getComputedStyle(document.querySelector('.canvas canvas:last-of-type')).cursor"
    slide(shared, programs.LIFTED, 0.01)
    programs.wait_for_lifts(shared, 0, 0, 0, 0, 0)
    shared.mouse.move(*pixel(shared, 0, 0))
    wait_until(lambda: shared.evaluate(cursor) == "grab")
    shared.mouse.down()
    shared.mouse.move(*pixel(shared, 0, -30), steps=3)
    wait_until(lambda: lifts(shared)[0] == pytest.approx(-30, abs=1) and shared.evaluate(cursor) == "grabbing")
    shared.mouse.move(20, 230, steps=3)  # below the canvas
    wait_until(lambda: -32 < lifts(shared)[0] < -20)
    shared.mouse.up()
    wait_until(lambda: "1-2-3-4-5" in shared.locator(".impacts").inner_text())
    shared.mouse.move(20, 20)
    wait_until(lambda: shared.evaluate(cursor) == "auto")


# --- the CSV, experiments and the table ------------------------------------------------------------------------------


def test_an_edited_csv_shows_up_or_its_mistake(shared, file):
    colors = BOBS.replace("[o.pos.x, o.pos.y]", "[o.color.x, o.color.y, o.color.z]")
    file.write_text(HEADER + GOOD.replace("red", "blue") * 7)
    wait_until(lambda: shared.evaluate(colors) == [[0, 0, 1]] * 7 and values(shared)[programs.LIFTED] == "1 of 7")
    assert shared.get_by_role("slider", name="Bobs lifted").evaluate("e => e.style.left") == "14.286%"
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error")
    error.wait_for(state="visible")
    shared.locator(".fold summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    assert error.inner_text().startswith(f"{file}, line 7, column mass: found '-1', allowed is ")
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


# How many arrows, boxes and spheres are visible.
SEEN = """() => ["arrow", "box", "sphere"].map(
    kind => glowObjs.filter(o => o?.constructor.name === kind && o.visible).length)"""


def test_a_lesson_in_present_from_the_question_to_the_sheet(shared):
    question, hit = shared.locator(".question"), shared.locator(".hit-words")
    shared.get_by_role("checkbox", name="Predict first").check()
    shared.keyboard.press("f")
    wait_until(lambda: menu(shared, "Collisions").is_hidden())
    for name in ("One bob comes in.", "Two bobs come in."):
        shared.keyboard.press("n")
        question.get_by_text(name).wait_for()
    programs.wait_for_rest(shared)
    shared.locator(".hands").nth(2).click()
    wait_until(lambda: shared.locator(".hands").all_inner_texts() == ["0", "0", "1", "0"])
    assert not shared.locator(".readout").is_visible()  # it waits for the answer
    shared.get_by_role("checkbox", name="Arrows").check()
    shared.keyboard.press("a")
    question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
    assert shared.evaluate(SEEN) == [0, 6 + 6, 5 + 5]  # no bob moves while the picture rests
    assert question.get_by_text("You said: A, One bob, twice as fast. Hands: A 0, B 0, C 1, D 0.").is_visible()
    shared.emulate_media(media="print")
    shared.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert shared.locator(".sheet img").evaluate("async e => await e.decode() ?? e.naturalWidth") > 100
    assert all(shared.get_by_text(text).is_visible() for text in ("I measured", "swung to (degrees)"))
    assert not shared.locator("canvas").first.is_visible()
    shared.emulate_media(media="screen")
    shared.keyboard.press("h")
    wait_until(lambda: hit.is_visible() and "m/s" in hit.inner_text() and shared.evaluate(SEEN)[0] == 2)
    shared.keyboard.press("Escape")
    menu(shared, "Collisions").wait_for()


def cell(page, column, row):
    return page.get_by_label(f"{column} of pendulum {row}", exact=True)


def test_the_table_moves_and_takes_a_mass(shared, file):
    assert cell(shared, "mass", 1).count() == 0  # folded away
    unfold(shared, "For programmers")
    theta = shared.locator(".pendula .now").first
    wait_until(lambda: theta.inner_text() not in ("", "-0.785398"))
    pause(shared)
    press(shared, "Restart")
    wait_until(lambda: theta.inner_text() == "-0.785398")
    press(shared, "One tick")
    shared.get_by_text("[0] theta -0.785398 -> ").wait_for()
    mass = cell(shared, "mass", 2)
    mass.fill("-3")
    mass.press("Tab")
    rule = shared.get_by_text("mass: allowed is a number from 1e-300 to 1e6, without its unit, kg", exact=True)
    rule.wait_for()
    assert mass.get_attribute("aria-invalid") == "true"
    wait_until(lambda: shared.evaluate("document.activeElement.ariaLabel") == "e of pendulum 2")  # where Tab leads
    mass.fill("2.5")
    mass.press("Enter")
    rule.wait_for(state="detached")
    wait_until(lambda: cell(shared, "mass", 2).input_value() == "2.5")
    assert file.read_text() == FIVE_CSV


# Let the page hear of a hit with this speed (m/s); return the largest sample that follows.
HIT = """async speed => {
    document.querySelector(".hit").parentElement.innerHTML = `<i class="hit" data-speed="${speed}"></i>`;
    let most = 0;
    for (let look = 0; look < 20; look++) { // a single look can be too early or too late
        await new Promise(resolve => setTimeout(resolve, 50));
        most = Math.max(most, peak());
    }
    return most;
}"""


def test_a_faster_hit_is_louder_and_only_if_you_ask_for_sound(shared):
    wait_until(lambda: "1-2-3-4-5" in shared.locator(".impacts").inner_text())
    assert shared.evaluate("peak()") is None
    assert shared.locator(".hit").get_attribute("data-speed") is None
    shared.get_by_role("checkbox", name="Sound").check()
    wait_until(lambda: (shared.evaluate("peak()") or 0) > 0.1)  # a hit of the cradle
    pause(shared)
    peaks = []
    for speed in (0.1, 2, 100):
        wait_until(lambda: shared.evaluate("peak()") == 0)
        peaks.append(shared.evaluate(HIT, speed))
    assert 0 < peaks[0] < 0.8 * peaks[1] and peaks[2] < 1.2 * peaks[1]
    shared.get_by_role("checkbox", name="Sound").uncheck()
    wait_until(lambda: shared.evaluate("audio.state") == "suspended")


# --- windows, screens and fingers ------------------------------------------------------------------------------------

PHONE, TABLET, LAPTOP, BOARD = (390, 844), (768, 1024), (1366, 625), (2560, 1440)

# The edges of an element, in the window: left, top, right, bottom.
EDGES = "e => (r => [r.left, r.top, r.right, r.bottom])(e.getBoundingClientRect())"
LETTERS = "() => parseFloat(getComputedStyle(document.querySelector('.readout')).fontSize)"  # at once: it is replaced


@pytest.fixture
def at_rest(shared):
    """The page in a laptop's window, with all bobs at rest; the canvas is as large as it is for a user."""
    shared.evaluate("document.querySelector('#small').disabled = true")
    resize(shared, LAPTOP)
    shared.evaluate(programs.CAMERA_FOLLOWS)  # only while the cradle runs
    pause(shared)
    slide(shared, programs.LIFTED, 0.01)
    programs.wait_for_lifts(shared, 0, 0, 0, 0, 0)
    yield shared
    shared.evaluate("document.querySelector('#small').disabled = false")


def resize(page, size):
    """Make the window this large (pixels), and wait until the canvas has followed."""
    page.set_viewport_size({"width": size[0], "height": size[1]})
    wait_until(lambda: page.evaluate("glowObjs[0].width") == round(edges(page, ".canvas")[2]))


def edges(page, selector):
    return page.locator(selector).first.evaluate(EDGES)


def is_whole(page, selector):
    """Return whether an element is in the window as a whole."""
    left, top, right, bottom = edges(page, selector)
    width, height = page.viewport_size["width"], page.viewport_size["height"]
    return 0 <= left < right <= width and 0 <= top < bottom <= height


@pytest.mark.parametrize("size", [PHONE, TABLET, LAPTOP, BOARD])
def test_the_page_fits_the_window(at_rest, size):
    """The whole swing is in view, and no part of the panel covers another. Only a tall window scrolls, up and down."""
    resize(at_rest, size)
    assert is_whole(at_rest, "canvas")
    left, top, right, bottom = edges(at_rest, "canvas")
    wait_until(lambda: all(left < pixel(at_rest, bob, theta)[0] < right for bob, theta in ((0, -90), (4, 90))))
    shown = [part for part in at_rest.locator(".panel section > *").all() if part.is_visible()]
    wait_until(lambda: all(part.evaluate(EDGES)[2] <= size[0] for part in shown))  # the graph follows the window, too
    parts = [part.evaluate(EDGES) for part in at_rest.locator(".panel section").all() if part.is_visible()]
    for (left1, top1, right1, bottom1), (left2, top2, right2, bottom2) in combinations(parts, 2):
        assert min(min(right1, right2) - max(left1, left2), min(bottom1, bottom2) - max(top1, top2)) <= 0
    if size in (PHONE, TABLET):
        assert all(is_whole(at_rest, f"button:has-text('{name}')") for name in ("Run", "Step", "Restart"))
        unfold(at_rest, "For programmers")
        scroll = "e => { (e.closest('tr')?.cells[0] ?? e).scrollIntoView() }"  # down, not sideways
        for name in ("tr:has(.now:not(:empty)) [aria-label='e of pendulum 5']", ".fold summary"):
            wait_until(lambda name=name: at_rest.locator(name).evaluate(scroll) or is_whole(at_rest, name))
    else:
        assert at_rest.evaluate("(e => e.scrollHeight - e.clientHeight)(document.querySelector('.panel'))") == 0
        selectors = (".readout", ".impacts", ".glowscript-graph", "select", "summary")
        assert all(is_whole(at_rest, selector) for selector in selectors)
        assert right < edges(at_rest, ".panel")[0] + 1
        assert pixel(at_rest, 4, 90)[0] - pixel(at_rest, 0, -90)[0] >= 0.8 * (right - left) >= 0.45 * size[0]
        assert at_rest.evaluate(LETTERS) >= 0.022 * size[1]
    assert at_rest.evaluate("(e => e.scrollWidth - e.clientWidth)(document.querySelector('.panel'))") == 0


def test_present_leaves_cradle_and_numbers(at_rest):
    before = at_rest.evaluate(LETTERS)
    at_rest.keyboard.press("f")
    wait_until(lambda: menu(at_rest, "Collisions").is_hidden())
    assert edges(at_rest, ".canvas")[2] == at_rest.evaluate("innerWidth")
    assert is_whole(at_rest, ".readout")
    assert at_rest.evaluate(LETTERS) > 1.5 * before
    at_rest.keyboard.press("f")
    wait_until(lambda: menu(at_rest, "Collisions").is_visible())
    press(at_rest, "Present")
    at_rest.get_by_role("button", name="End the presentation").click()
    wait_until(lambda: menu(at_rest, "Collisions").is_visible())
    assert at_rest.locator(".leave").is_hidden()


def test_light_dark_and_forced_colors_follow_the_system(at_rest):
    for scheme, is_dark in (("dark", True), ("light", False)):
        at_rest.emulate_media(color_scheme=scheme)
        wait_until(lambda is_dark=is_dark: (at_rest.evaluate("glowObjs[0].background.x") < 0.3) == is_dark)
        colors = "e => [getComputedStyle(e).backgroundColor, getComputedStyle(e).color]"
        seen = at_rest.locator(".panel").evaluate(colors)
        paper, ink = (sum(map(int, re.findall(r"\d+", color)[:3])) / 3 for color in seen)
        assert (paper < ink) == is_dark
        assert abs(paper - ink) > 128
    at_rest.emulate_media(forced_colors="active")
    parts = [at_rest.locator(name).first for name in (".ui-slider", ".ui-slider-range")]
    empty, filled = (part.evaluate("e => getComputedStyle(e).backgroundColor") for part in parts)
    assert filled != empty
    at_rest.emulate_media(forced_colors="none")


def test_one_finger_drags_a_bob_or_a_slider_or_turns_the_camera_and_two_zoom(at_rest):
    fingers = at_rest.context.new_cdp_session(at_rest)

    def touch(kind, *points):  # kind is Start, Move or End, with a finger at each of the points (x, y)
        points = [{"x": x, "y": y} for x, y in points]
        fingers.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})

    view = "[glowObjs[0].forward.x, glowObjs[0].range]"
    before = at_rest.evaluate(view)
    x, y = pixel(at_rest, 4, 0)
    radius = (x - pixel(at_rest, 3, 0)[0]) / 2.1
    touch("Start", (x, y + 1.3 * radius))  # a finger is not exact
    for theta in (20, 40):
        touch("Move", pixel(at_rest, 4, theta))
    wait_until(lambda: lifts(at_rest)[4] == pytest.approx(40, abs=3))
    assert at_rest.evaluate(view) == before
    touch("End")
    touch("Start", (60, 60))
    for x in (90, 140):
        touch("Move", (x, 60))
    touch("End")
    wait_until(lambda: at_rest.evaluate(view)[0] != before[0])
    for kind, apart in (("Start", 0), ("Move", 20), ("Move", 40), ("Move", 60), ("Move", 80)):
        touch(kind, (200 - apart, 60), (300 + apart, 60))
    touch("End")
    wait_until(lambda: at_rest.evaluate(view)[1] != before[1])
    left, top, right, bottom = edges(at_rest, ".ui-slider")
    for kind, part in (("Start", 0.5), ("Move", 0.7), ("Move", 1.0)):
        touch(kind, (left + part * (right - left), (top + bottom) / 2))
    touch("End")
    wait_until(lambda: values(at_rest)[SPEED] in ("1.9x", "2.0x"))  # the handle keeps its offset
    stays_above_the_base = """async () => {
        glowObjs[0].forward = vec(0, 0.5, -1);
        for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
        return glowObjs[0].forward.y;
    }"""
    wait_until(lambda: at_rest.evaluate(stays_above_the_base) == 0)


def test_widgets_have_names_roles_and_values_and_keep_their_keys(at_rest):
    for name in ("Speed", "Bobs lifted", "Release angle"):
        assert at_rest.get_by_role("slider", name=name).count() == 1
    for name in ("Collisions", "Graph", "Experiment"):
        assert menu(at_rest, name).count() == 1
    assert at_rest.evaluate("document.documentElement.lang") == "en"
    at_rest.get_by_role("img", name=re.compile("Newton's cradle with 5 bobs: t .* s, energy .* %")).wait_for()
    unfold(at_rest, "For programmers")
    for is_checked in (True, False):
        at_rest.get_by_text(programs.SEPARATING).click()
        assert at_rest.get_by_role("checkbox", name=programs.SEPARATING).is_checked() == is_checked
    slider = at_rest.get_by_role("slider", name="Bobs lifted")
    slider.focus()
    for lifted in (1, 2):
        slider.press("ArrowRight")  # lifts one bob more
        wait_until(lambda lifted=lifted: slider.get_attribute("aria-valuetext") == f"{lifted} of 5")
        assert slider.get_attribute("aria-valuenow") == str(lifted)
    slider.press("Home")
    at_rest.get_by_role("button", name="Run").focus()
    at_rest.keyboard.press("Space")  # once, not twice
    at_rest.get_by_role("button", name="Pause").wait_for()
    wait_until(lambda: programs.readout(at_rest, "t") > 0)
