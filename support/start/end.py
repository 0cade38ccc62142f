"""How programs end: after a signal, when nobody reads their output, because of a file."""

import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from support.root import SRC
from support.start.output import refuse

# The exit status of a program after a signal, by the signal's number.
STATUSES: dict[int, int] = {signal.SIGINT: 0, signal.SIGTERM: 128 + signal.SIGTERM}
if hasattr(signal, "SIGHUP"):  # Windows has none
    STATUSES[signal.SIGHUP] = 128 + signal.SIGHUP

came: list[int] = []  # the number of the signal that ends the program


class SignalError(SystemExit):
    """A signal ends the program; its code is the exit status."""

    is_late = True  # whether it came when no frame had come for long


def on_signals(handle: Callable[[int, Any], object]) -> dict[int, Any]:
    """Let Ctrl+C, kill and a closed terminal call handle; return the handlers before.

    A signal that is already ignored, as by nohup, stays ignored.
    """
    before = {}
    for number in STATUSES:
        if signal.getsignal(number) != signal.SIG_IGN:
            before[number] = signal.signal(number, handle)
    return before


def end(number: int, _: object) -> None:
    """Raise a SignalError. The next signal ends the process, also where code catches this one."""
    for other in STATUSES:
        signal.signal(other, signal.SIG_DFL)
    came.append(number)
    end_if_signalled()


def end_if_signalled() -> None:
    """Raise a SignalError if a signal has come: Python loses one that it raises in a callback."""
    if came:
        raise SignalError(STATUSES[came[0]])


def report_lost(lost: Any) -> None:
    """Report an error that Python loses in a callback, as Python does, but no SignalError."""
    if not isinstance(lost.exc_value, SignalError):
        sys.__unraisablehook__(lost)


@contextmanager
def ended_quietly() -> Iterator[None]:
    """Run a program: the body of the with statement, or the decorated function.

    End it without a traceback after a signal, or if nobody reads its output any more, as in
    `| head`. If an OSError reaches this place, name its file in one line, and exit with status 2.
    Afterwards, signals do what they did before, and a session can start changed files.
    """
    before = on_signals(end)
    hook = sys.unraisablehook
    sys.unraisablehook = report_lost
    if hasattr(sys.stdout, "reconfigure"):  # a notebook has another kind of output
        sys.stdout.reconfigure(errors="replace")
    try:
        yield
        print(end="", flush=True)  # here: at the end of Python, an error would be a traceback
    except BrokenPipeError:
        # Python would try again at its end
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
    except OSError as error:
        place = error.filename2 or error.filename or "The output"
        refuse(f"{place}: {error.strerror or error}")
    finally:
        came.clear()
        sys.unraisablehook = hook
        for number, handler in before.items():
            signal.signal(number, handler)
        if is_in_session():
            forget_modules()


def is_in_session() -> bool:
    """Return whether a prompt comes back after a program (IPython, IDLE, python -i)."""
    is_prompt = hasattr(sys, "ps1") or "idlelib.run" in sys.modules
    return is_prompt or bool(sys.flags.interactive)


def forget_modules() -> None:
    """Let Python import again what a program has imported: you may change a file of it.

    VPython is forgotten, too: it has all objects of the page, or is the stand-in for VPython.
    """
    # The files of src/ can also have been imported without "src.".
    names = {"src", "support", "vpython", *(file.stem for file in SRC.glob("*.py"))}
    for module in [*sys.modules]:
        if module.partition(".")[0] in names:
            del sys.modules[module]
