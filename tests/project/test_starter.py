"""What students are handed: made, graded as it is, graded with solutions in it, and what its programs say."""

import ast
import errno
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from math import degrees

import pandas as pd
import pytest
from make_starter import CHANGES, FOLDERS
from programs import (
    end,
    first_lines,
    MOVES,
    needs_vpython,
    on_posix,
    open_cradle,
    QUIETLY,
    readout,
    ROOT,
    running,
    SECONDS,
    slow_but_for,
    wait_until,
)
from students import write, write_all, write_tiers

from grading.handout import FUNCTIONS, SUITES

ALL = {"D": 16, "C": 6, "B": 12, "A": 12, "Honor roll": 7}  # checks


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


@pytest.fixture(scope="session")
def made(tmp_path_factory):
    """A starter that nobody writes into."""
    folder = tmp_path_factory.mktemp("made") / "starter"
    done = start(ROOT / "tests" / "make_starter.py", folder, folder=folder.parent)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{folder} is ready")
    return folder


@pytest.fixture
def starter(made, tmp_path):
    """A starter, for a student to write into."""
    return shutil.copytree(made, tmp_path / "starter")


def table_of(lines):
    """Return the table that pytest printed: for each tier, passed, waiting, failed, and points."""
    rows = [line.rsplit(maxsplit=4) for line in lines if re.fullmatch(r".+ \d+/\d+", line)]
    return {tier: [*map(int, numbers), points] for tier, *numbers, points in rows}


def test_what_a_student_gets(starter):
    """The signatures are the handout's own, and each function has its docstring and its place."""
    for name, function in FUNCTIONS.items():
        (node,) = (node for node in functions_in(starter / function.file) if node.name == name)
        assert ", ".join(arg.arg for arg in node.args.args) == function.parameters
        assert ast.get_docstring(node)
        stubs = [part for part in ast.walk(node) if isinstance(part, ast.Raise)]
        assert len(stubs) == (2 if name == "main" else 1)
        assert {ast.unparse(stub) for stub in stubs} == {f"raise NotImplementedError('{name} is not written yet')"}


def functions_in(file):
    """Return the functions of a file, as trees."""
    return [node for node in ast.parse(file.read_text(encoding="utf-8")).body if isinstance(node, ast.FunctionDef)]


def test_the_lines_of_the_handout_are_there_as_it_has_them(starter):
    (node,) = (node for node in functions_in(starter / "src/pds_helper.py") if node.name == "extract_and_convert")
    _, df, bad_rep, _ = map(ast.unparse, node.body)
    assert (df, bad_rep) == ("df = pd.read_csv(relative_filepath)", "bad_rep = df.to_dict(orient='index')")
    main = (starter / "src/visualize_cradle_run.py").read_text().partition("def main")[2]
    for line in (
        "while page.is_running():",
        "if page.wants_cradle():",
        "page.show(pend_list)",
        "while page.wants_tick():",
    ):
        assert line in main


def test_src_has_the_handouts_files_and_the_programs_and_nothing_else(starter):
    names = {path.name for path in starter.glob("src/*")}
    handouts = {function.file.partition("/")[2] for function in FUNCTIONS.values()}
    assert names == handouts | {
        *("__init__.py", "beyond", "text_cradle_run.py", "visualize_double_cradle_run.py"),
    }


def test_what_nobody_changes_is_the_projects(starter):
    changed = {change[0] for change in CHANGES} | {function.file for function in FUNCTIONS.values()}
    files = [path for folder in FOLDERS for path in (starter / folder).rglob("*.*")]
    for file in [*files, starter / "newton_cradle_pends.csv"]:
        name = file.relative_to(starter).as_posix()
        if name not in changed:
            assert file.read_bytes() == (ROOT / name).read_bytes()


