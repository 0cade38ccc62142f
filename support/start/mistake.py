"""Find a mistake in one of the handout's functions, and report it."""

import sys
import traceback
from collections.abc import Callable, Iterable
from numbers import Real
from pathlib import Path
from typing import Any

from support.found import in_short
from support.root import ROOT, SRC
from support.start.end import SignalError

LARGEST_NUMBER = 1e100  # a larger number has no energy: its square is too large
TYPE_PYTEST = "Type pytest in this folder: it says more about mistakes."


class MistakeError(Exception):
    """A function raised no error, but its result is unusable."""

    def __init__(self, function: Callable | str, message: str) -> None:
        """Put the function's name before the message, which describes the mistake."""
        # A decorator can make it of a class
        name = getattr(function, "__name__", type(function).__name__)
        if isinstance(function, str):
            name = function
        super().__init__(f"{name} {message}")
        self.code = getattr(function, "__code__", None)


def is_in_src(filename: str) -> bool:
    return Path(filename).resolve().is_relative_to(SRC)


def students_frames(error: BaseException, player: str) -> list[traceback.FrameSummary]:
    """Return the frames of an error that are in src/, and below those of the player's file.

    Return none if the player itself failed, when the program asked it, or before it ran one.
    """
    if isinstance(error, MistakeError) and error.code:
        code = error.code
        return [traceback.FrameSummary(code.co_filename, code.co_firstlineno, code.co_name)]
    found: list[traceback.FrameSummary] = []
    is_below = not player
    for frame in traceback.extract_tb(error.__traceback__):
        if frame.filename == player:
            found = []
            is_below = True
        elif is_below and is_in_src(frame.filename):
            found.append(frame)
    return found


def report_mistake(error: BaseException, player: str = "") -> str:
    """Print the traceback of an error on stderr, and return the error in one line, with its line.

    player is the file that has called the student's functions. The traceback has only lines of
    theirs: what they call is right, but got a wrong argument.
    """
    frames = students_frames(error, player)
    report = traceback.TracebackException.from_exception(error)
    says_place = isinstance(error, MistakeError | OSError | SyntaxError)
    report.stack[:] = frames if says_place else frames or report.stack
    text = "".join(report.format())
    message = " ".join("".join(report.format_exception_only()).split())
    if isinstance(error, MistakeError):
        message = str(error)
        text = "".join([*report.stack.format(), message, "\n"])
    if frames:
        text += f"{TYPE_PYTEST}\n"
    print(text, file=sys.stderr, end="")
    if isinstance(error, SyntaxError):
        place, line = place_of(str(error.filename), error.lineno), error.text
        message = f"{type(error).__name__}: {error.msg}"
    elif report.stack:
        last = report.stack[-1]
        place, line = place_of(last.filename, last.lineno), last.line
    else:
        return message
    return f"{message} ({place}: {(line or '').strip()})"


def place_of(file: str, line: int | None) -> str:
    """Return a line of a file as a message names it."""
    path = Path(file).resolve()
    name = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else path.name
    return f"{name}, line {line}"


def report_endless_loop(error: SignalError, player: str = "") -> None:
    """Print the lines of a student's that a signal has stopped, the innermost one last.

    player is as in report_mistake. If frames were still coming (is_late is False), say nothing:
    nothing hung.
    """
    frames = students_frames(error, player)
    if frames and error.is_late:
        lines = "".join(traceback.format_list(frames))
        print(f"Is there a loop that never ends?\n{lines}", end="", file=sys.stderr)


def require_pendula(make: Callable | str, pend_list: Any, keys: Iterable[str], parts: int) -> None:
    """Raise a MistakeError if pend_list, which make has made, is no list of complete pendula.

    keys are those of a pendulum's numbers, parts is the number of its objects.
    """
    if not pend_list or not is_pend_list(pend_list):
        must = "must return a list of dictionaries, for is_running(pend_list); it got"
        raise MistakeError(make, f"{must} {in_short(repr(pend_list))}.")
    require_numbers(make, pend_list, keys)
    for number, pend in enumerate(pend_list, start=1):
        if pend["mass"] <= 0:
            found = f"set mass of pendulum {number} to {pend['mass']!r}"
            raise MistakeError(make, f"{found}; it must be above 0.")
        objects = pend.get("objects")
        if not isinstance(objects, tuple) or len(objects) != parts:
            found = f"a {type(objects).__name__}" if "objects" in pend else "nothing"
            must = f"it must be a tuple of {parts} parts."
            raise MistakeError(make, f"set objects of pendulum {number} to {found}; {must}")


def is_pend_list(value: Any) -> bool:
    """Return whether a value is a list of dictionaries."""
    return isinstance(value, list) and all(isinstance(pend, dict) for pend in value)


def require_numbers(function: Callable | str, pend_list: list[dict], keys: Iterable[str]) -> None:
    """Raise a MistakeError if a pendulum has no number below LARGEST_NUMBER for one of these keys.

    The function has set them.
    """
    for number, pend in enumerate(pend_list, start=1):
        for key in keys:
            value: Any = pend.get(key)
            is_real = isinstance(value, Real)
            if not (is_real and abs(value) < LARGEST_NUMBER):
                found = repr(value) if key in pend else "nothing"
                raise MistakeError(
                    function,
                    f"set {key} of pendulum {number} to {found}; "
                    f"it must be a number up to {LARGEST_NUMBER:g}.",
                )
