"""Calls, values and errors as text for students."""

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

LABEL = 12  # columns of the labels of a message
WIDTH = 62  # columns of the text to the right of them: a terminal has 80
MOST = 20  # elements shown of a list
PENDULA = 3  # pendula shown of a call
DICTIONARIES = 1  # shown of a list of dictionaries
ROWS = 4  # lines shown of a file
LINES = 5  # lines shown of a result, and of an expected value
MOST_CHARACTERS = 300  # shown of a text


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

    def lines(self) -> list[str]:
        """Return it as text: the call, and below it the values of the pendula and files that the function reads."""
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
    """Return a plain copy of an argument: a file with its text, pendula without objects."""
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
    """Return lines about an argument that is too long for the call: a file, a pendulum, or a list of pendula.

    keys are the keys of a pendulum that the lines show.
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
    """Return a value as text: numbers with this number of digits, each dictionary of a list on its own line."""
    try:
        return text_of(value, digits)
    except RecursionError:
        return f"a {type(value).__name__} that contains itself"
    except Exception:
        return f"a {type(value).__name__} that has no text"


def text_of(value, digits) -> str:
    """Return the same as shown, but let errors of the value pass."""
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
    """Return the parts of a list, tuple or dictionary in lines, and the full number if parts are left out."""
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
    if len(lines) > LINES:
        lines[LINES - 1 :] = [" ..."]
    if not what:
        return lines
    return [f"{what}: {lines[0]}"] if len(lines) == 1 and len(what + lines[0]) < WIDTH else [f"{what}:", *lines]


FORMS = {list: "a list", tuple: "a tuple", dict: "a dictionary", str: "text", bool: "a bool", type(None): "None"}


def form_of(value) -> str:
    """Return the form of a value in words."""
    words = [words for kind, words in FORMS.items() if isinstance(value, kind)]
    return words[0] if words else "a number" if isinstance(value, Real) else f"a {type(value).__name__}"


def mistake_in(what, came, wanted, fits) -> str:
    """Return a sentence that says what is wrong in came. what names the value, or the parts of a tuple, with commas.

    fits(came, wanted) compares two values.
    """
    names = what.split(", ")
    whole = what if len(names) == 1 else "The result"
    like = wanted.like if isinstance(wanted, Wanted) else wanted
    if wanted is True and isinstance(came, bool):
        return f"It is not true {what}."
    if like is not None and form_of(came) != form_of(like):
        return f"{whole} is {form_of(came)}, not {form_of(like)}."
    if isinstance(like, (list, tuple)) and len(came) != len(like):
        elements = "element" if len(came) == 1 else "elements"
        return f"{whole} has {len(came)} {elements}, not {len(like)}."
    if isinstance(wanted, (list, tuple)):
        parts = names if len(names) == len(wanted) > 1 else [part_of(what, i) for i in range(len(wanted))]
        bad = [trio for trio in zip(parts, came, wanted, strict=True) if not fits(*trio[1:])]
        if isinstance(bad[0][2], dict) or (len(bad) == 1 and not isinstance(bad[0][2], (list, tuple))):
            return mistake_in(*bad[0], fits)
        are_all = len(bad) == len(parts) or parts[0] == part_of(what, 0) == what
        told = [part for part, *_ in bad][: 2 if len(bad[0][0]) < WIDTH / 2 - 5 else 1]
        return wrong(what if are_all else ", ".join(told + ["..."] * (len(bad) > len(told))))
    if isinstance(wanted, dict):
        return mistake_in_dictionary(what, came, wanted, fits)
    return wrong(what)


def mistake_in_dictionary(what, came, wanted, fits) -> str:
    """Return a sentence that says what is wrong in the dictionary came."""
    for words, keys in (("misses", wanted.keys() - came.keys()), ("must not have", came.keys() - wanted.keys())):
        if keys:
            return f"{what} {words} the key {min(map(shown, keys))}."
    bad = [str(key) for key in wanted if not fits(came[key], wanted[key])]
    return wrong(f"{', '.join(bad)} of {what}")


def part_of(what, i) -> str:
    """Return the name of an element: "theta of pend_list[2]" for "theta of each pendulum"."""
    for each, one in (("each pendulum", "pend_list"), ("each axle", "axle"), ("each bob", "bob")):
        if each in what:
            return what.replace(each, f"{one}[{i}]")
    return what if " " in what else f"{what}[{i}]"


def wrong(what) -> str:
    """Return a sentence that says what is wrong: "a is wrong.", "a and b are wrong.", "a, b, c are wrong."."""
    if what.count(", ") == 1 and " and " not in what:
        what = what.replace(", ", " and ")
    return f"{what} {'are' if ', ' in what or ' and ' in what else 'is'} wrong."


def message(lines) -> str:
    """Return pairs of a label and a text (or a list of lines) as one text."""
    block = []
    for label, text in lines:
        first, *others = text.split("\n") if isinstance(text, str) else text or [""]
        block += [
            f"{label:<{LABEL}}{'' if len(label) < LABEL else ' '}{first}",
            *(" " * LABEL + line for line in others),
        ]
    return "\n".join(block)


def own_places(error) -> list[tuple[str, str]]:
    """Return the student's own lines in the traceback of an error, each as (place, code); the last call comes last."""
    places = [
        (frame.filename, f", line {frame.lineno}, in {frame.name}", frame.line or "")
        for frame in traceback.extract_tb(error.__traceback__)
    ]
    if isinstance(error, SyntaxError) and error.filename:
        places.append((error.filename, f", line {error.lineno}", (error.text or "").strip()))
    # ROOT is resolved, for example to the share behind a drive on Windows. "<string>" is no file.
    files = [(Path(name).resolve(), place, code) for name, place, code in places if Path(name).is_absolute()]
    return [
        (file.relative_to(ROOT).as_posix() + place, code)
        for file, place, code in files
        if file.is_relative_to(ROOT / "src")
    ]


