"""The functions of the handout: their files, their places in the handout, and the functions that
they use.
"""

from itertools import takewhile
from typing import NamedTuple

HONOR = "Honor roll"
# By tier, in order
SUITES = {"D": "test_d", "C": "test_c", "B": "test_b", "A": "test_a", HONOR: "test_honor_roll"}


def highest(points, most) -> str | None:
    """Return the highest complete tier, with all tiers below it complete, or None; both are numbers
    by tier.
    """
    return [None, *takewhile(lambda tier: tier in points and points[tier] == most[tier], SUITES)][
        -1
    ]


class Function(NamedTuple):
    tier: str
    file: str
    parameters: str
    read: str  # place in the handout
    calls: tuple[str, ...] = ()  # the other functions here that it uses
    reads: tuple[str, ...] = ()  # keys of a pendulum that messages show
    returns: str = ""  # names of what it returns; without, it returns nothing
    given: tuple[str, ...] = ()  # functions that it uses, and that are there

    @property
    def uses(self) -> tuple[str, ...]:
        """The functions that it calls itself."""
        return self.given or self.calls


SPECIAL, SWINGING = "src/special_cradles.py", "src/swinging.py"
RUN, DOUBLE = "src/visualize_cradle_run.py", "src/double_cradle.py"

CONVERTER, CREATION = "A CVS to pend_list converter (D Tests)", "Pendulum Creation (D Tests)"
SWING = "Swing Implementation (C Tests), and Appendix: Physics Derivations"
COLLISIONS = "Handling Collisions (B Tests), and Appendix: Conservation Laws"
RUNNING, CHALLENGE = "Running the Simulation (A Tests)", "Honor Roll Challenge"


def maker(parameters, uses, *given) -> Function:
    """Return a function that makes a pend_list from a CSV, and uses this other function, and those
    that are given.
    """
    return Function("D", SPECIAL, parameters, CREATION, (uses,), returns="pend_list", given=given)


# In the order of the handout.
FUNCTIONS = {
    "extract_and_convert": Function(
        "D", "src/pds_helper.py", "relative_filepath", CONVERTER, returns="pend_list"
    ),
    "uniform_mass_newton_cradle": maker("relative_filepath, mass", "extract_and_convert"),
    "uniform_e_newton_cradle": maker("relative_filepath, e_val", "extract_and_convert"),
    "elastic_newton_cradle": maker("relative_filepath", "uniform_e_newton_cradle"),
    "inelastic_newton_cradle": maker("relative_filepath", "uniform_e_newton_cradle"),
    "make_newton_cradle": maker(
        "relative_filepath, r_param, theta_init", "extract_and_convert", "make_pendulum"
    ),
    "angle_update": Function(
        "C", SWINGING, "omega, theta, r_param, dt, g", SWING, returns="omega_new, theta_new"
    ),
    "full_swing_update": Function(
        "C",
        SWINGING,
        "pend_list, r_param, dt, g",
        SWING,
        ("angle_update",),
        ("theta", "omega"),
        given=("swing_update",),
    ),
    "handle_collision": Function(
        *("B", RUN, "e, omega1, omega2, m1, m2, r_param", COLLISIONS),
        returns="new_omega1, new_omega2",
    ),
    "handle_two_bobs": Function(
        "B",
        RUN,
        "pend1, pend2, r_param",
        COLLISIONS,
        ("handle_collision",),
        ("mass", "e", "omega", "bob", "radius"),
    ),
    "newton_cradle_tick": Function(
        *("A", RUN, "pend_list, r_param, dt, g", RUNNING, ("full_swing_update", "handle_two_bobs")),
        reads=("mass", "e", "theta", "omega", "bob"),
    ),
    "main": Function("A", RUN, "page", RUNNING, ("make_newton_cradle", "newton_cradle_tick")),
    "make_double_pendulum": Function(
        *(HONOR, DOUBLE, "axle_pos, r_param, theta, phi, color, texture", CHALLENGE),
        returns="axle, bob1, cord1, bob2, cord2",
        given=("make_pendulum",),
    ),
    "double_angle_update": Function(
        *(HONOR, DOUBLE, "omega_theta, omega_phi, theta, phi, r_param, dt, g, m1, m2", CHALLENGE),
        returns="omega_theta, omega_phi, theta, phi",
        given=("double_accelerations",),
    ),
}

# The functions that a starter provides in src/ beside these.
GIVEN = {
    *("write_to_csv", "swing_update", "make_double_newton_cradle"),
    *("double_accelerations", "double_swing_update", "double_cradle_tick"),
}

# The names that the files of the handout import.
IMPORTS = {
    "src/pds_helper.py": "pd PendulumEntry",
    SPECIAL: "vector extract_and_convert COLOR_MAP TEXTURE_MAP make_pendulum PendulumEntry",
    SWINGING: "sin show_pendulum",
    RUN: "mag make_newton_cradle full_swing_update DT G R_PARAM THETA_INIT",
    DOUBLE: "vector make_bob_and_cord make_pendulum double_accelerations",
}


def needed(function) -> list[str]:
    """Return all functions that this one uses, directly or not, in the order of the handout."""
    found = {name for called in FUNCTIONS[function].calls for name in (called, *needed(called))}
    return [name for name in FUNCTIONS if name in found]


def is_students(name, function) -> bool:
    """Return whether a student wrote a function of this name for this one of the handout: itself,
    or a helper.
    """
    return name == function or name not in FUNCTIONS and name not in GIVEN and name != "<lambda>"


def module_of(file) -> str:
    """Return the module name of a file of the project."""
    return file.removesuffix(".py").replace("/", ".")
