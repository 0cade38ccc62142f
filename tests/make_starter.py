"""Make the folder that students get: `python tests/make_starter.py FOLDER`.

It is the project without the bodies of the handout's functions. Of tests/, it has only the graded
tests.
"""

import ast
import json
import os
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

from grading.begin import ROOT

from grading.given import GIVEN_FUNCTIONS
from grading.handout import FUNCTIONS, GIVEN, IMPORTS, SUITES
from support.start.end import ended_quietly
from support.start.options import OneLineParser
from support.start.output import in_one_line

FILES = [".gitignore", "newton_cradle_pends.csv", "pds_tester.py", "pyproject.toml"]
FILES += [".devcontainer/devcontainer.json"]
FILES += [f"tests/{suite}.py" for suite in SUITES.values()]
FOLDERS = ["src", "support", "tests/grading", "tests/line_by_line"]
# src/README.md, the fast path, double cradles
WITH_ANSWERS = {"README.md", "many_ticks.py", "double_collisions.py"}
PICTURES = {"accuracy.png", "double.png", "experiment.png", "swing.png"}  # of the READMEs
LEFT_OUT = {"__pycache__", *PICTURES, *WITH_ANSWERS}
# Files that lose what students write, and the functions that lose their bodies: also one of the
# honor roll without a check.
STUDENTS_FILES = {function.file for function in FUNCTIONS.values()}
STUDENTS_FUNCTIONS = {*FUNCTIONS, "double_cradle_tick"}
PROVIDED = {"extract_and_convert": 2}  # statements that the handout provides at the start of a body
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
    print(in_one_line(f"{folder} is ready. Its README.md says what your students write."))


def make_starter(folder) -> None:
    """Make the folder, or fill an empty one.

    If this fails, leave nothing behind, and raise an OSError.
    """
    files = files_of_the_project()
    texts = texts_of_its_own()
    for file in files:
        if file.as_posix() in STUDENTS_FILES:
            texts[file] = for_students(ROOT / file)
    texts[Path(GIVEN_FUNCTIONS)] = given_functions(texts)
    new = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        for file in files:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / file, folder / file)
        for file, text in texts.items():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_text(text, encoding="utf-8", newline="\n")
    except BaseException:
        for path in new[-1:] or folder.iterdir():
            if path.is_dir():
                shutil.rmtree(path)
            else:
                path.unlink(missing_ok=True)
        raise


def files_of_the_project() -> list[Path]:
    """Return the project's files that students get, by their paths in it."""
    files = [Path(name) for name in FILES]
    for name in FOLDERS:
        for path in (ROOT / name).rglob("*"):
            file = path.relative_to(ROOT)
            if path.is_file() and not any(map(is_left_out, file.parts)):
                files.append(file)
    return files


def texts_of_its_own() -> dict[Path, str]:
    """Return the texts of the files that differ from the project's, except those of src/."""

    def read(name):
        return (ROOT / name).read_text(encoding="utf-8")

    rows = [
        f"| {function.tier} | {name} | `{function.file}` |" for name, function in FUNCTIONS.items()
    ]
    project, _, _ = read("pyproject.toml").partition("\n# A plain pytest")
    return {
        Path("src/no_program.py"): NO_PROGRAM_FILE,
        Path("README.md"): read("tests/starter.md").format(rows="\n".join(rows)),
        Path("pyproject.toml"): project.replace(" -m 'not browser and not slow'", ""),
        Path(".github/workflows/classroom.yml"): read("tests/teacher/classroom.yml"),
    }


def is_left_out(name) -> bool:
    """Return whether students do not get a file or a folder of this name.

    A name that begins with a dot is that of an editor's copy, or of what a Mac adds to a file on a
    disk of another system.
    """
    return name in LEFT_OUT or name.startswith(".")


def for_students(path) -> str:
    """Return the source of a file of src/ without what students write.

    The docstrings of their functions stay.
    """
    source = path.read_text(encoding="utf-8")
    file = f"src/{path.name}"
    if file not in STUDENTS_FILES:
        return source
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


def given_functions(texts) -> str:
    """Return JSON: [file, source] of each function that src/ provides, by its name.

    texts has the starter's files of src/, by their paths.
    """
    found = {}
    for file, text in texts.items():
        if file.as_posix() in STUDENTS_FILES:
            for statement in ast.parse(text).body:
                name = getattr(statement, "name", "")
                if name in GIVEN - STUDENTS_FUNCTIONS:
                    found[name] = file.as_posix(), ast.get_source_segment(text, statement)
    return json.dumps(found, indent=4, sort_keys=True) + "\n"


class Gap(NamedTuple):
    """Lines that students write: the lines of the file from begin to before end, from 0 on."""

    begin: int
    end: int
    name: str  # of the function
    indent: str
    task: str = ""  # of these lines, for the comment


def gaps(source) -> list[Gap]:
    """Return what students write in a file: the bodies of functions, and parts of the program."""
    found = []
    for statement in ast.parse(source).body:
        if isinstance(statement, ast.FunctionDef) and statement.name in STUDENTS_FUNCTIONS:
            # The docstring is the first statement
            provided = statement.body[PROVIDED.get(statement.name, 0)]
            gap = Gap(provided.end_lineno, statement.end_lineno, statement.name, " " * 4)
            found.append(gap)
        elif isinstance(statement, ast.If):  # of __name__
            for part in ast.walk(statement):
                if type(part) in PROGRAM:
                    indent = " " * part.col_offset
                    task = f": {PROGRAM[type(part)]}"
                    gap = Gap(part.lineno - 1, part.end_lineno, "the program", indent, task)
                    found.append(gap)
    return found


def used_names(source) -> set[str]:
    """Return the names that the code of a file uses."""
    nodes = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Name)]
    return {node.id for node in nodes if isinstance(node.ctx, ast.Load)}


def without_unused(source, helpers) -> str:
    """Return the source without the imports, functions and values of helpers that nothing uses."""
    unused = helpers - used_names(source)
    for statement in ast.parse(source).body:
        names = names_of(statement)
        if names and names <= unused:
            # Again, for the helpers that only this one has used
            return without_unused(without(source, statement), helpers)
    return source


def names_of(statement) -> set[str]:
    """Return the names that a statement outside of functions defines."""
    if isinstance(statement, ast.FunctionDef):
        return {statement.name}
    if isinstance(statement, ast.Import | ast.ImportFrom):
        return {alias.asname or alias.name for alias in statement.names}
    if isinstance(statement, ast.AnnAssign):
        return {ast.unparse(statement.target)}
    return set()


def without(source, statement) -> str:
    """Return the source without a statement; the longer gap of those above and below it stays."""
    lines = source.splitlines(keepends=True)
    above = "".join(lines[: statement.lineno - 1])
    below = "".join(lines[statement.end_lineno :])
    text_above, text_below = above.rstrip("\n"), below.lstrip("\n")
    gap_above = above.removeprefix(text_above)
    gap_below = "\n" + below.removesuffix(text_below)
    return text_above + max(gap_above, gap_below) + text_below


if __name__ == "__main__":
    main()
