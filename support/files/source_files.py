"""The files of src/, and those beside it: run one, forget them, notice that you have saved one.

A program runs again from its top for each cradle. So what you have saved is what runs.
"""

import linecache
import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cache
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from importlib.util import decode_source
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from support.files.cradle_csv import Live
from support.root import ROOT, SRC

# The imports that have begun the program: in a run, they do nothing.
BEGINNINGS = ("begin", "begin_page")
CONSTANTS = ROOT / "support" / "constants.py"
QUIET = 0.5  # s without a change, after which a file counts as saved: a formatter may save it again


@cache
def is_source_folder(folder: str) -> bool:
    """Return whether a folder is src/, or the one around it."""
    return Path(folder).resolve() in (SRC, ROOT)


# --- a run ---------------------------------------------------------------------------------------


def main_module(file: Path) -> ModuleType:
    """Return a main module for a program, this file of src/; it has no names of the file yet."""
    module = ModuleType("__main__")
    vars(module).update(__file__=str(file), __package__="src")  # for `from .swinging import`
    return module


def run_file(module: ModuleType, code: CodeType | None = None) -> None:
    """Run the file of a main module from its top, or this code; the module then has its names.

    fresh_modules is around this.
    """
    main = sys.modules["__main__"]
    for name in ("__main__", *BEGINNINGS):
        sys.modules[name] = module  # an import of a beginning finds it, and runs nothing
    try:
        exec(code or code_of(str(module.__file__)), vars(module))
    finally:
        sys.modules["__main__"] = main


def code_of(file: str) -> CodeType:
    """Return the code of a file, from its text; tracebacks then show the lines of this text."""
    source = Path(file).read_bytes()
    code = compile(source, file, "exec", dont_inherit=True)
    lines = decode_source(source).splitlines(keepends=True)
    linecache.cache[file] = len(source), None, lines, file  # None: Python does not look again
    return code


class SourceLoader(SourceFileLoader):
    """Imports a file from its text: Python's cache can be old after two saves in one second."""

    def get_code(self, fullname: str) -> CodeType:
        return code_of(self.path)


class SourceFinder:
    """Finds the modules of src/, and those beside it."""

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, _: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return how to import a module from its text; None leaves it to Python."""
        spec = PathFinder.find_spec(name, path)
        if not (spec and spec.origin and is_source_folder(os.path.dirname(spec.origin))):
            return None
        spec.loader = SourceLoader(name, spec.origin)
        return spec


@contextmanager
def fresh_modules() -> Iterator[None]:
    """Let the body of the with statement import the files of src/ as they are now.

    Afterwards, put back the modules that were there.
    """
    before = source_modules()
    finder: Any = SourceFinder()
    forget(before)
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)
        forget(source_modules())
        sys.modules.update(before)


def source_modules() -> dict[str, ModuleType]:
    """Return the imported modules of src/, and of files beside it, but not the main one."""
    found = {}
    for name, module in [*sys.modules.items()]:
        file = getattr(module, "__file__", None)
        if file and name != "__main__" and is_source_folder(os.path.dirname(file)):
            found[name] = module
    return found


def forget(modules: dict[str, ModuleType]) -> None:
    """Let Python import these modules again."""
    for name in modules:
        del sys.modules[name]


# --- a save --------------------------------------------------------------------------------------


class LiveSource(Live):
    """Notices that you have saved a file with other bytes; a new date alone is no change."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        super().__init__(contents, QUIET, clock)
        self.constants = self.current.get(CONSTANTS)  # those that this process has
        self.saved: list[Path] = []  # the files of the last change

    def changed(self) -> bool:
        """Return whether there was a change; saved then has its files."""
        before = self.current
        if not super().changed():
            return False
        now = self.current
        self.saved = [file for file in {*before, *now} if before.get(file) != now.get(file)]
        return True

    def has_new_constants(self) -> bool:
        """Return whether support/constants.py has changed since this process read it."""
        return self.current.get(CONSTANTS) != self.constants

    def mistake(self) -> str:
        """Return why Python cannot compile a file that you have saved, in one line, or ""."""
        for file in self.saved:
            try:
                compile(self.current.get(file, b""), str(file), "exec", dont_inherit=True)
            except SyntaxError as error:
                return f"{file.relative_to(ROOT).as_posix()}, line {error.lineno}: {error.msg}"
        return ""


def contents() -> dict[Path, bytes]:
    """Return the bytes of the source files, and of the constants; a file that is away has none."""
    found = {}
    for file in (*ROOT.glob("*.py"), *SRC.glob("*.py"), CONSTANTS):
        with suppress(OSError):
            found[file] = file.read_bytes()
    return found
