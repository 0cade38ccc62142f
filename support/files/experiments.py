"""Read experiments: each is a text file with lines such as `name = One bob`."""

import io
import re
from itertools import accumulate, cycle
from math import inf, radians
from pathlib import Path
from typing import NamedTuple

from support.files.cradle_csv import (
    are_in_range,
    IN_RANGE,
    in_short,
    MOST_PENDULA,
    RULES,
    Snapshot,
    to_number,
)

EXPERIMENTS = Path(__file__).resolve().parents[1] / "experiments"

NAMES = "name", "theta", "phi", "mass", "e", "question", "why"  # of lines; the others have answers
ANGLE = lambda text: -180 <= to_number(text) <= 180, "an angle from -180 to 180 (degrees)"
COLORS = "red", "yellow", "cyan", "blue", "purple"  # of the pendula, in turn
MEASURED = re.compile(r"\{(?:energy|(swing|speed|before)_([1-9]\d*))\}")
YOUR_CSV = "My cradle (CSV)"  # the name in the menu that no experiment can have


class Answer(NamedTuple):
    text: str
    # That it predicts: the angles (degrees) of the bobs, farthest from straight down
    swings: list[float]


class Experiment(NamedTuple):
    key: str  # the name of its file
    csv: Snapshot
    name: str
    question: str
    answers: list[Answer]
    explained: int  # the index of the answer that why explains
    why: str
    angles: list[list[float]]  # of each pendulum's cords at the start (rad)


def read_experiments(folder, cords) -> tuple[list[Experiment], list[str]]:
    """Return this folder's experiments (for pendula with 1 or 2 cords), as in the menu, and a line
    for each bad one.

    A name that begins with a dot is no experiment: a Mac puts such a file beside each one on a
    foreign disk.
    """
    experiments: list[Experiment] = []
    mistakes = []
    for file in sorted(Path(folder).glob("[!.]*.txt"), key=place_in_menu):
        try:
            experiment = read_experiment(file, cords)
            if experiment.name in [other.name for other in experiments]:
                raise ValueError(
                    f"{file}, name: {experiment.name!r} is the name of another experiment"
                )
            experiments.append(experiment)
        except ValueError as error:
            mistakes.append(str(error))
    return experiments, mistakes


def place_in_menu(file) -> tuple[float, str]:
    """Return what the menu is sorted by: the number at the start of a file's name, or infinity, and
    the name.
    """
    number = re.match("[0-9]+", file.name)
    return int(number[0]) if number else inf, file.name


def read_experiment(file, cords) -> Experiment:
    """Return the experiment of this text file (a Path); raises a ValueError with a one-line message
    for a mistake.
    """
    lines = ExperimentText(file)
    if cords == 1 and "phi" in lines.texts:
        raise ValueError(f"{file}, phi: is allowed only for the double cradle")
    count = min(len(lines.text("theta", allowed=ANGLE[1]).split()), MOST_PENDULA)
    lines.texts = {"mass": ["1"] * count, "e": ["1"] * count} | lines.texts
    angles = [map(radians, lines.numbers(name, count, *ANGLE)) for name in ("theta", "phi")[:cords]]
    masses, es = (lines.numbers(name, count, *RULES[name]) for name in ("mass", "e"))
    if cords == 2 and not are_in_range(masses):
        raise ValueError(f"{file}, mass: found {lines.text('mass')!r}, allowed is {IN_RANGE}")
    rows = [
        f"{mass},{e},0.0,0.0,{color},metal\n"
        for mass, e, color in zip(masses, es, cycle(COLORS), strict=False)
    ]
    names = [name for name in lines.texts if name not in NAMES]
    answers = [Answer(name[1:].strip(), lines.numbers(name, count, *ANGLE)) for name in names]
    explained = [number for number, name in enumerate(names) if name.startswith("*")]
    if len({answer.text for answer in answers}) < len(answers):
        raise ValueError(f"{file}, answers: found an answer twice")
    if not (2 <= len(answers) <= 5 and len(explained) == 1):
        found = f"found {len(answers)} answers, {len(explained)} of them with an asterisk"
        raise ValueError(
            f"{file}, answers: {found}, allowed are 2 to 5, one of them with an asterisk"
        )
    return Experiment(
        key=file.stem,
        csv=Snapshot(
            file.with_suffix(".csv"),
            "".join(["mass,e,theta,omega,color,texture\n", *rows]).encode(),
        ),
        name=lines.text("name", lambda text: text != YOUR_CSV, f"a text, but not {YOUR_CSV!r}"),
        question=lines.text("question"),
        answers=answers,
        explained=explained[0],
        why=lines.measured("why", count),
        angles=[[*accumulate(of_pendulum)] for of_pendulum in zip(*angles, strict=True)],
    )


class ExperimentText:
    """The lines of an experiment's text file; the methods raise a ValueError with a one-line
    message.
    """

    def __init__(self, file):
        self.file, name = file, ""
        self.texts: dict[str, list[str]] = {}  # the lines of each text, by its name or its answer
        for number, line in enumerate(io.StringIO(Snapshot(file).text(), newline=None), start=1):
            if re.match(r"\s*(#|$)", line):  # a note, or a blank line
                continue
            if name and line[0].isspace():  # it goes on with the line above
                self.texts[name].append(line)
            else:
                # An answer can have a =, too
                split = line.rpartition if line[0] in "-*" else line.partition
                name, equals, text = (part.strip() for part in split("="))
                if (
                    not equals
                    or name in self.texts
                    or not (name in NAMES or re.match("[-*].", name))
                ):
                    allowed = f"allowed before = is, once each, {', '.join(NAMES)}, or an answer after - or *"
                    raise ValueError(
                        f"{file}, line {number}: found {in_short(repr(line.strip()))}, {allowed}"
                    )
                self.texts[name] = [text]

    def text(self, name, is_allowed=bool, allowed="a text") -> str:
        """Return the text of a line, for which is_allowed(text) must be true; allowed names the
        allowed texts.
        """
        text = " ".join(" ".join(self.texts.get(name, [])).split())
        if not (text and is_allowed(text)):
            found = in_short(repr(text)) if text else "nothing"
            raise ValueError(f"{self.file}, {name}: found {found}, allowed is {allowed}")
        return text

    def numbers(self, name, count, is_allowed, allowed) -> list[float]:
        """Return the numbers of a line, an allowed one for each of count pendula."""
        words = f"{allowed}, for each of {count} pendula"
        text = self.text(
            name, lambda text: [*map(is_allowed, text.split())] == [True] * count, words
        )
        return [*map(to_number, text.split())]

    def measured(self, name, count) -> str:
        """Return the text of a line that can have measured numbers of count pendula in braces."""
        text = self.text(name)
        for field in re.findall(r"\{[^{}]*\}|[{}]", text):
            match = MEASURED.fullmatch(field)
            if not match or int(match[2] or 1) > count:
                allowed = f"{{energy}}, or swing_, speed_ or before_ with the number of a bob, 1 to {count}, in braces"
                raise ValueError(f"{self.file}, {name}: found {field}, allowed is {allowed}")
        return text
