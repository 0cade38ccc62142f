"""Experiments: their files, their menu and questions on the page, and that each explains what really happens."""

from itertools import combinations
from math import atan2, degrees, radians

import pytest
from students import put_files
from wall import Wall
from whole_cradles import GOOD, HEADER

from support.cradle.cradle import Cradle, DoubleCradle
from support.cradle.prediction import Measurement
from support.files.experiments import EXPERIMENTS, read_experiment, read_experiments
from support.page.questions import what_happened

KINDS = Cradle, DoubleCradle
SHIPPED = [(kind, path.stem) for kind in KINDS for path in sorted((EXPERIMENTS / kind.kind).glob("*.txt"))]

TEXT = """\
name = Two bobs
theta = -45 -45 0 0 0
seconds = 0.5
question = What\x0cleaves
    # It is a note.
    on the other side?
why = {speed_5} m/s after {before_1} m/s, {swing_5} degrees, {energy} %
- One=1 = 0 0 0 0 100
* Two = 0 0 0 45 45
"""


def read(folder, text=TEXT, cords=1):
    """Return the experiment with this text."""
    return read_experiment(put_files(folder, {"two.txt": text}) / "two.txt", cords)


def test_an_experiment_is_read(tmp_path):
    """Also with lines that end as on Windows, or with a sixth pendulum. phi is measured from the upper cord."""
    experiment = read(tmp_path)
    assert (experiment.key, experiment.name, experiment.seconds, experiment.explained) == ("two", "Two bobs", 0.5, 1)
    assert experiment.question == "What leaves on the other side?"
    assert experiment.answers == [("One=1", [0, 0, 0, 0, 100]), ("Two", [0, 0, 0, 45, 45])]
    assert read(tmp_path, ("\ufeff" + TEXT.replace("\n", "\r\n")).encode()) == experiment
    six = TEXT.replace(" 0 0 0", " 0 0 0 0").replace("seconds = 0.5", "e = 0 0.5 1 1 1 1\n#\nmass = 5 1 1 1 1 1e-7")
    csv, numbers = read(tmp_path, six).csv, ["5.0,0.0", "1.0,0.5", "1.0,1.0", "1.0,1.0", "1.0,1.0", "1e-07,1.0"]
    rows = map("{},0.0,0.0,{},metal\n".format, numbers, ["red", "yellow", "cyan", "blue", "purple", "red"])
    assert (csv.filepath.name, csv.data.decode()) == ("two.csv", HEADER + "".join(rows))
    with pytest.raises(ValueError, match="phi: found nothing, allowed is an angle"):
        read(tmp_path, cords=2)
    angles = read(tmp_path, TEXT.replace("seconds", "phi = -20 10 0 0 0\nseconds"), cords=2).angles
    assert angles[:2] == [pytest.approx([radians(-45), radians(phi)]) for phi in (-65, -35)]
    with pytest.raises(ValueError, match="mass: found '1 1 1e-7 1 1', allowed is at most 1e6 times the smallest mass"):
        read(tmp_path, TEXT.replace("seconds", "phi = 0 0 0 0 0\nmass = 1 1 1e-7 1 1\nseconds"), cords=2)


