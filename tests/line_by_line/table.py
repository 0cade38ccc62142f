"""The rows of a trace: each statement, its text, and what it gave, in 80 columns."""

import ast
import linecache
from collections.abc import Callable
from textwrap import wrap
from typing import Any, NamedTuple

from line_by_line.trace import Call, Key, Trace, Visit

COLUMNS = 80  # of a terminal
INDENT = 6  # columns of the number of a line
CODE = 34  # columns of a short line of code: the values of all short lines stand below each other
MOST_TEXTS = 3  # that a statement gave in one turn
MOST_CODE = 2  # lines of the code of a row
MOST_LINES = 3  # of the values of a row
FEW_TURNS = 4
# In this order, the rows of helpers, or the own ones, get at most this number of lines
CUTS = (True, 2), (True, 1), (False, 2), (True, 0), (False, 1), (False, 0)
GAVE = 1  # the rank of a row that gave a value like the wrong one
MOST_HELPERS = 2  # functions that are shown below the first one


class Wanted(NamedTuple):
    """What a table is about: the values that are wrong."""

    keys: frozenset[Key] = frozenset()  # of the cells that have them
    names: frozenset[Any] = frozenset()  # of such values, also elsewhere: "omega"
    is_wrong: Callable[[Any], bool] = lambda value: False
    error: BaseException | None = None  # that has stopped the call


class Row(NamedTuple):
    """A statement, and what it gave, as lines that are shown or left out together."""

    texts: list[str]
    # A row with a higher rank is left out first, one with GAVE only if no other one is left to cut,
    # and one with 0 never
    rank: int
    title: list[str] = []  # above the rows of a helper


def rows_of(trace: Trace, wanted: Wanted) -> list[Row]:
    """Return the rows of the first call, and below them those of the functions that it calls."""
    if not trace.calls:
        return []
    wanted = wanted._replace(error=trace.error)
    first = trace.calls[0]
    helpers: dict[str, list[Call]] = {}
    for call in trace.calls:
        if call.code is not first.code:
            helpers.setdefault(call.name, []).append(call)
    shown = [most_telling(calls, wanted) for calls in helpers.values()]
    shown.sort(key=lambda call: not is_telling(call, wanted))
    rows = rows_of_call(first, wanted, trace.is_full)
    for call in shown[:MOST_HELPERS]:
        title = wrap(f"Your function {call.head}, called there:", COLUMNS - 4)
        for row in rows_of_call(call, wanted, trace.is_full):
            rows.append(row._replace(title=[f"    {text}" for text in title]))
    return rows


def sets(visit: Visit, wanted: Wanted) -> bool:
    """Return whether a statement has set a wrong value, or has stopped."""
    is_stop = visit.error is not None and visit.error is wanted.error
    return is_stop or not wanted.keys.isdisjoint(visit.keys)


def gives(visit: Visit, wanted: Wanted) -> bool:
    """Return whether a statement gave a wrong value."""
    return any(map(wanted.is_wrong, visit.values))


def has_name(visit: Visit, wanted: Wanted) -> bool:
    """Return whether a statement has set a value like the wrong one."""
    return any(name in wanted.names for _, name in visit.keys)


def is_telling(call: Call, wanted: Wanted) -> bool:
    """Return whether a call has set or given a wrong value."""
    return any(sets(visit, wanted) or gives(visit, wanted) for visit in call.all_visits())


def most_telling(calls: list[Call], wanted: Wanted) -> Call:
    """Return the last call that has set a wrong value, else the last one that gave it.

    If there is none, return the first one.
    """
    for does in (sets, gives):
        for call in reversed(calls):
            if any(does(visit, wanted) for visit in call.all_visits()):
                return call
    return calls[0]


def rows_of_call(call: Call, wanted: Wanted, is_full: bool) -> list[Row]:
    """Return a row for each statement of a call."""
    last = [visit for visit in call.all_visits() if sets(visit, wanted)][-1:]
    lines = sorted({statement.lineno for statement in call.statements.values()})
    rows = []
    for i, line in enumerate(lines):
        visits = call.visits.get(line, [])
        telling = [visit for visit in visits if visit in last or gives(visit, wanted)]
        like = [visit for visit in visits if has_name(visit, wanted)]
        values = values_of(visits, telling, wanted)
        if not visits and not is_full:
            values = "(never ran)"
        is_here = is_full and call.is_open and call.line == line
        if is_here:
            values += " <- not watched further"
        texts = laid_out(call, line, values, calls_in([*telling[-1:], *like]))
        rank = GAVE + 1 + min(i, len(lines) - 1 - i)
        if not like:
            rank += len(lines)
        if telling:
            rank = GAVE
        if is_here or any(visit in last for visit in visits):
            rank = 0
        rows.append(Row(texts, rank))
    return rows


