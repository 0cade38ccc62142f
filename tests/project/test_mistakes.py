"""Your functions run as they are: a change shows, and a mistake is named in its place."""

import csv
import re
import runpy
import sys
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock, patch

import pytest
from programs import call, copy_project, end, first_lines, ROOT, running
from students import change
from whole_cradles import FIVE_CSV

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.cradle.motion import Motion
from support.start import mistake
from support.start.end import SignalError

SWINGING = Path("src/swinging.py")
VISUALIZE_FILE = Path("src/visualize_cradle_run.py")
SPECIAL = Path("src/special_cradles.py")
SWING = "    full_swing_update(pend_list, r_param, dt, g)\n"
OMEGA = "    omega_new = omega -"
COLOR = 'COLOR_MAP[pend_dict["color"]]'
CSV = "newton_cradle_pends.csv"
LOSSY = FIVE_CSV.replace("1.0,1.0", "1.0,0.9")  # the two rules differ
PAGE = [VISUALIZE_FILE]
PLAYED = ["src/text_cradle_run.py", "--seconds", "1"]
RECORDED = [*PLAYED[:2], "0.3", "--record", "data.csv", "--every", "0.05"]


@pytest.fixture
def project(tmp_path, monkeypatch):
    """The current folder: a copy of the project. Imports find the functions of its src/."""
    monkeypatch.chdir(copy_project(tmp_path, LOSSY))
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path / "src"))
    monkeypatch.setattr(mistake, "ROOT", tmp_path.resolve())
    monkeypatch.setattr(mistake, "SRC", tmp_path.resolve() / "src")
    for name in [name for name in sys.modules if name.partition(".")[0] == "src"]:
        monkeypatch.delitem(sys.modules, name)
    for name in ("begin", "begin_page"):
        monkeypatch.setitem(sys.modules, name, Mock())
    monkeypatch.setattr("signal.signal", lambda *_: None)
    tabs = Mock(have_room=bool, are_gone=False)
    server = SimpleNamespace(tabs=tabs, close=lambda *_: None)
    monkeypatch.setattr("support.page.show_cradle.open_page", lambda *_: server)
    return tmp_path


def start(program, *options):
    """Run a program of the project with these options in this process."""
    with patch.object(sys, "argv", [str(program), CSV, *options]):
        runpy.run_path(program, run_name="__main__")


CHANGES = {  # a file, an old and a new text
    "nothing": (VISUALIZE_FILE, SWING, SWING),
    "air resistance in the tick": (
        VISUALIZE_FILE,
        SWING,
        SWING + "    for pend in pend_list:\n        pend['omega'] *= 0.9999\n",
    ),
    "a wind": (SWINGING, "* dt\n    theta_new", "* dt + 0.001\n    theta_new"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_recorded_data_are_those_of_a_plain_loop_to_the_last_bit(project, name):
    change(*CHANGES[name])
    start(*RECORDED)
    functions = import_module("src.visualize_cradle_run")
    pend_list = functions.make_newton_cradle(CSV, R_PARAM, THETA_INIT)
    _, *rows = csv.reader((project / "data.csv").read_text().splitlines())
    assert len(rows) == 7
    for row in rows:
        recorded = [*map(float, row[1:11])]
        assert recorded == [pend[key] for key in ("theta", "omega") for pend in pend_list]
        for _ in range(round(0.05 / DT)):
            functions.newton_cradle_tick(pend_list, R_PARAM, DT, G, approaching_only=True)


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
    "no color": (
        SPECIAL,
        COLOR,
        'pend_dict["color"]',
        "make_newton_cradle",
        "pend_dict",
        "AttributeError:",
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
        "    exit()\n" + SWING,
        "newton_cradle_tick",
        "exit()",
        "SystemExit",
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


@pytest.mark.parametrize(
    ("name", "program"),
    [*[(name, PLAYED) for name in MISTAKES], ("late", PAGE), ("no file", RECORDED)],
)
def test_a_mistake_ends_a_program_with_the_students_line_last(project, capsys, name, program):
    change(*MISTAKES[name][:3])
    status, _, stderr = call(lambda: start(*program), capsys)
    check_end(status, stderr, name)


def test_a_mistake_of_the_project_is_reported_in_full(project, capsys, monkeypatch):
    monkeypatch.setattr(Motion, "time", lambda self: 1 / 0)
    status, _, report = call(lambda: start(*PLAYED), capsys)
    assert status == 1
    assert "players.py" in report
    assert "ZeroDivisionError" in report


def test_a_mistake_ends_the_process_of_the_browser_program_and_its_page_says_so(page, project):
    change(*MISTAKES["late"][:3])
    with running(project / VISUALIZE_FILE) as process:
        page.goto(first_lines(process))
        status, _, stderr = end(process)
    check_end(status, stderr, "late")
    page.get_by_text("To start it again, type this command").wait_for()
    words = page.locator(".notice").inner_text()
    assert words.startswith("NameError: name 'omegaa'")  # the mistake, then what to do
    assert re.search(r"\)\s+The program has ended\. To start it again, .*\n\s*\S+python", words)
    assert page.locator(".canvas").evaluate("canvas => canvas.inert")


def test_of_ctrl_c_nothing_is_said_where_nothing_hung(capsys):
    mistake.report_endless_loop(SignalError(0))  # in no function of the handout
    with pytest.raises(ZeroDivisionError) as caught:
        exec(compile("1 / 0", ROOT / "src" / "no_file.py", "exec"))
    caught.value.is_late = False
    mistake.report_endless_loop(caught.value)
    assert capsys.readouterr().err == ""
