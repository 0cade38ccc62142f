"""The trace table of a call that was watched: a row for each line of code.

layout.py lays the rows out.
"""

import ast
import builtins
import os
from typing import Any

from line_by_line.expressions import names_in_head, targets_of, used_in_head
from line_by_line.instrument import TRIES
from line_by_line.layout import cell, cells, INDENT, Kind, laid_out, once, Remark, Row
from line_by_line.source import head_of, indentation_of
from line_by_line.stops import Stop, stops_in
from line_by_line.traces import Called, LOOPS, Trace, WatchedCall
from line_by_line.watch import Watch
from line_by_line.words import in_words

MOST_CALLS = 3  # of a line that are shown
FEW_TURNS = 4  # turns of a loop that are all shown
LONG = 140  # characters of the values of all turns; if they are longer, only one turn is shown


class Table:
    """The trace table of one call of a function that the student wrote."""

    def __init__(
        self,
        watch: Watch,
        call: WatchedCall,
        stop: Stop | None = None,
        marks: dict[int, str] | None = None,
        index: int | None = None,
    ):
        """marks has what is said of a statement with a wrong value.

        index is that of the turn in question, from 0, or None.
        """
        self.watch = watch
        self.call = call
        self.stop = stop
        self.marks = marks or {}
        self.index = index
        self.numbers = [number for number in watch.numbers_of(call) if self.is_shown(number)]

    def is_shown(self, number: int) -> bool:
        """Return whether a statement has a row: a print has one only if it has stopped."""
        is_stop = self.stop is not None and number == self.stop.number
        return self.watch.statements[number].is_shown or is_stop

    def node(self, number: int) -> Any:
        return self.watch.statements[number].node

    def rows(self) -> list[Row]:
        """Return the rows in the order of the code."""
        columns = {}
        for number in self.numbers:
            columns[number] = indentation_of(self.node(number), self.call.file)
        first_column = min(columns.values(), default=0)
        lines = [self.node(number).lineno for number in self.numbers]
        width = len(str(max(lines, default=0)))
        rows: list[Row] = []
        for number, line in zip(self.numbers, lines, strict=True):
            remark = self.remark_on(number)
            if remark:
                code = head_of(self.node(number), self.call.file)
                code = f"{' ' * (columns[number] - first_column)}{code}"
                rows.append(Row(remark.kind, number, laid_out(f"{line:>{width}}", code, remark)))
        return rows

    # --- what is said of a statement ---

    def remark_on(self, number: int) -> Remark | None:
        """Return what is said of a statement, or None if it comes after a stop."""
        if isinstance(self.node(number), TRIES):
            return Remark(Kind.NO_END)
        remark = self.remark_on_traces(number)
        if self.stop and number == self.stop.number:
            return self.remark_on_stop(self.stop, remark or Remark(Kind.STOPPED))
        if not remark:
            is_after = self.stop and self.stop.is_error and number > self.stop.number
            if is_after and self.call.is_whole:
                return None
            return Remark(Kind.NO_END, self.why_it_has_no_end(number))
        if number in self.marks:
            after = f"{remark.after}  <- {self.marks[number]}"
            return Remark(Kind.MARKED, after, remark.below)
        return remark

    def remark_on_traces(self, number: int) -> Remark | None:
        """Return what is said of a statement, or None if it did not come to its end."""
        traces = self.call.traces.get(number)
        is_loop = isinstance(self.node(number), LOOPS)
        if not traces:
            is_empty = is_loop and number in self.call.whole_values and not self.stop
            return Remark(Kind.GAVE, "no turn") if is_empty else None
        kind = Kind.IDLE
        if any(trace.calls for trace in traces):
            kind = Kind.CALLED
        elif any(trace.values for trace in traces):
            kind = Kind.GAVE
        after = self.in_turns(number, traces)
        return Remark(kind, after, tuple(self.calls_in_words(number, traces)))

    def remark_on_stop(self, stop: Stop, remark: Remark) -> Remark:
        """Return what is said of the statement that has stopped.

        These are its earlier turns (in remark), and the values at which it stopped.
        """
        calls = self.call.called.get(stop.number, [])
        below = []
        if stop.is_error and not calls:  # what a call got is shown anyway
            below = self.values_at_stop(stop.number)
        turn = self.begun_turns(stop.number)
        label = f"turn {turn}: " if turn > 1 else ""
        below += [f"{label}{called.name} got {called.got}" for called in calls if called.got]
        after = f"{remark.after}  <- {stop.how}".strip()
        return Remark(Kind.STOPPED, after, (*remark.below[-1:], *below))

    def values_at_stop(self, number: int) -> list[str]:
        """Return the values at which a statement was stopped, and the lines that gave them."""
        values = self.watch.values_in(self.call, number)
        node = self.node(number)
        operands = values.operands_at_stop(node)
        if not operands and len(targets_of(node)) > 1 and number in self.call.whole_values:
            return [f"the value is {in_words(self.call.whole_values[number])}"]
        found = []
        for operand in operands or values.not_called(used_in_head(node)):
            text = values.operand(operand)
            if text and isinstance(operand, ast.Name):
                text += self.giver_of(operand.id)
            found.append(text)
        used = names_in_head(node)
        if isinstance(node, ast.AugAssign):
            used.add(getattr(node.target, "id", ""))
        found += [self.why_unset(name) for name in sorted(used) if not values.has(name)]
        return [*dict.fromkeys(filter(None, found))]

    def giver_of(self, name: str) -> str:
        """Return which line has given a name its value, or "", to be said behind the value."""
        stores = [store for store in self.watch.stores if store.holder is self.call]
        lines = [self.node(store.number).lineno for store in stores if store.key == name]
        if not lines:
            return ""
        text = f": line {lines[-1]} gave it this value"
        if hasattr(builtins, name):
            text = f"{text}; Python's own {name} has this name, too"
        return text

    def why_unset(self, name: str) -> str:
        """Return why a name has no value, if a line of the function sets it; else ""."""
        setting = self.lines_that_set(name)
        if not setting:
            return ""
        own = f"so {name} is a name of this function alone"
        return f"{name} has no value yet: line {setting[0]} gives it one, {own}"

    def lines_that_set(self, name: str) -> list[int]:
        """Return the lines of the function that give a name a value, also if they never ran."""
        lines = []
        for number in self.watch.numbers_of(self.call):
            node = self.node(number)
            if name in [getattr(target, "id", "") for target in targets_of(node)]:
                lines.append(node.lineno)
        return lines

    def why_it_has_no_end(self, number: int) -> str:
        """Return what is said of a statement that did not come to its end in any turn."""
        if number in self.call.hidden:
            return f"stopped: {self.call.hidden[number]}"
        if not self.call.is_whole:
            return "(not watched further)"
        if number in self.call.begun:
            return "(did not come to its end)"
        return "(not in this call)" if len(self.watch.calls_of(self.call)) > 1 else "(never ran)"

    # --- the turns of a loop ---

    def begun_turns(self, number: int) -> int:
        """Return how many turns the innermost loop has begun that is or is around a statement."""
        statement = self.watch.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        return self.call.turns[loops[-1]] if loops else 0

    def numbers_of_turns(self, columns: int) -> list[int]:
        """Return which turns are shown: the first two, the one in question, and the last one."""
        if columns <= FEW_TURNS:
            return [*range(1, columns + 1)]
        turns = {1, 2, columns}
        if self.index is not None and self.index < columns:
            turns.add(self.index + 1)
        return sorted(turns)

    def in_turns(self, number: int, traces: list[Trace]) -> str:
        """Return what a statement gave, in each turn of its loop that is shown."""
        turns = self.begun_turns(number)
        if not turns:
            return once(traces[-1].values)
        by_turn = {trace.turn: cell(trace.values) for trace in traces}
        if traces[0].is_condition_of_loop:  # it comes once more at each end of the loop
            by_turn = {i: cell(trace.values) for i, trace in enumerate(traces, start=1)}
            turns = len(traces)
        is_in_each = len(by_turn) == turns
        is_stop = self.stop is not None and number == self.stop.number
        if (is_in_each or is_stop) and not any(trace.values for trace in traces):
            return ""
        if is_in_each and len({*by_turn.values()}) == 1 and turns > 2:
            text = f"{by_turn[1]}, in each turn"
        else:
            text = cells(by_turn, self.numbers_of_turns(turns))
        if len(text) > LONG and self.index is not None and self.index < turns:
            turn = self.index + 1
            return f"turn {turn}: {by_turn.get(turn, '-')}"
        if not isinstance(self.node(number), LOOPS) or turns <= FEW_TURNS:
            return text
        watched = "" if self.call.is_whole else ": not watched further"
        return f"{text}  ({self.begun_turns(number)} turns{watched})"

    def calls_in_words(self, number: int, traces: list[Trace]) -> list[str]:
        """Return what the called functions got and gave, in the turns that are shown."""
        by_turn = {}
        for trace in traces:
            texts = [self.call_in_words(number, trace, called) for called in trace.calls]
            turn = trace.turn
            if trace.is_condition_of_loop:
                turn += 1  # it comes before its turn
            by_turn[turn] = [*filter(None, texts)]
        with_calls = [turn for turn, texts in by_turn.items() if texts]
        if self.begun_turns(number) <= 1 or not with_calls:
            return [text for texts in by_turn.values() for text in texts]
        first = by_turn[with_calls[0]]
        if len(with_calls) > 1 and all(by_turn[turn] == first for turn in with_calls):
            return [f"{text}, in each turn" for text in first]
        lines = []
        for turn in self.turns_with_calls(with_calls, number):
            lines += [f"turn {turn}: {text}" for text in by_turn[turn]]
        return lines

    def call_in_words(self, number: int, trace: Trace, called: Called) -> str:
        """Return what a called function got and gave, or "" if its row says it."""
        parts = []
        if called.got:
            parts.append(f"got {called.got}")
        if not self.is_value_of_row(number, trace, called):
            parts.append(called.gave)
        return f"{called.name} {'; it '.join(parts)}" if parts else ""

    def turns_with_calls(self, turns: list[int], number: int) -> list[int]:
        """Return the turns of a statement whose calls are shown, of those that have some."""
        in_question = 0 if self.index is None else self.index + 1
        if len(self.watch.statements[number].loops) == 1 and in_question in turns:
            return [in_question]
        if len(turns) > MOST_CALLS:
            return [*turns[: MOST_CALLS - 1], turns[-1]]
        return turns

    def is_value_of_row(self, number: int, trace: Trace, called: Called) -> bool:
        """Return whether the result of a call stands in its row already."""
        node = self.node(number)
        is_whole = isinstance(getattr(node, "value", None), ast.Call)
        if not is_whole or isinstance(node, ast.AugAssign):
            return False
        return called.says_result and len(trace.calls) == 1 and bool(trace.values)


def rows_of(
    watch: Watch,
    calls: list[WatchedCall],
    marks: dict[int, str] | None = None,
    index: int | None = None,
) -> list[Row]:
    """Return the rows of these watched calls, with a title above those of each but the first.

    marks has what is said of a statement with a wrong value. index is that of the turn in question,
    from 0, or None.
    """
    stops = stops_in(watch)
    rows: list[Row] = []
    for call in calls:
        if rows:
            name = watch.name_of(call)
            if call.file != calls[0].file:
                name = f"{name} in {os.path.basename(call.file)}"
            same = watch.calls_of(call)
            which = f" (call {1 + same.index(call)} of {len(same)})" if len(same) > 1 else ""
            title = f"{' ' * INDENT}Your function {name}, called there{which}:"
            rows.append(Row(Kind.TITLE, call.definition, [title]))
        rows += Table(watch, call, stops.get(call), marks, index).rows()
    return rows
