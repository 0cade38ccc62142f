"""Grade a whole class: `python tests/grade_class.py SUBMISSIONS`.

Each submission has a pytest of its own and, without --here, a container.
"""

import os
import shutil
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor, wait
from pathlib import Path
from tempfile import TemporaryDirectory

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

import grading.begin  # noqa: F401

from support.start.end import ended_quietly, on_signals
from support.start.options import OneLineParser
from support.start.output import in_one_line, progress_bar
from teacher.containers import find_engine
from teacher.report import own_folder, Report
from teacher.runners import Here, READ_OR_START
from teacher.submissions import read_submission, submissions_in

LOOK_AT_THREADS = 0.2  # s from one look at the other threads to the next


@ended_quietly()
def main() -> None:
    """Grade the class. The status is 2 if an argument is wrong or a file cannot be written.

    After Ctrl+C or another signal, it is 128 and the signal's number.
    """
    options, submitted, others = read_options()
    for folder in filter(None, (options.out, options.gradescope)):
        own_folder(folder)
    stopped = threading.Event()
    status = []

    def stop(number, _):
        status.append(128 + number)
        stopped.set()

    on_signals(stop)
    report = Report(options.out, options.gradescope)
    with TemporaryDirectory(prefix="cradle-") as work:
        folder = Path(work, "starter")
        starter = copy_starter(options.starter, folder)
        runner = Here(folder) if options.here else find_engine(folder, starter, stopped)
        try:
            Grading(submitted, starter, runner, report, stopped).grade_all()
        except OSError:
            if not status:  # or what was ended fails
                raise
        finally:
            if report.rows:  # or an older table stays
                report.write()
                print(*report.summary(len(submitted)), sep="\n")
    if others:
        print(f"No submissions: {in_one_line(', '.join(others))}")
    sys.exit(*status[:1])


def read_options():
    """Return the options, the submissions by the student's key, and the names of all others."""
    parser = OneLineParser(description="Grade a whole class.", allow_abbrev=False)
    add = parser.add_argument
    add(
        "submissions",
        metavar="SUBMISSIONS",
        type=Path,
        help="a folder with a folder or a .zip for each student, or with the files of all",
    )
    add(
        "--out",
        metavar="FOLDER",
        type=Path,
        help="the folder for the results (default: SUBMISSIONS-grades)",
    )
    add(
        "--gradescope",
        metavar="DIR",
        type=Path,
        help="write DIR/STUDENT/results.json, as Gradescope reads it",
    )
    add(
        "--starter",
        metavar="FOLDER",
        type=Path,
        help="a starter that is already made (default: a new one)",
    )
    add("--here", action="store_true", help="run the solutions on this machine, without containers")
    options = parser.parse_args()
    folder = options.submissions.resolve()
    options.out = options.out or folder.with_name(f"{folder.name}-grades")
    try:
        submitted, others = submissions_in(folder)
    except OSError as error:
        parser.error(f"argument SUBMISSIONS: {options.submissions}: {error.strerror}")
    except ValueError as error:
        parser.error(f"argument SUBMISSIONS: {error}")
    for name, path in (("out", options.out), ("gradescope", options.gradescope)):
        if path and path.resolve().is_relative_to(folder):
            allowed = "a folder outside of SUBMISSIONS"
            parser.error(f"argument --{name}: found '{path}', allowed is {allowed}")
    if options.starter and not (options.starter / "tests" / "grading").is_dir():
        allowed = "a folder made by make_starter.py"
        parser.error(f"argument --starter: found '{options.starter}', allowed is {allowed}")
    return options, submitted, others


def copy_starter(starter, folder) -> dict[str, bytes]:
    """Copy a starter to this folder, or make one there; return its files by their paths.

    The files of the image, and of a run, are put into it.
    """
    if starter:
        ignored = shutil.ignore_patterns(".*", "__pycache__")
        shutil.copytree(starter, folder, ignore=ignored, ignore_dangling_symlinks=True)
    else:
        # A folder for Gradescope, itself a starter, does not have it
        from make_starter import make_starter

        make_starter(folder)
    (folder / "tests" / "teacher").mkdir(exist_ok=True)
    for name in ("Containerfile", "one_run.py", "setup.sh"):
        shutil.copy(Path(__file__).with_name("teacher") / name, folder / "tests" / "teacher")
    files = {}
    for path in filter(Path.is_file, sorted(folder.rglob("*"))):
        files[path.relative_to(folder).as_posix()] = path.read_bytes()
    return files


class Grading:
    """Grades a class by a runner, and gives the results to a report."""

    def __init__(self, submitted, starter, runner, report, stopped):
        self.submitted = submitted  # by the student's key
        self.starter = starter  # its files by their paths
        self.runner = runner
        self.report = report
        self.stopped = stopped  # set once no more solutions are graded
        self.lock = threading.Lock()
        self.unsure: list[str] = []  # students whose run something beside it may have changed

    def grade_all(self) -> None:
        """Grade all students, one on each core; then those that are unsure again, each alone."""
        with ThreadPoolExecutor(self.runner.cores) as workers, progress_bar() as self.progress:
            self.finish([workers.submit(self.runner.open)])
            self.finish([workers.submit(self.grade, student) for student in self.submitted])
            for student in sorted(self.unsure):
                self.finish([workers.submit(self.grade, student, is_last=True)])

    def finish(self, futures) -> None:
        """Wait for the work of other threads; raise the error that one of them raises.

        Ctrl+C, and an error, end the others.
        """
        while wait(futures, timeout=LOOK_AT_THREADS).not_done:
            # Between two waits, a signal comes through, also on Windows
            if any(future.done() and future.exception() for future in futures):
                self.stopped.set()
            if self.stopped.is_set():
                self.runner.end_all()
        for future in futures:
            future.result()

    def grade(self, student, is_last=False) -> None:
        """Grade a student, and report the result if it is sure, or is the last one."""
        if self.stopped.is_set():
            return
        with READ_OR_START:
            files, problems = read_submission(self.submitted[student], self.starter)
        begin = time.monotonic()
        run = self.runner.run(files)
        seconds = time.monotonic() - begin
        if self.stopped.is_set():  # it has ended the run
            return
        if not (run.is_final or is_last):
            self.unsure.append(student)
            return
        if run.problem:
            problems.append(run.problem)
        with self.lock:
            self.report.add(student, seconds, problems, run.grade)
            self.progress(len(self.report.rows) / len(self.submitted))


if __name__ == "__main__":
    main()
