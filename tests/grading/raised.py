"""An error that stopped a student's code: where it was, and what it says."""

import ast
import re
import traceback
from collections.abc import Iterable
from functools import cache
from linecache import getline, getlines
from pathlib import Path
from types import FrameType
from typing import NamedTuple

from grading.begin import ROOT

from grading.assignment import FUNCTIONS, PROGRAM
from grading.hints import of_error
from support.root import SRC
from support.start.output import in_one_line

ENDLESS = "Does a loop in it ever end?"
ENDLESS_PROGRAM = "Does a loop in it go on without is_running, and without rate?"
ENDING = "This line ends the whole program. Remove it; return ends a function."
MOST_CHARACTERS = 300  # of the text of an error that are shown
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
    code: str  # of a line that is no Python, with a mark below it

    def __str__(self) -> str:
        return f"{self.file}, line {self.line}"

    @property
    def is_outside(self) -> bool:
        """Whether the line stands outside of all functions."""
        return self.function in ("", "<module>")


class StoppedError(Exception):
    """An error that stopped a student's function or the import of its file, or a limit that did."""

    def __init__(self, error: BaseException, function: str, limit: str) -> None:
        """function is "" if the error stopped the import. limit is from Limits.over_limit."""
        self.error = error
        self.function = function
        self.limit = limit
        self.text = in_one_line(text_of(error))[:MOST_CHARACTERS]
        frames = own_frames(traceback.walk_tb(error.__traceback__))
        # In the student's own files; the last call comes last
        self.places = [place_at(*pair) for pair in frames]
        if isinstance(error, SyntaxError) and own_file(f"{error.filename}"):
            self.places.append(place_of_syntax(error))
        self.stub = stub_of(error, self.places)  # the function that is not written yet, or None
        if self.stub:
            self.hint = hint_for_stub(self.stub, self.places[-1])
        elif isinstance(error, MemoryError):
            self.hint = ""  # there may be no loop
        elif limit:
            self.hint = ENDLESS_PROGRAM if function == PROGRAM else ENDLESS
        elif isinstance(error, SystemExit):
            self.hint = ENDING
        else:
            self.hint = of_error(error, self.text, frames, function)

    @property
    def culprit(self) -> str | None:
        """The file of src/ that made an import fail, or None.

        It lacks a function, or is the first one of a circle, or has the last line that ran.
        """
        missing = re.search(r"cannot import name '(\w+)' from 'src\.", self.text)
        if missing and missing[1] in FUNCTIONS:
            return FUNCTIONS[missing[1]].file
        files = [place.file for place in self.places if place.is_outside]
        if "circular import" in self.text:
            # In the order of the handout, it is the first file that imports from a later one
            for function in FUNCTIONS.values():
                if function.file in files:
                    return function.file
        return files[-1] if files else None


def text_of(error: BaseException) -> str:
    """Return the kind of an error and its text, also what Python guesses: "Did you mean: ...?"."""
    *_, text = traceback.TracebackException.from_exception(error).format_exception_only()
    return text.strip()


@cache
def own_file(file: str) -> str:
    """Return the path of a file of src/ below the project's folder; "" for another file."""
    path = Path(file).resolve()  # as ROOT is, for example to the share behind a drive on Windows
    return path.relative_to(ROOT).as_posix() if path.is_relative_to(SRC) else ""


def own_frames(walked: Iterable[tuple[FrameType, int]]) -> list[tuple[FrameType, int]]:
    """Return the frames, with their lines, that are in the student's own files."""
    return [(frame, line) for frame, line in walked if own_file(frame.f_code.co_filename)]


def place_at(frame: FrameType, line: int) -> Place:
    """Return the place of a line that has run."""
    file = frame.f_code.co_filename
    return Place(own_file(file), line, frame.f_code.co_name, getline(file, line).strip())


def place_of_syntax(error: SyntaxError) -> Place:
    """Return the place of a line that is no Python."""
    _, *code, _ = traceback.format_exception_only(error)
    return Place(own_file(f"{error.filename}"), error.lineno or 0, "", "".join(code).strip())


def stub_of(error: BaseException, places: list[Place]) -> str | None:
    """Return the function that raised this error because it is not written yet, or None."""
    if not isinstance(error, NotImplementedError):
        return None
    name = f"{error}".removesuffix(" is not written yet")
    return name if name in FUNCTIONS and name in (places[-1].function, PROGRAM) else None


def hint_for_stub(function: str, place: Place) -> str:
    """Return a hint if a function that is not written has code beside its raise, else ""."""
    file = f"{ROOT / place.file}"
    for node in ast.walk(ast.parse("".join(getlines(file)))):
        block = getattr(node, "body", None)
        if isinstance(block, list) and place.line in [statement.lineno for statement in block]:
            lines = [ast.unparse(statement).partition("\n")[0] for statement in block]
            code = [text for text in lines if not text.startswith(("'", '"', "raise"))]
            if not GIVEN.issuperset(code):
                delete = f"Delete line {place.line}, raise NotImplementedError"
                return f"{delete}: it stops {function} before its end."
    return ""
