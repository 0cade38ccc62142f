"""Show the cradle while functions of the handout are missing."""

import inspect

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.start.output import refuse
from support.start.unwritten import unwritten

CONSTANTS = {"r_param": R_PARAM, "theta_init": THETA_INIT, "dt": DT, "g": G}


def end_if_unwritten(*modules) -> None:
    """If functions in these modules of src/ are missing, name them in one line, and exit with status 2."""
    missing = unwritten(*modules)
    if missing:
        refuse(f"There is no cradle to see yet. Write first: {missing}.")


def what_there_is(main) -> tuple:
    """Return main and an empty remark or, while functions are missing, a simpler loop and a remark that names them.

    If there is nothing to see yet, print one line and exit with status 2.
    """
    end_if_unwritten("pds_helper", "special_cradles")
    swings, collides = unwritten("swinging"), unwritten("visualize_cradle_run")
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
