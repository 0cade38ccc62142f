"""What a program needs before its imports; a file that is only imported needs none of it."""

import sys


def begin() -> None:
    """Prepare the start of a program.

    This is ready for signals, and lets the import of pandas wait until the program uses it. Exits
    with one line if something is in the way.
    """
    from support.start.unfit import refuse_unfit

    refuse_unfit()
    # Not earlier: a file can hide what this imports.
    from support.start import early

    # The imports of a program take a moment; without this, Ctrl+C would print a traceback.
    early.end_on_signals()
    early.put_main_into("src")
    early.import_later("pandas")  # it takes longest: the page imports it while the browser loads


def refuse_to_run() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    from support.start.checks_command import checks_command

    sys.exit(
        f"This file has only functions. Type {checks_command()} to check them, "
        "or start src/text_cradle_run.py."
    )
