"""The controls of the page, in Chromium: on one page that the tests share, with all settings put
back between them.
"""

import re
import shlex
import signal
import subprocess
from itertools import combinations, pairwise

import programs
import pytest
from programs import (
    BOBS,
    lifts,
    menu,
    pause,
    pixel,
    press,
    readout,
    slide,
    values,
    violations,
    wait_until,
)
from whole_cradles import FIVE_CSV, GOOD, HEADER

# Put the settings back to those with which the page opens, pause, and restart the cradle.
PUT_BACK = """() => {
    tell("experiment", state.experiments[0]);
    if (state.running || state.question?.asking) tell("pause");
    for (const name of ["ask first", "slow hits", "arrows", "separating"]) tell(name, false);
    for (const name of ["collision", "graph", "span"]) tell(name, state[name + "s"][0]);
    tell("edit", 1, "mass", "1.0");
    tell("speed", 1);
    tell("lifted", 1);
    tell("lift", 0, 45);
    tell("restart");
    if (one("#sound").checked) one("#sound").click();
    for (const open of find("details[open]")) open.open = false;
    one("#keys").hidePopover();
    if (document.documentElement.matches(".presenting")) present();
    document.activeElement.blur();
    resetView();
    glowObjs[0].visible = false;
}"""
IS_BACK = """() => !state.running && parseFloat(state.motion.t) === 0 && !state.arrows && !state.question
    && bobs().length === 5 && find("output").map(e => e.value).join() === "1.0x,1 of 5,45°" """

# Ask the question of the first experiment.
ASK = """async () => {
    tell("ask first", true);
    tell("next");
    while (!state.question) await new Promise(requestAnimationFrame);
}"""

