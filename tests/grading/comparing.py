"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

from math import isclose
from numbers import Real

from vpython import vector

from grading.messages import about, shown, Wanted, WIDTH

LONG = 130  # characters; of a longer list, a message shows only the first difference

# Errors of a check that reads a value of the wrong form.
OTHER_FORM = (TypeError, ValueError, KeyError, IndexError, AttributeError, ArithmeticError, RecursionError)

FORMS = {list: "a list", tuple: "a tuple", dict: "a dictionary", str: "text", bool: "a bool", type(None): "None"}


def fits(found, wanted) -> bool:
    """Return whether found is right; wanted is a value, a Wanted, or a test of a value."""
    test = wanted.is_one if isinstance(wanted, Wanted) else wanted if callable(wanted) else None
    try:
        return bool(test(found)) if test else same(found, wanted)
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
        kind = list if isinstance(wanted, list) else tuple
        return isinstance(found, kind) and len(found) == len(wanted) and all(map(same, found, wanted))
    if isinstance(wanted, str):
        return isinstance(found, str) and found == wanted
    if isinstance(wanted, Real):
        return isinstance(found, Real) and isclose(found, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return type(found) is type(wanted) and bool(found == wanted)


def hint_for(found, wanted, hints) -> str:
    """Return the hint for this result, or "". If two mistakes give this result, nobody knows which one it was."""
    sentences = {sentence for mistaken, sentence in hints if fits(found, mistaken)}
    if not sentences and isinstance(wanted, tuple) and len(wanted) > 1 and isinstance(found, (list, tuple)):
        if same(tuple(found), wanted):
            sentences.add("You returned a list. Return a tuple.")
        if same(tuple(reversed(found)), wanted):
            sentences.add("The values are right, but in the wrong order.")
    return sentences.pop() if len(sentences) == 1 else ""


def has_form_of(found, wanted) -> bool:
    """Return whether only the numbers in found are wrong: watch.py can then play the scene."""
    if isinstance(wanted, Wanted):
        return has_form_of(found, wanted.like)
    if isinstance(wanted, (tuple, list)):
        is_row = isinstance(found, (tuple, list)) and len(found) == len(wanted)
        return is_row and all(map(has_form_of, found, wanted))
    return isinstance(found, Real) if isinstance(wanted, Real) else found is not None


def both(what, found, wanted) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message; for long lists, those of the first wrong element."""
    digits = 6 if shown(found) != shown(wanted) else 15  # else both would look the same
    are_lists = isinstance(found, list) and isinstance(wanted, list) and len(found) == len(wanted)
    are_long = are_lists and max(len(shown(found)), len(shown(wanted))) > LONG
    if are_long or (are_lists and isinstance(wanted[0], dict)):
        i = [same(*pair) for pair in zip(found, wanted, strict=True)].index(False)
        what, found, wanted = f"{what} at index {i}".lstrip(), found[i], wanted[i]
    return [("came back", about(what, found, digits)), ("expected", about(what, wanted, digits))]


def mistake_in(what, found, wanted) -> str:
    """Return a sentence that says what is wrong in found. what names it, or the parts of a tuple, with commas."""
    names = what.split(", ")
    whole = what if len(names) == 1 else "The result"
    like = wanted.like if isinstance(wanted, Wanted) else wanted
    if wanted is True and isinstance(found, bool):
        return f"It is not true {what}."
    if like is not None and form_of(found) != form_of(like):
        return f"{whole} is {form_of(found)}, not {form_of(like)}."
    if isinstance(like, (list, tuple)) and len(found) != len(like):
        elements = "element" if len(found) == 1 else "elements"
        return f"{whole} has {len(found)} {elements}, not {len(like)}."
    if isinstance(wanted, (list, tuple)):
        parts = names if len(names) == len(wanted) > 1 else [part_of(what, i) for i in range(len(wanted))]
        bad = [trio for trio in zip(parts, found, wanted, strict=True) if not fits(*trio[1:])]
        if isinstance(bad[0][2], dict) or (len(bad) == 1 and not isinstance(bad[0][2], (list, tuple))):
            return mistake_in(*bad[0])
        are_all = len(bad) == len(parts) or parts[0] == part_of(what, 0) == what
        some = [part for part, *_ in bad][: 2 if len(bad[0][0]) < WIDTH / 2 - 5 else 1]
        return wrong(what if are_all else ", ".join(some + ["..."] * (len(bad) > len(some))))
    if isinstance(wanted, dict):
        for words, keys in (("misses", wanted.keys() - found.keys()), ("must not have", found.keys() - wanted.keys())):
            if keys:
                return f"{what} {words} the key {min(map(shown, keys))}."
        bad_keys = [str(key) for key in wanted if not fits(found[key], wanted[key])]
        return wrong(f"{', '.join(bad_keys)} of {what}")
    return wrong(what)


def form_of(value) -> str:
    """Return the form of a value in words."""
    words = [words for kind, words in FORMS.items() if isinstance(value, kind)]
    return words[0] if words else "a number" if isinstance(value, Real) else f"a {type(value).__name__}"


def part_of(what, i) -> str:
    """Return the name of an element: "theta of pend_list[2]" for "theta of each pendulum"."""
    for each, one in (("each pendulum", "pend_list"), ("each axle", "axle"), ("each bob", "bob")):
        if each in what:
            return what.replace(each, f"{one}[{i}]")
    return what if " " in what else f"{what}[{i}]"


def wrong(what) -> str:
    """Return a sentence that says what is wrong: "a is wrong.", "a and b are wrong.", "a, b, c are wrong."."""
    if what.count(", ") == 1 and " and " not in what:
        what = what.replace(", ", " and ")
    return f"{what} {'are' if ', ' in what or ' and ' in what else 'is'} wrong."
