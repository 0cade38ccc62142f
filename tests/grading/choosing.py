"""The choice of the hint for a mistake: from what is seen and proved, in one order."""

import re

from grading.handout import FUNCTIONS
from grading.hints import FORMS
from grading.raised import StoppedError
from grading.students_code import Code


def hint_for(error: StoppedError | None, result: str, wrong: str, code: Code, function: str) -> str:
    """Return the hint for a mistake: from the first evidence that there is.

    error is the StoppedError of the function, or None. result is the hint for its exact result, or
    "", and wrong is the sentence that says what is wrong. code is the function's.

    A file that does not compile and a function that is not written never get here: grader.run
    answers them.
    """
    hints = [
        of_parameters(code.parameters, function, error),  # the check's own call does not fit
        error.hint if error else "",  # the type of Python's error, its text, the tree of the line
        result,  # the exact result of a known mistake
        error.meaning if error else "",
        of_sentence(wrong),
    ]
    return next(filter(None, hints), "")


def of_sentence(wrong: str) -> str:
    """Return the hint for the sentence that says what is wrong, or ""."""
    for pattern, hint in FORMS.values():
        if re.search(pattern, wrong):
            return hint
    return ""


def of_parameters(parameters: str, function: str, error: StoppedError | None) -> str:
    """Return the hint for a line def that has other parameters than the handout, or ""."""
    found = parameters.split(", ")
    expected = FUNCTIONS[function].parameters.split(", ")
    is_moved = sorted(found) == sorted(expected) and found != expected
    if is_moved or (error and is_refused_call(error, function)):
        return f"The line def has changed. It must be: def {function}({', '.join(expected)}):"
    return ""


def is_refused_call(error: StoppedError, function: str) -> bool:
    """Return whether Python did not even begin the call of a function."""
    is_about_call = error.kind == "TypeError" and f"{function}()" in (error.text or "")
    return is_about_call and not error.places
