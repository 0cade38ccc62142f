"""A wrong call, line by line: the tables of the student's functions, and sentences about what was seen."""

import ast
from math import isclose
from numbers import Real
from typing import NamedTuple

from grading.expressions import keys_in_head, names_in_head, targets_of
from grading.handout import FUNCTIONS
from grading.messages import shown
from grading.question import lines_in, Question
from grading.trace_table import INDENT, Row, Stop, Table
from grading.watch import EndlessError, Run, Watch

ACCELERATIONS = "acc", "accel", "angacc", "angularacceleration", "accelerationangular", "dotomega", "omegadot"


class Explained(NamedTuple):
    """What was seen of a wrong call."""

    line: int  # of the file: where to look; 0 if it is not known
    rows: list[Row]
    facts: list[str]


class WrongCall:
    """A call of a student's function that gave something wrong, and was watched."""

    def __init__(self, function, sentence, watch: Watch, arguments, index, right):
        """sentence says what is wrong, for the pendulum at index (or None). arguments are those of the call.

        right are pairs of a part of the handout's formula, and its right value in this call.
        """
        self.function, self.watch, self.index, self.right = function, watch, index, right
        self.runs = [*watch.runs.values()]
        self.main = next(run for run in self.runs if self.name_of(run) == function)
        self.stops = self.found_stops()
        self.question = Question(function, sentence, watch, self.main, arguments)
        self.marks = self.departures()

    def name_of(self, run) -> str:
        return self.watch.statements[run.definition].node.name

    def explained(self) -> Explained:
        """Return what was seen."""
        begins = [*self.question.lines, *self.marks, *(stop.line for stop in self.stops.values())]
        needed = self.needed(self.main, begins) or self.needed(self.main, self.ends(self.main))
        rows = self.table(self.main, needed)
        helper = self.helper(needed)
        if helper:
            below = self.table(helper, self.needed(helper, [*begins, *self.ends(helper)]))
            rank = min((row.rank for row in below), default=0)
            rows.append(Row(rank, [f"{' ' * INDENT}Your function {self.name_of(helper)}, called there:"]))
            rows += below
        facts = [*self.question.facts]
        if not self.watch.error:
            facts += [*self.early_return(), *self.nothing_returned(), *self.missing_calls()]
        if self.right and not self.watch.error:
            facts.append(f"Right here: {', '.join(f'{name} = {shown(value)}' for name, value in self.right)}.")
        where = (
            [stop.line for stop in self.stops.values()] or [*self.marks] or self.question.lines or self.ends(self.main)
        )
        return Explained(where[-1] if where else 0, rows, facts)

    def table(self, run, needed) -> list[Row]:
        return Table(self.watch, run, self.stops.get(run), needed, self.marks, self.index).rows()

    def found_stops(self) -> dict[Run, Stop]:
        """Return where the watched calls were stopped, the outer one first."""
        found, error = {}, self.watch.error
        step = error.__traceback__ if error else None
        while step:
            run = self.watch.runs.get(step.tb_frame)
            if run:
                found[run] = Stop(step.tb_lineno, *words_of(error))
            step = step.tb_next
        return found

    def ends(self, run) -> list[int]:
        """Return the lines with a return at which a call has come to its end."""
        nodes = [self.watch.statements[number].node for number in run.seen]
        return [node.lineno for node in nodes if isinstance(node, ast.Return)]

    def needed(self, run, begins) -> dict[int, int]:
        """Return these lines of a call, all lines that set what they use, and the loops and conditions around them.

        Each has the number of steps that lead to it.
        """
        own = [one.node for i, one in enumerate(self.watch.statements) if one.owner == run.definition != i]
        found: dict[int, int] = {}
        left = [(line, 0) for line in begins]
        while left:
            line, depth = left.pop(0)
            if line in found:
                continue
            for node in own:
                if node.lineno == line:
                    found[line] = depth
                    lines = lines_in(self.question.stores_of(names_in_head(node), run))
                    lines += [one.lineno for one in own if sets_what_is_used(one, node)]
                    left += [(one, depth + 1) for one in lines]
                elif hasattr(node, "body") and node.lineno < line <= node.end_lineno:
                    left.append((node.lineno, depth + 1))
        return found

    def helper(self, needed) -> Run | None:
        """Return the call of the student's own helper that stopped, or else one that a needed line has made."""
        if self.stops and [*self.stops][-1] is not self.main:
            return [*self.stops][-1]
        by_line = {self.watch.statements[number].node.lineno: seen for number, seen in self.main.seen.items()}
        for line in sorted(needed, key=lambda line: (needed[line], -line)):
            seen = by_line.get(line)
            if seen:
                is_in_question = self.index is not None and self.index < len(seen)
                one = seen[self.index] if is_in_question else seen[-1]
                runs = [called.run for called in one.calls if called.run]
                if runs:
                    return runs[-1]
        others = [run for run in self.runs if self.name_of(run) != self.function]
        if not others or self.stops:
            return None
        return others[self.index] if self.index is not None and self.index < len(others) else others[-1]

    def missing_calls(self) -> list[str]:
        """Return a sentence for each function that the handout tells to use, and that no line names."""
        definitions = [self.watch.statements[run.definition].node for run in self.runs]
        names = {getattr(one, "id", "") for node in definitions for one in ast.walk(node)}
        missing = [name for name in FUNCTIONS[self.function].uses if name not in names]
        return [f"No line of your function calls {name}." for name in missing]

    def early_return(self) -> list[str]:
        """Return a sentence about a return that has ended a loop."""
        for number, seen in self.main.seen.items():
            statement = self.watch.statements[number]
            if isinstance(statement.node, ast.Return) and statement.loops:
                loop = self.watch.statements[statement.loops[-1]].node.lineno
                words = f"Line {statement.node.lineno} returns in turn {seen[-1].turn} of the loop in line {loop}"
                return [f"{words}, and so ends it."]
        return []

    def nothing_returned(self) -> list[str]:
        """Return a sentence about a function that must return something, and has not."""
        if self.main.has_result or not FUNCTIONS[self.function].returns:
            return []
        own = [one.node for one in self.watch.statements if one.owner == self.main.definition]
        if any(isinstance(node, ast.Return) and node.value for node in own):
            return ["No return with a value has run."]
        return ["Your function has no return with a value."]

    def departures(self) -> dict[int, str]:
        """Return the first line whose value is certainly not that of the handout's formula, with the right value.

        It is certain if the student gives the value the name that it has in the formula, and gives it no other value.
        """
        for store in sorted(self.watch.stores, key=lambda store: store.line):
            if not isinstance(store.place, Run) or not isinstance(store.value, Real):
                continue
            others = self.question.stores_of([store.key], store.place)
            if {other.text for other in others} == {store.text}:
                for name, value in self.right:
                    is_near = isclose(store.value, value, rel_tol=1e-6, abs_tol=1e-9)
                    if plain_name(store.key) == plain_name(name) and not is_near:
                        return {store.line: f"{shown(value)} is right here"}
        return {}


def sets_what_is_used(one, node) -> bool:
    """Return whether a statement gives a value to a name, or to a key, that another one uses."""
    targets = targets_of(one)
    names = {target.id for target in targets if isinstance(target, ast.Name)}
    slices = [target.slice for target in targets if isinstance(target, ast.Subscript)]
    keys = {part.value for part in slices if isinstance(part, ast.Constant)}
    return bool(names & names_in_head(node) or keys & keys_in_head(node))


def words_of(error) -> tuple[str, bool]:
    """Return how an error has stopped a line, in words, and whether it is an error of the line's own."""
    if isinstance(error, EndlessError):
        return "still here after 1000 turns", False
    if isinstance(error, KeyboardInterrupt):
        return "stopped here", False
    return f"stops here: {type(error).__name__}", True


def plain_name(name) -> str:
    """Return a name without what people write in different ways: v1_new and new_v1."""
    plain = "".join(sorted(name.lower().split("_")))
    return "acceleration" if plain in ACCELERATIONS else plain
