"""Refuse to start where Python, a file or a package is in the way.

An older Python can compile this module, too.
"""

import os
import sys

NEEDED = {"autobahn", "numpy", "pandas", "pytest", "txaio", "vpython"}


def refuse_unfit() -> None:
    """Exit with one line if something is in the way of every program.

    Python may be too old, a file may hide a module, or pandas or a folder may be missing.
    """
    if sys.version_info < (3, 10):  # noqa: UP036
        sys.exit(
            f"Newton's cradle needs Python 3.10 or later; "
            f"{sys.executable} is {sys.version.split()[0]}."
        )
    # The first one first: the others import what a file can hide.
    message = missing_working_folder() or hidden_module() or missing_package() or missing_folder()
    if message:
        print(message, file=sys.stderr)
        sys.exit(2)


def missing_working_folder() -> str:
    """Return a line if the folder in which Python was started is gone, or ""."""
    try:
        os.getcwd()
    except OSError:
        return "The folder in which you started Python is gone. Change to another one, with cd."
    return ""


def hidden_module() -> str:
    """Return which file in the programs' folders hides a module, or "".

    It has the name of a module that Python or a package imports. Python would find the file first,
    and a package would fail with an error that says nothing about the file.
    """
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
    searched = [os.path.realpath(folder) for folder in sys.path]
    for folder in (root, os.path.join(root, "src"), os.path.join(root, "tests")):
        if folder not in searched:
            continue
        for name in sorted(os.listdir(folder)):
            path = os.path.join(folder, name)
            is_package = os.path.isfile(os.path.join(path, "__init__.py"))
            module = name.partition(".")[0]
            is_imported = module in NEEDED or module in sys.stdlib_module_names
            if is_imported and (is_package or name.endswith(".py")):
                file = os.path.relpath(path, root)
                return f"{file} hides the module {module} from Python and its packages. Rename it."
    return ""


def missing_package() -> str:
    """Return a line if there is no pandas, or ""."""
    from importlib.util import find_spec

    spec = find_spec("pandas")
    if spec and spec.origin:  # a folder that was left over has none
        return ""
    return (
        f"{sys.executable} has no pandas. "
        "Install it as README.md says, or start the Python that has it."
    )


def missing_folder() -> str:
    """Return a line if Python can write to no folder for temporary files, or ""."""
    import tempfile

    try:
        tempfile.gettempdir()
    except FileNotFoundError:
        return (
            "Python finds no folder for temporary files in which it can write. "
            "Set TMPDIR to such a folder."
        )
    return ""
