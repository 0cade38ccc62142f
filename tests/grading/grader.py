"""The grader: the checks, the calls of the students' functions, and the outcomes. pytest_grader.py runs it in pytest.

A check is a function in test_d.py, test_c.py, test_b.py, test_a.py or test_honor_roll.py with @check("...") above it.
The decorator names the function of the handout that it checks. Its docstring, a sentence of the handout, is its title.
It calls the function through expect, which compares the result, or the changed arguments, with the expected ones. The
code of the function does not matter.
"""

import importlib
import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable
from contextlib import contextmanager, redirect_stdout
from io import StringIO
from math import isclose
from numbers import Real
from pathlib import Path
from typing import Any, NamedTuple

import pandas  # noqa: F401  its first import is slow, and would count as time of a solution
from vpython import vector

from grading import limits
from grading.handout import FUNCTIONS, needed, SUITES
from grading.telling import (
    about,
    Call,
    culprit_of,
    import_hint,
    message,
    mistake_in,
    own_lines,
    place_of,
    plain,
    PlainFile,
    raised,
    ROOT,
    shown,
    unwritten,
    Wanted,
)
from support.constants import NC_FP
from support.start.command_line import command_line

PATIENCE = 5.0  # s; then the grader stops a function
LONG = 130  # characters; of a longer list, a message shows only the first difference

# Errors of a check that reads a value of the wrong form.
OTHER_FORM = (TypeError, ValueError, KeyError, IndexError, AttributeError, ArithmeticError, RecursionError)


# --- checks ----------------------------------------------------------------------------------------------------------


class Check(NamedTuple):
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises MistakeError
    watched: bool  # whether watch.py can play it

    @property
    def name(self) -> str:
        return self.ask.__name__

    @property
    def tier(self) -> str:
        return FUNCTIONS[self.function].tier

    def title(self) -> str:
        """Return its sentence of the handout, without line breaks."""
        return " ".join(self.ask.__doc__.split())


CHECKS: dict[str, Check] = {}  # by name, in the order of the suites


def check(function, watched=False) -> Callable:
    """Return a decorator that makes a check of this function of the handout. watched: watch.py can play it."""

    def add(ask):
        ask.is_check = True
        CHECKS[ask.__name__] = Check(function, ask, watched)
        return ask

    return add


def checks(*, tier=None, function=None) -> list[Check]:
    """Return the checks of a tier, or of a function."""
    tier = tier or FUNCTIONS[function].tier
    importlib.import_module(SUITES[tier])
    return [check for check in CHECKS.values() if check.tier == tier and function in (None, check.function)]


# --- calling students' functions -------------------------------------------------------------------------------------


class MistakeError(Exception):
    """A result that the handout does not ask for. Its text is a sentence that says what is wrong."""

    def __init__(self, wrong, call, lines, hints=(), hung="", playable=False):
        """lines and hints are the (label, text) pairs below the call in the message; there is at most one hint.

        hung says how the call went over a limit.
        """
        super().__init__(wrong)
        self.call, self.lines, self.hints, self.hung, self.playable = call, lines, list(hints), hung, playable

    def message(self, *more) -> str:
        """Return the message, with more (label, text) pairs at its end."""
        return message([("wrong", f"{self}"), ("called", self.call.lines()), *self.lines, *self.hints, *more])


class WaitError(Exception):
    """A check waits for another function or file, which the error names."""

    def __init__(self, what, hung=""):
        super().__init__(what)
        self.hung = hung


class UnwrittenError(Exception):
    """The function of a check is not written yet; the error names its place."""


CALLS: list[Call] = []  # of the current check
ALONE: list[int] = []  # the number of the only call that expect makes, if there is one: is_right_alone


