"""Read experiments: each is a CSV and a text with the same name; the README in support/experiments has its lines."""

import io
import re
from configparser import ConfigParser, Error
from itertools import accumulate
from math import radians
from pathlib import Path
from typing import NamedTuple

from support.files.cradle_csv import check_cradle, read_cells, read_file, Snapshot, to_number

EXPERIMENTS = Path(__file__).resolve().parents[1] / "experiments"

LONGEST = 60.0  # s from the release to the measurement
MEASURED = re.compile(r"\{(?:energy|(swing|speed|before)_([1-9]\d*))\}")
YOUR_CSV = "your CSV"  # the name in the menu that no experiment can have


class Answer(NamedTuple):
    """An answer to the question of an experiment."""

    text: str
    swings: list[float]  # that it predicts: the angles (degrees) of the bobs, farthest from straight down


class Experiment(NamedTuple):
    """An experiment, ready to run."""

    key: str  # the name of its files
    csv: Snapshot
    name: str
    question: str
    answers: list[Answer]
    explained: int  # the index of the answer that why explains
    why: str
    angles: list[list[float]]  # of each pendulum's cords at the start (rad)
    seconds: float


def read_experiments(folder, cords) -> tuple[list[Experiment], list[str]]:
    """Return the experiments in this folder, sorted by the names of their files, and a line for each bad one.

    cords is the number of cords of a pendulum: 1, or 2 for the double cradle.
    """
    experiments: list[Experiment] = []
    mistakes = []
    files = [file for ending in ("csv", "txt") for file in Path(folder).glob(f"*.{ending}")]
    for path in sorted({file.with_suffix(".csv") for file in files}):
        try:
            experiment = read_experiment(path, cords)
            if experiment.name in [other.name for other in experiments]:
                raise ValueError(
                    f"{path.with_suffix('.txt')}, name: {experiment.name!r} is the name of another experiment"
                )
            experiments.append(experiment)
        except ValueError as error:
            mistakes.append(str(error))
    return experiments, mistakes


def find_experiment(key, folder, cords) -> Experiment:
    """Return the experiment of this folder with this key; raises a ValueError with a one-line message if it is bad."""
    experiments, mistakes = read_experiments(folder, cords)
    for experiment in experiments:
        if experiment.key == key:
            return experiment
    for mistake in mistakes:
        if mistake.startswith(f"{Path(folder, key)}."):
            raise ValueError(mistake)
    allowed = ", ".join(experiment.key for experiment in experiments)
    raise ValueError(f"--experiment: found {key!r}, allowed is one of {allowed}")


def read_experiment(path, cords) -> Experiment:
    """Return the experiment with this CSV; raises a ValueError with a one-line message if it has a mistake."""
    csv = Snapshot(path)
    check_cradle(csv, cords)
    count = len(read_cells(csv)) - 1  # without the header
    file = path.with_suffix(".txt")
    lines = Lines(file)
    if cords == 1 and lines.has("phi"):
        raise ValueError(f"{file}, phi: is allowed only for the double cradle")
    angles = [map(radians, lines.angles(name, count)) for name in ("theta", "phi")[:cords]]
    answers = [Answer(text.lstrip("* "), lines.angles(text, count, "answers")) for text in lines.answers()]
    explained = [number for number, text in enumerate(lines.answers()) if text.startswith("*")]
    if len({answer.text for answer in answers}) < len(answers):
        raise ValueError(f"{file}, [answers]: found an answer twice")
    if not (2 <= len(answers) <= 5 and len(explained) == 1):
        found = f"found {len(answers)} answers, {len(explained)} of them with an asterisk"
        raise ValueError(f"{file}, [answers]: {found}, allowed are 2 to 5, one of them with an asterisk")
    return Experiment(
        key=path.stem,
        csv=csv,
        name=lines.name(),
        question=lines.text("question"),
        answers=answers,
        explained=explained[0],
        why=lines.measured("why", count),
        angles=[[*accumulate(of_pendulum)] for of_pendulum in zip(*angles, strict=True)],
        seconds=lines.seconds(),
    )


class Lines:
    """The lines of an experiment's text file; the methods raise a ValueError with a one-line message."""

    def __init__(self, file):
        """Read the file."""
        self.file, self.parser = file, ConfigParser(delimiters=("=",), comment_prefixes=("#",), interpolation=None)
        self.parser.optionxform = str  # type: ignore[assignment, method-assign]  # capitals stay
        try:
            with io.TextIOWrapper(io.BytesIO(read_file(file)), encoding="utf-8-sig") as text:
                self.parser.read_file(text, file.name)
        except OSError as error:
            raise ValueError(f"{file}: cannot be read: {error.strerror}") from error
        except UnicodeDecodeError as error:
            raise ValueError(f"{file}: is no text, saved as UTF-8") from error
        except Error as error:
            raise ValueError(f"{file}: {' '.join(error.message.split())}") from error

    def has(self, name) -> bool:
        """Return whether there is a line with this name."""
        return self.parser.has_option("experiment", name)

    def answers(self) -> list[str]:
        """Return the texts of the answers, with their asterisks."""
        return self.parser.options("answers") if self.parser.has_section("answers") else []

    def text(self, name, section="experiment") -> str:
        """Return the text of a line."""
        text = " ".join(self.parser.get(section, name, fallback="").split())
        if not text:
            raise ValueError(f"{self.file}, {name}: found nothing, allowed is a text")
        return text

    def name(self) -> str:
        """Return the name of the experiment; VPython's menu would change the letters & < >."""
        name = self.text("name")
        if re.search("[&<>]", name) or name == YOUR_CSV:
            raise ValueError(
                f"{self.file}, name: found {name!r}, allowed is a text without & < >, but not {YOUR_CSV!r}"
            )
        return name

    def angles(self, name, count, section="experiment") -> list[float]:
        """Return the angles (degrees) of a line, one for each of count pendula."""
        text = self.text(name, section)
        angles = [to_number(word) for word in text.split()]
        if len(angles) != count or not all(-180 <= angle <= 180 for angle in angles):
            allowed = f"{count} angles from -180 to 180 (degrees), one for each pendulum"
            raise ValueError(f"{self.file}, {name}: found {text!r}, allowed are {allowed}")
        return angles

    def seconds(self) -> float:
        """Return the time of the measurement."""
        text = self.text("seconds")
        if not 0 < to_number(text) <= LONGEST:
            raise ValueError(f"{self.file}, seconds: found {text!r}, allowed is a number above 0 and up to {LONGEST:g}")
        return to_number(text)

    def measured(self, name, count) -> str:
        """Return the text of a line that can have measured numbers of count pendula in braces."""
        text = self.text(name)
        for field in re.findall(r"\{[^{}]*\}|[{}]", text):
            match = MEASURED.fullmatch(field)
            if not match or int(match[2] or 1) > count:
                allowed = f"{{energy}}, or swing_, speed_ or before_ with the number of a bob, 1 to {count}, in braces"
                raise ValueError(f"{self.file}, {name}: found {field}, allowed is {allowed}")
        return text
