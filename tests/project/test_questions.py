"""The experiments on the page, on the stand-in: the menu, the question before the release, and what follows."""

import re

import pytest
from vpython import vector
from wall import set_slider, Wall
from whole_cradles import FIVE_CSV, GOOD, HEADER

from src.beyond.live_double_cradle import LiveDoubleCradle
from support.files.experiments import EXPERIMENTS
from support.page.commands import Command

ONE, TWO, HEAVY = 0, 1, 4  # indices of experiments


@pytest.fixture
def asking(wall):
    """A viewer that asks the question of an experiment, Two bobs."""
    tick(wall, True)
    choose(wall, TWO)
    return wall


def choose(wall, number):
    """Choose an experiment as a person does."""
    menu = wall.viewer.questions.menu
    menu.index = 0 if number is None else number + 1
    menu.bind(menu)
    wall.wait()


def tick(wall, checked):
    """Tick the box Ask first as a person does, or untick it."""
    box = wall.viewer.questions.box
    box.checked = checked
    box.bind(box)
    wall.wait()


def shown(wall):
    """Return the lines of the question's area."""
    return [re.sub("<.*?>", "", line) for line in re.split("</p>|</button>", wall.viewer.questions.area.text)[:-1]]


def test_the_menu_has_your_csv_and_the_experiments(wall):
    questions = wall.viewer.questions
    assert questions.menu.choices == ["your CSV", *(experiment.name for experiment in questions.experiments)]
    assert questions.menu.selected == "your CSV"
    assert len(questions.experiments) == len(list((EXPERIMENTS / "single").glob("*.csv")))


def test_an_experiment_is_made_by_main_from_its_csv_and_lifted_as_it_says(wall):
    wall.panel.collisions.selected = "inelastic, e = 0"
    wall.panel.collisions.bind(wall.panel.collisions)
    wall.viewer.cradle.mass = 3.0  # as with --mass
    choose(wall, HEAVY)
    assert [pend["mass"] for pend in wall.viewer.cradle.pend_list] == [5, 1, 1, 1, 1]
    assert [pend["e"] for pend in wall.viewer.cradle.pend_list] == [1] * 5
    assert wall.lifts() == [45, 0, 0, 0, 0]
    assert wall.panel.collisions.selected == "as in the CSV"
    assert shown(wall) == []
    choose(wall, 3)
    assert wall.lifts() == [45, 0, 0, 0, 45]
    assert [pend["theta"] > 0 for pend in wall.viewer.cradle.pend_list] == [False, False, False, False, True]
    assert wall.panel.lifted.text.text == '<span class="value">1 of 5</span>'


def test_back_at_your_csv_everything_is_as_you_had_set_it(wall):
    set_slider(wall.panel.angles[0], 20)
    set_slider(wall.panel.lifted, 0.4)
    wall.panel.collisions.selected = "inelastic, e = 0"
    wall.panel.collisions.bind(wall.panel.collisions)
    wall.wait()
    wall.viewer.cradle.mass = 3.0
    choose(wall, HEAVY)
    choose(wall, ONE)
    choose(wall, None)
    assert wall.lifts() == [20, 20, 0, 0, 0]
    assert [pend["e"] for pend in wall.viewer.cradle.pend_list] == [0] * 5
    assert [pend["mass"] for pend in wall.viewer.cradle.pend_list] == [3] * 5
    assert wall.panel.collisions.selected == "inelastic, e = 0"


def test_the_sliders_and_keys_change_an_experiment_too(wall):
    choose(wall, TWO)
    set_slider(wall.panel.angles[0], 10)
    wall.wait()
    assert wall.lifts() == [10, 10, 0, 0, 0]
    wall.press("3")
    assert wall.lifts() == [10, 10, 10, 0, 0]
    wall.press("r")
    assert wall.lifts() == [10, 10, 10, 0, 0]


def test_the_question_comes_before_the_release(asking):
    assert shown(asking) == [
        "Two bobs come in. What leaves on the other side?",
        "One bob, twice as fast",
        "One bob, as far as the two",
        "Two bobs, as far as the two",
        "Three bobs, not so far",
        "Run it without an answer",
    ]
    asking.wait(3)
    assert (asking.time(), asking.lifts()) == (0, [45, 45, 0, 0, 0])
    assert asking.panel.pause.text == "Run"


