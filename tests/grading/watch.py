"""A call of a student's function, watched: what each of its statements gave, in each turn of its
loops.

For this call, instrument.py gives the student's functions other code, which hands its values to a
Watch. trace_table.py writes down what the Watch has seen.
"""

import ast
import inspect
import sys
from collections import defaultdict
from contextlib import suppress
from dataclasses import dataclass, field
from functools import wraps
from pathlib import Path
from types import FrameType, FunctionType
from typing import Any, NamedTuple

from grading.begin import ROOT

from grading.expressions import names_in_head, targets_of, Values
from grading.values import in_words, names_in

MOST_TURNS = 1000  # of a loop, in a function that went over the limit of time: then it is stopped
MOST_NOTES = 20_000  # of a call: then it is not watched further
MOST_NOTES_ENDLESS = 200_000  # of a call that is stopped at MOST_TURNS
LOOPS = ast.For, ast.While


class EndlessError(BaseException):
    """A loop has made MOST_TURNS turns in a function that went over the limit of time."""


@dataclass
class Statement:
    """A statement of a student's function."""

    node: Any  # of the syntax tree as the student wrote it
    owner: int  # the number of the function's own statement: its def
    loops: tuple[int, ...]  # the numbers of the loops around it, the outer one first
    is_shown: bool  # in a table, if no error stops it: a print and an inner function are not


@dataclass
class Called:
    """A call of another function of src/ or support/."""

    name: str
    got: str  # its parameters and their values
    gave: str = ""  # its result and what it has changed; "" if it did not come to its end
    run: Any = None  # its Run, if the student wrote it


@dataclass
class Seen:
    """What a statement gave once."""

    turn: int  # of the innermost loop around it; for a loop, its own one; 0 without a loop
    words: list[tuple[str, str]]  # the code of a place, or "", and its value as text
    calls: list[Called] = field(default_factory=list)
    is_condition_of_loop: bool = False  # of a while


class Store(NamedTuple):
    """A value that a line has stored in a place: under a key of a dictionary, or under a name of a
    call.
    """

    place: Any  # the dictionary, or the Run
    key: Any  # the key, or the name
    line: int
    value: Any
    text: str  # the value in words


class Run:
    """One call of a function that the student wrote."""

    def __init__(self, definition, frame):
        """definition is the number of its def."""
        self.definition, self.frame = definition, frame
        # By the number of the loop, all of the call
        self.turns: defaultdict[int, int] = defaultdict(int)
        # Since the loop began the last time
        self.turns_now: defaultdict[int, int] = defaultdict(int)
        # By the number of the statement
        self.seen: defaultdict[int, list[Seen]] = defaultdict(list)
        # Of the statements that have begun, and not come to their ends, by their numbers:
        self.begun: set[int] = set()
        self.values: dict[int, Any] = {}  # the value of the expression
        # The values of its parts, by their places
        self.parts: defaultdict[int, dict] = defaultdict(dict)
        self.calls: defaultdict[int, list[Called]] = defaultdict(list)
        self.before: dict[int, tuple] = {}  # what a method may change, and a copy from before
        # The errors that an except has taken, by the line that has stopped
        self.hidden: dict[int, str] = {}
        self.result: Any = None
        self.has_result = False
        self.is_whole = True  # whether it was watched to its end


def noting(method):
    """Return a function that lets a method of the Watch note something of the call that calls it.

    The function gets the number of the statement and some values, and returns the last value. It
    raises no error: the values are a student's.
    """

    @wraps(method)
    def note(self, number, *values):
        run = self.run_of(sys._getframe(1))
        if run:
            with suppress(Exception):
                method(self, run, number, *values)
        return values[-1] if values else None

    return note


