"""Each frame of the page: its pace and pauses, its sound, its first and last picture, its words."""

from unittest.mock import Mock

import pytest
from whole_cradles import PROGRAMS

from support.cradle.player import run_for_each_cradle
from support.cradle.real_time import FRAME
from support.page.viewer import NEW_CONSTANTS


def test_pause_and_run(rig):
    """A command only queues: it comes in another thread, in the middle of a tick."""
    rig.wait(0.5)
    rig.give("pause")
    paused = dict(rig.state)
    assert not paused["running"]
    assert paused["paused"]
    rig.wait(1)
    assert rig.state == paused  # so nothing is sent
    rig.tell("pause")
    assert not rig.viewer.lesson.is_running()
    rig.wait(0.5)
    assert rig.state["running"]
    # The simulation does not catch up after the pause
    assert rig.time() == pytest.approx(1, abs=4 * FRAME)


def test_speed_and_slow_motion(rig):
    """A step moves the cradle by one frame, but only while it is paused."""
    rig.give("speed", 0.1)
    rig.wait(1)
    assert rig.state["speed"] == 0.1
    assert rig.time() == pytest.approx(0.1, abs=0.005)
    rig.viewer.pace.kept_up = 0.4
    rig.wait()
    assert rig.state["motion"]["t"].endswith(" s\n0.04x real time")
    ticks = rig.viewer.motion.ticks
    rig.give("step")
    assert rig.viewer.motion.ticks == ticks
    rig.give("pause")
    rig.give("step")
    assert rig.viewer.motion.ticks - ticks == round(0.1 * FRAME / rig.cradle.dt)


def test_numbers_change_ten_times_a_second_and_what_is_in_step_with_the_bobs_in_each_frame(rig):
    states = []
    rig.tabs.show = states.append
    for _ in range(60):
        rig.now += FRAME
        rig.do_frame()
    assert len(states) == 60
    assert all("view" in state for state in states)
    assert 8 <= sum("motion" in state for state in states) <= 10


def test_a_hit_is_heard_with_its_speed_and_bobs_that_rest_on_each_other_are_not(rig):
    """From 30 degrees, a bob comes down at sqrt(2 g R (1 - cos 30 degrees)) = 0.73 m/s."""
    assert "sound" not in rig.state
    rig.wait(0.4)
    assert rig.state["sound"]["speed"] == pytest.approx(0.73, abs=0.01)
    rig.give("e", 0)
    rig.give("lifted", 0)
    sound = rig.state["sound"]
    rig.cradle.pend_list[0]["omega"] = 0.02  # rad/s: 4 mm/s
    rig.wait(1)
    assert rig.state["sound"] == sound


def test_the_first_cradle_is_released_when_a_tab_has_drawn_it(rig):
    """Else nobody would see the release. The time until then does not count."""
    is_seen = rig.tabs.is_seen
    is_seen.clear()
    times = []

    def wait(seconds):
        rig.now += 5
        times.append(rig.now)
        if len(times) == 3:
            is_seen.set()

    is_seen.wait = wait
    rig.begin()
    assert len(times) == 3
    assert rig.viewer.motion.ticks == 0


def test_the_loop_ends_when_the_last_tab_is_closed(rig):
    """Also if no tab has drawn a picture."""
    rig.tabs.is_seen.clear()
    rig.tabs.are_gone = True
    rig.viewer.pace.sleep = Mock(side_effect=[None] * 3)
    rig.viewer.next_cradle.want()
    run_for_each_cradle(PROGRAMS["single"], rig.viewer)
    assert rig.viewer.is_over
    assert "stopped" not in rig.state


def test_a_swing_above_the_frame_widens_the_view_until_the_next_restart(rig):
    """Bobs with unequal masses will probably swing wide: they have room from the start."""
    near = rig.state["view"]
    rig.give("release_angle", 150)
    assert rig.state["view"] != near
    rig.give("release_angle", 45)
    assert rig.state["view"] == near
    rig.give("edit", 0, "mass", 5)
    assert rig.state["view"] != near


# --- the texts -------------------------------------------------------------------------------


def test_changed_constants_are_named(rig):
    rig.viewer.source.constants = b""
    rig.viewer.tell_of_files()
    assert rig.state["saved"] == NEW_CONSTANTS


def test_remarks_on_the_run_are_shown(rig):
    rig.viewer.remarks.append("It differs.")
    rig.wait()
    assert rig.state["remark"] == "It differs."
