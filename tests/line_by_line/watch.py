"""A Watch: it traces what each statement of a function gives, in each turn of its loops.

For one call, instrument.py gives the functions other code, which hands its values to a Watch.
traces.py has what it keeps, and table.py writes this down.
"""

import ast
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import wraps
from types import FrameType, FunctionType
from typing import Any

from line_by_line.expressions import names_in_head, Span, targets_of, Values
from line_by_line.remarks import remarks_on
from line_by_line.traces import (
    Called,
    Change,
    changed_keys,
    dictionaries_in,
    gave_in_words,
    got_by,
    Known,
    LOOPS,
    Statement,
    Store,
    Trace,
    ValueInWords,
    WatchedCall,
)
from line_by_line.words import in_words, names_in, short_form

MOST_TRACES = 20_000  # of a call: then it is not watched further
MOST_TRACES_ENDLESS = 200_000  # of a call that is stopped at MOST_TURNS
MOST_TURNS = 1000  # of a loop, in a function that went over a limit of time: then it is stopped


class EndlessError(BaseException):
    """A loop has made MOST_TURNS turns in a function that went over a limit of time."""


def tracing(method: Callable) -> Callable:
    """Return a function that lets a method of the Watch trace something of the call that calls it.

    The changed code gives it the number of a statement and some values. It calls the method with
    the watched call in front of these, and returns the last value. It raises an EndlessError, but
    no other error: the values are a student's.
    """

    @wraps(method)
    def trace(self: Any, statement_number: int, *values: Any) -> Any:
        call = self.call_of(sys._getframe(1))
        if call:
            with suppress(Exception):
                method(self, call, statement_number, *values)
        return values[-1] if values else None

    return trace


