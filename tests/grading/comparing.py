"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

from collections.abc import Iterable
from math import isclose
from numbers import Real
from typing import Any, NamedTuple

from vpython import vector

from grading.messages import about, Expected
from grading.subject import Each, NOTHING, RESULT, Subject, What
from line_by_line.words import form_of, number_of, plural, text_of

NOT_CALLED = "A name without ( ) is the function itself, and not what a call of it gives."
LONG = 60  # characters; of a longer list, a message shows only the first difference

# Errors of a check that reads a value of the wrong form.
OTHER_FORM = (
    TypeError,
    ValueError,
    KeyError,
    IndexError,
    AttributeError,
    ArithmeticError,
    RecursionError,
)


class Mistake(NamedTuple):
    """What is wrong with a value."""

    sentence: str
    subject: Subject
    hint: str = ""  # about its form


def fits(found: Any, expected: Any) -> bool:
    """Return whether found is right; expected is a value, an Expected, or a test of a value."""
    try:
        return bool(expected(found)) if callable(expected) else same(found, expected)
    except OTHER_FORM:
        return False


def same(found: Any, expected: Any) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0."""
    if isinstance(expected, Expected):
        return bool(expected.test(found))
    if isinstance(expected, vector):
        return isinstance(found, vector) and same(found.value, expected.value)
    if isinstance(expected, dict):
        if not isinstance(found, dict) or found.keys() != expected.keys():
            return False
        return all(same(found[key], expected[key]) for key in expected)
    if isinstance(expected, (list, tuple)):
        form = list if isinstance(expected, list) else tuple
        if not isinstance(found, form) or len(found) != len(expected):
            return False
        return all(same(*pair) for pair in zip(found, expected, strict=True))
    if isinstance(expected, Real):
        return isinstance(found, Real) and isclose(found, expected, rel_tol=1e-6, abs_tol=1e-9)
    return isinstance(found, type(expected)) and bool(found == expected)


def hint_for_result(found: Any, expected: Any, results: Iterable[tuple[Any, str]]) -> str:
    """Return the hint of the wrong results that fit, or "".

    results are pairs of a wrong result, or a test of it, and a hint. If two hints fit, nobody knows
    which mistake it was. If none fits, each part of a tuple may have its own one; the sentence is
    about the first wrong part.
    """
    results = [*results]
    hints = {hint for mistaken, hint in results if fits(found, mistaken)}
    if hints or not are_alike(found, expected):
        return hints.pop() if len(hints) == 1 else ""
    known = []
    for i, part in enumerate(expected):
        if not same(found[i], part):
            of_part = hints_for_part(i, found, expected, results)
            known.append(of_part.pop() if len(of_part) == 1 else "")
    return " ".join(filter(None, known)) if known and known[0] else ""


def are_alike(found: Any, expected: Any) -> bool:
    """Return whether both are tuples with the same number of parts."""
    is_tuple = isinstance(found, tuple) and isinstance(expected, tuple)
    return is_tuple and len(found) == len(expected)


def hints_for_part(
    i: int, found: tuple, expected: tuple, results: Iterable[tuple[Any, str]]
) -> set[str]:
    """Return the hints of the wrong results in which only this part is wrong, as it was found."""
    hints = set()
    for mistaken, hint in results:
        if isinstance(mistaken, tuple) and same(
            (*expected[:i], found[i], *expected[i + 1 :]), mistaken
        ):
            hints.add(hint)
    return hints


def is_exchanged(found: Any, expected: Any) -> bool:
    """Return whether a tuple has the expected values in another order."""
    if not are_alike(found, expected):
        return False
    left = [*found]
    for value in expected:
        equal = [i for i, element in enumerate(left) if same(element, value)]
        if not equal:
            return False
        left.pop(equal[0])
    return True


def both(what: What | None, found: Any, expected: Any) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message, each value behind its name.

    For long lists, these are the lines of the first wrong element.
    """
    name = f"{what or ''}"
    if isinstance(found, list) and isinstance(expected, list):
        if len(found) != len(expected):
            if are_pendula(expected):
                texts = [[f"a list of {number_of(value)}"] for value in (found, expected)]
                return [*zip(("came back", "expected"), texts, strict=True)]
        elif isinstance(expected[0], dict) or is_long(found) or is_long(expected):
            i = first_difference(found, expected)
            name = f"{name} at index {i}".lstrip()
            found = found[i]
            expected = expected[i]
    digits = digits_of(found, expected)
    return [("came back", about(name, found, digits)), ("expected", about(name, expected, digits))]


