"""The rule that finds the files of a submission: by the names that the handout gives them.

On the host, submissions_in and pack put together what each student has handed in, and open no
archive. In the container, unpack and choose take the files out that count.
"""

import re
import tarfile
import time
import zipfile
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from io import BytesIO
from pathlib import Path, PurePath, PurePosixPath
from stat import S_ISLNK
from typing import IO, NamedTuple

from grading.assignment import FUNCTIONS, HONOR

CONSTANTS = "support/constants.py"
# The places of the files that count, by their names
HANDOUT = {PurePosixPath(function.file).name: function.file for function in FUNCTIONS.values()}
HANDOUT["visualize_double_cradle_run.py"] = "src/visualize_double_cradle_run.py"
HANDOUT["constants.py"] = CONSTANTS
REQUIRED = dict.fromkeys(role.file for role in FUNCTIONS.values() if role.tier != HONOR)

# How course systems call a file. The first number counts: a student chooses the file's name.
FORM = re.compile(
    r"""
    (?P<name>.+?) (?:_LATE)? (?P<number>_\d+) _  # of the student
    (?:
        (?P<upload>\d{3,}) _            # Canvas: ann_12_345_swinging.py, ann_LATE_12_345_a.zip
        | assignsubmission_ [a-z]+ _?   # Moodle: "Ann A_12_assignsubmission_file_swinging.py"
    )
    (?P<file>.*)  # Moodle's folders end before it
    """,
    re.VERBOSE,
)
ARCHIVE = re.compile(r"(\.tar)?\.(zip|tar|tgz|gz|bz2|xz|7z|rar)$", re.IGNORECASE)
AGAIN = re.compile(r" ?[-(](\d{1,9})\)?(?=\.py$)")  # swinging-1.py, "swinging (1).py"
OF_OTHERS = {"__MACOSX", "site-packages"}  # folders without a student's work
OF_STARTER = {"support", "tests"}  # folders in which only constants.py is a student's

LARGEST = 1_000_000  # bytes of a Python file
MOST_BYTES = 20_000_000  # of all Python files


def submissions_in(folder: Path) -> tuple[dict[str, list[Path]], list[str]]:
    """Return what each student has handed in, and the names of the rest.

    Raises a ValueError with one line if the folder is no class, an OSError if it cannot be read.
    """
    submissions = defaultdict(list)
    rest = []
    paths = sorted(folder.iterdir()) if folder.is_dir() else []
    for path in filter(can_count, paths):
        student, _ = owner_of(path)
        if student:
            submissions[student].append(path)
        else:
            rest.append(path.name)
    is_project = "src" in submissions or not HANDOUT.keys().isdisjoint(rest)
    if is_project or not submissions:
        raise ValueError(
            f"found '{folder}', allowed is a folder with a folder or a .zip for each student, or "
            "with files like ann_12_345_swinging.py"
        )
    return submissions, rest


def owner_of(path: Path) -> tuple[str, str]:
    """Return the student who has handed in a path, or "", and its own name, "" for a folder."""
    form = FORM.fullmatch(path.name)
    archive = ARCHIVE.search(path.name)
    if path.is_symlink():  # it could lead to another student's files
        return "", ""
    if form and not (form["upload"] and path.is_dir()):  # Canvas gives no folders
        return form["name"] + form["number"], form["file"]
    if path.is_dir():
        return path.name, ""
    if archive:
        return path.name[: archive.start()], path.name
    return "", ""


def can_count(path: PurePath) -> bool:
    """Return whether no part of a path is hidden, or a folder of others."""
    hidden = [part for part in path.parts if part.startswith(".") and part != ".."]
    return not hidden and OF_OTHERS.isdisjoint(path.parts)


def pack(paths: list[Path], out: IO[bytes]) -> None:
    """Write what can count as a .tar; a link stays a link. Raises an OSError if this fails."""
    with tarfile.open(fileobj=out, mode="w|") as tar:
        for path in paths:
            _, name = owner_of(path)
            tar.add(path, name or ".", filter=packed)


def packed(entry: tarfile.TarInfo) -> tarfile.TarInfo | None:
    """Return an entry of the .tar, or None if it is left out: a video can have a gigabyte."""
    path = PurePosixPath(entry.name)
    return entry if can_count(path) and (entry.isdir() or is_read(path)) else None


def is_read(path: PurePosixPath) -> bool:
    """Return whether a file is a Python file or an archive."""
    return path.suffix == ".py" or bool(ARCHIVE.search(path.name))


