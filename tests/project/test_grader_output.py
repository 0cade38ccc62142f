"""The output of `pytest` in a student's folder, on 80 columns: missing functions, and mistakes."""

import os
import re
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from textwrap import dedent

import pytest
from programs import python, ROOT, SECONDS, slow_but_for
from right_solutions import PLAIN
from students import change, put_files, write

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from grading.outcomes import FAILED, FAULT, Outcome, PASSED
from grading.screen import SCREEN, table

COLUMNS = 80
PYTEST = "-m pytest -p no:cacheprovider"


def run(folder, *options):
    """Return the exit status of pytest in a folder, and its output as rows of a terminal."""
    done = python(*PYTEST.split(), *options, folder=folder, PYTEST_ADDOPTS="", COLUMNS=str(COLUMNS))
    assert done.stderr == ""
    rows = [
        row
        for line in done.stdout.splitlines()
        for row in re.findall(f".{{1,{COLUMNS}}}", line) or [""]
    ]
    return done.returncode, rows


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
    status, rows = run(starter, "--tier", "D", "-x")
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
    status, rows = run(starter)
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
OWN_ROWS = [[0, ["    7  a = 5"]]]
HELPERS_ROWS = [[0, ["    Your function f, called there:"]], [9, ["    2  b"] * 40]]


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


CIRCLE = "from src.visualize_cradle_run import handle_two_bobs"
MAIN = 'if __name__ == "__main__":\n    from'
# A file, an old and a new text in it, and all that pytest prints about it: {} is the line
BROKEN = {
    "a bracket": (
        "src/special_cradles.py",
        "r_param/5, 0)",
        "r_param/5, 0",
        "src/special_cradles.py, line {}: axle_pos = vector((-0.1 + r_param/4 * i), r_param/5, 0 "
        "^ SyntaxError: '(' was never closed",
    ),
    "a circle": (
        "src/swinging.py",
        "from support.p",
        f"{CIRCLE}\nfrom support.p",
        f"src/swinging.py, line {{}}: {CIRCLE} ImportError: cannot import name 'full_swing_update' "
        "from partially initialized module 'src.swinging' (most likely due to a circular import) "
        "({file}) Your files import each other in a circle. Remove the import in this file.",
    ),
    "a call of main": (
        "src/visualize_cradle_run.py",
        MAIN,
        f"main(5)\n{MAIN}",
        "src/visualize_cradle_run.py, line {}: main(5) AttributeError: 'int' object has no "
        "attribute 'csv' This line stands outside of all functions, so it runs when Python reads "
        "the file. Remove it.",
    ),
}


@pytest.mark.parametrize("name", slow_but_for(["a bracket", "a circle"], BROKEN))
def test_of_a_file_that_python_cannot_read_pytest_says_nothing_but_this(starter, name):
    """One check fails, and no function is named. Also if a thread of the solution does not end."""
    file, old, new, message = BROKEN[name]
    write(starter, *FUNCTIONS)
    with (starter / "src/pds_helper.py").open("a") as source:
        source.write("import threading\nthreading.Thread(target=threading.Event().wait).start()\n")
    number = (starter / file).read_text().partition(old)[0].count("\n") + 1
    change(starter / file, old, new)
    status, (_, title, *rows, last) = run(starter)
    assert status == 1
    assert title.strip("= ") == "Python cannot read a file"
    message = message.format(number, file=starter / file)
    assert "".join(rows).replace(" ", "") == message.replace(" ", "")  # wrapped at 80 columns
    assert last.startswith("1 failed, ")


NO_PYTHON = {  # the content of a file, and what pytest says about it
    "<!DOCTYPE html>\n<html>": "This file is no Python: it is a web page.",
    "{\\rtf1 def": "This file is no Python: it is a text of a word processor (RTF).",
    "x = 1\n<<<<<<< HEAD\nx = 2\n=======\n": "This file is no Python: it is two versions",
    "d = {'a': 1}\nx = f'{d['a']}'\n": "Python 3.12 and later ones read the same quotes inside",
    "x = sin 2\n": "A function needs ( ) around its values: sin(2).",
}


@pytest.mark.parametrize("content", slow_but_for([*NO_PYTHON][:1], NO_PYTHON))
def test_a_file_that_is_no_python_is_named_as_what_it_is(starter, content):
    if "f'" in content and sys.version_info >= (3, 12):
        pytest.skip("this Python reads it")
    (starter / "src/swinging.py").write_text(content)
    _, rows = run(starter, "--tier", "C")
    assert NO_PYTHON[content] in " ".join(rows)


