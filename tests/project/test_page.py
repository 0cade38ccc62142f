"""The controls of the page, in Chromium.

The tests share one page, with all settings put back between them.
"""

import re
import signal
from itertools import combinations, pairwise

import programs
import pytest
from programs import (
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
    wait_for_restart,
    wait_for_time,
    wait_until,
)
from whole_cradles import FIVE_CSV, GOOD, HEADER

# Put the settings back to those with which the page opens, pause, and restart the cradle.
PUT_BACK = """() => {
    send("experiment", state.controls.experiment.choices[0]);
    if (state.running || state.question?.asking) send("pause");
    for (const name of ["ask first", "slow hits", "arrows", "separating"]) send(name, false);
    for (const name of ["collision", "graph", "span"]) send(name, state.controls[name].choices[0]);
    send("edit", 1, "mass", "1.0");
    send("speed", 1);
    send("lifted", 1);
    send("release angle", 45);
    send("restart");
    if (one("#sound").checked) one("#sound").click();
    for (const open of find("details[open]")) open.open = false;
    one("#keys").hidePopover();
    if (document.documentElement.matches(".presenting")) present();
    document.activeElement.blur();
    resetView();
    glowObjs[0].visible = false;
}"""
IS_BACK = """() => !state.running && parseFloat(state.motion.t) === 0
    && !state.arrows && !state.question && bobs().length === 5
    && find("output").map(e => e.value).join() === "1.0x,1 of 5,45°" """

# Ask the question of the first experiment.
ASK = """async () => {
    send("ask first", true);
    send("next");
    while (!state.question) await new Promise(requestAnimationFrame);
}"""

# Before the page's own scripts: peak() is the largest sample of the last 0.7 s at the loudspeaker,
# if it is in use.
LISTEN = """
const connect = AudioNode.prototype.connect;
window.peak = () => null;
AudioNode.prototype.connect = function (to, ...others) {
    if (to === this.context.destination) {
        const tap = new AnalyserNode(this.context, { fftSize: 32768 });
        const samples = new Float32Array(tap.fftSize);
        connect.call(this, tap);
        window.audio = this.context;
        window.peak = () => {
            tap.getFloatTimeDomainData(samples);
            return Math.max(...samples.map(Math.abs));
        };
    }
    return connect.call(this, to, ...others);
};"""


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A page with a touch screen, and its program's CSV.

    In the end, nothing more was printed than at the start.
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
def file(started):
    """The CSV of the shared page."""
    return started[1]


@pytest.fixture
def shared(started, file):
    """The shared page as it opens: with its settings and its CSV.

    The first bob has just been released.
    """
    page = started[0]
    page.mouse.up()
    if file.read_text() != FIVE_CSV:
        file.write_text(FIVE_CSV)
    page.set_viewport_size({"width": 1000, "height": 700})
    page.evaluate(PUT_BACK)
    page.wait_for_function(IS_BACK)
    press(page, "Run")
    return page


def wait_for_text(page, text):
    page.get_by_text(text).wait_for()


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
    assert panel.evaluate("e => e.scrollHeight > e.clientHeight + 100")
    assert panel.evaluate("e => [scrollY, e.scrollTop]") == [0, 0]


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
    assert slider_texts(shared) == ["1.0x", "1 of 5", "45°"]
    # On a Russian keyboard, and on one in Dvorak's order
    for key in (("к", "KeyR"), ("r", "KeyO")):
        shared.evaluate(PRESS, key)
        wait_for_restart(shared)
        shared.keyboard.press("ArrowRight")
        wait_for_time(shared)
    shared.evaluate(ASK)
    for key in (("и", ""), ("и", "KeyB")):
        shared.evaluate(PRESS, key)
    wait_for_text(shared, "You said: B")  # the first answer counts


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
    menu(shared, "Graph").select_option("Phase 5")
    shared.locator(".y").get_by_text("omega (rad/s)").wait_for()
    shared.locator(".x").get_by_text("theta (rad)").wait_for()
    menu(shared, "Graph").select_option("no graph")
    plot.wait_for(state="hidden")


CURSOR = "getComputedStyle(document.querySelector('.canvas canvas:last-of-type')).cursor"
SIZES = """() => {
    const canvas = one(".canvas canvas");
    const { width, height, clientWidth, clientHeight } = canvas;
    return [width / clientWidth, height / clientHeight, labels[0].height];
}"""