class Watch:
    """What the changed code calls, and what it has noted."""

    def __init__(self, is_endless=False):
        """is_endless says that the function went over the limit of time."""
        self.is_endless = is_endless
        self.most_notes = MOST_NOTES_ENDLESS if is_endless else MOST_NOTES
        self.statements: list[Statement] = []
        self.runs: dict[FrameType, Run] = {}  # in the order of the calls
        self.stores: list[Store] = []
        # Dictionaries that others have made, copies of that time, and who gave them
        self.known: dict[int, tuple] = {}
        self.error: BaseException | None = None  # what stopped the call
        self.notes = 0

    def begin(self, arguments) -> None:
        """A call with these arguments begins: forget the one before."""
        for kept in (self.runs, self.stores, self.known):
            kept.clear()
        self.notes = 0
        self.know(arguments, "")

    def know(self, values, giver) -> None:
        """Keep copies of the dictionaries in these values. giver is the function that gives them,
        "" for the check.
        """
        for one in pendula_in(values):
            self.known.setdefault(id(one), (one, dict(one), giver))

    def run_of(self, frame) -> Run | None:
        """Return the call that has this frame, or None if it is not watched further."""
        self.notes += 1
        run = self.runs.get(frame)
        if run and self.notes > self.most_notes:
            run.is_whole = False
            return None
        return run

    # --- called by the changed code ---

    def enter(self, number) -> None:
        """A call of the function with this number begins."""
        frame = sys._getframe(1)
        self.runs[frame] = Run(number, frame)

    @noting
    def begin_statement(self, run, number):
        """Note that a statement begins, and forget its notes from a turn that an error has stopped."""
        run.begun.add(number)
        run.turns_now[number] = 0
        for kept in (run.values, run.parts, run.calls, run.before):
            kept.pop(number, None)

    @noting
    def part(self, run, number, place, value):
        """A part of a statement's expression has this value."""
        run.parts[number][place] = value

    @noting
    def value(self, run, number, value):
        """The expression of a statement has this value."""
        run.values[number] = value

    @noting
    def receiver(self, run, number, value):
        """A method of this value is called now, and may change it."""
        if type(value) in (dict, list):
            run.before[number] = value, value.copy()

    @noting
    def test(self, run, number, value):
        """The condition of an if, a while or an assert has this value."""
        node = self.statements[number].node.test
        self.end(run, number, [("", self.values_in(run, number).condition(node, value))])

    @noting
    def turn(self, run, number):
        """A turn of a loop begins."""
        run.turns[number] += 1
        if isinstance(self.statements[number].node, ast.For):
            self.end(run, number, self.stored(run, number))
        run.turns_now[number] += 1
        can_be_endless = (
            isinstance(self.statements[number].node, ast.While)
            or type(run.values.get(number)) is list
        )
        if self.is_endless and can_be_endless and run.turns_now[number] >= MOST_TURNS:
            run.turns[number] -= 1  # the others are whole
            raise EndlessError

    @noting
    def ran(self, run, number):
        """A statement that gives nothing runs."""
        self.end(run, number, [])

    @noting
    def done(self, run, number):
        """A statement that can store a value has come to its end."""
        words = self.stored(run, number)
        if number in run.before:
            words += self.changed_by_method(run, number)
        else:
            words += self.lost(run, number)
        self.end(run, number, words)

    @noting
    def gives(self, run, number, value):
        """A return gives this value."""
        run.result, run.has_result = value, True
        node, values = self.statements[number].node.value, self.values_in(run, number)
        if isinstance(node, (ast.Compare, ast.BoolOp)) and isinstance(value, bool):
            words = values.condition(node, value)
        else:
            words = in_words(value, {} if isinstance(value, list) else values.names_but(node))
        self.end(run, number, [("", f"gives {words}")])

    @noting
    def caught(self, run, number):
        """An except takes an error."""
        error = sys.exc_info()[1]
        step = error.__traceback__
        while step.tb_next and step.tb_frame is not run.frame:
            step = step.tb_next
        run.hidden[step.tb_lineno] = type(error).__name__
        words = f"line {step.tb_lineno} stopped with {type(error).__name__}: {error}; this except takes it"
        self.end(run, number, [("", words)])

    def function(self, number, function):
        """This value is called now: return it, or a function that calls it and notes what it got
        and gave.
        """
        run = self.run_of(sys._getframe(1))
        plain = getattr(function, "__func__", function)  # of a method
        if not run or not isinstance(plain, FunctionType) or not is_named(plain):
            return function

        @wraps(plain)
        def noted(*arguments, **options):
            called = Called(
                plain.__name__.strip("<>"), got_by(function, arguments, options, run.frame)
            )
            run.calls[number].append(called)
            pendula = pendula_in([*arguments, *options.values()])
            before = [dict(one) for one in pendula]
            count = len(self.runs)
            try:
                result = function(*arguments, **options)
            finally:
                called.run = self.run_after(count, function)
            changes = self.changes(run, number, called, pendula, before)
            called.gave = gave_in_words(result, changes, names_in(run.frame))
            self.know([result], function.__name__)
            return result

        return noted

    # --- what they note ---

    def values_in(self, run, number) -> Values:
        """Return the values in a statement that has not come to its end."""
        return Values(run.frame, run.parts[number])

    def run_after(self, count, function) -> Run | None:
        """Return the call of a function that was the first one after count others, if it was
        watched.
        """
        new = [*self.runs.values()][count : count + 1]
        if new and self.statements[new[0].definition].node.name == function.__name__:
            return new[0]
        return None

    def end(self, run, number, words) -> None:
        """Note what a statement gave, at its end."""
        statement = self.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        turn = run.turns[loops[-1]] if loops else 0
        is_condition = isinstance(statement.node, ast.While)
        run.seen[number].append(Seen(turn, words, run.calls.pop(number, []), is_condition))
        run.begun.discard(number)
        run.parts.pop(number, None)
        if not isinstance(statement.node, ast.For):
            run.values.pop(number, None)

    def stored(self, run, number) -> list[tuple[str, str]]:
        """Return what a statement has stored where, in words, and keep it in stores."""
        node, values = self.statements[number].node, self.values_in(run, number)
        found, targets = [], targets_of(node)
        new_names = {target.id for target in targets if isinstance(target, ast.Name)}
        for target in targets:
            code = ast.unparse(target)
            if new_names & names_in_head(target):
                continue  # a[i], i = 5, 1: now, i is another one
            with suppress(LookupError, TypeError, AttributeError):
                value = values.of(target)
                text = in_words(value, values.names_but(target))
                place, key = run, code
                if isinstance(target, ast.Subscript):
                    place, key = values.of(target.value), values.of(target.slice)
                self.stores.append(Store(place, key, node.lineno, value, text))
                if code != "_":
                    found.append((code, text))
        return found

    def changed_by_method(self, run, number) -> list[tuple[str, str]]:
        """Return what the method that a statement calls has changed, in words, and keep it in
        stores.
        """
        node = self.statements[number].node
        value, before = run.before.pop(number)
        code, found = ast.unparse(node.value.func.value), []
        if isinstance(value, list) and len(value) != len(before):
            self.stores.append(Store(run, code, node.lineno, value, in_words(value)))
            found.append((code, in_words(value)))
        for key in changed_keys(value, before) if isinstance(value, dict) else ():
            text = in_words(value[key], names_in(run.frame))
            self.stores.append(Store(value, key, node.lineno, value[key], text))
            found.append((f"{code}[{key!r}]", text))
        return found

    def lost(self, run, number) -> list[tuple[str, str]]:
        """Return the value of an expression that no name gets, in words: None, and what a call got,
        is not lost.
        """
        node, value = self.statements[number].node, run.values.get(number)
        if not isinstance(node, ast.Expr) or isinstance(node.value, ast.NamedExpr) or value is None:
            return []
        values = self.values_in(run, number)
        options = [option.value for option in getattr(node.value, "keywords", [])]
        for argument in [*getattr(node.value, "args", []), *options]:
            with suppress(LookupError):
                if values.of(argument) is value:
                    return []
        return [("", f"gives {in_words(value, values.names)}, and no name gets it")]

    def changes(self, run, number, called, pendula, before) -> list[str]:
        """Return which values of pendula a call has changed, in words, and keep them in stores."""
        names, line = names_in(run.frame), self.statements[number].node.lineno
        found: dict[str, list[tuple[str, str]]] = {}  # names of pendula and values, by the key
        for pend, old in zip(pendula, before, strict=True):
            for key in changed_keys(pend, old):
                text = in_words(pend[key])
                found.setdefault(key, []).append((names.get(id(pend), "a pendulum"), text))
                if not called.run:  # else its own lines have stored it
                    self.stores.append(Store(pend, key, line, pend[key], text))
        words = []
        for key, pairs in found.items():
            if len(pairs) > 2:
                whose = "" if words else f" of {len(pairs)} pendula"
                words.append(f"set {key}{whose} to {', '.join(text for _, text in pairs)}")
            else:
                words.append(
                    f"set {key} of {' and '.join(f'{name} to {text}' for name, text in pairs)}"
                )
        return words


