"""The runs of a class: what becomes of a submission, and plain processes on this machine.

one_run.py gets a submission as a .zip on stdin, and prints its grade.
"""

import json
import os
import signal
import subprocess
import sys
import threading
import zipfile
from contextlib import suppress
from io import BytesIO
from tempfile import TemporaryDirectory, TemporaryFile
from typing import NamedTuple
from uuid import uuid4

from support.start.output import complain
from teacher import one_run
from teacher.report import no_grade, read_grade

SPARE = 15  # s in which a container begins, and ends
# Reading a submission limits the memory of this process, also for what it starts then
READ_OR_START = threading.Lock()
# Ctrl+C is for this program
APART = (
    {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
    if os.name == "nt"
    else {"start_new_session": True}
)


class GradedRun(NamedTuple):
    """What has become of a submission."""

    grade: dict  # as report.read_grade returns it, or report.no_grade
    problem: str  # why there is no grade, or ""
    is_final: bool  # whether nothing that ran beside it can have changed this


class Runner:
    """Grades submissions, each in a fresh copy of a starter, by a process. Open it first."""

    cores = os.cpu_count() or 1

    def __init__(self, folder):
        self.folder = folder  # of the starter
        self.empty: dict = {}  # the grade of the starter
        self.stderr = subprocess.DEVNULL
        self.running: dict[str, subprocess.Popen] = {}  # by the name of the run

    def open(self) -> None:
        """Grade the starter; raise an OSError if this fails."""
        status, output = self.run_package(package({}))
        with suppress(ValueError, RecursionError):
            self.empty = json.loads(output)
        if read_grade(self.empty, output) is None:
            why = why_none(status)
            if output.strip():
                why += f": {output.decode(errors='replace').strip().splitlines()[-1]}"
            raise OSError(0, why, "The starter")

    def run(self, files) -> GradedRun:
        """Grade the files of a submission, by their paths in the project."""
        status, output = self.run_package(package(files))
        grade = read_grade(self.empty, output)
        if grade is None:
            return GradedRun(no_grade(self.empty, output), why_none(status), is_final=False)
        return GradedRun(grade, "", is_final=grade.pop("final") and 0 <= status < one_run.LATE)

    def run_package(self, content) -> tuple[int, bytes]:
        """Return the exit status of one_run.py for a package, and what it prints."""
        name = f"cradle-{os.getpid()}-{uuid4().hex}"
        with (
            TemporaryDirectory(prefix="cradle-", ignore_cleanup_errors=True) as folder,
            TemporaryFile() as stdin,
        ):
            stdin.write(content)
            stdin.seek(0)
            late = threading.Timer(one_run.SECONDS + SPARE, self.end, [name])
            with READ_OR_START:
                process = subprocess.Popen(
                    self.command(name),
                    cwd=folder,
                    stdin=stdin,
                    stdout=subprocess.PIPE,
                    stderr=self.stderr,
                    **APART,
                )
                self.running[name] = process
                late.start()
            output = process.stdout.read(one_run.MOST_BYTES + 1)
            if len(output) > one_run.MOST_BYTES:
                self.end(name)
            process.stdout.close()
            status = process.wait()
            late.cancel()
            del self.running[name]
        return status, output

    def command(self, name) -> list[str]:
        """Return the words that start one_run.py."""
        raise NotImplementedError

    def end(self, name) -> None:
        """End a run, also if it has just ended."""
        raise NotImplementedError

    def end_all(self) -> None:
        """End what runs."""
        for name in [*self.running]:
            self.end(name)


def why_none(status) -> str:
    """Return why there is no grade, by the exit status of one_run.py."""
    if status == one_run.LATE:
        return f"no grade: the run took longer than {one_run.SECONDS} s"
    return f"no grade: the run ended with status {status}"


def package(files) -> bytes:
    """Return a .zip with these files."""
    content = BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for name, text in files.items():
            # On Linux, a name can have letters that are none
            archive.writestr(name.encode(errors="replace").decode(), text)
    return content.getvalue()


class Here(Runner):
    """Runs each pytest as a plain process: for code that you trust."""

    def open(self) -> None:
        complain("Each solution runs as a plain process, and can do here all that you can.")
        super().open()

    def command(self, name) -> list[str]:
        program = self.folder / "tests" / "teacher" / "one_run.py"
        return [sys.executable, f"{program}", f"{one_run.SECONDS}"]

    def end(self, name) -> None:
        # On Windows, also to the pytest below it
        number = signal.CTRL_BREAK_EVENT if os.name == "nt" else signal.SIGTERM
        with suppress(KeyError):
            self.running[name].send_signal(number)
