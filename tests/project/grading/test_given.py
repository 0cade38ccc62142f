"""What a file of src/ defines: given functions that a student changes, and names defined twice."""

import json

import pytest
from programs import ROOT
from students import change

from grading.assignment import GIVEN
from grading.given import changed_given, defined_twice, GIVEN_FUNCTIONS

SWING, CSV = "src/swinging.py", "src/pds_helper.py"
DEF = "def swing_update(pend_dict: PendulumEntry, r_param: float, dt: float, g: float) -> None:\n"
THETA = '    pend_dict["theta"] = theta\n'
SHOW = "    show_pendulum(pend_dict, r_param)\n"

# A file, a text in a given function of it, and what it becomes; then the statement whose line is
# named. Nothing is said of harmless changes.
CHANGED = [
    (SWING, THETA, "    # It\n    pend_dict['theta'] = (theta)\n", ""),
    (SWING, DEF, f"def swing_update(): pass\n{DEF}", ""),  # the last counts
    (SWING, f"{DEF}    ", "", ""),  # Python cannot read the file
    (SWING, DEF, DEF.replace("swing", "my"), "none"),
    (SWING, SHOW, "", '"] = theta'),
    (CSV, 'name != "objects"', "name", "if name not in"),
]


@pytest.mark.parametrize(("file", "before", "after", "line"), CHANGED)
def test_a_given_function_that_has_changed_is_named_with_the_line(
    starter, file, before, after, line
):
    change(starter / file, before, after)
    said = []
    if line == "none":
        said = [f"swing_update was given; {file} has none."]
    elif line:
        number = (starter / file).read_text().partition(line)[0].count("\n") + 1
        name = {SWING: "swing_update", CSV: "write_to_csv"}[file]
        said = [f"{name} was given; yours differs in line {number} of {file}."]
    assert changed_given(starter) == said


def test_a_starter_has_the_source_of_all_given_functions(made):
    """Students write double_cradle_tick, which has no check."""
    sources = json.loads((made / GIVEN_FUNCTIONS).read_text())
    assert {*sources} == GIVEN - {"double_cradle_tick"}


def test_nothing_is_compared_in_the_project():
    assert not changed_given(ROOT)


def test_a_function_that_is_defined_twice_is_named_with_the_lines(tmp_path):
    path = tmp_path / "swinging.py"
    path.write_text(
        "def swing(): pass\nclass Mine:\n  def swing(): pass\n@cache\ndef swing(): pass"
    )
    assert (
        defined_twice(path, "swing")
        == "swing is defined in lines 1 and 5; Python uses the last one."
    )
    assert defined_twice(path, "Mine") == ""
