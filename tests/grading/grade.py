"""The grade from the outcomes of the checks, for people and for a gradebook."""

import re
from collections import Counter
from textwrap import wrap

from grading.grader import checks, FAILED, FAULT, PASSED, WAITING
from grading.handout import FUNCTIONS, highest, SUITES
from grading.hints import PYTHON, STEPS
from support.start.output import in_one_line
from support.start.preview import missing_in

PRINTED = 10  # lines that are shown of what a solution has printed
BOOKS = "In Python, with books:"
NUMBERS = r" (is|are) (-?[\d.]\S*|vector\(.*\)), not | wrong\.$"  # in a sentence about numbers
LAST = 9  # lines of the next step; below it, pytest has one more


def grade(outcomes) -> dict:
    """Return the grade of outcomes (by the names of the checks) for a gradebook.

    It is {"tiers": {tier: {"passed", "waiting", "failed", "points", "of"}}, "grade", "next", "more"}, without the tiers
    that have no outcomes. The grade is the highest complete tier, with all tiers below it complete, or None.
    """
    tiers = {}
    for tier in SUITES:
        states = Counter(outcomes[check.name].state for check in checks(tier=tier) if check.name in outcomes)
        if states:
            counts = {"passed": states[PASSED], "waiting": states[WAITING], "failed": states[FAILED] + states[FAULT]}
            tiers[tier] = {**counts, "points": states[PASSED], "of": len(checks(tier=tier))}
    points, most = ({tier: counts[key] for tier, counts in tiers.items()} for key in ("points", "of"))
    step, more = next_step(outcomes)
    return {"tiers": tiers, "grade": highest(points, most), "next": step, "more": more}


def made_checks(outcomes) -> list:
    """Return the checks that have an outcome, in the order of the handout."""
    return [check for tier in SUITES for check in checks(tier=tier) if check.name in outcomes]


def next_step(outcomes) -> tuple[str, str]:
    """Return the next step, and more words about it.

    It is a file that Python cannot read, else the first function with a mistake, else the first that is not written.
    """
    made = made_checks(outcomes)
    for check in [*mistakes_in(outcomes), *made]:
        function, outcome = FUNCTIONS[check.function], outcomes[check.name]
        if outcome.state == FAULT:
            return f"show your teacher the grader's fault in {check.name}", ""
        if outcome.state == FAILED:
            step = outcome.place if outcome.cause else f"{check.function} in {outcome.place or function.file}"
            dot = "" if outcome.wrong.endswith((".", "?", "!")) else "."
            hint = outcome.hint or (STEPS.get(check.name, "") if re.search(NUMBERS, outcome.wrong) else "")
            lines = [f"{outcome.wrong}{dot} {hint}".strip(), *[outcome.values] * bool(outcome.values)]
            lines += [STEPS[check.function], BOOKS]
            lines += [f"  {code}" for code, names in PYTHON.items() if check.function in names.split()]
            return step, "\n".join(lines)
        if outcome.is_unwritten:
            return f"{check.function} in {outcome.place}", f"read in the handout: {function.read}"
    for check in made:
        if outcomes[check.name].state == WAITING:
            return f"{outcomes[check.name].cause}, which {check.function} waits for", ""
    for tier in SUITES:
        if len([check for check in made if check.tier == tier]) < len(checks(tier=tier)):
            return f"run all checks of tier {tier}", ""
    left = missing_in("double_cradle", "visualize_double_cradle_run")  # without checks
    return "all functions with a check are right", f"The double cradle still needs {left}." * bool(left)


def mistakes_in(outcomes) -> list:
    """Return the checks that fail, those first whose file cannot be imported."""
    failed = [check for check in made_checks(outcomes) if outcomes[check.name].state in (FAILED, FAULT)]
    return sorted(failed, key=lambda check: not outcomes[check.name].cause)


def words(outcomes, printed, columns, note) -> list[tuple[str, str]]:
    """Return what a student reads about outcomes, as lines of text, each with its color or "".

    printed has the output of the student's code by the names of the checks that fail; note is about something else.
    """
    lines = []
    for first in mistakes_in(outcomes)[:1]:
        message = [(row, "") for row in outcomes[first.name].message.split("\n")]
        if outcomes[first.name].cause:  # a file that Python cannot read: nothing else matters
            return [(rule("Python cannot read a file", "=", columns), ""), *message]
        rows = [in_one_line(row) for row in printed.get(first.name, "").splitlines()]
        if len(rows) > PRINTED:
            rows[PRINTED:] = [f"... ({len(rows)} lines in all)"]
        lines = [(rule(first.title, "_", columns), "red"), *((f"printed     {row}", "") for row in rows), *message]
    made = [] if lines else made_checks(outcomes)
    places = {check.function: outcomes[check.name].place for check in made if outcomes[check.name].place}
    lines += [(rule("Not written yet", "=", columns), "")] * bool(places)
    lines += [(f"{function} in {place}", "yellow") for function, place in places.items()]
    return [*lines, (rule("Grade", "=", columns), ""), *table(outcomes, columns, note)]


def rule(title, sign, columns) -> str:
    """Return a title with a line of signs on both sides; a long title is cut off."""
    title = title if len(title) <= columns - 4 else f"{title[: columns - 7]}..."
    return f" {title} ".center(columns, sign)


def table(outcomes, columns, note="") -> list[tuple[str, str]]:
    """Return the grade of outcomes as lines of text, each with its color.

    Without the first tier, they say which tiers are complete, in place of the grade.
    """
    graded = grade(outcomes)
    rows, verdict = [(f"{'tier':<12}{'passed':>8}{'waiting':>9}{'failed':>8}{'points':>10}", "bold")], []
    for tier, counts in graded["tiers"].items():
        is_complete = counts["points"] == counts["of"]
        points = f"{counts['points']}/{counts['of']}"
        line = f"{tier:<12}{counts['passed']:>8}{counts['waiting']:>9}{counts['failed']:>8}{points:>10}"
        rows.append((line, "green" if is_complete else "red" if counts["failed"] else "yellow"))
        verdict.append(f"Tier {tier} is {'' if is_complete else 'not '}complete.")
    if next(iter(SUITES)) in graded["tiers"]:
        verdict = [f"Grade: {graded['grade'] or 'none yet'}."]
    causes = Counter(each.cause for each in outcomes.values() if each.state == WAITING and not each.place)
    rows += [(f"{n} check{'s wait' if n > 1 else ' waits'} for {cause}", "yellow") for cause, n in causes.items()]
    hints = [*(one.hint for one in outcomes.values() if one.state == PASSED), note]
    notes = sum((wrap(hint, columns, initial_indent="Note:  ", subsequent_indent=" " * 7) for hint in hints), [])
    lines = [("Next:  ", f"{graded['next']}."), *((" " * 7, line) for line in graded["more"].split("\n"))]
    steps = [wrap(line, columns, initial_indent=begin, subsequent_indent=" " * 7) for begin, line in lines]
    while len(steps) > 2 and (sum(map(len, steps)) > LAST or steps[-1] == [f"{' ' * 7}{BOOKS}"]):
        steps.pop()
    return [*rows, *((line, "bold") for line in [*verdict, *notes, *sum(steps, [])])]
