"""Wrong solutions with the mistakes of beginners. The graded suites must reject them all.

HINTED has a mistake for each row of tests/grading/hints.py, and for each known result of the
suites; OTHERS has more.

A version of a function is the body, or a pair (old text, new text) that puts a mistake into the
right body in PLAIN. It can use all names of the function's file, and `from ... import ...`.
"""

from right_solutions import PLAIN

from grading.handout import PROGRAM

# A row is a line:
# fmt: off
# The first words of each hint, by function, and a mistake that gets it.
HINTED = {
    "extract_and_convert": {
        "A character that you cannot see": "exec('x = 5\u200b')",
        "Python reads this character only in": "exec('x = 45\u00b0')",
        "This file is not saved in": "exec('x\\0')",
        "Python cannot read this line, or": "exec('a = 5 +')",
        "There is no such file. The": ("(relative_filepath)", "('my.csv')"),
        "This is a dictionary for each": ("pend_list.append(pend)", "pend_list += [{key: value} for key, value in pend.items()]"),
        "These are the single values of": ("pend_list.append(pend)", "pend_list += pend.values()"),
        "The first element has the index": ("append(pend)", "__getitem__(0); pend_list[0].append(pend)"),
        "These are the keys of bad_rep.": ("bad_rep.values()", "bad_rep"),
        "A name without ( ) is": ("return pend_list", "return len"),
        "The lines of a function begin": "exec('def f():')",
        "Your files import each other in": "raise ImportError('(most likely due to a circular import)')",
        "There is no module src.no for": "import src.no",
        "Write src. in front of the": "import swinging",
        "Your function calls itself, without end.": "return extract_and_convert(relative_filepath)",
    },
    "uniform_mass_newton_cradle": {
        "A dictionary needs brackets and quotes,": ("pend['mass'] = mass", "pend.mass = mass"),
    },
    "uniform_e_newton_cradle": {"A key is text. Write it": ("['e']", "[e]")},
    "make_newton_cradle": {
        "The name COLOR_MAP comes from another": "global COLOR_MAP\ndel COLOR_MAP\nreturn COLOR_MAP",
        "All bobs are lifted. make_pendulum must": ("r_param, pend['theta']", "r_param, theta_init"),
        "All pendula have the same objects.": ("pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)", "pend['objects'] = pend_list[0].get('objects') or make_pendulum(axle_pos, r_param, theta_init, color, texture)"),
    },
    "angle_update": {
        "In Python, ** is a power,": ("g * sin", "g ^ 1.0 * sin"),
        "No line that ran has given this name": ("(omega_new, ", "(omega_neww, "),
        "This is the acceleration in place": ("omega + -g * sin(theta) / r_param * dt", "-g * sin(theta) / r_param"),
        "This is the result with the old omega in": ("theta + omega_new", "theta + omega"),
        "This is the result if theta changes first. omega": "theta += omega * dt; return omega - g * sin(theta) / r_param * dt, theta",
        "This is the result with + in front of": ("+ -g", "+ g"),
        "This is the result with degrees.": ("sin(theta)", "sin(theta * 3.14159265 / 180)"),
        "This is the result with cos in place of": ("sin(theta)", "cos(theta)"),
        "This is the result without the old omega: the": ("omega_new = omega +", "omega_new = omega\n        omega_new =+"),
        "This is the result with theta in place of": ("sin(theta)", "theta"),
        "This is the result if r_param multiplies. The acceleration": ("/ r_param", "* r_param"),
        "This is the result without r_param: the acceleration is": ("/ r_param", ""),
        "This is the result without dt in the change of omega.": ("/ r_param * dt", "/ r_param"),
        "This is the result without dt in the change of theta.": ("omega_new * dt", "omega_new"),
        "This is the result with an average. Only the": ("theta + omega_new * dt", "theta + (omega + omega_new) / 2 * dt"),
    },
    "handle_collision": {
        "No line that ran has given": ("v1 = r_param * omega1", "v1 = cross(r_param, omega1)"),
        "This is the result if omega1 is not converted:": ("v1 = r_param * omega1", "v1 = omega1"),
        "This is the result if omega2 is not converted:": ("v2 = r_param * omega2", "v2 = omega2"),
        "These are the two omegas of": "return omega2, omega1",
        "Both results are the right one": ("(w1, w2)", "(w1, w1)"),
        "This is the result if the second formula has": ("v2_new =", "v1 = v1_new; v2_new ="),
        "This is the result with the new velocity of the first bob behind": ("m1*e*(v1 - v2)", "m1*e*(v1_new - v2)"),
        "This is the result if the omegas are not": ("r_param * omega", "omega"),
        "This is the result if r_param multiplies twice. At": ("(w1, w2)", "(v1_new * r_param, v2_new * r_param)"),
    },
    "handle_two_bobs": {
        "The bob is in the tuple": ("bob1.radius", "pend1['radius'] + bob1.radius"),
        "This is the result with the": ("e = pend1['e']", "e = pend1['e'] * pend2['e']"),
        "This is the result if handle_collision is called again": ("pend2['omega'] = new_omega2", "pend2['omega'] = handle_collision(e, pend1['omega'], omega2, m1, m2, r_param)[1]"),
    },
    "newton_cradle_tick": {
        "This is the result if all pendula swing twice.": ("full_swing_update(", "t = 0\n        while t < 2 * dt:\n            t += dt\n            full_swing_update("),
        "This is the result if all pairs collide.": ("handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)", "[handle_two_bobs(pend_list[i], other, r_param) for other in pend_list[i + 1 :]]"),
        "There is no module full_swing_update for": ("full_swing_update(", "import full_swing_update\n        full_swing_update("),
    },
    PROGRAM: {
        "No loop with a cradle has called": ("while is_running(pend_list):", "for _ in range(3):"),
        "This line calls newton_cradle_tick with a value": ("(pend_list, R_PARAM, DT, G)", "(R_PARAM, pend_list, DT, G)"),
        "The name NC_FP comes from another": ("pend_list =", "del NC_FP\n        pend_list ="),
        "This is the result if each turn makes": ("    newton_", "    pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT); newton_"),
        "This is the result of two ticks in": ("DT, G)", "DT, G); newton_cradle_tick(pend_list, R_PARAM, DT, G)"),
        "The program ended by itself before the check": ("DT, G)", "DT, G)\n            break"),
    },
    "double_angle_update": {
        "The value behind / is 0": ("g / r_param", "1 / (r_param / g)"),
        "This is beta'' in place of": ("v = v + dv", "v = v + (dv + du)"),
        "These are the accelerations of two": "u, v = (w - g / r_param * sin(a) * dt for w, a in ((omega_theta, theta), (omega_phi, phi))); return u, v, theta + u * dt, phi + v * dt",
        "This is the result if phi is measured from straight": ("(u, v - u, a, b - a)", "(u, v, a, b)"),
    },
}

