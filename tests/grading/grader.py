"""The grader: the checks, the calls of the students' functions, and the outcomes. pytest_grader.py
runs it in pytest.

A check is a function in a suite, such as test_d.py, with @check above it, which names the function
of the handout. Its docstring, in words of the handout, is its title. It calls the function through
expect, which compares the result, or the changed arguments, with the expected ones. The code of the
function does not matter.
"""

import importlib
import re
import sys
import traceback
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout, suppress
from errno import ENOSPC
from io import StringIO
from textwrap import wrap
from typing import Any, NamedTuple

import pandas  # noqa: F401  its first import is slow, and would count as time of a solution

from grading import limits
from grading.comparing import (
    are_pendula,
    both,
    fits,
    is_exchanged,
    mistake_in,
    number_of,
    OTHER_FORM,
    words_of,
)
from grading.evidence import words_for
from grading.handout import FUNCTIONS, is_students, needed, SUITES
from grading.line_by_line import Explained, WrongCall
from grading.messages import (
    about,
    Call,
    COLUMNS,
    damage,
    end_of,
    error_lines,
    message,
    plain,
    PlainFile,
    shown,
)
from grading.raised import Place, StoppedError
from grading.students_code import code_of, MissingError, StudentsCode, working_in
from grading.watch import EndlessError, Watch
from support.start.output import in_one_line


class Check(NamedTuple):
    name: str
    title: str
    tier: str
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises WrongError or WaitError


CHECKS: dict[str, Check] = {}  # by name, in the order of the suites


def check(function) -> Callable:
    """Return a decorator that makes a check of this function."""

    def add(ask):
        ask.is_check = True
        own = ask.__name__, ask.__doc__, FUNCTIONS[function].tier
        CHECKS[ask.__name__] = Check(*own, function, ask)
        return ask

    return add


def checks(*, tier=None, function=None) -> list[Check]:
    """Return the checks of a tier, or of a function."""
    tier = tier or FUNCTIONS[function].tier
    importlib.import_module(SUITES[tier])
    return [
        check
        for check in CHECKS.values()
        if check.tier == tier and function in (None, check.function)
    ]


class WrongError(Exception):
    """A result that the handout does not ask for.

    Its text is a sentence that says what is wrong.
    """

    def __init__(self, wrong, call, lines, result="", raised=None):
        """lines are (label, text) pairs, result has the words for the exact result, and raised is
        what stopped it.
        """
        super().__init__(wrong)
        self.call, self.lines, self.result, self.raised = call, lines, result, raised
        self.help = ""  # what the check says about this call
        # Pairs of a part of the handout's formula, and its value in this call
        self.right: tuple = ()


class WaitError(Exception):
    """A check waits.

    The text says for which function, or for which file that cannot be imported.
    """

    def __init__(self, cause, place="", raised=None):
        """place is that of the check's own function if it is not written. raised is what stopped
        the import.
        """
        super().__init__(cause)
        self.place, self.raised = place, raised


class Steps(NamedTuple):
    """How to write a function, in words, and lines of Python about books that show what it needs."""

    words: str
    python: tuple[str, ...]


STEPS: dict[str, Steps] = {}  # by the function


def steps(function, words, *python) -> None:
    """Give the steps of a function, for students who have not written it, or have written something
    wrong.
    """
    STEPS[function] = Steps(words, python)


runner = StudentsCode()
NOTES: list[str] = []  # sentences for a student whose solution is right


def expect(function, *arguments, help="", right=(), **expected) -> Any:
    """Call a student's function, and return its result; raise WrongError if the result is wrong.

    help    a sentence about this call, for a student whose result is wrong
    right   pairs of a part of the handout's formula, and its value in this call
    The other options are those of compared.
    """
    try:
        return compared(function, *arguments, **expected)
    except WrongError as error:
        error.help, error.right = help, right
        raise


