"""The student's functions in the grader's own process."""

import importlib
import os
import sys
from collections.abc import Callable
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any

from grading import limits
from grading.handout import FUNCTIONS
from grading.project_path import ROOT
from grading.raised import Raised, raised_by, StoppedError
from support.constants import NC_FP
from support.start.options import command_line


class OwnProcess:
    """Finds and calls the student's functions. The Solver of tests/teacher/ has the same methods."""

    watch = command_line("tests/watch.py", ROOT)  # the command that plays a check
    has_written = False  # whether the last call has changed newton_cradle_pends.csv, which was then put back

    def __init__(self):
        self.called: dict[str, list[str]] = {}  # the names of functions of the handout in the code of each one

    @contextmanager
    def check(self, is_again=False):
        """Keep the limits of a check in the body of the with statement. is_again: import the modules again."""
        with limits.patience(), limits.without_ends(), self.again() if is_again else nullcontext():
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
                with working_in(ROOT), limits.limited_memory():  # the check may be in another folder
                    importlib.import_module(name)
            except BaseException as error:  # also SystemExit
                raise StoppedError(raised_by(error)._replace(before="import")) from None
        found = getattr(sys.modules[name], function, None)
        if not callable(found):
            raise StoppedError(Raised(before="missing"))
        return found

    def run(self, function, arguments, times=1) -> Any:
        """Call a function of the handout, and return its result; raise a StoppedError if this fails.

        times is the number of calls; if the function returns values, they begin the arguments of the next call.
        """
        shipped, self.has_written = Path(NC_FP), False
        before = shipped.read_bytes() if shipped.is_file() else None
        try:
            solution = self.find(function)
            names = getattr(getattr(solution, "__code__", None), "co_names", ())
            self.called[function] = [name for name in FUNCTIONS if name in names]
            with limits.limited_memory():
                for _ in range(times):
                    result = solution(*arguments)
                    if FUNCTIONS[function].returns and isinstance(result, tuple):
                        arguments = (*result, *arguments[len(result) :])
                return result
        except StoppedError:
            raise
        except BaseException as error:  # also SystemExit
            raise StoppedError(raised_by(error)) from None
        finally:
            if before is not None and not (shipped.is_file() and shipped.read_bytes() == before):
                shipped.write_bytes(before)
                self.has_written = True


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