def test_no_reference_to_what_is_not_there(starter):
    """Neither to a file, nor to a module, nor to a name that nothing gives."""
    for file in starter.rglob("*.*"):
        if file.suffix in (".py", ".md", ".toml", ".html"):
            text = file.read_text(encoding="utf-8")
            for path in re.findall(r"\b(?:src|support|tests)/[\w/]+\.\w+", text):
                assert (starter / path).exists() or "make_starter" in path, (file.name, path)
            for module in re.findall(r"\b(?:src|support)(?:\.\w+)+", text):
                path = starter.joinpath(*module.split("."))
                assert any(each.exists() for each in (path, path.with_suffix(".py"), path.parent.with_suffix(".py"))), (
                    module
                )
    done = start(
        "-m", "ruff", "check", "--isolated", "--select", "F", "--ignore", "F401,F821,F841", "src", folder=starter
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stdout


def test_a_student_meets_no_unexplained_name(starter):
    for name in ("pds_helper", "special_cradles", "swinging", "visualize_cradle_run"):
        text = (starter / "src" / f"{name}.py").read_text()
        for word in (
            "cleaned",
            "EXACT_FLOATS",
            "approaching_only",
            "many_ticks",
            "check_cradle",
            "BUFFER",
            "pairwise",
            "rule",
        ):
            assert not re.search(rf"\b{word}\b", text), (name, word)


@on_posix
@pytest.mark.parametrize("place", ["deep/down/new", "."])
def test_on_a_full_disk_nothing_is_left_of_it(tmp_path, place):
    """A limit for the size of a file is like a full disk. A folder that was there stays."""
    folder = tmp_path / place
    words = shlex.join([sys.executable, str(ROOT / "tests" / "make_starter.py"), str(folder)])
    done = subprocess.run(["sh", "-c", f"ulimit -f 20; {words}"], cwd=tmp_path, capture_output=True, text=True)
    line = f"argument FOLDER: {folder} cannot be made: {os.strerror(errno.EFBIG)} (--help shows all options)"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"make_starter.py: error: {line}\n")
    assert os.listdir(tmp_path) == []


# --- no answers ------------------------------------------------------------------------------------------------------

# Calls of a student's function that the programs need, or that the handout itself gives: (file, function).
CALLED = {
    ("swinging.py", "angle_update"),  # by swing_update, which the handout provides
    ("double_cradle.py", "make_newton_cradle"),
    ("double_cradle.py", "make_double_pendulum"),
    ("double_cradle.py", "double_angle_update"),
    ("live_cradle.py", "uniform_mass_newton_cradle"),
    ("pds_tester.py", "extract_and_convert"),
    ("watch.py", "make_double_pendulum"),
}


def answers_in(tree, file):
    """Yield what in this file a student could write off."""
    for node in ast.walk(tree):
        called = name_of(node.func) if isinstance(node, ast.Call) else ""
        if called in FUNCTIONS and called != "main" and (file, called) not in CALLED:
            yield f"a call of {called}"
        if isinstance(node, (ast.For, ast.ListComp, ast.GeneratorExp)):
            inner = {name_of(call.func) for call in ast.walk(node) if isinstance(call, ast.Call)}
            if inner & {"swing_update", "angle_update"}:
                yield "a loop that swings"
        text = ast.unparse(node) if isinstance(node, (ast.BinOp, ast.Compare, ast.Subscript)) else ""
        for pattern, words in (
            (r"-?0\.1 \+ .*/ 4", "the places of the axles"),
            (r"/ 4 \* i\b", "the places of the axles"),
            (r"\b(r_param|R|R_PARAM) / 5\b", "the height of the axles"),
            (r"(COLOR|TEXTURE)_MAP\[.*(color|texture)", "the looks of a row"),
            (r"^mag\(.*\.pos - .*\.pos\) [<>]", "whether bobs touch"),
            (r"[<>].* (1\.05|BUFFER) \* \(\w+\.radius \+ \w+\.radius\)", "whether bobs touch"),
            (r"\be \* \((v|omega)1 - (v|omega)2\)", "the formula of a collision"),
            (r"\* e \* \(", "the formula of a collision"),
            (r"\bg \* sin\(theta\)", "the formula of the swing"),
            (r"theta \+ omega\w* \* dt", "the formula of the swing"),
        ):
            if re.search(pattern, text):
                yield f"{words}: {text}"


def name_of(function):
    """Return the name of what is called, or nothing."""
    return getattr(function, "id", getattr(function, "attr", ""))


def test_no_answers_are_in_the_folder(starter):
    found = [
        (file.name, answer)
        for file in starter.rglob("*.py")
        for answer in answers_in(ast.parse(file.read_text(encoding="utf-8")), file.name)
    ]
    assert found == []


