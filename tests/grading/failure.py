"""A failed check: it is performed again, and what was seen becomes parts of the screen."""

import sys
from contextlib import redirect_stderr, redirect_stdout, suppress
from io import StringIO
from typing import Any, NamedTuple

from grading import limits
from grading.grader import Check, checks, place_of, runner, STEPS, WrongError
from grading.handout import FUNCTIONS, PROGRAM
from grading.messages import error_lines, place_lines
from grading.present import present
from grading.room import labelled, Part, Rank
from grading.story import WrongCall
from grading.students_code import Code, is_named, working_in
from line_by_line.watch import Watch
from line_by_line.words import text_of
from support.start.output import in_one_line

DEEPER = 4  # times more calls within each other, for code that is watched
MOST_CALLS = 3  # others of a function that are shown


class Told(NamedTuple):
    """What a student reads about a failed check."""

    wrong: list[str]  # what is wrong, the call, and both values
    hint: str
    place: str  # a file and a line of it, if one is certain, else ""
    parts: list[Part]  # of the screen, with what is wrong


def tell(check: Check, error: WrongError, code: Code) -> Told:
    """Return what a student reads about a check that raised this WrongError.

    code is that of its function.
    """
    seen = watch_again(check, error)
    error = seen.error
    hint = in_one_line(hint_for(error, code))
    wrong = what_is_wrong(error, hint, has_code=bool(seen.code))
    place = seen.place
    if error.raised and not error.raised.limit:
        place = f"{place_of(error.raised, check.function) or ''}"
    parts = [Part(Rank.ALWAYS, wrong), *seen.code, *about(check, error, seen.facts)]
    others = [] if seen.has_state else other_calls(check, error)
    for text in others:
        parts.append(Part(Rank.OTHER_CALLS, labelled("also called", text)))
    return Told(wrong, hint, place, parts)


def hint_for(error: WrongError, code: Code) -> str:
    """Return what is known about a mistake, or "". code is that of the function."""
    function = error.call.function
    found = code.parameters.split(", ")
    expected = FUNCTIONS[function].parameters.split(", ")
    if code.line and sorted(found) == sorted(expected) and found != expected:
        return f"The def line has changed. It must be: def {function}({', '.join(expected)}):"
    return error.raised.hint if error.raised else error.hint


def what_is_wrong(error: WrongError, hint: str, has_code: bool = False) -> list[str]:
    """Return what is wrong, the call, and both values, as lines of the screen.

    has_code says whether the lines at which an error has stopped are shown below.
    """
    sentence = f"{error}"
    lines = error.lines
    if error.raised and not error.raised.limit:
        sentence, *more = error_lines(error.raised)
        places = [] if has_code else place_lines(error.raised.places)
        lines = [("", [*more, *places]), *lines]
    end = "" if sentence.endswith((".", "?", "!")) else "."
    pairs = [
        ("wrong", f"{sentence}{end} {hint}".strip()),
        ("called", error.call.lines(error.subject.list_index or 0)),
        *lines,
    ]
    found = []
    for label, text in pairs:
        if text:
            found += labelled(label, text)
    return found


def about(check: Check, error: WrongError, facts: list[str]) -> list[Part]:
    """Return what is right, what was seen, and the steps, as parts of the screen."""
    parts = []
    if error.right and not error.raised:
        right = ", ".join(f"{name} = {text_of(value)}" for name, value in error.right)
        parts.append(Part(Rank.RIGHT, labelled("right here", f"{right}.")))
    if error.help and not error.raised:
        parts.append(Part(Rank.RIGHT, labelled("right here", error.help)))
    parts += [Part(Rank.SEEN, labelled("seen", fact)) for fact in facts]
    return [*parts, *steps_of(check.function)]


def steps_of(function: str) -> list[Part]:
    """Return the steps of a function, its place in the handout, and lines of Python for it."""
    steps = STEPS[function]
    parts = [
        Part(Rank.STEPS, labelled("steps", steps.sentence)),
        Part(Rank.READ, labelled("read", f"handout, {FUNCTIONS[function].read}")),
    ]
    if steps.python:
        parts.append(Part(Rank.BOOKS, labelled("in Python", [*steps.python])))
    return parts


def ask(check: Check, watch: Watch | None = None, seen: dict[str, bool] | None = None) -> None:
    """Let a check call the student's functions, within limits.

    A watch is for its calls. With a dictionary for the calls that are seen, it goes on after a
    wrong result.
    """
    present.begin(check.function, watch, seen)
    with limits.patience(limits.PATIENCE), limits.without_ends(), working_in(runner.folder.name):
        check.ask()


def ask_again(check: Check, **again: Any) -> None:
    """Let a check ask again, with a watch or with seen. The student's code prints nothing now."""
    with redirect_stdout(StringIO()), redirect_stderr(StringIO()):
        ask(check, **again)


class SeenAgain(NamedTuple):
    """A failed check that was performed again, and what was seen of the wrong call."""

    error: WrongError
    place: str = ""  # a file and a line of it, if one is certain
    code: list[Part] = []  # rows of the tables
    facts: list[str] = []
    has_state: bool = False  # whether values live on, so that each call depends on those before


def watch_again(check: Check, error: WrongError) -> SeenAgain:
    """Perform a failed check again, watch its calls, and return what was seen of the wrong one.

    Nothing is seen of the program, which is no function, under a debugger, and if the function took
    too much memory.
    """
    raised = error.raised
    took_memory = bool(raised and isinstance(raised.error, MemoryError))
    if check.function == PROGRAM or present.is_debugged or took_memory:
        return SeenAgain(error)
    is_endless = bool(raised and raised.limit)
    watch = Watch(is_named, is_endless)
    depth = sys.getrecursionlimit()
    sys.setrecursionlimit(DEEPER * depth)  # the changed code needs more calls
    try:
        ask_again(check, watch=watch)
    except WrongError as again:
        is_slower = again.raised and again.raised.limit  # as it is watched
        again = error if is_endless or is_slower else again
        if watch.calls:
            with suppress(Exception):  # a student's values may say nothing of themselves
                call = WrongCall(check.function, again, watch, present.lasting)
                code = call.parts_of_code()
                return SeenAgain(again, call.place, code, call.facts(), bool(call.lasting))
        return SeenAgain(again)
    except (Exception, KeyboardInterrupt):  # also a WaitError
        if present.is_pressed:
            raise
        return SeenAgain(error)
    finally:
        present.watch = None
        sys.setrecursionlimit(depth)
    return SeenAgain(error, facts=["Called again with the same values, it gave the right result."])


def other_calls(check: Check, error: WrongError) -> list[str]:
    """Return other calls of a function that failed: of all its checks, those with numbers alone."""
    if error.raised and error.raised.limit:
        return []
    own = error.call.with_numbers()
    seen: dict[str, bool] = {}
    for other in checks(function=check.function):
        try:
            ask_again(other, seen=seen)
        except WrongError:  # it went over a limit: no more calls
            break
        except (Exception, KeyboardInterrupt):  # a check may need right results to go on
            if present.is_pressed:
                raise
    present.seen = None
    others = {text: is_right for text, is_right in seen.items() if not text.startswith(own)}
    right = [text for text, is_right in others.items() if is_right]
    wrong = [text for text, is_right in others.items() if not is_right]
    if error.raised and not right:  # all stopped
        return []
    return [*right[: MOST_CALLS - 1], *wrong][:MOST_CALLS]
