"""Files: written whole or not at all, and watched; recorded data."""

import errno
import os
import re
from unittest.mock import Mock, patch

import pytest
from programs import on_posix, ROOT
from whole_cradles import FIVE_CSV, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert, write_to_csv
from src.special_cradles import make_newton_cradle
from support.constants import NC_FP, R_PARAM
from support.files.cradle_csv import LiveFile, POLL, Snapshot
from support.files.data_file import has_data, require_replaceable, whole_file
from support.files.valid_cradle import read_cradle

# --- write_to_csv -------------------------------------------------------------------------------


def test_write_to_csv_keeps_each_number_to_the_last_bit(csv):
    numbers = [0.1 + 0.2, 1 / 3, 5e-324, 1.7976931348623157e308, -0.0]
    write_to_csv([{"theta": theta} for theta in numbers], csv)
    texts = [cells[0] for _, cells in Snapshot(csv).rows[1:]]
    # As text: 0.0 == -0.0
    assert [repr(float(text)) for text in texts] == [*map(repr, numbers)]


def test_write_to_csv_makes_a_column_of_each_key_but_objects_and_leaves_pend_list_alone(csv):
    """Also of a key that only some pendula have, and with text in any language."""
    csv.write_text(MIXED_CSV)
    pend_list = make_newton_cradle(csv, R_PARAM, 0.25)
    pend_list[1]["note"] = "schön, \u03c9"
    before = [dict(pend_dict) for pend_dict in pend_list]
    write_to_csv(pend_list, csv)
    assert pend_list == before
    assert csv.read_text(encoding="utf-8").splitlines() == [
        "mass,e,theta,omega,color,texture,note",
        "1.5,0.9,0.25,0,red,metal,",
        '2.5,0.8,0,0,blue,none,"schön, \u03c9"',
        "0.5,0.7,0,0,yellow,wood,",
    ]


def test_write_to_csv_writes_a_header_for_an_empty_list(csv):
    write_to_csv([], csv)
    assert csv.read_text() == HEADER


def test_the_shipped_file_is_a_cradle_and_the_one_that_write_to_csv_replaces_from_any_folder():
    assert write_to_csv.__defaults__ == (NC_FP,)
    assert os.path.isabs(NC_FP)
    assert make_newton_cradle(NC_FP, R_PARAM, 0)


# --- whole files --------------------------------------------------------------------------------


def contents(folder):
    """Return the text of each file in this folder, by its name."""
    return {path.name: path.read_text() for path in folder.iterdir()}


@pytest.mark.parametrize(
    "step", ["pandas.DataFrame.to_csv", "os.fsync", "shutil.copymode", "os.replace"]
)
def test_a_full_disk_leaves_the_old_file_and_nothing_else(step, csv, monkeypatch):
    monkeypatch.setattr(step, Mock(side_effect=OSError(errno.ENOSPC, "No space left on device")))
    with pytest.raises(OSError, match="cannot be written: No space left on device") as caught:
        write_to_csv(MIXED * 2, csv)
    assert caught.value.errno == errno.ENOSPC
    assert contents(csv.parent) == {"cradle.csv": FIVE_CSV}


def test_the_name_stays_with_the_old_file_until_the_new_one_is_complete_and_on_the_disk(
    csv, monkeypatch
):
    """The new one is hidden, and git does not see it; no other program writes the same one."""
    synced = []
    monkeypatch.setattr(
        "os.fsync", lambda number: synced.append((csv.read_text(), os.fstat(number).st_size))
    )
    with whole_file(csv) as new:
        new.write("new")
        assert new.encoding == "utf-8"  # in any locale
        [part] = contents(csv.parent).keys() - {"cradle.csv"}
    assert re.fullmatch(r"\.cradle\.csv\.[0-9a-f]{8}\.tmp", part)
    assert ".*.tmp" in (ROOT / ".gitignore").read_text().split()
    assert synced == [(FIVE_CSV, 3)]
    assert contents(csv.parent) == {"cradle.csv": "new"}


