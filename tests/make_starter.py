"""Make the folder that students get: `python tests/make_starter.py FOLDER`.

It is the project without the bodies of the handout's functions. Of tests/, it has only the graded tests.
"""

import ast
import re
import shutil
import sys
from contextlib import suppress
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent))  # so that Python finds grading, also with -P

from grading.project_path import ROOT
from support import headless_vpython

headless_vpython.install()

from grading.handout import FUNCTIONS, SUITES
from support.start.options import OneLineParser
from support.start.output import in_one_line, while_it_is_read

FILES = [
    *(".gitignore", "newton_cradle_pends.csv", "pds_tester.py", "pyproject.toml"),
    "tests/watch.py",
    *(f"tests/{suite}.py" for suite in SUITES.values()),
]
FOLDERS = ["src", "support", "tests/grading"]
# Pictures of the READMEs, and files with answers: src/README.md, the fast path, the collisions of the double cradle.
UNUSED = {
    *("__pycache__", "README.md", "double.png", "experiment.png", "swing.png"),
    *("many_ticks.py", "double_collisions.py"),
}
PROVIDED = {"extract_and_convert": 2}  # statements that the handout provides at the start of a body

RUN, DOUBLE_RUN = "src/visualize_cradle_run.py", "src/visualize_double_cradle_run.py"
# Functions of the honor roll without a check, by their file.
UNGRADED = {"src/double_cradle.py": ["double_cradle_tick"], DOUBLE_RUN: ["main"]}
# Names that the bodies need, as the handout says: the files still import them.
OFFERED = {
    *("COLOR_MAP", "DOUBLE_DT", "DT", "G", "PHI_INIT", "R_PARAM", "TEXTURE_MAP", "THETA_INIT", "cos", "mag", "sin"),
    *(
        "double_cradle_tick",
        "extract_and_convert",
        "full_swing_update",
        "make_bob_and_cord",
        "make_double_newton_cradle",
    ),
    *("make_newton_cradle", "make_pendulum", "vector"),
}
RULE = "    page.rule has the value of approaching_only, if the functions have this parameter.\n"
# Changes in the students' files: they have the lines of the handout, and nothing beyond it.
CHANGES = [
    ("pyproject.toml", re.compile(r"\n\[tool\.ruff\].*", re.DOTALL), ""),
    ("src/pds_helper.py", "pd.read_csv(cleaned(relative_filepath), **EXACT_FLOATS)", "pd.read_csv(relative_filepath)"),
    ("src/pds_helper.py", re.compile(r"# pandas reads floats .*?\n\n\n", re.DOTALL), "\n"),
    ("src/pds_helper.py", re.compile(r"\n\n    Spaces around names .*?\n    (?=\"\"\")", re.DOTALL), ""),
    ("src/special_cradles.py", re.compile(r"    Raises a ValueError .*?\n"), ""),
    ("src/swinging.py", "from math import sin\n", "from math import cos, sin\n\nfrom vpython import vector\n"),
    (RUN, re.compile(r"# Python 3.9 has no pairwise.*?\n"), ""),
    (RUN, re.compile(r", approaching_only=False(?=\))"), ""),
    (RUN, re.compile(r"    With approaching_only.*?\n"), ""),
    (RUN, RULE, ""),
    (RUN, re.compile(r" *from src.beyond.many_ticks import many_ticks\n"), ""),
    (RUN, "show_cradle(main, many_ticks)", "show_cradle(main)"),
    ("src/text_cradle_run.py", "from src.beyond.many_ticks import many_ticks\n", ""),
    ("src/text_cradle_run.py", ", many_ticks)", ")"),
    ("src/double_cradle.py", "import box, cylinder, sphere\n", "import box, cylinder, sphere, vector\n"),
    ("src/double_cradle.py", ", approaching_only=True)", ")"),
    ("src/double_cradle.py", re.compile(r"\n\n    With approaching_only.*?\n    (?=\"\"\")"), ""),
    (DOUBLE_RUN, RULE, ""),
]

