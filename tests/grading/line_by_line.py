"""A wrong call, line by line: the tables of the student's functions, and sentences about what was
seen.
"""

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

CALLED = "called there:"  # ends the line above the table of a helper
MOST_FUNCTIONS = 3  # that have a table


class Explained(NamedTuple):
    """What was seen of a wrong call."""

    line: int  # of the file: where to look; 0 if it is not known
    rows: list[Row]
    facts: list[str]


class WrongCall:
    """A call of a student's function that gave something wrong, and was watched."""

    def __init__(self, function, sentence, watch: Watch, arguments, index, right):
        """sentence says what is wrong, for the pendulum at index (or None). arguments are those of
        the call.

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
        runs = [self.main]
        helper = self.helper(self.main, needed) or self.other_helper()
        while helper and helper not in runs and len(runs) < MOST_FUNCTIONS:
            runs.append(helper)
            needed = self.needed(helper, [*begins, *self.ends(helper)])
            below = self.table(helper, needed)
            rank = min((row.rank for row in below), default=0)
            rows.append(
                Row(rank, [f"{' ' * INDENT}Your function {self.name_of(helper)}, {CALLED}"])
            )
            rows += below
            helper = self.helper(helper, needed)
        facts = [*self.question.facts]
        if not self.watch.error:
            facts += [*self.early_returns(runs), *self.nothing_returned(), *self.missing_calls()]
        if self.right and not self.watch.error:
            facts.append(
                f"Right here: {', '.join(f'{name} = {shown(value)}' for name, value in self.right)}."
            )
        where = (
            [stop.line for stop in self.stops.values()]
            or [*self.marks]
            or self.question.lines
            or self.ends(self.main)
        )
        return Explained(where[-1] if where else 0, rows, facts)

    def table(self, run, needed) -> list[Row]:
        return Table(self.watch, run, self.stops.get(run), needed, self.marks, self.index).rows()

    def found_stops(self) -> dict[Run, Stop]:
        """Return where the watched calls were stopped, the outer one first."""
        found, error = {}, self.watch.error
        step = error.__traceback__ if error else None
        # Of these, the outer call is enough
        while step and not (found and isinstance(error, RecursionError)):
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
        """Return these lines of a call, all lines that set what they use, and the loops and
        conditions around them.

        Each has the number of steps that lead to it.
        """
        own = [
            one.node
            for i, one in enumerate(self.watch.statements)
            if one.owner == run.definition != i
        ]
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

    def helper(self, run, needed) -> Run | None:
        """Return the call of a helper that this call has made: the one that stopped, or that a
        needed line made.
        """
        stopped = [*self.stops]
        if run in stopped and run is not stopped[-1]:
            return stopped[stopped.index(run) + 1]
        by_line = {
            self.watch.statements[number].node.lineno: seen for number, seen in run.seen.items()
        }
        for line in sorted(needed, key=lambda line: (needed[line], -line)):
            seen = by_line.get(line)
            if seen:
                is_in_question = self.index is not None and self.index < len(seen)
                one = seen[self.index] if is_in_question else seen[-1]
                runs = [called.run for called in one.calls if called.run]
                if runs:
                    return runs[-1]
        return None

    def other_helper(self) -> Run | None:
        """Return the last call of another function of the student's, or the one for the pendulum in
        question.
        """
        others = [
            run
            for run in self.runs
            if self.name_of(run) != self.function and "__" not in self.name_of(run)
        ]
        if not others or self.stops:
            return None
        return (
            others[self.index]
            if self.index is not None and self.index < len(others)
            else others[-1]
        )

    def missing_calls(self) -> list[str]:
        """Return a sentence for each function that the handout tells to use, and that no line
        names.
        """
        nodes = [
            one for run in self.runs for one in ast.walk(self.watch.statements[run.definition].node)
        ]
        names = {getattr(one, kind, "") for one in nodes for kind in ("id", "attr", "name")}
        missing = [name for name in FUNCTIONS[self.function].uses if name not in names]
        return [f"No line of your function calls {name}." for name in missing]

    def early_returns(self, runs) -> list[str]:
        """Return sentences about the returns that have ended a loop in these calls."""
        found = []
        for run in runs:
            for number, seen in run.seen.items():
                statement = self.watch.statements[number]
                if isinstance(statement.node, ast.Return) and statement.loops:
                    loop = self.watch.statements[statement.loops[-1]].node.lineno
                    words = f"Line {statement.node.lineno} returns in turn {seen[-1].turn} of the loop in line {loop}"
                    found.append(f"{words}, and so ends it.")
        return found

    def nothing_returned(self) -> list[str]:
        """Return a sentence about a function that must return something, and has not."""
        if self.main.has_result or not FUNCTIONS[self.function].returns:
            return []
        own = [one.node for one in self.watch.statements if one.owner == self.main.definition]
        if any(isinstance(node, ast.Return) and node.value for node in own):
            return ["No return with a value has run."]
        return ["Your function has no return with a value."]

    def departures(self) -> dict[int, str]:
        """Return the first line that gives a returned name a value that the handout's formula does
        not give.

        It is certain only if the returned name has this value, and says which result it is: omega,
        or theta.
        """
        node = self.question.returned()
        parts = node.value.elts if node and isinstance(node.value, ast.Tuple) else []
        names = FUNCTIONS[self.function].returns.split(", ")
        found = {}
        for part, name in zip(parts, names, strict=False):
            right = dict(self.right).get(name)
            own = getattr(part, "id", "")
            stores = self.question.stores_of([own], self.main)
            if right is None or not stores or not isinstance(stores[-1].value, Real):
                continue
            if name.partition("_")[0] not in own:
                continue  # the results may be exchanged
            if not isclose(stores[-1].value, right, rel_tol=1e-6, abs_tol=1e-9):
                found[stores[-1].line] = f"{shown(right)} is right here"
        return dict(sorted(found.items())[:1])


def sets_what_is_used(one, node) -> bool:
    """Return whether a statement gives a value to a name, or to a key, that another one uses."""
    targets = targets_of(one)
    names = {target.id for target in targets if isinstance(target, ast.Name)}
    slices = [target.slice for target in targets if isinstance(target, ast.Subscript)]
    keys = {part.value for part in slices if isinstance(part, ast.Constant)}
    return bool(names & names_in_head(node) or keys & keys_in_head(node))


def words_of(error) -> tuple[str, bool]:
    """Return how an error has stopped a line, in words, and whether it is an error of the line's
    own.
    """
    if isinstance(error, EndlessError):
        return "still here after 1000 turns", False
    if isinstance(error, KeyboardInterrupt):
        return "stopped here", False
    return f"stops here: {type(error).__name__}", True
