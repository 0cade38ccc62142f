"""Grade a whole class: `python tests/grade_class.py SUBMISSIONS`.

SUBMISSIONS has a folder or a .zip for each student. A judge on each core grades solutions, which run in a sandbox.
"""

import os
import signal
import sys

STOPPED = "Stopped. The same command goes on from there."
if __name__ == "__main__":
    # While the modules are imported:
    signal.signal(signal.SIGINT, lambda *_: (print(STOPPED, flush=True), os._exit(130)))

import multiprocessing
import threading
import time
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from grading.begin import ROOT

from grading.grader import checks
from grading.handout import SUITES
from support.files.data_file import whole_file
from support.start.options import OneLineParser
from support.start.output import complain, in_one_line, while_it_is_read
from support.terminal.screen import progress_bar
from teacher import judge
from teacher.report import digest_of, file_name, line_of, Result, results_in, summary, write_grades, write_gradescope
from teacher.sandbox import copy_files, holds_off, LEFT_OPEN, Process
from teacher.submissions import read_submission, submissions_in

TOLD = 10.0  # s between lines about the progress

for tier in SUITES:
    checks(tier=tier)  # imports them


@while_it_is_read()
def main() -> None:
    """Grade the class; the status is 2 if an argument is wrong or a file cannot be written, and 130 after Ctrl+C."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    options, paths, others = read_options()
    try:
        options.out.mkdir(parents=True, exist_ok=True)
        with TemporaryDirectory() as work, only_run_in(options.out):
            starter = options.starter or Path(work) / "starter"
            if not options.starter:
                from make_starter import make_starter  # a folder for Gradescope, itself a starter, does not have it

                make_starter(starter)
            results = grade_all(paths, starter, options, copy_files(starter, Path(work) / "copied"))
        finish(options, results, len(paths), others)
    except KeyboardInterrupt:
        print(STOPPED)
        sys.exit(130)


def read_options():
    """Return the options, the path of each student's submission, and the names of what is no submission."""
    parser = OneLineParser(description="Grade a whole class. Started again, it goes on from there.", allow_abbrev=False)
    add = parser.add_argument
    add("submissions", metavar="SUBMISSIONS", type=Path, help="a folder with a folder or a .zip for each student")
    add("--out", metavar="FOLDER", type=Path, help="the folder for the results (default: SUBMISSIONS-grades)")
    add("--gradescope", metavar="DIR", type=Path, help="write DIR/STUDENT/results.json, as Gradescope reads it")
    add("--starter", metavar="FOLDER", type=Path, help="a starter that is already made (default: a new one)")
    options = parser.parse_args()
    folder = options.submissions.resolve()
    try:
        paths, others = submissions_in(folder)
    except (OSError, ValueError) as error:
        words = f"{options.submissions}: {error.strerror}" if isinstance(error, OSError) else error
        parser.error(f"argument SUBMISSIONS: {words}")
    for name, path in (("out", options.out), ("gradescope", options.gradescope)):
        if path and path.resolve().is_relative_to(folder):
            parser.error(f"argument --{name}: found '{path}', allowed is a folder outside of SUBMISSIONS")
    for file in own_tests() if options.starter else ():  # the judges have those of this project
        theirs = options.starter / file.relative_to(ROOT)
        if not theirs.is_file() or theirs.read_bytes() != file.read_bytes():
            allowed = f"allowed is a folder made by make_starter.py, with the same {file.relative_to(ROOT)}"
            parser.error(f"argument --starter: found '{options.starter}', {allowed}")
    options.out = options.out or folder.with_name(f"{folder.name}-grades")
    return options, paths, others


def own_tests() -> list[Path]:
    """Return the files of the checks and of the grader."""
    return sorted([*(ROOT / "tests").glob("test_*.py"), *(ROOT / "tests" / "grading").glob("*.py")])


