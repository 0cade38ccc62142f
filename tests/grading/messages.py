"""Calls, values and errors as text for students."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple

from pandas import DataFrame
from vpython import box, cylinder, sphere, vector

from grading.handout import FUNCTIONS, PROGRAM
from grading.raised import Place, StoppedError
from grading.room import LABEL
from line_by_line.layout import COLUMNS
from line_by_line.words import FORMS, Noun, NOUNS, text_of, TEXTS, WIDTH
from support.start.output import in_one_line

MOST_OF_FILE = 8  # lines of the longest file that is shown whole
LINES_OF_FILE = 4  # shown of a longer one
MOST_LINES = 5  # shown of a result, and of an expected value
MOST_CHARACTERS = 300  # shown of an error's text


@dataclass(frozen=True)
class Expected:
    """What several values can be: as text, and as a test of a value."""

    text: str
    test: Callable
    like: Any = None  # an example of its form


def vector_text(value: vector, digits: int) -> str:
    return f"vector({', '.join(text_of(number, digits) for number in value.value)})"


# The words for the values of a cradle
FORMS |= {box: "an axle", sphere: "a bob", cylinder: "a cord"}
NOUNS.insert(0, Noun("mass", "pendulum", "pendula"))
TEXTS |= {
    vector: vector_text,
    DataFrame: lambda table, _: f"a table of {len(table)} rows",
    Expected: lambda expected, _: expected.text,
}
for shape in (box, sphere, cylinder):
    TEXTS[shape] = lambda value, _: f"{FORMS[type(value)]} at {vector_text(value.pos, 4)}"


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

    def with_numbers(self) -> str:
        """Return the call in one line, without the names of its parameters."""
        times = f" {self.times} times" if self.times > 1 else ""
        return f"{self.function}({', '.join(map(text_of, self.arguments or ()))}){times}"

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
    """Return a plain copy of an argument: a file with its text, pendula without objects."""
    if isinstance(value, list):
        return [plain(element) for element in value]
    if isinstance(value, vector):
        return vector(value)
    if isinstance(value, dict) and "objects" in value:
        # A student's code may have changed the objects
        with suppress(TypeError, ValueError, AttributeError):
            axle, bob = value["objects"][:2]
            copy = {key: part for key, part in value.items() if key != "objects"}
            copy["axle"] = tuple(axle.pos.value)
            copy["bob"] = tuple(bob.pos.value)
            copy["radius"] = bob.radius
            return copy
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
    lines = text_of(value, digits).split("\n")
    if len(lines) > MOST_LINES:
        lines[MOST_LINES - 1 :] = [" ..."]
    if not what:
        return lines
    if len(lines) == 1 and len(what + lines[0]) < WIDTH:
        return [f"{what}: {lines[0]}"]
    return [f"{what}:", *lines]


def place_lines(places: Sequence[Place]) -> list[str]:
    """Return places in a student's own files as lines of text."""
    lines = []
    for place in places:
        lines.append(f"{place}, in {place.function}" if place.function else f"{place}")
        lines.append(f"    {place.code}")
    return lines if len(lines) <= 4 else [*lines[:2], "...", *lines[-2:]]


def end_of(raised: StoppedError) -> tuple[str, list[str]]:
    """Return, as (label, lines), how the grader has stopped a call that went over a limit."""
    end = f"nothing; it {raised.limit} and was stopped"
    places = place_lines(raised.places)
    return "came back", [f"{end} here:", *places] if places else [f"{end}."]


def error_lines(raised: StoppedError) -> list[str]:
    """Return what an error says, as lines of text."""
    return [in_one_line(line) for line in raised.text[:MOST_CHARACTERS].split("\n")]
