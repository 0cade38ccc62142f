"""What a program of this folder needs before its imports; a file that is only imported needs none of it."""

import os
import sys


def program(needs_vpython=True) -> None:
    """Find the project, be ready for Ctrl+C, and let the import of pandas wait until the program uses it.

    Without needs_vpython, a stand-in takes VPython's place. Exits with one line if something is in the way.
    """
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
    from support.start.unfit import refuse_unfit

    refuse_unfit()
    from support.start.early import end_on_interrupt, import_later  # not earlier: a file can hide what this imports

    # The imports of a program take a moment; without this, Ctrl+C would print a traceback.
    end_on_interrupt(status=int(any(word.startswith("--record") for word in sys.argv[1:])))
    import_later("pandas")  # it takes longest: the page imports it while the browser loads
    if not needs_vpython:
        import support.headless_vpython  # noqa: F401
