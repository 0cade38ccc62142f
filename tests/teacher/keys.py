"""A key for each student of a class: a name for files that no other student has."""

from collections import Counter
from typing import NamedTuple

from support.start.output import in_one_line


class Student(NamedTuple):
    """What the names of files say of a student."""

    short: str  # ann
    full: str  # ann_12 for ann_12_345_swinging.py: two students may be called ann; ann.zip


def keys_of(students) -> dict[Student, str]:
    """Return a key for each student of a class.

    It is the short name or, if two share it, the full name, with a number if these are equal as
    well. Some file systems take capitals for small letters: so do these comparisons.
    """
    counts = Counter(student.short.casefold() for student in students)
    keys = {}
    taken = set()
    for student in students:
        name = in_one_line(student.short)
        if counts[student.short.casefold()] > 1:
            name = in_one_line(student.full)
        key = name
        number = 1
        while key.casefold() in taken:
            number += 1
            key = f"{name} ({number})"
        taken.add(key.casefold())
        keys[student] = key
    return keys
