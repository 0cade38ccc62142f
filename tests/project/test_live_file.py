"""The watched CSV, on a clock of the test, for every way in which an editor saves, also in two steps."""

import os

import pytest

from support.files.cradle_csv import read_cells, Snapshot
from support.files.live_file import LiveFile, POLL


class Clock:
    now = 0.0

    def __call__(self):
        return self.now


@pytest.fixture
def live(tmp_path):
    """A watched file, and a function that checks it again."""
    path = tmp_path / "cradle.csv"
    path.write_text("old\n")
    clock = Clock()
    file = LiveFile(path, clock)

    def look():
        clock.now += POLL * 1.01
        return file.changed()

    return path, file, look


def in_place(path, text):
    path.write_text(text)


def by_replacing(path, text):
    new = path.with_name("new")
    new.write_text(text)
    os.replace(new, path)


def by_moving_the_old_one_away(path, text):
    os.replace(path, path.with_name("cradle.csv~"))
    path.write_text(text)


@pytest.mark.parametrize("save", [in_place, by_replacing, by_moving_the_old_one_away])
def test_a_saved_file_is_noticed_once_within_a_second(live, save):
    path, file, look = live
    assert [look() for _ in range(3)] == [False] * 3
    save(path, "new\n")
    noticed = [look() for _ in range(4)]
    assert noticed.count(True) == 1
    assert noticed.index(True) * POLL < 1
    assert read_cells(file.current) == [(1, ["new"])]


def test_a_change_that_leaves_size_and_time_as_they_were_is_noticed(live):
    path, _, look = live
    before = path.stat()
    path.write_text("OLD\n")
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert [look(), look()] == [False, True]


def test_a_file_that_is_still_being_written_is_left_alone(live):
    path, file, look = live
    for text in ("n", "ne", "new"):
        path.write_text(text)
        assert not look()
    assert look()
    assert file.current.data == b"new"


def test_a_file_saved_as_it_was_is_no_news(live):
    path, _, look = live
    path.write_text("old\n")
    assert not any(look() for _ in range(3))


def test_a_file_that_goes_and_comes_back_as_it_was_is_news_both_times(live):
    """In between, the page says that the file is not readable."""
    path, file, look = live
    path.unlink()
    assert [look(), look(), look()] == [False, True, False]
    with pytest.raises(ValueError, match="cannot be read as a CSV file: No such file or directory$"):
        read_cells(file.current)
    path.write_text("old\n")
    assert [look(), look(), look()] == [False, True, False]
    assert read_cells(file.current) == [(1, ["old"])]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such pipes")
def test_a_pipe_in_its_place_is_news_once_and_so_is_the_file_that_comes_back(live):
    path, file, look = live
    path.unlink()
    os.mkfifo(path)
    assert [look(), look(), look()] == [False, True, False]
    with pytest.raises(ValueError, match="found a pipe or a device, allowed is a file$"):
        read_cells(file.current)
    path.unlink()
    path.write_text("new\n")
    assert [look(), look(), look()] == [False, True, False]
    assert read_cells(file.current) == [(1, ["new"])]


def test_the_file_is_read_once_a_poll(tmp_path, monkeypatch):
    """The program does not read it in every frame."""
    reads, clock = [], Clock()
    monkeypatch.setattr("support.files.live_file.Snapshot", lambda path: reads.append(path) or "always the same")
    file = LiveFile(tmp_path / "cradle.csv", clock)
    for _ in range(60):
        clock.now += 1 / 60
        file.changed()
    assert 4 <= len(reads) <= 1 + 1 / POLL


def test_a_snapshot_stays_as_it_was_whatever_becomes_of_the_file(live):
    path, file, _ = live
    for change in (lambda: path.write_text("new\n"), path.unlink):
        change()
        assert read_cells(file.current) == [(1, ["old"])]


def test_an_empty_file_is_not_the_same_as_none(tmp_path):
    path = tmp_path / "cradle.csv"
    none = Snapshot(path)
    path.touch()
    assert Snapshot(path) == Snapshot(path) != none
