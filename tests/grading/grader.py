"""The checks, and the calls of the students' functions. outcomes.py performs the checks.

A check is a function in a suite, such as test_d.py, with @check above it, which names the function
of the handout. Its docstring, in words of the handout, is its title. It calls the function through
expect, which compares the result, or the changed arguments, with the expected ones. How the
function is written does not matter.
"""

import importlib
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

from grading.comparing import (
    are_pendula,
    both,
    fits,
    hint_for_result,
    is_exchanged,
    Mistake,
    mistake_in,
    number_of,
    OTHER_FORM,
)
from grading.handout import FUNCTIONS, is_students, SUITES
from grading.messages import about, Call, damage, end_of, plain, PlainFile, text_of
from grading.present import present
from grading.raised import Place, StoppedError
from grading.students_code import MissingError, StudentsCode
from grading.subject import NOTHING, RESULT, Subject, subject_of


class Check(NamedTuple):
    """A check of a student's function, which gives one point."""

    name: str
    title: str
    tier: str
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises WrongError or WaitError


CHECKS: dict[str, Check] = {}  # by name, in the order of the suites


def check(function: str) -> Callable:
    """Return a decorator that makes a check of this function."""

    def add(ask: Any) -> Any:
        ask.is_check = True
        title = " ".join(ask.__doc__.split())
        tier = FUNCTIONS[function].tier
        CHECKS[ask.__name__] = Check(ask.__name__, title, tier, function, ask)
        return ask

    return add


def checks(*, tier: str = "", function: str = "") -> list[Check]:
    """Return the checks of a tier, or of a function."""
    tier = tier or FUNCTIONS[function].tier
    importlib.import_module(SUITES[tier])
    found = []
    for check in CHECKS.values():
        if check.tier == tier and function in ("", check.function):
            found.append(check)
    return found


class Steps(NamedTuple):
    """How to write a function, and lines of Python about books that show what it needs."""

    sentence: str
    python: tuple[str, ...]


STEPS: dict[str, Steps] = {}  # by the function


def steps(function: str, sentence: str, *python: str) -> None:
    """Give the steps of a function, for students who have not written it, or not correctly."""
    STEPS[function] = Steps(sentence, python)


class WrongError(Exception):
    """A result that the handout does not ask for.

    Its text is a sentence that says what is wrong.
    """

    def __init__(
        self,
        wrong: str,
        call: Call,
        lines: list[tuple[str, Any]],
        hint: str = "",
        raised: StoppedError | None = None,
        subject: Subject = NOTHING,
    ):
        """lines are (label, text) pairs, and raised is what stopped the call.

        hint is that of the exact result, or "". subject is what the sentence is about.
        """
        super().__init__(wrong)
        self.subject = subject
        self.call = call
        self.lines = lines
        self.hint = hint
        self.raised = raised
        self.call_number = present.calls  # of this call in the check
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


runner = StudentsCode()


def expect(
    function: str,
    *arguments: Any,
    help: str = "",
    right: Sequence[tuple[str, Any]] = (),
    **options: Any,
) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    help     a sentence about this call, for a student whose result is wrong
    right    pairs of a part of the handout's formula, and its value in this call
    The other options go to compared:
    expected the right value: an Expected, or a value for same
    see      returns the value to compare, from the result or the arguments; else the result
    what     the name of this value
    results  pairs of a wrong result, or a test of it, and a hint
    advice   pairs of a test of a right result, and a sentence
    times    the number of calls; a result gives the first arguments of the next one
    """
    try:
        return compared(function, *arguments, **options)
    except WrongError as error:
        error.help = help
        error.right = right
        raise


def compared(
    function: str,
    *arguments: Any,
    expected: Any,
    see: Callable | None = None,
    what: str = "",
    results: Iterable[tuple[Any, str]] = (),
    advice: Iterable[tuple[Any, str]] = (),
    times: int = 1,
) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    expect explains the options.
    """
    returns = FUNCTIONS[function].returns
    call = Call(function, tuple(map(plain, arguments)), times)
    is_number = are_pendula(expected) and not what
    expected_line = "expected", number_of(expected) if is_number else about(what, expected)
    result = run(call, arguments, expected_line)
    require_same_files(call)
    require_pendula(call, arguments)
    if result is None and returns:
        raise WrongError(
            f"{function} returns nothing.", call, [("came back", "None"), expected_line]
        )
    try:
        found = see(result) if see else result
    except OTHER_FORM as error:
        form = f"This has the wrong form ({type(error).__name__}: {error})."
        came_back = [*text_of(result).split("\n"), form] if returns else form
        mistake = unreadable(error, what, result)
        hint = hint_for_result(result, results)
        lines: list[tuple[str, Any]] = [("came back", came_back), expected_line]
        raise WrongError(mistake.sentence, call, lines, hint, subject=mistake.subject) from None
    if not fits(found, expected):
        mistake = mistake_in(what or returns, found, expected, is_result=not what)
        hint = hint_for_result(found, results)
        if not hint and is_exchanged(found, expected):
            hint = "These are the right values, in another order."
        values = both(what, found, expected)
        raise WrongError(mistake.sentence, call, values, hint, subject=mistake.subject)
    for test, sentence in advice:
        if fits(found, test):
            present.advice.append(sentence)
    return result


