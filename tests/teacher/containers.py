"""Runs of one_run.py: each in a container, by podman or Docker, or as a plain process.

A solution in a container has no network, and sees no file of the machine. What it writes is not
kept: its files come on stdin, and its result goes to stdout.
"""

import os
import subprocess
import sys
import threading
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO
from uuid import uuid4

from support.start.output import complain

ONE_RUN = "tests/teacher/one_run.py"
BASE = os.environ.get("CRADLE_BASE", "")  # an image in place of the one in the Containerfile
SECONDS = 300  # of a run, by the clock
LATE = 124  # the exit status of a run that takes longer, as the command timeout has it
SPARE = 15  # s in which a container begins, and ends
MOST_BYTES = 2_000_000  # of a result
PATIENCE = 60  # s for an answer of the engine

# Options of the engine; one with several values is given once for each.
LIMITS = {
    "rm": "true",
    "interactive": "true",
    "pull": "never",
    "log-driver": "none",
    "network": "none",
    # An engine would hand on the address of a proxy, which may have a password
    "env": "http_proxy= https_proxy= ftp_proxy= HTTP_PROXY= HTTPS_PROXY= FTP_PROXY=",
    "user": "65534:65534",
    "cap-drop": "all",
    "security-opt": "no-new-privileges",
    # For a submission with its files; grading/limits.py allows 1 GB
    "memory": "1500m",
    "memory-swap": "1500m",
    "read-only": "true",
    "tmpfs": "/cradle:rw,size=50m,mode=1777",
    "shm-size": "1m",
    "pids-limit": "12",
    "oom-score-adj": "1000",
    "stop-timeout": "0",
    "ulimit": "core=0:0 cpu=60:60 fsize=40000000:40000000 nofile=256:256 nproc=4096:4096",
}
OF_PODMAN = {
    "read-only-tmpfs": "false",  # or /tmp is open
    "timeout": f"{SECONDS + SPARE}",  # also if this program is killed
}
ENGINES = ("podman", "docker")


class Runner:
    """Runs each submission as a plain process: for code that you trust."""

    def __init__(self, folder: Path) -> None:
        """folder has the starter, with tests/teacher/."""
        self.folder = folder
        self.running: dict[str, subprocess.Popen[bytes]] = {}  # by the name of the run

    def prepare(self) -> None:
        """Say what plain processes mean."""
        complain("Each solution runs as a plain process, and can do here all that you can.")

    def run(self, submission: IO[bytes], stderr: int | None) -> tuple[int, bytes]:
        """Return the exit status of one_run.py for what pack has written, and what it prints.

        It writes errors to stderr, as subprocess takes it.
        """
        name = f"cradle-{uuid4().hex}"
        with TemporaryDirectory(prefix="cradle-", ignore_cleanup_errors=True) as work:
            process = subprocess.Popen(
                self.command(name),
                cwd=work,
                env={**os.environ, "TMPDIR": work},  # a pytest that is killed leaves files there
                stdin=submission,
                stdout=subprocess.PIPE,
                stderr=stderr,
                start_new_session=True,  # Ctrl+C is for this program
            )
            self.running[name] = process
            # An engine can hang, and a solution can stop all processes of its container
            late = threading.Timer(SECONDS + SPARE, self.end, [name, process])
            late.start()
            with process:
                output = process.stdout.read(MOST_BYTES + 1)  # type: ignore[union-attr]
                if len(output) > MOST_BYTES:
                    self.end(name, process)
            late.cancel()
            del self.running[name]
        return process.returncode, output

    def command(self, name: str) -> list[str]:
        """Return the words that start one_run.py."""
        return [sys.executable, str(self.folder / ONE_RUN)]

    def end(self, name: str, process: subprocess.Popen) -> None:
        """End a run, also if it has just ended."""
        process.terminate()

    def end_all(self) -> None:
        """End what runs."""
        for name, process in [*self.running.items()]:
            self.end(name, process)


class Engine(Runner):
    """Runs each submission in a container, by this program: podman or docker."""

    def __init__(self, folder: Path, program: str, packages: str) -> None:
        """packages are the names of those that the image has, too.

        Raises an OSError if the engine does not run.
        """
        super().__init__(folder)
        self.program = program
        self.packages = packages
        self.image = ""  # its number
        self.call("info")

    def call(self, *words: str) -> str:
        """Return what a command of the engine prints. Raises an OSError if it fails."""
        command = [self.program, *words]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
        except FileNotFoundError:
            raise OSError(0, "is not installed", self.program) from None
        except subprocess.TimeoutExpired:
            raise TimeoutError(0, "does not answer", self.program) from None
        if done.returncode:
            reason = [f"status {done.returncode}", *done.stderr.strip().splitlines()][-1]
            raise OSError(0, f"does not run: {reason}", self.program)
        return done.stdout

    def prepare(self) -> None:
        """Build the image, as far as it is not there. Raises an OSError if this fails."""
        print("Making the image. The first time, this takes a minute.", flush=True)
        command = [self.program, "build", "--quiet", "--tag=localhost/cradle-grader"]
        command += [f"--file={self.folder}/tests/teacher/Containerfile", str(self.folder)]
        command.append(f"--build-arg=PACKAGES={self.packages}")
        if BASE:
            command.append(f"--build-arg=BASE={BASE}")
        pipe = subprocess.PIPE
        # After Ctrl+C, this waits: a build that is ended leaves containers behind
        with subprocess.Popen(command, stdout=pipe, text=True, start_new_session=True) as build:
            self.image = build.communicate()[0].strip()
        if build.returncode:
            raise OSError(0, "cannot be built", "The image")

    def run(self, submission: IO[bytes], stderr: int | None) -> tuple[int, bytes]:
        status, output = super().run(submission, stderr)
        if status:
            self.call("info")  # or the class ends here
        return status, output

    def command(self, name: str) -> list[str]:
        command = [self.program, "run", f"--name={name}"]
        limits = LIMITS | OF_PODMAN if self.program == "podman" else LIMITS
        for option, values in limits.items():
            command += [f"--{option}={value}" for value in values.split()]
        # No signal of a solution ends or stops the first process
        command += [self.image, "timeout", "-k", "5", str(SECONDS)]
        return [*command, "python", f"/autograder/source/{ONE_RUN}"]

    def end(self, name: str, process: subprocess.Popen) -> None:
        try:
            self.call("rm", "--force", name)
        except TimeoutError:  # the engine hangs
            process.kill()
        except OSError:  # the run has just ended, or has not begun
            pass


def find_engine(folder: Path, packages: str) -> Engine:
    """Return the first engine that runs, for the starter in this folder.

    Raises an OSError that names all if none does.
    """
    problems = []
    for program in ENGINES:
        try:
            return Engine(folder, program, packages)
        except OSError as error:
            problems.append(f"{program} {error.strerror}")
    problems.append("on macOS and Windows, `podman machine start` starts podman")
    raise OSError(0, "; ".join(problems), "No containers")
