"""What students are handed: made, graded as it is and with solutions, and what its programs say."""

import ast
import os
import re
import shutil
from math import degrees
from unittest.mock import Mock

import pandas as pd
import pytest
from make_starter import FILES, make_starter
from programs import copy_project, python, ROOT, slow_but_for, with_vpython
from students import change, COUNTS, graded_in, put_files, write, write_tiers

from grading.handout import FUNCTIONS, SUITES

HANDOUTS = {function.file for function in FUNCTIONS.values()}


def test_a_starter_is_made_all_waits_and_with_the_solutions_all_is_green(tmp_path):
    folder = tmp_path / "starter"
    done = python(ROOT / "tests" / "make_starter.py", folder, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{folder} is ready")

    result = graded_in(folder)
    assert result["grade"] is None
    assert result["next"].startswith("extract_and_convert")
    for tier, counts in result["tiers"].items():
        assert counts["waiting"] == counts["of"] == COUNTS[tier]

    write(folder, *FUNCTIONS)
    result = graded_in(folder)
    assert result["grade"] == "Honor roll"
    assert result["next"] == "all functions with a check are right"
    for tier, counts in result["tiers"].items():
        assert counts["passed"] == counts["points"] == COUNTS[tier]
    left = "double_cradle_tick in src/double_cradle.py; main in src/visualize_double_cradle_run.py."
    text = " ".join(" ".join(result["text"]).split())
    assert f"The double cradle still needs {left}" in text


def test_each_function_has_the_handouts_signature_a_docstring_and_its_place(made):
    functions = {}
    for file in HANDOUTS:
        for node in ast.parse((made / file).read_text(encoding="utf-8")).body:
            functions[file, getattr(node, "name", None)] = node
    for name, function in FUNCTIONS.items():
        node = functions[function.file, name]
        assert ", ".join(arg.arg for arg in node.args.args) == function.parameters
        assert ast.get_docstring(node)
        stubs = [ast.unparse(part) for part in ast.walk(node) if isinstance(part, ast.Raise)]
        assert {*stubs} == {f"raise NotImplementedError('{name} is not written yet')"}
        assert len(stubs) == (2 if name == "main" else 1)


def test_the_lines_of_the_handout_are_there_as_it_has_them(made):
    for name, lines in [
        (
            "pds_helper",
            "    df = pd.read_csv(relative_filepath)\n    bad_rep = df.to_dict(orient='index')\n",
        ),
        ("visualize_cradle_run", "    page.show(pend_list)\n    while page.is_running():"),
        ("swinging", "from math import sin\n\nfrom support"),
        ("visualize_cradle_run", "from vpython import mag\n\nfrom src"),
        ("special_cradles", "from vpython import vector\n"),
        ("double_cradle", "from vpython import box, cylinder, sphere, vector\n"),
    ]:
        assert f"\n{lines}" in (made / "src" / f"{name}.py").read_text().replace('"', "'")


def test_the_folder_has_the_handouts_files_the_programs_and_the_graded_tests_alone(made):
    others = {"__init__", "text_cradle_run", "visualize_double_cradle_run"}
    sources = {f"src/{path.name}" for path in made.glob("src/*")}
    assert sources == HANDOUTS | {f"src/{name}.py" for name in others}
    suites = {f"{suite}.py" for suite in SUITES.values()}
    assert {path.name for path in made.glob("tests/*")} - {"__pycache__"} == suites | {"grading"}
    assert not [*made.rglob("many_ticks.py")]
    for file in [*made.glob("support/**/*.py"), *made.glob("tests/grading/*.py")]:
        assert file.read_bytes() == (ROOT / file.relative_to(made)).read_bytes()


def test_a_student_meets_no_reference_to_a_file_or_module_that_is_not_there(made):
    for file in made.rglob("*.*"):
        if file.suffix not in (".py", ".md", ".toml", ".html"):
            continue
        text = file.read_text(encoding="utf-8")
        for path in re.findall(r"\b(?:src|support|tests)/[\w/]+\.\w+", text):
            assert (made / path).exists() or "make_starter" in path, file
        for module in re.findall(r"\b(?:src|support)(?:\.\w+)+", text):
            path = made.joinpath(*module.split("."))
            # A folder, a file, or a name in a file
            places = (path, path.with_suffix(".py"), path.parent.with_suffix(".py"))
            assert any(place.exists() for place in places), module


def test_a_student_meets_no_name_that_is_not_there_or_beyond_the_handout(made):
    for file in made.glob("src/*.py"):
        assert not re.findall(r"approaching_only|page\.rule", file.read_text())
    for file in HANDOUTS - {"src/double_cradle.py"}:
        text = (made / file).read_text()
        assert not re.findall(r"\b(?:BUFFER|cos|many_ticks|pairwise|rule)\b", text)
    options = ["--isolated", "--no-cache", "--select", "F", "--ignore", "F401,F821,F841"]
    done = python("-m", "ruff", "check", *options, "src", folder=made)
    assert done.returncode == 0, done.stdout


def test_a_file_or_a_folder_whose_name_begins_with_a_dot_is_left_out(tmp_path, monkeypatch):
    """A Mac puts such a file beside each one on a foreign disk.

    Jupyter keeps whole solutions in such a folder.
    """
    shutil.copytree(ROOT / "tests", copy_project(tmp_path, "") / "tests")
    for name in FILES:
        shutil.copy(ROOT / name, tmp_path / name)
    copies = [
        "src/._swinging.py",
        "src/.ipynb_checkpoints/swinging.py",
        "tests/grading/._grade.py",
        "support/.x/y.txt",
    ]
    put_files(tmp_path, dict.fromkeys(copies, b"\0"))
    monkeypatch.setattr("make_starter.ROOT", tmp_path)
    make_starter(tmp_path / "starter")
    hidden = {path.name for path in (tmp_path / "starter").rglob(".*")}
    assert hidden == {".github", ".gitignore"}


def test_the_workflow_for_github_has_the_lines_of_the_readme(made):
    workflow = (made / ".github" / "workflows" / "classroom.yml").read_text()
    lines = workflow.partition("run: |\n")[2].splitlines()
    readme = (made / "README.md").read_text().splitlines()
    commands = [line.strip() for line in readme if ".venv/bin/p" in line]
    assert [line.strip() for line in lines] == commands[:3]


@pytest.mark.parametrize("place", ["deep/down/new", "."])
def test_on_a_full_disk_nothing_is_left_of_it(tmp_path, monkeypatch, place):
    """A folder that was there stays."""
    monkeypatch.setattr(shutil, "copy", Mock(side_effect=[*[None] * 20, OSError]))
    with pytest.raises(OSError):
        make_starter(tmp_path / place)
    assert os.listdir(tmp_path) == []


# A student's functions that a file may call: the programs need it, or the handout itself does it.
CALLED = {
    "swinging.py": ["angle_update"],  # by swing_update, which the handout provides
    "double_cradle.py": ["make_newton_cradle", "make_double_pendulum", "double_angle_update"],
    "cradle.py": ["extract_and_convert", "uniform_mass_newton_cradle"],
    "pds_tester.py": ["extract_and_convert"],
}
ANSWERS = {  # patterns of code
    "the places of the axles": r"-?0\.1 \+ .*/ 4|/ 4 \* i\b",
    "the height of the axles": r"\b(r_param|R|R_PARAM) / 5\b",
    "the looks of a row": r"(COLOR|TEXTURE)_MAP\[.*(color|texture)",
    "the distance of bobs": r"\bmag\(.*\.pos - .*\.pos\) [<>]",
    "whether bobs touch": r"[<>].* (1\.05|BUFFER) \* \(\w+\.radius \+ \w+\.radius\)",
    "the formula of a collision": r"\be \* \((v|omega)1 - (v|omega)2\)|\* e \* \(",
    "the formula of gravity": r"\bg \* sin\(theta\)",
    "the formula of the swing": r"theta \+ omega\w* \* dt",
    "the lower cord": r"\barm\(theta \+ phi\)|, theta \+ phi,",
    "a loop that swings": r"\bfor \w+ in .*\n?.*\b(swing|angle)_update\(",
}


def answers_below(folder) -> set[str]:
    """Return what a student could write off from the Python files below a folder."""
    answers = set()
    for file in folder.rglob("*.py"):
        code = ast.unparse(ast.parse(file.read_text(encoding="utf-8")))  # each statement in a line
        allowed = {"main", *CALLED.get(file.name, [])}
        called = re.findall(r"(?<!def )\b(\w+)\((?!\))", code)
        for function in FUNCTIONS.keys() & {*called} - allowed:
            answers.add(f"a call of {function}")
        for answer, pattern in ANSWERS.items():
            if re.search(pattern, code):
                answers.add(answer)
    return answers


def test_the_folder_has_no_answers(made):
    """The project itself has answers of each kind: the patterns fit its lines."""
    assert answers_below(made) == set()
    calls = {"a call of handle_two_bobs", "a call of newton_cradle_tick"}
    assert calls | ANSWERS.keys() <= answers_below(ROOT / "src")


def test_a_half_written_project(starter):
    """D is there, angle_update has a mistake, and handle_collision raises; others are stubs."""
    write_tiers(starter, "DC")
    change(starter / "src/swinging.py", "theta + omega_new * dt", "theta + omega * dt")
    write(starter, "handle_collision", handle_collision='return int("m1")')
    result = graded_in(starter)
    counts = {
        tier: (tier_counts["passed"], tier_counts["waiting"], tier_counts["failed"])
        for tier, tier_counts in result["tiers"].items()
    }
    d, c, b, a, honor = COUNTS.values()
    assert counts == {
        "D": (d, 0, 0),
        "C": (0, c - 2, 2),
        "B": (0, b - 4, 4),
        "A": (0, a, 0),
        "Honor roll": (0, honor, 0),
    }
    assert result["grade"] == "D"
    assert result["next"].startswith("angle_update ")
    assert f"{c - 2} checks wait for angle_update" in result["text"]


def test_files_that_cannot_be_imported_fail_and_the_files_that_import_them_wait(starter):
    write(starter, *FUNCTIONS)
    change(starter / "src/special_cradles.py", "from src.pds", "from pds")
    change(starter / "src/swinging.py", "in pend_list:", "in pend_list")
    result = graded_in(starter)
    failed = {tier: counts["failed"] for tier, counts in result["tiers"].items()}
    assert failed == {"D": 1, "C": 1, "B": 0, "A": 0, "Honor roll": 0}
    assert re.fullmatch(r"src/special_cradles.py, line \d+", result["next"])
    assert "ModuleNotFoundError: No module named 'pds_helper'" in result["text"]


TERMINAL = "src/text_cradle_run.py"
DOUBLE = "src/visualize_double_cradle_run.py"
# The program of the page prints only what it would show beside the cradle.
PAGE = """
import runpy, sys
from unittest.mock import Mock
import grading.begin
sys.modules["support.start.program"] = Mock()  # it would forget the next line
from support.page import page
page.show_page = lambda *given: print(given[-1])
runpy.run_path("src/visualize_cradle_run.py", run_name="__main__")
"""


@pytest.mark.parametrize(
    ("command", "tiers", "functions", "missing"),
    [
        ([TERMINAL], "", ["extract_and_convert"], "make_newton_cradle in src/special_cradles.py"),
        (
            [TERMINAL, "--elastic"],
            "",
            ["extract_and_convert", "make_newton_cradle"],
            "uniform_e_newton_cradle, elastic_newton_cradle in src/special_cradles.py",
        ),
        pytest.param(
            [DOUBLE],
            "DCBA",
            ["make_double_pendulum"],
            f"double_angle_update, double_cradle_tick in src/double_cradle.py; main in {DOUBLE}",
            marks=with_vpython,
        ),
    ],
)
def test_a_program_without_a_cradle_names_the_functions_to_write(
    starter, command, tiers, functions, missing
):
    write_tiers(starter, tiers)
    write(starter, *functions)
    done = python(*command, folder=starter)
    message = f"There is no cradle to see yet. Write first: {missing}.\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", message)


