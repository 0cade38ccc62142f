"""What a program makes a cradle from, and how the cradle is released."""

from typing import Any, NamedTuple

from support.files.experiments import Experiment, Hidden
from support.files.valid_cradle import CradleCsv


class Settings(NamedTuple):
    """The CSV of a cradle, and its release. None is as the program makes it."""

    csv: CradleCsv
    angles: list[float | None]  # of the release (rad)
    lifted: int | None  # bobs
    # Of each pendulum's cords, from straight down (rad), in place of angles and lifted
    poses: list[list[float]] | None = None
    hidden: Hidden | None = None  # nothing shows it
    separating: bool = False  # whether separating bobs collide, too


def settings_of(experiment: Experiment) -> Settings:
    """Return the settings that make the cradle of an experiment."""
    angles: list[float | None] = [None] * len(experiment.poses[0])
    poses, hidden = experiment.poses, experiment.hidden
    return Settings(experiment.csv, angles, None, poses, hidden)


class NextCradle:
    """The settings of the cradle that the program makes next, and whether it must make it now."""

    def __init__(self, settings: Settings):
        """Let the program make a cradle with these settings, as soon as it begins."""
        self.settings = settings
        self.is_wanted = True

    def want(self, **changed: Any) -> None:
        """Let the program run again, maybe with changed settings."""
        self.settings = self.settings._replace(**changed)
        self.is_wanted = True
