"""Values as text. A course adds the words for its own kinds of values to FORMS, TEXTS and NOUNS."""

import os
from collections.abc import Callable, Collection, Iterable, Iterator
from itertools import islice
from numbers import Real
from types import BuiltinFunctionType, FrameType, FunctionType, MethodType, ModuleType
from typing import Any, NamedTuple

WIDTH = 62  # characters of a line of a long value
MOST_ELEMENTS = 20  # shown of a long value
MOST_DICTIONARIES = 1  # shown of a list of dictionaries
MOST_CHARACTERS = 300  # shown of a text
MOST_PARTS = 10_000  # of a value that is shown

SHORT = 48  # characters of a value in a few words
FEW_ELEMENTS = 5  # of a list or a tuple in a few words
FEW_KEYS = 3  # of a dictionary in a few words
MOST_NAMED = 50  # elements of a list that have a name


class Noun(NamedTuple):
    """What a dictionary with a key is called."""

    key: str
    singular: str
    several: str


FORMS: dict[type, str] = {
    list: "a list",
    tuple: "a tuple",
    dict: "a dictionary",
    str: "text",
    bool: "a bool",
    type(None): "None",
}
# Functions that give the text of a value, with this number of digits
TEXTS: dict[type, Callable[[Any, int], str]] = {}
NOUNS: list[Noun] = [Noun("", "dictionary", "dictionaries")]  # the first one that fits


def plural(count: int, singular: str, several: str) -> str:
    """Return a number with its noun: "1 bob", "2 bobs"."""
    return f"{count} {singular if count == 1 else several}"


def form_of(value: Any) -> str:
    """Return the form of a value as text: "a list"."""
    for kind, form in FORMS.items():
        if isinstance(value, kind):
            return form
    return "a number" if isinstance(value, Real) else f"a {type(value).__name__}"


def short_form(value: Any) -> str:
    """Return the form of a value that has a longer text, too, or ""."""
    return FORMS[type(value)] if type(value) in FORMS and type(value) in TEXTS else ""


def number_of(value: Collection) -> str:
    """Return how many elements a list has: "3 pendula"."""
    if value and all(isinstance(element, dict) for element in value):
        for key, singular, several in NOUNS:
            if all(key in element for element in value) or not key:
                return plural(len(value), singular, several)
    return plural(len(value), "element", "elements")


# --- a whole value ---


def text_of(value: Any, digits: int = 6) -> str:
    """Return a value as text, numbers with this number of digits.

    Each dictionary of a list has its own line.
    """
    try:
        return text_in_parts(value, digits, iter(range(MOST_PARTS)))
    except RecursionError:
        return f"a {type(value).__name__} that contains itself"
    except StopIteration:
        return f"a {type(value).__name__} with more than {MOST_PARTS} parts"
    except Exception:
        return f"a {type(value).__name__} that has no text"


def text_in_parts(value: Any, digits: int, parts: Iterator[int]) -> str:
    """Do what text_of does, but let errors of the value pass.

    parts is an iterator that ends after the greatest number of parts.
    """
    next(parts)
    if type(value) in TEXTS:
        return TEXTS[type(value)](value, digits)
    if isinstance(value, Real) and not isinstance(value, bool):
        return f"{value + 0:.{digits}g}"  # no -0
    if isinstance(value, dict):
        rows = []
        for key, part in islice(value.items(), MOST_ELEMENTS):
            key_text = text_in_parts(key, digits, parts)
            rows.append(f"{key_text}: {text_in_parts(part, digits, parts)}")
        return "{" + joined(rows, value, value.values()) + "}"
    if isinstance(value, (list, tuple)):
        has_dictionaries = isinstance(value, list) and any(isinstance(part, dict) for part in value)
        most = MOST_DICTIONARIES if has_dictionaries else MOST_ELEMENTS
        elements = []
        for part in value[:most]:
            elements.append(short_form(part) or text_in_parts(part, digits, parts))
        text = joined(elements, value, value)
        if isinstance(value, list):
            return f"[{text}]"
        return f"({text},)" if len(value) == 1 else f"({text})"
    text = repr(value)
    return text if len(text) <= MOST_CHARACTERS else text[:MOST_CHARACTERS] + "..."


