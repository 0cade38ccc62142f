"""The output of `pytest` in a student's folder, on 80 columns: missing functions, and mistakes."""

import os
import re
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from textwrap import dedent

import pytest
from programs import python, ROOT, slow_but_for
from students import change, write
from wrong_solutions import PLAIN

from grading.grader import checks
from grading.handout import FUNCTIONS, SUITES
from grading.outcomes import FAILED, FAULT, Outcome, PASSED
from grading.screen import SCREEN, table

COLUMNS = 80
PYTEST = ("-m", "pytest", "-p", "no:cacheprovider")


def run(folder, *options):
    """Return the exit status of pytest in a folder, and its output as rows of a terminal."""
    done = python(*PYTEST, *options, folder=folder, PYTEST_ADDOPTS="", COLUMNS=str(COLUMNS))
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
    below = rows[begin + 1 :]
    return below[: next(i for i, row in enumerate(below) if row.startswith(("===", "__", "_ ")))]


def test_with_x_a_fresh_starter_stops_at_the_first_function(starter):
    status, rows = run(starter, "--tier", "D", "-x")
    assert status == 1
    lines = (starter / "src/pds_helper.py").read_text().splitlines()
    number = 1 + lines.index(
        '    raise NotImplementedError("extract_and_convert is not written yet")'
    )
    assert section(rows, "Not written yet") == [
        f"extract_and_convert in src/pds_helper.py, line {number}"
    ]
    assert section([*rows, "==="], "Grade")[2] == "Grade: none yet."
    assert f"Next:  extract_and_convert in src/pds_helper.py, line {number}." in rows
    assert "       The steps: read_csv gives df, to_dict gives bad_rep, and pend_list gets" in rows
    assert rows[-1].startswith("1 waiting in ")


def test_a_mistake_is_told_on_a_screen(starter):
    """pytest shows only the printed lines of the first mistake.

    Above the next step is a note about the CSV.
    """
    body = PLAIN["make_newton_cradle"].replace("r_param, pend['theta']", "r_param, theta_init")
    body = "for i in range(25):\n    print('row', i)\n" + dedent(body)
    write(
        starter,
        *FUNCTIONS,
        make_newton_cradle=body,
        handle_collision="print('collision')\nreturn omega1, omega2",
    )
    change(starter / "newton_cradle_pends.csv", "yellow", "grey")
    change(
        starter / "src/visualize_cradle_run.py",
        "page.csv,",
        "__import__('support.constants').constants.NC_FP,",
    )
    status, rows = run(starter)
    assert status == 1
    assert len(rows) <= SCREEN
    shown = section(rows, "Use one relevant helper function to create the tuple of objects.")
    assert shown[:6] == [
        *(f"printed     row {i}" for i in range(5)),
        "printed     ... (25 lines in all)",
    ]
    assert "called      make_newton_cradle(relative_filepath, r_param=0.4, theta_init=0.6)" in shown
    assert not [row for row in rows if "collision" in row and "printed" in row]
    before = (starter / "src/special_cradles.py").read_text().partition("make_pendulum(axle_pos")[0]
    number = before.count("\n") + 1
    whole = " ".join(row.strip() for row in rows)
    for words in (
        f"Next:  make_newton_cradle in src/special_cradles.py, line {number}.",
        "(m) of bob[1] is vector(0.225857, -0.330134, 0), not vector(0, -0.4, 0).",
        "All bobs are lifted. make_pendulum must get the theta of each pendulum, and not",
    ):
        assert words in whole
    assert (
        "Note:  your CSV has a mistake. newton_cradle_pends.csv, line 3, column color: found 'grey'"
        in whole
    )


WRONG = Outcome(FAILED, place="a.py, line 7", wrong="A is 5, not 6.")
ERROR = WRONG._replace(wrong="E: f.", hint="Do.")
HELPER = [
    [0, ["    7  a = 5"]],
    [0, ["    Your function f, called there:"]],
    [9, ["    2  b"] * 40],
]
SEEN = WRONG._replace(help="It is so.", rows=[[0, ["    7  a = 5"]]], facts=["No line has set it."])


