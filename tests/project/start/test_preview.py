"""A starter in which a student has written some functions: what its programs show and say."""

import pytest
from programs import python, slow_except
from students import change, NO_CRADLE, STAGES, write, write_next, write_tiers
from whole_cradles import GOOD, HEADER

from grading.assignment import PROGRAM, SPECIAL, SWINGING

TERMINAL = "src/text_cradle_run.py"


@pytest.mark.parametrize(
    ("functions", "missing"),
    [
        ([], "extract_and_convert"),
        (["extract_and_convert", PROGRAM], "uniform_mass_newton_cradle"),
    ],
)
def test_without_a_cradle_the_terminal_and_the_recorder_name_the_next_function(
    starter, functions, missing
):
    write(starter, *functions)
    for options in ([], ["--record", "-", "--seconds", "1"]):
        done = python(TERMINAL, *options, folder=starter)
        message = f"{NO_CRADLE}{write_next(starter, missing)}\n"
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
    "in one that it needs": (
        ("D", SPECIAL, "pend['omega'] = 0", "pend['omega'] = 0 / 0"),
        (1, "ZeroDivisionError: division by zero"),
    ),
    "in what this returns": (
        ("DCB", SPECIAL, "pend['objects'] =", "objects ="),
        (1, "make_newton_cradle set objects of pendulum 1 to nothing"),
    ),
    "while a file is imported": (
        ("D", SWINGING, "from math", "raise NotImplementedError('later')\nfrom math"),
        (1, "NotImplementedError: later"),
    ),
    "in a function that is provided": (
        ("DCBA", SWINGING, "    show_pendulum(", "    raise NotImplementedError("),
        (1, "NotImplementedError: ("),
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


def test_one_pendulum_shows_which_function_is_next(starter):
    (starter / "newton_cradle_pends.csv").write_text(HEADER + GOOD)
    write_tiers(starter, "DC")
    write(starter, "handle_collision")
    done = python(TERMINAL, "--seconds=0.1", folder=starter)
    assert done.stdout.startswith(write_next(starter, "handle_two_bobs"))


def test_what_a_function_prints_is_printed_once(starter):
    write_tiers(starter, "D")
    change(
        starter / "src/pds_helper.py", "    pend_list = []", "    print('here')\n    pend_list = []"
    )
    done = python(TERMINAL, "--seconds=0.1", folder=starter)
    assert done.stdout.splitlines().count("here") == 1
