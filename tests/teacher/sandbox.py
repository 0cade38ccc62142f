"""The process of a solver: what it may reach, and how much it may take.

Under bubblewrap, a solver sees Python, the system's libraries and a folder in memory, and nothing else: no files, no
processes, no network. https://github.com/containers/bubblewrap
"""

import compileall
import os
import select
import shutil
import signal
import site
import subprocess
import sys
import tempfile
from contextlib import suppress
from functools import cache
from pathlib import Path

from grading.project_path import ROOT

SPACE = 50_000_000  # bytes of a solver's folder
SYSTEM = (
    *("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/nix/store"),
    *("/etc/alternatives", "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/localtime"),
)
ALONE = ("--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try")
FIRST_USER, USERS = 60_600, 500  # numbers that systems give to nobody
LONGEST_END = 20.0  # s
IN_SANDBOX = Path("/cradle")  # the solver's folder
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0

COPIES, BWRAP, USER, LIMITS = "copies", "bwrap", "user", "limits"  # what holds a solver off
ALSO = "To hold this off, too, on Linux: apt install bubblewrap."
# What a solution can do nevertheless. Where COPIES do not work, each solution has a sandbox and a start of its own.
REMARKS = {
    COPIES: "",
    BWRAP: "",
    USER: f"Without bubblewrap, a solution can use the network, and read files that all users may read. {ALSO}",
    LIMITS: f"Without bubblewrap, a solution can use the network and all of your files. {ALSO}",
}


def holds_off(room, hidden) -> str:
    """Return the first of REMARKS with which a process starts here; raise an OSError if there is none."""
    for kind in REMARKS:
        if kind in (COPIES, BWRAP) and shutil.which("bwrap") is None or kind == USER and not IS_ROOT:
            continue
        process = Process(room, kind, hidden)
        process.begin()
        says = process.stdout.readline()
        process.end()
        if says.startswith(b"{"):
            return kind
    raise OSError(0, "A process for solutions does not start")


