"""The grade from the outcomes of the checks, for people and for a gradebook."""

from collections import Counter
from itertools import chain
from textwrap import wrap
from typing import NamedTuple

from grading.grader import checks, FAILED, FAULT, PASSED, STEPS, WAITING
from grading.handout import FUNCTIONS, highest, SUITES
from grading.line_by_line import CALLED
from support.start.checks_command import checks_command
from support.start.output import in_one_line
from support.start.preview import missing_in

PRINTED = 5  # lines that are shown of what a solution has printed
SCREEN = 40  # lines of a screen; the first one has the dots of pytest, and the last one its counts
MOST_ROWS = 16  # of the trace table
MOST_CAUSES = 3  # for which checks wait
MORE = " " * 7  # in front of the lines of the next step
LINE_BY_LINE = "Your code, line by line:"
BOOKS = "In Python, with books:"
# Ranks of what is said, among those of the rows of a trace table.
ALWAYS = -1
FACTS = 0.15
WORDS = 5
NEVER = 100


class Part(NamedTuple):
    """Lines of the next step.

    If there is no room for all parts, those of the highest rank are left out.
    """

    rank: float
    lines: list[str]
    is_row: bool = False  # of a trace table


def grade(outcomes) -> dict:
    """Return the grade of outcomes (by the names of the checks) for a gradebook.

    It is {"tiers": {tier: {"passed", "waiting", "failed", "points", "of"}}, "grade", "next",
    "more"}, without the tiers that have no outcomes. The grade is the highest complete tier, with
    all tiers below it complete, or None.
    """
    tiers = {}
    for tier in SUITES:
        states = Counter(
            outcomes[check.name].state for check in checks(tier=tier) if check.name in outcomes
        )
        if states:
            counts = {
                "passed": states[PASSED],
                "waiting": states[WAITING],
                "failed": states[FAILED] + states[FAULT],
            }
            tiers[tier] = {**counts, "points": states[PASSED], "of": len(checks(tier=tier))}
    points = {tier: counts["points"] for tier, counts in tiers.items()}
    most = {tier: counts["of"] for tier, counts in tiers.items()}
    step, parts = next_step(outcomes)
    more = "\n".join(line for part in parts for line in part.lines)
    return {"tiers": tiers, "grade": highest(points, most), "next": step, "more": more}


def made_checks(outcomes) -> list:
    """Return the checks that have an outcome, in the order of the handout."""
    every = chain.from_iterable(checks(tier=tier) for tier in SUITES)
    return [check for check in every if check.name in outcomes]


def next_step(outcomes) -> tuple[str, list[Part]]:
    """Return the next step, and more about it.

    It is a file that Python cannot read, else the first function with a mistake, else the first
    that is not written.
    """
    made = made_checks(outcomes)
    for check in [*mistakes_in(outcomes), *made]:
        function, outcome = FUNCTIONS[check.function], outcomes[check.name]
        if outcome.state == FAULT:
            return f"show your teacher the grader's fault in {check.name}", []
        if outcome.state == FAILED:
            step = (
                outcome.place
                if outcome.cause
                else f"{check.function} in {outcome.place or function.file}"
            )
            return step, explanation(check, outcome)
        if outcome.is_unwritten:
            return f"{check.function} in {outcome.place}", explanation(check, outcome)
    for check in made:
        if outcomes[check.name].state == WAITING:
            return f"{outcomes[check.name].cause}, which {check.function} waits for", []
    for tier in SUITES:
        if len([check for check in made if check.tier == tier]) < len(checks(tier=tier)):
            name = tier.split()[0]
            return f"run the checks of tier {name}: {checks_command()} --tier {name}", []
    left = missing_in("double_cradle", "visualize_double_cradle_run")  # without checks
    more = [Part(ALWAYS, [f"The double cradle still needs {left}."])] if left else []
    return "all functions with a check are right", more


def explanation(check, outcome) -> list[Part]:
    """Return what a student reads about a check that is not passed, in this order."""
    if outcome.is_unwritten:
        read = f"Read in the handout: {FUNCTIONS[check.function].read}."
        return [Part(ALWAYS, [read]), *step_parts(check.function)]
    dot = "" if outcome.wrong.endswith((".", "?", "!")) else "."
    # An error, or the exact result
    parts = [Part(ALWAYS, [f"{outcome.wrong}{dot} {outcome.hint}".strip()])]
    if outcome.cause:  # a file that Python cannot read: nothing else matters
        return parts
    if outcome.help:
        parts.append(Part(FACTS, [outcome.help]))
    if outcome.rows:
        parts.append(Part(ALWAYS, [LINE_BY_LINE]))
        best = sorted(outcome.rows, key=lambda row: row[0])[:MOST_ROWS]
        for rank, lines in outcome.rows:
            is_row = not lines[0].endswith(CALLED)
            parts.append(Part(rank if [rank, lines] in best else NEVER, lines, is_row))
    parts += [Part(FACTS, [fact]) for fact in outcome.facts]
    return [*parts, *step_parts(check.function)]


def step_parts(function) -> list[Part]:
    """Return the steps of a function, and lines of Python that show what it needs."""
    words, python = STEPS[function]
    parts = [Part(WORDS, [f"The steps: {words}"])]
    if python:
        parts.append(Part(WORDS + 1, [BOOKS, *(f"{MORE}  {line}" for line in python)]))
    return parts


