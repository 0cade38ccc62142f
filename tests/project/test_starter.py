"""What students are handed: made, graded as it is, graded with solutions in it, and what its
programs say.
"""

import ast
import os
import re
import runpy
import shutil
import sys
from math import degrees
from unittest.mock import Mock

import pandas as pd
import pytest
from make_starter import FILES, make_starter
from programs import call, copy_project, python, ROOT
from students import change, COUNTS, graded_in, put_files, write, write_tiers

from grading.handout import FUNCTIONS, SUITES

HANDOUTS = {function.file for function in FUNCTIONS.values()}


def table_of(lines):
    """Return the table that pytest printed: for each tier, passed, waiting, failed, and points."""
    return [" ".join(line.split()[-4:]) for line in lines if re.fullmatch(r".+ \d+/\d+", line)]


def test_a_starter_is_made_all_waits_and_with_the_solutions_all_is_green(tmp_path):
    folder = tmp_path / "starter"
    done = python(ROOT / "tests" / "make_starter.py", folder, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{folder} is ready")

    result = graded_in(folder)
    assert (result["grade"], result["next"].split()[0]) == (None, "extract_and_convert")
    assert table_of(result["text"]) == [f"0 {count} 0 0/{count}" for count in COUNTS.values()]

    write(folder, *FUNCTIONS)
    result = graded_in(folder)
    tiers = {
        tier: {"passed": n, "waiting": 0, "failed": 0, "points": n, "of": n}
        for tier, n in COUNTS.items()
    }
    assert (result["tiers"], result["grade"]) == (tiers, "Honor roll")
    assert result["next"] == "all functions with a check are right"
    left = "double_cradle_tick in src/double_cradle.py; main in src/visualize_double_cradle_run.py."
    assert f"The double cradle still needs {left}" in " ".join(" ".join(result["text"]).split())
    assert table_of(result["text"]) == [f"{count} 0 0 {count}/{count}" for count in COUNTS.values()]
    assert len(result["text"]) <= 25


def test_each_function_has_the_handouts_signature_a_docstring_and_its_place(made):
    for name, function in FUNCTIONS.items():
        body = ast.parse((made / function.file).read_text(encoding="utf-8")).body
        (node,) = (node for node in body if isinstance(node, ast.FunctionDef) and node.name == name)
        assert ", ".join(arg.arg for arg in node.args.args) == function.parameters
        assert ast.get_docstring(node)
        stubs = [ast.unparse(part) for part in ast.walk(node) if isinstance(part, ast.Raise)]
        assert stubs == [f"raise NotImplementedError('{name} is not written yet')"] * (
            2 if name == "main" else 1
        )


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
        ("double_cradle", "from vpython import box, cylinder, sphere\n"),
    ]:
        assert f"\n{lines}" in (made / "src" / f"{name}.py").read_text().replace('"', "'")


def test_the_folder_has_the_handouts_files_the_programs_and_the_graded_tests_alone(made):
    others = {
        "src/__init__.py",
        "src/text_cradle_run.py",
        "src/visualize_double_cradle_run.py",
    }
    assert {f"src/{path.name}" for path in made.glob("src/*")} == HANDOUTS | others
    suites = {f"{suite}.py" for suite in SUITES.values()}
    assert {path.name for path in made.glob("tests/*")} - {"__pycache__"} == suites | {"grading"}
    assert not [*made.rglob("many_ticks.py")]
    for file in [*made.glob("support/**/*.py"), *made.glob("tests/grading/*.py")]:
        assert file.read_bytes() == (ROOT / file.relative_to(made)).read_bytes()


def test_a_student_meets_no_reference_to_a_file_module_or_name_that_is_not_there(made):
    for file in made.rglob("*.*"):
        if file.suffix in (".py", ".md", ".toml", ".html"):
            text = file.read_text(encoding="utf-8")
            for path in re.findall(r"\b(?:src|support|tests)/[\w/]+\.\w+", text):
                assert (made / path).exists() or "make_starter" in path, (file.name, path)
            for module in re.findall(r"\b(?:src|support)(?:\.\w+)+", text):
                path = made.joinpath(*module.split("."))
                places = path, path.with_suffix(".py"), path.parent.with_suffix(".py")
                assert any(place.exists() for place in places), module
    for file in made.glob("src/*.py"):
        assert not re.findall(r"approaching_only|page\.rule", file.read_text())
    words = "BUFFER|cos|many_ticks|pairwise|rule"
    for file in HANDOUTS - {"src/double_cradle.py"}:
        assert re.findall(rf"\b(?:{words})\b", (made / file).read_text()) == []
    options = ["--isolated", "--no-cache", "--select", "F", "--ignore", "F401,F821,F841"]
    done = python("-m", "ruff", "check", *options, "src", folder=made)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout


