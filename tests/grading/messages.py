"""Calls, values and errors as text for students."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice
from numbers import Real
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple

from vpython import box, cylinder, sphere, vector

from grading.handout import FUNCTIONS
from support.start.output import in_one_line

# Of a terminal, of the labels of a message, and of the values beside them
COLUMNS = 80
LABEL = 12
WIDTH = 62
MOST_ELEMENTS, DICTIONARIES = 20, 1  # elements shown of a list, and of a list of dictionaries
FILE, ROWS = 8, 4  # lines of the longest file that is shown whole, and lines shown of a longer one
LINES = 5  # lines shown of a result, and of an expected value
MOST_CHARACTERS, MOST_PARTS = 300, 10_000  # shown of a text, and of a value

SHAPES = {box: "an axle", sphere: "a bob", cylinder: "a cord"}
FORMS = {
    list: "a list",
    tuple: "a tuple",
    dict: "a dictionary",
    str: "text",
    bool: "a bool",
    type(None): "None",
}


@dataclass(frozen=True)
class Wanted:
    """An expectation that several values meet: its words, and a test of a value."""

    words: str
    is_one: Callable
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

    def lines(self, index=0) -> list[str]:
        """Return it as text: the call, and below it the values of the pendula and files that the
        function reads.

        index is that of a pendulum that must be among those of a list.
        """
        function = FUNCTIONS[self.function]
        if self.arguments is None:
            return [f"{self.function}({function.parameters})"]
        words, below = [], [f"{self.times} times in a row"] if self.times > 1 else []
        for name, value in zip(function.parameters.split(", "), self.arguments, strict=False):
            is_long = value and isinstance(value, (PlainFile, dict, list))
            words.append(name if is_long else f"{name}={shown(value)}")
            if is_long:
                below += value_lines(name, value, function.reads, index)
                if isinstance(value, PlainFile) and self.function != "extract_and_convert":
                    # The pendula say what is in it
                    below = [f"{name} is the path of {Path(value.path).name}"]
        return [*wrap(f"{self.function}({', '.join(words)})", COLUMNS - LABEL), *below]


def plain(value):
    """Return a plain copy of an argument: a file with its text, pendula without objects."""
    if isinstance(value, list):
        return [plain(element) for element in value]
    if isinstance(value, dict) and "objects" in value:
        # A student's code may have changed the objects
        with suppress(TypeError, ValueError, AttributeError):
            axle, bob = value["objects"][:2]
            place = {
                "axle": tuple(axle.pos.value),
                "bob": tuple(bob.pos.value),
                "radius": bob.radius,
            }
            return {**{name: part for name, part in value.items() if name != "objects"}, **place}
    if isinstance(value, str) and Path(value).is_file():
        return PlainFile(value, Path(value).read_text(encoding="utf-8", errors="replace"))
    return value


def value_lines(name, value, keys, index=0) -> list[str]:
    """Return lines about a long argument: a file, a pendulum (these keys), or a list, with the
    pendulum at index.
    """
    if isinstance(value, PlainFile):
        rows = value.text.splitlines()
        if len(rows) > FILE:
            rows[ROWS - 1 :] = [f"... ({len(rows)} lines in all)"]
        return [f"{name} is the path of {Path(value.path).name}:", *(f"    {row}" for row in rows)]
    if isinstance(value, list):
        some = [0, 1, max(2, index)][: len(value)]
        lines = [line for i in some for line in value_lines(f"{name}[{i}]", value[i], keys)]
        return [*lines, f"... ({len(value)} in all)"] if len(value) > len(some) else lines
    digits = {"bob": 4}
    return [
        f"{name}: "
        + ", ".join(
            f"{key} {shown(value[key], digits.get(key, 6))}" for key in keys if key in value
        )
    ]


def damage(before, names, arguments):
    """Yield, for each pendulum in the arguments of a call that is none any more, its name and its
    value in words.

    before has plain copies of the arguments from before the call, names are their names with
    commas.
    """
    for name, old, value in zip(names.split(", "), before, arguments, strict=False):
        if isinstance(value, list) and isinstance(old, list):
            yield from damage(old, ", ".join(f"{name}[{i}]" for i in range(len(old))), value)
        elif isinstance(old, dict):
            now = plain(value)
            lost = (
                []
                if not isinstance(now, dict)
                else sorted(old.keys() - now.keys() - {"axle", "bob", "radius"})
            )
            if not isinstance(now, dict) or lost or "objects" in now or "bob" not in now:
                if lost:
                    yield f"{name}: without {lost[0]}"
                else:
                    yield f"{name}: {'with other objects' if isinstance(now, dict) else shown(now)}"


def shown(value, digits=6) -> str:
    """Return a value as text: numbers with this number of digits, each dictionary of a list on its
    own line.
    """
    try:
        return text_of(value, digits, iter(range(MOST_PARTS)))
    except RecursionError:
        return f"a {type(value).__name__} that contains itself"
    except StopIteration:
        return f"a {type(value).__name__} with more than {MOST_PARTS} parts"
    except Exception:
        return f"a {type(value).__name__} that has no text"


def form_of(value) -> str:
    """Return the form of a value in words."""
    words = [words for kind, words in FORMS.items() if isinstance(value, kind)]
    if words:
        return words[0]
    return "a number" if isinstance(value, Real) else f"a {type(value).__name__}"


def text_of(value, digits, parts) -> str:
    """Return the same as shown, but let errors of the value pass. parts limits the number of its
    parts.
    """
    next(parts)
    if isinstance(value, Wanted):
        return value.words
    if isinstance(value, Real) and not isinstance(value, bool):
        return f"{value + 0:.{digits}g}"  # no -0
    if isinstance(value, vector):
        return f"vector({', '.join(text_of(number, digits, parts) for number in value.value)})"
    if type(value) in SHAPES:
        return SHAPES[type(value)]
    if isinstance(value, dict):
        rows = []
        for key, part in islice(value.items(), MOST_ELEMENTS):
            rows.append(f"{text_of(key, digits, parts)}: {text_of(part, digits, parts)}")
        return "{" + joined(rows, value, value.values()) + "}"
    if isinstance(value, (list, tuple)):
        has_dictionaries = isinstance(value, list) and any(isinstance(part, dict) for part in value)
        most = DICTIONARIES if has_dictionaries else MOST_ELEMENTS
        text = joined([text_of(part, digits, parts) for part in value[:most]], value, value)
        if isinstance(value, list):
            return f"[{text}]"
        return f"({text},)" if len(value) == 1 else f"({text})"
    text = repr(value)
    return text if len(text) <= MOST_CHARACTERS else text[:MOST_CHARACTERS] + "..."


def joined(parts, whole, elements) -> str:
    """Return the parts of a list, tuple or dictionary in lines, and the full number if parts are
    left out.
    """
    has_pendula = any(isinstance(element, dict) for element in elements)
    if len(whole) > len(parts):
        parts = [*parts, f"... ({len(whole)} in all)"]
    text = "".join(parts[:1])
    for part in parts[1:]:
        line = text.rpartition("\n")[2]
        text += (",\n " if has_pendula or len(line) + len(part) > WIDTH else ", ") + part
    return text


def about(what, value, digits=6) -> list[str]:
    """Return a value as lines, after the words in what: in one line if it is short."""
    lines = shown(value, digits).split("\n")
    lines = lines if len(lines) <= LINES else [*lines[: LINES - 1], " ..."]
    if not what:
        return lines
    return (
        [f"{what}: {lines[0]}"]
        if len(lines) == 1 and len(what + lines[0]) < WIDTH
        else [f"{what}:", *lines]
    )


def message(pairs) -> str:
    """Return pairs of a label and a sentence (or a list of lines) as one text, without those that
    have no text.
    """
    rows = []
    for label, text in pairs:
        lines = []
        for line in [text] if isinstance(text, str) else "\n".join(text).split("\n"):
            lines += wrap(line, COLUMNS - LABEL) or [""]
        rows += [
            f"{label if i == 0 else '':<{LABEL}}{line}" for i, line in enumerate(lines) if text
        ]
    return "\n".join(rows)


def own_lines(places) -> list[str]:
    """Return places in a student's own files as lines of text."""
    lines = []
    for file, line, function, code in places:
        place = f"{file}, line {line}"
        lines += [f"{place}, in {function}" if function else place, f"    {code}"]
    return lines if len(lines) <= 4 else [*lines[:2], "...", *lines[-2:]]


def end_of(raised, places) -> tuple[str, list[str]]:
    """Return, as (label, lines), how a call was stopped, and at these places: by an error, or by
    the grader.
    """
    if not raised.limit:
        return "it raised", error_lines(raised)
    end = f"nothing; it {raised.limit} and was stopped"
    return "came back", [f"{end} here:", *own_lines(places)] if places else [f"{end}."]


def error_lines(raised) -> list[str]:
    """Return an error, and its places in the student's own lines, as lines of text."""
    text = (
        f"{raised.kind}, which has no text"
        if raised.text is None
        else f"{raised.kind}: {raised.text}"
    )
    return [*map(in_one_line, text[:MOST_CHARACTERS].split("\n")), *own_lines(raised.places)]
