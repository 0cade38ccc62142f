"""Make the folder that students get: `python tests/make_starter.py FOLDER`.

It is the project without the bodies of the handout's functions. Of tests/, it has only the graded
tests.
"""

import ast
import os
import re
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(__file__))  # with PYTHONSAFEPATH, Python does not

from grading.begin import ROOT

from grading.handout import FUNCTIONS, SUITES
from support.start.end import ended_quietly
from support.start.options import OneLineParser
from support.start.output import in_one_line

FILES = [".gitignore", "newton_cradle_pends.csv", "pds_tester.py", "pyproject.toml"]
FILES += [".devcontainer/devcontainer.json"]
FILES += [f"tests/{suite}.py" for suite in SUITES.values()]
FOLDERS = ["src", "support", "tests/grading", "tests/line_by_line"]
# src/README.md, the handout's loop, the fast path, double cradles.
WITH_ANSWERS = {
    "README.md",
    "plain_cradle_run.py",
    "many_ticks.py",
    "certainty.py",
    "double_collisions.py",
}
PICTURES = {"accuracy.png", "double.png", "experiment.png", "swing.png"}  # of the READMEs
LEFT_OUT = {"__pycache__", *PICTURES, *WITH_ANSWERS}
# Files whose functions lose their bodies, and these functions: also two of the honor roll without a
# check.
STUDENTS_FILES = {
    *(function.file for function in FUNCTIONS.values()),
    "src/visualize_double_cradle_run.py",
}
STUDENTS_FUNCTIONS = {*FUNCTIONS, "double_cradle_tick"}
PROVIDED = {"extract_and_convert": 2}  # statements that the handout provides at the start of a body

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

# Patterns of what the files of src/ lose: imports, arguments and sentences that go beyond the
# handout, and how the double cradle integrates.
CUT = (
    r" *from \S+ import (?:(?:cos|many_ticks|pairwise)(?:, |\n))+\n?",
    r"from src.double_collisions import .*\n",
    r", (?:\*\*page\.rule|approaching_only=\w+|many_ticks)(?=\))",
    r'\n+    (?:With approaching_only)[^"]*(?=\n    "{3})',
    r"(?s)\n    The motion is chaotic.*?(?=\"{3})|def (?:collide_pairs|moved|rates)\(.*?\n\n\n",
)


@ended_quietly()
def main() -> None:
    """Make the folder; the status is 2 if this fails."""
    parser = OneLineParser(description="Make the folder that students get.", allow_abbrev=False)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="a new or an empty folder")
    folder = parser.parse_args().folder
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        parser.error(f"argument FOLDER: found '{folder}', allowed is a new or an empty folder")
    make_starter(folder)
    functions = f"Students write {len(FUNCTIONS)} functions that pytest checks."
    print(in_one_line(f"{folder} is ready. {functions} Its README.md says more."))


def make_starter(folder) -> None:
    """Make the folder, or fill an empty one.

    If this fails, leave nothing behind, and raise an OSError.
    """
    files = files_of_the_project()
    texts = texts_of_its_own()
    for file in files:
        if file.match("src/*.py"):
            texts[file] = for_students(ROOT / file)
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
        f"| {function.tier} | `{name}` | `{function.file}` |"
        for name, function in FUNCTIONS.items()
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
    for pattern in CUT:
        source = re.sub(pattern, "", source)
    if f"src/{path.name}" in STUDENTS_FILES and "__main__" not in source:
        source = source.replace('"""\n\n', f'"""\n\n{NO_PROGRAM}', 1)
    if f"src/{path.name}" not in STUDENTS_FILES:
        return source
    lines = source.splitlines(keepends=True)
    for function in reversed(ast.parse(source).body):
        if isinstance(function, ast.FunctionDef) and function.name in STUDENTS_FUNCTIONS:
            for gap in reversed(gaps(function)):
                comment = f"# Write your code here, in place of the next line{gap.task}."
                stub = f'raise NotImplementedError("{function.name} is not written yet")'
                lines[gap.begin : gap.end] = [f"{gap.indent}{line}\n" for line in (comment, stub)]
    return "".join(lines)


class Gap(NamedTuple):
    """Lines that students write: the lines of the file from begin to before end, from 0 on."""

    begin: int
    end: int
    indent: str
    task: str  # of these lines, for the comment


def gaps(function) -> list[Gap]:
    """Return what students write of a function: its body or, of main, the two calls of theirs."""
    if function.name != "main":
        # The docstring is the first statement
        provided = function.body[PROVIDED.get(function.name, 0)]
        return [Gap(provided.end_lineno, function.end_lineno, " " * 4, "")]
    tasks = {ast.Assign: ": make pend_list", ast.Expr: ": one tick"}
    found = []
    for node in ast.walk(function):
        if type(node) in tasks and isinstance(node.value, ast.Call):
            is_of_a_function = isinstance(node.value.func, ast.Name)  # not page.show
            if is_of_a_function:
                indent = " " * node.col_offset
                found.append(Gap(node.lineno - 1, node.end_lineno, indent, tasks[type(node)]))
    return found


if __name__ == "__main__":
    main()
