"""The submissions of a class, in the forms in which course systems hand them out.

A student has a folder, a .zip, or files beside those of the others: Canvas names them
ann_12_345_swinging.py, and Moodle Ann A_12_assignsubmission_file_swinging.py. Only the Python files
of src/ count, wherever they lie.
"""

import re
from collections import defaultdict
from pathlib import Path

from grading.limits import limited_memory
from support.start.output import in_one_line
from teacher.choice import HANDOUTS, select
from teacher.entries import entries_of, SKIPPED
from teacher.keys import keys_of, Student

ARCHIVES = (".zip", ".7z", ".bz2", ".gz", ".rar", ".tar", ".tgz", ".xz")
MOST_MEMORY = 200  # MB to read a submission
MOST_PROBLEMS = 8  # of a submission
MOST_LETTERS = 200  # of a problem

# These names are read from their end, because a student can choose the beginning. Canvas writes the
# student's name, the student's number, a number of the file, and the file's own name.
CANVAS = re.compile(r"(?P<student>.+)_(?P<number>\d+)_\d+_(?P<file>.+)")
# Moodle puts the name and a number before it. Its folders have such names, too, and an online text
# is one more.
MOODLE = re.compile(
    r"(?P<student>.+)_(?P<number>\d+)_assignsubmission_(file|onlinetext)_?(?P<file>.*)"
)


def submissions_in(folder) -> tuple[dict[str, list[tuple[str, Path]]], list[str]]:
    """Return the submissions by the student's key, and the names of the rest.

    A submission is a list of pairs: ("", a folder or an archive), or (name, a file). No link is
    followed. Raises a ValueError with one line if the folder is a project, or has no submission; an
    OSError if it cannot be read.
    """
    folder = Path(folder)
    found = defaultdict(list)
    others = []
    for path in sorted(folder.iterdir()):
        if path.name in SKIPPED or path.name.startswith("."):
            continue
        student, file = owner_of(path)
        if student is None:
            others.append(path.name)
        else:
            found[student].append((file, path))
    if not found or has_handout(folder) or has_handout(folder / "src"):
        raise ValueError(
            f"found '{folder}', allowed is a folder with a folder or a .zip for each student, or "
            "with files like ann_12_345_swinging.py"
        )
    keys = keys_of(found)
    return {keys[student]: found[student] for student in sorted(found, key=keys.get)}, others


def has_handout(folder) -> bool:
    """Return whether a file of the handout is in a folder."""
    return any((folder / name).is_file() for name in HANDOUTS)


def owner_of(path) -> tuple[Student | None, str]:
    """Return the student who has handed in a path, None if nobody has, and the file's own name.

    This name is "" for a folder and for an archive.
    """
    if path.is_symlink():
        return None, ""
    name = path.name
    is_folder = path.is_dir()
    flat = MOODLE.fullmatch(name)
    if not flat and not is_folder:
        flat = CANVAS.fullmatch(name)
    if flat:
        student = flat["student"].removesuffix("_LATE")
        return Student(student, f"{student}_{flat['number']}"), "" if is_folder else flat["file"]
    if is_folder:
        return Student(name, name), ""
    if path.suffix.lower() in ARCHIVES:
        return Student(path.stem, name), ""
    return None, ""


@limited_memory(MOST_MEMORY)
def read_submission(paths) -> tuple[dict[str, bytes], list[str]]:
    """Return the files of a submission, by their paths below src/, and the problems with it.

    Each problem is a sentence.
    """
    problems: list[str] = []
    files: dict[str, bytes] = {}
    try:
        entries = entries_of(paths, problems)
        files = select(entries, problems)
    except Exception as error:  # also too deep a folder; the class goes on
        why = getattr(error, "strerror", None) or f"{error}" or type(error).__name__
        problems.append(f"cannot be read: {why}")
    if len(problems) > MOST_PROBLEMS:
        problems[MOST_PROBLEMS:] = ["and more"]
    return files, [in_one_line(problem[:MOST_LETTERS]) for problem in problems]
