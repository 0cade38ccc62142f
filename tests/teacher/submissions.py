"""The submissions of a class: a folder or a .zip for each student, in the forms that course systems hand out.

Of a submission, only the Python files of its src/ count. They are found wherever they lie.
"""

import os
import re
import stat
import zipfile
from collections import Counter
from itertools import islice
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from grading.handout import FUNCTIONS
from support.start.output import in_one_line

HANDOUTS = sorted({PurePosixPath(function.file).name for function in FUNCTIONS.values()})
# Folders that are not the student's work, or that the graded starter has itself.
SKIPPED = {"__MACOSX", "__pycache__", "node_modules", "site-packages", "support", "tests", "venv"}
ARCHIVES = (".7z", ".bz2", ".gz", ".rar", ".tar", ".tgz", ".xz")
MOST_BYTES, MOST_FILES = 1_000_000, 200  # of all Python files of a submission, and their number
MOST_ENTRIES = 20_000  # files of any kind


class Submission(NamedTuple):
    student: str
    files: dict[str, bytes]  # by their paths below src/
    problems: list[str]  # with its files, each in a sentence


def submissions_in(folder) -> tuple[dict[str, Path], list[str]]:
    """Return the path of each student's submission by the student's name, and the names of everything else there.

    Raises a ValueError with a one-line message if the folder is a project, or has no submission; an OSError if it
    cannot be read.
    """
    found: dict[str, Path] = {}
    others = []
    for path in sorted(Path(folder).iterdir()):
        if path.name.startswith(".") or path.name in SKIPPED:
            continue
        if path.is_dir() or path.suffix.lower() in (".zip", *ARCHIVES):
            student = in_one_line(path.name if path.is_dir() or path.stem in found else path.stem)
            while student in found:
                student += "_"
            found[student] = path
        else:
            others.append(path.name)
    is_project = any((path / file).is_file() for path in (Path(folder), Path(folder) / "src") for file in HANDOUTS)
    if is_project or not found:
        raise ValueError(f"found '{folder}', allowed is a folder with a folder or a .zip for each student")
    return found, others


def read_submission(student, path) -> Submission:
    """Return what a student has submitted. What cannot be read is missing in files, and told in problems."""
    try:
        read = select(student, entries_of(path))
    except OSError as error:
        read = Submission(student, {}, [f"cannot be read: {error.strerror or error}"])
    except Exception as error:  # a .zip can be damaged in many ways; the class goes on
        read = Submission(student, {}, [f"{path.name} is no .zip that can be read: {error}"])
    return read._replace(problems=[*map(in_one_line, read.problems)])


def entries_of(path) -> dict:
    """Return the files of a submission: for each path, a function that returns its first MOST_BYTES + 1 bytes."""
    if not path.is_dir() and not stat.S_ISREG(path.stat().st_mode):
        raise OSError(f"{path.name} is neither a folder nor a plain file")  # a pipe would never end
    entries = dict(islice(entries_of_folder(path) if path.is_dir() else entries_of_zip(path), MOST_ENTRIES + 1))
    if len(entries) > MOST_ENTRIES:
        raise OSError(f"it has more than {MOST_ENTRIES} files")
    zips = [name for name in entries if name.lower().endswith(".zip")]
    if path.is_dir() and len(zips) == 1 and not any(PurePosixPath(name).name in HANDOUTS for name in entries):
        return entries_of(path / zips[0])  # a .zip in the student's folder, as Moodle has it
    return entries


def entries_of_folder(folder):
    """Yield the path and the function of each plain file, as in entries_of. It does not follow links."""
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if is_own(name))
        for file in (Path(parent) / name for name in sorted(names)):
            if stat.S_ISREG(file.lstat().st_mode):  # no link, pipe or device
                yield file.relative_to(folder).as_posix(), lambda file=file: beginning_of(file)


def beginning_of(file) -> bytes:
    """Return the first MOST_BYTES + 1 bytes of a file."""
    with open(file, "rb") as opened:
        return opened.read(MOST_BYTES + 1)


def entries_of_zip(file):
    """Yield the path and the function of each file of a .zip, as in entries_of."""
    archive = zipfile.ZipFile(file)
    for info in archive.infolist():
        name = PurePosixPath(info.filename.replace("\\", "/"))
        if not info.is_dir() and all(map(is_own, name.parts[:-1])):
            yield name.as_posix(), lambda info=info: archive.open(info).read(MOST_BYTES + 1)


def is_own(folder) -> bool:
    """Return whether a folder of this name can hold the student's work. It does not lead outside, like .. and C:."""
    return folder not in SKIPPED and not folder.startswith(".") and ":" not in folder


def select(student, entries) -> Submission:
    """Return the submission: the Python files of the folder that has most of the handout's files, best called src."""
    folders = Counter(path.parent for path in map(PurePosixPath, entries) if path.name in HANDOUTS)
    if not folders:
        found = ", ".join([*entries][:4]) + " ..." * (len(entries) > 4) or "nothing"
        return Submission(student, {}, [f"none of the handout's files is there; found: {found}"])
    best, *others = sorted(folders, key=lambda path: (-folders[path], path.name != "src", len(path.parts), path))
    problems = [f"took {best}, left {other}" for other in others]
    files: dict[str, bytes] = {}
    paths = [path for path in map(PurePosixPath, entries) if path.suffix == ".py" and path.is_relative_to(best)]
    for path in paths[: MOST_FILES + 1]:
        if sum(map(len, files.values())) <= MOST_BYTES:
            files[path.relative_to(best).as_posix()] = entries[path.as_posix()]()
    if len(paths) > MOST_FILES or sum(map(len, files.values())) > MOST_BYTES:
        allowed = f"allowed are at most {MOST_FILES} Python files with {MOST_BYTES:,} bytes"
        return Submission(student, {}, [*problems, f"too large: found {len(paths)} Python files, {allowed}"])
    return Submission(student, files, problems + [told for file in HANDOUTS for told in missing(file, files)])


def missing(file, files) -> list[str]:
    """Return a problem if this file of the handout is missing, with the name of a file that may be meant."""
    if file in files:
        return []
    meant = [name for name in files if plain_name(name) == plain_name(file)]
    return [f"src/{file} is missing" + "".join(f", found '{name}'" for name in meant[:1])]


def plain_name(name) -> str:
    """Return the name of a file without what a browser or a course system adds, as in "Swinging (1).py"."""
    return re.sub(r"[ _-]*(\(\d+\)|-\d+|copy)*\.py$", "", PurePosixPath(name).name.lower())
