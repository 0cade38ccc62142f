"""The command that starts a program of the project in a terminal."""

import shlex
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def command_line(program, folder, arguments=()) -> str:
    """Return the command that starts a program of the project from this folder, with the running Python and arguments.

    program is the path of its file in the project's folder.
    """
    running, found = Path(sys.executable), shutil.which("python")
    is_plain = found is not None and Path(found) == running and not running.is_relative_to(folder)
    paths = [running, ROOT / program]
    words = [str(path.relative_to(folder) if path.is_relative_to(folder) else path) for path in paths]
    if is_plain:
        words[0] = "python"
    words += arguments
    return subprocess.list2cmdline(words) if sys.platform == "win32" else shlex.join(words)


def same_program(arguments) -> str:
    """Return the command that starts the running program of src/ from the current folder, with these arguments."""
    return command_line(f"src/{Path(sys.argv[0]).name}", Path.cwd(), arguments)
