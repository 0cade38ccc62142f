"""The experiments on the page, on the stand-in: the menu, the question before the release, and the answer."""

import re

import pytest
from wall import Wall
from whole_cradles import FIVE_CSV, GOOD, HEADER

from support.cradle.double_cradle import DoubleCradle
from support.files.experiments import EXPERIMENTS

ONE, TWO, HEAVY = 0, 1, 4  # indices of experiments
QUESTION = "Two bobs come in. What leaves on the other side?"
THAT, OTHER = "That is what happened.", "What happened: Two bobs, as far as the two."


@pytest.fixture
def asking(wall):
    """A viewer that asks the question of an experiment, Two bobs."""
    ask_first(wall, True)
    choose(wall, TWO)
    return wall


def choose(wall, number):
    """Choose an experiment, or your CSV (None)."""
    wall.use(wall.viewer.questions.menu, index=0 if number is None else number + 1)


def ask_first(wall, checked):
    wall.use(wall.viewer.questions.box, checked=checked)


def shown(wall):
    """Return the lines of the question's area."""
    return [re.sub("<.*?>", "", line) for line in re.split("</p>|</button>", wall.viewer.questions.area.text)[:-1]]


# --- the menu --------------------------------------------------------------------------------------------------------


def test_main_makes_an_experiment_from_its_csv_and_it_is_lifted_as_its_text_says(wall):
    wall.use(wall.panel.collisions, selected="inelastic, e = 0")
    wall.viewer.cradle.mass = 3.0  # as with --mass
    choose(wall, HEAVY)
    assert (wall.values("mass"), wall.values("e")) == ([5, 1, 1, 1, 1], [1] * 5)
    assert (wall.lifts(), wall.panel.collisions.selected) == ([45, 0, 0, 0, 0], "as in the CSV")
    assert shown(wall) == []
    choose(wall, 3)
    assert wall.lifts() == [45, 0, 0, 0, 45]
    assert [theta > 0 for theta in wall.thetas()] == [False, False, False, False, True]
    assert ">1 of 5<" in wall.panel.lifted.text.text


def test_back_at_your_csv_all_is_as_you_had_set_it(wall):
    wall.use(wall.panel.angles[0].slider, value=20)
    wall.use(wall.panel.lifted.slider, value=0.4)
    wall.use(wall.panel.collisions, selected="inelastic, e = 0")
    wall.viewer.cradle.mass = 3.0
    for number in (HEAVY, ONE, None):
        choose(wall, number)
    assert (wall.lifts(), wall.panel.collisions.selected) == ([20, 20, 0, 0, 0], "inelastic, e = 0")
    assert (wall.values("mass"), wall.values("e")) == ([3] * 5, [0] * 5)


def test_the_sliders_and_keys_change_an_experiment_too(wall):
    choose(wall, TWO)
    wall.use(wall.panel.angles[0].slider, value=10)
    assert wall.lifts() == [10, 10, 0, 0, 0]
    wall.press("3")
    assert wall.lifts() == [10, 10, 10, 0, 0]


@pytest.mark.parametrize(("angle", "lifted", "lifts"), [(None, None, [45, 45, 0, 0, 0]), (20, 3, [20, 20, 20, 0, 0])])
def test_the_program_can_begin_with_an_experiment(csv, angle, lifted, lifts):
    """Options for the release replace that of the experiment."""
    wall = Wall(csv, angle, experiment="2_two_bobs", lifted=lifted)
    assert (wall.lifts(), wall.viewer.questions.menu.selected) == (lifts, "Two bobs")
    choose(wall, None)
    assert wall.lifts() == [angle or 45] * (lifted or 1) + [0] * (5 - (lifted or 1))


def test_the_double_cradle_has_its_own_experiments(csv):
    wall = Wall(csv, 30, 10, kind=DoubleCradle)
    menu, names = wall.viewer.questions.menu, [each.name for each in wall.viewer.questions.experiments]
    assert (menu.choices, menu.selected) == (["your CSV", *names], "your CSV")
    assert len(names) == len(list((EXPERIMENTS / "double").glob("*.csv")))
    choose(wall, names.index("Two double pendula"))
    assert wall.lifts() == [45, 45, 0, 0, 0]
    assert wall.values("phi") == pytest.approx([-0.349066] * 2 + [0] * 3)


def test_a_mistake_in_an_experiment_is_shown_below_the_menu(csv, tmp_path, monkeypatch):
    folder, texts = tmp_path / "experiments" / "single", []
    folder.mkdir(parents=True)
    (folder / "no_<text>.csv").write_text(FIVE_CSV)
    monkeypatch.setattr("support.page.source.EXPERIMENTS", folder.parent)
    monkeypatch.setattr("support.page.questions.wtext", lambda text="": texts.append(text))
    assert Wall(csv).viewer.questions.menu.choices == ["your CSV"]
    [mistake] = [text for text in texts if text]
    assert mistake.startswith('<span class="failed">')
    assert "no_&lt;text&gt;.txt: cannot be read: No such file or directory" in mistake


