"""What is written is what runs: each change to a function shows in the programs, and a mistake in one is told of."""

import csv
import json
import re
import subprocess
import sys
from itertools import product

import pytest
from programs import copy_project, end, first_lines, needs_vpython, running, SECONDS, slow_but_for
from whole_cradles import FIVE_CSV

# A plain loop over the handout's functions, with the state after 0, 0.05, 0.1, ... s; and then the program itself.
LOOP = """
import json, runpy, sys
from support import headless_vpython
headless_vpython.install()
from src import visualize_cradle_run as run
from support.constants import DT, G, NC_FP, R_PARAM, THETA_INIT

rule = {"approaching_only": True} if "rule" in sys.argv else {}
pend_list = run.make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
rows = []
for _ in range(13):
    rows.append([pend[key] for key in ("theta", "omega") for pend in pend_list])
    for _ in range(round(0.05 / DT)):
        run.newton_cradle_tick(pend_list, R_PARAM, DT, G, **rule)
print(json.dumps(rows))
sys.argv[1:] = ["--record", "data.csv", "--seconds", "0.6", "--every", "0.05"]
runpy.run_path("src/text_cradle_run.py", run_name="__main__")
"""

LOSSY_CSV = FIVE_CSV.replace("1.0,1.0", "1.0,0.9")  # so that the two rules differ

SWINGING, RUN, SPECIAL = "swinging.py", "visualize_cradle_run.py", "special_cradles.py"
TICK = "    full_swing_update(pend_list, r_param, dt, g)\n    rule"
NO_RULE = [
    ("def newton_cradle_tick(pend_list, r_param, dt, g, approaching_only=False)", "def newton_cradle_tick(pend_list, r_param, dt, g)"),
    ('    rule = {"approaching_only": True} if approaching_only else {}  # works with a handle_two_bobs without this parameter\n', ""),
    ("handle_two_bobs(pend1, pend2, r_param, **rule)", "handle_two_bobs(pend1, pend2, r_param)"),
]  # fmt: skip

# Changes to one function each: its file, and what is replaced by what.
CHANGES = {
    "nothing": (RUN, []),
    "air resistance in the tick": (RUN, [(TICK, "    for pend in pend_list:\n        pend['omega'] *= 0.9999\n" + TICK)]),
    "a wall": (RUN, [(TICK, "    if pend_list[4]['theta'] > 0.3: pend_list[4]['omega'] = -abs(pend_list[4]['omega'])\n" + TICK)]),
    "no collisions": (RUN, [("        handle_two_bobs(pend1, pend2, r_param, **rule)", "        pass")]),
    "no buffer": (RUN, [("> BUFFER *", "> 0.9 *")]),
    "a weaker hit": (RUN, [("return v1_new / r_param, v2_new / r_param", "return v1_new / r_param, 0.9 * v2_new / r_param")]),
    "a sum in another order": (RUN, [("v1_new / r_param, v2_new", "v1_new / r_param, (v2_new - 1) / r_param + 1 / r_param #")]),
    "the handout's parameters": (RUN, NO_RULE),
    "twice the ticks": (RUN, [(TICK, "    full_swing_update(pend_list, r_param, dt, g)\n" + TICK)]),
    "a wind": (SWINGING, [("* dt\n    theta_new", "* dt + 0.001\n    theta_new")]),
    "the old omega": (SWINGING, [("theta + omega_new * dt", "theta + omega * dt")]),
    "all bobs in one place": (SWINGING, [("    show_pendulum(pend_dict, r_param)\n", "    show_pendulum(pend_dict, r_param)\n    pend_dict['objects'][1].pos = pend_dict['objects'][2].axis\n")]),
    "all but the first swing": (SWINGING, [("for pend_dict in pend_list:\n        swing_update", "for pend_dict in pend_list[1:]:\n        swing_update")]),
    "all lifted": (SPECIAL, [("theta_init if i == 0 else 0", "theta_init / (i + 1)")]),
    "all moving": (SPECIAL, [('pend_dict["omega"] = 0', 'pend_dict["omega"] = -1.5')]),
    "further apart": (SPECIAL, [("r_param / 4 * i", "r_param / 3 * i")]),
}  # fmt: skip


