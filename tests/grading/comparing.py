"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

from collections.abc import Iterable
from math import isclose
from numbers import Real
from typing import Any, NamedTuple

from vpython import vector

from grading.messages import about, form_of, plural, text_of, Wanted
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


class Part(NamedTuple):
    """A part of a value: its name, the value of it that was found, and the expected one."""

    name: str
    found: Any
    wanted: Any


def fits(found: Any, wanted: Any) -> bool:
    """Return whether found is right; wanted is a value, a Wanted, or a test of a value."""
    try:
        return bool(wanted(found)) if callable(wanted) else same(found, wanted)
    except OTHER_FORM:
        return False


def same(found: Any, wanted: Any) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0."""
    if isinstance(wanted, Wanted):
        return bool(wanted.test(found))
    if isinstance(wanted, vector):
        return isinstance(found, vector) and same(found.value, wanted.value)
    if isinstance(wanted, dict):
        if not isinstance(found, dict) or found.keys() != wanted.keys():
            return False
        return all(same(found[key], wanted[key]) for key in wanted)
    if isinstance(wanted, (list, tuple)):
        form = list if isinstance(wanted, list) else tuple
        if not isinstance(found, form) or len(found) != len(wanted):
            return False
        return all(same(*pair) for pair in zip(found, wanted, strict=True))
    if isinstance(wanted, Real):
        return isinstance(found, Real) and isclose(found, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return isinstance(found, type(wanted)) and bool(found == wanted)


def hint_for_result(found: Any, results: Iterable[tuple[Any, str]]) -> str:
    """Return the hint of the wrong results that fit, or "".

    results are pairs of a wrong result, or a test of it, and a hint. If two hints fit, nobody knows
    which mistake it was.
    """
    hints = {hint for mistaken, hint in results if fits(found, mistaken)}
    return hints.pop() if len(hints) == 1 else ""


def is_exchanged(found: Any, wanted: Any) -> bool:
    """Return whether a tuple has the expected values in another order."""
    if not isinstance(found, tuple) or not isinstance(wanted, tuple) or len(found) != len(wanted):
        return False
    left = [*found]
    for value in wanted:
        equal = [i for i, element in enumerate(left) if same(element, value)]
        if not equal:
            return False
        left.pop(equal[0])
    return True


def both(what: str, found: Any, wanted: Any) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message.

    For long lists, these are the lines of the first wrong element.
    """
    digits = digits_of(found, wanted)
    if isinstance(found, list) and isinstance(wanted, list):
        if len(found) != len(wanted):
            if are_pendula(wanted):
                return [("came back", [number_of(found)]), ("expected", [number_of(wanted)])]
        elif isinstance(wanted[0], dict) or is_long(found) or is_long(wanted):
            i = first_difference(found, wanted)
            what = f"{what} at index {i}".lstrip()
            found = found[i]
            wanted = wanted[i]
    return [("came back", about(what, found, digits)), ("expected", about(what, wanted, digits))]


def is_long(value: Any) -> bool:
    """Return whether a message has no room for a whole list."""
    return len(text_of(value)) > LONG


def first_difference(found: list, wanted: list) -> int:
    """Return the index of the first wrong element of a list."""
    return [same(*pair) for pair in zip(found, wanted, strict=True)].index(False)


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


def mistake_in(what: str, found: Any, wanted: Any, is_result: bool = False) -> Mistake:
    """Return the first mistake in found.

    what is its name or, with commas, the names of the parts of a tuple; is_result says whether it
    is the whole result.
    """
    whole = whole_of(what, is_result)
    subject = subject_of(whole)
    like = wanted.like if isinstance(wanted, Wanted) else wanted
    if wanted is True and isinstance(found, bool):
        return Mistake(f"It is not true {what}.", NOTHING)
    if like is not None and form_of(found) != form_of(like):
        sentence = f"{whole} {verb_of(whole)} {form_of(found)}, not {form_of(like)}."
        return Mistake(sentence, subject)
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        whole = list_of(what, is_result)
        has = "have" if verb_of(whole) == "are" else "has"
        elements = plural(len(found), "element", "elements")
        return Mistake(f"{whole} {has} {elements}, not {len(like)}.", subject_of(whole))
    if isinstance(wanted, dict) and found.keys() != wanted.keys():
        missing = wanted.keys() - found.keys()
        if missing:
            sentence = f"{what} misses the key {min(map(text_of, missing))}."
        else:
            others = found.keys() - wanted.keys()
            sentence = f"{what} must not have the key {min(map(text_of, others))}."
        return Mistake(sentence, subject_of(what, has_wrong_keys=True))
    for part in parts_in(what, found, wanted):
        if not fits(part.found, part.wanted):
            return mistake_in(part.name, part.found, part.wanted)
    return Mistake(f"{whole} {verb_of(whole)} {difference(found, wanted)}.", subject)


def parts_in(what: str, found: Any, wanted: Any) -> list[Part]:
    """Return the parts of a value, none if it has none."""
    if isinstance(wanted, dict):
        return [Part(f"{key} of {what}", found[key], wanted[key]) for key in wanted]
    if isinstance(wanted, Wanted) and isinstance(wanted.like, list):
        elements = [with_form_of(example) for example in wanted.like]
    elif isinstance(wanted, (list, tuple)):
        elements = [*wanted]
    else:
        return []
    names = parts_of(what, len(elements))
    return [Part(*part) for part in zip(names, found, elements, strict=True)]


def with_form_of(example: Any) -> Wanted:
    """Return the expectation of a value with the form of an example."""
    return Wanted("", lambda found: form_of(found) == form_of(example), like=example)


def difference(found: Any, wanted: Any) -> str:
    """Return what a value is, and what it must be."""
    digits = digits_of(found, wanted)
    if not isinstance(wanted, Wanted):
        if isinstance(found, (Real, str, vector)):
            return f"{text_of(found, digits)}, not {text_of(wanted, digits)}"
        return "wrong"
    if isinstance(found, Real) and not isinstance(found, bool):
        return f"{text_of(found, digits)}, not {wanted.text}"
    return f"not {wanted.text}" if wanted.text else "wrong"


def digits_of(found: Any, wanted: Any) -> int:
    """Return how many digits show that both values differ."""
    return 6 if text_of(found) != text_of(wanted) else 15
