"""What stopped a student's code."""

import re
import traceback
from contextlib import suppress
from linecache import getline, getlines
from pathlib import Path
from typing import NamedTuple

from grading.begin import ROOT

from grading import limits
from grading.evidence import nearest_name, of_error
from grading.handout import FUNCTIONS
from support.start.preview import stubs_in

ENDLESS = "Does a loop in it ever end?"
ENDING = "This line ends the whole program. Remove it; return ends a function."
MOST_PLACES = 20  # lines of an error that are kept: a recursion has hundreds


class Place(NamedTuple):
    """A line of a student's file that an error has passed."""

    file: str  # below the project's folder
    line: int
    function: str  # "" for a line that is no Python
    code: str

    def __str__(self):
        return f"{self.file}, line {self.line}"


class StoppedError(Exception):
    """An error that stopped a student's function, or the import of its file, or the limit over
    which it went.
    """

    def __init__(self, error, function):
        """function is "" if the error stopped the import."""
        self.error, self.function = error, function
        self.kind = type(error).__name__
        try:
            self.text = (
                error.msg if isinstance(error, SyntaxError) else f"{error}{nearest_name(error)}"
            )
        except Exception:
            self.text = None
        # In the student's own files; the last call comes last
        self.places, frames = own_places(error)
        self.limit = limits.over_limit(error)
        self.ends = isinstance(error, (SystemExit, KeyboardInterrupt))  # it ends the whole program
        # The file of src/ that made an import fail
        self.culprit = culprit_of(error, f"{self.text}", self.places)
        # The function that is not written yet, and the words, if they are known
        self.stub, self.hint = stub_of(error)
        self.mark = mark_of(error)  # a line below the code that Python cannot read
        self.meaning = ""  # what an error of this kind means
        if self.ends:
            self.hint = ENDLESS if self.limit else ENDING
        elif not self.limit and not self.stub:
            with suppress(Exception):  # an error of the student's own, which says nothing of itself
                self.hint, self.meaning = of_error(error, frames, function)


def mark_of(error) -> str:
    """Return a line with a mark below the place in the code that Python cannot read, or ""."""
    if not isinstance(error, SyntaxError) or not error.text or not error.offset:
        return ""
    code = error.text.rstrip()
    begin = error.offset - 1 - (len(code) - len(code.lstrip()))
    is_in_line = error.end_lineno == error.lineno and (error.end_offset or 0) > error.offset
    width = error.end_offset - error.offset if is_in_line else 1
    return " " * begin + "^" * width if 0 <= begin <= len(code) else ""


def own_places(error) -> tuple[tuple[Place, ...], list]:
    """Return the places of an error in the student's own files, and the frames and lines of them
    that have run.
    """
    stack = [
        (frame, frame.f_code.co_filename, line)
        for frame, line in traceback.walk_tb(error.__traceback__)
    ]
    places = [
        (Place(file, line, at.f_code.co_name, getline(file, line).strip()), at)
        for at, file, line in stack
    ]
    if isinstance(error, SyntaxError) and error.filename:
        places.append((Place(error.filename, error.lineno, "", (error.text or "").strip()), None))
    # ROOT is resolved, for example to the share behind a drive on Windows. "<string>" is no file.
    files = [
        (Path(place.file).resolve(), place, at)
        for place, at in places
        if Path(place.file).is_absolute()
    ]
    own = [each for each in files if each[0].is_relative_to(ROOT / "src")][:MOST_PLACES]
    found = [place._replace(file=file.relative_to(ROOT).as_posix()) for file, place, _ in own]
    return tuple(found), [(at, place.line) for _, place, at in own if at]


def stub_of(error) -> tuple[str | None, str]:
    """Return the function that raised this error because it is not written yet, or None, and a hint
    if it has code.
    """
    frames = traceback.extract_tb(error.__traceback__)
    name = frames[-1].name if frames else ""
    is_stub = isinstance(error, NotImplementedError) and name in FUNCTIONS
    stubs = stubs_in("".join(getlines(frames[-1].filename))) if is_stub else {}
    if name not in stubs:
        return None, ""
    line, has_code = stubs[name]
    return (
        name,
        f"Delete line {line}, raise NotImplementedError: it stops your function before its end."
        * has_code,
    )


def culprit_of(error, text, places) -> str | None:
    """Return the file of src/ that made an import fail, or None. text and places are those of the
    error.

    It lacks a function, or is missing itself, or is the first one of a circle, or has the last line
    that ran.
    """
    missing = re.match(r"cannot import name '(\w+)' from 'src\.", text)
    if missing and missing[1] in FUNCTIONS:
        return FUNCTIONS[missing[1]].file
    if isinstance(error, ModuleNotFoundError) and (error.name or "").startswith("src."):
        return error.name.replace(".", "/") + ".py"
    files = [each.file for each in places if each.function in ("", "<module>")]
    # In the order of the handout, it is the first file that imports from a later one
    if "circular import" in text:
        order = [*{function.file: None for function in FUNCTIONS.values()}]
        files = sorted(files, key=lambda file: -order.index(file) if file in order else -len(order))
    return files[-1] if files else None
