"""The command that runs the checks, as it works in this folder."""

import os
import shutil
import sys
from importlib.util import find_spec
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def quote(word: str) -> str:
    """Return a word as a shell takes it."""
    return f'"{word}"' if " " in word else word


def checks_command() -> str:
    """Return the command for the checks.

    It is uv's if uv has started this Python, pytest if that is the one of this Python, else a
    longer command that works: it names Python as it was started, or the pytest of README.md's
    folder .venv.
    """
    if Path.cwd().resolve() != ROOT:
        return f"cd {quote(str(ROOT))} && {command_in_root(sys.executable)}"
    return command_in_root(sys.orig_argv[0])


def command_in_root(python: str) -> str:
    """Return the command in the project's folder; python is the command that starts this Python."""
    if "UV" in os.environ:  # its path: uv run sets it
        return "uv run pytest"
    script = sys.argv[0]
    on_path = shutil.which("pytest")
    if Path(script).stem == "pytest" and os.path.exists(script):
        return "pytest" if on_path == script else quote(script)
    if on_path and os.path.dirname(on_path) == os.path.dirname(sys.executable):
        return "pytest"
    if find_spec("pytest"):
        return f"{quote(python)} -m pytest"
    for path in (".venv/bin/pytest", r".venv\Scripts\pytest.exe"):
        if (ROOT / path).exists():
            return path
    return "pytest"