def test_the_cursor_shows_that_a_bob_can_be_grabbed_and_it_is_let_go_outside_of_the_canvas(shared):
    """In a second tab, which is then moved to a display with twice the pixels.

    The canvas has them, too.
    """
    with programs.new_page(shared.context.browser) as sharp:
        programs.open_cradle(sharp, shared.url)
        display = {"width": 1000, "height": 700, "deviceScaleFactor": 2, "mobile": False}
        sharp.context.new_cdp_session(sharp).send("Emulation.setDeviceMetricsOverride", display)
        wait_until(lambda: sharp.evaluate(SIZES) == [2, 2, 24])
        slide(sharp, "Bobs lifted", 0)
        wait_for_angles(sharp, 0, 0, 0, 0, 0)
        sharp.mouse.move(*pixel(sharp, 0, 0))
        wait_until(lambda: sharp.evaluate(CURSOR) == "grab")
        programs.drag(sharp, 0, -30)
        wait_until(lambda: bob_angles(sharp)[0] == pytest.approx(-30, abs=1))
        assert sharp.evaluate(CURSOR) == "grabbing"
        sharp.mouse.move(20, 230, steps=3)  # below the canvas
        wait_until(lambda: -32 < bob_angles(sharp)[0] < -20)
        sharp.mouse.up()
        wait_until(lambda: "1-2-3-4-5" in sharp.locator(".impacts").inner_text())
        sharp.mouse.move(20, 20)
        wait_until(lambda: sharp.evaluate(CURSOR) == "auto")


# --- the CSV, experiments and the table ------------------------------------------------------


def test_an_edited_csv_shows_up_or_its_mistake(shared, file):
    file.write_text(HEADER + GOOD * 7)
    wait_until(lambda: slider_texts(shared)[1] == "1 of 7")
    slider = shared.get_by_role("slider", name="Bobs lifted")
    assert slider.evaluate("e => [e.value, e.max]") == ["1", "7"]
    programs.wait_for_cradle(shared, bobs=7)
    file.write_text(FIVE_CSV + GOOD.replace("1.0", "-1", 1))
    error = shared.locator(".error").first
    error.get_by_text(f"{file}, line 7, column mass: found '-1', allowed is ").wait_for()
    shared.set_viewport_size({"width": 1000, "height": 300})
    shared.locator("summary").scroll_into_view_if_needed()
    assert is_whole(shared, ".error")  # it sticks to the top
    file.write_text(FIVE_CSV)
    error.wait_for(state="hidden")


# Where a picture on paper begins to be red, from its left edge (0) to its right one (1).
RED = """picture => {
    const { width, height } = picture;
    const { data } = picture.getContext("2d").getImageData(0, 0, width, height);
    const isWhite = Math.min(...data.slice(0, 4)) === 255;
    if (!isWhite || !picture.checkVisibility() || one(".canvas").checkVisibility()) return NaN;
    let left = width;
    for (let place = 0; place < width * height; place++) {
        const [r, g, b] = data.slice(4 * place, 4 * place + 3);
        if (r > 100 && g < 40 && b < 40) left = Math.min(left, place % width);
    }
    return left / width;
}"""


def printed(page):
    """Have the page as it is on paper; return where the red bob is in its picture, from 0 to 1."""
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    return page.locator(".picture canvas").first.evaluate(RED)


# How many arrows, boxes and spheres are visible.
SHAPES = """() => ["arrow", "box", "sphere"].map(
    kind => glowObjs.filter(o => o?.constructor.name === kind && o.visible).length)"""


