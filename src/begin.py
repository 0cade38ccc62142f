"""What a program of this folder needs before its imports; a file that is only imported needs none
of it.
"""

import os
import sys


def program(needs_vpython=True) -> None:
    """Forget an earlier program, be ready for signals, and let the import of pandas wait until the
    program uses it.

    Without needs_vpython, a stand-in takes VPython's place. Exits with one line if something is in
    the way.
    """
    forget_earlier_program()
    from support.start.unfit import refuse_unfit

    refuse_unfit()
    # Not earlier: a file can hide what this imports.
    from support.start.early import (
        draw_without_its_page,
        end_on_signals,
        import_later,
        put_main_into,
    )

    # The imports of a program take a moment; without this, Ctrl+C would print a traceback
    end_on_signals()
    put_main_into("src")
    import_later("pandas")  # it takes longest: the page imports it while the browser loads
    if needs_vpython:
        draw_without_its_page()
    else:
        import support.headless_vpython  # noqa: F401


def no_program() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    from support.start.checks_command import checks_command

    sys.exit(
        f"This file has only functions. Type {checks_command()} to check them, or start src/text_cradle_run.py."
    )


def forget_earlier_program() -> None:
    """Let Python import again what an earlier program has left in a session (IPython, python -i).

    These are the files that you may have changed since, VPython with all objects of the earlier
    page (VPython forgets itself in the same way in Spyder), and the stand-in for VPython.
    """
    # Also imported without "src."
    names = {file.partition(".")[0] for file in os.listdir(os.path.dirname(__file__))}
    # A file that hides one is refused later
    names.difference_update(getattr(sys, "stdlib_module_names", ()))
    names |= {"src", "support", "vpython"}
    for module in [*sys.modules]:
        if module.partition(".")[0] in names:
            del sys.modules[module]
