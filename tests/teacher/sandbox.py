"""A fresh folder and a pytest for each submission: what it may reach, and how long it may take.

In bubblewrap, it sees Python, libraries and a folder in memory, and no network. github.com/containers/bubblewrap
"""

import asyncio
import ctypes
import json
import os
import platform
import shutil
import signal
import site
import struct
import subprocess
import sys
import tempfile
from contextlib import suppress
from errno import EDQUOT, ENOSPC
from functools import partial
from itertools import count
from pathlib import Path

from support.start.output import complain
from teacher import one_run

SPARE, SPACE = 10, 50_000_000  # s in which one_run.py ends a pytest that takes too long; bytes of a folder in memory
STARTER, OWN, FOLDER, PROGRAM = "/starter", "/own", "/cradle", "/one_run.py"  # in bubblewrap: copied, to where, by what
SYSTEM = "/bin /sbin /lib /lib32 /lib64 /libx32 /nix/store /etc/alternatives /etc/ld.so.cache /etc/localtime"
IN_PREFIX = "bin", "lib", "lib32", "lib64", "libx32", "libexec", "share", "pyvenv.cfg"  # of Python's folders and /usr
IS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0
USERS = (60_600 + number % 500 for number in count(os.getpid()))  # that systems give to nobody
REMOVE = ["cmd", "/c", "rd", "/s", "/q"] if os.name == "nt" else ["sh", "-c", 'chmod -R u+rwx "$0"; rm -rf "$0"']
NO_CTRL_C = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP} if os.name == "nt" else {"start_new_session": True}
LEFT_OPEN = "Without bubblewrap, a solution can use the network, all of your files, programs and memory."

# What the kernel refuses (docs.kernel.org/userspace-api/seccomp_filter.html): memory that outlives a process (shmget,
# semget, msgget, memfd_create), keys (add_key, request_key, keyctl), namespaces (unshare, clone3, clone), processes of
# others (ptrace, pidfd_getfd, process_vm_writev), locks (flock, a lease by fcntl), sockets to other virtual machines.
CALLS = {  # of a processor: its number, the numbers of these calls, and those of clone, fcntl and socket
    "x86_64": (0xC000003E, (29, 64, 68, 319, 248, 249, 250, 272, 435, 101, 438, 311, 73), (56, 72, 41)),
    "aarch64": (0xC00000B7, (194, 190, 186, 279, 217, 218, 219, 97, 435, 117, 438, 271, 32), (220, 25, 198)),
}
LOAD, IS, IS_FROM, HAS, RETURN, OTHER_TABLE = 0x20, 0x15, 0x35, 0x45, 0x06, 0x40000000  # the calls of x32 begin there
BY_ARGUMENT = (16, HAS, 0x10000000), (24, IS, 1024), (16, IS, 40)  # where it is, and what is refused
REFUSE, ALLOW = (RETURN, 0, 0, 0x50026), (RETURN, 0, 0, 0x7FFF0000)  # ENOSYS: glibc then takes clone for clone3


def seccomp_filter(name, refused, by_argument) -> bytes:
    """Return the filter for a processor, from its row of CALLS."""
    rows = [(LOAD, 0, 0, 4), (IS, 1, 0, name), REFUSE, (LOAD, 0, 0, 0), (IS_FROM, 0, 1, OTHER_TABLE), REFUSE]
    rows += [row for number in refused for row in ((IS, 0, 1, number), REFUSE)]
    for number, (place, test, value) in zip(by_argument, BY_ARGUMENT, strict=True):
        rows += [(IS, 0, 4, number), (LOAD, 0, 0, place), (test, 0, 1, value), REFUSE, ALLOW]
    return b"".join(struct.pack("HBBI", *row) for row in [*rows, ALLOW])


def quietly(*command, **options) -> bytes:
    """Run a command, and return what it prints."""
    return subprocess.run(command, capture_output=True, check=False, **NO_CTRL_C, **options).stdout


def bubblewrap(work) -> list[str]:
    """Return the command that starts a command in bubblewrap; put the filter into the folder work."""
    prefixes = ["/usr", "/usr/local", *map(os.path.abspath, (sys.base_prefix, sys.prefix))]
    python = [f"{prefix}/{name}" for prefix in prefixes for name in IN_PREFIX]
    visible = [path for path in [*SYSTEM.split(), *python, site.getusersitepackages()] if os.path.exists(path)]
    folders = sorted({STARTER, OWN, *(str(parent) for path in visible for parent in Path(path).parents)})
    mounts = [word for folder in folders for word in ("--perms", "0755", "--dir", folder)]
    mounts += [word for path in visible for word in ("--ro-bind", path, path)]
    size = ["--size", str(SPACE)] if b"--size" in quietly("bwrap", "--help") else []  # from version 0.8 on
    mounts += ["--ro-bind", one_run.__file__, PROGRAM, *size, "--perms", "1777", "--tmpfs", FOLDER, "--dev", "/dev"]
    mounts += ["--remount-ro", "/dev", "--remount-ro", "/", "--chdir", FOLDER]  # it writes only into its own folder
    # Root makes the sandbox, and one_run.py becomes another user in it: limits of root's processes have no effect.
    alone = [f"--unshare-{name}" for name in ("ipc", "pid", "net", "uts", "cgroup-try", *["user"] * (not IS_ROOT))]
    rules = [seccomp_filter(*row) for machine, row in CALLS.items() if machine == platform.machine()]
    (file := work / "filter").write_bytes(b"".join(rules))
    # If the memory of the machine is short, the kernel ends solutions first.
    start = 'echo 1000 2>&- >/proc/self/oom_score_adj; exec bwrap "$@" 9<"$0"'
    return ["sh", "-c", start, str(file), *["--seccomp", "9"] * len(rules), "--die-with-parent", *alone, *mounts]


