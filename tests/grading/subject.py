"""What a sentence of the grader is about: a pendulum, a value of it, an object, or a result."""

import re
from typing import NamedTuple

RESULT = "The result"  # the name of a whole result

# The names of values in the suites, for one pendulum or for one object.
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
    pend_index: int | None = None  # of the pendulum in pend_list
    has_wrong_keys: bool = False  # of a pendulum

    @property
    def is_of_pendulum(self) -> bool:
        return self.owner.startswith("pend")

    @property
    def pend(self) -> str:
        """The name of the pendulum."""
        return self.owner if self.pend_index is None else f"{self.owner}[{self.pend_index}]"

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
