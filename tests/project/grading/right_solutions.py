"""Correct solutions, which the graded suites must accept.

PLAIN has the body of each function of the handout, and of the program's block. RIGHT has other ways
to write it: the body, or a pair (old text, new text) for its body in PLAIN. Add one, and
test_suites.py covers it.
"""

from grading.assignment import PROGRAM

PLAIN = {
    "extract_and_convert": """\
        bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
        pend_list = []
        for pend in bad_rep.values():
            pend_list.append(pend)
        return pend_list""",
    "uniform_mass_newton_cradle": """\
        pend_list = extract_and_convert(relative_filepath)
        for pend in pend_list:
            pend['mass'] = mass
        return pend_list""",
    "uniform_e_newton_cradle": """\
        pend_list = extract_and_convert(relative_filepath)
        for pend in pend_list:
            pend['e'] = e_val
        return pend_list""",
    "elastic_newton_cradle": "return uniform_e_newton_cradle(relative_filepath, 1)",
    "inelastic_newton_cradle": "return uniform_e_newton_cradle(relative_filepath, 0)",
    "make_newton_cradle": """\
        pend_list = extract_and_convert(relative_filepath)
        for i in range(len(pend_list)):
            pend = pend_list[i]
            if i == 0:
                pend['theta'] = theta_init
            else:
                pend['theta'] = 0
            pend['omega'] = 0
            axle_pos = vector((-0.1 + r_param/4 * i), r_param/5, 0)
            color, texture = COLOR_MAP[pend['color']], TEXTURE_MAP[pend['texture']]
            pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)
        return pend_list""",
    "angle_update": """\
        omega_new = omega + -g * sin(theta) / r_param * dt
        theta_new = theta + omega_new * dt
        return (omega_new, theta_new)""",
    "full_swing_update": """\
        for pend in pend_list:
            swing_update(pend, r_param, dt, g)""",
    "handle_collision": """\
        v1 = r_param * omega1
        v2 = r_param * omega2
        v1_new = (m1*v1 + m2*v2 - m2*e*(v1 - v2)) / (m1 + m2)
        v2_new = (m1*v1 + m2*v2 + m1*e*(v1 - v2)) / (m1 + m2)
        w1, w2 = v1_new / r_param, v2_new / r_param
        return (w1, w2)""",
    "handle_two_bobs": """\
        m1, m2 = pend1['mass'], pend2['mass']
        bob1, bob2 = pend1['objects'][1], pend2['objects'][1]
        omega1, omega2 = pend1['omega'], pend2['omega']
        e = pend1['e']
        if mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius):
            new_omega1, new_omega2 = handle_collision(e, omega1, omega2, m1, m2, r_param)
            pend1['omega'] = new_omega1
            pend2['omega'] = new_omega2""",
    "newton_cradle_tick": """\
        full_swing_update(pend_list, r_param, dt, g)
        for i in range(len(pend_list) - 1):
            handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)""",
    PROGRAM: """\
        pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
        while is_running(pend_list):
            newton_cradle_tick(pend_list, R_PARAM, DT, G)""",
    "make_double_pendulum": """\
        axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
        bob2, cord2 = make_bob_and_cord(bob1.pos, r_param, theta + phi, color, texture)
        return (axle, bob1, cord1, bob2, cord2)""",
    "double_angle_update": """\
        a, b, u, v = theta, theta + phi, omega_theta, omega_theta + omega_phi
        du, dv = double_accelerations(a, b, u, v, g / r_param, m2 / (m1 + m2))
        u = u + du * dt
        v = v + dv * dt
        a = a + u * dt
        b = b + v * dt
        return (u, v - u, a, b - a)""",
}

