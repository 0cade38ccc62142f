"""What a Watch traces of a call: its statements, and what they gave, stored and called."""

import ast
import inspect
from collections import defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from types import FrameType
from typing import Any, NamedTuple

from line_by_line.words import in_words, names_in, number_of

LOOPS = ast.For, ast.While
FEW_CHANGES = 2  # of a key that name their dictionaries


@dataclass
class Statement:
    """A statement of a student's function."""

    node: Any  # of the syntax tree as the student wrote it
    owner: int  # the number of the function's own statement: its def
    loops: tuple[int, ...]  # the numbers of the loops around it, the outer one first
    is_shown: bool  # in a table, if no error stops it: a print and an inner function are not


class ValueInWords(NamedTuple):
    """A value that a statement gave, as text."""

    code: str  # of its target, or ""
    text: str


@dataclass
class Called:
    """A call of another function, which a table names."""

    name: str
    got: str  # its parameters and their values
    gave: str = ""  # its result and what it has changed; "" if it did not come to its end
    says_result: bool = False  # whether `gave` has its result


@dataclass
class Trace:
    """What a statement gave once."""

    turn: int  # of the innermost loop around it; for a loop, its own one; 0 without a loop
    values: list[ValueInWords]
    calls: list[Called] = field(default_factory=list)
    is_condition_of_loop: bool = False  # of a while


class Store(NamedTuple):
    """A value that a line has stored: in a dictionary under a key, or in a call under a name.

    A return stores it in its call, under "".
    """

    holder: Any  # the dictionary, or the WatchedCall
    key: Any  # the key, or the name
    number: int  # of the statement
    value: Any
    text: str  # the value in words


class Known(NamedTuple):
    """A dictionary that others have made, and a copy of that time."""

    dictionary: dict
    copy: dict
    giver: str  # the function that gave it, "" for the caller


class WatchedCall:
    """One call of a function that the student wrote."""

    def __init__(self, definition: int, frame: FrameType):
        """definition is the number of its def."""
        self.definition = definition
        self.frame = frame
        # Turns by the number of the loop: of the whole call, and since the loop began the last time
        self.turns: defaultdict[int, int] = defaultdict(int)
        self.turns_now: defaultdict[int, int] = defaultdict(int)
        # By the number of the statement
        self.traces: defaultdict[int, list[Trace]] = defaultdict(list)
        # Of the statements that have begun, and not come to their ends, by their numbers:
        self.begun: set[int] = set()
        self.whole_values: dict[int, Any] = {}  # the value of the whole expression
        # The values of its parts, by their spans
        self.parts: defaultdict[int, dict] = defaultdict(dict)
        self.called: defaultdict[int, list[Called]] = defaultdict(list)
        self.before: dict[int, tuple] = {}  # what a method may change, and a copy from before
        # The errors that an except has taken, by the statement that has stopped
        self.hidden: dict[int, str] = {}
        self.result: Any = None
        self.returned = 0  # the number of the return that gave the result, 0 without one
        self.is_whole = True  # whether it was watched to its end

    @property
    def file(self) -> str:
        return self.frame.f_code.co_filename

    def begin(self, number: int) -> None:
        """A statement begins: forget its traces from a turn that an error has stopped."""
        self.begun.add(number)
        self.turns_now[number] = 0
        for kept in (self.whole_values, self.parts, self.called, self.before):
            kept.pop(number, None)


class Change(NamedTuple):
    """A value of a dictionary that a call has changed."""

    key: str
    dictionary: dict
    name: str  # of the dictionary
    text: str  # the new value


def changes_in_words(changes: list[Change]) -> list[str]:
    """Return which values of dictionaries a call has changed: a text for each key."""
    by_key: dict[str, list[Change]] = {}
    for change in changes:
        by_key.setdefault(change.key, []).append(change)
    found: list[str] = []
    for key, same_key in by_key.items():
        if len(same_key) > FEW_CHANGES:
            whose = number_of([change.dictionary for change in same_key])
            found.append(f"set {key} of {whose} to {', '.join(each.text for each in same_key)}")
        else:
            texts = [f"{change.name} to {change.text}" for change in same_key]
            found.append(f"set {key} of {' and '.join(texts)}")
    return found


def gave_in_words(result: Any, changes: list[Change], names: dict[int, str]) -> str:
    """Return the result of a call, and what it has changed."""
    texts = changes_in_words(changes)
    if result is not None:
        return " and ".join([f"gave {in_words(result, names)}", *texts])
    return " and ".join(texts) or "gave None"


def got_by(function: Callable, arguments: tuple, options: dict[str, Any], frame: FrameType) -> str:
    """Return what a function gets in a call from a frame, by the names of its parameters.

    What it gets under the same name from a parameter of the caller is left out.
    """
    names = names_in(frame)
    parameters = frame.f_code.co_varnames[: frame.f_code.co_argcount]
    try:
        values = inspect.signature(function).bind(*arguments, **options).arguments
    except TypeError:  # Python says it
        return ""
    found = []
    for name, value in values.items():
        if name not in parameters or frame.f_locals.get(name) is not value:
            found.append(f"{name} = {in_words(value, names)}")
    return ", ".join(found)


def changed_keys(value: dict, before: dict) -> list:
    """Return the keys of a dictionary that have another value than before, also an equal one."""
    return [key for key in value if value[key] is not before.get(key)]


def dictionaries_in(values: Iterable) -> list[dict]:
    """Return the dictionaries in these values, and in the lists among them."""
    found = []
    for value in values:
        elements = value if type(value) is list else [value]
        found += [element for element in elements if type(element) is dict]
    return found
