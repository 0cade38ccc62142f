"""Values that live on from one call of a function to the next one."""

from collections.abc import Iterable, Iterator
from types import FunctionType
from typing import Any

from line_by_line.words import in_words

KINDS = list, dict, set, int, float, str


def state_of(functions: Iterable[FunctionType]) -> dict[str, str]:
    """Return the values that live on between calls of these functions, in words, by their names."""
    found = {}
    for function in functions:
        for name, value in living_values(function):
            if type(value) in KINDS:
                found[name] = in_words(value)
    return found


def living_values(function: FunctionType) -> Iterator[tuple[str, Any]]:
    """Yield names and values: defaults of parameters, and what a function names outside of it."""
    code = function.__code__
    defaults = function.__defaults__ or ()
    first = code.co_argcount - len(defaults)
    for name, value in zip(code.co_varnames[first : code.co_argcount], defaults, strict=True):
        yield f"the default of {name}", value
    for name in code.co_names:
        value = function.__globals__.get(name)
        yield name, value
        if isinstance(value, type) and value.__module__ == function.__module__:
            for key, part in vars(value).items():
                if not key.startswith("__"):
                    yield f"{name}.{key}", part
