"""The programs, as far as they need no browser: how they start, and what they print."""

import os
from unittest.mock import Mock

import pytest
from programs import call, copy_project, python, ROOT, with_vpython
from students import put_files

import pds_tester
from grading.cradles import MIXED, MIXED_CSV
from support.pendulum import outwards_to_angle
from support.start.end import SignalError
from support.start.mistake import TYPE_PYTEST

TEXT = "src/text_cradle_run"
PAGES = "src/visualize_cradle_run", "src/visualize_double_cradle_run"


@pytest.mark.parametrize(
    ("program", "hidden"),
    [
        ("pds_tester", "vpython"),
        (TEXT, "vpython"),
        pytest.param(PAGES[0], "pandas", marks=with_vpython),
        pytest.param(PAGES[1], "pandas", marks=with_vpython),
    ],
)
def test_a_program_finds_its_own_project_from_any_folder_and_refuses_in_one_line(
    tmp_path, program, hidden
):
    """It needs no VPython, or it has a page and no pandas so early.

    VPython's server does not start so early either: it would wait for a browser.
    """
    project = copy_project(tmp_path / "100% ü #1", "")
    folder = put_files(tmp_path / "hiding", {f"{hidden}.py": "raise ImportError"})
    link = tmp_path / "link"
    link.symlink_to(project)
    done = python(link / f"{program}.py", folder=os.sep, PYTHONPATH=str(folder))
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith(f"{project / 'newton_cradle_pends.csv'}: is empty, ")


def test_the_benchmark_finds_its_own_project_and_has_help():
    done = python(ROOT / "tests" / "benchmark.py", "--help", folder=os.sep)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("usage: benchmark.py ")


OTHER = """
import pkg_resources
pkg_resources.get_distribution = lambda name: pkg_resources.Distribution(version='7.6.4')
import begin_page
"""


@with_vpython
def test_another_vpython_is_named():
    done = python("-W", "ignore", "-c", OTHER, PYTHONPATH=str(ROOT / "src"))
    assert done.returncode == 1
    assert "the page needs another VPython than 7.6.4 in " in done.stderr.splitlines()[-1]


def test_ctrl_c_at_the_imports_of_a_program_prints_nothing():
    does = "from support.start.program import begin; begin(); import signal; "
    done = python("-c", does + "signal.raise_signal(signal.SIGINT)")
    assert (done.returncode, done.stderr) == (0, "")


DRAWN = """
import begin
from support.page.vpython_inside import draw_without_its_page
draw_without_its_page()
from vpython import *
sphere().clone()
rate(1e-9)
sleep(1e9)
for refused in {refused}.split():
    try:
        eval(refused)
    except RuntimeError:
        print(refused)
"""
REFUSED = """
text(text='a') compound([box()]) extrusion(path=[],shape=[]) graph() gcurve() slider(bind=abs)
scene.waitfor('click') scene.pause() scene.mouse.pick
curve() points() attach_trail(box()) box(make_trail=True) setattr(box(),'make_trail',True)
"""


@with_vpython
def test_a_program_with_a_page_draws_shapes_and_refuses_all_for_which_vpython_would_wait():
    code = DRAWN.format(refused=repr(REFUSED))
    done = python("-W", "ignore", "-c", code, PYTHONPATH=str(ROOT / "src"))
    assert (done.returncode, done.stdout.split(), done.stderr) == (0, REFUSED.split(), "")


def test_pds_tester_shows_each_step(csv, monkeypatch, capsys):
    csv.write_text(MIXED_CSV)
    monkeypatch.setattr(pds_tester, "NC_FP", str(csv))
    pds_tester.main()
    df, bad_rep, pend_list = [block.splitlines() for block in capsys.readouterr().out.split("\n\n")]
    assert df[0].startswith("df: ")
    assert len(df[1:]) == 1 + 3  # a header, three pendula
    assert bad_rep[1:] == [f"  {row}: {pend}" for row, pend in enumerate(MIXED)]
    assert pend_list[1:] == [f"  {pend}" for pend in MIXED]


@pytest.mark.parametrize(
    ("error", "status", "words"),
    [
        (SignalError(0), 0, "does a loop in extract_and_convert never end?\n"),
        (KeyError("mas"), 1, f"\nKeyError: 'mas'\n{TYPE_PYTEST}\n"),
    ],
)
def test_pds_tester_names_a_mistake(monkeypatch, capsys, error, status, words):
    monkeypatch.setattr("src.pds_helper.pd", Mock(**{"read_csv.side_effect": error}))
    ended, _, stderr = call(pds_tester.main, capsys)
    assert ended == status
    assert stderr.endswith(words)


def test_a_program_does_as_the_options_say(start):
    line = "--angle 25 --phi=-12.5 --lift 2 --host 0.0.0.0 --port 8000 --no-browser"
    page = start("double", line)
    assert page.place == ("0.0.0.0", 8000)
    assert not page.browser
    state = page.viewer.state()
    assert state["title"] == "Newton's double cradle"
    assert state["remark"] == ""
    assert page.viewer.cradle.values("theta") == [outwards_to_angle(25)] * 2 + [0]
    assert page.viewer.cradle.values("phi") == [outwards_to_angle(-12.5)] * 2 + [0]


def test_a_program_of_single_pendula_has_one_angle_and_ghosts(start, tmp_path):
    ghosts = tmp_path / "film.csv"
    ghosts.write_text("t,theta_1\n0,1\n")
    page = start("single", f"--angle 20 --ghosts {ghosts}")
    assert page.viewer.cradle.values("theta") == [outwards_to_angle(20), 0, 0]
    assert page.viewer.ghost_file.name == "film.csv"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("--lift 4", "--lift: found '4', allowed is at most 3, "),
        ("--ghosts no.csv", "no.csv: cannot be read: "),
    ],
)
def test_a_program_refuses_in_one_line_before_a_page_opens(start, capsys, line, message):
    status, stdout, stderr = call(lambda: start("single", line), capsys)
    assert (status, stdout, stderr.count("\n")) == (2, "", 1)
    assert stderr.startswith(message)


def test_a_program_says_why_it_is_slow_if_no_function_has_changed(tmp_path):
    profiler = ("-m", "cProfile", "-o", tmp_path / "profile")
    done = python(*profiler, "src/text_cradle_run.py", "--seconds", 0.01)
    assert done.stdout.startswith("A debugger, a tracer or a profiler watches each call. So ")