def expect(function, *arguments, gives, see=None, what="", hints=(), times=1, feeds=False) -> Any:
    """Call a student's function, and return its result; raise MistakeError if the result is wrong.

    see(result) returns the value to compare with gives, from the result or from the arguments; without see, it is the
    result. gives is a Wanted, or a value for same. what describes the value in words. hints are pairs: the result of a
    mistake (a value, or a test of a value or an error), and the sentence that names the mistake. A hint is shown only
    if no other hint has the same result. times is the number of calls; with feeds, the result of a call gives the first
    arguments of the next one.
    """
    call = Call(function, tuple(plain(argument) for argument in arguments), times)
    CALLS.append(call)
    if ALONE and len(CALLS) not in ALONE:
        return None
    wanted = ("expected", about(what, gives))
    solution = find(function)
    result = run(call, solution, arguments, wanted, feeds, hints)
    for before, path in zip(call.arguments, arguments, strict=True):
        if isinstance(before, PlainFile) and plain(path) != before:
            lines = [("came back", "The file has changed."), ("expected", "The file stays as it is. Only read it.")]
            raise MistakeError(f"{function} has changed the file at relative_filepath.", call, lines)
    if result is None and FUNCTIONS[function].returns:
        lines = [("came back", "None"), wanted]
        raise MistakeError(f"{function} returns nothing.", call, lines, [("hint", RETURNS_NOTHING)])
    try:
        came = see(result) if see else result
    except OTHER_FORM as error:
        lines = [*shown(result).split("\n")] if FUNCTIONS[function].returns else []
        lines.append(f"This has the wrong form ({type(error).__name__}: {error}).")
        sentence = f"{what or 'The result'} cannot be read."
        raise MistakeError(sentence, call, [("came back", lines), wanted], hint(result, gives, hints)) from None
    if not fits(came, gives):
        sentence = mistake_in(what or FUNCTIONS[function].returns, came, gives, fits)
        digits = 6 if shown(came) != shown(gives) else 15  # else both would look the same
        at, *values = first_difference(what, came, gives)
        lines = [
            (label, about(at, value, digits)) for label, value in zip(("came back", "expected"), values, strict=True)
        ]
        raise MistakeError(sentence, call, lines, hint(came, gives, hints), playable=has_form_of(came, gives))
    return result


def find(function) -> Callable:
    """Return a student's function; raise MistakeError if it is missing, or WaitError if another file is wrong."""
    file = FUNCTIONS[function].file
    try:
        with working_in(ROOT):  # the check may be in another folder
            module = limits.in_limited_memory(importlib.import_module, module_of(file))
    except BaseException as error:  # also SystemExit
        if is_ctrl_c(error):
            raise
        hung = over_limit(error)
        culprit = culprit_of(error)
        if culprit != file and culprit in {other.file for other in FUNCTIONS.values()}:
            raise WaitError(culprit, hung) from None
        lines = [("came back", stopped(error))] if hung else [("it raised", raised(error))]
        sentence = f"Python cannot import {file}."
        raise MistakeError(sentence, Call(function), lines, import_hint(error) or end_hint(error), hung) from None
    if not callable(getattr(module, function, None)):
        raise MistakeError(f"{file} has no function {function}.", Call(function), [])
    return getattr(module, function)


def run(call, solution, arguments, wanted, feeds, hints) -> Any:
    """Return the result of a student's function. Raise MistakeError if it raises an error or goes over a limit,
    UnwrittenError if it is not written yet, and WaitError if it calls a function that is not written yet.
    """
    try:
        return limits.in_limited_memory(repeat, solution, arguments, call.times, feeds)
    except BaseException as error:  # also SystemExit
        if is_ctrl_c(error):
            raise
        limit = over_limit(error)
        if limit:
            sentence = f"{call.function} {limit}."
            raise MistakeError(sentence, call, [("came back", stopped(error)), wanted], hung=limit) from None
        stub = unwritten(error)
        if stub not in (None, call.function):
            raise WaitError(stub) from None
        if stub and call.arguments == tuple(map(plain, arguments)):
            raise UnwrittenError(place_of(error, FUNCTIONS[stub].file)) from None
        has_worked = [("hint", "Your code ran up to this line. Now delete it.")] if stub else []
        sentence = f"{call.function} stops with an error."
        lines, found = [("it raised", raised(error)), wanted], has_worked or end_hint(error) or hint(error, None, hints)
        raise MistakeError(sentence, call, lines, found) from None


def repeat(solution, arguments, times, feeds) -> Any:
    """Return the result of the last call; with feeds, the result of a call begins the next arguments."""
    for _ in range(times):
        result = solution(*arguments)
        if feeds and isinstance(result, tuple):
            arguments = (*result, *arguments[len(result) :])
    return result


def is_right_alone(check, number) -> bool:
    """Return whether the call with this number in a check is right if nothing was called before it."""
    CALLS.clear()
    ALONE.append(number)
    try:
        with patience(), limits.without_ends(), imported_again(), redirect_stdout(StringIO()):
            check.ask()
    except BaseException as error:
        if is_ctrl_c(error):
            raise
        return False
    finally:
        ALONE.clear()
    return True


@contextmanager
def imported_again():
    """Let the body of the with statement import the student's modules again, so that they have kept nothing."""
    kept = {name: sys.modules.pop(name) for name in list(sys.modules) if name.partition(".")[0] == "src"}
    try:
        yield
    finally:
        for name in [name for name in sys.modules if name.partition(".")[0] == "src"]:
            del sys.modules[name]
        sys.modules.update(kept)


@contextmanager
def working_in(folder):
    """Make this folder the working directory, in the body of the with statement."""
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def module_of(file) -> str:
    """Return the module name of a file of the project."""
    return file.removesuffix(".py").replace("/", ".")


