"""Experiments: their files, what they measure, and that each explains what really happens."""

import os
import shutil
from math import radians

import pytest
from wall import Wall
from whole_cradles import FIVE_CSV

from src import visualize_cradle_run
from src.beyond.live_cradle import LiveCradle
from src.beyond.live_double_cradle import LiveDoubleCradle
from support.files.experiments import EXPERIMENTS, find_experiment, read_experiment, read_experiments
from support.page.commands import Command
from support.playback.prediction import Measurement

KINDS = {kind.kind: kind for kind in (LiveCradle, LiveDoubleCradle)}
CORDS = {"single": 1, "double": 2}
SHIPPED = [(kind, path.stem) for kind in KINDS for path in sorted((EXPERIMENTS / kind).glob("*.csv"))]

TEXT = """\
[experiment]
name = Two bobs
theta = -45 -45 0 0 0
seconds = 0.5
question = What leaves
    on the other side?
why = {speed_5} m/s after {before_1} m/s, {swing_5} degrees, {energy} %

[answers]
One = 0 0 0 0 100
* Two = 0 0 0 45 45
"""


@pytest.fixture
def files(tmp_path):
    """A folder with one experiment."""
    folder = tmp_path / "experiments"
    folder.mkdir()
    (folder / "two.csv").write_text(FIVE_CSV)
    (folder / "two.txt").write_text(TEXT)
    return folder


# --- the files -------------------------------------------------------------------------------------------------------


def test_an_experiment_is_read(files):
    experiment = read_experiment(files / "two.csv", 1)
    assert (experiment.key, experiment.name, experiment.seconds) == ("two", "Two bobs", 0.5)
    assert experiment.question == "What leaves on the other side?"
    assert [answer.text for answer in experiment.answers] == ["One", "Two"]
    assert experiment.answers[experiment.explained].swings == [0, 0, 0, 45, 45]
    assert experiment.angles[0] == [pytest.approx(-0.785398)]
    assert experiment.angles[4] == [0]


def test_phi_is_measured_from_the_upper_cord(files):
    (files / "two.txt").write_text(TEXT.replace("seconds", "phi = -20 10 0 0 0\nseconds"))
    angles = read_experiment(files / "two.csv", 2).angles
    assert angles[0] == pytest.approx([-0.785398, -1.134464])
    assert angles[1] == pytest.approx([-0.785398, -0.610865])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such pipes")
@pytest.mark.parametrize("name", ["two.csv", "two.txt"])
def test_a_pipe_is_no_experiment_and_not_waited_for(name, files):
    (files / name).unlink()
    os.mkfifo(files / name)
    (mistake,) = read_experiments(files, 1)[1]
    assert mistake.startswith(f"{files / name}: cannot be read")
    assert mistake.endswith(": found a pipe or a device, allowed is a file")


def test_the_lines_of_a_text_may_end_as_on_windows(files):
    before = read_experiment(files / "two.csv", 1)
    (files / "two.txt").write_bytes(("\ufeff" + TEXT.replace("\n", "\r\n")).encode())
    assert read_experiment(files / "two.csv", 1) == before


BAD = [
    ("theta = -45 -45 0 0 0", "theta = -45 -45", "theta: found '-45 -45', allowed are 5 angles from -180 to 180"),
    ("theta = -45 -45 0 0 0", "theta = -45 x 0 0 0", "theta: found '-45 x 0 0 0', allowed are 5 angles"),
    ("theta = -45", "theta = -181", "theta: found '-181 -45 0 0 0', allowed are 5 angles from -180 to 180"),
    ("seconds = 0.5", "seconds = 0", "seconds: found '0', allowed is a number above 0 and up to 60"),
    ("seconds = 0.5", "seconds = soon", "seconds: found 'soon', allowed is a number"),
    ("name = Two bobs\n", "", "name: found nothing, allowed is a text"),
    ("* Two", "Two", "[answers]: found 2 answers, 0 of them with an asterisk, allowed are 2 to 5, one of them"),
    ("One = 0", "* One = 0", "[answers]: found 2 answers, 2 of them with an asterisk"),
    ("One = 0 0 0 0 100\n", "", "[answers]: found 1 answers"),
    ("0 0 0 45 45", "45 45", "* Two: found '45 45', allowed are 5 angles"),
    ("[answers]", "answers", "three.txt' [line 9]"),
    ("{speed_5}", "{speed_6}", "why: found {speed_6}, allowed is {energy}, or swing_, speed_ or before_ with"),
    ("{speed_5}", "{speed}", "why: found {speed}, allowed is {energy}, or"),
    ("{speed_5}", "{speed_5", "why: found {, allowed is {energy}, or"),
    ("{energy}", "{energy:.1f}", "why: found {energy:.1f}, allowed is {energy}, or"),
    ("{energy}", "energy}", "why: found }, allowed is {energy}, or"),
    ("seconds", "phi = 0 0 0 0 0\nseconds", "phi: is allowed only for the double cradle"),
    ("name = Two bobs", "name = <Two>", "name: found '<Two>', allowed is a text without & < >, but not 'your CSV'"),
    ("name = Two bobs", "name = your CSV", "name: found 'your CSV', allowed is a text without & < >"),
    ("* Two", "* One", "[answers]: found an answer twice"),
    ("[experiment]\n", "", "File contains no section headers"),
    ("name = Two bobs", "name = Two bobs\nname = Three", "already exists"),
]


