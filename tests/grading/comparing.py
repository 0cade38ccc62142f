"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

import re
from functools import cache
from itertools import permutations
from math import isclose
from numbers import Real
from pathlib import Path

from vpython import vector

from grading.messages import about, form_of, shown, Wanted

MOST_CODE = 8_000  # characters of a student's code in which hints are looked for
LONG = 130  # characters; of a longer list, a message shows only the first difference

# Errors of a check that reads a value of the wrong form.
OTHER_FORM = (TypeError, ValueError, KeyError, IndexError, AttributeError, ArithmeticError, RecursionError)


def fits(found, wanted, *change) -> bool:
    """Return whether found is right; wanted is a value (change: see same), a Wanted, or a test of a value."""
    test = wanted.is_one if isinstance(wanted, Wanted) else wanted if callable(wanted) else None
    try:
        return bool(test(found)) if test else same(found, wanted, *change)
    except OTHER_FORM:
        return False


def same(found, wanted, change=lambda value: value) -> bool:
    """Return whether two values are equal, numbers within rounding errors; 0 equals 0.0. change alters found."""
    found = change(found)
    if isinstance(wanted, vector):
        return isinstance(found, vector) and same(found.value, wanted.value)
    if isinstance(wanted, dict):
        has_keys = isinstance(found, dict) and found.keys() == wanted.keys()
        return has_keys and all(same(found[key], wanted[key], change) for key in wanted)
    if isinstance(wanted, (list, tuple)):
        is_row = isinstance(found, list if isinstance(wanted, list) else tuple) and len(found) == len(wanted)
        return is_row and all(same(*pair, change) for pair in zip(found, wanted, strict=True))
    if isinstance(wanted, str):
        return isinstance(found, str) and found == wanted
    if isinstance(wanted, Real):
        return isinstance(found, Real) and isclose(found, wanted, rel_tol=1e-6, abs_tol=1e-9)
    return type(found) is type(wanted) and bool(found == wanted)


def hint_for(found, wanted, hints) -> str:
    """Return the hint for this result, or "". If two mistakes give this result, nobody knows which one it was."""
    sentences = {sentence for mistaken, sentence in hints if fits(found, mistaken)}
    if not sentences:
        are_parts = isinstance(wanted, tuple) and len(wanted) > 1 and isinstance(found, (list, tuple))
        general = {
            "You returned a list. Return a tuple.": are_parts and same(tuple(found), wanted),
            "The values are right, but in the wrong order.": are_parts and is_mixed_up(found, wanted),
            "A number here is text. Numbers have no quotes, and need no str().": fits(found, wanted, number_in),
            "A comma at the end of a line makes a tuple of one value. Remove it.": fits(found, wanted, single_in),
        }
        sentences = {sentence for sentence, is_so in general.items() if is_so}
    return sentences.pop() if len(sentences) == 1 else ""


def is_mixed_up(found, wanted) -> bool:
    """Return whether found has the values of wanted, up to four numbers, in another order."""
    has_all = len(found) < 5 and any(same(order, wanted) for order in permutations(found))
    return has_all and not same(tuple(found), wanted)


@cache
def rows_of(file, name) -> list[tuple[str, str]]:
    """Return the rows of a table (a file of this folder) below the headings with this name, as pairs of lines."""
    text = Path(__file__).with_name(file).read_text(encoding="utf-8")
    parts = re.split(r"^\[([a-z_ ]+)\]\n", text, flags=re.MULTILINE)
    below = [text for names, text in zip(parts[1::2], parts[2::2], strict=True) if name in names.split()]
    return re.findall(r"^(\S.*)\n    (.*)", "".join(below), re.MULTILINE)


def cases_of(name, names) -> list[tuple]:
    """Return cases: pairs of the arguments of a call and of its result, in which these names occur."""
    return [(eval(given, names), eval(result, names)) for given, result in rows_of("cases.txt", name)]


def hints_of(name, names) -> list[tuple]:
    """Return the hints of a check: pairs of the result of a mistake or a test of it, with these names, and the hint."""
    names = {"same": same, **names}
    return [(eval(mistaken, names), sentence) for mistaken, sentence in rows_of("hints.txt", name)]


def known_hint(kind, text) -> str:
    """Return the hint of hints.txt for a text of this kind (errors, code or wrong), or ""."""
    text = text[:MOST_CODE].replace('"', "'")
    for pattern, hint in rows_of("hints.txt", kind):
        if found := re.search(pattern, text, re.DOTALL | re.MULTILINE):
            return found.expand(hint)
    return ""


def number_in(value):
    """Return the number in a text, or the value."""
    is_number = isinstance(value, str) and re.fullmatch(r"-?\d+(\.\d*)?", value)
    return float(value) if is_number else value


def single_in(value):
    """Return the only value in a tuple, or the value."""
    return value[0] if type(value) is tuple and len(value) == 1 else value


def both(what, found, wanted) -> list[tuple[str, list[str]]]:
    """Return both values as (label, lines) of a message; for long lists, those of the first wrong element."""
    digits = digits_of(found, wanted)
    are_lists = isinstance(found, list) and isinstance(wanted, list) and len(found) == len(wanted)
    are_long = are_lists and max(len(shown(found)), len(shown(wanted))) > LONG
    if are_long or (are_lists and isinstance(wanted[0], dict)):
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
        elements = "element" if len(found) == 1 else "elements"
        return f"{whole} {have} {len(found)} {elements}, not {len(like)}."
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
