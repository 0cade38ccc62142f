"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

from collections.abc import Iterable
from math import isclose
from numbers import Real
from typing import Any, NamedTuple

from vpython import vector

from grading.messages import about, Expected, form_of, plural, text_of
from grading.subject import list_of, NOTHING, parts_of, Subject, subject_of, verb_of, whole_of

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


class ValuePart(NamedTuple):
    """A part of a value: its name, the value of it that was found, and the expected one."""

    name: str
    found: Any
    expected: Any


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


def hint_for_result(found: Any, results: Iterable[tuple[Any, str]]) -> str:
    """Return the hint of the wrong results that fit, or "".

    results are pairs of a wrong result, or a test of it, and a hint. If two hints fit, nobody knows
    which mistake it was.
    """
    hints = {hint for mistaken, hint in results if fits(found, mistaken)}
    return hints.pop() if len(hints) == 1 else ""


def is_exchanged(found: Any, expected: Any) -> bool:
    """Return whether a tuple has the expected values in another order."""
    if (
        not isinstance(found, tuple)
        or not isinstance(expected, tuple)
        or len(found) != len(expected)
    ):
        return False
    left = [*found]
    for value in expected:
        equal = [i for i, element in enumerate(left) if same(element, value)]
        if not equal:
            return False
        left.pop(equal[0])
    return True


def both(what: str, found: Any, expected: Any) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message.

    For long lists, these are the lines of the first wrong element.
    """
    digits = digits_of(found, expected)
    if isinstance(found, list) and isinstance(expected, list):
        if len(found) != len(expected):
            if are_pendula(expected):
                return [("came back", [number_of(found)]), ("expected", [number_of(expected)])]
        elif isinstance(expected[0], dict) or is_long(found) or is_long(expected):
            i = first_difference(found, expected)
            what = f"{what} at index {i}".lstrip()
            found = found[i]
            expected = expected[i]
    return [("came back", about(what, found, digits)), ("expected", about(what, expected, digits))]


def is_long(value: Any) -> bool:
    """Return whether a message has no room for a whole list."""
    return len(text_of(value)) > LONG


def first_difference(found: list, expected: list) -> int:
    """Return the index of the first wrong element of a list."""
    return [same(*pair) for pair in zip(found, expected, strict=True)].index(False)


def are_pendula(value: Any) -> bool:
    """Return whether a value is a list of dictionaries."""
    if not isinstance(value, list) or not value:
        return False
    return all(isinstance(element, dict) for element in value)


def number_of(value: list) -> str:
    """Return how many elements a list has, as text."""
    if are_pendula(value):
        return f"a list of {plural(len(value), 'pendulum', 'pendula')}"
    return f"a list of {plural(len(value), 'element', 'elements')}"


def mistake_in(what: str, found: Any, expected: Any, is_result: bool = False) -> Mistake:
    """Return the first mistake in found.

    what is its name or, with commas, the names of the parts of a tuple; is_result says whether it
    is the whole result.
    """
    whole = whole_of(what, is_result)
    subject = subject_of(whole)
    like = expected.like if isinstance(expected, Expected) else expected
    if expected is True and isinstance(found, bool):
        return Mistake(f"It is not true {what}.", NOTHING)
    if like is not None and form_of(found) != form_of(like):
        sentence = f"{whole} {verb_of(whole)} {form_of(found)}, not {form_of(like)}."
        return Mistake(sentence, subject)
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        whole = list_of(what, is_result)
        has = "have" if verb_of(whole) == "are" else "has"
        elements = plural(len(found), "element", "elements")
        return Mistake(f"{whole} {has} {elements}, not {len(like)}.", subject_of(whole))
    if isinstance(expected, dict) and found.keys() != expected.keys():
        missing = expected.keys() - found.keys()
        if missing:
            sentence = f"{what} misses the key {min(map(text_of, missing))}."
        else:
            others = found.keys() - expected.keys()
            sentence = f"{what} must not have the key {min(map(text_of, others))}."
        return Mistake(sentence, subject_of(what, has_wrong_keys=True))
    for part in parts_in(what, found, expected):
        if not fits(part.found, part.expected):
            return mistake_in(part.name, part.found, part.expected)
    return Mistake(f"{whole} {verb_of(whole)} {difference(found, expected)}.", subject)


def parts_in(what: str, found: Any, expected: Any) -> list[ValuePart]:
    """Return the parts of a value, none if it has none."""
    if isinstance(expected, dict):
        return [ValuePart(f"{key} of {what}", found[key], expected[key]) for key in expected]
    if isinstance(expected, Expected) and isinstance(expected.like, list):
        elements = [with_form_of(example) for example in expected.like]
    elif isinstance(expected, (list, tuple)):
        elements = [*expected]
    else:
        return []
    names = parts_of(what, len(elements))
    return [ValuePart(*part) for part in zip(names, found, elements, strict=True)]


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
