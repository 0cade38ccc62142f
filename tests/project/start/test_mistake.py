"""A mistake in your functions is named in its place."""

import re
from pathlib import Path

import pytest
from programs import copy_project, python
from students import change
from whole_cradles import FIVE_CSV

from support.start import mistake
from support.start.end import SignalError

SWINGING = Path("src/swinging.py")
VISUALIZE_FILE = Path("src/visualize_cradle_run.py")
SPECIAL = Path("src/special_cradles.py")
SWING = "    full_swing_update(pend_list, r_param, dt, g)\n"
OMEGA = "    omega_new = omega -"
PLAYED = ["src/text_cradle_run.py", "--seconds", "1"]
RECORDED = [*PLAYED[:2], "0.3", "--record", "data.csv", "--every", "0.05"]


@pytest.fixture
def project(tmp_path, monkeypatch):
    """The current folder: a copy of the project."""
    monkeypatch.chdir(copy_project(tmp_path, FIVE_CSV))
    return tmp_path


# A change, and the end of stderr: the student's function, a part of the line, and the error
MISTAKES = {
    "late": (
        SWINGING,
        OMEGA,
        "    omegaa if theta > 0.1 else 0\n" + OMEGA,
        "angle_update",
        "omegaa if",
        "NameError:",
    ),
    "no file": (
        SWINGING,
        OMEGA,
        "    open('no')\n" + OMEGA,
        "angle_update",
        "open('no')",
        "FileNotFoundError:",
    ),
    "no return": (
        SPECIAL,
        "    return pend_list\n",
        "",
        "make_newton_cradle",
        "def",
        "make_newton_cradle must return",
    ),
    "exit": (
        VISUALIZE_FILE,
        SWING,
        "    exit(3)\n" + SWING,
        "newton_cradle_tick",
        "exit(3)",
        "SystemExit: 3",
    ),
}


def check_end(status, stderr, name):
    """Check that a program has ended with this mistake, and that stderr has no line of support/."""
    file, _, _, function, line, error = MISTAKES[name]
    *_, place, text, last, more = re.sub(r"(?m)^[ ^~]+\n", "", stderr).splitlines()
    assert status == 1
    assert re.search(rf'{file.name}", line \d+, in {function}$', place)
    assert line in text
    assert last.startswith(error)
    assert more == mistake.TYPE_PYTEST
    assert "support" not in stderr


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_ends_a_program_with_the_students_line_last(project, name):
    change(*MISTAKES[name][:3])
    done = python(*RECORDED, folder=project)
    check_end(done.returncode, done.stderr, name)


def test_a_mistake_of_the_program_as_a_whole_has_no_line_of_ours(project):
    change(VISUALIZE_FILE, SWING, f"    exit()\n{SWING}")
    done = python(*PLAYED, folder=project)
    assert done.returncode == 1
    assert done.stderr.startswith("The program has ended, but the simulation goes on. ")
    assert done.stderr.count("\n") == 1


def test_a_mistake_of_the_project_is_reported_in_full(project):
    change(Path("support/cradle/motion.py"), "round(self", "round(1 / 0 * self")
    done = python(*PLAYED, folder=project)
    assert done.returncode == 1
    assert "players.py" in done.stderr
    assert "ZeroDivisionError" in done.stderr


def test_a_file_that_python_cannot_read_is_reported_with_its_own_place(tmp_path, capsys):
    file = tmp_path / "swinging.py"
    file.write_text("\nx = sin(")
    with pytest.raises(SyntaxError) as caught:
        compile(file.read_text(), file, "exec")
    message = mistake.report_mistake(caught.value)
    assert message == "SyntaxError: '(' was never closed (swinging.py, line 2: x = sin()"
    assert capsys.readouterr().err.splitlines()[0].endswith('swinging.py", line 2')


def test_of_ctrl_c_outside_of_the_students_functions_nothing_is_said(capsys):
    mistake.report_endless_loop(SignalError(0))  # in no function of the handout
    assert capsys.readouterr().err == ""
