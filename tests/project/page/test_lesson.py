"""The page asks the question of an experiment, takes answers, rests, and explains."""

from math import atan2, degrees
from typing import NamedTuple

import pytest
from vpython import vector
from whole_cradles import go_on, GOOD, HEADER

from support.constants import R_PARAM
from support.page.lesson import ASKED, EXPLAINED, OVER, REST, RUNNING, SEEN, WAITS

TWO = "Two bobs"
STEM = "02_two_bobs"


class QuestionState(NamedTuple):
    """What a tab shows of a question; answers are indices."""

    state: str
    asked: int | None = None
    seen: int | None = None
    outcome: int | None = None  # None before the explanation, too


def question_of(rig):
    """Return the QuestionState of a tab, or None without a question."""
    question = rig.state["question"]
    if not question:
        return None
    return QuestionState(question["state"], **question["replies"], outcome=question.get("outcome"))


@pytest.fixture
def asking(rig):
    """A viewer that asks what will happen in an experiment, Two bobs."""
    rig.give("experiment", TWO)
    return rig


@pytest.fixture
def asking_again(asking):
    """The same, when it asks what you have seen."""
    asking.give("answer", STEM, 0)
    wait_until_it_is(asking, SEEN)
    return asking


def wait_until_it_is(rig, state):
    while question_of(rig).state != state:
        rig.wait(0.1)


def wait_for_rest(rig):
    """Wait until the swing is over, and the picture rests."""
    while not rig.viewer.lesson.is_resting():
        rig.wait(0.1)


def test_a_program_that_reads_another_file_does_not_end_the_page(asking, write, tmp_path):
    """A frequent mistake: make_newton_cradle forgets its parameter. The page shows that cradle."""
    other = tmp_path / "other.csv"
    other.write_text(HEADER + GOOD * 2)
    write("make_newton_cradle", f"pend_list = make_newton_cradle({str(other)!r}, R_PARAM, 0)")
    asking.give("restart")
    asking.give("edit", 1, "mass", 2)
    asking.wait(0.1)
    assert len(asking.values("theta")) == 2
    assert question_of(asking) is None


def test_you_choose_an_experiment_although_the_program_has_ended(rig):
    rig.tell("experiment", TWO)
    rig.tell("restart")
    rig.viewer.go_on_after(None)
    go_on(rig.viewer)
    rig.wait()
    assert question_of(rig) == QuestionState(ASKED)


def test_a_lesson_asks_before_the_release_and_after_the_swing_and_then_explains(asking):
    asking.wait(0.5)
    assert asking.time() == 0
    assert not asking.state["running"]
    assert question_of(asking) == QuestionState(ASKED)
    question = asking.state["question"]
    assert question["question"] == "Two bobs come in. What leaves on the other side?"
    asking.give("answer", STEM, 0)
    asking.wait(0.3)
    assert question_of(asking) == QuestionState(RUNNING, asked=0)
    wait_until_it_is(asking, SEEN)
    asking.wait(1)
    # Nobody reads the answer off the picture: it is that of the release.
    assert asking.time() == 0
    assert asking.bob_angles() == [45, 45, 0, 0, 0]
    assert "why" not in asking.state["question"]
    asking.give("answer", STEM, 1)
    assert question_of(asking) == QuestionState(EXPLAINED, asked=0, seen=1, outcome=2)
    # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
    assert "two left at 1.07 and 1.07 m/s." in asking.state["question"]["why"]
    wait_for_rest(asking)  # the swing is seen once more, and holds while you read
    time = asking.time()
    asking.wait(2 * REST)
    assert asking.time() == time
    assert not asking.state["running"]
    asking.give("pause")
    asking.wait(0.1)
    assert asking.time() > time
    asking.give("restart")
    assert question_of(asking) == QuestionState(ASKED)


@pytest.mark.parametrize("command", ["step", "pause"])
def test_an_open_question_waits_for_an_answer_and_says_so(asking, command):
    """A teacher's clicker sends keys."""
    asking.give(command)
    asking.wait(0.1)
    assert asking.time() == 0
    assert asking.state["word"] == WAITS
    asking.give("answer", STEM, 2)
    assert asking.state["word"] == ""


def test_an_answer_to_another_question_or_after_the_answer_does_nothing(asking):
    for value in (("01_one_bob", 0), (STEM, 4)):
        asking.give("answer", *value)
    assert question_of(asking) == QuestionState(ASKED)
    asking.give("answer", STEM, 0)
    asking.give("answer", STEM, 1)
    assert question_of(asking).asked == 0


