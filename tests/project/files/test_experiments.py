"""The TOML file of an experiment: how it is read, and which mistakes it is refused for."""

import re
from math import radians

import pytest
from students import put_files

from support.columns import COLUMN_NAMES
from support.files.experiments import COLORS, Experiment, read_experiment, read_experiments
from support.files.valid_cradle import CradleCsv

CRADLE = {"name": "'Two'", "theta": "[-45, 0]", "phi": "[-20, 10]"}
ASKING = CRADLE | {
    "question": "'''What\n    leaves?'''",
    "answers": "{'One = 1' = [0, 90], Two = 45}",
    "right": "'B'",
    "why": "'{speed_2} {before_1} {swing_1} {energy} {hits}'",
}
HIDING = CRADLE | {"hidden": "'e'", "question": "'e?'", "why": "'So.'"}


def read(folder, lines):
    """Return the experiment of the double cradle with these lines."""
    text = "".join(f"{name} = {value}\n" for name, value in lines.items())
    return read_experiment(put_files(folder, {"two.toml": text}) / "two.toml", cords=2)


def test_an_experiment_is_read(tmp_path):
    experiment = read(tmp_path, ASKING)
    first_pose = [radians(-45), radians(-45) + radians(-20)]
    assert experiment == Experiment(
        stem="two",
        csv=experiment.csv,
        name="Two",
        poses=[first_pose, [0, radians(10)]],
        question="What leaves?",
        answers=[("One = 1", [0, 90]), ("Two", [45, 45])],
        explained=1,
        why=ASKING["why"].strip("'"),
    )


def test_an_experiment_has_a_csv_with_a_color_for_each_pendulum(tmp_path):
    csv = read(tmp_path, CRADLE | dict.fromkeys(["theta", "phi"], f"{[0] * 6}")).csv
    rows = [f"1.0 1.0 0.0 0.0 {color} metal".split() for color in (*COLORS, "red")]
    assert csv == CradleCsv(tmp_path / "two.csv", COLUMN_NAMES, rows)


# A changed line, and words of the message
WITH_ANSWERS = """\
theta = -45 | theta: found -45, allowed is a list
theta = [] | found []
theta = [-181, 0] | from -180 to 180
phi = [1] | found [1]
mass = [1, 9e-7] | from 0.001 to 1000
name = ' ' | a text
name = 5 | a text
seconds = 1 | a name: found 'seconds', allowed is name, theta
answers = {a = 0} | a table of 2 to 5
answers = 5 | a table of 2 to 5
answers = {a=1, b=1, c=1, d=1, e=1, f=1} | answers: found
right = 'C' | found 'C', allowed is one of ['A', 'B']
why = '{speed_3}' | found '{speed_3}', allowed is {energy}
why = '{' | found '{'
why = So. | (at line 8
"""
WITH_HIDDEN = """\
right = 'A' | found 'right'
hidden = 'mass 3' | found 'mass 3', allowed is mass
e = [0, 0] | or e, if
e = [1, 0.5] | or e, if
why = '{hits}' | without braces
"""
BAD = [(ASKING, row) for row in WITH_ANSWERS.splitlines()]
BAD += [(HIDING, row) for row in WITH_HIDDEN.splitlines()]


@pytest.mark.parametrize(("lines", "row"), BAD)
def test_a_bad_experiment_is_refused_with_the_place_of_its_mistake(tmp_path, lines, row):
    line, words = row.split(" | ")
    name, value = line.split(" = ", 1)
    with pytest.raises(ValueError, match=f"two.toml: .*{re.escape(words)}"):
        read(tmp_path, lines | {name: value})


def test_the_menu_is_in_the_order_of_the_files_and_without_bad_experiments(tmp_path):
    text = "name = 'Two'\ntheta = [0]"
    files = {
        "._09.toml": b"\0\5\26\7",  # a Mac adds it on a disk of another system
        "10.toml": text,
        "09.toml": text.replace("Two", "One"),
        "11.toml": text,
        "12.toml": b"#\n# l\xe9aves",
        "14.toml": "name = 'Three'",
    }
    experiments, mistakes = read_experiments(put_files(tmp_path, files), 1)
    assert [*experiments] == ["One", "Two"]
    beginnings = [
        "11.toml: 'Two' is the name of another experiment",
        "12.toml, line 2: found byte 0xe9",
        "14.toml: theta: found nothing",
    ]
    for mistake, beginning in zip(mistakes, beginnings, strict=True):
        assert mistake.startswith(str(tmp_path / beginning))
