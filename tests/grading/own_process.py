"""The student's functions in the grader's own process."""

import importlib
import inspect
import linecache
import os
import sys
from collections import defaultdict
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple
from unittest.mock import patch

from grading import limits
from grading.handout import FUNCTIONS
from grading.raised import Raised, raised_by, StoppedError

# The CSV that solutions read instead of the shipped one; each pendulum has another mass.
SHIPPED_CSV = "mass,e,theta,omega,color,texture\n" + "".join(f"{i}.25,0.5,0.0,0.0,cyan,none\n" for i in range(1, 6))


class Code(NamedTuple):
    """What is known of a student's function."""

    line: int = 0  # the first one in its file
    names: list[str] = []  # in its code
    parameters: str = ""  # with commas
    source: str = ""


class OwnProcess:
    """Finds and calls the student's functions. The Solver of tests/teacher/ has the same methods.

    They find a CSV of the grader in place of newton_cradle_pends.csv: yours may have a mistake, and stays as it is.
    """

    has_written = False  # whether the last call has changed the grader's CSV, which was then put back

    def __init__(self):
        self.codes: dict[str, Code] = defaultdict(Code)  # of each function that was called
        self.folder = TemporaryDirectory(ignore_cleanup_errors=True)  # a solution may leave a file open
        self.shipped = Path(self.folder.name) / "newton_cradle_pends.csv"
        self.shipped.write_text(SHIPPED_CSV)

    @contextmanager
    def check(self):
        """Keep the limits of a check in the body of the with statement."""
        with limits.patience(limits.PATIENCE), limits.without_ends(), working_in(self.folder.name):
            yield

    def find(self, function) -> Callable:
        """Return a function of the handout; raise a StoppedError if its file lacks it, or cannot be imported."""
        name = module_of(FUNCTIONS[function].file)
        if name not in sys.modules:
            try:
                with patch("support.constants.NC_FP", str(self.shipped)), limits.limited_memory():
                    importlib.import_module(name)
            except BaseException as error:  # also SystemExit
                raise StoppedError(replace(raised_by(error), before="import")) from None
        found = getattr(sys.modules[name], function, None)
        if not callable(found):
            raise StoppedError(Raised(before="missing"))
        return found

    def run(self, function, arguments, times=1) -> Any:
        """Call a function of the handout, and return its result; raise a StoppedError if this fails.

        times is the number of calls; if the function returns values, they begin the arguments of the next call.
        """
        self.has_written = False
        try:
            solution = self.find(function)
            code = getattr(solution, "__code__", None)
            if code:
                self.codes[function] = known_of(code)
            with limits.limited_memory():
                return self.repeated(solution, function, arguments, times)
        except StoppedError:
            raise
        except BaseException as error:  # also SystemExit
            raise StoppedError(raised_by(error, function)) from None
        finally:
            self.put_back()

    def repeated(self, solution, function, arguments, times) -> Any:
        """Call a solution of a function, and return the last result."""
        for _ in range(times):
            result = solution(*arguments)
            if FUNCTIONS[function].returns and isinstance(result, tuple):
                arguments = (*result, *arguments[len(result) :])
        return result

    def put_back(self) -> None:
        """Set has_written; if it is True, make the grader's CSV again."""
        self.has_written = not (self.shipped.is_file() and self.shipped.read_text(errors="replace") == SHIPPED_CSV)
        if self.has_written:
            self.shipped.write_text(SHIPPED_CSV)


@cache
def known_of(code) -> Code:
    """Return what is known of a function with this code."""
    parameters = ", ".join(code.co_varnames[: code.co_argcount])
    source = "".join(inspect.getblock(linecache.getlines(code.co_filename)[code.co_firstlineno - 1 :]))
    return Code(code.co_firstlineno, [*code.co_names], parameters, source)


@contextmanager
def working_in(folder):
    """Make this folder the working directory, in the body of the with statement."""
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def module_of(file) -> str:
    """Return the module name of a file of the project."""
    return file.removesuffix(".py").replace("/", ".")
