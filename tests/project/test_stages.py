"""A starter in which a student has written some functions: what its programs show and say."""

import signal

import pytest
from pages import bob_angles, wait_for_cradle
from programs import end, first_lines, python, running, slow_except, wait_until
from students import change, write, write_tiers
from whole_cradles import GOOD, HEADER

from grading.assignment import FUNCTIONS, PROGRAM, SPECIAL, SWINGING, VISUALIZE_FILE

TERMINAL = "src/text_cradle_run.py"
NO_CRADLE = "There is no cradle to see yet. "


def write_next(starter, function) -> str:
    """Return the sentence that names this function, which is not written yet."""
    file = FUNCTIONS[function].file
    source, stub, _ = (starter / file).read_text().partition(f'("{function} is not written yet")')
    assert stub
    line = 1 + source.count("\n")
    return f"Write next: {function} ({file}, line {line})."


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


SWING = "With tier C, the pendula swing."
COLLIDE = "With tier B, two bobs collide. If no pendulum swings, type pytest."
TWO = "Here are the first two pendula alone: their bobs collide. If not, type pytest."
TICK = "Here, newton_cradle_tick moves all pendula. If it does not, type pytest."
# The tiers and functions that are written, the next function, what one sees, and where a bob (an
# index) is after half a second, in degrees
STAGES = {
    " extract_and_convert make_newton_cradle": ("uniform_mass_newton_cradle", SWING, 0, -45),
    "D": ("angle_update", SWING, 0, -45),
    "D full_swing_update": ("angle_update", SWING, 0, -45),
    "DC": ("handle_collision", COLLIDE, 0, 44),
    "DC handle_two_bobs": ("handle_collision", COLLIDE, 0, 44),
    "DCB": ("newton_cradle_tick", TWO, 1, 44),
    "DCB newton_cradle_tick": (PROGRAM, TICK, 4, 44),
    "DCBA": ("", "", 4, 44),
}


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


def test_in_one_open_page_the_cradle_grows_with_each_save(starter, page):
    with running(starter / VISUALIZE_FILE, folder=starter) as process:
        page.goto(first_lines(process))
        unwritten = f"{NO_CRADLE}{write_next(starter, 'extract_and_convert')}"
        remark = page.get_by_text(unwritten)
        remark.wait_for()
        for tier, stage, bobs in [("D", "D", 5), ("C", "DC", 5), ("B", "DCB", 2), ("A", "DCBA", 5)]:
            write_tiers(starter, tier)
            remark.wait_for(state="hidden")
            wait_for_cradle(page, bobs)
            function, sight, bob, angle = STAGES[stage]
            top = pytest.approx(angle, abs=10)
            wait_until(lambda bob=bob, top=top: bob_angles(page)[bob] == top)
            if function:
                remark = page.get_by_text(f"{write_next(starter, function)} {sight}")
                remark.wait_for()
        process.send_signal(signal.SIGINT)
        assert end(process) == (0, f"{unwritten}\n", "")