ANGLES = "allowed is an angle from -180 to 180 (degrees), for each of"
LINES = "allowed before = is, once each, name, theta, phi, mass, e, seconds, question, why, or an answer after - or *"
BRACES = "allowed is {energy}, or swing_, speed_ or before_ with the number of a bob, 1 to 5, in braces"
TO_FIVE = "allowed are 2 to 5, one of them with an asterisk"
BAD = [
    ("theta = -45", "theta = -181", f"theta: found '-181 -45 0 0 0', {ANGLES} 5 pendula"),
    ("seconds = 0.5", "seconds = 0", "seconds: found '0', allowed is a number above 0 and up to 60"),
    ("name = Two bobs", "name = My cradle (CSV)", "name: found 'My cradle (CSV)', allowed is a text, but not "),
    ("* Two", "- Two", f"answers: found 2 answers, 0 of them with an asterisk, {TO_FIVE}"),
    ("- One=1 = 0 0 0 0 100\n", "", f"answers: found 1 answers, 1 of them with an asterisk, {TO_FIVE}"),
    ("- One", "- a = 0 0 0 0 0\n- b = 0 0 0 0 0\n- c = 0 0 0 0 0\n- d = 0 0 0 0 0\n- One", "answers: found 6 "),
    ("* Two", "* One=1", "answers: found an answer twice"),
    ("0 0 0 45 45", "45 45", f"* Two: found '45 45', {ANGLES} 5 pendula"),
    ("{speed_5}", "{speed_6}", f"why: found {{speed_6}}, {BRACES}"),
    ("{speed_5}", "{speed_5", f"why: found {{, {BRACES}"),
    ("seconds", "phi = 0 0 0 0 0\nseconds", "phi: is allowed only for the double cradle"),
    ("seconds", "e = 1 1 1 1\nseconds", "e: found '1 1 1 1', allowed is a number from 0 to 1, such as 0.9, for "),
    ("seconds", "mass = 1 1 1 1 0\nseconds", "mass: found '1 1 1 1 0', allowed is a number from 1e-300 to 1e6 (kg), "),
    ("seconds", "mas = 1 1 1 1 5\nseconds", f"line 3: found 'mas = 1 1 1 1 5', {LINES}"),
    ("seconds", "theta = 0 0 0 0 0\nseconds", f"line 3: found 'theta = 0 0 0 0 0', {LINES}"),
    ("- One=1 = 0", "- = 0", f"line 8: found '- = 0 0 0 0 100', {LINES}"),
    ("* Two =", "* Two", f"line 9: found '* Two 0 0 0 45 45', {LINES}"),
    ("leaves", "l\xe9aves", "line 4: found byte 0xe9, allowed is text only, saved as UTF-8"),
    ("seconds", "seconds", "name: 'Two bobs' is the name of another experiment"),
    ("-45 -45", "0 " * 1000, f"theta: found '{'0 ' * 149}0..., {ANGLES} 1000 pendula"),
]


def test_bad_experiments_are_named_in_one_line_each_and_the_other_one_works(tmp_path):
    put_files(tmp_path, {"two.txt": TEXT, "wrong.txt/file": ""})
    expected = [f"{tmp_path / 'wrong.txt'}: cannot be read: "]
    for number, (old, new, words) in enumerate(BAD):
        assert old in TEXT
        file = tmp_path / f"wrong_{number:02}.txt"
        file.write_bytes(TEXT.replace(old, new).encode("latin-1"))
        expected.append(f"{file}, {words}")
    (tmp_path / "._two.txt").write_bytes(b"\0\5\26\7")  # a Mac puts it beside two.txt on a foreign disk
    experiments, mistakes = read_experiments(tmp_path, 1)
    assert [experiment.key for experiment in experiments] == ["two"]
    for mistake, beginning in zip(mistakes, expected, strict=True):
        assert mistake[: len(beginning)] == beginning
        assert "\n" not in mistake


CSV, TWO, FROM_BOTH_SIDES, HEAVY = "My cradle (CSV)", "Two bobs", "From both sides", "A heavy one hits light ones"
KEY, INELASTIC, AS_FAR = "2_two_bobs", "perfectly inelastic, e = 0", "as far as the two"
ANSWERS = ["One bob, twice as fast", f"One bob, {AS_FAR}", f"Two bobs, {AS_FAR}", "Three bobs, not so far"]
THAT, OTHER, ASKING = "That is what happened.", f"What happened: C, {ANSWERS[2]}.", (True, "", None)


@pytest.fixture
def asking(wall):
    """A viewer that asks the question of an experiment, Two bobs."""
    wall.give("ask first", True)
    wall.give("experiment", TWO)
    return wall


def asked(wall):
    """Return whether the state has a question, and what it says about the answer and about what happened."""
    question = wall.state["question"]
    return question and (question["asking"], question["said"], (question["happened"] or {}).get("title"))


