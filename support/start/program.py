"""What a program needs before its imports; a file that is only imported needs none of it."""

import os
import sys
import warnings


def begin() -> None:
    """Prepare the start of a program.

    This is ready for signals, and lets the import of pandas wait until the program uses it. Exits
    with one line if something is in the way.
    """
    if not sys.flags.interactive:
        sys.excepthook = end_uncaught
    if any("error" in option for option in sys.warnoptions):
        # VPython's imports warn: with PYTHONWARNINGS=error, they would fail
        warnings.simplefilter("ignore")
    from support.start.unfit import refuse_unfit

    refuse_unfit()
    # Not earlier: a file can hide what this imports.
    import time

    from support import waits
    from support.start import early

    # The imports of a program take a moment; without this, Ctrl+C would print a traceback.
    early.end_on_signals()
    time.sleep = waits.heard("sleep", time.sleep)
    early.put_main_into("src")
    early.import_later("pandas")  # it takes longest: the page imports it while the browser loads


def end_uncaught(_: object, error: BaseException, __: object) -> None:
    """Report an error that nothing has caught, and end the process; Ctrl+C ends it quietly."""
    if isinstance(error, KeyboardInterrupt):
        os._exit(*error.args or [130])
    from support.start.mistake import report_mistake

    report_mistake(error)
    sys.stdout.flush()
    os._exit(1)  # a package that came half may fail once more at the end of Python


def refuse_to_run() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    from support.start.commands import checks_command

    sys.exit(
        f"This file has only functions. Type {checks_command()} to check them, "
        "or start src/text_cradle_run.py."
    )