@pytest.mark.parametrize(
    ("tiers", "outcome", "words"),  # of the checks of the last tier; those of the others are passed
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
            ERROR,
            ["       The steps: both omegas become linear velocities; the two formulas of the"],
        ),
        ("A", WRONG._replace(wrong="A."), ["       In Python, with books:"]),
        (
            "C",
            SEEN,
            [
                "       It is so.",
                "       Your code, line by line:",
                "    7  a = 5",
                "       No line has set it.",
            ],
        ),
        (
            "C",
            WRONG._replace(rows=HELPER),
            ["       Your code, line by line (1 line is left out):", "    7  a = 5"],
        ),
    ],
)
def test_the_grade_and_the_next_step(monkeypatch, tiers, outcome, words):
    monkeypatch.setattr("grading.grade.checks_command", lambda: "pytest")
    outcomes = {check.name: Outcome(PASSED) for tier in tiers for check in checks(tier=tier)}
    outcomes |= {check.name: outcome for check in checks(tier=tiers[-1])}
    lines = [line for line, _ in table(outcomes, COLUMNS)]
    assert [line for line in lines if line in words] == words
    assert "    Your function f, called there:" not in lines


CIRCLE = "from src.visualize_cradle_run import handle_two_bobs"
MAIN = 'if __name__ == "__main__":\n    from'
# A file and what is put into it, and the words that pytest prints about it, and no others
BROKEN = {
    "a bracket": (
        *("special_cradles", "    return pend_list", "    x = (1"),
        "src/special_cradles.py, line {}: x = (1 ^ SyntaxError: '(' was never closed",
    ),
    "a circle": (
        *("swinging", "from support.p", f"{CIRCLE}\nfrom support.p"),
        f"src/swinging.py, line {{}}: {CIRCLE} ImportError: cannot import name 'full_swing_update' from partially "
        "initialized module 'src.swinging' (most likely due to a circular import) ({}) "
        "Your files import each other in a circle. Remove the import in this file.",
    ),
    "a call of main": (
        *("visualize_cradle_run", MAIN, f"main(5)\n{MAIN}"),
        "src/visualize_cradle_run.py, line {}: main(5) AttributeError: 'int' object has no attribute 'csv' "
        "This line stands outside of all functions, so it runs when Python reads the file. Remove it.",
    ),
}


@pytest.mark.parametrize("name", slow_but_for(["a bracket", "a circle"], BROKEN))
def test_of_a_file_that_python_cannot_read_pytest_says_nothing_but_this(starter, name):
    """One check fails, and no function is named. Also if a thread of the solution does not end."""
    file, before, after, words = BROKEN[name]
    write(starter, *FUNCTIONS)
    with (starter / "src/pds_helper.py").open("a") as source:
        source.write(
            "import threading\n\nthreading.Thread(target=threading.Event().wait).start()\n"
        )
    source = starter / "src" / f"{file}.py"
    text = source.read_text().partition(before)
    source.write_text(f"{text[0]}{after}{text[2]}")
    status, rows = run(starter)
    assert status == 1
    number = text[0].count("\n") + 1
    _, title, *found, last = rows
    assert title.strip("= ") == "Python cannot read a file"
    # Wrapped at 80 columns
    assert "".join("".join(found).split()) == "".join(words.format(number, source).split())
    assert last.startswith("1 failed, ")


PYTHON = Path(sys.executable).as_posix()


