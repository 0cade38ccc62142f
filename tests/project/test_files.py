"""Files: each is written whole or not at all; one that you edit is noticed; the recorded data."""

import errno
import io
import os
import re
import subprocess
import sys
import threading
from collections import deque
from unittest.mock import Mock

import pytest
from programs import on_posix, ROOT

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert, write_to_csv
from support.files.cradle_csv import LiveFile, POLL, read_cells
from support.files.data_file import check_record, data_writer, EVERY, Recording, REMEMBERED, whole_file


def contents(folder):
    """Return the text of each file in this folder, by its name."""
    return {path.name: path.read_text() for path in folder.iterdir()}


# --- whole files -----------------------------------------------------------------------------------------------------


@pytest.fixture
def file(tmp_path):
    """The path of a CSV, in a folder of its own."""
    (tmp_path / "folder").mkdir()
    path = tmp_path / "folder" / "cradle.csv"
    path.write_text(MIXED_CSV)
    return path


@pytest.mark.parametrize("step", ["pandas.DataFrame.to_csv", "os.fsync", "shutil.copymode", "os.replace"])
def test_a_full_disk_leaves_the_old_file_and_nothing_else(step, file, monkeypatch):
    monkeypatch.setattr(step, Mock(side_effect=OSError(errno.ENOSPC, "No space left on device")))
    with pytest.raises(OSError, match=r"cannot be written: No space left on device: '.*cradle\.csv'") as caught:
        write_to_csv(MIXED * 2, file)
    assert (caught.value.errno, caught.value.filename) == (errno.ENOSPC, str(file))
    assert contents(file.parent) == {"cradle.csv": MIXED_CSV}


HALF = """
import sys
from support.files.data_file import whole_file
with whole_file(sys.argv[1]) as file:
    file.write("half \\u03c9")
    file.flush()
    print("half", flush=True)
    sys.stdin.read()
"""


@on_posix
def test_a_killed_program_leaves_the_old_file_and_a_hidden_part_that_git_does_not_see(file):
    """The part is UTF-8, also if the locale is another one, and a program that writes later does not need its name."""
    environment = {**os.environ, "LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen([sys.executable, "-c", HALF, file], cwd=ROOT, env=environment, **pipes) as process:
        assert process.stdout.readline() == b"half\n"
        process.kill()
    [part] = {*os.listdir(file.parent)} - {"cradle.csv"}
    assert re.fullmatch(r"\.cradle\.csv\.\w+\.tmp", part)
    assert ".*.tmp" in (ROOT / ".gitignore").read_text().split()
    assert (file.parent / part).read_bytes() == "half \u03c9".encode()
    assert file.read_text() == MIXED_CSV
    write_to_csv(MIXED[:1], file)
    assert extract_and_convert(file) == MIXED[:1]


def test_the_name_stays_with_the_old_file_until_the_new_one_is_complete_and_on_the_disk(file, monkeypatch):
    seen = []
    monkeypatch.setattr("os.fsync", lambda number: seen.append((file.read_text(), os.fstat(number).st_size)))
    with pytest.raises(ZeroDivisionError), whole_file(file) as new:
        new.write("half")
        raise ZeroDivisionError
    assert (seen, contents(file.parent)) == ([], {"cradle.csv": MIXED_CSV})
    with whole_file(file) as new:
        new.write("new")
    assert (seen, contents(file.parent)) == ([(MIXED_CSV, 3)], {"cradle.csv": "new"})


@on_posix
def test_permissions_and_links_stay_and_a_new_file_has_the_usual_permissions(file):
    link, other, usual = (file.with_name(name) for name in ("link.csv", "other.csv", "usual"))
    usual.touch()
    file.chmod(0o640)
    link.symlink_to(file)
    for path in (link, other):
        write_to_csv(MIXED[:1], path)
        assert extract_and_convert(path) == MIXED[:1]
    assert link.is_symlink()
    assert file.stat().st_mode & 0o777 == 0o640
    assert other.stat().st_mode == usual.stat().st_mode


def test_only_a_file_that_may_be_written_is_replaced_and_the_message_has_the_given_name(file, monkeypatch):
    """Not a folder, a device such as /dev/full, or a protected file, which the administrator could still replace."""
    monkeypatch.chdir(file.parent)
    words = "cannot be written: it is not a file, or is write-protected"
    for path in (file.parent, os.devnull, os.path.abspath(os.sep)):
        with pytest.raises(PermissionError, match=words):
            write_to_csv(MIXED, path)
    with pytest.raises(FileNotFoundError, match="cannot be written: No such file or directory: 'gone/cradle.csv'$"):
        write_to_csv(MIXED, "gone/cradle.csv")
    monkeypatch.setattr("os.access", lambda path, mode: False)
    with pytest.raises(PermissionError, match=words):
        write_to_csv(MIXED[:1], file)
    assert contents(file.parent) == {"cradle.csv": MIXED_CSV}


# --- a file that you edit --------------------------------------------------------------------------------------------


@pytest.fixture
def live(file):
    """A watched file with the text old, and a function that checks it again."""
    file.write_text("old\n")
    now = 0.0
    live_file = LiveFile(file, lambda: now)

    def look(seconds=POLL * 1.01):
        nonlocal now
        now += seconds
        return live_file.changed()

    return file, live_file, look


def test_a_saved_file_is_noticed_once_when_two_looks_find_the_same(live):
    path, live_file, look = live
    before = path.stat()
    path.write_text("ne")  # the editor is still at work
    assert not look()
    path.write_text("new\n")
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))  # size and time do not show the change
    assert [look(), look(0), look(0)] == [False] * 3  # the program does not read the file in each frame
    assert [look() for _ in range(3)] == [True, False, False]
    assert read_cells(live_file.current) == [(1, ["new"])]
    assert 2 * POLL < 1  # s