def test_an_experiment_is_as_its_file_says_and_back_at_your_csv_all_is_as_you_had_set_it(wall):
    """Also after two changes of an experiment, and if the file was saved meanwhile, which then comes back."""
    for command, *values in (("edit", 1, "mass", "3"), ("lift", 0, 20), ("lifted", 2), ("collision", INELASTIC)):
        wall.give(command, *values)
    for saves, masses in ((False, [1, 3, 1, 1, 1]), (True, [2] * 6)):
        wall.give("experiment", HEAVY)
        assert (wall.values("mass"), wall.values("e")) == ([5, 1, 1, 1, 1], [1] * 5)
        assert (wall.lifts(), wall.state["collision"], asked(wall)) == ([45, 0, 0, 0, 0], "as in the CSV", None)
        wall.give("experiment", FROM_BOTH_SIDES)
        assert (wall.lifts(), wall.state["lifted"], wall.state["lifts"]) == ([45, 0, 0, 0, 45], [1, 5], [45])
        assert [theta > 0 for theta in wall.thetas()] == [False, False, False, False, True]
        assert (wall.values("mass"), wall.values("e")) == ([1] * 5, [1] * 5)  # also when it was edited and chosen again
        wall.give("edit", 0, "e", "0.5")
        assert (wall.lifts(), wall.values("e")) == ([45, 0, 0, 0, 45], [0.5, 1, 1, 1, 1])
        wall.give("lifted", 5)
        assert (wall.lifts(), wall.state["experiment"]) == ([45] * 5, None)
        wall.save(HEADER + GOOD * 6) if saves else None
        wall.give(*("restart",) if saves else ("experiment", CSV))
        assert (wall.state["experiment"], wall.state["collision"]) == (CSV, INELASTIC)
        assert wall.lifts() == [20, 20] + [0] * (len(masses) - 2)
        assert (wall.values("mass"), wall.values("e")) == (masses, [0] * len(masses))
        wall.viewer.chooser.set(mass=2.0)  # as with --mass


def test_a_mistake_in_an_experiment_is_shown_as_plain_text_and_no_other_one_is_next(csv, tmp_path, monkeypatch):
    folder = put_files(tmp_path / "experiments", {"single/one.txt": "<s>"})
    monkeypatch.setattr("support.page.chooser.EXPERIMENTS", folder)
    wall = Wall(csv)
    wall.give("next")
    assert (wall.state["experiments"], wall.state["experiment"]) == ([CSV], CSV)
    [mistake] = wall.state["mistakes"]
    assert mistake.startswith(f"{folder / 'single' / 'one.txt'}, line 1: found '<s>', allowed before")


def test_a_main_that_reads_another_file_does_not_end_the_page(asking, monkeypatch, tmp_path):
    """A frequent mistake: make_newton_cradle forgets its parameter. The page shows that cradle."""
    other, make = tmp_path / "other.csv", asking.viewer.cradle.scope["make_newton_cradle"]
    other.write_text(HEADER + GOOD * 2)
    monkeypatch.setitem(asking.viewer.cradle.scope, "make_newton_cradle", lambda _, *given: make(other, *given))
    asking.give("experiment", HEAVY)
    asking.give("edit", 1, "mass", "2")
    asking.wait(0.1)
    assert (len(asking.thetas()), asked(asking)) == (2, None)


@pytest.mark.parametrize(("answer", "happened"), [(2, THAT), (0, OTHER), (None, OTHER)])
def test_the_question_comes_before_each_release_and_the_explanation_after_it(asking, answer, happened):
    said = "" if answer is None else f"You said: {'ABCD'[answer]}, {ANSWERS[answer]}."
    for _ in range(2):
        question = asking.state["question"]
        assert (question["key"], question["name"], question["answers"]) == (KEY, TWO, ANSWERS)
        assert question["question"] == "Two bobs come in. What leaves on the other side?"
        asking.wait(0.5)
        assert (asking.time(), asking.lifts(), asking.state["running"]) == (0, [45, 45, 0, 0, 0], False)
        assert asked(asking) == ASKING
        asking.tabs.give("answer", KEY, answer)
        asking.wait(0.3)
        assert (asked(asking), asking.time() > 0.2) == ((False, said, None), True)
        asking.wait(0.3)
        assert asked(asking) == (False, said, happened)
        result = asking.state["question"]["happened"]
        # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
        assert result["why"].startswith("Two bobs came in at 1.07 m/s, and two left at 1.07 and 1.07 m/s.")
        assert result["rows"] == [
            ["bob", "1", "2", "3", "4", "5"],
            ["largest speed before the first hit (m/s)", "1.07", "1.07", "0.00", "0.00", "0.00"],
            ["largest speed after it (m/s)", "0.00", "0.00", "0.00", "1.07", "1.07"],
            ["swung to (degrees)", "0", "0", "0", "45", "45"],
        ]
        asking.wait(0.5)
        assert asking.state["question"]["happened"] == result
        asking.give("restart")


