"""The programs, as far as they need no browser: pds_tester.py, importing the viewer, and what its main does."""

import os
import subprocess
import sys
from contextlib import contextmanager
from importlib.machinery import PathFinder
from types import SimpleNamespace

import pytest
from cradles import components, copy_project, MIXED, MIXED_CSV, ROOT

from src import visualize_cradle_run
from src.special_cradles import make_newton_cradle
from support.constants import DT, G, R_PARAM, THETA_INIT


@pytest.fixture
def run(tmp_path):
    """A function that runs Python in another folder, with no VPython to be found."""
    (tmp_path / "vpython.py").write_text("raise ModuleNotFoundError('VPython is not installed')\n")

    def run(*arguments):
        environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
        return subprocess.run([sys.executable, *arguments], cwd=os.sep, env=environment, capture_output=True, text=True)

    return run


def test_pds_tester_shows_each_step_without_vpython(run, tmp_path):
    done = run(str(copy_project(tmp_path, MIXED_CSV) / "pds_tester.py"))
    assert (done.returncode, done.stderr) == (0, "")
    blocks = [block.splitlines() for block in done.stdout.split("\n\n")]
    assert [block[0].partition(":")[0] for block in blocks] == ["df", "bad_rep", "pend_list"]
    assert [len(block) for block in blocks] == [1 + 1 + 3, 1 + 3, 1 + 3]  # what it is, df's header, three pendula
    assert [block[-1].strip() for block in blocks[1:]] == [f"2: {MIXED[-1]}", str(MIXED[-1])]


def test_pds_tester_refuses_what_is_no_csv(run, tmp_path):
    done = run(str(copy_project(tmp_path, "") / "pds_tester.py"))
    file = tmp_path / "newton_cradle_pends.csv"
    line = f"{file}: is empty, the first line must name the columns\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", line)


@pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed")
def test_importing_the_viewer_starts_nothing():
    """With VPython itself: its server's module is not even loaded, and there is no word on the screen."""
    program = "import sys, src.visualize_cradle_run; sys.exit('vpython.no_notebook' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_main_ticks_the_cradle_of_the_csv_in_real_time(tmp_path, monkeypatch):
    """It opens the page, builds the cradle, adds the scenery, and runs ticks in which only approaching bobs hit."""
    steps = []
    page, scenery = contextmanager(lambda port: iter([steps.append("page")])), lambda *given: steps.append(given)
    csv = copy_project(tmp_path, MIXED_CSV) / "newton_cradle_pends.csv"
    monkeypatch.setattr(visualize_cradle_run, "NC_FP", str(csv))
    monkeypatch.setattr(visualize_cradle_run, "open_page", page)
    monkeypatch.setattr(visualize_cradle_run, "keep_real_time", lambda *given: steps.append(given))
    monkeypatch.setitem(sys.modules, "support.scenery", SimpleNamespace(add_scenery=scenery))
    visualize_cradle_run.main()

    opened, (pend_list, r_param), (tick, dt) = steps
    assert (opened, r_param, dt) == ("page", R_PARAM, DT)
    expected = make_newton_cradle(str(csv), R_PARAM, THETA_INIT)
    for cradle in (pend_list, expected):  # so that the second pair touches, and parts
        cradle[1]["objects"][1].radius, cradle[1]["omega"], cradle[2]["omega"] = R_PARAM, -1.0, 1.0
    tick()
    visualize_cradle_run.newton_cradle_tick(expected, R_PARAM, DT, G, approaching_only=True)
    for pend, as_expected in zip(pend_list, expected, strict=True):
        assert (pend["theta"], pend["omega"]) == (as_expected["theta"], as_expected["omega"])
        assert components(pend["objects"][1].pos) == components(as_expected["objects"][1].pos)
    assert pend_list[2]["omega"] > 0  # as it was: by the handout's rule it would have been reversed
