"""The value in question: where the value that a sentence of the grader names comes from, in a call
that was watched.
"""

import ast
import re
from collections.abc import Iterable
from typing import Any

from grading.expressions import AS_THEY_ARE, names_in_head, operations_in, targets_of
from grading.handout import FUNCTIONS
from grading.values import in_words
from grading.watch import LOOPS, Run, Store, Watch

# What a sentence of comparing.py is about: a value of a pendulum, the keys of one, or a part of its
# objects.
PEND = r"(?P<pend>(?P<name>pend\w*)(?:\[(?P<index>\d+)\])?)"
VALUE = re.compile(rf"(?P<key>\w+) of {PEND} ")
KEYS = re.compile(rf"{PEND} (?:misses|must not have) the key ")
IN_EACH = re.compile(r"the value of (?P<key>\w+) in each pendulum ")
OBJECT = re.compile(
    r"(?P<what>\w+).* of (?:the )?(?P<part>axle|bob|cord)(?:\[| of pend_list\[)\d+\]"
)
UNSEEN = {"update", "setdefault", "pop", "clear", "map", "setattr", "exec", "vars", "__setitem__"}
MAKE_PENDULUM = "axle_pos", "r_param", "theta", "color", "texture"  # its parameters


class Question:
    """Finds the lines that have set the value in question. facts are sentences about it."""

    def __init__(self, function, sentence, watch: Watch, main: Run, arguments):
        """main is the call of the function. sentence says what is wrong, arguments are those of the
        call.
        """
        self.function, self.sentence = FUNCTIONS[function], sentence
        self.watch, self.main = watch, main
        self.values = dict(zip(self.function.parameters.split(", "), arguments, strict=False))
        if main.has_result:
            self.values[self.function.returns] = main.result
        self.facts: list[str] = []
        self.lines: list[int] = self.found()  # the last one is where to look

    def found(self) -> list[int]:
        """Return the lines that have set the value, or without such a line, those that give the
        result.
        """
        for pattern, search in (
            (VALUE, self.of_value),
            (KEYS, self.of_keys),
            (OBJECT, self.of_object),
            (IN_EACH, lambda match: self.lines_with_key(match["key"])),
        ):
            match = pattern.match(self.sentence)
            if match:
                return search(match) or self.of_result()
        return self.of_result()

    def pendulum(self, match) -> dict | None:
        """Return the pendulum that a sentence names, if it is there."""
        found = self.values.get(match["name"])
        if match["index"]:
            index = int(match["index"])
            found = (
                found[index] if isinstance(found, (list, tuple)) and index < len(found) else None
            )
        return found if isinstance(found, dict) else None

    def of_value(self, match) -> list[int]:
        """Return the lines for a value of a pendulum: "theta of pend_list[0]"."""
        pend = self.pendulum(match)
        key, name = match["key"], match["pend"]
        if pend is None:
            return self.of_result()
        setting = self.lines_with_key(key, name)
        lines = [*self.lines_of_list(), *setting]
        stores = [store for store in self.watch.stores if store.place is pend and store.key == key]
        if stores and stores[-1].value is pend.get(key):
            steps = ", then ".join(f"to {store.text} in line {store.line}" for store in stores[-3:])
            self.facts.append(f"{key} of {name} was set {steps}.")
            return [*lines, *lines_in(stores), first_with_last_value(stores)]
        _, before, giver = self.watch.known.get(id(pend), (pend, {}, ""))
        if key in before and before[key] is pend.get(key):
            before = f"as {giver} gave it" if giver else "as before the call"
            words = f"still {in_words(pend[key])}, {before}"
            if self.can_set_unseen():
                self.facts.append(f"{key} of {name} is {words}.")
            else:
                self.facts.append(
                    f"No line of your function has set {key} of {name}: it is {words}."
                )
        if setting:
            return [*lines, *self.conditions_around(setting[-1])]
        return [*lines, *(self.lines_without_effect() or self.lines_of_loops())] or self.of_result()

    def can_set_unseen(self) -> bool:
        """Return whether a line can set a value in a way that is not watched, as p.update(e=0) in a
        comprehension.
        """
        nodes = [
            one for run in self.watch.runs.values() for one in ast.walk(self.node(run.definition))
        ]
        names = {getattr(one, kind, "") for one in nodes for kind in ("id", "attr")}
        has_union = any(
            isinstance(one, ast.AugAssign) and isinstance(one.op, ast.BitOr) for one in nodes
        )
        return (
            has_union or bool(names & UNSEEN) or any(isinstance(one, AS_THEY_ARE) for one in nodes)
        )

    def conditions_around(self, line) -> list[int]:
        """Return the line of the innermost condition that was not true, and has a line in it."""
        found = []
        for run, number in self.statements_that_ran():
            node = self.node(number)
            is_around = (
                isinstance(node, (ast.If, ast.While)) and node.lineno < line <= node.end_lineno
            )
            if is_around and run.seen[number][-1].words[0][1].endswith("False"):
                found.append(node.lineno)
        return found[-1:]

    def lines_without_effect(self) -> list[int]:
        """Return the lines with a value that no name got."""
        found = []
        for run, number in self.statements_that_ran():
            words = [text for _, text in run.seen[number][-1].words]
            if isinstance(self.node(number), ast.Expr) and any(
                text.startswith("gives") for text in words
            ):
                found.append(self.node(number).lineno)
        return found

    def lines_of_loops(self) -> list[int]:
        """Return the lines with loops: in one of them, the value could be set."""
        return [
            self.node(number).lineno
            for _, number in self.statements_that_ran()
            if isinstance(self.node(number), LOOPS)
        ]

    def lines_of_list(self) -> list[int]:
        """Return the lines that have set the name that is returned."""
        node = self.returned()
        if node and isinstance(node.value, ast.Name):
            return lines_in(self.stores_of([node.value.id], self.main))
        return []

    def lines_with_key(self, key, name="") -> list[int]:
        """Return the lines that store something under a key, also if they never ran.

        If there are some for the pendulum with this name, return these only.
        """
        found, own = [], []
        for statement in self.watch.statements:
            for target in targets_of(statement.node):
                if (
                    isinstance(target, ast.Subscript)
                    and getattr(target.slice, "value", None) == key
                ):
                    found.append(statement.node.lineno)
                    if ast.unparse(target.value) == name:
                        own.append(statement.node.lineno)
        return own or found

    def of_keys(self, match) -> list[int]:
        """Return the lines for a pendulum with other keys: those that store something in it."""
        pend = self.pendulum(match)
        return lines_in(store for store in self.watch.stores if store.place is pend)

    def of_object(self, match) -> list[int]:
        """Return the lines for a place or the looks of an object: those that set what make_pendulum
        gets for it.
        """
        parameter = match["what"] if match["what"] in MAKE_PENDULUM else "theta"
        if match["part"] == "axle":
            parameter = "axle_pos"
        for run, number in self.statements_that_ran():
            node = self.node(number)
            for call in [one for one in operations_in(node) if isinstance(one, ast.Call)]:
                given = dict(zip(MAKE_PENDULUM, call.args, strict=False))
                given |= {option.arg: option.value for option in call.keywords}
                if getattr(call.func, "id", "") == "make_pendulum" and parameter in given:
                    return lines_in(self.stores_of(names_in_head(given[parameter]), run)) or [
                        node.lineno
                    ]
        return []

    def of_result(self) -> list[int]:
        """Return the lines for a result: those that set the wrong part of it, and those that give
        it.
        """
        node = self.returned()
        names = self.function.returns.split(", ")
        wrong = [
            i
            for i, name in enumerate(names)
            if re.match(rf"(\w+ of )?{name} (is|are|has) ", self.sentence)
        ]
        if not node or not node.value:
            return self.lines_with_calls()
        part = node.value
        if wrong and isinstance(part, ast.Tuple) and len(part.elts) == len(names):
            part = part.elts[wrong[0]]
        stores = self.stores_of(names_in_head(part), self.main)
        lines = [*lines_in(stores), first_with_last_value(stores)] if stores else []
        if not isinstance(part, ast.Name) or self.sentence.startswith("The result "):
            return [*lines, node.lineno]
        if wrong and part.id in self.values and not self.is_set(part.id):
            self.facts.append(
                f"{names[wrong[0]]} is your {part.id}, and no line of your function has set it."
            )
        return lines or [node.lineno]

    def is_set(self, name) -> bool:
        """Return whether a line of the function can give a name another value."""
        nodes = [*ast.walk(self.node(self.main.definition))]
        names = {
            one.id
            for one in nodes
            if isinstance(one, ast.Name) and not isinstance(one.ctx, ast.Load)
        }
        return name in names or any(getattr(one, "name", "") == name for one in nodes)

    def lines_with_calls(self) -> list[int]:
        """Return the first line of the function that has called a function of src/."""
        for run, number in self.statements_that_ran():
            if run is self.main and any(one.calls for one in run.seen[number]):
                return [self.node(number).lineno]
        return []

    def node(self, number) -> Any:
        return self.watch.statements[number].node

    def statements_that_ran(self) -> Iterable[tuple[Run, int]]:
        """Yield each call that was watched, with the number of each of its statements that ran."""
        for run in self.watch.runs.values():
            for number in run.seen:
                yield run, number

    def returned(self) -> ast.Return | None:
        """Return the statement that gave the result of the function."""
        for run, number in self.statements_that_ran():
            if run is self.main and isinstance(self.node(number), ast.Return):
                return self.node(number)
        return None

    def stores_of(self, names, run) -> list[Store]:
        """Return what was stored under these names of a call."""
        return [store for store in self.watch.stores if store.place is run and store.key in names]


def first_with_last_value(stores) -> int:
    """Return the line that has given a place its last value; lines that have given it again do not
    count.
    """
    last = stores[-1]
    for store in reversed(stores):
        if store.text != last.text or store.key != last.key:
            break
        last = store
    return last.line


def lines_in(stores) -> list[int]:
    """Return the lines of stores, each once."""
    return [*dict.fromkeys(store.line for store in stores)]