# Other mistakes, by function.
OTHERS = {
    "extract_and_convert": {
        "Each theta must be as in its row": ("append(pend)", "append({**pend, 'theta': 0})"),
        "ten at most": ("return pend_list", "return pend_list[:10]"),
    },
    "uniform_mass_newton_cradle": {
        "a loop over one pendulum": ('for pend in pend_list:\n            pend', 'for key in pend_list[0]:\n            pend_list[0]'),
    },
    "uniform_e_newton_cradle": {"Here, e is 1, but e_val is not.": ("= e_val", "= e_val or 1")},
    "elastic_newton_cradle": {"e must be exactly 1.": (", 1)", ", 0.99)")},
    "inelastic_newton_cradle": {"e must be exactly 0.": (", 0)", ", 1e-3)")},
    "make_newton_cradle": {
        "the first bob drawn at rest": ("r_param, pend['theta']", "r_param, 0"),
        "sorted by mass": ("for i in", "pend_list.sort(key=lambda pend: pend['mass'])\n        for i in"),
        "the first known by its mass": ("i == 0", "pend['mass'] == pend_list[0]['mass']"),
        "at most half a round": ("= theta_init", "= max(-3.1415926, min(3.1415926, theta_init))"),
        "You forgot the -0.1.": ("-0.1 + ", ""),
    },
    "angle_update": {"an array of whole numbers": "import numpy\nstate = numpy.array([omega, theta])\nstate[0] += -g * sin(theta) / r_param * dt\nstate[1] += state[0] * dt\nreturn tuple(state)"},
    "full_swing_update": {
        "Your code makes axles, bobs or": ("swing_update(", "import support.pendulum as p; p.make_pendulum(vector(0, 0, 0), r_param, 0, vector(1, 1, 1), None); swing_update("),
        "five at most": ("in pend_list", "in pend_list[:5]"),
        "bobs that shrink": ("r_param, dt, g)", "r_param, dt, g); pend['objects'][1].radius *= 0.99"),
    },
    "handle_collision": {
        "v1 - v2 is negative here.": ("(v1 - v2)", "abs(v1 - v2)"),
        "a small e as 0": ("v1 = r_param", "e = e if e > 0.2 else 0; v1 = r_param"),
    },
    "handle_two_bobs": {
        "These bobs are 1.1373 times the": ("1.05", "(1.2 if bob1.pos.y > 1 else 1.05)"),
        "These bobs are 1.15 times the": ("mag(bob1.pos - bob2.pos)", "abs(bob1.pos.x - bob2.pos.x)"),
        "These bobs are exactly 1.05 times": ("<=", "<"),
        "These pendula have turned more than": ("if mag", "if abs(pend1['theta'] - pend2['theta']) < 3.1415926 and mag"),
        "e of the faster one": ("e = pend1['e']", "e = max(pend1, pend2, key=lambda pend: abs(pend['omega']))['e']"),
        "moves the bobs apart": ("pend2['omega'] = new_omega2", "pend2['omega'] = new_omega2; bob2.pos.x += 0.01"),
        "the last pair does not collide again": ("if mag", "last = handle_two_bobs.__dict__.setdefault('last', [])\n        if any(pend1 is one for one in last): return\n        last[:] = [pend1]\n        if mag"),
    },
    "newton_cradle_tick": {
        "numbers of its own": ("(pend_list, r_param, dt, g)", "(pend_list, 0.2, 0.0001, 9.81); R_PARAM = DT = G = 0"),
        "the swing between": "from src.swinging import swing_update\nfor i in range(len(pend_list)):\n    swing_update(pend_list[i], r_param, dt, g)\n    if i + 1 < len(pend_list): handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)",
        "from the right": ("len(pend_list) - 1)", "len(pend_list) - 1)[:: -1 if pend_list[-1]['omega'] < 0 else 1]"),
    },
    PROGRAM: {
        "a path for the loop": ("(pend_list):", "(NC_FP):"),
        "an angle of its own": ("THETA_INIT", "-0.7"),
        "a cord of its own": ("NC_FP, R_PARAM", "NC_FP, 0.3"),
        "the constants exchanged": ("DT, G", "G, DT"),
        "made twice": ("while", "make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)\n        while"),
        "nothing in the loop": ("newton_cradle_tick(pend_list, R_PARAM, DT, G)", "pass"),
        "an exit in the loop": ("DT, G)", "DT, G)\n            exit()"),
        "only the swings": ("newton_cradle_tick", "full_swing_update"),
        "pendula of no file": """\
            from support.pendulum import make_pendulum
            pend_list = []
            for theta in (THETA_INIT, 0):
                objects = make_pendulum(vector(0, 0, 0), R_PARAM, theta, vector(1, 0, 0), None)
                pend_list.append({"mass": 1, "e": 1, "theta": theta, "omega": 0, "objects": objects})
            while is_running(pend_list):
                newton_cradle_tick(pend_list, R_PARAM, DT, G)""",
    },
    "make_double_pendulum": {
        "Both cords have the length r_param.": ("bob1.pos, r_param", "bob1.pos, 2 * r_param"),
        "a lower bob that cannot be seen": ("return (", "bob2.visible = False\n        return ("),
    },
    "double_angle_update": {
        "Only unequal masses go wrong: mu": ("m2 / (m1 + m2)", "m1 / (m1 + m2)"),
        "phi of half a round at most": ("b - a)", "max(-3.14, min(3.14, b - a)))"),
    },
}

