"""Experiments: their files, their menu and questions on the page, and that each explains what really happens."""

import re
from itertools import combinations
from math import atan2, degrees, radians

import pytest
from students import put_files
from wall import Wall
from whole_cradles import FIVE_CSV, GOOD, HEADER

from src import visualize_cradle_run
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.prediction import Measurement
from support.files.experiments import EXPERIMENTS, read_experiment, read_experiments

KINDS = {kind.kind: kind for kind in (Cradle, DoubleCradle)}
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
    return put_files(tmp_path, {"two.csv": FIVE_CSV, "two.txt": TEXT})


def test_an_experiment_is_read(files):
    """Also with lines that end as on Windows. phi is measured from the upper cord."""
    experiment = read_experiment(files / "two.csv", 1)
    assert (experiment.key, experiment.name, experiment.seconds) == ("two", "Two bobs", 0.5)
    assert experiment.question == "What leaves on the other side?"
    assert [answer.text for answer in experiment.answers] == ["One", "Two"]
    assert experiment.answers[experiment.explained].swings == [0, 0, 0, 45, 45]
    assert [experiment.angles[0], experiment.angles[4]] == [[radians(-45)], [0]]
    (files / "two.txt").write_bytes(("\ufeff" + TEXT.replace("\n", "\r\n")).encode())
    assert read_experiment(files / "two.csv", 1) == experiment
    with pytest.raises(ValueError, match="phi: found nothing, allowed is a text$"):
        read_experiment(files / "two.csv", 2)
    (files / "two.txt").write_text(TEXT.replace("seconds", "phi = -20 10 0 0 0\nseconds"))
    angles = read_experiment(files / "two.csv", 2).angles
    assert angles[:2] == [pytest.approx([radians(-45), radians(phi)]) for phi in (-65, -35)]
    (files / "two.csv").write_text(FIVE_CSV.replace("1.0", "1e-7", 1))
    with pytest.raises(ValueError, match="at most 1e6 times the smallest mass, in a double cradle$"):
        read_experiment(files / "two.csv", 2)


ANGLES = "allowed are 5 angles from -180 to 180 (degrees), one for each pendulum"
BRACES = "allowed is {energy}, or swing_, speed_ or before_ with the number of a bob, 1 to 5, in braces"
NAMES = "allowed is a text without & < >, but not 'My cradle (CSV)'"
TO_FIVE = "allowed are 2 to 5, one of them with an asterisk"
BAD = [
    ("theta = -45", "theta = -181", f"theta: found '-181 -45 0 0 0', {ANGLES}"),
    ("seconds = 0.5", "seconds = 0", "seconds: found '0', allowed is a number above 0 and up to 60"),
    ("name = Two bobs\n", "", "name: found nothing, allowed is a text"),
    ("name = Two bobs", "name = <Two>", f"name: found '<Two>', {NAMES}"),
    ("name = Two bobs", "name = My cradle (CSV)", f"name: found 'My cradle (CSV)', {NAMES}"),
    ("* Two", "Two", f"[answers]: found 2 answers, 0 of them with an asterisk, {TO_FIVE}"),
    ("One = 0 0 0 0 100\n", "", f"[answers]: found 1 answers, 1 of them with an asterisk, {TO_FIVE}"),
    ("* Two", "* One", "[answers]: found an answer twice"),
    ("0 0 0 45 45", "45 45", f"* Two: found '45 45', {ANGLES}"),
    ("{speed_5}", "{speed_6}", f"why: found {{speed_6}}, {BRACES}"),
    ("{speed_5}", "{speed_5", f"why: found {{, {BRACES}"),
    ("seconds", "phi = 0 0 0 0 0\nseconds", "phi: is allowed only for the double cradle"),
    ("[answers]", "answers", "txt' [line 9]"),
]


def test_bad_experiments_are_named_in_one_line_each_and_the_other_one_works(files):
    for number, (old, new, _) in enumerate(BAD):
        assert old in TEXT
        text = TEXT.replace(old, new).replace("Two bobs", "Three bobs")
        put_files(files, {f"bad_{number:02}.csv": FIVE_CSV, f"bad_{number:02}.txt": text})
    csvs = {"broken.csv": FIVE_CSV.replace("red", "rouge"), **dict.fromkeys(["latin.csv", "silent.csv"], FIVE_CSV)}
    put_files(files, {**csvs, "latin.txt": b"\xe9", "alone.txt": TEXT, "two_more.csv": FIVE_CSV, "two_more.txt": TEXT})
    expected = [
        ("alone.csv", ": cannot be read as a CSV file: No such file or directory"),
        *((f"bad_{number:02}.txt", words) for number, (*_, words) in enumerate(BAD)),
        ("broken.csv", ", line 2, column color: found 'rouge', "),
        ("latin.txt", ": is no text, saved as UTF-8"),
        ("silent.txt", ": cannot be read: No such file or directory"),
        ("two_more.txt", ", name: 'Two bobs' is the name of another experiment"),
    ]
    experiments, mistakes = read_experiments(files, 1)
    assert [experiment.key for experiment in experiments] == ["two"]
    for mistake, (name, words) in zip(mistakes, expected, strict=True):
        assert mistake.startswith(str(files / name))
        assert words in mistake
        assert "\n" not in mistake


