"""The grader: it performs checks, which call the student's functions through expect.

expect calls the function, and compares the result, or the changed arguments, with the expected
ones. How the function is written does not matter. outcomes.py judges the checks.
"""

from collections.abc import Callable, Sequence
from contextlib import chdir
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import Any

from grading.assignment import FUNCTIONS, is_students, PROGRAM
from grading.checks import Check, collect, stand_in
from grading.comparing import (
    both,
    fits,
    hint_for_result,
    is_exchanged,
    Mistake,
    mistake_in,
)
from grading.given import defined_twice
from grading.limits import CLOCK, Limits
from grading.messages import about, Call, own_copies, plain
from grading.raised import Place, StoppedError
from grading.students_code import MissingError, StudentsCode
from grading.subject import result_of, Subject, What
from grading.words import text_of
from line_by_line.trace import Trace

NOT_CALLED = "its stand-in"  # the cause of a WaitError: the function has not called it

running: ContextVar["Grader"] = ContextVar("running")  # the grader that performs a check


class WrongError(Exception):
    """A result that the handout does not ask for.

    Its text is a sentence that says what is wrong.
    """

    def __init__(
        self,
        mistake: Mistake,
        call: Call,
        lines: list[tuple[str, Any]],
        hint: str = "",
        raised: StoppedError | None = None,
        result: Any = None,
    ):
        """lines are (label, text) pairs, and raised is what stopped the call.

        hint is what is known about the mistake, or "".
        """
        super().__init__(mistake.sentence)
        self.mistake = mistake
        self.call = call
        self.lines = lines
        self.hint = hint
        self.raised = raised
        self.result = result
        self.is_exchanged = False  # whether the result has the right values, in another order
        self.arguments: tuple = ()  # as they are after the call
        self.help = ""  # what the check says about this call
        # Pairs of a part of the handout's formula, and its value in this call
        self.right: Sequence[tuple[str, Any]] = ()


class WaitError(Exception):
    """A check waits.

    The text says for which function, or for which file that cannot be imported.
    """

    def __init__(self, cause: str, place: str = "", raised: StoppedError | None = None):
        """place is that of the check's own function if it is not written.

        raised is what stopped the import.
        """
        super().__init__(cause)
        self.place = place
        self.raised = raised


@dataclass
class Performance:
    """What is known of a check while it is performed."""

    check: Check
    trace: Trace | None = None
    goes_on: bool = False  # after wrong calls
    errors: list[WrongError] = field(default_factory=list)  # the wrong calls
    stand_ins: dict[str, Callable] = field(default_factory=dict)  # by function
    called: set[str] = field(default_factory=set)  # the functions whose stand-in was called


class Grader:
    """The checks of all suites, and what they need to call the student's functions."""

    def __init__(
        self, has_terminal: bool = False, end: Callable[[str], None] = lambda line: None
    ) -> None:
        """Without a terminal, nobody can debug. end(line) ends pytest with this line."""
        self.checks, self.alone, self.steps = collect()
        self.code = StudentsCode()
        self.new_limits = lambda: Limits(has_terminal, end)
        self.limits = self.new_limits()  # those of the last performance
        self.performance: Performance
        # Whether a call, of any check, may have failed for want of what other programs use as well:
        # time by the clock, memory, the disk
        self.shared_was_short = False

    def checks_of(self, function: str) -> list[Check]:
        """Return the checks of a function."""
        return [check for check in self.checks.values() if check.function == function]

    def perform(self, check: Check, trace: Trace | None = None, goes_on: bool = False) -> None:
        """Let a check call the student's functions, within limits.

        Raise a WrongError or a WaitError. If the function has not called each stand-in, and has not
        stopped by itself, raise a WaitError: nobody knows whether it is right. If it goes on after
        wrong calls, the trace is of the first one.
        """
        performance = self.performance = Performance(check, trace, goes_on)
        for function, gives in check.stand_ins:
            performance.stand_ins[function] = stand_in(function, gives, performance.called)
        self.limits = self.new_limits()
        running.set(self)
        wrong = None
        try:
            with self.limits, chdir(self.code.folder.name):
                check.ask()
        except WrongError as error:
            wrong = error
        places = wrong.raised.places if wrong and wrong.raised else []
        has_stopped = places and is_students(places[-1].function, check.function)
        if performance.called != performance.stand_ins.keys() and not has_stopped:
            raise WaitError(NOT_CALLED)
        if wrong:
            raise wrong

    def run(self, call: Call, arguments: tuple, expected_line: tuple[str, Any]) -> Any:
        """Return the result of a student's function.

        Raise WrongError if it is missing, raises an error or goes over a limit. Raise WaitError if
        it or a function that it calls is not written yet, or if its file is wrong.
        """
        file = FUNCTIONS[call.function].file
        performance = self.performance
        is_traced = not performance.errors and call.function == performance.check.function
        if performance.stand_ins and call.function == PROGRAM:
            is_traced = False  # the import of its file would be traced
        trace = performance.trace if is_traced else None
        try:
            return self.code.run(
                call.function, arguments, call.times, self.limits, performance.stand_ins, trace
            )
        except MissingError:
            mistake = Mistake(f"{file} has no function {call.function}.")
            raise WrongError(mistake, Call(call.function), []) from None
        except StoppedError as error:
            raised = error
        is_of_system = isinstance(raised.error, (MemoryError, OSError))
        self.shared_was_short |= is_of_system or self.limits.stopped_by == CLOCK
        if not raised.function:
            raise WaitError(raised.culprit or file, raised=raised)
        if raised.stub not in (None, performance.check.function):
            raise WaitError(raised.stub)
        if raised.stub and not raised.hint and not defined_twice(file, raised.stub):
            place = f"{place_of(raised, call.function) or file}"
            raise WaitError(f"you to write {raised.stub} in {place}", place)
        sentence = f"{call.function} {raised.limit}." if raised.limit else raised.text
        raise WrongError(Mistake(sentence), call, [expected_line], raised.hint, raised)


