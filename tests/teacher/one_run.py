"""Run pytest in a copy of folders, with limits: `one_run.py USER SECONDS FOLDER...`.

USER is the number of a user, or 0 for yourself.
"""

import ctypes
import os
import shutil
import subprocess
import sys
from contextlib import suppress

PYTEST = (
    "pytest --assert=plain -p no:cacheprovider -o faulthandler_timeout=20 --grade-json=grade.json"
)
NO_NEW_PRIVILEGES = 38  # prctl's number
LATE = 124  # the exit status after the time by the clock
MOST_BYTES = 1_000_000  # of a grade
MOST_OUTPUT = 3000  # bytes of what pytest has printed
MOST_PROCESSES = 8  # with threads; pytest and the grader have 4
# Seconds, bytes and files of each process. grading/limits.py allows less than DATA; AS limits
# shared memory, too.
LIMITS = {
    "CORE": 0,
    "CPU": 60,
    "FSIZE": 40 * 10**6,
    "NOFILE": 256,
    "DATA": 1300 * 10**6,
    "AS": 2500 * 10**6,
}


def main(user, seconds, *folders) -> int:
    """Print the grade or, without one, the end of pytest's output; return its exit status.

    The status is LATE after these seconds. As root, it takes the number of another user, or raises
    an OSError.
    """
    if user:
        os.setgroups([])
        os.setgid(user)
        os.setuid(user)
    elif os.name != "nt" and os.geteuid() == 0:
        raise PermissionError("a solution does not run as root")
    # No program gives it the rights of another user: one that a solution has left, too
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0)
    if os.name != "nt":
        limit_resources()
    for folder in folders:  # a file in a later one takes the place of that in an earlier one
        shutil.copytree(folder, "project", dirs_exist_ok=True)
    os.chdir("project")
    status = LATE
    with open("output.txt", "w+b") as output:
        with suppress(subprocess.TimeoutExpired):
            status = subprocess.run(
                [sys.executable, "-m", *PYTEST.split()],
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=output,
                timeout=seconds,
                check=False,
            ).returncode
        output.seek(max(0, output.tell() - MOST_OUTPUT))
        found = output.read()
    with suppress(OSError), open("grade.json", "rb", opener=at_once) as grade:
        found = grade.read(MOST_BYTES + 1)
    os.write(1, found)
    return as_in_a_shell(status)


def limit_resources() -> None:
    """Limit what pytest and all that it starts can take, as far as the system allows it."""
    import resource

    for name, most in LIMITS.items():
        # macOS refuses some, and a system those above its own
        with suppress(ValueError, OSError):
            resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (most, most))
    limit_processes(resource)


def as_in_a_shell(status) -> int:
    """Return the exit status of a process as a shell does.

    It is 128 and the number of the signal that has ended it.
    """
    return status if status >= 0 else 128 - status


def at_once(path, flags) -> int:
    """Open a file, which may be a pipe to which nobody writes."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))  # Windows has no such pipe


def limit_processes(resource) -> None:
    """Allow MOST_PROCESSES more than this user has now.

    Outside of a sandbox, the system counts all of them.
    """
    hard = resource.getrlimit(resource.RLIMIT_NPROC)[1]
    for number in range(50_000):  # of processes that there are
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_NPROC, (number + 1, hard))
            child = os.fork()
            if child == 0:
                os._exit(0)
            os.waitpid(child, 0)
            most = number + MOST_PROCESSES
            resource.setrlimit(resource.RLIMIT_NPROC, (most, most))
            return


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]), *sys.argv[3:]))
