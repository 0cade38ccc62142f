"""Slips: a command for the checks that goes wrong gets one line, which says what to do."""

import sys
from pathlib import Path

import pytest
from programs import python, slow_except
from students import put_files, PYTEST

from support.start.unfit import hidden_module

HIDING = {  # a file of a project, and the beginning of the line about it
    "src/contextlib.py": "src/contextlib.py hides the module contextlib from Python",
    "tests/statistics.py": "tests/statistics.py hides the module statistics",
    "pandas/__init__.py": "pandas hides the module pandas",
    "test.py": "",  # nobody needs Python's module test
    "random.csv": "",
    "other/random.py": "",
}


@pytest.mark.parametrize("file", HIDING)
def test_a_file_that_hides_a_module_is_named(tmp_path, file):
    for name in ("src", "tests"):
        (tmp_path / name).mkdir()
    put_files(tmp_path, {file: ""})
    python_path = [str(tmp_path), str(tmp_path / "src"), str(tmp_path / "tests")]
    line = hidden_module(str(tmp_path), python_path)
    assert line.replace("\\", "/").startswith(HIDING[file])
    assert bool(line) == bool(HIDING[file])


def require_line(line, done):
    assert line in (done.stdout + done.stderr).replace("\\", "/")
    assert done.returncode
    assert "Traceback" not in done.stderr


def test_pytest_names_a_file_that_hides_a_module(starter):
    put_files(starter, {"json.py": ""})
    line = "json.py hides the module json from Python and its packages."
    require_line(line, python(*PYTEST.split(), folder=starter))


def test_a_support_that_is_elsewhere_gets_a_line(starter):
    (starter / "support").rename(starter / "src/support")
    require_line("support is not next to src", python(*PYTEST.split(), folder=starter))


PYTHON = Path(sys.executable).as_posix()
SLIPS = {  # words behind python, and a part of what it prints
    f"{PYTEST} --grade-json no/a.json": "--grade-json: found 'no/a.json', allowed is a file in",
    f"{PYTEST} --grade-json src": "--grade-json: found 'src', allowed is a file in a folder",
    f"{PYTEST} src": f"The checks are not here. Type: {PYTHON} -m pytest",
    "-m unittest": f"Type {PYTHON} -m pytest to run them.",
    "tests/test_d.py": f"These are checks. Type {PYTHON} -m pytest to run them.",
    "src/swinging.py": f"This file has only functions. Type {PYTHON} -m pytest",
    f"{PYTEST} --tier E": "argument --tier: found 'E', allowed is D, C, B, A or honor",
    f"-O {PYTEST}": "Run pytest without -O, -OO and PYTHONOPTIMIZE: with them",
}


@pytest.mark.parametrize("command", slow_except([*SLIPS][:3], SLIPS))
def test_a_slip_in_a_command_gets_a_line(starter, command):
    require_line(SLIPS[command], python(*command.split(), folder=starter))


def test_from_another_folder_the_command_goes_to_the_checks_once(starter, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    done = python(*PYTEST.split(), starter / "src", folder=elsewhere)
    lines = [line for line in done.stdout.splitlines() if line.startswith("The checks are not")]
    assert lines == [
        f"The checks are not here. Type: {sys.executable} -m pytest {starter / 'tests'}"
    ]
