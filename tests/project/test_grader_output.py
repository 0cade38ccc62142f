"""The output of `pytest` in a student's folder, on 80 columns: missing functions, and mistakes."""

import os
import re
import subprocess
import sys
from contextlib import suppress
from textwrap import dedent

import pytest
from programs import python, ROOT, SECONDS
from right_solutions import PLAIN
from students import change, COLUMNS, PYTEST, pytest_in, write

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from grading.layout import TraceRow
from grading.outcomes import FAILED, FAULT, Outcome, PASSED
from grading.screen import SCREEN, table


def section(rows, title):
    """Return the rows between this title and the next one. The title occurs once."""
    (begin,) = (i for i, row in enumerate(rows) if row.strip("=_ ") == title)
    found = []
    for row in rows[begin + 1 :]:
        if row.startswith(("===", "__", "_ ")):
            break
        found.append(row)
    return found


def test_with_x_a_fresh_starter_stops_at_the_first_function(starter):
    status, rows = pytest_in(starter, "--tier", "D", "-x")
    assert status == 1
    lines = (starter / "src/pds_helper.py").read_text().splitlines()
    stub = '    raise NotImplementedError("extract_and_convert is not written yet")'
    place = f"extract_and_convert in src/pds_helper.py, line {1 + lines.index(stub)}"
    assert section(rows, "Not written yet") == [place]
    grade = section(rows, "Grade")
    assert grade[2] == "Grade: none yet."
    assert f"Next:  {place}." in grade
    assert "       The steps: read_csv gives df, to_dict gives bad_rep, and pend_list gets" in grade
    assert rows[-1].startswith("1 waiting in ")


def test_a_mistake_is_told_on_a_screen(starter):
    """pytest shows only the printed lines of the first mistake.

    Above the next step is a note about the CSV.
    """
    right = PLAIN["make_newton_cradle"]
    wrong = dedent(right.replace("r_param, pend['theta']", "r_param, theta_init"))
    write(
        starter,
        *FUNCTIONS,
        make_newton_cradle=f"for i in range(25):\n    print('row', i)\n{wrong}",
        handle_collision="print('collision')\nreturn omega1, omega2",
    )
    change(starter / "newton_cradle_pends.csv", "yellow", "grey")
    status, rows = pytest_in(starter)
    assert status == 1
    assert len(rows) <= SCREEN
    message = section(rows, "Use one relevant helper function to create the tuple of objects.")
    printed = [row for row in rows if row.startswith("printed ")]
    assert printed == message[:6]
    assert printed[0] == "printed     row 0"
    assert printed[-1] == "printed     ... (25 lines in all)"
    source = (starter / "src/special_cradles.py").read_text()
    number = 1 + source.partition("make_pendulum(axle_pos")[0].count("\n")
    text = " ".join(row.strip() for row in rows)
    assert f"Next:  make_newton_cradle in src/special_cradles.py, line {number}." in text
    assert "All bobs are lifted. make_pendulum must get the theta of each pendulum" in text
    assert "Note:  your CSV has a mistake. newton_cradle_pends.csv, line 3, column color:" in text


WRONG = Outcome(FAILED, place="a.py, line 7", wrong="A is 5, not 6.")
OWN_ROWS = [TraceRow(0, ["    7  a = 5"])]
HELPERS_ROWS = [
    TraceRow(0, ["    Your function f, called there:"], is_title=True),
    TraceRow(9, ["    2  b"] * 40),
]


@pytest.mark.parametrize(
    ("tiers", "outcome", "expected"),  # of the checks of the last tier; those of others are passed
    [
        ("DB", Outcome(PASSED), ["Grade: D.", "Next:  run the checks of tier C: pytest --tier C."]),
        (
            "DC",
            Outcome(FAULT),
            ["Grade: D.", "Next:  show your teacher the grader's fault in test_angle_update."],
        ),
        (
            "C",
            Outcome(PASSED),
            ["Tier C is complete.", "Next:  run the checks of tier D: pytest --tier D."],
        ),
        (
            "B",
            WRONG._replace(hint="Do."),
            ["Next:  handle_collision in a.py, line 7.", "       A is 5, not 6. Do."],
        ),
        (
            "B",
            WRONG._replace(wrong="E: f.", hint="Do."),
            ["       The steps: both omegas become linear velocities; the two formulas of the"],
        ),
        ("A", WRONG._replace(wrong="A."), ["       In Python, with books:"]),
        (
            "C",
            WRONG._replace(help="It is so.", rows=OWN_ROWS, facts=["No line has set it."]),
            [
                "       It is so.",
                "       Your code, line by line:",
                "    7  a = 5",
                "       No line has set it.",
            ],
        ),
        (
            "C",
            WRONG._replace(rows=OWN_ROWS + HELPERS_ROWS),
            ["       Your code, line by line (1 line is left out):", "    7  a = 5"],
        ),
    ],
)
def test_the_grade_and_the_next_step(monkeypatch, tiers, outcome, expected):
    monkeypatch.setattr("grading.grade.checks_command", lambda: "pytest")
    outcomes = {check.name: Outcome(PASSED) for tier in tiers for check in checks(tier=tier)}
    outcomes |= {check.name: outcome for check in checks(tier=tiers[-1])}
    lines = [line for line, _ in table(outcomes, COLUMNS)]
    assert [line for line in lines if line in expected] == expected
    assert "    Your function f, called there:" not in lines


