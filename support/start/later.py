"""Import a slow module later than the import statement says, while the program has to wait for something else."""

import sys
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType


class Later(ModuleType):
    """Stands in for a module, and imports it as soon as someone uses one of its names."""

    def __getattr__(self, name):
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def import_later(name) -> None:
    """Let the statement `import name` import this module when it is first used, or when import_now asks for it.

    A module that is not installed stays as it is: the statement then raises its usual error.
    """
    if name not in sys.modules and PathFinder.find_spec(name):
        sys.modules[name] = Later(name)


def import_now(name) -> None:
    """Import a module that was to be imported later."""
    if isinstance(sys.modules.get(name), Later):
        del sys.modules[name]
        import_module(name)