def test_a_main_that_reads_another_file_does_not_end_the_page(asking, monkeypatch, tmp_path):
    """A frequent mistake: make_newton_cradle forgets its parameter. The page shows that cradle."""
    other, make = tmp_path / "other.csv", asking.viewer.cradle.scope["make_newton_cradle"]
    other.write_text(HEADER + GOOD * 2)
    monkeypatch.setitem(asking.viewer.cradle.scope, "make_newton_cradle", lambda _, *given: make(other, *given))
    choose(asking, HEAVY)
    asking.wait(0.1)
    assert (len(asking.thetas()), shown(asking)) == (2, [])


# --- the question ----------------------------------------------------------------------------------------------------


def test_the_question_comes_before_each_release(asking):
    answers = [answer.text for answer in asking.viewer.questions.experiments[TWO].answers]
    for _ in range(2):
        assert shown(asking) == [QUESTION, *answers, "Run it without an answer"]
        asking.wait(0.5)
        assert (asking.time(), asking.lifts(), asking.panel.pause.text) == (0, [45, 45, 0, 0, 0], "Run")
        asking.viewer.give("answer", ["2_two_bobs", 0])
        asking.wait(0.1)
        assert asking.time() > 0
        asking.press("r")


@pytest.mark.parametrize(("answer", "happened"), [(2, THAT), (0, OTHER), (None, OTHER)])
def test_an_answer_runs_the_cradle_and_the_explanation_follows(asking, answer, happened):
    said = [] if answer is None else [f"You said: {asking.viewer.questions.experiments[TWO].answers[answer].text}."]
    asking.viewer.give("answer", ["2_two_bobs", answer])
    asking.wait(0.3)
    assert shown(asking) == [QUESTION, *said]
    assert asking.time() > 0.2
    asking.wait(0.3)
    *before, result = shown(asking)
    assert before == [QUESTION, *said]
    # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
    assert result.startswith(f"{happened} Two bobs came in at 1.07 m/s, and two left at 1.07 and 1.07 m/s.")
    asking.wait(0.5)
    assert shown(asking)[-1] == result


@pytest.mark.parametrize("command", ["pause", "step", "tick"])
def test_the_cradle_also_runs_without_an_answer(asking, command):
    """The measurement begins at the release."""
    asking.viewer.give(command)
    asking.wait(0.05)
    assert shown(asking) == [QUESTION]
    assert 0 < asking.viewer.motion.ticks < 1000
    if asking.panel.pause.text == "Run":
        asking.panel.pause.bind()
    asking.wait(0.6)
    assert shown(asking)[-1].startswith(f"{OTHER} Two bobs came in at 1.07 m/s")


@pytest.mark.parametrize("value", [["1_one_bob", 0], ["5_heavy_hits_light", None], ["2_two_bobs", 99]])
def test_an_answer_to_another_question_does_nothing(asking, value):
    """You may click faster than the page shows the new question."""
    asking.viewer.give("answer", value)
    asking.wait(0.1)
    assert (len(shown(asking)), asking.time()) == (6, 0)
    choose(asking, None)
    asking.click(asking.panel.pause)
    asking.viewer.give("answer", ["2_two_bobs", 0])
    asking.wait(0.1)
    assert (shown(asking), asking.panel.pause.text) == ([], "Run")


def test_the_box_asks_at_once_and_takes_the_question_back(wall):
    """It asks nothing about your CSV."""
    for number, (time, lines) in {None: (0.2, 0), TWO: (0, 6)}.items():
        choose(wall, number)
        wall.wait(0.2)
        ask_first(wall, True)
        assert (wall.time(), len(shown(wall))) == (pytest.approx(time, abs=0.05), lines)
        ask_first(wall, False)
        wall.wait(0.2)
        assert (wall.time() > 0.1, shown(wall)) == (True, [])


CHANGES = {
    "angle": lambda wall: wall.use(wall.panel.angles[0].slider, value=10),
    "lift": lambda wall: wall.press("4"),
    "collisions": lambda wall: wall.use(wall.panel.collisions, selected="inelastic, e = 0"),
    "separating": lambda wall: wall.give("separating", True),
    "drag": lambda wall: wall.mouse("mousedown", wall.viewer.cradle.bobs()[4].pos),
    "edit": lambda wall: wall.give("edit", [0, "mass", "2"]),
    "delete": lambda wall: wall.give("delete", 0),
    "file": lambda wall: wall.save(HEADER + GOOD * 6),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change):
    CHANGES[change](asking)
    asking.wait(0.6)  # the measurement would be over
    assert (shown(asking), asking.panel.pause.text) == ([], "Pause")  # only the question has held it up
    assert asking.viewer.questions.menu.selected == ("your CSV" if change == "file" else None)
    asking.press("r")
    ask_first(asking, False)
    ask_first(asking, True)
    assert shown(asking) == []
    choose(asking, TWO)
    assert len(shown(asking)) == 6
