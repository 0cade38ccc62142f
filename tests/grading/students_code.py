"""The student's functions, as the grader finds and calls them."""

import atexit
import importlib
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple
from unittest.mock import patch

from grading import limits
from grading.handout import FUNCTIONS, module_of
from grading.instrument import watched
from grading.present import present
from grading.raised import stopped_error

# The CSV that solutions read instead of the shipped one; each pendulum has another mass.
SHIPPED_CSV = """\
mass,e,theta,omega,color,texture
1.25,0.5,0.0,0.0,cyan,none
2.25,0.5,0.0,0.0,cyan,none
3.25,0.5,0.0,0.0,cyan,none
4.25,0.5,0.0,0.0,cyan,none
5.25,0.5,0.0,0.0,cyan,none
"""


class Code(NamedTuple):
    """What is known of a student's function."""

    line: int = 0  # the first one in its file
    names: tuple[str, ...] = ()  # in its code
    parameters: str = ""  # with commas


class MissingError(Exception):
    """A file lacks the function that the handout asks for."""


class StudentsCode:
    """Finds and calls the student's functions, in the process of the grader.

    They find a CSV of the grader in place of newton_cradle_pends.csv: yours may have a mistake, and
    stays as it is.
    """

    def __init__(self) -> None:
        # A solution may leave a file open
        self.folder = TemporaryDirectory(ignore_cleanup_errors=True)
        atexit.register(self.folder.cleanup)  # or Python warns of it at the end
        self.shipped = Path(self.folder.name) / "newton_cradle_pends.csv"
        self.shipped.write_text(SHIPPED_CSV)
        # Whether the last call has changed this CSV, which was then put back
        self.has_written = False

    def find(self, function: str) -> Callable:
        """Return a function of the handout; raise a MissingError if its file lacks it.

        Errors of its import pass.
        """
        with patch("support.constants.NC_FP", str(self.shipped)):
            module = importlib.import_module(module_of(FUNCTIONS[function].file))
        found = getattr(module, function, None)
        if not callable(found):
            raise MissingError
        return found

    def run(self, function: str, arguments: tuple, times: int = 1) -> Any:
        """Call a function of the handout, and return its result.

        Raises a StoppedError if it or its import fails.
        """
        solution = None
        present.calls += 1
        watch = present.watch
        try:
            with limits.limited_memory():
                solution = self.find(function)
                if watch and present.calls == watch.call_number:
                    with watched(function, watch):
                        return self.repeated(solution, function, arguments, times)
                return self.repeated(solution, function, arguments, times)
        except MissingError:
            raise
        except BaseException as error:  # also SystemExit
            if present.is_debugged and type(error).__name__ in ("BdbQuit", "Exit"):
                raise  # somebody has ended the debugger, and with it pytest
            if limits.is_for_want_of_shared(error):
                present.shared_was_short = True
            if watch:
                watch.error = error
            raise stopped_error(error, "" if solution is None else function) from None
        finally:
            self.put_back()

    def repeated(self, solution: Callable, function: str, arguments: tuple, times: int) -> Any:
        """Call a solution this number of times; return the last result.

        Each result gives the first arguments of the next call.
        """
        for _ in range(times):
            if present.watch:
                present.watch.begin(arguments)
            result = solution(*arguments)
            if FUNCTIONS[function].returns and isinstance(result, tuple):
                arguments = (*result, *arguments[len(result) :])
        return result

    def put_back(self) -> None:
        """Set has_written; if it is True, make the grader's CSV again."""
        self.has_written = True
        if self.shipped.is_file():
            self.has_written = self.shipped.read_text(errors="replace") != SHIPPED_CSV
        if self.has_written:
            self.shipped.write_text(SHIPPED_CSV)


def code_of(function: str) -> Code:
    """Return what is known of a student's function, if it is there."""
    with suppress(Exception):  # it is not imported, or no plain function
        module = sys.modules[module_of(FUNCTIONS[function].file)]
        code = getattr(module, function).__code__
        parameters = code.co_varnames[: code.co_argcount]
        return Code(code.co_firstlineno, code.co_names, ", ".join(parameters))
    return Code()


@contextmanager
def working_in(folder: str) -> Iterator[None]:
    """Make this folder the working directory, in the body of the with statement."""
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