def own_lines(error) -> list[str]:
    """Return own_places as lines of text."""
    lines = [line for place, code in own_places(error) for line in (place, f"    {code}")]
    return lines if len(lines) <= 8 else [*lines[:2], f"... ({len(lines) // 2} places in all)", *lines[-4:]]


def raised(error) -> list[str]:
    """Return an error, and its places in the student's own lines, as lines of text."""
    try:
        text = f"{type(error).__name__}: {error}"
    except Exception:
        text = f"{type(error).__name__}, which has no text"
    return [*text[:MOST_CHARACTERS].split("\n"), *own_lines(error)]


def unwritten(error) -> str | None:
    """Return the function that raised this error because it is not written yet, or None."""
    stub = re.fullmatch(r"(\w+) is not written yet", str(error)) if isinstance(error, NotImplementedError) else None
    return stub[1] if stub and stub[1] in FUNCTIONS else None


def place_of(error, file) -> str:
    """Return the place of an error in this file of src/, as "FILE, line N"."""
    places = [place for place, _ in own_places(error) if place.startswith(file)]
    return places[-1].rpartition(", in ")[0] if places else file


def culprit_of(error) -> str | None:
    """Return the file of src/ that made an import fail, or None.

    It lacks a function, or is missing itself, or is the first one of a circle, or has the last line that ran.
    """
    missing = re.match(r"cannot import name '(\w+)' from 'src\.", str(error))
    if missing and missing[1] in FUNCTIONS:
        return FUNCTIONS[missing[1]].file
    if isinstance(error, ModuleNotFoundError) and error.name.startswith("src."):
        return error.name.replace(".", "/") + ".py"
    files = importing(error)
    if is_circle(error):
        order = [*{function.file: None for function in FUNCTIONS.values()}]
        # In the order of the handout, it is the first file that imports from a later one.
        return min(files, key=lambda file: order.index(file) if file in order else len(order), default=None)
    return files[-1] if files else None


def importing(error) -> list[str]:
    """Return the files of src/ whose import an error stopped, the last one last."""
    places = [place for place, _ in own_places(error)]
    # Only their own lines, not those of functions that they called.
    return [place.partition(",")[0] for place in places if place.endswith("in <module>") or ", in " not in place]


def is_circle(error) -> bool:
    """Return whether an import failed because files import from each other."""
    return "circular import" in str(error)


def import_hint(error) -> list[tuple[str, str]]:
    """Return the hint for a failed import, or no hint."""
    if is_circle(error):
        return [("hint", f"Your files import each other in a circle. Remove the import in {culprit_of(error)}.")]
    if isinstance(error, ModuleNotFoundError):
        is_here = (ROOT / "src" / f"{error.name}.py").is_file()
        not_here = "Is the name right? Is the module installed for this Python?"
        return [("hint", f"Write src.{error.name} in the import." if is_here else not_here)]
    return []
