"""The page to play with, in Chromium: the controls that leave no trace, tried on one page that the tests share."""

import re
from itertools import pairwise

import pytest
from pages import csv_of, from_start, LIFTED, lifts, menu, pixel, slide, SPEED, unfold, values, wait_for_lifts
from programs import (
    BOBS,
    copy_project,
    first_lines,
    MOVES,
    needs_vpython,
    new_page,
    open_cradle,
    pause,
    press,
    PROGRAM,
    readout,
    running,
    SECONDS,
    wait_until,
)
from whole_cradles import FIVE_CSV, GOOD, HEADER, PERIOD

from support.playback.real_time import FRAME

pytestmark = needs_vpython

# The bobs' colors, as the page has them.
COLORS = BOBS.replace("[o.pos.x, o.pos.y]", "[o.color.x, o.color.y, o.color.z]")
RED, BLUE = [1, 0, 0], [0, 0, 1]

# Click the button that pauses or runs. A click by Playwright waits for two pictures: slow without a graphics card.
PAUSE_OR_RUN = "document.querySelector('button').click()"

# Put the cradle back to its start, with the settings with which the page opens.
PUT_BACK = """() => {
    for (const menu of document.querySelectorAll("select")) {
        menu.selectedIndex = 0;
        menu.dispatchEvent(new Event("change"));
    }
    for (const box of document.querySelectorAll("input[type=checkbox]:checked")) box.click();
    for (const open of document.querySelectorAll("details[open]")) open.open = false;
    document.activeElement.blur();
    const keys = { keyCode: 49, key: "1", bubbles: true };
    document.body.dispatchEvent(new KeyboardEvent("keydown", keys));
    document.body.dispatchEvent(new KeyboardEvent("keyup", keys));
}"""


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A paused page in Chromium with five bobs, and its program's CSV, for the tests that need no page of their own."""
    program = copy_project(tmp_path_factory.mktemp("shared"), FIVE_CSV) / "src" / PROGRAM.name
    with (
        running(program, "--angle", "45", folder=program.parent, patience=60 * SECONDS) as process,
        new_page(chromium) as page,
    ):
        open_cradle(page, first_lines(process))
        page.evaluate(PAUSE_OR_RUN)
        yield page, csv_of(program)


@pytest.fixture
def shared_csv(started):
    """The CSV of the shared page."""
    return started[1]


@pytest.fixture
def shared(started):
    """The shared page, put back to how it opens: the settings, the CSV, and a first bob that has just been released."""
    page, csv = started
    if csv.read_text() != FIVE_CSV:
        csv.write_text(FIVE_CSV)
        wait_until(lambda: page.evaluate(COLORS) == [RED] * 5)
    if values(page)[SPEED] != "1.0x":
        slide(page, SPEED, 0.475)
    page.evaluate(PUT_BACK)
    wait_until(lambda: values(page) == ["1.0x", "1 of 5", "45°"] and readout(page, "t") == 0)
    page.evaluate(PAUSE_OR_RUN)
    page.get_by_role("button", name="Pause").wait_for()
    yield page
    page.mouse.up()
    if page.get_by_role("button", name="Pause").count():
        page.evaluate(PAUSE_OR_RUN)  # the tests of other pages need the processor


def test_pause_stops_and_run_goes_on(shared):
    pause(shared)
    paused = readout(shared, "t")
    press(shared, "Run")
    wait_until(lambda: readout(shared, "t") > paused + 0.2)
    wait_until(lambda: shared.evaluate(MOVES) > 0)


def test_step_moves_once_while_paused(shared):
    assert shared.get_by_role("button", name="Step").is_disabled()
    pause(shared)
    t, bobs = readout(shared, "t"), shared.evaluate(BOBS)
    press(shared, "Step")
    wait_until(lambda: shared.evaluate(BOBS) != bobs and readout(shared, "t") != t)
    assert shared.evaluate(MOVES) == 0
    assert readout(shared, "t") - t == pytest.approx(FRAME, abs=0.01)


def test_restart_begins_anew(shared):
    wait_until(lambda: readout(shared, "t") > 0.3)
    pause(shared)
    press(shared, "Restart")
    wait_for_lifts(shared, -45, 0, 0, 0, 0)
    wait_until(lambda: readout(shared, "t") == 0)
    assert shared.locator(".impacts").inner_text().strip() == "Impacts"


def test_a_slider_can_be_put_back_to_where_it_was_before_a_key_was_pressed(shared):
    """VPython would say nothing of it, as it said the same the last time."""
    for _ in range(2):
        slide(shared, LIFTED, 0.99)
        wait_until(lambda: values(shared)[LIFTED] == "5 of 5")
        shared.keyboard.press("1")
        wait_until(lambda: values(shared)[LIFTED] == "1 of 5")


