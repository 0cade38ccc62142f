"""What students are handed: made, graded as it is, graded with solutions in it, and what its programs say."""

import ast
import json
import os
import re
import shutil
import subprocess
import sys

import pytest
from handout import FUNCTIONS, SUITES
from programs import ROOT, SECONDS

ALL = {"D": 16, "C": 6, "B": 12, "A": 8, "Honor roll": 7}  # checks


def start(*arguments, folder):
    """Return the finished process of Python with these arguments in this folder."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTEST_ADDOPTS"}
    command = [sys.executable, *map(str, arguments)]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=2 * SECONDS)


def grade(folder, *options):
    """Return the exit status of pytest there, the lines that it printed, and the grade that it wrote."""
    done = start("-m", "pytest", "-p", "no:cacheprovider", "--grade-json", "grade.json", *options, folder=folder)
    assert done.stderr == ""
    return done.returncode, done.stdout.splitlines(), json.loads((folder / "grade.json").read_text())


@pytest.fixture
def starter(tmp_path):
    done = start(ROOT / "tests" / "make_starter.py", tmp_path / "starter", folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{tmp_path / 'starter'} is ready")
    return tmp_path / "starter"


def put_back(starter, *files):
    for file in files:
        shutil.copy(ROOT / file, starter / file)


def table_of(lines):
    """Return the table that pytest printed: for each tier, passed, waiting, failed, and points."""
    rows = [line.rsplit(maxsplit=4) for line in lines if re.fullmatch(r".+ \d+/\d+", line)]
    return {tier: [*map(int, numbers), points] for tier, *numbers, points in rows}


def test_only_the_bodies_of_the_handouts_functions_are_taken_out(starter):
    for file in {function.file for function in FUNCTIONS.values()}:
        before, after = (ast.parse((folder / file).read_text()).body for folder in (ROOT, starter))
        for node, emptied in zip(before, after, strict=True):
            if isinstance(node, ast.FunctionDef) and node.name in FUNCTIONS:
                assert ast.unparse(emptied.args) == ast.unparse(node.args)
                assert ast.get_docstring(emptied) == ast.get_docstring(node)
                provided = 2 if node.name == "extract_and_convert" else 0
                *kept, last = emptied.body[1:]
                assert [*map(ast.unparse, kept)] == [*map(ast.unparse, node.body[1 : 1 + provided])]
                assert ast.unparse(last) == f"raise NotImplementedError('{node.name} is not written yet')"
            else:
                assert ast.unparse(emptied) == ast.unparse(node)
    for file in [*ROOT.glob("src/*.py"), *ROOT.glob("support/*.*"), ROOT / "newton_cradle_pends.csv"]:
        if file.relative_to(ROOT).as_posix() not in {function.file for function in FUNCTIONS.values()}:
            assert (starter / file.relative_to(ROOT)).read_bytes() == file.read_bytes()


def test_of_tests_only_what_grades_is_handed_out(starter):
    names = {path.name for path in starter.glob("tests/*")}
    assert names == {f"{suite}.py" for suite in SUITES.values()} | {
        *("cradles.py", "grade.py", "grader.py", "handout.py", "pytest_grader.py", "telling.py", "watch.py")
    }


def test_all_fails_as_not_written_yet_and_with_the_solutions_all_is_green(starter):
    status, lines, graded = grade(starter)
    assert status == 1
    assert table_of(lines) == {tier: [0, 0, count, f"0/{count}"] for tier, count in ALL.items()}
    assert len([line for line in lines if "not written yet" in line]) == sum(ALL.values())
    assert lines[-1].startswith(f"{'=' * 20}") and f" {sum(ALL.values())} failed in " in lines[-1]
    assert graded["grade"] is None
    assert graded["next"].startswith("extract_and_convert in src/pds_helper.py")
    assert not [line for line in lines if "fault of the grader" in line]

    put_back(starter, *{function.file for function in FUNCTIONS.values()})
    status, lines, graded = grade(starter)
    assert status == 0
    tiers = {tier: {"passed": n, "waiting": 0, "failed": 0, "points": n, "of": n} for tier, n in ALL.items()}
    assert graded == {"tiers": tiers, "grade": "Honor roll", "next": "nothing is left to write; show it to someone"}
    assert table_of(lines) == {tier: [count, 0, 0, f"{count}/{count}"] for tier, count in ALL.items()}
    assert len(lines) <= 25


@pytest.mark.parametrize(
    ("program", "missing"),
    [
        ("src/visualize_cradle_run.py", [name for name, of in FUNCTIONS.items() if of.tier in "DCBA"]),
        ("src/text_cradle_run.py", [name for name, of in FUNCTIONS.items() if of.tier in "DCBA"]),
        ("src/visualize_double_cradle_run.py", [name for name, of in FUNCTIONS.items() if of.tier not in "CBA"]),
    ],
)
def test_programs_say_what_is_missing(starter, program, missing):
    done = start(program, folder=starter)
    assert (done.returncode, done.stdout) == (2, "")
    first, *names, last = done.stderr.splitlines()
    assert first == "There is no cradle to be seen yet. Still to be written:"
    assert [line.partition(",")[0] for line in names] == [f"    {name} in {FUNCTIONS[name].file}" for name in missing]
    assert last == "`pytest` tells which one is next."


def test_pds_tester_shows_what_there_is(starter):
    done = start("pds_tester.py", folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    assert "\nbad_rep: " in done.stdout
    line = "pend_list: there is none yet, as extract_and_convert is not written yet. It is in src/pds_helper.py."
    assert done.stdout.splitlines()[-1] == line


def test_a_half_written_project(starter):
    """D is there, angle_update has a mistake, and handle_collision raises; the rest is not written."""
    put_back(starter, "src/pds_helper.py", "src/special_cradles.py", "src/swinging.py")
    swinging, run = starter / "src" / "swinging.py", starter / "src" / "visualize_cradle_run.py"
    swinging.write_text(swinging.read_text().replace("theta + omega_new * dt", "theta + omega * dt"))
    stub = 'raise NotImplementedError("handle_collision is not written yet")'
    run.write_text(run.read_text().replace(stub, 'return int("m1")'))
    status, lines, graded = grade(starter)
    assert status == 1
    assert table_of(lines) == {
        "D": [16, 0, 0, "16/16"],
        "C": [0, 4, 2, "0/6"],
        "B": [0, 0, 12, "0/12"],
        "A": [0, 0, 8, "0/8"],
        "Honor roll": [0, 0, 7, "0/7"],
    }
    assert "4 wait for angle_update" in lines
    assert "Grade: D." in lines
    assert (graded["grade"], graded["next"].split()[0]) == ("D", "angle_update")
    where = lines.index("it raised   ValueError: invalid literal for int() with base 10: 'm1'")
    assert lines[where + 1].startswith("            src/visualize_cradle_run.py, line ")
    assert lines[where + 2] == '                return int("m1")'

    done = start("tests/watch.py", "test_angle_update", "--seconds", 0.6, folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    assert [line.partition(",")[0] for line in done.stdout.splitlines()[-2:]] == ["t = 0.50 s", "t = 0.60 s"]


def test_a_file_that_cannot_be_imported_fails_its_own_functions_only(starter):
    put_back(starter, *{function.file for function in FUNCTIONS.values()})
    swinging = starter / "src" / "swinging.py"
    swinging.write_text(swinging.read_text().replace("for pend_dict in pend_list:", "for pend_dict in pend_list"))
    status, lines, graded = grade(starter)
    assert status == 1
    waiting = {"D": 16, "C": 0, "B": 0, "A": 0, "Honor roll": 0}
    assert {tier: row[0] for tier, row in table_of(lines).items()} == {**waiting, "Honor roll": 7}
    assert {tier: row[2] for tier, row in table_of(lines).items()} == {"D": 0, "C": 2, "B": 0, "A": 0, "Honor roll": 0}
    assert [line.startswith("it raised   SyntaxError: expected ':' (swinging.py, line ") for line in lines].count(
        True
    ) == 2


@pytest.mark.parametrize(
    ("before", "after", "line"),
    [
        (
            "import extract_and_convert",
            "import extract_and_converts",
            "ImportError: cannot import name 'extract_and_conv",
        ),
        ("from src.pds_helper", "from pds_helper", "ModuleNotFoundError: No module named 'pds_helper'"),
        (
            "def uniform_mass",
            "extract_and_convert('nowhere.csv')\n\n\ndef uniform_mass",
            "ValueError: nowhere.csv: cannot",
        ),
    ],
)
def test_the_file_at_fault_fails_and_those_that_import_it_wait(starter, before, after, line):
    put_back(starter, *{function.file for function in FUNCTIONS.values()})
    special = starter / "src" / "special_cradles.py"
    special.write_text(special.read_text().replace(before, after))
    status, lines, graded = grade(starter)
    table = table_of(lines)
    assert status == 1
    assert [row[2] for row in table.values()] == [10, 0, 0, 0, 0]  # elastic and inelastic wait for uniform_e
    assert graded["next"].startswith("uniform_mass_newton_cradle in src/special_cradles.py")
    assert len([text for text in lines if text.startswith(f"it raised   {line}")]) == 10
    assert ("hint        Its name is src.pds_helper." in lines) == line.startswith("Module")


def test_a_fault_of_the_grader_fails_and_is_no_point(starter):
    put_back(starter, *{function.file for function in FUNCTIONS.values()})
    suite = starter / "tests" / "test_c.py"
    suite.write_text(suite.read_text().replace('expect("angle_update", *STEP', 'expect("angle_update", 1 / 0, *STEP'))
    status, lines, graded = grade(starter, "--tier", "C")
    assert status == 1
    assert table_of(lines) == {"C": [1, 4, 1, "1/6"]}
    assert "This is a fault of the grader, not of the solution. Please show it to your teacher." in lines
    assert (graded["grade"], graded["next"]) == (None, "show your teacher the grader's fault in test_angle_update")


def test_the_suites_run_in_the_order_of_the_handout(starter):
    _, lines, _ = grade(starter)
    files = [line.split()[0].replace(os.sep, "/") for line in lines if line.startswith(f"tests{os.sep}")]
    assert files == [f"tests/{suite}.py" for suite in SUITES.values()]


def test_one_tier_alone(starter):
    put_back(starter, "src/pds_helper.py", "src/special_cradles.py")
    status, lines, graded = grade(starter, "--tier", "d")
    assert (status, table_of(lines)) == (0, {"D": [16, 0, 0, "16/16"]})
    assert (graded["grade"], graded["next"]) == ("D", "all checks of tier C, which were not all run")
    assert (starter / "grade.json").is_file()  # and can be written again
    status, lines, graded = grade(starter, "--tier", "honor")
    assert (status, table_of(lines)) == (1, {"Honor roll": [0, 0, 7, "0/7"]})
    assert graded["grade"] is None


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--tier", "E"], "argument --tier: invalid choice: 'E'"),
        (["--grade-json", "nowhere/grade.json"], "--grade-json: found 'nowhere/grade.json', allowed is a file in a"),
        (["--grade-json", "src"], "--grade-json: found 'src', allowed is a file in a folder that is there"),
    ],
)
def test_bad_options_of_pytest(starter, options, words):
    done = start("-m", "pytest", *options, folder=starter)
    assert done.returncode == 4
    assert words in done.stderr


def test_a_folder_with_something_in_it_is_refused(tmp_path):
    (tmp_path / "mine.txt").write_text("mine")
    done = start(ROOT / "tests" / "make_starter.py", tmp_path, folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.count("\n") == 1
    assert f"found '{tmp_path}', allowed is a new folder, or an empty one" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["test_angle"], 2, "found 'test_angle', allowed is the name of a check, as test_angle_update"),
        (["test_angle_update"], 1, "There is nothing to watch."),
        (["test_angle_update", "--seconds", "0"], 2, "found '0', allowed is a number above 0 and up to 1e6 (s)"),
    ],
)
def test_what_cannot_be_watched(starter, arguments, status, words):
    done = start("tests/watch.py", *arguments, folder=starter)
    assert (done.returncode, done.stderr.count("\n")) == (status, 1)
    assert words in done.stderr