def compared(function, *arguments, wanted, see=None, what="", results=(), notes=(), times=1) -> Any:
    """Do what expect does.

    wanted  the right value: a Wanted, or a value for same
    see     returns the value to compare, from the result or the arguments; without see, it is the result
    what    the name of this value, in words
    results pairs of a wrong result, or a test of it, and words about it
    notes   pairs of a test of a right result, and a sentence
    times   the number of calls; a result gives the first arguments of the next one
    """
    call = Call(function, tuple(map(plain, arguments)), times)
    words = number_of(wanted) if are_pendula(wanted) and not what else about(what, wanted)
    expected, returns = ("expected", words), FUNCTIONS[function].returns
    result = run(call, arguments, expected)
    has_changed = any(
        isinstance(one, PlainFile) and plain(one.path) != one for one in call.arguments
    )
    # The handout lets main write into NC_FP
    if has_changed or runner.has_written and function != "main":
        lines = [
            ("came back", "A file has changed."),
            ("expected", "All files stay as they are. Only read them."),
        ]
        raise WrongError(f"{function} writes into a file.", call, lines)
    for words in damage(call.arguments, FUNCTIONS[function].parameters, arguments):
        lines = [
            ("came back", words),
            ("expected", "The same dictionary, with its keys and its objects."),
        ]
        raise WrongError(f"{function} has lost a pendulum.", call, lines)
    if result is None and returns:
        raise WrongError(f"{function} returns nothing.", call, [("came back", "None"), expected])
    try:
        found = see(result) if see else result
    except OTHER_FORM as error:
        form = f"This has the wrong form ({type(error).__name__}: {error})."
        came_back = [*shown(result).split("\n"), form] if returns else form
        lines = [("came back", came_back), expected]
        is_key = isinstance(error, KeyError)
        sentence = (
            f"A pendulum has no key {error}."
            if is_key
            else f"{what or 'The result'} cannot be read."
        )
        for i, one in enumerate(result if isinstance(result, list) else ()):
            sentence = sentence if isinstance(one, dict) else mistake_in(f"pend_list[{i}]", one, {})
        raise WrongError(sentence, call, lines, words_of(result, results)) from None
    if not fits(found, wanted):
        sentence = mistake_in(what or returns, found, wanted)
        if not what:
            sentence = re.sub(rf"^{returns} (is|has) ", r"The result \1 ", sentence)
        words = words_of(found, results)
        if not words and is_exchanged(found, wanted):
            words = "These are the right values, in another order."
        raise WrongError(sentence, call, both(what, found, wanted), words)
    NOTES.extend(sentence for test, sentence in notes if fits(found, test))
    return result


def result_of(function, *arguments) -> Any:
    """Return the result of a student's function that is correct: the check waits for it, also if it
    is none.
    """
    result = run(Call(function, arguments), arguments, ("expected", "a result"))
    if not (
        isinstance(result, tuple) and len(result) == len(FUNCTIONS[function].returns.split(", "))
    ):
        raise WaitError(function)
    return result


def run(call, arguments, expected) -> Any:
    """Return the result of a student's function. Raise WrongError if it is missing, raises an error
    or goes over a limit, and WaitError if it or a function that it calls is not written yet, or if
    its file is wrong.
    """
    file = FUNCTIONS[call.function].file
    try:
        return runner.run(call.function, arguments, call.times)
    except MissingError:
        raise WrongError(
            f"{file} has no function {call.function}.", Call(call.function), []
        ) from None
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
    raise WrongError(sentence, call, [end_of(raised, raised.places), expected], raised=raised)


def place_of(raised, function) -> Place | None:
    """Return the innermost place of an error in what the student wrote for this function; None if
    it has none.
    """
    if not raised:
        return None
    own = [
        place for place in raised.places if is_students(place.function, function)
    ] or raised.places
    return own[-1] if own else None


DEEPER = 4
NOTHING_SEEN = Explained(0, [], [])

PASSED, WAITING, FAILED, FAULT = "passed", "waiting", "failed", "fault"


