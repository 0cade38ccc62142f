"""A fresh folder and a pytest for each submission: what it may reach, and how long it may take.

In bubblewrap (github.com/containers/bubblewrap), it sees Python, libraries and a folder in memory,
and no network.
"""

import json
import os
import shutil
import site
import socket
import subprocess
import sys
import tempfile
from contextlib import suppress
from errno import ENOSPC
from pathlib import Path
from typing import NamedTuple

from teacher import memory, one_run
from teacher.processes import Processes
from teacher.report import no_grade, read_grade
from teacher.seccomp import seccomp_filter

# Seconds by the clock for a submission: ten times the processor time that one_run.py gives it
LAST = 600
ALONE = 120  # if nothing else runs
SPARE = 10  # s in which one_run.py ends a pytest that takes too long
SPACE = 50_000_000  # bytes of a folder in memory
LEAST_FREE = 1_000_000_000  # bytes of the disk, if there are more now
# In bubblewrap: the starter, the student's files, the folder to which they are copied, and one_run
STARTER = "/starter"
OWN = "/own"
FOLDER = "/cradle"
PROGRAM = "/one_run.py"
# What it sees of the system
SYSTEM = [
    "/bin",
    "/sbin",
    "/lib",
    "/lib32",
    "/lib64",
    "/libx32",
    "/nix/store",
    "/etc/alternatives",
    "/etc/ld.so.cache",
    "/etc/localtime",
]
IN_PREFIX = "bin", "lib", "lib32", "lib64", "libx32", "libexec", "share", "pyvenv.cfg"
DEVICES = "/dev/null", "/dev/random", "/dev/urandom"  # not zero: shared, it is uncounted memory
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0
USERS = range(60_600, 61_100)  # numbers that systems give to nobody
REMOVE = (
    ["cmd", "/c", "rd", "/s", "/q"]
    if os.name == "nt"
    else ["sh", "-c", 'chmod -R u+rwx "$0"; rm -rf "$0"']
)
# It kills all processes of a user at once. It becomes this user last, so they have no time to kill
# it.
END_ALL = """
import os, sys
user = int(sys.argv[1])
os.setgroups([])
os.setgid(user)
os.setuid(user)
os.kill(-1, 9)
"""
# It removes the user's files from the folders in which everybody can write.
REMOVE_ALL = 'ipcrm -a; find /tmp /var/tmp /dev/shm -user "$0" -delete'
QUIETLY = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


class GradedRun(NamedTuple):
    """What has become of a submission."""

    grade: dict  # as report.read_grade returns it, or report.no_grade
    problem: str  # why there is no grade, or ""
    is_final: bool  # whether no other program can have changed this


