"""The text file of an experiment: how it is read, and which mistakes it is refused for."""

import re
from math import radians

import pytest
from students import put_files
from whole_cradles import HEADER

from support.files.experiments import read_experiment, read_experiments

TEXT = """\
name = Two bobs
theta = -45 -45 0 0 0
question = What leaves
    # It is a comment.
    on the other side?
why = {speed_5} m/s after {before_1} m/s, {swing_5} degrees, {energy} %
- One=1 = 0 0 0 0 100
* Two = 0 0 0 45 45
"""


def read(folder, text=TEXT, cords=1):
    """Return the experiment with this text."""
    return read_experiment(put_files(folder, {"two.txt": text}) / "two.txt", cords)


def test_an_experiment_is_read_however_an_editor_has_written_it(tmp_path):
    experiment = read(tmp_path)
    assert experiment.key == "two"
    assert experiment.name == "Two bobs"
    assert experiment.question == "What leaves on the other side?"
    assert experiment.answers == [("One=1", [0, 0, 0, 0, 100]), ("Two", [0, 0, 0, 45, 45])]
    assert experiment.explained == 1
    assert experiment.why == "{speed_5} m/s after {before_1} m/s, {swing_5} degrees, {energy} %"
    assert read(tmp_path, ("\ufeff" + TEXT.replace("\n", "\r\n")).encode()) == experiment


def test_an_experiment_has_a_csv_with_a_color_for_each_pendulum(tmp_path):
    text = TEXT.replace(" 0 0 0", " 0 0 0 0").replace(
        "question", "e = 0 0.5 1 1 1 1\n#\nmass = 5 1 1 1 1 1e-7\nquestion"
    )
    csv = read(tmp_path, text).csv
    assert csv.filepath.name == "two.csv"
    assert csv.columns == HEADER.strip().split(",")
    assert [",".join(cells) for cells in csv.pendula] == [
        "5.0,0.0,0.0,0.0,red,metal",
        "1.0,0.5,0.0,0.0,yellow,metal",
        "1.0,1.0,0.0,0.0,cyan,metal",
        "1.0,1.0,0.0,0.0,blue,metal",
        "1.0,1.0,0.0,0.0,purple,metal",
        "1e-07,1.0,0.0,0.0,red,metal",
    ]


def test_phi_is_measured_from_the_upper_cord(tmp_path):
    text = TEXT.replace("question", "phi = -20 10 0 0 0\nmass = 1 1 1e-6 1 1\nquestion")
    upper, lower = read(tmp_path, text, cords=2).poses[0]
    assert upper == pytest.approx(radians(-45))
    assert lower == pytest.approx(radians(-65))


ANGLE = "an angle from -180 to 180 (degrees), for each of 5 pendula"
LINES = "name, theta, phi, mass, e, hidden, question, why, or an answer after - or *"
FOUR = "- a = 0 0 0 0 0\n- b = 1 0 0 0 0\n- c = 2 0 0 0 0\n- d = 3 0 0 0 0\n"
BAD = [  # an old and a new text; the beginning of the message after the name of the file; a part
    ("theta = -45", "theta = -180.5", ", theta: found '-180.5 -45 0 0 0', ", ANGLE),
    ("name = Two bobs\n", "", ", name: found nothing, ", "a text"),
    ("name = Two bobs", "name = My cradle", ", name: found 'My cradle', ", "text"),
    ("- One", "* One", ", answers: found 2 answers, 2 of them with an asterisk", "one of them"),
    ("- One", f"{FOUR}- One", ", answers: found 6 answers, 1 of them", "2 to 5"),
    ("0 0 0 45 45", "45 45", ", * Two: found '45 45', ", ANGLE),
    ("{speed_5}", "{speed_6}", ", why: found {speed_6}, ", "the number of a bob, 1 to 5"),
    ("{speed_5}", "{speed_5", ", why: found {, ", "in braces"),
    ("question", "phi = 0 0 0 0 0\nquestion", ", phi: is allowed only for", "double"),
    ("question", "e = 1 1 1 1 1.1\nquestion", ", e: found '1 1 1 1 1.1', ", "from 0 to 1"),
    ("question", "seconds = 0.5\nquestion", ", line 3: found 'seconds = 0.5', ", LINES),
    ("question", "hidden = mass 6\nquestion", ", hidden: found 'mass 6', ", "1 to 5, or e"),
    ("question", "e = 1 1 1 1 0\nhidden = e\nquestion", ", hidden: found 'e', ", "e, if all have"),
    ("question", "e = 0 0 0 0 0\nhidden = e\nquestion", ", hidden: found 'e', ", "one above 0"),
    ("question", "hidden = e\nquestion", ", hidden: found answers, which are", "not allowed"),
    ("leaves", "l\xe9aves", ", line 3: found byte 0xe9, ", "UTF-8"),
]


@pytest.mark.parametrize(("old", "new", "beginning", "part"), BAD)
def test_a_bad_experiment_is_refused_with_the_place_of_its_mistake(
    tmp_path, old, new, beginning, part
):
    with pytest.raises(ValueError, match=re.escape(part)) as caught:
        read(tmp_path, TEXT.replace(old, new).encode("latin-1"))
    assert str(caught.value).startswith(f"{tmp_path / 'two.txt'}{beginning}")


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ("", "phi: found nothing, allowed is an angle"),
        ("phi = 0 0 0 0 0\nmass = 1 1 9.9e-7 1 1\n", "mass: found '1 1 9.9e-7 1 1', .*1e6 times"),
    ],
)
def test_an_experiment_of_the_double_cradle_needs_phi_and_masses_in_a_range(
    tmp_path, lines, message
):
    with pytest.raises(ValueError, match=message):
        read(tmp_path, lines + TEXT, cords=2)


def test_the_menu_is_in_the_order_of_the_numbers_and_without_bad_experiments(tmp_path):
    files = {f"{name}.txt": TEXT.replace("Two bobs", name) for name in ("b", "10_a", "9_c")}
    files["._9_c.txt"] = b"\0\5\26\7"  # a Mac adds it on a disk of another system
    files["0_wrong.txt"] = "<s>"
    files["11_b.txt"] = files["b.txt"]
    files["12_a_folder.txt/file"] = ""
    put_files(tmp_path, files)
    experiments, mistakes = read_experiments(tmp_path, 1)
    assert [experiment.key for experiment in experiments] == ["9_c", "10_a", "11_b"]
    beginnings = [
        f"{tmp_path / '0_wrong.txt'}, line 1: found '<s>', ",
        f"{tmp_path / '12_a_folder.txt'}: cannot be read: ",
        f"{tmp_path / 'b.txt'}, name: 'b' is the name of another experiment",
    ]
    for mistake, beginning in zip(mistakes, beginnings, strict=True):
        assert mistake.startswith(beginning)
