"""The judge: it has the checks, the expected values and the hints, and asks a solver for what a solution gives."""

import json
import os
import time
from contextlib import contextmanager, redirect_stdout, suppress
from io import StringIO
from pathlib import Path
from typing import NamedTuple

from vpython import scene

from grading import grader, limits
from grading.comparing import OTHER_FORM
from grading.grade import words
from grading.grader import CHECKS, FAULT, Grading, Outcome
from grading.handout import FUNCTIONS
from grading.raised import Place, Raised, StoppedError
from support.constants import NC_FP
from teacher.crossing import Crossing, File

SPARE = 3.0  # s that a solver has to say that a call took too long
WHOLE = 120.0  # s for all checks of a solution
LINE = 5_000_000  # bytes of an answer
ALL = 20_000_000  # bytes that a solver tells in a call
TEXT, PRINTED = 2000, 30_000  # characters of a text that a solver tells, and of what a call prints


class Graded(NamedTuple):
    """What a solution has achieved."""

    outcomes: dict[str, Outcome]  # by the names of the checks
    text: str  # for the student
    problems: list[str]


def grade(files, process) -> Graded:
    """Return what a solution achieves in a Process: its files by their paths in the project.

    If a check ends with a fault of the grader, the solution is graded once more: a machine with too much to do can stop
    a check in the grader's own code.
    """
    for _ in range(2):
        solver, grading, printed = Solver(files, process), Grading(), {}
        before, grader.student = grader.student, solver
        try:
            solver.open()
            for check in CHECKS.values():
                with redirect_stdout(StringIO()) as out:
                    grading.judge(check)
                printed[check.name] = out.getvalue()
        except ValueError as error:
            return Graded({}, "\n".join(line for line, _ in words({}, {})), [str(error)])
        finally:
            solver.close()
            grader.student = before
        faults = [name for name, outcome in grading.outcomes.items() if outcome.state == FAULT]
        if not faults:
            break
    text = "\n".join(line for line, _ in words(grading.outcomes, printed))
    outcomes = {check.name: grading.outcomes[check.name]._replace(call=None) for check in CHECKS.values()}
    return Graded(outcomes, text, [f"a fault of the grader in {name}" for name in faults])


