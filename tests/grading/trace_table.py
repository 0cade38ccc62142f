"""The trace table of a call that was watched: a row for each line, as teachers draw it.

layout.py lays the rows out.
"""

import ast
from typing import Any, NamedTuple

from grading.instrument import TRIES
from grading.layout import cell, cells, laid_out, once, Remark, together, TraceRow
from grading.ranks import CALLS, IDLE, IN_QUESTION, NO_END, rank_after, VALUES
from grading.source import Source, without_comment
from grading.stops import Stop
from grading.traces import Called, LOOPS, Trace, WatchedCall
from grading.values import in_words
from grading.watch import Watch

MOST_CALLS = 3  # of a line that are shown
FEW_TURNS = 4  # turns of a loop that are all shown
SHORT = 12  # characters of a value that is shown again if all turns give the same
LONG = 140  # characters of the values of all turns; if they are longer, only one turn is shown
# By the handout
PROVIDED = "df = pd.read_csv(relative_filepath)", 'bad_rep = df.to_dict(orient="index")'


class Turns(NamedTuple):
    """How many turns a statement in a loop has made; 0 without a loop."""

    finished: int  # turns of the innermost loop in which it came to its end
    columns: int  # the same, but the condition of a while comes once more at each end of the loop


class Table:
    """The trace table of one call of a function that the student wrote."""

    def __init__(
        self,
        watch: Watch,
        call: WatchedCall,
        stop: Stop | None,
        needed: dict[int, int],
        marks: dict[int, str],
        index: int | None,
    ):
        """needed has the lines that matter, with the numbers of steps that lead to them.

        marks has what is right, by the line that departs from it. index is that of the pendulum in
        question, or None.
        """
        self.watch = watch
        self.call = call
        self.stop = stop
        self.needed = needed
        self.marks = marks
        self.index = index
        self.source = Source(call.frame.f_code.co_filename)
        # The numbers of the statements that begin in a line
        self.by_line: dict[int, list[int]] = {}
        for number, statement in enumerate(watch.statements):
            is_own = statement.owner == call.definition != number
            if is_own and (statement.is_shown or self.is_stopped_in(statement.node)):
                self.by_line.setdefault(statement.node.lineno, []).append(number)
        self.first_column = min(map(self.source.indentation, self.by_line), default=0)
        self.stop_start = self.start_of(stop.line) if stop else 0

    def is_stopped_in(self, node: Any) -> bool:
        """Return whether the call was stopped in a statement."""
        return self.stop is not None and node.lineno <= self.stop.line <= node.end_lineno

    def node(self, number: int) -> Any:
        return self.watch.statements[number].node

    def rows(self) -> list[TraceRow]:
        """Return the rows in the order of the code.

        A row with else has the rank of the one below it.
        """
        lines = sorted({*self.by_line, *self.lines_with_else()})
        width = len(str(max(lines, default=0)))
        rows: list[TraceRow] = []
        for line in reversed(lines):
            remark = None
            if line in self.by_line:
                remark = self.remark_on_line(line)
            elif rows:
                remark = Remark(rows[0].rank)
            if remark:
                texts = laid_out(f"{line:>{width}}", self.code_of(line), remark)
                rows.insert(0, TraceRow(remark.rank, texts))
        return rows

    def lines_with_else(self) -> set[int]:
        """Return the lines with else and finally."""
        found: set[int] = set()
        for numbers in self.by_line.values():
            for number in numbers:
                found.update(self.source.lines_with_else(self.node(number)))
        return found

    def code_of(self, line: int) -> str:
        """Return the code of the statement at a line, or the line with else."""
        if line in self.by_line:
            code = self.source.head_of(self.node(self.by_line[line][0]))
        else:
            code = without_comment(self.source.line(line))
        return code[self.first_column :]

    # --- what is said of a line ---

    def remark_on_line(self, line: int) -> Remark | None:
        """Return what is said of a line with statements.

        Return None if it comes after the line that has stopped.
        """
        numbers = []
        for number in self.by_line[line]:
            if not isinstance(self.node(number), TRIES):
                numbers.append(number)
        if not numbers:
            return Remark(NO_END)
        remark = self.remark_on_statements(line, numbers)
        if remark is None:
            return None
        if line in self.marks:
            remark = remark._replace(after=f"{remark.after}  <- {self.marks[line]}")
        if self.source.line(line).strip().rstrip(";") in PROVIDED and not self.stop:
            return remark._replace(rank=IDLE)
        if line in self.needed:
            return remark._replace(rank=min(remark.rank, rank_after(self.needed[line])))
        return remark

    def remark_on_statements(self, line: int, numbers: list[int]) -> Remark | None:
        """Return what is said of these statements in a line."""
        found = []
        for number in numbers:
            remark = self.remark_on_statement(number)
            if remark:
                found.append(remark)
        if self.stop and line == self.stop_start:
            return self.remark_on_stop(self.stop, numbers, found)
        if found:
            return together(found)
        if self.stop and self.stop.is_error and line > self.stop.line and self.call.is_whole:
            return None
        return Remark(NO_END, self.why_it_has_no_end(line, numbers))

    def remark_on_statement(self, number: int) -> Remark | None:
        """Return what is said of a statement, or None if it did not come to its end."""
        traces = self.call.traces.get(number)
        is_loop = isinstance(self.node(number), LOOPS)
        if not traces:
            is_empty = is_loop and number in self.call.whole_values and not self.stop
            return Remark(VALUES, "no turn") if is_empty else None
        turns = self.turns_of(number, traces)
        rank = IDLE
        if any(trace.calls for trace in traces):
            rank = CALLS
        elif any(trace.values for trace in traces):
            rank = VALUES
        after = self.in_turns(traces, turns, is_loop)
        return Remark(rank, after, tuple(self.calls_in_words(number, traces, turns)))

    def remark_on_stop(self, stop: Stop, numbers: list[int], found: list[Remark]) -> Remark:
        """Return what is said of the line that has stopped.

        These are its earlier turns, and the values at which it stopped.
        """
        remark = together([Remark(IN_QUESTION), *found])
        below = []
        for number in numbers:
            calls = self.call.called.get(number, [])
            if stop.is_error and not calls:  # what a call got is shown anyway
                below += self.watch.values_in(self.call, number).stopped_at(self.node(number))
                if not below and number in self.call.whole_values:  # its value was not taken apart
                    below.append(f"the value is {in_words(self.call.whole_values[number])}")
            turn = self.begun_turns(number)
            label = f"turn {turn}: " if turn > 1 else ""
            for called in calls:
                if called.got:
                    below.append(f"{label}{called.name} got {called.got}")
        after = f"{remark.after}  <- {stop.how}".strip()
        return Remark(IN_QUESTION, after, (*below, *remark.below[-1:]))

    def why_it_has_no_end(self, line: int, numbers: list[int]) -> str:
        """Return what is said of a line that did not come to its end in any turn."""
        for stopped, kind in self.call.hidden.items():
            if line == self.start_of(stopped):
                return f"stopped: {kind}"
        if not self.call.is_whole:
            return "(not watched further)"
        if self.call.begun.intersection(numbers):
            return "(did not come to its end)"
        return "(never ran)"

    def start_of(self, line: int) -> int:
        """Return the first line of the innermost statement in which a line is, 0 without one."""
        found = 0
        for start, numbers in self.by_line.items():
            last = max(self.node(number).end_lineno for number in numbers)
            if start <= line <= last:
                found = max(found, start)
        return found

    # --- the turns of a loop ---

    def begun_turns(self, number: int) -> int:
        """Return how many turns the innermost loop has begun that is or is around a statement."""
        statement = self.watch.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        return self.call.turns[loops[-1]] if loops else 0

    def turns_of(self, number: int, traces: list[Trace]) -> Turns:
        """Return the turns of a statement that has these traces."""
        finished = self.begun_turns(number)
        if not self.call.is_whole:
            finished = max(0, finished - 1)  # the last turn was not watched to its end
        node = self.node(number)
        has_stopped = self.stop is not None and node.lineno == self.stop_start
        if has_stopped and finished > 1 and not isinstance(node, LOOPS):
            finished -= 1  # the last turn has stopped here
        return Turns(finished, len(traces) if traces[0].is_condition_of_loop else finished)

    def numbers_of_turns(self, columns: int) -> list[int]:
        """Return which turns are shown: the first two, the one in question, and the last one."""
        if columns <= FEW_TURNS:
            return [*range(1, columns + 1)]
        turns = {1, 2, columns}
        if self.index is not None and self.index < columns:
            turns.add(self.index + 1)
        return sorted(turns)

    def in_turns(self, traces: list[Trace], turns: Turns, is_loop: bool) -> str:
        """Return what a statement gave, in each turn of its loop that is shown."""
        if not turns.finished:
            return once(traces[-1].values)
        if traces[0].is_condition_of_loop:
            by_turn = {i: cell(trace.values) for i, trace in enumerate(traces, start=1)}
        else:
            by_turn = {trace.turn: cell(trace.values) for trace in traces}
        is_in_each = len(by_turn) == turns.columns
        if is_in_each and not any(trace.values for trace in traces):
            return ""
        is_same = is_in_each and len({*by_turn.values()}) == 1 and turns.columns > 2
        if is_same and (turns.columns > FEW_TURNS or len(by_turn[1]) > SHORT):
            text = f"{by_turn[1]}, in each turn"
        else:
            text = cells(by_turn, self.numbers_of_turns(turns.columns))
        if len(text) > LONG and self.index is not None and self.index < turns.columns:
            turn = self.index + 1
            return f"turn {turn}: {by_turn.get(turn, '-')}"
        if not is_loop or turns.columns <= FEW_TURNS:
            return text
        return f"{text}  ({self.number_of_turns(traces, turns)})"

    def number_of_turns(self, traces: list[Trace], turns: Turns) -> str:
        """Return how many turns a loop has made, with the one that a limit has stopped."""
        number = turns.finished
        is_over_limit = self.stop is not None and not self.stop.is_error
        if is_over_limit and traces[0].is_condition_of_loop:
            number = turns.columns  # the condition has come in this turn, too
        if not self.call.is_whole:
            return f"more than {number} turns: not watched further"
        return f"{number} turns"

    def calls_in_words(self, number: int, traces: list[Trace], turns: Turns) -> list[str]:
        """Return what the called functions got and gave, in the turns that are shown."""
        lines = []
        for trace in self.traces_with_calls(number, traces):
            turn = trace.turn
            if trace.is_condition_of_loop:
                turn += 1  # it comes before its turn
            label = f"turn {turn}: " if turns.finished > 1 else ""
            for called in trace.calls:
                parts = []
                if called.got:
                    parts.append(f"got {called.got}")
                if not self.is_value_of_row(number, trace, called):
                    parts.append(called.gave)
                if parts:
                    lines.append(f"{label}{called.name} {'; it '.join(parts)}")
        return lines

    def traces_with_calls(self, number: int, traces: list[Trace]) -> list[Trace]:
        """Return the traces of a statement whose calls the table shows."""
        calling = [trace for trace in traces if trace.calls]
        if self.index is not None and len(self.watch.statements[number].loops) == 1:
            in_question = [trace for trace in calling if trace.turn == self.index + 1]
            if in_question:
                return in_question
        if len(calling) > MOST_CALLS:
            return [*calling[: MOST_CALLS - 1], calling[-1]]
        return calling

    def is_value_of_row(self, number: int, trace: Trace, called: Called) -> bool:
        """Return whether the result of a call stands in its row already."""
        node = self.node(number)
        is_whole = isinstance(getattr(node, "value", None), ast.Call)
        if not is_whole or isinstance(node, ast.AugAssign):
            return False
        return called.says_result and len(trace.calls) == 1 and bool(trace.values)
