"""The controls of the page, and the commands of its tabs.

A control is declared once, in declarations.py. All else follows: its description in the state, with
its value; which values the command `set` may give it; and its element. In its place of page.html,
controls.js makes a checkbox of a Switch, a slider of a Slider, and a menu of a Menu.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any


def is_text(value: Any) -> bool:
    return type(value) is str


def is_count(value: Any) -> bool:
    return type(value) is int and value >= 0


def is_number(value: Any) -> bool:
    return type(value) in (int, float) and abs(value) < 1e9


def is_point(value: Any) -> bool:
    return type(value) is list and len(value) == 3 and all(map(is_number, value))


def is_direction(value: Any) -> bool:
    return is_point(value) and max(map(abs, value)) > 1e-3


@dataclass
class Command:
    """What a command of a tab does, and a test for each of its values, which come as JSON."""

    do: Callable[..., None]
    tests: tuple[Callable[[Any], bool], ...] = ()

    def takes(self, values: Sequence) -> bool:
        """Return whether these are values of this command."""
        if len(values) != len(self.tests):
            return False
        return all(test(value) for test, value in zip(self.tests, values, strict=True))


@dataclass
class Control:
    """A control: its place on the page, its words, and its value."""

    place: str  # as in data-place of page.html; the controls of a place stand in their order
    label: str
    help: str  # appears under a mouse that rests on it
    get: Callable[[], Any]
    set: Callable[[Any], None]
    is_enabled: Callable[[], bool] = field(default=lambda: True, kw_only=True)

    def allows(self, value: Any) -> bool:
        """Return whether the value, which comes as JSON, can be set."""
        raise NotImplementedError

    def takes(self, value: Any) -> bool:
        """Return whether a tab can set this value, which comes as JSON, now."""
        return self.is_enabled() and self.allows(value)

    def description(self) -> dict[str, Any]:
        """Return what the page needs to make and to fill the element."""
        return {
            "kind": type(self).__name__,
            "place": self.place,
            "label": self.label,
            "help": self.help,
            "enabled": self.is_enabled(),
            "value": self.get(),
        }


@dataclass
class Switch(Control):
    """A value that is true or false."""

    def allows(self, value: Any) -> bool:
        return type(value) is bool


@dataclass
class Slider(Control):
    """A number from the least to the largest one."""

    limits: Callable[[], tuple[float, float]]
    as_text: Callable[[Any], str]
    step: float = 1  # a slider whose step is 1 takes whole numbers

    def allows(self, value: Any) -> bool:
        least, largest = self.limits()
        has_kind = type(value) is int if self.step == 1 else is_number(value)
        return has_kind and least <= value <= largest

    def description(self) -> dict[str, Any]:
        least, largest = self.limits()
        description = super().description()
        value = description["value"]
        return {
            **description,
            "min": least,
            "max": largest,
            "step": self.step,
            "text": "?" if value is None else self.as_text(value),
        }


@dataclass
class Menu(Control):
    """One of several names."""

    choices: Callable[[], Sequence[str]]

    def allows(self, value: Any) -> bool:
        return value in self.choices()

    def description(self) -> dict[str, Any]:
        return {**super().description(), "choices": list(self.choices())}