@pytest.mark.parametrize(("old", "new", "words"), BAD)
def test_a_bad_experiment_is_named_in_one_line_and_the_others_work(files, old, new, words):
    shutil.copy(files / "two.csv", files / "three.csv")
    assert old in TEXT
    (files / "three.txt").write_text(TEXT.replace(old, new).replace("Two bobs", "Three bobs"))
    experiments, mistakes = read_experiments(files, 1)
    assert [experiment.key for experiment in experiments] == ["two"]
    [mistake] = mistakes
    assert mistake.startswith(str(files / "three.txt"))
    assert words in mistake
    assert "\n" not in mistake


def test_other_mistakes_of_experiments(files):
    (files / "alone.txt").write_text(TEXT)
    (files / "broken.csv").write_text(FIVE_CSV.replace("red", "rouge"))
    (files / "latin.csv").write_text(FIVE_CSV)
    (files / "latin.txt").write_bytes(b"\xe9")
    (files / "silent.csv").write_text(FIVE_CSV)
    (files / "two_more.csv").write_text(FIVE_CSV)
    (files / "two_more.txt").write_text(TEXT)
    experiments, mistakes = read_experiments(files, 1)
    assert [experiment.key for experiment in experiments] == ["two"]
    names = ["alone.csv", "broken.csv", "latin.txt", "silent.txt", "two_more.txt"]
    words = [
        "No such file",
        "column color: found 'rouge'",
        "UTF-8",
        "No such file",
        "is the name of another experiment",
    ]
    assert len(mistakes) == len(names)
    for mistake, name, word in zip(mistakes, names, words, strict=True):
        assert mistake.startswith(f"{files / name}")
        assert word in mistake


def test_an_experiment_of_the_double_cradle_needs_phi(files):
    experiments, [mistake] = read_experiments(files, 2)
    assert not experiments
    assert mistake == f"{files / 'two.txt'}, phi: found nothing, allowed is a text"


def test_masses_too_far_apart_are_no_experiment_of_the_double_cradle(files):
    (files / "two.csv").write_text(FIVE_CSV.replace("1.0", "1e-7", 1))
    (files / "two.txt").write_text(TEXT.replace("seconds", "phi = 0 0 0 0 0\nseconds"))
    assert read_experiments(files, 2) == (
        [],
        [
            f"{files / 'two.csv'}, line 3, column mass: found '1.0', and '1e-7' in line 2, "
            "allowed is at most 1e6 times the smallest mass, in a double cradle"
        ],
    )


def test_the_command_names_an_experiment(files):
    assert find_experiment("two", files, 1) == read_experiment(files / "two.csv", 1)
    shutil.copy(files / "two.csv", files / "two_more.csv")
    shutil.copy(files / "two.txt", files / "two_more.txt")
    with pytest.raises(ValueError, match=r"two_more.txt, name: 'Two bobs' is the name of another experiment$"):
        find_experiment("two_more", files, 1)
    with pytest.raises(ValueError, match=r"^--experiment: found 'three', allowed is one of two$"):
        find_experiment("three", files, 1)


# --- what happens ----------------------------------------------------------------------------------------------------


def run(kind, key, csv) -> tuple:
    """Run a shipped experiment; return the viewer's questions, with the measurement at its end."""
    wall = Wall(csv, *[30] * len(KINDS[kind].angles), kind=KINDS[kind])
    questions = wall.viewer.questions
    [number] = [i for i, experiment in enumerate(questions.experiments) if experiment.key == key]
    wall.viewer.give(Command.ASK_FIRST, True)
    wall.viewer.give(Command.EXPERIMENT, number)
    wall.wait()
    wall.viewer.give(Command.ANSWER, [key, questions.experiments[number].explained])
    wall.wait(questions.experiments[number].seconds + 0.1)
    return wall, questions


