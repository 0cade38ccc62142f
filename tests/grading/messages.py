"""Calls, values and errors as text for students."""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice
from numbers import Real
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple

from vpython import box, cylinder, sphere, vector

from grading.handout import FUNCTIONS
from grading.raised import Place, StoppedError
from support.start.output import in_one_line

TERMINAL_COLUMNS = 80  # of a terminal
LABEL = 12  # columns of the labels of a message
WIDTH = 62  # of the values after the labels
MOST_ELEMENTS = 20  # shown of a list
MOST_DICTIONARIES = 1  # shown of a list of dictionaries
MOST_OF_FILE = 8  # lines of the longest file that is shown whole
LINES_OF_FILE = 4  # shown of a longer one
MOST_LINES = 5  # shown of a result, and of an expected value
MOST_CHARACTERS = 300  # shown of a text
MOST_PARTS = 10_000  # of a value that is shown

SHAPES = {box: "an axle", sphere: "a bob", cylinder: "a cord"}
FORMS = {
    list: "a list",
    tuple: "a tuple",
    dict: "a dictionary",
    str: "text",
    bool: "a bool",
    type(None): "None",
}
PLACES = {"axle", "bob", "radius"}  # the keys that a plain copy of a pendulum has for its objects


@dataclass(frozen=True)
class Expected:
    """What several values can be: as text, and as a test of a value."""

    text: str
    test: Callable
    like: Any = None  # an example of its form


class PlainFile(NamedTuple):
    """A file whose path is an argument of a call."""

    path: str
    text: str


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
        return [*wrap(call, TERMINAL_COLUMNS - LABEL), *below]


def plural(count: int, singular: str, several: str) -> str:
    """Return a number with its noun: "1 bob", "2 bobs"."""
    return f"{count} {singular if count == 1 else several}"


def plain(value: Any) -> Any:
    """Return a plain copy of an argument: a file with its text, pendula without objects."""
    if isinstance(value, list):
        return [plain(element) for element in value]
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


class Damage(NamedTuple):
    """What a call has done to a pendulum among its arguments: a verb, and how it is now."""

    verb: str
    text: str


def damage(before: Sequence, names: str, arguments: Sequence) -> Iterator[Damage]:
    """Yield the damage of each pendulum in the arguments of a call that is none any more.

    The text has its name and its value. before has plain copies of the arguments from before the
    call, names are their names with commas.
    """
    for name, old, value in zip(names.split(", "), before, arguments, strict=False):
        if isinstance(value, list) and isinstance(old, list):
            yield from damage(old, ", ".join(f"{name}[{i}]" for i in range(len(old))), value)
        elif isinstance(old, dict):
            now = plain(value)
            if not isinstance(now, dict):
                yield Damage("has lost a pendulum", f"{name}: {text_of(now)}")
                continue
            lost = sorted(old.keys() - now.keys() - PLACES)
            if lost:
                yield Damage("has taken a key from a pendulum", f"{name}: without {lost[0]}")
            elif "objects" in now or "bob" not in now:
                yield Damage("has changed the objects of a pendulum", f"{name}: with other objects")


def text_of(value: Any, digits: int = 6) -> str:
    """Return a value as text, numbers with this number of digits.

    Each dictionary of a list has its own line.
    """
    try:
        return text_in_parts(value, digits, iter(range(MOST_PARTS)))
    except RecursionError:
        return f"a {type(value).__name__} that contains itself"
    except StopIteration:
        return f"a {type(value).__name__} with more than {MOST_PARTS} parts"
    except Exception:
        return f"a {type(value).__name__} that has no text"


def form_of(value: Any) -> str:
    """Return the form of a value as text."""
    for kind, form in FORMS.items():
        if isinstance(value, kind):
            return form
    return "a number" if isinstance(value, Real) else f"a {type(value).__name__}"


def text_in_parts(value: Any, digits: int, parts: Iterator[int]) -> str:
    """Do what text_of does, but let errors of the value pass.

    parts is an iterator that ends after the greatest number of parts.
    """
    next(parts)
    if isinstance(value, Expected):
        return value.text
    if isinstance(value, Real) and not isinstance(value, bool):
        return f"{value + 0:.{digits}g}"  # no -0
    if isinstance(value, vector):
        numbers = [text_in_parts(number, digits, parts) for number in value.value]
        return f"vector({', '.join(numbers)})"
    if type(value) in SHAPES:
        return SHAPES[type(value)]
    if isinstance(value, dict):
        rows = []
        for key, part in islice(value.items(), MOST_ELEMENTS):
            key_text = text_in_parts(key, digits, parts)
            rows.append(f"{key_text}: {text_in_parts(part, digits, parts)}")
        return "{" + joined(rows, value, value.values()) + "}"
    if isinstance(value, (list, tuple)):
        has_dictionaries = isinstance(value, list) and any(isinstance(part, dict) for part in value)
        most = MOST_DICTIONARIES if has_dictionaries else MOST_ELEMENTS
        elements = [text_in_parts(part, digits, parts) for part in value[:most]]
        text = joined(elements, value, value)
        if isinstance(value, list):
            return f"[{text}]"
        return f"({text},)" if len(value) == 1 else f"({text})"
    text = repr(value)
    return text if len(text) <= MOST_CHARACTERS else text[:MOST_CHARACTERS] + "..."


def joined(texts: list[str], whole: Collection, elements: Iterable) -> str:
    """Return the texts of the elements of a list, tuple or dictionary in lines.

    If elements are left out, their full number stands at the end.
    """
    has_pendula = any(isinstance(element, dict) for element in elements)
    if len(whole) > len(texts):
        texts = [*texts, f"... ({len(whole)} in all)"]
    joined_text = "".join(texts[:1])
    for text in texts[1:]:
        line = joined_text.rpartition("\n")[2]
        needs_line = has_pendula or len(line) + len(text) > WIDTH
        joined_text += ",\n " if needs_line else ", "
        joined_text += text
    return joined_text


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


def message(pairs: Iterable[tuple[str, Any]]) -> str:
    """Return pairs of a label and a text (a sentence or lines) as one text.

    A pair without text is left out.
    """
    rows = []
    for label, text in pairs:
        if not text:
            continue
        lines = [text] if isinstance(text, str) else "\n".join(text).split("\n")
        for line in lines:
            for wrapped in wrap(line, TERMINAL_COLUMNS - LABEL) or [""]:
                rows.append(f"{label:<{LABEL}}{wrapped}")
                label = ""  # it stands in the first line only
    return "\n".join(rows)


def place_lines(places: Sequence[Place]) -> list[str]:
    """Return places in a student's own files as lines of text."""
    lines = []
    for place in places:
        lines.append(f"{place}, in {place.function}" if place.function else f"{place}")
        lines.append(f"    {place.code}")
    return lines if len(lines) <= 4 else [*lines[:2], "...", *lines[-2:]]


def end_of(raised: StoppedError, places: Sequence[Place]) -> tuple[str, list[str]]:
    """Return, as (label, lines), how a call was stopped: by an error, or by the grader."""
    if not raised.limit:
        return "it raised", error_lines(raised)
    end = f"nothing; it {raised.limit} and was stopped"
    return "came back", [f"{end} here:", *place_lines(places)] if places else [f"{end}."]


def error_lines(raised: StoppedError) -> list[str]:
    """Return an error, and its places in the student's own lines, as lines of text."""
    if raised.text is None:
        text = f"{raised.kind}, which has no text"
    else:
        text = f"{raised.kind}: {raised.text}"
    lines = text[:MOST_CHARACTERS].split("\n")
    return [*map(in_one_line, lines), *place_lines(raised.places)]
