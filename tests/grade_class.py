"""Grade a whole class: `python tests/grade_class.py SUBMISSIONS`.

Each submission has a pytest of its own and, without --here, a container.
"""

import os
import signal
import sys

if __name__ == "__main__":
    signal.signal(signal.SIGINT, lambda *_: os._exit(130))  # while the modules are imported
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

import shutil
import threading
import time
from concurrent.futures import ThreadPoolExecutor, wait
from pathlib import Path
from tempfile import TemporaryDirectory

import grading.begin  # noqa: F401

from support.files.cradle_csv import naming
from support.files.data_file import whole_file
from support.start.early import on_signals
from support.start.options import OneLineParser
from support.start.output import in_one_line, progress_bar, while_it_is_read
from teacher.cluster import Collected, write_packages
from teacher.containers import find_engine
from teacher.report import digest_of, line_of, own_folder, Report, results_in, write_gradescope
from teacher.runners import Here, package, READ_OR_START, Runner
from teacher.submissions import read_submission, submissions_in

LOOK_AT_THREADS = 0.2  # s from one look at the other threads to the next


@while_it_is_read()
def main() -> None:
    """Grade the class. The status is 2 if an argument is wrong or a file cannot be written.

    It is 130 after Ctrl+C, and 128 and its number after another signal.
    """
    options, submitted, others = read_options()
    for folder in filter(None, (options.out, options.gradescope)):
        own_folder(folder)
    stopped = threading.Event()
    status = []

    def stop(number):
        status.append(number or 130)
        stopped.set()

    on_signals(stop)
    file = options.out / "results.jsonl"
    with TemporaryDirectory(prefix="cradle-") as work:
        folder = Path(work, "starter")
        starter = copy_starter(options.starter, folder)
        version = digest_of(starter)
        runner = runner_for(options, folder, version, stopped)
        grading = Grading(submitted, starter, version, file, runner, stopped)
        left = grading.keep_old()
        if stopped.is_set():
            sys.exit(*status)
        if options.pack:
            grading.pack_all(left, options.pack)
            sys.exit(*status)
        grading.grade_all(left)
    report = Report()
    for results in (results_in(file), grading.without_grade):
        for result in results:
            report.add(options.out, result)
            if options.gradescope:
                write_gradescope(options.gradescope / result["student"], result)
    report.write(options.out)
    count = len(report.rows) - len(grading.without_grade)
    graded = f"{count} of {len(submitted)} solutions are graded"
    if status:
        print(f"{graded}. The same command goes on from there.")
        sys.exit(*status)
    print(*report.summary(), sep="\n")
    if others:
        print(f"\nNo submissions: {in_one_line(', '.join(others))}")
    file = in_one_line(options.out / "grades.csv")
    print(f"\n{graded}: {file}, and a text for each student next to it")


def runner_for(options, folder, version, stopped) -> Runner:
    """Return what runs the solutions, with the starter in this folder. Raises an OSError without an
    engine."""
    if options.collect:
        return Collected(version, options.collect)
    if options.here:
        return Here(folder)
    return find_engine(folder, version, stopped)


