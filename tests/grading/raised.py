"""An error that stopped a student's code: where it was, and what it says."""

import ast
import re
import traceback
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from linecache import getline, getlines
from pathlib import Path
from types import FrameType
from typing import Any, NamedTuple

from grading.begin import ROOT

from grading import limits
from grading.handout import FUNCTIONS, PROGRAM
from grading.hints import of_error

ENDLESS = "Does a loop in it ever end?"
ENDLESS_PROGRAM = "Does a loop in it go on without is_running, and without rate?"
ENDING = "This line ends the whole program. Remove it; return ends a function."
MOST_PLACES = 20  # lines of an error that are kept: a recursion has hundreds
# The first lines of the statements that the handout provides beside a raise, as ast.unparse writes
# them
GIVEN = {
    "df = pd.read_csv(relative_filepath)",
    "bad_rep = df.to_dict(orient='index')",
    "while is_running(pend_list):",
}


class Place(NamedTuple):
    """A line of a student's file that an error has passed."""

    file: str  # below the project's folder
    line: int
    function: str  # "" for a line that is no Python
    code: str

    def __str__(self) -> str:
        return f"{self.file}, line {self.line}"

    @property
    def is_outside(self) -> bool:
        """Whether the line stands outside of all functions."""
        return self.function in ("", "<module>")


@dataclass(eq=False)
class StoppedError(Exception):
    """An error that stopped a student's function or the import of its file, or a limit that did.

    stopped_error makes it.
    """

    error: BaseException
    function: str  # "" if the error stopped the import
    text: str  # what Python says: the kind of error, and its text
    code: list[str]  # of a line that Python cannot read, with a mark below it
    places: tuple[Place, ...]  # in the student's own files; the last call comes last
    limit: str  # how the call went over a limit, or ""
    culprit: str | None  # the file of src/ that made an import fail
    stub: str | None  # the function that is not written yet
    hint: str  # if one is known

    @property
    def kind(self) -> str:
        return type(self.error).__name__


class StubHint(NamedTuple):
    """A function that is not written yet."""

    function: str
    hint: str  # if it has code, else ""


def stopped_error(error: BaseException, function: str) -> StoppedError:
    """Return what is known of an error that stopped a function.

    function is "" if the error stopped the import of its file.
    """
    *code, text = traceback.format_exception_only(error)
    places, frames = own_places(error)
    limit = limits.over_limit(error)
    stub = stub_of(error)
    hint = ""
    if stub:
        hint = stub.hint
    elif isinstance(error, (SystemExit, KeyboardInterrupt)):  # it ends the whole program
        hint = ENDING
        if limit:
            hint = ENDLESS_PROGRAM if function == PROGRAM else ENDLESS
    elif not limit:
        with suppress(Exception):  # an error of the student's own, which says nothing of itself
            hint = of_error(error, frames, function)
    return StoppedError(
        error=error,
        function=function,
        text=text.strip(),
        code=[line.rstrip() for line in code[1:]],
        places=places,
        limit=limit,
        culprit=culprit_of(error, text, places),
        stub=stub.function if stub else None,
        hint=hint,
    )


def below_project(file: str) -> str:
    """Return the path of a file below the project's folder."""
    # As ROOT is, for example to the share behind a drive on Windows
    return Path(file).resolve().relative_to(ROOT).as_posix()


def own_places(error: BaseException) -> tuple[tuple[Place, ...], list[tuple[FrameType, int]]]:
    """Return the places of an error in the student's own files, the last call last.

    Also return the frames and the lines of those that have run.
    """
    places: list[Place] = []
    frames = []
    for place, frame in all_places(error):
        if len(places) == MOST_PLACES:
            break
        path = Path(place.file)
        if not path.is_absolute():  # "<string>" is no file
            continue
        if path.resolve().is_relative_to(ROOT / "src"):
            places.append(place._replace(file=below_project(place.file)))
            if frame:
                frames.append((frame, place.line))
    return tuple(places), frames


def all_places(error: Any) -> Iterator[tuple[Place, FrameType | None]]:
    """Yield the places of an error in all files, with their frames.

    A line that is no Python has none.
    """
    for frame, line in traceback.walk_tb(error.__traceback__):
        file = frame.f_code.co_filename
        yield Place(file, line, frame.f_code.co_name, getline(file, line).strip()), frame
    if isinstance(error, SyntaxError) and error.filename:
        number: Any = error.lineno
        yield Place(error.filename, number, "", (error.text or "").strip()), None


def stub_of(error: BaseException) -> StubHint | None:
    """Return the function that raised this error because it is not written yet, or None."""
    frames = traceback.extract_tb(error.__traceback__)
    if not frames or not isinstance(error, NotImplementedError):
        return None
    place = frames[-1]
    name = PROGRAM if place.name == "<module>" else place.name
    if name not in FUNCTIONS or f"{error}" != f"{name} is not written yet":
        return None
    if not has_code_beside(place.filename, place.lineno):
        return StubHint(name, "")
    delete = f"Delete line {place.lineno}, raise NotImplementedError"
    return StubHint(name, f"{delete}: it stops {name} before its end.")


def has_code_beside(file: str, line: int | None) -> bool:
    """Return whether a student has written statements beside the raise in this line of a file."""
    for node in ast.walk(ast.parse("".join(getlines(file)))):
        for part in ("body", "orelse"):
            block = getattr(node, part, None)
            if isinstance(block, list) and line in [statement.lineno for statement in block]:
                lines = [ast.unparse(statement).partition("\n")[0] for statement in block]
                code = [text for text in lines if not text.startswith(("'", '"', "raise"))]
                return not GIVEN.issuperset(code)
    return False


def culprit_of(error: BaseException, text: str, places: tuple[Place, ...]) -> str | None:
    """Return the file of src/ that made an import fail, or None.

    It lacks a function, or is missing itself, or is the first one of a circle, or has the last line
    that ran. text and places are those of the error.
    """
    missing = re.search(r"cannot import name '(\w+)' from 'src\.", text)
    if missing and missing[1] in FUNCTIONS:
        return FUNCTIONS[missing[1]].file
    if isinstance(error, ModuleNotFoundError):
        name = error.name or ""
        if name.startswith("src."):
            return name.replace(".", "/") + ".py"
    files = [place.file for place in places if place.is_outside]
    if "circular import" in text:
        # In the order of the handout, it is the first file that imports from a later one
        for function in FUNCTIONS.values():
            if function.file in files:
                return function.file
    return files[-1] if files else None
