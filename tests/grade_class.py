"""Grade a whole class: `python tests/grade_class.py SUBMISSIONS`. Each submission has a pytest of its own."""

import os
import signal
import sys

if __name__ == "__main__":  # while the modules are imported
    signal.signal(signal.SIGINT, lambda *_: os._exit(130))

import asyncio
import compileall
import shutil
import time
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import grading.begin  # noqa: F401

from support.files.data_file import whole_file
from support.start.options import OneLineParser
from support.start.output import in_one_line, progress_bar, while_it_is_read
from teacher import report
from teacher.sandbox import open_sandbox
from teacher.submissions import read_submission, submissions_in


@while_it_is_read()
def main() -> None:
    """Grade the class; the status is 2 if an argument is wrong or a file cannot be written, and 130 after Ctrl+C."""
    options, submitted, others = read_options()
    results: dict[str, dict] = {}
    with suppress(asyncio.CancelledError):
        options.out.mkdir(mode=0o700, parents=True, exist_ok=True)
        signal.signal(signal.SIGINT, lambda *_: sys.exit(130))  # in place of asyncio's, which waits for the starter
        with TemporaryDirectory(prefix="cradle-") as work:
            try:
                asyncio.run(grade_all(submitted, results, options, Path(work)))
            except OSError as error:  # of a full disk, it may have no name
                raise OSError(error.errno, error.strerror or f"{error}", error.filename or work) from None
    results = {student: results[student] for student in submitted if student in results}
    report.write_grades(options.out, results.values())
    if len(results) < len(submitted):
        print(f"{len(results)} of {len(submitted)} solutions are graded. The same command goes on from there.")
        sys.exit(130)
    for result in results.values() if options.gradescope else []:
        report.write_gradescope(options.gradescope / report.file_name(result["student"]), result)
    lines, file = report.summary(results.values()), in_one_line(options.out / "grades.csv")
    lines += [f"\nNo submissions: {in_one_line(', '.join(others))}"] * bool(others)
    print(*lines, f"\n{len(results)} solutions are graded: {file}, and a text for each student beside it", sep="\n")


def read_options():
    """Return the options, the submissions by student, and the names of what is no submission."""
    parser = OneLineParser(description="Grade a whole class. Started again, it goes on from there.", allow_abbrev=False)
    add = parser.add_argument
    add("submissions", metavar="SUBMISSIONS", type=Path, help="a folder with a folder or a .zip for each student")
    add("--out", metavar="FOLDER", type=Path, help="the folder for the results (default: SUBMISSIONS-grades)")
    add("--gradescope", metavar="DIR", type=Path, help="write DIR/STUDENT/results.json, as Gradescope reads it")
    add("--starter", metavar="FOLDER", type=Path, help="a starter that is already made (default: a new one)")
    options = parser.parse_args()
    folder = options.submissions.resolve()
    options.out = options.out or folder.with_name(f"{folder.name}-grades")
    try:
        submitted, others = submissions_in(folder)
    except (OSError, ValueError) as error:
        words = f"{options.submissions}: {error.strerror}" if isinstance(error, OSError) else error
        parser.error(f"argument SUBMISSIONS: {words}")
    for name, path in (("out", options.out), ("gradescope", options.gradescope)):
        if path and path.resolve().is_relative_to(folder):
            parser.error(f"argument --{name}: found '{path}', allowed is a folder outside of SUBMISSIONS")
    if options.starter and not (options.starter / "tests" / "grading").is_dir():
        parser.error(f"argument --starter: found '{options.starter}', allowed is a folder made by make_starter.py")
    return options, submitted, others


async def grade_all(submitted, results, options, work) -> None:
    """Grade the submissions, one on each core, and put the results into results, by student, as they come.

    results.jsonl in the folder options.out keeps each result, so the next run grades only what is new or changed.
    """
    mask = os.umask(0o022)  # other users, if there are any, read the starter
    grader = copy_starter(options.starter, work / "starter")
    os.umask(mask)
    submissions = {student: read_submission(paths) for student, paths in submitted.items()}
    digests = {student: report.digest_of(grader, student, *each) for student, each in submissions.items()}
    before, file = report.results_in(options.out / "results.jsonl"), options.out / "results.jsonl"
    results |= {student: result for student, result in before.items() if result["digest"] == digests.get(student)}
    for student in before.keys() - submissions.keys():  # they are gone
        (options.out / f"{report.file_name(student)}.txt").unlink(missing_ok=True)
    with whole_file(file) as kept:
        kept.writelines(map(report.line_of, results.values()))
    loop, task = asyncio.get_running_loop(), asyncio.current_task()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: loop.is_closed() or loop.call_soon_threadsafe(task.cancel))
    left = iter([student for student in submissions if student not in results])
    run, empty = await open_sandbox(work / "starter", work) if len(results) < len(submissions) else (None, {})
    with open(file, "a", encoding="utf-8") as kept, progress_bar() as progress:

        async def grade():
            for student in left:
                begin, (files, problems) = time.monotonic(), submissions[student]
                read = report.read_grade(empty, *await run(files), problems)
                seconds = time.monotonic() - begin
                results[student] = {"student": student, "digest": digests[student], "seconds": seconds, **read}
                kept.write(report.line_of(results[student]))
                kept.flush()
                progress(len(results) / len(submissions))

        await asyncio.gather(*(grade() for _ in range(os.cpu_count() or 1)))


def copy_starter(starter, folder) -> str:
    """Copy a starter to this folder, or make one there; compile it, so that Python starts faster; return its hash."""
    if starter:
        shutil.copytree(starter, folder, ignore=shutil.ignore_patterns(".*", "__pycache__"))
    else:
        from make_starter import make_starter  # a folder for Gradescope, itself a starter, does not have it

        make_starter(folder)
    for name in ("support", "tests"):
        compileall.compile_dir(folder / name, quiet=2)
    return report.digest_of(*((path.name, path.read_bytes()) for path in sorted(folder.rglob("*.py"))))


if __name__ == "__main__":
    main()
