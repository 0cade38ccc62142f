"""A Watch: it notes what each statement of a student's function gives, in each turn of its loops.

For one call, instrument.py gives the student's functions other code, which hands its values to a
Watch. notes.py has what it notes, and trace_table.py writes this down.
"""

import ast
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import wraps
from types import FrameType, FunctionType
from typing import Any

from grading.expressions import names_in_head, targets_of, Values
from grading.notes import (
    Called,
    Change,
    changed_keys,
    gave_in_words,
    got_by,
    is_named,
    Known,
    LOOPS,
    Note,
    pendula_in,
    Run,
    Statement,
    Store,
    Value,
)
from grading.noting import EndlessError, MOST_TURNS, noting
from grading.values import in_words, names_in

MOST_NOTES = 20_000  # of a call: then it is not watched further
MOST_NOTES_ENDLESS = 200_000  # of a call that is stopped at MOST_TURNS


class Watch:
    """What the changed code calls, and what it has noted."""

    def __init__(self, call: int = 1, is_endless: bool = False):
        """is_endless says that the function went over the limit of time."""
        self.call = call  # its number in the check
        self.arguments: tuple = ()
        self.is_endless = is_endless
        self.most_notes = MOST_NOTES_ENDLESS if is_endless else MOST_NOTES
        self.count = 0  # of what the changed code has handed over
        self.statements: list[Statement] = []
        self.runs: dict[FrameType, Run] = {}  # in the order of the calls
        self.stores: list[Store] = []
        self.known: dict[int, Known] = {}  # by the id of the dictionary
        self.error: BaseException | None = None  # what stopped the call

    def begin(self, arguments: tuple) -> None:
        """A call with these arguments begins: forget the one before."""
        self.arguments = arguments
        self.runs.clear()
        self.stores.clear()
        self.known.clear()
        self.count = 0
        self.know(arguments, "")

    def know(self, values: Iterable, giver: str) -> None:
        """Keep copies of the dictionaries that giver gives: a function, or "" for the check."""
        for pend in pendula_in(values):
            self.known.setdefault(id(pend), Known(pend, dict(pend), giver))

    def run_of(self, frame: FrameType) -> Run | None:
        """Return the call that has this frame, or None if it is not watched further."""
        self.count += 1
        run = self.runs.get(frame)
        if run and self.count > self.most_notes:
            run.is_whole = False
            return None
        return run

    # --- called by the changed code ---

    def enter(self, number: int) -> None:
        """A call of the function with this number begins."""
        frame = sys._getframe(1)
        self.runs[frame] = Run(number, frame)

    @noting
    def begin_statement(self, run: Run, number: int) -> None:
        """A statement begins."""
        run.begin(number)

    @noting
    def part(self, run: Run, number: int, place: tuple[int, ...], value: Any) -> None:
        """A part of a statement's expression has this value."""
        run.parts[number][place] = value

    @noting
    def value(self, run: Run, number: int, value: Any) -> None:
        """The expression of a statement has this value."""
        run.values[number] = value

    @noting
    def receiver(self, run: Run, number: int, value: Any) -> None:
        """A method of this value is called now, and may change it."""
        if type(value) in (dict, list):
            run.before[number] = value, value.copy()

    @noting
    def test(self, run: Run, number: int, value: Any) -> None:
        """The condition of an if, a while or an assert has this value."""
        node = self.statements[number].node.test
        text = self.values_in(run, number).condition(node, value)
        self.end(run, number, [Value("", text, is_false=not value)])

    @noting
    def turn(self, run: Run, number: int) -> None:
        """A turn of a loop begins."""
        run.turns[number] += 1
        node = self.statements[number].node
        if isinstance(node, ast.For):
            self.end(run, number, self.stored(run, number))
        run.turns_now[number] += 1
        can_be_endless = isinstance(node, ast.While) or type(run.values.get(number)) is list
        if self.is_endless and can_be_endless and run.turns_now[number] >= MOST_TURNS:
            run.turns[number] -= 1  # the others are whole
            raise EndlessError

    @noting
    def ran(self, run: Run, number: int) -> None:
        """A statement that gives nothing runs."""
        self.end(run, number, [])

    @noting
    def done(self, run: Run, number: int) -> None:
        """A statement that can store a value has come to its end."""
        values = self.stored(run, number)
        if number in run.before:
            values += self.changed_by_method(run, number)
        else:
            values += self.lost(run, number)
        self.end(run, number, values)

    @noting
    def gives(self, run: Run, number: int, value: Any) -> None:
        """A return gives this value."""
        run.result = value
        run.has_result = True
        node = self.statements[number].node.value
        values = self.values_in(run, number)
        if isinstance(node, (ast.Compare, ast.BoolOp)) and isinstance(value, bool):
            text = values.condition(node, value)
        elif isinstance(value, list):
            text = in_words(value)
        else:
            text = in_words(value, values.names_but(node))
        self.end(run, number, [Value("", f"gives {text}")])

    @noting
    def caught(self, run: Run, number: int) -> None:
        """An except takes an error."""
        error: Any = sys.exc_info()[1]
        step = error.__traceback__
        while step.tb_next and step.tb_frame is not run.frame:
            step = step.tb_next
        kind = type(error).__name__
        run.hidden[step.tb_lineno] = kind
        text = f"line {step.tb_lineno} stopped with {kind}: {error}; this except takes it"
        self.end(run, number, [Value("", text)])

    def function(self, number: int, function: Any) -> Any:
        """This value is called now: return it, or a function that calls it.

        The function notes what it got and gave.
        """
        run = self.run_of(sys._getframe(1))
        plain = getattr(function, "__func__", function)  # of a method
        if not run or not isinstance(plain, FunctionType) or not is_named(plain):
            return function

        @wraps(plain)
        def noted(*arguments: Any, **options: Any) -> Any:
            got = got_by(function, arguments, options, run.frame)
            called = Called(plain.__name__.strip("<>"), got)
            run.calls[number].append(called)
            pendula = pendula_in([*arguments, *options.values()])
            before = [dict(pend) for pend in pendula]
            count = len(self.runs)
            try:
                result = function(*arguments, **options)
            finally:
                called.run = self.run_after(count, function)
            changes = self.changes(run, number, called, pendula, before)
            called.gave = gave_in_words(result, changes, names_in(run.frame))
            called.says_result = result is not None or not changes
            self.know([result], function.__name__)
            return result

        return noted

    # --- what they note ---

    def values_in(self, run: Run, number: int) -> Values:
        """Return the values in a statement that has not come to its end."""
        return Values(run.frame, run.parts[number])

    def run_after(self, count: int, function: Callable) -> Run | None:
        """Return the call of a function that came after count others, if it was watched."""
        runs = [*self.runs.values()]
        if len(runs) <= count:
            return None
        run = runs[count]
        is_of_function = self.statements[run.definition].node.name == function.__name__
        return run if is_of_function else None

    def end(self, run: Run, number: int, values: list[Value]) -> None:
        """Note what a statement gave, at its end."""
        statement = self.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        turn = run.turns[loops[-1]] if loops else 0
        is_condition = isinstance(statement.node, ast.While)
        run.notes[number].append(Note(turn, values, run.calls.pop(number, []), is_condition))
        run.begun.discard(number)
        run.parts.pop(number, None)
        if not isinstance(statement.node, ast.For):
            run.values.pop(number, None)

    def stored(self, run: Run, number: int) -> list[Value]:
        """Return what a statement has stored where, and keep it in stores."""
        node = self.statements[number].node
        values = self.values_in(run, number)
        targets = targets_of(node)
        new_names = {target.id for target in targets if isinstance(target, ast.Name)}
        found = []
        for target in targets:
            code = ast.unparse(target)
            if new_names & names_in_head(target):
                continue  # a[i], i = 5, 1: now, i is another one
            with suppress(LookupError, TypeError, AttributeError):
                value = values.of(target)
                text = in_words(value, values.names_but(target))
                if isinstance(target, ast.Subscript):
                    place = values.of(target.value)
                    key = values.of(target.slice)
                else:
                    place = run
                    key = code
                self.stores.append(Store(place, key, node.lineno, value, text))
                if code != "_":
                    found.append(Value(code, text))
        return found

    def changed_by_method(self, run: Run, number: int) -> list[Value]:
        """Return what the method that a statement calls has changed, and keep it in stores."""
        node = self.statements[number].node
        code = ast.unparse(node.value.func.value)
        value, before = run.before.pop(number)
        found = []
        if isinstance(value, dict):
            for key in changed_keys(value, before):
                text = in_words(value[key], names_in(run.frame))
                self.stores.append(Store(value, key, node.lineno, value[key], text))
                found.append(Value(f"{code}[{key!r}]", text))
        elif len(value) != len(before):
            text = in_words(value)
            self.stores.append(Store(run, code, node.lineno, value, text))
            found.append(Value(code, text))
        return found

    def lost(self, run: Run, number: int) -> list[Value]:
        """Return the value of an expression that no name gets.

        None is not lost, and neither is a value that a call in the expression got.
        """
        node = self.statements[number].node
        value = run.values.get(number)
        if not isinstance(node, ast.Expr) or isinstance(node.value, ast.NamedExpr) or value is None:
            return []
        values = self.values_in(run, number)
        options = [option.value for option in getattr(node.value, "keywords", [])]
        for argument in [*getattr(node.value, "args", []), *options]:
            with suppress(LookupError):
                if values.of(argument) is value:
                    return []
        text = f"gives {in_words(value, values.names)}, and no name gets it"
        return [Value("", text, is_lost=True)]

    def changes(
        self, run: Run, number: int, called: Called, pendula: list[dict], before: list[dict]
    ) -> list[Change]:
        """Return which values of pendula a call has changed, and keep them in stores."""
        names = names_in(run.frame)
        line = self.statements[number].node.lineno
        found = []
        for pend, old in zip(pendula, before, strict=True):
            for key in changed_keys(pend, old):
                text = in_words(pend[key])
                found.append(Change(key, names.get(id(pend), "a pendulum"), text))
                if not called.run:  # else its own lines have stored it
                    self.stores.append(Store(pend, key, line, pend[key], text))
        return found
