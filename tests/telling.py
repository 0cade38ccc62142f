"""What a student is told: calls, values and errors as text."""

import re
import traceback
from collections.abc import Callable
from itertools import islice
from numbers import Real
from pathlib import Path
from typing import NamedTuple

from handout import FUNCTIONS
from vpython import box, cylinder, sphere, vector

ROOT = Path(__file__).resolve().parents[1]
LABEL = 12  # columns of the words at the left of a message
MOST = 20  # elements of a list that are shown
LONGEST = 300  # characters of a text that are shown


class A(NamedTuple):
    """Something that is expected of which there is more than one: how to say it, and a test of what came back."""

    words: str
    is_one: Callable


class PlainFile(NamedTuple):
    """A file that a function was given the path of."""

    path: str
    text: str


class Call(NamedTuple):
    """A call of a student's function, its arguments in plain values, as they were before it."""

    function: str
    arguments: tuple | None = None  # None if the function was not found
    times: int = 1

    def lines(self) -> list[str]:
        """Return it as text: the call, and below it the pendula and files that it was given."""
        if self.arguments is None:
            return [f"{self.function}({FUNCTIONS[self.function].parameters})"]
        words: list[str] = []
        below = [f"{self.times} times in a row"] if self.times > 1 else []
        for name, value in zip(FUNCTIONS[self.function].parameters.split(", "), self.arguments, strict=False):
            if isinstance(value, (PlainFile, dict, list)):
                words.append(name)
                below += told(name, value)
            else:
                words.append(f"{name}={shown(value)}")
        return [f"{self.function}({', '.join(words)})", *below]


def plain(value):
    """Return an argument in plain values, as it is at this moment: a file with its text, pendula without objects."""
    if isinstance(value, list):
        return [plain(element) for element in value]
    if isinstance(value, dict) and "objects" in value:
        axle, bob = value["objects"][:2]
        place = {"axle": tuple(axle.pos.value), "bob": tuple(bob.pos.value), "radius": bob.radius}
        return {**{name: value[name] for name in ("mass", "e", "theta", "omega")}, **place}
    if isinstance(value, str) and Path(value).is_file():
        return PlainFile(value, Path(value).read_text(encoding="utf-8"))
    return value


def told(name, value) -> list[str]:
    """Return lines about an argument that is too long to stand in a call: a file, a pendulum, or a list of those."""
    if isinstance(value, PlainFile):
        return [f"{name} is the path of {Path(value.path).name}:", *(f"    {line}" for line in value.text.splitlines())]
    if isinstance(value, list):
        return [line for i, pendulum in enumerate(value) for line in told(f"{name}[{i}]", pendulum)]
    return [f"{name}: " + ", ".join(f"{key} {shown(part)}" for key, part in value.items())]


def shown(value, digits=6) -> str:
    """Return any value as text, numbers with so many digits, a list of dictionaries with one a line."""
    try:
        return text_of(value, digits)
    except RecursionError:
        return f"a {type(value).__name__} that contains itself"
    except Exception:
        return f"a {type(value).__name__} that has no text"


def text_of(value, digits) -> str:
    """Return what shown returns; raises what the value itself raises."""
    if isinstance(value, A):
        return value.words
    if isinstance(value, bool) or value is None:
        return str(value)
    if isinstance(value, Real):
        return f"{value:.{digits}g}"
    if isinstance(value, vector):
        return f"vector({', '.join(text_of(number, digits) for number in value.value)})"
    if isinstance(value, sphere):
        return f"a bob at {text_of(value.pos, digits)}"
    if isinstance(value, (box, cylinder)):
        return f"{'an axle' if isinstance(value, box) else 'a cord'} at {text_of(value.pos, digits)}"
    if isinstance(value, dict):
        parts = [f"{text_of(key, digits)}: {text_of(part, digits)}" for key, part in islice(value.items(), MOST)]
        return "{" + joined(parts, value, value.values()) + "}"
    if isinstance(value, list):
        return "[" + joined([text_of(part, digits) for part in value[:MOST]], value, value) + "]"
    if isinstance(value, tuple):
        comma = "," if len(value) == 1 else ""
        return "(" + joined([text_of(part, digits) for part in value[:MOST]], value, value) + comma + ")"
    text = repr(value)
    return text if len(text) <= LONGEST else text[:LONGEST] + "..."


def joined(parts, whole, elements) -> str:
    """Return the parts of a list, tuple or dictionary in one text, and how many there are if these are not all."""
    more = [f"... ({len(whole)} in all)"] if len(whole) > len(parts) else []
    long = sum(map(len, parts)) > 100 and all(isinstance(element, (list, tuple)) for element in elements)
    return (",\n " if long or any(isinstance(element, dict) for element in elements) else ", ").join([*parts, *more])


def about(what, value, digits=6) -> list[str]:
    """Return a value as lines, after the words for what it is: in one line if that is not long."""
    lines = shown(value, digits).split("\n")
    if not what:
        return lines
    return [f"{what}: {lines[0]}"] if len(lines) == 1 and len(what + lines[0]) < 100 else [f"{what}:", *lines]


def message(lines) -> str:
    """Return labels and what belongs to them, a text or a list of lines, as one text."""
    block = []
    for label, text in lines:
        first, *others = text.split("\n") if isinstance(text, str) else text or [""]
        block += [
            f"{label:<{LABEL}}{'' if len(label) < LABEL else ' '}{first}",
            *(" " * LABEL + line for line in others),
        ]
    return "\n".join(block)


def own_places(error) -> list[tuple[str, str]]:
    """Return where in the student's own lines an error arose, the last place last: each as a place and its code."""
    places = [
        (frame.filename, f", line {frame.lineno}, in {frame.name}", frame.line or "")
        for frame in traceback.extract_tb(error.__traceback__)
    ]
    if isinstance(error, SyntaxError) and error.filename:
        places.append((error.filename, f", line {error.lineno}", (error.text or "").strip()))
    # ROOT is resolved: to the share behind a drive of Windows, for one. "<string>" is no file.
    files = [(Path(name).resolve(), place, code) for name, place, code in places if Path(name).is_absolute()]
    return [
        (file.relative_to(ROOT).as_posix() + place, code)
        for file, place, code in files
        if file.is_relative_to(ROOT / "src")
    ]


def own_lines(error) -> list[str]:
    """Return these places as lines of text."""
    lines = [line for place, code in own_places(error) for line in (place, f"    {code}")]
    return lines if len(lines) <= 8 else [*lines[:2], f"... ({len(lines) // 2} places in all)", *lines[-4:]]


def raised(error) -> list[str]:
    """Return lines that say what was raised, and where in the student's own lines."""
    try:
        text = f"{type(error).__name__}: {error}"
    except Exception:
        text = f"{type(error).__name__}, which has no text"
    return [*text[:LONGEST].split("\n"), *own_lines(error)]


def culprit_of(error) -> str | None:
    """Return the file of src/ because of which an import failed, or None: the one with a function missing, the one
    that is missing itself, or the one with the last line that was carried out.
    """
    missing = re.match(r"cannot import name '(\w+)' from 'src\.", str(error))
    if missing and missing[1] in FUNCTIONS:
        return FUNCTIONS[missing[1]].file
    if isinstance(error, ModuleNotFoundError) and error.name.startswith("src."):
        return error.name.replace(".", "/") + ".py"
    places = [place for place, _ in own_places(error)]
    # Of its own lines, not of what they called.
    importing = [place for place in places if place.endswith("in <module>") or ", in " not in place]
    return importing[-1].partition(",")[0] if importing else None
