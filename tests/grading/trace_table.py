"""The trace table of a call that was watched: a row for each line of the student's code, as
teachers draw it.
"""

import ast
import io
import linecache
import tokenize
from contextlib import suppress
from textwrap import wrap
from typing import NamedTuple

from grading.instrument import TRIES
from grading.values import in_words
from grading.watch import LOOPS, Run, Seen, Watch

COLUMNS, INDENT = 80, 4  # of the screen, and spaces in front of each row
CODE = 34  # columns of a short line of code; the values of all short lines stand below each other
MOST_LINES = 3  # of the values of a row
MOST_CALLS = 3  # of a line that are shown
FEW = 4  # turns of a loop that are all shown
SHORT = 12  # characters of a value that is shown again if all turns give the same
LONG = 140  # characters of the values of all turns; if they are longer, only one turn is shown
# By the handout
PROVIDED = "df = pd.read_csv(relative_filepath)", 'bad_rep = df.to_dict(orient="index")'

# Ranks of rows: if there is no room for all, the highest ones are left out. Needed lines have ranks
# from 0 to 1.
CALLS, VALUES, ABOVE, IDLE = 1, 2, 3, 4


class Row(NamedTuple):
    """A line of code, and what it gave, as lines of the screen."""

    rank: float
    lines: list[str]


class Stop(NamedTuple):
    """Where a call was stopped."""

    line: int
    words: str  # "stops here: TypeError"
    is_error: bool  # and not a limit


class Said(NamedTuple):
    """What is said of a line of code."""

    rank: float
    beside: str = ""
    below: tuple[str, ...] = ()


