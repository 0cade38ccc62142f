"""Find the functions that a student has not written yet, and show the cradle without them."""

import ast
from collections import ChainMap
from collections.abc import Collection, Mapping
from contextlib import suppress
from typing import Any, NamedTuple, Protocol

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.main_page import Loop, Page
from support.pendulum import discard
from support.root import SRC
from support.start.output import refuse

# The first lines of the statements that the handout provides around a raise, as ast.unparse writes
# them.
GIVEN = {
    "df = pd.read_csv(relative_filepath)",
    "bad_rep = df.to_dict(orient='index')",
    "page.show(pend_list)",
    "while page.is_running():",
}


class Stub(NamedTuple):
    """The raise from tests/make_starter.py in a function that is not written yet."""

    line: int
    has_code: bool  # apart from the raise, which stops it


class HasFunctions(Protocol):
    """A cradle, with the functions that make and move it."""

    needs: set[str]  # the names of those without which there is no picture
    scope: ChainMap[str, Any]

    def slow_remark(self) -> str:
        """Return why the program is slow although nobody has changed a function, or ""."""


def stubs_in(source: str | bytes) -> dict[str, Stub]:
    """Return the stub of each function in source that has one, by the function's name.

    Raises a SyntaxError or a ValueError if Python cannot compile the source.
    """
    found: dict[str, Stub] = {}
    for function in ast.parse(source).body:
        name = getattr(function, "name", "")
        for node in ast.walk(function):
            for part in ("body", "orelse"):
                block = getattr(node, part, None)
                stub = stub_in(block, name) if isinstance(block, list) else None
                if stub:
                    found.setdefault(name, stub)
    return found


def stub_in(block: list[ast.stmt], name: str) -> Stub | None:
    """Return the stub of the function with this name in a block of statements.

    A raise below a return is no stub: it never runs.
    """
    stub = f"raise NotImplementedError('{name} is not written yet')"
    lines = [ast.unparse(statement).partition("\n")[0] for statement in block]
    if stub not in lines:
        return None
    place = lines.index(stub)
    if any(line.startswith("return") for line in lines[:place]):
        return None
    code = {line for line in lines if not line.startswith(("'", '"'))} - GIVEN - {stub}
    return Stub(block[place].lineno, has_code=bool(code))


def unwritten_in(module: str) -> dict[str, Stub]:
    """Return the stubs of a module of src/.

    Without its file, or if Python cannot compile it, return none.
    """
    file = SRC / f"{module}.py"
    with suppress(OSError, SyntaxError, ValueError):  # the import of the file shows why
        return stubs_in(file.read_bytes())
    return {}


def missing_in(*modules: str, names: Collection[str] | None = None) -> str:
    """Return the functions in these modules of src/ that are not written yet, with their files.

    names are those of the functions that matter; without names, all do.
    """
    places = []
    for module in modules:
        found = []
        for name, stub in unwritten_in(module).items():
            if names is None or name in names:
                found.append(f"{name} (delete line {stub.line})" if stub.has_code else name)
        if found:
            places.append(f"{', '.join(found)} in src/{module}.py")
    return "; ".join(places)


def end_if_unwritten(*modules: str, names: Collection[str] | None = None) -> None:
    """If functions in these modules of src/ are missing, name them, and exit with status 2."""
    missing = missing_in(*modules, names=names)
    if missing:
        refuse(f"There is no cradle to see yet. Write first: {missing}.")


def what_there_is(main: Loop, cradle: HasFunctions) -> tuple[Loop, str]:
    """Return main, or a simpler loop, and a remark: the missing functions, or why main is slow.

    The remark can be empty.
    Exit if functions are missing without which there is no picture.
    """
    end_if_unwritten("pds_helper", "special_cradles", names=cradle.needs)
    others = missing_in("special_cradles")
    for_swings = missing_in("swinging")
    for_hits = missing_in("visualize_cradle_run")
    loop = main
    sentence = ""
    if for_swings:
        loop = preview(cradle.scope)
        sentence = "Then the pendula swing."
    elif for_hits:
        collision = {"handle_collision", "handle_two_bobs"}
        collides = not missing_in("visualize_cradle_run", names=collision)
        loop = preview(cradle.scope, swings=True, collides=collides)
        if collides:
            sentence = (
                "Here are the first two pendula alone: their bobs collide. If not, type pytest."
            )
        else:
            sentence = "Then the bobs collide. If no pendulum swings, type pytest."
    missing = "; ".join(place for place in (others, for_swings or for_hits) if place)
    if missing:
        return loop, f"Write next: {missing}. {sentence}".strip()
    return loop, cradle.slow_remark()


def preview(scope: Mapping[str, Any], swings: bool = False, collides: bool = False) -> Loop:
    """Return a loop that makes and moves a cradle with the functions in scope that are written.

    swings says whether full_swing_update is written, collides whether handle_two_bobs is: then
    there are two pendula.
    """

    def loop(page: Page) -> None:
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