def test_a_file_or_a_folder_whose_name_begins_with_a_dot_is_left_out(tmp_path, monkeypatch):
    """A Mac puts such a file beside each one on a foreign disk; Jupyter keeps whole solutions in
    such a folder.
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
    assert sorted(path.name for path in (tmp_path / "starter").rglob(".*")) == [
        ".github",
        ".gitignore",
    ]


def test_the_workflow_for_github_has_the_lines_of_the_readme(made):
    workflow, readme = (
        (made / file).read_text() for file in (".github/workflows/classroom.yml", "README.md")
    )
    lines = [line.strip() for line in workflow.partition("run: |\n")[2].splitlines()]
    assert lines == [line.strip() for line in readme.splitlines() if ".venv/bin/p" in line][:3]


@pytest.mark.parametrize("place", ["deep/down/new", "."])
def test_on_a_full_disk_nothing_is_left_of_it(tmp_path, monkeypatch, place):
    """A folder that was there stays."""
    monkeypatch.setattr(shutil, "copy", Mock(side_effect=[*[None] * 20, OSError]))
    with pytest.raises(OSError):
        make_starter(tmp_path / place)
    assert os.listdir(tmp_path) == []


# A student's functions that a file may call: the programs need it, or the handout itself has the
# call
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


def answers_below(folder):
    """Yield what in the Python files below a folder a student could write off, each as "file:
    answer".
    """
    for file in folder.rglob("*.py"):
        code = ast.unparse(ast.parse(file.read_text(encoding="utf-8")))  # each statement in a line
        called = {*re.findall(r"(?<!def )\b(\w+)\((?!\))", code)} - {
            "main",
            *CALLED.get(file.name, []),
        }
        yield from (
            f"{file.name}: a call of {function}" for function in called.intersection(FUNCTIONS)
        )
        yield from (
            f"{file.name}: {words}"
            for words, pattern in ANSWERS.items()
            if re.search(pattern, code)
        )


def test_the_folder_has_no_answers(made):
    """The project itself has answers of each kind: the patterns fit its lines."""
    assert [*answers_below(made)] == []
    in_project = {answer.partition(": ")[2] for answer in answers_below(ROOT / "src")}
    assert {"a call of handle_two_bobs", "a call of newton_cradle_tick", *ANSWERS} <= in_project


def test_a_half_written_project(starter):
    """D is there, angle_update has a mistake, and handle_collision raises; the rest is not written."""
    write_tiers(starter, "DC")
    change(starter / "src/swinging.py", "theta + omega_new * dt", "theta + omega * dt")
    write(starter, "handle_collision", handle_collision='return int("m1")')
    result = graded_in(starter)
    counts = [
        (tier["passed"], tier["waiting"], tier["failed"]) for tier in result["tiers"].values()
    ]
    d, c, b, a, honor = COUNTS.values()
    assert counts == [(d, 0, 0), (0, c - 2, 2), (0, b - 4, 4), (0, a, 0), (0, honor, 0)]
    assert (result["grade"], result["next"].split()[0]) == ("D", "angle_update")
    assert {"Grade: D.", f"{c - 2} checks wait for angle_update"} <= {*result["text"]}
    text = " ".join(" ".join(result["text"]).split())
    assert (
        "theta_new is 2.91799, not 2.81799. This is the result with the old omega in the change of theta."
        in text
    )
    message = result["checks"]["test_handle_collision"]["message"].splitlines()
    assert "it raised   ValueError: invalid literal for int() with base 10: 'm1'" in message


def test_files_that_cannot_be_imported_fail_and_the_files_that_import_them_wait(starter):
    write(starter, *FUNCTIONS)
    change(starter / "src/special_cradles.py", "from src.pds", "from pds")
    change(starter / "src/swinging.py", "in pend_list:", "in pend_list")
    result = graded_in(starter)
    assert [counts["failed"] for counts in result["tiers"].values()] == [1, 1, 0, 0, 0]
    assert re.fullmatch(r"src/special_cradles.py, line \d+", result["next"])
    error = "ModuleNotFoundError: No module named 'pds_helper'"
    hint = "Write src. in front of the file in the import: src.pds_helper."
    assert result["text"][-2:] == [error, hint]
    assert "SyntaxError: expected ':'" in "\n".join(
        check["message"] for check in result["checks"].values()
    )


@pytest.fixture
def run(monkeypatch, capsys):
    """A function that runs a program of a starter in this process; it returns the status, stdout
    and stderr.
    """
    monkeypatch.setattr("support.start.early.on_signals", lambda act: None)
    monkeypatch.setattr("support.start.preview.checks_command", lambda: "pytest")

    def taken():
        names = [name for name in sys.modules if name.partition(".")[0] == "src"]
        return {name: sys.modules.pop(name) for name in names}

    def run(starter, program, *arguments):
        monkeypatch.chdir(starter)
        monkeypatch.setattr("support.start.preview.SRC", starter / "src")
        monkeypatch.setattr(sys, "path", [str(starter / "src"), str(starter), *sys.path])
        monkeypatch.setattr(sys, "argv", [str(starter / program), *arguments])
        # It would forget what the tests have imported
        monkeypatch.setitem(sys.modules, "support.start.program", Mock())
        return call(lambda: runpy.run_path(str(starter / program), run_name="__main__"), capsys)

    kept = taken()
    yield run
    taken()
    sys.modules.update(kept)


TERMINAL, DOUBLE = "src/text_cradle_run.py", "src/visualize_double_cradle_run.py"
UNIFORM = "uniform_mass_newton_cradle, uniform_e_newton_cradle, elastic_newton_cradle, inelastic_newton_cradle"
BOTH = f"double_angle_update, double_cradle_tick in src/double_cradle.py; main in {DOUBLE}"


@pytest.mark.parametrize(
    ("words", "tiers", "more", "missing"),
    [
        ([TERMINAL], "", ["extract_and_convert"], "make_newton_cradle in src/special_cradles.py"),
        (
            [TERMINAL, "--elastic"],
            *("", ["extract_and_convert", "make_newton_cradle"]),
            "uniform_e_newton_cradle, elastic_newton_cradle in src/special_cradles.py",
        ),
        ([DOUBLE], "DCBA", ["make_double_pendulum"], BOTH),
    ],
)
def test_a_program_without_a_cradle_names_the_functions_to_write(
    run, starter, words, tiers, more, missing
):
    write_tiers(starter, tiers)
    write(starter, *more)
    assert run(starter, *words) == (
        2,
        "",
        f"There is no cradle to see yet. Write first: {missing}.\n",
    )


def test_two_functions_make_a_picture(run, starter):
    write(starter, "extract_and_convert", "make_newton_cradle")
    status, out, err = run(starter, TERMINAL, "--seconds", "0.01")
    assert (status, err) == (0, "")
    assert out.startswith(
        f"Write next: {UNIFORM} in src/special_cradles.py; angle_update, full_swing_update in src/"
    )


FIRST_TWO = "Here are the first two pendula alone: their bobs collide. If not, type pytest."
COLLIDE = (
    "in src/visualize_cradle_run.py. Then the bobs collide. If no pendulum swings, type pytest."
)
# The tiers that are written, what the line says, and the angles of the first and of the last
# pendulum
STAGES = [
    (
        "D",
        "Write next: angle_update, full_swing_update in src/swinging.py. Then the pendula swing.",
        (-45, 0),
    ),
    (
        "DC",
        f"Write next: handle_collision, handle_two_bobs, newton_cradle_tick, main {COLLIDE}",
        (44, 0),
    ),
    (
        "DCB",
        f"Write next: newton_cradle_tick, main in src/visualize_cradle_run.py. {FIRST_TWO}",
        (0, 44),
    ),
    ("DCBA", "", (0, 44)),
]


@pytest.mark.parametrize(("tiers", "remark", "angles"), STAGES)
def test_the_terminal_and_the_page_show_as_much_as_is_written(
    run, monkeypatch, starter, tiers, remark, angles
):
    write_tiers(starter, tiers)
    if "C" in tiers:  # below a return, it is no stub
        stub = '    raise NotImplementedError("angle_update is not written yet")\n'
        change(starter / "src/swinging.py", "theta_new)\n", f"theta_new)\n{stub}")
    status, out, err = run(starter, TERMINAL, "--seconds", "0.01")
    assert (status, err) == (0, "")
    assert out.startswith(f"{remark}\nt = 0.00 s" if remark else "t = 0.00 s")
    assert run(starter, TERMINAL, "--record", "data.csv", "--seconds", "0.5", "--every", "0.5")[
        ::2
    ] == (0, "")
    thetas = pd.read_csv(starter / "data.csv").filter(like="theta").iloc[-1]
    assert [round(degrees(thetas.iloc[i])) for i in (0, -1)] == pytest.approx(angles, abs=1)
    monkeypatch.setattr("support.page.page.show_page", lambda *given: print(given[-1]))
    assert run(starter, "src/visualize_cradle_run.py") == (0, f"{remark}\n", "")
