"""What a program needs before its imports; a file that is only imported needs none of it.

An older Python can compile this file, too.
"""

import os
import sys

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Modules that the programs use, beside Python's own
USED = ("numpy", "pandas", "support", "vpython")
# What a program imports first; started by themselves, they are no programs
STARTS = ("begin.py", "begin_page.py")


def require_python() -> None:
    """Exit with one line if this Python is too old."""
    if sys.version_info < (3, 11):  # noqa: UP036
        sys.exit(
            f"Newton's cradle needs Python 3.11 or later; "
            f"{sys.executable} is {sys.version.split()[0]}."
        )


def taken_names() -> list:
    """Return a sentence about each file in src/, or beside it, with the name of another module."""
    sentences = []
    for folder in ("src/", ""):
        for file in sorted(os.listdir(os.path.join(PROJECT, folder))):
            name, ending = os.path.splitext(file)
            if ending == ".py" and (name in sys.stdlib_module_names or name in USED):
                sentences.append(f"{folder}{file} has the name of another module. Rename it.")
    return sentences


def begin() -> None:
    """Prepare the start of a program.

    This is ready for signals. Exits with one line if Python is too old. Names files that hide
    a module of Python's: what follows can then fail.
    """
    require_python()
    if os.path.basename(sys.argv[0]) in STARTS:
        refuse_to_run()
    for sentence in taken_names():
        print(sentence, file=sys.stderr)
    # Not earlier: an older Python cannot compile it.
    from support.start import end

    if not end.is_in_session():  # a session keeps its own signals if an import fails
        end.on_signals(end.exit_at_once)


def refuse_to_run() -> None:
    """Say how the functions of a file without a program are checked, and exit with status 1."""
    sys.exit(
        "This file has only functions. Type pytest in this folder to check them, "
        "or start src/text_cradle_run.py."
    )