def joined(texts: list[str], whole: Collection, elements: Iterable) -> str:
    """Return the texts of the elements of a list, tuple or dictionary in lines.

    If elements are left out, their full number stands at the end.
    """
    has_dictionaries = any(isinstance(element, dict) for element in elements)
    if len(whole) > len(texts):
        texts = [*texts, f"... ({len(whole)} in all)"]
    joined_text = "".join(texts[:1])
    for text in texts[1:]:
        line = joined_text.rpartition("\n")[2]
        needs_line = has_dictionaries or len(line) + len(text) > WIDTH
        joined_text += ",\n " if needs_line else ", "
        joined_text += text
    return joined_text


# --- a value in a few words ---


def names_in(frame: FrameType) -> dict[int, str]:
    """Return the code of each dictionary and each list of a frame, by their ids: "books[1]".

    The names of parameters come first, then elements, then other names.
    """
    found: dict[int, str] = {}
    parameters = frame.f_code.co_varnames[: frame.f_code.co_argcount]
    values = frame.f_locals
    for name in parameters:
        if type(values.get(name)) in (dict, list):
            found.setdefault(id(values[name]), name)
    for name, value in values.items():
        for key, element in elements_of(value):
            if type(element) is dict:
                found.setdefault(id(element), f"{name}[{key!r}]")
    for name, value in values.items():
        if type(value) in (dict, list):
            found.setdefault(id(value), name)
    return found


def elements_of(value: Any) -> list[tuple]:
    """Return pairs of the first keys and values of a dictionary, or indexes and elements."""
    if type(value) in (list, tuple):
        return [*enumerate(value[:MOST_NAMED])]
    if type(value) is dict:
        return [*islice(value.items(), MOST_NAMED)]
    return []


def in_words(value: Any, names: dict[int, str] | None = None) -> str:
    """Return a value in a few words: "a list of 3 pendula". names is from names_in."""
    names = names or {}
    if isinstance(value, dict):
        return names.get(id(value)) or dictionary_in_words(value)
    if isinstance(value, list):
        text = list_in_words(value, names)
        return f"{names[id(value)]}, {text}" if id(value) in names else text
    if type(value) is tuple and len(value) <= FEW_ELEMENTS:
        texts = [short_form(element) or in_words(element, names) for element in value]
        return f"({texts[0]},)" if len(texts) == 1 else f"({', '.join(texts)})"
    if isinstance(value, (FunctionType, BuiltinFunctionType, MethodType, type)):
        name = value.__name__
        return "a lambda" if name == "<lambda>" else f"the function {name}, not called"
    if isinstance(value, ModuleType):
        return f"the module {value.__name__}"
    if isinstance(value, str) and (os.path.isabs(value) or os.path.isfile(value)):
        return f"the path of {os.path.basename(value)}"
    text = text_of(value)
    is_long = len(text) > SHORT or "\n" in text or " at 0x" in text
    return form_of(value) if is_long else text


def dictionary_in_words(value: dict) -> str:
    """Return a dictionary with its first keys."""
    if not value:
        return "{ }, empty"
    parts = []
    for key, part in islice(value.items(), FEW_KEYS):
        text = "{...}" if isinstance(part, dict) else in_words(part)
        parts.append(f"{text_of(key)}: {text}")
    if len(value) > FEW_KEYS:
        parts.append("...")
    return f"{{{', '.join(parts)}}}"


def list_in_words(value: list, names: dict[int, str]) -> str:
    """Return a short list of plain values whole, and of another one how many elements it has."""
    if not value:
        return "[ ], empty"
    is_plain = not any(isinstance(element, (dict, list, tuple)) for element in value)
    if is_plain and len(value) <= FEW_ELEMENTS:
        text = f"[{', '.join(in_words(element, names) for element in value)}]"
        if len(text) <= SHORT:
            return text
    text = f"a list of {number_of(value)}"
    is_same = len(value) > 1 and len({id(element) for element in value}) == 1
    return f"{text}, all the same one" if is_same and not is_plain else text