def test_collisions(shared):
    """Elastic, the first train leaves four of five bobs behind; inelastic, all five go on together."""
    slide(shared, SPEED, 0.25)  # so that there is time to look
    from_start(shared)
    wait_until(lambda: lifts(shared)[4] > 20)
    assert max(map(abs, lifts(shared)[:4])) < 2
    slide(shared, SPEED, 0.99)
    menu(shared, "Collisions").select_option("inelastic, e = 0")
    from_start(shared)
    wait_until(lambda: readout(shared, "t") > 0.45 * PERIOD)
    together = lifts(shared)
    assert max(together) - min(together) < 2
    assert readout(shared, "energy") == pytest.approx(20, abs=0.5)  # five times the mass, a fifth of the speed


def test_the_readout_and_the_strip_are_there_to_be_read(shared):
    from_start(shared)
    wait_until(lambda: "s  " in shared.locator(".impacts").inner_text())
    assert re.search(r"^t = \d\.\d\d s  1-2", shared.locator(".impacts").inner_text(), re.MULTILINE)
    pause(shared)
    both = readout(shared, "kinetic") + readout(shared, "potential")
    assert both == pytest.approx(readout(shared, "energy"), abs=0.11) == pytest.approx(100, abs=0.1)


def curves(page):
    """Return the labels of the curves in the graph, from its legend."""
    return page.locator(".glowscript-graph .legend").all_inner_texts()


def test_the_graph_has_a_choice(shared):
    graph, choice = shared.locator(".glowscript-graph"), menu(shared, "Graph")
    graph.wait_for(state="visible")
    wait_until(lambda: " ".join(curves(shared)).split() == ["kinetic", "potential", "total"])
    wait_until(lambda: graph.locator(".yAxis .tickLabel").count() > 2)
    ticks = [float(tick) for tick in graph.locator(".yAxis .tickLabel").all_inner_texts()]
    steps = [b - a for a, b in pairwise(sorted(ticks))]
    assert steps == pytest.approx([steps[0]] * len(steps))  # which VPython's own, rounded ones are not always
    assert min(ticks) == 0
    choice.select_option("Angles theta (rad)")
    wait_until(lambda: " ".join(curves(shared)).split() == ["1", "2", "3", "4", "5"])
    wait_until(lambda: any("-" in tick for tick in graph.locator(".yAxis .tickLabel").all_inner_texts()))
    choice.select_option("Phase picture of bob 5: omega over theta")
    wait_until(lambda: "".join(curves(shared)) == "")
    choice.select_option("no graph")
    graph.wait_for(state="hidden")
    choice.select_option("Energies (J)")
    graph.wait_for(state="visible")


def test_a_bob_is_let_go_outside_of_the_canvas(shared):
    slide(shared, LIFTED, 0.01)
    wait_for_lifts(shared, 0, 0, 0, 0, 0)
    shared.mouse.move(*pixel(shared, 0, 0))
    shared.mouse.down()
    shared.mouse.move(*pixel(shared, 0, -30), steps=3)
    wait_until(lambda: lifts(shared)[0] == pytest.approx(-30, abs=0.5))
    shared.mouse.move(20, 230, steps=3)  # on the panel
    wait_until(lambda: -28 < lifts(shared)[0] < -20)
    shared.mouse.up()
    wait_until(lambda: "1-2-3-4-5" in shared.locator(".impacts").inner_text())


def test_the_data_are_saved_and_the_page_says_where(shared, shared_csv):
    wait_until(lambda: readout(shared, "t") > 1)
    unfold(shared, "Take away")
    press(shared, "Save data")
    saved = shared.locator(".saved", has_text="rows are in")
    saved.wait_for()
    file = shared_csv.with_name("src") / "cradle_data_1.csv"
    assert saved.inner_text().endswith(f" rows are in {file}")
    times = [float(line.partition(",")[0]) for line in file.read_text().splitlines()[1:]]
    assert times == pytest.approx([0.01 * i for i in range(len(times))])
    assert times[-1] > 1


def test_an_edited_csv_shows_up_and_its_objects_are_used_again(shared, shared_csv):
    shapes = "glowObjs.filter(o => o && o.constructor.name.match(/box|sphere|cylinder/)).length"
    seven = HEADER + GOOD * 5 + "3.0,1.0,0,0,white,wood\n" * 2
    counts = set()
    for _ in range(3):
        shared_csv.write_text(seven)
        wait_until(lambda: len(shared.evaluate(BOBS)) == 7 and values(shared)[LIFTED] == "1 of 7")
        counts.add(shared.evaluate(shapes))
        shared_csv.write_text(FIVE_CSV)
        wait_until(lambda: len(shared.evaluate(BOBS)) == 5)
        counts.add(shared.evaluate(shapes))
    assert len(counts) == 1
    blue = FIVE_CSV.replace("red", "blue")  # on shapes that were another color before
    shared_csv.write_text(blue)
    wait_until(lambda: shared.evaluate(COLORS) == [BLUE] * 5)
