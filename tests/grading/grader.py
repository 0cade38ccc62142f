"""The grader: the checks, the calls of the students' functions, and the outcomes. pytest_grader.py runs it in pytest.

A check is a function in test_d.py, test_c.py, test_b.py, test_a.py or test_honor_roll.py with @check("...") above it.
The decorator names the function of the handout that it checks. Its docstring, a sentence of the handout, is its title.
It calls the function through expect, which compares the result, or the changed arguments, with the expected ones. The
code of the function does not matter.
"""

import importlib
import os
import sys
import traceback
from collections.abc import Callable
from contextlib import contextmanager, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any, NamedTuple

import pandas  # noqa: F401  its first import is slow, and would count as time of a solution

from grading import limits
from grading.comparing import both, fits, has_form_of, hint_for, mistake_in, OTHER_FORM
from grading.handout import FUNCTIONS, needed, SUITES
from grading.messages import about, Call, culprit_of, end_of, import_hint, line_of, message, plain, shown, stub_of
from grading.project_path import ROOT
from support.constants import NC_FP
from support.start.options import command_line

# --- checks ----------------------------------------------------------------------------------------------------------


class Check(NamedTuple):
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises WrongError or WaitError
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


class WrongError(Exception):
    """A result that the handout does not ask for. Its text is a sentence that says what is wrong."""

    def __init__(self, wrong, call, lines, hint="", hung="", playable=False):
        """lines are the (label, text) pairs below the call in the message. hung says how the call went over a limit."""
        super().__init__(wrong)
        self.call, self.lines, self.hint, self.hung, self.playable = call, lines, hint, hung, playable

    def message(self, *more) -> str:
        """Return the message, with more (label, text) pairs at its end."""
        return message([("wrong", f"{self}"), ("called", self.call.lines()), *self.lines, ("hint", self.hint), *more])


class WaitError(Exception):
    """A check waits. The text says for which function or file, or for the student to write its own function."""

    def __init__(self, cause, hung="", place=""):
        """hung says how the cause went over a limit. place is that of the check's function if it is not written."""
        super().__init__(cause)
        self.hung, self.place = hung, place


CALLS: list[Call] = []  # of the current check
ALONE: list[int] = []  # the number of the only call that expect makes, if there is one: is_right_alone

RETURNS_NOTHING = "Does your function reach a return with a value? (append returns None.)"


def expect(function, *arguments, wanted, see=None, what="", hints=(), times=1) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    see(result) returns the value to compare with wanted, from the result or from the arguments; without see, it is the
    result. wanted is a Wanted, or a value for same. what describes the value in words. hints are pairs: the result of a
    mistake (a value, or a test of a value or an error), and the sentence that names the mistake. A hint is shown only
    if no other hint has the same result. times is the number of calls; a result gives the first arguments of the next.
    """
    call = Call(function, tuple(plain(argument) for argument in arguments), times)
    CALLS.append(call)
    if ALONE and len(CALLS) not in ALONE:
        return None
    expected, returns = ("expected", about(what, wanted)), FUNCTIONS[function].returns
    result = run(call, find(function), arguments, expected, hints)
    if call.has_changed_a_file():
        lines = [("came back", "The file has changed."), ("expected", "The file stays as it is. Only read it.")]
        raise WrongError(f"{function} has changed the file at relative_filepath.", call, lines)
    if result is None and returns:
        raise WrongError(f"{function} returns nothing.", call, [("came back", "None"), expected], RETURNS_NOTHING)
    try:
        found = see(result) if see else result
    except OTHER_FORM as error:
        form = f"This has the wrong form ({type(error).__name__}: {error})."
        lines = [("came back", [*shown(result).split("\n") * bool(returns), form]), expected]
        sentence = f"{what or 'The result'} cannot be read."
        raise WrongError(sentence, call, lines, hint_for(result, wanted, hints)) from None
    if not fits(found, wanted):
        lines, hint = both(what, found, wanted), hint_for(found, wanted, hints)
        sentence = mistake_in(what or returns, found, wanted)
        raise WrongError(sentence, call, lines, hint, playable=has_form_of(found, wanted))
    return result


def find(function) -> Callable:
    """Return a student's function; raise WrongError if it is missing, or WaitError if another file is wrong."""
    file, call = FUNCTIONS[function].file, Call(function)
    try:
        with working_in(ROOT):  # the check may be in another folder
            module = limits.in_limited_memory(importlib.import_module, module_of(file))
    except BaseException as error:  # also SystemExit
        culprit = culprit_of(error)
        if culprit != file and culprit in {other.file for other in FUNCTIONS.values()}:
            raise WaitError(culprit, limits.over_limit(error)) from None
        raise stopped(call, f"Python cannot import {file}.", error, hint=import_hint(error)) from None
    if not callable(getattr(module, function, None)):
        raise WrongError(f"{file} has no function {function}.", call, [])
    return getattr(module, function)


