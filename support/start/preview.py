"""Show as much of the cradle as you have written, and name the function to write next.

A function that is not written yet raises a NotImplementedError.
"""

from collections import ChainMap
from importlib import import_module
from traceback import extract_tb
from typing import Any

from support import constants
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.pendulum import discard, Pendulum
from support.simulation import is_running
from support.start.mistake import place_of, require_pendula

# The modules with functions of the handout, beside the program
MODULES = ("src.pds_helper", "src.special_cradles", "src.swinging")


class UnwrittenError(NotImplementedError):
    """There is no cradle to see yet: a function that makes it is missing."""

    def __init__(self, name: str, place: str) -> None:
        """Name the missing function, and the place where it must be written."""
        super().__init__(f"There is no cradle to see yet. Write next: {name} ({place}).")


def preview(names: dict[str, Any], error: NotImplementedError, remarks: list[str]) -> None:
    """Show the cradle with the functions that are written; the next one goes into remarks.

    names are those of the program, which has raised this error. Raises an UnwrittenError if there
    is no cradle yet, and the error if it comes from an import.
    """
    if "newton_cradle_tick" not in names:
        raise error
    written = Written(names)
    pend_list = written.make_cradle()
    written.note(error)

    swing = ("full_swing_update", pend_list, R_PARAM, DT, G)
    calls: list[tuple] = []  # of a tick
    if written.is_missing("angle_update", "full_swing_update"):
        sight = "With tier C, the pendula swing. If they hang wrong, type pytest."
    elif written.is_missing("handle_collision", "handle_two_bobs"):
        calls = [swing]
        sight = "With tier B, two bobs collide. If no pendulum swings, type pytest."
    elif written.is_missing("newton_cradle_tick"):
        while len(pend_list) > 2:
            discard(pend_list.pop()["objects"])
        calls = [swing, ("handle_two_bobs", pend_list[0], pend_list[-1], R_PARAM)]
        sight = "Here are the first two pendula alone: their bobs collide. If not, type pytest."
    else:
        calls = [("newton_cradle_tick", pend_list, R_PARAM, DT, G)]
        sight = "Here, newton_cradle_tick moves all pendula. If it does not, type pytest."
    name, place = written.next()
    remarks.append(f"Write next: {name} ({place}). {sight}")
    while is_running(pend_list):
        for function, *arguments in calls:
            written.functions[function](*arguments)


class Written:
    """The functions of the handout, as they are written."""

    def __init__(self, names: dict[str, Any]) -> None:
        """names are those of the program."""
        self.functions = ChainMap(names, *(vars(import_module(name)) for name in MODULES))
        self.missing: dict[str, str] = {}  # the places of those that are not, by their names

    def make_cradle(self) -> list[Pendulum]:
        """Return the cradle; call each function once, in the order of the handout.

        Raises an UnwrittenError if the functions that make the cradle are missing, and a
        MistakeError if it has no pendula.
        """
        path = constants.NC_FP
        self.call("extract_and_convert", path)
        self.call("uniform_mass_newton_cradle", path, 1.0)
        self.call("uniform_e_newton_cradle", path, 1.0)
        self.call("elastic_newton_cradle", path)
        self.call("inelastic_newton_cradle", path)
        make = self.functions["make_newton_cradle"]
        try:
            pend_list = make(path, R_PARAM, THETA_INIT)
        except NotImplementedError as error:
            self.note(error)
            raise UnwrittenError(*self.next()) from None
        require_pendula(make, pend_list, keys=(), parts=3)
        self.call("angle_update", 0.0, 0.0, R_PARAM, DT, G)
        self.call("full_swing_update", [], R_PARAM, DT, G)
        self.call("handle_collision", 1.0, 0.0, 0.0, 1.0, 1.0, R_PARAM)
        self.call("handle_two_bobs", dict(pend_list[0]), dict(pend_list[-1]), R_PARAM)
        self.call("newton_cradle_tick", [], R_PARAM, DT, G)
        return pend_list

    def call(self, name: str, *arguments: Any) -> None:
        """Note whether a function is missing, by a call that changes nothing."""
        try:
            self.functions[name](*arguments)
        except NotImplementedError as error:
            self.note(error)
        except Exception:
            pass  # it will show in the cradle

    def note(self, error: NotImplementedError) -> None:
        """Note that the function that has raised this error is missing, or the program."""
        name, place = missing_in(error)
        self.missing.setdefault(name, place)

    def is_missing(self, *names: str) -> bool:
        """Return whether one of these functions is missing."""
        return not self.missing.keys().isdisjoint(names)

    def next(self) -> tuple[str, str]:
        """Return the first function that is missing, and its place."""
        return next(iter(self.missing.items()))


def missing_in(error: NotImplementedError) -> tuple[str, str]:
    """Return the name of the function that has raised this error, and its place."""
    frame = extract_tb(error.__traceback__)[-1]
    name = "the program" if frame.name == "<module>" else frame.name
    return name, place_of(frame.filename, frame.lineno)
