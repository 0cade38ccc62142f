"""Comparing a student's result with the expected one: whether they are equal, and what is wrong."""

import re
from math import isclose
from numbers import Real
from pathlib import Path

from vpython import vector

from grading.messages import about, shown, Wanted, WIDTH

LONG = 130  # characters; of a longer list, a message shows only the first difference

# A pattern of an error, and its hint, as hints.txt explains.
HINTS = re.findall(
    r"^(\S.*)\n    (.*)", Path(__file__).with_name("hints.txt").read_text(encoding="utf-8"), re.MULTILINE
)

# Errors of a check that reads a value of the wrong form.
OTHER_FORM = (TypeError, ValueError, KeyError, IndexError, AttributeError, ArithmeticError, RecursionError)

FORMS = {list: "a list", tuple: "a tuple", dict: "a dictionary", str: "text", bool: "a bool", type(None): "None"}


def fits(found, wanted, change=None) -> bool:
    """Return whether found is right; wanted is a value, a Wanted, or a test. change alters found first: see changed."""
    test = wanted.is_one if isinstance(wanted, Wanted) else wanted if callable(wanted) else None
    try:
        found = changed(found, change) if change else found
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
    if not sentences:
        is_row = isinstance(wanted, tuple) and len(wanted) > 1
        are_parts = is_row and isinstance(found, (list, tuple))
        general = {
            "The keys must be those of the file, letter by letter, and all.": have_other_keys(found, wanted),
            "You returned a list. Return a tuple.": are_parts and same(tuple(found), wanted),
            "The values are right, but in the wrong order.": are_parts and same(tuple(reversed(found)), wanted),
            "Return all values, with commas between them.": is_row and isinstance(found, Real),
            "You named a function, but did not call it. Put ( ) behind its name.": "function" in form_of(found),
            "A number here is text. Numbers have no quotes, and need no str().": fits(found, wanted, number_in),
            "A comma at the end of a line makes a tuple of one value. Remove it.": fits(found, wanted, single_in),
        }
        sentences = {sentence for sentence, is_so in general.items() if is_so}
    return sentences.pop() if len(sentences) == 1 else ""


def have_other_keys(found, wanted) -> bool:
    """Return whether both are lists of dictionaries, of one length, and the keys differ."""
    are_rows = all(isinstance(rows, list) and all(isinstance(row, dict) for row in rows) for rows in (found, wanted))
    return are_rows and len(found) == len(wanted) and any(map(lambda a, b: a.keys() != b.keys(), found, wanted))


def difference(found, wanted) -> str:
    """Return a sentence with the first numbers or texts that differ, or "" if one has another form."""
    pairs = []
    if isinstance(found, (list, tuple)) and isinstance(wanted, (list, tuple)):
        pairs = [*zip(found, wanted, strict=False)]
    elif isinstance(found, dict) and isinstance(wanted, dict):
        pairs = [(found.get(key), wanted[key]) for key in wanted]
    for pair in pairs:
        if not same(*pair):
            return difference(*pair)
    are_plain = all(isinstance(value, (Real, str, vector)) for value in (found, wanted))
    return f"Found {shown(found)}, expected {shown(wanted)}." if are_plain else ""


def hint_of(raised) -> str:
    """Return the hint of hints.txt for an error, or "". It reads the error, and the student's lines."""
    said = "\n".join([f"{raised.kind}: {raised.text}", *(place.code for place in raised.places)]).replace('"', "'")
    for pattern, hint in HINTS:
        if found := re.search(pattern, said, re.DOTALL):
            return found.expand(hint)
    return ""


def changed(value, change):
    """Return a copy of a value; change gives its parts."""
    value = change(value)
    if isinstance(value, dict):
        return {key: changed(part, change) for key, part in value.items()}
    return type(value)(changed(part, change) for part in value) if type(value) in (list, tuple) else value


def number_in(value):
    """Return the number in a text, or the value."""
    return float(value) if isinstance(value, str) and re.fullmatch(r"-?[\d.]+", value) else value


def single_in(value):
    """Return the only value in a tuple, or the value."""
    return value[0] if type(value) is tuple and len(value) == 1 else value


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
