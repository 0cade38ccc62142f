"""A starter in which a student has written some functions: its grade, and what its programs say."""

import os
import re
from math import degrees

import pandas as pd
import pytest
from programs import python, slow_except, with_vpython
from students import change, COUNTS, graded_in, write, write_tiers

from grading.grader import checks
from grading.handout import FUNCTIONS


def failed_in(result):
    """Return how many checks have failed, by tier."""
    return {tier: counts["failed"] for tier, counts in result["tiers"].items()}


def test_a_half_written_project(starter):
    """D is there, angle_update and handle_collision raise errors, and others are stubs."""
    angle_checks = len(checks(function="angle_update"))
    hit_checks = len(checks(function="handle_collision"))
    write_tiers(starter, "DC")
    change(starter / "src/swinging.py", "theta + omega_new * dt", "theta + omega_neu * dt")
    write(starter, "handle_collision", handle_collision='return int("m1")')
    result = graded_in(starter)
    failed = {"D": 0, "C": angle_checks, "B": hit_checks, "A": 0, "Honor roll": 0}
    assert failed_in(result) == failed
    assert result["grade"] == "D"
    assert result["next"].startswith("angle_update ")
    assert f"{COUNTS['C'] - angle_checks} wait for angle_update" in "\n".join(result["text"])


def test_files_that_cannot_be_imported_fail_and_the_files_that_import_them_wait(starter):
    write(starter, *FUNCTIONS)
    change(starter / "src/special_cradles.py", "from src.pds", "from pds")
    change(starter / "src/swinging.py", "in pend_list:", "in pend_list")
    result = graded_in(starter)
    assert failed_in(result) == {"D": 1, "C": 1, "B": 0, "A": 0, "Honor roll": 0}
    assert re.fullmatch(r"src/special_cradles.py, line \d+", result["next"])
    assert "ModuleNotFoundError: No module named 'pds_helper'" in result["text"]


TERMINAL = "src/text_cradle_run.py"
DOUBLE = "src/visualize_double_cradle_run.py"
# The program of the page prints only the remark that it would show.
PAGE = """
import runpy, sys
from unittest.mock import Mock
import grading.begin
sys.modules["begin_page"] = Mock()
from support.page import show_cradle
show_cradle.show_page = lambda *given: print(given[-1])
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


@pytest.mark.parametrize("written", slow_except(["two functions", "DCB"], STAGES))
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
