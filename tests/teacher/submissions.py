"""The submissions of a class, in the forms in which course systems hand them out.

A student has a folder, a .zip, or files beside those of the others: Canvas names them ann_12_345_swinging.py, and
Moodle Ann A_12_assignsubmission_file_swinging.py. Only the Python files of src/ count, wherever they lie.
"""

import os
import re
import stat
import zipfile
from collections import Counter, defaultdict
from functools import partial
from io import BytesIO
from pathlib import Path, PurePosixPath

from grading.handout import FUNCTIONS
from grading.limits import limited_memory
from support.start.output import in_one_line

HANDOUTS = sorted({PurePosixPath(function.file).name for function in FUNCTIONS.values()})
# Folders that are not the student's work, or that the graded starter has itself.
SKIPPED = {"__MACOSX", "__pycache__", "node_modules", "site-packages", "support", "tests", "venv"}
ARCHIVES = (".zip", ".7z", ".bz2", ".gz", ".rar", ".tar", ".tgz", ".xz")
MOST_FILES, MOST_BYTES = 200, 1_000_000  # of the Python files of a submission
MOST_ZIPS, MOST_ZIP = 4, 20_000_000  # .zips in another one or in a folder, and bytes of a file in a .zip
MOST_PROBLEMS, MOST_LETTERS = 8, 200  # of a submission, and of a problem
READ = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED  # with other methods, a few bytes can take all memory
LEFT_OUT = "allowed is no link, no password, no path outside, only a deflated file of at most 20 MB"
FLAT = re.compile(r"(?P<student>.+?)(_LATE)?_(?P<number>\d+)_(\d+|assignsubmission_file)_(?P<file>.+)")
# A file that is handed in or downloaded again: swinging-1.py, "swinging (1).py".
AGAIN = re.compile(r"(?: ?\(|-)(\d{1,9})(?!\d)\)?(?=[-() \d]*\.py$)")


def submissions_in(folder) -> tuple[dict[str, dict[str, Path]], list[str]]:
    """Return the submissions by student, each {"": a folder or a .zip} or {name: a file}, and the names of the rest.

    Raises a ValueError with one line if the folder is a project, or has no submission; an OSError if it cannot be read.
    """
    found: dict[str, dict[str, Path]] = defaultdict(dict)
    paths = [path for path in sorted(Path(folder).iterdir()) if path.name not in SKIPPED and path.name[0] != "."]
    flat = {path: match for path in paths if not path.is_dir() and (match := FLAT.fullmatch(path.name))}
    whole = [path for path in paths if path not in flat and (path.is_dir() or path.suffix.lower() in ARCHIVES)]
    for path in whole:
        student = in_one_line(path.name if path.is_dir() or path.stem in found else path.stem)
        found[student if student not in found else f"{student}_"] = {"": path}
    taken = {*found}
    for path, match in flat.items():
        student, number = match["student"], match["number"]
        others = [each for each in flat.values() if each["student"] == student and each["number"] != number]
        if student in taken or others:
            student += f"_{number}"
        found[in_one_line(student)][match["file"]] = path
    is_project = any((path / file).is_file() for path in (Path(folder), Path(folder) / "src") for file in HANDOUTS)
    if is_project or not found:
        allowed = "a folder with a folder or a .zip for each student, or with files like ann_12_345_swinging.py"
        raise ValueError(f"found '{folder}', allowed is {allowed}")
    return dict(found), [path.name for path in paths if path not in flat and path not in whole]


