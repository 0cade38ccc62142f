"""What a file of src/ defines: whether a given function has changed, or a name is defined twice."""

import ast
import json
from contextlib import suppress
from itertools import zip_longest
from pathlib import Path
from typing import Any
from warnings import catch_warnings

from grading.begin import ROOT

# Only a starter has it: [file, source] of each given function, by its name
GIVEN_FUNCTIONS = "tests/grading/given_functions.json"


def changed_given(folder: Path = ROOT) -> list[str]:
    """Return a sentence for each given function that is not as in the starter.

    Comments do not count. Nothing is said in the project itself, which is no starter.
    """
    sources = folder / GIVEN_FUNCTIONS
    given = json.loads(sources.read_bytes()) if sources.is_file() else {}
    sentences = []
    for name, (file, source) in given.items():
        with suppress(Exception):  # Python cannot read the file
            yours = definitions(folder / file, name)
            if not yours:
                sentences.append(f"{name} was given; {file} has none.")
                continue
            line = difference(source, ast.unparse(yours[-1]))
            if line:
                sentences.append(f"{name} was given; yours differs in {file}: {line}")
    return sentences


def defined_twice(file: str, name: str) -> str:
    """Return a sentence if a file of the project defines a function more than once, or ""."""
    found = []
    with suppress(Exception):  # Python cannot read the file
        found = definitions(ROOT / file, name)
    if len(found) < 2:
        return ""
    lines = " and ".join(f"{definition.lineno}" for definition in found)
    return f"{name} is defined in lines {lines}; Python uses the last one."


def definitions(file: Path, name: str) -> list[Any]:
    """Return the definitions of a function at the left edge of a file."""
    with catch_warnings(action="ignore"):
        module = ast.parse(file.read_bytes())
    return [statement for statement in module.body if getattr(statement, "name", "") == name]


def difference(given: str, yours: str) -> str:
    """Return the first line of a function that is not as given, or ""."""
    given_lines = ast.unparse(ast.parse(given)).split("\n")
    lines = yours.split("\n")
    for given_line, line in zip_longest(given_lines, lines, fillvalue="(its end)"):
        if line != given_line:
            return line.strip()
    return ""
