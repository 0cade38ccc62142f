"""CSVs that are read, refused and edited."""

import os
import re
from pathlib import Path

import pytest
from students import put_files
from whole_cradles import GOOD, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import extract_and_convert
from support.constants import COLOR_MAP, TEXTURE_MAP
from support.files.cradle_csv import LARGEST_FILE, Snapshot
from support.files.valid_cradle import CradleCsv, file_for_pandas, read_cradle, with_numbers


def row(mass=1, e=1, color="red", texture="none"):
    """Return a row below HEADER."""
    return f"{mass},{e},0,0,{color},{texture}\n"


# Files that are no CSV, or give no cradle, and the message after the name of the file
REFUSED = {
    "blank": ("\n  \n,,\n", ": is empty, "),
    "latin-1": (b"\xef\xbb\xbf\n\nros\xe9\n", ", line 3: found byte 0xe9, allowed is text only"),
    "endless cell": (HEADER + '"' + "x" * 200_000, ", line 2: field larger than field limit"),
    "decimal comma": (
        f"\n{HEADER}1,0,5,0,0,red,none\n",
        ", line 3: found 7 cells, allowed are at most 6, as in line 2; a decimal comma needs semi",
    ),
    "no row": (HEADER, ": names columns but has no pendulum, "),
    "no column": (
        "Mass;e\n",
        ", line 1 must name the columns: found no column mass in 'Mass', 'e';",
    ),
    "a row too short": (
        f"{HEADER}1,1,0,0,red\n",
        ", line 2, column texture: found nothing, allowed",
    ),
    "below a cell of two lines": (
        f'{HEADER}\n1,1,0,"0\n0",red,none\n{row(mass=0)}',
        ", line 5, column mass: found '0', allowed is ",
    ),
    # The row after them, with a cell that is too long for a CSV, is not even read
    "too many pendula": (
        HEADER + GOOD * 1001 + '"' + "x" * 200_000,
        ", line 1002: found pendulum 1001, allowed are at most 1000, ",
    ),
}


@pytest.fixture
def save(tmp_path):
    """A function that puts text or bytes into a file and returns the file's path."""
    return lambda content: str(put_files(tmp_path, {"cradle.csv": content}) / "cradle.csv")


def refusal(filepath):
    """Return the message with which a CSV is refused, after the name of the file."""
    with pytest.raises(ValueError, match=f"^{re.escape(filepath)}.*$") as caught:
        read_cradle(Snapshot(filepath))
    return str(caught.value).removeprefix(filepath)


@pytest.mark.parametrize(("content", "message"), REFUSED.values(), ids=REFUSED)
def test_a_csv_is_refused_with_the_place_of_its_mistake(content, message, save):
    assert refusal(save(content)).startswith(message)


@pytest.mark.parametrize(
    ("column", "texts", "allowed"),
    [
        ("mass", ["nan", "1000.5", "0"], "a number from 0.001 to 1000 (kg)"),
        ("e", ["-0.1", "heavy"], "a number from 0 to 1, such as 0.9"),
        ("color", ["mauve"], f"one of {', '.join(COLOR_MAP)}"),
        ("texture", ["velvet"], f"one of {', '.join(TEXTURE_MAP)}"),
    ],
)
def test_a_bad_cell_is_named_with_its_place_and_the_allowed_values(column, texts, allowed, save):
    for text in texts:
        message = refusal(save(HEADER + GOOD + row(**{column: text})))
        place = f", line 3, column {column}: "
        assert message.startswith(f"{place}found {text!r}, allowed is {allowed}")


def test_a_file_that_cannot_be_read_or_is_too_large_is_refused(tmp_path, save):
    assert refusal(str(tmp_path / "no.csv")) == ": cannot be read: No such file or directory"
    assert refusal(str(tmp_path)).startswith(": cannot be read: ")
    file = save("")
    os.truncate(file, LARGEST_FILE + 1)
    assert refusal(file) == ": cannot be read: it has more than 6 MB"


def test_the_smallest_and_the_largest_cradle_are_allowed(save):
    for rows in (GOOD * 1000, row(mass="0.001", e=0), row(mass="1000")):
        read_cradle(Snapshot(save(HEADER + rows)))


# How a CSV may be written, and whether a plain pd.read_csv finds the same cradle in it
READABLE = {
    "shipped": (MIXED_CSV, True),
    "Windows": (("\ufeff\n" + MIXED_CSV).replace("\n", "\r\n\r\n"), True),
    "spaces": (MIXED_CSV.replace(",", " , ").replace("red", '"red"'), False),
    "a comma behind each row": (MIXED_CSV.replace("\n", ",\n"), False),
    "a German Excel": (MIXED_CSV.replace(",", ";").replace(".", ","), False),
}


@pytest.mark.parametrize(("content", "is_plain"), READABLE.values(), ids=READABLE)
def test_the_functions_read_the_csv_itself_or_a_copy_for_pandas(content, is_plain, save):
    csv = read_cradle(Snapshot(save(content)))
    with file_for_pandas(csv) as file:
        assert (file == csv.filepath) == is_plain
        assert extract_and_convert(file) == MIXED
    assert Path(file).exists() == is_plain


def test_the_functions_get_the_csv_that_was_checked_also_if_it_has_changed(save):
    csv = read_cradle(Snapshot(save(MIXED_CSV)))
    for later in ("", MIXED_CSV.replace("0.9", "0.1")):
        save(later)
        with file_for_pandas(csv) as file:
            assert extract_and_convert(file) == MIXED


def test_a_number_for_the_check_is_the_same_number_for_the_functions(save):
    """pandas has rules of its own: for it, this is a text."""
    with file_for_pandas(read_cradle(Snapshot(save(HEADER + row(mass="1_000"))))) as file:
        assert extract_and_convert(file)[0]["mass"] == 1000


def test_an_edit_leaves_the_other_cells_as_they_are():
    cells = [["a, b", "1.50", "1"], ["c", "2", "1"]]
    original = CradleCsv("cradle.csv", ["note", "mass", "e"], cells)
    edited = with_numbers(original, {"mass": [1.5, 0.1 + 0.2], "e": [1]})
    assert original.pendula == cells == [["a, b", "1.50", "1"], ["c", "2", "1"]]
    assert edited.pendula == [["a, b", "1.5", "1.0"], ["c", "0.30000000000000004", "1"]]
