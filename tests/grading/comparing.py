"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

import re
from math import isclose
from numbers import Real

from vpython import vector

from grading.messages import about, form_of, shown, Wanted

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


def fits(found, wanted) -> bool:
    """Return whether found is right; wanted is a value, a Wanted, or a test of a value."""
    try:
        return bool(wanted(found)) if callable(wanted) else same(found, wanted)
    except OTHER_FORM:
        return False


def same(found, wanted) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0."""
    if isinstance(wanted, Wanted):
        return bool(wanted.is_one(found))
    if isinstance(wanted, vector):
        return isinstance(found, vector) and same(found.value, wanted.value)
    if isinstance(wanted, dict):
        has_keys = isinstance(found, dict) and found.keys() == wanted.keys()
        return has_keys and all(same(found[key], wanted[key]) for key in wanted)
    if isinstance(wanted, (list, tuple)):
        is_row = isinstance(found, list if isinstance(wanted, list) else tuple) and len(
            found
        ) == len(wanted)
        return is_row and all(same(*pair) for pair in zip(found, wanted, strict=True))
    if isinstance(wanted, Real):
        return isinstance(found, Real) and isclose(found, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return isinstance(found, type(wanted)) and bool(found == wanted)


def words_of(found, rows) -> str:
    """Return the words of the rows that fit a result, or "".

    If two of them do, nobody knows which one it was.
    """
    sentences = {sentence for mistaken, sentence in rows if fits(found, mistaken)}
    return sentences.pop() if len(sentences) == 1 else ""


def is_exchanged(found, wanted) -> bool:
    """Return whether a tuple has the expected values in another order."""
    if not (isinstance(found, tuple) and isinstance(wanted, tuple) and len(found) == len(wanted)):
        return False
    left = [*found]
    for value in wanted:
        match = next((i for i, one in enumerate(left) if same(one, value)), None)
        if match is None:
            return False
        left.pop(match)
    return True


def both(what, found, wanted) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message; for long lists, those of the first wrong
    element.
    """
    digits = digits_of(found, wanted)
    are_lists = isinstance(found, list) and isinstance(wanted, list)
    if are_lists and len(found) != len(wanted) and are_pendula(wanted):
        return [("came back", number_of(found)), ("expected", number_of(wanted))]
    if (
        are_lists
        and len(found) == len(wanted)
        and (isinstance(wanted[0], dict) or max(len(shown(found)), len(shown(wanted))) > LONG)
    ):
        i = [same(*pair) for pair in zip(found, wanted, strict=True)].index(False)
        what = f"{what} at index {i}".lstrip()
        found, wanted = found[i], wanted[i]
    return [("came back", about(what, found, digits)), ("expected", about(what, wanted, digits))]


def are_pendula(value) -> bool:
    """Return whether a value is a list of dictionaries."""
    return isinstance(value, list) and bool(value) and all(isinstance(one, dict) for one in value)


def number_of(value) -> str:
    """Return how many elements a list has, in words."""
    one, more = ("pendulum", "pendula") if are_pendula(value) else ("element", "elements")
    return f"a list of {len(value)} {one if len(value) == 1 else more}"


def mistake_in(what, found, wanted) -> str:
    """Return a sentence about the first mistake in found. what names it, or the parts of a tuple,
    with commas.
    """
    whole = "The result" if ", " in what else what
    like = wanted.like if isinstance(wanted, Wanted) else wanted
    if wanted is True and isinstance(found, bool):
        return f"It is not true {what}."
    if like is not None and form_of(found) != form_of(like):
        return f"{whole} {verb_of(whole)} {form_of(found)}, not {form_of(like)}."
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        whole = "pend_list" if what.endswith(" of each pendulum") else whole
        has = "have" if verb_of(whole) == "are" else "has"
        return (
            f"{whole} {has} {len(found)} element{'' if len(found) == 1 else 's'}, not {len(like)}."
        )
    if isinstance(wanted, dict) and found.keys() != wanted.keys():
        missing, others = wanted.keys() - found.keys(), found.keys() - wanted.keys()
        words = "misses" if missing else "must not have"
        return f"{what} {words} the key {min(map(shown, missing or others))}."
    for part in parts_in(what, found, wanted):
        if not fits(*part[1:]):
            return mistake_in(*part)
    return f"{whole} {verb_of(whole)} {difference(found, wanted)}."


def verb_of(whole) -> str:
    """Return the verb for the name of a value: ends are, and omega and theta are."""
    return "are" if re.match(r"ends |[^,]* and ", whole) else "is"


def parts_in(what, found, wanted) -> list[tuple]:
    """Return the parts of a value: of each, its name, the value, and the expected one."""
    if isinstance(wanted, Wanted) and isinstance(wanted.like, list):  # the forms of its elements
        wanted = [
            Wanted("", lambda one, each=each: form_of(one) == form_of(each), like=each)
            for each in wanted.like
        ]
    if isinstance(wanted, dict):
        return [(f"{key} of {what}", found[key], wanted[key]) for key in wanted]
    if isinstance(wanted, (list, tuple)):
        return [*zip(parts_of(what, len(wanted)), found, wanted, strict=True)]
    return []


def difference(found, wanted) -> str:
    """Return what a value is, and what it must be."""
    digits = digits_of(found, wanted)
    if not isinstance(wanted, Wanted):
        is_plain = isinstance(found, (Real, str, vector))
        return f"{shown(found, digits)}, not {shown(wanted, digits)}" if is_plain else "wrong"
    if isinstance(found, Real) and not isinstance(found, bool):
        return f"{shown(found, digits)}, not {wanted.words}"
    return f"not {wanted.words}" if wanted.words else "wrong"


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