def test_answers_are_found_where_there_are_some():
    """In the project itself: in each file of a function, and in the collisions of the double cradle."""
    for name, words in [
        ("special_cradles", "the places of the axles"),
        ("special_cradles", "the looks of a row"),
        ("swinging", "a loop that swings"),
        ("swinging", "the formula of the swing"),
        ("visualize_cradle_run", "a call of handle_two_bobs"),
        ("visualize_cradle_run", "a call of newton_cradle_tick"),
        ("visualize_cradle_run", "whether bobs touch"),
        ("visualize_cradle_run", "the formula of a collision"),
    ]:
        file = ROOT / "src" / f"{name}.py"
        answers = list(answers_in(ast.parse(file.read_text(encoding="utf-8")), file.name))
        assert any(answer.startswith(words) for answer in answers), (name, words)


def test_of_tests_only_what_grades_is_handed_out(starter):
    names = {path.name for path in starter.glob("tests/*")}
    assert names == {f"{suite}.py" for suite in SUITES.values()} | {"grading", "watch.py"}


def test_all_waits_to_be_written_and_with_the_solutions_all_is_green(starter):
    status, lines, graded = grade(starter)
    assert status == 1
    assert table_of(lines) == {tier: [0, count, 0, f"0/{count}"] for tier, count in ALL.items()}
    assert [line.split()[0] for line in lines if re.search(r" in src/\w+\.py, line \d+$", line)] == [*FUNCTIONS]
    assert f" {sum(ALL.values())} waiting in " in lines[-1]
    assert len(lines) <= 40
    assert graded["grade"] is None
    assert graded["next"].startswith("extract_and_convert in src/pds_helper.py")
    assert not [line for line in lines if "fault of the grader" in line]

    write_all(starter)
    status, lines, graded = grade(starter)
    assert status == 0
    tiers = {tier: {"passed": n, "waiting": 0, "failed": 0, "points": n, "of": n} for tier, n in ALL.items()}
    assert graded == {"tiers": tiers, "grade": "Honor roll", "next": "nothing is left to write; show it to someone"}
    assert table_of(lines) == {tier: [count, 0, 0, f"{count}/{count}"] for tier, count in ALL.items()}
    assert len(lines) <= 25
    assert not [line for line in lines if line.startswith("Left out")]


# --- something to see after every grade ------------------------------------------------------------------------------


@pytest.mark.parametrize("program", ["src/visualize_cradle_run.py", "src/text_cradle_run.py"])
def test_before_d_one_line_says_what_is_to_be_written(starter, program):
    write(starter, "extract_and_convert", "elastic_newton_cradle")
    done = start(program, folder=starter)
    assert (done.returncode, done.stdout) == (2, "")
    names = "uniform_mass_newton_cradle, uniform_e_newton_cradle, inelastic_newton_cradle, make_newton_cradle"
    line = f"There is no cradle to see yet. Write first: {names} in src/special_cradles.py.\n"
    assert done.stderr == line