def values_of(visits: list[Visit], telling: list[Visit], wanted: Wanted) -> str:
    """Return what a statement gave: in the first turns, the last one that is telling, the last."""
    said = [visit for visit in visits if visit.texts or visit.error]
    texts = [text_of(visit, wanted) for visit in said]
    if len(texts) > 1 and len({*texts}) == 1:
        return f"{texts[0]}, {len(texts)} times"
    name = texts[0].partition(" = ")[0] + " = " if texts else ""
    are_single = all(len(visit.texts) == 1 for visit in said)
    if are_single and all(text.startswith(name) for text in texts):
        texts[1:] = [text.removeprefix(name) for text in texts[1:]]
    kept = [*said[:2], *telling[-1:], *said[-1:]]
    shown: list[str] = []
    for visit, text in zip(said, texts, strict=True):
        if visit in kept or len(said) <= FEW_TURNS:
            shown.append(text)
        elif shown[-1] != "...":
            shown.append("...")
    return " | ".join(shown)


def text_of(visit: Visit, wanted: Wanted) -> str:
    """Return what a statement gave in one turn."""
    texts = visit.texts[:MOST_TEXTS]
    if len(visit.texts) > MOST_TEXTS:
        texts.append("...")
    text = ", ".join(texts)
    if visit.error:
        word = "<- stops here" if visit.error is wanted.error else "stopped"
        text = f"{text} {word}: {type(visit.error).__name__}".strip()
    return text


def calls_in(visits: list[Visit]) -> list[str]:
    """Return the calls of functions that are not shown below, in the first of these turns."""
    for visit in visits:
        if visit.calls:
            return [result_of(call, visit) for call in visit.calls[:2]]
    return []


def result_of(call: Call, visit: Visit) -> str:
    """Return a call with what it gave, if that is not said before."""
    is_said = any(text.endswith(f" {call.gave}") for text in visit.texts)
    return call.head if is_said or not call.gave else f"{call.head} gives {call.gave}"


def laid_out(call: Call, line: int, values: str, calls: list[str]) -> list[str]:
    """Return a row as lines: values behind the code if they fit, else below it."""
    statement = call.statements[line]
    file = call.code.co_filename
    code = linecache.getline(file, line).strip()
    if call.statements.get(line + 1) is statement:
        code = ast.unparse(statement).partition("\n")[0]
    indent = indent_of(file, line) - min(indent_of(file, other) for other in call.statements)
    begin = f"{line:>{INDENT}}  {' ' * indent}"
    start, *more = below(code, begin, MOST_CODE)
    column = INDENT + 2 + CODE
    if column + 2 + len(values) > COLUMNS:
        column = len(start)
    texts = [f"{start:<{column}}  {values}".rstrip()]
    if more or len(texts[0]) > COLUMNS:
        texts = [start, *more, *below(values)]
    for text in calls:
        texts += below(text)
    return texts


def indent_of(file: str, line: int) -> int:
    """Return how many spaces stand at the beginning of a line."""
    text = linecache.getline(file, line)
    return len(text) - len(text.lstrip())


def below(text: str, begin: str = "", most: int = MOST_LINES) -> list[str]:
    """Return a text as lines below a line of code, or behind the beginning of one."""
    space = " " * (INDENT + 6)
    return wrap(
        text,
        COLUMNS,
        initial_indent=begin or space,
        subsequent_indent=space,
        max_lines=most,
        placeholder=" ...",
        break_on_hyphens=False,
    )


def returns_in_loops(trace: Trace) -> list[str]:
    """Return a sentence for each return in a loop that has ended it."""
    found = []
    for call in trace.calls:
        if isinstance(call.statements.get(call.line), ast.Return):
            for line, loop in call.statements.items():
                is_loop = isinstance(loop, (ast.For, ast.While)) and line == loop.lineno
                if is_loop and line < call.line <= (loop.end_lineno or line):
                    turn = f"turn {len(call.visits[line])} of the loop in line {line}"
                    found.append(f"Line {call.line} returns in {turn}, and so ends it.")
    return [*dict.fromkeys(found)]


def fitting(rows: list[Row], height: int) -> tuple[list[str], int]:
    """Return the lines of the rows for which there is room, and how many rows are left out.

    Rows become shorter before one is left out; see CUTS. Of a helper's rows, or of the own ones,
    those come first that have set nothing like the wrong value, from the middle.
    """
    kept = dict(enumerate(rows))
    order = sorted(kept, key=lambda i: rows[i].rank, reverse=True)
    for is_helpers, most in CUTS:
        for i in order:
            if len(lines_of([*kept.values()])) <= height:
                break
            if rows[i].rank > GAVE and bool(rows[i].title) == is_helpers:
                kept[i] = cut(rows[i], most)
    for i in order:
        if len(lines_of([*kept.values()])) > height and rows[i].rank == GAVE:
            kept[i] = cut(rows[i], 0)
    return lines_of([*kept.values()]), len([row for row in kept.values() if not row.texts])


def cut(row: Row, most: int) -> Row:
    """Return a row with at most this number of lines; if others are left out, the last says so."""
    texts = row.texts[:most]
    if texts and len(row.texts) > most:
        texts[-1] = f"{texts[-1].removesuffix(' ...')[: COLUMNS - 4]} ..."
    return row._replace(texts=texts)


def lines_of(rows: list[Row]) -> list[str]:
    """Return rows as lines, with the title of each helper above its first one."""
    lines: list[str] = []
    title: list[str] = []
    for row in rows:
        if row.texts and row.title != title:
            title = row.title
            lines += title
        lines += row.texts
    return lines
