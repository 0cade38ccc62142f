"""The command that runs the checks, as it works in this folder."""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def quote(word: str) -> str:
    """Return a word as a shell takes it."""
    return f'"{word}"' if " " in word else word


def checks_command() -> str:
    """Return the command for the checks: uv's if uv has started this Python, else this Python's."""
    python = Path(sys.executable)
    if python.is_relative_to(ROOT):
        python = python.relative_to(ROOT)
    command = f"{quote(str(python))} -m pytest"
    if "UV" in os.environ:  # its path: uv run sets it
        command = "uv run pytest"
    if os.path.samefile(".", ROOT):  # no question for its name: the working folder may be gone
        return command
    return f"cd {quote(str(ROOT))} && {command}"
