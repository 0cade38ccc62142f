"""Make what a student is handed: `python tests/make_starter.py FOLDER`.

It is the project with the bodies of the handout's functions taken out, and of tests/ what grades them.
"""

import ast
import shutil
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from support import headless_vpython

headless_vpython.install()

from handout import FUNCTIONS, SUITES

from support.options import OneLineParser

FILES = [
    *(".gitignore", "newton_cradle_pends.csv", "pds_tester.py", "pyproject.toml"),
    *(f"tests/{name}.py" for name in ("grade", "grader", "handout", "pytest_grader", "telling")),
    *("tests/cradles.py", "tests/watch.py"),
    *(f"tests/{suite}.py" for suite in SUITES.values()),
]
FOLDERS = ["src", "support"]
UNUSED = ["__pycache__", "double.png", "swing.png"]
PROVIDED = {"extract_and_convert": 2}  # how many statements the handout provides, at the beginning of a body

README = """\
# Newton's cradle

![The page with the cradle, as it will be](support/pictures/page.png)

This is the project of the handout, without the functions that are yours to write. Each of them has a place marked with
*Write your code here*. `pytest` checks them, and says after each run what is next.

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

**Test**: all; one grade's checks only; these up to the first that fails.

    .venv/bin/pytest
    .venv/bin/pytest --tier D
    .venv/bin/pytest --tier D -x

Where what is wrong can be watched, the message ends with the command that plays it in the terminal.

**See** the data as soon as you like, and the cradle once all but the honor roll is written; in the terminal, too:

    .venv/bin/python pds_tester.py
    .venv/bin/python src/visualize_cradle_run.py
    .venv/bin/python src/text_cradle_run.py

and the double cradle once the honor roll is written:

    .venv/bin/python src/visualize_double_cradle_run.py

The programs do many ticks at once, by `advance_cradle` with your `angle_update` and `handle_collision`; your
`handle_two_bobs` and `newton_cradle_tick` say what such ticks have to do, and are checked by `pytest`. The cradle's CSV
is `newton_cradle_pends.csv`, in this folder.
"""


def main() -> None:
    """Make the folder; status 2 if it cannot be had."""
    parser = OneLineParser(description="Make what a student is handed.", allow_abbrev=False)
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="a folder to be made, or an empty one")
    folder = parser.parse_args().folder
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        parser.error(f"argument FOLDER: found '{folder}', allowed is a new folder, or an empty one")
    try:
        make_starter(folder)
    except OSError as error:
        parser.error(f"argument FOLDER: {folder} cannot be made: {error.strerror}")
    print(f"{folder} is ready, with {len(FUNCTIONS)} functions to be written. Its README.md says how to begin.")


def make_starter(folder) -> None:
    """Make the folder, or fill it; raises an OSError if that cannot be done."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        made = Path(work)
        for name in FOLDERS:
            shutil.copytree(ROOT / name, made / name, ignore=shutil.ignore_patterns(*UNUSED))
        for name in FILES:
            (made / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, made / name)
        for file in {function.file for function in FUNCTIONS.values()}:
            path = made / file
            path.write_text(emptied(path.read_text(encoding="utf-8")), encoding="utf-8", newline="\n")
        rows = (f"| {of.tier} | `{name}` | `{of.file}` |" for name, of in FUNCTIONS.items())
        readme = README.format(rows="\n".join(rows))
        (made / "README.md").write_text(readme, encoding="utf-8", newline="\n")
        shutil.copytree(made, folder, dirs_exist_ok=True)


def emptied(source) -> str:
    """Return the source of a module without the bodies of the handout's functions, but with their docstrings."""
    lines = source.splitlines()
    for node in reversed(ast.parse(source).body):
        if isinstance(node, ast.FunctionDef) and node.name in FUNCTIONS:
            kept = node.body[PROVIDED.get(node.name, 0)]  # the docstring is the first statement
            lines[kept.end_lineno : node.end_lineno] = [
                "    # Write your code here, in place of the next line.",
                f'    raise NotImplementedError("{node.name} is not written yet")',
            ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
