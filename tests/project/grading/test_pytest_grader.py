"""Slips: a command for the checks that goes wrong gets one line, which says what to do."""

import pytest
from programs import python, slow_except
from students import PYTEST

SLIPS = {  # words behind python, and a part of what it prints
    f"{PYTEST} --grade-json no/a.json": "--grade-json: no/a.json: No such file or directory",
    "tests/test_d.py": "These are checks. Type pytest in this folder to run them.",
    "src/swinging.py": "This file has only functions. Type pytest in this folder",
    "src/begin_page.py": "This file has only functions. Type pytest in this folder",
    f"{PYTEST} --tier E": "argument --tier: invalid choice: 'E' (choose from",
}


@pytest.mark.parametrize("command", slow_except([*SLIPS][:2], SLIPS))
def test_a_slip_in_a_command_gets_a_line(starter, command):
    done = python(*command.split(), folder=starter)
    assert SLIPS[command] in done.stdout + done.stderr
    assert done.returncode
    assert "Traceback" not in done.stderr
