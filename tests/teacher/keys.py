"""A key for each student of a class: a name for files.

On no file system, the files of another student can have the same name.
"""

import hashlib
import re
from collections import Counter
from typing import NamedTuple
from unicodedata import normalize

from support.start.output import in_one_line

REFUSED = re.compile(r'[<>:"/\\|?*]')  # in names of files on Windows
# Names that mean something else there
DEVICES = re.compile(r"(con|prn|aux|nul|com.|lpt.)(\..*)?", re.IGNORECASE)
MOST_BYTES = 100  # of a key without its hash: a file system takes 255, an encrypted one 143
WITH_HASH = re.compile(r".*-[0-9a-f]{16}")


class Student(NamedTuple):
    """What the names of files say of a student."""

    short: str  # ann
    full: str  # ann_12 for ann_12_345_swinging.py: two students may be called ann; ann.zip


def keys_of(students) -> dict[Student, str]:
    """Return a key for each student of a class.

    It is the short name or, if two could meet, the full name or a hash of it. A key depends only on
    the students who could meet. It differs from the others also where a file system takes capitals
    for small letters, or e and an accent for one letter.
    """
    counts: Counter[str] = Counter()
    for student in students:
        counts.update({folded(plain(student.short)), folded(plain(student.full))})
    keys = {}
    for student in students:
        full = plain(student.full)
        digest = hashlib.sha256(repr(student).encode()).hexdigest()
        keys[student] = f"{full}-{digest[:16]}"
        for name in (full, plain(student.short)):  # the short one is taken if both are alone
            if counts[folded(name)] == 1 and not WITH_HASH.fullmatch(folded(name)):
                keys[student] = name
    return keys


def plain(name) -> str:
    """Return a name that each file system takes."""
    letters = REFUSED.sub("_", normalize("NFC", in_one_line(name)))
    kept = letters.encode()[:MOST_BYTES].decode(errors="ignore").strip(" .")
    return f"_{kept}" if DEVICES.fullmatch(kept) or not kept else kept


def folded(name) -> str:
    """Return a name without the differences that some file system does not see."""
    return normalize("NFKC", normalize("NFKC", name).casefold())
