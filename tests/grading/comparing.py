"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

from collections.abc import Sequence
from math import isclose
from numbers import Real
from typing import Any, NamedTuple

from vpython import vector

from grading.messages import about, Expected
from grading.subject import Each, NOTHING, Subject, What
from grading.words import form_of, plural, text_of

NOT_CALLED = "A name without ( ) is the function itself, and not what a call of it gives."
LONG = 60  # characters; of a longer list, a message shows only the first difference


class Mistake(NamedTuple):
    """What is wrong with a value."""

    sentence: str
    subject: Subject = NOTHING
    hint: str = ""  # about its form
    found: Any = ...  # the part of the value that is wrong, if there is one


def fits(found: Any, expected: Any) -> bool:
    """Return whether found is right; expected is a value, an Expected, or a test of a value."""
    try:
        return bool(expected(found)) if callable(expected) else same(found, expected)
    except Exception:  # it has another form
        return False


def same(found: Any, expected: Any) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0."""
    if isinstance(expected, Expected):
        return bool(expected.test(found))
    if isinstance(expected, Real):
        return isinstance(found, Real) and isclose(found, expected, rel_tol=1e-6, abs_tol=1e-9)
    if not isinstance(found, type(expected)):
        return False
    if isinstance(expected, vector):
        return same(found.value, expected.value)
    if isinstance(expected, dict):
        are_keys = found.keys() == expected.keys()
        return are_keys and all(same(found[key], expected[key]) for key in expected)
    if isinstance(expected, (list, tuple)):
        return len(found) == len(expected) and all(map(same, found, expected))
    return bool(found == expected)


def hint_for_result(found: Any, expected: Any, results: Sequence[tuple[Any, str]]) -> str:
    """Return the hint of the wrong results that fit, or "".

    results are pairs of a wrong result, or a test of it, and a hint. If none fits, each part of a
    tuple may have its own one; the sentence is about the first wrong part.
    """
    hint = known_hint(found, results)
    if hint or not are_alike(found, expected):
        return hint
    hints = []
    for i, part in enumerate(expected):
        if not same(found[i], part):
            hint = known_hint((*expected[:i], found[i], *expected[i + 1 :]), results)
            if not hint:
                break
            hints.append(hint)
    return " ".join(hints)


def known_hint(found: Any, results: Sequence[tuple[Any, str]]) -> str:
    """Return the hint of the wrong results that fit, or "".

    If two hints fit, nobody knows which mistake it was.
    """
    hints = {hint for mistaken, hint in results if fits(found, mistaken)}
    return hints.pop() if len(hints) == 1 else ""


def are_alike(found: Any, expected: Any) -> bool:
    """Return whether both are tuples with the same number of parts."""
    is_tuple = isinstance(found, tuple) and isinstance(expected, tuple)
    return is_tuple and len(found) == len(expected)


def is_exchanged(found: Any, expected: Any) -> bool:
    """Return whether a tuple has the expected values in another order."""
    if not are_alike(found, expected):
        return False
    left = [*found]
    for value in expected:
        equal = [i for i, element in enumerate(left) if fits(element, value)]
        if not equal:
            return False
        left.pop(equal[0])
    return True


def both(what: What | None, found: Any, expected: Any) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message, each value behind its name.

    For long lists, these are the lines of the first wrong element.
    """
    name = f"{what or ''}"
    are_lists = isinstance(found, list) and isinstance(expected, list)
    is_long = max(len(text_of(found)), len(text_of(expected))) > LONG
    if are_lists and is_long and len(found) == len(expected):
        i = [*map(same, found, expected)].index(False)
        name = f"{name} at index {i}".lstrip()
        found = found[i]
        expected = expected[i]
    digits = digits_of(found, expected)
    return [("came back", about(name, found, digits)), ("expected", about(name, expected, digits))]


def mistake_in(what: Any, found: Any, expected: Any) -> Mistake:
    """Return the first mistake in a value. what is its subject."""
    subject = what if isinstance(what, Subject) else NOTHING
    like = expected.like if isinstance(expected, Expected) else expected
    if like is not None and form_of(found) != form_of(like):
        sentence = f"{what} is {form_of(found)}, not {form_of(like)}."
        return Mistake(sentence, subject, NOT_CALLED if callable(found) else "", found)
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        is_owner = isinstance(what, Each) and not what.name
        whole = Subject(owner=what.owner) if is_owner else what
        elements = plural(len(found), "element", "elements")
        return Mistake(f"{whole} has {elements}, not {len(like)}.", subject, found=found)
    if isinstance(expected, dict):
        for key in expected:
            if key not in found:
                return Mistake(f"{what} has no key {text_of(key)}.", subject)
        for key in found:
            if key not in expected:
                return Mistake(f"{what} has the key {text_of(key)}, too.", subject)
    for key, part in parts_of(what, expected):
        if not fits(found[key], expected[key]):
            return mistake_in(part, found[key], expected[key])
    return Mistake(f"{what} is {difference(found, expected)}.", subject, found=found)


def parts_of(what: Any, expected: Any) -> list[tuple[Any, Any]]:
    """Return the keys, or the indexes, of the parts of a value, and what each part is."""
    if isinstance(expected, dict):
        return [(key, what.value(key)) for key in expected]
    if isinstance(expected, (list, tuple)):
        return [(i, what.element(i)) for i in range(len(expected))]
    return []


def difference(found: Any, expected: Any) -> str:
    """Return what a value is, and what it must be."""
    digits = digits_of(found, expected)
    right = text_of(expected, digits)
    if isinstance(found, (Real, str, vector)):
        return f"{text_of(found, digits)}, not {right}"
    return f"not {right}" if isinstance(expected, Expected) else "wrong"


def digits_of(found: Any, expected: Any) -> int:
    """Return how many digits show that both values differ."""
    return 6 if text_of(found) != text_of(expected) else 15
