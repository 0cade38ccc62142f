"""Saved data: the samples, and their files."""

import io
import os
import re
import threading

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


def test_another_thread_can_write_while_samples_are_added_and_the_cradle_changes():
    """Each file has the rows of one cradle: its columns, and no others."""
    recording, files, over = Recording(), [], threading.Event()

    def write():
        while not over.is_set():
            files.append(io.StringIO())
            recording.write(data_writer(files[-1]))

    writing = threading.Thread(target=write)
    writing.start()
    for count in [2, 3] * 100:
        recording.clear()
        for number in range(100):
            recording.add({"t": number, **{f"theta_{i}": 0.0 for i in range(count)}})
    over.set()
    writing.join()
    widths = [{line.count(",") for line in file.getvalue().splitlines()[1:]} for file in files]
    headers = [file.getvalue().partition("\n")[0].count(",") for file in files]
    assert all(width <= {header} for width, header in zip(widths, headers, strict=True))
    assert {2, 3} <= {*headers}


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
