"""What a sentence of the grader is about: a pendulum, a value of it, an object, or a result.

The suites name what they compare. Only this module takes such a name apart:

    theta of pend1                  a value of a pendulum
    omega of each pendulum          a list, with a value of each pendulum of pend_list
    color and texture of each bob   a list of pairs
    the value of objects in each pendulum
                                    the values of a key, judged together
    new_omega, new_theta            the parts of a tuple
    masses of the first cradle      anything else is one value with these words
"""

import re
from typing import NamedTuple

RESULT = "The result"  # the name of a whole result

# The names of elements, and the name of the list that has them.
ELEMENTS = {"each pendulum": "pend_list", "each axle": "axle", "each bob": "bob"}
# The names of values, for one pendulum or for one object.
OF_PENDULUM = re.compile(r"(?:(?P<value>\w+) of )?(?P<owner>pend\w*)(?:\[\d+\])?")
OF_OBJECT = re.compile(
    r"(?P<value>\w+).* of (?:the )?(?P<owner>axle|bob|cord)(?: of pend_list)?\[\d+\]"
)
OF_EACH = re.compile(r"the value of (?P<value>\w+) in (?P<owner>each pendulum)")
INDEX = re.compile(r"\b(?:pend_list|axle|bob)\[(\d+)\]")


class Subject(NamedTuple):
    """What a sentence is about."""

    name: str = ""  # in the sentence: "theta of pend_list[0]", "position of bob[2]"
    value: str = ""  # of the owner: "theta", "position"; "" if it is the whole owner
    owner: str = ""  # "pend1", "pend_list", "each pendulum", "axle", "bob" or "cord"
    list_index: int | None = None  # 2 of pend_list[2], axle[2] or bob[2]
    has_wrong_keys: bool = False  # of a pendulum

    @property
    def is_of_pendulum(self) -> bool:
        return self.owner.startswith("pend")

    @property
    def pend(self) -> str:
        """The name of the pendulum."""
        return self.owner if self.list_index is None else f"{self.owner}[{self.list_index}]"

    @property
    def is_result(self) -> bool:
        """Whether it is the whole result."""
        return self.name == RESULT

    def is_part(self, name: str) -> bool:
        """Return whether it is this part of a result, or a value of this part."""
        return self.name == name or (not self.has_wrong_keys and self.name.endswith(f" of {name}"))


NOTHING = Subject()  # if a sentence is about no value


def subject_of(name: str, has_wrong_keys: bool = False) -> Subject:
    """Return the subject with this name."""
    index = INDEX.search(name)
    value = owner = ""
    for pattern in (OF_PENDULUM, OF_OBJECT, OF_EACH):
        found = pattern.fullmatch(name)
        if found:
            value = found["value"] or ""
            owner = found["owner"]
            break
    return Subject(name, value, owner, int(index[1]) if index else None, has_wrong_keys)


def whole_of(name: str, is_result: bool) -> str:
    """Return the name of a whole value, which may have parts with names; or that of a result."""
    return RESULT if is_result or ", " in name else name


def list_of(name: str, is_result: bool) -> str:
    """Return the name of what has as many elements as the value with this name."""
    return "pend_list" if name.endswith("each pendulum") else whole_of(name, is_result)


def verb_of(name: str) -> str:
    """Return the verb for the name of a value: ends are, and omega and theta are."""
    return "are" if re.match(r"ends |[^,]* and ", name) else "is"


def parts_of(name: str, count: int) -> list[str]:
    """Return the names of the elements: "theta of pend_list[0]" for "theta of each pendulum"."""
    for elements, whole in ELEMENTS.items():
        if elements in name:
            return [name.replace(elements, f"{whole}[{i}]") for i in range(count)]
    names = name.split(", ")
    if len(names) == count > 1:
        return names
    first, of, owner = name.partition(" of ")
    names = first.split(" and ")
    if len(names) == count > 1:
        return [value + of + owner for value in names]
    if " " in name:
        return [name] * count
    return [f"{name}[{i}]" for i in range(count)]