NO_PYTHON = {  # the content of a file, and what pytest says about it
    "<!DOCTYPE html>\n<html>": "This file is no Python: it is a web page. Download the file itself.",
    "{\\rtf1 def": "This file is no Python: it is a text of a word processor (RTF). Save it as plain text.",
    "x = 1\n<<<<<<< HEAD\nx = 2\n=======\n": "This file is no Python: it is two versions, which git has put together.",
    "d = {'a': 1}\nx = f'{d['a']}'\n": "Python 3.12 and later ones read the same quotes inside of the { } of an",
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
    command = [sys.executable, *PYTEST, "--tier", "C"]
    with subprocess.Popen(
        command, cwd=starter, stdin=theirs, stdout=theirs, stderr=theirs
    ) as process:
        os.close(theirs)
        seen = b""
        while b"(Pdb) " not in seen:
            seen += os.read(ours, 1000)
        os.write(ours, b"p omega\nc\n")
        with suppress(OSError):  # the terminal is closed
            while True:
                seen += os.read(ours, 1000)
    os.close(ours)
    assert (process.returncode, b"3.0" in seen, b"Tier C is complete." in seen) == (0, True, True)


def hides(name):
    return lambda folder: (folder / name).parent.mkdir(exist_ok=True) or (folder / name).touch()


SAID = {  # what a student does to the folder, a command of Python, and a line that it prints
    "json.py": (
        hides("json.py"),
        PYTEST,
        "json.py hides the module json from Python and its packages.",
    ),
    "no pandas": (
        str,
        ("-S", "pds_tester.py"),
        " has no pandas. Install it as README.md says, or start the Python",
    ),
    "no assert": (
        str,
        ("-O", *PYTEST),
        "Run pytest without -O, -OO and PYTHONOPTIMIZE: with them, Python leaves out",
    ),
    "no folder": (
        str,
        (*PYTEST, "--grade-json", "no/a.json"),
        "--grade-json: found 'no/a.json', allowed is a file in",
    ),
    "its folder": (
        str,
        (*PYTEST, "--grade-json", "src"),
        "--grade-json: found 'src', allowed is a file in a folder",
    ),
    "no checks": (str, (*PYTEST, "src"), f"The checks are not here. Type: {PYTHON} -m pytest"),
    "unittest": (
        str,
        ("-m", "unittest"),
        f"unittest does not find the checks. Type {PYTHON} -m pytest to run them.",
    ),
    "a suite": (
        str,
        ("tests/test_d.py",),
        f"These are checks. Type {PYTHON} -m pytest to run them.",
    ),
    "a test hides a module": (
        hides("tests/statistics.py"),
        PYTEST,
        "tests/statistics.py hides the module statistics",
    ),
    "a folder hides a module": (
        hides("pandas/__init__.py"),
        PYTEST,
        "pandas hides the module pandas from Python",
    ),
    "no support": (
        lambda path: (path / "support").rename(path / "src/support"),
        PYTEST,
        "support is not beside src",
    ),
    "a file without a program": (
        str,
        ("src/swinging.py",),
        f"This file has only functions. Type {PYTHON} -m pytest",
    ),
    "no value": (
        str,
        (*PYTEST, "--grade-json=--"),
        "found '--grade-json=--', allowed is no -- after =",
    ),
    "no tier": (
        str,
        (*PYTEST, "--tier", "E"),
        "argument --tier: found 'E', allowed is D, C, B, A or honor",
    ),
}


@pytest.mark.parametrize("name", slow_but_for([*SAID][:6], SAID))
def test_a_slip_around_the_functions_gets_a_line(starter, name):
    does, command, line = SAID[name]
    does(starter)
    done = python(*command, folder=starter)
    assert line.format(starter.as_posix()) in (done.stdout + done.stderr).replace("\\", "/")
    assert done.returncode and "Traceback" not in done.stderr


def test_from_another_folder_the_command_goes_to_the_checks_once(starter, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    done = python("-m", "pytest", starter / "src", folder=elsewhere)
    [command] = [
        line for line in done.stdout.splitlines() if line.startswith("The checks are not here.")
    ]
    assert command == f"The checks are not here. Type: cd {starter} && {sys.executable} -m pytest"


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
    others = "import pytest\n\n\n@pytest.mark.parametrize('number', range(30))\ndef test_other(number): pass\n"
    (starter / "tests" / "test_others.py").write_text(others)
    ends = []
    for options in ([], ["-n", "2"]):
        status, rows = run(starter, "-vv", *options, "--grade-json", "grade.json")
        title = "Takes in theta and omega and updates them for a given timestep dt."
        begin = [row.strip("_ ") for row in rows].index(title)
        # The last row has the time
        ends.append((status, rows[begin:-1], (starter / "grade.json").read_text()))
        (starter / "grade.json").unlink()
    assert ends[0] == ends[1]
    done = re.findall(r"^\[(gw\d)\] .* tests/(test_\w+)\.py", "\n".join(rows), re.MULTILINE)
    assert {file for _, file in done} == {"test_others", *SUITES.values()}


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
