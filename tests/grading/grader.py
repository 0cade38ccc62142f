"""The checks, and the calls of the students' functions. outcomes.py performs the checks.

A check is a function in a suite, such as test_d.py, with @check above it, which names the function
of the handout. Its docstring, in words of the handout, is its title. It calls the function through
expect, which compares the result, or the changed arguments, with the expected ones. How the
function is written does not matter.
"""

import importlib
import operator
from collections.abc import Callable, Iterable, Sequence
from numbers import Real
from typing import Any, NamedTuple

from vpython import vector

from grading.comparing import (
    are_alike,
    are_pendula,
    both,
    first_difference,
    fits,
    hint_for_result,
    is_exchanged,
    Mistake,
    mistake_in,
    OTHER_FORM,
    same,
)
from grading.handout import FUNCTIONS, is_students, PROGRAM, SUITES
from grading.marks import marks_of
from grading.messages import about, Call, end_of, own_copies, plain, PlainFile
from grading.present import present
from grading.raised import Place, StoppedError
from grading.students_code import MissingError, StudentsCode
from grading.subject import NOTHING, result_of, Subject, What
from line_by_line.words import number_of, text_of


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
        result: Any = None,
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
        self.result = result
        self.help = ""  # what the check says about this call
        # Pairs of a part of the handout's formula, and its value in this call
        self.right: Sequence[tuple[str, Any]] = ()
        self.marks: dict[int, str] = {}  # what is right in a statement, by its number
        self.changed: list[str] = []  # the parameters that the call has changed


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
    what     what this value is
    results  pairs of a wrong result, or a test of it, and a hint
    advice   pairs of a test of a right result, and a sentence
    times    the number of calls; a result gives the first arguments of the next one
    """
    arguments = own_copies(arguments)
    call = Call(function, tuple(map(plain, arguments)), options.get("times", 1))
    try:
        result = compared(call, arguments, right=right, **options)
    except WrongError as error:
        error.help = help
        error.right = right
        error.changed = changed_vectors(call, arguments)
        note_call(call, error)
        is_over_limit = error.raised and error.raised.limit
        if present.seen is None or is_over_limit:
            raise
        return error.result
    note_call(call, None, result)
    return result


def changed_vectors(call: Call, arguments: tuple) -> list[str]:
    """Return the names of the parameters whose vectors a call has changed."""
    names = FUNCTIONS[call.function].parameters.split(", ")
    found = []
    for name, before, after in zip(names, call.arguments or (), arguments, strict=False):
        if isinstance(before, vector) and not same(after, before):
            found.append(name)
    return found


def note_call(call: Call, error: WrongError | None, result: Any = None) -> None:
    """Keep in present.seen what a call with numbers gave, and whether that is right."""
    if present.seen is None or not all(isinstance(value, Real) for value in call.arguments or [""]):
        return
    if error and error.raised:
        gave = f"stopped with {error.raised.kind}"
    elif error:
        gave = f"gave {text_of(error.result)}, wrong"
    else:
        gave = f"gave {text_of(result)}, right"
    present.seen[f"{call.with_numbers()} {gave}"] = error is None


def compared(
    call: Call,
    arguments: tuple,
    *,
    expected: Any,
    see: Callable | None = None,
    what: What | None = None,
    results: Iterable[tuple[Any, str]] = (),
    advice: Iterable[tuple[Any, str]] = (),
    times: int = 1,
    right: Sequence[tuple[str, Any]] = (),
) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    expect explains the options.
    """
    function = call.function
    returns = FUNCTIONS[function].returns
    if are_pendula(expected) and not what:
        expected_line = "expected", [f"a list of {number_of(expected)}"]
    else:
        expected_line = "expected", about(f"{what or ''}", expected)
    result = run(call, arguments, expected_line)
    require_same_files(call)
    if result is None and returns:
        raise WrongError(
            f"{function} returns nothing.", call, [("came back", "None"), expected_line]
        )
    subject = what or result_of(returns)
    try:
        found = see(result) if see else result
    except OTHER_FORM as error:
        form = f"This has the wrong form ({type(error).__name__}: {error})."
        came_back = [*text_of(result).split("\n"), form] if returns else form
        mistake = unreadable(error, subject, result)
        hint = hint_for_result(result, expected, results)
        lines: list[tuple[str, Any]] = [("came back", came_back), expected_line]
        raise WrongError(
            mistake.sentence, call, lines, hint, subject=mistake.subject, result=result
        ) from None
    if not fits(found, expected):
        mistake = mistake_in(subject, found, expected)
        hint = hint_for_result(found, expected, results) or mistake.hint
        if not hint and is_exchanged(found, expected):
            hint = "These are the right values, in another order."
            if returns:  # no value is wrong, but the whole
                mistake = mistake._replace(subject=Subject(is_result=True))
        values = both(what, found, expected)
        wrong = WrongError(
            mistake.sentence, call, values, hint, subject=mistake.subject, result=result
        )
        if times == 1:
            wrong.marks = marks_in(call, right, see, found, expected)
        raise wrong
    for test, sentence in advice:
        if fits(found, test):
            present.advice.append(sentence)
    return result


