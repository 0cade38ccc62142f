"""Calls, values and errors as text for students."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple

from vpython import vector

from grading.assignment import FUNCTIONS, PROGRAM
from grading.raised import Place
from grading.words import in_words, text_of
from line_by_line.table import COLUMNS

LABEL = 12  # columns of the labels
MOST_OF_FILE = 8  # lines of the longest file that is shown whole
LINES_OF_FILE = 4  # shown of a longer one
MOST_LINES = 3  # shown of a result, and of an expected value


@dataclass(frozen=True)
class Expected:
    """What several values can be: as text, and as a test of a value."""

    text: str
    test: Callable
    like: Any = None  # an example of its form

    def __repr__(self) -> str:
        return self.text


class PlainFile(NamedTuple):
    """A file whose path is an argument of a call."""

    path: str
    text: str


def own_copies(arguments: Sequence) -> tuple:
    """Return arguments for a student's code, which may change a vector: it gets one of its own."""
    return tuple(vector(value) if isinstance(value, vector) else value for value in arguments)


class Call(NamedTuple):
    """A call of a student's function; arguments has plain copies from before the call."""

    function: str
    arguments: tuple | None = None  # None if the function was not found
    times: int = 1

    def lines(self, index: int = 0) -> list[str]:
        """Return the call as text, and below it the values of pendula and files that it reads.

        index is that of a pendulum that must be among those of a list.
        """
        function = FUNCTIONS[self.function]
        if self.arguments is None:
            return [f"{self.function}({function.parameters})"]
        arguments = []
        below = []
        if self.times > 1:
            below.append(f"{self.times} times in a row")
        names = function.parameters.split(", ")
        if self.function == PROGRAM:
            return [f"{PROGRAM}, for {self.arguments[0]}", *below]
        for name, value in zip(names, self.arguments, strict=False):
            if not value or not isinstance(value, (PlainFile, dict, list)):
                arguments.append(f"{name}={text_of(value)}")
                continue
            arguments.append(name)
            if isinstance(value, PlainFile) and self.function != "extract_and_convert":
                # The pendula say what is in it
                below.append(f"{name} is the path of {Path(value.path).name}")
            else:
                below += value_lines(name, value, function.reads, index)
        call = f"{self.function}({', '.join(arguments)})"
        return [*wrap(call, COLUMNS - LABEL), *below]


def plain(value: Any) -> Any:
    """Return a plain copy of an argument: a file with its text, pendula with the bob's place."""
    if isinstance(value, list):
        return [plain(element) for element in value]
    if isinstance(value, vector):
        return vector(value)
    if isinstance(value, dict):
        with suppress(Exception):  # it has no objects, or a student's code has changed them
            bob = value["objects"][1]
            return {**value, "bob": tuple(bob.pos.value), "radius": bob.radius}
    if isinstance(value, str) and Path(value).is_file():
        return PlainFile(value, Path(value).read_text(encoding="utf-8", errors="replace"))
    return value


def value_lines(name: str, value: Any, keys: tuple[str, ...], index: int = 0) -> list[str]:
    """Return lines about a long argument: a file, a pendulum, or a list of pendula.

    keys are those of a pendulum that are shown. index is that of a pendulum that must be shown.
    """
    if isinstance(value, PlainFile):
        rows = value.text.splitlines()
        if len(rows) > MOST_OF_FILE:
            rows[LINES_OF_FILE - 1 :] = [f"... ({len(rows)} lines in all)"]
        return [f"{name} is the path of {Path(value.path).name}:", *(f"    {row}" for row in rows)]
    if isinstance(value, list):
        lines = []
        indexes = [0, 1, max(2, index)][: len(value)]
        for i in indexes:
            lines += value_lines(f"{name}[{i}]", value[i], keys)
        if len(value) > len(indexes):
            lines.append(f"... ({len(value)} in all)")
        return lines
    parts = []
    for key in keys:
        if key in value:
            parts.append(f"{key} {text_of(value[key], 4 if key == 'bob' else 6)}")
    return [f"{name}: {', '.join(parts)}"]


def about(what: str, value: Any, digits: int = 6) -> list[str]:
    """Return a value as lines, after its name in what: in one line if it is short."""
    start = f"{what}: " if what else ""
    has_pendula = isinstance(value, list) and dict in map(type, value)
    text = in_words(value) if has_pendula and not what else text_of(value, digits)
    return wrap(f"{start}{text}", COLUMNS - LABEL, max_lines=MOST_LINES, placeholder=" ...")


def place_lines(places: Sequence[Place]) -> list[str]:
    """Return places in a student's own files as lines of text."""
    lines = []
    for place in places:
        lines.append(f"{place}, in {place.function}" if place.function else f"{place}")
        lines.append(f"    {place.code}")
    return lines if len(lines) <= 4 else [*lines[:2], "...", *lines[-2:]]


def labelled(label: str, text: str | list[str]) -> list[str]:
    """Return a text, or its lines, behind a label, as lines of the screen."""
    lines = [text] if isinstance(text, str) else "\n".join(text).split("\n")
    found = []
    for line in lines:
        for wrapped in wrap(line, COLUMNS - LABEL) or [""]:
            found.append(f"{label:<{LABEL}}{wrapped}".rstrip())
            label = ""  # it stands in the first line only
    return found
