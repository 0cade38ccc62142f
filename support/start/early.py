"""What a program does first: signals that end it, imports that wait, and VPython without its own
page.

A program begins here, so all that is imported here is fast.
"""

import os
import signal
import sys
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType


def on_signals(act) -> None:
    """Let Ctrl+C, Ctrl+\\, a closed terminal and kill call act(status) once, with an exit status
    for the program.

    The status is 0 for Ctrl+C (and Ctrl+Break on Windows), else that of a shell, 128 + the signal's
    number. Later signals do not interrupt act. A signal that is already ignored, as by nohup, stays
    ignored. As the first process of a container, a program gets only the signals for which this is
    set.

    In a session (IPython, python -i), nothing changes: with Ctrl+C, the prompt comes back.
    """
    if hasattr(sys, "ps1") or sys.flags.interactive:
        return
    names = ("SIGINT", "SIGBREAK", "SIGQUIT", "SIGHUP", "SIGTERM")
    numbers = {getattr(signal, name): name for name in names if hasattr(signal, name)}
    numbers = {
        number: name
        for number, name in numbers.items()
        if signal.getsignal(number) != signal.SIG_IGN
    }
    left = [act]

    def handle(number, _):
        for each in numbers:
            signal.signal(each, signal.SIG_IGN)
        if left:  # a second signal can come before the first one is ignored
            left.pop()(0 if numbers[number] in ("SIGINT", "SIGBREAK") else 128 + number)

    for number in numbers:
        signal.signal(number, handle)


def end_on_signals(first=lambda: None) -> None:
    """Let these signals call first, and end the process at once; its status is 1 if a recording has
    not begun yet.
    """
    is_recording = any(word.startswith("--record") for word in sys.argv[1:])

    def end(status):
        first()
        os._exit(1 if is_recording else status)

    on_signals(end)


def stop_on_signals() -> None:
    """Let these signals raise one KeyboardInterrupt with the exit status; in a session, Ctrl+C
    raises one without.
    """

    def stop(status):
        raise KeyboardInterrupt(status)

    on_signals(stop)


class Later(ModuleType):
    """Stands in for a module, and imports it when the program first uses one of its names."""

    def __init__(self, spec):
        super().__init__(spec.name)
        self.__spec__ = spec  # Python asks for it, and must not import the module for that

    def __getattr__(self, name):
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def import_later(name) -> None:
    """Let the statement `import name` import this module when it is first used.

    A module that is not installed stays as it is: the statement then raises its usual error.
    """
    spec = PathFinder.find_spec(name)
    if spec and name not in sys.modules:
        sys.modules[name] = Later(spec)


def put_main_into(package) -> None:
    """Let the started file be a module of this package, so that `from .swinging import ...` works
    in it, too.
    """
    sys.modules["__main__"].__package__ = package


def import_now(name) -> None:
    """Import a module for which import_later has let the program wait."""
    if isinstance(sys.modules.get(name), Later):
        del sys.modules[name]
        import_module(name)


def draw_without_its_page() -> None:
    """Let VPython make objects for our page.

    Its own page, and a server for it, would come with the first object.

    What needs an answer of its page, or a place on it, raises a RuntimeError: VPython would wait
    for ever.
    """
    vpython = import_module("vpython.vpython")
    vpython.baseObj._view_constructed = True  # its own page is there: it believes so
    # Nothing is on its way to that page: clone() would wait for it
    vpython.baseObj.empty = lambda: True

    def refuse(*_, **__):
        there = "the page shows VPython's shapes, but no text, compound, extrusion, graph, button or the like"
        raise RuntimeError(f"{there}, and nothing can wait for a click")

    for kind in (
        vpython.text,
        vpython.compound,
        vpython.extrusion,
        vpython.graph,
        vpython.gobj,
        vpython.controls,
    ):
        kind.__new__ = refuse
    vpython._wait = refuse  # type: ignore[attr-defined]