async def run(starter, work, before, drops_root, files) -> tuple[int | str, bytes]:
    """Run pytest for these files of a submission, by their paths below src/, in a copy of the starter.

    before is the command of bubblewrap, if any. Return the exit status, or in words why there is none, and what
    one_run.py has written. Raise an OSError if the disk of the folder work is full.
    """
    folder = Path(tempfile.mkdtemp(dir=work))
    try:
        (folder / "own").mkdir()
        for path, content in ((folder / "own" / "src" / name, content) for name, content in files.items()):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        with tempfile.TemporaryFile(dir=work) as output:
            status = await run_in(folder, starter, before, drops_root, output)
            if shutil.disk_usage(work).free < SPACE:
                raise OSError(ENOSPC, "No space left")
            output.seek(0)
            return status, output.read(one_run.MOST_BYTES + 1)
    except (OSError, ValueError, RecursionError) as error:
        if getattr(error, "errno", 0) in (ENOSPC, EDQUOT):
            raise OSError(error.errno, error.strerror, str(work)) from None
        return f"the files cannot be written: {getattr(error, 'strerror', error)}", b""
    finally:
        await asyncio.to_thread(quietly, *REMOVE, str(folder))


async def run_in(folder, starter, before, drops_root, output) -> int:
    """Run pytest in a folder, and end all that it has started; return its exit status."""
    user, own = next(USERS) if drops_root else 0, str(folder / "own")
    for path in (folder, *folder.rglob("*")) if user else ():
        os.chown(path, user, user)
    home, program = str(folder), [one_run.__file__, str(user), str(one_run.WHOLE), str(starter), own]
    if before:
        home, program = FOLDER, [PROGRAM, str(user), str(one_run.WHOLE), STARTER, OWN]
        before = [*before, "--ro-bind", str(starter), STARTER, "--ro-bind", own, OWN]
    environment = dict(os.environ) if os.name == "nt" else {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8"}
    environment |= {"HOME": home, "TMPDIR": home, "PYTHONUSERBASE": site.getuserbase(), "OPENBLAS_NUM_THREADS": "1"}
    environment |= {"PYTHONDONTWRITEBYTECODE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "COLUMNS": "100"}
    pipes = {"stdin": subprocess.DEVNULL, "stdout": output, "stderr": output}
    job = ctypes.windll.kernel32.CreateJobObjectW(None, None) if os.name == "nt" else None
    process = subprocess.Popen([*before, sys.executable, *program], **pipes, **NO_CTRL_C, env=environment, cwd=folder)
    try:
        if job:  # from now on, all that it starts is in its job, also after it has ended
            ctypes.windll.kernel32.AssignProcessToJobObject(job, int(process._handle))
        return await asyncio.wait_for(asyncio.to_thread(process.wait), one_run.WHOLE + SPARE)
    except asyncio.TimeoutError:
        return one_run.LATE
    finally:
        process.kill()
        if job:
            ctypes.windll.kernel32.TerminateJobObject(job, 1)
            ctypes.windll.kernel32.CloseHandle(job)
        with suppress(OSError, AttributeError):  # macOS refuses it for a process that has just ended
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        if user and not before:  # what has left its group
            quietly("sh", "-c", "ipcrm -a; kill -9 -1", user=user)


async def open_sandbox(starter, work) -> tuple:
    """Return run with its first arguments, and the grade of the starter; raise an OSError if this cannot be graded."""
    work.chmod(0o711)  # for other users
    has_bwrap = shutil.which("bwrap") is not None
    for command, drops_root in [(bubblewrap, IS_ROOT)] * has_bwrap + [(None, True)] * IS_ROOT + [(None, False)]:
        run_one = partial(run, starter, work, command(work) if command else [], drops_root)
        status, output = await run_one({})
        with suppress(ValueError):
            empty = json.loads(output)
            if command is None:
                complain(LEFT_OPEN + (" It does not work here." if has_bwrap else " On Linux: apt install bubblewrap."))
            return run_one, empty
    raise OSError(0, f"pytest does not grade it: {output.decode(errors='replace').strip() or status}", str(starter))
