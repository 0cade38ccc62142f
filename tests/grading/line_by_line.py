"""A wrong call, line by line: the tables of the student's functions, and facts about the call."""

import ast
from collections.abc import Sequence
from functools import cached_property
from math import isclose
from numbers import Real
from typing import Any, NamedTuple

from grading.expressions import keys_in_head, names_in_head, targets_of
from grading.handout import FUNCTIONS
from grading.layout import INDENT, TraceRow
from grading.messages import text_of
from grading.question import lines_in, Origin, Question
from grading.ranks import IN_QUESTION
from grading.stops import stops_in
from grading.subject import Subject
from grading.trace_table import Table
from grading.traces import Statement, WatchedCall
from grading.watch import Watch

MOST_FUNCTIONS = 3  # that have a table


class Explained(NamedTuple):
    """What was seen of a wrong call."""

    line: int  # of the file: where to look; 0 if it is not known
    rows: list[TraceRow]
    facts: list[str]


class WrongCall:
    """A call of a student's function that gave something wrong, and was watched."""

    def __init__(
        self,
        function: str,
        subject: Subject,
        watch: Watch,
        right: Sequence[tuple[str, Any]],
    ):
        """subject is what the sentence about the mistake names.

        right are pairs of a part of the handout's formula, and its right value in this call.
        """
        self.function = function
        self.watch = watch
        self.index = subject.list_index
        self.right = right
        self.calls = [*watch.calls.values()]
        self.main = next(call for call in self.calls if self.name_of(call) == function)
        self.stops = stops_in(watch)
        self.question = Question(function, subject, watch, self.main)

    def name_of(self, call: WatchedCall) -> str:
        return self.watch.statements[call.definition].node.name

    @cached_property
    def origin(self) -> Origin:
        """Where the value in question comes from."""
        return self.question.origin()

    def explained(self) -> Explained:
        """Return what was seen."""
        rows = []
        calls: list[WatchedCall] = []
        call: WatchedCall | None = self.main
        while call and call not in calls and len(calls) < MOST_FUNCTIONS:
            needed = self.needed(call, self.starts_in(call))
            table = self.table(call, needed)
            if calls:
                rank = min((row.rank for row in table), default=IN_QUESTION)
                title = f"{' ' * INDENT}Your function {self.name_of(call)}, called there:"
                rows.append(TraceRow(rank, [title], is_title=True))
            rows += table
            calls.append(call)
            helper = self.helper(call, needed)
            if call is self.main and not helper:
                helper = self.other_helper()
            call = helper
        return Explained(self.line(), rows, self.facts(calls))

    def starts_in(self, call: WatchedCall) -> list[int]:
        """Return the lines that matter, from which needed finds the lines that lead to them."""
        stops = [stop.line for stop in self.stops.values()]
        starts = [*self.origin.lines, *self.marks, *stops]
        if call is not self.main:
            return [*starts, *self.ends(call)]
        return starts if self.needed(call, starts) else self.ends(call)

    def line(self) -> int:
        """Return the line where to look, 0 if it is not known."""
        if self.stops:
            return [*self.stops.values()][-1].line
        lines = [*self.marks] or self.origin.lines or self.ends(self.main)
        return lines[-1] if lines else 0

    def facts(self, calls: list[WatchedCall]) -> list[str]:
        """Return sentences about what was seen in these calls."""
        facts = [*self.origin.facts]
        if self.watch.error:
            return facts
        facts += [*self.early_returns(calls), *self.nothing_returned(), *self.missing_calls()]
        if self.right:
            parts = [f"{name} = {text_of(value)}" for name, value in self.right]
            facts.append(f"Right here: {', '.join(parts)}.")
        return facts

    def table(self, call: WatchedCall, needed: dict[int, int]) -> list[TraceRow]:
        return Table(self.watch, call, self.stops.get(call), needed, self.marks, self.index).rows()

    def ends(self, call: WatchedCall) -> list[int]:
        """Return the lines with a return at which a call has come to its end."""
        nodes = [self.watch.statements[number].node for number in call.traces]
        return [node.lineno for node in nodes if isinstance(node, ast.Return)]

    def statements_of(self, call: WatchedCall) -> list[Statement]:
        """Return the statements in the function of a call."""
        found = []
        for number, statement in enumerate(self.watch.statements):
            if statement.owner == call.definition != number:
                found.append(statement)
        return found

    def needed(self, call: WatchedCall, starts: list[int]) -> dict[int, int]:
        """Return these lines of a call, and all lines that set what they use.

        The loops and conditions around them are needed, too. Each line has the number of steps that
        lead to it.
        """
        nodes = [statement.node for statement in self.statements_of(call)]
        found: dict[int, int] = {}
        left = [(line, 0) for line in starts]
        while left:
            line, depth = left.pop(0)
            if line in found:
                continue
            for node in nodes:
                if node.lineno == line:
                    found[line] = depth
                    lines = lines_in(self.question.stores_of(names_in_head(node), call))
                    lines += [other.lineno for other in nodes if sets_what_is_used(other, node)]
                    left += [(other, depth + 1) for other in lines]
                elif hasattr(node, "body") and node.lineno < line <= node.end_lineno:
                    left.append((node.lineno, depth + 1))
        return found

    def helper(self, call: WatchedCall, needed: dict[int, int]) -> WatchedCall | None:
        """Return the call of a helper that stopped in this call, or that a needed line made."""
        stopped = [*self.stops]
        if call in stopped and call is not stopped[-1]:
            return stopped[stopped.index(call) + 1]
        by_line = {}
        for number, traces in call.traces.items():
            by_line[self.watch.statements[number].node.lineno] = traces
        for line in sorted(needed, key=lambda line: (needed[line], -line)):
            traces_of_line = by_line.get(line)
            if traces_of_line:
                called = self.in_question(traces_of_line).calls
                helpers = [call.watched_call for call in called if call.watched_call]
                if helpers:
                    return helpers[-1]
        return None

    def in_question(self, elements: list) -> Any:
        """Return the element for the pendulum in question, else the last one."""
        if self.index is not None and self.index < len(elements):
            return elements[self.index]
        return elements[-1]

    def other_helper(self) -> WatchedCall | None:
        """Return the call of another function of the student's for the pendulum in question.

        Without one, return the last call.
        """
        others = []
        for call in self.calls:
            name = self.name_of(call)
            if name != self.function and "__" not in name:
                others.append(call)
        return self.in_question(others) if others and not self.stops else None

    def missing_calls(self) -> list[str]:
        """Return a sentence for each function that the handout tells to use, and no line names."""
        names: set[str] = set()
        for call in self.calls:
            for node in ast.walk(self.watch.statements[call.definition].node):
                names.update(getattr(node, field, "") for field in ("id", "attr", "name"))
        missing = [name for name in FUNCTIONS[self.function].must_name if name not in names]
        return [f"No line of your function calls {name}." for name in missing]

    def early_returns(self, calls: list[WatchedCall]) -> list[str]:
        """Return sentences about the returns that have ended a loop in these calls."""
        found = []
        for call in calls:
            for number, traces in call.traces.items():
                statement = self.watch.statements[number]
                if isinstance(statement.node, ast.Return) and statement.loops:
                    line = statement.node.lineno
                    loop = self.watch.statements[statement.loops[-1]].node.lineno
                    found.append(
                        f"Line {line} returns in turn {traces[-1].turn} of the loop in line "
                        f"{loop}, and so ends it."
                    )
        return found

    def nothing_returned(self) -> list[str]:
        """Return a sentence about a function that must return something, and has not."""
        if self.main.has_result or not FUNCTIONS[self.function].returns:
            return []
        nodes = [statement.node for statement in self.statements_of(self.main)]
        if any(isinstance(node, ast.Return) and node.value for node in nodes):
            return ["No return with a value has run."]
        return ["Your function has no return with a value."]

    @cached_property
    def marks(self) -> dict[int, str]:
        """The first line that gives a returned name another value than the formula.

        It stands with what is right there. It is certain only if the returned name has this value,
        and says which result it is: omega, or theta.
        """
        node = self.question.returned()
        if not node or not isinstance(node.value, ast.Tuple):
            return {}
        names = FUNCTIONS[self.function].returns.split(", ")
        found = {}
        for part, name in zip(node.value.elts, names, strict=False):
            right = dict(self.right).get(name)
            returned = getattr(part, "id", "")
            stores = self.question.stores_of([returned], self.main)
            if right is None or not stores or not isinstance(stores[-1].value, Real):
                continue
            if name.partition("_")[0] not in returned:
                continue  # the results may be exchanged
            if not isclose(stores[-1].value, right, rel_tol=1e-6, abs_tol=1e-9):
                found[stores[-1].line] = f"{text_of(right)} is right here"
        return dict(sorted(found.items())[:1])


def sets_what_is_used(statement: ast.AST, node: ast.AST) -> bool:
    """Return whether a statement gives a value to a name, or to a key, that another one uses."""
    names = set()
    keys = set()
    for target in targets_of(statement):
        if isinstance(target, ast.Name):
            names.add(target.id)
        elif isinstance(target, ast.Subscript) and isinstance(target.slice, ast.Constant):
            keys.add(target.slice.value)
    return bool(names & names_in_head(node) or keys & keys_in_head(node))
