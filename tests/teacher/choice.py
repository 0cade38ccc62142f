"""The choice of the files that count in a submission: most of the handout's are beside them."""

import re
from collections import defaultdict
from collections.abc import Callable
from pathlib import PurePosixPath

from grading.handout import FUNCTIONS

HANDOUTS = sorted({PurePosixPath(function.file).name for function in FUNCTIONS.values()})
MOST_FILES = 200  # Python files of a submission
MOST_BYTES = 1_000_000  # of the Python files of a submission

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