def read_options():
    """Return the options, the submissions by the student's key, and the names of all others."""
    parser = OneLineParser(
        description="Grade a whole class. Started again, it goes on from there.", allow_abbrev=False
    )
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
    add = parser.add_mutually_exclusive_group().add_argument
    add("--here", action="store_true", help="run the solutions on this machine, without containers")
    add("--pack", metavar="FOLDER", type=Path, help="write the solutions for a cluster, and stop")
    add("--collect", metavar="FOLDER", type=Path, help="take the grades of a cluster from there")
    options = parser.parse_args()
    folder = options.submissions.resolve()
    options.out = options.out or folder.with_name(f"{folder.name}-grades")
    try:
        submitted, others = submissions_in(folder)
    except OSError as error:
        parser.error(f"argument SUBMISSIONS: {options.submissions}: {error.strerror}")
    except ValueError as error:
        parser.error(f"argument SUBMISSIONS: {error}")
    for name in ("out", "gradescope", "pack"):
        path = getattr(options, name)
        if path and path.resolve().is_relative_to(folder):
            allowed = "a folder outside of SUBMISSIONS"
            parser.error(f"argument --{name}: found '{path}', allowed is {allowed}")
    if options.starter and not (options.starter / "tests" / "grading").is_dir():
        allowed = "a folder made by make_starter.py"
        parser.error(f"argument --starter: found '{options.starter}', allowed is {allowed}")
    if options.pack and options.pack.exists() and any(options.pack.iterdir()):
        parser.error(f"argument --pack: found '{options.pack}', allowed is a new or empty folder")
    if options.collect and not (options.collect / "packages.txt").is_file():
        allowed = "a folder made with --pack"
        parser.error(f"argument --collect: found '{options.collect}', allowed is {allowed}")
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
    """The grades of a class.

    results.jsonl keeps each whole one, so the next run grades only what is new or changed.
    """

    def __init__(self, submitted, starter, version, file, runner, stopped):
        self.submitted = submitted  # by the student's key
        self.starter = starter  # its files by their paths
        self.version = version  # of the starter and what runs it
        self.file = file
        self.runner = runner
        self.stopped = stopped  # set once no more solutions are graded
        self.lock = threading.Lock()
        self.unsure: list[str] = []  # students whose run something beside it may have changed
        self.without_grade: list[dict] = []  # results
        self.done = 0  # students who have a result now

    def grade_all(self, left) -> None:
        """Grade these students, one on each core; then those that are unsure again, each alone."""
        if not left:
            return
        with ThreadPoolExecutor(self.runner.cores) as workers, progress_bar() as self.progress:
            self.most = len(left)
            self.finish([workers.submit(self.get_ready, self.runner.open)])
            self.finish([workers.submit(self.grade, student) for student in left])
            for student in sorted(self.unsure):
                self.finish([workers.submit(self.grade, student, is_last=True)])

    def get_ready(self, act) -> None:
        """Open the runner, or build its image, by this; if the class is stopped, this may fail."""
        try:
            act()
        except OSError:
            if not self.stopped.is_set():
                raise

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

    def pack_all(self, students, folder) -> None:
        """Write packages of the starter and of these students for a cluster."""
        with ThreadPoolExecutor(1) as workers:
            self.finish([workers.submit(self.get_ready, self.runner.build)])
            self.finish([workers.submit(self.pack, students, folder)])

    def pack(self, students, folder) -> None:
        """Read these students' submissions, and write the packages."""
        packages = [package({})]
        for student in students:
            if self.stopped.is_set():
                return
            files, _ = self.read(student)
            packages.append(package(files))
        if self.stopped.is_set():
            return
        write_packages(folder, self.version, packages)
        jobs = f"the starter and {len(students)} solutions, for the jobs 0 to {len(students)}"
        print(in_one_line(f"{folder} has {jobs} in the image {self.runner.image}."))

    def keep_old(self) -> list[str]:
        """Let results.jsonl have only the results that still hold; return the students without one.

        If somebody stops the program while it reads the submissions, results.jsonl stays as it is.
        """
        digests = {}
        for student in self.submitted:
            if self.stopped.is_set():
                return []
            digests[student] = self.digest(student, self.read(student))
        old = results_in(self.file)
        with whole_file(self.file) as kept:
            for result in old:
                student = result["student"]
                if student not in self.submitted:  # it is gone
                    self.file.with_name(f"{student}.txt").unlink(missing_ok=True)
                elif digests.get(student) == result["digest"]:
                    kept.write(line_of(result))
                    del digests[student]
        return [*digests]

    def read(self, student) -> tuple[dict[str, bytes], list[str]]:
        """Return a student's files, and the problems with them, as read_submission does."""
        with READ_OR_START:
            return read_submission(self.submitted[student], self.starter)

    def digest(self, student, submission) -> str:
        """Return a hash of what a result depends on."""
        return digest_of(self.version, student, *submission)

    def grade(self, student, is_last=False) -> None:
        """Grade a student, and keep the result if it is sure, or is the last one."""
        if self.stopped.is_set():
            return
        submission = self.read(student)
        files, problems = submission
        begin = time.monotonic()
        run = self.runner.run(files)
        seconds = time.monotonic() - begin
        if self.stopped.is_set():  # it has ended the run
            return
        if not (run.is_final or is_last):
            self.unsure.append(student)
            return
        result = {
            "student": student,
            "digest": self.digest(student, submission),
            "seconds": seconds,
            **run.grade,
        }
        result["problems"] = [*problems, run.problem] if run.problem else problems
        with self.lock:
            self.keep(result, has_grade=not run.problem)

    def keep(self, result, has_grade) -> None:
        """Keep a result: in results.jsonl only if it has a grade.

        So a run without one is made again.
        """
        if has_grade:
            with naming(self.file), open(self.file, "a", encoding="utf-8") as kept:
                kept.write(line_of(result))
        else:
            self.without_grade.append(result)
        self.done += 1
        self.progress(self.done / self.most)


if __name__ == "__main__":
    main()