# Before the page's own scripts: peak() is the largest sample of the last 0.7 s at the loudspeaker,
# if it is in use.
LISTEN = """
const connect = AudioNode.prototype.connect;
window.peak = () => null;
AudioNode.prototype.connect = function (to, ...others) {
    if (to === this.context.destination) {
        const tap = new AnalyserNode(this.context, { fftSize: 32768 }), samples = new Float32Array(tap.fftSize);
        connect.call(this, tap);
        window.audio = this.context;
        window.peak = () => (tap.getFloatTimeDomainData(samples), Math.max(...samples.map(Math.abs)));
    }
    return connect.call(this, to, ...others);
};"""


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A page with a touch screen, and its program's CSV. In the end, nothing more was printed than
    at the start.
    """
    project = programs.copy_project(tmp_path_factory.mktemp("shared"), FIVE_CSV)
    program = project / "src" / programs.PROGRAM.name
    with (
        programs.running(
            program, "--angle", "45", folder=project, patience=60 * programs.SECONDS
        ) as process,
        programs.new_page(chromium, has_touch=True) as page,
    ):
        page.add_init_script(LISTEN)
        programs.open_cradle(page, programs.first_lines(process))
        yield page, project / "newton_cradle_pends.csv"
        process.send_signal(signal.SIGINT)
        assert programs.end(process) == programs.QUIETLY


@pytest.fixture
def shared(started):
    """The shared page as it opens: with its settings and its CSV; the first bob has just been
    released.
    """
    page, file = started
    page.mouse.up()
    if file.read_text() != FIVE_CSV:
        file.write_text(FIVE_CSV)
    page.set_viewport_size({"width": 1000, "height": 700})
    page.evaluate(PUT_BACK)
    page.wait_for_function(IS_BACK)
    press(page, "Run")
    return page


def test_keys_and_buttons_control_the_cradle_and_do_not_scroll_the_page(shared):
    slide(shared, "Speed", 1.1)
    wait_until(lambda: shared.get_by_role("button", name="Step").is_disabled())
    shared.keyboard.press("Space")
    shared.get_by_role("button", name="Run").wait_for()
    shared.keyboard.press("r")
    programs.wait_for_lifts(shared, -45, 0, 0, 0, 0)
    for _ in range(2):
        slide(shared, "Bobs lifted", 5)
        programs.wait_for_lifts(shared, -45, -45, -45, -45, -45)
        shared.keyboard.press("3")
        programs.wait_for_lifts(shared, -45, -45, -45, 0, 0)
    shared.set_viewport_size({"width": 1000, "height": 300})  # so that the panel can scroll
    shared.keyboard.press("ArrowRight")
    wait_until(lambda: readout(shared, "t") > 0)
    press(shared, "Restart")
    wait_until(lambda: readout(shared, "t") == 0)
    press(shared, "Step")
    wait_until(lambda: readout(shared, "t") > 0)
    shared.keyboard.press("Space")
    shared.get_by_role("button", name="Pause").wait_for()
    panel = shared.locator(".panel")
    assert panel.evaluate("e => [scrollY, e.scrollTop, e.scrollHeight > e.clientHeight + 100]") == [
        0,
        0,
        True,
    ]


def test_what_you_type_counts_and_on_another_alphabet_the_place_of_the_key(shared):
    typed = "([key, code]) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key, code, bubbles: true }))"
    wait_until(lambda: readout(shared, "t") > 0)
    pause(shared)
    before = readout(shared, "t")
    for key in ("ContextMenu", "AudioVolumeUp", "Meta", "AltGraph", "F1", "x", "Control", "Meta+2"):
        shared.keyboard.press(key)
    for key, code in (("o", "KeyR"), ("Process", "KeyR"), ("Unidentified", ""), ("к", "")):
        shared.evaluate(typed, [key, code])
    shared.keyboard.press("ArrowRight")
    wait_until(lambda: readout(shared, "t") > before)
    assert values(shared) == ["1.0x", "1 of 5", "45°"]  # none of these keys has done anything
    # On a Russian keyboard, and on one in Dvorak's order
    for key, code in (("к", "KeyR"), ("r", "KeyO")):
        shared.evaluate(typed, [key, code])
        wait_until(lambda: readout(shared, "t") == 0)
        shared.keyboard.press("ArrowRight")
        wait_until(lambda: readout(shared, "t") > 0)
    shared.evaluate(ASK)
    for code in ("", "KeyB"):
        shared.evaluate(typed, ["и", code])
    shared.get_by_text("You said: B").wait_for()  # the first answer counts


def test_the_graph_has_even_ticks_and_a_choice(shared):
    plot, ticks, names = (shared.locator(name) for name in (".plot", ".yAxis .tickLabel", ".y, .x"))
    plot.get_by_text("potential").wait_for()
    wait_until(lambda: min(map(float, ticks.all_inner_texts()), default=1) == 0)  # %
    menu(shared, "Graph").select_option("Angles theta")
    plot.get_by_text("potential").wait_for(state="detached")
    wait_until(lambda: ticks.count() > 2)
    steps = [b - a for a, b in pairwise(sorted(map(float, ticks.all_inner_texts())))]
    assert steps == pytest.approx([steps[0]] * len(steps))  # no tick is rounded
    menu(shared, "Graph").select_option("Phase 5")
    wait_until(lambda: names.all_inner_texts() == ["omega (rad/s)", "theta (rad)"])
    menu(shared, "Graph").select_option("no graph")
    plot.wait_for(state="hidden")


def test_the_cursor_shows_that_a_bob_can_be_grabbed_and_it_is_let_go_outside_of_the_canvas(shared):
    """In a second tab, which is then moved to a display with twice the pixels: the canvas has them,
    too.
    """
    cursor = "getComputedStyle(document.querySelector('.canvas canvas:last-of-type')).cursor"
    sizes = """() => {
        const canvas = one(".canvas canvas");
        return [canvas.width / canvas.clientWidth, canvas.height / canvas.clientHeight, labels[0].height];
    }"""
    with programs.new_page(shared.context.browser) as sharp:
        programs.open_cradle(sharp, shared.url)
        display = {"width": 1000, "height": 700, "deviceScaleFactor": 2, "mobile": False}
        sharp.context.new_cdp_session(sharp).send("Emulation.setDeviceMetricsOverride", display)
        wait_until(lambda: sharp.evaluate(sizes) == [2, 2, 24])
        slide(sharp, "Bobs lifted", 0)
        programs.wait_for_lifts(sharp, 0, 0, 0, 0, 0)
        sharp.mouse.move(*pixel(sharp, 0, 0))
        wait_until(lambda: sharp.evaluate(cursor) == "grab")
        sharp.mouse.down()
        sharp.mouse.move(*pixel(sharp, 0, -30), steps=3)
        wait_until(
            lambda: (
                lifts(sharp)[0] == pytest.approx(-30, abs=1)
                and sharp.evaluate(cursor) == "grabbing"
            )
        )
        sharp.mouse.move(20, 230, steps=3)  # below the canvas
        wait_until(lambda: -32 < lifts(sharp)[0] < -20)
        sharp.mouse.up()
        wait_until(lambda: "1-2-3-4-5" in sharp.locator(".impacts").inner_text())
        sharp.mouse.move(20, 20)
        wait_until(lambda: sharp.evaluate(cursor) == "auto")


# --- the CSV, experiments and the table ------------------------------------------------------------------------------


def test_an_edited_csv_shows_up_or_its_mistake(shared, started):
    file = started[1]
    colors = BOBS.replace("[o.pos.x, o.pos.y]", "[o.color.x, o.color.y, o.color.z]")
    file.write_text(HEADER + GOOD.replace("red", "blue") * 7)
    wait_until(lambda: shared.evaluate(colors) == [[0, 0, 1]] * 7 and values(shared)[1] == "1 of 7")
    assert shared.get_by_role("slider", name="Bobs lifted").evaluate("e => [e.value, e.max]") == [
        "1",
        "7",
    ]
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error").first
    error.wait_for(state="visible")
    shared.set_viewport_size({"width": 1000, "height": 300})
    shared.locator("summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    assert error.inner_text().startswith(f"{file}, line 7, column mass: found '-1', allowed is ")
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


# Where a picture on paper begins to be red, from its left edge (0) to its right one (1).
RED = """picture => {
    const { width, height } = picture, { data } = picture.getContext("2d").getImageData(0, 0, width, height);
    const isRed = place => (([r, g, b]) => r > 100 && g < 40 && b < 40)(data.slice(4 * place, 4 * place + 3));
    const places = [...Array(width * height).keys()].filter(isRed), isWhite = Math.min(...data.slice(0, 4)) === 255;
    if (!isWhite || !picture.checkVisibility() || one(".canvas").checkVisibility()) return NaN;
    return Math.min(...places.map(place => place % width)) / width;
}"""


def printed(page):
    """Have the page as it is on paper; return where the red bob is in its picture, from 0 to 1."""
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    return page.locator(".picture canvas").first.evaluate(RED)


def test_a_lesson_in_present_from_the_question_to_the_sheet(shared):
    # How many arrows, boxes and spheres are visible.
    seen = """() => ["arrow", "box", "sphere"].map(
        kind => glowObjs.filter(o => o?.constructor.name === kind && o.visible).length)"""
    question, hit = shared.locator(".question"), shared.locator(".hit-part")
    shared.get_by_role("checkbox", name="Predict first").check()
    programs.draw(shared, True)
    for name in ("One bob comes in.", "Two bobs come in."):
        shared.keyboard.press("n")
        question.get_by_text(name).wait_for()
    # The picture of the sheet is there
    shared.wait_for_function("() => asked === state.question.question")
    programs.draw(shared, False)
    assert violations(shared) == {}
    shared.keyboard.press("f")
    wait_until(lambda: menu(shared, "Collisions").is_hidden())
    assert violations(shared) == {}
    programs.wait_for_rest(shared)
    shared.locator(".hands").nth(2).click()
    wait_until(lambda: shared.locator(".hands").all_inner_texts() == ["0", "0", "1", "0"])
    assert not shared.locator(".readout").is_visible()  # it waits for the answer
    shared.get_by_role("checkbox", name="Arrows").check()
    shared.keyboard.press("a")
    question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
    assert shared.evaluate(seen) == [0, 6 + 6, 5 + 5]  # no bob moves while the picture rests
    assert question.get_by_text(
        "You said: A, One bob, twice as fast. Hands: A 0, B 0, C 1, D 0."
    ).is_visible()
    assert printed(shared) < 0.2  # the first bob before its release, although it hangs now
    assert all(
        shared.get_by_text(text).is_visible() for text in ("I measured", "swung to (degrees)")
    )
    shared.emulate_media(media="screen")
    assert violations(shared) == {}
    shared.keyboard.press("h")
    wait_until(
        lambda: hit.is_visible() and "m/s" in hit.inner_text() and shared.evaluate(seen)[0] == 2
    )
    shared.keyboard.press("Escape")
    menu(shared, "Collisions").wait_for()
    assert violations(shared) == {}


def test_the_table_moves_and_takes_a_mass(shared, started):
    mass = shared.get_by_label("mass of pendulum 2", exact=True)
    assert not mass.is_visible()
    shared.locator("summary").click()
    theta = shared.locator(".pendula .now").first
    wait_until(lambda: theta.inner_text() not in ("", "-0.785398"))
    pause(shared)
    press(shared, "Restart")
    wait_until(lambda: theta.inner_text() == "-0.785398")
    press(shared, "One tick")
    shared.get_by_text("[0] theta -0.785398 -> ").wait_for()
    mass.fill("-3")
    mass.press("Tab")
    rule = shared.get_by_text(
        "mass: allowed is a number from 1e-300 to 1e6 (kg), such as 1.5", exact=True
    )
    rule.wait_for()
    assert mass.get_attribute("aria-invalid") == "true"
    # Where Tab leads
    wait_until(lambda: shared.evaluate("document.activeElement.ariaLabel") == "e of pendulum 2")
    assert violations(shared) == {}
    mass.fill("2.5")
    mass.press("Enter")
    rule.wait_for(state="detached")
    wait_until(lambda: mass.input_value() == "2.5")
    assert started[1].read_text() == FIVE_CSV


# Let the page hear of a hit with this speed (m/s); return the largest sample that follows.
HIT = """async speed => {
    shows.sound([0, speed]);
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
# At once: it is replaced
LETTERS = "() => parseFloat(getComputedStyle(document.querySelector('.readout')).fontSize)"


@pytest.fixture
def at_rest(shared):
    """The page in a laptop's window, with all bobs at rest; the canvas is as large as it is for a
    user.
    """
    shared.evaluate("document.querySelector('#small').disabled = true")
    resize(shared, LAPTOP)
    pause(shared)
    slide(shared, "Bobs lifted", 0)
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
    """The whole swing is in view, and no part of the panel covers another.

    Only a tall window scrolls, up and down.
    """
    resize(at_rest, size)
    assert is_whole(at_rest, "canvas")
    left, top, right, bottom = edges(at_rest, "canvas")
    wait_until(
        lambda: all(
            left < pixel(at_rest, bob, theta)[0] < right for bob, theta in ((0, -90), (4, 90))
        )
    )
    shown = [part for part in at_rest.locator(".panel section > *").all() if part.is_visible()]
    # The graph follows the window, too
    wait_until(lambda: all(part.evaluate(EDGES)[2] <= size[0] for part in shown))
    parts = [
        part.evaluate(EDGES)
        for part in at_rest.locator(".panel section").all()
        if part.is_visible()
    ]
    for (left1, top1, right1, bottom1), (left2, top2, right2, bottom2) in combinations(parts, 2):
        assert (
            min(min(right1, right2) - max(left1, left2), min(bottom1, bottom2) - max(top1, top2))
            <= 0
        )
    if size in (PHONE, TABLET):
        assert all(
            is_whole(at_rest, f"button:has-text('{name}')") for name in ("Run", "Step", "Restart")
        )
        at_rest.locator("summary").click()
        scroll = "e => { (e.closest('tr')?.cells[0] ?? e).scrollIntoView() }"  # down, not sideways
        for name in ("tr:has(.now:not(:empty)) [aria-label='e of pendulum 5']", ".fold summary"):
            wait_until(
                lambda name=name: at_rest.locator(name).evaluate(scroll) or is_whole(at_rest, name)
            )
    else:
        assert (
            at_rest.evaluate(
                "(e => e.scrollHeight - e.clientHeight)(document.querySelector('.panel'))"
            )
            == 0
        )
        selectors = (".readout", ".impacts", ".graph", "select", "summary")
        assert all(is_whole(at_rest, selector) for selector in selectors)
        assert right < edges(at_rest, ".panel")[0] + 1
        assert (
            pixel(at_rest, 4, 90)[0] - pixel(at_rest, 0, -90)[0]
            >= 0.8 * (right - left)
            >= 0.45 * size[0]
        )
        assert at_rest.evaluate(LETTERS) >= 0.022 * size[1]
    assert (
        at_rest.evaluate("(e => e.scrollWidth - e.clientWidth)(document.querySelector('.panel'))")
        == 0
    )


def test_a_page_on_paper_has_the_cradle_as_it_is_now_its_numbers_and_no_controls(at_rest):
    programs.draw(at_rest, True)
    at_rest.emulate_media(color_scheme="dark")
    assert 0.25 < printed(at_rest) < 0.4
    assert at_rest.evaluate("document.body.innerText.trim() === one('.readout').innerText.trim()")
    at_rest.emulate_media(media="screen", color_scheme="light")


# The parts of the panel that reach out of the window on the right.
CUT = """() => find(".panel *").filter(part => part.checkVisibility())
    .filter(part => part.getBoundingClientRect().right > innerWidth).map(part => part.outerHTML)"""


def test_the_text_is_as_large_as_the_reader_has_chosen_and_nothing_is_cut(driver, shared):
    """24 pixels in the settings of the browser; the small text follows, and the texts in the
    canvas.
    """
    arguments = [*programs.ARGUMENTS, "--blink-settings=defaultFontSize=24"]
    sizes = "() => [...['body', '.impacts'].map(name => getComputedStyle(one(name)).fontSize), labels[0].height]"
    with (
        driver.chromium.launch(executable_path=programs.CHROMIUM, args=arguments) as browser,
        programs.new_page(browser) as page,
    ):
        programs.open_cradle(page, shared.url)
        assert page.evaluate(sizes) == ["24px", "21px", 18]
        page.evaluate(ASK)
        for size in (LAPTOP, PHONE):
            resize(page, size)
            assert page.evaluate(CUT) == []


def test_impacts_break_between_paths_and_each_one_is_whole_or_hidden(at_rest):
    paths = ["1-2-3", "1-2-3-4", "1-2-3-4-5", "1-2-3-4-5-6", "1-2-3-4-5-6-7"]
    at_rest.evaluate(
        "lines => shows.impacts(lines)", [f"t = 12.34 s  {path}  {path}  {path}" for path in paths]
    )
    box = at_rest.locator(".trains").evaluate(EDGES)
    trains = [line.evaluate(EDGES) for line in at_rest.locator(".trains div").all()]
    seen = [bottom <= box[3] + 1 for left, _, _, bottom in trains if left < box[2]]
    assert 2 <= len(seen) < 5 and all(seen)
    assert (
        at_rest.evaluate(
            "find('.trains span').map(path => path.getClientRects().length > 1)"
        ).count(True)
        == 0
    )


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
        wait_until(
            lambda is_dark=is_dark: (at_rest.evaluate("glowObjs[0].background.x") < 0.3) == is_dark
        )
        paper = at_rest.locator(".panel").evaluate(
            "e => parseInt(getComputedStyle(e).backgroundColor.slice(4))"
        )
        assert (paper < 128) == is_dark
    at_rest.emulate_media(forced_colors="active")
    curves = at_rest.locator(".legendColorBox div div").all()
    # The legend's colors
    assert len({curve.evaluate("e => getComputedStyle(e).borderColor") for curve in curves}) == 3
    at_rest.emulate_media(forced_colors="none")


def test_one_finger_drags_a_bob_or_turns_the_camera_and_two_zoom(at_rest):
    fingers = at_rest.context.new_cdp_session(at_rest)

    # Kind is Start, Move or End, with a finger at each of the points (x, y)
    def touch(kind, *points):
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
    at_rest.evaluate("glowObjs[0].forward = vec(0, 0.5, -1)")
    wait_until(lambda: at_rest.evaluate("glowObjs[0].forward.y") == 0)  # never below the base


def test_controls_have_names_and_values_and_keep_their_keys(at_rest):
    at_rest.get_by_role(
        "img", name=re.compile("Newton's cradle with 5 bobs: t .* s, energy .* %")
    ).wait_for()
    assert violations(at_rest) == {}
    slider = at_rest.get_by_role("slider", name="Bobs lifted")
    slider.focus()
    for lifted in (1, 2):
        slider.press("ArrowRight")  # lifts one bob more
        wait_until(lambda lifted=lifted: slider.get_attribute("aria-valuetext") == f"{lifted} of 5")
    slider.press("Home")
    at_rest.get_by_role("button", name="Run").focus()
    at_rest.keyboard.press("Space")  # once, not twice
    at_rest.get_by_role("button", name="Pause").wait_for()
    wait_until(lambda: readout(at_rest, "t") > 0)
    press(at_rest, "Keys")
    at_rest.get_by_text("answer a question").wait_for()
    assert violations(at_rest) == {}


def test_a_browser_without_webgl_is_offered_the_terminal_cradle(driver, shared, started):
    arguments = ["--no-sandbox", "--disable-3d-apis"]
    with driver.chromium.launch(executable_path=programs.CHROMIUM, args=arguments) as browser:
        blind = browser.new_page()
        blind.set_default_timeout(programs.SECONDS * 1000)
        blind.goto(shared.url)
        blind.get_by_text(
            "This browser cannot draw the cradle: WebGL 2 is missing or switched off."
        ).wait_for()
        command = shlex.split(blind.locator(".notice code").inner_text())
    done = subprocess.run(
        [*command, "--seconds", "0.1"], cwd=started[1].parent, capture_output=True, text=True
    )
    assert "t = 0.10 s" in done.stdout
    programs.wait_for_moves(shared)
