"""Read experiments: each is a TOML file with lines such as `name = "One bob"`."""

import re
import tomllib
from itertools import accumulate, cycle
from math import radians
from pathlib import Path
from typing import Any, NamedTuple

from support.columns import CHECKED, Column, COLUMN_NAMES
from support.files.cradle_csv import Snapshot
from support.files.valid_cradle import CradleCsv, MOST_PENDULA
from support.found import found
from support.root import ROOT

EXPERIMENTS = ROOT / "support" / "experiments"
ANGLE = Column("angle", example="-45", unit="degrees", limits=(-180, 180))
COLORS = "red", "yellow", "cyan", "blue", "purple"  # of the pendula, in turn
MEASURED = re.compile(r"\{(?:energy|hits|(?:swing|speed|before)_([1-9]\d*))\}")
FIELDS = "{energy}, {hits}, or swing_, speed_ or before_ with the number of a bob, in braces"
NAMES = (
    "name, theta, phi (of the double cradle), mass, e, question, and with it why, and answers and "
    "right, or hidden"
)
YOUR_CSV = "My cradle"  # on the page, beside the names of the experiments


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
    stem: str  # the name of its file
    csv: CradleCsv
    name: str
    poses: list[list[float]]  # of each pendulum's cords at the start (rad)
    question: str = ""
    hidden: Hidden | None = None  # in place of answers
    answers: list[Answer] = []  # nobody changes it
    explained: int = 0  # the index of the answer that why explains
    why: str = ""


def read_experiments(folder: str | Path, cords: int) -> tuple[dict[str, Experiment], list[str]]:
    """Return this folder's experiments by their names, and a message for each bad one.

    cords is the number of cords of a pendulum, 1 or 2. A name that begins with a dot is no
    experiment: on a disk of another system, a Mac adds such a file to each file.
    """
    experiments: dict[str, Experiment] = {}
    mistakes = []
    for file in sorted(Path(folder).glob("[!.]*.toml")):
        try:
            experiment = read_experiment(file, cords)
            name = experiment.name
            if name in experiments:
                raise ValueError(f"{file}: {name!r} is the name of another experiment")
            experiments[name] = experiment
        except ValueError as error:
            mistakes.append(str(error))
    return experiments, mistakes


def read_experiment(file: Path, cords: int) -> Experiment:
    """Return the experiment of this TOML file; raises a ValueError with a one-line message."""
    text = Snapshot(file).text()
    try:
        return take_experiment(file, tomllib.loads(text), cords)
    except ValueError as error:  # that of tomllib says the line
        raise ValueError(f"{file}: {error}") from error


# These take what they return out of the values of a file: a value that is left has a wrong name.
# They raise a ValueError.


def take_experiment(file: Path, values: dict[str, Any], cords: int) -> Experiment:
    name = take_text(values, "name")
    thetas: Any = values.get("theta")
    require(isinstance(thetas, list), "theta", thetas, "a list of angles")
    count = len(thetas)
    angles = [take_numbers(values, name, ANGLE, count) for name in ("theta", "phi")[:cords]]
    poses = [[*accumulate(map(radians, pendulum))] for pendulum in zip(*angles, strict=True)]
    values = {"mass": 1, "e": 1} | values
    masses = take_numbers(values, "mass", CHECKED["mass"], count)
    es = take_numbers(values, "e", CHECKED["e"], count)
    rows = zip(masses, es, cycle(COLORS), strict=False)
    pendula = [[str(mass), str(e), "0.0", "0.0", color, "metal"] for mass, e, color in rows]
    csv = CradleCsv(file.with_suffix(".csv"), COLUMN_NAMES, pendula)  # there is no such file
    asked = take_question(values, es) if "question" in values else {}
    require(not values, "a name", ", ".join(values), NAMES)
    return Experiment(file.stem, csv, name, poses, **asked)


def take_question(values: dict[str, Any], es: list[float]) -> dict[str, Any]:
    """Return the fields of an Experiment with a question, for a cradle with these e."""
    count = len(es)
    question = take_text(values, "question")
    why = take_text(values, "why")
    if "hidden" in values:
        return {"question": question, "hidden": take_hidden(values, es, question, why)}
    for field in re.findall(r"\{[^{}]*\}|[{}]", why):
        match = MEASURED.fullmatch(field)
        require(match and int(match[1] or 1) <= count, "why", field, FIELDS)
    answers = values.pop("answers", None)
    is_table = isinstance(answers, dict) and 2 <= len(answers) <= 5
    require(is_table, "answers", answers, "a table of 2 to 5 answers")
    letters = [*"ABCDE"[: len(answers)]]
    right: Any = values.pop("right", None)
    require(right in letters, "right", right, f"one of {letters}")
    return {
        "question": question,
        "answers": [Answer(text, take_numbers(answers, text, ANGLE, count)) for text in [*answers]],
        "explained": letters.index(right),
        "why": why,
    }


def take_hidden(values: dict[str, Any], es: list[float], question: str, why: str) -> Hidden:
    """Return what is hidden: a mass, or the e of all."""
    require("{" not in why, "why", why, "a text without braces")
    rows = {f"mass {row + 1}": [row] for row in range(len(es))}
    if min(es) == max(es) > 0:
        rows["e"] = [*range(len(es))]
    hidden = take_text(values, "hidden")
    allowed = "mass and the number of a bob, or e, if all have one above 0"
    require(hidden in rows, "hidden", hidden, allowed)
    return Hidden(hidden.split()[0], rows[hidden], question, why)


def take_text(values: dict[str, Any], name: str) -> str:
    """Return the text with this name, in one line."""
    text: Any = values.pop(name, None)
    require(isinstance(text, str) and text.strip(), name, text, "a text")
    return " ".join(text.split())


def take_numbers(values: dict[str, Any], name: str, column: Column, count: int) -> list[float]:
    """Return the numbers with this name; one that is not in a list is for all pendula."""
    value = values.pop(name, None)
    listed = value if isinstance(value, list) else [value] * count
    has_all = 0 < len(listed) == count <= MOST_PENDULA
    is_right = has_all and all(column.allows(str(number)) for number in listed)
    each = f"or a list of one for each pendulum (at most {MOST_PENDULA})"
    require(is_right, name, value, f"{column.allowed()}, {each}")
    return [*map(float, listed)]


def require(is_so: object, name: str, value: object, allowed: str) -> None:
    """Raise a ValueError if the value with this name is not one of the allowed ones."""
    if not is_so:
        raise ValueError(f"{name}: {found(value, allowed)}")
