"""What goes between the judge and a solver: plain data as JSON, and what both of them have, by number.

A list, dictionary, vector or shape has a number on both sides. With each message go the contents of those that have
changed: the other side changes its own in place, so what was one object stays one object. Anything else is there on one
side only; the other side has a stand-in with its type and short text.
"""

from dataclasses import dataclass
from itertools import count
from numbers import Integral, Real
from operator import attrgetter
from pathlib import Path

from vpython import box, cylinder, sphere, vector

from support.start.output import in_one_line

SHAPES = {"box": box, "sphere": sphere, "cylinder": cylinder}
vectors_of = attrgetter("_pos", "_axis", "_up", "_size", "_color")
values_of = attrgetter("texture", "visible", "shininess", "opacity")
MOST_TEXT, MOST_PRINTED = 2000, 20_000  # characters of the text of a stand-in, and of what a call prints
MOST_KEYS = 5000  # of a dictionary: with equal hashes, they take quadratic time
MOST_BITS = 1000  # of a whole number


@dataclass(eq=False)
class File:
    """A file whose path is an argument."""

    path: Path
    given: str  # the argument
    name: str  # with a / in front if the argument is absolute


class Crossing:
    """One side's view of what both sides have."""

    def __init__(self, first):
        """first is 0 for one side, and 1 for the other one: they give different numbers."""
        self.free = count(first, 2)
        self.objects: dict[int, object] = {}
        self.numbers: dict[int, int] = {}  # by id; objects keeps them from being another object's
        self.known: dict[int, list] = {}  # the contents as they last went across

    def letter(self, value) -> list:
        """Return a value in the form that goes across, and the contents that the other side does not have."""
        packed, news, done = self.pack(value), [], set()
        while left := self.objects.keys() - done:  # the content of one may bring in others
            done |= left
            for number in left:
                content = self.content(self.objects[number], number)
                if self.known.get(number) != content:
                    self.known[number] = content
                    news.append([number, content])
        return [packed, news]

    def open(self, letter):
        """Return the value in a letter of the other side; raise an error if it has another form."""
        packed, news = letter
        for number, content in news:
            if number not in self.objects:
                self.keep(int(number), self.made(*content))
        for number, content in news:
            self.fill(self.objects[number], *content)
            self.known[number] = content
        return self.unpack(packed)

    def pack(self, value):
        """Return a value without the contents of its objects."""
        if type(value) in (float, bool, type(None)):
            return value
        if isinstance(value, str):
            return str.__str__(value)
        if isinstance(value, tuple):
            return {"tuple": [*map(self.pack, value)]}
        if id(value) not in self.numbers:
            if isinstance(value, Integral) and int(value).bit_length() < MOST_BITS:
                return int(value)
            if isinstance(value, Real) and not isinstance(value, Integral):
                return float(value)
            self.keep(next(self.free), value)
        return {"number": self.numbers[id(value)]}

    def unpack(self, packed):
        """Return the value that pack has packed on the other side."""
        if not isinstance(packed, dict):
            return packed
        if "number" not in packed:
            return tuple(map(self.unpack, packed["tuple"]))
        found = self.objects[packed["number"]]
        return found.given if isinstance(found, File) else found

    def keep(self, number, value) -> None:
        self.objects[number], self.numbers[id(value)] = value, number

    def content(self, value, number) -> list:
        """Return the content of an object in the form that goes across."""
        if isinstance(value, list):
            return ["list", [*map(self.pack, value)]]
        if isinstance(value, dict):
            return ["dict", [[self.pack(key), self.pack(part)] for key, part in value.items()]]
        if isinstance(value, vector):
            return ["vector", [value._x, value._y, value._z]]
        for name, kind in SHAPES.items():
            if isinstance(value, kind):
                vectors = [number for v in vectors_of(value) for number in (v._x, v._y, v._z)]
                return [name, vectors, *map(self.pack, values_of(value))]
        if isinstance(value, File):
            return ["file", value.name, value.path.read_bytes().decode("latin-1") if value.path.is_file() else None]
        if hasattr(type(value), "METHODS"):
            return ["page", repr(value), [*value.METHODS]]
        return self.known.get(number) or ["other", type(value).__name__, text_of(value)]

    def made(self, kind, *parts):
        """Return a new object for a content, still without it."""
        if kind == "other":
            return stand_in(*parts)
        return {"list": list, "dict": dict, "vector": lambda: vector(0, 0, 0), **SHAPES}[kind]()

    def fill(self, value, kind, *parts) -> None:
        """Give an object this content."""
        if kind == "list":
            list.__setitem__(value, slice(None), [*map(self.unpack, parts[0])])
        elif kind == "dict":
            if len(parts[0]) > MOST_KEYS:
                raise ValueError("too many keys")
            pairs = [(self.unpack(key), self.unpack(part)) for key, part in parts[0]]
            dict.clear(value)
            dict.update(value, pairs)
        elif kind == "vector":
            value.value = vector(*parts[0])
        elif kind in SHAPES:
            numbers = [*map(float, parts[0])]
            for i, v in enumerate(vectors_of(value)):
                v._x, v._y, v._z = numbers[3 * i : 3 * i + 3]
            value.texture, value.visible, value.shininess, value.opacity = map(self.unpack, parts[1:])
        elif kind == "file" and parts[1] is None:
            value.path.unlink(missing_ok=True)
        elif kind == "file":
            value.path.write_bytes(parts[1].encode("latin-1"))


def text_of(value) -> str | None:
    """Return the short text of a value, or None if it has none."""
    try:
        return str(repr(value))[:MOST_TEXT]
    except Exception:
        return None


def bounded(text) -> str:
    """Return the beginning of a text, with letters that every file and terminal takes."""
    return "\n".join(map(in_one_line, str.__str__(text)[:MOST_TEXT].split("\n")))


def stand_in(name, text):
    """Return a stand-in for an object of the other side, with the name of its type and its text."""
    return type(bounded(name), (), {"__repr__": lambda _: bounded(text)})()  # repr raises a TypeError without a text
