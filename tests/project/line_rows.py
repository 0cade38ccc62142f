"""Wrong solutions, and rows of the trace tables that a student gets for them."""

# A function, a wrong version, and rows of its tables; the numbers of the lines are those of the
# function
ROWS = {
    "a row has the turns in which its line ran": (
        "make_newton_cradle",
        """\
        pend_list = extract_and_convert(relative_filepath)
        i = 0
        for pend in pend_list:
            pend['omega'] = 0
            if i == 0:
                pend['theta'] = theta_init
                i += 1
            else:
                pend['theta'] = 0
            axle_pos = vector((-0.1+r_param/4 * i), r_param/5, 0)
            color, texture = COLOR_MAP[pend['color']], TEXTURE_MAP[pend['texture']]
            pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)
        return pend_list""",
        [
            "3 i = 0 i = 0",
            "4 for pend in pend_list: pend_list[0] | pend_list[1] | pend_list[2]",
            "6 if i == 0: 0 == 0 True | 1 == 0 False | 1 == 0 False",
            "8 i += 1 1 | - | -",
            "(-0.025, 0.06, 0), in each turn",
        ],
    ),
    "of many turns the first two, the one in question, and the last one": (
        "full_swing_update",
        """\
        for i in range(len(pend_list)):
          if i != 5: swing_update(pend_list[i], r_param, dt, g)""",
        ["2 for i in range(len(pend_list)): 0 | 1 | ... | 5 | ... | 9 (10 turns)"],
    ),
    "what a called function got and gave": (
        "handle_two_bobs",
        ("e = pend1", "e = pend2"),
        [
            "handle_collision got e = 1, omega1 = 4, omega2 = 0, m1 = 1, m2 = 1",
            "8 pend1['omega'] = new_omega1 0",
        ],
    ),
    "as much of a long line as there is room for, and a sign that it goes on": (
        "handle_collision",
        f"""\
        w = {"+".join(["omega1"] * 30)}
        w = {" + ".join(["omega1"] * 30)}
        return omega1, omega2""",
        [
            "+omega1+omega1+omega ... w = 90",
            "+ omega1 + omega1 + ... w = 90",
        ],
    ),
    "what a called function has changed": (
        "newton_cradle_tick",
        ("pend_list[i + 1]", "pend_list[i]"),
        ["turn 1: handle_two_bobs got pend1 = pend_list[0], pend2 = pend_list[0]; it set omega"],
    ),
    "lines that never ran": (
        "handle_collision",
        """\
        if m1 < m2:
            return omega1, omega2
        else:
            w = 5
        return omega2, omega1""",
        [
            "2 if m1 < m2: 2 < 8 True",
            "5 w = 5 (never ran)",
            "6 return omega2, omega1 (never ran)",
        ],
    ),
    "the line that stopped, and the values in it": (
        "handle_two_bobs",
        """\
        for i in range(3):
            bob = pend1['objects']['bob']""",
        [
            "2 for i in range(3): 0",
            "3 bob = pend1['objects']['bob'] <- stops here: TypeError",
        ],
    ),
    "the keys of a dictionary that lacks one": (
        "handle_two_bobs",
        "return pend1['radius']",
        ["the keys of pend1 are 'mass', 'e', 'theta', 'omega', 'color', 'texture', 'objects'"],
    ),
    "a value that was not taken apart": (
        "handle_two_bobs",
        "axle, bob = pend1['objects']",
        ["the value is (axle, bob, cord)"],
    ),
    "a guard, and a loop in a loop": (
        "angle_update",
        """\
        a, n = None, 0
        if a is not None and a['x'] > 1: pass
        for i in range(2):
            for j in range(2): n += 1
        else: n = 0
        return n, theta""",
        [
            "3 if a is not None and a['x'] > 1: pass None is not None False",
            "5 for j in range(2): n += 1 0 | 1 | 0 | 1; 1 | 2 | 3 | 4",
            "n = 0",
        ],
    ),
    "the else of a loop": (
        "angle_update",
        """\
        n = 0
        for i in range(3):
            n += i
        else:
            n = 7
        return n, theta""",
        ["6 n = 7 n = 7"],
    ),
    "a call in a turn that an except ended is no call of the next turn": (
        "angle_update",
        """\
        def part(x): return 6 / x
        r = 0
        for i in range(2):
            try:
                r += part(i)
            except ZeroDivisionError:
                pass
        return r, theta""",
        ["6 r += part(i) - | 6 turn 2: part got x = 1; it gave 6 7 except"],
    ),
    "an index that changes with its value": (
        "angle_update",
        """\
        a, i = [0, 0], 0
        a[i], i = 5, 1
        return i, theta""",
        ["3 a[i], i = 5, 1 i = 1"],
    ),
    "the last call of a helper": (
        "angle_update",
        """\
        def same(x):
            y = x
            return y
        w = same(1) + same(2)
        return w, theta""",
        ["Your function same, called there: 3 y = x y = 2"],
    ),
    "no turn": (
        "angle_update",
        """\
        for i in range(0): g = i
        return omega, theta""",
        ["2 for i in range(0): g = i no turn"],
    ),
    "match": (
        "angle_update",
        """\
        match g:
            case 8:
                a = 1
            case _:
                a = 2
        return a, theta""",
        ["2 match g: 4 a = 1 a = 1 6 a = 2 (never ran)"],
    ),
    "an error in a print": (
        "angle_update",
        """\
        a = 5
        print(a / 0)""",
        ["2 a = 5 a = 5 3 print(a / 0) <- stops here: ZeroDivisionError"],
    ),
    "an error that nobody told": (
        "angle_update",
        """\
        from contextlib import suppress
        with suppress(Exception):
            a = g / 0
        return 1, 1""",
        ["4 a = g / 0 (did not come to its end)"],
    ),
    "a long loop": (
        "angle_update",
        """\
        for i in range(20000): a = i
        return a, theta""",
        [
            "turns: not watched further)",
            "3 return a, theta (not watched further)",
        ],
    ),
    "a helper has a table of its own": (
        "angle_update",
        """\
        def pull(a):
            return g * sin(a)
        new = omega - pull(theta)
        return new, theta + new * dt""",
        [
            "pull got a = 2.61799",
            "Your function pull, called there:",
            "3 return g * sin(a) gives 4",
        ],
    ),
    "the helper that stopped": (
        "angle_update",
        """\
        def pull(a):
            b = None
            return b * a
        return omega + pull(theta), theta""",
        [
            "5 return omega + pull(theta), theta <- stops here: TypeError",
            "4 return b * a <- stops here: TypeError",
            "b is None",
        ],
    ),
    "an error that an except hides": (
        "angle_update",
        """\
        try:
            a = omega / 0
        except ZeroDivisionError:
            a = 0
        return a, theta""",
        [
            "2 try: 3 a = omega / 0 stopped: ZeroDivisionError",
            "line 3 stopped with ZeroDivisionError: float division by zero; this except takes it",
        ],
    ),
    "conditions": (
        "angle_update",
        """\
        a = []
        while not a and 2 > len(a) > -1:
            a.append(g)
        if a:
            pass
        return a[0], theta""",
        [
            "not [ ], empty and 2 > 0 > -1 True | not [8] False",
            "5 if a: [8], so True",
            "4 a.append(g) [8]",
        ],
    ),
    "a value that no name gets": (
        "elastic_newton_cradle",
        """\
        uniform_e_newton_cradle(relative_filepath, 1)
        return []""",
        ["gives a list of 3 pendula, and no name gets it"],
    ),
    "the same dictionary again and again": (
        "extract_and_convert",
        """\
        pend, pend_list = {}, []
        for i in range(3):
            pend['mass'] = i
            pend_list.append(pend)
        return pend_list""",
        [
            (
                "a list of 1 pendulum | a list of 2 pendula, all the same one | "
                "a list of 3 pendula, all the same one"
            ),
        ],
    ),
    "a function that is not called": (
        "main",
        """\
        pend_list = make_newton_cradle
        page.show(pend_list)""",
        ["the function make_newton_cradle: a call has ( )"],
    ),
    "an object of the student's class, which would answer otherwise if it was asked again": (
        "angle_update",
        """\
        class Count(dict):
            n = 0
            def __getitem__(self, key): self.n += 1; return 5
        c = Count()
        c['x'] = 4
        n = c.n
        return n, theta""",
        ["n = c.n n = 0"],
    ),
    "the first value that is certainly not the formula's": (
        "angle_update",
        ("-g * sin(theta) / r_param * dt", "0 * dt"),
        ["2 omega_new = omega + 0 * dt omega_new = 3 <- 2 is right here"],
    ),
}
