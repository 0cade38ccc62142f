"""The outcomes of the checks, judged once each, in the order in which functions need others.

pytest_grader.py asks for them in pytest, and grade.py makes a grade of them.
"""

import traceback
from errno import ENOSPC
from textwrap import wrap
from typing import Any, NamedTuple

from grading.failure import ask, tell, what_is_wrong
from grading.grader import Check, checks, WaitError, WrongError
from grading.handout import FUNCTIONS, needed
from grading.messages import error_lines
from grading.present import present
from grading.raised import StoppedError
from grading.room import Part, Rank
from grading.students_code import Code, code_of
from line_by_line.layout import COLUMNS

PASSED, WAITING, FAILED, FAULT = "passed", "waiting", "failed", "fault"


class Outcome(NamedTuple):
    """The outcome of a check."""

    state: str
    message: str = ""
    # A file of the student's, and a line of it if one is certain: where the function is not
    # written yet, or is wrong
    place: str = ""
    advice: str = ""  # about a right solution
    waits_for: str = ""  # the functions, or the file, that are wrong
    broken_file: str = ""  # that Python cannot read, so that the check fails
    hint: str = ""
    parts: list[Part] = []  # of the screen

    def plain(self) -> dict:
        """Return it as a dictionary that another process can get; from_plain makes it again."""
        parts = [[int(rank), *others] for rank, *others in self.parts]
        return {**self._asdict(), "parts": parts}

    @classmethod
    def from_plain(cls, fields: Any) -> "Outcome":
        return cls(**{**fields, "parts": [Part(*part) for part in fields["parts"]]})

    @property
    def is_unwritten(self) -> bool:
        return self.state == WAITING and bool(self.place)

    @property
    def is_wrong(self) -> bool:
        """Whether the function has a mistake of its own, and not its file."""
        return self.state in (FAILED, FAULT) and not self.broken_file


def waiting(cause: str, place: str = "") -> Outcome:
    """Return the outcome of a check that waits for this cause."""
    return Outcome(WAITING, f"waits for {cause}", place=place, waits_for=cause)


