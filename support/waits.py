"""Calls that wait, such as rate: a cradle's program keeps the time itself, so it names them."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from support.root import SRC


def nothing(*_: object, **__: object) -> None: ...


calls: dict[tuple[str, int], str] = {}  # the name of what was called, by the file and line


def heard(name: str, wait: Callable = nothing) -> Callable:
    """Return a function that does what wait does, and notes in calls who calls it by this name."""

    def call(*values: Any, **named: Any) -> Any:
        frame = sys._getframe(1)
        calls[frame.f_code.co_filename, frame.f_lineno] = name
        return wait(*values, **named)

    return call


def remark() -> str:
    """Return a sentence that names a call in src/ which waits, or ""."""
    for (file, line), name in calls.copy().items():
        path = Path(file).resolve()
        if path.parent == SRC:
            place = f"src/{path.name}, line {line}"
            return f"{place} calls {name}. Delete this call: the program keeps the time itself."
    return ""