UNIFORM = (
    "uniform_mass_newton_cradle, uniform_e_newton_cradle, elastic_newton_cradle, "
    "inelastic_newton_cradle in src/special_cradles.py"
)
SWING = "angle_update, full_swing_update in src/swinging.py"
HITS = "handle_collision, handle_two_bobs, newton_cradle_tick, main in src/visualize_cradle_run.py"
# What is written, the beginning of the line above the cradle, and the angles of the first and the
# last bob after half a second
STAGES = {
    "two functions": (f"Write next: {UNIFORM}; {SWING}. Then the pendula swing.", (-45, 0)),
    "D": (f"Write next: {SWING}. Then the pendula swing.", (-45, 0)),
    "DC": (f"Write next: {HITS}. Then the bobs collide.", (44, 0)),
    "DCB": (
        "Write next: newton_cradle_tick, main in src/visualize_cradle_run.py. "
        "Here are the first two pendula alone: their bobs collide.",
        (0, 44),
    ),
    "DCBA": ("", (0, 44)),
}


@pytest.mark.parametrize("written", slow_but_for(["two functions", "DCB"], STAGES))
def test_the_terminal_and_the_page_show_as_much_as_is_written(starter, written):
    remark, angles = STAGES[written]
    if written == "two functions":
        write(starter, "extract_and_convert", "make_newton_cradle")
    else:
        write_tiers(starter, written)
    if "C" in written:  # below a return, it is no stub
        stub = '    raise NotImplementedError("angle_update is not written yet")\n'
        change(starter / "src/swinging.py", "theta_new)\n", f"theta_new)\n{stub}")

    def first_line(*command):
        done = python(*command, folder=starter, PYTHONPATH=f"src{os.pathsep}tests")
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout.partition("\n")[0]

    assert first_line(TERMINAL, "--seconds", "0.01").startswith(remark or "t = 0.00 s")
    page_remark = first_line("-c", PAGE)
    assert page_remark.startswith(remark)
    assert bool(page_remark) == bool(remark)
    first_line(TERMINAL, "--record", "data.csv", "--seconds", "0.5", "--every", "0.5")
    thetas = pd.read_csv(starter / "data.csv").filter(like="theta").iloc[-1]
    found = degrees(thetas.iloc[0]), degrees(thetas.iloc[-1])
    assert found == pytest.approx(angles, abs=1.5)