# Mistakes in the formulas of handle_collision, by their hint: old and new texts. Each is in both
# formulas, or in one.
FORMULAS = {
    "e is missing.": {"*e*": "*"},
    "the sign before e is wrong.": {"- m2*e": "+ m2*e", "+ m1*e": "- m1*e"},
    "the mass before e is wrong:": {"- m2*e": "- m1*e", "+ m1*e": "+ m2*e"},
    "the mass before e is missing.": {"m2*e": "e", "m1*e": "e"},
    "e multiplies only a part of": {"(v1 - v2)": "v1 - v2"},
    "only the end is divided": {"2)) /": "2) / (m1 + m2)) #"},
    "only m1 divides:": {"(m1 + m2)": "m1 + m2"},
    "nothing divides by the sum": {" / (m1 + m2)": ""},
    "both divisions apply only to the end:": {"2)) / (m1 + m2)": "2) / (m1 + m2) / r_param) * r_param"},
    "m1 multiplies v2, and m2": {"m1*v1 + m2*v2": "m1*v2 + m2*v1"},
    "the linear velocity is returned:": {"2))": "2)) * r_param"},
}
RIGHT_1, RIGHT_2 = PLAIN["handle_collision"].splitlines()[2:4]
for words, changes in FORMULAS.items():
    wrong_1, wrong_2 = RIGHT_1, RIGHT_2
    for old, new in changes.items():
        wrong_1 = wrong_1.replace(old, new)
        wrong_2 = wrong_2.replace(old, new)
    HINTED["handle_collision"] |= {
        f"This is the result if, in the first formula, {words}": (RIGHT_1, wrong_1),
        f"This is the result if, in the second formula, {words}": (RIGHT_2, wrong_2),
        f"This is the result if, in both formulas, {words}": (f"{RIGHT_1}\n{RIGHT_2}", f"{wrong_1}\n{wrong_2}"),
    }

# All of them, by the function and the words.
WRONG = {}
for table in (HINTED, OTHERS):
    for function, mistakes in table.items():
        WRONG |= {(function, words): version for words, version in mistakes.items()}
