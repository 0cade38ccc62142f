"""Grade solutions side by side: each worker gives one solution after the other to a process of one_solution.py."""

import ast
import compileall
import errno
import json
import os
import queue
import secrets
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from grading.grader import CHECKS, FAILED, FAULT, Outcome

PROGRAM = Path(__file__).with_name("one_solution.py")
SILENCE = 20.0  # s for a check; the grader itself stops Python code after limits.PATIENCE
PATIENCE = 120.0  # s for a solution
LEFT_OUT = ("PYTHONOPTIMIZE", "PYTHONPATH", "PYTHONSAFEPATH")  # they would change what a solution sees
SHOWN = 3  # names of the grader that a problem lists
LONGEST_LINE = 1_000_000  # bytes of a message
OUTPUT = 200_000  # bytes that are kept of the output


class Graded(NamedTuple):
    """What a solution has achieved."""

    outcomes: dict[str, Outcome]  # of the checks that were made, by name
    output: str  # what pytest told
    problems: list[str]  # of its process, each in a sentence


class Attempt:
    """What a process of a solution has told so far."""

    def __init__(self):
        self.pid, self.check, self.ended = None, None, None
        self.outcomes: dict[str, Outcome] = {}
        self.changed: list[str] | None = None  # names of the grader, when the checks are complete
        self.output = ""  # what pytest told
        self.why = ""  # the process ended

    def take(self, message) -> None:
        """Take a message of the process into account. A later message changes neither the pid nor an outcome."""
        match message:
            case {"pid": int(pid)}:
                self.pid = self.pid or pid
            case {"begins": str(check)}:
                self.check = check
            case {"check": str(check), "outcome": [str(), str(), None, str(), str(), str()] as outcome}:
                self.outcomes.setdefault(check, Outcome(*outcome))
            case {"changed": list(names)}:
                self.changed = names
            case {"ended": int(status)}:
                self.ended = status

    def faults(self) -> list[str]:
        """Return the names of the checks with a fault of the grader."""
        return [name for name, outcome in self.outcomes.items() if outcome.state == FAULT]

    def result(self, problems) -> Graded:
        """Return what the solution has achieved, with these problems and more.

        Who has changed the grader gets no points.
        """
        if not self.changed:
            faults = [f"a fault of the grader in {name}" for name in self.faults()]
            return Graded(self.outcomes, self.output, problems + faults)
        names = ", ".join(self.changed[:SHOWN]) + (" ..." if len(self.changed) > SHOWN else "")
        words = f"the solution has changed the grader ({names}): no points"
        return Graded({name: Outcome(FAILED, words) for name in self.outcomes}, "", [*problems, words])