class Outcome(NamedTuple):
    state: str
    message: str = ""
    # A file and a line of the student's: where the function is not written yet, or is wrong
    place: str = ""
    hint: str = ""  # of a check that passes, a note
    # The functions or the file that a check waits for, or the file that makes it fail
    cause: str = ""
    wrong: str = ""  # in a sentence
    help: str = ""  # of the check
    # Of the trace tables, as pairs of a rank and lines; a low rank comes first  # noqa: RUF012
    rows: list = []
    facts: list = []  # sentences about what was seen  # noqa: RUF012

    @property
    def is_unwritten(self) -> bool:
        return self.state == WAITING and bool(self.place)


class Grading:
    """The outcomes of the checks. Each check is made once."""

    def __init__(self):
        self.outcomes: dict[str, Outcome] = {}  # by the name of the check
        self.hung: set[str] = set()  # functions that went over a limit: they are not called again
        # Files that cannot be imported, and the file that is the cause
        self.broken: dict[str, str] = {}

    def judge(self, check) -> Outcome:
        """Return the outcome of a check. It waits if its function uses a function that is wrong."""
        # In their order: the first one that fails has the hint
        for each in checks(function=check.function):
            if each.name not in self.outcomes:
                self.outcomes[each.name] = self.outcome_of(each)
            if each.name == check.name:
                break
        return self.outcomes[check.name]

    def outcome_of(self, check) -> Outcome:
        """Return the outcome of a check that was not made yet."""
        waits = [name for name in needed(check.function) if self.is_wrong(name)]
        if waits:
            # Find out whether the function is written; skip this if a function hangs.
            outcome = None if self.hung else self.make(checks(function=check.function)[0])
            is_own = outcome and (outcome.is_unwritten or outcome.cause in self.broken.values())
            return outcome if is_own else waiting(", ".join(waits))
        return waiting(check.function) if check.function in self.hung else self.make(check)

    def is_wrong(self, function) -> bool:
        """Return whether the function is not written, or one of its own checks fails."""
        outcomes = [self.judge(check) for check in checks(function=function)]
        return any(
            each.is_unwritten or each.state in (FAILED, FAULT) and not each.cause
            for each in outcomes
        )

    def make(self, check) -> Outcome:
        """Make a check, and return its outcome."""
        NOTES.clear()
        if FUNCTIONS[check.function].file in self.broken:
            return waiting(self.broken[FUNCTIONS[check.function].file])
        try:
            ask(check)
        except WrongError as error:
            return self.failed(check, error)
        except WaitError as error:
            return (
                self.broken_by(check, error) if error.raised else waiting(str(error), error.place)
            )
        except BaseException as error:
            if (
                limits.PRESSED.is_set()
                or limits.DEBUGGED.is_set()
                or getattr(error, "errno", 0) == ENOSPC
            ):
                raise
            lines = [
                "This is a fault of the grader, not of your code. Please show it to your teacher."
            ]
            return Outcome(FAULT, "\n".join([*lines, traceback.format_exc(limit=-3).rstrip()]))
        return Outcome(PASSED, hint=" ".join(NOTES))

    def failed(self, check, error) -> Outcome:
        """Return the outcome of a check that raised this WrongError.

        The first one of a function has words about it.
        """
        raised, code = error.raised, code_of(check.function)
        if raised and raised.limit:
            self.hung.add(check.function)
        earlier = list(FUNCTIONS)[: list(FUNCTIONS).index(check.function)]
        others = [
            name for name in code.names if name in earlier and not self.hung and self.is_wrong(name)
        ]
        if others:  # the function uses others than those that the handout asks for
            return waiting(", ".join(others))
        before = [
            self.outcomes[each.name]
            for each in checks(function=check.function)
            if each.name in self.outcomes
        ]
        hint, seen = "", NOTHING_SEEN
        if not any(each.state == FAILED for each in before):
            hint = words_for(raised, error.result, f"{error}", code, check.function)
            seen = line_by_line(check, error)
        file = FUNCTIONS[check.function].file
        place = place_of(raised, check.function)
        lines, wrong = error.lines, f"{error}"
        if raised and not raised.limit:
            wrong = error_lines(raised)[0]
        elif raised and seen.line:  # where the clock has stopped it is chance
            place = None
            lines = [end_of(raised, ()), *lines[1:]]
        if place is None:
            line = seen.line or code.line
            place = f"{file}, line {line}" if line else file
        called = error.call.lines(index_in(f"{error}") or 0)
        read = f"handout, {FUNCTIONS[check.function].read}: {check.function}"
        text = message([("wrong", f"{error}"), ("called", called), *lines, ("read", read)])
        return Outcome(
            FAILED,
            text,
            f"{place}",
            in_one_line(hint),
            wrong=wrong,
            help="" if raised else error.help,
            rows=[[row.rank, row.lines] for row in seen.rows],
            facts=seen.facts,
        )

    def broken_by(self, check, error) -> Outcome:
        """Return the outcome of a check whose file cannot be imported: the first one fails, and the
        others wait.
        """
        file, raised = f"{error}", error.raised
        is_first = file not in self.broken.values()
        self.broken[FUNCTIONS[check.function].file] = file
        if not is_first:
            return waiting(file)
        hint = raised.hint or raised.meaning
        wrong = raised.limit or error_lines(raised)[0]
        place, code = file, []
        own = [each for each in raised.places if each.function in ("", "<module>")]
        for each in ([each for each in own if each.file == file] or own)[-1:]:
            place, code = f"{each}", [f"    {each.code}"]
            if raised.mark:
                code.append(f"    {raised.mark}")
            if own[-1] is not raised.places[-1]:
                hint = "This line stands outside of all functions, so it runs when Python reads the file. Remove it."
        lines = [f"{place}:", *code, *wrap(wrong, COLUMNS), *wrap(hint, COLUMNS)]
        return Outcome(FAILED, "\n".join(lines), place, hint, file, wrong)


