"""Run pytest on solutions, each in a process of its own with limits. workers.py starts this file and gives it jobs.

A job is a line of JSON on the standard input:

    {"folder": a starter with the solution, "key": a text, "lost": {function: why it is not called any more},
     "hidden": [folders that the solution must not read]}

The answer is lines with Python's dictionaries on the standard output. Each has the key, which the solution does not
know. Each begins a new line, because the solution may have written half a line:

    {"pid": the process of this solution}
    {"begins": the name of a check}
    {"check": its name, "outcome": the fields of its Outcome, without the call}
    {"changed": [names of the grader that the solution has changed]}
    {"ended": the exit status of the process}

This file imports nothing of the project: the solution's process takes the grader from its own folder.
"""

import builtins
import json
import math
import os
import sys
import tempfile

from guard import close_back_doors, Guard

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def leave_project() -> None:
    """Take the project from the path, and the guard out of a solution's reach."""
    own = [os.path.join(PROJECT, *names) for names in ((), ("tests",), ("tests", "teacher"))]
    sys.path[:] = [path for path in sys.path if os.path.abspath(path) not in own]
    del sys.modules["guard"]


leave_project()

# The processes of the solutions are copies of this one, so that they need not import these again.
import _pytest.terminal  # noqa: F401
import pandas  # noqa: F401
import pytest

SECONDS = 120  # of processor time; workers.py ends it earlier, if it is still there
MEMORY = 1 << 30  # bytes more than at the start
FILE_SIZE = 10_000_000  # bytes, also of the output


def main() -> None:
    """Do the jobs, until the standard input ends."""
    for line in sys.stdin:
        job = json.loads(line)
        if not hasattr(os, "fork"):  # as on Windows: workers.py starts this file again for the next job
            os._exit(solve(**job))
        pid = os.fork()
        if not pid:
            os._exit(solve(**job))
        status = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        print("\n" + ascii({"key": job["key"], "ended": status}), flush=True)


def solve(folder, key, lost, hidden) -> int:
    """Run pytest on the starter in this folder; return its exit status."""
    answer, write, as_text = os.dup(1), os.write, ascii  # a solution can replace os.write

    def tell(**what):
        write(answer, b"\n%s\n" % as_text({"key": key, **what}).encode())

    move_into(folder)
    set_limits()
    tell(pid=os.getpid())
    arguments = ["-p", "no:cacheprovider", "--assert=plain", "--no-header", "-q", "--color=no", "--tb=short"]
    status = int(pytest.main(arguments, plugins=[Reporter(tell, lost, Guard(folder, [PROJECT, *hidden]))]))
    sys.stdout.flush()  # os._exit does not
    return status


def move_into(folder) -> None:
    """Make the folder the place of all that this process reads by name and writes."""
    if hasattr(os, "setsid"):
        os.setsid()  # all processes that it starts can be ended with it
    for number, (name, flags) in enumerate([(os.devnull, os.O_RDONLY), ("output.txt", os.O_WRONLY | os.O_CREAT)]):
        file = os.open(os.path.join(folder, name), flags, 0o600)
        os.dup2(file, number)
        os.close(file)
    os.dup2(1, 2)
    sys.stdin = sys.__stdin__ = None
    for variable in ("HOME", "TEMP", "TMP", "TMPDIR", "USERPROFILE"):
        os.environ[variable] = folder
    tempfile.tempdir = None
    os.environ.update(COLUMNS="100", PYTEST_DISABLE_PLUGIN_AUTOLOAD="1")
    os.environ.pop("PYTEST_ADDOPTS", None)
    os.chdir(folder)
    sys.path.insert(0, folder)
    sys.dont_write_bytecode = True
    # The grader tells the student the command of this Python, as if it were installed in the folder.
    sys.executable = os.path.join(folder, ".venv", *(("Scripts", "python") if os.name == "nt" else ("bin", "python")))


def set_limits() -> None:
    """Limit memory and the size of files, where the system can (not on Windows)."""
    try:
        import resource
    except ImportError:
        return
    import signal

    def limit(what, most):
        hard = resource.getrlimit(what)[1]
        most = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(what, (most, most))

    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # too long a file is an OSError
    limit(resource.RLIMIT_FSIZE, FILE_SIZE)
    limit(resource.RLIMIT_CORE, 0)
    limit(resource.RLIMIT_CPU, SECONDS)
    if sys.platform == "linux":
        with open("/proc/self/statm") as file:
            used = int(file.read().split()[0]) * resource.getpagesize()
        limit(resource.RLIMIT_AS, used + MEMORY)


class Reporter:
    """A plugin of pytest: it guards the process, and tells the outcomes."""

    def __init__(self, tell, lost, guard):
        self.tell, self.lost, self.guard = tell, lost, guard

    def pytest_collection_finish(self, session):
        """Prepare for the solution: none of its code has run yet."""
        session.config.grading.hung.update({function: (function, words) for function, words in self.lost.items()})
        modules = [builtins, json, math, os, sys, *(module for name, module in sys.modules.items() if is_graders(name))]
        self.state_of_grader = lambda: {name: value for module in modules for name, value in state(module)}
        self.at_first = self.state_of_grader()
        close_back_doors()
        sys.addaudithook(self.guard.hook)

    def pytest_runtest_logstart(self, nodeid):
        self.tell(begins=nodeid.rpartition("::")[2])

    def pytest_runtest_logreport(self, report):
        from grading.pytest_grader import OUTCOME

        for outcome in [value for key, value in report.user_properties if key == OUTCOME]:
            self.tell(check=report.nodeid.rpartition("::")[2], outcome=outcome)

    def pytest_sessionfinish(self, exitstatus):
        if exitstatus not in (pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED):  # it was interrupted
            return
        now = self.state_of_grader()
        changed = [name for name, value in self.at_first.items() if now.get(name) != value]
        # Of a class that is another one, its name is enough.
        self.tell(changed=[name for name in changed if name.rpartition(".")[0] not in changed])


def is_graders(module) -> bool:
    """Return whether a module of this name is a part of the grader."""
    return module.partition(".")[0] in ("grading", "vpython") or module.startswith("test_")


def state(owner, where=None):
    """Yield the names of the functions and classes of a module, each with what shows a change of it."""
    where = where or owner.__name__
    for name, value in list(vars(owner).items()):
        if callable(value):
            yield f"{where}.{name}", (value, getattr(value, "__code__", None))
        if isinstance(value, type) and value.__module__ == where:
            yield from state(value, f"{where}.{name}")


if __name__ == "__main__":
    main()
