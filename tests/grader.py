"""The grader: what is graded, how a check is judged, and what a student is told. conftest.py brings it to pytest.

A check is a function in test_d.py, test_c.py, test_b.py, test_a.py or test_honor_roll.py with @check("...") above it,
which names the function of the handout that it is a check of. Its docstring, a sentence of the handout, is its public
name. It calls that function through expect, which compares what it returned or changed with what was expected; how the
function is written is nobody's business here.
"""

import importlib
import signal
import threading
import traceback
from _thread import interrupt_main
from collections.abc import Callable
from contextlib import contextmanager
from math import isclose
from numbers import Real
from typing import Any, NamedTuple

from handout import FUNCTIONS, needed, SUITES, WATCHED
from telling import A, about, Call, culprit_of, message, own_lines, plain, PlainFile, raised, shown
from vpython import vector

PATIENCE = 10.0  # s after which a function that has not come back counts as one that never does


# --- checks ----------------------------------------------------------------------------------------------------------


class Check(NamedTuple):
    function: str  # the name of the function that is checked
    ask: Callable  # calls it, and raises MistakeError
    tier: str
    name: str

    def title(self) -> str:
        """Return the sentence of the handout that it is about, without line breaks."""
        return " ".join((self.ask.__doc__ or self.name).split())


CHECKS: dict[str, Check] = {}  # by name, in the order in which they stand in the suites


def check(function) -> Callable:
    """Return a decorator that makes a check of this function of the handout."""

    def add(ask):
        ask.is_check = True
        CHECKS[ask.__name__] = Check(function, ask, FUNCTIONS[function].tier, ask.__name__)
        return ask

    return add


def checks(*, tier=None, function=None) -> list[Check]:
    """Return the checks of a tier, or of a function."""
    tier = tier or FUNCTIONS[function].tier
    importlib.import_module(SUITES[tier])
    return [check for check in CHECKS.values() if check.tier == tier and function in (None, check.function)]


# --- how a check asks ------------------------------------------------------------------------------------------------


class MistakeError(Exception):
    """What came back, or was changed, is not what the handout asks for."""

    def __init__(self, call, lines, unwritten=False, hung=False, watchable=False):
        """lines are what a student is to read below the call, each as (label, text)."""
        super().__init__(message([("called", call.lines()), *lines]))
        self.call, self.unwritten, self.hung, self.watchable = call, unwritten, hung, watchable


class WaitError(Exception):
    """A check cannot be made before something else is in order."""


def expect(function, *arguments, gives, see=None, what="", hints=(), times=1) -> Any:
    """Call a student's function; raise MistakeError if what comes of it is not what it is to give.

    see(result) takes out of the result, or out of the arguments, what is compared with gives (an A, or a value that is
    compared by same); what says in words what that is. hints are pairs of what a certain mistake gives, or a test of
    that, and the sentence that names the mistake. If it is called more than once, what it returns are the first
    arguments of the next call. Returns the last result.
    """
    call = Call(function, tuple(plain(argument) for argument in arguments), times)
    wanted = ("expected", about(what, gives))
    solution = find(function)
    result = run(call, solution, arguments, wanted)
    for before, path in zip(call.arguments, arguments, strict=True):
        if isinstance(before, PlainFile) and plain(path) != before:
            lines = [("came back", "The file has other contents than before.")]
            raise MistakeError(call, [*lines, ("expected", "The file is read, and stays as it is.")])
    try:
        came = see(result) if see else result
    except Exception as error:
        lines = [*shown(result).split("\n"), f"in which this is missing: {type(error).__name__}: {error}"]
        raise MistakeError(call, [("came back", lines), wanted]) from None
    if not fits(came, gives):
        digits = 6 if shown(came) != shown(gives) else 15  # or they would look alike
        lines = [("came back", about(what, came, digits)), ("expected", about(what, gives, digits))]
        lines += hint(came, gives, hints)
        raise MistakeError(call, lines, watchable=function in WATCHED and came is not None)
    return result


def find(function) -> Callable:
    """Return a student's function; raise MistakeError if there is none, or WaitError if another file is at fault."""
    file = FUNCTIONS[function].file
    try:
        module = importlib.import_module(file.removesuffix(".py").replace("/", "."))
    except (Exception, SystemExit) as error:
        if culprit_of(error) not in (file, None):
            raise WaitError(culprit_of(error)) from None
        raise MistakeError(Call(function), [("it raised", raised(error))]) from None
    if not callable(getattr(module, function, None)):
        raise MistakeError(Call(function), [("came back", f"There is no such function in {file}.")])
    return getattr(module, function)


def run(call, solution, arguments, wanted) -> Any:
    """Return what a student's function returns; raise MistakeError if it raises something, or does not come back."""
    try:
        for _ in range(call.times):
            result = solution(*arguments)
            if call.times > 1 and isinstance(result, tuple):
                arguments = (*result, *arguments[len(result) :])
    except KeyboardInterrupt as stopped:
        if not LATE.is_set():
            raise
        lines = [f"nothing, within {PATIENCE:g} s; it was stopped here:", *own_lines(stopped)]
        raise MistakeError(call, [("came back", lines), wanted], hung=True) from None
    except NotImplementedError as error:
        unwritten = traceback.extract_tb(error.__traceback__)[-1].name == call.function
        if unwritten:
            call = Call(call.function)  # whatever it is called with
        lines = [("not written yet", own_lines(error))] if unwritten else [("it raised", raised(error)), wanted]
        raise MistakeError(call, lines, unwritten) from None
    except (Exception, SystemExit) as error:
        raise MistakeError(call, [("it raised", raised(error)), wanted]) from None
    return result


