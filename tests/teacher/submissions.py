"""The submissions of a class, in the forms in which course systems hand them out.

A student has a folder, a .zip, or files beside those of the others: Canvas names them
ann_12_345_swinging.py, and Moodle Ann A_12_assignsubmission_file_swinging.py. Only the Python files
of src/ count, wherever they lie.
"""

import os
import re
import stat
import zipfile
from collections import defaultdict
from collections.abc import Callable
from functools import partial
from io import BytesIO
from pathlib import Path, PurePosixPath

from grading.handout import FUNCTIONS
from grading.limits import limited_memory
from support.start.output import in_one_line
from teacher.keys import keys_of, Student

HANDOUTS = sorted({PurePosixPath(function.file).name for function in FUNCTIONS.values()})
# Folders that are not the student's work, or that the graded starter has itself.
SKIPPED = {"__MACOSX", "__pycache__", "node_modules", "site-packages", "support", "tests", "venv"}
ARCHIVES = (".zip", ".7z", ".bz2", ".gz", ".rar", ".tar", ".tgz", ".xz")
MOST_FILES = 200  # Python files of a submission
MOST_BYTES = 1_000_000  # of the Python files of a submission
MOST_ZIPS = 4  # in another one or in a folder
MOST_ZIP = 20_000_000  # bytes of a file in a .zip
MOST_LIST = 5_000_000  # bytes of the list of files in a .zip; a project with its .venv has 3 MB
MOST_MEMORY = 200  # MB to read a submission
MOST_PATH = 250  # letters of a path in a submission
MOST_PROBLEMS = 8  # of a submission
MOST_LETTERS = 200  # of a problem
# With other methods, a few bytes can take all memory
READ = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED
LEFT_OUT = "allowed is no link, no password, no path outside, only a deflated file of at most 20 MB"
TOO_LONG = f"allowed is a path of at most {MOST_PATH} letters"

# These names are read from their end, because a student can choose the beginning. Canvas writes the
# student's name, the student's number, a number of the file, and the file's own name.
CANVAS = re.compile(r"(?P<student>.+)_(?P<number>\d+)_\d+_(?P<file>.+)")
# Moodle puts the name and a number before it. Its folders have such names, too, and an online text
# is one more.
MOODLE = re.compile(
    r"(?P<student>.+)_(?P<number>\d+)_assignsubmission_(file|onlinetext)_?(?P<file>.*)"
)
# A file that is handed in or downloaded again: swinging-1.py, "swinging (1).py".
AGAIN = re.compile(
    r"""
    (?:[ ]?\(|-) (\d{1,9})(?!\d) \)?    # the number
    (?=[-()\ \d]*\.py$)                 # more of them may follow
    """,
    re.VERBOSE,
)

# A function for each file of a submission that opens it, by the path of the file.
Entries = dict[str, Callable]


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


def entries_of(paths, problems) -> Entries:
    """Return the entries of a submission, and those of .zips in it."""
    entries: Entries = {}
    for name, path in paths:
        if path.is_dir():
            entries |= in_folder(path, problems)
        elif not stat.S_ISREG(path.stat().st_mode):
            # A pipe would never end
            raise OSError(f"{path.name} is neither a folder nor a plain file")
        elif name:
            entries[name] = partial(open, path, "rb")
        else:
            entries |= in_zip(partial(open, path, "rb"), path.name, problems)
    if not any(meant(PurePosixPath(name)) for name in entries):
        zips = [name for name in entries if name.lower().endswith(".zip")]
        for name in zips[MOST_ZIPS:]:
            problems.append(f"left out {name}: allowed are at most {MOST_ZIPS} in one")
        for name in zips[:MOST_ZIPS]:
            for path, opens in in_zip(entries[name], name, problems).items():
                entries[f"{name}/{path}"] = opens
    return entries


def in_folder(folder, problems) -> Entries:
    """Return the entries of the plain files of a folder. It does not follow links."""
    entries: Entries = {}
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(filter(is_own, folders))
        for name in sorted(names):
            file = Path(parent, name)
            path = file.relative_to(folder).as_posix()
            if len(path) > MOST_PATH:
                problems.append(f"left out {path[-50:]}: {TOO_LONG}")
            elif stat.S_ISREG(file.lstat().st_mode):  # no link, pipe or device
                entries[path] = partial(open, file, "rb")
    return entries


def in_zip(opens, name, problems) -> Entries:
    """Return the entries of the files of a .zip that can be read. opens opens the .zip."""
    entries: Entries = {}
    try:
        file = opens()
        if isinstance(file, zipfile.ZipExtFile):  # it lies in another one, and is read in any order
            file = BytesIO(file.read(MOST_ZIP))
        if list_size(file) > MOST_LIST:
            raise ValueError(f"its list of files has more than {MOST_LIST:,} bytes")
        archive = zipfile.ZipFile(file)
    except Exception as error:  # it can be damaged in many ways; the class goes on
        problems.append(f"{name} is no .zip that can be read: {error}")
        return {}
    for info in archive.infolist():
        if len(info.filename) > MOST_PATH:
            problems.append(f"left out {info.filename[-50:]}: {TOO_LONG}")
            continue
        path = PurePosixPath(info.filename.replace("\\", "/"))
        if not can_be_read(info, path):
            if path.suffix in (".py", ".zip"):
                problems.append(f"left out {info.filename}: {LEFT_OUT}")
        elif not info.is_dir() and all(map(is_own, path.parts[:-1])):
            entries[str(path)] = partial(archive.open, info)
    return entries


