"""Runs of one_run.py: each in a container, by podman or Docker, or as a plain process.

A solution in a container has no network, and sees no file of the machine. What it writes is not
kept: its files come on stdin, and its result goes to stdout.
"""

import os
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO

from support.start.output import complain

ONE_RUN = "tests/teacher/one_run.py"
BASE = os.environ.get("CRADLE_BASE", "")  # an image in place of the one in the Containerfile
SECONDS = 300  # of a run, by the clock
MOST_BYTES = 2_000_000  # of a result

# Options of the engine. It would hand on the address of a proxy, which may have a password. The
# memory is for a submission with its files; grading/limits.py allows 1 GB.
LIMITS = """
    --rm --interactive --pull=never --log-driver=none --network=none
    --env=http_proxy= --env=https_proxy= --env=ftp_proxy=
    --env=HTTP_PROXY= --env=HTTPS_PROXY= --env=FTP_PROXY=
    --user=65534:65534 --cap-drop=all --security-opt=no-new-privileges
    --memory=1500m --memory-swap=1500m --oom-score-adj=1000 --stop-timeout=0
    --read-only --tmpfs=/cradle:rw,size=50m,mode=1777 --shm-size=1m
    --pids-limit=12 --ulimit=nproc=4096:4096 --ulimit=nofile=256:256
    --ulimit=cpu=60:60 --ulimit=fsize=40000000:40000000 --ulimit=core=0:0
"""
OF_PODMAN = " --read-only-tmpfs=false"  # or /tmp is open
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
        with TemporaryDirectory(prefix="cradle-", ignore_cleanup_errors=True) as work:
            name = Path(work).name
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
            late = threading.Timer(SECONDS, self.end, [name, process])
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

    def call(self, *words: str) -> None:
        """Let the engine do a command. Raises an OSError if it fails."""
        try:
            done = subprocess.run([self.program, *words], capture_output=True, text=True)
        except FileNotFoundError:
            raise OSError(0, "is not installed", self.program) from None
        if done.returncode:
            reason = [f"status {done.returncode}", *done.stderr.strip().splitlines()][-1]
            raise OSError(0, f"does not run: {reason}", self.program)

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

    def command(self, name: str) -> list[str]:
        limits = LIMITS + OF_PODMAN if self.program == "podman" else LIMITS
        program = ["python", f"/autograder/source/{ONE_RUN}"]
        return [self.program, "run", f"--name={name}", *limits.split(), self.image, *program]

    def end(self, name: str, process: subprocess.Popen) -> None:
        with suppress(OSError):  # the run has just ended, or has not begun
            self.call("rm", "--force", name)


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
