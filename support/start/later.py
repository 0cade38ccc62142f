"""Import a slow module later than the import statement says, while the program has to wait for something else."""

import sys
import threading
from contextlib import suppress
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType


class Later(ModuleType):
    """Stands in for a module, and imports it as soon as someone uses one of its names."""

    def __getattr__(self, name):
        make_room(self.__name__)
        return getattr(import_module(self.__name__), name)


lock = threading.Lock()


def make_room(name) -> None:
    """Remove the stand-in, so that the module can be imported; a second thread may ask for this at the same time."""
    with lock:
        if isinstance(sys.modules.get(name), Later):
            del sys.modules[name]


def import_later(name) -> None:
    """Let the statement `import name` import this module when it is first used, or when import_now asks for it.

    A module that is not installed stays as it is: the statement then raises its usual error.
    """
    if name not in sys.modules and PathFinder.find_spec(name):
        sys.modules[name] = Later(name)


def import_now(name) -> None:
    """Import a module that was to be imported later; if this fails, it fails again, and is told, where it is used."""
    if isinstance(sys.modules.get(name), Later):
        make_room(name)
        with suppress(Exception):
            import_module(name)
