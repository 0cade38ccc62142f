"""Limits for students' functions: they cannot take all memory, ask somebody, or end the process of the grader.

This is for mistakes. It is no protection from a student who means harm.
"""

import builtins
import os
from contextlib import contextmanager
from pathlib import Path

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]

MOST_MEMORY = 1000  # MB
SPARE = 2**18  # bytes, for the message about a call that took all its memory

MEMORY_IN_USE = Path("/proc/self/statm")  # Linux has it; its sixth number counts the pages of data

ENDS = [(os, "_exit"), (os, "abort"), (os, "kill")]  # functions that end the process, even without an error


def in_limited_memory(function, *arguments):
    """Return function(*arguments). On Linux, raise a MemoryError if the call takes more than MOST_MEMORY."""
    if resource is None or not MEMORY_IN_USE.exists():
        return function(*arguments)
    in_use = int(MEMORY_IN_USE.read_text().split()[5]) * resource.getpagesize()
    before = resource.getrlimit(resource.RLIMIT_DATA)
    allowed = [limit for limit in before if limit != resource.RLIM_INFINITY]
    spare = bytearray(SPARE)
    resource.setrlimit(resource.RLIMIT_DATA, (min([in_use + MOST_MEMORY * 10**6, *allowed]), before[1]))
    try:
        return function(*arguments)
    finally:
        del spare  # first: without it, the next line could raise a MemoryError, too
        resource.setrlimit(resource.RLIMIT_DATA, before)


@contextmanager
def without_ends():
    """In the body of the with statement, functions that end the process raise a SystemExit, and input an EOFError.

    A process that the body starts can end as it likes.
    """
    kept = [(module, name, getattr(module, name)) for module, name in [*ENDS, (builtins, "input")]]
    for module, name, function in kept[:-1]:
        setattr(module, name, refusal(f"os.{name}", function))
    builtins.input = no_answer
    try:
        yield
    finally:
        for module, name, function in kept:
            setattr(module, name, function)


def refusal(name, end):
    """Return a function that takes the place of end in this process."""
    process = os.getpid()

    def refused(*arguments):
        ends_another = os.getpid() != process or (name == "os.kill" and arguments[:1] != (process,))
        if ends_another:
            return end(*arguments)
        raise SystemExit(f"{name}({', '.join(map(str, arguments))})")

    return refused


def no_answer(*_):
    """Take the place of input."""
    raise EOFError("input() waits for somebody, but nobody answers in a check")
