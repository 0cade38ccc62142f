"""The submissions of a class, in the forms in which course systems hand them out.

A student has a folder, a .zip, or files among those of the others. Their names, as those of some
folders, have what the system says of the student and of the upload before the file's own name.
"""

import re
from collections import defaultdict
from contextlib import suppress
from pathlib import Path

import pandas as pd

from grading.limits import limited_memory
from support.start.output import in_one_line
from teacher.choice import ASSIGNED, select
from teacher.entries import entries_of, SKIPPED
from teacher.keys import keys_of, Student

ARCHIVES = (".zip", ".7z", ".bz2", ".gz", ".rar", ".tar", ".tgz", ".xz")
MOST_MEMORY = 200  # MB to read a submission
MOST_PROBLEMS = 8  # of a submission
MOST_LETTERS = 200  # of a problem

# Names with numbers: ann_12_345_swinging.py (Canvas: of the student, and of the upload), and
# "Ann A_12_assignsubmission_file_swinging.py" (Moodle; its folders are called so, too). They are
# read from their end, because a student can choose the beginning.
WITH_NUMBERS = re.compile(
    r"""
    (?P<student>.+) _ (?P<other>\d+) _
    (?: assignsubmission_(?:file|onlinetext)_? | (?P<upload>\d+) _ (?=.))
    (?P<file>.*)
    """,
    re.VERBOSE,
)
# With a time: "Project 4_ann_attempt_2026-11-25-13-14-00_swinging.py" (Blackboard), and
# "12-345 - Ann A - Nov 25, 2026 114 PM - swinging.py" (Brightspace; or a folder).
WITH_TIME = re.compile(
    r"""
    (?: (?P<other>.+?) (?:-\d+)? (?:_|\ -\ ))?
    (?P<student>[^_]+?) (?:_attempt)? (?:_|\ -\ )
    (?P<upload>
        20\d\d (?:-\d\d){5}
        | (?:[^\W\d]+\ \d+,? | \d+\.?\ [^\W\d]+\.?)\ 20\d\d\ \d{1,2}:?\d\d (?:\ [AP]M)?
    )
    (?:_|\ -\ )? (?P<file>.*)
    """,
    re.VERBOSE,
)
# With nothing but the student's name: "Ann A - swinging.py", "Ann A_swinging.py".
STEMS = "|".join(name.removesuffix(".py") for name in ASSIGNED)
WITH_NAME = re.compile(
    rf"(?P<student>.+?)(?P<other>)(?P<upload>)(?: - |_(?={STEMS}))(?P<file>.+\.py)"
)
CLOCK = r"(?<=\d):?(?=\d\d( [AP]M)?$)"  # what is between hours and minutes


def submissions_in(folder) -> tuple[dict[str, list[tuple[str, Path]]], list[str]]:
    """Return the submissions by the student's key, and the names of the rest.

    A submission is a list of pairs, the newest upload last: ("", a folder or an archive), or (name,
    a file). No link is followed. Raises a ValueError with one line if the folder is a project, or
    has no submission; an OSError if it cannot be read.
    """
    folder = Path(folder)
    found = defaultdict(list)
    others = []
    for path in sorted(folder.iterdir()):
        if path.name in SKIPPED or path.name.startswith("."):
            continue
        student, file, upload = owner_of(path)
        if student is None:
            others.append(path.name)
        else:
            found[student].append((upload, file, path))
    if not found or has_assigned(folder) or has_assigned(folder / "src"):
        raise ValueError(
            f"found '{folder}', allowed is a folder with a folder or a .zip for each student, or "
            "with files like ann_12_345_swinging.py"
        )
    keys = keys_of(found)
    submissions = {}
    for student in sorted(found, key=keys.get):
        submissions[keys[student]] = [(file, path) for _, file, path in sorted(found[student])]
    return submissions, others


def has_assigned(folder) -> bool:
    """Return whether a file of the assignment is in a folder."""
    return any((folder / name).is_file() for name in ASSIGNED)


def owner_of(path) -> tuple[Student | None, str, str]:
    """Return who has handed in a path (None if nobody has), the file's own name, and the time.

    The name is "" for a folder and for an archive. The time is as time_of returns it.
    """
    name = path.name
    if path.is_symlink():
        return None, "", ""
    for pattern in (WITH_TIME, WITH_NUMBERS, WITH_NAME):
        found = pattern.fullmatch(name)
        if found and not (found["file"] and path.is_dir()):
            student = found["student"].removesuffix("_LATE")
            full = f"{student}_{found['other']}"
            return Student(student, full), found["file"], time_of(found["upload"] or "")
    if path.is_dir():
        return Student(name, name), "", ""
    if path.suffix.lower() in ARCHIVES:
        return Student(path.stem, name), "", ""
    return None, "", ""


def time_of(upload) -> str:
    """Return a text that is greater for a later upload."""
    with suppress(Exception):  # it is no time with a month
        return f"{pd.to_datetime(re.sub(CLOCK, ':', upload))}"
    return upload


@limited_memory(MOST_MEMORY)
def read_submission(paths, starter) -> tuple[dict[str, bytes], list[str]]:
    """Return the files of a submission, by their paths in the project, and the problems with it.

    starter has the starter's files in the same form. Each problem is a sentence.
    """
    problems: list[str] = []
    files: dict[str, bytes] = {}
    try:
        entries = entries_of(paths, problems)
        files = select(entries, starter, problems)
    except Exception as error:  # also too deep a folder; the class goes on
        why = getattr(error, "strerror", None) or f"{error}" or type(error).__name__
        problems.append(f"cannot be read: {why}")
    if len(problems) > MOST_PROBLEMS:
        problems[MOST_PROBLEMS:] = ["and more"]
    return files, [in_one_line(problem[:MOST_LETTERS]) for problem in problems]