README = (ROOT / "tests/README.md").read_text(encoding="utf-8")
SHOWN = """\
    # linear
    v1 = omega1*r_param
    v2 = omega2*r_param  # the second one
    new1 = (m1*v1 + m2*v2 - m2*e*(v1-v2))/(m1+m2)
    new2 = (m1*v1 + m2*v2 + m1*e*(v1-v2))/m1+m2
    print(new1)
    return new1, new2"""


def test_the_readme_shows_a_real_screen(starter):
    write(starter, *FUNCTIONS, handle_collision=SHOWN)
    _, rows = pytest_in(starter)
    begin = [row[:5] for row in rows].index("Next:")
    screen = "\n".join(f"    {row}".rstrip() for row in rows[begin:-1])
    assert f"\n{screen}\n" in README, f"tests/README.md shows another screen. Now it is:\n{screen}"


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="Windows has no pty")
@pytest.mark.parametrize("debug", ["breakpoint()", "import pdb; pdb.set_trace()"])
def test_a_debugger_has_its_prompt_in_a_terminal(starter, debug):
    """Without a terminal, breakpoint does nothing: the other tests have none."""
    write(starter, *FUNCTIONS, angle_update=f"if g == 8: {debug}\n{dedent(PLAIN['angle_update'])}")
    status, rows = pytest_in(starter, "--tier", "C")
    assert status == 0, rows
    ours, theirs = os.openpty()
    command = [sys.executable, *PYTEST.split(), "--tier", "C"]
    process = subprocess.Popen(command, cwd=starter, stdin=theirs, stdout=theirs, stderr=theirs)
    os.close(theirs)
    output = b""
    while b"(Pdb) " not in output:
        output += os.read(ours, 1000)
    os.write(ours, b"p omega\nc\n")
    with suppress(OSError):  # the terminal is closed
        while True:
            output += os.read(ours, 1000)
    os.close(ours)
    assert process.wait(SECONDS) == 0
    assert b"3.0" in output
    assert b"Tier C is complete." in output


@pytest.mark.slow
def test_side_by_side_the_suites_say_the_same(starter):
    """With pytest-xdist, one of two processes performs all checks.

    The first process writes the grade.
    """
    pytest.importorskip("xdist")
    written = FUNCTIONS.keys() - {"make_double_pendulum"}
    bodies = {
        "angle_update": "print('swing')\nreturn omega, theta",
        "handle_collision": "return omega1, omega2",
    }
    write(starter, *written, **bodies)
    others = """
import pytest
@pytest.mark.parametrize('number', range(30))
def test_other(number): pass
"""
    (starter / "tests" / "test_others.py").write_text(others)
    title = "Takes in theta and omega and updates them for a given timestep dt."
    ends = []
    for options in ([], ["-n", "2"]):
        status, rows = pytest_in(starter, "-vv", *options, "--grade-json", "grade.json")
        begin = [row.strip("_ ") for row in rows].index(title)
        # The last row has the time
        ends.append((status, rows[begin:-1], (starter / "grade.json").read_text()))
        (starter / "grade.json").unlink()
    assert ends[0] == ends[1]
    done = re.findall(r"^\[gw\d\] .* tests/(test_\w+)\.py", "\n".join(rows), re.MULTILINE)
    assert {*done} == {"test_others", *SUITES.values()}


# An interrupt between the inner two lines is caught by the outer ones.
STUBBORN = """while True:
    try:
        while True:
            try:
                while True: omega += 1
            except: pass
    except: pass
"""
IMPATIENT = """import sys
from grading import limits
import pytest
limits.PATIENCE, limits.NEXT_INTERRUPT = 0.3, 0.1
sys.exit(pytest.main(["--tier", "C"]))
"""


@pytest.mark.slow
def test_a_function_that_nothing_stops_ends_pytest_with_its_line(starter):
    write(starter, "angle_update", angle_update=STUBBORN)
    done = python("-c", IMPATIENT, folder=starter, PYTHONPATH=f"tests{os.pathsep}.")
    assert done.returncode == 1
    place = r"src/swinging\.py, line \d+"
    assert re.fullmatch(
        rf"\n{place} catches all that could stop it, so pytest ends here\.\n", done.stderr
    )
