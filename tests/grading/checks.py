"""The checks of the students' functions, as the suites have them.

A check is a function in a suite, such as test_d.py, with @check above it, which names the function
of the assignment. Its docstring is its title. It calls the student's function through expect of
grader.py. A suite also has STEPS: a sentence for each of its functions.

A function that calls others of the assignment has one more check, alone: with stand-ins for them.
"""

import importlib
import sys
from collections.abc import Callable
from inspect import Parameter, Signature
from typing import Any, NamedTuple

from grading.assignment import FUNCTIONS, SUITES


class Check(NamedTuple):
    """A check of a student's function, which gives one point."""

    name: str
    title: str
    tier: str
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises WrongError or WaitError
    stand_ins: tuple[tuple[str, Callable], ...] = ()  # pairs of a function, and what it gives


def check(function: str, **stand_ins: Callable) -> Callable:
    """Return a decorator that marks a check of this function.

    With stand-ins, it is the check of this function alone.
    """

    def mark(ask: Any) -> Any:
        if ask.__module__ == "__main__":  # the file was started, and not by pytest
            sys.exit("These are checks. Type pytest in this folder to run them.")
        ask.marks = [*getattr(ask, "marks", []), (function, (*stand_ins.items(),))]
        return ask

    return mark


def stand_in(function: str, gives: Callable, called: set[str]) -> Callable:
    """Return a function that stands in for one of the assignment.

    It notes that it was called, and returns what gives returns for the arguments, in the order of
    the assignment. A call that does not fit them raises a TypeError, and is not noted.
    """
    names = FUNCTIONS[function].parameters.split(", ")
    signature = Signature([Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in names])

    def give(*values: Any, **by_name: Any) -> Any:
        arguments = signature.bind(*values, **by_name).args
        called.add(function)
        return gives(*arguments)

    return give


class Suites(NamedTuple):
    """What all suites have."""

    checks: dict[str, Check]  # by name, in the order of the suites
    alone: dict[str, Check]  # those with stand-ins, by function
    steps: dict[str, str]  # by function


def collect() -> Suites:
    """Return what all suites have."""
    found = Suites({}, {}, {})
    for tier, module in SUITES.items():
        try:
            suite = importlib.import_module(module)
        except Exception:  # pytest says it when it collects this file
            continue
        found.steps.update(suite.STEPS)
        for name, ask in vars(suite).items():
            for function, stand_ins in getattr(ask, "marks", []):
                title = " ".join(ask.__doc__.split())
                marked = Check(name, title, tier, function, ask, stand_ins)
                if stand_ins:
                    found.alone[function] = marked
                else:
                    found.checks[name] = marked
    return found
