"""Experiments, and the table of the pendula, in Chromium: on one page that the tests share."""

import pytest
from pages import LIFTED, lifts, menu, unfold, values, wait_for_lifts
from programs import (
    copy_project,
    first_lines,
    MOVES,
    needs_vpython,
    new_page,
    open_cradle,
    pause,
    press,
    PROGRAM,
    ROOT,
    running,
    SECONDS,
    wait_until,
)
from whole_cradles import FIVE_CSV

from src.pds_helper import extract_and_convert

pytestmark = needs_vpython


@pytest.fixture(scope="module")
def started(chromium, tmp_path_factory):
    """A page that begins with an experiment, and its program's project; one experiment is bad."""
    project = copy_project(tmp_path_factory.mktemp("experiments"), FIVE_CSV)
    (project / "support" / "experiments" / "single" / "mine.csv").write_text(FIVE_CSV)
    program = project / "src" / PROGRAM.name
    with (
        running(program, "--experiment", "2_two_bobs", patience=60 * SECONDS) as process,
        new_page(chromium) as page,
    ):
        open_cradle(page, first_lines(process))
        yield page, project


@pytest.fixture
def shared(started):
    """The shared page, with the experiment Two bobs."""
    page, _ = started
    if page.get_by_role("checkbox", name="Ask first").is_checked():
        page.get_by_role("checkbox", name="Ask first").uncheck()
    for name, lifted in (("your CSV", "1 of 5"), ("Two bobs", "2 of 5")):
        menu(page, "Experiment").select_option(name)
        wait_until(lambda lifted=lifted: values(page)[LIFTED] == lifted)
    if page.get_by_role("button", name="Run", exact=True).count():
        press(page, "Run")
    return page


@pytest.fixture
def project(started):
    return started[1]


def test_the_program_begins_with_the_experiment_of_the_command(started):
    page, _ = started
    assert menu(page, "Experiment").input_value() == "Two bobs"
    assert page.locator(".value").all_inner_texts()[1] == "2 of 5"


def test_a_bad_experiment_is_named_below_the_menu(shared, project):
    file = project / "support" / "experiments" / "single" / "mine.txt"
    assert shared.locator(".experiment .failed").inner_text() == f"{file}: cannot be read: No such file or directory"
    assert menu(shared, "Experiment").locator("option").count() == 10


def test_predict_then_see(shared):
    shared.get_by_role("checkbox", name="Ask first").check()
    shared.get_by_role("button", name="Two bobs, as far as the two").wait_for()
    wait_for_lifts(shared, -45, -45, 0, 0, 0)
    assert shared.evaluate(MOVES) == 0
    shared.get_by_role("button", name="One bob, twice as fast").click()
    result = shared.get_by_text("What happened: Two bobs, as far as the two.")
    result.wait_for()
    assert shared.get_by_text("You said: One bob, twice as fast.").is_visible()
    assert "two left at 1.07 and 1.07 m/s" in shared.locator(".question").inner_text()
    shared.keyboard.press("r")
    shared.get_by_role("button", name="Run it without an answer").click()
    result.wait_for()
    assert shared.get_by_text("You said").count() == 0


def test_the_question_is_there_while_you_present(shared):
    shared.get_by_role("checkbox", name="Ask first").check()
    answer = shared.get_by_role("button", name="Three bobs, not so far")
    answer.wait_for()
    shared.keyboard.press("f")
    wait_until(lambda: menu(shared, "Experiment").is_hidden())
    assert answer.is_visible()
    shared.keyboard.press("Escape")
    wait_until(lambda: menu(shared, "Experiment").is_visible())


def cell(page, column, row):
    return page.get_by_label(f"{column} of pendulum {row}", exact=True)


def test_the_table_is_edited_and_written(shared, project):
    csv = project / "newton_cradle_pends.csv"
    assert cell(shared, "mass", 1).count() == 0  # folded away
    unfold(shared, "Pendula")
    mass = cell(shared, "mass", 2)
    mass.fill("-3")
    mass.press("Tab")
    rule = shared.locator(".pendula .failed")
    rule.wait_for()
    assert rule.inner_text() == "mass: allowed is a number from 1e-300 to 1e6 (kg)"
    assert mass.get_attribute("aria-invalid") == "true"
    wait_until(lambda: shared.evaluate("document.activeElement.ariaLabel") == "e of pendulum 2")  # where Tab leads
    mass.fill("2.5")
    mass.press("Enter")
    rule.wait_for(state="detached")
    cell(shared, "color", 5).select_option("white")
    shared.get_by_role("button", name="Add a pendulum").click()
    cell(shared, "mass", 6).wait_for()
    shared.get_by_role("button", name="Delete pendulum 1").click()
    cell(shared, "mass", 6).wait_for(state="detached")
    assert cell(shared, "mass", 1).input_value() == "2.5"
    wait_until(lambda: len(lifts(shared)) == 5)
    assert csv.read_text() == FIVE_CSV
    press(shared, "Write to my CSV")
    shared.get_by_text("has these pendula now.").wait_for()
    rows = extract_and_convert(csv)
    assert [row["mass"] for row in rows] == [2.5, 1, 1, 1, 1]
    assert [row["color"] for row in rows][-2:] == ["white", "white"]
    wait_until(lambda: menu(shared, "Experiment").input_value() == "your CSV")
    csv.write_text(FIVE_CSV)
    wait_until(lambda: cell(shared, "mass", 1).input_value() == "1.0")


def test_the_dictionaries_move_and_one_tick_is_told(shared):
    unfold(shared, "Pendula")
    theta = shared.locator(".pendula .now").first
    theta.wait_for()
    first = theta.inner_text()
    wait_until(lambda: theta.inner_text() not in ("", first))
    assert shared.get_by_role("button", name="One tick").is_disabled()
    pause(shared)
    press(shared, "Restart")
    wait_until(lambda: theta.inner_text() == "-0.785398")
    press(shared, "One tick")
    told = shared.locator(".tick")
    told.wait_for()
    assert "[0] theta -0.785398 -> " in told.inner_text()
    assert told.inner_text().splitlines()[-1] == "handle_collision was not called."
    menu(shared, "Graph").select_option("Angles theta (rad)")
    shared.get_by_role("button", name="Add a pendulum").click()
    wait_until(lambda: shared.locator(".legend").inner_text().split() == ["1", "2", "3", "4", "5", "6"])
    assert menu(shared, "Graph").input_value() == "Angles theta (rad)"
    menu(shared, "Graph").select_option("Energies (J)")
    wait_until(lambda: "total" in shared.locator(".legend").inner_text())


def test_an_experiment_that_was_changed_can_be_chosen_again(shared):
    shared.keyboard.press("3")
    wait_until(lambda: menu(shared, "Experiment").input_value() == "")
    menu(shared, "Experiment").select_option("Two bobs")
    wait_until(lambda: shared.locator(".value").all_inner_texts()[1] == "2 of 5")


def test_no_such_experiment(program):
    with running(program, "--experiment", "two") as process:
        output, error = process.communicate(timeout=SECONDS)
    names = [path.stem for path in sorted((ROOT / "support" / "experiments" / "single").glob("*.csv"))]
    assert (process.returncode, output) == (2, "")
    assert error == f"--experiment: found 'two', allowed is one of {', '.join(names)}\n"