LATE = threading.Event()  # whether a check was stopped because it took too long


@contextmanager
def patience():
    """Raise a KeyboardInterrupt in the body of the with statement, and set LATE, if it takes longer than PATIENCE."""
    lock, over = threading.Lock(), False

    def interrupt():
        with lock:
            if not over:
                LATE.set()
                interrupt_main()

    LATE.clear()
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background ignores interrupts
    watchdog = threading.Timer(PATIENCE, interrupt)
    watchdog.daemon = True
    watchdog.start()
    try:
        yield
    finally:
        with lock:
            over = True
        watchdog.cancel()
        signal.signal(signal.SIGINT, before)


# --- comparing -------------------------------------------------------------------------------------------------------


def fits(came, wanted) -> bool:
    """Return whether what came back is what is wanted: a value, or an A or another test of it."""
    if isinstance(wanted, A) or callable(wanted):
        test = wanted.is_one if isinstance(wanted, A) else wanted
        try:
            return bool(test(came))
        except Exception:  # it has not even the form that is tested
            return False
    return same(came, wanted)


def same(came, wanted) -> bool:
    """Return whether two values are the same, numbers within rounding errors; 0 is also 0.0."""
    if isinstance(wanted, vector):
        return isinstance(came, vector) and same(came.value, wanted.value)
    if isinstance(wanted, dict):
        return isinstance(came, dict) and came.keys() == wanted.keys() and all(same(came[k], wanted[k]) for k in wanted)
    if isinstance(wanted, (list, tuple)):
        kind = list if isinstance(wanted, list) else tuple
        return isinstance(came, kind) and len(came) == len(wanted) and all(map(same, came, wanted))
    if isinstance(wanted, Real):
        return isinstance(came, Real) and isclose(came, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return type(came) is type(wanted) and bool(came == wanted)


def hint(came, wanted, hints) -> list[tuple[str, str]]:
    """Return the hint that fits what came back, or none."""
    for mistaken, sentence in hints:
        if fits(came, mistaken):
            return [("hint", sentence)]
    if came is None:
        return [("hint", "None is what a function gives that has no return.")]
    if isinstance(wanted, tuple) and len(wanted) > 1 and isinstance(came, (list, tuple)):
        if same(tuple(came), wanted):
            return [("hint", "This is a list; the handout asks for a tuple.")]
        if same(tuple(reversed(came)), wanted):
            return [("hint", "This is what the right values give in the wrong order.")]
    return []


# --- judging ---------------------------------------------------------------------------------------------------------

PASSED, WAITING, FAILED, FAULT = "passed", "waiting", "failed", "fault"


class Outcome(NamedTuple):
    state: str
    message: str = ""
    call: Call | None = None  # the one that failed, if it can be watched
    unwritten: bool = False
    hung: bool = False


class Grading:
    """What has become of the checks, each of which is made once."""

    def __init__(self):
        self.outcomes: dict[str, Outcome] = {}  # by the name of the check

    def judge(self, check) -> Outcome:
        """Return the outcome of a check. It waits if a function that its own one uses has failed checks of its own."""
        if check.name not in self.outcomes:
            waits = [name for name in needed(check.function) if self.has_failed(name)]
            outcome = Outcome(WAITING, f"waits for {', '.join(waits)}")
            if not any(self.has_hung(name) for name in waits):
                made = self.make(check)
                if not waits or made.unwritten:
                    outcome = made
            self.outcomes[check.name] = outcome
        return self.outcomes[check.name]

    def has_failed(self, function) -> bool:
        """Return whether any of the function's own checks fails."""
        return any(self.judge(check).state in (FAILED, FAULT) for check in checks(function=function))

    def has_hung(self, function) -> bool:
        """Return whether the function did not come back, in any of its own checks that were made."""
        return any(
            check.name in self.outcomes and self.outcomes[check.name].hung for check in checks(function=function)
        )

    def make(self, check) -> Outcome:
        """Return what comes of a check by itself."""
        if self.has_hung(check.function):
            lines = [("not called", f"{check.function} did not come back within {PATIENCE:g} s before.")]
            return Outcome(FAILED, message([*lines, *more(check)]))
        try:
            with patience():
                check.ask()
        except MistakeError as wrong:
            text = "\n".join([str(wrong), message(more(check, wrong))])
            return Outcome(FAILED, text, wrong.call if wrong.watchable else None, wrong.unwritten, wrong.hung)
        except WaitError as waits:
            return Outcome(WAITING, f"waits for {waits}")
        except (Exception, KeyboardInterrupt) as error:
            if isinstance(error, KeyboardInterrupt) and not LATE.is_set():
                raise
            lines = ["This is a fault of the grader, not of the solution. Please show it to your teacher."]
            return Outcome(FAULT, "\n".join([*lines, traceback.format_exc().rstrip()]))
        return Outcome(PASSED)


def more(check, wrong=None) -> list[tuple[str, str]]:
    """Return the end of a message: where to read, and how to watch what went wrong."""
    lines = [("read", f"handout, {FUNCTIONS[check.function].read}: {check.function}")]
    if wrong and wrong.watchable:
        lines.append(("watch", f"python tests/watch.py {check.name}"))
    return lines
