"""A file is written whole, or not at all: whole_file replaces it, write_new_file finds a new name for it.

test_csv.py tests whole_file in write_to_csv.
"""

import errno
import os
import subprocess
import sys
import time
from contextlib import contextmanager
from fnmatch import fnmatch
from itertools import count

import pytest
from programs import on_posix, ROOT

from support.files.atomic_write import OLD, TRIES, whole_file, write_new_file

# A program that writes a new file: its text, and, if there is one more argument, nothing else until it is killed.
WRITER = """
import sys, time
from itertools import count
from pathlib import Path
from support.files.atomic_write import write_new_file
folder, text, *waits = sys.argv[1:]
def write(file):
    file.write(text)
    file.flush()
    if waits:
        print("half written", flush=True)
        time.sleep(600)
print(write_new_file((Path(folder, f"data_{number}.csv") for number in count(1)), write).name)
"""


def test_it_is_made_beside_its_target_under_a_hidden_name_of_its_own(tmp_path, monkeypatch):
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    leftover = tmp_path / f".data.csv.{os.getpid()}.tmp"
    leftover.write_text("of a crash")
    with whole_file(tmp_path / "data.csv") as file:
        file.write("new")
        assert sorted(os.listdir(tmp_path)) == [leftover.name, "elsewhere"]
    assert sorted(os.listdir(tmp_path)) == ["data.csv", "elsewhere"]
    assert (tmp_path / "data.csv").read_text() == "new"


def test_all_of_it_is_on_the_disk_before_it_has_its_name(tmp_path, monkeypatch):
    sizes = []
    monkeypatch.setattr("os.fsync", lambda descriptor: sizes.append(os.fstat(descriptor).st_size))
    with whole_file(tmp_path / "data.csv") as file:
        file.write("abc")
    assert sizes == [3]


def test_an_error_has_its_number_and_the_name_that_was_given(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileNotFoundError, match="cannot be written") as caught, whole_file("gone/data.csv"):
        pass
    assert caught.value.filename == "gone/data.csv"


def test_it_is_utf_8_whatever_the_locale(tmp_path):
    imports = "import sys; from support.files.atomic_write import whole_file"
    program = f"{imports}\nwith whole_file(sys.argv[1]) as file: file.write(chr(0x3c9))"
    environment = {**os.environ, "LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
    subprocess.run([sys.executable, "-c", program, str(tmp_path / "data.csv")], cwd=ROOT, env=environment, check=True)
    assert (tmp_path / "data.csv").read_bytes() == chr(0x3C9).encode()


@pytest.mark.parametrize("times", [0, 1, TRIES - 1])
def test_a_file_that_is_open_for_a_moment_is_replaced_on_windows_too(tmp_path, monkeypatch, times):
    pauses = open_elsewhere(monkeypatch, times)
    with whole_file(tmp_path / "data.csv") as file:
        file.write("new")
    assert os.listdir(tmp_path) == ["data.csv"]
    assert len(pauses) == times


def test_a_file_that_stays_open_stays_as_it_is(tmp_path, monkeypatch):
    (tmp_path / "data.csv").write_text("old")
    open_elsewhere(monkeypatch, TRIES)
    words = "cannot be written: another program has it open"
    with pytest.raises(PermissionError, match=words), whole_file(tmp_path / "data.csv") as file:
        file.write("new")
    assert os.listdir(tmp_path) == ["data.csv"]
    assert (tmp_path / "data.csv").read_text() == "old"


def open_elsewhere(monkeypatch, times):
    """Let os.replace fail `times` times, as on Windows if a program has the file open; return the pauses (s)."""
    really, pauses = os.replace, []

    def replace(*paths):
        if len(pauses) < times:
            raise PermissionError(errno.EACCES, "Access is denied")
        really(*paths)

    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(os, "replace", replace)
    monkeypatch.setattr("time.sleep", pauses.append)
    return pauses


# --- new files -------------------------------------------------------------------------------------------------------


def write_new(folder, text):
    """Write a new file with this text, and return its name."""
    return write_new_file((folder / f"data_{number}.csv" for number in count(1)), lambda file: file.write(text)).name


def contents(folder):
    """Return the text of each file in this folder, by its name."""
    return {path.name: path.read_text() for path in folder.iterdir()}


@pytest.fixture(params=["links", "no links"])
def disk(request, monkeypatch):
    """A disk with links, or one without them, as FAT is."""
    if request.param == "no links":
        monkeypatch.setattr("os.link", fail)


def fail(*given):
    raise PermissionError(errno.EPERM, "Operation not permitted")


@pytest.mark.usefixtures("disk")
def test_a_new_file_has_the_first_name_that_no_file_has(tmp_path):
    assert [write_new(tmp_path, text) for text in "ab"] == ["data_1.csv", "data_2.csv"]
    assert contents(tmp_path) == {"data_1.csv": "a", "data_2.csv": "b"}


@pytest.mark.usefixtures("disk")
def test_two_programs_that_write_at_the_same_time_write_two_files(tmp_path, monkeypatch):
    """The other one begins and ends while this one, which has begun, makes sure that its file is on the disk."""
    command = [sys.executable, "-c", WRITER, str(tmp_path), "other"]
    monkeypatch.setattr("os.fsync", lambda _: subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL))
    assert write_new(tmp_path, "mine") == "data_2.csv"
    assert contents(tmp_path) == {"data_1.csv": "other", "data_2.csv": "mine"}


