"""The output of `pytest` in a student's folder, on 80 columns: missing functions, and mistakes."""

import os
import re
import subprocess
import sys
from textwrap import dedent

import pytest
from graded import CHECKS, GRADER, outcomes_of
from programs import PROCESS_SECONDS, python, ROOT, slow_except
from right_solutions import PLAIN
from students import COLUMNS, PYTEST, pytest_in, write
from wrong_solutions import WRONG

from grading.assignment import FUNCTIONS, SUITES
from grading.grade import Results
from grading.outcomes import Outcome, PASSED
from grading.outcomes import waiting as waits
from grading.screen import SCREEN, Screen


def test_with_x_a_fresh_starter_stops_at_the_first_function(starter):
    status, rows = pytest_in(starter, "--tier", "D", "-x")
    assert status == 1
    begin = rows.index("steps       extract_and_convert in ASSIGNMENT.md")
    assert rows[begin - 2].strip("= ") == "Not written yet"
    place = rows[begin - 1]
    assert place.startswith("extract_and_convert in src/pds_helper.py, line ")
    assert rows[-3] == f"Next:  {place}."
    assert rows[-1].startswith("1 waiting in ")


LABELS = (
    *("wrong", "called", "came back", "expected", "your code", "right here", "seen", "steps"),
    *("also fails", "printed"),
)


def screen_of(outcomes, printed=""):
    """Return the lines of a screen about the outcomes of checks; those of others are passed."""
    outcomes = {check.name: outcome for check, outcome in outcomes.items()}
    screen = Screen(Results(GRADER.checks, outcomes), [])
    return [line.text for line in screen.lines(dict.fromkeys(outcomes, printed))]


@pytest.mark.parametrize(("function", "words"), slow_except([*WRONG][::9], WRONG))
def test_each_screen_has_the_same_order_and_at_most_40_lines(solve, function, words):
    """What was printed is there only if there is room."""
    solve(function, WRONG[function, words])
    passed = dict.fromkeys(CHECKS, Outcome(PASSED))
    lines = screen_of({**passed, **outcomes_of(function)}, "1\n2\n3")
    assert len(lines) + 2 <= SCREEN  # and the dots, and the counts
    assert all(len(line) <= COLUMNS for line in lines)
    end = lines.index(f"{' Grade ':=^{COLUMNS}}")
    labels = [*dict.fromkeys(line[:12].strip() for line in lines[1:end] if line[:2].strip())]
    assert labels == [label for label in LABELS if label in labels]


D = [name for name, function in FUNCTIONS.items() if function.tier == "D"]
# The tiers that ran, the functions of them that wait, the verdict, and the program to look at
VERDICTS = [
    (SUITES, [], "Grade: Honor roll.", "visualize_double_cradle_run.py"),
    (SUITES, ["make_double_pendulum"], "Grade: A.", "visualize_cradle_run.py"),
    (
        SUITES,
        ["elastic_newton_cradle"],
        "Grade: none yet. For D: elastic_newton_cradle, 1 of 15 points missing.",
        "",
    ),
    (SUITES, D[:3], "Grade: none yet. For D: 3 functions, 5 of 15 points missing.", ""),
    ("C", [], "Tier C is complete.", "visualize_cradle_run.py"),
]


@pytest.mark.parametrize(("tiers", "waiting", "verdict", "program"), VERDICTS)
def test_the_verdict_names_what_is_missing_and_the_program_to_look_at(
    tiers, waiting, verdict, program
):
    """In a run of some tiers, nothing is said of the others."""
    ran = [check for check in CHECKS if check.tier in tiers]
    states = [waits("you") if check.function in waiting else Outcome(PASSED) for check in ran]
    lines = screen_of(dict(zip(ran, states, strict=True)))
    assert verdict in lines
    assert any(line.startswith("Grade:") for line in lines) == (tiers is SUITES)
    shown = [line.partition("src/")[2] for line in lines if line.startswith("Look at it:")]
    assert shown == ([program] if program else [])


README = (ROOT / "tests/starter/README.md").read_text(encoding="utf-8")
SHOWN = """\
    # linear
    v1 = omega1*r_param
    v2 = omega2*r_param  # the second one
    new1 = (m1*v1 + m2*v2 + m2*e*(v1-v2))/(m1+m2)
    new2 = (m1*v1 + m2*v2 + m1*(v1-v2))/(m1+m2)
    print(new1)
    return new1/r_param, new2/r_param"""


@pytest.mark.parametrize("options", slow_except([""], ["", "-n 2"]))
def test_the_readme_shows_a_real_screen(starter, options):
    """Nothing stands above it, but for lines of pytest-xdist."""
    write(starter, *FUNCTIONS, handle_collision=SHOWN)
    _, rows = pytest_in(starter, *options.split())
    begin = [row.startswith("___") for row in rows].index(True)
    assert options or begin == 1
    screen = "\n".join(f"    {row}".rstrip() for row in rows[begin:-1])
    assert f"\n{screen}\n" in README, f"It shows another screen. Now it is:\n{screen}"


IN_TERMINAL = "import pty, sys; pty.spawn([sys.executable, *sys.argv[1:]])"


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="Windows has no pty")
def test_a_debugger_has_its_prompt_in_a_terminal(starter):
    debugged = f"if g == 8: breakpoint()\n{dedent(PLAIN['angle_update'])}"
    write(starter, *FUNCTIONS, angle_update=debugged)
    command = [sys.executable, "-c", IN_TERMINAL, *PYTEST.split(), "--tier", "C"]
    done = subprocess.run(
        command, cwd=starter, input=b"p omega\nc\n", stdout=subprocess.PIPE, timeout=PROCESS_SECONDS
    )
    assert b"3.0" in done.stdout
    assert b"Tier C is complete." in done.stdout


STUBBORN = """
import time
while True:
    try: time.sleep(1)
    except BaseException: pass
"""
IMPATIENT = """
from grading.limits import Limits
import pytest
Limits.__init__.__defaults__ = 50, 0.3, 0.1, 1000
pytest.main(["--tier", "C"])
"""


def test_a_function_that_nothing_stops_ends_pytest_with_its_line(starter):
    write(starter, "angle_update", angle_update=STUBBORN)
    done = python("-c", IMPATIENT, folder=starter, PYTHONPATH="tests")
    assert done.returncode == 1
    line = r"src/swinging\.py, line \d+ still runs after it was stopped, so pytest ends here\."
    assert re.fullmatch(f"\n{line}\n", done.stderr)
