"""Files: CSVs that are read, refused, edited and written whole or not at all; recorded data."""

import errno
import os
import re
from pathlib import Path
from unittest.mock import Mock, patch

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from programs import on_posix, ROOT, running
from students import put_files
from vpython import color, textures, vector
from whole_cradles import FIVE_CSV, GOOD, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert, write_to_csv
from src.special_cradles import make_newton_cradle
from support.constants import COLOR_MAP, NC_FP, R_PARAM, TEXTURE_MAP
from support.files.cradle_csv import clean_copy, LiveFile, POLL, Snapshot
from support.files.data_file import require_replaceable, whole_file
from support.files.valid_cradle import require_cradle
from support.page.chooser import with_numbers

FEW = settings(max_examples=40, deadline=None, derandomize=True, database=None)
MANY = settings(FEW, max_examples=200)

MASS = "a number from 1e-300 to 1e6 (kg)"
COMMAS = "plain commas"
HINTS = [COMMAS, "semicolons", "not tabs", "the quotes around", "cells, not"]

# Files that are no CSV, or give no cradle. The message goes on after the name of the file, and has
# the other texts later.
REFUSED = {
    "blank": ("\ufeff\ufeff\n  \n\n", ": is empty"),
    "zero byte at the start": (b"\0", ", line 1: found a zero byte"),
    "zero byte after a line": (b"\n\0", ", line 2: found a zero byte"),
    "zero byte": (b"mass,e\n1,\x00\n", ", line 2: found a zero byte", "UTF-8"),
    "latin-1": (b"mass\n1\nros\xe9\n", ", line 3: found byte 0xe9", "UTF-8"),
    "endless cell": (HEADER + '"' + "x" * 200_000, ", line 2: field larger than field limit"),
    "large": (" " * 10_000_001, ": cannot be read: found more than 10 MB", "at most 10 MB"),
    "not too large": (" " * 10_000_000, ": is empty"),
    "too many cells, below a column without a name": (
        "color,texture,mass,e,\nred,metal,1,0,9\n",
        ", line 2: found 5 cells",
        "at most 4, as in line 1",
    ),
    "a separator in line 3": (HEADER + GOOD + "sep=,,,,,\n", ", line 3, column mass: found 'sep='"),
    "header only": (HEADER, ": names columns but has no pendulum"),
    "two columns mass": (
        "mass,mass\n",
        ", line 1: found 2 columns mass",
        "mass, e, color, texture",
    ),
    "no column": ("mass,E,color,texture\n", ", line 1: found no column e in 'mass', 'E', "),
    "tabs": ("mass\te\n", ", line 1 must name the columns: found 'mass\\te'", "not tabs"),
    "a decimal comma": ("sep=;\ne;mass\n1;1,0", ", line 2 must name", "'e;mass'", "semicolons"),
    "quotes": ('"mass, e"\n"1,1"\n', ", line 1 must name", "'mass, e'", "the quotes around"),
    "a title": (f"Cradle; e, 1,,,\n{HEADER}{GOOD}", ", line 1 must name", "'Cradle; e', '1'; "),
    "names in quotes": ('"Mass";"E"\n', ", line 1 must name", """'Mass;"E"'""", "semicolons"),
    "full-width commas": ("mass\uff0ce\n", ", line 1 must name", "'mass\uff0ce'", COMMAS),
    "a long line": ("x" * 1000 + "\n", ", line 1 must name", f" '{'x' * 299}...; "),
    "a line as long as in a message": ("x" * 298, ", line 1 must name", f" '{'x' * 298}'; "),
    "a workbook": (b"PK\3\4\xff", ": is a workbook"),
    "an old workbook": (b"\xd0\xcf\x11\xe0", ": is a workbook"),
    "row too short": (
        HEADER + "1,1,0,0,red\n",
        ", line 2, column texture: found nothing, ",
        "5 cells, not 6",
    ),
    "an Arabic comma": (
        HEADER + "1\u060c1,0,0,red,metal\n",
        ", line 2, column mass: found '1\u060c1', ",
        "5 cells, not 6",
        COMMAS,
    ),
    # The row after them, with a cell that is too long for a CSV, is not even read
    "too many pendula": (
        HEADER + "\n" + GOOD * 1001 + '"' + "x" * 200_000,
        ", line 1003: found pendulum 1001",
        "at most 1000",
    ),
    "after blank lines and a cell of two lines": (
        'note,mass,e,color,texture\n   \n\n"one\ntwo",1,1,red,none\nx,0,1,red,none\n',
        ", line 6, column mass: found '0'",
        MASS,
    ),
}


@pytest.fixture
def save(tmp_path):
    """A function that puts text or bytes into a file and returns the file's path."""
    return lambda content: str(put_files(tmp_path, {"cradle.csv": content}) / "cradle.csv")


