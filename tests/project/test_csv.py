"""CSVs that are read, refused and edited."""

import os
import re
from pathlib import Path
from unittest.mock import patch

import pytest
from students import put_files
from whole_cradles import GOOD, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert
from support.constants import COLOR_MAP, TEXTURE_MAP
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import CradleCsv, file_for_pandas, read_cradle
from support.page.cradle_settings import with_numbers

MASS = "a number from 1e-300 to 1e6 (kg)"
NAMES = ", line 1 must name the columns: found "

# Files that are no CSV, or give no cradle; the message after the name of the file has these texts.
REFUSED = {
    "blank": ("\n  \n,,\n", ": is empty"),
    "latin-1": ("\ufeffmass\n1\nros".encode() + b"\xe9\n", ", line 3: found byte 0xe9", "UTF-8"),
    "a workbook": (b"PK\3\4\xff", ": is a workbook; save it as CSV"),
    "an old workbook": (b"\xd0\xcf\x11\xe0", ": is a workbook; save it as CSV"),
    "UTF-16": (HEADER.encode("utf-16"), ": is text in UTF-16; save it in UTF-8"),
    "endless cell": (HEADER + '"' + "x" * 200_000, ", line 2: field larger than field limit"),
    "a decimal comma": (
        "\ncolor,texture,mass,e,,\nred,metal,1,0,5\n",
        ", line 3: found 5 cells, allowed are at most 4, as in line 2; a decimal comma needs semi",
    ),
    "header only": (HEADER, ": names columns but has no pendulum"),
    "two columns mass": ("mass,mass\n", f"{NAMES}2 columns mass", "mass, e, color, texture"),
    "no column": ("Mass;e\n", f"{NAMES}no column mass in 'Mass', 'e'; "),
    "a long line": ("x" * 1000 + "\n", NAMES, f" '{'x' * 299}...; "),
    "row too short": (HEADER + "1,1,0,0,red\n", ", line 2, column texture: found nothing, "),
    # The row after them, with a cell that is too long for a CSV, is not even read
    "too many pendula": (
        HEADER + "\n" + GOOD * 1001 + '"' + "x" * 200_000,
        ", line 1003: found pendulum 1001",
        "at most 1000",
    ),
    "after blank lines and a cell of two lines": (
        '\nnote,mass,e,color,texture\n\n"one\ntwo",1,1,red,none\nx,0,1,red,none\n',
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


def test_a_file_that_cannot_be_read_is_refused_and_a_large_one_before_it_is_read(tmp_path, save):
    assert refusal(str(tmp_path / "no.csv")) == ": cannot be read: No such file or directory"
    assert refusal(str(tmp_path)).startswith(": cannot be read: ")
    file = save("")
    os.truncate(file, 3 * 10**9)
    with patch.object(Path, "read_bytes", side_effect=AssertionError):
        message = refusal(file)
    assert message == ": cannot be read: found more than 10 MB, allowed are at most 10 MB"


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
        ("mass", ["heavy", "nan", "1000000.5", "0", "1e-310"], MASS),
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


# How a CSV may be written, and whether a plain pd.read_csv finds the same cradle in it
READABLE = {
    "the shipped way": (MIXED_CSV, True),
    "Windows": (("\ufeff\n" + MIXED_CSV).replace("\n", "\r\n\r\n"), True),
    "spaces": (MIXED_CSV.replace(",", " , ").replace("red", '"red"'), False),
    "commas behind each row": (MIXED_CSV.replace("\n", ",\n"), False),
    "a comma behind each row below": (
        MIXED_CSV.replace("\n", ",\n").replace(",\n", "\n", 1),
        False,
    ),
    "a German Excel": (MIXED_CSV.replace(",", ";").replace(".", ","), False),
}


@pytest.mark.parametrize(("content", "is_plain"), READABLE.values(), ids=READABLE)
def test_the_functions_read_the_csv_itself_or_a_copy_for_pandas(content, is_plain, save):
    csv = read_cradle(Snapshot(save(content)))
    with file_for_pandas(csv) as file:
        assert (file == csv.filepath) == is_plain
        assert Path(file).name == "cradle.csv"
        assert extract_and_convert(file) == MIXED
    assert Path(file).exists() == is_plain


@pytest.mark.parametrize("later", ["", MIXED_CSV.replace("0.9", "0.1"), MIXED_CSV + GOOD])
def test_the_functions_get_the_csv_that_was_checked_also_if_the_file_has_changed(later, save):
    csv = read_cradle(Snapshot(save(MIXED_CSV)))
    save(later)
    with file_for_pandas(csv) as file:
        assert extract_and_convert(file) == MIXED


@pytest.mark.parametrize("text", ["1_000", "0.00000000000000000000012345", "+1.e2"])
def test_a_number_for_the_check_is_the_same_number_for_the_functions(text, save):
    """pandas has rules of its own, which change from version to version."""
    with file_for_pandas(read_cradle(Snapshot(save(LINES["mass"].format(text))))) as file:
        assert extract_and_convert(file)[1]["mass"] == float(text)


def test_an_edit_leaves_the_other_cells_as_they_are():
    cells = [["a, b", "1.50", "1"], ["c", "2", "1"]]
    original = CradleCsv("cradle.csv", ["note", "mass", "e"], cells)
    edited = with_numbers(original, {"mass": [1.5, 0.1 + 0.2], "e": [1]})
    assert original.pendula == cells == [["a, b", "1.50", "1"], ["c", "2", "1"]]
    assert edited.pendula == [["a, b", "1.50", "1"], ["c", "0.30000000000000004", "1"]]
