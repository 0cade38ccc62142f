"""Signals that end a program, and imports that wait. A program begins here, so all that is imported here is fast."""

import os
import signal
import sys
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType


def end_on_interrupt(status=0, first=lambda: None) -> None:
    """Let Ctrl+C call first, and end the process immediately, with this status and no traceback.

    In a session (IPython, python -i), the prompt comes back, as usual.
    """
    if not (hasattr(sys, "ps1") or sys.flags.interactive):
        signal.signal(signal.SIGINT, lambda *_: (first(), os._exit(status)))


def stop_on_signals() -> None:
    """Let Ctrl+C, Ctrl+\\, a closed terminal and kill raise one KeyboardInterrupt with the exit status.

    The status is 0 for Ctrl+C (and Ctrl+Break on Windows), else that of a shell, 128 + the signal's number. Later
    signals do not interrupt the clean-up. A signal that is already ignored, as by nohup, stays ignored.
    """
    names = ("SIGINT", "SIGBREAK", "SIGQUIT", "SIGHUP", "SIGTERM")
    numbers = {getattr(signal, name): name for name in names if hasattr(signal, name)}
    numbers = {number: name for number, name in numbers.items() if signal.getsignal(number) != signal.SIG_IGN}

    def stop(number, _):
        for each in numbers:
            signal.signal(each, signal.SIG_IGN)
        raise KeyboardInterrupt(0 if numbers[number] in ("SIGINT", "SIGBREAK") else 128 + number)

    for number in numbers:
        signal.signal(number, stop)


class Later(ModuleType):
    """Stands in for a module, and imports it when the program first uses one of its names."""

    def __getattr__(self, name):
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def import_later(name) -> None:
    """Let the statement `import name` import this module when it is first used.

    A module that is not installed stays as it is: the statement then raises its usual error.
    """
    if name not in sys.modules and PathFinder.find_spec(name):
        sys.modules[name] = Later(name)