@contextmanager
def only_run_in(folder):
    """Keep other runs out of this folder, in the body of the with statement; raise an OSError if there is one."""
    if os.name == "nt":  # it has no such locks
        yield
        return
    import fcntl

    opened = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(opened, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    except BlockingIOError as error:
        raise OSError(error.errno, "another run of this program is at work here", str(folder)) from None
    finally:
        os.close(opened)


def given_files(starter) -> dict[str, bytes]:
    """Return the files of a starter's src/, and its CSV, by their paths: a solution's files take their places."""
    files = [*sorted((starter / "src").rglob("*.py")), starter / "newton_cradle_pends.csv"]
    return {path.relative_to(starter).as_posix(): path.read_bytes() for path in files}


def grade_all(paths, starter, options, copied) -> list[Result]:
    """Grade the submissions, and return the results in their order; after Ctrl+C, those that are there.

    Each result is kept in results.jsonl in the folder options.out, so the next run grades only what is new or changed.
    """
    file, given = options.out / "results.jsonl", given_files(starter)
    graders = [*own_tests(), *sorted(starter.rglob("support/**/*.py"))]
    grader = digest_of(given, *(path.read_bytes() for path in graders))
    submissions = {student: read_submission(student, path) for student, path in paths.items()}
    digests = {student: digest_of(grader, *submission) for student, submission in submissions.items()}
    before = results_in(file)
    results = {student: result for student, result in before.items() if result.digest == digests.get(student)}
    for student in before.keys() - submissions.keys():  # they are gone
        (options.out / f"{file_name(student)}.txt").unlink(missing_ok=True)
        if options.gradescope:
            (options.gradescope / file_name(student) / "results.json").unlink(missing_ok=True)
    with whole_file(file) as kept:
        kept.writelines(map(line_of, results.values()))

    to_grade = [(submissions[student], digest) for student, digest in digests.items() if student not in results]
    hidden = {path.parent for path in paths.values()} | {options.out.resolve(), starter.resolve()}
    graded_ones = side_by_side(to_grade, given, copied, hidden)
    with open(file, "a", encoding="utf-8") as kept, suppress(KeyboardInterrupt), closing(graded_ones):
        for result, text in graded_ones:
            lines = "\n".join([result.student, *result.problems, "", text, ""])
            (options.out / f"{file_name(result.student)}.txt").write_text(lines, "utf-8", "backslashreplace")
            kept.write(line_of(result))
            kept.flush()
            results[result.student] = result
    return [results[student] for student in submissions if student in results]


def side_by_side(to_grade, given, copied, hidden):
    """Grade each (submission, digest), a judge on each core; yield the results and the students' texts as they come.

    A bar shows the progress, or in a file a line now and then.
    """
    if not to_grade:
        return
    kind = holds_off(copied, hidden)
    if LEFT_OPEN[kind]:
        how = "It does not work here." if which("bwrap") else "On Linux: apt install bubblewrap."
        complain(f"Without bubblewrap, a solution can use {LEFT_OPEN[kind]}. {how}")
    count, fresh = len(to_grade), multiprocessing.get_context("spawn")
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)  # the judges start so: Ctrl+C is for this process
    pool = ProcessPoolExecutor(mp_context=fresh, initializer=prepare, initargs=(given, copied, kind, hidden))
    left = {pool.submit(graded, *each) for each in to_grade}
    signal.signal(signal.SIGINT, before)
    told = time.monotonic()
    try:
        with progress_bar() as progress:
            while left:
                done, left = wait(left, TOLD, FIRST_COMPLETED)
                for future in done:
                    yield future.result()
                    progress(1 - len(left) / count)
                if not sys.stderr.isatty() and time.monotonic() > told + TOLD:
                    complain(f"{count - len(left)} of {count} solutions are graded.")
                    told = time.monotonic()
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in multiprocessing.active_children():
            process.terminate()


JUDGE: dict = {}  # what a judge needs to grade a solution


def prepare(given, *of_process) -> None:
    """Make this process a judge. It ends with the main program, and the solution's process with it."""

    def end(*_):
        JUDGE["process"].close()
        os._exit(1)

    JUDGE.update(given=given, process=Process(*of_process))
    signal.signal(signal.SIGTERM, end)
    threading.Thread(target=lambda: end(multiprocessing.parent_process().join()), daemon=True).start()


def graded(submission, digest) -> tuple[Result, str]:
    """Grade a submission, in the process of a judge; return the result, and the text for the student."""
    begin = time.monotonic()
    files = {**JUDGE["given"], **{f"src/{name}": content for name, content in submission.files.items()}}
    outcomes, text, problems = judge.grade(files, JUDGE["process"])
    return Result(submission.student, digest, outcomes, time.monotonic() - begin, submission.problems + problems), text


def finish(options, results, count, others) -> None:
    """Write grades.csv and what the options ask for, and print the summary; exit if solutions are not graded yet."""
    write_grades(options.out / "grades.csv", results)
    if len(results) < count:
        print(f"{len(results)} of {count} solutions are graded. The same command goes on from there.")
        sys.exit(130)
    for result in results if options.gradescope else []:
        write_gradescope(options.gradescope / file_name(result.student), result)
    print("\n".join(summary(results)))
    if others:
        print(f"\nNo submissions: {in_one_line(', '.join(others))}")
    line = f"{count} solutions are graded: {options.out / 'grades.csv'}, and a text for each student beside it"
    print(f"\n{in_one_line(line)}")


if __name__ == "__main__":
    main()
