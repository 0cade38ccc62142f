"""A key for each student of a class: a name for files.

On no file system, the files of another student can have the same name.
"""

import re
from collections import Counter
from typing import NamedTuple
from unicodedata import normalize

from support.start.output import in_one_line

REFUSED = re.compile(r'[<>:"/\\|?*]')  # in names of files on Windows
# Names that mean something else there
DEVICES = re.compile(r"(con|prn|aux|nul|com.|lpt.)(\..*)?", re.IGNORECASE)
MOST_BYTES = 100  # of a key without its number: a file system takes 255, an encrypted one 143


class Student(NamedTuple):
    """What the names of files say of a student."""

    short: str  # ann
    full: str  # ann_12 for ann_12_345_swinging.py: two students may be called ann; ann.zip


def keys_of(students) -> dict[Student, str]:
    """Return a key for each student of a class.

    It is the short name or, if two could meet, the full name, with a number if these meet as well.
    It differs from the others also where a file system takes capitals for small letters, or e and
    an accent for one letter.
    """
    counts = Counter(folded(plain(student.short)) for student in students)
    keys = {}
    taken = set()
    for student in students:
        name = plain(student.short)
        if counts[folded(name)] > 1:
            name = plain(student.full)
        key = name
        number = 1
        while folded(key) in taken:
            number += 1
            key = f"{name} ({number})"
        taken.add(folded(key))
        keys[student] = key
    return keys


def plain(name) -> str:
    """Return a name that each file system takes."""
    letters = REFUSED.sub("_", normalize("NFC", in_one_line(name)))
    kept = letters.encode()[:MOST_BYTES].decode(errors="ignore").strip(" .")
    return f"_{kept}" if DEVICES.fullmatch(kept) or not kept else kept


def folded(name) -> str:
    """Return a name without the differences that some file system does not see."""
    return normalize("NFKC", normalize("NFKC", name).casefold())
