"""Grade a whole class: `python tests/grade_class.py SUBMISSIONS`.

Each submission has a pytest of its own and, without --here, a container.
"""

import json
import os
import shutil
import subprocess
import sys
from argparse import Namespace
from collections.abc import Collection, Iterator
from concurrent.futures import as_completed, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from typing import NoReturn

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

import grading.begin  # noqa: F401

from make_starter import make_starter

from support.start.end import ended_quietly, on_signals
from support.start.options import OneLineParser
from support.start.output import in_one_line, progress_bar
from teacher.containers import find_engine, LATE, Runner, SECONDS
from teacher.one_run import Result, without_grade
from teacher.submissions import pack, submissions_in
from teacher.table import write_table

LOOK_AGAIN = 0.2  # s until runs that should end are ended again: they may only have begun


@ended_quietly()
def main() -> None:
    """Grade the class. The status is 2 if an argument is wrong or a file cannot be written.

    After Ctrl+C or another signal, it is 128 and the signal's number.
    """
    options = read_options()
    on_signals(stop)
    results: dict[str, Result] = {}
    with TemporaryDirectory(prefix="cradle-") as work:
        folder = Path(work, "starter")
        make_grader(folder, options.starter)
        runner = Runner(folder) if options.here else find_engine(folder, options.packages)
        runner.prepare()
        with ThreadPoolExecutor(1) as worker:
            run = worker.submit(grade, runner, [], stderr=None)
            with ended([run], runner):
                starter = run.result()
        if not starter.get("is_final"):
            why = [*starter["problems"], *starter["text"].splitlines()]
            raise OSError(0, why[-1], "The starter")
        options.grades.mkdir(mode=0o700, exist_ok=True)
        options.grades.chmod(0o700)
        try:
            grade_all(options.students, runner, results)
        finally:
            if results:  # or an older table stays
                table = write_table(options.grades, results)
                print(f"{len(results)} of {len(options.students)} solutions are in {table}")
    for name in options.rest:
        print(f"not recognised: {in_one_line(name)}")


def stop(number: int, _: object) -> NoReturn:
    """End the program by an error; another signal could leave a container behind."""
    on_signals(lambda *_: None)
    sys.exit(128 + number)


def read_options() -> Namespace:
    """Return the options, with students (what each has handed in), rest (names) and grades."""
    parser = OneLineParser(description="Grade a whole class.", allow_abbrev=False)
    text = "a folder with a folder or a .zip for each student, or with the files of all"
    parser.add_argument("submissions", metavar="SUBMISSIONS", type=Path, help=text)
    text = "a starter that is already made (default: a new one)"
    parser.add_argument("--starter", metavar="FOLDER", type=Path, help=text)
    group = parser.add_mutually_exclusive_group()
    text = "packages that the solutions may import, too"
    group.add_argument("--packages", metavar="NAMES", default="", help=text)
    text = "run the solutions on this machine, without containers"
    group.add_argument("--here", action="store_true", help=text)
    options = parser.parse_args()
    folder = options.submissions.resolve()
    try:
        options.students, options.rest = submissions_in(folder)
        options.grades = folder.with_name(f"{folder.name}-grades")
    except ValueError as error:
        parser.error(f"argument SUBMISSIONS: {error}")
    tests = options.starter and options.starter / "tests"
    if tests and (not (tests / "grading").is_dir() or (tests / "project").is_dir()):
        allowed = "a folder made by make_starter.py"
        parser.error(f"argument --starter: found '{options.starter}', allowed is {allowed}")
    return options


def make_grader(folder: Path, starter: Path | None = None) -> None:
    """Make a folder with a starter, a new one or a copy, and what grades a solution in it."""
    if starter:
        shutil.copytree(starter, folder, ignore=shutil.ignore_patterns(".*", "__pycache__"))
    else:
        make_starter(folder)
    teacher = Path(__file__).with_name("teacher")
    shutil.copytree(teacher, folder / "tests" / "teacher", ignore=shutil.ignore_patterns("__*"))


def grade_all(students: dict[str, list[Path]], runner: Runner, results: dict[str, Result]) -> None:
    """Grade all students, one on each core; then those again, each alone, that are not sure."""
    unsure = [*students]
    with progress_bar() as progress:
        for cores in (os.cpu_count() or 1, 1):
            with ThreadPoolExecutor(cores) as workers:
                runs = {}
                for student in unsure:
                    runs[workers.submit(grade, runner, students[student])] = student
                with ended(runs, runner):
                    for run in as_completed(runs):
                        results[runs[run]] = run.result()
                        progress(len(results) / len(students))
            unsure = [student for student in unsure if not results[student].get("is_final")]


@contextmanager
def ended(runs: Collection[Future], runner: Runner) -> Iterator[None]:
    """At the end of the body, end the runs that go on, as after Ctrl+C: the main thread waits."""
    try:
        yield
    finally:
        for run in runs:
            run.cancel()
        while wait(runs, timeout=LOOK_AGAIN).not_done:
            runner.end_all()


def grade(runner: Runner, paths: list[Path], stderr: int | None = subprocess.DEVNULL) -> Result:
    """Return the result of what a student has handed in; runner.run says what stderr is."""
    with TemporaryFile(buffering=0) as submission:
        try:
            pack(paths, submission)
            submission.seek(0)
        except OSError as error:
            return without_grade([f"cannot be read: {error}"])
        status, output = runner.run(submission, stderr)
    with suppress(ValueError, LookupError, TypeError, RecursionError):
        result = json.loads(output)
        # A solution can have written it
        if isinstance(result["problems"], list) and isinstance(result["text"], str):
            return result
    problem = f"no grade: the run ended with status {status}"
    if status == LATE:
        problem = f"no grade: the run took longer than {SECONDS} s"
    return without_grade([problem])


if __name__ == "__main__":
    main()
