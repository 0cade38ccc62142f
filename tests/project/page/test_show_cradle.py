"""A program with a page: its options, what a save does, and what stops saved code."""

import signal

import programs
import pytest
from pages import (
    new_page,
    open_cradle,
    wait_for_cradle,
    wait_for_moves,
    wait_for_throw,
)
from programs import call, end, first_lines, running, wait_until
from students import change, NO_CRADLE, STAGES, write_next, write_tiers
from whole_cradles import FIVE_CSV

from support.pendulum import outwards_to_angle

pytestmark = pytest.mark.xdist_group("saved_code")

RUN = "src/visualize_cradle_run.py"
SWINGING = "src/swinging.py"
QUICK = {  # shorter times, as these tests wait for them again and again
    "support/files/source_files.py": ("QUIET = 0.5", "QUIET = 0.1"),
    "support/page/endless.py": ("TOO_LONG = 3.0", "TOO_LONG = 2.0"),
}


class Open:
    """An open page, and the files of its program."""

    def __init__(self, page, folder):
        self.page = page
        self.folder = folder
        self.texts = {name: (folder / name).read_text() for name in (RUN, SWINGING)}

    def save(self, *changes):
        """Save the files as they were, but with these changes: a file, a text in it, a new one."""
        texts = {**self.texts}
        for name, before, after in changes:
            assert before in texts[name]
            texts[name] = texts[name].replace(before, after)
        for name, text in texts.items():
            if (self.folder / name).read_text() != text:
                (self.folder / name).write_text(text)

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
    opened.page.get_by_text(words).wait_for()
    opened.mend()


def test_a_file_that_cannot_be_compiled_lets_the_cradle_swing_on(opened):
    opened.save((SWINGING, "- g *", "- g * ("))
    words = "Saved, but not run: src/swinging.py, line 18: '(' was never closed."
    opened.page.get_by_text(words).wait_for()
    wait_for_moves(opened.page)
    opened.mend()


def test_in_one_open_page_the_cradle_grows_with_each_save(starter, page):
    """test_preview.py has the other stages."""

    def write_at_once(tiers):
        process.send_signal(signal.SIGSTOP)  # it would run what is half written
        write_tiers(starter, tiers)
        process.send_signal(signal.SIGCONT)

    with running(starter / RUN, folder=starter) as process:
        page.goto(first_lines(process))
        unwritten = f"{NO_CRADLE}{write_next(starter, 'extract_and_convert')}"
        remark = page.get_by_text(unwritten)
        remark.wait_for()
        write_at_once("D")
        wait_for_cradle(page)
        page.get_by_text(write_next(starter, STAGES["D"][0])).wait_for()
        write_at_once("CBA")
        wait_for_throw(page)
        remark.wait_for(state="hidden")
        process.send_signal(signal.SIGINT)
        assert end(process) == (0, f"{unwritten}\n", "")


EVERYBODY = "Every machine that reaches this one can open it"


def test_a_program_does_as_the_options_say(start, capsys):
    line = "--angle 25 --phi=-12.5 --lift 2 --host 0.0.0.0 --port 8000 --no-browser"
    page = start("double", line)
    assert page.place == ("0.0.0.0", 8000)
    assert EVERYBODY in capsys.readouterr().out
    assert not page.browser
    state = page.viewer.state()
    assert state["title"] == "Newton's double cradle"
    assert state["remark"] == ""
    assert page.viewer.cradle.values("theta") == [outwards_to_angle(25)] * 2 + [0]
    assert page.viewer.cradle.values("phi") == [outwards_to_angle(-12.5)] * 2 + [0]


def test_a_program_of_single_pendula_has_one_angle_and_ghosts(start, tmp_path, capsys):
    ghosts = tmp_path / "video.csv"
    ghosts.write_text("t,theta_1\n0,1\n")
    page = start("single", f"--angle 20 --ghosts {ghosts}")
    assert EVERYBODY not in capsys.readouterr().out
    assert page.viewer.cradle.values("theta") == [outwards_to_angle(20), 0, 0]
    assert page.viewer.ghost_file.name == "video.csv"


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
