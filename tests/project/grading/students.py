"""Starters, and students who write functions into them. conftest.py takes over the fixtures."""

import json
import re
import shutil
from collections import Counter
from textwrap import dedent, indent

import pytest
from make_starter import make_starter
from programs import python
from right_solutions import PLAIN

from grading.assignment import FUNCTIONS, PROGRAM
from grading.checks import collect
from line_by_line.table import COLUMNS

COUNTS = Counter(check.tier for check in collect().checks.values())

# Without a plugin that takes longer to import than the checks take; a student does not have it.
PYTEST = "-m pytest -p no:cacheprovider -p no:hypothesispytest"

# The lines of the program; a student writes the first and the last one.
MAKE, LOOP, TICK = map(str.strip, PLAIN[PROGRAM].splitlines())


@pytest.fixture(scope="session")
def made(tmp_path_factory):
    """A starter that nobody writes into."""
    folder = tmp_path_factory.mktemp("made") / "starter"
    make_starter(folder)
    return folder


@pytest.fixture
def starter(made, tmp_path):
    """A starter, for a student to write into."""
    return shutil.copytree(made, tmp_path / "starter")


@pytest.fixture(scope="session")
def solved(made, tmp_path_factory):
    """The files of a complete solution, by their paths below src/."""
    folder = shutil.copytree(made, tmp_path_factory.mktemp("solved") / "starter")
    write(folder, *FUNCTIONS)
    names = sorted({function.file.removeprefix("src/") for function in FUNCTIONS.values()})
    return {name: (folder / "src" / name).read_bytes() for name in names}


def graded_in(starter) -> dict:
    """Return what pytest writes for a gradebook in this starter."""
    command = f"{PYTEST} --grade-json grade.json"
    done = python(
        *command.split(), folder=starter, PYTEST_ADDOPTS="", COLUMNS="100", PYTHONWARNINGS="error"
    )
    grade = json.loads((starter / "grade.json").read_text())
    (starter / "grade.json").unlink()  # or pytest would take it for a folder of tests
    assert done.stderr == ""
    assert done.returncode == (0 if grade["grade"] in ("A", "Honor roll") else 1)
    return grade


def pytest_in(starter, *options):
    """Return the exit status of pytest in this starter, and its output as rows of a terminal."""
    done = python(
        *PYTEST.split(), *options, folder=starter, PYTEST_ADDOPTS="", COLUMNS=str(COLUMNS)
    )
    assert done.stderr == ""
    rows = []
    for line in done.stdout.splitlines():
        rows += re.findall(f".{{1,{COLUMNS}}}", line) or [""]
    return done.returncode, rows


def put_files(folder, files):
    """Write files (text or bytes) into a folder, by their paths; return the folder."""
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    return folder


def write(starter, *functions, **bodies) -> None:
    """Write these functions in place of their stubs; bodies has others than those of PLAIN."""
    for function in functions:
        path = starter / FUNCTIONS[function].file
        source = path.read_text(encoding="utf-8")
        written = [MAKE, TICK] if function == PROGRAM else [{**PLAIN, **bodies}[function]]
        for body in written:
            stub = rf'^( +)# Write your code here.*\n +raise .*"{function} is not written yet".*\n'
            found = re.search(stub, source, re.MULTILINE)
            code = indent(dedent(body).strip(), found[1])
            source = f"{source[: found.start()]}{code}\n{source[found.end() :]}"
        path.write_text(source, encoding="utf-8")


def write_tiers(starter, tiers) -> None:
    """Write all functions of these tiers: "DC" stands for D and C."""
    write(starter, *(name for name, function in FUNCTIONS.items() if function.tier in tiers))


def change(file, before, after) -> None:
    text = file.read_text(encoding="utf-8")
    assert before in text
    file.write_text(text.replace(before, after), encoding="utf-8")


NO_CRADLE = "There is no cradle to see yet. "


def write_next(starter, function) -> str:
    """Return the sentence that names this function, which is not written yet."""
    file = FUNCTIONS[function].file
    source, stub, _ = (starter / file).read_text().partition(f'("{function} is not written yet")')
    assert stub
    line = 1 + source.count("\n")
    return f"Write next: {function} ({file}, line {line})."


SEE_SWING = "With tier C, the pendula swing. If they hang wrong, type pytest."
SEE_COLLIDE = "With tier B, two bobs collide. If no pendulum swings, type pytest."
SEE_TWO = "Here are the first two pendula alone: their bobs collide. If not, type pytest."
SEE_TICK = "Here, newton_cradle_tick moves all pendula. If it does not, type pytest."
# The tiers and functions that are written, the next function, what one sees, and where a bob (an
# index) is after half a second, in degrees
STAGES = {
    " extract_and_convert make_newton_cradle": ("uniform_mass_newton_cradle", SEE_SWING, 0, -45),
    "D": ("angle_update", SEE_SWING, 0, -45),
    "D full_swing_update": ("angle_update", SEE_SWING, 0, -45),
    "DC": ("handle_collision", SEE_COLLIDE, 0, 44),
    "DC handle_two_bobs": ("handle_collision", SEE_COLLIDE, 0, 44),
    "DCB": ("newton_cradle_tick", SEE_TWO, 1, 44),
    "DCB newton_cradle_tick": (PROGRAM, SEE_TICK, 4, 44),
    "DCBA": ("", "", 4, 44),
}