def test_a_lesson_in_present_from_the_question_to_the_sheet(shared):
    question = shared.locator(".question")
    tick(shared, "Predict first")
    programs.draw(shared, True)
    shared.keyboard.press("n")
    question.get_by_text("One bob comes in.").wait_for()
    shared.keyboard.press("n")
    question.get_by_text("Two bobs come in.").wait_for()
    # The picture of the sheet is there
    shared.wait_for_function("() => asked === state.question.question")
    programs.draw(shared, False)
    shared.keyboard.press("f")
    wait_until(lambda: menu(shared, "Collisions").is_hidden())
    assert violations(shared) == {}
    programs.wait_for_rest(shared)
    shared.locator(".hands").nth(2).click()
    wait_until(lambda: shared.locator(".hands").all_inner_texts() == ["0", "0", "1", "0"])
    assert not shared.locator(".readout").is_visible()  # it waits for the answer
    tick(shared, "Arrows")
    shared.keyboard.press("a")
    question.get_by_text("What happened: C, Two bobs, as far as the two.").wait_for()
    assert shared.evaluate(SHAPES) == [0, 6 + 6, 5 + 5]  # no bob moves while the picture rests
    said = question.get_by_text("You said: A, One bob, twice as fast. Hands: A 0, B 0, C 1, D 0.")
    assert said.is_visible()
    assert printed(shared) < 0.2  # the first bob before its release, although it hangs now
    assert shared.get_by_text("I measured").is_visible()
    assert shared.get_by_text("swung to (degrees)").is_visible()
    shared.emulate_media(media="screen")
    shared.keyboard.press("h")
    shared.locator(".hit-part").get_by_text("m/s").first.wait_for()
    wait_until(lambda: shared.evaluate(SHAPES)[0] == 2)
    shared.keyboard.press("Escape")
    menu(shared, "Collisions").wait_for()
    assert violations(shared) == {}


def test_the_table_moves_and_takes_a_mass(shared, file):
    mass = shared.get_by_label("mass of pendulum 2", exact=True)
    assert not mass.is_visible()
    shared.locator("summary").click()
    theta = shared.locator(".pendula .now").first
    wait_until(lambda: theta.inner_text() not in ("", "-0.785398"))
    pause(shared)
    press(shared, "Restart")
    wait_until(lambda: theta.inner_text() == "-0.785398")
    press(shared, "One tick")
    wait_for_text(shared, "[0] theta -0.785398 -> ")
    mass.fill("-3")
    mass.press("Tab")
    message = shared.get_by_text("mass: allowed is a number from ")
    message.wait_for()
    assert mass.get_attribute("aria-invalid") == "true"
    # Where Tab leads
    wait_until(lambda: shared.evaluate("document.activeElement.ariaLabel") == "e of pendulum 2")
    assert violations(shared) == {}
    mass.fill("2.5")
    mass.press("Enter")
    message.wait_for(state="detached")
    assert mass.input_value() == "2.5"
    assert file.read_text() == FIVE_CSV


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
    tick(shared, "Sound")
    wait_until(lambda: (shared.evaluate("peak()") or 0) > 0.1)  # a hit of the cradle
    pause(shared)
    peaks = []
    for speed in (0.1, 2, 100):
        wait_until(lambda: shared.evaluate("peak()") == 0)
        peaks.append(shared.evaluate(HIT, speed))
    slow, fast, fastest = peaks
    assert 0 < slow < 0.8 * fast
    assert fastest < 1.2 * fast
    shared.get_by_role("checkbox", name="Sound").uncheck()
    wait_until(lambda: shared.evaluate("audio.state") == "suspended")


# --- windows, screens and fingers ------------------------------------------------------------

PHONE, TABLET, LAPTOP, BOARD = (390, 844), (768, 1024), (1366, 625), (2560, 1440)

# The edges of an element, in the window: left, top, right, bottom.
EDGES = "e => (r => [r.left, r.top, r.right, r.bottom])(e.getBoundingClientRect())"
# At once: it is replaced
LETTERS = "() => parseFloat(getComputedStyle(document.querySelector('.readout')).fontSize)"


@pytest.fixture
def at_rest(shared):
    """The page in a laptop's window, with all bobs at rest.

    The canvas is as large as it is for a user.
    """
    shared.evaluate("document.querySelector('#small').disabled = true")
    resize(shared, LAPTOP)
    pause(shared)
    slide(shared, "Bobs lifted", 0)
    wait_for_angles(shared, 0, 0, 0, 0, 0)
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


def is_whole_after_scrolling(page, selector):
    """Scroll down to an element, but not sideways; return whether it is in the window."""
    scroll = "e => (e.closest('tr')?.cells[0] ?? e).scrollIntoView()"
    page.locator(selector).evaluate(scroll)
    return is_whole(page, selector)


