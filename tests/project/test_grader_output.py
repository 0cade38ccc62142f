"""The output of `pytest` in a student's folder, on 80 columns: missing functions, and mistakes."""

import ast
import os
import re
import shutil
import subprocess
import sys
from math import ceil
from pathlib import Path
from textwrap import dedent, indent

import pytest
from programs import ROOT, SECONDS, slow_but_for
from whole_cradles import FIVE_CSV
from wrong_solutions import PLAIN

from grading.grade import table
from grading.grader import checks, FAILED, FAULT, Outcome, PASSED
from grading.handout import FUNCTIONS, SUITES

COLUMNS = 80
STUB = 'raise NotImplementedError("{} is not written yet")'
STUBS = {
    **{name: STUB.format(name) for name in FUNCTIONS},
    "extract_and_convert": f"bad_rep = pd.read_csv(relative_filepath)\n{STUB.format('extract_and_convert')}",
    "main": f"while page.is_running():\n    if page.wants_cradle():\n        {STUB.format('main')}",
}


@pytest.fixture
def student(tmp_path_factory):
    """A function that makes a student's folder with these bodies of functions."""
    folder = tmp_path_factory.mktemp("s")

    def make(**bodies):
        for name in ("src", "support", "tests/grading"):
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        for name in ("pyproject.toml", *(f"tests/{suite}.py" for suite in SUITES.values())):
            shutil.copy(ROOT / name, folder / name)
        (folder / "newton_cradle_pends.csv").write_text(FIVE_CSV)
        for name, body in bodies.items():
            put(folder / FUNCTIONS[name].file, name, body)
        return folder

    return make


def put(file, function, body):
    """Replace the body of a function in a file."""
    lines = file.read_text().splitlines()
    (node,) = (
        node for node in ast.parse("\n".join(lines)).body if isinstance(node, ast.FunctionDef) and node.name == function
    )
    lines[node.body[0].lineno - 1 : node.end_lineno] = indent(dedent(body), "    ").rstrip().splitlines()
    file.write_text("\n".join(lines) + "\n")


