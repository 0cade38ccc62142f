"""Find a mistake in one of the handout's functions, and report it."""

import sys
import traceback
from math import isfinite
from numbers import Real
from pathlib import Path

from support.start.checks_command import checks_command
from support.start.output import say

ROOT = Path(__file__).resolve().parents[2]


class MistakeError(Exception):
    """A function raised no error, but its result is unusable."""

    def __init__(self, function, words):
        """Name the function in the message, before words, which describe the mistake."""
        # A decorator can make it of a class
        name = getattr(function, "__name__", type(function).__name__)
        super().__init__(f"{name} {words}")
        self.code = getattr(function, "__code__", None)


def is_own(filename) -> bool:
    """Return whether a file is one of the handout's."""
    path = Path(filename).resolve()
    return path.parent == ROOT / "src" and path.name != "text_cradle_run.py"


def own_frames(error) -> list[traceback.FrameSummary]:
    """Return the frames of an error that are in the handout's files: none if the error did not
    arise in these.

    Return none as well if main called the player and the player failed.
    """
    if isinstance(error, MistakeError) and error.code:
        return [
            traceback.FrameSummary(
                error.code.co_filename, error.code.co_firstlineno, error.code.co_name
            )
        ]
    frames = traceback.extract_tb(error.__traceback__)
    own = [number for number, frame in enumerate(frames) if is_own(frame.filename)]
    callee = frames[own[-1] + 1] if own and own[-1] + 1 < len(frames) else None
    if callee and Path(callee.filename).name == "player.py":
        return []
    return [frames[number] for number in own]


def report_mistake(error) -> str:
    """Print the traceback of an error on stderr, and return the error in one line, with its place.

    The traceback has only lines of the handout's files: what they call is right, but got a wrong
    argument.
    """
    report = traceback.TracebackException.from_exception(error)
    report.stack[:] = own_frames(error) or report.stack
    if isinstance(error, MistakeError):
        text, words = "".join(report.stack.format()) + f"{error}\n", str(error)
    else:
        text = "".join(report.format())
        words = " ".join("".join(report.format_exception_only()).split())
    if own_frames(error):
        text += f"Type {checks_command()}: it says more about mistakes.\n"
    say(text, sys.stderr, end="")  # the page says it, too
    last = report.stack[-1]
    path = Path(last.filename).resolve()
    place = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else path.name
    return f"{words} ({place}, line {last.lineno})"


def report_endless_loop(error) -> None:
    """Say where Ctrl+C (a KeyboardInterrupt) has stopped functions that have not returned, the
    innermost one first.

    Say nothing if run has marked that the loop was not late.
    """
    frames = own_frames(error)
    if frames and getattr(error, "is_late", True):
        names = " or ".join(
            dict.fromkeys(frame.name for frame in reversed(frames) if frame.name != "<module>")
        )
        place = f"{Path(frames[-1].filename).name}, line {frames[-1].lineno}"
        say(f"{place}: does a loop in {names} never end?", sys.stderr)


def require_pendula(make, pend_list, keys, parts) -> None:
    """Raise a MistakeError if pend_list, the result of the function make, is no list of complete
    pendula.

    keys are those of a pendulum's numbers, parts is the number of its objects.
    """
    require_list(
        make, pend_list, "return a list of dictionaries, and main must show it; page.show got"
    )
    require_numbers(make, pend_list, keys)
    for number, pend in enumerate(pend_list, start=1):
        objects = pend.get("objects")
        if not isinstance(objects, tuple) or len(objects) != parts:
            found = f"a {type(objects).__name__}" if "objects" in pend else "nothing"
            raise MistakeError(
                make, f"set objects of pendulum {number} to {found}; it must be a tuple of parts."
            )


def require_list(make, pend_list, must) -> None:
    """Raise a MistakeError if pend_list is no list of dictionaries; must says what the function
    make must do.
    """
    if not (
        isinstance(pend_list, list)
        and pend_list
        and all(isinstance(pend, dict) for pend in pend_list)
    ):
        found = "an empty list." if pend_list == [] else f"a {type(pend_list).__name__}."
        if pend_list is None:
            found = "None. Is a return missing?"
        raise MistakeError(make, f"must {must} {found}")


def require_numbers(function, pend_list, keys) -> None:
    """Raise a MistakeError if the function has set one of these keys of a pendulum to no finite
    number.
    """
    for number, pend in enumerate(pend_list, start=1):
        for key in keys:
            if not (isinstance(pend.get(key), Real) and isfinite(pend[key])):
                found = repr(pend[key]) if key in pend else "nothing"
                raise MistakeError(
                    function,
                    f"set {key} of pendulum {number} to {found}; it must be a finite number.",
                )
