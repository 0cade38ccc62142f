"""The functions that the handout provides. The folders below are for the cradle, files, start, page and terminal."""

import os
import sys

# This comes first: an older Python cannot even compile the other modules.
if sys.version_info < (3, 10):  # noqa: UP036
    sys.exit(f"Newton's cradle needs Python 3.10 or later; {sys.executable} is {sys.version.split()[0]}.")

GIVEN = "given.txt"  # a file here, in a student's folder: the check sums and names of the given files
NEEDED = {*sys.stdlib_module_names, "numpy", "pandas", "pytest", "vpython"}


def refuse_hiding_files() -> None:
    """Exit with status 2 if a file beside the programs has the name of a module that Python or a package imports.

    Python would find the file first, and a package would fail with an error that says nothing about the file.
    """
    root = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
    searched = [os.path.realpath(folder) for folder in sys.path]
    for folder in (root, os.path.join(root, "src"), os.path.join(root, "tests")):
        for name in sorted(os.listdir(folder)) if folder in searched else ():
            is_module = name.endswith(".py") or os.path.isfile(os.path.join(folder, name, "__init__.py"))
            module = name.partition(".")[0]
            if is_module and module in NEEDED:
                file = os.path.relpath(os.path.join(folder, name), root)
                print(f"{file} hides the module {module} from Python and its packages. Rename it.", file=sys.stderr)
                sys.exit(2)


refuse_hiding_files()

from importlib.util import find_spec  # noqa: E402
from pathlib import Path  # noqa: E402
from zlib import crc32  # noqa: E402


def refuse_changed_files() -> None:
    """Exit with status 2 if a file that tests/make_starter.py gives to students is missing, or has changed."""
    here = Path(__file__).resolve().parent
    for line in (here / GIVEN).read_text().splitlines() if (here / GIVEN).is_file() else ():
        crc, name = line.split()
        file = here.parent / name
        if not file.is_file() or crc32(file.read_bytes().replace(b"\r\n", b"\n")) != int(crc):
            what = "has changed" if file.is_file() else "is missing"
            print(f"{name} {what}. Copy it again from the folder that your teacher gave you.", file=sys.stderr)
            sys.exit(2)


refuse_changed_files()
if find_spec("pandas") is None:
    print(
        f"{sys.executable} has no pandas. Install it as README.md says, or start the Python that has it.",
        file=sys.stderr,
    )
    sys.exit(2)
