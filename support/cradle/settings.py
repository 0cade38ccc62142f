"""What main makes a cradle from, and what replaces parts of it."""

from collections.abc import Callable
from typing import Any, NamedTuple

from support.files.experiments import Experiment, Hidden
from support.files.valid_cradle import CradleCsv


class Source(NamedTuple):
    """A function that returns pendula, and its arguments behind the path of the CSV."""

    make: Callable
    arguments: tuple[float, ...] = ()


class Settings(NamedTuple):
    """The CSV of a cradle, and the settings that replace parts of it. None is as main makes it."""

    csv: CradleCsv
    angles: list[float | None]  # of the release (rad)
    lifted: int | None  # bobs
    e_source: Source | None  # of pendula with the e of all
    mass: float | None  # kg, of all pendula
    # Of each pendulum's cords, from straight down (rad), in place of angles and lifted
    poses: list[list[float]] | None = None
    hidden: Hidden | None = None  # nothing shows it


def settings_of(experiment: Experiment) -> Settings:
    """Return the settings that make the cradle of an experiment."""
    angles: list[float | None] = [None] * len(experiment.poses[0])
    poses, hidden = experiment.poses, experiment.hidden
    return Settings(experiment.csv, angles, None, None, None, poses, hidden)


class NextCradle:
    """The settings of the cradle that the loop makes next, and whether it must make it now."""

    def __init__(self, settings: Settings, separating: bool):
        """Let the loop make a cradle with these settings, as soon as it begins."""
        self.settings = settings
        self.separating = separating  # whether separating bobs collide, too
        self.is_wanted = True

    def want(self, **changed: Any) -> None:
        """Let the loop end, and make a new cradle, maybe with changed settings."""
        self.settings = self.settings._replace(**changed)
        self.is_wanted = True
