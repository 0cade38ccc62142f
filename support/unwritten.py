"""A project in which functions are still to be written, as students get it: the programs say so before they begin."""

import re
import sys
from pathlib import Path

SRC = Path(__file__).resolve().parents[1] / "src"
STUB = re.compile(r'raise NotImplementedError\("(\w+) is not written yet"\)')  # as tests/make_starter.py leaves it


def unwritten(*modules) -> list[str]:
    """Return the functions in these modules of src/ that are not written yet, each as "name in file"."""
    sources = {module: (SRC / f"{module}.py").read_text(encoding="utf-8") for module in modules}
    return [f"{name} in src/{module}.py" for module in modules for name in STUB.findall(sources[module])]


def end_if_unwritten(*modules) -> None:
    """If a function in these modules of src/ is not written yet, name all of them and end the program with status 2."""
    missing = unwritten(*modules)
    if missing:
        lines = ["There is no cradle to be seen yet. Still to be written:", *(f"    {name}" for name in missing)]
        print(*lines, "`pytest` tells which one is next.", sep="\n", file=sys.stderr)
        sys.exit(2)
