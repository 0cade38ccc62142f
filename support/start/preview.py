"""Find the functions that a student has not written yet, and show the cradle without them."""

import ast
from contextlib import suppress
from pathlib import Path

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import discard
from support.start.checks_command import checks_command
from support.start.output import refuse

SRC = Path(__file__).resolve().parents[2] / "src"
# The first lines of the statements that the handout provides beside a raise, as ast.unparse writes
# them.
GIVEN = {
    *("df = pd.read_csv(relative_filepath)", "bad_rep = df.to_dict(orient='index')"),
    *("page.show(pend_list)", "while page.is_running():"),
}


def stubs_in(source) -> dict[str, tuple[int, bool]]:
    """Return the functions in source that still have their raise from tests/make_starter.py, each
    with its line.

    The bool says whether code stands beside the raise, which stops it. A raise below a return does
    not count: it never runs. Raises a SyntaxError or a ValueError if Python cannot compile the
    source.
    """
    found: dict[str, tuple[int, bool]] = {}
    for function in ast.parse(source).body:
        name = getattr(function, "name", "")
        for block in (
            getattr(node, part, ()) for node in ast.walk(function) for part in ("body", "orelse")
        ):
            lines = (
                [ast.unparse(each).partition("\n")[0] for each in block]
                if isinstance(block, list)
                else []
            )
            stub = f"raise NotImplementedError('{name} is not written yet')"
            if stub in lines and not any(
                line.startswith("return") for line in lines[: lines.index(stub)]
            ):
                others = [
                    line
                    for line in lines
                    if line != stub and line not in GIVEN and line[0] not in "'\""
                ]
                found.setdefault(name, (block[lines.index(stub)].lineno, bool(others)))
    return found


def unwritten_in(module) -> dict[str, tuple[int, bool]]:
    """Return what stubs_in returns for a module of src/; without its file, or if Python cannot
    compile it, nothing.
    """
    file = SRC / f"{module}.py"
    with suppress(OSError, SyntaxError, ValueError):  # the import of the file shows why
        return stubs_in(file.read_bytes())
    return {}


def missing_in(*modules, names=None) -> str:
    """Return the functions in these modules of src/ that are not written yet, each with its file,
    in words.

    names are those of the functions that matter; without names, all do.
    """
    places = []
    for module in modules:
        found = []
        for name, (line, has_code) in unwritten_in(module).items():
            if names is None or name in names:
                found.append(f"{name} (delete line {line})" if has_code else name)
        if found:
            places.append(f"{', '.join(found)} in src/{module}.py")
    return "; ".join(places)


def end_if_unwritten(*modules, names=None) -> None:
    """If functions in these modules of src/ are missing, name them in one line, and exit with
    status 2.
    """
    missing = missing_in(*modules, names=names)
    if missing:
        refuse(f"There is no cradle to see yet. Write first: {missing}.")


def what_there_is(main, cradle) -> tuple:
    """Return main and no remark, or a simpler loop and a remark that names the missing functions.

    Exit if functions are missing without which there is no picture: cradle.needs has their names.
    """
    end_if_unwritten("pds_helper", "special_cradles", names=cradle.needs)
    others, swings = missing_in("special_cradles"), missing_in("swinging")
    collides = missing_in("visualize_cradle_run")
    loop, now, words = main, "", ""
    if swings:
        loop, now = preview(cradle.scope), swings
        words = "Then the pendula swing."
    elif collides:
        has_handled = "handle_" not in collides
        loop, now = preview(cradle.scope, True, has_handled), collides
        words = f"Then the bobs collide. If no pendulum swings, type {checks_command()}."
        if has_handled:
            words = f"Here are the first two pendula alone: their bobs collide. If not, type {checks_command()}."
    missing = "; ".join(place for place in (others, now) if place)
    return loop, f"Write next: {missing}. {words}".strip() if missing else ""


def preview(scope, swings=False, collides=False):
    """Return a loop that makes and moves a cradle with the functions in scope, as far as they are
    written.

    swings says whether full_swing_update is written, collides whether handle_two_bobs is: then
    there are two pendula.
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
