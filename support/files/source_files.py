"""The files of src/, and those beside it: run one, forget them, notice that you have saved one.

A program runs again from its top for each cradle. So what you have saved is what runs.
"""

import importlib
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

from support.root import ROOT, SRC

# The imports that have begun the program: in a run, they do nothing.
BEGINNINGS = ("begin", "begin_page")
CONSTANTS = ROOT / "support" / "constants.py"
POLL = 0.1  # s between two looks at the files
QUIET = 0.5  # s without a change, after which a file counts as saved: a formatter may save it again
GONE = 1.0  # the same, if a file is empty or away: its new content may still come


@cache
def is_source_folder(folder: str) -> bool:
    """Return whether a folder is src/, one in it, or the one around it."""
    path = Path(folder).resolve()
    is_of_python = "site-packages" in path.parts  # an environment can be in src/
    return path == ROOT or path.is_relative_to(SRC) and not is_of_python


def source_files() -> list[Path]:
    """Return the Python files in src/, at any depth, and those beside it."""
    files = [*ROOT.glob("*.py"), *SRC.glob("*.py")]
    for folder in SRC.glob("*"):
        is_environment = (folder / "pyvenv.cfg").exists()
        if folder.is_dir() and not is_environment:
            files += folder.rglob("*.py")
    return files


# --- a run ---------------------------------------------------------------------------------------


def main_module(file: Path) -> ModuleType:
    """Return a main module for a program, this file of src/; it has no names of the file yet."""
    module = ModuleType("__main__")
    vars(module).update(__file__=str(file), __package__="src")  # for `from .swinging import`
    return module


def run_file(module: ModuleType, code: CodeType | None = None) -> None:
    """Run the file of a main module from its top, or this code; the module then has its names."""
    outer = {name: sys.modules.get(name) for name in ("__main__", *BEGINNINGS)}
    sys.modules["__main__"] = module
    for beginning in BEGINNINGS:
        sys.modules.setdefault(beginning, module)  # an import finds it, and runs nothing
    try:
        exec(code or code_of(str(module.__file__)), vars(module))
    finally:
        put_back(outer)


def put_back(modules: dict[str, ModuleType | None]) -> None:
    """Let each name stand for its module again, or for none."""
    for name, module in modules.items():
        if module:
            sys.modules[name] = module
        else:
            sys.modules.pop(name, None)


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
        if not (spec and isinstance(spec.loader, SourceFileLoader)):
            return None
        file = spec.loader.path
        if not is_source_folder(os.path.dirname(file)):
            return None
        spec.loader = SourceLoader(name, file)
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
    return {
        name: module
        for name, module in [*sys.modules.items()]
        if name != "__main__" and any(map(is_source_folder, folders_of(module)))
    }


def folders_of(module: ModuleType) -> list[str]:
    """Return the folder of a module's file; of a package without a file, those that it is."""
    file = getattr(module, "__file__", None)
    return [os.path.dirname(file)] if file else [*getattr(module, "__path__", ())]


def forget(modules: dict[str, ModuleType]) -> None:
    """Let Python import these modules again."""
    importlib.invalidate_caches()
    for name in modules:
        del sys.modules[name]


# --- a save --------------------------------------------------------------------------------------


class LiveSource:
    """Notices that you have saved a file with other bytes; a new date alone is no change."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        """Watch from now on. A test can replace clock()."""
        self.clock = clock
        self.take()
        self.constants = self.current.get(CONSTANTS)  # those that this process has

    def take(self) -> None:
        """Take the files as they are now."""
        self.current = self.candidate = contents()
        self.saved: list[Path] = []
        self.since = self.next_look = self.clock()

    def changed(self) -> bool:
        """Return whether you have saved a file since this last returned True, or since take.

        If so, saved has the files that have changed.
        """
        now = self.clock()
        if now < self.next_look:
            return False
        self.next_look = now + POLL
        found = contents()
        if found != self.candidate:
            self.candidate = found
            self.since = now
        before = self.current
        changed = [file for file in {*found, *before} if found.get(file) != before.get(file)]
        is_away = any(not found.get(file) for file in changed)
        if not changed or now - self.since < (GONE if is_away else QUIET):
            return False
        self.current = found
        self.saved = changed
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
    for file in (*source_files(), CONSTANTS):
        with suppress(OSError):
            found[file] = file.read_bytes()
    return found
