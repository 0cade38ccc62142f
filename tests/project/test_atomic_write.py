"""whole_file replaces a file only when the new one is complete. test_csv.py tests it in write_to_csv."""

import errno
import os
import subprocess
import sys

import pytest
from programs import ROOT

from support.files.atomic_write import TRIES, whole_file


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