@limited_memory()
def read_submission(paths) -> tuple[dict[str, bytes], list[str]]:
    """Return the files of a submission, by their paths below src/, and the problems with it, each in a sentence."""
    problems, files, entries = [], {}, {}  # entries has, for each path, a function that opens it
    try:
        for name, path in paths.items():
            if not path.is_dir() and not stat.S_ISREG(path.stat().st_mode):
                raise OSError(f"{path.name} is neither a folder nor a plain file")  # a pipe would never end
            file = partial(open, path, "rb")
            entries |= {name: file} if name else in_folder(path) if path.is_dir() else in_zip(file, path.name, problems)
        if not any(PurePosixPath(AGAIN.sub("", name)).name in HANDOUTS for name in entries):
            zips = [name for name in entries if name.lower().endswith(".zip")]
            problems += [f"left out {name}: allowed are at most {MOST_ZIPS} in one" for name in zips[MOST_ZIPS:]]
            for name in zips[:MOST_ZIPS]:
                entries |= {f"{name}/{path}": opens for path, opens in in_zip(entries[name], name, problems).items()}
        files = select(entries, problems)
    except Exception as error:  # also too deep a folder; the class goes on
        problems.append(f"cannot be read: {getattr(error, 'strerror', None) or error}")
    problems[MOST_PROBLEMS:] = ["and more"] * (len(problems) > MOST_PROBLEMS)
    return files, [in_one_line(problem[:MOST_LETTERS]) for problem in problems]


def in_folder(folder) -> dict:
    """Return a function that opens it for each plain file of a folder, by its path. It does not follow links."""
    entries = {}
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(filter(is_own, folders))
        for file in (Path(parent, name) for name in sorted(names)):
            if stat.S_ISREG(file.lstat().st_mode):  # no link, pipe or device
                entries[file.relative_to(folder).as_posix()] = partial(open, file, "rb")
    return entries


def in_zip(opens, name, problems) -> dict:
    """Return a function that opens it for each file of a .zip that can be read, by its path."""
    entries = {}
    try:
        archive = zipfile.ZipFile(opens())
    except Exception as error:  # it can be damaged in many ways; the class goes on
        problems.append(f"{name} is no .zip that can be read: {error}")
        return {}
    for info in archive.infolist():
        path, is_link = PurePosixPath(info.filename.replace("\\", "/")), stat.S_ISLNK(info.external_attr >> 16)
        leads_outside = ":" in str(path) or ".." in path.parts or path.is_absolute()
        is_read = info.compress_type in READ and not info.flag_bits & 1 and info.file_size <= MOST_ZIP
        if leads_outside or is_link or not is_read:
            problems += [f"left out {info.filename}: {LEFT_OUT}"] * (path.suffix in (".py", ".zip"))
        elif not info.is_dir() and all(map(is_own, path.parts[:-1])):
            entries[str(path)] = lambda info=info: BytesIO(archive.read(info))
    return entries


def is_own(folder) -> bool:
    """Return whether a folder of this name can hold the student's work."""
    return folder not in SKIPPED and not folder.startswith(".")


def select(entries, problems) -> dict[str, bytes]:
    """Return the Python files of the folder that has most of the handout's files, best called src."""
    versions = defaultdict(list)
    paths = [path for path in entries if path.endswith(".py")]
    for path in sorted(paths, key=lambda path: [*map(int, AGAIN.findall(path))]):
        versions[PurePosixPath(AGAIN.sub("", path))].append(path)
    folders = Counter(path.parent for path in versions if path.name in HANDOUTS)
    if not folders:
        found = ", ".join([*entries][:4]) + " ..." * (len(entries) > 4) or "nothing"
        problems.append(f"none of the handout's files is there, found: {found}")
        return {}
    best, *others = sorted(folders, key=lambda path: (-folders[path], path.name != "src", len(path.parts), path))
    problems += [f"took {best}, left {other}" for other in others]
    files: dict[str, bytes] = {}
    for path, (*left, newest) in versions.items():
        if path.is_relative_to(best):
            if newest != str(path):
                problems.append(f"took {newest} as {path.name}" + f", left {', '.join(left)}" * bool(left))
            try:
                with entries[newest]() as opened:
                    files[path.relative_to(best).as_posix()] = opened.read(MOST_BYTES + 1)
            except Exception as error:  # the .zip is damaged, or the file cannot be read
                problems.append(f"left out {newest}: {error}")
        if len(files) > MOST_FILES or sum(map(len, files.values())) > MOST_BYTES:
            problems.append(f"too large: allowed are at most {MOST_FILES} Python files with {MOST_BYTES:,} bytes")
            return {}
    for name in (name for name in HANDOUTS if name not in files):
        meant = [each for each in files if each.lower() == name]
        problems.append(f"src/{name} is missing" + f", found '{''.join(meant)}'" * bool(meant))
    return files
