"""The page asks the question of an experiment, takes answers, rests, and explains."""

from math import atan2, degrees
from typing import NamedTuple

import pytest
from rig import Rig
from students import put_files
from vpython import vector
from whole_cradles import go_on, GOOD, HEADER

from support.page import questions
from support.page.scene.marks import BEHIND

CSV = "My cradle"
TWO = "Two bobs"
KEY = "2_two_bobs"
ANSWERS = [
    "One bob, twice as fast",
    "One bob, as far as the two",
    "Two bobs, as far as the two",
    "Three bobs, not so far",
]
PREDICTED, SEEN = "predicted", "seen"


class QuestionState(NamedTuple):
    """What a tab shows of a question; answers are indices."""

    asking: str | None = None
    predicted: int | None = None
    seen: int | None = None
    outcome: int | None = None  # None before the end, too


ASKING = QuestionState(PREDICTED)


def question_of(rig):
    """Return the QuestionState of a tab, or None without a question."""
    question = rig.state["question"]
    if not question:
        return None
    outcome = question["happened"]["outcome"] if question["happened"] else None
    replies = question["replies"]
    return QuestionState(question["asking"], replies[PREDICTED], replies[SEEN], outcome)


@pytest.fixture
def asking(rig):
    """A viewer that asks what will happen in an experiment, Two bobs, and not what you saw."""
    rig.give("ask_seen", False)
    rig.give("experiment", TWO)
    return rig


def test_a_mistake_in_an_experiment_is_shown_as_plain_text_and_no_other_one_is_next(
    csv, tmp_path, monkeypatch
):
    folder = put_files(tmp_path / "experiments", {"single/one.txt": "<s>"})
    monkeypatch.setattr("support.page.chooser.EXPERIMENTS", folder)
    rig = Rig(csv)
    rig.give("next")
    assert rig.control("experiment")["choices"] == [rig.state["experiment"]] == [CSV]
    [mistake] = rig.state["mistakes"]
    assert "one.txt, line 1: found '<s>'" in mistake


def test_a_program_that_reads_another_file_does_not_end_the_page(asking, write, tmp_path):
    """A frequent mistake: make_newton_cradle forgets its parameter. The page shows that cradle."""
    other = tmp_path / "other.csv"
    other.write_text(HEADER + GOOD * 2)
    write("make_newton_cradle", f"pend_list = make_newton_cradle({str(other)!r}, R_PARAM, 0)")
    asking.give("restart")
    asking.give("edit", 1, "mass", "2")
    asking.wait(0.1)
    assert len(asking.thetas()) == 2
    assert question_of(asking) is None


def test_you_choose_an_experiment_although_the_program_has_ended(rig):
    rig.tell("experiment", TWO)
    rig.tell("restart")
    rig.viewer.go_on_after(None)
    go_on(rig.viewer)
    rig.wait()
    assert question_of(rig) == ASKING


def test_the_question_comes_before_each_release_and_the_explanation_after_it(asking):
    asking.wait(0.5)
    assert asking.time() == 0
    assert not asking.state["running"]
    assert question_of(asking) == ASKING
    question = asking.state["question"]
    assert question["question"] == "Two bobs come in. What leaves on the other side?"
    assert question["answers"] == ANSWERS
    asking.give("answer", KEY, 0)
    asking.wait(0.3)
    assert question_of(asking) == QuestionState(predicted=0)
    asking.wait(0.3)
    assert question_of(asking) == QuestionState(predicted=0, outcome=2)
    # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
    assert "two left at 1.07 and 1.07 m/s." in asking.state["question"]["happened"]["why"]
    asking.give("restart")
    assert question_of(asking) == ASKING


@pytest.mark.parametrize("command", ["step", "pause"])
def test_an_open_question_waits_for_an_answer_and_says_so(asking, command):
    """A teacher's clicker sends keys."""
    asking.give(command)
    asking.wait(0.1)
    assert asking.time() == 0
    assert asking.state["word"] == questions.WAITS
    asking.give("answer", KEY, 2)
    assert asking.state["word"] == ""


def test_an_answer_to_another_question_or_after_the_answer_does_nothing(asking):
    for value in (("1_one_bob", 0), (KEY, 4)):
        asking.give("answer", *value)
    assert question_of(asking) == ASKING
    asking.give("answer", KEY, 0)
    asking.give("answer", KEY, 1)
    assert question_of(asking).predicted == 0


def test_without_predict_first_an_experiment_runs_at_once_and_still_explains_itself(asking):
    asking.give("ask_first", False)
    wait_for_rest(asking)
    assert question_of(asking) == QuestionState(outcome=2)
    asking.give("ask_first", True)
    assert question_of(asking) == ASKING
    assert asking.time() == 0


def test_you_say_what_you_saw_before_it_is_explained(asking):
    """Until then the picture rests."""
    asking.give("ask_seen", True)
    asking.give("answer", KEY, 0)
    wait_for_question(asking)
    assert question_of(asking) == QuestionState(SEEN, predicted=0, outcome=2)
    time = asking.time()
    asking.wait(4)
    asking.give("answer", KEY, 1)
    assert question_of(asking) == QuestionState(None, predicted=0, seen=1, outcome=2)
    asking.wait(2.5)
    assert asking.time() == time
    asking.wait(1)
    assert asking.time() > time