def mistakes_in(outcomes) -> list:
    """Return the checks that fail, those first whose file cannot be imported."""
    failed = [
        check for check in made_checks(outcomes) if outcomes[check.name].state in (FAILED, FAULT)
    ]
    return sorted(failed, key=lambda check: not outcomes[check.name].cause)


def words(outcomes, printed, columns, note) -> list[tuple[str, str]]:
    """Return what a student reads about outcomes, as lines of text, each with its color or "".

    printed has the output of the student's code by the names of the checks that fail; note is about
    something else.
    """
    lines = []
    for first in mistakes_in(outcomes)[:1]:
        message = [(row, "") for row in outcomes[first.name].message.split("\n")]
        if outcomes[first.name].cause:  # a file that Python cannot read: nothing else matters
            return [(rule("Python cannot read a file", "=", columns), ""), *message]
        rows = [in_one_line(row) for row in printed.get(first.name, "").splitlines()]
        if len(rows) > PRINTED:
            rows[PRINTED:] = [f"... ({len(rows)} lines in all)"]
        lines = [(rule(first.title, "_", columns), "red")]
        lines += [(shorten(f"printed     {row}", columns), "") for row in rows] + message
    made = [] if lines else made_checks(outcomes)
    places = {
        check.function: outcomes[check.name].place for check in made if outcomes[check.name].place
    }
    if places:
        lines.append((rule("Not written yet", "=", columns), ""))
    lines += [(f"{function} in {place}", "yellow") for function, place in places.items()]
    lines.append((rule("Grade", "=", columns), ""))
    return [*lines, *table(outcomes, columns, note, SCREEN - 2 - len(lines))]


def shorten(text, columns) -> str:
    """Return a text with at most this number of columns: the end of a longer one is cut off."""
    return text if len(text) <= columns else f"{text[: columns - 3]}..."


def rule(title, sign, columns) -> str:
    """Return a title with a line of signs on both sides."""
    return f" {shorten(title, columns - 4)} ".center(columns, sign)


def table(outcomes, columns, note="", room=SCREEN) -> list[tuple[str, str]]:
    """Return the grade of outcomes as lines of text, each with its color; room is the greatest
    number of lines.

    Without the first tier, they say which tiers are complete, in place of the grade.
    """
    graded = grade(outcomes)
    rows = [(f"{'tier':<12}{'passed':>8}{'waiting':>9}{'failed':>8}{'points':>10}", "bold")]
    verdict = []
    for tier, counts in graded["tiers"].items():
        points = f"{counts['points']}/{counts['of']}"
        line = f"{tier:<12}{counts['passed']:>8}{counts['waiting']:>9}{counts['failed']:>8}{points:>10}"
        if counts["points"] == counts["of"]:
            rows.append((line, "green"))
            verdict.append(f"Tier {tier} is complete.")
        else:
            rows.append((line, "red" if counts["failed"] else "yellow"))
            verdict.append(f"Tier {tier} is not complete.")
    if next(iter(SUITES)) in graded["tiers"]:
        verdict = [f"Grade: {graded['grade'] or 'none yet'}."]
    causes = Counter(
        each.cause for each in outcomes.values() if each.state == WAITING and not each.place
    )
    for cause, n in causes.most_common(MOST_CAUSES):
        rows.append((f"{n} check{'s wait' if n > 1 else ' waits'} for {cause}", "yellow"))
    hints = [*(one.hint for one in outcomes.values() if one.state == PASSED), note]
    notes = sum(
        (wrap(hint, columns, initial_indent="Note:  ", subsequent_indent=MORE) for hint in hints),
        [],
    )
    above = [*rows, *((line, "bold") for line in [*verdict, *notes])]
    step, parts = next_step(outcomes)
    lines = wrap(f"Next:  {step}.", columns, subsequent_indent=MORE)
    parts = [part._replace(lines=wrapped(part.lines, columns)) for part in parts]
    shown = fitting(parts, room - len(above) - len(lines))
    left_out = sum(part.is_row for part in parts) - sum(part.is_row for part in shown)
    for part in shown:
        lines += part.lines
    if left_out:
        words = "1 line is left out" if left_out == 1 else f"{left_out} lines are left out"
        lines = [
            line.replace(LINE_BY_LINE, f"Your code, line by line ({words}):") for line in lines
        ]
    return [*above, *((line, "bold") for line in lines)]


def wrapped(lines, columns) -> list[str]:
    """Return lines in columns; those that are indented already, as in a trace table, stay as they
    are.
    """
    found = []
    for line in lines:
        found += (
            [line]
            if line.startswith(" ")
            else wrap(line, columns, initial_indent=MORE, subsequent_indent=MORE)
        )
    return found


def fitting(parts, room) -> list[Part]:
    """Return the parts for which there is room, those of the lowest ranks, in their order."""
    kept = []
    for i in sorted(range(len(parts)), key=lambda i: (parts[i].rank, i)):
        if parts[i].rank == ALWAYS or parts[i].rank != NEVER and len(parts[i].lines) <= room:
            kept.append(i)
            room -= len(parts[i].lines)
    found: list[Part] = []
    for i in sorted(kept, reverse=True):
        is_title = parts[i].lines[0].endswith(CALLED)
        # The title of a helper's table needs a row below it
        if not is_title or found and found[0].is_row:
            found.insert(0, parts[i])
    return found
