"""Slow hits: the calls of a series as they were, one by one."""

from math import inf

from whole_cradles import GOOD, HEADER

from support.constants import R_PARAM
from support.page.scene.slow_hits import MOST, SlowHits


def test_slow_hits_show_all_bobs_as_after_a_hit_and_only_the_last_of_many(swing):
    player = swing(HEADER + GOOD * 3, lift=0)
    cradle = player.cradle
    for bob in cradle.bobs():
        bob.radius *= 1.01
    first, second, third = cradle.pend_list
    first["omega"] = 2.0
    collide = cradle.tick_names["handle_two_bobs"]
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