def wait_for_question(asking):
    while not question_of(asking).asking:
        asking.wait(0.1)


def test_without_say_what_you_saw_the_page_asks_no_more(asking):
    asking.give("ask_seen", True)
    asking.give("answer", KEY, 1)
    wait_for_question(asking)
    asking.give("ask_seen", False)
    assert question_of(asking) == QuestionState(predicted=1, outcome=2)


@pytest.mark.parametrize(
    "change", [("release_angle", 10), ("e", 0.5), ("separating", True), ("edit", 0, "mass", "2")]
)
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change):
    """It is paused: else it would give the answer away."""
    asking.give(*change)
    assert question_of(asking) is None
    assert asking.state["word"] == questions.OVER
    assert asking.state["paused"]
    asking.give("ask_first", False)
    asking.give("ask_first", True)
    assert asking.state["changed"]
    assert question_of(asking) is None
    asking.give("experiment", TWO)
    assert question_of(asking) == ASKING
    assert asking.state["word"] == ""


@pytest.mark.parametrize("moves", [False, True])
def test_a_bob_that_is_moved_and_let_go_in_one_frame_ends_the_question(asking, moves):
    """As on a slow line."""
    bob = asking.viewer.cradle.bobs()[4].pos
    asking.tell("grab", bob.value, [0, 0, -1])
    asking.tell("drag", (bob + vector(0.01 * moves, 0, 0)).value, [0, 0, -1])
    asking.give("let_go")
    assert asking.state["changed"] == moves
    assert question_of(asking) == (None if moves else ASKING)


def wait_for_rest(asking):
    """Wait until the experiment is measured, and the picture rests."""
    while asking.viewer.questions.rest_end is None:
        asking.wait(0.1)


def test_a_pause_in_the_rest_ends_it(asking):
    asking.give("answer", KEY, 0)
    wait_for_rest(asking)
    time = asking.time()
    asking.give("pause")
    asking.give("pause")
    asking.wait(0.1)
    assert asking.time() > time


def test_ghosts_swing_as_far_as_the_answers_say_until_the_picture_rests_no_more(asking):
    asking.give("arrows", True)
    asking.give("answer", KEY, 0)
    asking.wait(0.2)
    assert ghosts(asking) == []
    asking.wait(0.15)
    assert 0 < ghosts(asking)[4] < 100
    wait_for_rest(asking)
    # The pale bobs that its file says, and those of the other answers: the page shows yours
    assert ghosts(asking) == pytest.approx([0, 0, 0, 0, 100])
    assert ghosts(asking, 1) == pytest.approx([0, 0, 0, 0, 45])
    assert asking.state["view"]["ghosts"] == [0] * 5 + [1] * 5 + [2] * 5 + [3] * 5
    labels = asking.state["view"]["labels"]
    assert [label["answer"] for label in labels] == [0, 1, 2, 3]
    assert {label["text"] for label in labels} == {"your answer"}
    # Most bobs stop at this moment: the bars are those after the hits
    bars = asking.state["bars"]
    assert bars["title"] == "Momentum after the hits (kg m/s)"
    assert [bar["part"] for bar in bars["bars"]] == pytest.approx([0, 0, 0, 0.5, 0.5, 1], abs=0.01)
    asking.wait(questions.REST + 0.1)
    assert ghosts(asking) == []


def ghosts(rig, answer=0):
    """Return the angles of the ghosts of an answer (degrees)."""
    axles = rig.viewer.cradle.axles()
    shown = [ghost for ghost in rig.viewer.marks.shapes["ghosts"] if ghost.visible]
    angles = []
    first = answer * len(axles)
    for ghost, axle in zip(shown[first : first + len(axles)], axles, strict=False):
        arm = ghost.pos - rig.viewer.cradle.bobs()[0].radius * BEHIND - axle.pos
        angles.append(degrees(atan2(arm.x, -arm.y)))
    return angles


@pytest.mark.parametrize(("slowly", "speed"), [(True, 0.1), (False, 2)])
def test_again_keeps_the_answer(asking, slowly, speed):
    """Slow motion ends with the rest, and the speed is as you have set it."""
    asking.give("speed", 2)
    asking.give("answer", KEY, 1)
    wait_for_rest(asking)
    asking.give("repeat", slowly)
    assert asking.time() == 0
    assert question_of(asking) == QuestionState(predicted=1)
    wait_for_rest(asking)
    assert question_of(asking) == QuestionState(predicted=1, outcome=2)
    assert asking.state["speed"] == speed
    asking.wait(questions.REST)
    assert asking.state["speed"] == 2


def test_next_and_previous_go_through_all_experiments_and_around(asking):
    names = asking.control("experiment")["choices"][1:]
    for name in (names[0], names[-1], names[-2]):
        asking.give("previous")
        assert asking.state["experiment"] == name
    for name in (names[-1], *names[:2]):
        asking.give("next")
        assert asking.state["experiment"] == name
