"""The functions of the assignment: their files, their places in it, and those that they need."""

from typing import NamedTuple

HONOR = "Honor roll"
# The files of the checks by tier, in order
SUITES = {"D": "test_d", "C": "test_c", "B": "test_b", "A": "test_a", HONOR: "test_honor_roll"}


class Function(NamedTuple):
    """A function that students write."""

    tier: str
    file: str
    parameters: str
    waits_for: tuple[str, ...] = ()  # functions here that must be right first
    # What a line of it must name, if not the functions that it waits for. If none does, a student
    # reads: No line of your function calls ...
    must_name: tuple[str, ...] = ()
    reads: tuple[str, ...] = ()  # keys of a pendulum that messages show
    returns: str = ""  # names of what it returns; "" if it returns nothing


SPECIAL = "src/special_cradles.py"
SWINGING = "src/swinging.py"
VISUALIZE_FILE = "src/visualize_cradle_run.py"
DOUBLE = "src/double_cradle.py"
# The block below `if __name__ == "__main__":`, which makes and moves the cradle. It runs, with its
# file, as when the file is started.
PROGRAM = "the program"


def maker(parameters: str, waits_for: str) -> Function:
    """Return a function that makes a pend_list from a CSV."""
    return Function("D", SPECIAL, parameters, (waits_for,), returns="pend_list")


# In the order of the assignment.
FUNCTIONS = {
    "extract_and_convert": Function(
        "D", "src/pds_helper.py", "relative_filepath", returns="pend_list"
    ),
    "uniform_mass_newton_cradle": maker("relative_filepath, mass", "extract_and_convert"),
    "uniform_e_newton_cradle": maker("relative_filepath, e_val", "extract_and_convert"),
    "elastic_newton_cradle": maker("relative_filepath", "uniform_e_newton_cradle"),
    "inelastic_newton_cradle": maker("relative_filepath", "uniform_e_newton_cradle"),
    "make_newton_cradle": maker(
        "relative_filepath, r_param, theta_init", "extract_and_convert"
    )._replace(must_name=("make_pendulum",)),
    "angle_update": Function(
        "C", SWINGING, "omega, theta, r_param, dt, g", returns="omega_new, theta_new"
    ),
    "full_swing_update": Function(
        "C",
        SWINGING,
        "pend_list, r_param, dt, g",
        waits_for=("angle_update",),
        must_name=("swing_update",),
        reads=("theta", "omega"),
    ),
    "handle_collision": Function(
        "B",
        VISUALIZE_FILE,
        "e, omega1, omega2, m1, m2, r_param",
        returns="new_omega1, new_omega2",
    ),
    "handle_two_bobs": Function(
        "B",
        VISUALIZE_FILE,
        "pend1, pend2, r_param",
        waits_for=("handle_collision",),
        reads=("mass", "e", "omega", "bob", "radius"),
    ),
    "newton_cradle_tick": Function(
        "A",
        VISUALIZE_FILE,
        "pend_list, r_param, dt, g",
        waits_for=("full_swing_update", "handle_two_bobs"),
        reads=("mass", "e", "theta", "omega", "bob"),
    ),
    PROGRAM: Function(
        "A",
        VISUALIZE_FILE,
        "",
        waits_for=("make_newton_cradle", "newton_cradle_tick"),
    ),
    "make_double_pendulum": Function(
        HONOR,
        DOUBLE,
        "axle_pos, r_param, theta, phi, color, texture",
        must_name=("make_pendulum",),
        returns="axle, bob1, cord1, bob2, cord2",
    ),
    "double_angle_update": Function(
        HONOR,
        DOUBLE,
        "omega_theta, omega_phi, theta, phi, r_param, dt, g, m1, m2",
        must_name=("double_accelerations",),
        returns="omega_theta, omega_phi, theta, phi",
    ),
}

# The other functions that a starter provides in src/.
GIVEN = {
    "write_to_csv",
    "swing_update",
    "make_double_newton_cradle",
    "double_accelerations",
    "double_swing_update",
    "double_cradle_tick",
}

# The names that the files of the assignment import.
IMPORTS = {
    "src/pds_helper.py": "pd PendulumEntry",
    SPECIAL: "vector extract_and_convert COLOR_MAP TEXTURE_MAP make_pendulum PendulumEntry",
    SWINGING: "sin PendulumEntry show_pendulum",
    VISUALIZE_FILE: "mag make_newton_cradle full_swing_update "
    "DT G NC_FP R_PARAM THETA_INIT PendulumEntry is_running",
    DOUBLE: "vector make_bob_and_cord make_pendulum double_accelerations",
}


def needed(function: str) -> list[str]:
    """Return all functions that must be right first, also for those that this one waits for.

    They are in the order of the assignment.
    """
    found: set[str] = set()
    for name in FUNCTIONS[function].waits_for:
        found |= {name, *needed(name)}
    return [name for name in FUNCTIONS if name in found]


def is_students(name: str, function: str) -> bool:
    """Return whether this is the name of a function of the assignment, or of a helper for it."""
    return name == function or name not in {*FUNCTIONS, *GIVEN, "<lambda>"}


def module_of(file: str) -> str:
    """Return the module name of a file of the project."""
    return file.removesuffix(".py").replace("/", ".")