def ask(check) -> None:
    """Let a check call the student's functions, within limits."""
    runner.count = 0
    with limits.patience(limits.PATIENCE), limits.without_ends(), working_in(runner.folder.name):
        check.ask()


def line_by_line(check, error) -> Explained:
    """Make a check that fails once more, and watch the call that is wrong.

    The student's code prints nothing.

    error is the WrongError of the check. Return NOTHING_SEEN if something else happens now, under a
    debugger, and if the function took too much memory.
    """
    raised = error.raised
    if limits.DEBUGGED.is_set() or isinstance(raised and raised.error, MemoryError):
        return NOTHING_SEEN
    watch = Watch(is_endless=bool(raised and raised.limit))
    runner.watch, runner.watched = watch, runner.count
    depth = sys.getrecursionlimit()
    sys.setrecursionlimit(DEEPER * depth)  # the changed code needs more calls
    try:
        with redirect_stdout(StringIO()), redirect_stderr(StringIO()):
            ask(check)
    except WrongError as again:
        is_same = (f"{again}", again.call.lines()) == (f"{error}", error.call.lines())
        if watch.runs and (is_same or isinstance(watch.error, EndlessError)):
            with suppress(Exception):  # a student's values may say nothing of themselves
                index = index_in(f"{error}")
                return WrongCall(
                    check.function, f"{error}", watch, runner.arguments, index, error.right
                ).explained()
    except Exception:
        return NOTHING_SEEN  # also a WaitError
    finally:
        runner.watch = None
        sys.setrecursionlimit(depth)
    return NOTHING_SEEN


def index_in(sentence) -> int | None:
    """Return the index of the pendulum in question, as a sentence has it: "bob[2] is ..."."""
    found = re.search(r"\b(?:pend_list|axle|bob)\[(\d+)\]", sentence)
    return int(found[1]) if found else None


def waiting(cause, place="") -> Outcome:
    """Return the outcome of a check that waits for this cause."""
    return Outcome(WAITING, f"waits for {cause}", place=place, cause=cause)