# A row is a line:
# fmt: off
RIGHT = {
    "extract_and_convert": {
        "the columns named": "df = pd.read_csv(relative_filepath); keys = 'mass', 'e', 'theta', 'omega', 'color', 'texture'; return [dict(zip(keys, row)) for row in zip(*(df[key].tolist() for key in keys))]",
        "row by row": "return [dict(row) for _, row in pd.read_csv(relative_filepath).iterrows()]",
        "the module csv": "import csv, pathlib; rows = csv.DictReader(pathlib.Path(relative_filepath).read_text().splitlines()); return [{key: float(cell) if cell[-1].isdigit() else cell for key, cell in row.items()} for row in rows]",
    },
    "uniform_mass_newton_cradle": {},
    "uniform_e_newton_cradle": {"with pandas": "import pandas as pd; return pd.read_csv(relative_filepath).assign(e=e_val).to_dict('records')"},
    "elastic_newton_cradle": {
        "a float, by its name": "return uniform_e_newton_cradle(relative_filepath, e_val=1.0)",
        "by itself": "return [{**pend, 'e': 1} for pend in extract_and_convert(relative_filepath)]",
    },
    "inelastic_newton_cradle": {},
    "make_newton_cradle": {
        "new dictionaries": ("return pend_list", "return [dict(pend) for pend in pend_list]"),
        "with a frame and a name": ("return pend_list", "from vpython import box, cylinder, label; box(pos=vector(0, -1, 0), size=vector(2, 0.1, 1)); cylinder(axis=vector(1, 0, 0), radius=r_param / 20); label(text='cradle')\n        return pend_list"),
        "made twice, and the first ones hidden": ("pend['objects'] = make", "for old in make_pendulum(axle_pos, r_param, 0, color, texture): old.visible = False\n            pend['objects'] = make"),
        "each axle from the one before": ("-0.1 + r_param/4 * i", "pend_list[i - 1]['objects'][0].pos.x + r_param/4 if i else -0.1"),
        "theta_init times a truth": ("= theta_init", "= theta_init * (i == 0)"),
        "keys of its own": ("pend['omega'] = 0", "pend['omega'] = 0; pend['number'] = i + 1"),
    },
    "angle_update": {
        "breakpoints, and nobody debugs": ("omega_new =", "breakpoint(); __import__('pdb').set_trace(); omega_new ="),
        "numpy's sin": ("sin(", "__import__('numpy').sin("),
        "the formulas put together": ("omega_new * dt", "dt * omega - dt * dt * g * sin(theta) / r_param"),
        "a named tuple": ("return (", "return __import__('collections').namedtuple('Angles', 'omega theta')("),
    },
    "full_swing_update": {
        "by names": "for pend in pend_list: swing_update(pend_dict=pend, r_param=r_param, dt=dt, g=g)",
        "from the right": ("in pend_list", "in reversed(pend_list)"),
        "the shapes turned": """\
            for pend in pend_list:
                omega, theta = angle_update(pend["omega"], pend["theta"], r_param, dt, g)
                axle, bob, cord = pend["objects"]
                turn = {"angle": theta - pend["theta"], "axis": vector(0, 0, 1), "origin": axle.pos}
                bob.rotate(**turn)
                cord.rotate(**turn)
                pend["omega"], pend["theta"] = omega, theta""",
        "the cord drawn from the bob": ("dt, g)", "dt, g); axle, bob, cord = pend['objects']; cord.pos, cord.axis = bob.pos, axle.pos - bob.pos"),
    },
    "handle_collision": {
        "through the centre of mass": "common = (m1 * omega1 + m2 * omega2) / (m1 + m2); return common - e * (omega1 - common), common - e * (omega2 - common)",
        "numpy's solver": "import numpy; return tuple(numpy.linalg.solve([[m1, m2], [-1, 1]], [m1 * omega1 + m2 * omega2, e * (omega1 - omega2)]))",
    },
    "handle_two_bobs": {
        "returns the dictionaries, too": ("pend2['omega'] = new_omega2", "pend2['omega'] = new_omega2\n        return pend1, pend2"),
        "places from the angles, axles r_param/4 apart": ("mag(bob1.pos - bob2.pos)", "__import__('math').hypot(r_param / 4 + r_param * (sin(pend2['theta']) - sin(pend1['theta'])), r_param * (cos(pend2['theta']) - cos(pend1['theta'])))"),
        "the ends of the cords": ("mag(bob1.pos - bob2.pos)", "mag(pend1['objects'][2].pos + pend1['objects'][2].axis - pend2['objects'][2].pos - pend2['objects'][2].axis)"),
        "the gap between the bobs, and a twentieth": ("mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius)", "mag(bob1.pos - bob2.pos) - (bob1.radius + bob2.radius) <= 0.05 * (bob1.radius + bob2.radius)"),
        "without handle_collision": ("handle_collision(e, omega1, omega2, m1, m2, r_param)", "omega1 - (1 + e)*m2*(omega1 - omega2)/(m1 + m2), omega2 + (1 + e)*m1*(omega1 - omega2)/(m1 + m2)"),
    },
    "newton_cradle_tick": {
        "each pair when both swung": """\
            from src.swinging import swing_update
            for i in range(len(pend_list)):
                swing_update(pend_list[i], r_param, dt, g)
                if i > 0:
                    handle_two_bobs(pend_list[i - 1], pend_list[i], r_param)""",
    },
    PROGRAM: {
        "VPython's rate": ("while is_running(pend_list):", "from vpython import *\n        while True:\n            rate(1 / DT)"),
        "rate after the tick": """\
            import vpython as vp
            pendula = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
            while True:
                newton_cradle_tick(pendula, R_PARAM, DT, G)
                vp.rate(10000)""",
        "rate in a for loop": ("while is_running(pend_list):", "from vpython import rate\n        for _ in range(1000):\n            rate(1 / DT)"),
        "rate as well, and more to see": """\
            from vpython import arange, arrow, color, label, rate, scene, vector
            scene.title = "Newton's cradle"
            cradle = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
            for x in arange(0, 1, 0.5):
                arrow(pos=vector(x, 0, 0), axis=vector(0, -G, 0), color=color.red)
            name = label(pos=scene.center, text="cradle")
            while is_running(cradle):
                rate(1 / DT)
                newton_cradle_tick(cradle, R_PARAM, DT, G)
                name.text = f'cradle of {len(cradle)}'
            exit()""",
        "a last tick when all is over": ("while is_running(pend_list):", "running = True\n        while running:\n            running = is_running(pend_list)"),
        "a loop in a function": """\
            import support.constants as c
            def main():
                # The simulation
                pend_list = make_newton_cradle(relative_filepath=c.NC_FP, theta_init=c.THETA_INIT, r_param=c.R_PARAM)
                while is_running(pend_list):
                    newton_cradle_tick(pend_list, c.R_PARAM, c.DT, c.G)
            main()""",
        "a path of its own": ("NC_FP", "'newton_cradle_pends.csv'"),
        "the path of the file": ("NC_FP", "__import__('pathlib').Path(__file__).parents[1] / 'newton_cradle_pends.csv'"),
        "an elastic cradle first": ("pend_list =", "from src.pds_helper import *; from src.special_cradles import *\n        pend_list = elastic_newton_cradle(NC_FP)\n        write_to_csv(pend_list, NC_FP)\n        pend_list ="),
        "pendula of its own first": ("pend_list =", "from src.pds_helper import write_to_csv\n        write_to_csv([{'mass': m, 'e': 1, 'theta': 0, 'omega': 0, 'color': 'red', 'texture': 'none'} for m in (1.0, 2.0)])\n        pend_list ="),
    },
    "make_double_pendulum": {
        "the lower one from a pendulum, its axle hidden": ("bob2, cord2 = make_bob_and_cord(bob1.pos, r_param, theta + phi, color, texture)", "hidden, bob2, cord2 = make_pendulum(bob1.pos, r_param, theta + phi, color, texture)\n        hidden.visible = False"),
        "the lower cord drawn from its bob": ("return (", "cord2.pos, cord2.axis = bob2.pos, -cord2.axis; return ("),
    },
    "double_angle_update": {
        "explicit Euler": ("u = u + du * dt\n        v = v + dv * dt\n        a = a + u * dt\n        b = b + v * dt", "a, b, u, v = a + u * dt, b + v * dt, u + du * dt, v + dv * dt"),
    },
}