class Sandbox:
    """Runs pytest for submissions in a copy of the starter, below the folder work.

    Open it first.
    """

    def __init__(self, starter, work, has_bubblewrap, stopped):
        """stopped is an Event: once it is set, all ends that runs, and nothing more begins."""
        self.starter = starter
        self.work = work
        self.has_bubblewrap = has_bubblewrap
        self.bubblewrap = bubblewrap(work / "filter") if has_bubblewrap else []
        self.has_systemd = False
        self.empty: dict = {}  # the grade of the starter
        self.least_free = min(LEAST_FREE, shutil.disk_usage(work).free // 2)
        self.stopped = stopped
        self.processes = Processes()

    def open(self) -> None:
        """Find out what the system has; raise an OSError if the starter cannot be graded."""
        self.work.chmod(0o711)  # for other users
        if shutil.which("systemd-run"):
            self.has_systemd = self.processes.run(*memory.in_systemd(10**8), "true", **QUIETLY) == 0
        status, output = self.run_files({}, ALONE, 1)
        with suppress(ValueError):
            self.empty = json.loads(output)
        if read_grade(self.empty, output) is None:
            why = self.why_not(status, output)
            raise OSError(0, f"pytest does not grade it{why}", "The starter")

    def why_not(self, status, output) -> str:
        """Return what is known of a starter without a grade, as the end of a sentence."""
        if self.empty:
            return ". It was made by another version of make_starter.py"
        lines = output.decode(errors="replace").strip().split("\n")
        last = lines[-1] or f"status {status}"
        return f" in bubblewrap: {last}. See --help" if self.has_bubblewrap else f" here: {last}"

    def run(self, files, jobs, is_alone=False) -> GradedRun:
        """Run pytest for the files of a submission, by their paths in the project.

        jobs is the number of runs side by side. Raises an OSError if it is alone, and the disk is
        full.
        """
        seconds = ALONE if is_alone else LAST
        status, output = self.run_files(files, seconds, jobs)
        if is_alone and self.is_full():
            raise OSError(ENOSPC, "No space left", str(self.work))
        grade = read_grade(self.empty, output)
        if grade is None:
            if status == one_run.LATE:
                how = f"pytest took longer than {seconds} s"
            elif isinstance(status, int):
                how = f"pytest ended with status {status}"
            else:
                how = status
            return GradedRun(no_grade(self.empty, output), f"no grade: {how}", is_final=False)
        has_ended = isinstance(status, int) and status < one_run.LATE
        return GradedRun(grade, "", is_final=grade.pop("final") and has_ended)

    def is_full(self) -> bool:
        """Return whether the disk is nearly full."""
        return shutil.disk_usage(self.work).free < self.least_free

    def must_stop(self) -> bool:
        """Return whether a run must end now."""
        return self.stopped.is_set() or self.is_full()

    def run_files(self, files, seconds, jobs) -> tuple[int | str, bytes]:
        """Run pytest for these files, at most this long. It gets the memory of one of these jobs.

        Return the exit status, or why there is none, and what one_run.py has written.
        """
        folder = Path(tempfile.mkdtemp(dir=self.work))
        try:
            for name, content in files.items():
                path = folder / "own" / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            (folder / "own").mkdir(exist_ok=True)
            with tempfile.TemporaryFile(dir=self.work) as output:
                status = self.run_in(folder, output, seconds, jobs)
                output.seek(0)
                found = output.read(one_run.MOST_BYTES + 1)
            return "the disk was full" if self.is_full() else status, found
        except (OSError, ValueError, RecursionError, MemoryError) as error:
            return f"the files cannot be written: {getattr(error, 'strerror', error)}", b""
        finally:
            # No process can be started now: the folder goes with those of the others
            with suppress(OSError):
                self.processes.run(*REMOVE, str(folder), **QUIETLY)

    def run_in(self, folder, output, seconds, jobs) -> int:
        """Run pytest in a folder, and end all that it has started; return its exit status."""
        if not IS_ROOT:
            return self.run_as(0, folder, output, seconds, jobs)
        user, claim = free_user()
        with claim:
            return self.run_as(user, folder, output, seconds, jobs)

    def run_as(self, user, folder, output, seconds, jobs) -> int:
        """Do what run_in does, as the user with a number, or as yourself if the number is 0."""
        if user:
            for path in (folder, *folder.rglob("*")):
                os.chown(path, user, user)
        command = self.command(user, folder, seconds)
        try:
            with memory.bounded(command, memory.share(jobs), self.has_systemd) as bounded:
                status = self.processes.run(
                    *bounded,
                    seconds=seconds + SPARE,
                    stop=self.must_stop,
                    env=self.environment(folder),
                    cwd=folder,
                    stdin=subprocess.DEVNULL,
                    stdout=output,
                    stderr=output,
                )
        finally:
            if user and not self.has_bubblewrap:
                self.processes.run(sys.executable, "-c", END_ALL, str(user), **QUIETLY)
                self.processes.run("sh", "-c", REMOVE_ALL, str(user), user=user, **QUIETLY)
        return one_run.LATE if status is None else one_run.as_in_a_shell(status)

    def command(self, user, folder, seconds) -> list[str]:
        """Return the words that run pytest for the submission in a folder."""
        limits = [str(user), str(seconds)]
        files = str(folder / "own")
        if not self.has_bubblewrap:
            return [sys.executable, one_run.__file__, *limits, str(self.starter), files]
        binds = ["--ro-bind", str(self.starter), STARTER, "--ro-bind", files, OWN]
        return [*self.bubblewrap, *binds, sys.executable, PROGRAM, *limits, STARTER, OWN]

    def environment(self, folder) -> dict[str, str]:
        """Return the environment of a run."""
        if os.name == "nt":
            given = dict(os.environ)
        else:
            given = {name: os.environ[name] for name in memory.BUS if name in os.environ}
            given |= {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
        home = FOLDER if self.has_bubblewrap else str(folder)
        return given | {
            "HOME": home,
            "TMPDIR": home,
            "PYTHONUSERBASE": site.getuserbase(),
            "OPENBLAS_NUM_THREADS": "1",
            "PYTHONDONTWRITEBYTECODE": "1",
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
            "COLUMNS": "100",
        }


def free_user() -> tuple[int, socket.socket]:
    """Return the number of a user that no other run has, also of another class.

    This holds as long as the socket is open.
    """
    for user in USERS:
        claim = socket.socket(type=socket.SOCK_DGRAM)
        with suppress(OSError):  # another run has the port with this number
            claim.bind(("127.0.0.1", user))
            return user, claim
        claim.close()
    raise OSError(0, "all of them run solutions already", f"the users {USERS}")


def bubblewrap(filter_file) -> list[str]:
    """Return the words before a command that start it in bubblewrap.

    The kernel's filter is written into this file.
    """
    filter_file.write_bytes(seccomp_filter())
    bwrap = f"{shutil.which('bwrap')}"
    start = ["sh", "-c", 'exec "$@" 9<"$0"', str(filter_file), bwrap, "--die-with-parent"]
    if seccomp_filter():
        start += ["--seccomp", "9"]
    for name in ("ipc", "pid", "net", "uts", "cgroup-try"):
        start.append(f"--unshare-{name}")
    # Root makes the sandbox, and one_run.py becomes another user in it: limits of root's processes
    # have no effect.
    if not IS_ROOT:
        start.append("--unshare-user")
    return [*start, *mounts()]


def mounts() -> list[str]:
    """Return the options of bubblewrap for the folders that a solution sees."""
    visible = visible_paths()
    folders = {"/dev", STARTER, OWN}
    for path in visible:
        folders.update(map(str, Path(path).parents))
    options = []
    for folder in sorted(folders):
        options += ["--perms", "0755", "--dir", folder]
    for path in visible:
        options += ["--ro-bind", path, path]
    for device in DEVICES:
        options += ["--dev-bind", device, device]
    options += ["--ro-bind", one_run.__file__, PROGRAM]
    known = subprocess.run(["bwrap", "--help"], capture_output=True, check=False).stdout
    if b"--size" in known:  # from version 0.8 on
        options += ["--size", str(SPACE)]
    options += ["--perms", "1777", "--tmpfs", FOLDER]
    # It writes only into its own folder
    return [*options, "--remount-ro", "/", "--chdir", FOLDER]


def visible_paths() -> list[str]:
    """Return the paths of the system and of Python that a solution sees, if they are there."""
    paths = [*SYSTEM]
    for prefix in ("/usr", "/usr/local", sys.base_prefix, sys.prefix):
        paths += [f"{os.path.abspath(prefix)}/{name}" for name in IN_PREFIX]
    paths.append(site.getusersitepackages())
    return [path for path in paths if os.path.exists(path)]