@pytest.mark.usefixtures("disk")
@pytest.mark.parametrize("step", ["os.fsync", "os.replace"])
def test_an_error_leaves_no_file(tmp_path, monkeypatch, step):
    monkeypatch.setattr(step, fail)
    if step == "os.replace":
        monkeypatch.setattr("os.link", fail)
    with pytest.raises(OSError, match=r"cannot be written: Operation not permitted: '.*data_1\.csv'"):
        write_new(tmp_path, "mine")
    assert contents(tmp_path) == {}


# --- unfinished files ------------------------------------------------------------------------------------------------


@contextmanager
def writing(folder):
    """Start a program that has written half of data_1.csv in this folder; yield its process, and end it."""
    command = [sys.executable, "-c", WRITER, str(folder), "half", "and waits"]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "half written\n"
            yield process
        finally:
            process.kill()


@on_posix
def test_the_next_one_removes_what_a_killed_program_has_left(tmp_path):
    with writing(tmp_path) as process:
        unfinished = f".data_1.csv.{process.pid}.tmp"
        assert write_new(tmp_path, "first") == "data_1.csv"
        assert contents(tmp_path) == {unfinished: "half", "data_1.csv": "first"}  # it is still being written
    assert unfinished in os.listdir(tmp_path)
    assert write_new(tmp_path, "second") == "data_2.csv"
    assert contents(tmp_path) == {"data_1.csv": "first", "data_2.csv": "second"}


@on_posix
def test_only_what_is_left_of_the_same_target_is_removed(tmp_path):
    process = subprocess.Popen([sys.executable, "-c", ""])
    process.wait()
    others = [f".other.csv.{process.pid}.tmp", f"data.csv.{process.pid}.tmp", ".data.csv.tmp", ".data.csv.x.tmp"]
    for name in (f".data.csv.{process.pid}.tmp", *others):
        (tmp_path / name).touch()
    with whole_file(tmp_path / "data.csv"):
        pass
    assert sorted(os.listdir(tmp_path)) == sorted(["data.csv", *others])


def test_windows_removes_what_is_old_and_ends_no_program(tmp_path, monkeypatch):
    """There, os.kill ends a program. A file that a program has open cannot be deleted, so age is enough."""
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr("os.kill", lambda *_: pytest.fail("a program was to be ended"))
    for number, age in ((1, OLD + 10), (2, OLD - 10)):
        unfinished = tmp_path / f".data_{number}.csv.123.tmp"
        unfinished.touch()
        os.utime(unfinished, times=(time.time() - age,) * 2)
    write_new(tmp_path, "mine")
    assert sorted(os.listdir(tmp_path)) == [".data_2.csv.123.tmp", "data_1.csv"]


def test_git_does_not_see_an_unfinished_file():
    patterns = (ROOT / ".gitignore").read_text().split()
    assert any(fnmatch(".cradle_data_1.csv.123.tmp", pattern) for pattern in patterns)