def gave_in_words(result, changes, names) -> str:
    """Return the result of a call, and what it has changed, in words."""
    if result is not None:
        return " and ".join([f"gave {in_words(result, names)}", *changes])
    return " and ".join(changes) or "gave None"


def got_by(function, arguments, options, frame) -> str:
    """Return what a function gets in a call from a frame, by the names of its parameters.

    What it gets under the same name from a parameter of the caller is left out.
    """
    names = names_in(frame)
    own = frame.f_code.co_varnames[: frame.f_code.co_argcount]
    try:
        given = inspect.signature(function).bind(*arguments, **options).arguments
    except TypeError:  # Python says it, too
        return ", ".join(in_words(one, names) for one in arguments)
    found = []
    for name, value in given.items():
        if name not in own or frame.f_locals.get(name) is not value:
            found.append(f"{name} = {in_words(value, names)}")
    return ", ".join(found)


def is_named(function) -> bool:
    """Return whether the trace table names the calls of a function: those of src/, and the makers
    of pendula.
    """
    file = Path(function.__code__.co_filename)
    return file.is_relative_to(ROOT / "src") or file == ROOT / "support" / "pendulum.py"


def changed_keys(value, before) -> list:
    """Return the keys of a dictionary that have another value than before, also an equal one."""
    return [key for key in value if value[key] is not before.get(key)]


def pendula_in(values) -> list[dict]:
    """Return the dictionaries in these values, and in the lists among them."""
    found = []
    for value in values:
        found += [one for one in (value if type(value) is list else [value]) if type(one) is dict]
    return found
