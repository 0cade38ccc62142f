"""What a program needs before its imports; a file that is only imported needs none of it.

An older Python can compile this file, too.
"""

import sys


def require_python() -> None:
    """Exit with one line if this Python is too old."""
    if sys.version_info < (3, 11):  # noqa: UP036
        sys.exit(
            f"Newton's cradle needs Python 3.11 or later; "
            f"{sys.executable} is {sys.version.split()[0]}."
        )


def begin() -> None:
    """Prepare the start of a program.

    This is ready for signals, and lets the import of pandas wait until the program uses it. Exits
    with one line if Python is too old.
    """
    require_python()
    # Not earlier: an older Python cannot compile them.
    from support.start import early, end

    if not end.is_in_session():  # a session keeps its own signals if an import fails
        end.on_signals(end.exit_at_once)
    early.import_later("pandas")  # it takes longest: the page imports it while the browser loads


def refuse_to_run() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    sys.exit(
        "This file has only functions. Type pytest in this folder to check them, "
        "or start src/text_cradle_run.py."
    )
