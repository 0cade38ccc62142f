"""The grade from the outcomes of the checks, and the next step. screen.py shows both."""

from collections import Counter

from grading.grader import Check, checks
from grading.handout import FUNCTIONS, highest, SUITES
from grading.outcomes import FAILED, FAULT, Outcome, PASSED, WAITING


def grade(outcomes: dict[str, Outcome]) -> dict:
    """Return the grade of outcomes (by the names of the checks) for a gradebook.

    It is {"tiers": {tier: {"passed", "waiting", "failed", "points", "of"}}, "grade", "next"},
    without the tiers that have no outcomes. The grade is the highest complete tier, with all tiers
    below it complete, or None.
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
    return {"tiers": tiers, "grade": highest(points, most), "next": next_step(outcomes)}


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


def unwritten_functions(outcomes: dict[str, Outcome]) -> dict[str, str]:
    """Return the places of the functions that are not written yet."""
    places = {}
    for check in checks_with_outcome(outcomes):
        if outcomes[check.name].is_unwritten:
            places[check.function] = outcomes[check.name].place
    return places


def next_step(outcomes: dict[str, Outcome]) -> str:
    """Return the next step.

    It is a file that Python cannot read, else the first function with a mistake, else the first
    that is not written.
    """
    for check in failed_checks(outcomes):
        return place_of_failure(check, outcomes[check.name])
    for function, place in unwritten_functions(outcomes).items():
        return f"{function} in {place}"
    for check in checks_with_outcome(outcomes):
        outcome = outcomes[check.name]
        if outcome.state == WAITING:
            return f"{outcome.waits_for}, which {check.function} waits for"
    for tier in SUITES:
        if any(check.name not in outcomes for check in checks(tier=tier)):
            name = tier.split()[0]
            return f"run the checks of tier {name}: pytest --tier {name}"
    return "all functions with a check are right"


def place_of_failure(check: Check, outcome: Outcome) -> str:
    """Return where the mistake is for which a check fails."""
    if outcome.state == FAULT:
        return f"show your teacher the grader's fault in {check.name}"
    if outcome.broken_file:
        return outcome.place
    return f"{check.function} in {outcome.place or FUNCTIONS[check.function].file}"
