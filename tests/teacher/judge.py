"""The judge: it has the checks, the expected values and the hints, and asks a solver for what a solution gives."""

import json
import os
import signal
import time
from collections import defaultdict
from contextlib import contextmanager, redirect_stdout
from io import StringIO
from pathlib import Path
from tempfile import gettempdir
from unittest.mock import patch

from vpython import scene, vector

from grading import grader, limits
from grading.comparing import OTHER_FORM
from grading.grade import words
from grading.grader import CHECKS, FAULT, Grading, Outcome
from grading.own_process import Code
from grading.raised import ENDLESS, Place, Raised, StoppedError
from teacher.crossing import bounded, Crossing, File, MOST_PRINTED

SPARE = 3.0  # s that a solver has to say that a call took too long
WHOLE = 120.0  # s for all checks of a solution
LINE = 5_000_000  # bytes of an answer
MOST_MESSAGE = 20_000  # characters of a message


def grade(files, process) -> tuple[dict[str, Outcome], str, list[str]]:
    """Return the outcomes of a solution's files (by path) by the names of checks, the student's text, and problems."""
    solver, grading, printed, problems = Solver(files, process), Grading(), {}, []
    if os.name != "nt":  # the judge's own work is bounded, too
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, WHOLE, SPARE)
    try:
        with patch.object(grader, "runner", solver), limits.limited_memory():
            solver.open()
            for check in CHECKS.values():
                with redirect_stdout(StringIO()) as out:
                    outcome = grading.judge(check)
                printed[check.name] = out.getvalue()[:MOST_PRINTED]
                problems += [f"a fault of the grader in {check.name}"] * (outcome.state == FAULT)
    except StoppedError as error:
        problems = [error.raised.limit or f"the files cannot be written: {error.raised.text}"]
    except KeyboardInterrupt:
        problems = [f"took longer than {WHOLE:g} s"]
    except OSError as error:  # the disk is full: the class stops
        raise OSError(error.errno, error.strerror, gettempdir()) from None
    finally:
        if os.name != "nt":
            signal.setitimer(signal.ITIMER_REAL, 0)
        process.end()
    outcomes = {name: one._replace(message=one.message[:MOST_MESSAGE]) for name, one in grading.outcomes.items()}
    return outcomes, "\n".join(line for line, _ in words(outcomes, printed)), problems


class Solver:
    """The functions of a solution in a process of their own. It takes the place of OwnProcess: check, run."""

    def __init__(self, files, process):
        self.files = {name: content.decode("latin-1") for name, content in files.items()}
        self.process, self.codes, self.has_written = process, defaultdict(Code), False

    @contextmanager
    def check(self):
        scene._made.clear()
        if self.process.line is None:
            self.open()
        self.desk, self.files_given = Crossing(first=0), {}
        self.until = time.monotonic() + limits.PATIENCE + SPARE
        self.beginning = {"seconds": limits.PATIENCE}  # the next message tells the solver
        yield

    def run(self, function, arguments, times=1):
        return self.exchange("call", tuple(map(self.with_file, arguments)), function=function, times=times)

    def open(self) -> None:
        """Start a process; raise a StoppedError if it cannot take the files."""
        self.process.begin()
        self.heard, self.until = bytearray(), time.monotonic() + WHOLE
        self.beginning, self.desk = None, Crossing(first=0)
        self.hear()
        self.exchange("write", None, files=self.files)

    def with_file(self, value):
        """Return a value, a File if it is the path of one, or the copy of a vector, which a solution may change."""
        if isinstance(value, vector):
            return vector(value)
        if not isinstance(value, str) or not Path(value).is_file():
            return value
        name = f"/{Path(value).name}" if Path(value).is_absolute() else value
        return self.files_given.setdefault(value, File(Path(value), value, name))

    def exchange(self, do, value, **more):
        """Return what the solver answers to a message with this value; raise a StoppedError if it gives no result."""
        try:
            self.send({"do": do, "beginning": self.beginning, "letter": self.desk.letter(value), **more})
            self.beginning = None
            answer = self.hear()
            while "ask" in answer:
                self.send(self.page_says(**answer))
                answer = self.hear()
            codes, self.has_written = answer["codes"], bool(answer["has_written"])
            self.codes |= {f: Code(int(n), [*names], *map(str, rest)) for f, (n, names, *rest) in codes.items()}
            print(str(answer["printed"])[:MOST_PRINTED], end="")
            if answer["raised"] is not None:
                raise StoppedError(raised_in(answer["raised"]))
            return self.desk.open(answer["letter"])[0]
        except OTHER_FORM:
            self.process.end()
            raise StoppedError(Raised(limit="gave an answer that the grader cannot read")) from None
        except StoppedError as error:
            if error.raised.limit:
                self.process.end()
            raise

    def send(self, message) -> None:
        """Send a message; raise a StoppedError if the solver does not take it."""
        with self.in_time() as line:
            line.sendall(json.dumps(message).encode() + b"\n")

    def hear(self) -> dict:
        """Return the next message of the solver; raise a StoppedError if there is none."""
        while b"\n" not in self.heard:
            with self.in_time() as line:
                part = line.recv(1 << 16)
            self.heard += part
            if len(self.heard) > LINE:
                raise StoppedError(Raised(limit=f"gave back more than {LINE / 1e6:g} MB"))
            if not part:
                raise StoppedError(ended())
        line, _, self.heard = self.heard.partition(b"\n")
        message = json.loads(line or b"{}")
        if "ended" in message:
            raise StoppedError(ended(int(message["ended"])))
        return message or self.hear()

    @contextmanager
    def in_time(self):
        """Yield the socket; raise a StoppedError if it is not ready in time, or if the other end is closed."""
        try:
            left = self.until - time.monotonic()
            if self.process.line is None or left <= 0:
                raise TimeoutError if left <= 0 else BrokenPipeError
            self.process.line.settimeout(left)
            yield self.process.line
        except TimeoutError:
            late = Raised("KeyboardInterrupt", limit=f"took longer than {limits.PATIENCE:g} s", ends=True, hint=ENDLESS)
            raise StoppedError(late) from None
        except OSError:
            raise StoppedError(ended()) from None

    def page_says(self, ask, letter) -> dict:
        """Return the answer of a page to main."""
        page, arguments = self.desk.open(letter)
        try:
            if ask not in page.METHODS + page.VALUES:
                raise AttributeError(f"'Page' object has no attribute '{ask}'")
            said = getattr(page, ask)
            said = self.with_file(said if arguments is None else said(*arguments))
        except Exception as error:
            return {"error": type(error).__name__, "words": [str(word) for word in error.args]}
        return {"letter": self.desk.letter(said)}


def ended(status=None) -> Raised:
    """Return what stopped a call if its process has ended, with this exit status, or with minus the signal's number."""
    words = "" if status is None else f" (signal {-status})" if status < 0 else f" (status {status})"
    return Raised(limit=f"ended its process{words}")


def raised_in(fields) -> Raised:
    """Return the error in an answer; raise an error if it has another form."""
    kind, text, places, limit, ends, stub, culprit, *words = fields
    lines = tuple(Place(bounded(a), int(line), *map(bounded, rest)) for a, line, *rest in places)
    text, culprit, stub = (None if part is None else bounded(part) for part in (text, culprit, stub))
    return Raised(bounded(kind), text, lines, bounded(limit), bool(ends), stub, culprit, *map(bounded, words))
