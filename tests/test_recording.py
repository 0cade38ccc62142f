"""Data to take away: the samples of a cradle, and the files that they are written to."""

import os
from math import cos
from types import SimpleNamespace

import pandas as pd
import pytest
from cradles import MIXED_CSV

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
    write_data(file, ["t", "theta_1"], [[0.0, 1.0]])
    check_record(file)
    for other in (file, tmp_path):
        file.write_text(MIXED_CSV)
        with pytest.raises(ValueError, match=f"^--record: found '{other}', which holds something else; allowed is "):
            check_record(other)
