"""Write functions into a starter, as a student does."""

from textwrap import dedent, indent

from right_solutions import RIGHT
from wrong_solutions import PLAIN

from grading.handout import FUNCTIONS

# Bodies that PLAIN lacks, and those of the honor roll without a check.
BODIES = {
    "extract_and_convert": "return list(bad_rep.values())",
    "uniform_mass_newton_cradle": RIGHT["uniform_mass_newton_cradle"]["by index"],
    "uniform_e_newton_cradle": """\
        pend_list = extract_and_convert(relative_filepath)
        for pend in pend_list:
            pend["e"] = e_val
        return pend_list
        """,
    "elastic_newton_cradle": "return uniform_e_newton_cradle(relative_filepath, 1)",
    "inelastic_newton_cradle": "return uniform_e_newton_cradle(relative_filepath, 0)",
    "double_cradle_tick": "for pend in pend_list: double_swing_update(pend, r_param, dt, g)",
    **PLAIN,
}


def write(starter, *functions) -> None:
    """Replace the stubs of these functions; for main, its two calls."""
    for function in functions:
        file = FUNCTIONS[function].file if function in FUNCTIONS else "src/double_cradle.py"
        if function == "main":
            replace(starter, file, "main", "pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)")
            replace(starter, file, "main", "newton_cradle_tick(pend_list, R_PARAM, DT, G)")
        else:
            replace(starter, file, function, BODIES[function])


def write_tiers(starter, tiers) -> None:
    """Write all functions of these tiers: "DC" stands for D and C."""
    write(starter, *(name for name, function in FUNCTIONS.items() if function.tier in list(tiers)))


def write_all(starter) -> None:
    """Write all functions that are graded."""
    write(starter, *FUNCTIONS)


def replace(starter, file, function, body) -> None:
    """Replace the first stub of the function by this body."""
    path = starter / file
    lines = path.read_text(encoding="utf-8").splitlines()
    number = next(i for i, line in enumerate(lines) if f'"{function} is not written yet"' in line)
    spaces = lines[number][: -len(lines[number].lstrip())]
    assert "# Write your code here" in lines[number - 1]
    lines[number - 1 : number + 1] = indent(dedent(body).strip(), spaces).splitlines()
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