class Grading:
    """The outcomes of the checks. Each check is judged once."""

    def __init__(self) -> None:
        self.outcomes: dict[str, Outcome] = {}  # by the name of the check
        self.missing: dict[str, Outcome | None] = {}  # see missing_outcome, by the function
        self.hung: set[str] = set()  # functions that went over a limit: they are not called again
        # Files that cannot be imported, and the file that is the cause
        self.broken: dict[str, str] = {}

    def judge(self, check: Check) -> Outcome:
        """Return the outcome of a check. It waits if its function uses a function that is wrong."""
        # In their order: the first one that fails has the hint
        for other in checks(function=check.function):
            if other.name not in self.outcomes:
                self.outcomes[other.name] = self.outcome_of(other)
            if other.name == check.name:
                break
        return self.outcomes[check.name]

    def outcome_of(self, check: Check) -> Outcome:
        """Return the outcome of a check that was not performed yet."""
        causes = [name for name in needed(check.function) if self.is_not_right(name)]
        if not causes:
            return waiting(check.function) if check.function in self.hung else self.perform(check)
        return self.missing_outcome(check.function) or waiting(", ".join(causes))

    def missing_outcome(self, function: str) -> Outcome | None:
        """Return the outcome if a function is not written, or its file cannot be imported.

        Its first check finds this out, once; but not after a function went over a limit.
        """
        if self.hung:
            return None
        if function not in self.missing:
            outcome = self.perform(checks(function=function)[0])
            waits_for_file = outcome.waits_for in self.broken.values()
            is_missing = outcome.is_unwritten or outcome.broken_file or waits_for_file
            self.missing[function] = outcome if is_missing else None
        return self.missing[function]

    def is_not_right(self, function: str) -> bool:
        """Return whether the function is not written, or one of its own checks fails."""
        outcomes = [self.judge(check) for check in checks(function=function)]
        return any(outcome.is_unwritten or outcome.is_wrong for outcome in outcomes)

    def perform(self, check: Check) -> Outcome:
        """Perform a check, and return its outcome."""
        file = FUNCTIONS[check.function].file
        if file in self.broken:
            return waiting(self.broken[file])
        try:
            return self.performed(check)
        except BaseException as error:
            is_full = getattr(error, "errno", 0) == ENOSPC
            if present.is_pressed or present.is_debugged or is_full:
                raise
            return Outcome(FAULT, fault_message())

    def performed(self, check: Check) -> Outcome:
        """Return the outcome of a check that is performed now. Faults of the grader pass."""
        try:
            ask(check)
        except WrongError as error:
            return self.failed(check, error)
        except WaitError as error:
            if error.raised:
                return self.broken_by(check, f"{error}", error.raised)
            return waiting(str(error), error.place)
        return Outcome(PASSED, advice=" ".join(present.advice))

    def failed(self, check: Check, error: WrongError) -> Outcome:
        """Return the outcome of a check that raised this WrongError.

        The first one of a function has a hint and a trace table.
        """
        function = check.function
        code = code_of(function)
        if error.raised and error.raised.limit:
            self.hung.add(function)
        causes = self.wrong_functions_in(code, function)
        if causes:
            return waiting(", ".join(causes))
        if not self.is_first_failure(check):
            message = "\n".join(what_is_wrong(error, ""))
            return Outcome(FAILED, message, place=FUNCTIONS[function].file)
        told = tell(check, error, code)
        message = "\n".join(told.wrong)
        place = told.place or FUNCTIONS[function].file
        return Outcome(FAILED, message, place=place, hint=told.hint, parts=told.parts)

    def wrong_functions_in(self, code: Code, function: str) -> list[str]:
        """Return the wrong functions that a student uses and the handout does not ask for."""
        functions = [*FUNCTIONS]
        earlier = functions[: functions.index(function)]
        wrong = []
        for name in code.names:
            if name in earlier and not self.hung and self.is_not_right(name):
                wrong.append(name)
        return wrong

    def is_first_failure(self, check: Check) -> bool:
        """Return whether no other check of the same function has failed."""
        for other in checks(function=check.function):
            if other.name in self.outcomes and self.outcomes[other.name].state == FAILED:
                return False
        return True

    def broken_by(self, check: Check, file: str, raised: StoppedError) -> Outcome:
        """Return the outcome of a check whose file cannot be imported.

        The first one fails, and the others wait.
        """
        is_first = file not in self.broken.values()
        self.broken[FUNCTIONS[check.function].file] = file
        if not is_first:
            return waiting(file)
        hint = raised.hint
        wrong = f"This file {raised.limit}." if raised.limit else error_lines(raised)[0]
        where = file
        code = []
        outside = [place for place in raised.places if place.is_outside]
        if outside:
            in_file = [place for place in outside if place.file == file] or outside
            where = f"{in_file[-1]}"
            code = raised.code or [f"    {in_file[-1].code}"]
            if outside[-1] is not raised.places[-1]:
                hint = (
                    "This line stands outside of all functions, so it runs whenever Python reads "
                    "the file. Remove it, or put it below if __name__ == '__main__'."
                )
        lines = [f"{where}:", *code, *wrap(wrong, COLUMNS), *wrap(hint, COLUMNS)]
        parts = [Part(Rank.ALWAYS, lines[1:])]
        message = "\n".join(lines)
        return Outcome(FAILED, message, place=where, broken_file=file, hint=hint, parts=parts)


def fault_message() -> str:
    """Return the message for an error of the grader, which is handled now."""
    lines = [
        "This is a fault of the grader, not of your code. Please show it to your teacher.",
        traceback.format_exc(limit=-3).rstrip(),
    ]
    return "\n".join(lines)
