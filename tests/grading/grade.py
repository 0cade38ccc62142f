"""The grade from the outcomes of the checks, for people and for a gradebook."""

from collections import Counter

from grading.grader import checks, FAILED, FAULT, PASSED, WAITING
from grading.handout import FUNCTIONS, SUITES
from support.start.output import in_one_line

PRINTED = 10  # lines that are shown of what a solution has printed


def grade(outcomes) -> dict:
    """Return the grade of outcomes (by the names of the checks) for a gradebook.

    It is {"tiers": {tier: {"passed", "waiting", "failed", "points", "of"}}, "grade", "next", "more"}. Each passed check
    gives a point. The grade is the highest complete tier, with all tiers below it complete, or None. A tier without
    checks in outcomes has no entry. next is the next step, and more are words about it.
    """
    tiers = {}
    for tier in SUITES:
        states = Counter(outcomes[check.name].state for check in checks(tier=tier) if check.name in outcomes)
        if states:
            failed = states[FAILED] + states[FAULT]
            counts = {"passed": states[PASSED], "waiting": states[WAITING], "failed": failed}
            tiers[tier] = {**counts, "points": states[PASSED], "of": len(checks(tier=tier))}
    earned = None
    for tier in SUITES:
        if tier not in tiers or tiers[tier]["points"] < tiers[tier]["of"]:
            break
        earned = tier
    step, more = next_step(outcomes)
    return {"tiers": tiers, "grade": earned, "next": step, "more": more}


def made_checks(outcomes) -> list:
    """Return the checks that have an outcome, in the order of the handout."""
    return [check for tier in SUITES for check in checks(tier=tier) if check.name in outcomes]


def next_step(outcomes) -> tuple[str, str]:
    """Return the next step, mostly the first function of the handout that is not right yet, and more words about it."""
    made = made_checks(outcomes)
    for check in made:
        function, outcome = FUNCTIONS[check.function], outcomes[check.name]
        if outcome.state == FAULT:
            return f"show your teacher the grader's fault in {check.name}", ""
        if outcome.state == FAILED or outcome.place:
            return f"{check.function} in {function.file}", f"read in the handout: {function.read}"
    for check in made:
        if outcomes[check.name].state == WAITING:
            return f"{outcomes[check.name].cause}, which {check.function} waits for", ""
    for tier in SUITES:
        if len([check for check in made if check.tier == tier]) < len(checks(tier=tier)):
            return f"run all checks of tier {tier}", ""
    return "nothing is left to write", "show it to someone"


def whole_step(graded) -> str:
    """Return the next step and the words about it in one line."""
    return "; ".join(filter(None, (graded["next"], graded["more"])))


def words(outcomes, printed, columns=100) -> list[tuple[str, str]]:
    """Return what a student reads about outcomes, as lines of text, each with its color or "".

    printed has the output of the student's code by the names of the checks that fail. columns is the width of rules.
    """
    made = made_checks(outcomes)
    places = {check.function: outcomes[check.name].place for check in made if outcomes[check.name].place}
    lines = [(rule("Not written yet", "=", columns), "")] if places else []
    lines += [(f"{function} in {place}", "yellow") for function, place in places.items()]
    mistakes = [check for check in made if outcomes[check.name].state in (FAILED, FAULT)]
    if mistakes:
        first, *others = mistakes
        lines.append((rule("Failures", "=", columns), ""))
        more = Counter(check.function for check in others)
        for function, count in reversed(more.items()):
            lines.append((f"{count} more fail{'s' if count == 1 else ''}: {function}", "red"))
        lines.append((rule(first.title, "_", columns), "red"))
        rows = [in_one_line(row) for row in printed.get(first.name, "").splitlines()]
        lines += [(f"printed     {row}", "") for row in rows[:PRINTED]]
        if len(rows) > PRINTED:
            lines.append((f"printed     ... ({len(rows)} lines in all)", ""))
        lines += [(row, "") for row in outcomes[first.name].message.split("\n")]
    return [*lines, (rule("Grade", "=", columns), ""), *table(outcomes)]


def rule(title, sign, columns) -> str:
    """Return a title with a line of signs on both sides; a long title is cut off."""
    title = title if len(title) <= columns - 4 else f"{title[: columns - 7]}..."
    return f" {title} ".center(columns, sign)


def table(outcomes) -> list[tuple[str, str]]:
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
    causes = Counter(outcome.cause for outcome in outcomes.values() if outcome.cause and not outcome.place)
    rows += [(f"{count} wait for {cause}", "yellow") for cause, count in causes.items()]
    fails = any(outcome.state == FAILED for outcome in outcomes.values())
    in_message = fails and not any(
        outcome.place for outcome in outcomes.values()
    )  # the message above has the place in the handout
    step = graded["next"] if in_message else whole_step(graded)
    return [*rows, *((line, "bold") for line in [*verdict, f"Next:  {step}."])]
