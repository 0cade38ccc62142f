"""The grade from the outcomes of the checks, and the next step.

screen.py shows both.
"""

from collections import Counter
from typing import NamedTuple

from grading.grader import Check, checks, STEPS
from grading.handout import FUNCTIONS, highest, SUITES
from grading.outcomes import FAILED, FAULT, Outcome, PASSED, WAITING
from grading.ranks import ALWAYS, FACTS, IN_PYTHON, IN_WORDS, NEVER
from support.start.checks_command import checks_command
from support.start.preview import missing_in

MOST_ROWS = 16  # of the trace table
MORE = " " * 7  # in front of the lines of the next step
LINE_BY_LINE = "Your code, line by line:"
BOOKS = "In Python, with books:"


class StepPart(NamedTuple):
    """Lines of the next step.

    If there is no room for all parts, those of the highest rank are left out.
    """

    rank: int
    lines: list[str]
    is_row: bool = False  # of a trace table
    is_title: bool = False  # of the table of a helper


def grade(outcomes: dict[str, Outcome]) -> dict:
    """Return the grade of outcomes (by the names of the checks) for a gradebook.

    It is {"tiers": {tier: {"passed", "waiting", "failed", "points", "of"}}, "grade", "next",
    "more"}, without the tiers that have no outcomes. The grade is the highest complete tier, with
    all tiers below it complete, or None.
    """
    tiers = {}
    for tier in SUITES:
        tier_checks = checks(tier=tier)
        found = [outcomes[check.name] for check in tier_checks if check.name in outcomes]
        states = Counter(outcome.state for outcome in found)
        if states:
            tiers[tier] = {
                "passed": states[PASSED],
                "waiting": states[WAITING],
                "failed": states[FAILED] + states[FAULT],
                "points": states[PASSED],
                "of": len(tier_checks),
            }
    points = {tier: counts["points"] for tier, counts in tiers.items()}
    most = {tier: counts["of"] for tier, counts in tiers.items()}
    step, parts = next_step(outcomes)
    more = []
    for part in parts:
        more += part.lines
    return {"tiers": tiers, "grade": highest(points, most), "next": step, "more": "\n".join(more)}


def checks_with_outcome(outcomes: dict[str, Outcome]) -> list[Check]:
    """Return the checks that have an outcome, in the order of the handout."""
    found = []
    for tier in SUITES:
        found += [check for check in checks(tier=tier) if check.name in outcomes]
    return found


def failed_checks(outcomes: dict[str, Outcome]) -> list[Check]:
    """Return the checks that fail, those first whose file cannot be imported."""
    failed = []
    for check in checks_with_outcome(outcomes):
        if outcomes[check.name].state in (FAILED, FAULT):
            failed.append(check)
    return sorted(failed, key=lambda check: not outcomes[check.name].broken_file)


def next_step(outcomes: dict[str, Outcome]) -> tuple[str, list[StepPart]]:
    """Return the next step, and more about it.

    It is a file that Python cannot read, else the first function with a mistake, else the first
    that is not written.
    """
    in_order = checks_with_outcome(outcomes)
    for check in [*failed_checks(outcomes), *in_order]:
        outcome = outcomes[check.name]
        if outcome.state == FAULT:
            return f"show your teacher the grader's fault in {check.name}", []
        if outcome.broken_file:
            return outcome.place, explanation(check, outcome)
        if outcome.state == FAILED or outcome.is_unwritten:
            place = outcome.place or FUNCTIONS[check.function].file
            return f"{check.function} in {place}", explanation(check, outcome)
    for check in in_order:
        outcome = outcomes[check.name]
        if outcome.state == WAITING:
            return f"{outcome.waits_for}, which {check.function} waits for", []
    for tier in SUITES:
        if any(check.name not in outcomes for check in checks(tier=tier)):
            name = tier.split()[0]
            return f"run the checks of tier {name}: {checks_command()} --tier {name}", []
    parts = []
    left = missing_in("double_cradle", "visualize_double_cradle_run")  # without checks
    if left:
        parts.append(StepPart(ALWAYS, [f"The double cradle still needs {left}."]))
    return "all functions with a check are right", parts


def explanation(check: Check, outcome: Outcome) -> list[StepPart]:
    """Return what a student reads about a check that is not passed, in this order."""
    if outcome.is_unwritten:
        read = f"Read in the handout: {FUNCTIONS[check.function].read}."
        return [StepPart(ALWAYS, [read]), *step_parts(check.function)]
    dot = "" if outcome.wrong.endswith((".", "?", "!")) else "."
    # An error, or the exact result
    parts = [StepPart(ALWAYS, [f"{outcome.wrong}{dot} {outcome.hint}".strip()])]
    if outcome.broken_file:  # a file that Python cannot read: nothing else matters
        return parts
    if outcome.help:
        parts.append(StepPart(FACTS, [outcome.help]))
    if outcome.rows:
        parts.append(StepPart(ALWAYS, [LINE_BY_LINE]))
    best = sorted(outcome.rows, key=lambda row: row.rank)[:MOST_ROWS]
    for row in outcome.rows:
        rank = row.rank if row in best else NEVER
        parts.append(StepPart(rank, row.lines, is_row=not row.is_title, is_title=row.is_title))
    parts += [StepPart(FACTS, [fact]) for fact in outcome.facts]
    return [*parts, *step_parts(check.function)]


def step_parts(function: str) -> list[StepPart]:
    """Return the steps of a function, and lines of Python that show what it needs."""
    steps = STEPS[function]
    parts = [StepPart(IN_WORDS, [f"The steps: {steps.sentence}"])]
    if steps.python:
        lines = [f"{MORE}  {line}" for line in steps.python]
        parts.append(StepPart(IN_PYTHON, [BOOKS, *lines]))
    return parts