class Table:
    """The trace table of one call of a function that the student wrote."""

    def __init__(
        self,
        watch: Watch,
        run: Run,
        stop: Stop | None,
        needed: dict[int, int],
        marks: dict[int, str],
        index,
    ):
        """needed has the lines that matter, with the numbers of steps that lead to them.

        marks has what is right, by the line that departs from it. index is that of the pendulum in
        question, or None.
        """
        self.watch, self.run, self.stop = watch, run, stop
        self.needed, self.marks, self.index = needed, marks, index
        self.file = run.frame.f_code.co_filename
        # The numbers of the statements that begin in a line
        self.by_line: dict[int, list[int]] = {}
        for number, statement in enumerate(watch.statements):
            is_own = statement.owner == run.definition != number
            if is_own and (statement.is_shown or self.is_stopped_in(statement.node)):
                self.by_line.setdefault(statement.node.lineno, []).append(number)
        columns = [
            len(self.source(line)) - len(self.source(line).lstrip()) for line in self.by_line
        ]
        self.first_column = min(columns, default=0)

    def is_stopped_in(self, node) -> bool:
        """Return whether the call was stopped in a statement."""
        return self.stop is not None and node.lineno <= self.stop.line <= node.end_lineno

    def node(self, number) -> ast.AST:
        return self.watch.statements[number].node

    def source(self, line) -> str:
        return linecache.getline(self.file, line).rstrip().expandtabs(4)

    def rows(self) -> list[Row]:
        """Return the rows in the order of the code.

        A row with else has the rank of the one below it.
        """
        lines = sorted({*self.by_line, *self.lines_with_else()})
        width = len(str(max(lines, default=0)))
        rows: list[Row] = []
        for line in reversed(lines):
            said = None
            if line in self.by_line:
                said = self.said(line)
            elif rows:
                said = Said(rows[0].rank)
            if said is not None:
                rows.insert(
                    0, Row(said.rank, laid_out(f"{line:>{width}}", self.code_of(line), said))
                )
        return rows

    def lines_with_else(self) -> set[int]:
        """Return the lines with else and finally: no statement begins there."""
        found = set()
        for number in [number for numbers in self.by_line.values() for number in numbers]:
            node = self.node(number)
            for block in (getattr(node, "orelse", None), getattr(node, "finalbody", None)):
                if block:
                    above = range(node.lineno, block[0].lineno)
                    words = ("else", "finally")
                    found.update(
                        [line for line in above if self.source(line).lstrip().startswith(words)][
                            -1:
                        ]
                    )
        return found

    def code_of(self, line) -> str:
        """Return the code of the statement at a line, in one line and without comments; of a block,
        its head.
        """
        texts = [without_comment(self.source(line))]
        if line in self.by_line:
            node = self.node(self.by_line[line][0])
            body = getattr(node, "body", None) or getattr(node, "cases", None)
            last = node.end_lineno
            if isinstance(body, list):
                last = getattr(body[0], "lineno", line + 1) - 1
            for number in range(line + 1, last + 1):
                if body and texts[-1].endswith(":"):
                    break  # comments and prints follow
                texts.append(without_comment(self.source(number)).strip())
        return " ".join(text for text in texts if text.strip())[self.first_column :]

    # --- what is said of a line ---

    def said(self, line) -> Said | None:
        """Return what is said of a line with statements; None if it comes after the line that has
        stopped.
        """
        numbers = [
            number for number in self.by_line[line] if not isinstance(self.node(number), TRIES)
        ]
        if not numbers:
            return Said(ABOVE)
        found = [self.said_of(number, line) for number in numbers]
        if self.stop and line == self.begin_of(self.stop.line):
            said = self.stopped(numbers, found)
        elif not any(found):
            if self.stop and self.stop.is_error and line > self.stop.line and self.run.is_whole:
                return None
            said = Said(ABOVE, self.never_ran(line, numbers))
        else:
            said = together([one for one in found if one])
        if line in self.marks:
            said = said._replace(beside=f"{said.beside}  <- {self.marks[line]}")
        if self.source(line).strip().rstrip(";") in PROVIDED and not self.stop:
            return said._replace(rank=IDLE)
        if line in self.needed:
            return said._replace(rank=min(said.rank, min(self.needed[line], 9) / 10))
        return said

    def said_of(self, number, line) -> Said | None:
        """Return what is said of a statement, or None if it did not come to its end."""
        seen, node = self.run.seen.get(number), self.node(number)
        count = self.count_of(number)
        if not self.run.is_whole:
            count = max(0, count - 1)  # the last turn was not watched to its end
        if not seen:
            is_empty = isinstance(node, LOOPS) and number in self.run.values and not self.stop
            return Said(VALUES, "no turn") if is_empty else None
        if (
            self.stop
            and line == self.begin_of(self.stop.line)
            and count > 1
            and not isinstance(node, LOOPS)
        ):
            count -= 1  # the last turn has stopped here
        beside = (
            self.in_turns_of(seen, count, isinstance(node, LOOPS))
            if count
            else once(seen[-1].words)
        )
        calls = self.calls(number, seen, count)
        rank = VALUES if any(one.words for one in seen) else IDLE
        return Said(CALLS if any(one.calls for one in seen) else rank, beside, tuple(calls))

    def count_of(self, number) -> int:
        """Return how many turns the innermost loop around a statement has made, or the loop that it
        is; else 0.
        """
        statement = self.watch.statements[number]
        loops = [number] if isinstance(statement.node, LOOPS) else statement.loops
        return self.run.turns[loops[-1]] if loops else 0

    def stopped(self, numbers, found) -> Said:
        """Return what is said of the line that has stopped: its earlier turns, and the values at
        which it stopped.
        """
        said = together([Said(0), *(one for one in found if one)])
        below = []
        for number in numbers:
            calls = self.run.calls.get(number, [])
            if self.stop.is_error and not calls:  # what a call got is shown anyway
                below += self.watch.values_in(self.run, number).stopped_at(self.node(number))
                if not below and number in self.run.values:  # its value was not taken apart
                    below.append(f"the value is {in_words(self.run.values[number])}")
            count = self.count_of(number)
            turn = f"turn {count}: " if count > 1 else ""
            below += [f"{turn}{called.name} got {called.got}" for called in calls if called.got]
        return Said(0, f"{said.beside}  <- {self.stop.words}".strip(), (*below, *said.below[-1:]))

    def never_ran(self, line, numbers) -> str:
        """Return what is said beside a line that did not come to its end in any turn."""
        for stopped, kind in self.run.hidden.items():
            if line == self.begin_of(stopped):
                return f"stopped: {kind}"
        if not self.run.is_whole:
            return "(not watched further)"
        return (
            "(did not come to its end)" if self.run.begun.intersection(numbers) else "(never ran)"
        )

    def begin_of(self, line) -> int:
        """Return the first line of the innermost statement in which a line is; 0 if it is in none."""
        found = [0]
        for begin, numbers in self.by_line.items():
            found += [begin for number in numbers if begin <= line <= self.node(number).end_lineno]
        return max(found)

    # --- the turns of a loop ---

    def shown_turns(self, count) -> list[int]:
        """Return which turns of a loop are shown: the first two, the one in question, and the last
        one.
        """
        if count <= FEW:
            return [*range(1, count + 1)]
        some = {1, 2, count}
        if self.index is not None and self.index < count:
            some.add(self.index + 1)
        return sorted(some)

    def in_turns_of(self, seen: list[Seen], count, is_loop) -> str:
        """Return what a statement gave, in each turn of its loop that is shown."""
        by_turn = {one.turn: self.cell(one) for one in seen}
        turns = count
        if seen[0].is_condition_of_loop:  # it comes once more at each end
            by_turn = {i: self.cell(one) for i, one in enumerate(seen, start=1)}
            count = len(seen)
            turns = count if self.stop and not self.stop.is_error else turns
        is_in_each = len(by_turn) == count
        if is_in_each and not any(one.words for one in seen):
            return ""
        shown = self.shown_turns(count)
        texts = {*by_turn.values()}
        is_same = is_in_each and len(texts) == 1 and count > 2
        if is_same and (count > FEW or len(by_turn[1]) > SHORT):
            text = f"{by_turn[1]}, in each turn"
        else:
            text = cells(by_turn, shown)
        if len(text) > LONG and self.index is not None and self.index < count:
            turn = self.index + 1
            return f"turn {turn}: {by_turn.get(turn, '-')}"
        if not is_loop or count <= FEW:
            return text
        if not self.run.is_whole:
            return f"{text}  (more than {turns} turns: not watched further)"
        return f"{text}  ({turns} turns)"

    def cell(self, one: Seen) -> str:
        """Return what a statement gave in one turn."""
        values = [text for _, text in one.words]
        if not values:
            return "ran"
        return values[0] if len(values) == 1 else f"({', '.join(values)})"

    def calls(self, number, seen: list[Seen], count) -> list[str]:
        """Return what the functions got and gave that a statement has called, in the turns that are
        shown.
        """
        calling = [one for one in seen if one.calls]
        in_question = []
        if self.index is not None and len(self.watch.statements[number].loops) == 1:
            in_question = [one for one in calling if one.turn == self.index + 1]
        node = self.node(number)
        is_whole = isinstance(getattr(node, "value", None), ast.Call) and not isinstance(
            node, ast.AugAssign
        )
        lines = []
        for one in in_question or [*calling[: MOST_CALLS - 1], *calling[MOST_CALLS - 1 :][-1:]]:
            for called in one.calls:
                parts = [f"got {called.got}"] if called.got else []
                # What the call gave is the row's value
                is_said = is_whole and len(one.calls) == 1 and one.words
                if not (called.gave.startswith("gave") and is_said):
                    parts.append(called.gave)
                if parts:
                    number_of_turn = one.turn + one.is_condition_of_loop  # it comes before its turn
                    turn = f"turn {number_of_turn}: " if count > 1 else ""
                    lines.append(f"{turn}{called.name} {'; it '.join(parts)}")
        return lines


