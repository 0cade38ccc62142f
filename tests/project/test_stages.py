"""A starter in which a student has written some functions: what its programs show and say."""

import os

import pytest
from programs import python, slow_except, with_vpython
from students import change, write, write_tiers

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
# What is written, the line above the cradle, and where a bob (an index) is after half a second, in
# degrees
STAGES = {
    "two functions": (f"Write next: {UNIFORM}; {SWING}. Then the pendula swing.", 0, -45),
    "D": (f"Write next: {SWING}. Then the pendula swing.", 0, -45),
    "DC": (f"Write next: {HITS}. Then the bobs collide.", 0, 44),
    "DCB": (
        "Write next: newton_cradle_tick, main in src/visualize_cradle_run.py. "
        "Here are the first two pendula alone: their bobs collide.",
        1,
        44,
    ),
    "DCBA": ("", 4, 44),
}


@pytest.mark.parametrize("written", slow_except(["two functions", "DCB"], STAGES))
def test_the_terminal_and_the_page_show_as_much_as_is_written(starter, written):
    remark, bob, angle = STAGES[written]
    if written == "two functions":
        write(starter, "extract_and_convert", "make_newton_cradle")
    else:
        write_tiers(starter, written)
    if "C" in written:  # below a return, it is no stub
        stub = '    raise NotImplementedError("angle_update is not written yet")\n'
        change(starter / "src/swinging.py", "theta_new)\n", f"theta_new)\n{stub}")

    def lines(*command):
        done = python(*command, folder=starter, PYTHONPATH=f"src{os.pathsep}tests")
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout.splitlines()

    first, *_, last = lines(TERMINAL, "--seconds", "0.5")
    assert first.startswith(remark or "   t (s)")
    _, _, _, *angles = last.split()  # behind the time and the energy in %
    assert float(angles[bob]) == pytest.approx(angle, abs=0.5)
    [page_remark] = lines("-c", PAGE)
    assert page_remark.startswith(remark)
    assert bool(page_remark) == bool(remark)