@pytest.mark.parametrize(
    ("answer", "said", "happened"),
    [
        (2, ["You said: Two bobs, as far as the two."], "That is what happened."),
        (0, ["You said: One bob, twice as fast."], "What happened: Two bobs, as far as the two."),
        (None, [], "What happened: Two bobs, as far as the two."),
    ],
)
def test_an_answer_runs_it_and_then_comes_what_happened_and_why(asking, answer, said, happened):
    asking.viewer.give(Command.ANSWER, ["2_two_bobs", answer])
    asking.wait(0.3)
    assert shown(asking) == ["Two bobs come in. What leaves on the other side?", *said]
    assert asking.time() > 0.2
    asking.wait(0.3)
    *_, result = shown(asking)
    assert shown(asking)[:-1] == ["Two bobs come in. What leaves on the other side?", *said]
    # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
    assert result.startswith(f"{happened} Two bobs came in at 1.07 m/s, and two left at 1.07 and 1.07 m/s.")
    assert asking.panel.pause.text == "Pause"
    asking.wait(1)
    assert shown(asking)[-1] == result


@pytest.mark.parametrize("go_on", [" ", "right", Command.TICK])
def test_it_also_runs_without_an_answer(asking, go_on):
    """Picture by picture and tick by tick, too; what is measured begins at the release."""
    if go_on is Command.TICK:
        asking.viewer.give(go_on)
    else:
        asking.press(go_on)
    asking.wait(0.05)
    assert shown(asking) == ["Two bobs come in. What leaves on the other side?"]
    assert 0 < asking.viewer.motion.ticks < 1000
    if asking.panel.pause.text == "Run":
        asking.panel.pause.bind()
    asking.wait(0.6)
    assert shown(asking)[-1].startswith("What happened: Two bobs, as far as the two. Two bobs came in at 1.07 m/s")


OTHERS = [["1_one_bob", 0], ["5_heavy_hits_light", None], ["2_two_bobs", 99], ["2_two_bobs", -1]]


@pytest.mark.parametrize("value", OTHERS)
def test_an_answer_to_another_question_does_nothing(asking, value):
    """You may click faster than the page shows the new question."""
    asking.viewer.give(Command.ANSWER, value)
    asking.wait(0.5)
    assert (len(shown(asking)), asking.time()) == (6, 0)
    choose(asking, None)
    asking.panel.pause.bind()
    asking.wait()
    asking.viewer.give(Command.ANSWER, ["2_two_bobs", 0])
    time = asking.time()
    asking.wait(0.5)
    assert (shown(asking), asking.time()) == ([], time)


def test_each_restart_asks_again(asking):
    asking.viewer.give(Command.ANSWER, ["2_two_bobs", 0])
    asking.wait(1)
    asking.press("r")
    assert len(shown(asking)) == 6
    assert (asking.time(), asking.panel.pause.text) == (0, "Run")


def test_the_box_asks_at_once_and_takes_the_question_back(wall):
    choose(wall, TWO)
    wall.wait(1)
    tick(wall, True)
    assert (wall.time(), len(shown(wall))) == (0, 6)
    tick(wall, False)
    wall.wait(1)
    assert shown(wall) == []
    assert wall.time() > 0.5


def test_the_box_asks_nothing_about_your_csv(wall):
    wall.wait(1)
    tick(wall, True)
    assert shown(wall) == []
    assert wall.time() > 0.9


def change_collisions(wall):
    wall.panel.collisions.selected = "inelastic, e = 0"
    wall.panel.collisions.bind(wall.panel.collisions)


def grab(wall):
    wall.mouse("mousedown", vector(wall.viewer.cradle.bobs()[4].pos))