TWO, FROM_BOTH_SIDES, HEAVY = 1, 3, 4  # indices of experiments
SAID_B = "You said: B, One bob, as far as the two."
QUESTION = "Two bobs come in. What leaves on the other side?"
THAT, OTHER = "That is what happened.", "What happened: C, Two bobs, as far as the two."
SHEET, AFTER = "Print a sheet", ["Again", "Again slowly", "Next experiment", "Print a sheet"]


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
    """Return the lines of the question's area, and the words on its last buttons."""
    before_the_sheet = wall.viewer.questions.area.text.split('<div class="sheet')[0]
    text = re.sub('<button class="hands".*?</button>', "", before_the_sheet)
    return [re.sub("<.*?>", "", line).replace("&ensp;", " ") for line in re.split("</p>|</button>", text)[:-1]]


def test_an_experiment_is_as_its_files_say_and_back_at_your_csv_all_is_as_you_had_set_it(wall):
    wall.use(wall.panel.angles[0].slider, value=20)
    wall.use(wall.panel.lifted.slider, value=0.4)
    wall.use(wall.panel.collisions, selected="perfectly inelastic, e = 0")
    wall.viewer.cradle.mass = 3.0  # as with --mass
    choose(wall, HEAVY)
    assert (wall.values("mass"), wall.values("e")) == ([5, 1, 1, 1, 1], [1] * 5)
    assert (wall.lifts(), wall.panel.collisions.selected) == ([45, 0, 0, 0, 0], "as in the CSV")
    assert shown(wall) == []
    choose(wall, FROM_BOTH_SIDES)
    assert wall.lifts() == [45, 0, 0, 0, 45]
    assert [theta > 0 for theta in wall.thetas()] == [False, False, False, False, True]
    assert ">1 of 5<" in wall.panel.lifted.text.text
    wall.press("3")  # changes an experiment, too
    assert wall.lifts() == [45, 45, 45, 0, 0]
    choose(wall, None)
    assert (wall.lifts(), wall.panel.collisions.selected) == ([20, 20, 0, 0, 0], "perfectly inelastic, e = 0")
    assert (wall.values("mass"), wall.values("e")) == ([3] * 5, [0] * 5)


def test_a_mistake_in_an_experiment_is_shown_below_the_menu(csv, tmp_path, monkeypatch):
    texts, folder = [], put_files(tmp_path / "experiments", {"single/no_<text>.csv": FIVE_CSV})
    monkeypatch.setattr("support.page.source.EXPERIMENTS", folder)
    monkeypatch.setattr("support.page.questions.wtext", lambda text="": texts.append(text))
    assert Wall(csv).viewer.questions.menu.choices == ["My cradle (CSV)"]
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


@pytest.mark.parametrize(("answer", "happened"), [(2, THAT), (0, OTHER), (None, OTHER)])
def test_the_question_comes_before_each_release_and_the_explanation_after_it(asking, answer, happened):
    texts = [each.text for each in asking.viewer.questions.experiments[TWO].answers]
    answers = [f"{letter} {text}" for letter, text in zip("ABCD", texts, strict=True)]
    said = [] if answer is None else [f"You said: {answers[answer].replace(' ', ', ', 1)}."]
    for _ in range(2):
        assert shown(asking) == [QUESTION, *answers, "Run it without an answer", SHEET]
        asking.wait(0.5)
        assert (asking.time(), asking.lifts(), asking.panel.pause.text) == (0, [45, 45, 0, 0, 0], "Run")
        asking.viewer.give("answer", ["2_two_bobs", answer])
        asking.wait(0.3)
        assert shown(asking) == [QUESTION, *said, SHEET]
        assert asking.time() > 0.2
        asking.wait(0.3)
        *before, result = shown(asking)[:-4]
        assert (before, shown(asking)[-4:]) == ([QUESTION, *said], AFTER)
        # From 45 degrees, a bob comes down at sqrt(2 g R (1 - cos 45 degrees)) = 1.07 m/s.
        assert result.startswith(f"{happened} Two bobs came in at 1.07 m/s, and two left at 1.07 and 1.07 m/s.")
        asking.wait(0.5)
        assert shown(asking)[-5] == result
        asking.press("r")


