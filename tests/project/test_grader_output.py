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
from students import change, COLUMNS, PYTEST, pytest_in, write, write_tiers

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from grading.outcomes import FAULT, Outcome, PASSED
from grading.room import fitting, Part, Rank
from grading.screen import grade_lines, SCREEN


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
    unwritten = section(rows, "Not written yet")
    assert unwritten[:2] == [place, "Next: extract_and_convert"]
    assert (
        "steps       read_csv gives df, to_dict gives bad_rep, and pend_list gets each" in unwritten
    )
    assert section(rows, "Grade")[:2] == ["Grade: none yet.", f"Next:  {place}."]
    assert rows[-1].startswith("1 waiting in ")


def test_a_mistake_is_told_once_on_a_screen(starter):
    """Also with many prints, other mistakes, and a mistake in the CSV."""
    right = dedent(PLAIN["make_newton_cradle"])
    wrong = right.replace("r_param, pend['theta']", "r_param, theta_init").replace(
        "return", "for i in range(25): print('row', i)\nreturn"
    )
    write(
        starter,
        *FUNCTIONS,
        make_newton_cradle=wrong,
        handle_collision="return omega1, omega2",
    )
    change(starter / "newton_cradle_pends.csv", "yellow", "grey")
    status, rows = pytest_in(starter)
    assert status == 1
    assert len(rows) <= SCREEN
    text = " ".join(" ".join(rows).split())
    assert "All bobs are lifted. make_pendulum must get the theta of each pendulum" in text
    assert text.count("All bobs are lifted") == 1
    assert "Note: your CSV has a mistake. newton_cradle_pends.csv, line 3, column color:" in text


def test_a_program_with_rate_that_writes_its_csv_has_all_points_and_leaves_your_files(starter):
    """It also reads a CSV by a path of its own, as when it is started in this folder.

    A test of the student's has imported write_to_csv before.
    """
    write_tiers(starter, "DCBA")
    (starter / "conftest.py").write_text("import src.pds_helper\n")
    program = starter / "src/visualize_cradle_run.py"
    change(program, "import mag", "import mag, rate")
    change(program, "while is_running(pend_list):", "while True:\n        rate(1 / DT)")
    writes = """    from src.pds_helper import write_to_csv
    from src.special_cradles import uniform_mass_newton_cradle
    write_to_csv(uniform_mass_newton_cradle(NC_FP, 3))
    write_to_csv(uniform_mass_newton_cradle('mine.csv', 3), 'mine.csv')
"""
    change(program, "    pend_list = ", f"{writes}    pend_list = ")
    change(program, "cradle(NC_FP, R_PARAM", "cradle('mine.csv', R_PARAM")
    files = [starter / "newton_cradle_pends.csv", starter / "mine.csv"]
    before = files[0].read_bytes()
    files[1].write_bytes(before)
    status, rows = pytest_in(starter, "--tier", "A")
    assert (status, rows[-3]) == (0, "Tier A is complete.")
    assert [file.read_bytes() for file in files] == [before, before]


def test_what_has_no_room_is_left_out_by_its_rank():
    parts = [
        Part(Rank.ALWAYS, ["wrong"]),
        Part(Rank.ALWAYS, ["your code   line by line"]),
        Part(Rank.GAVE, ["a = 1"], is_row=True),
        Part(Rank.ALWAYS, ["b = 2"], is_row=True),
        Part(Rank.LEADING, ["Your function f:"], is_title=True),
        Part(Rank.IDLE, ["c"], is_row=True),
        Part(Rank.NEVER, ["d"], is_row=True),
        Part(Rank.BOOKS, ["books"]),
        Part(Rank.STEPS, ["the", "steps"]),
    ]
    whole = fitting(parts, 20)
    left_out = "your code   line by line (1 line is left out)"
    assert whole == [
        "wrong",
        left_out,
        "a = 1",
        "b = 2",
        "Your function f:",
        "c",
        "books",
        "the",
        "steps",
    ]
    left_out = "your code   line by line (3 lines are left out)"
    assert fitting(parts, 6) == ["wrong", left_out, "b = 2", "the", "steps"]
    assert fitting(parts, 0) == ["wrong", left_out, "b = 2"]


@pytest.mark.parametrize(
    ("tiers", "outcome", "expected"),  # of the checks of the last tier; those of others are passed
    [
        ("DB", Outcome(PASSED), ["Grade: D.", "Next:  run the checks of tier C: pytest --tier C."]),
        ("DC", Outcome(FAULT), ["C             0 of 6 points: 6 failed", "Grade: D."]),
        (
            "C",
            Outcome(PASSED),
            ["Tier C is complete.", "Next:  run the checks of tier D: pytest --tier D."],
        ),
    ],
)
def test_the_grade_and_the_next_step(tiers, outcome, expected):
    outcomes = {check.name: Outcome(PASSED) for tier in tiers for check in checks(tier=tier)}
    outcomes |= {check.name: outcome for check in checks(tier=tiers[-1])}
    lines = [line for line, _ in grade_lines(outcomes, COLUMNS, "")]
    assert [line for line in lines if line in expected] == expected


README = (ROOT / "tests/README.md").read_text(encoding="utf-8")
SHOWN = """\
    # linear
    v1 = omega1*r_param
    v2 = omega2*r_param  # the second one
    new1 = (m1*v1 + m2*v2 + m2*e*(v1-v2))/(m1+m2)
    new2 = (m1*v1 + m2*v2 + m1*(v1-v2))/(m1+m2)
    print(new1)
    return new1/r_param, new2/r_param"""


def test_the_readme_shows_a_real_screen(starter):
    write(starter, *FUNCTIONS, handle_collision=SHOWN)
    _, rows = pytest_in(starter)
    screen = "\n".join(f"    {row}".rstrip() for row in rows[1:-1])
    assert f"\n{screen}\n" in README, f"tests/README.md shows another screen. Now it is:\n{screen}"


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="Windows has no pty")
def test_a_debugger_has_its_prompt_in_a_terminal(starter):
    debugged = f"if g == 8: breakpoint()\n{dedent(PLAIN['angle_update'])}"
    write(starter, *FUNCTIONS, angle_update=debugged)
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
    title = "angle_update in src/swinging.py"
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
