"""What a check compares, and what a sentence is about: the English is made from these objects."""

from typing import Any, NamedTuple, TypeAlias

RESULT = "The result"

OBJECTS = "axle", "bob", "cord"  # of a pendulum, in this order; a double one has bob1, too
# The attribute of an object that a key means, by its first word, which is the attribute otherwise
ATTRIBUTES = {"position": "pos", "end": "pos"}


class Subject(NamedTuple):
    """A value: that of a key of an owner, the owner itself, or a value with a name of its own.

    Subject("theta", "pend_list", 0) is theta of pend_list[0], Subject(owner="pend_list") is
    pend_list, and Subject("momentum") the momentum. The owner can be an object, as in
    Subject("color", "bob", 0), or the key names one: Subject("radius of the bob", "pend1").
    """

    key: str = ""
    owner: str = ""
    list_index: int | None = None  # of the owner, if it is in a list

    def __str__(self) -> str:
        whole = self.owner if self.list_index is None else f"{self.owner}[{self.list_index}]"
        return f"{self.key} of {whole}" if self.key and whole else self.key or whole

    @property
    def object_name(self) -> str:
        """The object that has the attribute, such as "bob" or "cord2", or ""."""
        name = self.key.partition(" of the ")[2] or self.owner
        return name if name.startswith(OBJECTS) else ""

    @property
    def attribute(self) -> str:
        """The attribute of an object, such as "pos"; "" for a key of a dictionary."""
        word = self.key.partition(" ")[0]
        return ATTRIBUTES.get(word, word) if self.object_name else ""

    def element(self, i: int) -> "Subject":
        """Return the subject of an element, which has no name of its own."""
        return self

    def value(self, key: str) -> "Subject":
        """Return the subject of the value of a key."""
        return Subject(key, self.owner, self.list_index)


class Several(NamedTuple):
    """The parts of a tuple or a list, each with its own subject, and a name for all of them."""

    parts: tuple[Any, ...]
    name: str = ""

    def __str__(self) -> str:
        return self.name or ", ".join(map(str, self.parts))

    def element(self, i: int) -> Any:
        """Return the subject of a part."""
        return self.parts[i]


class Each(NamedTuple):
    """These keys of each element of a list; the elements themselves, if there are none."""

    keys: tuple[str, ...]
    owner: str = "pend_list"
    name: str = ""  # of all of them

    def __str__(self) -> str:
        if self.name:
            return self.name
        each = "each pendulum" if self.owner == "pend_list" else f"each {self.owner}"
        return f"{' and '.join(self.keys)} of {each}" if self.keys else each

    def element(self, i: int) -> Subject | Several:
        """Return the subject of an element."""
        parts = tuple(Subject(key, self.owner, i) for key in self.keys or [""])
        return Several(parts) if len(parts) > 1 else parts[0]


What: TypeAlias = Subject | Several | Each
NOTHING = Subject()  # if a sentence is about no value


def result_of(returns: str) -> What:
    """Return what a function returns, from the names of its parts."""
    names = returns.split(", ")
    if len(names) == 1:
        return Each((), returns, RESULT)
    return Several(tuple(map(Subject, names)), RESULT)
