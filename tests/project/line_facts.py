"""Wrong solutions, and the sentence below the trace table of each."""

# A function, a wrong version, the line to look at, and a sentence about what the grader has seen
FACTS = {
    "set": (
        "full_swing_update",
        """\
        for p in pend_list:
            p['omega'] = 5
            p['omega'] = 5.0""",
        3,
        "omega of pend_list[0] was set to 5 in line 3, then to 5 in line 4.",
    ),
    "set in a helper": (
        "handle_two_bobs",
        """\
        def put(p):
            p['omega'] = 7
        put(pend1)""",
        3,
        "omega of pend1 was set to 7 in line 3.",
    ),
    "set again, unseen": (
        "elastic_newton_cradle",
        """\
        pends = uniform_e_newton_cradle(relative_filepath, 0)
        for p in pends: p['e'] = 1
        [p.update(e=0.3) for p in pends]
        return pends""",
        3,
        None,
    ),
    "the other pendulum": (
        "handle_two_bobs",
        """\
        if pend1['e'] > 5:
            pend1['omega'] = 5
        pend2['omega'] = 6""",
        2,
        "No line of your function has set omega of pend1: it is still 3, as before the call.",
    ),
    "not set": (
        "handle_two_bobs",
        "omega = 5",
        1,
        "No line of your function has set omega of pend1: it is still 3, as before the call.",
    ),
    "given": (
        "uniform_e_newton_cradle",
        ("['e'] = e_val", "['mass'] = e_val"),
        4,
        "mass of pend_list[0] was set to 0.0625 in line 4.",
    ),
    "as it was": (
        "elastic_newton_cradle",
        "return uniform_e_newton_cradle(relative_filepath, 0)",
        2,
        (
            "No line of your function has set e of pend_list[0]: it is still 0, as "
            "uniform_e_newton_cradle gave it."
        ),
    ),
    "a parameter": (
        "handle_collision",
        "return omega1, omega2",
        2,
        "new_omega1 is your omega1, and no line of your function has set it.",
    ),
    "perhaps set": (
        "elastic_newton_cradle",
        """\
        pend_list = uniform_e_newton_cradle(relative_filepath, 0)
        [p.update(e=0) for p in pend_list]
        return pend_list""",
        3,
        "e of pend_list[0] is still 0, as uniform_e_newton_cradle gave it.",
    ),
    "a return in a loop": (
        "uniform_mass_newton_cradle",
        ("        return", "            return"),
        4,
        "Line 5 returns in turn 1 of the loop in line 3, and so ends it.",
    ),
    "no return": (
        "uniform_mass_newton_cradle",
        ("        return pend_list", ""),
        2,
        "Your function has no return with a value.",
    ),
    "no call": (
        "full_swing_update",
        "pass",
        1,
        "No line of your function calls swing_update.",
    ),
    "the formula": (
        "angle_update",
        "return 1, 1",
        2,
        ("Right here: sin(theta) = 0.5, acceleration = -10, omega_new = 2, theta_new = 2.81799."),
    ),
}