class Member(NamedTuple):
    """A file in an archive. It must be read before the next one."""

    name: str
    size: int  # bytes
    modified: tuple[int, ...]  # the time, from the year to the second
    content: IO[bytes] | None  # None for a link or a device


def members_of_tar(stream: IO[bytes]) -> Iterator[Member]:
    """Yield the files of a .tar, also of a .tar.gz."""
    with tarfile.open(fileobj=stream, mode="r|*") as tar:
        for info in tar:
            if not info.isdir():
                content = tar.extractfile(info) if info.isfile() else None
                yield Member(info.name, info.size, time.localtime(info.mtime)[:6], content)


def members_of_zip(stream: IO[bytes]) -> Iterator[Member]:
    """Yield the Python files of a .zip: the others need not be unpacked."""
    with zipfile.ZipFile(stream) as archive:
        for info in archive.infolist():
            if info.filename.endswith(".py"):
                is_link = S_ISLNK(info.external_attr >> 16)
                content = None if is_link else archive.open(info)
                yield Member(info.filename, info.file_size, info.date_time, content)


class File(NamedTuple):
    """A Python file that was handed in."""

    path: PurePosixPath
    name: str  # without the number of a file that was handed in again
    modified: tuple[int, ...]
    content: bytes


def unpack(stream: IO[bytes], problems: list[str], archive: str = "") -> Iterator[File]:
    """Yield the Python files in what pack has written, and in its archives; name problems.

    archive is the name of such an archive.
    """
    is_zip = archive.lower().endswith(".zip")
    size = 0
    try:
        for member in members_of_zip(stream) if is_zip else members_of_tar(stream):
            # Some programs of Windows write other separators
            path = PurePosixPath(archive, member.name.replace("\\", "/"))
            is_archive = path.suffix != ".py"
            if not can_count(path) or not is_read(path) or (is_archive and archive):
                continue
            if member.content is None:
                problems.append(f"left out {path}: it is a link or a device")
            elif ".." in path.parts:
                problems.append(f"left out {path}: it is outside of the folder")
            elif is_archive:
                yield from unpack(BytesIO(member.content.read()), problems, path.name)
            elif member.size > LARGEST:
                problems.append(f"left out {path}: it has more than {LARGEST:,} bytes")
            else:
                size += member.size
                if size > MOST_BYTES:
                    raise ValueError(f"its Python files have more than {MOST_BYTES:,} bytes")
                name = AGAIN.sub("", path.name)
                yield File(path, name, member.modified, member.content.read())
    except Exception as error:  # it can be damaged in many ways
        problems.append(f"{archive or 'the rest'} cannot be read: {error}")


def choose(files: Iterable[File], problems: list[str]) -> dict[str, bytes]:
    """Return the content of the files that count, by their places in the project; name problems.

    These are the handout's, and the others of the folder in which most of these are.
    """
    chosen: dict[str, File] = {}
    own = [file for file in sorted(files, key=age_of) if is_own(file)]
    for file in own:
        place = HANDOUT.get(file.name)
        if place and (place != CONSTANTS or b"NC_FP" in file.content):  # or it is one's own file
            take(chosen, place, file, problems)
    problems += [f"{place} is missing" for place in REQUIRED if place not in chosen]
    folders = Counter(file.path.parent for file in chosen.values())
    for folder, _ in folders.most_common(1):
        for file in own:
            if file.path.is_relative_to(folder):
                place = f"src/{file.path.relative_to(folder).with_name(file.name)}"
                if place not in HANDOUT.values():
                    take(chosen, place, file, problems)
    return {place: file.content for place, file in chosen.items()}


def age_of(file: File) -> tuple[int, tuple[int, ...]]:
    """Return what is greater for a newer file: the number in its name, and its date."""
    again = AGAIN.search(file.path.name)
    number = int(again[1]) if again else 0
    return number, file.modified


def is_own(file: File) -> bool:
    """Return whether a file can be the student's own, not the starter's."""
    if file.name == "constants.py":
        return True
    return file.name != "pendulum.py" and OF_STARTER.isdisjoint(file.path.parts)


def take(chosen: dict[str, File], place: str, file: File, problems: list[str]) -> None:
    """Take a file for a place of the project; name an older one that it replaces."""
    older = chosen.get(place, file)
    if older.content != file.content:
        problems.append(f"took {file.path} for {place}, left {older.path}")
    chosen[place] = file
