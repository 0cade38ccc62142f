"""A starter in which a student has written some functions: what its programs show and say."""

import pytest
from programs import python, slow_except
from students import change, NO_CRADLE, STAGES, write, write_next, write_tiers

from grading.assignment import PROGRAM, SPECIAL, SWINGING, VISUALIZE_FILE

TERMINAL = "src/text_cradle_run.py"


def test_without_a_cradle_the_next_function_is_named(starter):
    write(starter, "extract_and_convert", PROGRAM)
    done = python(TERMINAL, folder=starter)
    message = f"{NO_CRADLE}{write_next(starter, 'uniform_mass_newton_cradle')}\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", message)


@pytest.mark.parametrize("written", slow_except(["DCB"], STAGES))
def test_the_terminal_shows_as_much_as_is_written(starter, written):
    function, sight, bob, angle = STAGES[written]
    tiers, *functions = written.split(" ")
    write_tiers(starter, tiers)
    write(starter, *functions)
    done = python(TERMINAL, "--seconds=0.5", folder=starter)
    assert (done.returncode, done.stderr) == (0, "")
    first, *_, last = done.stdout.splitlines()
    if function:
        assert first == f"{write_next(starter, function)} {sight}"
    else:
        assert first.startswith("   t (s)")
    _, _, _, *angles = last.split()  # behind the time and the energy in %
    assert float(angles[bob]) == pytest.approx(angle, abs=0.5)


# What is written, a change to it, the status, and what is printed then
MISTAKES = {
    "in a function that the cradle does not need": (
        ("D", SPECIAL, "pend['mass'] = mass", "pend.mass = mass"),
        (0, "Write next: angle_update "),
    ),
    "in what this returns": (
        ("DCB", SPECIAL, "pend['objects'] =", "objects ="),
        (1, "make_newton_cradle set objects of pendulum 1 to nothing"),
    ),
    "while a file is imported": (
        ("D", SWINGING, "from math", "raise NotImplementedError('later')\nfrom math"),
        (1, "NotImplementedError: later"),
    ),
}


@pytest.mark.parametrize("mistake", slow_except(["in what this returns"], MISTAKES))
def test_a_mistake_is_shown_only_if_the_cradle_needs_its_line(starter, mistake):
    (tiers, file, before, after), (status, words) = MISTAKES[mistake]
    write_tiers(starter, tiers)
    change(starter / file, before, after)
    done = python(TERMINAL, "--seconds=0.1", folder=starter)
    assert done.returncode == status
    printed = done.stderr.splitlines()[-2] if status else done.stdout  # the last line is advice
    assert printed.startswith(words)
    assert "another exception" not in done.stderr


def test_a_program_without_an_import_shows_which_function_is_next(starter):
    change(starter / VISUALIZE_FILE, "from src.swinging import full_swing_update\n", "")
    done = python(TERMINAL, folder=starter)
    message = f"{NO_CRADLE}{write_next(starter, 'extract_and_convert')}\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", message)