@pytest.fixture
def project(tmp_path):
    return copy_project(tmp_path, LOSSY_CSV)


def change(project, file, replacements):
    path = project / "src" / file
    text = path.read_text()
    for before, after in replacements:
        assert before in text, before
        text = text.replace(before, after)
    path.write_text(text)


def start(project, *arguments):
    command = [sys.executable, *map(str, arguments)]
    return subprocess.run(command, cwd=project, capture_output=True, text=True, timeout=SECONDS)


def plain_and_recorded(project, name):
    """Return the states of a plain loop and those that the program records, with this change."""
    change(project, *CHANGES[name])
    done = start(project, "-c", LOOP, *([] if CHANGES[name][1] == NO_RULE else ["rule"]))
    assert (done.returncode, done.stderr) == (0, "")
    with open(project / "data.csv") as file:
        _, *rows = csv.reader(file)
    return json.loads(done.stdout.splitlines()[0]), [[float(cell) for cell in row[1:11]] for row in rows]


@pytest.fixture(scope="module")
def shipped(tmp_path_factory):
    """What is recorded without any change."""
    return plain_and_recorded(copy_project(tmp_path_factory.mktemp("shipped"), LOSSY_CSV), "nothing")[1]


@pytest.mark.parametrize("name", slow_but_for(["nothing", "air resistance in the tick"], CHANGES))
def test_what_is_recorded_is_what_a_plain_loop_does_to_the_last_bit(project, shipped, name):
    plain, recorded = plain_and_recorded(project, name)
    assert recorded == plain
    assert len(recorded) == 13
    assert (recorded == shipped) == (name == "nothing")  # or the change would prove nothing


# --- mistakes --------------------------------------------------------------------------------------------------------

# A change, what stderr ends with: the student's file, line and text, and the error.
MISTAKES = {
    "a name": (
        *(SWINGING, [("omega_new = omega -", "omega_new = omegaa -")]),
        ["swinging.py", "in angle_update", "omega_new = omegaa - g * sin(theta) / r_param * dt", "NameError: name 'omegaa'"],
    ),
    "raised in the tick": (
        *(RUN, [(TICK, "    raise ValueError('no')\n" + TICK)]),
        ["visualize_cradle_run.py", "in newton_cradle_tick", "raise ValueError('no')", "ValueError: no"],
    ),
    "too few arguments": (
        *(RUN, [("handle_two_bobs(pend1, pend2, r_param, **rule)", "handle_two_bobs(pend1)")]),
        ["visualize_cradle_run.py", "in newton_cradle_tick", "handle_two_bobs(pend1)", "TypeError: handle_two_bobs() missing 2"],
    ),
    "support is given something wrong": (
        *(SPECIAL, [('COLOR_MAP[pend_dict["color"]]', 'pend_dict["color"]')]),
        ["special_cradles.py", "in make_newton_cradle", "pend_dict", "AttributeError: color must be a vector"],
    ),
    "a file of the student's own": (
        *(SWINGING, [("    omega_new = omega -", "    open('none.txt')\n    omega_new = omega -")]),
        ["swinging.py", "in angle_update", "open('none.txt')", "FileNotFoundError: [Errno 2] No such file or directory: 'none.txt'"],
    ),
    "no return": (
        *(SPECIAL, [('texture)\n    return pend_list\n', "texture)\n")]),
        ["special_cradles.py", "in make_newton_cradle", "def make_newton_cradle(relative_filepath, r_param, theta_init)",
         "make_newton_cradle returned None; it must return a list of dictionaries. Is a return missing?"],
    ),
    "no number": (
        *(RUN, [("    for pend1, pend2 in pairwise", "    pend_list[0]['theta'] = float('nan')\n    for pend1, pend2 in pairwise")]),
        ["visualize_cradle_run.py", "in newton_cradle_tick", "def newton_cradle_tick(pend_list",
         "newton_cradle_tick set theta of pendulum 1 to nan; it must be a finite number."],
    ),
    "a pendulum too few": (
        *(RUN, [("    for pend1, pend2 in pairwise", "    pend_list[4:] = []\n    for pend1, pend2 in pairwise")]),
        ["visualize_cradle_run.py", "in newton_cradle_tick", "def newton_cradle_tick(pend_list",
         "newton_cradle_tick made 4 pendula from 5; it must keep their number."],
    ),
    "exit": (
        *(RUN, [(TICK, "    exit()\n" + TICK)]),
        ["visualize_cradle_run.py", "in newton_cradle_tick", "exit()", "SystemExit"],
    ),
    "no cradle shown": (
        *(RUN, [("            page.show(pend_list)\n", "")]),
        ["visualize_cradle_run.py", "in main", "def main(page)", "main showed no cradle when page.wants_cradle() was True: page.show is missing."],
    ),
    "ticks without being asked": (
        *(RUN, [("        while page.wants_tick():  # in step with the clock\n", "        if pend_list:\n")]),
        ["visualize_cradle_run.py", "in main", "def main(page)", "main did not call page.wants_tick() when ticks"],
    ),
    "a loop that ends": (
        *(RUN, [("    while page.is_running():", "    if page.is_running():")]),
        ["visualize_cradle_run.py", "in main", "def main(page)", "main ended, but the simulation still runs."],
    ),
}  # fmt: skip


