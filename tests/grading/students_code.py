"""The student's functions, as the grader finds and calls them."""

import ast
import atexit
import importlib
import os
import shutil
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from linecache import getlines
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FunctionType, ModuleType
from typing import Any, NamedTuple
from unittest.mock import patch

from grading.begin import ROOT

from grading import limits
from grading.check_player import CheckPlayer
from grading.handout import FUNCTIONS, is_students, module_of, PROGRAM
from grading.messages import own_copies
from grading.present import present
from grading.raised import stopped_error
from line_by_line.instrument import watched
from line_by_line.state import state_of
from line_by_line.watch import Watch
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


class Code(NamedTuple):
    """What is known of a student's function."""

    line: int = 0  # the first one in its file
    names: tuple[str, ...] = ()  # in its code
    parameters: str = ""  # with commas


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
        for file in ROOT.glob("*.csv"):  # the program may use one of them
            with suppress(OSError):
                shutil.copyfile(file, Path(self.folder.name) / file.name)
        self.shipped = Path(self.folder.name) / "newton_cradle_pends.csv"
        self.shipped.write_text(SHIPPED_CSV)
        # Whether the last call has changed this CSV, which was then put back
        self.has_written = False

    def find(self, function: str) -> Callable:
        """Return a function of the handout; raise a MissingError if its file lacks it.

        Errors of its import pass.
        """
        if function == PROGRAM:
            return self.run_program
        with patch("support.constants.NC_FP", str(self.shipped)):
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
            with patch("support.constants.NC_FP", str(self.shipped)), fresh_modules():
                simulation.play(lambda: run_file(program), player)
        except SystemExit as end:  # exit() without an error ends the run, as on the page
            if end.code:
                raise

    def run(self, function: str, arguments: tuple, times: int = 1) -> Any:
        """Call a function of the handout, and return its result.

        Raises a StoppedError if it or its import fails.
        """
        solution = None
        watch = present.watch if function == present.watched_function else None
        try:
            with limits.limited_memory():
                solution = self.find(function)
                if not watch:
                    return self.repeated(solution, function, arguments, times)
                own = own_functions(function)
                before = state_of(own)
                try:
                    with watched(own, watch):
                        return self.repeated(solution, function, arguments, times, watch)
                finally:
                    present.lasting = changes_between(before, state_of(own))
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

    def repeated(
        self,
        solution: Callable,
        function: str,
        arguments: tuple,
        times: int,
        watch: Watch | None = None,
    ) -> Any:
        """Call a solution this number of times; return the last result.

        Each result gives the first arguments of the next call. A watch keeps the last call.
        """
        for _ in range(times):
            if watch:
                watch.begin(arguments)
            result = solution(*arguments)
            if FUNCTIONS[function].returns and isinstance(result, tuple):
                arguments = (*result, *arguments[len(result) :])
        return result

    @contextmanager
    def with_other_values(self, function: str) -> Iterator[Callable]:
        """Yield a function that calls this one with other values than its statements give.

        It gets the arguments, and the values by the numbers of the statements.
        """
        watch = Watch()
        solution = self.find(function)

        def call(arguments: tuple, replaced: dict[int, Any]) -> Any:
            watch.replaced = replaced
            watch.begin(arguments)
            return solution(*own_copies(arguments))

        with watched(own_functions(function), watch):
            yield call

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
        if function == PROGRAM:
            nodes = ast.walk(ast.parse("".join(getlines(str(PROGRAM_FILE)))))
            return Code(names=tuple(node.id for node in nodes if isinstance(node, ast.Name)))
        module = sys.modules[module_of(FUNCTIONS[function].file)]
        code = getattr(module, function).__code__
        parameters = code.co_varnames[: code.co_argcount]
        return Code(code.co_firstlineno, code.co_names, ", ".join(parameters))
    return Code()


def own_functions(function: str) -> list[FunctionType]:
    """Return this function of the handout, and the student's own functions that it can use.

    They are in its file, or in a file from which this one takes them.
    """
    found: list[FunctionType] = []
    namespaces = [vars(sys.modules[module_of(FUNCTIONS[function].file)])]
    for namespace in namespaces:  # it grows
        values = [*namespace.values()]
        for value in [*values]:
            is_own_class = isinstance(value, type) and value.__module__ == namespace["__name__"]
            is_own_file = isinstance(value, ModuleType) and value.__name__.startswith("src.")
            if is_own_class or is_own_file:
                values += vars(value).values()
        for value in values:
            if isinstance(value, FunctionType) and value not in found and is_own(value, function):
                found.append(value)
                if all(value.__globals__ is not known for known in namespaces):
                    namespaces.append(value.__globals__)
    return found


def changes_between(before: dict[str, str], now: dict[str, str]) -> dict[str, str]:
    """Return how a call has changed values that live on, by their names."""
    found = {}
    for name, text in before.items():
        if now.get(name, text) != text:
            found[name] = f"it was {text} when this call began, and {now[name]} at its end"
    return found


def is_own(value: FunctionType, function: str) -> bool:
    """Return whether a function is this one of the handout, or a helper of the student's."""
    code = value.__code__
    is_in_src = Path(code.co_filename).is_relative_to(ROOT / "src")
    return is_in_src and is_students(code.co_name, function)


def is_named(function: FunctionType) -> bool:
    """Return whether a table names the calls of a function: it is of src/, or makes pendula."""
    file = Path(function.__code__.co_filename)
    return file.is_relative_to(ROOT / "src") or file == ROOT / "support" / "pendulum.py"


@contextmanager
def working_in(folder: str) -> Iterator[None]:
    """Make this folder the working directory, in the body of the with statement."""
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
