"""What the project's tests share."""

import os
import signal
import sys
from functools import partial
from pathlib import Path

# Modules that tests of several rooms share
PROJECT = Path(__file__).parent
sys.path += map(str, [PROJECT, *(PROJECT / room for room in ("cradle", "grading", "page"))])

import pytest
from graded import solve  # noqa: F401  a fixture
from programs import call, copy_project, PROGRAM
from students import made, MAKE, solved, starter  # noqa: F401  fixtures
from vpython import scene
from whole_cradles import FIVE_CSV, make_swing, PROGRAMS

from src import text_cradle_run
from support import pendulum
from support.start import mistake
from support.start.options import PORT_VARIABLE

os.environ.pop(PORT_VARIABLE, None)  # or the programs that the tests start would all want that port

# A program inherits the signals that are ignored, as with nohup, but none that has a handler.
for name in ("SIGHUP", "SIGINT"):
    number = getattr(signal, name, None)
    if number and signal.getsignal(number) == signal.SIG_IGN:
        signal.signal(number, lambda *_: None)


@pytest.fixture(autouse=True)
def no_shapes():
    """Let each test begin without the shapes of others."""
    for shapes in (scene.objects, pendulum.in_use, pendulum.discarded):
        shapes.clear()


@pytest.fixture
def program(tmp_path):
    """The program in a project of its own, with five equal bobs in its CSV."""
    return copy_project(tmp_path, FIVE_CSV) / "src" / PROGRAM.name


@pytest.fixture
def csv(tmp_path):
    """The path of a CSV with five equal bobs."""
    path = tmp_path / "cradle.csv"
    path.write_text(FIVE_CSV)
    return path


@pytest.fixture
def swing(tmp_path):
    """make_swing, in a folder of its own."""
    return partial(make_swing, tmp_path)


@pytest.fixture
def main(monkeypatch, capsys):
    """main(*arguments) runs the program in the terminal; it returns its status and output."""

    def main(*arguments):
        monkeypatch.setattr(sys, "argv", ["text_cradle_run.py", *map(str, arguments)])
        return call(text_cradle_run.main, capsys)

    return main


@pytest.fixture
def write_program(tmp_path, monkeypatch):
    """A function that writes the program that main runs."""

    def write_program(text):
        file = tmp_path / "program.py"
        file.write_text(text)
        monkeypatch.setattr(text_cradle_run, "PROGRAM", file)
        monkeypatch.setattr(mistake, "SRC", tmp_path)

    return write_program


# The last line of what makes the cradle in the program, and of a tick
LAST_LINES = {
    "make_newton_cradle": MAKE,
    "newton_cradle_tick": "    handle_two_bobs(pend1, pend2, r_param)",
}


@pytest.fixture
def write(tmp_path, monkeypatch):
    """write(name, line) adds a line where this function is called, or to it, in a copy.

    swing and Rig run the copy.
    """
    path = tmp_path / "own_run.py"
    path.write_text(PROGRAM.read_text())
    monkeypatch.setitem(PROGRAMS, "single", path)

    def write(name, line):
        last = LAST_LINES[name]
        text = path.read_text()
        assert text.count(f"    {last}\n") == 1
        path.write_text(text.replace(f"    {last}\n", f"    {last}\n    {line}\n"))

    return write