@pytest.mark.parametrize("command", ["pause", "step", "tick"])
def test_the_cradle_also_runs_without_an_answer(asking, command):
    asking.tabs.give(command)
    asking.wait(0.05)
    assert (asked(asking), 0 < asking.viewer.motion.ticks < 1000) == ((False, "", None), True)
    if not asking.state["running"]:
        asking.tabs.give("pause")
    asking.wait(0.6)
    assert asked(asking) == (False, "", OTHER)


@pytest.mark.parametrize("value", [("1_one_bob", 0), ("5_heavy_hits_light", None), (KEY, 99), (KEY, 4)])
def test_an_answer_to_another_question_does_nothing(asking, value):
    asking.give("answer", *value)
    asking.give("vote", *value)
    asking.wait(0.1)
    assert (asked(asking), asking.time(), asking.state["question"]["votes"]) == (ASKING, 0, [0] * 4)


def test_the_box_asks_at_once_and_takes_the_question_back(wall):
    for name, (time, words) in {CSV: (0.2, None), TWO: (0, ASKING)}.items():
        wall.give("experiment", name)
        wall.wait(0.2)
        wall.give("ask first", True)
        assert (wall.time(), asked(wall), wall.state["ask first"]) == (pytest.approx(time, abs=0.05), words, True)
        wall.give("ask first", False)
        wall.wait(0.2)
        assert (wall.time() > 0.1, asked(wall)) == (True, None)


CHANGES = {
    "angle": lambda wall: wall.give("lift", 0, 10),
    "collisions": lambda wall: wall.give("collision", INELASTIC),
    "separating": lambda wall: wall.give("separating", True),
    "drag": lambda wall: wall.mouse("grab", wall.viewer.cradle.bobs()[4].pos),
    "edit": lambda wall: wall.give("edit", 0, "mass", "2"),
    "file": lambda wall: wall.save(HEADER + GOOD * 6),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change):
    CHANGES[change](asking)
    asking.wait(0.6)  # the measurement would be over
    assert (asked(asking), asking.state["running"]) == (None, True)  # only the question has held it up
    assert asking.state["experiment"] == (CSV if change == "file" else None)
    for command, *values in (("restart",), ("ask first", False), ("ask first", True)):
        asking.give(command, *values)
    assert asked(asking) is None
    asking.give("experiment", TWO)
    assert asked(asking) == ASKING


def test_hands_are_counted_and_ghosts_swing_as_far_as_the_answer_says(asking):
    """The picture rests for three seconds at the measurement. Then they have gone, and a later answer does nothing."""
    for number in (1, 2, 2):
        asking.give("vote", KEY, number)
    assert asking.state["question"]["votes"] == [0, 1, 2, 0]
    asking.give("answer", KEY, 0)
    asking.wait(0.2)
    assert ghosts(asking) == []
    asking.wait(0.15)
    assert 0 < ghosts(asking)[4] < 100
    asking.wait(2.5)
    assert asking.time() == 0.47
    said = f"You said: A, {ANSWERS[0]}. Hands: A 0, B 1, C 2, D 0."
    assert asked(asking) == (False, said, OTHER)
    assert ghosts(asking) == pytest.approx([0, 0, 0, 0, 100])  # the pale bobs that its file says
    for command in ("answer", "vote"):
        asking.give(command, KEY, 1)
    asking.wait(1)
    assert (asking.time() > 0.6, ghosts(asking), asked(asking)[1]) == (True, [], said)


def ghosts(wall):
    """Return the angles of the visible ghosts (degrees)."""
    visible = [ghost for ghost in wall.viewer.marks.shapes["ghosts"] if ghost.visible]
    arms = [ghost.pos - axle.pos for ghost, axle in zip(visible, wall.viewer.cradle.axles(), strict=bool(visible))]
    return [degrees(atan2(arm.x, -arm.y)) for arm in arms]


