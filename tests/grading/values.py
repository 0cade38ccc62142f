"""The values in a student's code, in a few words."""

import os
from itertools import islice
from types import BuiltinFunctionType, FrameType, FunctionType, MethodType, ModuleType
from typing import Any

from pandas import DataFrame
from vpython import box, cylinder, sphere, vector

from grading.messages import form_of, plural, text_of

SHORT = 48  # characters of a value that is shown whole
SHAPES = box, sphere, cylinder
MOST_ELEMENTS = 5  # shown of a tuple
MOST_NAMED = 50  # elements of a list that have a name
MOST_KEYS = 3  # shown of a dictionary


def kind_of(shape: Any) -> str:
    """Return which part of a pendulum a shape is."""
    return text_of(shape).partition(" ")[2]


def names_in(frame: FrameType) -> dict[int, str]:
    """Return the code of each dictionary and each list of a frame, by their ids: "pend_list[1]".

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
    if isinstance(value, tuple) and len(value) <= MOST_ELEMENTS:
        return tuple_in_words(value, names)
    if isinstance(value, vector):
        numbers = [text_of(number, 4) for number in value.value]
        return f"({', '.join(numbers)})"
    return object_in_words(value) or plain_in_words(value)


def tuple_in_words(value: tuple, names: dict[int, str]) -> str:
    """Return a short tuple; shapes alone are named without their places."""
    if value and all(isinstance(element, SHAPES) for element in value):
        texts = [kind_of(shape) for shape in value]
    else:
        texts = [in_words(element, names) for element in value]
    return f"({', '.join(texts)})"


def object_in_words(value: Any) -> str:
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


def plain_in_words(value: Any) -> str:
    """Return a number, a text, or another value: its form, if its text is long."""
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
    for key, part in islice(value.items(), MOST_KEYS):
        text = "{...}" if isinstance(part, dict) else in_words(part)
        parts.append(f"{text_of(key)}: {text}")
    if len(value) > MOST_KEYS:
        parts.append("...")
    return f"{{{', '.join(parts)}}}"


def list_in_words(value: list, names: dict[int, str]) -> str:
    """Return a short list of plain values whole, and of another one how many elements it has."""
    if not value:
        return "[ ], empty"
    if all(isinstance(element, dict) and "mass" in element for element in value):
        text = f"a list of {plural(len(value), 'pendulum', 'pendula')}"
        is_same = len(value) > 1 and len({id(pend) for pend in value}) == 1
        return f"{text}, all the same one" if is_same else text
    is_plain = not any(isinstance(element, (dict, list, tuple)) for element in value)
    if is_plain and len(value) <= MOST_ELEMENTS:
        elements = [in_words(element, names) for element in value]
        text = f"[{', '.join(elements)}]"
        if len(text) <= SHORT:
            return text
    return f"a list of {plural(len(value), 'element', 'elements')}"
