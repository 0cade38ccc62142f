"""How much memory a solution has with all of its processes:
docs.kernel.org/admin-guide/cgroup-v2.html.
"""

import os
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path

MOST = 1_500_000_000  # bytes for a solution: one_run.py allows 1.3 GB to a process
MOUNT = Path("/sys/fs/cgroup")
NUMBERS = count()
# If the memory of the machine is short, the kernel ends solutions first. $0 takes the process into
# a group.
START = 'echo 1000 2>&- >/proc/self/oom_score_adj; echo $$ 2>&- >"$0"; exec "$@"'
# Of the environment: systemd-run finds systemd with them
BUS = "XDG_RUNTIME_DIR", "DBUS_SESSION_BUS_ADDRESS"


@contextmanager
def bounded(command, size, has_systemd):
    """Yield the words that start a command in a group with this many bytes, as far as this user can
    have one.
    """
    if os.name == "nt":
        yield command
        return
    group = None
    if has_systemd:
        command = [*in_systemd(size), *command]
    else:
        group = new_group(size)
    processes = group / "cgroup.procs" if group else os.devnull
    try:
        yield ["sh", "-c", START, f"{processes}", *command]
    finally:
        if group:
            with suppress(OSError):  # a process is still there
                group.rmdir()


def own_group() -> tuple[Path, str]:
    """Return the group in which the system counts the memory of this program, and the name of the
    file with its limit.

    Raises an OSError if the system has none.
    """
    for line in Path("/proc/self/cgroup").read_text().splitlines():
        _, kinds, path = line.split(":", 2)
        # Of version 1, which comes first if it is there, and of version 2
        if kinds == "memory" or not kinds:
            folder = MOUNT / kinds
            name = "memory.limit_in_bytes" if kinds else "memory.max"
            return (folder / path[1:] if (folder / path[1:]).is_dir() else folder), name
    raise FileNotFoundError


def share(jobs) -> int:
    """Return how many bytes each of these solutions side by side can have, so that all of them fit
    beside the rest.
    """
    sizes = [MOST * (jobs + 1)]
    with suppress(OSError, ValueError, StopIteration):
        lines = Path("/proc/meminfo").read_text().splitlines()
        sizes.append(
            1024 * next(int(line.split()[1]) for line in lines if line.startswith("MemAvailable"))
        )
        folder, name = own_group()
        sizes.append(int((folder / name).read_text()))  # "max" if it has no limit
    return min(sizes) // (jobs + 1)


def new_group(size) -> Path | None:
    """Return the folder of a new group with this many bytes, None if this user cannot make one;
    mostly, root can.
    """
    with suppress(OSError):
        parent, name = own_group()
        folder = parent / f"cradle-{os.getpid()}-{next(NUMBERS)}"
        folder.mkdir()
        try:
            (folder / name).write_text(f"{size}")
        except OSError:
            folder.rmdir()
            raise
        return folder
    return None


def in_systemd(size) -> list[str]:
    """Return the words before a command with which systemd starts it in a group with this many
    bytes.
    """
    user = [] if os.geteuid() == 0 else ["--user"]
    limits = ["-p", f"MemoryMax={size}", "-p", "MemorySwapMax=0"]
    return ["systemd-run", *user, "--scope", "--quiet", "--collect", *limits, "--"]
