"""Ctrl+C, from the first moment on, and the other signals that end a program: these imports take no time."""

import os
import signal


def end_on_interrupt(status=0) -> None:
    """Let Ctrl+C end the process immediately, with this status and no traceback.

    VPython's own handler waits for its servers, which may be waiting for a browser.
    """
    signal.signal(signal.SIGINT, lambda *_: os._exit(status))


def stop_on_signals() -> None:
    """Let Ctrl+C, Ctrl+\\, a closed terminal and kill raise one KeyboardInterrupt with the exit status.

    The status is 0 for Ctrl+C, and the one of a shell for the others, 128 + the signal's number. Later signals do not
    interrupt the clean-up. A signal that is already ignored, for instance because of nohup, stays ignored. Windows has
    no signal for Ctrl+\\ and for a closed terminal, but one for Ctrl+Break, which is like Ctrl+C.
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
