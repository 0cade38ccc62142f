"""The student's functions, as the grader finds and calls them."""

import ast
import atexit
import importlib
import shutil
import sys
from collections.abc import Callable
from contextlib import nullcontext, suppress
from linecache import getlines
from pathlib import Path
from tempfile import TemporaryDirectory
from types import CodeType
from typing import Any
from unittest.mock import patch

from grading.begin import ROOT

from grading.check_player import CheckPlayer
from grading.handout import FUNCTIONS, is_students, module_of, PROGRAM
from grading.limits import limited_memory, Limits
from grading.raised import own_file, StoppedError
from line_by_line.trace import Trace
from support import simulation
from support.files.source_files import fresh_modules, main_module, run_file

PROGRAM_FILE = ROOT / FUNCTIONS[PROGRAM].file
# The CSV that solutions read instead of the shipped one; each pendulum has another mass.
SHIPPED_CSV = """\
mass,e,theta,omega,color,texture
1.25,0.5,0.0,0.0,cyan,none
2.25,0.5,0.0,0.0,cyan,none
3.25,0.5,0.0,0.0,cyan,none
4.25,0.5,0.0,0.0,cyan,none
5.25,0.5,0.0,0.0,cyan,none
"""


class MissingError(Exception):
    """A file lacks the function that the handout asks for."""


class StudentsCode:
    """Finds and calls the student's functions, and runs the program, in the grader's process.

    They find a CSV of the grader in place of newton_cradle_pends.csv: yours may have a mistake, and
    stays as it is.
    """

    def __init__(self) -> None:
        # A solution may leave a file open
        self.folder = TemporaryDirectory(ignore_cleanup_errors=True)
        atexit.register(self.folder.cleanup)  # or Python warns of it at the end
        folder = Path(self.folder.name)
        for file in ROOT.glob("*.csv"):  # the program may use one of them
            with suppress(OSError):
                shutil.copyfile(file, folder / file.name)
        self.shipped = folder / "newton_cradle_pends.csv"
        self.shipped.write_text(SHIPPED_CSV)
        # Whether the last call has changed this CSV, which was then put back
        self.has_written = False

    def find(self, function: str) -> Callable:
        """Return a function of the handout; raise a MissingError if its file lacks it.

        Errors of its import pass.
        """
        if function == PROGRAM:
            return self.run_program
        module = importlib.import_module(module_of(FUNCTIONS[function].file))
        found = getattr(module, function, None)
        if not callable(found):
            raise MissingError
        return found

    def run_program(self, player: CheckPlayer) -> None:
        """Run the student's program from its top, as when it is started; a player lets it tick."""
        program = main_module(PROGRAM_FILE)
        player.begin()
        try:
            with fresh_modules():
                simulation.play(lambda: run_file(program), player)
        except SystemExit as end:  # exit() without an error ends the run, as on the page
            if end.code:
                raise

    def run(
        self,
        function: str,
        arguments: tuple,
        times: int,
        limits: Limits,
        trace: Trace | None = None,
    ) -> Any:
        """Call a function of the handout this number of times, and return the last result.

        Each result gives the first arguments of the next call. A trace is on in the last one.
        Raises a StoppedError if the function or its import fails.
        """
        called = ""
        try:
            grader_csv = patch("support.constants.NC_FP", str(self.shipped))
            with limited_memory(limits.memory), grader_csv:
                solution = self.find(function)
                called = function
                for i in range(times):
                    with trace.on() if trace and i == times - 1 else nullcontext():
                        result = solution(*arguments)
                    if limits.stopped_by:  # the function has caught the interrupt
                        raise KeyboardInterrupt
                    if FUNCTIONS[function].returns and isinstance(result, tuple):
                        arguments = (*result, *arguments[len(result) :])
                return result
        except MissingError:
            raise
        except BaseException as error:  # also SystemExit
            if limits.is_debugged and type(error).__name__ in ("BdbQuit", "Exit"):
                raise  # somebody has ended the debugger, and with it pytest
            raise StoppedError(error, called, limits.over_limit(error)) from None
        finally:
            self.put_back()

    def put_back(self) -> None:
        """Set has_written; if it is True, make the grader's CSV again."""
        self.has_written = True
        if self.shipped.is_file():
            self.has_written = self.shipped.read_text(errors="replace") != SHIPPED_CSV
        if self.has_written:
            self.shipped.write_text(SHIPPED_CSV)


def code_of(function: str) -> CodeType | None:
    """Return the code of a student's function, or of the program's block, if it is there."""
    with suppress(Exception):  # it is not imported, or no plain function
        if function == PROGRAM:
            module = ast.parse("".join(getlines(str(PROGRAM_FILE))))
            module.body = [statement for statement in module.body if isinstance(statement, ast.If)]
            return compile(module, str(PROGRAM_FILE), "exec")
        module_name = module_of(FUNCTIONS[function].file)
        return getattr(sys.modules[module_name], function).__code__
    return None


def names_in(code: CodeType | None) -> set[str]:
    """Return the names that a code uses, and the functions in it."""
    if not code:
        return set()
    names = {*code.co_names}
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            names |= names_in(constant)
    return names


def is_watched(code: CodeType, function: str) -> bool:
    """Return whether a table shows a call: of this function, or of a helper of the student's."""
    if code.co_name == "<module>":
        return function == PROGRAM and code.co_filename == str(PROGRAM_FILE)
    return bool(own_file(code.co_filename)) and is_students(code.co_name, function)


def is_named(code: CodeType) -> bool:
    """Return whether a table names the calls of a function: it is of src/, or makes pendula."""
    file = code.co_filename
    return bool(own_file(file)) or file == str(ROOT / "support" / "pendulum.py")
