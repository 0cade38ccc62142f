"""Make the folder that students get: `python tests/make_starter.py FOLDER`.

It is the project without the bodies of the assignment's functions. Of tests/, it has only the
graded tests; tests/starter/ has what only a starter has.
"""

import ast
import json
import os
import sys
from pathlib import Path
from typing import NamedTuple

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

from grading.begin import ROOT

from grading.assignment import FUNCTIONS, GIVEN, IMPORTS, SUITES
from grading.given import GIVEN_FUNCTIONS
from support.start.end import ended_quietly
from support.start.options import OneLineParser
from support.start.output import in_one_line

FILES = [
    ".devcontainer/devcontainer.json",
    ".gitignore",
    "newton_cradle_pends.csv",
    "pds_tester.py",
    *(f"tests/{suite}.py" for suite in SUITES.values()),
]
# Where the texts are that only a starter has, by their paths in it
OWN = {
    "README.md": "tests/starter/starter.md",
    "ASSIGNMENT.md": "tests/starter/ASSIGNMENT.md",
    ".vscode/extensions.json": "tests/starter/.vscode/extensions.json",
    ".vscode/launch.json": "tests/starter/.vscode/launch.json",
    ".vscode/settings.json": "tests/starter/.vscode/settings.json",
    ".github/workflows/classroom.yml": "tests/starter/classroom.yml",
}
FOLDERS = ["src", "support", "tests/grading", "tests/line_by_line"]
LEFT_OUT = {
    "__pycache__",
    # Answers
    "double_collisions.py",
    "many_ticks.py",
    # Of the project's own pages
    "README.md",
    "accuracy.png",
    "double.png",
    "experiment.png",
    "swing.png",
}
# Files that lose what students write, and the functions that lose their bodies: also one of the
# honor roll without a check.
STUDENTS_FILES = {function.file for function in FUNCTIONS.values()}
STUDENTS_FUNCTIONS = {*FUNCTIONS, "double_cradle_tick"}
# Statements that a starter provides at the start of a body
PROVIDED = {"extract_and_convert": 2}
# What students write in the program: a statement of each of these types
PROGRAM = {ast.Assign: "make pend_list", ast.Expr: "one tick"}

# The first lines of a file without a program, and the module that they import.
NO_PROGRAM = """if __name__ == "__main__":
    import no_program

"""
NO_PROGRAM_FILE = """# You have started a file that has only functions.

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
from support.start import program

program.refuse_to_run()
"""


@ended_quietly()
def main() -> None:
    """Make the folder; the status is 2 if this fails."""
    parser = OneLineParser(description="Make the folder that students get.", allow_abbrev=False)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="a new or an empty folder")
    folder = parser.parse_args().folder
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        parser.error(f"argument FOLDER: found '{folder}', allowed is a new or an empty folder")
    make_starter(folder)
    print(in_one_line(f"{folder} is ready. Its ASSIGNMENT.md says what your students write."))


def make_starter(folder: Path) -> None:
    """Make the folder, or fill an empty one."""
    for name, content in (copies() | changed_texts()).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def copies() -> dict[str, bytes]:
    """Return the contents of the files that a starter has from the project, by their paths."""
    files = [*FILES]
    for name in FOLDERS:
        for path in (ROOT / name).rglob("*"):
            file = path.relative_to(ROOT)
            if path.is_file() and not any(map(is_left_out, file.parts)):
                files.append(file.as_posix())
    return {file: (ROOT / file).read_bytes() for file in files}


def changed_texts() -> dict[str, bytes]:
    """Return the contents of the files that are not as in the project, by their paths."""
    texts = {file: for_students(file) for file in STUDENTS_FILES}
    texts[GIVEN_FUNCTIONS] = given_functions(texts)
    texts["src/no_program.py"] = NO_PROGRAM_FILE
    # As far as its options of the tests, without the choice of marks
    project, grader, _ = text_of("pyproject.toml").partition("-p grading.pytest_grader")
    texts["pyproject.toml"] = f'{project}{grader}"\n'
    for name, place in OWN.items():
        texts[name] = text_of(place).replace("../../", "")  # in links
    return {name: text.encode() for name, text in texts.items()}


