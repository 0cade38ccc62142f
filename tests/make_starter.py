"""Make the folder that students get: `python tests/make_starter.py FOLDER`.

It is the project without the bodies of the handout's functions. Of tests/, it has only the graded
tests.
"""

import ast
import re
import shutil
from pathlib import Path

from grading.begin import ROOT

from grading.handout import FUNCTIONS, SUITES
from support.start.options import OneLineParser
from support.start.output import in_one_line, while_it_is_read

FILES = [
    *(".gitignore", "newton_cradle_pends.csv", "pds_tester.py", "pyproject.toml"),
    *(f"tests/{suite}.py" for suite in SUITES.values()),
]
FOLDERS = ["src", "support", "tests/grading"]
# src/README.md, the fast path, double cradles
WITH_ANSWERS = {"README.md", "many_ticks.py", "double_collisions.py"}
# Of the READMEs
UNUSED = {"__pycache__", "accuracy.png", "double.png", "experiment.png", "swing.png", *WITH_ANSWERS}
# Files whose functions lose their bodies, and these functions: also two of the honor roll without a
# check.
STUDENTS_FILES = {
    *(function.file for function in FUNCTIONS.values()),
    "src/visualize_double_cradle_run.py",
}
STUDENTS_FUNCTIONS = {*FUNCTIONS, "double_cradle_tick"}
PROVIDED = {"extract_and_convert": 2}  # statements that the handout provides at the start of a body

# What a file without a program says if a student starts it.
NO_PROGRAM = """if __name__ == "__main__":
    import os
    import sys

    sys.path.insert(0, os.path.realpath(f"{sys.argv[0]}/../.."))  # the project's folder
    from support.start import program

    program.refuse_to_run()

"""

# Patterns of what the files of src/ lose: imports, arguments and sentences that go beyond the
# handout, and how the double cradle integrates.
CUT = (
    r" *from \S+ import (?:(?:collide_pairs|cos|keep_apart|many_ticks|pairwise)(?:, |\n))+\n?",
    r", (?:\*\*page\.rule|approaching_only=\w+|many_ticks)(?=\))",
    r'\n+    (?:With approaching_only)[^"]*(?=\n    "{3})',
    r"(?s)\n    The motion is chaotic.*?(?=\"{3})|def (?:rates|moved)\(.*?\n\n\n",
)


@while_it_is_read()
def main() -> None:
    """Make the folder; the status is 2 if this fails."""
    parser = OneLineParser(description="Make the folder that students get.", allow_abbrev=False)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="a new or an empty folder")
    folder = parser.parse_args().folder
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        parser.error(f"argument FOLDER: found '{folder}', allowed is a new or an empty folder")
    try:
        make_starter(folder)
    except OSError as error:
        parser.error(f"argument FOLDER: {folder} cannot be made: {error.strerror}")
    line = f"{folder} is ready. Students write {len(FUNCTIONS)} functions that pytest checks. Its README.md says more."
    print(in_one_line(line))


def make_starter(folder) -> None:
    """Make the folder, or fill an empty one; if this fails, leave nothing behind, and raise an
    OSError.
    """
    found = [
        path.relative_to(ROOT)
        for name in FOLDERS
        for path in (ROOT / name).rglob("*")
        if path.is_file()
    ]
    found = [path for path in found if not any(is_left_out(part) for part in path.parts)]
    rows = "\n".join(
        f"| {function.tier} | `{name}` | `{function.file}` |"
        for name, function in FUNCTIONS.items()
    )
    project = (
        (ROOT / "pyproject.toml").read_text(encoding="utf-8").partition("\n# A plain pytest")[0]
    )
    texts = {
        "README.md": Path(__file__)
        .with_name("starter.md")
        .read_text(encoding="utf-8")
        .format(rows=rows),
        "pyproject.toml": project.replace(
            " -m 'not browser and not slow' -n 2 --dist worksteal", ""
        ),
        ".github/workflows/classroom.yml": (ROOT / "tests" / "teacher" / "classroom.yml").read_text(
            encoding="utf-8"
        ),
    }
    for path in found:
        if path.match("src/*.py"):
            texts[path.as_posix()] = for_students(ROOT / path)
    new = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        for path in [*map(Path, FILES), *found]:
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / path, folder / path)
        for name, text in texts.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8", newline="\n")
    except BaseException:
        for path in new[-1:] or folder.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink(missing_ok=True)
        raise


def is_left_out(name) -> bool:
    """Return whether students do not get a file or a folder of this name.

    A name that begins with a dot is that of an editor's copy, or of what a Mac puts beside a file
    on a foreign disk.
    """
    return name in UNUSED or name.startswith(".")


def for_students(path) -> str:
    """Return the source of a file of src/ without what students write; the docstrings of their
    functions stay.
    """
    source = path.read_text(encoding="utf-8")
    for pattern in CUT:
        source = re.sub(pattern, "", source)
    if "__main__" not in source:
        source = source.replace('"""\n\n', f'"""\n\n{NO_PROGRAM}', 1)
    lines = source.splitlines(keepends=True)
    for function in reversed(
        ast.parse(source).body if f"src/{path.name}" in STUDENTS_FILES else []
    ):
        if isinstance(function, ast.FunctionDef) and function.name in STUDENTS_FUNCTIONS:
            for before, last, indent, words in reversed(places(function)):
                lines[before:last] = [
                    " " * indent + f"# Write your code here, in place of the next line{words}.\n",
                    " " * indent
                    + f'raise NotImplementedError("{function.name} is not written yet")\n',
                ]
    return "".join(lines)


def places(function) -> list[tuple[int, int, int, str]]:
    """Return what students write of a function: its body or, of main, the two calls of their own
    functions.

    Each is (line before, last line, indentation, words that describe it).
    """
    if function.name != "main":
        # The docstring is the first statement
        given = function.body[PROVIDED.get(function.name, 0)]
        return [(given.end_lineno, function.end_lineno, 4, "")]
    words = {ast.Assign: ": make pend_list", ast.Expr: ": one tick"}
    nodes = [node for node in ast.walk(function) if type(node) in words]
    calls = [node for node in nodes if isinstance(getattr(node.value, "func", None), ast.Name)]
    return [
        (node.lineno - 1, node.end_lineno, node.col_offset, words[type(node)]) for node in calls
    ]


if __name__ == "__main__":
    main()
