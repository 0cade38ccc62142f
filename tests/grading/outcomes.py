"""The outcomes of the checks, judged once each, in the order in which functions need others.

pytest_grader.py asks for them in pytest, and grade.py makes a grade of them.
"""

import traceback
from textwrap import wrap
from typing import NamedTuple

from grading.assignment import FUNCTIONS, needed
from grading.checks import Check
from grading.explanation import explain, Explanation, what_is_wrong
from grading.grader import Grader, NOT_CALLED, WaitError, WrongError
from grading.raised import StoppedError
from line_by_line.table import COLUMNS

PASSED, WAITING, FAILED, FAULT = "passed", "waiting", "failed", "fault"
FAULT_OF_GRADER = "This is a fault of the grader, not of your code. Please show it to your teacher."


class Outcome(NamedTuple):
    """The outcome of a check."""

    state: str
    message: str = ""
    # A file of the student's, and the line at which Python stopped: where the function is not
    # written yet, or is wrong
    place: str = ""
    waits_for: str = ""  # the functions, or the file, that are wrong
    broken_file: str = ""  # that Python cannot read, so that the check fails
    explanation: Explanation = Explanation([])

    @property
    def is_unwritten(self) -> bool:
        return self.state == WAITING and bool(self.place)


def waiting(cause: str, place: str = "") -> Outcome:
    """Return the outcome of a check that waits for this cause."""
    return Outcome(WAITING, f"waits for {cause}", place=place, waits_for=cause)


class Grading:
    """The outcomes of the checks. Each check is judged once."""

    def __init__(self, grader: Grader) -> None:
        self.grader = grader
        self.outcomes: dict[str, Outcome] = {}  # by the name of the check
        # What all further checks of a function have: one with stand-ins decides about all, and a
        # function that went over a limit is not called again
        self.decided: dict[str, Outcome] = {}
        self.explained: set[str] = set()  # functions whose first mistake has its explanation
        # Files that cannot be imported, and the file that is the cause
        self.broken: dict[str, str] = {}

    def judge(self, check: Check) -> Outcome:
        """Return the outcome of a check."""
        # In their order: the first one that fails has the explanation
        for other in self.grader.checks_of(check.function):
            if other.name not in self.outcomes:
                self.outcomes[other.name] = self.outcome_of(other)
            if other is check:
                break
        return self.outcomes[check.name]

    def outcome_of(self, check: Check) -> Outcome:
        """Return the outcome of a check that was not performed yet.

        If its function needs some that are not right, it is the check with stand-ins for them.
        """
        function = check.function
        if function in self.decided:
            return self.decided[function]
        causes = [name for name in needed(function) if not self.is_right(name)]
        if not causes:
            return self.perform(check)
        outcome = self.perform(self.grader.alone[function])
        if outcome.waits_for == NOT_CALLED:
            outcome = waiting(", ".join(causes))
        is_told = outcome.state in (FAILED, FAULT)
        self.decided[function] = waiting(outcome.broken_file or function) if is_told else outcome
        return outcome

    def is_right(self, function: str) -> bool:
        """Return whether a function passes all its checks."""
        return all(self.judge(check).state == PASSED for check in self.grader.checks_of(function))

    def perform(self, check: Check) -> Outcome:
        """Perform a check, and return its outcome."""
        file = FUNCTIONS[check.function].file
        if file in self.broken:
            return waiting(self.broken[file])
        try:
            return self.performed(check)
        except BaseException:
            if self.grader.limits.is_pressed or self.grader.limits.is_debugged:
                raise
            text = traceback.format_exc(limit=-3).rstrip()
            return Outcome(FAULT, f"{FAULT_OF_GRADER}\n{text}")

    def performed(self, check: Check) -> Outcome:
        """Return the outcome of a check that is performed now. Faults of the grader pass."""
        try:
            self.grader.perform(check)
        except WrongError as error:
            return self.failed(check, error)
        except WaitError as error:
            if error.raised:
                return self.broken_by(check, f"{error}", error.raised)
            return waiting(str(error), error.place)
        return Outcome(PASSED)

    def failed(self, check: Check, error: WrongError) -> Outcome:
        """Return the outcome of a check that raised this WrongError.

        The first one of a function has a hint and a table.
        """
        function = check.function
        if error.raised and error.raised.limit:
            self.decided[function] = waiting(function)
        explanation = Explanation(what_is_wrong(error, ""))
        if function not in self.explained:
            self.explained.add(function)
            explanation = explain(self.grader, check, error)
        place = explanation.place or FUNCTIONS[function].file
        return Outcome(FAILED, "\n".join(explanation.wrong), place=place, explanation=explanation)

    def broken_by(self, check: Check, file: str, raised: StoppedError) -> Outcome:
        """Return the outcome of a check whose file cannot be imported.

        The first one fails, and the others wait. If the cause is another file of the assignment,
        this one is imported without it.
        """
        own_file = FUNCTIONS[check.function].file
        is_of_assignment = any(function.file == file for function in FUNCTIONS.values())
        if is_of_assignment and file != own_file and self.grader.code.replace(file):
            return self.perform(check)
        self.grader.code.replace(own_file)
        is_first = file not in self.broken.values()
        self.broken[own_file] = file
        if not is_first:
            return waiting(file)
        hint = raised.hint
        wrong = f"This file {raised.limit}." if raised.limit else raised.text
        where = file
        code = []
        outside = [place for place in raised.places if place.is_outside]
        if outside:
            in_file = [place for place in outside if place.file == file] or outside
            where = f"{in_file[-1]}"
            code = f"    {in_file[-1].code}".split("\n")
            if outside[-1] is not raised.places[-1]:
                hint = (
                    "This line stands outside of all functions, so it runs whenever Python reads "
                    "the file. Remove it."
                )
        lines = [*code, *wrap(wrong, COLUMNS), *wrap(hint, COLUMNS)]
        message = "\n".join([f"{where}:", *lines])
        return Outcome(
            FAILED, message, place=where, broken_file=file, explanation=Explanation(lines)
        )
