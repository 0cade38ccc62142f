"""A program's first steps: signals that end it, and imports that wait.

A program begins here, so all that is imported here is fast.
"""

import os
import signal
import sys
from collections.abc import Callable
from importlib import import_module
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import Any, NoReturn

from support.root import SRC


def is_in_session() -> bool:
    """Return whether a prompt comes back after a program (IPython, python -i)."""
    return hasattr(sys, "ps1") or bool(sys.flags.interactive)


def forget_program() -> None:
    """Let Python import again what a program has imported.

    These are the files that you may change before the next program of a session, VPython with all
    objects of the page (VPython forgets itself in the same way in Spyder), and the stand-in for
    VPython.
    """
    # The files of src/ can also have been imported without "src.".
    names = {"src", "support", "vpython", *(file.stem for file in SRC.glob("*.py"))}
    for module in [*sys.modules]:
        if module.partition(".")[0] in names:
            del sys.modules[module]


def on_signals(act: Callable[[int], object]) -> None:
    """Let Ctrl+C, Ctrl+\\, a closed terminal and kill call act(status) once.

    The status is the exit status for the program: 0 for Ctrl+C (and Ctrl+Break on Windows), else
    that of a shell, 128 + the signal's number. Later signals do not interrupt act. A signal that is
    already ignored, as by nohup, stays ignored. As the first process of a container, a program gets
    only the signals for which this is set.

    In a session, nothing changes: with Ctrl+C, the prompt comes back.
    """
    if is_in_session():
        return
    statuses: dict[int, int] = {}  # a signal's number -> the exit status
    for name in ("SIGINT", "SIGBREAK", "SIGQUIT", "SIGHUP", "SIGTERM"):
        number = getattr(signal, name, None)  # each system lacks some
        if number is not None and signal.getsignal(number) != signal.SIG_IGN:
            statuses[number] = 0 if name in ("SIGINT", "SIGBREAK") else 128 + number
    has_acted = False

    def handle(number: int, _: object) -> None:
        nonlocal has_acted
        for other in statuses:
            signal.signal(other, signal.SIG_IGN)
        if not has_acted:  # a second signal can come before the first one is ignored
            has_acted = True
            act(statuses[number])

    for number in statuses:
        signal.signal(number, handle)


def end_on_signals(first: Callable[[], object] = lambda: None) -> None:
    """Let these signals call first, and end the process at once with the exit status."""

    def end(status: int) -> NoReturn:
        first()
        os._exit(status)

    on_signals(end)


def stop_on_signals() -> None:
    """Let these signals raise one KeyboardInterrupt with the exit status.

    In a session, Ctrl+C raises one without a status.
    """

    def stop(status: int) -> NoReturn:
        raise KeyboardInterrupt(status)

    on_signals(stop)


class DeferredModule(ModuleType):
    """Stands in for a module, and imports it when the program first uses one of its names."""

    def __init__(self, spec: ModuleSpec) -> None:
        super().__init__(spec.name)
        self.__spec__ = spec  # Python asks for it, and must not import the module for that

    def __getattr__(self, name: str) -> Any:
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def import_later(name: str) -> None:
    """Let the statement `import name` import this module when it is first used.

    A module that is not installed stays as it is: the statement then raises its usual error.
    """
    spec = PathFinder.find_spec(name)
    if spec and name not in sys.modules:
        sys.modules[name] = DeferredModule(spec)


def put_main_into(package: str) -> None:
    """Let the started file be a module of this package.

    So `from .swinging import ...` works in it, too.
    """
    sys.modules["__main__"].__package__ = package


def import_now(name: str) -> None:
    """Import a module for which import_later has let the program wait."""
    if isinstance(sys.modules.get(name), DeferredModule):
        del sys.modules[name]
        import_module(name)