def test_without_ask_an_experiment_runs_at_once_and_still_explains_itself(asking):
    asking.give("ask", False)
    wait_for_rest(asking)
    assert question_of(asking) == QuestionState(EXPLAINED, outcome=2)
    time = asking.time()
    asking.wait(REST - 0.1)
    assert asking.time() == time
    asking.wait(0.3)
    assert asking.time() > time
    asking.give("ask", True)
    assert question_of(asking) == QuestionState(ASKED)
    assert asking.time() == 0


@pytest.mark.parametrize(
    "change", [("release_angle", 10), ("e", 0.5), ("separating", True), ("edit", 0, "mass", 2)]
)
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change):
    """It is paused: else it would give the answer away."""
    asking.give(*change)
    assert question_of(asking) is None
    assert asking.state["word"] == OVER
    assert asking.state["paused"]
    asking.give("ask", False)
    asking.give("ask", True)
    assert asking.state["changed"]
    assert question_of(asking) is None
    asking.give("experiment", TWO)
    assert question_of(asking) == QuestionState(ASKED)
    assert asking.state["word"] == ""


@pytest.mark.parametrize("moves", [False, True])
def test_a_bob_that_is_moved_and_let_go_in_one_frame_ends_the_question(asking, moves):
    """As on a slow connection."""
    bob = asking.viewer.cradle.bobs()[4].pos
    asking.tell("grab", bob.value, [0, 0, -1])
    asking.tell("drag", (bob + vector(0.01 * moves, 0, 0)).value, [0, 0, -1])
    asking.give("let_go")
    assert asking.state["changed"] == moves
    assert question_of(asking) == (None if moves else QuestionState(ASKED))


def test_ghosts_swing_as_far_as_the_answers_say_until_the_picture_rests_no_more(asking_again):
    rig = asking_again
    rig.give("momenta", True)
    rig.give("answer", STEM, 0)
    points = rig.state["view"]["points"]
    assert max(x for x, *_ in points) > rig.cradle.axles()[-1].pos.x + R_PARAM  # room for 100
    rig.wait(0.35)
    assert 0 < ghosts(rig)[0] < 100
    wait_for_rest(rig)
    # Of your answer and of the others: the page shows yours. A bob that hangs has no ghost.
    assert ghosts(rig) == pytest.approx([100, 45, 45, 45, 29, 29, 29])
    whose = rig.state["view"]["ghosts"]
    assert [whose[str(ghost.idx)] for ghost in rig.marks("ghosts")] == [0, 1, 2, 2, 3, 3, 3]
    assert rig.state["view"]["points"] == points  # the camera stays
    assert [whose[str(name.idx)] for name in rig.marks("names")] == [0, 1, 2, 3]
    # Most bobs stop at this moment: the bars are those after the hits
    bars = rig.state["bars"]
    assert "after the hits" in bars["title"]
    assert [part for *_, part in bars["bars"]] == pytest.approx([0, 0, 0, 0.5, 0.5, 1], abs=0.01)
    rig.give("pause")
    rig.wait(0.1)
    assert ghosts(rig) == []


def ghosts(rig):
    """Return the angles of all ghosts (degrees)."""
    return [degrees(atan2(thread.axis.x, -thread.axis.y)) for thread in rig.marks("threads")]


@pytest.mark.parametrize("state", [SEEN, EXPLAINED])
def test_again_slowly_shows_the_swing_once_more_and_changes_nothing_else(asking_again, state):
    rig = asking_again
    rig.give("speed", 2)
    if state == EXPLAINED:
        rig.give("answer", STEM, 1)
        wait_for_rest(rig)
    before = question_of(rig)
    rig.give("repeat")
    assert rig.time() == 0
    assert rig.state["speed"] == 0.1
    rig.wait(0.5)
    assert 0 < rig.time() < 0.1
    assert question_of(rig) == before
    while rig.state["speed"] == 0.1:
        rig.wait(0.1)
    assert rig.state["speed"] == 2
    assert question_of(rig) == before
    assert not rig.state["running"]
    assert (rig.time() == 0) == (state == SEEN)


def test_next_and_previous_go_through_all_experiments_and_around(asking):
    names = asking.control("experiment")["choices"]
    for command, places in (("previous", (1, 0, -1)), ("next", (0, 1))):
        for place in places:
            asking.give(command)
            assert asking.state["experiment"] == names[place]
