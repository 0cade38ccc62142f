"""The student's functions, as the grader finds and calls them."""

import ast
import atexit
import importlib
import shutil
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, ExitStack, nullcontext, suppress
from functools import partial
from linecache import getlines
from pathlib import Path
from tempfile import TemporaryDirectory
from types import CodeType, ModuleType
from typing import Any
from unittest.mock import Mock, patch

from grading.begin import ROOT

from grading.assignment import FUNCTIONS, GIVEN, is_students, module_of, PROGRAM
from grading.check_player import CheckPlayer
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
    """A file lacks the function that the assignment asks for."""


@contextmanager
def placed(stand_ins: dict[str, Callable]) -> Iterator[None]:
    """Let stand-ins take the place of functions, by their names, in all modules of src/."""
    with ExitStack() as stack:
        for function, stand_in in stand_ins.items():
            for name, module in sys.modules.items():
                if name.startswith("src.") and hasattr(module, function):
                    stack.enter_context(patch.object(module, function, stand_in))
        yield


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

    def replace(self, file: str) -> bool:
        """Let other files import from this one, which Python cannot read.

        The functions that they find raise an ImportError. Return whether it was not replaced yet.
        """
        name = module_of(file)
        is_new = hasattr(sys.modules.get(name), "__file__") or name not in sys.modules
        if is_new:
            module = sys.modules[name] = ModuleType(name)
            raises = Mock(side_effect=ImportError(f"{file} cannot be read"))
            vars(module).update(dict.fromkeys([*FUNCTIONS, *GIVEN], raises))
        return is_new

    def find(self, function: str, stand_ins: dict[str, Callable]) -> Callable:
        """Return a function of the assignment; raise a MissingError if its file lacks it.

        Errors of its import pass.
        """
        if function == PROGRAM:
            return partial(self.run_program, stand_ins=stand_ins)
        module = importlib.import_module(module_of(FUNCTIONS[function].file))
        found = getattr(module, function, None)
        if not callable(found):
            raise MissingError
        return found

    def run_program(self, player: CheckPlayer, stand_ins: dict[str, Callable]) -> None:
        """Run the student's program as when it is started; a player lets it tick.

        It runs from its top. With stand-ins, its file is imported, and then its block runs.
        """
        player.begin()
        try:
            with fresh_modules():
                if stand_ins:
                    program = importlib.import_module(module_of(FUNCTIONS[PROGRAM].file))
                    program.__name__ = "__main__"
                    block = code_of(PROGRAM)
                else:
                    program = main_module(PROGRAM_FILE)
                    block = None
                with placed(stand_ins):
                    simulation.run(lambda: run_file(program, block), player)
        except SystemExit as end:  # exit() without an error ends the run, as on the page
            if end.code:
                raise

    def run(
        self,
        function: str,
        arguments: tuple,
        times: int,
        limits: Limits,
        stand_ins: dict[str, Callable],
        trace: Trace | None = None,
    ) -> Any:
        """Call a function of the assignment this number of times, and return the last result.

        Each result gives the first arguments of the next call. stand_ins take the place of other
        functions, by name. A trace is on in the last call. Raises a StoppedError if the function or
        its import fails.
        """
        called = ""
        try:
            grader_csv = patch("support.constants.NC_FP", str(self.shipped))
            with limited_memory(limits.memory), grader_csv:
                solution = self.find(function, stand_ins)
                called = function
                for i in range(times):
                    tracing = trace.on() if trace and i == times - 1 else nullcontext()
                    with placed(stand_ins), tracing:
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
            self.shipped.write_text(SHIPPED_CSV)  # the call may have changed it


def code_of(function: str) -> CodeType | None:
    """Return the code of a student's function, if it is a plain one, or of the program's block."""
    if function == PROGRAM:
        module = ast.parse("".join(getlines(str(PROGRAM_FILE))))
        module.body = [statement for statement in module.body if isinstance(statement, ast.If)]
        return compile(module, str(PROGRAM_FILE), "exec")
    module_name = module_of(FUNCTIONS[function].file)
    return getattr(getattr(sys.modules[module_name], function), "__code__", None)


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
