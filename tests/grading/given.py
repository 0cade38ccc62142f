"""What a file of src/ defines: whether a given function has changed, or a name is defined twice."""

import ast
import json
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any
from warnings import catch_warnings

from grading.begin import ROOT

# Only a starter has it: [file, source] of each given function, by its name
GIVEN_FUNCTIONS = "tests/grading/given_functions.json"
UNREADABLE = OSError, SyntaxError, ValueError, RecursionError, MemoryError  # for Python
BLOCKS = "body", "handlers", "orelse", "finalbody"  # the statements in a statement


def changed_given(folder: Path = ROOT) -> list[str]:
    """Return a sentence for each given function that is not as in the starter.

    Comments, docstrings and annotations do not count. Nothing is said of a file that Python cannot
    read, and nothing in the project itself, which is no starter.
    """
    sources = folder / GIVEN_FUNCTIONS
    sentences: list[str] = []
    if not sources.is_file():
        return sentences
    for name, (file, source) in json.loads(sources.read_bytes()).items():
        with suppress(*UNREADABLE):
            yours = definitions(folder / file, name)
            if not yours:
                sentences.append(f"{name} was given; {file} has none at the left edge.")
            elif where := difference(ast.parse(source).body[0], yours[-1]):
                sentences.append(f"{name} was given; {where} of {file}.")
    return sentences


def defined_twice(file: str, name: str) -> str:
    """Return a sentence if a file of the project defines a function more than once, or ""."""
    found = []
    with suppress(*UNREADABLE):
        found = definitions(ROOT / file, name)
    if len(found) < 2:
        return ""
    *lines, last = [str(definition.lineno) for definition in found]
    which = "last" if len(found) > 2 else "second"
    places = f"{', '.join(lines)} and {last}"
    return f"{name} is defined in lines {places}; Python uses the {which} one."


def definitions(file: Path, name: str) -> list[ast.stmt]:
    """Return the definitions of a function at the left edge of a file."""
    with catch_warnings(action="ignore"):
        module = ast.parse(file.read_bytes())
    return [statement for statement in module.body if getattr(statement, "name", "") == name]


def difference(given: ast.stmt, yours: ast.stmt) -> str:
    """Return in which line yours is not as given, or ""."""
    _, given_code = zip(*rows_of(given), strict=True)
    lines, code = zip(*rows_of(yours), strict=True)
    if code == given_code:
        return ""
    same = 0  # so many rows are equal, from the first one on
    while code[: same + 1] == given_code[: same + 1]:
        same += 1
    missing = len(given_code) - len(code)
    if missing > 0 and code[same:] == given_code[same + missing :]:
        return f"in yours, code is missing below line {lines[same - 1]}"
    return f"yours differs in line {lines[same]}"


def rows_of(statement: Any, place: str = "") -> Iterator[tuple[int, str]]:
    """Yield the line of a statement and its code with its place, then those of the ones in it."""
    yield statement.lineno, f"{place} {code_of(statement)}"
    for block in BLOCKS:
        for inner in getattr(statement, block, []):
            # A docstring, or another value alone in a statement, does nothing
            if not isinstance(inner, ast.Expr) or not isinstance(inner.value, ast.Constant):
                yield from rows_of(inner, f"{place} {block}")


def code_of(statement: Any) -> str:
    """Return a statement without its annotations, which this takes away, and those in it."""
    for node in ast.walk(statement):
        if isinstance(node, ast.arg):
            node.annotation = None
        elif isinstance(node, ast.FunctionDef):
            node.returns = None
    if isinstance(statement, ast.AnnAssign) and statement.value:
        return f"{ast.unparse(statement.target)} = {ast.unparse(statement.value)}"
    head, _, _ = ast.unparse(statement).partition("\n")
    return head
