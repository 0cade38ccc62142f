"""Find the functions that a student has not written yet."""

import dis
from pathlib import Path
from types import CodeType

SRC = Path(__file__).resolve().parents[2] / "src"


def unwritten(*modules) -> str:
    """Return the names of the functions in these modules of src/ that are not written yet, each with its file.

    Such a function still has the raise from tests/make_starter.py. A raise below a return does not count: Python does
    not compile code that can never run. A file that Python cannot compile counts as written: its import shows why.
    """
    places = []
    for file in filter(Path.is_file, (SRC / f"{module}.py" for module in modules)):
        try:
            code = compile(file.read_bytes(), file, "exec")
        except (SyntaxError, ValueError):
            continue
        names = [function.co_name for function in functions_in(code) if is_unwritten(function)]
        if names:
            places.append(f"{', '.join(names)} in src/{file.name}")
    return "; ".join(places)


def functions_in(code) -> list[CodeType]:
    """Return the code of the functions in the code of a file."""
    return [constant for constant in code.co_consts if isinstance(constant, CodeType)]


def is_unwritten(code) -> bool:
    """Return whether the code of a function still has its raise from tests/make_starter.py."""
    says_so = f"{code.co_name} is not written yet"
    return any(instruction.argval == says_so for instruction in dis.get_instructions(code))