CHANGES = {
    "angle": lambda wall: set_slider(wall.panel.angles[0], 10),
    "lift": lambda wall: wall.press("4"),
    "collisions": change_collisions,
    "separating": lambda wall: wall.viewer.give(Command.SEPARATING, True),
    "drag": grab,
    "edit": lambda wall: wall.viewer.give(Command.EDIT, [0, "mass", "2"]),
    "delete": lambda wall: wall.viewer.give(Command.DELETE, 0),
    "file": lambda wall: (wall.file.write_text(HEADER + GOOD * 5 + GOOD), wall.wait(1)),
}


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("answered", [False, True])
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change, answered):
    if answered:
        asking.viewer.give(Command.ANSWER, ["2_two_bobs", 0])
        asking.wait(0.1)
    CHANGES[change](asking)
    asking.wait(0.6)  # the measurement would be over
    assert shown(asking) == []
    assert asking.panel.pause.text == "Pause"  # only the question has held it up
    assert asking.viewer.questions.menu.selected == ("your CSV" if change == "file" else None)
    asking.press("r")
    tick(asking, False)
    tick(asking, True)
    assert shown(asking) == []
    choose(asking, TWO)
    assert len(shown(asking)) == 6


def test_a_saved_csv_comes_back_into_view(wall, csv):
    choose(wall, TWO)
    csv.write_text(FIVE_CSV + GOOD)
    wall.wait(1)
    assert len(wall.thetas()) == 6
    assert wall.viewer.questions.menu.selected == "your CSV"


def test_a_bad_csv_leaves_the_experiment_alone(wall, csv):
    choose(wall, HEAVY)
    csv.write_text("mass\n")
    wall.wait(1)
    assert len(wall.thetas()) == 5
    assert wall.viewer.cradle.pend_list[0]["mass"] == 5
    assert "column e" in wall.panel.error.text


def test_the_double_cradle_has_its_own(csv):
    wall = Wall(csv, 30, 10, kind=LiveDoubleCradle)
    names = [experiment.name for experiment in wall.viewer.questions.experiments]
    assert wall.viewer.questions.menu.choices == ["your CSV", *names]
    choose(wall, names.index("Two double pendula"))
    assert wall.lifts() == [45, 45, 0, 0, 0]
    assert [pend["phi"] for pend in wall.viewer.cradle.pend_list] == pytest.approx([-0.349066] * 2 + [0] * 3)


def test_a_mistake_in_an_experiment_is_shown_below_the_menu(csv, tmp_path, monkeypatch):
    folder = tmp_path / "experiments" / "single"
    folder.mkdir(parents=True)
    (folder / "no_<text>.csv").write_text(FIVE_CSV)
    texts = []
    monkeypatch.setattr("support.page.workbench.EXPERIMENTS", folder.parent)
    monkeypatch.setattr("support.page.questions.wtext", lambda text="": texts.append(text))
    wall = Wall(csv)
    assert wall.viewer.questions.menu.choices == ["your CSV"]
    [mistake] = [text for text in texts if text]
    assert mistake.startswith('<span class="failed">')
    assert "no_&lt;text&gt;.txt: cannot be read: No such file or directory" in mistake


def test_a_main_that_reads_another_file_does_not_end_the_page(asking, monkeypatch, tmp_path):
    """A frequent mistake: make_newton_cradle forgets its parameter. The page shows what it makes."""
    other, make = tmp_path / "other.csv", asking.viewer.cradle.scope["make_newton_cradle"]
    other.write_text(HEADER + GOOD * 2)
    monkeypatch.setitem(asking.viewer.cradle.scope, "make_newton_cradle", lambda _, *given: make(other, *given))
    choose(asking, HEAVY)
    asking.wait(1)
    assert len(asking.thetas()) == 2
    assert shown(asking) == []


def test_the_program_can_begin_with_an_experiment(csv):
    wall = Wall(csv, None, experiment="2_two_bobs", lifted=None)
    assert wall.lifts() == [45, 45, 0, 0, 0]
    assert wall.viewer.questions.menu.selected == "Two bobs"
    choose(wall, None)
    assert wall.lifts() == [45, 0, 0, 0, 0]


def test_options_for_the_release_replace_those_of_the_experiment(csv):
    wall = Wall(csv, 20, experiment="2_two_bobs", lifted=3)
    assert wall.lifts() == [20, 20, 20, 0, 0]