PLAYED, RECORDED = ("--seconds", "1"), ("--record", "data.csv", "--seconds", "1")
SOME = [("a name", PLAYED), ("a name", RECORDED), ("no return", PLAYED)]


@pytest.mark.parametrize(("name", "options"), slow_but_for(SOME, product(MISTAKES, (PLAYED, RECORDED))))
def test_a_mistake_ends_the_program_with_the_students_line_last(project, name, options):
    file, replacements, (place, function, line, error) = MISTAKES[name]
    change(project, file, replacements)
    done = start(project, "src/text_cradle_run.py", *options)
    *_, where, text, last = [said for said in done.stderr.splitlines() if not re.fullmatch(r"[ ^~]+", said)]
    assert done.returncode == 1
    assert place in where
    assert function in where
    assert line in text
    assert last.startswith(error)
    assert "support" not in done.stderr
    assert not (project / "data.csv").exists()


def test_a_mistake_of_the_projects_own_is_told_of_in_full(project):
    """It is none of the student's."""
    path = project / "support" / "playback" / "motion.py"
    path.write_text(
        path.read_text().replace("        return round(self.ticks", "        1 / 0\n        return round(self.ticks")
    )
    done = start(project, "src/text_cradle_run.py", "--seconds", "0.1")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == "ZeroDivisionError: division by zero"
    assert "motion.py" in done.stderr


def test_an_output_that_cannot_be_written_is_no_mistake(project):
    done = start(project, "src/text_cradle_run.py", "--record", "none/data.csv", "--seconds", "1")
    assert (done.returncode, done.stderr) == (2, "none/data.csv: cannot be written: No such file or directory\n")


class TestOnThePage:
    pytestmark = needs_vpython

    def test_the_page_says_that_the_program_has_ended_and_why(self, page, project):
        """The mistake comes after a while. The page greys out the cradle."""
        change(
            project,
            SWINGING,
            [("    omega_new = omega -", "    omegaa if theta > 0.1 else 0\n    omega_new = omega -")],
        )
        with running(project / "src" / "visualize_cradle_run.py") as process:
            page.goto(first_lines(process))
            status, _, stderr = end(process)
        assert status == 1
        assert "support" not in stderr
        assert stderr.splitlines()[-1].startswith("NameError: name 'omegaa' is not defined")
        said = page.locator(".error").inner_text()
        assert said.startswith("The program has ended. NameError: name 'omegaa' is not defined")
        assert "(src/swinging.py, line 14)" in said
        page.get_by_text("To start it again, type this command").wait_for()
        assert page.locator(".notice").count() == 0
        opacity = "() => getComputedStyle(document.querySelector('.glowscript-canvas-wrapper')).opacity"
        assert float(page.evaluate(opacity)) < 0.5

    def test_a_cradle_that_is_none_is_told_of_in_the_same_way(self, page, project):
        file, replacements, (*_, error) = MISTAKES["no return"]
        change(project, file, replacements)
        with running(project / "src" / "visualize_cradle_run.py") as process:
            page.goto(first_lines(process))
            status, _, stderr = end(process)
        assert (status, stderr.splitlines()[-1]) == (1, error)
        assert page.locator(".error").inner_text().startswith(f"The program has ended. {error}")