def refusal(filepath, cords=1):
    """Return the message with which a CSV is refused, after the name of the file."""
    with pytest.raises(ValueError, match=f"^{re.escape(filepath)}.*$") as caught:
        require_cradle(Snapshot(filepath), cords)
    return str(caught.value).removeprefix(filepath)


@pytest.mark.parametrize("mistake", REFUSED)
def test_a_csv_is_refused_with_the_place_of_its_mistake(mistake, save):
    content, beginning, *parts = REFUSED[mistake]
    message = refusal(save(content))
    assert message.startswith(beginning)
    assert [part for part in parts if part not in message] == []
    hints = [hint for hint in HINTS if hint in " ".join(parts)]
    assert [hint for hint in HINTS if hint in message] == hints
    assert len(message) < 500


# The third line of a CSV with one cell to fill in
LINES = {
    "mass": HEADER + GOOD + "{},1,0,0,red,none\n",
    "e": HEADER + GOOD + "1,{},0,0,red,none\n",
    "color": HEADER + GOOD + "1,1,0,0,{},none\n",
    "texture": HEADER + GOOD + "1,1,0,0,red,{}\n",
}


@pytest.mark.parametrize(
    ("column", "texts", "allowed"),
    [
        ("mass", ["heavy", "nan", "1000000.5", "0", "1e-310", "1_000", "\u0663"], MASS),
        ("e", ["-0.1", "1.01", "nan"], "a number from 0 to 1, such as 0.9"),
        ("color", ["mauve"], f"one of {', '.join(COLOR_MAP)}"),
        ("texture", ["velvet"], f"one of {', '.join(TEXTURE_MAP)}"),
    ],
)
def test_a_bad_cell_is_named_with_its_place_and_the_allowed_values(column, texts, allowed, save):
    for text in texts:
        message = refusal(save(LINES[column].format(text)))
        assert message.startswith(
            f", line 3, column {column}: found {text!r}, allowed is {allowed}"
        )
        assert "cells" not in message


def test_the_smallest_and_the_largest_cradle_are_allowed(save):
    require_cradle(Snapshot(save(HEADER + GOOD * 1000)))
    for column, text in [("e", "0"), ("e", "1"), ("mass", "1e-300"), ("mass", "1e6")]:
        require_cradle(Snapshot(save(LINES[column].format(text))))


def test_the_masses_of_a_double_cradle_may_differ_by_a_factor_of_a_million(save):
    require_cradle(Snapshot(save(LINES["mass"].format("1e-6"))), cords=2)
    file = save(LINES["mass"].format("9.9999995e-7"))
    require_cradle(Snapshot(file))
    message = refusal(file, cords=2)
    assert message.startswith(", line 2, column mass: found '1.0', and '9.9999995e-7' in line 3, ")
    assert "at most 1e6 times" in message


@on_posix
def test_a_missing_file_a_folder_a_pipe_and_a_device_are_refused_at_once(tmp_path):
    """A pipe may have no writer, and /dev/zero never ends."""
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    reasons = {
        tmp_path / "missing.csv": "No such file or directory",
        pipe: "found a pipe or a device",
        "/dev/zero": "found a pipe or a device",
    }
    for file, reason in reasons.items():
        assert refusal(str(file)).startswith(f": cannot be read: {reason}")


@pytest.mark.parametrize("system", ["win32", "linux"])
def test_windows_denies_the_permission_for_a_folder_and_for_a_file_that_excel_holds_open(
    system, csv, monkeypatch
):
    """It says the same of both."""
    monkeypatch.setattr("sys.platform", system)
    denied = PermissionError(errno.EACCES, "Permission denied")
    monkeypatch.setattr("os.open", Mock(side_effect=denied))
    assert ("another program may have it open" in refusal(str(csv))) == (system == "win32")
    assert refusal(str(csv.parent)).startswith(": cannot be read: found a folder")


READABLE = {
    "marks": MIXED_CSV.replace("mass", '\ufeff\ufeff"\ufeffmass"').replace("2.5", "\ufeff2.5"),
    "windows": MIXED_CSV.replace("\n", "\r\n\r\n") + "\x1a",
    "spaces": "  " + MIXED_CSV.replace(",", " ,\t ").replace("\n", "  \n "),
    "quotes": MIXED_CSV.replace("red", ' "red" '),
    "a spreadsheet": "Sep=,\n" + MIXED_CSV.replace("\n", ",,\n,,,,,,,,\n"),
    "hard spaces": MIXED_CSV.replace(",", "\u00a0,\u00a0") + '""\n\u00a0\n',
    "another order": "\n".join(
        ",".join(reversed(line.split(","))) for line in MIXED_CSV.splitlines()
    ),
}


