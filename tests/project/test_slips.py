"""A slip in a command, or a file in the wrong place, gets a line that says what to do."""

import sys
from pathlib import Path

import pytest
from programs import python, slow_except
from students import put_files, PYTEST

HIDING = {  # a file, and the beginning of a line about it
    "json.py": "json.py hides the module json from Python and its packages.",
    "tests/statistics.py": "tests/statistics.py hides the module statistics",
    "pandas/__init__.py": "pandas hides the module pandas from Python",
}


def require_line(line, done):
    assert line in (done.stdout + done.stderr).replace("\\", "/")
    assert done.returncode
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("file", slow_except(["json.py"], HIDING))
def test_a_file_that_hides_a_module_gets_a_line(starter, file):
    put_files(starter, {file: ""})
    require_line(HIDING[file], python(*PYTEST.split(), folder=starter))


def test_a_support_that_is_elsewhere_gets_a_line(starter):
    (starter / "support").rename(starter / "src/support")
    require_line("support is not next to src", python(*PYTEST.split(), folder=starter))


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
    f"{PYTEST} --tier E": "argument --tier: found 'E', allowed is D, C, B, A or honor",
}


@pytest.mark.parametrize("command", slow_except([*SLIPS][:5], SLIPS))
def test_a_slip_in_a_command_gets_a_line(starter, command):
    require_line(SLIPS[command], python(*command.split(), folder=starter))


def test_from_another_folder_the_command_goes_to_the_checks_once(starter, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    done = python(*PYTEST.split(), starter / "src", folder=elsewhere)
    lines = [line for line in done.stdout.splitlines() if line.startswith("The checks are not")]
    command = f"cd {starter} && {sys.executable} -m pytest"
    assert lines == [f"The checks are not here. Type: {command}"]
