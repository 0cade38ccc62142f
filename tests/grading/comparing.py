"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

import re
from math import isclose
from numbers import Real

from vpython import vector

from grading.messages import about, form_of, shown, Wanted

LONG = 130  # characters; of a longer list, a message shows only the first difference

# Errors of a check that reads a value of the wrong form.
OTHER_FORM = (TypeError, ValueError, KeyError, IndexError, AttributeError, ArithmeticError, RecursionError)


def fits(found, wanted) -> bool:
    """Return whether found is right; wanted is a value, a Wanted, or a test of a value."""
    test = wanted.is_one if isinstance(wanted, Wanted) else wanted
    try:
        return bool(test(found)) if callable(test) else same(found, wanted)
    except OTHER_FORM:
        return False


def same(found, wanted) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0."""
    if isinstance(wanted, vector):
        return isinstance(found, vector) and same(found.value, wanted.value)
    if isinstance(wanted, dict):
        has_keys = isinstance(found, dict) and found.keys() == wanted.keys()
        return has_keys and all(same(found[key], wanted[key]) for key in wanted)
    if isinstance(wanted, (list, tuple)):
        is_row = isinstance(found, list if isinstance(wanted, list) else tuple) and len(found) == len(wanted)
        return is_row and all(same(*pair) for pair in zip(found, wanted, strict=True))
    if isinstance(wanted, Real):
        return isinstance(found, Real) and isclose(found, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return isinstance(found, type(wanted)) and bool(found == wanted)


def words_of(found, rows) -> str:
    """Return the words of the rows that fit a result, or "". If two of them do, nobody knows which one it was."""
    sentences = {sentence for mistaken, sentence in rows if fits(found, mistaken)}
    return sentences.pop() if len(sentences) == 1 else ""


def both(what, found, wanted) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message; for long lists, those of the first wrong element."""
    digits = digits_of(found, wanted)
    are_lists = isinstance(found, list) and isinstance(wanted, list) and len(found) == len(wanted)
    if are_lists and (isinstance(wanted[0], dict) or max(len(shown(found)), len(shown(wanted))) > LONG):
        i = [same(*pair) for pair in zip(found, wanted, strict=True)].index(False)
        what, found, wanted = f"{what} at index {i}".lstrip(), found[i], wanted[i]
    return [("came back", about(what, found, digits)), ("expected", about(what, wanted, digits))]


def mistake_in(what, found, wanted) -> str:
    """Return a sentence about the first mistake in found. what names it, or the parts of a tuple, with commas."""
    whole = "The result" if ", " in what else what
    are, have = ("are", "have") if re.match(r"ends |[^,]* and ", whole) else ("is", "has")
    like = wanted.like if isinstance(wanted, Wanted) else wanted
    if wanted is True and isinstance(found, bool):
        return f"It is not true {what}."
    if like is not None and form_of(found) != form_of(like):
        return f"{whole} {are} {form_of(found)}, not {form_of(like)}."
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        return f"{whole} {have} {len(found)} element{'s' * (len(found) != 1)}, not {len(like)}."
    if isinstance(wanted, Wanted) and isinstance(like, list):  # the forms of its elements
        wanted = [Wanted("", lambda one, each=each: form_of(one) == form_of(each), like=each) for each in like]
    if isinstance(wanted, dict):
        for words, keys in (("misses", wanted.keys() - found.keys()), ("must not have", found.keys() - wanted.keys())):
            if keys:
                return f"{what} {words} the key {min(map(shown, keys))}."
        parts = [(f"{key} of {what}", found[key], wanted[key]) for key in wanted]
    else:
        is_row = isinstance(wanted, (list, tuple))
        parts = [*zip(parts_of(what, len(wanted)), found, wanted, strict=True)] if is_row else []
    for part in parts:
        if not fits(*part[1:]):
            return mistake_in(*part)
    digits = digits_of(found, wanted)
    is_plain = not isinstance(wanted, Wanted) and isinstance(found, (Real, str, vector))
    return f"{whole} {are} {f'{shown(found, digits)}, not {shown(wanted, digits)}' if is_plain else 'wrong'}."


def parts_of(what, count) -> list[str]:
    """Return the names of the elements: "theta of pend_list[0]", ... for "theta of each pendulum"."""
    for each, one in (("each pendulum", "pend_list"), ("each axle", "axle"), ("each bob", "bob")):
        if each in what:
            return [what.replace(each, f"{one}[{i}]") for i in range(count)]
    first, of, others = what.partition(" of ")
    for names, end in ((what.split(", "), ""), (first.split(" and "), of + others)):
        if len(names) == count > 1:
            return [name + end for name in names]
    return [what if " " in what else f"{what}[{i}]" for i in range(count)]


def digits_of(found, wanted) -> int:
    """Return how many digits show that both values differ."""
    return 6 if shown(found) != shown(wanted) else 15
