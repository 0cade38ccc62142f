"""What a program needs before its imports; a file that is only imported needs none of it."""

import os
import sys

SRC = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "src")


def begin(needs_vpython: bool = True) -> None:
    """Prepare the start of a program.

    This forgets an earlier program, is ready for signals, and lets the import of pandas wait until
    the program uses it. Without needs_vpython, a stand-in takes VPython's place. Exits with one
    line if something is in the way.
    """
    forget_earlier_program()
    from support.start.unfit import refuse_unfit

    refuse_unfit()
    # Not earlier: a file can hide what this imports.
    from support.start import early

    # The imports of a program take a moment; without this, Ctrl+C would print a traceback.
    early.end_on_signals()
    early.put_main_into("src")
    early.import_later("pandas")  # it takes longest: the page imports it while the browser loads
    if needs_vpython:
        early.draw_without_its_page()
    else:
        import support.headless_vpython  # noqa: F401


def refuse_to_run() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    from support.start.checks_command import checks_command

    sys.exit(
        f"This file has only functions. Type {checks_command()} to check them, "
        "or start src/text_cradle_run.py."
    )


def forget_earlier_program() -> None:
    """Let Python import again what an earlier program has left in a session (IPython, python -i).

    These are the files that you may have changed since, VPython with all objects of the earlier
    page (VPython forgets itself in the same way in Spyder), and the stand-in for VPython.
    """
    # The files of src/ can also have been imported without "src.".
    names = {file.partition(".")[0] for file in os.listdir(SRC)}
    # A file that hides a module of Python is refused later.
    names.difference_update(getattr(sys, "stdlib_module_names", ()))
    names |= {"src", "support", "vpython"}
    for module in [*sys.modules]:
        if module.partition(".")[0] in names:
            del sys.modules[module]