def can_be_read(info: zipfile.ZipInfo, path: PurePosixPath) -> bool:
    """Return whether a file of a .zip is a plain one, inside of it, and not too large."""
    leads_outside = ":" in str(path) or ".." in path.parts or path.is_absolute()
    is_link = stat.S_ISLNK(info.external_attr >> 16)
    has_password = info.flag_bits & 1
    if leads_outside or is_link or has_password:
        return False
    return info.compress_type in READ and info.file_size <= MOST_ZIP


def list_size(file) -> int:
    """Return how many bytes the list of files in a .zip has, before all of it is read.

    The end of a .zip says so. It can be in several places: the largest list counts. That of a .zip
    of 64 bits always is too large.
    """
    size = file.seek(0, os.SEEK_END)
    file.seek(max(0, size - 2**16 - 100))
    last = file.read()
    if b"PK\6\7" in last:
        return MOST_LIST + 1
    sizes = [0]
    for end in re.finditer(b"PK\5\6", last):
        sizes.append(int.from_bytes(last[end.start() + 12 : end.start() + 16], "little"))
    return max(sizes)


def is_own(folder) -> bool:
    """Return whether a folder of this name can hold the student's work."""
    return folder not in SKIPPED and not folder.startswith(".")


def meant(path) -> str:
    """Return the handout's file that a file is, or may be meant for: "Copy of swinging.py".

    Return "" if it is none.
    """
    name = path.name.casefold()
    if name.endswith(".py"):
        for file in HANDOUTS:
            if file.removesuffix(".py") in name:
                return file
    return ""


def select(entries: Entries, problems) -> dict[str, bytes]:
    """Return the Python files of the folder that has most of the handout's files."""
    paths = [path for path in map(PurePosixPath, entries) if path.suffix.casefold() == ".py"]
    best = best_folder(paths, problems)
    if best is None:
        found = ", ".join([*entries][:4]) or "nothing"
        more = " ..." if len(entries) > 4 else ""
        problems.append(f"none of the handout's files is there, found: {found}{more}")
        return {}
    taken = newest([path for path in paths if path.is_relative_to(best)], problems)
    for name in HANDOUTS:
        if best / name not in taken:
            add_candidate(taken, best, name, problems)
    files: dict[str, bytes] = {}
    for path, source in taken.items():
        try:
            with entries[str(source)]() as opened:
                files[path.relative_to(best).as_posix()] = opened.read(MOST_BYTES + 1)
        except Exception as error:  # the .zip is damaged, or the file cannot be read
            problems.append(f"left out {source}: {error}")
        if len(taken) > MOST_FILES or sum(map(len, files.values())) > MOST_BYTES:
            allowed = f"at most {MOST_FILES} Python files with {MOST_BYTES:,} bytes"
            problems.append(f"too large: allowed are {allowed}")
            return {}
    return files


def best_folder(paths, problems) -> PurePosixPath | None:
    """Return the folder with most of the handout's files.

    Of two, it is the one with the higher numbers in its path.
    """
    exact = [path for path in paths if AGAIN.sub("", path.name) in HANDOUTS]
    files = defaultdict(set)
    for path in exact or filter(meant, paths):
        files[path.parent].add(meant(path))

    def rank(folder):
        # "Version 2" is newer
        numbers = [-int(number) for number in re.findall(r"\d{1,9}", str(folder))]
        return -len(files[folder]), numbers or [0], folder.name != "src", len(folder.parts), folder

    folders = sorted(files, key=rank)
    if not folders:
        return None
    problems += [f"took {folders[0]}, left {other}" for other in folders[1:]]
    return folders[0]


def newest(paths, problems) -> dict[PurePosixPath, PurePosixPath]:
    """Return the newest version of each file, by the path without the numbers of versions."""
    versions = defaultdict(list)
    for path in sorted(paths, key=lambda path: [*map(int, AGAIN.findall(path.name))]):
        versions[path.with_name(AGAIN.sub("", path.name))].append(path)
    found = {}
    for path, sources in versions.items():
        found[path] = sources[-1]
        if found[path] != path:
            older = ", ".join(map(str, sources[:-1]))
            left = f", left {older}" if older else ""
            problems.append(f"took {found[path]} as {path.name}{left}")
    return found


def add_candidate(taken, folder, name, problems) -> None:
    """Take the only file that may be meant for this file of the handout, which is missing.

    If there are several, name them.
    """
    candidates = []
    for path, source in taken.items():
        if path.parent == folder and meant(path) == name:
            candidates.append(source)
    if len(candidates) == 1:
        taken[folder / name] = candidates[0]
        problems.append(f"took {candidates[0]} as {name}")
    else:
        names = " and ".join(f"'{path.name}'" for path in candidates)
        found = f", found {names}" if names else ""
        problems.append(f"src/{name} is missing{found}")
