"""Ghosts from a file: what it may have, where they are, and how far the cradle is off them."""

from math import degrees

import pages
import pytest
from programs import wait_until
from rig import Rig
from vpython import mag

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.real_time import FRAME
from support.files.cradle_csv import LARGEST_FILE, Snapshot
from support.files.ghosts import read_ghosts
from support.page.scene.marks import BEHIND

RAD = degrees(1)
KEYS = DoubleCradle.angle_keys


@pytest.mark.parametrize(
    ("text", "time", "poses"),
    [
        ("t,theta_1\n0,1\n2,3\n", 2.1, {}),
        ("\ufeff# film; Tracker\n#\n\nt,theta_2,x,theta_1\r\n0,2,red,1\r\n", 0, {0: [1], 1: [2]}),
        ('"x;y"\t"theta_2"\t"t"\n7\t-0,5\t-1\n\n1,5\t5E-1\t1,00\n', 0, {1: [0]}),
        ("omega_1;t;theta_1 (degrees)\n;0;90\n;1,5;\n;2;NaN\n;3;-90\n;4\n", 2, {0: [-30 / RAD]}),
        ("start,0.5,-41.5,,\nt,theta_1\n0.5,1\n1.5,2\n", 0.5, {0: [1.5]}),
        ("Time (s),theta_1(rad)\n0,3\n1,-3\n", 0.5, {0: [180 / RAD]}),  # over the top
        ("t,phi_1,theta_1,phi_2\n0,-1,3,1\n", 0, {0: [3, 2]}),  # of cord 2, only half is known
        ("t,theta_1,theta_3\n0,,1\n", 0, {}),  # bob 1 was never found, and there is no bob 3
        ("mass A\nstart,0.5,-9\nt (s)\ttheta_1 (°)\n0,5\t90\n", 0, {0: [90 / RAD]}),
    ],
)
def test_a_file_has_angles_at_times_and_between_them(text, time, poses):
    ghosts = read_ghosts(Snapshot("a.csv", text.encode()), KEYS)
    assert ghosts.poses(time, 2) == {index: pytest.approx(cords) for index, cords in poses.items()}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("#\nt,theta\n0,1\n", ": names no columns, allowed is a line with t, and theta_1 (rad), "),
        ("t,theta_1,theta_01\n0,,1\n", ": found no angle, allowed is at least one"),
        (
            "theta_1;t\n\n1;0,1\n1;0,1\n",
            ", line 4, column t: found '0.1', allowed is a time (s), after ",
        ),
        ("t,theta_1\n0,red\n", ", line 2, column theta_1: found 'red', allowed is a number, or "),
        ("t,theta_1\n0,0,5\n", ", line 2: found 3 cells, allowed are at most 2, as in line 1;"),
        ("\nstart;1\nt;theta_1\n", ", line 2, after start: found '1', allowed is the time (s) of"),
        (
            "t" * LARGEST_FILE + ",",
            ": cannot be read: it has more than 10 MB",
        ),
    ],
)
def test_a_mistake_in_a_file_is_named_and_the_old_ghosts_stay(rig, text, message):
    rig.give("load_ghosts", "old.csv", "t,theta_1\n0,0\n")
    rig.give("load_ghosts", "a.csv", text)
    assert rig.state["mistake_in_ghosts"].startswith(f"a.csv{message}")
    assert rig.state["ghosts"] == "old.csv"
    rig.give("remove_ghosts")
    assert rig.state["mistake_in_ghosts"] == rig.state["ghosts"] == ""


def test_the_cradle_is_off_by_the_root_of_the_mean_square_of_all_differences(rig):
    """From each release on, until the file ends. The first one has the angle of the file."""
    names = "t,theta_1 (degrees),theta_2 (degrees)"
    rig.give("lifted", 0)  # all bobs hang
    rig.give("load_ghosts", "a.csv", f"start,0,-41.5\n{names}\n0,363,-4\n0.5,363,-4\n")
    assert rig.state["release_angle"] == pytest.approx(41.5)
    assert rig.state["motion"]["ghosts"] == "0.0 to 0.5 s"
    rig.wait(0.6)
    rig.cradle.pend_list[0]["theta"] = 1.0
    rig.wait(0.1)
    assert rig.state["motion"]["off by"] == "3.54 degrees"  # of 3 and 4
    rig.give("restart")
    assert "off by" not in rig.state["motion"]


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_ghosts_of_a_recording_of_the_cradle_are_behind_its_bobs(csv, kind):
    """Also of one with more bobs, but not in a slow hit. The ghosts of your answer come first."""
    rig = Rig(csv, *[30] * kind.cord_count, kind=kind)
    rows = [rig.viewer.motion.sample()]
    while rig.time() < 0.3:
        rig.wait(FRAME)
        rows.append(rig.viewer.motion.sample())
    lines = [",".join(map(str, line)) for line in (rows[0], *map(dict.values, rows))]
    rig.give("load_ghosts", "a.csv", "\n".join(lines))
    assert rig.time() == 0
    rig.give("count", 3)
    rig.wait(0.2)  # the first hit is later
    for bob, ghost in zip(rig.cradle.bobs(), visible_ghosts(rig), strict=True):
        assert mag(ghost.pos - bob.radius * BEHIND - bob.pos) < 0.01 * R_PARAM
        assert ghost.color == bob.color
    [label] = rig.state["view"]["labels"]
    assert label["text"] == "a.csv"
    rig.viewer.questions.ghosts = lambda time: [{2: [1.0]}]
    rig.wait()
    assert len(visible_ghosts(rig)) == 1
    rig.give("slow_hits", True)
    while rig.state["hit"] is None:
        rig.wait(FRAME)
    assert not visible_ghosts(rig)


def visible_ghosts(rig):
    return [ghost for ghost in rig.viewer.marks.shapes["ghosts"] if ghost.visible]


# The x of each ghost
GHOSTS = (
    "glowObjs.filter(o => kindOf(o) === 'sphere' && o.visible && !o.pickable).map(o => o.pos.x)"
)


def test_a_file_is_chosen_on_the_page_and_its_ghosts_are_removed(shared):
    def choose(text):
        file = {"name": "a.csv", "mimeType": "text/csv", "buffer": text.encode()}
        shared.get_by_label("Ghosts from a file").set_input_files(file)

    shared.locator(".keep summary").click()
    choose("start,2,-20\nt,theta_5 (degrees)\n0,30\n99,30\n")
    shared.wait_for_function("() => state.controls.release_angle.value === 20")
    axle, _ = pages.axle(4)
    wait_until(lambda: shared.evaluate(GHOSTS) == [pytest.approx(axle + R_PARAM / 2)])
    choose("t,theta_5\n0,red\n")
    shared.get_by_text("a.csv, line 2, column theta_5: found 'red', allowed is ").wait_for()
    assert pages.violations(shared) == {}
    pages.press(shared, "Remove a.csv")
    wait_until(lambda: shared.evaluate(GHOSTS) == [])
    assert not shared.get_by_text("Remove").is_visible()
