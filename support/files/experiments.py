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

LONGEST_RUN = 60.0  # s from the release to the measurement
MEASURED = re.compile(r"\{(?:energy|(swing|speed|before)_([1-9]\d*))\}")
YOUR_CSV = "My cradle (CSV)"  # the name in the menu that no experiment can have


class Answer(NamedTuple):
    text: str
    swings: list[float]  # that it predicts: the angles (degrees) of the bobs, farthest from straight down


class Experiment(NamedTuple):
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
    """Return this folder's experiments (for pendula with 1 or 2 cords), by file name, and a line for each bad one."""
    experiments: list[Experiment] = []
    mistakes = []
    files = [file for ending in ("csv", "txt") for file in Path(folder).glob(f"*.{ending}")]
    for path in sorted({file.with_suffix(".csv") for file in files}):
        try:
            experiment = read_experiment(path, cords)
            if experiment.name in [other.name for other in experiments]:
                file = path.with_suffix(".txt")
                raise ValueError(f"{file}, name: {experiment.name!r} is the name of another experiment")
            experiments.append(experiment)
        except ValueError as error:
            mistakes.append(str(error))
    return experiments, mistakes


def read_experiment(path, cords) -> Experiment:
    """Return the experiment with this CSV; raises a ValueError with a one-line message if it has a mistake."""
    csv = Snapshot(path)
    check_cradle(csv, cords)
    count = len(read_cells(csv)) - 1  # without the header
    file = path.with_suffix(".txt")
    lines = ExperimentText(file)
    if cords == 1 and lines.parser.has_option("experiment", "phi"):
        raise ValueError(f"{file}, phi: is allowed only for the double cradle")
    angles = [map(radians, lines.angles(name, count)) for name in ("theta", "phi")[:cords]]
    texts = lines.parser.options("answers")  # with their asterisks
    answers = [Answer(text.lstrip("* "), lines.angles(text, count, "answers")) for text in texts]
    explained = [number for number, text in enumerate(texts) if text.startswith("*")]
    if len({answer.text for answer in answers}) < len(answers):
        raise ValueError(f"{file}, [answers]: found an answer twice")
    if not (2 <= len(answers) <= 5 and len(explained) == 1):
        found = f"found {len(answers)} answers, {len(explained)} of them with an asterisk"
        raise ValueError(f"{file}, [answers]: {found}, allowed are 2 to 5, one of them with an asterisk")
    allowed = f"a number above 0 and up to {LONGEST_RUN:g}"
    seconds = lines.text("seconds", lambda text: 0 < to_number(text) <= LONGEST_RUN, allowed)
    return Experiment(
        key=path.stem,
        csv=csv,
        name=lines.text("name", lambda text: text != YOUR_CSV, f"a text, but not {YOUR_CSV!r}"),
        question=lines.text("question"),
        answers=answers,
        explained=explained[0],
        why=lines.measured("why", count),
        angles=[[*accumulate(of_pendulum)] for of_pendulum in zip(*angles, strict=True)],
        seconds=to_number(seconds),
    )


class ExperimentText:
    """The lines of an experiment's text file; the methods raise a ValueError with a one-line message."""

    def __init__(self, file):
        self.file, self.parser = file, ConfigParser(delimiters=("=",), comment_prefixes=("#",), interpolation=None)
        self.parser.add_section("answers")  # empty, if the file has none
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

    def text(self, name, is_allowed=bool, allowed="a text", section="experiment") -> str:
        """Return the text of a line, for which is_allowed(text) must be true; allowed names the allowed texts."""
        text = " ".join(self.parser.get(section, name, fallback="").split())
        if not (text and is_allowed(text)):
            raise ValueError(f"{self.file}, {name}: found {repr(text) if text else 'nothing'}, allowed is {allowed}")
        return text

    def angles(self, name, count, section="experiment") -> list[float]:
        """Return the angles (degrees) of a line, one for each of count pendula."""
        text = self.text(name, section=section)
        angles = [to_number(word) for word in text.split()]
        if len(angles) != count or not all(-180 <= angle <= 180 for angle in angles):
            allowed = f"{count} angles from -180 to 180 (degrees), one for each pendulum"
            raise ValueError(f"{self.file}, {name}: found {text!r}, allowed are {allowed}")
        return angles

    def measured(self, name, count) -> str:
        """Return the text of a line that can have measured numbers of count pendula in braces."""
        text = self.text(name)
        for field in re.findall(r"\{[^{}]*\}|[{}]", text):
            match = MEASURED.fullmatch(field)
            if not match or int(match[2] or 1) > count:
                allowed = f"{{energy}}, or swing_, speed_ or before_ with the number of a bob, 1 to {count}, in braces"
                raise ValueError(f"{self.file}, {name}: found {field}, allowed is {allowed}")
        return text