@pytest.mark.parametrize("content", READABLE.values(), ids=READABLE)
def test_a_csv_is_read_however_a_program_has_written_it_and_also_when_it_is_gone(content, save):
    """A plain pd.read_csv reads its clean copy, whose path is a plain one."""
    snapshot = Snapshot(save(content))
    os.remove(snapshot.filepath)
    with clean_copy(snapshot) as copy:
        assert type(copy) is str
        assert Path(copy).name == "cradle.csv"
        assert extract_and_convert(copy) == MIXED
        assert [pend["mass"] for pend in make_newton_cradle(copy, R_PARAM, 0)] == [1.5, 2.5, 0.5]
    assert not Path(copy).exists()


NUMBERS = st.from_regex(r"\A[0-9]{1,2}(\.[0-9]{0,2})?([eE][+-]?[0-9])?\Z")
ODD = st.text("0123456789.eE+-x ", min_size=1, max_size=6)


@MANY
@given(NUMBERS | ODD)
def test_a_number_for_the_check_is_a_number_for_pandas(text):
    """The check reads the text of a cell itself.

    A cell that it accepts must not become text in pend_list.
    """
    data = f"mass,e,color,texture\n{text},1,red,none\n".encode()
    try:
        require_cradle(Snapshot("cradle.csv", data))
    except ValueError:
        return
    with clean_copy(Snapshot("cradle.csv", data)) as copy:
        [pend_dict] = extract_and_convert(copy)
    assert isinstance(pend_dict["mass"], (int, float))
    assert pend_dict["mass"] == float(text)


def test_the_copy_of_a_long_number_has_only_digits_that_pandas_2_reads():
    data = b"id,mass,e\n00000000000000001,0.00000000000000000000012345,0.02000000000000000045\n"
    with clean_copy(Snapshot("cradle.csv", data)) as copy:
        assert Path(copy).read_text().split() == ["id,mass,e", "00000000000000001,1.2345e-22,2e-2"]


def test_the_maps_have_all_names_of_vpython_and_none_for_a_plain_bob():
    """test_headless_vpython.py compares the colors of the stand-in with those of VPython."""
    colors = [name for name, value in vars(color).items() if isinstance(value, vector)]
    assert {name: getattr(color, name) for name in colors} == COLOR_MAP
    names = [name for name in vars(textures) if not name.startswith("_")]
    assert {"none": None} | {name: getattr(textures, name) for name in names} == TEXTURE_MAP


def test_an_edit_leaves_the_other_cells_and_the_file_as_they_are(save):
    text = 'note,mass , e\n"a, b",1.50,1\nshort,2\n'
    original = Snapshot(save(text))
    edited = with_numbers(original, {"mass": [1.5, 0.1 + 0.2], "e": [1]})
    assert str(edited) == original.filepath
    assert edited.rows == [
        (1, ["note", "mass", "e"]),
        (2, ["a, b", "1.50", "1"]),
        (3, ["short", "0.30000000000000004"]),
    ]
    assert Path(original.filepath).read_text() == text


@FEW
@given(numbers=st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=1))
@example(numbers=[0.1 + 0.2, 1 / 3, 5e-324, 1.7976931348623157e308, -0.0])
def test_write_to_csv_keeps_each_number_to_the_last_bit(tmp_path_factory, numbers):
    file = tmp_path_factory.getbasetemp() / "numbers.csv"
    write_to_csv([{"theta": theta, "omega": -theta} for theta in numbers], file)
    for (_, cells), number in zip(Snapshot(file).rows[1:], numbers, strict=True):
        # As text: 0.0 == -0.0
        assert [repr(float(text)) for text in cells] == [repr(number), repr(-number)]


def test_write_to_csv_makes_a_column_of_each_key_but_objects_and_leaves_pend_list_alone(
    tmp_path, save
):
    """Also of a key that only some pendula have, and with text in any language."""
    pend_list = make_newton_cradle(save(MIXED_CSV), R_PARAM, 0.25)
    pend_list[1]["note"] = "schön, \u03c9"
    before = [dict(pend_dict) for pend_dict in pend_list]
    file = tmp_path / "written.csv"
    write_to_csv(pend_list, file)
    assert pend_list == before
    assert file.read_text(encoding="utf-8").splitlines() == [
        "mass,e,theta,omega,color,texture,note",
        "1.5,0.9,0.25,0,red,metal,",
        '2.5,0.8,0,0,blue,none,"schön, \u03c9"',
        "0.5,0.7,0,0,yellow,wood,",
    ]