def marks_in(
    call: Call,
    right: Sequence[tuple[str, Any]],
    see: Callable | None,
    found: Any,
    expected: Any,
) -> dict[int, str]:
    """Return what is right in the first statement with a wrong value, by its number.

    right are the parts of the formula. Without them, and in a call that was not watched, there is
    none.
    """
    if not present.watch or not right:
        return {}
    arguments = call.arguments or ()
    part = first_wrong_part(found, expected)
    with runner.with_other_values(call.function) as call_again:

        def is_mended(replaced: dict[int, Any]) -> bool:
            again = call_again(arguments, replaced)
            return same(part(see(again) if see else again), part(expected))

        try:
            return marks_of(present.watch, right, arguments, is_mended)
        except KeyboardInterrupt:  # all these calls have taken too long
            return {}


def first_wrong_part(found: Any, expected: Any) -> Callable:
    """Return a function that takes the first wrong part from a value like these."""
    if are_alike(found, expected):
        return operator.itemgetter(first_difference(found, expected))
    return lambda value: value


def require_same_files(call: Call) -> None:
    """Raise WrongError if a call has written into a file."""
    files = [value for value in call.arguments or () if isinstance(value, PlainFile)]
    has_changed = any(plain(file.path) != file for file in files)
    # The handout lets the program write into NC_FP
    if has_changed or (runner.has_written and call.function != PROGRAM):
        lines = [
            ("came back", "A file has changed."),
            ("expected", "All files stay as they are. Only read them."),
        ]
        raise WrongError(f"{call.function} writes into a file.", call, lines)


def unreadable(error: Exception, what: What, result: Any) -> Mistake:
    """Return what is wrong with a result from which the check cannot read a value."""
    if isinstance(result, list):
        for i, element in enumerate(result):
            if not isinstance(element, dict):
                return mistake_in(Subject(owner="pend_list", list_index=i), element, {})
    if isinstance(error, KeyError):
        return Mistake(f"A pendulum has no key {error}.", NOTHING)
    return Mistake(f"{what} cannot be read.", NOTHING)


def usable_result(function: str, *arguments: Any) -> Any:
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
    if not raised.limit:
        raise WrongError(raised.text, call, [expected_line], raised=raised)
    sentence = f"{call.function} {raised.limit}."
    raise WrongError(sentence, call, [end_of(raised), expected_line], raised=raised)


def place_of(raised: StoppedError | None, function: str) -> Place | None:
    """Return the innermost place of an error in what the student wrote for this function.

    Return None if it has none.
    """
    if not raised or not raised.places:
        return None
    places = [place for place in raised.places if is_students(place.function, function)]
    return places[-1] if places else raised.places[-1]
