"""The explanation of a student's mistake: its call, the code line by line, and what was seen."""

import builtins

import pytest
from graded import failures

from grading import limits
from grading.assignment import PROGRAM
from line_by_line.table import fitting


def explained(function):
    """Return the explanation of a function's first failure, and its words in one line."""
    explanation = failures(function)[0].explanation
    lines = [*explanation.wrong, *fitting(explanation.rows, 20)[0], *explanation.below]
    return explanation, " ".join(" ".join(lines).split())


# A function, a wrong version, parts of the screen, and a part that must not be there
SAID = {
    "an attribute is no key": (
        "make_newton_cradle",
        ("COLOR_MAP[pend['color']]", "vector(1, 1, 1)"),
        ["color of bob[0] is vector(1, 1, 1), not"],
        "No line that ran",
    ),
    "a stored None": (
        "full_swing_update",
        "for i in range(3): pend_list[i] = swing_update(pend_list[i], r_param, dt, g)",
        ["i = 0, pend_list[0] = None | i = 1,"],
        "cannot be read",
    ),
    "another name of an argument": (
        "make_double_pendulum",
        (
            "axle, bob1, cord1 =",
            "joint = axle_pos\n        joint.x = 0.8\n        axle, bob1, cord1 =",
        ),
        ["joint = axle_pos, vector(0.3, 0.1, 0)", "joint.x = 0.8"],
        "Error",
    ),
    "not set": (
        "handle_two_bobs",
        "pend2['omega'] = 6",
        ["function has changed omega of pend1.", "No line of your function calls handle_coll"],
        "omega of pend2.",
    ),
    "given by another function": (
        "inelastic_newton_cradle",
        "return uniform_e_newton_cradle(relative_filepath, 0.5)",
        ["changed e of pend_list[0]. It came so from your call of uniform_e_n"],
        "extract_and_convert",
    ),
    "a return in a loop": (
        "uniform_mass_newton_cradle",
        ("        return", "            return"),
        ["Line 5 returns in turn 1 of the loop in line 3, and so ends it."],
        "function calls",
    ),
    "a right result the second time": (
        "angle_update",
        "CALLS.append(1)\nomega -= g * sin(theta) / r_param * dt\n"
        "return omega, (theta + omega * dt) * (len(CALLS) > 1)",
        ["Called again with the same values, it gave the right result."],
        "your code",
    ),
    "the block": (
        PROGRAM,
        ("R_PARAM, DT, G)", "R_PARAM, G, DT)"),
        ["newton_cradle_tick(pend_list=a list of 5 pendula, r_param=0.2, dt="],
        "__main__",
    ),
    "values that say nothing of themselves": (
        "angle_update",
        """\
        class Odd:
            def fail(self, *_): 1 / 0
            __eq__ = __bool__ = __repr__ = __getattr__ = fail
        row = {1: Odd()}
        return row[1], row""",
        ["omega_new is a Odd, not a number.", "row = {1: Odd()} row ="],
        "fault",
    ),
}


@pytest.mark.parametrize("name", SAID)
def test_the_explanation_says_what_was_seen(solve, monkeypatch, name):
    function, version, parts, false = SAID[name]
    monkeypatch.setattr(builtins, "CALLS", [], raising=False)
    solve(function, version)
    _, screen = explained(function)
    assert [part for part in parts if part not in screen] == [], screen
    assert false not in screen


def test_under_a_debugger_there_is_no_table(solve, monkeypatch):
    monkeypatch.setattr(limits, "is_debugged", lambda: True)
    solve("angle_update", "return 1, 1")
    explanation, screen = explained("angle_update")
    assert not explanation.rows
    assert "omega_new is 1, not 2." in screen