def overlap(part1, part2):
    """Return whether two rectangles (as of EDGES) cover each other."""
    left1, top1, right1, bottom1 = part1
    left2, top2, right2, bottom2 = part2
    is_beside = right1 <= left2 or right2 <= left1
    is_above = bottom1 <= top2 or bottom2 <= top1
    return not (is_beside or is_above)


@pytest.mark.parametrize("size", [PHONE, TABLET, LAPTOP, BOARD])
def test_the_whole_swing_is_in_view_and_no_part_of_the_panel_covers_another(at_rest, size):
    resize(at_rest, size)
    assert is_whole(at_rest, "canvas")
    left, _, right, _ = edges(at_rest, "canvas")
    wait_until(lambda: left < pixel(at_rest, 0, -90)[0] < pixel(at_rest, 4, 90)[0] < right)
    # The graph follows the window, too
    wait_until(lambda: edges(at_rest, ".graph")[2] <= size[0])
    assert at_rest.evaluate(CUT) == []
    sections = at_rest.locator(".panel section").all()
    parts = [part.evaluate(EDGES) for part in sections if part.is_visible()]
    for part1, part2 in combinations(parts, 2):
        assert not overlap(part1, part2)


@pytest.mark.parametrize("size", [PHONE, TABLET])
def test_a_tall_window_has_the_buttons_in_view_and_scrolls_up_and_down_to_the_rest(at_rest, size):
    resize(at_rest, size)
    for name in ("Run", "Step", "Restart"):
        assert is_whole(at_rest, f"button:has-text('{name}')")
    at_rest.locator("summary").click()
    for name in ("tr:has(.now:not(:empty)) [aria-label='e of pendulum 5']", ".fold summary"):
        wait_until(lambda name=name: is_whole_after_scrolling(at_rest, name))
    assert at_rest.evaluate("(e => e.scrollWidth - e.clientWidth)(one('.panel'))") == 0


@pytest.mark.parametrize("size", [LAPTOP, BOARD])
def test_a_wide_window_has_all_in_view_beside_a_large_cradle(at_rest, size):
    resize(at_rest, size)
    assert at_rest.evaluate("(e => e.scrollHeight - e.clientHeight)(one('.panel'))") == 0
    for selector in (".readout", ".impacts", ".graph", "select", "summary"):
        assert is_whole(at_rest, selector)
    left, _, right, _ = edges(at_rest, "canvas")
    assert right < edges(at_rest, ".panel")[0] + 1
    assert right - left >= 0.56 * size[0]
    swing = pixel(at_rest, 4, 90)[0] - pixel(at_rest, 0, -90)[0]
    assert swing >= 0.8 * (right - left)
    assert at_rest.evaluate(LETTERS) >= 0.022 * size[1]


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
    """24 pixels in the settings of the browser.

    The small text follows, and the texts in the canvas.
    """
    arguments = [*programs.ARGUMENTS, "--blink-settings=defaultFontSize=24"]
    sizes = """() => [
        getComputedStyle(document.body).fontSize,
        getComputedStyle(one(".impacts")).fontSize,
        labels[0].height,
    ]"""
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


def test_impacts_break_between_chains_and_each_line_is_whole_or_hidden(at_rest):
    chains = ["1-2-3", "1-2-3-4", "1-2-3-4-5", "1-2-3-4-5-6", "1-2-3-4-5-6-7"]
    lines = [f"t = 12.34 s  {chain}  {chain}  {chain}" for chain in chains]
    at_rest.evaluate("lines => shows.impacts(lines)", lines)
    _, _, box_right, box_bottom = edges(at_rest, ".series")
    visible = 0
    for line in at_rest.locator(".series div").all():
        left, _, _, bottom = line.evaluate(EDGES)
        if left < box_right:  # else it is in a column that is hidden
            visible += 1
            assert bottom <= box_bottom + 1
    assert 2 <= visible < 5
    rows = at_rest.evaluate("find('.series span').map(chain => chain.getClientRects().length)")
    assert max(rows) == 1