@pytest.mark.parametrize("command", ["pause", "step", "tick"])
def test_the_cradle_also_runs_without_an_answer(asking, command):
    asking.viewer.give(command)
    asking.wait(0.05)
    assert shown(asking) == [QUESTION, SHEET]
    assert 0 < asking.viewer.motion.ticks < 1000
    if asking.panel.pause.text == "Run":
        asking.panel.pause.bind()
    asking.wait(0.6)
    assert shown(asking)[-5].startswith(f"{OTHER} Two bobs came in at 1.07 m/s")


@pytest.mark.parametrize("value", [["1_one_bob", 0], ["5_heavy_hits_light", None], ["2_two_bobs", 99]])
def test_an_answer_to_another_question_does_nothing(asking, value):
    asking.viewer.give("answer", value)
    asking.viewer.give("vote", value)
    asking.wait(0.1)
    assert (len(shown(asking)), asking.time(), asking.viewer.questions.votes) == (7, 0, [0] * 4)
    choose(asking, None)
    asking.click(asking.panel.pause)
    asking.viewer.give("answer", ["2_two_bobs", 0])
    asking.wait(0.1)
    assert (shown(asking), asking.panel.pause.text) == ([], "Run")


def test_the_box_asks_at_once_and_takes_the_question_back(wall):
    for number, (time, lines) in {None: (0.2, 0), TWO: (0, 7)}.items():
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
    "collisions": lambda wall: wall.use(wall.panel.collisions, selected="perfectly inelastic, e = 0"),
    "separating": lambda wall: wall.give("separating", True),
    "drag": lambda wall: wall.mouse("mousedown", wall.viewer.cradle.bobs()[4].pos),
    "edit": lambda wall: wall.give("edit", [0, "mass", "2"]),
    "file": lambda wall: wall.save(HEADER + GOOD * 6),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_ends_the_question_as_it_is_no_longer_about_this_cradle(asking, change):
    CHANGES[change](asking)
    asking.wait(0.6)  # the measurement would be over
    assert (shown(asking), asking.panel.pause.text) == ([], "Pause")  # only the question has held it up
    assert asking.viewer.questions.menu.selected == ("My cradle (CSV)" if change == "file" else None)
    asking.press("r")
    ask_first(asking, False)
    ask_first(asking, True)
    assert shown(asking) == []
    choose(asking, TWO)
    assert len(shown(asking)) == 7


def test_hands_are_counted_a_key_answers_and_ghosts_swing_as_far_as_the_answer_says(asking):
    """The picture rests for three seconds at the measurement. Then they have gone, and keys of answers do nothing."""
    for number in (1, 2, 2):
        asking.give("vote", ["2_two_bobs", number])
    assert re.findall(r'class="hands"[^>]*>(\d+)<', asking.viewer.questions.area.text) == ["0", "1", "2", "0"]
    asking.press("e")  # there are four answers
    assert asking.panel.pause.text == "Run"
    asking.press("a")
    asking.wait(0.2)
    assert ghosts(asking) == []
    asking.wait(0.15)
    assert 0 < ghosts(asking)[4] < 100
    asking.wait(2.5)
    assert asking.time() == 0.47
    assert shown(asking)[1] == "You said: A, One bob, twice as fast. Hands: A 0, B 1, C 2, D 0."
    assert ghosts(asking) == pytest.approx([0, 0, 0, 0, 100])  # the pale bobs that its file says
    asking.press("b")
    asking.wait(1)
    assert (asking.time() > 0.6, ghosts(asking), shown(asking)[1][:11]) == (True, [], "You said: A")


def ghosts(wall):
    """Return the angles of the visible ghosts (degrees)."""
    visible = [ghost for ghost in wall.viewer.marks.shapes["ghosts"] if ghost.visible]
    arms = [ghost.pos - axle.pos for ghost, axle in zip(visible, wall.viewer.cradle.axles(), strict=bool(visible))]
    return [degrees(atan2(arm.x, -arm.y)) for arm in arms]


