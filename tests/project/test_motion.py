"""A cradle in motion: its time, its impacts, its energy, and its samples."""

from math import cos, radians, sqrt

import pytest
from whole_cradles import make_swing, PERIOD

from grading.cradles import MIXED_CSV
from support.constants import DT, G, R_PARAM


@pytest.fixture
def player(tmp_path):
    """Three unequal pendula that start at 30 degrees."""
    return make_swing(tmp_path, MIXED_CSV)


@pytest.fixture
def motion(player):
    return player.motion


def test_a_sample_has_all_figures_of_the_moment_by_their_names(player, motion):
    player.swing(round(0.4 / DT))
    sample = motion.sample()
    names = "t theta_1 theta_2 theta_3 omega_1 omega_2 omega_3 kinetic potential total momentum"
    assert list(sample) == names.split()
    assert sample["t"] == 0.4
    pend_list = motion.cradle.pend_list
    for i, pend in enumerate(pend_list, start=1):
        assert (sample[f"theta_{i}"], sample[f"omega_{i}"]) == (pend["theta"], pend["omega"])
    kinetic = sum(pend["mass"] * (R_PARAM * pend["omega"]) ** 2 / 2 for pend in pend_list)
    potential = sum(pend["mass"] * G * R_PARAM * (1 - cos(pend["theta"])) for pend in pend_list)
    momentum = sum(pend["mass"] * R_PARAM * pend["omega"] * cos(pend["theta"]) for pend in pend_list)
    found = [sample[name] for name in ("kinetic", "potential", "total", "momentum")]
    assert found == pytest.approx([kinetic, potential, kinetic + potential, momentum])
    assert kinetic > 0 < potential


@pytest.mark.parametrize(("ticks", "parts"), [(0, []), (3, [3]), (5, [5]), (12, [5, 7]), (28, [5, 10, 10, 3])])
def test_parts_end_at_multiples_and_at_the_last_tick(motion, ticks, parts):
    motion.ticks, found = 105, []
    for part in motion.parts(ticks, 10):
        found.append(part)
        motion.ticks += part
    assert found == parts


@pytest.mark.parametrize("ticks", [1, 3, 7, 12345, 999999])
def test_times_are_no_longer_than_they_need_be(motion, ticks):
    motion.ticks = ticks
    assert len(str(motion.sample()["t"])) <= len(f"{ticks * DT:.4f}")
    assert motion.sample()["t"] == pytest.approx(ticks * DT, rel=1e-12)


def test_only_approaching_bobs_collide_unless_told_otherwise(tmp_path):
    player = make_swing(tmp_path, lift=0)
    pend1, pend2 = player.cradle.pend_list[:2]
    pend1["objects"][1].radius *= 1.5
    pend1["omega"], pend2["omega"] = -1.0, 1.0
    player.swing(1)
    assert pend1["omega"] < 0 < pend2["omega"]
    player.separating = True
    player.swing(1)
    assert pend1["omega"] > 0


def test_impacts_are_those_of_single_ticks_however_many_are_done_at_once(tmp_path):
    """The times and the directions of the impacts."""
    at_once, one_by_one = make_swing(tmp_path, impacts=99), make_swing(tmp_path, impacts=99)
    at_once.at_once = True
    ticks = round(1.3 * PERIOD / DT)
    at_once.swing(ticks)
    for _ in range(ticks):
        one_by_one.swing(1)
        if len(one_by_one.motion.trains.trains) == 1 and one_by_one.motion.trains.trains[0].last == (1, 2):
            first = one_by_one.motion.time()
    assert at_once.motion.trains.lines() == one_by_one.motion.trains.lines()
    assert at_once.motion.trains.trains[0].begin == pytest.approx(first, abs=DT / 2)
    assert {"1-2-3-4-5", "5-4-3-2-1"} <= {*map(str, at_once.motion.trains.trains)}


def test_the_speed_of_a_hit_is_that_of_the_bobs_before_it_however_the_ticks_are_done(tmp_path):
    """A bob that is let go at 30 degrees is as fast below as its height allows; the hit back is as fast."""
    found = []
    for at_once in (True, False):
        player = make_swing(tmp_path)
        player.at_once = at_once
        assert player.motion.take_fastest() == 0
        player.swing(round(0.2 * PERIOD / DT))
        assert player.motion.take_fastest() == 0
        player.swing(round(0.2 * PERIOD / DT))
        found.append(player.motion.take_fastest())
        assert player.motion.take_fastest() == 0
        player.swing(round(0.5 * PERIOD / DT))
        assert player.motion.take_fastest() == pytest.approx(found[-1], rel=0.01)
    assert found[0] == found[1] == pytest.approx(sqrt(2 * G * R_PARAM * (1 - cos(radians(30)))), rel=1e-3)
    player.swing(round(0.2 * PERIOD / DT))
    player.motion.fastest = 1.0
    player.motion.restart()
    assert player.motion.take_fastest() == 0


def test_bobs_that_hit_while_they_move_apart_have_a_speed_below_0(tmp_path):
    player = make_swing(tmp_path, lift=0)
    player.separating = True
    pend1, pend2 = player.cradle.pend_list[:2]
    pend1["objects"][1].radius *= 1.5
    pend1["omega"], pend2["omega"] = -1.0, 1.0
    with player.cradle.noting_hits():
        player.cradle.scope["handle_two_bobs"](pend2, pend1, R_PARAM)  # in any order
    assert player.cradle.hits == [(0, 1, False, pytest.approx(-2 * R_PARAM))]


def test_the_energy_of_the_start_is_100_percent(tmp_path):
    """For kinetic and potential energy. Above ten times, the text is not exact; 0 of 0 is 0 %."""
    player = make_swing(tmp_path)
    motion = player.motion
    player.cradle.pend_list[0]["omega"] = 2.0
    motion.set_start()
    assert "energy 100.00 % (kinetic" in motion.reading()
    motion.start_energy /= 10.1
    assert "energy  > 999 %" in motion.reading()
    still = make_swing(tmp_path, lift=0)
    assert "energy   0.00 % (kinetic   0.00 %, potential   0.00 %)" in still.motion.reading()