def test_present_leaves_cradle_and_numbers(at_rest):
    before = at_rest.evaluate(LETTERS)
    at_rest.keyboard.press("f")
    wait_until(lambda: menu(at_rest, "Collisions").is_hidden())
    assert edges(at_rest, ".canvas")[2] == at_rest.evaluate("innerWidth")
    assert is_whole(at_rest, ".readout")
    assert at_rest.evaluate(LETTERS) > 1.5 * before
    at_rest.keyboard.press("f")
    menu(at_rest, "Collisions").wait_for()
    press(at_rest, "Present")
    press(at_rest, "End the presentation")
    menu(at_rest, "Collisions").wait_for()
    assert at_rest.locator(".leave").is_hidden()


def test_light_dark_and_forced_colors_follow_the_system(at_rest):
    paper = "parseInt(getComputedStyle(one('.panel')).backgroundColor.slice(4))"
    at_rest.emulate_media(color_scheme="dark")
    wait_until(lambda: at_rest.evaluate("glowObjs[0].background.x") < 0.3)
    assert at_rest.evaluate(paper) < 128
    at_rest.emulate_media(color_scheme="light")
    wait_until(lambda: at_rest.evaluate("glowObjs[0].background.x") > 0.3)
    assert at_rest.evaluate(paper) > 128
    at_rest.emulate_media(forced_colors="active")
    legend = at_rest.evaluate(
        "find('.legendColorBox div div').map(e => getComputedStyle(e).borderColor)"
    )
    assert len(legend) == len({*legend}) == 3
    at_rest.emulate_media(forced_colors="none")


def test_one_finger_drags_a_bob_or_turns_the_camera_and_two_zoom(at_rest):
    fingers = at_rest.context.new_cdp_session(at_rest)

    def touch(kind, *points):
        """Kind is Start, Move or End, with a finger at each of the points (x, y)."""
        points = [{"x": x, "y": y} for x, y in points]
        fingers.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": points})

    def view():
        return at_rest.evaluate("[glowObjs[0].forward.x, glowObjs[0].range]")

    turn, size = view()
    x, y = pixel(at_rest, 4, 0)
    radius = (x - pixel(at_rest, 3, 0)[0]) / 2.1
    touch("Start", (x, y + 1.3 * radius))  # a finger is not exact
    touch("Move", pixel(at_rest, 4, 20))
    touch("Move", pixel(at_rest, 4, 40))
    wait_until(lambda: bob_angles(at_rest)[4] == pytest.approx(40, abs=3))
    assert view() == [turn, size]
    touch("End")
    touch("Start", (60, 60))
    touch("Move", (90, 60))
    touch("Move", (140, 60))
    touch("End")
    wait_until(lambda: view()[0] != turn)
    touch("Start", (200, 60), (300, 60))
    for apart in (20, 40, 60, 80):
        touch("Move", (200 - apart, 60), (300 + apart, 60))
    touch("End")
    wait_until(lambda: view()[1] != size)
    at_rest.evaluate("glowObjs[0].forward = vec(0, 0.5, -1)")
    wait_until(lambda: at_rest.evaluate("glowObjs[0].forward.y") == 0)  # never below the base


def test_controls_have_names_and_values_and_keep_their_keys(at_rest):
    words = re.compile("Newton's cradle with 5 bobs: t .* s, energy .* %")
    at_rest.get_by_role("img", name=words).wait_for()
    slider = at_rest.get_by_role("slider", name="Bobs lifted")
    slider.press("ArrowRight")  # lifts one bob more
    wait_until(lambda: slider.get_attribute("aria-valuetext") == "1 of 5")
    slider.press("Home")
    button(at_rest, "Run").press("Space")  # once, not twice
    button(at_rest, "Pause").wait_for()
    wait_for_time(at_rest)
    press(at_rest, "Keys")
    wait_for_text(at_rest, "answer a question")
    assert violations(at_rest) == {}


def test_a_browser_without_webgl_is_offered_the_terminal_cradle(driver, shared):
    arguments = ["--no-sandbox", "--disable-3d-apis"]
    with driver.chromium.launch(executable_path=programs.CHROMIUM, args=arguments) as browser:
        blind = browser.new_page()
        blind.set_default_timeout(programs.SECONDS * 1000)
        blind.goto(shared.url)
        wait_for_text(
            blind, "This browser cannot draw the cradle: WebGL 2 is missing or switched off."
        )
        command = blind.locator(".notice code").inner_text()
        assert command.endswith("src/text_cradle_run.py")
    programs.wait_for_moves(shared)
