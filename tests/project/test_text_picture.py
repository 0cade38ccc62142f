"""A picture of the cradle in characters, and the lines around it."""

import os
import re
from itertools import pairwise, product
from math import radians
from types import SimpleNamespace

import pytest
from whole_cradles import GOOD, HEADER

from grading.cradles import hang, R
from support.terminal import players


def test_the_lines_fit_into_a_terminal_of_any_size(swing, monkeypatch):
    motion = swing(angle=170).motion
    motion.impacts.add(1.0, 0, 1, True)
    for rows, columns in product([1, 2, 3, 4, 17, 18, 19], [1, 2, 6, 7, 11, 40]):
        monkeypatch.setattr(
            "shutil.get_terminal_size", lambda size=(columns, rows): os.terminal_size(size)
        )
        for remark in ("", "Write next: handle_collision."):
            lines = players.screen(motion, players.TextPicture(), "0.6x real time", remark)
            assert 1 <= len(lines) <= rows
            assert max(map(len, lines)) <= columns
            assert lines[0] == motion.reading()[:columns].rstrip()
            is_whole = "Impacts" in lines and lines[-1] == "Ctrl+C ends it."[:columns].rstrip()
            assert is_whole == (rows >= 18 and columns >= 7)


# Python 3.10 then returns 0
@pytest.mark.parametrize("size", [(200, 24), (0, 0)], ids=["large", "not known"])
def test_a_screen_has_numbers_remark_picture_and_impacts(swing, monkeypatch, size):
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size(size))
    motion = swing(HEADER + GOOD * 20, angle=180, lift=3).motion
    for left in [*range(19), *range(18, -1, -1)]:
        motion.impacts.add(1.0, left, left + 1, True)
    remark = f"Write next: {'handle_collision, ' * 6}main."
    lines = players.screen(motion, players.TextPicture(), "0.6x real time", remark)
    assert len(lines) <= 24
    assert lines[0].startswith("t = 0.00 s")
    assert " ".join(lines[1:3]) == remark
    assert lines[3] == "0.6x real time"
    impacts, *rest = lines[lines.index("Impacts") + 1 :]
    assert impacts.startswith("t = 1.00 s  1-2-3-...-20  ")
    assert len(impacts) == 80
    assert rest == ["", "", "", "", "Ctrl+C ends it."]


# --- the picture ----------------------------------------------------------------------------------


def draw(*thetas, picture=None):
    """Return the picture of equal pendula at these angles (degrees)."""
    pendula = [hang(theta=radians(theta), axle=(i * R / 4, 0, 0)) for i, theta in enumerate(thetas)]
    axles, bobs, cords = zip(*(pend["objects"] for pend in pendula), strict=True)
    cradle = SimpleNamespace(
        cords_length=R, axles=lambda: axles, bobs=lambda: bobs, cords=lambda: cords
    )
    return (picture or players.TextPicture()).lines(cradle, columns=80, rows=20)


def test_each_bob_is_in_its_place_on_a_cord_in_its_direction():
    """At 30 degrees, a cord of 8 lines ends one line higher, and 8 columns to the side."""
    assert draw(0, 0, 0) == [
        " " * 16 + line for line in ["=+===+===+=", *[" |   |   |"] * 7, "(1) (2) (3)"]
    ]
    lines = draw(-30, 0, 30)
    assert lines[7:] == ["        (1)          |          (3)", "                    (2)"]
    assert [lines[4].count(stroke) for stroke in "/|\\"] == [1, 1, 1]
    assert draw(90)[0] == "                =+=-------------(1)"
    assert draw(-90)[0] == "(1)-------------=+="
    assert draw(45)[3].strip("/ ") == "\\\\"
    assert draw(-45)[3].strip("\\ ") == "//"


def test_the_space_above_the_axles_comes_into_view_and_stays():
    picture = players.TextPicture()
    assert len(draw(0, picture=picture)) == 9
    lines = draw(180, picture=picture)
    assert len(lines) == 17
    assert lines[0].strip() == "(1)"
    assert lines[8].strip() == "=+="
    assert len(draw(0, picture=picture)) == 17


@pytest.mark.parametrize(("count", "name"), [(1, "(1)"), (12, "(12)"), (13, "O"), (50, "O")])
def test_bobs_have_numbers_while_there_is_room_and_hang_under_their_cords(count, name):
    *_, above, bottom = draw(*[0] * count)
    names = [*re.finditer(r"\(\d+\)|O", bottom)]
    assert len(names) == count
    assert names[-1][0] == name
    cords = [match.start() for match in re.finditer(r"\|", above)]
    for match, cord in zip(names, cords, strict=True):
        assert (match.start() + match.end() - 1) / 2 == pytest.approx(cord, abs=1)
    # Unequal gaps look like groups of bobs
    assert len({right - left for left, right in pairwise(cords)}) <= 1
