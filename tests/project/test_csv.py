"""CSVs that are read, refused and edited."""

import errno
import os
import re
from pathlib import Path
from unittest.mock import Mock

import pytest
from hypothesis import strategies as st
from programs import on_posix
from strategies import random_examples
from students import put_files
from whole_cradles import GOOD, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert
from support.constants import COLOR_MAP, TEXTURE_MAP
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import clean_copy, CradleCsv, read_cradle
from support.page.cradle_settings import with_numbers

MASS = "a number from 1e-300 to 1e6 (kg)"
IN_CELL_5 = "is in cell 5 of 6"
HINTS = ["the quotes around", IN_CELL_5]
NAMES = ", line 1 must name the columns: found "

# Files that are no CSV, or give no cradle. The message goes on after the name of the file, and has
# the other texts later.
REFUSED = {
    "blank": ("\ufeff\ufeff\n  \n\n", ": is empty"),
    "zero byte": (b"mass,e\n1,\x00\n", ", line 2: found a zero byte", "UTF-8"),
    "latin-1": (b"mass\n1\nros\xe9\n", ", line 3: found byte 0xe9", "UTF-8"),
    "endless cell": (HEADER + '"' + "x" * 200_000, ", line 2: field larger than field limit"),
    "large": (" " * 10_000_001, ": cannot be read: found more than 10 MB", "at most 10 MB"),
    "zero bytes, as many as allowed": (b"\0" * 10_000_000, ", line 1: found a zero byte"),
    "too many cells, below a column without a name": (
        "color,texture,mass,e,\nred,metal,1,0,9\n",
        ", line 2: found 5 cells",
        "at most 4, as in line 1; ",
    ),
    "header only": (HEADER, ": names columns but has no pendulum"),
    "two columns mass": ("mass,mass\n", f"{NAMES}2 columns mass", "mass, e, color, texture"),
    "no column": ("mass,E,color,texture\n", f"{NAMES}no column e in 'mass', 'E', "),
    "semicolons": ("sep=;\ne;Mass\n", ", line 2 must name", "no column mass in 'e', 'Mass'; "),
    "quotes": ('"mass; e"\n"1;1"\n', NAMES, "in 'mass; e'; ", "the quotes around"),
    "a long line": ("x" * 1000 + "\n", NAMES, f" '{'x' * 299}...; "),
    "a line as long as in a message": ("x" * 298, NAMES, f" '{'x' * 298}'; "),
    "a workbook": (b"PK\3\4\xff", ": is a workbook"),
    "an old workbook": (b"\xd0\xcf\x11\xe0", ": is a workbook"),
    "a blank line above": ("\n" + HEADER + "0,1,0,0,red,metal\n", ", line 3, column mass: found"),
    "row too short": (
        HEADER + "1,1,0,0,red\n",
        ", line 2, column texture: found nothing, ",
        IN_CELL_5,
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
        read_cradle(Snapshot(filepath), cords)
    return str(caught.value).removeprefix(filepath)


@pytest.mark.parametrize("mistake", REFUSED)
def test_a_csv_is_refused_with_the_place_of_its_mistake(mistake, save):
    content, beginning, *parts = REFUSED[mistake]
    message = refusal(save(content))
    assert message.startswith(beginning)
    assert [part for part in parts if part not in message] == []
    hints = [hint for hint in HINTS if hint in " ".join(parts)]
    assert [hint for hint in HINTS if hint in message] == hints


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
        assert IN_CELL_5 not in message


def test_the_smallest_and_the_largest_cradle_are_allowed(save):
    read_cradle(Snapshot(save(HEADER + GOOD * 1000)))
    for column, text in [("e", "0"), ("e", "1"), ("mass", "1e-300"), ("mass", "1e6")]:
        read_cradle(Snapshot(save(LINES[column].format(text))))


def test_the_masses_of_a_double_cradle_may_differ_by_a_factor_of_a_million(save):
    read_cradle(Snapshot(save(LINES["mass"].format("1e-6"))), cords=2)
    file = save(LINES["mass"].format("9.9999995e-7"))
    read_cradle(Snapshot(file))
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
    "a German Excel": "sep=;\r\n" + MIXED_CSV.replace(",", ";").replace(".", ","),
    "tabs": MIXED_CSV.replace(",", "\t"),
    "a minus": MIXED_CSV.replace("-", "\u2212"),
}


@pytest.mark.parametrize("content", READABLE.values(), ids=READABLE)
def test_a_csv_is_read_however_a_program_has_written_it_and_also_when_it_is_gone(content, save):
    """A plain pd.read_csv reads its clean copy, whose path is a plain one."""
    csv = read_cradle(Snapshot(save(content)))
    os.remove(csv.filepath)
    with clean_copy(csv) as copy:
        assert type(copy) is str
        assert Path(copy).name == "cradle.csv"
        assert extract_and_convert(copy) == MIXED
    assert not Path(copy).exists()


def test_a_full_disk_names_the_copy(monkeypatch):
    full = OSError(errno.ENOSPC, "No space left on device")
    monkeypatch.setattr("csv.writer", Mock(side_effect=full))
    message = r"cannot be written: No space left on device: '.+cradle\.csv'$"
    csv = CradleCsv("cradle.csv", ["mass"], [["1"]])
    with pytest.raises(OSError, match=message), clean_copy(csv):
        pass


NUMBERS = st.from_regex(r"\A[0-9]{1,2}(\.[0-9]{0,2})?([eE][+-]?[0-9])?\Z")
ODD = st.text("0123456789.eE+-x ", min_size=1, max_size=6)


@random_examples(50, text=NUMBERS | ODD)
def test_a_number_for_the_check_is_a_number_for_pandas(text):
    """The check reads the text of a cell itself.

    A cell that it accepts must not become text in pend_list.
    """
    data = f"mass,e,color,texture\n{text},1,red,none\n".encode()
    try:
        csv = read_cradle(Snapshot("cradle.csv", data))
    except ValueError:
        return
    with clean_copy(csv) as copy:
        [pend_dict] = extract_and_convert(copy)
    assert isinstance(pend_dict["mass"], (int, float))
    assert pend_dict["mass"] == float(text)


def test_the_copy_of_a_long_number_has_only_digits_that_pandas_2_reads():
    cells = ["00000000000000001", "0.00000000000000000000012345", "0.02000000000000000045"]
    with clean_copy(CradleCsv("cradle.csv", ["id", "mass", "e"], [cells])) as copy:
        assert Path(copy).read_text().split() == ["id,mass,e", "00000000000000001,1.2345e-22,2e-2"]


def test_an_edit_leaves_the_other_cells_as_they_are():
    cells = [["a, b", "1.50", "1"], ["c", "2", "1"]]
    original = CradleCsv("cradle.csv", ["note", "mass", "e"], cells)
    edited = with_numbers(original, {"mass": [1.5, 0.1 + 0.2], "e": [1]})
    assert original.pendula == cells == [["a, b", "1.50", "1"], ["c", "2", "1"]]
    assert edited.pendula == [["a, b", "1.50", "1"], ["c", "0.30000000000000004", "1"]]
