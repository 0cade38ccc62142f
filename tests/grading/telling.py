"""What a student is told: calls, values and errors as text."""

import re
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from itertools import islice
from numbers import Real
from pathlib import Path
from typing import Any, NamedTuple

from vpython import box, cylinder, sphere, vector

from grading.handout import FUNCTIONS
from grading.project_path import ROOT

LABEL = 12  # columns of the words at the left of a message
WIDTH = 62  # columns of what stands to the right of them, where it can be broken: a terminal has 80
MOST = 20  # elements of a list that are shown
PENDULA = 3  # pendula of a call that are shown
DICTIONARIES = 1  # of a list that are shown
ROWS = 4  # lines of a file that are shown
LINES = 5  # lines of what came back, and of what was expected, that are shown
MOST_CHARACTERS = 300  # of a text that are shown


@dataclass(frozen=True)
class Wanted:
    """Something that is expected of which there is more than one: how to say it, and a test of what came back."""

    words: str
    is_one: Callable
    like: Any = None  # a value of its form


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
        """Return it as text: the call, and below it of the pendula and files that it was given what it reads."""
        function = FUNCTIONS[self.function]
        if self.arguments is None:
            return [f"{self.function}({function.parameters})"]
        words: list[str] = []
        below = [f"{self.times} times in a row"] if self.times > 1 else []
        for name, value in zip(function.parameters.split(", "), self.arguments, strict=False):
            if value and isinstance(value, (PlainFile, dict, list)):
                words.append(name)
                below += told(name, value, function.reads)
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


def told(name, value, keys) -> list[str]:
    """Return lines about an argument that is too long to stand in a call: a file, a pendulum, or a list of those.

    keys are what is told of a pendulum.
    """
    if isinstance(value, PlainFile):
        rows = value.text.splitlines()
        if len(rows) > ROWS:
            rows[ROWS - 1 :] = [f"... ({len(rows)} lines in all)"]
        return [f"{name} is the path of {Path(value.path).name}:", *(f"    {row}" for row in rows)]
    if isinstance(value, list):
        more = [f"... ({len(value)} in all)"] if len(value) > PENDULA else []
        lines = [line for i, pend in enumerate(value[:PENDULA]) for line in told(f"{name}[{i}]", pend, keys)]
        return [*lines, *more]
    return [f"{name}: " + ", ".join(f"{key} {shown(value[key])}" for key in keys)]


def shown(value, digits=6) -> str:
    """Return any value as text, numbers with this many digits, a list of dictionaries with one a line."""
    try:
        return text_of(value, digits)
    except RecursionError:
        return f"a {type(value).__name__} that contains itself"
    except Exception:
        return f"a {type(value).__name__} that has no text"


def text_of(value, digits) -> str:
    """Return what shown returns; raises what the value itself raises."""
    if isinstance(value, Wanted):
        return value.words
    if isinstance(value, bool) or value is None:
        return str(value)
    if isinstance(value, Real):
        return f"{value:.{digits}g}"
    if isinstance(value, vector):
        return f"vector({', '.join(text_of(number, digits) for number in value.value)})"
    if isinstance(value, sphere):
        return "a bob"
    if isinstance(value, (box, cylinder)):
        return "an axle" if isinstance(value, box) else "a cord"
    if isinstance(value, dict):
        parts = [f"{text_of(key, digits)}: {text_of(part, digits)}" for key, part in islice(value.items(), MOST)]
        return "{" + joined(parts, value, value.values()) + "}"
    if isinstance(value, list):
        most = DICTIONARIES if any(isinstance(part, dict) for part in value) else MOST
        return "[" + joined([text_of(part, digits) for part in value[:most]], value, value) + "]"
    if isinstance(value, tuple):
        comma = "," if len(value) == 1 else ""
        return "(" + joined([text_of(part, digits) for part in value[:MOST]], value, value) + comma + ")"
    text = repr(value)
    return text if len(text) <= MOST_CHARACTERS else text[:MOST_CHARACTERS] + "..."


def joined(parts, whole, elements) -> str:
    """Return the parts of a list, tuple or dictionary in lines, and how many there are if these are not all."""
    has_pendula = any(isinstance(element, dict) for element in elements)
    if len(whole) > len(parts):
        parts = [*parts, f"... ({len(whole)} in all)"]
    text = "".join(parts[:1])
    for part in parts[1:]:
        line = text.rpartition("\n")[2]
        text += (",\n " if has_pendula or len(line) + len(part) > WIDTH else ", ") + part
    return text


def about(what, value, digits=6) -> list[str]:
    """Return a value as lines, after the words for what it is: in one line if that is not long."""
    lines = shown(value, digits).split("\n")
    if len(lines) > LINES:
        lines[LINES - 1 :] = [" ..."]
    if not what:
        return lines
    return [f"{what}: {lines[0]}"] if len(lines) == 1 and len(what + lines[0]) < WIDTH else [f"{what}:", *lines]


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
    return [*text[:MOST_CHARACTERS].split("\n"), *own_lines(error)]


def unwritten(error) -> str | None:
    """Return the function whose place in the starter raised this error, as it is not written yet, or None."""
    stub = re.fullmatch(r"(\w+) is not written yet", str(error)) if isinstance(error, NotImplementedError) else None
    return stub[1] if stub and stub[1] in FUNCTIONS else None


def place_of(error, file) -> str:
    """Return where in this file of src/ the error arose, as "FILE, line N"."""
    places = [place for place, _ in own_places(error) if place.startswith(file)]
    return places[-1].rpartition(", in ")[0] if places else file


def culprit_of(error) -> str | None:
    """Return the file of src/ because of which an import failed, or None: the one with a function missing, the one
    that is missing itself, the first one of a circle, or the one with the last line that was carried out.
    """
    missing = re.match(r"cannot import name '(\w+)' from 'src\.", str(error))
    if missing and missing[1] in FUNCTIONS:
        return FUNCTIONS[missing[1]].file
    if isinstance(error, ModuleNotFoundError) and error.name.startswith("src."):
        return error.name.replace(".", "/") + ".py"
    files = importing(error)
    if is_circle(error):
        order = [*{function.file: None for function in FUNCTIONS.values()}]
        # It is the first one in the order of the handout that imports from a later one.
        return min(files, key=lambda file: order.index(file) if file in order else len(order), default=None)
    return files[-1] if files else None


def importing(error) -> list[str]:
    """Return the files of src/ that were being imported when an error arose, the last one last."""
    places = [place for place, _ in own_places(error)]
    # Of their own lines, not of what they called.
    return [place.partition(",")[0] for place in places if place.endswith("in <module>") or ", in " not in place]


def is_circle(error) -> bool:
    """Return whether an import failed because files import from each other."""
    return "circular import" in str(error)


def import_hint(error) -> list[tuple[str, str]]:
    """Return the hint that fits an import that failed, or none."""
    if is_circle(error):
        return [("hint", f"Imports go round in a circle here: leave out the one in {culprit_of(error)}.")]
    if isinstance(error, ModuleNotFoundError):
        is_here = (ROOT / "src" / f"{error.name}.py").is_file()
        not_here = "Is its name right, and is it installed for the Python that runs this?"
        return [("hint", f"Its name is src.{error.name}." if is_here else not_here)]
    return []
