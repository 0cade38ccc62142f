"""Refuse to start where Python, a file or a package is in the way.

An older Python can compile this module, too.
"""

import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
NEEDED = {"autobahn", "numpy", "pandas", "pytest", "txaio", "vpython"}


def refuse_unfit() -> None:
    """Exit with one line if something is in the way of every program.

    Python may be too old, its folder may be gone, or a file may hide a module.
    """
    if sys.version_info < (3, 11):  # noqa: UP036
        sys.exit(
            f"Newton's cradle needs Python 3.11 or later; "
            f"{sys.executable} is {sys.version.split()[0]}."
        )
    message = missing_working_folder() or hidden_module(ROOT, sys.path)
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


def hidden_module(root: str, python_path: list[str]) -> str:
    """Return which file of the programs' folders below root hides a module, or "".

    It is in a folder of python_path, and has the name of a module that Python or a package imports.
    Python would find the file first, and a package would fail with an error that says nothing about
    the file.
    """
    searched = [os.path.realpath(folder) for folder in python_path]
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