def test_the_double_cradle_needs_all_of_its_functions(starter):
    write_tiers(starter, "DCBA")
    write(starter, "make_double_pendulum")
    done = start("src/visualize_double_cradle_run.py", folder=starter)
    names = (
        "double_angle_update, double_cradle_tick in src/double_cradle.py; main in src/visualize_double_cradle_run.py"
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"There is no cradle to see yet. Write first: {names}.\n"


STAGES = [  # the tiers that are written, what the line says, and the angles of the first and of the last pendulum
    ("D", "Write next: angle_update, full_swing_update in src/swinging.py. Then the pendula swing.", (-45, 0)),
    (
        "DC",
        "Write next: handle_collision, handle_two_bobs, newton_cradle_tick, main in "
        "src/visualize_cradle_run.py. Then the bobs collide.",
        (44, 0),
    ),
    (
        "DCB",
        "Write next: newton_cradle_tick, main in src/visualize_cradle_run.py. Then the bobs collide.",
        (44, 0),
    ),
    ("DCBA", "", (0, 44)),
]


@pytest.mark.parametrize(("tiers", "remark", "angles"), slow_but_for([STAGES[1], STAGES[3]], STAGES))
def test_the_terminal_shows_what_there_is(starter, tiers, remark, angles):
    write_tiers(starter, tiers)
    program = "src/text_cradle_run.py"
    done = start(program, "--seconds", "0.1", folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{remark}\nt = 0.00 s" if remark else "t = 0.00 s")
    done = start(program, "--record", "data.csv", "--seconds", "0.5", "--every", "0.5", folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    last = pd.read_csv(starter / "data.csv").iloc[-1]
    assert [round(degrees(last[name])) for name in ("theta_1", "theta_5")] == pytest.approx(angles, abs=1)


@pytest.mark.parametrize("option", ["-O", "-OO"])
def test_without_assert_and_docstrings_there_is_no_grade(made, option):
    done = start(option, "-m", "pytest", "-p", "no:cacheprovider", "--tier", "C", folder=made)
    assert (done.returncode, done.stdout) == (4, "")
    line = "ERROR: Run pytest without -O, -OO and PYTHONOPTIMIZE: with them, Python leaves out checks."
    assert done.stderr.strip() == line


def test_a_line_that_was_left_below_a_return_is_no_stub(starter):
    write_tiers(starter, "DCBA")
    swinging = starter / "src" / "swinging.py"
    stub = '    raise NotImplementedError("angle_update is not written yet")\n'
    swinging.write_text(swinging.read_text().replace("theta_new)\n", f"theta_new)\n{stub}", 1))
    done = start("src/text_cradle_run.py", "--seconds", "0.1", folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("t = 0.00 s")


@pytest.mark.parametrize(("tiers", "remark", "angles"), STAGES[:2])
class TestOnThePage:
    pytestmark = needs_vpython

    def test_the_page_shows_what_there_is(self, page, starter, tiers, remark, angles):
        write_tiers(starter, tiers)
        with running(starter / "src" / "visualize_cradle_run.py") as process:
            open_cradle(page, first_lines(process))
            assert page.locator(".remark").inner_text() == remark
            wait_until(lambda: readout(page, "t") > 0.3)
            if tiers == "D":
                assert page.evaluate(MOVES) == 0
            else:
                wait_until(lambda: page.evaluate(MOVES) > 0)
            assert page.get_by_label("Separating bobs collide too").is_disabled()
            page.close()
            assert end(process) == QUIETLY


def test_pds_tester_shows_what_there_is(starter):
    done = start("pds_tester.py", folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    assert "\nbad_rep: " in done.stdout
    line = "pend_list: missing, because extract_and_convert is not written yet. Its place is in src/pds_helper.py."
    assert done.stdout.splitlines()[-1] == line


def test_a_half_written_project(starter):
    """D is there, angle_update has a mistake, and handle_collision raises; the rest is not written."""
    write_tiers(starter, "DC")
    swinging, run = starter / "src" / "swinging.py", starter / "src" / "visualize_cradle_run.py"
    swinging.write_text(swinging.read_text().replace("theta + omega_new * dt", "theta + omega * dt"))
    stub = 'raise NotImplementedError("handle_collision is not written yet")'
    run.write_text(run.read_text().replace(stub, 'return int("m1")'))
    status, lines, graded = grade(starter)
    assert status == 1
    assert table_of(lines) == {
        "D": [16, 0, 0, "16/16"],
        "C": [0, 4, 2, "0/6"],
        "B": [0, 8, 4, "0/12"],
        "A": [0, 12, 0, "0/12"],
        "Honor roll": [0, 7, 0, "0/7"],
    }
    assert "4 wait for angle_update" in lines
    assert "Grade: D." in lines
    assert (graded["grade"], graded["next"].split()[0]) == ("D", "angle_update")
    assert lines.index("4 more fail: handle_collision") < lines.index("1 more fails: angle_update")
    assert "hint        You used the old omega; theta moves with the new one." in lines
    _, lines, _ = grade(starter, "--tier", "B")
    where = lines.index("it raised   ValueError: invalid literal for int() with base 10: 'm1'")
    assert lines[where + 1].startswith("            src/visualize_cradle_run.py, line ")
    assert lines[where + 2] == '                return int("m1")'

    done = start("tests/watch.py", "test_angle_update", "--seconds", 0.6, folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    assert [line.partition(",")[0] for line in done.stdout.splitlines()[-2:]] == ["t = 0.50 s", "t = 0.60 s"]


def test_a_file_that_cannot_be_imported_fails_its_own_functions_only(starter):
    write_all(starter)
    swinging = starter / "src" / "swinging.py"
    swinging.write_text(swinging.read_text().replace("for pend in pend_list:", "for pend in pend_list"))
    status, lines, graded = grade(starter)
    assert status == 1
    waiting = {"D": 16, "C": 0, "B": 0, "A": 0, "Honor roll": 0}
    assert {tier: row[0] for tier, row in table_of(lines).items()} == {**waiting, "Honor roll": 7}
    assert {tier: row[2] for tier, row in table_of(lines).items()} == {"D": 0, "C": 2, "B": 0, "A": 0, "Honor roll": 0}
    assert len([line for line in lines if line.startswith("it raised   SyntaxError: expected ':' (swinging.py")]) == 1


AT_FAULT = [
    (
        "import extract_and_convert",
        "import extract_and_converts",
        "ImportError: cannot import name 'extract_and_conv",
    ),
    ("from src.pds_helper", "from pds_helper", "ModuleNotFoundError: No module named 'pds_helper'"),
    (
        "def uniform_mass",
        "extract_and_convert('nowhere.csv')\n\n\ndef uniform_mass",
        "FileNotFoundError: [Errno 2] No such file or directory: 'nowhere.csv'",
    ),
]


@pytest.mark.parametrize(("before", "after", "line"), slow_but_for(AT_FAULT[1:2], AT_FAULT))
def test_the_file_at_fault_fails_and_those_that_import_it_wait(starter, before, after, line):
    write_all(starter)
    special = starter / "src" / "special_cradles.py"
    special.write_text(special.read_text().replace(before, after))
    status, lines, graded = grade(starter)
    table = table_of(lines)
    assert status == 1
    assert [row[2] for row in table.values()] == [10, 0, 0, 0, 0]  # elastic and inelastic wait for uniform_e
    assert graded["next"].startswith("uniform_mass_newton_cradle in src/special_cradles.py")
    assert len([text for text in lines if text.startswith(f"it raised   {line}")]) == 1
    assert ("hint        Write src.pds_helper in the import." in lines) == line.startswith("Module")


def test_a_fault_of_the_grader_fails_and_is_no_point(starter):
    write_all(starter)
    suite = starter / "tests" / "test_c.py"
    suite.write_text(suite.read_text().replace('expect("angle_update", *STEP', 'expect("angle_update", 1 / 0, *STEP'))
    status, lines, graded = grade(starter, "--tier", "C")
    assert status == 1
    assert table_of(lines) == {"C": [1, 4, 1, "1/6"]}
    assert "This is a fault of the grader, not of your code. Please show it to your teacher." in lines
    assert (graded["grade"], graded["next"]) == (None, "show your teacher the grader's fault in test_angle_update")


@pytest.mark.slow
def test_the_suites_run_in_the_order_of_the_handout(starter):
    _, lines, _ = grade(starter)
    files = [line.split()[0].replace(os.sep, "/") for line in lines if line.startswith(f"tests{os.sep}")]
    assert files == [f"tests/{suite}.py" for suite in SUITES.values()]


@pytest.mark.slow
def test_one_tier_alone(starter):
    write_tiers(starter, "D")
    status, lines, graded = grade(starter, "--tier", "d")
    assert (status, table_of(lines)) == (0, {"D": [16, 0, 0, "16/16"]})
    assert (graded["grade"], graded["next"]) == ("D", "run all checks of tier C")
    assert (starter / "grade.json").is_file()  # and can be written again
    status, lines, graded = grade(starter, "--tier", "Honor roll")
    assert (status, table_of(lines)) == (1, {"Honor roll": [0, 7, 0, "0/7"]})
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
    assert f"found '{tmp_path}', allowed is a new or an empty folder" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


@pytest.mark.parametrize(
    ("arguments", "status", "words"),
    [
        (["test_angle"], 2, "found 'test_angle', allowed is the name of a check, for example test_angle_update"),
        (["test_angle_update"], 1, "There is nothing to watch."),
        (["test_angle_update", "--seconds", "0"], 2, "found '0', allowed is a number above 0 and up to 1e6 (s)"),
    ],
)
def test_what_cannot_be_watched(starter, arguments, status, words):
    done = start("tests/watch.py", *arguments, folder=starter)
    assert (done.returncode, done.stderr.count("\n")) == (status, 1)
    assert words in done.stderr
