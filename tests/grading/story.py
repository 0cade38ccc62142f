"""The story of a wrong call: what was seen of it, as parts of the screen."""

import ast
import itertools
from typing import Any

from grading.grader import WrongError
from grading.handout import FUNCTIONS
from grading.raised import below_project
from grading.room import in_order_of_ranks, LABEL, Part, Rank, YOUR_CODE
from line_by_line.expressions import names_in_head, targets_of
from line_by_line.layout import Kind, Row
from line_by_line.stops import stops_in
from line_by_line.table import rows_of
from line_by_line.traces import Store, WatchedCall
from line_by_line.watch import Watch
from line_by_line.words import in_words

MOST_FUNCTIONS = 3  # that have a table
MOST_ROWS = 16  # of the tables
MOST_REMARKS = 2
MOST_STEPS = 3  # in which a value was set that are told
RANKS = {
    Kind.STOPPED: Rank.ALWAYS,
    Kind.MARKED: Rank.ALWAYS,
    Kind.CALLED: Rank.CALLED,
    Kind.GAVE: Rank.GAVE,
    Kind.NO_END: Rank.NO_END,
    Kind.IDLE: Rank.IDLE,
}


class WrongCall:
    """A call of a student's function that gave something wrong, and was watched."""

    def __init__(self, function: str, error: WrongError, watch: Watch, lasting: dict[str, str]):
        """lasting says how the call has changed values that live on, by their names."""
        self.function = FUNCTIONS[function]
        self.error = error
        self.subject = error.subject
        self.watch = watch
        self.lasting = lasting
        self.calls = [*watch.calls.values()]
        self.main = next(call for call in self.calls if watch.name_of(call) == function)
        self.stops = stops_in(watch)
        self.stores = self.stores_in_question()
        # The numbers of the statements that have set it, are marked or have stopped
        self.in_question = {store.number for store in self.stores} | {*error.marks}
        self.in_question |= {stop.number for stop in self.stops.values()}
        self.leading = self.leading_statements()

    @property
    def place(self) -> str:
        """The line that has stopped, is marked, or has set the value alone; "" if there is none."""
        if self.stops:
            call, stop = [*self.stops.items()][-1]
            return f"{below_project(call.file)}, line {stop.line}"
        lines = {self.line_of(number) for number in self.error.marks or self.in_question}
        if len(lines) != 1:
            return ""
        number = min(self.error.marks or self.in_question)
        owner = self.watch.statements[number].owner
        file = next(call.file for call in self.calls if call.definition == owner)
        return f"{below_project(file)}, line {lines.pop()}"

    def line_of(self, number: int) -> int:
        """Return the line of a statement."""
        return self.watch.statements[number].node.lineno

    # --- the value in question ---

    def stores_in_question(self) -> list[Store]:
        """Return what has set the value that the sentence is about."""
        pend = self.pendulum()
        index = self.subject.list_index
        if pend is None and index is not None:
            stores = self.watch.stores
            whole = self.main.result
            return [store for store in stores if store.holder is whole and store.key == index]
        if pend is None:
            return self.stores_of_result()
        key = self.subject.key if self.subject.key in pend else "objects"
        if not self.subject.key:
            return [store for store in self.watch.stores if store.holder is pend]
        stores = [store for store in self.watch.stores if store.holder is pend and store.key == key]
        return stores if stores and stores[-1].value is pend.get(key) else []

    def pendulum(self) -> dict | None:
        """Return the pendulum in question, if there is one."""
        names = self.function.parameters.split(", ")
        values = dict(zip(names, self.watch.arguments, strict=False))
        values[self.function.returns] = self.main.result
        index = self.subject.list_index
        if index is None:
            found = values.get(self.subject.owner)
        else:
            pend_list = values.get("pend_list")
            is_there = isinstance(pend_list, (list, tuple)) and index < len(pend_list)
            found = pend_list[index] if pend_list and is_there else None
        return found if isinstance(found, dict) else None

    def stores_of_result(self) -> list[Store]:
        """Return what has set the wrong part of the result, else what gave the result."""
        node = self.watch.statements[self.main.returned].node
        is_about_list = self.function.returns == "pend_list" and not self.subject.is_result
        if not self.function.returns or is_about_list or not isinstance(node, ast.Return):
            return []
        part: Any = node.value
        names = self.function.returns.split(", ")
        is_whole = isinstance(part, ast.Tuple) and len(part.elts) == len(names)
        for name in (self.subject.key, self.subject.owner):
            if is_whole and name in names:
                part = part.elts[names.index(name)]
        stores = [store for store in self.watch.stores if store.holder is self.main]
        if isinstance(part, ast.Name):
            return [store for store in stores if store.key == part.id]
        return [store for store in stores if store.number == self.main.returned]

    # --- the tables ---

    def parts_of_code(self) -> list[Part]:
        """Return the rows of the tables, below their title."""
        rows = rows_of(self.watch, self.shown_calls(), self.error.marks, self.subject.list_index)
        if not rows:
            return []
        parts: list[Part] = []
        for row in reversed(rows):
            if row.kind == Kind.TITLE:
                own = itertools.takewhile(lambda part: part.is_row, parts)
                rank = min((part.rank for part in own), default=Rank.NEVER)
                parts.insert(0, Part(rank, row.texts, is_title=True))
            else:
                parts.insert(0, Part(self.rank_of(row), row.texts, is_row=True))
        in_order = [i for i in in_order_of_ranks(parts) if parts[i].is_row]
        for i in in_order[MOST_ROWS:]:
            parts[i] = parts[i]._replace(rank=Rank.NEVER)
        return [Part(Rank.ALWAYS, [f"{YOUR_CODE:<{LABEL}}line by line"]), *parts]

    def rank_of(self, row: Row) -> int:
        """Return the rank of a row."""
        if row.number in self.in_question:
            return Rank.ALWAYS
        rank = RANKS[row.kind]
        return min(rank, Rank.LEADING) if row.number in self.leading else rank

    def shown_calls(self) -> list[WatchedCall]:
        """Return the calls that have a table: of the function, and of the most important others."""
        if not self.stops:
            return [self.main, *self.helpers()]
        inner = [call for call in self.stops if call is not self.main]
        return [self.main, *inner[-MOST_FUNCTIONS + 1 :]]

    def helpers(self) -> list[WatchedCall]:
        """Return a call of each of the student's other functions that matter most."""
        by_function: dict[int, list[WatchedCall]] = {}
        for call in self.calls:
            if call.definition != self.main.definition and "__" not in self.watch.name_of(call):
                by_function.setdefault(call.definition, []).append(call)
        index = self.subject.list_index
        found: list[tuple[bool, int, WatchedCall]] = []
        for calls in by_function.values():
            whole = [call for call in calls if call.is_whole] or calls
            call = whole[-1] if index is None or index >= len(whole) else whole[index]
            found.append((not self.in_question & {*call.traces}, len(found), call))
        return [call for *_, call in sorted(found, key=lambda each: each[:2])][: MOST_FUNCTIONS - 1]

    def leading_statements(self) -> set[int]:
        """Return the numbers of the statements from which values go into those in question."""
        found = {*self.in_question}
        names = {store.key for store in self.stores}
        called: set[str] = set()
        count = -1
        while count != len(found):
            count = len(found)
            for number, statement in enumerate(self.watch.statements):
                if isinstance(statement.node, (ast.FunctionDef, ast.ClassDef)):
                    continue
                sets_name = any(base_of(target) in names for target in targets_of(statement.node))
                is_return = isinstance(statement.node, ast.Return)
                gives = is_return and self.watch.statements[statement.owner].node.name in called
                if sets_name or gives or any(self.is_in(other, number) for other in found):
                    found.add(number)
                    names |= names_in_head(statement.node)
                    called |= self.called_by(number)
        return found

    def called_by(self, number: int) -> set[str]:
        """Return the names of the functions that a statement has called."""
        traces = [trace for call in self.calls for trace in call.traces.get(number, [])]
        return {called.name for trace in traces for called in trace.calls}

    def is_in(self, number: int, outer: int) -> bool:
        """Return whether a statement is another one, or is in its blocks."""
        inner, around = self.watch.statements[number], self.watch.statements[outer]
        if not hasattr(around.node, "body") or inner.owner != around.owner:
            return number == outer
        return around.node.lineno <= inner.node.lineno <= around.node.end_lineno

    # --- sentences ---

    def facts(self) -> list[str]:
        """Return sentences about what was seen."""
        facts = [
            *self.about_state(),
            *(f"Your function has changed {name}." for name in self.error.changed),
        ]
        remarks = [text for text, number in self.watch.remarks.items() if number in self.leading]
        facts += remarks[:MOST_REMARKS]
        if self.watch.error:
            return facts
        return [*facts, *self.about_value(), *self.about_returns(), *self.missing_calls()]

    def about_state(self) -> list[str]:
        """Return sentences about values that live on between calls, and have changed."""
        return [
            f"{name} lives on from call to call: {text}." for name, text in self.lasting.items()
        ]

    def about_value(self) -> list[str]:
        """Return sentences about how the value in question was set, or that it is as before."""
        key = self.subject.key
        pend = self.pendulum()
        if pend is None or key not in pend:
            return []
        if self.stores:
            return self.about_stores()
        known = self.watch.known.get(id(pend))
        if known and key in known.copy and known.copy[key] is pend[key]:
            before = f"as {known.giver} gave it" if known.giver else "as before the call"
            return [f"{self.subject} is still {in_words(pend[key])}, {before}."]
        return []

    def about_stores(self) -> list[str]:
        """Return a sentence about the lines that have set the value in question more than once."""
        last = self.stores[-MOST_STEPS:]
        lines = [self.line_of(store.number) for store in last]
        if len({*lines}) > 1:
            steps = [f"to {store.text} in line {self.line_of(store.number)}" for store in last]
            return [f"{self.subject} was set {', then '.join(steps)}."]
        if len(last) > 1:
            steps = [f"to {store.text}" for store in last]
            return [f"{self.subject} was set {', then '.join(steps)}, in line {lines[0]}."]
        return []

    def about_returns(self) -> list[str]:
        """Return sentences about a return that has ended a loop, and about one that is missing."""
        found = []
        for call in self.shown_calls():
            statement = self.watch.statements[call.returned]
            if call.returned and statement.loops:
                loop = self.watch.statements[statement.loops[-1]].node.lineno
                turn = call.turns_now[statement.loops[-1]]
                found.append(
                    f"Line {statement.node.lineno} returns in turn {turn} of the loop in line "
                    f"{loop}, and so ends it."
                )
        if not self.main.returned and self.function.returns:
            found.append("No return with a value has run.")
        return found

    def missing_calls(self) -> list[str]:
        """Return a sentence for each function that the handout tells to use, and no line names."""
        names: set[str] = set()
        for call in self.calls:
            for node in ast.walk(self.watch.statements[call.definition].node):
                names.update(getattr(node, field, "") for field in ("id", "attr", "name"))
        missing = [name for name in self.function.must_name if name not in names]
        return [f"No line of your function calls {name}." for name in missing]


def base_of(target: ast.expr) -> str:
    """Return the name in front of the brackets and dots of a target."""
    node: Any = target
    while isinstance(node, (ast.Subscript, ast.Attribute)):
        node = node.value
    return getattr(node, "id", "")
