"""The command and the file that the page gives for its cradle make the same cradle again."""

import shlex
import sys
from math import radians
from unittest.mock import Mock

import pytest
from rig import Rig
from vpython import vector
from whole_cradles import go_on, GOOD, HEADER

from src import special_cradles, visualize_cradle_run, visualize_double_cradle_run
from support.cradle.double_cradle import DoubleCradle
from support.files.experiments import EXPERIMENTS
from support.page import show_cradle
from support.page.setup import FILE, NO_RULE

BUILT_IN = str(EXPERIMENTS / "single" / "2_two_bobs.txt")
BY_FILE = f"--experiment={FILE}"


@pytest.fixture
def start(monkeypatch, tmp_path):
    """What starts a program with these words, in tmp_path; it returns the viewer of its cradle."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(show_cradle, "open_page", Mock())
    monkeypatch.setattr(show_cradle, "run", Mock())

    def start(words, kind="single"):
        monkeypatch.setattr(sys, "argv", ["", *words.split()])
        if kind == "single":
            show_cradle.show_cradle(visualize_cradle_run.main, special_cradles)
        else:
            show_cradle.show_double_cradle(visualize_double_cradle_run.main, special_cradles)
        _, viewer = show_cradle.run.call_args[0]
        viewer.next_cradle.want()
        go_on(viewer)
        return viewer

    return start


@pytest.fixture
def options_of(start, tmp_path):
    """What returns the options of the command of a rig, whose cradle has just been released.

    They make the same cradle, and the file does, too.
    """

    def options_of(rig):
        (tmp_path / FILE).write_text(rig.state["setup"])
        _, program, csv, *options = shlex.split(rig.state["same_cradle"])
        assert program.endswith(rig.cradle.page_program)
        assert ("save" in rig.state["advice"]) == (options == [BY_FILE])
        for words in (" ".join([csv, *options]), BY_FILE):
            made = start(words, rig.cradle.kind).cradle
            for key in (*made.angle_keys, "mass", "e"):
                assert made.values(key) == pytest.approx(rig.values(key), abs=1e-7)
        return " ".join(options)

    return options_of


@pytest.mark.parametrize(
    ("commands", "options"),
    [
        ([("release_angle", 77.5), ("e", 0.35)], "--angle=77.5 --lift=1 --e=0.35"),
        ([("experiment", "Two bobs")], f"--experiment={BUILT_IN}"),
        ([("experiment", "Two bobs"), ("e", 0.5)], BY_FILE),
        ([("edit", 1, "mass", "0.1"), ("lifted", 2)], BY_FILE),
    ],
)
def test_the_command_and_the_file_make_the_same_cradle(options_of, rig, commands, options):
    rig.give("pause")
    for command in commands:
        rig.give(*command)
    rig.give("restart")
    assert options_of(rig) == options


def test_the_csv_is_that_of_the_cradle_or_no_options_make_it(options_of, rig):
    rig.give("pause")
    rig.give("lifted", 5)
    rig.save(HEADER + GOOD * 2)
    assert options_of(rig) == "--angle=30 --lift=2"
    rig.save("mistake")
    assert rig.state["same_cradle"].endswith(BY_FILE)
    rig.give("separating", True)
    assert rig.state["advice"].startswith(NO_RULE)


def test_the_double_cradle_has_phi(options_of, csv):
    assert options_of(Rig(csv, 77, -20, kind=DoubleCradle)) == "--angle=77 --phi=-20 --lift=1"


def test_a_bob_that_was_let_go_begins_there(options_of, rig):
    rig.wait(0.1)
    rig.give("pause")
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    rig.mouse("drag", rig.cradle.axles()[4].pos + vector(1, 0, 0))
    rig.give("let_go")
    assert rig.thetas()[4] == pytest.approx(radians(90))
    assert options_of(rig) == BY_FILE
    rig.give("restart")
    assert options_of(rig) == "--angle=30 --lift=1"


def test_ghosts_of_a_file_leave_an_experiment_as_it_is(start, tmp_path):
    (tmp_path / "film.csv").write_text("start,0,-20\nt,theta_1\n0,1\n")
    viewer = start(f"--experiment {BUILT_IN} --ghosts film.csv")
    assert viewer.chooser.whole_experiment()


def test_an_experiment_by_its_file_takes_the_place_of_one_with_its_name(start, tmp_path):
    """Without a question, nothing is asked."""
    viewer = start("--mass 0.1")
    assert viewer.setup.state()["same_cradle"].endswith("run.py --mass=0.1")
    names = viewer.chooser.names()
    (tmp_path / "two.txt").write_text("name = Two bobs\ntheta = 0 -10")
    for path, count in ((BUILT_IN, 5), ("two.txt", 2)):
        viewer = start(f"--experiment {path}")
        viewer.lesson.set_ask_first(True)
        go_on(viewer)
        assert (viewer.chooser.name(), viewer.chooser.names()) == ("Two bobs", names)
        assert len(viewer.cradle.pend_list) == count
        assert bool(viewer.questions.asking) == (path == BUILT_IN)
