"""The output of `pytest` in a student's folder, on 80 columns: missing functions, and mistakes."""

import re
from math import ceil
from pathlib import Path
from textwrap import dedent

import pytest
from programs import python, slow_but_for
from students import change, write
from wrong_solutions import PLAIN

from grading.grade import table
from grading.grader import checks, FAILED, Outcome, PASSED
from grading.handout import FUNCTIONS, SUITES

COLUMNS = 80
PYTEST = ("-m", "pytest", "-p", "no:cacheprovider")


def run(folder, *options):
    """Return the exit status of pytest in a folder, and its output as rows of a terminal."""
    done = python(*PYTEST, *options, folder=folder, PYTEST_ADDOPTS="", COLUMNS=str(COLUMNS))
    assert done.stderr == ""
    rows = []
    for line in done.stdout.splitlines():
        rows += [line[COLUMNS * i : COLUMNS * (i + 1)] for i in range(max(1, ceil(len(line) / COLUMNS)))]
    return done.returncode, rows


def section(rows, title):
    """Return the rows between this title and the next one. The title occurs once."""
    (begin,) = (i for i, row in enumerate(rows) if row.strip("=_ ") == title)
    below = rows[begin + 1 :]
    return below[: next(i for i, row in enumerate(below) if row.startswith(("===", "__", "_ ")))]


def test_with_x_a_fresh_starter_stops_at_the_first_function(starter):
    status, rows = run(starter, "--tier", "D", "-x")
    assert status == 1
    lines = (starter / "src/pds_helper.py").read_text().splitlines()
    number = 1 + lines.index('    raise NotImplementedError("extract_and_convert is not written yet")')
    assert section(rows, "Not written yet") == [f"extract_and_convert in src/pds_helper.py, line {number}"]
    assert section([*rows, "==="], "Grade")[2] == "Grade: none yet."
    assert "Next:  extract_and_convert in src/pds_helper.py; read in the handout: A CVS to " in "".join(rows)
    assert rows[-1].strip("= ").startswith("1 waiting in ")


def test_a_mistake_is_the_last_message_and_fits_on_a_screen(starter):
    """pytest shows only the printed lines of the first mistake."""
    body = PLAIN["make_newton_cradle"].replace("r_param, pend['theta']", "r_param, 0")
    body = "for i in range(25):\n    print('row', i)\n" + dedent(body)
    collision = "print('collision')\nreturn omega1, omega2"
    write(starter, *FUNCTIONS, make_newton_cradle=body, handle_collision=collision)
    status, rows = run(starter)
    assert status == 1
    assert len(rows) <= 45 + 11  # with the printed lines
    assert section(rows, "Failures") == ["3 more fail: handle_collision"]
    title = "Use one relevant helper function to create the tuple of objects."
    shown = section(rows, title)
    assert shown[:11] == [*(f"printed     row {i}" for i in range(10)), "printed     ... (25 lines in all)"]
    assert shown[12] == "called      make_newton_cradle(relative_filepath, r_param=0.4, theta_init=0.6)"
    assert "".join(shown).endswith(" test_bobs_hang_from_their_axles")  # the command to watch it, above the table
    assert not [row for row in rows if "collision" in row and "printed" in row]


@pytest.mark.parametrize(
    ("tier", "state", "words"),
    [
        ("C", PASSED, ["Tier C is complete.", "Next:  run all checks of tier D."]),
        ("B", FAILED, ["Tier B is not complete.", "Next:  handle_collision in src/visualize_cradle_run.py."]),
    ],
)
def test_the_grade_and_the_next_step(tier, state, words):
    """test_starter.py has the grades of several tiers, and a fault."""
    lines = [line for line, _ in table({check.name: Outcome(state) for check in checks(tier=tier)})]
    assert lines[-2:] == words


def test_code_that_ends_the_program_and_a_thread_that_does_not_end_leave_the_table(starter):
    write(starter, *FUNCTIONS)
    for file, code in [
        ("swinging", "import os\n\nos._exit(0)\n"),
        ("pds_helper", "import threading\n\nthreading.Thread(target=threading.Event().wait).start()\n"),
    ]:
        with (starter / "src" / f"{file}.py").open("a") as source:
            source.write(code)
    status, rows = run(starter)
    assert status == 1
    assert "it raised   SystemExit: os._exit(0)" in rows
    assert section(rows, "Grade")[1].split() == ["D", "16", "0", "0", "16/16"]
    assert " failed, " in rows[-1]  # the last line of pytest is there


@pytest.mark.parametrize("name", slow_but_for(["json.py"], ["json.py", "tests/statistics.py", "pandas/__init__.py"]))
def test_a_file_that_hides_a_module_is_named(starter, name):
    (starter / name).parent.mkdir(exist_ok=True)
    (starter / name).write_text("x = 1\n")
    done = python(*PYTEST, folder=starter)
    file, module = Path(name.removesuffix("/__init__.py")), Path(name.removesuffix("/__init__.py")).stem
    line = f"{file} hides the module {module} from Python and its packages. Rename it.\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


@pytest.mark.slow
def test_an_import_in_a_circle_is_named(starter):
    write(starter, *FUNCTIONS)
    circle = "from src.visualize_cradle_run import handle_two_bobs\n"
    change(starter / "src/swinging.py", "from support", f"{circle}from support")
    status, rows = run(starter)
    assert status == 1
    text = "".join(row.ljust(COLUMNS) for row in rows)
    assert "called      angle_update(omega, theta, r_param, dt, g)" in text
    assert "it raised   ImportError: cannot import name 'full_swing_update' from partially initialized module" in text
    assert "            src/swinging.py, line 7, in <module>" in text
    assert "hint        Your files import each other in a circle. Remove the import in src/swinging.py." in text
    assert "12 wait for src/swinging.py" in rows
    assert rows[-2] == "Next:  angle_update in src/swinging.py."


@pytest.mark.slow
def test_side_by_side_the_suites_say_the_same(starter):
    """With pytest-xdist, one of two processes makes all checks. The first process writes the grade."""
    pytest.importorskip("xdist")
    written = FUNCTIONS.keys() - {"make_double_pendulum"}
    bodies = {"angle_update": "print('swing')\nreturn omega, theta", "handle_collision": "return omega1, omega2"}
    write(starter, *written, **bodies)
    others = "import pytest\n\n\n@pytest.mark.parametrize('number', range(30))\ndef test_other(number): pass\n"
    (starter / "tests" / "test_others.py").write_text(others)
    ends = []
    for options in ([], ["-n", "2"]):
        status, rows = run(starter, "-v", *options, "--grade-json", "grade.json")
        begin = [row.strip("= ") for row in rows].index("Not written yet")
        grade = (starter / "grade.json").read_text()
        ends.append((status, rows[begin:-1], grade))  # the last row says how long it took
        (starter / "grade.json").unlink()
    assert ends[0] == ends[1]
    done = re.findall(r"^\[(gw\d)\] .* tests/(test_\w+)\.py", "\n".join(rows), re.MULTILINE)
    assert {file for _, file in done} == {"test_others", *SUITES.values()}
    assert len({process for process, file in done if file != "test_others"}) == 1
