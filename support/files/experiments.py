"""Read experiments: each is a text file with lines such as `name = One bob`."""

import re
from collections.abc import Callable
from itertools import accumulate, cycle, islice
from math import inf, radians
from pathlib import Path
from typing import NamedTuple

from support.columns import CHECKED, COLUMNS, SETTABLE, to_number
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import are_in_range, CradleCsv, IN_RANGE, MOST_PENDULA
from support.found import found
from support.root import ROOT

EXPERIMENTS = ROOT / "support" / "experiments"

# The names of lines; the other lines are answers.
CRADLE = ["name", "theta", "phi", *SETTABLE]
NAMES = [*CRADLE, "hidden", "question", "why"]
ANGLE = "an angle from -180 to 180 (degrees)"
COLORS = "red", "yellow", "cyan", "blue", "purple"  # of the pendula, in turn
MEASURED = re.compile(r"\{(?:energy|hits|(swing|speed|before)_([1-9]\d*))\}")
HIDDEN = re.compile(r"e|mass ([1-9]\d*)")
YOUR_CSV = "My cradle"  # the name on the page that no experiment can have


class Answer(NamedTuple):
    text: str
    # That it predicts: the angles (degrees) of the bobs, farthest from straight down
    swings: list[float]


class Hidden(NamedTuple):
    """A value that a class finds by measuring: until then, nothing shows it."""

    column: str  # mass or e
    rows: list[int]  # the indices of the pendula that have it
    question: str
    why: str  # how one finds it


class Experiment(NamedTuple):
    key: str  # the name of its file
    csv: CradleCsv
    name: str
    question: str  # without it, there are no answers, and no why
    answers: list[Answer]
    explained: int  # the index of the answer that why explains
    why: str
    poses: list[list[float]]  # of each pendulum's cords at the start (rad)
    hidden: Hidden | None = None  # in place of question, answers and why

    def asks(self) -> str:
        """Return what it asks, or nothing."""
        return self.hidden.question if self.hidden else self.question


def read_experiments(folder: str | Path, cords: int) -> tuple[list[Experiment], list[str]]:
    """Return this folder's experiments, as in the menu, and a message for each bad one.

    cords is the number of cords of a pendulum, 1 or 2. A name that begins with a dot is no
    experiment: on a disk of another system, a Mac adds such a file to each file.
    """
    experiments: dict[str, Experiment] = {}
    mistakes = []
    for file in sorted(Path(folder).glob("[!.]*.txt"), key=place_in_menu):
        try:
            experiment = read_experiment(file, cords)
            name = experiment.name
            if name in experiments:
                raise ValueError(f"{file}, name: {name!r} is the name of another experiment")
            experiments[name] = experiment
        except ValueError as error:
            mistakes.append(str(error))
    return list(experiments.values()), mistakes


def place_in_menu(file: Path) -> tuple[float, str]:
    """Return the number at the start of a file's name, or infinity, and the name: sort by these."""
    number = re.match("[0-9]+", file.name)
    return int(number[0]) if number else inf, file.name


def read_experiment(file: Path, cords: int) -> Experiment:
    """Return the experiment of this text file; raises a ValueError with a one-line message."""
    lines = ExperimentText(file)
    if cords == 1 and "phi" in lines.texts:
        raise ValueError(f"{file}, phi: is allowed only for the double cradle")
    poses = lines.start_poses(cords)
    columns = {name: lines.column(name) for name in SETTABLE}
    if cords == 2 and not are_in_range(columns["mass"]):
        raise ValueError(f"{file}, mass: found {lines.text('mass')!r}, allowed is {IN_RANGE}")
    name = lines.text("name", lambda text: text != YOUR_CSV, f"a text, but not {YOUR_CSV!r}")
    csv = csv_of(file.with_suffix(".csv"), columns)  # there is no such file
    experiment = Experiment(file.stem, csv, name, "", [], 0, "", poses)
    if lines.texts.keys() <= {*CRADLE}:
        return experiment
    if "hidden" in lines.texts:
        return experiment._replace(hidden=lines.hidden(columns))
    answers = lines.answers()
    return experiment._replace(
        question=lines.text("question"),
        answers=list(answers.values()),
        explained=[line[0] for line in answers].index("*"),
        why=lines.measured("why"),
    )


def csv_of(filepath: Path, columns: dict[str, list[float]]) -> CradleCsv:
    """Return the CSV of a cradle with these numbers, a list for each of SETTABLE."""
    count = len(columns["mass"])
    table: dict[str, list] = {}
    for column in COLUMNS:
        table[column.name] = [column.default] * count
    table |= columns
    table["color"] = list(islice(cycle(COLORS), count))
    pendula = [[*map(str, row)] for row in zip(*table.values(), strict=True)]
    return CradleCsv(filepath, [*table], pendula)


