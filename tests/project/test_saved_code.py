"""Saved code runs on the open page. These tests share one page, and save change after change."""

import programs
import pytest
from pages import bob_angles, new_page, open_cradle, press, readout, slider_texts, wait_for_moves
from programs import wait_until
from students import change
from whole_cradles import FIVE_CSV

pytestmark = [
    pytest.mark.browser,
    *programs.needs_vpython,
    pytest.mark.xdist_group("saved_code"),
]

RUN = "src/visualize_cradle_run.py"
SWINGING = "src/swinging.py"
SPECIAL = "src/special_cradles.py"
HELPER = "src/pds_helper.py"
CSV = "newton_cradle_pends.csv"
QUICK = {  # shorter times, as these tests wait for them again and again
    "support/files/source_files.py": ("QUIET = 0.5", "QUIET = 0.1"),
    "support/page/endless.py": ("TOO_LONG = 3.0", "TOO_LONG = 2.0"),
}


class Open:
    """An open page, and the files of its program."""

    def __init__(self, page, folder):
        self.page = page
        self.folder = folder
        self.texts = {
            name: (folder / name).read_text() for name in (RUN, SWINGING, SPECIAL, HELPER, CSV)
        }

    def save(self, *changes):
        """Save the files as they were, but with these changes: a file, a text in it, a new one."""
        texts = {**self.texts}
        for name, before, after in changes:
            assert before in texts[name]
            texts[name] = texts[name].replace(before, after)
        for name, text in texts.items():
            if (self.folder / name).read_text() != text:
                (self.folder / name).write_text(text)

    def wait_for_text(self, text):
        self.page.get_by_text(text).wait_for()

    def mend(self):
        """Save the files as they were: the page shows no mistake any more, and swings."""
        self.save()
        shown = self.page.locator(".messages p:visible")
        wait_until(lambda: shown.count() == 0)
        wait_for_moves(self.page)


@pytest.fixture(scope="module")
def opened(chromium, tmp_path_factory):
    folder = programs.copy_project(tmp_path_factory.mktemp("saved"), FIVE_CSV)
    for name, (before, after) in QUICK.items():
        change(folder / name, before, after)
    with programs.running(folder / RUN, folder=folder) as process, new_page(chromium) as page:
        open_cradle(page, programs.first_lines(process))
        yield Open(page, folder)


def written(cradle):
    """Return a change of the program: it writes this cradle to its CSV before it makes its own."""
    make = "    pend_list = make"
    lines = ["from src.pds_helper import *", "from src.special_cradles import *"]
    block = "".join(f"    {line}\n" for line in [*lines, f"write_to_csv({cradle})"])
    return RUN, make, block + make


def have_count(count):
    return lambda page: len(bob_angles(page)) == count


def are_at(*expected):
    return lambda page: bob_angles(page) == pytest.approx(expected, abs=0.2)


def only_three_collide(page):
    angles = bob_angles(page)
    return angles[3:] == pytest.approx([0, 0], abs=0.2) and angles[2] > 20


def have_texts(**texts):
    return lambda page: slider_texts(page, *texts) == [*texts.values()]


CHANGES = {  # of functions of each file of the assignment, and of the block; and what they show
    "extract_and_convert": (
        have_count(3),
        (HELPER, "(bad_rep.values())", "(bad_rep.values())[:3]"),
    ),
    "write_to_csv": (
        have_count(2),
        written("elastic_newton_cradle(NC_FP)"),
        (HELPER, "pd.DataFrame(pend_list,", "pd.DataFrame(pend_list[:2],"),
    ),
    "uniform_mass_newton_cradle": (
        have_texts(mass="4 kg, set by the program"),
        written("uniform_mass_newton_cradle(NC_FP, 2.0)"),
        (SPECIAL, '["mass"] = mass', '["mass"] = 2 * mass'),
    ),
    "make_newton_cradle": (
        are_at(*[-20] * 5),
        (SPECIAL, "theta_init if i == 0 else 0", "-pi / 9"),
        (SPECIAL, "from vpython", "from math import pi\nfrom vpython"),
    ),
    "angle_update": (are_at(*[-30] * 5), (SWINGING, "omega_new, theta_new\n", "0.0, -0.5236\n")),
    "full_swing_update": (
        lambda page: bob_angles(page)[0] < -50,
        (
            SWINGING,
            "  swing_update(pend_dict, r_param, dt, g",
            "  swing_update(pend_dict, r_param, dt, -g",
        ),
    ),
    "handle_collision": (
        lambda page: readout(page, "t") > 0.5 and are_at(*[0] * 5)(page),
        (RUN, "return v1_new / r_param, v2_new / r_param", "return 0.0, 0.0"),
    ),
    "newton_cradle_tick": (
        only_three_collide,
        (RUN, "pairwise(pend_list)", "pairwise(pend_list[:3])"),
    ),
    "handle_two_bobs": (
        lambda page: bob_angles(page)[1] > 25,
        (RUN, "    omega1, omega2 = pend1", '    pend2["theta"] = 0.5\n    omega1, omega2 = pend1'),
    ),
    "the block": (
        lambda page: bob_angles(page)[0] < -60,
        (RUN, "R_PARAM, THETA_INIT)", "R_PARAM, -1.2)"),
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_saved_change_of_a_function_shows(opened, name):
    is_seen, *changes = CHANGES[name]
    assert not is_seen(opened.page)
    opened.save(*changes)
    wait_until(lambda: is_seen(opened.page))


RATE = """while True:
        try:
            rate(1 / DT)
            newton_cradle_tick(pend_list, R_PARAM, DT, G)
        except:
            pass
    while False:"""
MISTAKES = {  # changes that end the motion, and what the page says
    "a mistake": (
        "NameError: name 'pull' is not defined (src/swinging.py, line 18: omega_new = omega - pull "
        "* sin(theta) / r_param * dt). Mend it, and save the file; pytest says more.",
        (SWINGING, "- g *", "- pull *"),
    ),
    "an endless loop": (
        "src/swinging.py, line 37: the program has been here for 2 s.",
        (SWINGING, "in pend_list:\n", "in pend_list:\n        while True: pass\n"),
    ),
    "the end": (
        "The program has come to its end. Restart runs it again.",
        (RUN, "while is_running(pend_list)", "for _ in range(100)"),
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_what_stops_the_cradle_is_named_and_the_next_save_goes_on(opened, name):
    words, *changes = MISTAKES[name]
    opened.save(*changes)
    opened.wait_for_text(words)
    opened.mend()


def test_a_file_that_cannot_be_compiled_lets_the_cradle_swing_on(opened):
    opened.save((SWINGING, "- g *", "- g * ("))
    opened.wait_for_text("Saved, but not run: src/swinging.py, line 18: '(' was never closed.")
    wait_for_moves(opened.page)
    opened.mend()


def test_a_loop_that_catches_its_end_ends_all_the_same(opened):
    opened.save(
        (RUN, "from vpython import", "from vpython import rate,"),
        (RUN, "while is_running(pend_list):", RATE),
    )
    wait_until(lambda: readout(opened.page, "t") > 1)
    press(opened.page, "Restart")
    wait_until(lambda: readout(opened.page, "t") < 1)
    opened.mend()
