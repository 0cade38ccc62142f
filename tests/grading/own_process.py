"""The student's functions in the grader's own process."""

import importlib
import inspect
import linecache
import os
import sys
from collections import defaultdict
from collections.abc import Callable
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple
from unittest.mock import patch

from grading.begin import ROOT

from grading import limits
from grading.handout import FUNCTIONS
from grading.raised import Raised, raised_by, StoppedError
from grading.values import all_in_words, noting_ends
from support.start.options import command_line

# The CSV that solutions read instead of the shipped one; each pendulum has another mass.
SHIPPED_CSV = "mass,e,theta,omega,color,texture\n" + "".join(f"{i}.25,0.5,0.0,0.0,cyan,none\n" for i in range(1, 6))


class Code(NamedTuple):
    """What is known of a student's function."""

    line: int = 0  # the first one in its file
    names: list[str] = []  # in its code
    parameters: str = ""  # with commas
    source: str = ""
    values: str = ""  # of its names at its end, in words


class OwnProcess:
    """Finds and calls the student's functions. The Solver of tests/teacher/ has the same methods.

    They find a CSV of the grader in place of newton_cradle_pends.csv: yours may have a mistake, and stays as it is.
    """

    watch = command_line("tests/watch.py", ROOT)  # the command that plays a check
    has_written = False  # whether the last call has changed the grader's CSV, which was then put back

    def __init__(self):
        self.codes: dict[str, Code] = defaultdict(Code)  # of each function that was called
        self.folder = TemporaryDirectory(ignore_cleanup_errors=True)  # a solution may leave a file open
        self.shipped = Path(self.folder.name) / "newton_cradle_pends.csv"
        self.shipped.write_text(SHIPPED_CSV)

    @contextmanager
    def check(self, is_again=False):
        """Keep the limits of a check in the body of the with statement. is_again: import the modules again."""
        again = self.again() if is_again else nullcontext()
        with limits.patience(), limits.without_ends(), working_in(self.folder.name), again:
            yield

    @contextmanager
    def again(self):
        """Let the body of the with statement import the student's modules again, so that they have kept nothing."""
        kept = {name: sys.modules.pop(name) for name in students_modules()}
        try:
            yield
        finally:
            for name in students_modules():
                del sys.modules[name]
            sys.modules.update(kept)

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
        self.has_written, values = False, {}
        try:
            solution = self.find(function)
            code = getattr(solution, "__code__", None)
            if code:
                self.codes[function] = known_of(code)
            with limits.limited_memory(), noting_ends(code, values):
                for _ in range(times):
                    result = solution(*arguments)
                    if FUNCTIONS[function].returns and isinstance(result, tuple):
                        arguments = (*result, *arguments[len(result) :])
            self.codes[function] = self.codes[function]._replace(values=all_in_words(values.items()))
            return result
        except StoppedError:
            raise
        except BaseException as error:  # also SystemExit
            raise StoppedError(raised_by(error)) from None
        finally:
            if not (self.shipped.is_file() and self.shipped.read_text(errors="replace") == SHIPPED_CSV):
                self.shipped.write_text(SHIPPED_CSV)
                self.has_written = True


@cache
def known_of(code) -> Code:
    """Return what is known of a function with this code."""
    parameters = ", ".join(code.co_varnames[: code.co_argcount])
    source = "".join(inspect.getblock(linecache.getlines(code.co_filename)[code.co_firstlineno - 1 :]))
    return Code(code.co_firstlineno, [*code.co_names], parameters, source)


def students_modules() -> list[str]:
    """Return the names of the modules of src/ that are imported."""
    return [name for name in sys.modules if name.partition(".")[0] == "src"]


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
