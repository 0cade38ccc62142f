"""What stopped a student's code, as plain data: the code may run in another process than the grader."""

import re
import traceback
from pathlib import Path
from typing import NamedTuple

from grading import limits
from grading.handout import FUNCTIONS
from grading.project_path import ROOT
from support.start.preview import is_unwritten

MOST_TEXT = 2000  # characters of an error that are kept


class Place(NamedTuple):
    """A line of a student's file that an error has passed."""

    file: str  # below the project's folder
    line: int
    function: str  # "" for a line that is no Python
    code: str


class Raised(NamedTuple):
    """An error that a student's code raised, or the limit over which it went."""

    kind: str = ""  # the name of the error's class
    text: str | None = ""  # None if it has no text
    places: tuple[Place, ...] = ()  # in the student's own files; the last call comes last
    limit: str = ""  # how the code went over a limit
    ends: bool = False  # it ends the whole program
    stub: str | None = None  # the function that is not written yet
    culprit: str | None = None  # the file of src/ that made an import fail
    hint: str = ""  # for an import
    before: str = ""  # why the function was not called: "import" if its file has failed, "missing" if it has none


class StoppedError(Exception):
    """A student's function, or the import of its file, did not come to its end."""

    def __init__(self, raised):
        super().__init__(raised.kind)
        self.raised = raised


def raised_by(error) -> Raised:
    """Return an error as plain data."""
    try:
        text = str(error)[:MOST_TEXT]
    except Exception:
        text = None
    places, ends = tuple(own_places(error)), isinstance(error, (SystemExit, KeyboardInterrupt))
    failed = import_failure(error, text or "", [place.file for place in places if place.function in ("", "<module>")])
    return Raised(type(error).__name__, text, places, limits.over_limit(error), ends, stub_of(error), *failed)


def own_places(error) -> list[Place]:
    """Return the places of an error in the student's own files."""
    frames = traceback.extract_tb(error.__traceback__)
    places = [Place(frame.filename, frame.lineno, frame.name, frame.line) for frame in frames]
    if isinstance(error, SyntaxError) and error.filename:
        places.append(Place(error.filename, error.lineno, "", (error.text or "").strip()))
    # ROOT is resolved, for example to the share behind a drive on Windows. "<string>" is no file.
    files = [(Path(place.file).resolve(), place) for place in places if Path(place.file).is_absolute()]
    own = [(file, place) for file, place in files if file.is_relative_to(ROOT / "src")]
    return [place._replace(file=file.relative_to(ROOT).as_posix()) for file, place in own]


def stub_of(error) -> str | None:
    """Return the function that raised this error because it is not written yet, or None."""
    frames = [frame for frame, _ in traceback.walk_tb(error.__traceback__)]
    code = frames[-1].f_code if isinstance(error, NotImplementedError) else None
    return code.co_name if code and code.co_name in FUNCTIONS and is_unwritten(code) else None


def import_failure(error, text, files) -> tuple[str | None, str]:
    """Return the file of src/ that made an import fail, or None, and a hint, or "".

    It lacks a function, or is missing itself, or is the first one of a circle, or has the last line that ran. files are
    those whose import the error stopped.
    """
    missing = re.match(r"cannot import name '(\w+)' from 'src\.", text)
    if missing and missing[1] in FUNCTIONS:
        return FUNCTIONS[missing[1]].file, ""
    if "circular import" in text:
        order = [*{function.file: None for function in FUNCTIONS.values()}]
        # In the order of the handout, it is the first file that imports from a later one.
        culprit = min(files, key=lambda file: order.index(file) if file in order else len(order), default=None)
        return culprit, f"Your files import each other in a circle. Remove the import in {culprit}."
    last = files[-1] if files else None
    if not isinstance(error, ModuleNotFoundError):
        return last, ""
    if (error.name or "").startswith("src."):
        last = error.name.replace(".", "/") + ".py"
    is_here = (ROOT / "src" / f"{error.name}.py").is_file()
    not_here = "Is the name right? Is the module installed for this Python?"
    return last, f"Write src.{error.name} in the import." if is_here else not_here
