"""The grade from the outcomes of the checks, for people and for a gradebook."""

from collections import Counter

from grading.grader import checks, FAILED, FAULT, PASSED, WAITING
from grading.handout import FUNCTIONS, SUITES


def grade(outcomes) -> dict:
    """Return the grade of outcomes (by the names of the checks) for a gradebook.

    It is {"tiers": {tier: {"passed", "waiting", "failed", "points", "of"}}, "grade", "next"}. Each passed check gives a
    point. The grade is the highest complete tier, with all tiers below it complete, or None. A tier without checks in
    outcomes has no entry.
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
    return {"tiers": tiers, "grade": earned, "next": next_step(outcomes)}


def next_step(outcomes) -> str:
    """Return the next step: the first function in the order of the handout that is not right yet."""
    made = [check for tier in SUITES for check in checks(tier=tier) if check.name in outcomes]
    for check in made:
        function, outcome = FUNCTIONS[check.function], outcomes[check.name]
        if outcome.state == FAULT:
            return f"show your teacher the grader's fault in {check.name}"
        if outcome.state == FAILED or outcome.place:
            return f"{check.function} in {function.file}; read in the handout: {function.read}"
    for check in made:
        if outcomes[check.name].state == WAITING:
            return f"{outcomes[check.name].message.removeprefix('waits for ')}, which {check.function} waits for"
    for tier in SUITES:
        if len([check for check in made if check.tier == tier]) < len(checks(tier=tier)):
            return f"run all checks of tier {tier}"
    return "nothing is left to write; show it to someone"


def unwritten(outcomes) -> list[str]:
    """Return a line with the place of each function that is not written yet, in the order of the handout."""
    made = [check for tier in SUITES for check in checks(tier=tier) if check.name in outcomes]
    places = {check.function: outcomes[check.name].place for check in made}
    return [f"{function} in {place}" for function, place in places.items() if place]


def verdict(graded) -> list[str]:
    """Return lines with the grade; without the first tier, they say instead which tiers are complete."""
    if next(iter(SUITES)) in graded["tiers"]:
        return [f"Grade: {graded['grade'] or 'none yet'}."]
    tiers = graded["tiers"].items()
    return [f"Tier {tier} is {'' if of['points'] == of['of'] else 'not '}complete." for tier, of in tiers]


def lines(outcomes) -> list[tuple[str, str]]:
    """Return the grade of outcomes as lines of text, each with its color."""
    graded = grade(outcomes)
    table = [(f"{'tier':<12}{'passed':>8}{'waiting':>9}{'failed':>8}{'points':>10}", "bold")]
    for tier, counts in graded["tiers"].items():
        points = f"{counts['points']}/{counts['of']}"
        line = f"{tier:<12}{counts['passed']:>8}{counts['waiting']:>9}{counts['failed']:>8}{points:>10}"
        color = "green" if counts["points"] == counts["of"] else "red" if counts["failed"] else "yellow"
        table.append((line, color))
    waits = Counter(of.message for of in outcomes.values() if of.state == WAITING and not of.place)
    table += [(f"{count} wait {message.removeprefix('waits ')}", "yellow") for message, count in waits.items()]
    what_next = graded["next"]
    if any(of.state == FAILED for of in outcomes.values()) and not unwritten(outcomes):
        what_next = what_next.partition("; ")[0]  # the message above has the place in the handout
    return [*table, *((line, "bold") for line in [*verdict(graded), f"Next:  {what_next}."])]
