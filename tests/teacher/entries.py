"""The files of a submission: in a folder, in a .zip, and in a .zip inside of it."""

import os
import re
import stat
import zipfile
from functools import partial
from io import BytesIO
from pathlib import PurePosixPath

from teacher.choice import Entries, is_python, meant

# Folders that are not the student's work.
SKIPPED = {"__MACOSX", "__pycache__", "node_modules", "site-packages", "venv"}
MOST_ZIPS = 4  # in another one or in a folder
MOST_ZIP = 20_000_000  # bytes of a file in a .zip
MOST_LIST = 5_000_000  # bytes of the list of files in a .zip; a project with its .venv has 3 MB
MOST_PATH = 250  # letters of a path in a submission

# With other methods, a few bytes can take all memory
READ = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED
LEFT_OUT = "allowed is no link, no password, no path outside, only a deflated file of at most 20 MB"
TOO_LONG = f"allowed is a path of at most {MOST_PATH} letters"


def entries_of(paths, problems) -> Entries:
    """Return the entries of a submission, and those of .zips in it."""
    entries: Entries = {}
    again: set[str] = set()
    for name, path in paths:
        opens = partial(open, path, "rb")
        if path.is_dir():
            uploaded = in_folder(path, problems)
        elif not stat.S_ISREG(path.stat().st_mode):
            # A pipe would never end
            raise OSError(f"{path.name} is neither a folder nor a plain file")
        elif name:
            uploaded = {name: opens}
        else:
            uploaded = in_zip(opens, path.name, problems)
        again |= entries.keys() & uploaded.keys()
        entries |= uploaded
    if again:
        problems.append(f"took the newest upload of {', '.join(sorted(again))}")
    if not any(map(meant, filter(is_python, map(PurePosixPath, entries)))):
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
            file = os.path.join(parent, name)
            path = file.removeprefix(f"{folder}{os.sep}").replace(os.sep, "/")
            if len(path) > MOST_PATH:
                problems.append(f"left out {path[-50:]}: {TOO_LONG}")
            elif stat.S_ISREG(os.lstat(file).st_mode):
                entries[path] = partial(open, file, "rb")
            else:
                entries[path] = refuse
    return entries


def refuse():
    """Raise the error of a file that is not opened: a link could lead to another student's."""
    raise OSError("it is a link, a pipe or a device")


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

    The end of a .zip says so. It can be in several places: the largest list is taken. That of a
    .zip of 64 bits always is too large.
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
