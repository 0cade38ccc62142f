"""A container for each submission, by podman or Docker: what it may reach, and what it may take.

A solution has no network, and sees no file of the machine. What it writes is not kept. Its files
come on stdin, and its grade goes to stdout. The first process is timeout: no signal of a solution
ends or stops it. By ptrace, a solution can stop it, so the time is also counted from outside.
"""

import hashlib
import os
import re
import shutil
import subprocess

from teacher import one_run
from teacher.runners import APART, READ_OR_START, Runner, SPARE

# How an engine says how many cores and bytes of memory it has: mostly those of a virtual machine
SIZES = {
    "podman": "{{.Host.CPUs}} {{.Host.MemTotal}}",
    "docker": "{{.NCPU}} {{.MemTotal}}",
}
BASE = os.environ.get("CRADLE_BASE", "")  # another image than that of the Containerfile
MEMORY = 1_500_000_000  # bytes for a submission, with its files; grading/limits.py allows 1 GB
# An engine would hand on the address of a proxy, which may have a password
PROXIES = ("http_proxy", "https_proxy", "ftp_proxy", "all_proxy")
LIMITS = [
    *("--rm", "--interactive", "--pull=never", "--network=none", "--log-driver=none"),
    *("--user=65534:65534", "--cap-drop=all", "--security-opt=no-new-privileges"),
    *("--read-only", "--tmpfs=/cradle:rw,size=50m,mode=1777", "--shm-size=1m"),
    *("--pids-limit=12", "--oom-score-adj=1000", "--ulimit=core=0:0", "--ulimit=cpu=60:60"),
    *("--ulimit=fsize=40000000:40000000", "--ulimit=nofile=256:256", "--ulimit=nproc=4096:4096"),
    *(f"--env={name}=" for name in PROXIES),
    *(f"--env={name.upper()}=" for name in PROXIES),
]
# Without the first one, podman leaves /tmp open. The second one holds if this program is killed.
OF_PODMAN = ["--read-only-tmpfs=false", f"--timeout={one_run.SECONDS + SPARE}"]
ONE_RUN = "/autograder/source/tests/teacher/one_run.py"
NO_START = 125  # the exit status if the engine could not start a run; a solution can have it, too
PATIENCE = 60  # s for an answer of the engine


def call(program, *words) -> subprocess.CompletedProcess:
    """Run a command of an engine to its end."""
    try:
        return subprocess.run(
            [program, *words],
            capture_output=True,
            text=True,
            errors="replace",
            stdin=subprocess.DEVNULL,
            timeout=PATIENCE,
            **APART,
        )
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(words, 1, "", "it does not answer")


def size_of(program) -> tuple[int, int]:
    """Return how many cores, and bytes of memory, an engine has; raise an OSError if it does not
    run."""
    info = call(program, "info", "--format", SIZES[program])
    found = re.fullmatch(r"([1-9]\d*) ([1-9]\d*)", info.stdout.strip())
    if found is None:
        reason = [f"status {info.returncode}", *info.stderr.strip().splitlines()][-1]
        raise OSError(0, f"it does not run: {reason}", program)
    return int(found[1]), int(found[2])


class Engine(Runner):
    """Runs each pytest in a container, by this program: podman or docker."""

    def __init__(self, folder, starter, stopped, program, cores, memory):
        """starter has the files in this folder by their paths; Ctrl+C sets stopped, an Event."""
        super().__init__(folder)
        self.stopped = stopped
        version = hashlib.sha256(repr((starter, BASE)).encode()).hexdigest()[:16]
        self.image = f"localhost/cradle-grader:{version}"
        self.program = program
        self.cores = cores
        share = min(MEMORY, memory // (cores + 1))
        self.limits = [*LIMITS, f"--memory={share}", f"--memory-swap={share}"]
        if program == "podman":
            self.limits += OF_PODMAN
        self.building: subprocess.Popen | None = None
        self.is_told = False  # that the class has been stopped

    def open(self) -> None:
        self.build()
        self.stderr = None  # at first, the engine's own words are for the teacher
        super().open()
        self.stderr = subprocess.DEVNULL

    def build(self) -> None:
        """Build the image, if it is not there; raise an OSError if this fails."""
        if call(self.program, "image", "inspect", self.image).returncode == 0:
            return
        print("The image for the containers is built once. It takes a minute.", flush=True)
        command = [self.program, "build", "--quiet", f"--tag={self.image}"]
        if BASE:
            command.append(f"--build-arg=BASE={BASE}")
        file = self.folder / "tests" / "teacher" / "Containerfile"
        self.building = subprocess.Popen(
            [*command, f"--file={file}", self.folder],
            stdout=subprocess.DEVNULL,
            **APART,
        )
        if self.stopped.is_set():  # what begins after Ctrl+C can ignore the signal of end_all
            self.building.kill()
        if self.building.wait() or self.stopped.is_set():
            raise OSError(0, "cannot be built", "The image")

    def run_package(self, content) -> tuple[int, bytes]:
        status, output = super().run_package(content)
        if status == NO_START:
            size_of(self.program)  # or the class ends here
        return status, output

    def command(self, name) -> list[str]:
        run = [self.program, "run", f"--name={name}", *self.limits, self.image]
        # one_run.py itself ends a pytest that takes too long
        seconds = one_run.SECONDS
        return [*run, "timeout", "-k", "5", f"{seconds + 5}", "python", ONE_RUN, f"{seconds}"]

    def end(self, name) -> None:
        with READ_OR_START:
            call(self.program, "kill", name)

    def end_all(self) -> None:
        if self.building and not self.is_told:
            self.is_told = True  # a second signal could damage the engine's images
            self.building.terminate()
        super().end_all()


def find_engine(folder, starter, stopped) -> Engine:
    """Return the first engine that runs, for the starter in this folder, with these files.

    Raises an OSError without one.
    """
    error = OSError(0, "it is not installed; tests/starter/README.md says how", "podman")
    for program in SIZES:
        if shutil.which(program):
            try:
                return Engine(folder, starter, stopped, program, *size_of(program))
            except OSError as found:
                error = found
    raise error
