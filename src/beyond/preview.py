"""What there is to see of a cradle as long as functions of the handout are still to be written."""

import inspect
import sys

from support.constants import DT, G, R_PARAM, THETA_INIT
from support.start.unwritten import unwritten

CONSTANTS = {"r_param": R_PARAM, "theta_init": THETA_INIT, "dt": DT, "g": G}


def end_if_unwritten(*modules) -> None:
    """If functions in these modules of src/ are still to be written, name them in one line, and end with status 2."""
    missing = unwritten(*modules)
    if missing:
        print(f"There is no cradle to be seen yet. Still to be written: {missing}.", file=sys.stderr)
        sys.exit(2)


def what_there_is(main) -> tuple:
    """Return main, and no remark; or a loop that shows what there is, and a line that says what is still to be written.

    If there is nothing to be seen yet, end the program with one line and status 2.
    """
    end_if_unwritten("pds_helper", "special_cradles")
    swings, collides = unwritten("swinging"), unwritten("visualize_cradle_run")
    if swings:
        remark = f"Still to be written: {swings}. Then the pendula swing."
        return preview(main.__globals__, None), remark
    if collides:
        remark = f"Still to be written: {collides}. Then the bobs collide."
        return preview(main.__globals__, "full_swing_update"), remark
    return main, ""


def preview(scope, moved_by):
    """Return a loop like main's, for functions of this scope: what moves the cradle is moved_by, or nothing."""

    def call(name, first):
        """Call a function of the scope with the constants that its parameters are named after."""
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