def test_again_maybe_slowly_and_next(asking):
    """Again keeps the answer. Slow motion ends with the rest, and the speed is as you have set it."""
    asking.use(asking.panel.speed.slider, value=2.0)
    asking.press("b")
    asking.wait(0.5)
    for slowly, speed in ((True, 0.1), (False, 2.0)):
        asking.give("again", slowly)
        assert (asking.viewer.pace.speed, asking.lifts()[:2], shown(asking)[1]) == (speed, [45, 45], SAID_B)
        asking.wait(0.47 / speed + 0.1)
        assert (asking.time(), shown(asking)[-4:], asking.viewer.pace.speed) == (0.47, AFTER, speed)
        asking.wait(3)
        assert (asking.time() > 0.47, asking.viewer.pace.speed) == (True, 2.0)
    names = [experiment.name for experiment in asking.viewer.questions.experiments]
    for name in (*names[2:], *names[:2]):
        asking.press("n")
        assert (asking.viewer.questions.menu.selected, asking.time()) == (name, 0)
        assert asking.viewer.questions.is_asking
    choose(asking, None)
    asking.give("again", False)
    asking.press("a")
    assert shown(asking) == []


def test_a_sheet_has_the_question_and_after_the_run_the_measured_figures(asking):
    def pages():
        text = asking.viewer.questions.area.text.split('<div class="sheet">')[1]
        return [" ".join(re.sub("<.*?>", " ", page).split()) for page in text.split("</article>")[:-1]]

    [page] = pages()
    for text in ("Two bobs", QUESTION, "Three bobs, not so far", "My answer", "My sketch", "I measured: speed ___"):
        assert text in page
    asking.press("c")
    asking.wait(0.6)
    first, second = pages()
    assert first == page
    for text in (f"{THAT} Two bobs came in", "(m/s) 1.07 1.07 0.00 0.00 0.00", "swung to (degrees) 0 0 0 45 45"):
        assert text in second


def run(kind, key, csv):
    """Run a shipped experiment; return the viewer's questions, with the measurement at its end."""
    wall = Wall(csv, *[30] * len(KINDS[kind].angles), kind=KINDS[kind])
    questions = wall.viewer.questions
    [number] = [i for i, experiment in enumerate(questions.experiments) if experiment.key == key]
    ask_first(wall, True)
    choose(wall, number)
    wall.viewer.give("answer", [key, questions.experiments[number].explained])
    wall.wait(questions.experiments[number].seconds + 0.1)
    assert questions.measurement.is_over
    return questions


@pytest.mark.parametrize(("kind", "key"), SHIPPED)
def test_a_shipped_experiment_explains_what_happens_and_its_answers_differ(kind, key, csv):
    questions = run(kind, key, csv)
    measured, experiment = questions.measurement, questions.experiment
    assert questions.mistakes == []
    assert measured.outcome() == experiment.explained
    assert measured.swings == pytest.approx(experiment.answers[experiment.explained].swings, abs=3)
    assert "That is what happened" in questions.area.text
    assert "{" not in measured.explanation()
    for answer, other in combinations(experiment.answers, 2):
        assert max(abs(a - b) for a, b in zip(answer.swings, other.swings, strict=True)) > 5


def test_a_measurement_has_the_speeds_at_the_first_hit_and_the_largest_swings(files):
    """Bobs 1 and 2 come in at 1 and 2 rad/s; after the hit, bob 5 swings to 40 degrees."""

    def measure(*samples):
        measured = Measurement(read_experiment(files / "two.csv", 1))
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
    assert measured.explanation().startswith("After the first hit, the bobs swung to 0, -3, 0, 0, 40 degrees.")
    assert "expects: Two." in measured.explanation()
    numbers = measured.numbers()
    assert (numbers["before_1"], numbers["before_2"], numbers["speed_5"]) == ("0.20", "0.40", "1.00")
    assert (numbers["swing_2"], numbers["swing_5"], numbers["energy"]) == ("3", "40", "50")
    # Nothing is claimed without a hit, also if an answer predicts swings as small as those that are not measured.
    (files / "two.txt").write_text(TEXT.replace("0 0 0 45 45", "0 0 0 9 9"))
    assert measure(*before).outcome() is None
    assert measure(*before).explanation() == "No two bobs hit each other."


def test_another_outcome_is_not_explained_away(csv, monkeypatch):
    """If a hit takes half of the velocity, the page must not say why two leave."""
    monkeypatch.setattr(visualize_cradle_run, "handle_collision", lambda e, omega1, omega2, *_: (omega2, omega1 / 2))
    text = run("single", "2_two_bobs", csv).area.text
    assert "Only two bobs keep both" not in text
    assert "What happened: none of these answers.</strong> After the first hit, the bobs swung to" in text
