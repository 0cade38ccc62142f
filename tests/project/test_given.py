"""What a file of src/ defines: given functions that a student changes, and names defined twice."""

import json

import pytest
from programs import ROOT
from students import change

from grading.given import changed_given, defined_twice, GIVEN_FUNCTIONS
from grading.handout import GIVEN

SWING, CSV, DOUBLE = "swing_update", "write_to_csv", "double_swing_update"
FILES = {
    SWING: "src/swinging.py",
    CSV: "src/pds_helper.py",
    DOUBLE: "src/double_cradle.py",
    "make_double_newton_cradle": "src/double_cradle.py",
}
DEF = "def swing_update(pend_dict, r_param, dt, g) -> None:\n"
THETA = '    pend_dict["theta"] = theta\n'
SHOW = "    show_pendulum(pend_dict, r_param)\n"
APPEND = "columns.append(name)\n"
OBJECTS = 'name != "objects"'
UPDATE = "    pend_dict.update(omega=omega, phi_omega=phi_omega, theta=theta, phi=phi)\n"
SPEEDS = '        speeds = f"omega = {omega:g} and phi_omega = {phi_omega:g} rad/s"\n'
DIFFERS, MISSING = "yours differs in line", "in yours, code is missing below line"
GONE = "src/swinging.py has none at the left edge"

# A given function, a text in its file, and what it becomes; then what is said, and the line that is
# named. Nothing is said of harmless changes.
# fmt: off
CHANGED = [
    (SWING, THETA, f"    # The angle\n\n\n{THETA}", "", ""),
    (SWING, THETA, "    pend_dict['theta'] = (theta);\n", "", ""),
    (SWING, THETA, "    pend_dict['theta']: float = theta\n", "", ""),
    (SWING, THETA, f"{THETA}    'The angle.'\n", "", ""),
    (SWING, DEF, f"{DEF}    'Mine.'\n", "", ""),
    (SWING, DEF, "def swing_update(pend_dict: dict, r_param: float, dt, g):\n", "", ""),
    (SWING, DEF, f"def swing_update():\n    pass\n\n\n{DEF}", "", ""),
    ("make_double_newton_cradle", "pend_list: list = make", "pend_list = make", "", ""),
    (DOUBLE, "(pend_dict, r_param, dt, g) -> None", "(\n  pend_dict, r_param, dt, g\n)", "", ""),
    (SWING, SHOW, f"{SHOW}  return\n", "", ""),  # Python cannot read the file
    (SWING, SHOW, f"{SHOW}\0\n", "", ""),
    (SWING, THETA, THETA.replace("= ", "= -"), DIFFERS, '["theta"] = -theta'),
    (SWING, THETA, THETA.replace("=", "+="), DIFFERS, '["theta"] += theta'),
    (SWING, THETA, 2 * THETA, DIFFERS, THETA),
    (SWING, SHOW, f"{SHOW}    return pend_dict\n", DIFFERS, "return pend_dict"),
    (SWING, SHOW, f"    if g > 0:\n    {SHOW}", DIFFERS, "if g > 0"),
    (SWING, SHOW, f"    try:\n    {SHOW}    except KeyError:\n        pass\n", DIFFERS, "try:"),
    (SWING, THETA, "", MISSING, '["omega"] = omega'),
    (SWING, SHOW, "", MISSING, '["theta"] = theta'),
    (SWING, THETA + SHOW, "", MISSING, '["omega"] = omega'),
    (SWING, f"{THETA}{SHOW}", f"{SHOW}{THETA}", DIFFERS, SHOW),
    (SWING, DEF, "def swing_update(pend, r_param, dt, g):\n", DIFFERS, "def swing_update"),
    (SWING, DEF, "def swing_update(pend_dict, r_param, dt, g=9.8):\n", DIFFERS, "def swing_update"),
    (SWING, DEF, f"@staticmethod\n{DEF}", DIFFERS, "def swing_update"),
    (SWING, DEF, f"async {DEF}", DIFFERS, "def swing_update"),
    (SWING, SHOW, f"{SHOW}\n\ndef swing_update():\n    pass\n", DIFFERS, "def swing_update()"),
    (SWING, DEF, DEF.replace("swing", "my_swing"), GONE, ""),
    (SWING, DEF, f"if True:\n  {DEF}    pass\n\ndef mine(pend_dict, r_param, dt, g):\n", GONE, ""),
    (CSV, OBJECTS, "name != 'objects'", "", ""),
    (CSV, OBJECTS, 'name == "objects"', DIFFERS, 'name == "objects"'),
    (CSV, APPEND, f"{APPEND}        columns.sort()\n", DIFFERS, "columns.sort"),
    (CSV, "        df.to_csv", "        pass\n    df.to_csv", DIFFERS, "pass"),
    (CSV, "[] if pend_list", "[] if not pend_list", DIFFERS, "if not pend_list"),
    (CSV, "filepath=NC_FP", 'filepath="x.csv"', DIFFERS, "def write_to_csv"),
    (DOUBLE, SPEEDS, SPEEDS.replace("{omega", "{-omega"), DIFFERS, "{-omega"),
    (DOUBLE, UPDATE, f"    {UPDATE}", DIFFERS, UPDATE),
    (DOUBLE, UPDATE, UPDATE.replace("phi_omega", "omega_phi", 1), DIFFERS, "omega_phi="),
    (DOUBLE, "dt / steps", "dt", DIFFERS, "theta, phi = double_angle_update("),
]
# fmt: on


