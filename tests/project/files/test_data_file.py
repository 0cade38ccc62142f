"""Files are written whole or not at all."""

import errno
import os

import pytest
from whole_cradles import FIVE_CSV, HEADER

from grading.cradles import MIXED, MIXED_CSV
from src.pds_helper import write_to_csv
from src.special_cradles import make_newton_cradle
from support.constants import R_PARAM
from support.files.data_file import whole_file

# --- write_to_csv -------------------------------------------------------------------------------


def test_write_to_csv_makes_a_column_of_each_key_but_objects_and_leaves_pend_list_alone(csv):
    """Also of a key that only some pendula have, and with text in any language.

    Numbers have all their digits.
    """
    csv.write_text(MIXED_CSV)
    pend_list = make_newton_cradle(csv, R_PARAM, 0.1 + 0.2)
    pend_list[1]["note"] = "schön, \u03c9"
    before = [dict(pend_dict) for pend_dict in pend_list]
    write_to_csv(pend_list, csv)
    assert pend_list == before
    assert csv.read_text(encoding="utf-8").splitlines() == [
        "mass,e,theta,omega,color,texture,note",
        "1.5,0.9,0.30000000000000004,0,red,metal,",
        '2.5,0.8,0,0,blue,none,"schön, \u03c9"',
        "0.5,0.7,0,0,yellow,wood,",
    ]


def test_write_to_csv_writes_a_header_for_an_empty_list(csv):
    write_to_csv([], csv)
    assert csv.read_text() == HEADER


# --- whole files --------------------------------------------------------------------------------


def contents(folder):
    """Return the text of each file in this folder, by its name."""
    return {path.name: path.read_text() for path in folder.iterdir()}


def test_a_file_is_replaced_only_when_the_new_one_is_complete(csv):
    with whole_file(csv) as new:
        new.write("new \u03c9")
        assert csv.read_text() == FIVE_CSV
    assert csv.read_bytes() == "new \u03c9".encode()


@pytest.mark.parametrize(
    ("error", "name"),
    [
        (KeyboardInterrupt(), None),
        (OSError(errno.ENOSPC, "No space left on device"), "cradle.csv"),
        (FileNotFoundError(errno.ENOENT, "No such file", "of a function"), "of a function"),
    ],
)
def test_an_error_leaves_the_old_file_and_nothing_else(error, name, csv, monkeypatch):
    monkeypatch.chdir(csv.parent)
    with pytest.raises(type(error)) as caught, whole_file("cradle.csv") as new:
        new.write("half")
        raise error
    assert getattr(caught.value, "filename", None) == name
    assert contents(csv.parent) == {"cradle.csv": FIVE_CSV}


@pytest.mark.parametrize("name", ["gone/cradle.csv", ".", os.devnull])
def test_a_file_that_cannot_be_written_is_named_as_it_was_given(name, csv, monkeypatch):
    monkeypatch.chdir(csv.parent)
    with pytest.raises(OSError, match=f": '{name}'$"):
        write_to_csv(MIXED, name)
