"""The process of a solver: what it may reach, and how much it may take.

Under bubblewrap, a solver sees Python, the system's libraries and a folder in memory, and nothing else: no files, no
processes, no network. https://github.com/containers/bubblewrap
"""

import compileall
import os
import shutil
import signal
import site
import socket
import subprocess
import sys
import tempfile
from contextlib import closing, suppress
from pathlib import Path

from grading.begin import ROOT

SPACE = 50_000_000  # bytes of a solver's folder
SYSTEM = (
    *("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/nix/store"),
    *("/etc/alternatives", "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/localtime"),
)
ALONE = ("--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try")
FIRST_USER, USERS = 60_600, 500  # numbers that systems give to nobody
START_OR_END = 20.0  # s, of the start of a process and of its end
IN_SANDBOX = Path("/cradle")  # the solver's folder
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0

GRADING = "begin", "cradles", "evidence", "handout", "hints", "limits", "messages", "own_process", "raised", "values"
# The files of tests/ that a solver needs.
SOLVERS = (*(f"grading/{name}" for name in GRADING), "teacher/crossing", "teacher/solver")

BWRAP, LIMITS = "bwrap", "limits"  # what holds a solver off
LEFT_OPEN = {BWRAP: "", LIMITS: "the network, and all of your files"}  # what a solution can use nevertheless


def holds_off(copied, hidden) -> str:
    """Return the first of LEFT_OPEN with which a process starts here; raise an OSError if there is none."""
    for kind in LEFT_OPEN:
        if kind == BWRAP and shutil.which("bwrap") is None:
            continue
        process = Process(copied, kind, hidden)
        process.begin()
        process.line.settimeout(START_OR_END)
        with closing(process), suppress(OSError):
            if process.line.recv(1) == b"{":
                return kind
    raise OSError(0, "it does not start", "tests/teacher/solver.py")


class Process:
    """A process of solver.py for a solution, and all that it starts."""

    def __init__(self, copied, kind, hidden=()):
        """copied is the folder that copy_files has made. kind is one of LEFT_OPEN. The solver sees no hidden folder."""
        self.copied, self.kind, self.hidden = copied, kind, hidden
        self.user = FIRST_USER + os.getpid() % USERS if IS_ROOT and kind != LIMITS else 0
        self.process = self.folder = self.line = None  # line leads to the process

    def begin(self) -> None:
        """Start a process for a solution."""
        if self.kind == BWRAP:
            folder, before = IN_SANDBOX, bubblewrap(self.copied, self.hidden)
        else:
            self.folder = tempfile.TemporaryDirectory(prefix="cradle_", ignore_cleanup_errors=True)
            folder, before = Path(os.path.realpath(self.folder.name)), []
            shutil.copytree(self.copied, folder, dirs_exist_ok=True)
        self.line, end = socket.socketpair()
        end.set_inheritable(True)
        numbers = self.user, end.fileno()
        python = [sys.executable, "-B", str(folder / "tests" / "teacher" / "solver.py"), *map(str, numbers)]
        environment = dict(os.environ) if os.name == "nt" else {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
        environment.update(HOME=str(folder), TMPDIR=str(folder), PYTHONUSERBASE=site.getuserbase())
        options = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.DEVNULL)
        options.update({"close_fds": False} if os.name == "nt" else {"pass_fds": [end.fileno()]})
        options.update(env={**environment, "OPENBLAS_NUM_THREADS": "1"}, cwd="/" if before else folder)
        with end:  # in a session of its own: Ctrl+C reaches only the program that tells it
            self.process = subprocess.Popen([*before, *python], start_new_session=True, **options)

    def end(self) -> None:
        """End the solution's process and all that it has started."""
        if self.line is not None:
            self.line.close()
            self.line = None
            self.close()

    def close(self) -> None:
        """End everything."""
        if self.process is None:
            return
        with suppress(OSError, AttributeError):  # Windows has no groups
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.kill()
        self.process.wait()
        self.process = None
        if self.folder:
            self.folder.cleanup()


def bubblewrap(copied, hidden) -> list[str]:
    """Return the command that starts a command in a sandbox with the copied files, but with no other file."""
    python = [sys.prefix, sys.base_prefix, *site.getsitepackages(), site.getusersitepackages()]
    visible = [path for path in (*SYSTEM, *map(os.path.abspath, python)) if os.path.exists(path)]
    mounts = [["--ro-bind", path, path] for path in dict.fromkeys(visible)]
    hidden = {str(folder) for folder in (ROOT, *hidden)}
    mounts += [["--tmpfs", folder] for folder in hidden]
    known = subprocess.run(["bwrap", "--help"], capture_output=True, text=True, check=False).stdout
    size = ["--size", str(SPACE)] if "--size" in known else []  # from version 0.8 on
    mounts += [[*size, "--perms", "1777", "--tmpfs", str(IN_SANDBOX)]]
    mounts += [["--ro-bind", str(copied / name), str(IN_SANDBOX / name)] for name in ("support", "tests")]
    parents = {parent for mount in mounts for parent in Path(mount[-1]).parents}
    mounts += [["--perms", "0755", "--dir", str(parent)] for parent in parents]
    mounts.sort(key=lambda mount: (len(Path(mount[-1]).parts), "--dir" not in mount))  # the deeper one covers the other
    # Root makes the sandbox, and solver.py becomes another user in it: limits of root's processes have no effect.
    begin = ["bwrap", "--die-with-parent", *(ALONE if IS_ROOT else ["--unshare-all"]), "--dev", "/dev"]
    end = [["--remount-ro", folder] for folder in (*hidden, "/dev", "/")]  # it can write only into its own folder
    return [*begin, *(word for mount in mounts + end for word in mount)]


def copy_files(starter, folder) -> Path:
    """Make the folder that solvers share: the starter's support/, and what a solver needs of the grader."""
    shutil.copytree(starter / "support", folder / "support", ignore=shutil.ignore_patterns("__pycache__"))
    for name in SOLVERS:
        file = folder / "tests" / f"{name}.py"
        file.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / "tests" / f"{name}.py", file)
    compileall.compile_dir(folder, quiet=2)
    return folder