README = (ROOT / "tests/README.md").read_text(encoding="utf-8")
SHOWN = {  # a function, and the body whose screen the README shows
    "handle_collision": """\
        # linear
        v1 = omega1*r_param
        v2 = omega2*r_param  # the second one
        new1 = (m1*v1 + m2*v2 - m2*e*(v1-v2))/(m1+m2)
        new2 = (m1*v1 + m2*v2 + m1*e*(v1-v2))/m1+m2
        print(new1)
        return new1, new2""",
    "newton_cradle_tick": """\
        full_swing_update(pend_list, r_param, dt, g)
        for i in range(len(pend_list)):
            handle_two_bobs(pend_list[i], pend_list[i+1], r_param)""",
}


@pytest.mark.parametrize("function", SHOWN)
def test_the_readme_shows_a_real_screen(starter, function):
    write(starter, *FUNCTIONS, **{function: SHOWN[function]})
    _, rows = run(starter)
    begin = 1 if function == "handle_collision" else [row[:5] for row in rows].index("Next:")
    screen = "\n".join(f"    {row}".rstrip() for row in rows[begin:-1])
    assert f"\n{screen}\n" in README, screen


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="Windows has no pty")
@pytest.mark.parametrize("debug", ["breakpoint()", "import pdb; pdb.set_trace()"])
def test_a_debugger_has_its_prompt_in_a_terminal(starter, debug):
    """Without a terminal, breakpoint does nothing: the other tests have none."""
    write(starter, *FUNCTIONS, angle_update=f"if g == 8: {debug}\n{dedent(PLAIN['angle_update'])}")
    status, rows = run(starter, "--tier", "C")
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


HIDING = {  # a file, and the beginning of a line about it
    "json.py": "json.py hides the module json from Python and its packages.",
    "tests/statistics.py": "tests/statistics.py hides the module statistics",
    "pandas/__init__.py": "pandas hides the module pandas from Python",
}


def require_line(line, done):
    assert line in (done.stdout + done.stderr).replace("\\", "/")
    assert done.returncode
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("file", slow_but_for(["json.py"], HIDING))
def test_a_file_that_hides_a_module_gets_a_line(starter, file):
    put_files(starter, {file: ""})
    require_line(HIDING[file], python(*PYTEST.split(), folder=starter))


def test_a_support_that_is_elsewhere_gets_a_line(starter):
    (starter / "support").rename(starter / "src/support")
    require_line("support is not beside src", python(*PYTEST.split(), folder=starter))


PYTHON = Path(sys.executable).as_posix()
SLIPS = {  # words behind python, and a part of what it prints
    "-S pds_tester.py": " has no pandas. Install it as README.md says, or start the Python",
    f"-O {PYTEST}": "Run pytest without -O, -OO and PYTHONOPTIMIZE: with them",
    f"{PYTEST} --grade-json no/a.json": "--grade-json: found 'no/a.json', allowed is a file in",
    f"{PYTEST} --grade-json src": "--grade-json: found 'src', allowed is a file in a folder",
    f"{PYTEST} src": f"The checks are not here. Type: {PYTHON} -m pytest",
    "-m unittest": f"Type {PYTHON} -m pytest to run them.",
    "tests/test_d.py": f"These are checks. Type {PYTHON} -m pytest to run them.",
    "src/swinging.py": f"This file has only functions. Type {PYTHON} -m pytest",
    f"{PYTEST} --grade-json=--": "found '--grade-json=--', allowed is no -- after =",
    f"{PYTEST} --tier E": "argument --tier: found 'E', allowed is D, C, B, A or honor",
}


@pytest.mark.parametrize("command", slow_but_for([*SLIPS][:5], SLIPS))
def test_a_slip_in_a_command_gets_a_line(starter, command):
    require_line(SLIPS[command], python(*command.split(), folder=starter))


def test_from_another_folder_the_command_goes_to_the_checks_once(starter, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    done = python("-m", "pytest", starter / "src", folder=elsewhere)
    lines = [line for line in done.stdout.splitlines() if line.startswith("The checks are not")]
    command = f"cd {starter} && {sys.executable} -m pytest"
    assert lines == [f"The checks are not here. Type: {command}"]


@pytest.mark.slow
def test_side_by_side_the_suites_say_the_same(starter):
    """With pytest-xdist, one of two processes makes all checks.

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
        status, rows = run(starter, "-vv", *options, "--grade-json", "grade.json")
        begin = [row.strip("_ ") for row in rows].index(title)
        # The last row has the time
        ends.append((status, rows[begin:-1], (starter / "grade.json").read_text()))
        (starter / "grade.json").unlink()
    assert ends[0] == ends[1]
    done = re.findall(r"^\[gw\d\] .* tests/(test_\w+)\.py", "\n".join(rows), re.MULTILINE)
    assert {*done} == {"test_others", *SUITES.values()}


STUBBORN = """while True:
    try:
        while True: omega += 1
    except: pass
"""
IMPATIENT = """import sys
from grading import limits
import pytest
limits.PATIENCE, limits.AGAIN = 0.3, 0.1
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
