"""The value in question: where the value that a sentence of the grader names comes from.

The call was watched.
"""

import ast
from collections.abc import Container, Iterable
from typing import Any, NamedTuple

from grading.expressions import AS_THEY_ARE, names_in_head, operations_in, targets_of
from grading.handout import FUNCTIONS
from grading.subject import Subject
from grading.traces import Known, LOOPS, Store, WatchedCall
from grading.values import in_words
from grading.watch import Watch

UNSEEN = {"update", "setdefault", "pop", "clear", "map", "setattr", "exec", "vars", "__setitem__"}
MAKE_PENDULUM = "axle_pos", "r_param", "theta", "color", "texture"  # its parameters


class Origin(NamedTuple):
    """Where the value in question comes from."""

    lines: list[int] = []  # that have set it; the last one is where to look
    facts: list[str] = []  # sentences about it


class Question:
    """Finds the lines that have set the value in question."""

    def __init__(self, function: str, subject: Subject, watch: Watch, main: WatchedCall):
        """main is the call of the function.

        subject is what the sentence about the mistake names.
        """
        self.function = FUNCTIONS[function]
        self.subject = subject
        self.watch = watch
        self.main = main
        names = self.function.parameters.split(", ")
        self.values_by_name = dict(zip(names, watch.arguments, strict=False))
        if main.has_result:
            self.values_by_name[self.function.returns] = main.result

    def origin(self) -> Origin:
        """Return the lines that have set the value, else those that give the result."""
        origin = self.of_subject()
        if origin.lines:
            return origin
        result = self.of_result()
        return Origin(result.lines, [*origin.facts, *result.facts])

    def of_subject(self) -> Origin:
        """Return the origin by the kind of the subject; of a result, it is empty."""
        subject = self.subject
        if subject.has_wrong_keys:
            is_whole_pendulum = subject.is_of_pendulum and not subject.value
            return Origin(self.of_keys()) if is_whole_pendulum else Origin()
        if subject.owner == "each pendulum":
            return Origin(self.lines_with_key(subject.value))
        if subject.is_of_pendulum:
            return self.of_value() if subject.value else Origin()
        return Origin(self.of_object()) if subject.owner else Origin()

    # --- by the subject ---

    def of_value(self) -> Origin:
        """Return the origin of a value of a pendulum: "theta of pend_list[0]"."""
        pend = self.pendulum()
        key = self.subject.value
        name = self.subject.pend
        if pend is None:
            return Origin()
        setting = self.lines_with_key(key, name)
        lines = [*self.lines_of_list(), *setting]
        stores = [store for store in self.watch.stores if store.holder is pend and store.key == key]
        if stores and stores[-1].value is pend.get(key):
            steps = [f"to {store.text} in line {store.line}" for store in stores[-3:]]
            fact = f"{key} of {name} was set {', then '.join(steps)}."
            return Origin([*lines, *lines_in(stores), first_with_last_value(stores)], [fact])
        facts = []
        known = self.watch.known.get(id(pend))
        if known and key in known.copy and known.copy[key] is pend.get(key):
            facts.append(self.fact_about_same(f"{key} of {name}", pend[key], known))
        if setting:
            lines += self.conditions_around(setting[-1])
        else:
            lines += self.lines_without_effect() or self.lines_of_loops()
        return Origin(lines, facts)

    def of_keys(self) -> list[int]:
        """Return the lines for a pendulum with other keys: those that store something in it."""
        pend = self.pendulum()
        return lines_in(store for store in self.watch.stores if store.holder is pend)

    def of_object(self) -> list[int]:
        """Return the lines for the place or the looks of an object.

        They set what make_pendulum gets for it.
        """
        parameter = self.subject.value if self.subject.value in MAKE_PENDULUM else "theta"
        if self.subject.owner == "axle":
            parameter = "axle_pos"
        for call, number in self.statements_that_ran():
            node = self.node(number)
            for part in operations_in(node):
                if isinstance(part, ast.Call) and getattr(part.func, "id", "") == "make_pendulum":
                    given: dict = dict(zip(MAKE_PENDULUM, part.args, strict=False))
                    given |= {option.arg: option.value for option in part.keywords}
                    if parameter in given:
                        stores = self.stores_of(names_in_head(given[parameter]), call)
                        return lines_in(stores) or [node.lineno]
        return []

    def of_result(self) -> Origin:
        """Return the origin of a result: the lines that set its wrong part, and that give it."""
        node = self.returned()
        if not node or not node.value:
            return Origin(self.lines_with_calls())
        names = self.function.returns.split(", ")
        wrong = self.wrong_parts(names)
        part = node.value
        if wrong and isinstance(part, ast.Tuple) and len(part.elts) == len(names):
            part = part.elts[wrong[0]]
        stores = self.stores_of(names_in_head(part), self.main)
        lines = [*lines_in(stores), first_with_last_value(stores)] if stores else []
        if not isinstance(part, ast.Name) or self.subject.is_result:
            return Origin([*lines, node.lineno])
        facts = []
        if wrong and part.id in self.values_by_name and not self.is_set(part.id):
            name = names[wrong[0]]
            facts.append(f"{name} is your {part.id}, and no line of your function has set it.")
        return Origin(lines or [node.lineno], facts)

    # --- what they need ---

    def pendulum(self) -> dict | None:
        """Return the pendulum in question, if it is there."""
        found = self.values_by_name.get(self.subject.owner)
        index = self.subject.list_index
        if index is not None:
            if not isinstance(found, (list, tuple)) or index >= len(found):
                return None
            found = found[index]
        return found if isinstance(found, dict) else None

    def wrong_parts(self, names: list[str]) -> list[int]:
        """Return the indexes of the parts of the result that are in question."""
        return [i for i, name in enumerate(names) if self.subject.is_part(name)]

    def fact_about_same(self, name: str, value: Any, known: Known) -> str:
        """Return a sentence about a value of a pendulum that is the same as before."""
        before = f"as {known.giver} gave it" if known.giver else "as before the call"
        still = f"still {in_words(value)}, {before}"
        if self.can_set_unseen():
            return f"{name} is {still}."
        return f"No line of your function has set {name}: it is {still}."

    def can_set_unseen(self) -> bool:
        """Return whether a line can set a value in a way that is not watched.

        An example is p.update(e=0) in a comprehension.
        """
        for call in self.watch.calls.values():
            for node in ast.walk(self.node(call.definition)):
                is_union = isinstance(node, ast.AugAssign) and isinstance(node.op, ast.BitOr)
                names = {getattr(node, "id", ""), getattr(node, "attr", "")}
                if is_union or names & UNSEEN or isinstance(node, AS_THEY_ARE):
                    return True
        return False

    def conditions_around(self, line: int) -> list[int]:
        """Return the line of the innermost condition that was not true, and has a line in it."""
        found = []
        for call, number in self.statements_that_ran():
            node = self.node(number)
            is_condition = isinstance(node, (ast.If, ast.While))
            if not is_condition or not node.lineno < line <= node.end_lineno:
                continue
            if call.traces[number][-1].values[0].is_false:
                found.append(node.lineno)
        return found[-1:]

    def lines_without_effect(self) -> list[int]:
        """Return the lines with a value that no name got."""
        found = []
        for call, number in self.statements_that_ran():
            node = self.node(number)
            if any(value.is_lost for value in call.traces[number][-1].values):
                found.append(node.lineno)
        return found

    def lines_of_loops(self) -> list[int]:
        """Return the lines with loops: in one of them, the value could be set."""
        nodes = [self.node(number) for _, number in self.statements_that_ran()]
        return [node.lineno for node in nodes if isinstance(node, LOOPS)]

    def lines_of_list(self) -> list[int]:
        """Return the lines that have set the name that is returned."""
        node = self.returned()
        if node and isinstance(node.value, ast.Name):
            return lines_in(self.stores_of([node.value.id], self.main))
        return []

    def lines_with_key(self, key: Any, name: str = "") -> list[int]:
        """Return the lines that store something under a key, also if they never ran.

        If there are some for the pendulum with this name, return these only.
        """
        found = []
        with_name = []
        for statement in self.watch.statements:
            for target in targets_of(statement.node):
                if not isinstance(target, ast.Subscript):
                    continue
                if getattr(target.slice, "value", None) == key:
                    found.append(statement.node.lineno)
                    if ast.unparse(target.value) == name:
                        with_name.append(statement.node.lineno)
        return with_name or found

    def is_set(self, name: str) -> bool:
        """Return whether a line of the function can give a name another value."""
        for node in ast.walk(self.node(self.main.definition)):
            if getattr(node, "name", "") == name:
                return True
            if (
                isinstance(node, ast.Name)
                and node.id == name
                and not isinstance(node.ctx, ast.Load)
            ):
                return True
        return False

    def lines_with_calls(self) -> list[int]:
        """Return the first line of the function that has called a function of src/."""
        for number, traces in self.main.traces.items():
            if any(trace.calls for trace in traces):
                return [self.node(number).lineno]
        return []

    def node(self, number: int) -> Any:
        return self.watch.statements[number].node

    def statements_that_ran(self) -> Iterable[tuple[WatchedCall, int]]:
        """Yield each call that was watched, with the number of each of its statements that ran."""
        for call in self.watch.calls.values():
            for number in call.traces:
                yield call, number

    def returned(self) -> ast.Return | None:
        """Return the statement that gave the result of the function."""
        for number in self.main.traces:
            if isinstance(self.node(number), ast.Return):
                return self.node(number)
        return None

    def stores_of(self, names: Container[str], call: WatchedCall) -> list[Store]:
        """Return what was stored under these names of a call."""
        return [store for store in self.watch.stores if store.holder is call and store.key in names]


def first_with_last_value(stores: list[Store]) -> int:
    """Return the line that has given a place its last value.

    Lines that have given it again are left out.
    """
    last = stores[-1]
    for store in reversed(stores):
        if store.text != last.text or store.key != last.key:
            break
        last = store
    return last.line


def lines_in(stores: Iterable[Store]) -> list[int]:
    """Return the lines of stores, each once."""
    return [*dict.fromkeys(store.line for store in stores)]
