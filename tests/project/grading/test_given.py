"""What a file of src/ defines: given functions that a student changes, and names defined twice."""

import json

import pytest
from students import change, pytest_in

from grading.assignment import GIVEN
from grading.given import changed_given, defined_twice, GIVEN_FUNCTIONS

DEF = "def swing_update(pend_dict: PendulumEntry, r_param: float, dt: float, g: float) -> None:\n"
THETA = '    pend_dict["theta"] = theta\n'
SHOW = "    show_pendulum(pend_dict, r_param)\n"

# A text in the file of swing_update, what it becomes, and what is said. Nothing is said of harmless
# changes.
DIFFERS = "swing_update was given; yours differs in src/swinging.py: "
CHANGED = [
    (THETA, "    # It\n    pend_dict['theta'] = (theta)\n", []),
    (DEF, f"def swing_update(): pass\n{DEF}", []),  # the last one counts
    (f"{DEF}    ", "", []),  # Python cannot read the file
    (DEF, DEF.replace("swing", "my"), ["swing_update was given; src/swinging.py has none."]),
    (THETA, "", [f"{DIFFERS}show_pendulum(pend_dict, r_param)"]),
    (SHOW, "", [f"{DIFFERS}(its end)"]),
]


@pytest.mark.parametrize(("before", "after", "said"), CHANGED)
def test_a_given_function_that_has_changed_is_named_with_the_line(starter, before, after, said):
    change(starter / "src/swinging.py", before, after)
    assert changed_given(starter) == said


def test_a_starter_has_the_source_of_all_given_functions(made):
    """Students write double_cradle_tick, which has no check."""
    sources = json.loads((made / GIVEN_FUNCTIONS).read_text())
    assert {*sources} == GIVEN - {"double_cradle_tick"}


STUB = "def angle_update("
# A text in a new starter, what stands in its place, and what pytest says
DEFINED = [
    (STUB, f"def angle_update(): pass\n{STUB}", "angle_update is defined in lines"),
    (STUB, "def update(", "src/swinging.py has no function angle_update."),
    (SHOW, "", f"Note: {DIFFERS}(its end)"),
]


@pytest.mark.parametrize(("before", "after", "said"), DEFINED)
def test_pytest_says_what_a_file_defines(starter, before, after, said):
    change(starter / "src/swinging.py", before, after)
    _, rows = pytest_in(starter, "--tier", "C")
    assert said in " ".join(" ".join(rows).split())


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
