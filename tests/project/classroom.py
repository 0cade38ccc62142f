"""A class of solutions, and the program that grades it. conftest.py takes over the fixtures."""

import csv
import json
import os
import shutil
import subprocess
import sys
import sysconfig
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from programs import ROOT, SECONDS
from students import put_files

from teacher.report import TABLES

UNBOXED = "--without-bubblewrap"
needs_bwrap = pytest.mark.skipif(
    shutil.which("bwrap") is None, reason="bubblewrap is not installed"
)
# In bubblewrap, four at a time: none takes what others need.
FAST = """
import os, shutil
import grade_class
from teacher import sandbox
sandbox.LAST, sandbox.ALONE, sandbox.SPARE = 12, 8, 2
os.cpu_count = lambda: 4 if shutil.which("bwrap") else 2
"""

SLEEPING = f"{10**9 + os.getpid()}"  # seconds that no other process sleeps
# A solution that leaves a process, which no group has.
LEAVES = f"""
import os
if not os.fork():
    os.setsid()
    if os.fork():
        os._exit(0)
    os.execvp("sleep", ["sleep", "{SLEEPING}"])
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
    """Return the rows of grades.csv by student; those of the table with semicolons are the same."""
    commas, semicolons = [
        [*csv.DictReader((folder / name).read_text("utf-8-sig").splitlines(), delimiter=delimiter)]
        for name, delimiter in TABLES.items()
    ]
    assert commas == semicolons
    return {row["student"]: row for row in commas}


class Classroom:
    """A teacher's folder, with the submissions in class, and the program that grades them."""

    def __init__(self, folder, starter, work, python_for_all):
        self.folder = folder
        self.grades = folder / "class-grades"
        self.starter = starter
        self.work = work  # for the program's own folders
        self.python_for_all = python_for_all  # a function

    def hand_in(self, student, files):
        put_files(self.folder / "class" / student / "src", files)

    def start(self, *options, first=""):
        """Start the program; it runs the Python code in first before the rest."""
        python = self.python_for_all() if UNBOXED in options else sys.executable
        code = f"{FAST}{first}\ngrade_class.main()"
        command = [python, "-c", code, "class", "--starter", str(self.starter), *options]
        return subprocess.Popen(
            command,
            cwd=self.folder,
            env={**os.environ, "TMPDIR": str(self.work), "PYTHONPATH": str(ROOT / "tests")},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )

    def grade(self, *options, first=""):
        """Grade the class; return the status, and the output on stdout and stderr."""
        process = self.start(*options, first=first)
        printed, errors = process.communicate(timeout=10 * SECONDS)
        return process.returncode, printed, errors

    def rows(self):
        return rows_in(self.grades)

    def results(self):
        """Return the results in results.jsonl by student."""
        lines = (self.grades / "results.jsonl").read_text(encoding="utf-8").splitlines()
        results = map(json.loads, lines)
        return {result["student"]: result for result in results}

    def require_clean(self):
        """Require that the program has left no folder and no process."""
        assert os.listdir(self.work) == []
        assert left_processes() == []


@pytest.fixture
def classroom(made, tmp_path, request):
    with TemporaryDirectory() as work:
        os.chmod(work, 0o755)  # other users can pass, as they cannot in pytest's folders
        yield Classroom(
            tmp_path, made, Path(work), lambda: request.getfixturevalue("python_for_all")
        )


@pytest.fixture(scope="session")
def python_for_all():
    """The path of a Python that other users can start: root's may lie where they cannot pass."""
    if os.geteuid() != 0 or is_for_all(sys.executable):
        yield sys.executable
        return
    name = f"python3.{sys.version_info.minor}"
    with TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        with suppress(FileNotFoundError):  # the system has another version
            subprocess.run([f"/usr/bin/{name}", "-m", "venv", "--without-pip", folder], check=True)
        packages = Path(folder) / "lib" / name / "site-packages"
        put_files(packages, {"all.pth": sysconfig.get_path("purelib")})
        python = f"{folder}/bin/python"
        if not is_for_all(python):
            pytest.skip("other users cannot start this Python")
        yield python


def is_for_all(python) -> bool:
    """Return whether other users can start this Python, and find pytest."""
    command = [python, "-c", "import pandas, pytest"]
    nobody = 65534
    try:
        done = subprocess.run(command, cwd="/", user=nobody, group=nobody, extra_groups=[])
    except OSError:
        return False
    return done.returncode == 0