class ExperimentText:
    """The lines of an experiment's text file.

    The methods raise a ValueError with a one-line message.
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self.texts: dict[str, str] = {}  # by the name, or the answer, before the =
        name = ""
        for number, line in enumerate(Snapshot(file).text().splitlines(), start=1):
            is_note = re.match(r"\s*(#|$)", line)  # or a blank line
            if is_note:
                continue
            if name and line[0].isspace():  # it goes on with the line above
                self.texts[name] += f" {line}"
                continue
            # An answer can have a =, too
            split = line.rpartition if line[0] in "-*" else line.partition
            name, equals, text = split("=")
            name = name.strip()
            is_known = name in NAMES or re.match("[-*].", name)
            if not equals or not is_known or name in self.texts:
                names = f"{', '.join(NAMES)}, or an answer after - or *"
                allowed = f"a line with =, and before it, once each, {names}"
                raise ValueError(f"{file}, line {number}: {found(line.strip(), allowed)}")
            self.texts[name] = text
        thetas = self.text("theta", allowed=ANGLE).split()
        self.count = min(len(thetas), MOST_PENDULA)  # of the pendula

    def text(
        self, name: str, is_allowed: Callable[[str], object] = bool, allowed: str = "a text"
    ) -> str:
        """Return the text of a line, for which is_allowed(text) must be true.

        allowed names the allowed texts.
        """
        text = " ".join(self.texts.get(name, "").split())
        if not (text and is_allowed(text)):
            raise ValueError(f"{self.file}, {name}: {found(text, allowed)}")
        return text

    def numbers(self, name: str, is_allowed: Callable[[str], bool], allowed: str) -> list[float]:
        """Return the numbers of a line, an allowed one for each pendulum."""

        def has_one_for_each(text: str) -> bool:
            numbers = text.split()
            return len(numbers) == self.count and all(map(is_allowed, numbers))

        text = self.text(name, has_one_for_each, f"{allowed}, for each of {self.count} pendula")
        return [to_number(number) for number in text.split()]

    def degrees_of(self, name: str) -> list[float]:
        """Return the angles (degrees) of a line."""
        return self.numbers(name, lambda text: -180 <= to_number(text) <= 180, ANGLE)

    def start_poses(self, cords: int) -> list[list[float]]:
        """Return the angles (rad) of each pendulum's cords from straight down at the start."""
        names = ("theta", "phi")[:cords]
        rows = zip(*map(self.degrees_of, names), strict=True)
        return [list(accumulate(map(radians, row))) for row in rows]

    def column(self, name: str) -> list[float]:
        """Return the numbers of a column of the CSV; without such a line, they are its default."""
        column = CHECKED[name]
        if name not in self.texts:
            return [float(column.default)] * self.count
        return self.numbers(name, column.allows, column.allowed())

    def answers_in(self) -> list[str]:
        """Return the marks and the texts of the answers."""
        return [name for name in self.texts if name not in NAMES]

    def answers(self) -> dict[str, Answer]:
        """Return the answers, each by its mark and its text; one mark is an asterisk."""
        answers = {}
        for name in self.answers_in():
            answers[name] = Answer(name[1:].strip(), self.degrees_of(name))
        marks = [name[0] for name in answers]
        if not 2 <= len(marks) <= 5 or marks.count("*") != 1:
            raise ValueError(
                f"{self.file}, answers: found {len(marks)} answers, {marks.count('*')} of them "
                "with an asterisk, allowed are 2 to 5, one of them with an asterisk"
            )
        return answers

    def hidden(self, columns: dict[str, list[float]]) -> Hidden:
        """Return what is hidden in a cradle with these numbers: a mass, or the e of all."""

        def is_one_value(text: str) -> bool:
            match = HIDDEN.fullmatch(text)
            if not match:
                return False
            if match[1]:
                return int(match[1]) <= self.count
            return len({*columns["e"]}) == 1 and columns["e"][0] > 0

        allowed = f"mass and the number of a bob, 1 to {self.count}, or e, if all have one above 0"
        name = self.text("hidden", is_one_value, allowed)
        if self.answers_in():
            raise ValueError(f"{self.file}, hidden: found answers, which are not allowed with it")
        column, _, bob = name.partition(" ")
        rows = [int(bob) - 1] if bob else [*range(self.count)]
        why = self.text("why", lambda text: "{" not in text, "a text without braces")
        return Hidden(column, rows, self.text("question"), why)

    def measured(self, name: str) -> str:
        """Return the text of a line that can have measured numbers of the bobs in braces."""
        text = self.text(name)
        for field in re.findall(r"\{[^{}]*\}|[{}]", text):
            match = MEASURED.fullmatch(field)
            if not match or int(match[2] or 1) > self.count:
                raise ValueError(
                    f"{self.file}, {name}: found {field}, allowed is {{energy}}, {{hits}}, or "
                    f"swing_, speed_ or before_ with the number of a bob, 1 to {self.count}, "
                    "in braces"
                )
        return text
