"""What main makes a cradle from, and what replaces parts of it."""

from typing import NamedTuple

from support.cradle.collision import Collision
from support.files.cradle_csv import Snapshot


class Settings(NamedTuple):
    """The CSV of a cradle, and the settings that replace parts of it. None is as main makes it."""

    csv: Snapshot
    angles: list[float | None]  # of the release (rad)
    lifted: int | None  # bobs
    collision: Collision
    mass: float | None  # kg, of all pendula