@on_posix
def test_permissions_and_links_stay_and_a_new_file_has_the_usual_permissions(csv):
    link = csv.with_name("link.csv")
    other = csv.with_name("other.csv")
    usual = csv.stat().st_mode
    csv.chmod(0o640)
    link.symlink_to(csv)
    for path in (link, other):
        write_to_csv(MIXED[:1], path)
        assert extract_and_convert(path) == MIXED[:1]
    assert link.is_symlink()
    assert csv.stat().st_mode & 0o777 == 0o640
    assert other.stat().st_mode == usual


def test_only_a_file_that_may_be_written_is_replaced_and_the_message_has_the_given_name(
    csv, monkeypatch
):
    """A folder, a device such as /dev/full, or a protected file is none.

    The administrator could still replace a protected file.
    """
    monkeypatch.chdir(csv.parent)
    protected = "cannot be written: it is not a file, or is write-protected"
    for path in (csv.parent, os.devnull):
        with pytest.raises(PermissionError, match=protected):
            write_to_csv(MIXED, path)
    with pytest.raises(FileNotFoundError, match="cannot be written: .*: 'gone/cradle.csv'$"):
        write_to_csv(MIXED, "gone/cradle.csv")
    monkeypatch.setattr("os.access", lambda path, mode: False)
    with pytest.raises(PermissionError, match=protected):
        write_to_csv(MIXED[:1], csv)
    assert contents(csv.parent) == {"cradle.csv": FIVE_CSV}


class Watched(LiveFile):
    """A file that is watched on a clock of its own."""

    def __init__(self, filepath):
        self.now = 0.0
        super().__init__(filepath, lambda: self.now)

    def look(self, seconds=POLL * 1.01):
        """Let this time (s) pass; return whether the file has changed."""
        self.now += seconds
        return self.changed()

    def three_looks(self):
        """Return whether each of three looks has noticed a change."""
        return [self.look() for _ in range(3)]


def test_a_saved_file_is_noticed_once_when_two_looks_find_the_same(csv):
    assert POLL < 0.5  # s
    file = Watched(csv)
    csv.write_text("half")
    assert not file.look(POLL / 2)  # the program does not read the file in each frame
    csv.write_text(FIVE_CSV.replace("red", "sky"))
    os.utime(csv, (0, 0))  # size and time do not show the change
    assert not file.look(POLL / 2)
    assert not file.look(0)
    assert file.three_looks() == [True, False, False]
    csv.write_text("half")  # the editor is still at work
    assert not file.look()
    csv.write_text("whole")
    assert file.three_looks() == [False, True, False]
    assert file.current.rows == [(1, ["whole"])]


def test_a_file_that_goes_or_is_empty_and_comes_back_is_noticed(csv):
    """While it is gone or empty, the page says so."""
    file = Watched(csv)
    for change, words in ((csv.unlink, "No such file or directory"), (csv.touch, "is empty")):
        change()
        assert file.three_looks() == [False, True, False]
        with pytest.raises(ValueError, match=words):
            read_cradle(file.current)
    csv.write_text("new\n")
    assert file.three_looks() == [False, True, False]
    assert file.current.rows == [(1, ["new"])]


@pytest.mark.parametrize("number", [errno.EMFILE, errno.ENFILE])
def test_that_no_more_files_can_be_opened_is_no_change_of_the_file(csv, number):
    file = Watched(csv)
    with patch("os.open", side_effect=OSError(number, "Too many open files")):
        assert file.three_looks() == [False] * 3
    assert file.three_looks() == [False] * 3


def require_data(filepath):
    require_replaceable("--record", filepath, has_data, "data of a cradle")


def test_data_can_replace_only_data(tmp_path, monkeypatch):
    file = tmp_path / "data.csv"
    require_data(file)
    require_data(tmp_path)  # whole_file refuses it
    for text in ("", "t,theta_1,momentum\n0.0,1.0,2.0\n"):
        file.write_text(text)
        require_data(file)
    for text in (MIXED_CSV, "t,theta_1,mine\n", "t,mine,momentum\n"):
        file.write_text(text)
        with pytest.raises(ValueError, match=f"^--record: found '{re.escape(str(file))}', "):
            require_data(file)
    opened = Mock(side_effect=PermissionError(errno.EACCES, "Permission denied"))
    monkeypatch.setattr("builtins.open", opened)
    with pytest.raises(ValueError, match="^--record: .*: Permission denied"):
        require_data(file)
    # Excel lets other programs read its file, but not write it
    opened.assert_called_once_with(file, "r+b")