def run(call, solution, arguments, expected, hints) -> Any:
    """Return the result of a student's function. Raise WrongError if it raises an error or goes over a limit, and
    WaitError if it is not written yet, or calls a function that is not written yet.
    """
    try:
        return limits.in_limited_memory(repeat, solution, arguments, call)
    except BaseException as error:  # also SystemExit
        stub = stub_of(error)
        if stub not in (None, call.function):
            raise WaitError(stub) from None
        if stub and call.arguments == tuple(map(plain, arguments)):
            place = line_of(error, FUNCTIONS[stub].file)
            raise WaitError(f"you to write {stub} in {place}", place=place) from None
        limit = limits.over_limit(error)
        sentence = f"{call.function} {limit or 'stops with an error'}."
        hint = "Your code ran up to this line. Now delete it." if stub else hint_for(error, None, hints)
        raise stopped(call, sentence, error, expected, hint=hint) from None


def repeat(solution, arguments, call) -> Any:
    """Return the result of the last call; if the function returns values, they begin the next arguments."""
    for _ in range(call.times):
        result = solution(*arguments)
        if FUNCTIONS[call.function].returns and isinstance(result, tuple):
            arguments = (*result, *arguments[len(result) :])
    return result


def stopped(call, sentence, error, *lines, hint) -> WrongError:
    """Return what to raise if a call raises this error, or if the grader stopped it at a limit."""
    limit = limits.over_limit(error)
    if limit or isinstance(error, (SystemExit, KeyboardInterrupt)):
        hint = "" if limit else "This line ends the whole program. Remove it; return ends a function."
    return WrongError(sentence, call, [end_of(error), *lines], hint, limit)


def is_right_alone(check, number) -> bool:
    """Return whether the call with this number in a check is right if nothing was called before it."""
    CALLS.clear()
    ALONE.append(number)
    try:
        with limits.patience(), limits.without_ends(), imported_again(), redirect_stdout(StringIO()):
            check.ask()
    except BaseException:
        if limits.PRESSED.is_set():
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


# --- judging ---------------------------------------------------------------------------------------------------------

PASSED, WAITING, FAILED, FAULT = "passed", "waiting", "failed", "fault"


class Outcome(NamedTuple):
    state: str
    message: str = ""
    call: Call | None = None  # the call that failed, else the first one; None if watch.py cannot play it
    place: str = ""  # the place of the function, if it is not written yet
    hint: str = ""  # it is in the message, too
    cause: str = ""  # the functions or the file that a check waits for


MATTERS = "This call is right when it is made alone. What does your code keep from the calls before it?"


class Grading:
    """The outcomes of the checks. Each check is made once."""

    def __init__(self, asks_again=True):
        """asks_again: make a call that fails once more, alone, to find out whether the calls before it matter."""
        self.asks_again = asks_again
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
        waits = [name for name in needed(check.function) if self.is_wrong(name)]
        if waits:
            # Find out whether the function is written; skip this if a function hangs.
            outcome = None if self.hung else self.make(checks(function=check.function)[0])
            return outcome if outcome and outcome.place else waiting(", ".join(waits))
        for name in (FUNCTIONS[check.function].file, check.function):
            cause, limit = self.hung.get(name, ("", ""))
            if cause == name:
                lines = [("not called", f"{name} {limit} in an earlier check.")]
                return Outcome(FAILED, message([*lines, where_to_read(check)]))
            if cause:
                return waiting(cause)
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
            with limits.patience(), limits.without_ends():
                check.ask()
            if before and not (shipped.is_file() and shipped.read_bytes() == before):
                shipped.write_bytes(before)
                lines = [("came back", "Your code changed newton_cradle_pends.csv. It is restored now.")]
                lines.append(("expected", "Your function writes no file."))
                raise WrongError(f"{check.function} writes a file.", Call(check.function), lines)
        except WrongError as error:
            return self.failed(check, error)
        except WaitError as error:
            if error.hung:
                self.hung[FUNCTIONS[check.function].file] = str(error), error.hung
            return waiting(str(error), error.place)
        except BaseException:
            if limits.PRESSED.is_set():
                raise
            lines = ["This is a fault of the grader, not of your code. Please show it to your teacher."]
            return Outcome(FAULT, "\n".join([*lines, traceback.format_exc().rstrip()]))
        return Outcome(PASSED, call=CALLS[0] if check.watched else None)

    def failed(self, check, error) -> Outcome:
        """Return the outcome of a check that raised this WrongError."""
        called = error.call.arguments is not None
        if error.hung:
            name = check.function if called else FUNCTIONS[check.function].file
            self.hung[name] = name, error.hung
        elif called and self.asks_again and is_right_alone(check, len(CALLS)):
            error.hint = MATTERS
        lines, call = [where_to_read(check)], error.call if check.watched and error.playable else None
        if call:
            lines.append(("watch", f"{command_line('tests/watch.py', ROOT)} {check.name}"))
        return Outcome(FAILED, error.message(*lines), call, hint=error.hint)


def waiting(cause, place="") -> Outcome:
    """Return the outcome of a check that waits for this cause."""
    return Outcome(WAITING, f"waits for {cause}", place=place, cause=cause)


def where_to_read(check) -> tuple[str, str]:
    """Return the place in the handout about the function of a check, as (label, text)."""
    return "read", f"handout, {FUNCTIONS[check.function].read}: {check.function}"
