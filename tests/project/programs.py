"""The programs as processes: how the tests start them, what they print first, how they end."""

import os
import re
import shutil
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from importlib.machinery import PathFinder
from pathlib import Path

import pytest

from support.root import ROOT

PROGRAM = ROOT / "src" / "visualize_cradle_run.py"
SECONDS = 60  # a test waits for something at most this long,
PROCESS_SECONDS = 10 * SECONDS  # and for a process, which a busy machine can slow down ten times
# The environment of a program that imports modules of the tests
OF_TESTS = {"PYTHONPATH": os.pathsep.join(sys.path)}
# How a program ends: its status, and what it still prints.
QUIETLY = (0, "", "")
CLOSED = (0, "No page is open any more, so the program ends.\n", "")  # after its last tab

with_vpython = pytest.mark.skipif(
    PathFinder.find_spec("vpython") is None, reason="VPython is not installed"
)
on_posix = pytest.mark.skipif(
    os.name != "posix", reason="programs are sent signals as on Linux and macOS"
)
needs_vpython = [with_vpython, on_posix]


def slow_except(kept, values):
    """Return the values as parameters of a test; all except the kept ones have the mark slow."""
    values = [*values]
    assert {*kept} <= {*values}
    parameters = []
    for value in values:
        parts = value if isinstance(value, tuple) else (value,)
        marks = () if value in kept else pytest.mark.slow
        parameters.append(pytest.param(*parts, marks=marks))
    return parameters


def python(*arguments, folder=ROOT, **environment):
    """Run Python with these arguments in this folder; return the process, which has ended."""
    return subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        timeout=PROCESS_SECONDS,
    )


# Another test may just now let Python compile a file: this copy is renamed when it is whole
half_written = shutil.ignore_patterns("*.pyc.*")


def copy_project(folder, csv) -> Path:
    """Copy what the programs need, and this CSV, into a folder; return it."""
    for name in ("src", "support"):
        shutil.copytree(ROOT / name, folder / name, ignore=half_written)
    shutil.copy(ROOT / "pds_tester.py", folder)
    (folder / "newton_cradle_pends.csv").write_text(csv, encoding="utf-8")
    return folder


def call(main, capsys):
    """Call main in this process; return its status, and its output on stdout and on stderr."""
    status = 0
    try:
        main()
    except SystemExit as ended:
        status = ended.code
    return status, *capsys.readouterr()


@contextmanager
def running(
    program=None,
    *arguments,
    folder=os.sep,
    python=sys.executable,
    patience=PROCESS_SECONDS,
    **environment,
):
    """Start the program as a user would, from this folder; yield the process, and end it later.

    After `patience` seconds it ends, too: a test that waits for its output then fails.
    """
    environment = {**os.environ, "VPYTHON_NO_LAUNCH_BROWSER": "1", **environment}
    # It must not wait for a full buffer with what it has to say
    environment.pop("PYTHONUNBUFFERED", None)
    process = subprocess.Popen(
        [python, str(program or PROGRAM), *arguments],
        cwd=folder,
        env=environment,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    timer = threading.Timer(patience, process.kill)
    timer.start()
    try:
        yield process
    finally:
        timer.cancel()
        process.kill()
        process.communicate()


def first_lines(process):
    """Return the address of the page; the program prints it before it waits for a browser."""
    address = re.fullmatch(
        r"Newton's cradle is at (http://127\.0\.0\.1:\d+/\?key=\w+)\n", process.stdout.readline()
    )[1]
    assert "Ctrl+C" in process.stdout.readline()
    return address


def end(process):
    """Wait until the program ends by itself; return its status, and the rest of its output.

    The output is what it has printed on stdout and on stderr.
    """
    stdout, stderr = process.communicate(timeout=PROCESS_SECONDS)
    return process.returncode, stdout, stderr


def wait_until(condition, seconds=SECONDS):
    """Wait until condition() holds; fail after `seconds`."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.02)