def text_of(file: str) -> str:
    """Return the text of a file of the project."""
    return (ROOT / file).read_text(encoding="utf-8")


def is_left_out(name: str) -> bool:
    """Return whether students do not get a file or a folder of this name.

    A name that begins with a dot is that of an editor's copy, or of what a Mac adds to a file on a
    disk of another system.
    """
    return name in LEFT_OUT or name.startswith(".")


def for_students(file: str) -> str:
    """Return the source of a file of src/ without what students write.

    The docstrings of their functions stay.
    """
    source = text_of(file)
    used_before = used_names(source)
    lines = source.splitlines(keepends=True)
    for gap in reversed(gaps(source)):
        stub = f'raise NotImplementedError("{gap.name} is not written yet")'
        lines[gap.begin : gap.end] = [
            f"{gap.indent}# Write your code here, in place of the next line{gap.task}.\n",
            f"{gap.indent}{stub}\n",
        ]
    kept = {*FUNCTIONS, *GIVEN, *IMPORTS[file].split()}
    source = without_unused("".join(lines), used_before - kept)
    if "__main__" not in source:
        source = source.replace('"""\n\n', f'"""\n\n{NO_PROGRAM}', 1)
    return source


def given_functions(texts: dict[str, str]) -> str:
    """Return JSON: [file, source] of each function that src/ provides, by its name.

    texts has what students get of the files that they write into, by their paths.
    """
    found = {}
    for file, text in texts.items():
        for statement in ast.parse(text).body:
            name = getattr(statement, "name", "")
            if name in GIVEN - STUDENTS_FUNCTIONS:
                found[name] = file, ast.get_source_segment(text, statement)
    return json.dumps(found, indent=4, sort_keys=True) + "\n"


class Gap(NamedTuple):
    """Lines that students write: the lines of the file from begin to before end, from 0 on."""

    begin: int
    end: int
    name: str  # of the function
    indent: str
    task: str = ""  # of these lines, for the comment


def gaps(source: str) -> list[Gap]:
    """Return what students write in a file: the bodies of functions, and parts of the program."""
    found = []
    for statement in ast.parse(source).body:
        if isinstance(statement, ast.FunctionDef) and statement.name in STUDENTS_FUNCTIONS:
            # The docstring is the first statement
            provided = statement.body[PROVIDED.get(statement.name, 0)]
            found.append(Gap(end_of(provided), end_of(statement), statement.name, "    "))
        elif isinstance(statement, ast.If):  # of __name__
            for part in ast.walk(statement):
                if isinstance(part, ast.stmt) and type(part) in PROGRAM:
                    indent = " " * part.col_offset
                    task = f": {PROGRAM[type(part)]}"
                    found.append(Gap(part.lineno - 1, end_of(part), "the program", indent, task))
    return found


def end_of(statement: ast.stmt) -> int:
    """Return the number of the last line of a statement."""
    return statement.end_lineno or statement.lineno


def used_names(source: str) -> set[str]:
    """Return the names that the code of a file uses."""
    names = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Name)]
    return {name.id for name in names if isinstance(name.ctx, ast.Load)}


def without_unused(source: str, helpers: set[str]) -> str:
    """Return the source without the imports, functions and values of helpers that nothing uses."""
    unused = helpers - used_names(source)
    for statement in ast.parse(source).body:
        if names_of(statement) <= unused:
            # Again, for the helpers that only this one has used
            return without_unused(without(source, statement), helpers)
    return source


def names_of(statement: ast.stmt) -> set[str]:
    """Return the names that an import, a function or a value with a type defines, or {""}."""
    if isinstance(statement, ast.AnnAssign):
        return {ast.unparse(statement.target)}
    parts = getattr(statement, "names", [statement])  # of an import
    return {getattr(part, "name", "") for part in parts}


def without(source: str, statement: ast.stmt) -> str:
    """Return the source without a statement; of the gaps above and below it, one stays."""
    lines = source.splitlines(keepends=True)
    above = "".join(lines[: statement.lineno - 1])
    below = "".join(lines[statement.end_lineno :])
    if below.startswith("\n"):
        above = above.rstrip("\n") + "\n"
    return above + below


if __name__ == "__main__":
    main()
