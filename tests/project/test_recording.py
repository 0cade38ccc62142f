"""Saved data: the samples, and their files."""

import io
import os
import re
import threading
from collections import deque

import pandas as pd
import pytest
from whole_cradles import make_swing

from grading.cradles import MIXED_CSV
from src.pds_helper import EXACT_FLOATS
from support.files.recording import check_record, data_file, data_writer, EVERY, Recording, REMEMBERED


@pytest.fixture
def player(tmp_path):
    """Three unequal pendula that start at 30 degrees."""
    return make_swing(tmp_path, MIXED_CSV)


@pytest.fixture
def motion(player):
    return player.motion


def test_what_is_saved_is_read_back_by_pandas_to_the_last_bit(player, motion, tmp_path):
    recording, samples = Recording(), []
    for _ in range(5):
        player.swing(321)
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
    for number in range(round(REMEMBERED / EVERY) + 10):
        recording.add({**sample, "t": number})
    assert REMEMBERED == 600
    assert len(recording.rows) == 60_000
    assert [recording.rows[end][0] for end in (0, -1)] == [10, 60_009]


def test_a_download_has_the_rows_of_one_cradle_though_the_next_one_is_made_in_another_thread():
    recording, file = Recording(), io.StringIO()

    def make_next():
        recording.clear()
        recording.add({"t": 0.0, "theta_1": 1.0, "theta_2": 2.0})

    class Rows(deque):
        def __iter__(self):
            making.start()
            making.join(0.5)  # it must not come to its end now: the rows are being read
            return super().__iter__()

    making, recording.rows = threading.Thread(target=make_next), Rows()
    recording.add({"t": 0.0, "theta_1": 1.0})
    recording.write(data_writer(file))
    making.join()
    assert file.getvalue() == "t,theta_1\n0.0,1.0\n"
    assert recording.columns == ["t", "theta_1", "theta_2"]


def test_half_of_a_file_is_none(tmp_path):
    """Not even if the error comes while the program makes the rows."""
    with pytest.raises(ZeroDivisionError), data_file(tmp_path / "data.csv") as writer:
        writer.writerow([1, 2])
        raise ZeroDivisionError
    assert os.listdir(tmp_path) == []


def test_data_may_be_replaced_by_data_and_nothing_else(tmp_path):
    file = tmp_path / "data.csv"
    check_record(file)
    file.touch()
    check_record(file)
    with data_file(file) as writer:
        writer.writerows([["t", "theta_1", "momentum"], [0.0, 1.0, 2.0]])
    check_record(file)
    assert file.read_bytes() == b"t,theta_1,momentum\n0.0,1.0,2.0\n"
    for other in (MIXED_CSV, "t,theta_1,mine\n", "t,mine,momentum\n"):
        file.write_text(other)
        with pytest.raises(ValueError, match=f"^--record: found '{re.escape(str(file))}', which has no data"):
            check_record(file)


def test_a_file_that_another_program_has_open_is_refused_before_anything_is_made(tmp_path, monkeypatch):
    """Excel lets other programs read it, but not write it."""
    file = tmp_path / "data.csv"
    file.write_text("t,theta_1,momentum\n")

    def fail(path, mode):
        assert mode == "r+b"
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("builtins.open", fail)
    with pytest.raises(ValueError, match="^--record: .*: Permission denied$"):
        check_record(file)


@pytest.mark.skipif(os.name != "posix", reason="names may be longer, and the messages differ")
def test_a_name_that_is_too_long_is_refused_before_anything_is_made(tmp_path):
    with pytest.raises(ValueError, match=f"^--record: {tmp_path}/n+: File name too long$"):
        check_record(tmp_path / ("n" * 300))
