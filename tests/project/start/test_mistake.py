"""A mistake in your functions is named in its place."""

import re

import pytest

from support.cradle.motion import Motion
from support.start import mistake
from support.start.end import SignalError

PROGRAM = """
from src.special_cradles import make_newton_cradle as make
from support.constants import NC_FP, R_PARAM, THETA_INIT
from support.simulation import is_running

def make_newton_cradle(*given):
    return make(*given)

def newton_cradle_tick():
    pass

pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
while is_running(pend_list):
    newton_cradle_tick()
"""


@pytest.mark.parametrize(
    ("before", "after", "function", "line", "error"),
    [
        ("pass", "omegaa", "newton_cradle_tick", "omegaa", "NameError:"),
        ("pass", "open('no')", "newton_cradle_tick", "open('no')", "FileNotFoundError:"),
        ("pass", "exit(3)", "newton_cradle_tick", "exit(3)", "SystemExit: 3"),
        ("return ", "", "make_newton_cradle", "def ", "make_newton_cradle must return"),
    ],
)
def test_a_mistake_ends_a_program_with_the_students_line_last(
    main, csv, write_program, before, after, function, line, error
):
    write_program(PROGRAM.replace(before, after))
    status, _, stderr = main(csv, "--seconds", 1)
    *_, place, text, last, more = re.sub(r"(?m)^[ ^~]+\n", "", stderr).splitlines()
    assert status == 1
    assert re.search(rf'program.py", line \d+, in {function}$', place)
    assert text.strip().startswith(line)
    assert last.startswith(error)
    assert more == mistake.TYPE_PYTEST
    assert "support" not in stderr


def test_a_mistake_of_the_project_is_reported_in_full(main, csv, monkeypatch):
    monkeypatch.setattr(Motion, "time", lambda motion: 1 / 0)
    status, _, stderr = main(csv)
    assert status == 1
    assert "players.py" in stderr
    assert stderr.splitlines()[-1].startswith("ZeroDivisionError")


def test_a_mistake_without_a_line_is_the_message_alone():
    error = mistake.MistakeError("The program", "has ended.")
    assert mistake.report_mistake(error) == "The program has ended."


def test_of_ctrl_c_outside_of_the_students_functions_nothing_is_said(capsys):
    mistake.report_endless_loop(SignalError(0))
    assert capsys.readouterr().err == ""


def test_a_file_that_python_cannot_read_is_reported_with_its_own_place(tmp_path, capsys):
    file = tmp_path / "swinging.py"
    file.write_text("\nx = sin(")
    with pytest.raises(SyntaxError) as caught:
        compile(file.read_text(), file, "exec")
    message = mistake.report_mistake(caught.value)
    assert message == "SyntaxError: '(' was never closed (swinging.py, line 2: x = sin()"
    assert capsys.readouterr().err.splitlines()[0].endswith('swinging.py", line 2')
