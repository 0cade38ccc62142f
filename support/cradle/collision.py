"""How bobs collide: with the e of their CSV, or with that of other pendula."""

from collections.abc import Callable
from typing import NamedTuple


class Source(NamedTuple):
    """A function that returns pendula, and its arguments behind the path of the CSV."""

    make: Callable
    arguments: tuple[float, ...] = ()


class Collision(NamedTuple):
    """A way for bobs to collide: its name, and a source of pendula with its e."""

    name: str
    source: Source | None = None  # None keeps each pendulum's own e


AS_MADE = Collision("as in the CSV")


def name_with(e: float) -> str:
    """Return the name of the way to collide in which all pendula have this e."""
    if e == 1:
        return "elastic, e = 1"
    if e == 0:
        return "perfectly inelastic, e = 0"
    return f"e = {e:g}"
