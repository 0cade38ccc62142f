"""The values in a student's code, in a few words."""

import os
from itertools import islice
from types import BuiltinFunctionType, FrameType, FunctionType, MethodType, ModuleType

from pandas import DataFrame
from vpython import box, cylinder, sphere, vector

from grading.messages import form_of, shown

SHORT = 48  # characters of a value that is shown whole
SHAPES = box, sphere, cylinder
MOST_ELEMENTS = 5  # shown of a tuple
MOST_NAMED = 50  # elements of a list that have a name
MOST_KEYS = 3  # shown of a dictionary


def kind_of(shape) -> str:
    """Return which part of a pendulum a shape is."""
    return shown(shape).partition(" ")[2]


def names_in(frame: FrameType) -> dict[int, str]:
    """Return the code that gives each dictionary and each list of a frame, by their ids:
    "pend_list[1]".
    """
    found: dict[int, str] = {}
    parameters = frame.f_code.co_varnames[: frame.f_code.co_argcount]
    names = frame.f_locals
    for name in parameters:
        if type(names.get(name)) in (dict, list):
            found.setdefault(id(names[name]), name)
    for name, value in names.items():
        for key, one in elements_of(value):
            if type(one) is dict:
                found.setdefault(id(one), f"{name}[{key!r}]")
    for name, value in names.items():
        if type(value) in (dict, list):
            found.setdefault(id(value), name)
    return found


def elements_of(value) -> list[tuple]:
    """Return the first indexes and elements of a list or a tuple, or keys and values of a
    dictionary.
    """
    if type(value) in (list, tuple):
        return [*enumerate(value[:MOST_NAMED])]
    return [*islice(value.items(), MOST_NAMED)] if type(value) is dict else []


def in_words(value, names=None) -> str:
    """Return a value in a few words: "a list of 3 pendula". names is from names_in."""
    names = names or {}
    if isinstance(value, dict):
        return names.get(id(value)) or dictionary_in_words(value)
    if isinstance(value, list):
        text = list_in_words(value, names)
        return f"{names[id(value)]}, {text}" if id(value) in names else text
    if isinstance(value, tuple) and len(value) <= MOST_ELEMENTS:
        return tuple_in_words(value, names)
    if isinstance(value, vector):
        return f"({', '.join(shown(number, 4) for number in value.value)})"
    return object_in_words(value) or plain_in_words(value)


def tuple_in_words(value, names) -> str:
    """Return a short tuple; shapes alone are named without their places."""
    if value and all(isinstance(one, SHAPES) for one in value):
        return f"({', '.join(kind_of(one) for one in value)})"
    return f"({', '.join(in_words(one, names) for one in value)})"


def object_in_words(value) -> str:
    """Return a value that has no short text of its own, or ""."""
    if isinstance(value, SHAPES):
        return f"{kind_of(value)} at {in_words(value.pos)}"
    if isinstance(value, DataFrame):
        return f"a table of {len(value)} rows"
    if isinstance(value, FunctionType) and value.__name__ == "<lambda>":
        return "a lambda"
    if isinstance(value, (FunctionType, BuiltinFunctionType, type)):
        return f"the function {value.__name__}: a call has ( )"
    if isinstance(value, MethodType):
        return f"the method {value.__name__}: a call has ( )"
    if isinstance(value, ModuleType):
        return f"the module {value.__name__}"
    return ""


def plain_in_words(value) -> str:
    """Return a number, a text, or another value: its form, if its text is long."""
    if isinstance(value, str) and (os.path.isabs(value) or os.path.isfile(value)):
        return f"the path of {os.path.basename(value)}"
    text = shown(value)
    is_long = len(text) > SHORT or "\n" in text or " at 0x" in text
    return form_of(value) if is_long else text


def dictionary_in_words(value) -> str:
    """Return a dictionary with its first keys."""
    if not value:
        return "{ }, empty"
    parts = []
    for key in [*value][:MOST_KEYS]:
        part = value[key]
        parts.append(f"{shown(key)}: {'{...}' if isinstance(part, dict) else in_words(part)}")
    if len(value) > MOST_KEYS:
        parts.append("...")
    return f"{{{', '.join(parts)}}}"


def list_in_words(value, names) -> str:
    """Return a short list of plain values whole, and of another one how many elements it has."""
    if not value:
        return "[ ], empty"
    if all(isinstance(one, dict) and "mass" in one for one in value):
        is_one = len(value) > 1 and len({id(one) for one in value}) == 1
        same = ", all the same one" if is_one else ""
        return (
            "a list of 1 pendulum" if len(value) == 1 else f"a list of {len(value)} pendula{same}"
        )
    if len(value) <= MOST_ELEMENTS and not any(
        isinstance(one, (dict, list, tuple)) for one in value
    ):
        text = f"[{', '.join(in_words(one, names) for one in value)}]"
        if len(text) <= SHORT:
            return text
    return "a list of 1 element" if len(value) == 1 else f"a list of {len(value)} elements"
