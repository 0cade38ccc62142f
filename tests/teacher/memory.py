"""How much memory a solution has with all of its processes.

docs.kernel.org/admin-guide/cgroup-v2.html
"""

import os
from collections.abc import Iterator
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
def bounded(command, size, has_systemd) -> Iterator[list[str]]:
    """Yield the words that start a command in a group with this many bytes.

    If this user cannot have a group, the command starts without one.
    """
    if os.name == "nt":
        yield command
        return
    group = None if has_systemd else new_group(size)
    if has_systemd:
        command = [*in_systemd(size), *command]
    processes = group / "cgroup.procs" if group else os.devnull
    try:
        yield ["sh", "-c", START, f"{processes}", *command]
    finally:
        if group:
            with suppress(OSError):  # a process is still there
                group.rmdir()


def own_group() -> Path:
    """Return the file with the limit of the group in which the system counts this program.

    Raises an OSError if the system has none.
    """
    for line in Path("/proc/self/cgroup").read_text().splitlines():
        _, kinds, path = line.split(":", 2)
        # Of version 1, which comes first if it is there, and of version 2
        if kinds == "memory" or not kinds:
            name = "memory.limit_in_bytes" if kinds else "memory.max"
            folder = MOUNT / kinds / path[1:]
            return folder / name if folder.is_dir() else MOUNT / kinds / name
    raise FileNotFoundError


def share(jobs) -> int:
    """Return how many bytes each of these solutions side by side can have.

    All of them fit into what the other programs leave.
    """
    sizes = [MOST * (jobs + 1)]
    with suppress(OSError, ValueError):
        for line in Path("/proc/meminfo").read_text().splitlines():
            if line.startswith("MemAvailable"):
                sizes.append(1024 * int(line.split()[1]))
        sizes.append(int(own_group().read_text()))  # "max" if it has no limit
    return min(sizes) // (jobs + 1)


def new_group(size) -> Path | None:
    """Return the folder of a new group with this many bytes.

    Return None if this user cannot make one; mostly, root can.
    """
    with suppress(OSError):
        limit = own_group()
        folder = limit.parent / f"cradle-{os.getpid()}-{next(NUMBERS)}"
        folder.mkdir()
        try:
            (folder / limit.name).write_text(f"{size}")
        except OSError:
            folder.rmdir()
            raise
        return folder
    return None


def in_systemd(size) -> list[str]:
    """Return the words before a command that start it in a group of systemd's."""
    user = [] if os.geteuid() == 0 else ["--user"]
    limits = ["-p", f"MemoryMax={size}", "-p", "MemorySwapMax=0"]
    return ["systemd-run", *user, "--scope", "--quiet", "--collect", *limits, "--"]