class Worker:
    """A process that solves one job after the other."""

    def __init__(self, starter, hidden=()):
        """starter is the folder of a fresh starter; solutions must not read the hidden folders."""
        self.starter, self.hidden = starter, [str(folder) for folder in hidden]
        self.is_closed = False
        self.process = None
        self.pid = None  # of the present solution's process

    def grade(self, files) -> Graded:
        """Return what a solution achieves: its files by their paths below src/.

        If it ends its process, or takes too long, it runs again without the function that did so: the other functions
        keep their points. If a check ends with a fault of the grader, it runs once more: a machine with too much to do
        can stop a check in the grader's own code.
        """
        latest, has_had_faults = time.monotonic() + PATIENCE, False
        lost: dict[str, str] = {}  # functions that are not called any more, and why
        while True:
            try:
                attempt = self.attempt(files, lost, latest)
            except ValueError as error:
                return Graded({}, "", [str(error)])
            if attempt.changed is None:
                function = CHECKS[attempt.check].function if attempt.check in CHECKS else "the solution"
                is_new = function not in lost
                lost[function] = attempt.why
                if function == "the solution" or not is_new or time.monotonic() > latest or self.is_closed:
                    break
            elif attempt.faults() and not has_had_faults:
                has_had_faults = True
            else:
                break
        return attempt.result([f"{function} {why}" for function, why in lost.items()])

    def attempt(self, files, lost, latest) -> Attempt:
        """Run pytest on a solution's files, but for the lost functions, and return the Attempt.

        It ends at the latest time. Raises a ValueError if a file cannot be written.
        """
        with fresh_folder() as folder:
            copy_starter(self.starter, files, folder)
            key = secrets.token_hex()
            self.give({"folder": str(folder), "key": key, "lost": lost, "hidden": self.hidden})
            attempt = self.listen(key, latest)
            attempt.output = read_output(folder / "output.txt")
        return attempt

    def listen(self, key, latest) -> Attempt:
        """Return what the process tells with this key until it ends; end it if it is silent, and at the latest time."""
        attempt, self.pid = Attempt(), None
        until = min(time.monotonic() + SILENCE, latest)
        while attempt.ended is None:
            try:
                line = self.lines.get(timeout=max(0.0, until - time.monotonic()))
            except queue.Empty:
                if attempt.why:  # the end of the process was not told
                    self.process.kill()
                seconds = SILENCE if until < latest else PATIENCE
                attempt.why = attempt.why or f"did not end within {seconds:g} s"
                self.kill()
                until = time.monotonic() + SILENCE
                continue
            if line is None:  # as on Windows, where a process solves one job only
                attempt.ended = self.process.wait()
            message = message_in(line, key)
            if message and not attempt.why:
                until = min(time.monotonic() + SILENCE, latest)
            attempt.take(message)
            self.pid = attempt.pid
        if self.pid is not None:
            self.kill()  # what it may have started
        attempt.why = attempt.why or f"ended the process ({status_words(attempt.ended)})"
        return attempt

    def give(self, job) -> None:
        """Send a job to the process, and start the process if there is none."""
        if self.is_closed:
            raise ValueError("the worker is closed")
        if self.process is None or self.process.poll() is not None:
            environment = {name: value for name, value in os.environ.items() if name not in LEFT_OUT}
            environment["OPENBLAS_NUM_THREADS"] = "1"  # a copy of a process has only one of the threads
            command, pipe = [sys.executable, str(PROGRAM)], subprocess.PIPE
            # In a session of its own: Ctrl+C reaches only the program that tells it.
            self.process = subprocess.Popen(
                command, stdin=pipe, stdout=pipe, env=environment, start_new_session=True, cwd=tempfile.gettempdir()
            )
            self.lines: queue.SimpleQueue = queue.SimpleQueue()
            threading.Thread(target=read_lines, args=(self.process.stdout, self.lines), daemon=True).start()
        self.process.stdin.write(json.dumps(job).encode() + b"\n")
        self.process.stdin.flush()

    def kill(self) -> None:
        """End the process of a solution, and all that it has started; the worker's own if it is not known."""
        if self.pid is not None and hasattr(os, "killpg"):
            with suppress(OSError):
                os.killpg(self.pid, signal.SIGKILL)
        else:
            self.process.kill()

    def close(self) -> None:
        """End all processes."""
        self.is_closed = True
        if self.process is not None:
            self.kill()
            self.process.kill()
            self.process.wait()


def read_lines(stream, lines) -> None:
    """Put all lines of a stream into a queue, and None when it ends."""
    for line in iter(lambda: stream.readline(LONGEST_LINE), b""):
        lines.put(line)
    lines.put(None)


def message_in(line, key) -> dict | None:
    """Return the message in a line, or None if the line is not one with this key."""
    try:
        message = ast.literal_eval(line.decode("ascii")) if line else None
    except (ValueError, SyntaxError, RecursionError, MemoryError):
        return None
    return message if isinstance(message, dict) and message.get("key") == key else None


def status_words(status) -> str:
    """Return the exit status of a process in words."""
    return f"signal {-status}" if status < 0 else f"status {status}"


class fresh_folder(tempfile.TemporaryDirectory):
    """A temporary folder as a Path. It is removed also if a solution has changed its permissions."""

    def __init__(self):
        super().__init__(prefix="cradle_", ignore_cleanup_errors=True)

    def __enter__(self):
        return Path(os.path.realpath(super().__enter__()))

    def __exit__(self, *error):
        for parent, folders, _ in os.walk(self.name):
            for name in ["", *folders]:
                with suppress(OSError):
                    os.chmod(os.path.join(parent, name), stat.S_IRWXU)
        super().__exit__(*error)


def compile_starter(starter) -> None:
    """Let Python compile the modules of a starter that all solutions have: the copies then need not."""
    for folder in ("support", "tests"):
        compileall.compile_dir(starter / folder, quiet=2)


def copy_starter(starter, files, folder) -> None:
    """Copy the starter into the folder, and a solution's files over its src/.

    Raises a ValueError if the name of a file is wrong, and an OSError if the disk is full.
    """
    shutil.copytree(starter, folder, dirs_exist_ok=True)
    for name, content in files.items():
        file = folder / "src" / name
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
        except (OSError, ValueError) as error:
            if getattr(error, "errno", None) in (errno.ENOSPC, errno.EDQUOT):  # no fault of the solution
                raise
            raise ValueError(f"src/{name} cannot be written: {getattr(error, 'strerror', error)}") from error


def read_output(file) -> str:
    """Return the beginning of a file as text; nothing if it is not there any more."""
    try:
        with open(file, "rb") as opened:
            return opened.read(OUTPUT).decode("utf-8", "replace")
    except OSError:
        return ""
