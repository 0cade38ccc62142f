"""Imports that wait.

A program begins here, so all that is imported here is fast.
"""

import sys
from importlib import import_module
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import Any


class DeferredModule(ModuleType):
    """Stands in for a module, and imports it when the program first uses one of its names."""

    def __init__(self, spec: ModuleSpec) -> None:
        super().__init__(spec.name)
        self.__spec__ = spec  # Python asks for it, and must not import the module for that

    def __getattr__(self, name: str) -> Any:
        import_now(self.__name__)
        return getattr(sys.modules[self.__name__], name)


def import_later(name: str) -> None:
    """Let the statement `import name` import this module when it is first used.

    A module that is not installed stays as it is: the statement then raises its usual error.
    """
    spec = PathFinder.find_spec(name)
    if spec and name not in sys.modules:
        sys.modules[name] = DeferredModule(spec)


def import_now(name: str) -> None:
    """Import a module for which import_later has let the program wait.

    Another thread imports it: Python could lose the error of a signal there.
    """
    if isinstance(sys.modules.get(name), DeferredModule):
        from concurrent.futures import ThreadPoolExecutor  # not earlier: it is slow

        del sys.modules[name]
        with ThreadPoolExecutor(1) as worker:
            worker.submit(import_module, name).result()
