"""The values in a student's code where it stopped, in words."""

import ast
import os
from contextlib import suppress
from itertools import islice
from numbers import Real
from types import ModuleType

from vpython import box, cylinder, sphere, vector

from grading.evidence import nodes_of
from grading.messages import form_of, shown

SHORT, MOST_VALUES, MOST_KEYS = 50, 160, 7  # characters of a value that is shown whole, and of all values; keys


def in_words(value) -> str:
    """Return a value in a few words: "a list of 3 pendula"."""
    if isinstance(value, dict) and value:
        keys = ", ".join([*map(shown, islice(value, MOST_KEYS)), *["..."] * (len(value) > MOST_KEYS)])
        return "a pendulum (a dictionary)" if "mass" in value else f"a dictionary with the keys {keys}"
    if isinstance(value, list) and value:
        are_pendula = all(isinstance(one, dict) and "mass" in one for one in value[:20])
        one, more = ("pendulum", "pendula") if are_pendula else ("element", "elements")
        return f"a list of {len(value)} {one if len(value) == 1 else more}"
    if isinstance(value, str) and os.path.isfile(value):
        return f"the path of {os.path.basename(value)}"
    text = shown(value)
    if len(text) > SHORT or "\n" in text or " at 0x" in text:
        return form_of(value)
    return f"the text {text}" if isinstance(value, str) else text


def value_of(node, names):
    """Return the value of a name, an element or a part of an object; raise a LookupError if it is none of these."""
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.Constant):
        return node.value
    whole = value_of(node.value, names) if isinstance(node, (ast.Subscript, ast.Attribute)) else None
    if isinstance(node, ast.Subscript) and type(whole) in (dict, list, tuple):
        return whole[value_of(node.slice, names)]
    if isinstance(node, ast.Attribute) and isinstance(whole, (box, sphere, cylinder, vector)):
        return getattr(whole, node.attr)
    raise LookupError


def values_at(frame, line, only_names) -> str:
    """Return the values of the names and elements in this line of a frame, in words, or only all names of the frame."""
    if only_names:
        return f"these names have a value: {', '.join(islice(frame.f_locals, 12))}"
    found, inner, text = {}, set(), ""
    with suppress(Exception):  # a line of no file
        for node in nodes_of(frame, line):
            if isinstance(getattr(node, "ctx", None), ast.Load) and node not in inner:
                with suppress(LookupError, TypeError, AttributeError):
                    found.setdefault(ast.unparse(node), value_of(node, frame.f_locals))
                    inner.update(ast.walk(node))
    for name, value in sorted(found.items(), key=lambda pair: isinstance(pair[1], Real)):  # numbers last
        with suppress(Exception):  # a value that says nothing of itself
            if not callable(value) and not isinstance(value, ModuleType):
                text += f"{', ' * bool(text)}{name} is {in_words(value)}"
        if len(text) > MOST_VALUES:
            return f"{text}, ..."
    return text