README = """\
# Newton's cradle

![The page with the cradle, as it will be](support/pictures/page.png)

This is the project of the handout. You write the missing functions. Each has a place with the mark *Write your code
here*. `pytest` checks your functions and names the next one.

**Install**, in this folder, with Python 3.10 or later:

    python3 -m venv .venv && .venv/bin/pip install -q --no-deps -r support/requirements.txt
    .venv/bin/pip install -q "pytest>=8.4"

On Windows, type these lines one by one. If there is no `py`, type `python`. Everywhere below, type `.venv\\Scripts\\`
in place of `.venv/bin/`.

    py -m venv .venv
    .venv\\Scripts\\pip install -q --no-deps -r support\\requirements.txt
    .venv\\Scripts\\pip install -q "pytest>=8.4"

**Write**, in this order:

| for | function | in |
|---|---|---|
{rows}

**Test** all functions, the functions of one grade, or these up to the first check that fails:

    .venv/bin/pytest
    .venv/bin/pytest --tier D
    .venv/bin/pytest --tier D -x

Some messages end with the command *watch*, which plays your mistake in the terminal.

**See** your work: first the data, then the cradle in the browser or in the terminal. The cradle appears when you have
written the functions for D. It swings with those for C, and its bobs collide with those for B and A. A line names the
missing functions.

    .venv/bin/python pds_tester.py
    .venv/bin/python src/visualize_cradle_run.py
    .venv/bin/python src/text_cradle_run.py

When you have written the honor roll, see the double cradle:

    .venv/bin/python src/visualize_double_cradle_run.py

The programs run your functions. Change one, start the program again, and see the effect. The cradle's CSV is
`newton_cradle_pends.csv`, in this folder.

The honor roll has three more places without a check: `double_cradle_tick`, in which you decide how two double pendula
collide, and the two calls in `main` of `src/visualize_double_cradle_run.py`.
"""


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
    line = f"{folder} is ready. Students write {len(FUNCTIONS)} functions in it. Its README.md says how to begin."
    print(in_one_line(line))


def make_starter(folder) -> None:
    """Make the folder, or fill an empty one; if this fails, leave nothing behind, and raise an OSError."""
    new = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        fill(folder)
    except BaseException:
        for path in folder.iterdir() if folder.is_dir() else ():
            shutil.rmtree(path) if path.is_dir() else path.unlink()
        for path in new:
            with suppress(OSError):  # it was not made yet
                path.rmdir()
        raise


def fill(folder) -> None:
    """Write all files of the starter into an empty folder."""
    found = [path.relative_to(ROOT) for name in FOLDERS for path in (ROOT / name).rglob("*") if path.is_file()]
    for path in [*map(Path, FILES), *(path for path in found if not UNUSED.intersection(path.parts))]:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, folder / path)
    for file in sorted({change[0] for change in CHANGES} | {function.file for function in FUNCTIONS.values()}):
        path = folder / file
        path.write_text(for_students(file, path.read_text(encoding="utf-8")), encoding="utf-8", newline="\n")
    rows = (f"| {of.tier} | `{name}` | `{of.file}` |" for name, of in FUNCTIONS.items())
    readme = README.format(rows="\n".join(rows))
    (folder / "README.md").write_text(readme, encoding="utf-8", newline="\n")


def for_students(file, source) -> str:
    """Return the source of a file in the form for students."""
    for of, before, after in CHANGES:
        if of == file:
            source, count = re.subn(before if isinstance(before, re.Pattern) else re.escape(before), after, source)
            assert count, f"{file} has no {before}"
    if not file.endswith(".py"):
        return source
    graded = [name for name, function in FUNCTIONS.items() if function.file == file]
    return without_imports(emptied(source, graded + UNGRADED.get(file, [])))


def emptied(source, names) -> str:
    """Return the source of a module without the bodies of these functions, but with their docstrings.

    main loses only its two calls of the student's own functions.
    """
    lines = source.splitlines()
    for node in reversed(ast.parse(source).body):
        if isinstance(node, ast.FunctionDef) and node.name in names:
            first = node.body[PROVIDED.get(node.name, 0)].end_lineno  # the docstring is the first statement
            taken = own_calls(node) if node.name == "main" else [(first, node.end_lineno, 4, "")]
            for start, end, indent, what in reversed(taken):
                lines[start:end] = [
                    " " * indent + f"# Write your code here, in place of the next line{what}.",
                    " " * indent + f'raise NotImplementedError("{node.name} is not written yet")',
                ]
    return "\n".join(lines) + "\n"


def own_calls(main) -> list[tuple[int, int, int, str]]:
    """Return the statements of main that call the student's own functions.

    Each is (line before, last line, indentation, words that describe it).
    """
    return [
        (
            node.lineno - 1,
            node.end_lineno,
            node.col_offset,
            ": make pend_list" if isinstance(node, ast.Assign) else ": one tick",
        )
        for node in ast.walk(main)
        if isinstance(node, (ast.Assign, ast.Expr)) and isinstance(node.value, ast.Call)
        if isinstance(node.value.func, ast.Name)
    ]


def without_imports(source) -> str:
    """Return the source of a module without the imports that neither the code nor the student needs."""
    tree = ast.parse(source)
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} | OFFERED
    lines = source.splitlines()
    for node in reversed([node for node in tree.body if isinstance(node, ast.ImportFrom)]):
        names = [alias.name for alias in node.names if alias.name in used]
        if len(names) < len(node.names):
            lines[node.lineno - 1 : node.end_lineno] = [f"from {node.module} import {', '.join(names)}"] * bool(names)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
