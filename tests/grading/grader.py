"""The grader: the checks, the calls of the students' functions, and the outcomes. pytest_grader.py runs it in pytest.

A check is a function in test_d.py, test_c.py, test_b.py, test_a.py or test_honor_roll.py with @check("...") above it.
The decorator names the function of the handout that it checks. Its docstring, in words of the handout, is its title.
It calls the function through expect, which compares the result, or the changed arguments, with the expected ones. The
code of the function does not matter.
"""

import importlib
import traceback
from collections.abc import Callable
from contextlib import redirect_stdout
from errno import ENOSPC
from io import StringIO
from typing import Any, NamedTuple

import pandas  # noqa: F401  its first import is slow, and would count as time of a solution

from grading import limits
from grading.comparing import both, fits, has_form_of, hint_for, mistake_in, OTHER_FORM
from grading.handout import FUNCTIONS, needed, SUITES
from grading.messages import about, Call, end_of, message, plain, PlainFile, shown
from grading.own_process import OwnProcess
from grading.raised import StoppedError

# --- checks ----------------------------------------------------------------------------------------------------------


class Check(NamedTuple):
    name: str
    title: str
    tier: str
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises WrongError or WaitError
    watched: bool  # whether watch.py can play it
    others_wait: bool  # for it, if their functions use this one


CHECKS: dict[str, Check] = {}  # by name, in the order of the suites


def check(function, watched=False, others_wait=True) -> Callable:
    """Return a decorator that makes a check of this function of the handout. watched: watch.py can play it.

    others_wait: if it fails, the functions that use this one wait.
    """

    def add(ask):
        ask.is_check = True
        own = ask.__name__, ask.__doc__, FUNCTIONS[function].tier
        CHECKS[ask.__name__] = Check(*own, function, ask, watched, others_wait)
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


class WaitError(Exception):
    """A check waits. The text says for which function or file, or for the student to write its own function."""

    def __init__(self, cause, hung="", place=""):
        """hung says how the cause went over a limit. place is that of the check's function if it is not written."""
        super().__init__(cause)
        self.hung, self.place = hung, place


student: Any = OwnProcess()  # has the student's functions; for a class, a Solver of tests/teacher/ takes its place

CALLS: list[Call] = []  # of the current check
ALONE: list[int] = []  # the number of the only call that expect makes, if there is one: is_right_alone


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
    result = run(call, arguments, expected, hints)
    if any(isinstance(before, PlainFile) and plain(before.path) != before for before in call.arguments):
        lines = [("came back", "The file has changed."), ("expected", "The file stays as it is. Only read it.")]
        raise WrongError(f"{function} has changed the file at relative_filepath.", call, lines)
    if student.has_written and function != "main":  # the handout lets main write it
        lines = [("came back", "Your code changed newton_cradle_pends.csv. It is restored now.")]
        raise WrongError(f"{function} writes a file.", call, [*lines, ("expected", "Your function writes no file.")])
    if result is None and returns:
        hint = "Does your function reach a return with a value? (append returns None.)"
        raise WrongError(f"{function} returns nothing.", call, [("came back", "None"), expected], hint)
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


def result_of(function, *arguments) -> Any:
    """Return the result of a student's function that is correct: the check waits for it."""
    return run(Call(function, arguments), arguments, ("expected", "a result"), ())


def first_of(file) -> str:
    """Return the first function of a file."""
    return next(name for name, function in FUNCTIONS.items() if function.file == file)