class Process:
    """A process of solver.py for one solution after the other, and all that it starts."""

    def __init__(self, room, kind, hidden=()):
        """room is the folder that make_room has made. kind is one of REMARKS. The solver sees no hidden folder."""
        self.room, self.kind, self.hidden = room, kind, hidden
        self.user = FIRST_USER + os.getpid() % USERS if IS_ROOT and kind != LIMITS else 0
        self.process, self.folder = None, None

    def begin(self) -> None:
        """Start a process for a solution: stdin and stdout lead to it."""
        if self.process is None:
            self.start()
        if self.kind == COPIES:
            with suppress(OSError):  # stdout will show that it has ended
                os.write(self.orders, b"\n")
        self.stdin, self.stdout = self.process.stdin, self.process.stdout

    def start(self) -> None:
        """Start a process that waits for a solution."""
        ends: list[int] = []  # that the process has, too
        if self.kind in (COPIES, BWRAP):
            folder, before = IN_SANDBOX, bubblewrap(self.room, self.hidden)
        else:
            self.folder = tempfile.TemporaryDirectory(prefix="cradle_", ignore_cleanup_errors=True)
            folder, before = Path(os.path.realpath(self.folder.name)), []
            shutil.copytree(self.room, folder, dirs_exist_ok=True)
            if self.user:
                os.chown(folder, self.user, self.user)
        if self.kind == COPIES:
            (orders, self.orders), (self.done, done) = os.pipe(), os.pipe()
            ends = [orders, done]
        python = [sys.executable, str(folder / "tests" / "teacher" / "solver.py"), *map(str, [self.user, *ends])]
        environment = dict(os.environ) if os.name == "nt" else {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
        environment.update(HOME=str(folder), TMPDIR=str(folder), PYTHONUSERBASE=site.getuserbase())
        environment.update(PYTHONDONTWRITEBYTECODE="1", OPENBLAS_NUM_THREADS="1")
        # In a session of its own: Ctrl+C reaches only the program that tells it.
        self.process = subprocess.Popen(
            [*before, *python],
            **{"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "bufsize": 0},
            **{"env": environment, "cwd": "/" if before else folder, "start_new_session": True, "pass_fds": ends},
        )
        for end in ends:
            os.close(end)

    def end(self) -> None:
        """End the solution's process and all that it has started."""
        if self.process is None or self.kind == COPIES and self.copy_ends():
            return
        if self.kind in (USER, LIMITS) and hasattr(os, "killpg"):
            with suppress(OSError):
                os.killpg(self.process.pid, signal.SIGKILL)
        if self.kind == USER:  # also what has left the session
            who = {"user": self.user, "group": self.user, "extra_groups": []}
            subprocess.run(["sh", "-c", "kill -KILL -1"], **who, check=False, capture_output=True)
        self.process.kill()
        with self.process:
            self.process.wait()
        self.process = None
        if self.kind == COPIES:
            os.close(self.orders)
            os.close(self.done)
        if self.folder is not None:
            self.folder.cleanup()

    def copy_ends(self) -> bool:
        """Let the process end its copy; return whether it has done so. Nothing of the copy is left in stdout."""
        try:
            os.write(self.orders, b"\n")
            if not select.select([self.done], [], [], LONGEST_END)[0] or not os.read(self.done, 1):
                return False
        except OSError:
            return False
        while select.select([self.process.stdout], [], [], 0)[0] and self.process.stdout.read(1 << 16):
            pass
        return True

    def close(self) -> None:
        """End everything."""
        self.kind = BWRAP if self.kind == COPIES else self.kind
        self.end()

    def status(self) -> int | None:
        """Return the exit status of a process that has just ended, as a shell has it, or None."""
        with suppress(subprocess.TimeoutExpired):
            status = self.process.wait(1.0)
            return 128 - status if status < 0 else status
        return None


def bubblewrap(room, hidden) -> list[str]:
    """Return the command that starts a command in a sandbox with the room, but with no other file of these folders."""
    python = [sys.prefix, sys.base_prefix, *site.getsitepackages(), site.getusersitepackages()]
    visible = [path for path in (*SYSTEM, *map(os.path.abspath, python)) if os.path.exists(path)]
    mounts = [["--ro-bind", path, path] for path in dict.fromkeys(visible)]
    hidden = {str(folder) for folder in (ROOT, *hidden)}
    mounts += [["--tmpfs", folder] for folder in hidden]
    mounts += [[*size_option(), "--perms", "1777", "--tmpfs", str(IN_SANDBOX)]]
    mounts += [["--ro-bind", str(room / name), str(IN_SANDBOX / name)] for name in ("support", "tests")]
    parents = {parent for mount in mounts for parent in Path(mount[-1]).parents}
    mounts += [["--perms", "0755", "--dir", str(parent)] for parent in parents]
    mounts.sort(key=lambda mount: (len(Path(mount[-1]).parts), "--dir" not in mount))  # the deeper one covers the other
    # Root makes the sandbox, and solver.py becomes another user in it: limits of root's processes have no effect.
    begin = ["bwrap", "--die-with-parent", *(ALONE if IS_ROOT else ["--unshare-all"]), "--dev", "/dev"]
    end = [["--remount-ro", folder] for folder in (*hidden, "/dev", "/")]  # it can write only into its own folder
    return [*begin, *(word for mount in mounts + end for word in mount)]


@cache
def size_option() -> list[str]:
    """Return the option that limits a folder in memory; before version 0.8, bubblewrap does not have it."""
    known = subprocess.run(["bwrap", "--help"], capture_output=True, text=True, check=False).stdout
    return ["--size", str(SPACE)] if "--size" in known else []


def make_room(starter, folder) -> Path:
    """Make the folder that solvers share: the starter's support/, and what a solver needs of the grader."""
    shutil.copytree(starter / "support", folder / "support", ignore=shutil.ignore_patterns("__pycache__"))
    names = ("__init__", "handout", "limits", "own_process", "project_path", "raised")
    files = [ROOT / "tests" / "grading" / f"{name}.py" for name in names]
    for file in [*files, *(Path(__file__).with_name(f"{name}.py") for name in ("__init__", "crossing", "solver"))]:
        (folder / file.relative_to(ROOT)).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, folder / file.relative_to(ROOT))
    compileall.compile_dir(folder, quiet=2)
    return folder
