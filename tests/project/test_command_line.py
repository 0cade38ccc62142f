"""The commands that the programs tell a person to type."""

import os
import shutil
import sys
from pathlib import Path

import pytest

from support.start.command_line import command_line


@pytest.mark.parametrize(
    ("running", "on_the_path", "folder", "words"),
    [
        ("/project/.venv/bin/python", "/usr/bin/python", "/project", ".venv/bin/python tests/watch.py"),
        ("/usr/bin/python", "/usr/bin/python", "/project", "python tests/watch.py"),
        ("/opt/3.14/bin/python", None, "/project", "/opt/3.14/bin/python tests/watch.py"),
        ("/opt/my own/bin/python", "/usr/bin/python", "/project", "'/opt/my own/bin/python' tests/watch.py"),
        ("/opt/$old/bin/python", "/usr/bin/python", "/project", "'/opt/$old/bin/python' tests/watch.py"),
        ("/usr/bin/python", "/usr/bin/python", "/elsewhere", "python /project/tests/watch.py"),
    ],
)
def test_the_command_that_starts_a_program_with_the_same_python(monkeypatch, running, on_the_path, folder, words):
    monkeypatch.setattr("support.start.command_line.ROOT", Path("/project"))
    monkeypatch.setattr(sys, "executable", running)
    monkeypatch.setattr(shutil, "which", lambda _: on_the_path)
    quote = '"' if os.name == "nt" else "'"
    assert command_line("tests/watch.py", Path(folder)) == words.replace("/", os.sep).replace("'", quote)


def test_the_quotes_of_windows(monkeypatch):
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(sys, "executable", "/opt/my own/python")
    monkeypatch.setattr(shutil, "which", lambda _: None)
    assert command_line("tests/watch.py", Path("/nowhere")).startswith(f'"{Path("/opt/my own/python")}" ')