def run(call, arguments, expected, hints) -> Any:
    """Return the result of a student's function. Raise WrongError if it is missing, raises an error or goes over a
    limit, and WaitError if it is not written yet, calls a function that is not, or if another file is wrong.
    """
    file = FUNCTIONS[call.function].file
    try:
        return student.run(call.function, arguments, call.times)
    except StoppedError as error:
        raised = error.raised
    if raised.before == "missing":
        raise WrongError(f"{file} has no function {call.function}.", Call(call.function), [])
    if raised.before:
        is_later = call.function != first_of(file)  # one mistake of the file costs its points only once
        if is_later or raised.culprit != file and raised.culprit in {other.file for other in FUNCTIONS.values()}:
            raise WaitError(raised.culprit or file, raised.limit)
        raise stopped(Call(call.function), f"Python cannot import {file}.", raised, hint=raised.hint)
    if raised.stub not in (None, call.function):
        raise WaitError(raised.stub)
    if raised.stub and call.arguments == tuple(map(plain, arguments)):
        place = file + "".join([f", line {place.line}" for place in raised.places if place.file == file][-1:])
        raise WaitError(f"you to write {raised.stub} in {place}", place=place)
    sentence = f"{call.function} {raised.limit or 'stops with an error'}."
    hint = "Your code ran up to this line. Now delete it." if raised.stub else hint_for(raised, None, hints)
    raise stopped(call, sentence, raised, expected, hint=hint)


def stopped(call, sentence, raised, *lines, hint) -> WrongError:
    """Return what to raise if a student's code was stopped by an error, or at a limit."""
    if raised.limit or raised.ends:
        hint = "" if raised.limit else "This line ends the whole program. Remove it; return ends a function."
    return WrongError(sentence, call, [end_of(raised), *lines], hint, raised.limit)


def is_right_alone(check, number) -> bool:
    """Return whether the call with this number in a check is right if nothing was called before it."""
    CALLS.clear()
    ALONE.append(number)
    try:
        with student.check(is_again=True), redirect_stdout(StringIO()):
            check.ask()
    except BaseException:
        if limits.PRESSED.is_set():
            raise
        return False
    finally:
        ALONE.clear()
    return True


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
            if cause == name and check.function in (name, first_of(FUNCTIONS[check.function].file)):
                lines = [("not called", f"{name} {limit} in an earlier check.")]
                return Outcome(FAILED, message([*lines, where_to_read(check)]))
            if cause:
                return waiting(cause)
        outcome = self.make(check)
        if outcome.state == FAILED and not self.hung:
            earlier = list(FUNCTIONS)[: list(FUNCTIONS).index(check.function)]
            called = student.called.get(check.function, [])
            wrong = [name for name in called if name in earlier and self.is_wrong(name)]
            if wrong:  # the function uses others than those that the handout asks for
                return waiting(", ".join(wrong))
        return outcome

    def is_wrong(self, function) -> bool:
        """Return whether the function is not written, or one of its own checks fails for which others wait."""
        outcomes = [self.judge(check) for check in checks(function=function) if check.others_wait]
        return any(outcome.place or outcome.state in (FAILED, FAULT) for outcome in outcomes)

    def make(self, check) -> Outcome:
        """Make a check, and return its outcome."""
        CALLS.clear()
        try:
            with student.check():
                check.ask()
        except WrongError as error:
            return self.failed(check, error)
        except WaitError as error:
            if error.hung:
                self.hung[FUNCTIONS[check.function].file] = str(error), error.hung
            return waiting(str(error), error.place)
        except BaseException as error:
            if limits.PRESSED.is_set() or getattr(error, "errno", 0) == ENOSPC:
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
        call = error.call if check.watched and error.playable else None
        rows = [("wrong", f"{error}"), ("called", error.call.lines()), *error.lines, ("hint", error.hint)]
        watch = ("watch", f"{student.watch} {check.name}" if call else "")
        return Outcome(FAILED, message([*rows, where_to_read(check), watch]), call, hint=error.hint)


def waiting(cause, place="") -> Outcome:
    """Return the outcome of a check that waits for this cause."""
    return Outcome(WAITING, f"waits for {cause}", place=place, cause=cause)


def where_to_read(check) -> tuple[str, str]:
    """Return the place in the handout about the function of a check, as (label, text)."""
    return "read", f"handout, {FUNCTIONS[check.function].read}: {check.function}"