def over_limit(error) -> str:
    """Return how a call that raised this error went over a limit, or "" if it did not."""
    if isinstance(error, KeyboardInterrupt) and LATE.is_set():
        return f"took longer than {PATIENCE:g} s"
    return f"took more than {limits.MOST_MEMORY} MB of memory" if isinstance(error, MemoryError) else ""


def stopped(error) -> list[str]:
    """Return lines that say where a call went over a limit."""
    is_late = isinstance(error, KeyboardInterrupt)
    what = f"nothing, within {PATIENCE:g} s; it was" if is_late else f"nothing; it {over_limit(error)} and was"
    return [f"{what} stopped here:", *own_lines(error)]


def end_hint(error) -> list[tuple[str, str]]:
    """Return the hint for a call that wants to end the program, or no hint."""
    ends = isinstance(error, (SystemExit, KeyboardInterrupt))
    return [("hint", "This line ends the whole program. Remove it; return ends a function.")] if ends else []


LATE = threading.Event()  # set if the grader stopped a check
PRESSED = threading.Event()  # set if somebody pressed Ctrl+C


def is_ctrl_c(error) -> bool:
    """Return whether somebody pressed Ctrl+C: neither the grader nor the function itself raised this error."""
    return isinstance(error, KeyboardInterrupt) and PRESSED.is_set()


@contextmanager
def patience():
    """Raise a KeyboardInterrupt in the body of the with statement, and set LATE, if it takes longer than PATIENCE."""
    lock, over = threading.Lock(), threading.Event()

    def interrupt():
        in_time = over.wait(PATIENCE)
        while not in_time:  # repeat it: the solution may catch the first one
            with lock:
                if not over.is_set():
                    LATE.set()
                    interrupt_main_thread()
            in_time = over.wait(0.5)

    def on_interrupt(*_):
        if not LATE.is_set():
            PRESSED.set()
        raise KeyboardInterrupt

    LATE.clear()
    PRESSED.clear()
    before = signal.signal(signal.SIGINT, on_interrupt)  # a background job ignores interrupts
    threading.Thread(target=interrupt, daemon=True).start()
    try:
        yield
    finally:
        with lock:
            over.set()
        signal.signal(signal.SIGINT, before)


def interrupt_main_thread() -> None:
    """Do the same as Ctrl+C: this also ends a sleep. On Windows, any thread can send the signal."""
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)
    else:
        signal.raise_signal(signal.SIGINT)


# --- comparing -------------------------------------------------------------------------------------------------------


def fits(came, wanted) -> bool:
    """Return whether came is right; wanted is a value, a Wanted, or a test of a value."""
    test = wanted.is_one if isinstance(wanted, Wanted) else wanted if callable(wanted) else None
    try:
        return bool(test(came)) if test else same(came, wanted)
    except OTHER_FORM:
        return False


