"""The grade from the outcomes of the checks, and the next step. screen.py shows both."""

from collections import Counter

from grading.assignment import HONOR, SUITES
from grading.checks import Check
from grading.outcomes import FAILED, FAULT, Outcome, PASSED, WAITING


class Results:
    """The outcomes of the checks that ran, by their names, and what follows from them."""

    def __init__(self, checks: dict[str, Check], outcomes: dict[str, Outcome]) -> None:
        """checks are those of all suites, in the order of the handout."""
        self.checks = checks
        self.outcomes = outcomes

    @property
    def ran(self) -> list[tuple[Check, Outcome]]:
        """The checks that have an outcome, in the order of the handout."""
        outcomes = self.outcomes
        return [(check, outcomes[name]) for name, check in self.checks.items() if name in outcomes]

    @property
    def is_whole(self) -> bool:
        """Whether all checks ran."""
        return len(self.ran) == len(self.checks)

    def grade(self) -> dict:
        """Return the grade for a gradebook.

        It is {"tiers": {tier: {"waiting", "failed", "points", "of"}}, "grade", "next"}, without the
        tiers that have no outcomes. The grade is the highest complete tier, with all tiers below it
        complete, or None.
        """
        tiers = {}
        grade = None
        are_complete = True  # this tier, and all below it
        of = Counter(check.tier for check in self.checks.values())
        for tier in SUITES:
            states = Counter(outcome.state for check, outcome in self.ran if check.tier == tier)
            are_complete = are_complete and states[PASSED] == of[tier]
            if are_complete:
                grade = tier
            if states:
                tiers[tier] = {
                    "waiting": states[WAITING],
                    "failed": states[FAILED] + states[FAULT],
                    "points": states[PASSED],
                    "of": of[tier],
                }
        return {"tiers": tiers, "grade": grade, "next": self.next_step()}

    def missing_for_a_letter(self, tiers: dict[str, dict]) -> str:
        """Return what the first tier lacks that is not complete, or "": the honor roll is extra."""
        for tier, counts in tiers.items():
            missing = counts["of"] - counts["points"]
            if missing and tier != HONOR:
                wrong = [check for check, outcome in self.ran if outcome.state != PASSED]
                names = {check.function: None for check in wrong if check.tier == tier}
                named = " and ".join(names) if len(names) < 3 else f"{len(names)} functions"
                return f"For {tier}: {named}, {missing} of {counts['of']} points missing."
        return ""

    def failed(self) -> list[tuple[Check, Outcome]]:
        """Return the checks that fail, those first whose file cannot be imported."""
        failed = [pair for pair in self.ran if pair[1].state in (FAILED, FAULT)]
        return sorted(failed, key=lambda pair: not pair[1].broken_file)

    def unwritten(self) -> dict[str, str]:
        """Return the places of the functions that are not written yet."""
        return {
            check.function: outcome.place for check, outcome in self.ran if outcome.is_unwritten
        }

    def next_step(self) -> str:
        """Return the next step for the checks that ran, or "".

        It is a file that Python cannot read, else the first function with a mistake, else the first
        that is not written.
        """
        for check, outcome in self.failed():
            return place_of_failure(check, outcome)
        for function, place in self.unwritten().items():
            return f"{function} in {place}"
        return ""


def place_of_failure(check: Check, outcome: Outcome) -> str:
    """Return where the mistake is for which a check fails."""
    if outcome.state == FAULT:
        return f"show your teacher the grader's fault in {check.name}"
    if outcome.broken_file:
        return outcome.place
    return f"{check.function} in {outcome.place}"
