"""Grade a whole class: `python tests/grade_class.py SUBMISSIONS`.

SUBMISSIONS has a folder or a .zip for each student. Each solution runs in a fresh starter, in a process of its own.
"""

import hashlib
import os
import sys
import time
from concurrent.futures import as_completed, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path
from queue import SimpleQueue
from tempfile import TemporaryDirectory

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent))  # so that Python finds grading, also with -P

from grading.project_path import ROOT
from support import headless_vpython

headless_vpython.install()

from grading.grade import lines
from grading.grader import checks
from grading.handout import SUITES
from support.files.data_file import whole_file
from support.start.options import OneLineParser
from support.start.output import in_one_line, is_unread, refuse, while_it_is_read
from support.terminal.screen import progress_bar
from teacher.report import line_of, Result, results_in, summary, write_grades, write_gradescope
from teacher.submissions import read_submission, submissions_in
from teacher.workers import compile_starter, Worker


@while_it_is_read()
def main() -> None:
    """Grade the class; the status is 2 if an argument is wrong or a file cannot be written, and 130 after Ctrl+C."""
    options, paths, others = read_options()
    for tier in SUITES:
        checks(tier=tier)  # imports them
    try:
        with TemporaryDirectory() as work:
            starter = options.starter or new_starter(Path(work) / "starter")
            results = grade_all(paths, starter, options.out)
        finish(options, results, len(paths), others)
    except KeyboardInterrupt:
        print("Stopped. The same command goes on from there.")
        sys.exit(130)
    except OSError as error:
        if is_unread(error):
            raise  # while_it_is_read ends the program
        refuse(f"{error.filename or options.out}: {error.strerror}")


def read_options():
    """Return the options, the path of each student's submission, and the names of what is no submission."""
    parser = OneLineParser(description="Grade a whole class. Started again, it goes on from there.", allow_abbrev=False)
    add = parser.add_argument
    add("submissions", metavar="SUBMISSIONS", type=Path, help="a folder with a folder or a .zip for each student")
    text = "the folder for grades.csv and a text for each student (default: SUBMISSIONS-grades)"
    add("--out", metavar="FOLDER", type=Path, help=text)
    text = "write DIR/STUDENT/results.json for each student, as Gradescope reads it"
    add("--gradescope", metavar="DIR", type=Path, help=text)
    add("--starter", metavar="FOLDER", type=Path, help="a starter that is already made (default: a new one)")
    options = parser.parse_args()
    folder = options.submissions.resolve()
    try:
        paths, others = submissions_in(folder)
    except OSError as error:
        parser.error(f"argument SUBMISSIONS: {options.submissions}: {error.strerror}")
    except ValueError as error:
        parser.error(f"argument SUBMISSIONS: {error}")
    for name, path in (("out", options.out), ("gradescope", options.gradescope)):
        if path and path.resolve().is_relative_to(folder):
            parser.error(f"argument --{name}: found '{path}', allowed is a folder outside of SUBMISSIONS")
    if options.starter and not (options.starter / "tests" / "grading").is_dir():
        parser.error(f"argument --starter: found '{options.starter}', allowed is a folder made by make_starter.py")
    options.out = options.out or folder.with_name(f"{folder.name}-grades")
    return options, paths, others


def new_starter(folder) -> Path:
    """Make a starter, and return its folder."""
    from make_starter import make_starter  # a folder for Gradescope, which is a starter itself, does not have it

    make_starter(folder)
    compile_starter(folder)
    return folder


def source_files(folder) -> dict[str, bytes]:
    """Return the Python files below a folder by their paths."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*.py"))}


def grade_all(paths, starter, out) -> list[Result]:
    """Grade the submissions, and return the results in their order.

    Each result is kept in results.jsonl in the folder out, so the next run grades only what is new or changed. After
    Ctrl+C, it returns what is there.
    """
    out.mkdir(parents=True, exist_ok=True)
    grader = digest_of(source_files(starter), source_files(ROOT / "tests" / "teacher"))
    submissions = {student: read_submission(student, path) for student, path in paths.items()}
    digests = {student: digest_of(grader, *submission) for student, submission in submissions.items()}
    file = out / "results.jsonl"
    results = {student: result for student, result in results_in(file).items() if result.digest == digests.get(student)}
    with whole_file(file) as kept:
        kept.writelines(map(line_of, results.values()))
    to_grade = [submission for student, submission in submissions.items() if student not in results]
    hidden = {path.parent for path in paths.values()} | {out}
    with (
        open(file, "a", encoding="utf-8") as kept,
        graded_side_by_side(to_grade, digests, starter, hidden) as graded,
        suppress(KeyboardInterrupt),
        progress_bar() as progress,
    ):
        for number, (result, output) in enumerate(graded, start=1):
            write_text(out, result, output)
            kept.write(line_of(result))
            kept.flush()
            results[result.student] = result
            progress(number / len(to_grade))
    return [results[student] for student in submissions if student in results]


def digest_of(*values) -> str:
    """Return a hash of the values."""
    return hashlib.sha256(repr(values).encode()).hexdigest()


@contextmanager
def graded_side_by_side(submissions, digests, starter, hidden):
    """Yield an iterator over the results and pytest's outputs, as they come; a worker for each core grades."""
    count = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    workers = [Worker(starter, hidden) for _ in range(count)]
    idle: SimpleQueue = SimpleQueue()
    for worker in workers:
        idle.put(worker)

    def grade_one(submission):
        worker, start = idle.get(), time.monotonic()
        try:
            graded = worker.grade(submission.files)
        finally:
            idle.put(worker)
        seconds, problems = time.monotonic() - start, submission.problems + graded.problems
        digest = digests[submission.student]
        return Result(submission.student, digest, graded.outcomes, seconds, problems), graded.output

    with ThreadPoolExecutor(count) as pool:
        try:
            yield (future.result() for future in as_completed([pool.submit(grade_one, each) for each in submissions]))
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
            for worker in workers:
                worker.close()


def write_text(folder, result, output) -> None:
    """Write the student's text: the problems, and what pytest printed, or the table if it did not get so far."""
    printed = output if "Next:  " in output else "\n".join(line for line, _ in lines(result.outcomes))
    text = "".join(f"{problem}\n" for problem in [result.student, *result.problems])
    (folder / f"{result.student}.txt").write_text(f"{text}\n{printed.strip()}\n", encoding="utf-8")


def finish(options, results, count, others) -> None:
    """Write grades.csv and what the options ask for, and print the summary; exit if solutions are not graded yet."""
    write_grades(options.out / "grades.csv", results)
    if len(results) < count:
        print(f"{len(results)} of {count} solutions are graded. The same command goes on from there.")
        sys.exit(130)
    for result in results if options.gradescope else []:
        write_gradescope(options.gradescope / result.student, result)
    print("\n".join(summary(results)))
    if others:
        print(f"\nNo submissions: {in_one_line(', '.join(others))}")
    line = f"{count} solutions are graded: {options.out / 'grades.csv'}, and a text for each student beside it"
    print(f"\n{in_one_line(line)}")


if __name__ == "__main__":
    main()
