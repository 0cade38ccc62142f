"""Find a mistake in one of the handout's functions, and report it."""

import sys
import traceback
from collections.abc import Callable, Iterable
from numbers import Real
from pathlib import Path
from typing import Any

from support.root import ROOT
from support.start.commands import checks_command
from support.start.other_tools import of_other_tool
from support.start.output import complain, say
from support.start.packages import report_of_package

LARGEST_NUMBER = 1e100  # a larger number has no energy: its square is too large
# A frame of this file below one of main: the player works, or waits for the clock.
PLAYER_FILE = ROOT / "support" / "cradle" / "player.py"


class MistakeError(Exception):
    """A function raised no error, but its result is unusable."""

    def __init__(self, function: Callable, message: str) -> None:
        """Put the function's name before the message, which describes the mistake."""
        # A decorator can make it of a class
        name = getattr(function, "__name__", type(function).__name__)
        super().__init__(f"{name} {message}")
        self.code = getattr(function, "__code__", None)


def is_handout_file(filename: str) -> bool:
    """Return whether a file is one of the handout's."""
    path = Path(filename).resolve()
    return path.parent == ROOT / "src" and path.name != "text_cradle_run.py"


def is_player_file(filename: str) -> bool:
    return Path(filename).resolve() == PLAYER_FILE


def handout_frames(error: BaseException) -> list[traceback.FrameSummary]:
    """Return the frames of an error that are in the handout's files.

    Return none if the error did not arise in these, or if main called the player and the player
    failed.
    """
    if isinstance(error, MistakeError) and error.code:
        code = error.code
        return [traceback.FrameSummary(code.co_filename, code.co_firstlineno, code.co_name)]
    found: list[traceback.FrameSummary] = []
    callee = ""  # the file of the frame below the last found one
    for frame in traceback.extract_tb(error.__traceback__):
        if is_handout_file(frame.filename):
            found.append(frame)
            callee = ""
        elif not callee:
            callee = frame.filename
    return [] if is_player_file(callee) else found


def report_mistake(error: BaseException) -> str:
    """Print the traceback of an error on stderr, and return the error in one line, with its place.

    The traceback has only lines of the handout's files: what they call is right, but got a wrong
    argument. An error of a package, or for want of input, is printed in one line.
    """
    frames = handout_frames(error)
    line = report_of_package(error) or report_of_input(error, frames)
    if line:
        complain(line)
        return line
    report = traceback.TracebackException.from_exception(error)
    report.stack[:] = frames or report.stack
    if isinstance(error, MistakeError):
        message = str(error)
        text = "".join(report.stack.format()) + f"{message}\n"
    else:
        message = " ".join("".join(report.format_exception_only()).split())
        text = "".join(report.format())
    if isinstance(error, SyntaxError):
        text += f"{of_other_tool(error.text or '')}\n".lstrip()
    if frames:
        text += f"Type {checks_command()}: it says more about mistakes.\n"
    say(text, sys.stderr, end="")  # the page says it, too
    last = report.stack[-1]
    path = Path(last.filename).resolve()
    place = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else path.name
    return f"{message} ({place}, line {last.lineno})"


def report_of_input(error: BaseException, frames: list[traceback.FrameSummary]) -> str:
    """Return in one line that a line of a student's file finds nobody who types, or ""."""
    words = {
        "BdbQuit": "the debugger has ended the program. Delete the line that starts it.",
        "EOFError": "this line waits for input, but nobody can type here. Delete it.",
    }.get(type(error).__name__)
    if not words or not frames:
        return ""
    return f"{Path(frames[-1].filename).name}, line {frames[-1].lineno}: {words}"


def report_endless_loop(error: KeyboardInterrupt) -> None:
    """Name the loop that Ctrl+C has stopped: the functions that have not returned, innermost first.

    If frames were still coming (is_late is False), say nothing: nothing hung.
    """
    frames = handout_frames(error)
    if not frames or not getattr(error, "is_late", True):
        return
    names = [frame.name for frame in reversed(frames) if frame.name != "<module>"]
    functions = " or ".join(dict.fromkeys(names))  # each once
    last = frames[-1]
    place = f"{Path(last.filename).name}, line {last.lineno}"
    say(f"{place}: does a loop in {functions} never end?", sys.stderr)


def require_pendula(make: Callable, pend_list: Any, keys: Iterable[str], parts: int) -> None:
    """Raise a MistakeError if the function make has returned no list of complete pendula.

    keys are those of a pendulum's numbers, parts is the number of its objects.
    """
    must = "return a list of dictionaries, and main must show it; page.show got"
    require_list(make, pend_list, must)
    require_numbers(make, pend_list, keys)
    for number, pend in enumerate(pend_list, start=1):
        objects = pend.get("objects")
        if not isinstance(objects, tuple) or len(objects) != parts:
            found = f"a {type(objects).__name__}" if "objects" in pend else "nothing"
            raise MistakeError(
                make, f"set objects of pendulum {number} to {found}; it must be a tuple of parts."
            )


def require_list(make: Callable, pend_list: Any, must: str) -> None:
    """Raise a MistakeError if pend_list is no list of dictionaries.

    must says what the function make must do.
    """
    if is_pend_list(pend_list) and pend_list:
        return
    found = f"a {type(pend_list).__name__}."
    if pend_list == []:
        found = "an empty list."
    elif pend_list is None:
        found = "None. Is a return missing?"
    raise MistakeError(make, f"must {must} {found}")


def is_pend_list(value: Any) -> bool:
    """Return whether a value is a list of dictionaries."""
    return isinstance(value, list) and all(isinstance(pend, dict) for pend in value)


def require_numbers(function: Callable, pend_list: list[dict], keys: Iterable[str]) -> None:
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