def require_same_files(call: Call) -> None:
    """Raise WrongError if a call has written into a file."""
    files = [value for value in call.arguments or () if isinstance(value, PlainFile)]
    has_changed = any(plain(file.path) != file for file in files)
    # The handout lets main write into NC_FP
    if has_changed or (runner.has_written and call.function != "main"):
        lines = [
            ("came back", "A file has changed."),
            ("expected", "All files stay as they are. Only read them."),
        ]
        raise WrongError(f"{call.function} writes into a file.", call, lines)


def require_pendula(call: Call, arguments: tuple) -> None:
    """Raise WrongError if a pendulum in the arguments of a call is none any more."""
    for damaged in damage(call.arguments or (), FUNCTIONS[call.function].parameters, arguments):
        lines = [
            ("came back", damaged.text),
            ("expected", "The same dictionary, with its keys and its objects."),
        ]
        raise WrongError(f"{call.function} {damaged.verb}.", call, lines)


def unreadable(error: Exception, what: str, result: Any) -> Mistake:
    """Return what is wrong with a result from which the check cannot read a value."""
    name = what or RESULT
    mistake = Mistake(f"{name} cannot be read.", subject_of(name))
    if isinstance(error, KeyError):
        mistake = Mistake(f"A pendulum has no key {error}.", NOTHING)
    if isinstance(result, list):
        for i, element in enumerate(result):
            if not isinstance(element, dict):
                return mistake_in(f"pend_list[{i}]", element, {})
    return mistake


def result_of(function: str, *arguments: Any) -> Any:
    """Call a function that has passed its own checks, and return its result.

    If it returns nothing usable, this check waits for it.
    """
    result = run(Call(function, arguments), arguments, ("expected", "a result"))
    names = FUNCTIONS[function].returns.split(", ")
    if not isinstance(result, tuple) or len(result) != len(names):
        raise WaitError(function)
    return result


def run(call: Call, arguments: tuple, expected_line: tuple[str, Any]) -> Any:
    """Return the result of a student's function.

    Raise WrongError if it is missing, raises an error or goes over a limit. Raise WaitError if it
    or a function that it calls is not written yet, or if its file is wrong.
    """
    file = FUNCTIONS[call.function].file
    try:
        return runner.run(call.function, arguments, call.times)
    except MissingError:
        sentence = f"{file} has no function {call.function}."
        raise WrongError(sentence, Call(call.function), []) from None
    except StoppedError as error:
        raised = error
    if not raised.function:
        raise WaitError(raised.culprit or file, raised=raised)
    if raised.stub not in (None, call.function):
        raise WaitError(raised.stub)
    if raised.stub and not raised.hint:
        place = f"{place_of(raised, call.function) or file}"
        raise WaitError(f"you to write {raised.stub} in {place}", place)
    sentence = f"{call.function} {raised.limit or 'stops with an error'}."
    raise WrongError(sentence, call, [end_of(raised, raised.places), expected_line], raised=raised)


def place_of(raised: StoppedError | None, function: str) -> Place | None:
    """Return the innermost place of an error in what the student wrote for this function.

    Return None if it has none.
    """
    if not raised or not raised.places:
        return None
    places = [place for place in raised.places if is_students(place.function, function)]
    return places[-1] if places else raised.places[-1]
