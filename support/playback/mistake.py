"""Report a mistake in one of the handout's functions."""

import linecache
import sys
import traceback
from contextlib import suppress
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class MistakeError(Exception):
    """A function raised no error, but its result is unusable."""

    def __init__(self, function, words):
        """Name the function in the message, before words, which describe the mistake."""
        super().__init__(f"{function.__name__} {words}")
        self.code = function.__code__


def is_own(frame) -> bool:
    """Return whether a frame of a traceback is in one of the handout's files, which are directly in src/."""
    path = Path(frame.filename).resolve()
    return path.parent == ROOT / "src" and path.name != "text_cradle_run.py"


def own_frames(error) -> list[traceback.FrameSummary]:
    """Return the frames of an error that are in the handout's files: none if the error did not arise in these.

    If main calls a method of the player, and the error arises there, main is right: return none, too.
    """
    if isinstance(error, MistakeError):
        file, line = error.code.co_filename, error.code.co_firstlineno
        return [traceback.FrameSummary(file, line, error.code.co_name, line=linecache.getline(file, line).strip())]
    frames = traceback.extract_tb(error.__traceback__)
    own = [number for number, frame in enumerate(frames) if is_own(frame)]
    callee = frames[own[-1] + 1] if own and own[-1] + 1 < len(frames) else None
    if callee and Path(callee.filename).name == "player.py":
        return []
    return [frames[number] for number in own]


def tell_mistake(error) -> str:
    """Print the traceback of an error on stderr, and return the error in one line, with its place.

    The traceback has only lines of the handout's files, the last one last. The functions of support/ and VPython that
    they call are right, but got a wrong argument.
    """
    report = traceback.TracebackException.from_exception(error)
    report.stack[:] = own_frames(error) or report.stack
    if isinstance(error, MistakeError):
        text, words = "".join(report.stack.format()) + f"{error}\n", str(error)
    else:
        text, words = "".join(report.format()), " ".join("".join(report.format_exception_only()).split())
    with suppress(OSError):  # the page says it, too
        print(text, end="", file=sys.stderr, flush=True)
    last = report.stack[-1]
    path = Path(last.filename).resolve()
    place = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else path.name
    return f"{words} ({place}, line {last.lineno})"
