"""Values as text. A course makes Words of its own, which know its kinds of values."""

import math
import os
from collections.abc import Callable, Collection, Iterable
from contextlib import suppress
from numbers import Real
from reprlib import Repr
from types import BuiltinFunctionType, FunctionType, MethodType
from typing import Any, NamedTuple

SHORT = 48  # characters of a value in a few words
FORMS: dict[type, str] = {
    list: "a list",
    tuple: "a tuple",
    dict: "a dictionary",
    str: "text",
    bool: "a bool",
    type(None): "None",
}
# They give a value, and do nothing else: a call of them may be repeated.
FUNCTIONS = (
    abs,
    float,
    int,
    isinstance,
    len,
    max,
    min,
    round,
    sum,
    *filter(callable, vars(math).values()),
)
CALLABLE = BuiltinFunctionType, FunctionType, MethodType


class Noun(NamedTuple):
    """What a dictionary with a key is called."""

    key: str
    singular: str
    several: str


def plural(count: int, singular: str, several: str) -> str:
    """Return a number with its noun: "1 bob", "2 bobs"."""
    return f"{count} {singular if count == 1 else several}"


class Words(Repr):
    """Says values in words, as Python writes them; numbers have a few digits."""

    def __init__(
        self,
        forms: dict[type, str] | None = None,
        texts: dict[type, Callable[[Any], str]] | None = None,
        nouns: Iterable[Noun] = (),
        attributes: dict[type, tuple[str, ...]] | None = None,
        functions: Iterable[Callable] = (),
    ):
        """forms has what values of a kind are called: "a bob", and texts functions that say one.

        The first of the nouns that fits is taken. attributes has those that say what a value of a
        kind is, and functions those that do nothing but give a value.
        """
        super().__init__()
        self.maxlist = self.maxtuple = self.maxdict = 20
        self.maxother = self.maxstring = 300
        self.digits = 6
        self.forms = {**FORMS, **(forms or {})}
        self.texts = texts or {}
        self.nouns = [*nouns, Noun("", "dictionary", "dictionaries")]
        self.attributes = attributes or {}
        self.functions = [*FUNCTIONS, *functions]

    def form_of(self, value: Any) -> str:
        """Return the form of a value: "a list"."""
        for kind, form in self.forms.items():
            if isinstance(value, kind):
                return form
        return "a number" if isinstance(value, Real) else f"a {type(value).__name__}"

    def number_of(self, value: Collection) -> str:
        """Return how many elements a list has: "3 pendula"."""
        if value and all(isinstance(element, dict) for element in value):
            for key, singular, several in self.nouns:
                if all(key in element for element in value) or not key:
                    return plural(len(value), singular, several)
        return plural(len(value), "element", "elements")

    def text_of(self, value: Any, digits: int = 6) -> str:
        """Return a value as text, its numbers with this number of digits."""
        self.digits = digits
        return self.repr(value)

    def repr1(self, value: Any, level: int) -> str:
        if type(value) in self.texts:
            is_part = level < self.maxlevel and type(value) in self.forms
            return self.forms[type(value)] if is_part else self.texts[type(value)](value)
        if isinstance(value, Real) and not isinstance(value, bool):
            return self.number_text(value)
        return super().repr1(value, level)

    def number_text(self, value: Any) -> str:
        with suppress(OverflowError):
            return f"{value + 0:.{self.digits}g}"  # no -0
        return "a very large number"

    def repr_instance(self, value: Any, level: int) -> str:
        """Return the text of an object, or its attributes if it has none of its own."""
        text = " ".join(super().repr_instance(value, level).split())
        if " at 0x" not in text:
            return text
        if level < self.maxlevel or not hasattr(value, "__dict__"):
            return self.form_of(value)
        parts = [f"{name}={self.repr1(part, level - 1)}" for name, part in vars(value).items()]
        return f"{type(value).__name__}({', '.join(parts)})"

    def in_words(self, value: Any, name: str = "") -> str:
        """Return a value in a few words: "a list of 3 pendula". name is code that gives it."""
        if isinstance(value, dict) and name:
            return name
        text = self.plainly(value)
        return f"{name}, {text}" if name else text

    def plainly(self, value: Any) -> str:
        """Return a value in a few words."""
        if isinstance(value, type):
            return f"the class {value.__name__}"
        if isinstance(value, CALLABLE):
            return f"{value.__name__}, not called"
        if isinstance(value, str) and (os.path.isabs(value) or os.path.isfile(value)):
            return f"the path of {os.path.basename(value)}"
        text = self.text_of(value)
        is_list = isinstance(value, list)
        if len(text) <= SHORT and not (is_list and any(isinstance(part, dict) for part in value)):
            return text
        if is_list:
            text = f"a list of {self.number_of(value)}"
            is_same = len(value) > 1 and len({id(element) for element in value}) == 1
            return f"{text}, all the same one" if is_same else text
        if isinstance(value, dict) and ", " in text[:SHORT]:
            return f"{text[:SHORT].rpartition(', ')[0]}, ...}}"
        return self.form_of(value)