def same(came, wanted) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0."""
    if isinstance(wanted, vector):
        return isinstance(came, vector) and same(came.value, wanted.value)
    if isinstance(wanted, dict):
        return isinstance(came, dict) and came.keys() == wanted.keys() and all(same(came[k], wanted[k]) for k in wanted)
    if isinstance(wanted, (list, tuple)):
        kind = list if isinstance(wanted, list) else tuple
        return isinstance(came, kind) and len(came) == len(wanted) and all(map(same, came, wanted))
    if isinstance(wanted, str):
        return isinstance(came, str) and came == wanted
    if isinstance(wanted, Real):
        return isinstance(came, Real) and isclose(came, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return type(came) is type(wanted) and bool(came == wanted)


def first_difference(what, came, wanted) -> tuple:
    """Return what, came and wanted; for long lists, those of the first wrong element."""
    are_lists = isinstance(came, list) and isinstance(wanted, list) and len(came) == len(wanted)
    are_long = are_lists and max(len(shown(came)), len(shown(wanted))) > LONG
    if are_long or (are_lists and isinstance(wanted[0], dict)):
        i = [same(*pair) for pair in zip(came, wanted, strict=True)].index(False)
        return f"{what} at index {i}".lstrip(), came[i], wanted[i]
    return what, came, wanted


def has_form_of(came, wanted) -> bool:
    """Return whether only the numbers in came are wrong: watch.py can then play the scene."""
    if isinstance(wanted, Wanted):
        return has_form_of(came, wanted.like)
    if isinstance(wanted, (tuple, list)):
        is_row = isinstance(came, (tuple, list)) and len(came) == len(wanted)
        return is_row and all(map(has_form_of, came, wanted))
    return isinstance(came, Real) if isinstance(wanted, Real) else came is not None


RETURNS_NOTHING = "Does your function reach a return with a value? (append returns None.)"


def hint(came, wanted, hints) -> list[tuple[str, str]]:
    """Return the hint for this result, or no hint. If two mistakes give this result, nobody knows which one it was."""
    sentences = {sentence for mistaken, sentence in hints if fits(came, mistaken)}
    if not sentences and isinstance(wanted, tuple) and len(wanted) > 1 and isinstance(came, (list, tuple)):
        if same(tuple(came), wanted):
            sentences.add("You returned a list. Return a tuple.")
        if same(tuple(reversed(came)), wanted):
            sentences.add("The values are right, but in the wrong order.")
    return [("hint", sentence) for sentence in sentences] if len(sentences) == 1 else []


# --- judging ---------------------------------------------------------------------------------------------------------

PASSED, WAITING, FAILED, FAULT = "passed", "waiting", "failed", "fault"


class Outcome(NamedTuple):
    state: str
    message: str = ""
    call: Call | None = None  # the call that failed, else the first one; None if watch.py cannot play it
    place: str = ""  # the place of the function, if it is not written yet


MATTERS = "This call is right when it is made alone. What does your code keep from the calls before it?"


class Grading:
    """The outcomes of the checks. Each check is made once."""

    def __init__(self):
        self.outcomes: dict[str, Outcome] = {}  # by the name of the check
        # Functions and files that went over a limit: the cause, mostly themselves, and the limit in words.
        self.hung: dict[str, tuple[str, str]] = {}

    def judge(self, check) -> Outcome:
        """Return the outcome of a check. It waits if its function uses a function that is wrong."""
        if check.name not in self.outcomes:
            self.outcomes[check.name] = self.outcome_of(check)
        return self.outcomes[check.name]

    def outcome_of(self, check) -> Outcome:
        """Return the outcome of a check that was not made yet."""
        function = FUNCTIONS[check.function]
        waits = [name for name in needed(check.function) if self.is_wrong(name)]
        if waits:
            # Find out whether the function is written; skip this if a function hangs.
            outcome = None if self.hung else self.make(checks(function=check.function)[0])
            is_written = outcome is None or not outcome.place
            return Outcome(WAITING, f"waits for {', '.join(waits)}") if is_written else outcome
        for name in (function.file, check.function):
            cause, limit = self.hung.get(name, ("", ""))
            if cause == name:
                lines = [("not called", f"{name} {limit} in an earlier check.")]
                return Outcome(FAILED, message([*lines, where_to_read(check)]))
            if cause:
                return Outcome(WAITING, f"waits for {cause}")
        return self.make(check)

    def is_wrong(self, function) -> bool:
        """Return whether the function is not written, or one of its own checks fails."""
        outcomes = map(self.judge, checks(function=function))
        return any(outcome.place or outcome.state in (FAILED, FAULT) for outcome in outcomes)

    def make(self, check) -> Outcome:
        """Make a check, and return its outcome."""
        CALLS.clear()
        shipped = Path(NC_FP)
        before = shipped.read_bytes() if shipped.is_file() else None
        try:
            with patience(), limits.without_ends():
                check.ask()
            if before and not (shipped.is_file() and shipped.read_bytes() == before):
                shipped.write_bytes(before)
                lines = [("came back", "Your code changed newton_cradle_pends.csv. It is restored now.")]
                lines.append(("expected", "Your function writes no file."))
                raise MistakeError(f"{check.function} writes a file.", Call(check.function), lines)
        except MistakeError as mistake:
            return self.failed(check, mistake)
        except UnwrittenError as place:
            return Outcome(WAITING, f"waits for you to write {check.function} in {place}", place=str(place))
        except WaitError as error:
            if error.hung:
                self.hung[FUNCTIONS[check.function].file] = str(error), error.hung
            return Outcome(WAITING, f"waits for {error}")
        except BaseException as error:
            if is_ctrl_c(error):
                raise
            lines = ["This is a fault of the grader, not of your code. Please show it to your teacher."]
            return Outcome(FAULT, "\n".join([*lines, traceback.format_exc().rstrip()]))
        return Outcome(PASSED, call=CALLS[0] if check.watched else None)

    def failed(self, check, mistake) -> Outcome:
        """Return the outcome of a check in which a function made this mistake."""
        called = mistake.call.arguments is not None
        if mistake.hung:
            name = check.function if called else FUNCTIONS[check.function].file
            self.hung[name] = name, mistake.hung
        elif called and is_right_alone(check, len(CALLS)):
            mistake.hints = [("hint", MATTERS)]
        lines, is_scene = [where_to_read(check)], check.watched and mistake.playable
        if is_scene:
            lines.append(("watch", f"{command_line('tests/watch.py', ROOT)} {check.name}"))
        return Outcome(FAILED, mistake.message(*lines), mistake.call if is_scene else None)


def where_to_read(check) -> tuple[str, str]:
    """Return the place in the handout about the function of a check, as (label, text)."""
    return "read", f"handout, {FUNCTIONS[check.function].read}: {check.function}"
