"""A Watch: it traces what each statement of a student's function gives, in each turn of its loops.

For one call, instrument.py gives the student's functions other code, which hands its values to a
Watch. traces.py has what it keeps, and trace_table.py writes this down.
"""

import ast
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import wraps
from types import FrameType, FunctionType
from typing import Any

from grading.expressions import names_in_head, Span, targets_of, Values
from grading.traces import (
    Called,
    Change,
    changed_keys,
    gave_in_words,
    got_by,
    is_named,
    Known,
    LOOPS,
    pendula_in,
    Statement,
    Store,
    Trace,
    ValueInWords,
    WatchedCall,
)
from grading.tracing import EndlessError, MOST_TURNS, tracing
from grading.values import in_words, names_in

MOST_TRACES = 20_000  # of a call: then it is not watched further
MOST_TRACES_ENDLESS = 200_000  # of a call that is stopped at MOST_TURNS


class Watch:
    """What the changed code calls, and what it has traced."""

    def __init__(self, call_number: int = 1, is_endless: bool = False):
        """is_endless says that the function went over the limit of time."""
        self.call_number = call_number  # its number in the check
        self.arguments: tuple = ()
        self.is_endless = is_endless
        self.most_traces = MOST_TRACES_ENDLESS if is_endless else MOST_TRACES
        self.count = 0  # of what the changed code has handed over
        self.statements: list[Statement] = []
        self.calls: dict[FrameType, WatchedCall] = {}  # in the order of the calls
        self.stores: list[Store] = []
        self.known: dict[int, Known] = {}  # by the id of the dictionary
        self.error: BaseException | None = None  # what stopped the call

    def begin(self, arguments: tuple) -> None:
        """A call with these arguments begins: forget the one before."""
        self.arguments = arguments
        self.calls.clear()
        self.stores.clear()
        self.known.clear()
        self.count = 0
        self.know(arguments, "")

    def know(self, values: Iterable, giver: str) -> None:
        """Keep copies of the dictionaries that giver gives: a function, or "" for the check."""
        for pend in pendula_in(values):
            self.known.setdefault(id(pend), Known(pend, dict(pend), giver))

    def call_of(self, frame: FrameType) -> WatchedCall | None:
        """Return the call that has this frame, or None if it is not watched further."""
        self.count += 1
        call = self.calls.get(frame)
        if call and self.count > self.most_traces:
            call.is_whole = False
            return None
        return call

    # --- called by the changed code ---

    def enter(self, number: int) -> None:
        """A call of the function with this number begins."""
        frame = sys._getframe(1)
        self.calls[frame] = WatchedCall(number, frame)

    @tracing
    def begin_statement(self, call: WatchedCall, number: int) -> None:
        """A statement begins."""
        call.begin(number)

    @tracing
    def part(self, call: WatchedCall, number: int, span: Span, value: Any) -> None:
        """A part of a statement's expression has this value."""
        call.parts[number][span] = value

    @tracing
    def value(self, call: WatchedCall, number: int, value: Any) -> None:
        """The expression of a statement has this value."""
        call.whole_values[number] = value

    @tracing
    def receiver(self, call: WatchedCall, number: int, value: Any) -> None:
        """A method of this value is called now, and may change it."""
        if type(value) in (dict, list):
            call.before[number] = value, value.copy()

    @tracing
    def test(self, call: WatchedCall, number: int, value: Any) -> None:
        """The condition of an if, a while or an assert has this value."""
        node = self.statements[number].node.test
        text = self.values_in(call, number).condition(node, value)
        self.end(call, number, [ValueInWords("", text, is_false=not value)])

    @tracing
    def turn(self, call: WatchedCall, number: int) -> None:
        """A turn of a loop begins."""
        call.turns[number] += 1
        node = self.statements[number].node
        if isinstance(node, ast.For):
            self.end(call, number, self.stored(call, number))
        call.turns_now[number] += 1
        can_be_endless = isinstance(node, ast.While) or type(call.whole_values.get(number)) is list
        if self.is_endless and can_be_endless and call.turns_now[number] >= MOST_TURNS:
            call.turns[number] -= 1  # the others are whole
            raise EndlessError

    @tracing
    def ran(self, call: WatchedCall, number: int) -> None:
        """A statement that gives nothing runs."""
        self.end(call, number, [])

    @tracing
    def done(self, call: WatchedCall, number: int) -> None:
        """A statement that can store a value has come to its end."""
        values = self.stored(call, number)
        if number in call.before:
            values += self.changed_by_method(call, number)
        else:
            values += self.lost(call, number)
        self.end(call, number, values)

    @tracing
    def gives(self, call: WatchedCall, number: int, value: Any) -> None:
        """A return gives this value."""
        call.result = value
        call.has_result = True
        node = self.statements[number].node.value
        values = self.values_in(call, number)
        if isinstance(node, (ast.Compare, ast.BoolOp)) and isinstance(value, bool):
            text = values.condition(node, value)
        elif isinstance(value, list):
            text = in_words(value)
        else:
            text = in_words(value, values.names_but(node))
        self.end(call, number, [ValueInWords("", f"gives {text}")])

    @tracing
    def caught(self, call: WatchedCall, number: int) -> None:
        """An except takes an error."""
        error: Any = sys.exc_info()[1]
        step = error.__traceback__
        while step.tb_next and step.tb_frame is not call.frame:
            step = step.tb_next
        kind = type(error).__name__
        call.hidden[step.tb_lineno] = kind
        text = f"line {step.tb_lineno} stopped with {kind}: {error}; this except takes it"
        self.end(call, number, [ValueInWords("", text)])

    def function(self, number: int, function: Any) -> Any:
        """This value is called now: return it, or a function that calls it.

        The function keeps what it got and gave.
        """
        call = self.call_of(sys._getframe(1))
        plain = getattr(function, "__func__", function)  # of a method
        if not call or not isinstance(plain, FunctionType) or not is_named(plain):
            return function

        @wraps(plain)
        def traced_call(*arguments: Any, **options: Any) -> Any:
            got = got_by(function, arguments, options, call.frame)
            called = Called(plain.__name__.strip("<>"), got)
            call.called[number].append(called)
            pendula = pendula_in([*arguments, *options.values()])
            before = [dict(pend) for pend in pendula]
            count = len(self.calls)
            try:
                result = function(*arguments, **options)
            finally:
                called.watched_call = self.call_after(count, function)
            line = self.statements[number].node.lineno
            changes = self.changes(call, line, called, pendula, before)
            called.gave = gave_in_words(result, changes, names_in(call.frame))
            called.says_result = result is not None or not changes
            self.know([result], function.__name__)
            return result

        return traced_call

    # --- what they keep ---

    def values_in(self, call: WatchedCall, number: int) -> Values:
        """Return the values in a statement that has not come to its end."""
        return Values(call.frame, call.parts[number])

    def call_after(self, count: int, function: Callable) -> WatchedCall | None:
        """Return the call of a function that came after count others, if it was watched."""
        calls = [*self.calls.values()]
        if len(calls) <= count:
            return None
        call = calls[count]
        is_of_function = self.statements[call.definition].node.name == function.__name__
        return call if is_of_function else None

    def end(self, call: WatchedCall, number: int, values: list[ValueInWords]) -> None:
        """Keep what a statement gave, at its end."""
        statement = self.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        turn = call.turns[loops[-1]] if loops else 0
        is_condition = isinstance(statement.node, ast.While)
        call.traces[number].append(Trace(turn, values, call.called.pop(number, []), is_condition))
        call.begun.discard(number)
        call.parts.pop(number, None)
        if not isinstance(statement.node, ast.For):
            call.whole_values.pop(number, None)

    def stored(self, call: WatchedCall, number: int) -> list[ValueInWords]:
        """Return what a statement has stored where, and keep it in stores."""
        node = self.statements[number].node
        values = self.values_in(call, number)
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
                    holder = values.of(target.value)
                    key = values.of(target.slice)
                else:
                    holder = call
                    key = code
                self.stores.append(Store(holder, key, node.lineno, value, text))
                if code != "_":
                    found.append(ValueInWords(code, text))
        return found

    def changed_by_method(self, call: WatchedCall, number: int) -> list[ValueInWords]:
        """Return what the method that a statement calls has changed, and keep it in stores."""
        node = self.statements[number].node
        code = ast.unparse(node.value.func.value)
        value, before = call.before.pop(number)
        found = []
        if isinstance(value, dict):
            for key in changed_keys(value, before):
                text = in_words(value[key], names_in(call.frame))
                self.stores.append(Store(value, key, node.lineno, value[key], text))
                found.append(ValueInWords(f"{code}[{key!r}]", text))
        elif len(value) != len(before):
            text = in_words(value)
            self.stores.append(Store(call, code, node.lineno, value, text))
            found.append(ValueInWords(code, text))
        return found

    def lost(self, call: WatchedCall, number: int) -> list[ValueInWords]:
        """Return the value of an expression that no name gets.

        None is not lost, and neither is a value that a call in the expression got.
        """
        node = self.statements[number].node
        value = call.whole_values.get(number)
        if not isinstance(node, ast.Expr) or isinstance(node.value, ast.NamedExpr) or value is None:
            return []
        values = self.values_in(call, number)
        options = [option.value for option in getattr(node.value, "keywords", [])]
        for argument in [*getattr(node.value, "args", []), *options]:
            with suppress(LookupError):
                if values.of(argument) is value:
                    return []
        text = f"gives {in_words(value, values.names)}, and no name gets it"
        return [ValueInWords("", text, is_lost=True)]

    def changes(
        self, call: WatchedCall, line: int, called: Called, pendula: list[dict], before: list[dict]
    ) -> list[Change]:
        """Return which values of pendula a call has changed, and keep them in stores."""
        names = names_in(call.frame)
        found = []
        for pend, old in zip(pendula, before, strict=True):
            for key in changed_keys(pend, old):
                text = in_words(pend[key])
                found.append(Change(key, names.get(id(pend), "a pendulum"), text))
                if not called.watched_call:  # else its own lines have stored it
                    self.stores.append(Store(pend, key, line, pend[key], text))
        return found