class Watch:
    """What the changed code calls, and what it has traced."""

    def __init__(
        self, is_named: Callable[[FunctionType], bool] = lambda _: True, is_endless: bool = False
    ):
        """is_named says whether a table names the calls of a function.

        is_endless says that the function went over a limit of time.
        """
        self.is_named = is_named
        self.is_endless = is_endless
        self.most_traces = MOST_TRACES_ENDLESS if is_endless else MOST_TRACES
        self.replaced: dict[int, Any] = {}  # values that statements get in place of their own
        self.statements: list[Statement] = []
        self.error: BaseException | None = None  # what stopped the call
        self.begin(())

    def begin(self, arguments: tuple) -> None:
        """A call with these arguments begins: forget the one before."""
        self.arguments = arguments
        self.count = 0  # of what the changed code has handed over
        self.calls: dict[FrameType, WatchedCall] = {}  # in the order of the calls
        self.stores: list[Store] = []
        self.remarks: dict[str, int] = {}  # sentences about what was seen, with their statements
        self.known: dict[int, Known] = {}  # by the id of the dictionary
        self.know(arguments, "")

    def know(self, values: Iterable, giver: str) -> None:
        """Keep copies of the dictionaries that giver gives: a function, or "" for the caller."""
        for dictionary in dictionaries_in(values):
            known = Known(dictionary, dict(dictionary), giver)
            self.known.setdefault(id(dictionary), known)

    def call_of(self, frame: FrameType) -> WatchedCall | None:
        """Return the call that has this frame, or None if it is not watched further."""
        self.count += 1
        call = self.calls.get(frame)
        if call and self.count > self.most_traces:
            call.is_whole = False
            return None
        return call

    def name_of(self, call: WatchedCall) -> str:
        """Return the name of the function of a call."""
        return self.statements[call.definition].node.name

    def calls_of(self, call: WatchedCall) -> list[WatchedCall]:
        """Return all calls of the function of a call."""
        return [other for other in self.calls.values() if other.definition == call.definition]

    def numbers_of(self, call: WatchedCall) -> list[int]:
        """Return the numbers of the statements in the function of a call."""
        numbers = range(len(self.statements))
        owner = call.definition
        return [number for number in numbers if self.statements[number].owner == owner != number]

    def statement_at(self, call: WatchedCall, line: int) -> int:
        """Return the number of the innermost statement that runs at a line of a call."""
        found = [call.definition]
        for number in self.numbers_of(call):
            node = self.statements[number].node
            if node.lineno <= line <= node.end_lineno:
                found.append(number)
        return max(found, key=lambda number: (number in call.begun, number))

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

    def value(self, number: int, value: Any) -> Any:
        """The expression of a statement has this value, or gets another one."""
        call = self.call_of(sys._getframe(1))
        value = self.replaced.get(number, value)
        if call:
            call.whole_values[number] = value
        return value

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
        self.end(call, number, [ValueInWords("", text)])

    @tracing
    def turn(self, call: WatchedCall, number: int) -> None:
        """A turn of a loop begins."""
        call.turns[number] += 1
        node = self.statements[number].node
        if isinstance(node, ast.For):
            self.end(call, number, self.stored(call, number))
        call.turns_now[number] += 1
        can_be_endless = isinstance(node, ast.While) or type(call.whole_values.get(number)) is list
        if self.is_endless and can_be_endless and call.turns_now[number] > MOST_TURNS:
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
        self.end(call, number, values or self.not_stored(call, number))

    @tracing
    def gives(self, call: WatchedCall, number: int, value: Any) -> None:
        """A return gives this value."""
        call.result = value
        call.returned = number
        node = self.statements[number].node.value
        values = self.values_in(call, number)
        if isinstance(node, (ast.Compare, ast.BoolOp)) and isinstance(value, bool):
            text = values.condition(node, value)
        elif isinstance(value, list):
            text = in_words(value)
        else:
            text = in_words(value, values.names_but(node))
        self.keep(call, "", number, value, text)
        self.end(call, number, [ValueInWords("", f"gives {text}")])

    @tracing
    def caught(self, call: WatchedCall, number: int) -> None:
        """An except takes an error."""
        error: Any = sys.exc_info()[1]
        step = error.__traceback__
        while step.tb_next and step.tb_frame is not call.frame:
            step = step.tb_next
        kind = type(error).__name__
        call.hidden[self.statement_at(call, step.tb_lineno)] = kind
        text = f"line {step.tb_lineno} stopped with {kind}: {error}; this except takes it"
        self.end(call, number, [ValueInWords("", text)])

    def function(self, number: int, function: Any) -> Any:
        """This value is called now: return it, or a function that calls it.

        The function keeps what it got and gave.
        """
        call = self.call_of(sys._getframe(1))
        plain = getattr(function, "__func__", function)  # of a method
        if not call or not isinstance(plain, FunctionType) or not self.is_named(plain):
            return function

        @wraps(plain)
        def traced_call(*arguments: Any, **options: Any) -> Any:
            got = got_by(function, arguments, options, call.frame)
            called = Called(plain.__name__.strip("<>"), got)
            call.called[number].append(called)
            holders = dictionaries_in([*arguments, *options.values()])
            before = [dict(holder) for holder in holders]
            count = len(self.calls)
            result = function(*arguments, **options)
            changes = self.changes(call, number, holders, before, len(self.calls) > count)
            called.gave = gave_in_words(result, changes, names_in(call.frame))
            called.says_result = result is not None or not changes
            self.know([result], function.__name__)
            return result

        return traced_call

    # --- what they keep ---

    def values_in(self, call: WatchedCall, number: int) -> Values:
        """Return the values in a statement that has not come to its end."""
        return Values(call.frame, call.parts[number])

    def end(self, call: WatchedCall, number: int, values: list[ValueInWords]) -> None:
        """Keep what a statement gave, at its end."""
        statement = self.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        turn = call.turns[loops[-1]] if loops else 0
        is_condition = isinstance(statement.node, ast.While)
        call.traces[number].append(Trace(turn, values, call.called.pop(number, []), is_condition))
        call.begun.discard(number)
        for remark in remarks_on(statement.node, self.values_in(call, number)):
            self.remarks[remark] = number
        call.parts.pop(number, None)
        if not isinstance(statement.node, ast.For):
            call.whole_values.pop(number, None)

    def keep(self, holder: Any, key: Any, number: int, value: Any, text: str) -> None:
        """Keep that a statement has stored a value."""
        self.stores.append(Store(holder, key, number, value, text))

    def stored(self, call: WatchedCall, number: int) -> list[ValueInWords]:
        """Return what a statement has stored where, and keep it in stores."""
        values = self.values_in(call, number)
        targets = targets_of(self.statements[number].node)
        new_names = {target.id for target in targets if isinstance(target, ast.Name)}
        found = []
        for target in targets:
            code = ast.unparse(target)
            if new_names & names_in_head(target):
                continue  # a[i], i = 5, 1: now, i is another one
            with suppress(LookupError, TypeError, AttributeError):
                value = values.of(target)
                text = short_form(value) if len(targets) > 1 else ""
                text = text or in_words(value, values.names_but(target))
                if isinstance(target, ast.Subscript):
                    self.keep(values.of(target.value), values.of(target.slice), number, value, text)
                else:
                    self.keep(call, code, number, value, text)
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
                self.keep(value, key, number, value[key], text)
                found.append(ValueInWords(f"{code}[{key!r}]", text))
        elif len(value) != len(before):
            text = in_words(value)
            self.keep(call, code, number, value, text)
            found.append(ValueInWords(code, text))
        return found

    def not_stored(self, call: WatchedCall, number: int) -> list[ValueInWords]:
        """Return the value of an expression that is not stored.

        None is left out, and a value that a call in the expression got.
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
        return [ValueInWords("", f"gives {in_words(value, values.names)}, which is not stored")]

    def changes(
        self,
        call: WatchedCall,
        number: int,
        holders: list[dict],
        before: list[dict],
        is_watched: bool,
    ) -> list[Change]:
        """Return which values of dictionaries a call has changed, and keep them in stores.

        If it was watched, its own lines have stored them.
        """
        names = names_in(call.frame)
        found = []
        for holder, old in zip(holders, before, strict=True):
            for key in changed_keys(holder, old):
                text = in_words(holder[key])
                found.append(Change(key, holder, names.get(id(holder), "a dictionary"), text))
                if not is_watched:
                    self.keep(holder, key, number, holder[key], text)
        return found
