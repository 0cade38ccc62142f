"""The rows of a trace table, laid out as lines of the screen."""

from enum import Enum
from textwrap import wrap
from typing import NamedTuple

from line_by_line.traces import ValueInWords

COLUMNS = 80  # of a terminal
INDENT = 4  # spaces in front of each row
CODE = 34  # columns of a short line of code; the values of all short lines stand below each other
MOST_CODE = 2  # lines of the code of a row
MOST_LINES = 3  # of the values of a row


class Kind(Enum):
    """What a statement has done."""

    STOPPED = "it has stopped"
    MARKED = "its value is not the right one"
    CALLED = "it has called a function that is named"
    GAVE = "it has given a value"
    NO_END = "it never ran to its end, or has none: try"
    IDLE = "it only ran"
    TITLE = "it is the name of another function, whose rows follow"


class Row(NamedTuple):
    """A statement, and what it gave, as lines of the screen."""

    kind: Kind
    number: int  # of the statement; of a title, that of the function's def
    texts: list[str]


class Remark(NamedTuple):
    """What is said of a statement."""

    kind: Kind
    after: str = ""
    below: tuple[str, ...] = ()


def laid_out(number: str, code: str, remark: Remark) -> list[str]:
    """Return a row as lines of the screen: values after short code if they fit, else below it."""
    start = f"{' ' * INDENT}{number}  {code}".ljust(INDENT + len(number) + 2 + CODE)
    after = remark.after
    name, _, value = after.partition(" = ")
    is_one = name.isidentifier() and " = " not in value
    if is_one and not has_room(start, after) and has_room(start, value):
        after = value  # the name stands in the code
    if not after or has_room(start, after):
        lines = [f"{start}  {after}".rstrip()]
    else:
        code_lines = wrap(start.rstrip(), COLUMNS, subsequent_indent=" " * (INDENT + 10))
        lines = cut(code_lines, MOST_CODE) + indented(after)
    for text in remark.below:
        lines += indented(text)
    return lines


def has_room(start: str, after: str) -> bool:
    """Return whether both fit into a line."""
    return len(f"{start}  {after}") <= COLUMNS


def indented(text: str) -> list[str]:
    """Return what is said below a line of code, cut after MOST_LINES."""
    space = " " * (INDENT + 8)
    return cut(wrap(text, COLUMNS, initial_indent=space, subsequent_indent=space), MOST_LINES)


def cut(lines: list[str], most: int) -> list[str]:
    """Return at most this number of lines; if more are left out, the last one ends with ... ."""
    if len(lines) <= most:
        return lines
    return [*lines[: most - 1], shortened(lines[most - 1])]


def shortened(line: str) -> str:
    """Return a line with ... at its end, and without the words that have no room then."""
    if len(line) > COLUMNS - 4:
        line = line[: COLUMNS - 4]
        whole_words = line.rpartition(" ")[0]
        if whole_words.strip():
            line = whole_words
    return f"{line} ..."


def cell(values: list[ValueInWords]) -> str:
    """Return what a statement gave in one turn."""
    texts = [value.text for value in values]
    if not texts:
        return "ran"
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"


def cells(by_turn: dict[int, str], turns: list[int]) -> str:
    """Return the texts of these turns, with ... for those that are left out."""
    texts = []
    last = 0
    for turn in turns:
        if turn > last + 1:
            texts.append("...")
        texts.append(by_turn.get(turn, "-"))
        last = turn
    return " | ".join(texts)


def once(values: list[ValueInWords]) -> str:
    """Return what a statement gave outside of loops.

    A target whose code stands in the line needs no label.
    """
    if len(values) == 1 and not values[0].code.isidentifier():
        return values[0].text
    texts = [f"{value.code} = {value.text}" if value.code else value.text for value in values]
    return ", ".join(texts)