def test_write_to_csv_writes_a_header_for_an_empty_list(tmp_path):
    file = tmp_path / "cradle.csv"
    write_to_csv([], file)
    assert file.read_text() == HEADER
    assert extract_and_convert(file) == []


def test_the_shipped_file_is_a_cradle_and_the_one_that_write_to_csv_replaces_from_any_folder():
    assert write_to_csv.__defaults__ == (NC_FP,)
    assert os.path.isabs(NC_FP)
    assert make_newton_cradle(NC_FP, R_PARAM, 0)


# --- whole files ----------------------------------------------------------------------------------


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
    assert caught.value.filename == str(csv)
    assert contents(csv.parent) == {"cradle.csv": FIVE_CSV}


HALF = """
import sys, time
from support.files.data_file import whole_file
with whole_file(sys.argv[1]) as file:
    file.write("half \\u03c9")
    file.flush()
    print("half", flush=True)
    time.sleep(1000)
"""


@on_posix
def test_a_killed_program_leaves_the_old_file_and_a_hidden_part_that_git_does_not_see(csv):
    """The part is UTF-8, also if the locale is another one.

    A program that writes later does not need its name.
    """
    c_locale = {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}
    with running("-c", HALF, csv, folder=ROOT, **c_locale) as process:
        assert process.stdout.readline() == "half\n"
    write_to_csv(MIXED[:1], csv)
    files = contents(csv.parent)
    [part] = files.keys() - {"cradle.csv"}
    assert re.fullmatch(r"\.cradle\.csv\.[0-9a-f]{8}\.tmp", part)
    assert ".*.tmp" in (ROOT / ".gitignore").read_text().split()
    assert files[part] == "half \u03c9"
    assert extract_and_convert(csv) == MIXED[:1]


def test_the_name_stays_with_the_old_file_until_the_new_one_is_complete_and_on_the_disk(
    csv, monkeypatch
):
    synced = []
    monkeypatch.setattr(
        "os.fsync", lambda number: synced.append((csv.read_text(), os.fstat(number).st_size))
    )
    with whole_file(csv) as new:
        new.write("new")
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


def test_a_saved_file_is_noticed_once_when_two_looks_find_the_same(csv):
    assert POLL < 0.5  # s
    file = Watched(csv)
    csv.write_text("half")
    assert not file.look(POLL / 2)  # the program does not read the file in each frame
    csv.write_text(FIVE_CSV.replace("red", "sky"))
    os.utime(csv, (0, 0))  # size and time do not show the change
    assert not file.look(POLL / 2)
    assert file.look(0) is False
    assert file.look()
    assert file.current.data == csv.read_bytes()
    assert not file.look()
    csv.write_text("half")  # the editor is still at work
    assert not file.look()
    csv.write_text("whole")
    assert not file.look()
    assert file.look()
    assert file.current.rows == [(1, ["whole"])]


def test_a_file_that_goes_or_is_empty_and_comes_back_is_noticed(csv):
    """While it is gone or empty, the page says so."""
    file = Watched(csv)
    for change, words in ((csv.unlink, "No such file or directory"), (csv.touch, "is empty")):
        change()
        assert [file.look(), file.look(), file.look()] == [False, True, False]
        with pytest.raises(ValueError, match=words):
            require_cradle(file.current)
    csv.write_text("new\n")
    assert [file.look(), file.look(), file.look()] == [False, True, False]
    assert file.current.rows == [(1, ["new"])]


@pytest.mark.parametrize("number", [errno.EMFILE, errno.ENFILE])
def test_that_no_more_files_can_be_opened_is_no_change_of_the_file(csv, number):
    file = Watched(csv)
    with patch("os.open", side_effect=OSError(number, "Too many open files")):
        assert [file.look(), file.look(), file.look()] == [False] * 3
    assert [file.look(), file.look()] == [False] * 2


def test_data_can_replace_only_data(tmp_path, monkeypatch):
    file = tmp_path / "data.csv"
    require_replaceable(file)
    require_replaceable(tmp_path)  # whole_file refuses it
    for text in ("", "t,theta_1,momentum\n0.0,1.0,2.0\n"):
        file.write_text(text)
        require_replaceable(file)
    for text in (MIXED_CSV, "t,theta_1,mine\n", "t,mine,momentum\n"):
        file.write_text(text)
        with pytest.raises(ValueError, match=f"^--record: found '{re.escape(str(file))}', "):
            require_replaceable(file)
    opened = Mock(side_effect=PermissionError(errno.EACCES, "Permission denied"))
    monkeypatch.setattr("builtins.open", opened)
    with pytest.raises(ValueError, match="^--record: .*: Permission denied"):
        require_replaceable(file)
    # Excel lets other programs read its file, but not write it
    opened.assert_called_once_with(file, "r+b")
