"""The room on a student's screen: the order in which parts are left out, and those that fit."""

from enum import IntEnum
from textwrap import wrap
from typing import NamedTuple

from line_by_line.layout import COLUMNS

LABEL = 12  # columns of the labels
YOUR_CODE = "your code"  # the label above the rows of a table


class Rank(IntEnum):
    """What a student reads about a mistake. If there is no room for all, the last is left out."""

    ALWAYS = 0  # what is wrong, the call, both values; a line that stopped, is marked, or stored it
    RIGHT = 1  # what is right there
    SEEN = 2  # sentences about what was seen
    STEPS = 3  # the steps of the function
    LEADING = 4  # lines of code from which a value goes into one of those that stay
    CALLED = 5  # the other lines: of these, first those that call functions
    GAVE = 6
    NO_END = 7
    PRINTED = 8  # by the student's code
    OTHER_CHECKS = 9  # that fail, too
    READ = 10  # the place in the handout
    OTHER_CALLS = 11
    IDLE = 12  # lines of code that only ran
    BOOKS = 13  # lines of Python, with books, that show what the function needs
    NEVER = 14  # is left out, with room, too


class Part(NamedTuple):
    """Lines of the screen that are shown or left out together."""

    rank: int
    lines: list[str]
    is_row: bool = False  # of a table
    is_title: bool = False  # of the table of a helper


def labelled(label: str, text: str | list[str]) -> list[str]:
    """Return a text, or its lines, behind a label, as lines of the screen."""
    lines = [text] if isinstance(text, str) else "\n".join(text).split("\n")
    found = []
    for line in lines:
        for wrapped in wrap(line, COLUMNS - LABEL) or [""]:
            found.append(f"{label:<{LABEL}}{wrapped}".rstrip())
            label = ""  # it stands in the first line only
    return found


def in_order_of_ranks(parts: list[Part]) -> list[int]:
    """Return the indexes of the parts, those with the lowest ranks first.

    Of equal rows, the last is nearest to the result; a title comes before its rows.
    """

    def key(i: int) -> tuple[int, int]:
        if parts[i].is_title:
            return parts[i].rank, -len(parts)
        return parts[i].rank, -i if parts[i].is_row else i

    return sorted(range(len(parts)), key=key)


def fitting(parts: list[Part], height: int) -> list[str]:
    """Return the lines of the parts for which there is room, in their order."""
    kept = set()
    for i in in_order_of_ranks(parts):
        has_room = len(parts[i].lines) <= height and parts[i].rank != Rank.NEVER
        if has_room or parts[i].rank == Rank.ALWAYS:
            kept.add(i)
            height -= len(parts[i].lines)
    shown: list[Part] = []
    for i in sorted(kept, reverse=True):
        # The title of a helper's table needs a row below it
        if not parts[i].is_title or (shown and shown[0].is_row):
            shown.insert(0, parts[i])
    left_out = len([part for part in parts if part.is_row and part not in shown])
    lines = [line for part in shown for line in part.lines]
    if left_out:
        left = f"{left_out} line is" if left_out == 1 else f"{left_out} lines are"
        lines = [
            f"{line} ({left} left out)" if line.startswith(YOUR_CODE) else line for line in lines
        ]
    return lines
