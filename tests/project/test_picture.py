"""The cradle as ASCII characters: it fits, and each bob is in the right place."""

from itertools import pairwise
from math import radians
from types import SimpleNamespace

import pytest

from grading.cradles import hang, R, row
from support.terminal.picture import TextPicture


def cradle(pend_list):
    """Return the parts of a cradle that a picture uses."""
    axles, bobs, cords = ([pend["objects"][part] for pend in pend_list] for part in range(3))
    return SimpleNamespace(reach=R, axles=lambda: axles, bobs=lambda: bobs, cords=lambda: cords)


def draw(*thetas, columns=80, rows=20):
    """Return the picture of equal pendula at these angles (degrees)."""
    pend_list = [hang(theta=radians(theta), axle=(i * R / 4, 0, 0)) for i, theta in enumerate(thetas)]
    return TextPicture().lines(cradle(pend_list), columns, rows)


AT_REST = """\
                =+===+===+=
                 |   |   |
                 |   |   |
                 |   |   |
                 |   |   |
                 |   |   |
                 |   |   |
                 |   |   |
                (1) (2) (3)"""


def test_three_at_rest():
    assert "\n".join(draw(0, 0, 0)) == AT_REST


def test_the_outer_ones_swing_out():
    """At 30 degrees, a cord of 8 lines ends one line higher, and 8 columns to the side."""
    lines = draw(-30, 0, 30)
    assert lines[7] == "        (1)          |          (3)"
    assert lines[8] == "                    (2)"
    assert [lines[4].count(stroke) for stroke in "/|\\"] == [1, 1, 1]


def test_a_cord_is_drawn_in_its_direction():
    assert draw(90)[0] == "                =+=-------------(1)"
    assert draw(-90)[0] == "(1)-------------=+="
    assert draw(45)[3].strip("/ ") == "\\\\"
    assert draw(-45)[3].strip("\\ ") == "//"


def test_what_is_above_the_axles_comes_into_view_and_stays():
    picture, pend_list = TextPicture(), row(1)
    assert len(picture.lines(cradle(pend_list), 80, 20)) == 9
    up = [hang(theta=radians(180))]
    lines = picture.lines(cradle(up), 80, 20)
    assert (lines[0].strip(), lines[8].strip(), len(lines)) == ("(1)", "=+=", 17)
    assert len(picture.lines(cradle(pend_list), 80, 20)) == 17


@pytest.mark.parametrize("count", [1, 2, 5, 9, 10, 12, 13, 20, 50, 200])
@pytest.mark.parametrize(("columns", "rows"), [(80, 14), (80, 5), (40, 14), (20, 3)])
@pytest.mark.parametrize("theta", [-180, -120, -90, -45, 0, 30, 90, 135])
def test_it_fits_and_is_ascii(count, columns, rows, theta):
    lines = draw(*[theta] * count, columns=columns, rows=rows)
    assert len(lines) <= rows
    assert max(map(len, lines)) <= columns
    assert "".join(lines).isascii()


@pytest.mark.parametrize("count", [3, 7, 13, 20])
def test_bobs_that_hang_are_evenly_apart_and_under_their_cords(count):
    for columns in range(20, 90):
        *_, above, bottom = draw(*[0] * count, columns=columns, rows=40)
        cords = [column for column, character in enumerate(above) if character == "|"]
        apart = {right - left for left, right in pairwise(cords)}
        assert len(apart) <= 1 or apart <= {0, 1}
        if "O" in bottom and cords:
            assert [column for column, character in enumerate(bottom) if character == "O"] == cords
        elif "(" in bottom:
            assert bottom.count("(") == bottom.count(")") == count


@pytest.mark.parametrize(("count", "name"), [(1, "(1)"), (12, "(12)"), (13, "O"), (20, "O")])
def test_every_bob_is_there_by_its_number_where_there_is_room(count, name):
    *_, bottom = draw(*[0] * count)
    names = bottom.replace(")(", ") (").split()
    assert len(names) == count
    assert names[-1] == name
