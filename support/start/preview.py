"""Find the functions that a student has not written yet, and show the cradle without them."""

import dis
import inspect
from pathlib import Path
from types import CodeType

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.start.output import refuse

SRC = Path(__file__).resolve().parents[2] / "src"
CONSTANTS = {"r_param": R_PARAM, "theta_init": THETA_INIT, "dt": DT, "g": G}


def is_unwritten(code) -> bool:
    """Return whether the code of a function still has its raise from tests/make_starter.py.

    A raise below a return does not count: Python does not compile code that can never run.
    """
    says_so = f"{code.co_name} is not written yet"
    return any(instruction.argval == says_so for instruction in dis.get_instructions(code))


def missing_in(*modules) -> str:
    """Return the names of the functions in these modules of src/ that are not written yet, each with its file.

    A file that Python cannot compile counts as written: its import shows why.
    """
    places = []
    for file in filter(Path.is_file, (SRC / f"{module}.py" for module in modules)):
        try:
            code = compile(file.read_bytes(), file, "exec")
        except (SyntaxError, ValueError):
            continue
        functions = [constant for constant in code.co_consts if isinstance(constant, CodeType)]
        names = [function.co_name for function in functions if is_unwritten(function)]
        if names:
            places.append(f"{', '.join(names)} in src/{file.name}")
    return "; ".join(places)


def end_if_unwritten(*modules) -> None:
    """If functions in these modules of src/ are missing, name them in one line, and exit with status 2."""
    missing = missing_in(*modules)
    if missing:
        refuse(f"There is no cradle to see yet. Write first: {missing}.")


def what_there_is(main) -> tuple:
    """Return main and an empty remark or, while functions are missing, a simpler loop and a remark that names them.

    If there is nothing to see yet, print one line and exit with status 2.
    """
    end_if_unwritten("pds_helper", "special_cradles")
    swings, collides = missing_in("swinging"), missing_in("visualize_cradle_run")
    if swings:
        remark = f"Write next: {swings}. Then the pendula swing."
        return preview(main.__globals__, None), remark
    if collides:
        remark = f"Write next: {collides}. Then the bobs collide."
        return preview(main.__globals__, "full_swing_update"), remark
    return main, ""


def preview(scope, moved_by):
    """Return a loop like main's, with the functions in scope; moved_by names the one for a tick, or is None."""

    def call(name, first):
        """Call a function of the scope with first, and with the constants that have its parameters' names."""
        _, *others = inspect.signature(scope[name]).parameters
        return scope[name](first, *(CONSTANTS[other] for other in others))

    def loop(page):
        made = None
        while page.is_running():
            if page.wants_cradle():
                page.show(made := call("make_newton_cradle", page.csv))
            while page.wants_tick():
                if moved_by:
                    call(moved_by, made)

    return loop
