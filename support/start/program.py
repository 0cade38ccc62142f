"""What a program needs before its imports; a file that is only imported needs none of it.

An older Python can compile this file, too.
"""

import os
import sys

# What a program imports first; started by themselves, they are no programs
STARTS = ("begin.py", "begin_page.py")


def require_python() -> None:
    """Exit with one line if this Python is too old."""
    if sys.version_info < (3, 11):  # noqa: UP036
        sys.exit(
            f"Newton's cradle needs Python 3.11 or later; "
            f"{sys.executable} is {sys.version.split()[0]}."
        )


def begin() -> None:
    """Exit with one line if Python is too old, or if this is no program."""
    require_python()
    if os.path.basename(sys.argv[0]) in STARTS:
        refuse_to_run()


def refuse_to_run() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    sys.exit(
        "This file has only functions. Type pytest in this folder to check them, "
        "or start src/text_cradle_run.py."
    )
