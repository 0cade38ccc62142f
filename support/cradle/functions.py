"""Find the handout's functions, in whatever module of src/ they are."""

import sys
from collections import ChainMap
from collections.abc import Callable
from inspect import signature
from pathlib import Path
from types import ModuleType
from typing import Any

from support.root import SRC

Names = dict[str, Any]  # the names of a module, with their values


def scope_of(main: Callable, special_cradles: ModuleType) -> ChainMap[str, Any]:
    """Return the names in main's module, in special_cradles, and in all of src/, in this order."""
    names = getattr(main, "__globals__", None)
    if names is None:  # a decorator has made main of a class
        names = vars(sys.modules[main.__module__])
    return ChainMap(names, vars(special_cradles), *loaded_modules())


def loaded_modules() -> list[Names]:
    """Return the names in each imported module of src/, and of files that you have added there or
    next to it.
    """
    found = []
    for module in [*sys.modules.values()]:
        names = getattr(module, "__dict__", {})
        # Not module.__file__: that would import a deferred module.
        file = Path(names.get("__file__") or "")
        # A quick look first: to resolve a path takes longer.
        may_be_yours = SRC.name in file.parts or file.parent.name == SRC.parent.name
        if may_be_yours and is_yours(file.resolve()):
            found.append(names)
    return found


def is_yours(file: Path) -> bool:
    """Return whether a file is in src/, at any depth, or in the folder above it."""
    return SRC in file.parents or file.parent == SRC.parent


def takes_rule(*functions: Callable) -> bool:
    """Return whether all these functions have the parameter approaching_only."""
    return all("approaching_only" in signature(function).parameters for function in functions)
