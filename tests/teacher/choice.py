"""The choice of the files of a submission that are graded: those next to most of the assigned."""

import re
from collections import defaultdict
from collections.abc import Callable
from pathlib import PurePosixPath

from grading.assignment import FUNCTIONS, HONOR

# In the order of the assignment
ASSIGNED = [*dict.fromkeys(PurePosixPath(function.file).name for function in FUNCTIONS.values())]
EXTRA = {PurePosixPath(role.file).name for role in FUNCTIONS.values() if role.tier == HONOR}
MOST_FILES = 200  # of a submission that count
MOST_BYTES = 1_000_000  # of these files
TOO_MUCH = f"allowed are at most {MOST_FILES} files with {MOST_BYTES:,} bytes"
STARTERS_FOLDERS = {"support", "tests"}
CONSTANTS = "support/constants.py"
# The files of the starter outside of src/ that students may change, and what must be in them
MAY_CHANGE = {CONSTANTS: b"NC_FP", "newton_cradle_pends.csv": b""}
FOR_PYTEST = b"conftest.py pyproject.toml"  # files that pytest asks for

# A file that is handed in or downloaded again: swinging-1.py, "swinging (1).py".
AGAIN = re.compile(
    r"""
    (?:[ ]?\(|-) (\d{1,9})(?!\d) \)?    # the number
    (?=[-()\ \d]*\.py$)                 # more of them may follow
    """,
    re.VERBOSE,
)
# How a file is called while iCloud, Nextcloud or a browser downloads it: .swinging.py.icloud.
NOT_DOWNLOADED = re.compile(r"cloudf?$|download$|\.part$")
WORD = re.compile(r"\w+")

# A function for each file of a submission that opens it, by the path of the file.
Entries = dict[str, Callable]


def is_python(path) -> bool:
    """Return whether a file is a Python file, and not hidden."""
    return path.suffix.casefold() == ".py" and not path.name.startswith(".")


def meant(path) -> str:
    """Return the file of src/ that a file is, or may be meant for: "Copy of swinging.py".

    Return "" if it is none.
    """
    for file in ("visualize_double_cradle_run.py", *ASSIGNED):
        if file.removesuffix(".py") in path.name.casefold():
            return file
    return ""


def select(entries: Entries, starter, problems) -> dict[str, bytes]:
    """Return the files that count, by their paths in the project.

    These are the Python files of the folder that has most of the assignment's files, and all others
    that they ask for. starter has the starter's files in the same form.
    """
    paths = [*map(PurePosixPath, entries)]
    own = [path for path in paths if not STARTERS_FOLDERS & {*path.parts}]
    src = best_folder([*filter(is_python, own)], problems)
    if src is None:
        problems.append(f"none of the assignment's files is there{found(paths)}")
        return {}
    python = [path for path in own if is_python(path) and path.is_relative_to(src)]
    sources = newest(python, problems)
    for name in ASSIGNED:
        if src / name not in sources:
            similar = [path for path in own if meant(path) == name]
            add_candidate(sources, src / name, similar, problems)
    to_read = []
    for path in sorted(sources, key=lambda path: [*ASSIGNED, path.name].index(path.name)):
        to_read.append((f"src/{path.relative_to(src)}", f"{sources[path]}", ""))
    others = others_around(src, sorted({*paths} - {*python}))
    to_read += asked_for("pytest", FOR_PYTEST, others)
    files = read(entries, to_read, others, starter, problems)
    constants = files.get("src/constants.py", b"")
    if MAY_CHANGE[CONSTANTS] in constants:  # all files were handed in without folders
        files.setdefault(CONSTANTS, constants)
    problems += odd_files(files, starter)
    return files


def best_folder(paths, problems) -> PurePosixPath | None:
    """Return the folder with most of the assignment's files.

    Of two, it is the one with the higher numbers in its path.
    """
    exact = [path for path in paths if AGAIN.sub("", path.name) in ASSIGNED]
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