@pytest.mark.parametrize("kind", KINDS)
def test_all_shipped_experiments_are_good(kind):
    experiments, mistakes = read_experiments(EXPERIMENTS / kind, CORDS[kind])
    assert not mistakes
    assert [experiment.key for experiment in experiments] == [key for folder, key in SHIPPED if folder == kind]


@pytest.mark.parametrize(("kind", "key"), SHIPPED)
def test_a_shipped_experiment_explains_what_happens(kind, key, csv):
    _, questions = run(kind, key, csv)
    measured, experiment = questions.measurement, questions.experiment
    assert measured.is_over
    assert measured.outcome() == experiment.explained
    assert measured.swings == pytest.approx(experiment.answers[experiment.explained].swings, abs=3)
    assert "That is what happened" in questions.area.text
    assert "{" not in measured.explanation()


@pytest.mark.parametrize(("kind", "key"), SHIPPED)
def test_no_two_answers_of_a_shipped_experiment_predict_nearly_the_same(kind, key):
    answers = read_experiment(EXPERIMENTS / kind / f"{key}.csv", CORDS[kind]).answers
    for number, answer in enumerate(answers):
        for other in answers[:number]:
            assert max(abs(a - b) for a, b in zip(answer.swings, other.swings, strict=True)) > 5


def test_the_measured_numbers(files):
    """Hand-made samples: bobs 1 and 2 come in at 1 and 2 rad/s; after the hit, bob 5 swings to 40 degrees."""
    measured = Measurement(read_experiment(files / "two.csv", 1))

    def note(t, thetas, omegas, total, has_hit):
        names = {f"theta_{i}": radians(theta) for i, theta in enumerate(thetas, start=1)}
        measured.note(
            {"t": t, "total": total, **names, **{f"omega_{i}": w for i, w in enumerate(omegas, start=1)}}, has_hit
        )

    note(0.0, [-45, -45, 0, 0, 0], [0, 0, 0, 0, 0], 4.0, False)
    note(0.2, [-1, -1, 0, 0, 0], [1, 2, 0, 0, 0], 4.0, False)
    note(0.3, [0, 0, 0, 0, 30], [0, 0, 0, 0, 5], 3.0, True)
    note(0.4, [0, -3, 0, 0, 40], [0, 0, 0, 0, 1], 3.0, True)
    assert not measured.is_over
    note(0.5, [0, 0, 0, 0, 20], [0, 0, 0, 0, -4], 2.0, True)
    assert measured.is_over
    note(0.6, [0, 0, 0, 0, 90], [0, 0, 0, 0, 9], 1.0, True)
    assert measured.swings == pytest.approx([0, -3, 0, 0, 40])
    assert measured.explanation().startswith("After the first hit, the bobs swung to 0, -3, 0, 0, 40 degrees.")
    assert "expects: Two." in measured.explanation()
    assert measured.outcome() is None
    numbers = measured.numbers()
    assert (numbers["before_1"], numbers["before_2"], numbers["speed_5"]) == ("0.20", "0.40", "1.00")
    assert (numbers["swing_2"], numbers["swing_5"], numbers["energy"]) == ("3", "40", "50")


def test_a_changed_function_is_not_explained_away(csv, monkeypatch):
    """Bobs that hit nobody: the page must not say why two leave."""
    monkeypatch.setattr(visualize_cradle_run, "handle_collision", lambda e, omega1, omega2, *_: (omega2, omega1 / 2))
    _, questions = run("single", "2_two_bobs", csv)
    assert "Only two bobs keep both" not in questions.area.text
    assert "a function in src/, or a setting, is different" in questions.area.text


@pytest.mark.parametrize("key", [key for kind, key in SHIPPED if kind == "single"])
def test_without_a_hit_nothing_is_claimed(key, csv, monkeypatch):
    """As in a student's preview: the bobs swing through each other."""
    monkeypatch.setattr(visualize_cradle_run, "handle_two_bobs", lambda *_, **__: None)
    _, questions = run("single", key, csv)
    assert questions.measurement.is_over
    assert questions.measurement.outcome() is None
    assert "What happened: none of these answers.</strong> No two bobs hit each other." in questions.area.text