class Solver:
    """The functions of a solution in a process of their own. It takes the place of OwnProcess."""

    has_written = False  # whether the last call has changed newton_cradle_pends.csv
    watch = f".venv{os.sep}{'Scripts' if os.name == 'nt' else 'bin'}{os.sep}python tests{os.sep}watch.py"

    def __init__(self, files, process):
        self.files = {name: content.decode("latin-1") for name, content in files.items()}
        self.process, self.is_open = process, False
        self.found: set[str] = set()  # functions that the process has
        self.latest = time.monotonic() + WHOLE

    # --- as in OwnProcess ---

    @contextmanager
    def check(self):
        scene._made.clear()
        if not self.is_open:
            self.open()
        with limits.patience(SPARE), limits.limited_memory():
            self.begin(is_again=False)
            yield

    @contextmanager
    def again(self):
        self.found.clear()
        self.begin(is_again=True)
        yield
        self.found.clear()

    def find(self, function):
        if function not in self.found and not self.exchange("find", function=function):
            return None
        self.found.add(function)
        return lambda *arguments: self.run(function, arguments)

    def called_by(self, function):
        with suppress(StoppedError, *OTHER_FORM):
            return [str(name) for name in self.exchange("called_by", function=function)]
        return []

    def run(self, function, arguments, times=1):
        arguments = tuple(map(self.with_file, arguments))
        self.crossing.roots = [*self.results, arguments]
        letter = self.crossing.letter(arguments)
        result = self.exchange("call", function=function, letter=letter, times=times)
        if isinstance(result, (list, dict)):
            self.results.append(result)
        return result

    # --- the other process ---

    def open(self) -> None:
        """Start a process; raise a ValueError if it cannot take the files."""
        self.process.begin()
        self.is_open = True
        self.found, self.told, self.beginning, self.crossing = set(), 0, None, Desk(first=0)
        self.hear()
        problem = self.exchange("write", files=self.files)
        if problem:
            raise ValueError(problem)

    def close(self) -> None:
        """End the solution's process."""
        if self.is_open:
            self.process.end()
        self.is_open = False

    def begin(self, is_again) -> None:
        """Forget what both sides had: the next message tells the solver."""
        if not self.is_open:
            self.open()
        self.crossing, self.results, self.files_given = Desk(first=0), [], {}
        seconds = min(limits.PATIENCE, max(0.1, self.latest - time.monotonic()))
        self.beginning = {"seconds": seconds, "is_again": is_again}

    def with_file(self, value):
        """Return a value, or a File if it is the path of one; a solver gets the same path for the same text."""
        if not isinstance(value, str) or value == NC_FP or not Path(value).is_file():
            return value
        return self.files_given.setdefault(value, File(value))

    def exchange(self, do, **arguments):
        """Return the value that the solver answers; raise a StoppedError if it is an error, or if there is none."""
        try:
            self.told = 0
            self.send({"do": do, "beginning": self.beginning, **arguments})
            self.beginning = None
            answer = self.hear()
            while "ask" in answer:
                self.send(self.page_says(**answer))
                answer = self.hear()
            raised, (value, _) = raised_in(answer["raised"]), self.crossing.open(answer["letter"])
            self.has_written = bool(answer["has_written"])
            print(str(answer["printed"])[:PRINTED], end="")
        except KeyboardInterrupt:
            if limits.PRESSED.is_set():
                raise
            raised = Raised("KeyboardInterrupt", limit=f"took longer than {limits.PATIENCE:g} s", ends=True)
        except AnswerError as error:
            raised = Raised(limit=f"{error}")
        except OSError:
            raised = Raised(limit=ended(self.process.status()))
        except OTHER_FORM:
            raised = Raised(limit="gave an answer that the grader cannot read")
        if raised is None:
            return value
        if raised.limit:
            self.close()
        raise StoppedError(raised)

    def send(self, message) -> None:
        line = json.dumps(message).encode() + b"\n"
        while line:
            line = line[self.process.stdin.write(line) :]

    def hear(self) -> dict:
        """Return the next message of the solver; raise an AnswerError if there is none, or if it is too long."""
        line = self.process.stdout.readline(LINE + 1)
        self.told += len(line)
        if max(len(line) / LINE, self.told / ALL) > 1:
            raise AnswerError(f"gave back more than {LINE / 1e6:g} MB")
        if line == b"\n":  # the line before is cut off, or there is none
            line = self.process.stdout.readline(LINE)
        if not line:
            raise AnswerError(ended(self.process.status()))
        message = json.loads(line)
        if "ended" in message:
            raise AnswerError(ended(int(message["ended"])))
        return message

    def page_says(self, ask, letter) -> dict:
        """Return the answer of a page to main."""
        page, arguments = self.crossing.open(letter)
        try:
            if arguments is not None and ask in page.METHODS:
                self.crossing.roots.append(arguments)
                said = getattr(page, ask)(*arguments)
            elif ask in page.VALUES:
                said = self.with_file(getattr(page, ask))
            else:
                raise AttributeError(f"'Page' object has no attribute '{ask}'")
        except Exception as error:
            return {"error": type(error).__name__, "words": [str(word) for word in error.args]}
        return {"letter": self.crossing.letter(said)}


class Desk(Crossing):
    """The judge's side of the crossing: it has the pages for main."""

    def words(self, value):
        return ["page", repr(value), list(value.METHODS)]


class AnswerError(Exception):
    """An answer of a solver that cannot be taken. Its text says how the call went over a limit."""


def ended(status) -> str:
    """Return how a process has ended in words."""
    if status is None:
        return "ended its answers"
    return f"ended its process ({f'signal {status - 128}' if status > 128 else f'status {status}'})"


def raised_in(fields) -> Raised | None:
    """Return the error in an answer; raise an error if it has another form."""
    if fields is None:
        return None
    kind, text, places, limit, ends, stub, culprit, hint = fields
    kind, limit, hint = (str(part)[:TEXT] for part in (kind, limit, hint))
    text, culprit = (None if part is None else str(part)[:TEXT] for part in (text, culprit))
    if stub is not None:
        FUNCTIONS[stub]
    lines = tuple(Place(str(a)[:TEXT], int(line), str(b)[:TEXT], str(c)[:TEXT]) for a, line, b, c in places)
    return Raised(kind, text, lines, limit, bool(ends), stub, culprit, hint)
