"""How a method of the Watch traces something of a call; and what stops a loop without end."""

import sys
from collections.abc import Callable
from contextlib import suppress
from functools import wraps
from typing import Any

MOST_TURNS = 1000  # of a loop, in a function that went over the limit of time: then it is stopped


class EndlessError(BaseException):
    """A loop has made MOST_TURNS turns in a function that went over the limit of time."""


def tracing(method: Callable) -> Callable:
    """Return a function that lets a method of the Watch trace something of the call that calls it.

    The changed code gives it the number of a statement and some values. It calls the method with
    the watched call in front of these, and returns the last value. It raises an EndlessError, but
    no other error: the values are a student's.
    """

    @wraps(method)
    def trace(self: Any, statement_number: int, *values: Any) -> Any:
        call = self.call_of(sys._getframe(1))
        if call:
            with suppress(Exception):
                method(self, call, statement_number, *values)
        return values[-1] if values else None

    return trace
