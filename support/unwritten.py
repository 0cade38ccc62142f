"""A project in which functions are still to be written, as students get it: the programs say so before they begin."""

import re
import sys
from pathlib import Path

SRC = Path(__file__).resolve().parents[1] / "src"

# What stands in such a function: tests/make_starter.py has put it there.
STUB = re.compile(r'^ +raise NotImplementedError\("(\w+) is not written yet"\)', re.MULTILINE)


def unwritten(*modules) -> dict[str, str]:
    """Return where the functions in these modules of src/ are that are not written yet, by their names."""
    places = {}
    for file in filter(Path.is_file, (SRC / f"{module}.py" for module in modules)):
        source = file.read_text(encoding="utf-8", errors="replace")
        for stub in STUB.finditer(source):
            places[stub[1]] = f"src/{file.name}, line {source.count(chr(10), 0, stub.start()) + 1}"
    return places


def end_if_unwritten(*modules) -> None:
    """If a function in these modules of src/ is not written yet, name all of them and end the program with status 2."""
    missing = unwritten(*modules)
    if missing:
        lines = ["There is no cradle to be seen yet. Still to be written:"]
        lines += [f"    {name} in {place}" for name, place in missing.items()]
        print(*lines, "`pytest` tells which one is next.", sep="\n", file=sys.stderr)
        sys.exit(2)