def test_again_maybe_slowly_and_next(asking):
    """Again keeps the answer. Slow motion ends with the rest, and the speed is as you have set it."""
    said = f"You said: B, {ANSWERS[1]}."
    asking.give("speed", 2)
    asking.give("answer", KEY, 1)
    asking.wait(0.5)
    for slowly, speed in ((True, 0.1), (False, 2.0)):
        asking.give("again", slowly)
        assert (asking.state["speed"], asking.lifts()[:2], asked(asking)) == (speed, [45, 45], (False, said, None))
        asking.wait(0.47 / speed + 0.1)
        assert (asking.time(), asked(asking), asking.state["speed"]) == (0.47, (False, said, OTHER), speed)
        asking.wait(3)
        assert (asking.time() > 0.47, asking.state["speed"]) == (True, 2)
    names = asking.state["experiments"][1:]
    for name in (*names[2:], *names[:2]):
        asking.give("next")
        assert (asking.state["experiment"], asking.time(), asked(asking)) == (name, 0, ASKING)


@pytest.mark.parametrize(("kind", "key"), SHIPPED)
def test_a_shipped_experiment_explains_what_happens_and_its_answers_differ(kind, key, csv):
    wall = Wall(csv, *[30] * len(kind.angles), kind=kind)
    [experiment] = [one for one in wall.viewer.chooser.experiments.values() if one.key == key]
    wall.give("ask first", True)
    wall.give("experiment", experiment.name)
    wall.tabs.give("answer", key, experiment.explained)
    wall.wait(experiment.seconds + 0.1)
    happened, measured = wall.state["question"]["happened"], wall.viewer.questions.measurement
    assert (wall.state["mistakes"], happened["title"], "{" in happened["why"]) == ([], THAT, False)
    assert measured.swings == pytest.approx(experiment.answers[experiment.explained].swings, abs=3)
    for answer, other in combinations(experiment.answers, 2):
        assert max(abs(a - b) for a, b in zip(answer.swings, other.swings, strict=True)) > 5


def test_a_measurement_has_the_speeds_at_the_first_hit_and_the_largest_swings(tmp_path):
    """Bobs 1 and 2 come in at 1 and 2 rad/s; after the hit, bob 5 swings to 40 degrees."""

    def measure(*samples, text=TEXT):
        measured = Measurement(read(tmp_path, text))
        for t, thetas, omegas, total, has_hit in samples:
            sample = {f"theta_{i}": radians(theta) for i, theta in enumerate(thetas, start=1)}
            sample |= {f"omega_{i}": omega for i, omega in enumerate(omegas, start=1)}
            measured.note({"t": t, "total": total, **sample}, has_hit)
        return measured

    before = (0.0, [-45, -45, 0, 0, 0], [0] * 5, 4.0, False), (0.2, [-1, -1, 0, 0, 0], [1, 2, 0, 0, 0], 4.0, False)
    hit = (0.3, [0, 0, 0, 0, 30], [0, 0, 0, 0, 5], 3.0, True), (0.4, [0, -3, 0, 0, 40], [0, 0, 0, 0, 1], 3.0, True)
    end, too_late = ((t, [0, 0, 0, 0, 50 * t - 5], [0, 0, 0, 0, -4], 1 / t, True) for t in (0.5, 5))
    assert not measure(*before, *hit).is_over
    measured = measure(*before, *hit, end, too_late)
    assert (measured.is_over, measured.outcome()) == (True, None)
    assert measured.swings == pytest.approx([0, -3, 0, 0, 40])
    happened = what_happened(measured, None)
    assert happened["title"] == "What happened: none of these answers."
    assert happened["why"].startswith("After the first hit, the bobs swung to 0, -3, 0, 0, 40 degrees.")
    assert "expects: Two." in happened["why"]
    names = "before_1", "before_2", "speed_5", "swing_2", "swing_5", "energy"
    assert [measured.numbers()[name] for name in names] == ["0.20", "0.40", "1.00", "3", "40", "50"]
    # Nothing is claimed without a hit, also if an answer predicts swings as small as those that are not measured.
    measured = measure(*before, text=TEXT.replace("0 0 0 45 45", "0 0 0 9 9"))
    assert (measured.outcome(), measured.explanation()) == (None, "No two bobs hit each other.")
