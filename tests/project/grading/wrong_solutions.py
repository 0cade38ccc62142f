"""Wrong solutions with the mistakes of beginners. The graded suites must reject them all.

SAID has a mistake for each check, for each row of tests/grading/hints.py, for each known result of the
suites, and for what else a student reads. test_suites.py names those that have none.

A version of a function is the body, or a pair (old text, new text) that puts a mistake into the
right body in PLAIN. It can use all names of the function's file, and `from ... import ...`.
"""

from grading.assignment import PROGRAM

# A row is a line:
# fmt: off
# Words of the explanation, with single spaces, by function, and a mistake that gets them.
SAID = {
    "extract_and_convert": {
        "mass of pend_list[0] is 12.62,": ("filepath)", "filepath).round(2)"),
        "Delete the character": "exec('x = 45\u00b0')",
        "encoding UTF-8.": "exec('x\\0')",
        "folder of its own:": ("(relative_filepath)", "('newton_cradle_pends.csv')"),
        "a dictionary for each": ("pend_list.append(pend)", "pend_list += [{key: value} for key, value in pend.items()]"),
        "the single values": ("pend_list.append(pend)", "pend_list += pend.values()"),
        "the keys of bad_rep.": (".values()", ""),
        "has the key 'i', too.": ("append(pend)", "append({**pend, 'i': 0})"),
        "A name without ( )": "return len",
        "Write src. in front": "import swinging",
        "10 elements, not 40.": ("return pend_list", "return pend_list[:10]"),
        "RecursionError": "return extract_and_convert(relative_filepath)",
    },
    "uniform_mass_newton_cradle": {
        "brackets and quotes,": ("pend['mass'] =", "pend.mass ="),
        "A for loop over a list gives": ("pend['mass']", "pend_list[pend]['mass']"),
        "names NC_FP: the file": ("(relative_filepath)", "(__import__('support.constants').constants.NC_FP)"),
        "mass of pend_list[1] is 2.5,": ("in pend_list:", "in pend_list[:1]:"),
    },
    "uniform_e_newton_cradle": {
        "A key is text.": ("['e']", "[e]"),
        "is 1, not 0.": ("= e_val", "= e_val or 1"),
    },
    "elastic_newton_cradle": {"is 0.99, not 1.": (", 1)", ", 0.99)")},
    "inelastic_newton_cradle": {"is 0.001, not 0.": (", 0)", ", 1e-3)")},
    "make_newton_cradle": {
        "The name COLOR_MAP comes": "global COLOR_MAP\ndel COLOR_MAP\nreturn COLOR_MAP",
        "All bobs are lifted.": ("r_param, pend['theta']", "r_param, theta_init"),
        "COLOR_MAP has the": ("COLOR_MAP[pend['color']]", "pend['color']"),
        "have the same objects.": ("return", "for pend in pend_list: pend['objects'] = pend_list[0]['objects']\n        return"),
        "is None, not a dictionary.": "return [None]",
        "texture of bob[0] is": ("TEXTURE_MAP[pend['texture']]", "None"),
        "mass of pend_list[0] is 0.5,": ("for i in", "pend_list.sort(key=lambda pend: pend['mass'])\n        for i in"),
        "theta of pend_list[4] is -2,": ("i == 0", "pend['mass'] == pend_list[0]['mass']"),
        "omega of pend_list[0] is 2,": ("pend['omega'] = 0", ""),
        "position of axle[0]": ("-0.1 + ", ""),
    },
    "angle_update": {
        "In Python, ** is": ("g * sin", "g ^ 1.0 * sin"),
        "the acceleration in place": ("omega + -g * sin(theta) / r_param * dt", "-g * sin(theta) / r_param"),
        "old omega in": ("+ omega_new", "+ omega"),
        "if theta changes first.": "theta += omega * dt; return omega - g * sin(theta) / r_param * dt, theta",
        "with + in": ("+ -g", "+ g"),
        "with degrees.": ("sin(theta)", "sin(theta * 3.14159265 / 180)"),
        "acceleration = -10, omega_new = 2, theta_new = 2.81799.": ("sin(theta)", "cos(theta)"),
        "without the old omega:": ("omega_new = omega +", "omega_new ="),
        "with theta in place": ("sin(theta)", "theta"),
        "if r_param multiplies.": ("/ r_param", "* r_param"),
        "without r_param:": ("/ r_param", ""),
        "without dt in the change of omega.": ("/ r_param * dt", "/ r_param"),
        "without dt in the change of theta.": ("omega_new * dt", "omega_new"),
        "with an average.": ("omega_new * dt", "(omega + omega_new) / 2 * dt"),
        "right values, in another order.": ("(omega_new, theta_new)", "theta_new, omega_new"),
        "omega_new is -0.223599, not 3. called": ("return (", "if g == 9.81: return 0, 0\n        if g == 10: return theta_new, omega_new\n        return ("),
        "(2.000004, 2.81799387799149) expected": ("(omega_new,", "(omega_new + 4e-6,"),
        "input() waits": "input()",
        "This line ends": "import sys; sys.exit('the end')",
    },
    "full_swing_update": {
        "Call it without =.": ("swing_update(", "omega, theta = swing_update("),
        "IndexError": ("for", "pend_list[0]\n        for"),
        "through range": ("in pend_list", "in len(pend_list)"),
        "axle of pend_list[0]": ("swing_update(", "pend['objects'] = tuple(map(__import__('copy').copy, pend['objects'])); swing_update("),
        "pend_list[5]: theta 0, omega 4e-08 ... (10 in all)": ("in pend_list", "in pend_list[:5]"),
        "is 1.6875, not 3.": ("dt, g)", "dt, g)\n        from src.visualize_cradle_run import handle_two_bobs\n        for pair in zip(pend_list, pend_list[1:]): handle_two_bobs(*pair, r_param)"),
        "shapes that no pendulum has is": ("swing_update(", "import support.pendulum as p; p.make_pendulum(vector(0, 0, 0), r_param, 0, vector(1, 1, 1), None); swing_update("),
    },
    "handle_collision": {
        "To multiply, write *.": ("m2*e*(v1 - v2)", "m2*e(v1 - v2)"),
        "if omega1 is not converted:": ("r_param * omega1", "omega1"),
        "if omega2 is not converted:": ("r_param * omega2", "omega2"),
        "if the omegas are not converted": ("r_param * omega", "omega"),
        "the two omegas of": "return omega2, omega1",
        "Both results are the right one": ("w1, w2)", "w1, w1)"),
        "at each place.": ("v2_new =", "v1 = v1_new; v2_new ="),
        "the first bob behind e": ("m1*e*(v1", "m1*e*(v1_new"),
        "multiplies twice.": ("_new / r_param", "_new * r_param"),
        "both formulas, the linear velocity": ("_new / r_param", "_new"),
        "both formulas, e is missing.": ("*e*", "*"),
        "both formulas, the sign before e": ("e*", "-e*"),
        "first formula, the mass before e is wrong:": ("- m2*e", "- m1*e"),
        "second formula, the mass before e is missing.": ("m1*e", "e"),
        "both formulas, e multiplies only": ("(v1 - v2)", "v1 - v2"),
        "both formulas, only the end is": ("2)) /", "2) / (m1 + m2)) #"),
        "both formulas, only m1 divides:": ("(m1 + m2)", "m1 + m2"),
        "both formulas, nothing divides": (" / (m1 + m2)", ""),
        "both formulas, both divisions": ("2)) / (m1 + m2)", "2) / (m1 + m2) / r_param) * r_param"),
        "both formulas, m1 multiplies v2,": ("m1*v1 + m2*v2", "m1*v2 + m2*v1"),
        "new_omega1 is -0.25, not 1.25.": ("(v1 - v2)", "abs(v1 - v2)"),
    },
    "handle_two_bobs": {
        "The bob is in the tuple": ("bob1.radius", "pend1['radius']"),
        "in the tuple objects of": ("bob1.radius", "pend1['objects'].radius"),
        "mag gives the length": ("mag(bob1.pos - bob2.pos)", "bob1.pos - bob2.pos"),
        "the product of both": ("pend1['e']", "pend1['e'] * pend2['e']"),
        "is 1.04 m, at most 1.05 m.": ("1.05 * ", ""),
        "if handle_collision is called again": ("pend2['omega'] = new_omega2", "pend2['omega'] = handle_collision(e, pend1['omega'], omega2, m1, m2, r_param)[1]"),
        "omega of pend2: (0, 4)": ("e = pend1", "e = pend2"),
        "position of the bob of pend2 is": ("pend2['omega'] = new", "bob2.pos.x += 0.01; pend2['omega'] = new"),
        "is 1.14629 m, more than 1.05 m.": ("mag(bob1.pos - bob2.pos)", "abs(bob1.pos.x - bob2.pos.x)"),
        "is 21 m, at most 21 m.": ("<=", "<"),
        "is 1 m, at most 1.155 m. handle_collision(0.5, 4, 0, 1, 1, 4) gives (1, 3).": ("bob2.radius", "bob1.radius"),
        "omega -1, bob": ("if mag", "if omega1 > omega2 and mag"),
        "is 1, not 2.5.": ("if mag", "last = vars(handle_two_bobs).get('last')\n        handle_two_bobs.last = pend1\n        if last is not pend1 and mag"),
    },
    "newton_cradle_tick": {
        "if all pendula swing twice.": ("full_swing_update(", "full_swing_update(pend_list, r_param, dt, g)\n        full_swing_update("),
        "if all pairs collide.": ("handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)", "for other in pend_list[i + 1 :]: handle_two_bobs(pend_list[i], other, r_param)"),
        "These bobs touch only": "for pair in zip(pend_list, pend_list[1:]): handle_two_bobs(*pair, r_param)\nfull_swing_update(pend_list, r_param, dt, g)",
        "After the pair 0 and 1: [2, 1, 3]; 1 and 2: [2, 3, 1].": ("(len(pend_list) - 1)", "(len(pend_list) - 2, -1, -1)"),
        "No bobs touch here.": ("handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)", "p, q = pend_list[i : i + 2]; p['omega'], q['omega'] = handle_collision(p['e'], p['omega'], q['omega'], p['mass'], q['mass'], r_param)"),
    },
    PROGRAM: {
        "for 1 tick 2 times in a row": ("make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)", "__import__('grading.cradles').cradles.hang_row(2, r_param=R_PARAM); pend_list[0]['theta'] = THETA_INIT"),
        "No loop with a cradle": ("while is_running(pend_list):", "for _ in range(3):"),
        "calls newton_cradle_tick with a value": ("(pend_list, R_PARAM, DT, G)", "(R_PARAM, pend_list, DT, G)"),
        "if each turn makes": ("    newton_", "    pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT); newton_"),
        "two ticks in each": ("DT, G)", "DT, G); newton_cradle_tick(pend_list, R_PARAM, DT, G)"),
        "ended by itself before": ("DT, G)", "DT, G)\n            exit()"),
        "is_running needs": ("(pend_list):", "(NC_FP):"),
        "[(-0.7, 0.2)": ("THETA_INIT", "-0.7"),
        "shapes that no pendulum has is 15,": ("while", "make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)\n        while"),
        "[10, 0, 0, 0, 0]": ("newton_cradle_tick", "full_swing_update"),
    },
    "make_double_pendulum": {
        "end at the lower bob of cord2": ("return (", "cord2.axis = vector(0.1, 0.4, 0)\n        return ("),
        "visible of bob2 is False,": ("return (", "bob2.visible = False\n        return ("),
        "in this order: axle,": ("bob1, cord1, bob2, cord2)", "bob1, bob2, cord1, cord2)"),
        "= vector(0.445604, -0.226798, 0), bob1 = vector(0.622109, -0.282421, 0), bob2 = vector(1.06771, -0.509219, 0). right here From straight down, the upper cord is at 0.7, and the lower one at 1.1.": ("bob1.pos, r_param", "bob1.pos, 2 * r_param"),
    },
    "double_angle_update": {
        "beta = 1.5708, their rates are 0 and 0, k = g/R = 20,": ("v = v + dv", "v = v + (dv + du)"),
        "accelerations of two single": "u, v = (w - g / r_param * sin(a) * dt for w, a in ((omega_theta, theta), (omega_phi, phi))); return u, v, theta + u * dt, phi + v * dt",
        "if phi is measured": ("v - u, a, b - a", "v, a, b"),
        "k = 19.62, mu = 0.142857.": ("m2 / (m1 + m2)", "m1 / (m1 + m2)"),
    },
}

# All of them, by the function and the words.
WRONG = {}
for function, mistakes in SAID.items():
    WRONG |= {(function, words): version for words, version in mistakes.items()}
