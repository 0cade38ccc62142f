"""Experiments: their files, their menu and questions on the page, and that each explains what
really happens.
"""

import re
from itertools import combinations, pairwise
from math import acos, atan2, copysign, cos, degrees, radians, sqrt

import pytest
from programs import copy_project, OF_TESTS, python, slow_but_for
from rig import Rig
from students import put_files
from whole_cradles import go_on, GOOD, HEADER, make_live, PERIOD, Swing

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle, DoubleCradle
from support.cradle.prediction import Measurement
from support.files.experiments import EXPERIMENTS, read_experiment, read_experiments

KINDS = Cradle, DoubleCradle
SHIPPED = [
    (kind, path.stem) for kind in KINDS for path in sorted((EXPERIMENTS / kind.kind).glob("*.txt"))
]

TEXT = """\
name = Two bobs
theta = -45 -45 0 0 0
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
    """Also with lines that end as on Windows, or with a sixth pendulum. phi is measured from the
    upper cord.
    """
    experiment = read(tmp_path)
    assert (experiment.key, experiment.name, experiment.explained) == ("two", "Two bobs", 1)
    assert experiment.question == "What leaves on the other side?"
    assert experiment.answers == [("One=1", [0, 0, 0, 0, 100]), ("Two", [0, 0, 0, 45, 45])]
    assert read(tmp_path, ("\ufeff" + TEXT.replace("\n", "\r\n")).encode()) == experiment
    six = TEXT.replace(" 0 0 0", " 0 0 0 0").replace(
        "question", "e = 0 0.5 1 1 1 1\n#\nmass = 5 1 1 1 1 1e-7\nquestion"
    )
    csv = read(tmp_path, six).csv
    numbers = ["5.0,0.0", "1.0,0.5", "1.0,1.0", "1.0,1.0", "1.0,1.0", "1e-07,1.0"]
    rows = map(
        "{},0.0,0.0,{},metal\n".format, numbers, ["red", "yellow", "cyan", "blue", "purple", "red"]
    )
    assert (csv.filepath.name, csv.data.decode()) == ("two.csv", HEADER + "".join(rows))
    with pytest.raises(ValueError, match="phi: found nothing, allowed is an angle"):
        read(tmp_path, cords=2)
    angles = read(
        tmp_path, TEXT.replace("question", "phi = -20 10 0 0 0\nquestion"), cords=2
    ).angles
    assert angles[:2] == [pytest.approx([radians(-45), radians(phi)]) for phi in (-65, -35)]
    with pytest.raises(
        ValueError,
        match="mass: found '1 1 1e-7 1 1', allowed is at most 1e6 times the smallest mass",
    ):
        read(
            tmp_path,
            TEXT.replace("question", "phi = 0 0 0 0 0\nmass = 1 1 1e-7 1 1\nquestion"),
            cords=2,
        )


ANGLES = "allowed is an angle from -180 to 180 (degrees), for each of"
LINES = "allowed before = is, once each, name, theta, phi, mass, e, question, why, or an answer after - or *"
BRACES = (
    "allowed is {energy}, or swing_, speed_ or before_ with the number of a bob, 1 to 5, in braces"
)
TO_FIVE = "allowed are 2 to 5, one of them with an asterisk"
BAD = [
    ("theta = -45", "theta = -181", f"theta: found '-181 -45 0 0 0', {ANGLES} 5 pendula"),
    (
        "name = Two bobs",
        "name = My cradle (CSV)",
        "name: found 'My cradle (CSV)', allowed is a text, but not ",
    ),
    ("* Two", "- Two", f"answers: found 2 answers, 0 of them with an asterisk, {TO_FIVE}"),
    (
        "- One=1 = 0 0 0 0 100\n",
        "",
        f"answers: found 1 answers, 1 of them with an asterisk, {TO_FIVE}",
    ),
    (
        "- One",
        "- a = 0 0 0 0 0\n- b = 0 0 0 0 0\n- c = 0 0 0 0 0\n- d = 0 0 0 0 0\n- One",
        "answers: found 6 ",
    ),
    ("* Two", "* One=1", "answers: found an answer twice"),
    ("0 0 0 45 45", "45 45", f"* Two: found '45 45', {ANGLES} 5 pendula"),
    ("{speed_5}", "{speed_6}", f"why: found {{speed_6}}, {BRACES}"),
    ("{speed_5}", "{speed_5", f"why: found {{, {BRACES}"),
    ("question", "phi = 0 0 0 0 0\nquestion", "phi: is allowed only for the double cradle"),
    (
        "question",
        "e = 1 1 1 1\nquestion",
        "e: found '1 1 1 1', allowed is a number from 0 to 1, such as 0.9, for ",
    ),
    (
        "question",
        "mass = 1 1 1 1 0\nquestion",
        "mass: found '1 1 1 1 0', allowed is a number from 1e-300 to 1e6 (kg), ",
    ),
    ("question", "seconds = 0.5\nquestion", f"line 3: found 'seconds = 0.5', {LINES}"),
    ("question", "mas = 1 1 1 1 5\nquestion", f"line 3: found 'mas = 1 1 1 1 5', {LINES}"),
    ("question", "theta = 0 0 0 0 0\nquestion", f"line 3: found 'theta = 0 0 0 0 0', {LINES}"),
    ("- One=1 = 0", "- = 0", f"line 7: found '- = 0 0 0 0 100', {LINES}"),
    ("* Two =", "* Two", f"line 8: found '* Two 0 0 0 45 45', {LINES}"),
    ("leaves", "l\xe9aves", "line 3: found byte 0xe9, allowed is text only, saved as UTF-8"),
    ("question", "question", "name: 'Two bobs' is the name of another experiment"),
    ("-45 -45", "0 " * 1000, f"theta: found '{'0 ' * 149}0..., {ANGLES} 1000 pendula"),
]


def test_bad_experiments_are_named_in_one_line_each_by_number_and_the_other_one_works(tmp_path):
    put_files(tmp_path, {"0_two.txt": TEXT, "wrong.txt/file": ""})
    expected = []
    for number, (old, new, words) in enumerate(BAD):
        assert old in TEXT
        file = tmp_path / f"{number}_wrong.txt"
        file.write_bytes(TEXT.replace(old, new).encode("latin-1"))
        expected.append(f"{file}, {words}")
    expected.append(f"{tmp_path / 'wrong.txt'}: cannot be read: ")
    # A Mac puts it beside two.txt on a foreign disk
    (tmp_path / "._two.txt").write_bytes(b"\0\5\26\7")
    experiments, mistakes = read_experiments(tmp_path, 1)
    assert [experiment.key for experiment in experiments] == ["0_two"]
    for mistake, beginning in zip(mistakes, expected, strict=True):
        assert mistake[: len(beginning)] == beginning
        assert "\n" not in mistake


CSV = "My cradle (CSV)"
TWO = "Two bobs"
FROM_BOTH_SIDES = "From both sides"
HEAVY = "A heavy one hits light ones"
KEY, INELASTIC, AS_FAR = "2_two_bobs", "perfectly inelastic, e = 0", "as far as the two"
ANSWERS = [
    "One bob, twice as fast",
    f"One bob, {AS_FAR}",
    f"Two bobs, {AS_FAR}",
    "Three bobs, not so far",
]
THAT, OTHER, ASKING = "That is what happened.", f"What happened: C, {ANSWERS[2]}.", (True, "", None)


@pytest.fixture
def asking(rig):
    """A viewer that asks the question of an experiment, Two bobs."""
    rig.give("ask first", True)
    rig.give("experiment", TWO)
    return rig


def asked(rig):
    """Return whether the state has a question, and what it says about the answer and about what
    happened.
    """
    question = rig.state["question"]
    return question and (
        question["asking"],
        question["said"],
        (question["happened"] or {}).get("title"),
    )


def test_an_experiment_is_as_its_file_says_and_back_at_your_csv_all_is_as_you_had_set_it(rig):
    """Also after two changes of an experiment, and if the file was saved meanwhile, which then
    comes back.
    """
    for command, *values in (
        ("edit", 1, "mass", "3"),
        ("lift", 0, 20),
        ("lifted", 2),
        ("collision", INELASTIC),
    ):
        rig.give(command, *values)
    for saves, masses in ((False, [1, 3, 1, 1, 1]), (True, [2] * 6)):
        rig.give("experiment", HEAVY)
        assert (rig.values("mass"), rig.values("e")) == ([5, 1, 1, 1, 1], [1] * 5)
        assert (rig.lifts(), rig.state["collision"], asked(rig)) == (
            [45, 0, 0, 0, 0],
            "as in the experiment",
            None,
        )
        rig.give("experiment", FROM_BOTH_SIDES)
        assert (rig.lifts(), rig.state["lifted"], rig.state["lifts"]) == (
            [45, 0, 0, 0, 45],
            [1, 5],
            [45],
        )
        assert [theta > 0 for theta in rig.thetas()] == [False, False, False, False, True]
        # Also when it was edited and chosen again
        assert (rig.values("mass"), rig.values("e")) == ([1] * 5, [1] * 5)
        rig.give("edit", 0, "e", "0.5")
        assert (rig.lifts(), rig.values("e")) == ([45, 0, 0, 0, 45], [0.5, 1, 1, 1, 1])
        rig.give("lifted", 5)
        assert (rig.lifts(), rig.state["experiment"]) == ([45] * 5, f"{FROM_BOTH_SIDES}, changed")
        rig.save(HEADER + GOOD * 6) if saves else None
        rig.give(*("restart",) if saves else ("experiment", CSV))
        assert (rig.state["experiment"], rig.state["collision"]) == (CSV, INELASTIC)
        assert rig.lifts() == [20, 20] + [0] * (len(masses) - 2)
        assert (rig.values("mass"), rig.values("e")) == (masses, [0] * len(masses))
        rig.viewer.chooser.set(mass=2.0)  # as with --mass


def test_a_mistake_in_an_experiment_is_shown_as_plain_text_and_no_other_one_is_next(
    csv, tmp_path, monkeypatch
):
    folder = put_files(tmp_path / "experiments", {"single/one.txt": "<s>"})
    monkeypatch.setattr("support.page.chooser.EXPERIMENTS", folder)
    rig = Rig(csv)
    rig.give("next")
    assert (rig.state["experiments"], rig.state["experiment"]) == ([CSV], CSV)
    [mistake] = rig.state["mistakes"]
    assert mistake.startswith(
        f"{folder / 'single' / 'one.txt'}, line 1: found '<s>', allowed before"
    )


def test_a_main_that_reads_another_file_does_not_end_the_page(asking, monkeypatch, tmp_path):
    """A frequent mistake: make_newton_cradle forgets its parameter. The page shows that cradle."""
    other, make = tmp_path / "other.csv", asking.viewer.cradle.scope["make_newton_cradle"]
    other.write_text(HEADER + GOOD * 2)
    monkeypatch.setitem(
        asking.viewer.cradle.scope, "make_newton_cradle", lambda _, *given: make(other, *given)
    )
    asking.give("experiment", HEAVY)
    asking.give("edit", 1, "mass", "2")
    asking.wait(0.1)
    assert (len(asking.thetas()), asked(asking)) == (2, None)


@pytest.mark.parametrize(("answer", "happened"), [(2, THAT), (0, OTHER), (None, OTHER)])
def test_the_question_comes_before_each_release_and_the_explanation_after_it(
    asking, answer, happened
):
    said = "" if answer is None else f"You said: {'ABCD'[answer]}, {ANSWERS[answer]}."
    for _ in range(2):
        question = asking.state["question"]
        assert (question["key"], question["name"], question["answers"]) == (KEY, TWO, ANSWERS)
        assert question["question"] == "Two bobs come in. What leaves on the other side?"
        asking.wait(0.5)
        assert (asking.time(), asking.lifts(), asking.state["running"]) == (
            0,
            [45, 45, 0, 0, 0],
            False,
        )
        assert asked(asking) == ASKING
        asking.tabs.give("answer", KEY, answer)
        asking.wait(0.3)
        assert (asked(asking), asking.time() > 0.2) == ((False, said, None), True)
        asking.wait(0.3)
        assert asked(asking) == (False, said, happened)
        result = asking.state["question"]["happened"]
        # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
        assert result["why"].startswith(
            "Two bobs came in at 1.07 m/s, and two left at 1.07 and 1.07 m/s."
        )
        assert result["rows"] == [
            ["bob", "1", "2", "3", "4", "5"],
            ["largest speed before the hits (m/s)", "1.07", "1.07", "0.00", "0.00", "0.00"],
            ["largest speed after them (m/s)", "0.00", "0.00", "0.00", "1.07", "1.07"],
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


@pytest.mark.parametrize(
    "value", [("1_one_bob", 0), ("5_heavy_hits_light", None), (KEY, 99), (KEY, 4)]
)
def test_an_answer_to_another_question_does_nothing(asking, value):
    asking.give("answer", *value)
    asking.give("vote", *value)
    asking.wait(0.1)
    assert (asked(asking), asking.time(), asking.state["question"]["votes"]) == (ASKING, 0, [0] * 4)


def test_the_box_asks_at_once_and_takes_the_question_back(rig):
    for name, (time, words) in {CSV: (0.2, None), TWO: (0, ASKING)}.items():
        rig.give("experiment", name)
        rig.wait(0.2)
        rig.give("ask first", True)
        assert (rig.time(), asked(rig), rig.state["ask first"]) == (
            pytest.approx(time, abs=0.05),
            words,
            True,
        )
        rig.give("ask first", False)
        rig.wait(0.2)
        assert (rig.time() > 0.1, asked(rig)) == (True, None)


CHANGES = {
    "angle": lambda rig: rig.give("lift", 0, 10),
    "collisions": lambda rig: rig.give("collision", INELASTIC),
    "separating": lambda rig: rig.give("separating", True),
    "drag": lambda rig: rig.mouse("grab", rig.viewer.cradle.bobs()[4].pos),
    "edit": lambda rig: rig.give("edit", 0, "mass", "2"),
    "file": lambda rig: rig.save(HEADER + GOOD * 6),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change):
    CHANGES[change](asking)
    asking.wait(0.6)  # the measurement would be over
    # Only the question has held it up
    assert (asked(asking), asking.state["running"]) == (None, True)
    name = CSV if change == "file" else f"{TWO}, changed"
    for command, *values in (
        ("restart",),
        ("ask first", False),
        ("ask first", True),
        ("experiment", name),
    ):
        assert (asking.state["experiment"], name in asking.state["experiments"]) == (name, True)
        asking.give(command, *values)
    assert asked(asking) is None
    asking.give("experiment", TWO)
    assert asked(asking) == ASKING


def test_hands_are_counted_and_ghosts_swing_as_far_as_the_answer_says(asking):
    """The picture rests for three seconds at the measurement.

    Then they have gone, and a later answer does nothing.
    """
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


def ghosts(rig):
    """Return the angles of the visible ghosts (degrees)."""
    visible = [ghost for ghost in rig.viewer.marks.shapes["ghosts"] if ghost.visible]
    arms = [
        ghost.pos - axle.pos
        for ghost, axle in zip(visible, rig.viewer.cradle.axles(), strict=bool(visible))
    ]
    return [degrees(atan2(arm.x, -arm.y)) for arm in arms]


def test_again_maybe_slowly_and_next(asking):
    """Again keeps the answer.

    Slow motion ends with the rest, and the speed is as you have set it.
    """
    said = f"You said: B, {ANSWERS[1]}."
    asking.give("speed", 2)
    asking.give("answer", KEY, 1)
    asking.wait(0.5)
    for slowly, speed in ((True, 0.1), (False, 2.0)):
        asking.give("again", slowly)
        assert (asking.state["speed"], asking.lifts()[:2], asked(asking)) == (
            speed,
            [45, 45],
            (False, said, None),
        )
        asking.wait(0.47 / speed + 0.1)
        assert (asking.time(), asked(asking), asking.state["speed"]) == (
            0.47,
            (False, said, OTHER),
            speed,
        )
        asking.wait(3)
        assert (asking.time() > 0.47, asking.state["speed"]) == (True, 2)
    names = asking.state["experiments"][1:]
    for name in (*names[2:], *names[:2]):
        asking.give("next")
        assert (asking.state["experiment"], asking.time(), asked(asking)) == (name, 0, ASKING)


TICK = Cradle.dt / PERIOD  # in small swings


def measured(experiment, kind):
    """Measure this experiment with single ticks."""
    player = Swing(make_live(kind), experiment.csv, [None] * len(kind.angles), None, 4, 1e9)
    player.cradle.many_ticks = None
    player.want_cradle()
    go_on(player)
    player.cradle.pose(experiment.angles)
    player.motion.restart()
    measurement = Measurement(experiment, player.motion)
    while not measurement.is_over:
        player.swing(max(1, round(PERIOD / 1000 / kind.dt)))
        measurement.measure()
    return measurement


def after_the_hits(masses, es, velocities):
    """Return the velocities after all hits of a row at rest side by side: each keeps the momentum,
    and e holds.
    """
    velocities = list(velocities)
    pairs = [*pairwise(range(len(masses)))]
    while approaching := [
        pair for pair in pairs if velocities[pair[0]] - velocities[pair[1]] > 1e-9
    ]:
        left, right = approaching[0]
        common = (masses[left] * velocities[left] + masses[right] * velocities[right]) / (
            masses[left] + masses[right]
        )
        velocities[left], velocities[right] = (
            common - es[left] * (velocities[left] - common),
            common - es[left] * (velocities[right] - common),
        )
    return velocities


def check_this_world(keys=()):
    """Compare each shipped experiment (or those with these keys) with theory, at the constants of
    this process.

    A bob comes in at v = sqrt(2 g R (1 - cos(theta))), and swings out until 1 - cos(theta) = v^2 /
    (2 g R).
    """
    for kind, key in SHIPPED:
        if keys and key not in keys:
            continue
        experiment = read_experiment(EXPERIMENTS / kind.kind / f"{key}.txt", len(kind.angles))
        found = measured(experiment, kind)
        assert found.outcome() == experiment.explained, (key, found.swings)
        assert "{" not in found.explanation()
        for answer, other in combinations(experiment.answers, 2):
            assert max(abs(a - b) for a, b in zip(answer.swings, other.swings, strict=True)) > 5
        assert found.swings == pytest.approx(experiment.answers[experiment.explained].swings, abs=3)
        if kind is DoubleCradle:
            continue
        masses, es = found.cradle.values("mass"), found.cradle.values("e")
        befores = [
            copysign(sqrt(2 * G * R_PARAM * (1 - cos(theta))), -theta)
            for [theta] in experiment.angles
        ]
        speeds = after_the_hits(masses, es, befores)
        swings = [copysign(degrees(acos(1 - v**2 / (2 * G * R_PARAM))), v) for v in speeds]
        energies = [
            sum(m * v**2 for m, v in zip(masses, vs, strict=True)) for vs in (befores, speeds)
        ]
        fastest = max(map(abs, befores))
        assert found.befores == pytest.approx(
            [*map(abs, befores)], abs=(0.008 + 12 * TICK) * fastest
        ), key
        assert found.speeds == pytest.approx(
            [*map(abs, speeds)], abs=(0.008 + 12 * TICK) * fastest
        ), key
        assert found.swings == pytest.approx(swings, abs=0.1 + 700 * TICK), key  # degrees
        assert found.energy == pytest.approx(100 * energies[1] / energies[0], abs=0.1), key  # %


# Changed constants: R_PARAM (m), G (m/s^2), DT (s), DOUBLE_DT (s); the experiments to check, or all
WORLDS = {
    "the Moon": ("0.2 1.62 0.001 0.001", ()),
    "a short cord, and fast": ("0.05 25.0 0.0005 0.0005", ()),
    "the longest cord": ("2.0 9.81 0.001 0.001", ()),
    "short ticks": ("0.05 9.81 0.00001 0.00025", ("2_two_bobs",)),
    "the shipped one": ("0.2 9.81 0.0001 0.00025", ()),
}


@pytest.mark.parametrize("world", slow_but_for(["the Moon"], WORLDS))
def test_an_experiment_is_right_with_any_cord_gravity_and_tick(world, tmp_path):
    numbers, keys = WORLDS[world]
    file = copy_project(tmp_path, "") / "support" / "constants.py"
    text = file.read_text()
    for name, number in zip(("R_PARAM", "G", "DT", "DOUBLE_DT"), numbers.split(), strict=True):
        text = re.sub(rf"(?m)^{name} = .*", f"{name} = {number}", text)
    file.write_text(text)
    check = f"import support.headless_vpython, src.double_cradle; import test_experiments as t; t.check_this_world({keys})"
    done = python("-c", check, folder=tmp_path, **OF_TESTS)
    assert done.returncode == 0, done.stderr


SHORT = """\
name = Short
theta = {}
e = 0 0
question = What happens?
why = They stop.
* All stop = 0 0
- All go on = 45 45
"""


@pytest.mark.parametrize(
    ("theta", "words", "swings"),
    [
        ("-45 45", "They stop.", 0.5),  # nothing moves any more
        ("0 0", "In 2.69 s, no two bobs hit each other.", 3),
        ("-1 -1", "In 2.69 s, no two bobs hit each other.", 3),  # side by side
    ],
)
def test_a_measurement_ends_in_any_case(tmp_path, theta, words, swings):
    found = measured(read(tmp_path, SHORT.format(theta)), Cradle)
    assert (found.explanation(), found.end / PERIOD < swings + 0.1) == (words, True)


def test_the_shipped_experiments_have_no_mistakes():
    assert [read_experiments(EXPERIMENTS / kind.kind, len(kind.angles))[1] for kind in KINDS] == [
        [],
        [],
    ]
