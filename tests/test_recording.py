"""Data to take away: the samples of a cradle, and the files that they are written to."""

import os
from math import cos
from types import SimpleNamespace

import pandas as pd
import pytest
from cradles import FIVE_CSV, MIXED_CSV, PERIOD

from src.live_cradle import LiveCradle
from src.pds_helper import EXACT_FLOATS
from src.visualize_cradle_run import advance_cradle
from support.constants import DT, G, R_PARAM
from support.cradle_csv import Snapshot
from support.motion import Motion
from support.recording import check_record, EVERY, Recording, SPAN, write_data


@pytest.fixture
def motion(tmp_path):
    """Three unequal pendula, let go from 30 degrees."""
    csv = tmp_path / "cradle.csv"
    csv.write_text(MIXED_CSV)
    cradle = LiveCradle(advance_cradle, SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None))
    cradle.load(Snapshot(csv))
    cradle.release([30], 1)
    return Motion(cradle, impacts=1)


def test_a_sample_has_all_figures_of_the_moment_by_their_names(motion):
    motion.advance(round(0.4 / DT))
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


def test_hits_are_told_in_their_direction_however_long_the_time(tmp_path):
    csv = tmp_path / "five.csv"
    csv.write_text(FIVE_CSV)
    cradle = LiveCradle(advance_cradle, SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None))
    cradle.load(Snapshot(csv))
    cradle.release([30], 1)
    motion = Motion(cradle, impacts=9)
    motion.advance(round(0.95 * PERIOD / DT))
    assert motion.trains.runs()[-1] == "1-2-3-4-5"
    assert "5-4-3-2-1" in motion.trains.runs()


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


def test_what_is_saved_is_read_back_by_pandas_to_the_last_bit(motion, tmp_path):
    recording, samples = Recording(), []
    for _ in range(5):
        motion.advance(321)
        samples.append(motion.sample())
        recording.add(samples[-1])
    data = pd.read_csv(recording.save(tmp_path), **EXACT_FLOATS)
    assert data.to_dict(orient="records") == samples


def test_each_file_has_a_name_of_its_own(motion, tmp_path):
    recording = Recording()
    recording.add(motion.sample())
    (tmp_path / "cradle_data_2.csv").write_text("mine")
    assert [recording.save(tmp_path).name for _ in range(3)] == [f"cradle_data_{number}.csv" for number in (1, 3, 4)]
    assert (tmp_path / "cradle_data_2.csv").read_text() == "mine"


def test_only_the_last_ten_minutes_are_kept(motion):
    recording, sample = Recording(), motion.sample()
    for number in range(round(SPAN / EVERY) + 10):
        recording.add({**sample, "t": number})
    assert SPAN == 600
    assert len(recording.rows) == 60_000
    assert [recording.rows[end][0] for end in (0, -1)] == [10, 60_009]


def test_half_of_a_file_is_none(tmp_path):
    """Not even where rows are still being made when it goes wrong."""

    def rows():
        yield [1, 2]
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        write_data(tmp_path / "data.csv", ["t", "theta_1"], rows())
    assert os.listdir(tmp_path) == []


def test_data_may_be_replaced_by_data_and_nothing_else(tmp_path):
    file = tmp_path / "data.csv"
    check_record(file)
    file.touch()
    check_record(file)
    write_data(file, ["t", "theta_1", "momentum"], [[0.0, 1.0, 2.0]])
    check_record(file)
    for other in (MIXED_CSV, "t,theta_1,mine\n", "t,mine,momentum\n"):
        file.write_text(other)
        with pytest.raises(ValueError, match=f"^--record: found '{file}', which holds something else; allowed is "):
            check_record(file)
    with pytest.raises(ValueError, match=f"^--record: {tmp_path}/n+: File name too long$"):
        check_record(tmp_path / ("n" * 300))