def is_long(value: Any) -> bool:
    """Return whether a message has no room for a whole list."""
    return len(text_of(value)) > LONG


def first_difference(found: list | tuple, expected: list | tuple) -> int:
    """Return the index of the first wrong element of a list or a tuple of the right length."""
    return [same(*pair) for pair in zip(found, expected, strict=True)].index(False)


def are_pendula(value: Any) -> bool:
    """Return whether a value is a list of dictionaries."""
    if not isinstance(value, list) or not value:
        return False
    return all(isinstance(element, dict) for element in value)


def mistake_in(what: What, found: Any, expected: Any) -> Mistake:
    """Return the first mistake in found."""
    subject = what if isinstance(what, Subject) else Subject(is_result=f"{what}" == RESULT)
    like = expected.like if isinstance(expected, Expected) else expected
    if like is not None and form_of(found) != form_of(like):
        sentence = f"{what} is {form_of(found)}, not {form_of(like)}."
        return Mistake(sentence, subject, NOT_CALLED if callable(found) else "")
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        whole = Subject(owner=what.owner) if isinstance(what, Each) else what
        elements = plural(len(found), "element", "elements")
        return Mistake(f"{whole} has {elements}, not {len(like)}.", subject)
    if isinstance(expected, dict) and found.keys() != expected.keys():
        missing = expected.keys() - found.keys()
        if missing:
            return Mistake(f"{what} has no key {min(map(text_of, missing))}.", subject)
        others = found.keys() - expected.keys()
        return Mistake(f"{what} has the key {min(map(text_of, others))}, too.", subject)
    for part, found_part, expected_part in parts_in(what, found, expected):
        if not fits(found_part, expected_part):
            return mistake_in(part, found_part, expected_part)
    return Mistake(f"{what} is {difference(found, expected)}.", subject)


def parts_in(what: What, found: Any, expected: Any) -> list[tuple[What, Any, Any]]:
    """Return what each part of a value is, its value that was found, and the expected one."""
    if isinstance(expected, dict):
        whole = what if isinstance(what, Subject) else NOTHING
        return [(whole.value(key), found[key], expected[key]) for key in expected]
    if isinstance(expected, Expected) and isinstance(expected.like, list):
        elements = [with_form_of(example) for example in expected.like]
    elif isinstance(expected, (list, tuple)):
        elements = [*expected]
    else:
        return []
    return [(what.element(i), found[i], element) for i, element in enumerate(elements)]


def with_form_of(example: Any) -> Expected:
    """Return the expectation of a value with the form of an example."""
    return Expected("", lambda found: form_of(found) == form_of(example), like=example)


def difference(found: Any, expected: Any) -> str:
    """Return what a value is, and what it must be."""
    digits = digits_of(found, expected)
    if not isinstance(expected, Expected):
        if isinstance(found, (Real, str, vector)):
            return f"{text_of(found, digits)}, not {text_of(expected, digits)}"
        return "wrong"
    if isinstance(found, Real) and not isinstance(found, bool):
        return f"{text_of(found, digits)}, not {expected.text}"
    return f"not {expected.text}" if expected.text else "wrong"


def digits_of(found: Any, expected: Any) -> int:
    """Return how many digits show that both values differ."""
    return 6 if text_of(found) != text_of(expected) else 15
