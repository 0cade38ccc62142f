"""A class of solutions, and the program that grades it. conftest.py takes over the fixtures."""

import csv
import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Event

import pytest
from grade_class import copy_starter
from programs import ROOT, SECONDS
from students import put_files

from grading.assignment import SUITES
from teacher.containers import find_engine

FAST = """
import grade_class
from teacher import one_run, runners
one_run.SECONDS, runners.SPARE = 6, 2
"""

# What the run of a starter with one check prints
GRADE = {
    "checks": {
        "test_one": {
            "function": "angle_update",
            "tier": "D",
            "state": "waiting",
            "message": "",
        }
    },
    "tiers": {tier: {"of": 1} for tier in SUITES},
    "next": "",
    "text": [],
    "final": True,
}
SLEEPING = f"{10**9 + os.getpid()}"  # seconds that no other process sleeps
# A solution that leaves a process, which no group has; once, although the program imports it again.
LEAVES = f"""
import os
if "LEFT" not in os.environ and not os.fork():
    os.setsid()
    if os.fork():
        os._exit(0)
    os.execvp("sleep", ["sleep", "{SLEEPING}"])
os.environ["LEFT"] = "1"
"""


def left_processes() -> list[Path]:
    """Return the processes that LEAVES has left. Linux has their files."""
    found = []
    for file in Path("/proc").glob("[0-9]*/cmdline"):
        with suppress(OSError):  # it has just ended
            if SLEEPING.encode() in file.read_bytes():
                found.append(file)
    return found


def rows_in(folder) -> dict[str, dict]:
    """Return the rows of grades.csv by student."""
    lines = (folder / "grades.csv").read_text("utf-8-sig").splitlines()
    return {row["student"]: row for row in csv.DictReader(lines)}


class Classroom:
    """A teacher's folder, with the submissions in class, and the program that grades them."""

    def __init__(self, folder, starter, work):
        self.folder = folder
        self.grades = folder / "class-grades"
        self.starter = starter
        self.work = work  # for the program's own folders
        self.how = ["--here"]

    def hand_in(self, student, files):
        put_files(self.folder / "class" / student / "src", files)

    def start(self, first=""):
        """Start the program; it runs the Python code in first before the rest."""
        code = f"{FAST}{first}\ngrade_class.main()"
        command = [sys.executable, "-c", code, "class", "--starter", str(self.starter)]
        return subprocess.Popen(
            [*command, *self.how],
            cwd=self.folder,
            env={**os.environ, "TMPDIR": str(self.work), "PYTHONPATH": str(ROOT / "tests")},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )

    def grade(self, first=""):
        """Grade the class; return the status, and the output on stdout and stderr."""
        process = self.start(first)
        printed, errors = process.communicate(timeout=10 * SECONDS)
        return process.returncode, printed, errors

    def rows(self):
        return rows_in(self.grades)

    def require_clean(self):
        """Require that the program has left no folder and no process."""
        assert os.listdir(self.work) == []
        assert left_processes() == []


@pytest.fixture
def classroom(made, tmp_path):
    with TemporaryDirectory() as work:
        yield Classroom(tmp_path, made, Path(work))


@pytest.fixture(scope="session")
def engine(made, tmp_path_factory):
    """An engine that has the image of the starter.

    Where CRADLE_BASE names an image to build on, there must be one.
    """
    folder = tmp_path_factory.mktemp("image") / "starter"
    starter = copy_starter(made, folder)
    try:
        engine = find_engine(folder, starter, Event())
        engine.build()
    except OSError as error:
        if "CRADLE_BASE" in os.environ:
            raise
        pytest.skip(f"no container: {error}")
    return engine
