"""Ghosts from a file: what it may have, where they are, and how far the cradle is off them."""

from base64 import b64encode
from math import tau

import pages
import pytest
from programs import wait_until

from support.files.cradle_csv import LARGEST_FILE

GOOD = b"t,theta_1\n0,1\n"


def load(rig, content, name="a.csv"):
    """Choose a file on the page; return what is said about it."""
    rig.give("load_ghosts", name, f"data:text/csv;base64,{b64encode(content).decode()}")
    return rig.state["mistake_in_ghosts"]


@pytest.mark.parametrize(
    ("content", "time", "angles"),
    [
        (b"t,theta_2,color,theta_1\n0,2,red,1\n\n2,,,3\n", 1, {0: 2}),
        (b"Time;Theta_1;theta_2 (rad);x,y\n2;3,5;\n0;1;2\n4;;4\n", 2, {0: 3.5, 1: 3}),
        (b'"theta_1 (degrees)"\t"Time (s)"\nNaN\t0\n-90\t-1\n450\t2\n', 1, {0: tau * 3 / 4}),
        (b"t,theta_1,theta_9\n0,0,0\n", 0.1, {}),
    ],
)
def test_a_ghost_is_between_the_rows_with_a_number(rig, content, time, angles):
    assert load(rig, content) == ""
    poses = rig.viewer.ghost_file.poses(time, 3)
    assert poses == {index: [pytest.approx(angle)] for index, angle in angles.items()}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b'"t, s","theta_1, rad"\n0,1\n', ": found 't, s, theta_1, rad', allowed is a column t, "),
        (b"t,theta_1\n0,\n,1\n", ": found 't, theta_1', allowed is a column t, and theta_1 or "),
        (
            b"t,theta_1\n0,-41.5\n1,1\n",
            ", theta_1: found '-41.5', allowed is -6.28 to 6.28 (rad), or n",
        ),
        (b"t" * LARGEST_FILE + b",", ": cannot be read: it has more than 6 MB"),
    ],
)
def test_a_mistake_in_a_file_is_named_and_all_stays_as_it_is(rig, content, message):
    load(rig, GOOD, "old.csv")
    rig.wait(0.1)
    assert load(rig, content).startswith(f"Not taken: a.csv{message}")
    assert (rig.state["ghosts"], rig.time()) == ("old.csv", 0.1)
    assert load(rig, GOOD) == ""
    assert rig.time() == 0


def test_the_cradle_goes_on_whatever_a_file_raises(rig, monkeypatch):
    monkeypatch.setattr(rig.viewer.ghost_file, "read", {}.__getitem__)
    assert load(rig, GOOD).startswith("Not taken: ")


def test_the_cradle_is_off_by_the_root_of_the_mean_square_of_all_differences(rig):
    """From each release on, until the file ends."""
    rig.give("lifted", 0)  # all bobs hang
    load(rig, b"t,theta_1 (degrees),theta_2 (degrees)\n0,-357,-4\n0.5,-357,-4\n")
    assert rig.state["motion"]["ghosts"] == "0.0 to 0.5 s"
    rig.wait(0.6)
    rig.cradle.pend_list[0]["theta"] = 1.0
    rig.wait(0.1)
    assert rig.state["motion"]["off by"] == "3.54 degrees"  # of 3 and 4
    rig.give("restart")
    assert "off by" not in rig.state["motion"]


def test_the_ghosts_of_your_answer_come_before_those_of_a_file(rig):
    """There are none beside a slow hit."""
    load(rig, GOOD)
    rig.viewer.lesson.ghosts = lambda time: [{1: [1.0]}]
    rig.wait()
    [name] = rig.marks("names")
    assert name.text == "your answer"
    [ghost] = rig.marks("ghosts")
    assert ghost.color.mag > rig.cradle.bobs()[1].color.mag  # pale
    rig.give("slow_hits", True)
    while not rig.state["hits"]:
        rig.wait(0.05)
    assert not rig.marks("names")


def test_a_file_is_chosen_on_the_page_and_its_ghosts_are_removed(shared):
    content = b"t,theta_5 (degrees)\n0,30\n99,30\n"
    file = {"name": "<s>.csv", "mimeType": "text/csv", "buffer": content}
    shared.locator(".keep summary").click()
    shared.get_by_label("Ghosts from a file").set_input_files(file)
    wait_until(lambda: shared.evaluate("texts()") == [*"12345", "<s>.csv"])
    assert shared.evaluate("visible('sphere').length") == 6
    assert pages.violations(shared) == {}
    pages.press(shared, "Remove <s>.csv")
    wait_until(lambda: shared.evaluate("texts()") == [*"12345"])
    assert not shared.get_by_text("Remove").is_visible()
