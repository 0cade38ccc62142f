"""The arguments with which the page's program starts the same cradle again, with what is set on the page now."""

import sys

import pytest
from whole_cradles import FIVE_CSV, go_on, make_live

from src.beyond.live_cradle import LiveCradle
from src.beyond.live_double_cradle import LiveDoubleCradle
from support.files.live_file import LiveFile
from support.page.commands import Command
from support.page.viewer import Viewer
from support.pendulum import from_lift
from support.start.options import read_double_page_options, read_page_options

OF_CRADLES = ("elastic", "inelastic", "e", "mass")  # the options that a cradle knows


@pytest.fixture
def view(tmp_path):
    """A function that returns the viewer of a program that was started with this line of options."""

    def view(line="", double=False):
        file = tmp_path / "cradle.csv"
        file.write_text(FIVE_CSV)
        read, kind = (read_double_page_options, LiveDoubleCradle) if double else (read_page_options, LiveCradle)
        options = read([str(file), *line.split()])
        angles = [options.angle, options.phi] if double else [options.angle]
        cradle = make_live(kind, **{name: getattr(options, name) for name in OF_CRADLES})
        viewer = Viewer(cradle, LiveFile(file), angles, options.lift, "", vars(options))
        go_on(viewer, viewer.open())
        return viewer

    return view


def test_an_experiment_starts_again(view):
    viewer = view("--mass 2 --angle 20 --lift 2")
    give(viewer, Command.EXPERIMENT, 1)
    assert viewer.arguments()[1:] == ["--experiment", "2_two_bobs"]
    give(viewer, Command.ANGLE, (0, from_lift(30)))
    assert viewer.arguments()[1:] == ["--experiment", "2_two_bobs", "--angle", "30", "--lift", "2"]
    give(viewer, Command.EXPERIMENT, None)
    assert viewer.arguments()[1:] == ["--mass", "2", "--angle", "20", "--lift", "2"]
    viewer = view("--experiment 2_two_bobs")
    assert viewer.arguments()[1:] == ["--experiment", "2_two_bobs"]
    assert [pend["theta"] != 0 for pend in viewer.cradle.pend_list] == [True, True, False, False, False]


def test_what_only_the_table_has_cannot_be_started_again_before_it_is_written(view):
    viewer = view()
    assert "cradle.csv" in viewer.panel.command.text
    give(viewer, Command.EDIT, [0, "mass", "2"])
    assert viewer.arguments() is None
    assert "No file has this cradle." in viewer.panel.command.text
    assert 'class="command"' not in viewer.panel.command.text


def give(viewer, command, value):
    go_on(viewer, viewer.carry_out(command, value))


@pytest.mark.parametrize(
    "line",
    ["", "--elastic", "--inelastic --separating", "--e 0.25 --mass 3 --angle 12.5 --lift 4 --port 8000 --no-browser"],
)
def test_a_program_that_nobody_touched_starts_again_as_it_was_started(view, line):
    viewer = view(line)
    assert sorted(viewer.arguments()) == sorted([str(viewer.file.filepath), *line.split()])


def test_what_is_set_takes_the_place_of_what_was_given(view):
    viewer = view("--e 0.25 --angle 12.5 --lift 4 --separating")
    give(viewer, Command.COLLISIONS, "elastic, e = 1")
    give(viewer, Command.ANGLE, (0, from_lift(60)))
    give(viewer, Command.LIFT, 9)
    give(viewer, Command.SEPARATING, False)
    assert viewer.arguments()[1:] == ["--elastic", "--angle", "60", "--lift", "5"]
    give(viewer, Command.COLLISIONS, "e = 0.25")
    give(viewer, Command.LIFT, 0)
    assert viewer.arguments()[1:] == ["--e", "0.25", "--angle", "60", "--lift", "0"]
    give(viewer, Command.COLLISIONS, "as in the CSV")
    assert viewer.arguments()[1:] == ["--angle", "60", "--lift", "0"]


def test_the_double_cradle_has_its_phi(view):
    viewer = view("--phi 20", double=True)
    give(viewer, Command.ANGLE, (1, from_lift(-45)))
    give(viewer, Command.SEPARATING, True)
    assert viewer.arguments()[1:] == ["--separating", "--phi=-45"]


def test_the_panel_shows_the_command_and_the_box_of_the_rule(view, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["/anywhere/visualize_cradle_run.py"])
    viewer = view("--separating --lift 2")
    assert viewer.panel.separating.checked
    assert viewer.rule == {"approaching_only": False}
    words = viewer.panel.command.text.removeprefix('<code class="command">').removesuffix("</code>")
    assert words.endswith(f"visualize_cradle_run.py {viewer.file.filepath} --separating --lift 2")
    give(viewer, Command.LIFT, 3)
    assert viewer.panel.command.text.endswith(" --lift 3</code>")
    assert not view().panel.separating.checked


def test_functions_with_a_fixed_rule_need_no_option(view):
    viewer = view()
    viewer.cradle.takes_rule = False
    viewer.separating = True
    assert viewer.arguments() == [str(viewer.file.filepath)]
