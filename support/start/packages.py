"""Name the package that stopped a program: it is missing, broken, or another Python's."""

import os
import sys
import traceback
from pathlib import Path
from textwrap import shorten

from support.root import ROOT
from support.start.unfit import NEEDED

LONGEST_ERROR = 250  # letters of an error: numpy writes a page


def report_of_package(error: BaseException) -> str:
    """Return in one line which package stopped a program, and what to do, or "" if none did."""
    while error.__cause__:  # pandas says only that it cannot import numpy
        error = error.__cause__
    files = files_of_import(error)
    is_needed = f"{getattr(error, 'name', '')}".partition(".")[0] in NEEDED
    if files:
        text = shorten(f"{type(error).__name__}: {error}", LONGEST_ERROR, placeholder=" ...")
        line = f"Python cannot use {files[-1]} ({text})"
    elif isinstance(error, ModuleNotFoundError) and is_needed:
        line = f"{sys.executable}: {error}"
    else:
        return ""
    path = os.environ.get("PYTHONPATH")
    if path:
        line += f". First unset PYTHONPATH, which is {path}"
    return f"{line}. Install the packages as README.md says."


def files_of_import(error: BaseException) -> list[str]:
    """Return the files of the package that raised an error while the project imported it."""
    places = [(frame.filename, frame.name) for frame in traceback.extract_tb(error.__traceback__)]
    if isinstance(error, SyntaxError):
        places.append((f"{error.filename}", "<module>"))
    files: list[str] = []
    for file, function in places:
        is_of_project = Path(file).resolve().is_relative_to(ROOT) and "site-packages" not in file
        if is_of_project:
            files = []
        elif files or function == "<module>":
            files.append(file)
    return files
