"""Slow hits: the calls of a series as they were, one by one, with their marks and their table."""

from math import inf

import pytest
from pages import tick
from rig import Rig
from vpython import vector
from whole_cradles import GOOD, HEADER, let_bobs_touch, PERIOD

from support.constants import R_PARAM
from support.cradle.double_cradle import DoubleCradle
from support.cradle.real_time import FRAME
from support.energy import momentum
from support.page.scene.marks import LONGEST_ARROW
from support.page.scene.slow_hits import MOST, SlowHits


def wait_for_hit(rig):
    """Wait for a hit; return the rows of its two pendula in the table."""
    while not rig.viewer.slow_hits.current:
        rig.wait(FRAME)
    return rig.state["hits"][-1]["bobs"]


def test_each_hit_waits_in_the_order_of_the_calls(rig):
    """With rings, and equal and opposite changes of momentum."""
    rig.give("slow_hits", True)
    rig.give("lifted", 2)
    for left in (1, 0, 2, 1, 3, 2):
        assert [int(bob["no."]) - 1 for bob in wait_for_hit(rig)] == [left, left + 1]
        places = [bob.pos.x for bob in rig.cradle.bobs()]
        assert [ring.pos.x for ring in rig.marks("rings")] == places[left : left + 2]
        backwards, forwards = [arrow.axis.x for arrow in rig.marks("changes")]
        # Two such bobs have the largest momentum
        assert forwards == pytest.approx(LONGEST_ARROW * R_PARAM / 2, rel=0.01)
        assert backwards == pytest.approx(-forwards)
        time = rig.time()
        rig.wait(1)
        assert rig.time() == time
        rig.give("step")


def test_run_takes_the_rest_into_the_table_and_goes_on_to_the_next_series(rig):
    """Step goes to a first hit, also while paused. While you drag a bob, there is no hit."""
    rig.give("slow_hits", True)
    for left in "14":
        rig.give("pause")
        rig.give("step")
        assert wait_for_hit(rig)[0]["no."] == left
        assert [hit["now"] for hit in rig.state["hits"]] == [True]
        rig.give("pause")
        rig.wait(PERIOD / 8)
        assert [hit["now"] for hit in rig.state["hits"]] == [False] * 4
        assert not rig.marks("rings")
    wait_for_hit(rig)
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    rig.mouse("drag", vector(1, 0, 0))
    assert rig.state["hits"] == []
    rig.give("restart")  # nobody holds a bob of the new cradle
    rig.wait(0.1)
    assert rig.time() > 0


def test_the_table_has_both_rates_of_double_pendula_and_the_momentum_of_their_bobs(csv):
    rig = Rig(csv, 30, 20, kind=DoubleCradle)
    rig.give("slow_hits", True)
    left, _ = wait_for_hit(rig)
    hit, *_ = rig.viewer.slow_hits.current
    for pend, side in ((hit.before[0], 0), (hit.after[0], -1)):
        v, p = rig.cradle.velocity(pend), momentum([pend], R_PARAM)
        found = [float(text.split()[side]) for text in left.values()]
        assert found == pytest.approx([1, pend["omega"], pend["phi_omega"], v, p], abs=0.006)


def test_slow_hits_say_why_they_are_empty(csv, write):
    """A tick can do without the function that lets two bobs collide."""
    write("make_newton_cradle", "newton_cradle_tick = full_swing_update")
    rig = Rig(csv)
    rig.wait(0.1)
    assert rig.state["remark"] == ""
    rig.give("slow_hits", True)
    why = "The tick does not call handle_two_bobs: there are no hits to show."
    assert rig.state["remark"] == why


def test_a_hit_has_all_bobs_as_after_it_its_arguments_and_only_the_last_of_many_are_kept(swing):
    player = swing(HEADER + GOOD * 3, lift=0)
    collide = let_bobs_touch(player.cradle)
    first, second, third = player.cradle.pend_list
    collide(first, second, R_PARAM)
    collide(third, pend2=second, r_param=R_PARAM)  # in any order
    hits = player.hits.noted
    slow_hits = SlowHits(player.motion)
    player.motion.fast_speed = -inf
    slow_hits.add(hits)
    assert [pend["omega"] for pend in slow_hits.shown_pendula()] == [0, 2, 0]
    slow_hits.add(hits * 197)
    slow_hits.leave()
    *_, hit = slow_hits.state()
    assert hit["call"] == "396. handle_two_bobs(pend_list[2], pend2=pend_list[1], r_param=0.2)"
    assert len(slow_hits.series) == MOST


def test_a_slow_hit_is_in_the_table_of_the_page_and_a_screen_reader_hears_it(shared):
    tick(shared, "Slow hits")
    for place in (".hits .now", ".summary"):
        shared.locator(place).get_by_text("1. handle_two_bobs(pend_list[").wait_for()