def add_candidate(sources, missing, similar, problems) -> None:
    """Add the only one of these files that may be meant for an assigned file that is missing.

    If there are several, name all. If there is none, nothing is said of a file of the honor roll.
    """
    neighbours = [path for path in similar if is_python(path) and path.parent == missing.parent]
    if len(neighbours) == 1:
        sources[missing] = neighbours[0]
        problems.append(f"took {neighbours[0]} as {missing.name}")
    elif similar or missing.name not in EXTRA:
        problems.append(f"src/{missing.name} is missing{found(similar)}")


def found(paths) -> str:
    """Return the names of the first files, as the end of a sentence."""
    names = ""
    for path in paths[:4]:
        names += f", found {path}"
        if NOT_DOWNLOADED.search(path.name):
            names += " (not downloaded yet)"
    return names


def others_around(src, paths) -> dict[str, str]:
    """Return those of these files that are in the project around a folder, by their paths there.

    If the folder is not called src, it may be src/ and the project's folder in one.
    """
    root = src.parent if src.name.casefold() == "src" else src
    below = f"{root}/".removeprefix("./")
    others = {}
    for path in map(str, paths):
        if path.startswith(below):
            place = path.removeprefix(below)
            others[place] = path
            if root == src and "/" not in place:
                others[f"src/{place}"] = path
    return others


def asked_for(file, content, others) -> list[tuple[str, str, str]]:
    """Take those of the other files out that a file with this content asks for; return them.

    It does so if it has all words of their path. Each has its path, its entry, and who asks for it.
    """
    words = {*WORD.findall(f"{file} {content.decode(errors='replace')} __init__")}
    taken = []
    for place in [*others]:
        if words.issuperset(WORD.findall(place.removesuffix(".py"))):
            taken.append((place, others.pop(place), f", which {file} asks for"))
    return taken


def read(entries: Entries, to_read, others, starter, problems) -> dict[str, bytes]:
    """Return the content of the files that are graded: of those to read, and those that they ask
    for."""
    files: dict[str, bytes] = {}
    room = MOST_BYTES
    for place, source, why in to_read:
        try:
            if len(files) == MOST_FILES:
                raise ValueError(TOO_MUCH)
            with entries[source]() as opened:
                content = opened.read(room + 1)
            if len(content) > room:
                raise ValueError(TOO_MUCH)
            if may_count(place, content, starter):
                files[place] = content
                room -= len(content)
                to_read += asked_for(place, content, others)
            elif content.splitlines() != starter.get(place, b"").splitlines():
                raise ValueError("it is not the starter's")
        except Exception as error:  # also if the .zip is damaged, or the file cannot be read
            problems.append(f"left out {source}{why}: {error}")
    return files


def may_count(place, content, starter) -> bool:
    """Return whether a file with this content may be at this place of the project."""
    if place in MAY_CHANGE:
        return MAY_CHANGE[place] in content
    if place in starter:
        return place.startswith("src/")
    return not place.startswith("tests/")


def odd_files(files, starter) -> list[str]:
    """Return a problem for each file of the assignment that has none of its functions.

    A file as in the starter is one, too, if a later one is not, or if all are.
    """
    problems = []
    unchanged = []
    is_changed = False
    for file, content in files.items():
        names = [name.encode() for name, function in FUNCTIONS.items() if function.file == file]
        # Without the mark of the encoding, and also in UTF-16
        text = content.replace(b"\0", b"").lstrip(b"\xef\xbb\xbf\xff\xfe").strip()
        code = re.sub(rb"(?m)^\s*#.*", b"", text)
        if names and content.splitlines() == starter[file].splitlines():
            unchanged.append(f"{file} is as in the starter")
        elif names:
            is_changed = True
            problems += unchanged
            unchanged = []
            if not text:
                problems.append(f"{file} is empty")
            elif not any(name in code for name in names):
                begin = text[:60].decode(errors="replace").splitlines()[0]
                problems.append(f"{file} has none of its functions, and begins with '{begin}'")
    return problems if is_changed else unchanged
