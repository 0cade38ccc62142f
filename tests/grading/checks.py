"""The checks of the students' functions, as the suites have them.

A check is a function in a suite, such as test_d.py, with @check above it, which names the function
of the handout. Its docstring, in words of the handout, is its title. It calls the student's
function through expect of grader.py. A suite also has STEPS: a sentence for each of its functions.
"""

import importlib
from collections.abc import Callable
from typing import Any, NamedTuple

from grading.handout import SUITES


class Check(NamedTuple):
    """A check of a student's function, which gives one point."""

    name: str
    title: str
    tier: str
    function: str  # the name of the function that is checked
    ask: Callable  # calls the function; raises WrongError or WaitError


def check(function: str) -> Callable:
    """Return a decorator that marks a check of this function."""

    def mark(ask: Any) -> Any:
        ask.checks_function = function
        return ask

    return mark


def collect() -> tuple[dict[str, Check], dict[str, str]]:
    """Return the checks by name, in the order of the suites, and the steps by function."""
    checks = {}
    steps = {}
    for tier, module in SUITES.items():
        try:
            suite = importlib.import_module(module)
        except Exception:  # pytest says it when it collects this file
            continue
        steps.update(suite.STEPS)
        for name, ask in vars(suite).items():
            function = getattr(ask, "checks_function", None)
            if function:
                title = " ".join(ask.__doc__.split())
                checks[name] = Check(name, title, tier, function, ask)
    return checks, steps
