"""Commands that a message tells you to type, with this Python."""

import shlex
import subprocess
import sys
from pathlib import Path

from support.root import ROOT

FOLDER = Path.cwd()  # now: a student's function may leave it


def python_command(*words: str | Path) -> str:
    """Return the command that starts this Python with these words, as a shell takes it.

    In the project's folder, the paths below it are short.
    """
    texts = []
    for word in (Path(sys.executable), *words):
        if FOLDER == ROOT and isinstance(word, Path) and word.is_relative_to(ROOT):
            word = word.relative_to(ROOT)
        texts.append(str(word))
    return subprocess.list2cmdline(texts) if sys.platform == "win32" else shlex.join(texts)


def checks_command() -> str:
    """Return the command that runs the checks."""
    tests = [] if FOLDER == ROOT else [ROOT / "tests"]
    return python_command("-m", "pytest", *tests)
