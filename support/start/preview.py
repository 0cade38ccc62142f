"""Find the functions that a student has not written yet, and show the cradle without them."""

import ast
from contextlib import suppress
from pathlib import Path

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import discard
from support.start.output import refuse

SRC = Path(__file__).resolve().parents[2] / "src"
# The first lines of the statements that the handout provides beside a raise, as ast.unparse writes them.
GIVEN = {
    *("df = pd.read_csv(relative_filepath)", "bad_rep = df.to_dict(orient='index')"),
    *("page.show(pend_list)", "while page.is_running():"),
}


def stubs_in(source) -> dict[str, tuple[int, bool]]:
    """Return the functions in source that still have their raise from tests/make_starter.py, each with its line.

    The bool says whether code stands beside the raise, which stops it. A raise below a return does not count: it never
    runs. Raises a SyntaxError or a ValueError if Python cannot compile the source.
    """
    found: dict[str, tuple[int, bool]] = {}
    for function in ast.parse(source).body:
        name = getattr(function, "name", "")
        for block in (getattr(node, part, ()) for node in ast.walk(function) for part in ("body", "orelse")):
            lines = [ast.unparse(each).partition("\n")[0] for each in block] if isinstance(block, list) else []
            stub = f"raise NotImplementedError('{name} is not written yet')"
            if stub in lines and not any(line.startswith("return") for line in lines[: lines.index(stub)]):
                others = [line for line in lines if line != stub and line not in GIVEN and line[0] not in "'\""]
                found.setdefault(name, (block[lines.index(stub)].lineno, bool(others)))
    return found


def missing_in(*modules) -> str:
    """Return the names of the functions in these modules of src/ that are not written yet, each with its file."""
    places = []
    for file in filter(Path.is_file, (SRC / f"{module}.py" for module in modules)):
        with suppress(SyntaxError, ValueError):  # a file that Python cannot compile: its import shows why
            found = stubs_in(file.read_bytes()).items()
            names = [f"{name} (delete line {line})" if has_code else name for name, (line, has_code) in found]
            places += [f"{', '.join(names)} in src/{file.name}"] * bool(names)
    return "; ".join(places)


def end_if_unwritten(*modules) -> None:
    """If functions in these modules of src/ are missing, name them in one line, and exit with status 2."""
    missing = missing_in(*modules)
    if missing:
        refuse(f"There is no cradle to see yet. Write first: {missing}.")


def what_there_is(main, scope) -> tuple:
    """Return main and no remark, or a simpler loop and a remark that names the missing functions; or exit.

    scope has the handout's functions by their names.
    """
    end_if_unwritten("pds_helper", "special_cradles")
    swings, collides = missing_in("swinging"), missing_in("visualize_cradle_run")
    if swings:
        return preview(scope), f"Write next: {swings}. Then the pendula swing."
    if collides:
        words = "Here are the first two pendula alone: their bobs collide. If not, type pytest."
        if "handle_" in collides:
            words = "Then the bobs collide. If no pendulum swings, type pytest."
        return preview(scope, True, "handle_" not in collides), f"Write next: {collides}. {words}"
    return main, ""


def preview(scope, swings=False, collides=False):
    """Return a loop that makes and moves a cradle with the functions in scope, as far as they are written.

    swings says whether full_swing_update is written, collides whether handle_two_bobs is: then there are two pendula.
    """

    def loop(page):
        cradle = scope["make_newton_cradle"](page.csv, R_PARAM, THETA_INIT)
        while collides and len(cradle) > 2:
            discard(cradle.pop()["objects"])
        page.show(cradle)
        while page.is_running():
            if swings:
                scope["full_swing_update"](cradle, R_PARAM, DT, G)
            if collides and len(cradle) == 2:
                scope["handle_two_bobs"](*cradle, R_PARAM)

    return loop
