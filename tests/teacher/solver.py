"""A solver: it calls the functions of one solution, as the judge tells it. It knows no check and no expected value.

A message is a line of JSON: "do" names a method of Solver, the rest are its arguments. The answer has what the method
returns, or an error as plain data. While main runs, it asks the judge for its page.
"""

import builtins
import json
import os
import shutil
import signal
import socket
import sys
import threading
from contextlib import ExitStack, redirect_stdout, suppress
from dataclasses import astuple
from io import StringIO

if __name__ == "__main__":
    sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # tests/, where Python finds grading

from grading.begin import ROOT

import pandas  # noqa: F401  its first import is slow, and would count as time of a solution
from vpython import scene

from grading import limits
from grading.own_process import OwnProcess, working_in
from grading.raised import raised_by, StoppedError
from support.pendulum import discarded
from teacher.crossing import Crossing, File, MOST_PRINTED

SECONDS = 300  # of processor time
MEMORY = limits.MOST_MEMORY * 10**6  # bytes more than at the start, for this process and for each one that it starts
ADDRESSES = 2_500_000_000  # bytes, also of memory that processes share
FILE_SIZE, FILES, PROCESSES = 10_000_000, 64, 8  # bytes of a file, open files, processes


class Solver:
    """The messages that a solver understands."""

    def __init__(self, line):
        self.line, self.lines = line, line.makefile("rb")
        self.own, self.desk = OwnProcess(), Desk(self)
        self.check = ExitStack()  # holds what the present check needs

    def tell(self, answer) -> None:
        self.line.sendall(json.dumps(answer).encode() + b"\n")

    def hear(self) -> dict:
        while True:
            with suppress(KeyboardInterrupt):  # the present check took too long, but no call
                return json.loads(self.lines.readline())

    def answer(self, do, beginning, **arguments) -> dict:
        """Carry out a message. If it is the first one of a check, beginning has the arguments of begin."""
        scene._made.clear()
        printed, raised, letter = StringIO(), None, None
        try:
            if beginning:
                self.begin(**beginning)
            with redirect_stdout(printed):
                value = getattr(self, do)(**arguments)
                letter = self.desk.letter((value, tuple(scene._made)))  # also the shapes that it has made
        except StoppedError as error:
            raised = error.raised
        except BaseException as error:
            raised = raised_by(error)
        text = "" if printed.closed else printed.getvalue()[:MOST_PRINTED]
        own = {"codes": self.own.codes, "has_written": self.own.has_written}
        return {"raised": raised and astuple(raised), "letter": letter, "printed": text, **own}

    def write(self, letter, files) -> None:
        """Make these the files of src/, each with its text as Latin-1 has it."""
        shutil.rmtree(ROOT / "src", ignore_errors=True)
        for name, text in files.items():
            (ROOT / name).parent.mkdir(parents=True, exist_ok=True)
            (ROOT / name).write_bytes(text.encode("latin-1"))

    def begin(self, seconds) -> None:
        """Begin a check of at most these seconds."""
        self.desk = Desk(self)
        self.check.close()
        limits.PATIENCE = seconds
        self.check.enter_context(self.own.check())

    def call(self, function, letter, times):
        """Call a function, and return its result."""
        arguments = self.desk.open(letter)
        discarded.clear()
        with working_in(self.desk.folder if self.desk.is_relative else "."):
            return self.own.run(function, arguments, times)

    def ask(self, page, name, arguments):
        """Return what the page in the judge gives."""
        self.tell({"ask": name, "letter": self.desk.letter((page, arguments))})
        told = self.hear()
        if "error" in told:
            raise getattr(builtins, told["error"])(*told["words"])
        return self.desk.open(told["letter"])


class Desk(Crossing):
    """The solver's side of the crossing: it has files and pages, too."""

    def __init__(self, solver):
        super().__init__(first=1)
        self.solver, self.folder, self.is_relative = solver, ROOT / "files", False
        shutil.rmtree(self.folder, ignore_errors=True)

    def made(self, kind, *parts):
        if kind == "page":
            return Page(self.solver, *parts)
        if kind != "file":
            return super().made(kind, *parts)
        self.folder.mkdir(exist_ok=True)
        path, is_absolute = self.folder / parts[0].lstrip("/"), parts[0].startswith("/")
        self.is_relative |= not is_absolute
        return File(path, str(path) if is_absolute else parts[0], parts[0])


class Page:
    """The page for main: all that it does, the judge's page does."""

    __module__ = "test_a"  # an error names the class as in pytest

    def __init__(self, solver, text, methods):
        vars(self).update(_solver=solver, _text=text, _methods=methods)

    def __repr__(self):
        return self._text

    def __getattr__(self, name):
        if name in self._methods:
            return lambda *arguments: self._solver.ask(self, name, arguments)
        return self._solver.ask(self, name, None)


def limit_resources() -> None:
    """Limit what the solution can take, where the system can (not on Windows)."""
    resource = limits.resource
    if resource is None:
        return
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # too long a file is an OSError
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 + MEMORY
    table = {"FSIZE": FILE_SIZE, "NOFILE": FILES, "CPU": SECONDS, "DATA": memory, "AS": ADDRESSES, "NPROC": PROCESSES}
    for name, most in {"CORE": 0, **table}.items():
        what = getattr(resource, f"RLIMIT_{name}")
        before = resource.getrlimit(what)
        most = most if before[1] == resource.RLIM_INFINITY else min(most, before[1])
        resource.setrlimit(what, (most, before[1]))
        try:
            threading.Thread(target=int).start()
            resource.setrlimit(what, (most, most))
        except RuntimeError:  # outside of a sandbox, all processes of the user count
            resource.setrlimit(what, before)


def serve(user, number) -> None:
    """Answer the judge through the socket with this number, in a child; this process tells how the child has ended."""
    line = socket.socket(fileno=number)
    child = os.fork() if hasattr(os, "fork") else 0
    if child:
        line.sendall(b'\n{"ended": %d}\n' % os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        os._exit(0)
    if user:
        folders = [folder for folder in sys.path if os.path.isdir(folder)]
        os.setgroups([])
        os.setgid(user)
        os.setuid(user)
        if not all(os.access(folder, os.R_OK) for folder in folders):  # Python is in a folder of root's
            return
    limit_resources()
    solver = Solver(line)
    solver.tell({"is_ready": True})
    with suppress(json.JSONDecodeError):  # the end
        while True:
            solver.tell(solver.answer(**solver.hear()))


if __name__ == "__main__":
    serve(*map(int, sys.argv[1:]))
