"""Refuse to start where Python, a file or a package is in the way.

An older Python can compile this module, too.
"""

import os
import sys

NEEDED = {"numpy", "pandas", "pytest", "vpython"}


def refuse_unfit() -> None:
    """Exit with one line if Python is too old, if a file hides a module, or if pandas or a folder
    is missing.
    """
    if sys.version_info < (3, 10):  # noqa: UP036
        sys.exit(
            f"Newton's cradle needs Python 3.10 or later; {sys.executable} is {sys.version.split()[0]}."
        )
    # The others import what a file can hide
    for obstacle in (hidden_module, missing_package, missing_folder):
        words = obstacle()
        if words:
            print(words, file=sys.stderr)
            sys.exit(2)


def hidden_module() -> str:
    """Return which file beside the programs has the name of a module that Python or a package
    imports, or "".

    Python would find the file first, and a package would fail with an error that says nothing about
    the file.
    """
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
    searched = [os.path.realpath(folder) for folder in sys.path]
    for folder in (root, os.path.join(root, "src"), os.path.join(root, "tests")):
        for name in sorted(os.listdir(folder)) if folder in searched else ():
            is_module = name.endswith(".py") or os.path.isfile(
                os.path.join(folder, name, "__init__.py")
            )
            module = name.partition(".")[0]
            if is_module and module in NEEDED | sys.stdlib_module_names:
                file = os.path.relpath(os.path.join(folder, name), root)
                return f"{file} hides the module {module} from Python and its packages. Rename it."
    return ""


def missing_package() -> str:
    """Return a line if there is no pandas, or ""."""
    from importlib.util import find_spec

    if find_spec("pandas") is None:
        return f"{sys.executable} has no pandas. Install it as README.md says, or start the Python that has it."
    return ""


def missing_folder() -> str:
    """Return a line if Python can write to no folder for temporary files, or ""."""
    import tempfile

    try:
        tempfile.gettempdir()
    except FileNotFoundError:
        return "Python finds no folder for temporary files in which it can write. Set TMPDIR to such a folder."
    return ""