def test_a_file_that_goes_and_comes_back_is_noticed_each_time(live):
    """In between, the page says that the file is not readable, and then that it is empty."""
    path, live_file, look = live
    for change, words in ((path.unlink, "No such file or directory$"), (path.touch, "is empty")):
        change()
        assert [look(), look(), look()] == [False, True, False]
        with pytest.raises(ValueError, match=words):
            read_cells(live_file.current)
    path.write_text("old\n")
    assert [look(), look(), look()] == [False, True, False]
    assert read_cells(live_file.current) == [(1, ["old"])]


# --- recorded data ---------------------------------------------------------------------------------------------------


def test_a_download_has_the_exact_rows_of_one_cradle_though_another_thread_makes_the_next_one():
    class Rows(deque):
        def __iter__(self):
            making.start()
            making.join(0.1)  # it must not come to its end now: the rows are being read
            return super().__iter__()

    recording, file = Recording(), io.StringIO()
    assert recording.rows.maxlen * EVERY == REMEMBERED == 600  # s
    making = threading.Thread(target=lambda: (recording.clear(), recording.add({"t": 0.0, "theta_2": 2.0})))
    recording.rows = Rows()
    recording.add({"t": 0.1 + 0.2, "theta_1": 5e-324})
    recording.write(data_writer(file))
    making.join()
    assert file.getvalue() == "t,theta_1\n0.30000000000000004,5e-324\n"
    assert recording.columns == ["t", "theta_2"]


def test_data_can_replace_only_data(tmp_path, monkeypatch):
    file = tmp_path / "data.csv"
    check_record(file)
    for text in ("", "t,theta_1,momentum\n0.0,1.0,2.0\n"):
        file.write_text(text)
        check_record(file)
    for text in (MIXED_CSV, "t,theta_1,mine\n", "t,mine,momentum\n"):
        file.write_text(text)
        with pytest.raises(ValueError, match=f"^--record: found '{re.escape(str(file))}', which has no data"):
            check_record(file)
    opened = Mock(side_effect=PermissionError(errno.EACCES, "Permission denied"))
    monkeypatch.setattr("builtins.open", opened)
    with pytest.raises(ValueError, match="^--record: .*: Permission denied$"):
        check_record(file)
    opened.assert_called_once_with(file, "r+b")  # Excel lets other programs read its file, but not write it