def expect(
    function: str,
    *arguments: Any,
    help: str = "",
    right: Sequence[tuple[str, Any]] = (),
    times: int = 1,
    **options: Any,
) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    help     a sentence about this call, for a student whose result is wrong
    right    pairs of a part of the handout's formula, and its value in this call
    times    the number of calls; a result gives the first arguments of the next one
    The other options go to compared:
    expected the right value: an Expected, or a value for same
    see      returns the value to compare, from the result or the arguments; else the result
    what     what this value is
    results  pairs of a wrong result, or a test of it, and a hint
    """
    grader = running.get()
    arguments = own_copies(arguments)
    call = Call(function, tuple(map(plain, arguments)), times)
    try:
        return compared(grader, call, arguments, **options)
    except WrongError as error:
        error.arguments = arguments
        error.help = help
        error.right = right
        grader.performance.errors.append(error)
        is_over_limit = error.raised and error.raised.limit
        if is_over_limit or not grader.performance.goes_on:
            raise
        return error.result


def compared(
    grader: Grader,
    call: Call,
    arguments: tuple,
    *,
    expected: Any,
    see: Callable | None = None,
    what: What | None = None,
    results: Sequence[tuple[Any, str]] = (),
) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    expect explains the options.
    """
    function = call.function
    returns = FUNCTIONS[function].returns
    expected_line = "expected", about(f"{what or ''}", expected)
    result = grader.run(call, arguments, expected_line)
    if result is None and returns:
        mistake = Mistake(f"{function} returns nothing.", found=None)
        raise WrongError(mistake, call, [("came back", "None"), expected_line])
    subject = what or result_of(returns)
    try:
        found = see(result) if see else result
    except Exception as error:  # the result has another form
        mistake = unreadable(error, subject, [result, *arguments])
        lines = [("came back", text_of(result)), expected_line] if returns else [expected_line]
        hint = hint_for_result(result, expected, results)
        raise WrongError(mistake, call, lines, hint, result=result) from None
    if not fits(found, expected):
        mistake = mistake_in(subject, found, expected)
        hint = hint_for_result(found, expected, results) or mistake.hint
        lines = both(what, found, expected)
        wrong = WrongError(mistake, call, lines, hint, result=result)
        wrong.is_exchanged = is_exchanged(found, expected)
        raise wrong
    return result


def unreadable(error: Exception, what: What, values: list) -> Mistake:
    """Return what is wrong with a result or an argument that the check cannot read."""
    for value in values:
        for i, element in enumerate(value if isinstance(value, list) else []):
            if not isinstance(element, dict):
                return mistake_in(Subject(owner="pend_list", list_index=i), element, {})
    if isinstance(error, KeyError):
        return Mistake(f"A pendulum has no key {error}.")
    return Mistake(f"{what} cannot be read.")


def usable_result(function: str, *arguments: Any) -> Any:
    """Call a function that has passed its own checks, and return its result."""
    return running.get().run(Call(function, arguments), arguments, ("expected", "a result"))


def place_of(raised: StoppedError, function: str) -> Place | None:
    """Return the innermost place of an error in what the student wrote for this function.

    Return None if it has none.
    """
    own = [place for place in raised.places if is_students(place.function, function)]
    places = own or raised.places
    return places[-1] if places else None
