"""Edit a CSV in memory: the cells that nobody edits keep their text."""

import pytest

from support.files.cradle_csv import read_cells, Snapshot
from support.files.edited_csv import cells_of, with_cell, with_numbers, with_row, without_row

TEXT = 'note,mass , e\n"a, b",1.50,1\nshort\n\n"say ""hi""",3,0.5\n'


@pytest.fixture
def original(tmp_path):
    path = tmp_path / "cradle.csv"
    path.write_text(TEXT)
    return Snapshot(path)


def rows(csv):
    return [cells for _, cells in read_cells(csv)]


HEADER, FIRST, SHORT, LAST = ["note", "mass", "e"], ["a, b", "1.50", "1"], ["short", "", ""], ['say "hi"', "3", "0.5"]


@pytest.mark.parametrize(
    ("edited", "expected"),
    [
        (lambda csv: with_cell(csv, 0, "e", "x,y"), [["a, b", "1.50", "x,y"], SHORT, LAST]),
        (lambda csv: with_cell(csv, 1, "mass", "2"), [FIRST, ["short", "2", ""], LAST]),
        (with_row, [FIRST, SHORT, LAST, LAST]),
        (lambda csv: without_row(csv, 0), [SHORT, LAST]),
        (lambda csv: without_row(csv, 2), [FIRST, SHORT]),
        (
            lambda csv: with_numbers(csv, "mass", [1.5, 2, 4.0]),
            [FIRST, ["short", "2.0", ""], ['say "hi"', "4.0", "0.5"]],
        ),
        (lambda csv: with_numbers(csv, "mass", [9]), [["a, b", "9.0", "1"], SHORT, LAST]),
    ],
)
def test_an_edit(original, edited, expected):
    csv = edited(original)
    assert rows(csv) == [HEADER, *expected]
    assert str(csv) == str(original)
    assert rows(original)[1:] == [FIRST, ["short"], LAST]  # unchanged, as is its file
    assert Snapshot(original.filepath).data == TEXT.encode()


def test_a_number_comes_back_to_the_last_bit(original):
    csv = with_numbers(original, "e", [0.1 + 0.2, 1 / 3, 1e-300])
    assert [float(cells[2]) for cells in cells_of(csv)[1]] == [0.1 + 0.2, 1 / 3, 1e-300]


def test_edits_add_up(original):
    csv = with_cell(with_row(original), 3, "mass", "8")
    assert [cells[1] for cells in cells_of(csv)[1]] == ["1.50", "", "3", "8"]
