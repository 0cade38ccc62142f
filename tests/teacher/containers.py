"""A container for each submission, by podman or Docker: what it may reach, and what it may take.

It has no network and no files but its own, of which nothing is kept. Its files come on stdin, and
its grade goes to stdout, so the engine can also be that of another machine. Its first process is
timeout: no signal of a solution's ends or stops it.
"""

import os
import shutil
import subprocess
import sys

from support.start.output import say
from teacher import one_run
from teacher.report import digest_of
from teacher.runners import Processes, SPARE

# How an engine says how many cores and bytes of memory it has: mostly those of a virtual machine
SIZES = {
    "podman": "{{.Host.CPUs}} {{.Host.MemTotal}}",
    "docker": "{{.NCPU}} {{.MemTotal}}",
}
INSTALL = {
    "linux": "sudo apt install podman (Fedora: sudo dnf install podman)",
    "darwin": "brew install podman && podman machine init && podman machine start",
    "win32": "winget install RedHat.Podman; podman machine init; podman machine start",
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
TIMEOUT = ["timeout", "-k", "5"]
ONE_RUN = ["python", "/autograder/source/tests/teacher/one_run.py"]


# podman leaves /tmp open otherwise, and ends by itself a container whose first process is stopped
OF_PODMAN = ["--read-only-tmpfs=false", f"--timeout={one_run.SECONDS + SPARE}"]


def call(program, *words) -> subprocess.CompletedProcess:
    """Run a command of an engine to its end."""
    return subprocess.run(
        [program, *words],
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl+C is for this program
    )


class Engine(Processes):
    """Runs each pytest in a container, by this program: podman or docker."""

    def __init__(self, folder, version, program, cores, memory):
        super().__init__(folder)
        # version is that of the files in this folder
        self.image = f"localhost/cradle-grader:{digest_of(version, BASE)[:16]}"
        self.program = program
        self.cores = cores
        share = min(MEMORY, memory // (cores + 1))
        self.limits = [*LIMITS, f"--memory={share}", f"--memory-swap={share}"]
        if program == "podman":
            self.limits += OF_PODMAN
        self.building: subprocess.Popen | None = None

    def open(self) -> None:
        self.build()
        self.stderr = None  # at first, the engine's own words are for the teacher
        super().open()
        self.stderr = subprocess.DEVNULL

    def build(self) -> None:
        """Build the image, if it is not there; raise an OSError if this fails."""
        if call(self.program, "image", "inspect", self.image).returncode == 0:
            return
        say("The image for the containers is built once. It takes a minute.")
        command = [self.program, "build", "--quiet", f"--tag={self.image}"]
        if BASE:
            command.append(f"--build-arg=BASE={BASE}")
        file = self.folder / "tests" / "teacher" / "Containerfile"
        self.building = subprocess.Popen(
            [*command, f"--file={file}", self.folder],
            stdout=subprocess.DEVNULL,
            start_new_session=True,
        )
        if self.building.wait():
            raise OSError(0, "cannot be built", "The image")

    def command(self, name) -> list[str]:
        run = [self.program, "run", f"--name={name}", *self.limits, self.image]
        # one_run.py itself ends a pytest that takes too long
        return [*run, *TIMEOUT, f"{one_run.SECONDS + 5}", *ONE_RUN]

    def end(self, name) -> None:
        call(self.program, "kill", name)

    def end_all(self) -> None:
        if self.building:
            self.building.terminate()
        super().end_all()


def find_engine(folder, version) -> Engine:
    """Return the first engine that runs, for the starter in this folder; raise an OSError without
    one."""
    said = f"install one ({INSTALL.get(sys.platform, 'podman.io')})"
    for program, sizes in SIZES.items():
        if shutil.which(program):
            info = call(program, "info", "--format", sizes)
            if info.returncode == 0:
                cores, memory = map(int, info.stdout.split())
                return Engine(folder, version, program, cores, memory)
            reason = [f"status {info.returncode}", *info.stderr.strip().splitlines()][-1]
            said = f"{program} does not run: {reason}"
    raise OSError(0, f"{said}, or see --here in --help", "No engine")