@pytest.mark.parametrize(("name", "before", "after", "said", "line"), CHANGED)
def test_a_given_function_that_has_changed_is_named_with_the_line(
    starter, name, before, after, said, line
):
    file = FILES[name]
    change(starter / file, before, after)
    if line:
        said = f"{said} {number_of(line, starter / file)} of {file}"
    assert changed_given(starter) == ([f"{name} was given; {said}."] if said else [])


def number_of(line, file):
    """Return the number of the last line of a file that has this text."""
    lines = file.read_text(encoding="utf-8").split("\n")
    return max(i for i, other in enumerate(lines, 1) if line.strip("\n") in other)


def test_a_starter_has_the_source_of_all_given_functions(made):
    """Students write double_cradle_tick, which has no check."""
    sources = json.loads((made / GIVEN_FUNCTIONS).read_text())
    assert {*sources} == GIVEN - {"double_cradle_tick"}


def test_nothing_is_compared_in_the_project_nor_in_a_file_that_is_away(starter):
    assert not changed_given(ROOT)
    (starter / FILES[SWING]).unlink()
    assert not changed_given(starter)


STUB = "def swing(a):\n    raise NotImplementedError\n"
TWICE = [
    ("", ""),
    (STUB, ""),
    (STUB + STUB, "lines 1 and 3; Python uses the second one"),
    (f"{STUB}\n@cache\n{STUB}x = 1\n{STUB}", "lines 1, 5 and 8; Python uses the last one"),
    (f"{STUB}class swing:\n    pass\n", "lines 1 and 3; Python uses the second one"),
    (f"{STUB}if True:\n    def swing():\n        pass\n", ""),
    (f"class Mine:\n    def swing(self):\n        pass\n{STUB}", ""),
    (f"{STUB}swing = cache(swing)\nswing_2 = swing\n", ""),
    (f"{STUB}{STUB}return)", ""),
]


@pytest.mark.parametrize(("code", "said"), TWICE)
def test_a_function_that_is_defined_twice_is_named_with_the_lines(tmp_path, code, said):
    path = tmp_path / "swinging.py"
    path.write_text(code)
    assert defined_twice(str(path), "swing") == (f"swing is defined in {said}." if said else "")
    assert not defined_twice(str(tmp_path / "away.py"), "swing")