def run(folder, *options):
    """Return the exit status of pytest in a folder, and its output as rows of a terminal."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTEST_ADDOPTS"}
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *options]
    environment["COLUMNS"] = str(COLUMNS)
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=2 * SECONDS)
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


def test_with_x_a_fresh_starter_stops_at_the_first_function(student):
    folder = student(**STUBS)
    status, rows = run(folder, "--tier", "D", "-x")
    assert status == 1
    place = place_of_stub(folder, "extract_and_convert")
    assert section(rows, "Not written yet") == [f"extract_and_convert in {place}"]
    assert section([*rows, "==="], "Grade")[2] == "Grade: none yet."
    assert "Next:  extract_and_convert in src/pds_helper.py; read in the handout: A CVS to " in "".join(rows)
    assert rows[-1].strip("= ").startswith("1 waiting in ")


def test_a_mistake_is_the_last_message_and_fits_on_a_screen(student):
    """pytest shows only the printed lines of the first mistake."""
    body = PLAIN["make_newton_cradle"].replace("r_param, pend['theta']", "r_param, 0")
    body = "for i in range(25):\n    print('row', i)\n" + dedent(body)
    collision = "print('collision')\nreturn omega1, omega2"
    status, rows = run(student(make_newton_cradle=body, handle_collision=collision))
    assert status == 1
    assert len(rows) <= 45 + 11  # with the printed lines
    assert section(rows, "Failures") == ["3 more fail: handle_collision"]
    title = "Use one relevant helper function to create the tuple of objects."
    shown = section(rows, title)
    assert shown[:11] == [*(f"printed     row {i}" for i in range(10)), "printed     ... (25 lines in all)"]
    assert shown[12] == "called      make_newton_cradle(relative_filepath, r_param=0.4, theta_init=0.6)"
    assert "".join(shown).endswith(" test_bobs_hang_from_their_axles")  # the command to watch it, above the table
    assert not [row for row in rows if "collision" in row and "printed" in row]


def outcomes(**states):
    """Return outcomes of the checks of these tiers; all of a tier have the same state."""
    return {check.name: Outcome(state) for tier, state in states.items() for check in checks(tier=tier)}


@pytest.mark.parametrize(
    ("states", "words"),
    [
        ({"C": PASSED}, ["Tier C is complete.", "Next:  run all checks of tier D."]),
        ({"B": FAILED}, ["Tier B is not complete.", "Next:  handle_collision in src/visualize_cradle_run.py."]),
        ({"D": PASSED, "C": PASSED, "B": FAULT}, ["Grade: C.", "Next:  show your teacher the grader's fault in {}."]),
    ],
)
def test_the_grade_and_the_next_step(states, words):
    text = [line for line, _ in table(outcomes(**states))]
    assert text[-2:] == [line.format("test_handle_collision") for line in words]


def test_code_that_ends_the_program_and_a_thread_that_does_not_end_leave_the_table(student):
    folder = student()
    for file, code in [
        ("swinging", "import os\n\nos._exit(0)\n"),
        ("pds_helper", "import threading\n\nthreading.Thread(target=threading.Event().wait).start()\n"),
    ]:
        with (folder / "src" / f"{file}.py").open("a") as source:
            source.write(code)
    status, rows = run(folder)
    assert status == 1
    assert "it raised   SystemExit: os._exit(0)" in rows
    assert section(rows, "Grade")[1].split() == ["D", "16", "0", "0", "16/16"]
    assert " failed, " in rows[-1]  # the last line of pytest is there


@pytest.mark.parametrize("name", slow_but_for(["json.py"], ["json.py", "tests/statistics.py", "pandas/__init__.py"]))
def test_a_file_that_hides_a_module_is_named(student, name):
    folder = student()
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text("x = 1\n")
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=2 * SECONDS)
    file, module = Path(name.removesuffix("/__init__.py")), Path(name.removesuffix("/__init__.py")).stem
    line = f"{file} hides the module {module} from Python and its packages. Rename it.\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


@pytest.mark.slow
def test_an_import_in_a_circle_is_named(student):
    folder = student()
    swinging = folder / "src" / "swinging.py"
    source = swinging.read_text()
    swinging.write_text(
        source.replace("from support", "from src.visualize_cradle_run import handle_two_bobs\nfrom support")
    )
    status, rows = run(folder)
    assert status == 1
    text = "".join(row.ljust(COLUMNS) for row in rows)
    assert "called      angle_update(omega, theta, r_param, dt, g)" in text
    assert "it raised   ImportError: cannot import name 'full_swing_update' from partially initialized module" in text
    assert "            src/swinging.py, line 5, in <module>" in text
    assert "hint        Your files import each other in a circle. Remove the import in src/swinging.py." in text
    assert "12 wait for src/swinging.py" in rows
    assert rows[-2] == "Next:  angle_update in src/swinging.py."


@pytest.mark.slow
def test_side_by_side_the_suites_say_the_same(student):
    """With pytest-xdist, one of two processes makes all checks. The first process writes the grade."""
    pytest.importorskip("xdist")
    folder = student(
        angle_update="print('swing')\nreturn omega, theta",
        handle_collision="return omega1, omega2",
        make_double_pendulum=STUBS["make_double_pendulum"],
    )
    others = "import pytest\n\n\n@pytest.mark.parametrize('number', range(30))\ndef test_other(number): pass\n"
    (folder / "tests" / "test_others.py").write_text(others)
    ends = []
    for options in ([], ["-n", "2"]):
        status, rows = run(folder, "-v", *options, "--grade-json", "grade.json")
        begin = [row.strip("= ") for row in rows].index("Not written yet")
        ends.append((status, rows[begin:-1], (folder / "grade.json").read_text()))  # the last row says how long it took
        (folder / "grade.json").unlink()
    assert ends[0] == ends[1]
    done = re.findall(r"^\[(gw\d)\] .* tests/(test_\w+)\.py", "\n".join(rows), re.MULTILINE)
    assert {file for _, file in done} == {"test_others", *SUITES.values()}
    assert len({process for process, file in done if file != "test_others"}) == 1


def place_of_stub(folder, function):
    file = FUNCTIONS[function].file
    lines = (folder / file).read_text().splitlines()
    return f"{file}, line {1 + lines.index('    ' + STUB.format(function))}"