def together(found: list[Said]) -> Said:
    """Return what is said of several statements in a line."""
    texts = dict.fromkeys(one.beside for one in found if one.beside)
    if len(texts) > 1:  # whether a line ran in a turn stands in the others, too
        texts = {text: None for text in texts if {*text.split(" | ")} - {"ran", "-", "..."}}
    beside = "; ".join(texts)
    return Said(
        min(one.rank for one in found), beside, tuple(text for one in found for text in one.below)
    )


def once(words) -> str:
    """Return what a statement gave outside of loops.

    A place whose code stands in the line needs no label.
    """
    if len(words) == 1 and not words[0][0].isidentifier():
        return words[0][1]
    return ", ".join(f"{code} = {text}" if code else text for code, text in words)


def cells(by_turn, shown) -> str:
    """Return texts in these turns, with ... for those that are left out."""
    texts, last = [], 0
    for turn in shown:
        if turn > last + 1:
            texts.append("...")
        texts.append(by_turn.get(turn, "-"))
        last = turn
    return " | ".join(texts)


def laid_out(number, code, said: Said) -> list[str]:
    """Return a row as lines of the screen: values beside the code if both are short, else below it."""
    begin = f"{' ' * INDENT}{number}  {code}".ljust(INDENT + len(number) + 2 + CODE)
    beside = said.beside
    value = beside.partition(" = ")[2]
    if beside.count(" = ") == 1 and len(f"{begin}  {beside}") > COLUMNS >= len(f"{begin}  {value}"):
        beside = value  # the name stands in the code
    if not beside or len(f"{begin}  {beside}") <= COLUMNS:
        lines = [f"{begin}  {beside}".rstrip()]
    else:
        lines = wrap(begin.rstrip(), COLUMNS, subsequent_indent=" " * (INDENT + 10))[:2]
        lines += indented(beside)
    for text in said.below:
        lines += indented(text)
    return lines


def indented(text) -> list[str]:
    """Return what is said below a line of code, cut after MOST_LINES."""
    space = " " * (INDENT + 8)
    lines = wrap(text, COLUMNS, initial_indent=space, subsequent_indent=space)
    if len(lines) > MOST_LINES:
        return [*lines[: MOST_LINES - 1], shortened(lines[MOST_LINES - 1])]
    return lines


def shortened(line) -> str:
    """Return a line with ... at its end, and without the words that have no room then."""
    while len(line) > COLUMNS - 4:
        line = line.rpartition(" ")[0]
    return f"{line} ..."


def without_comment(line) -> str:
    """Return a line of code without its comment."""
    begin = len(line) - len(line.lstrip())
    with suppress(tokenize.TokenError, SyntaxError):
        for token in tokenize.generate_tokens(io.StringIO(line[begin:]).readline):
            if token.type == tokenize.COMMENT:
                return line[: begin + token.start[1]].rstrip()
    return line
