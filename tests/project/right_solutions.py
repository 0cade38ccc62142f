"""Correct solutions in other ways. The graded suites must accept them all.

RIGHT has ways to write each function of the handout: the body of the function, or a pair (old text, new text) for its
body in PLAIN (wrong_solutions.py). Add one, and tests/project/test_graded_suites.py covers it.
"""

RIGHT = {
    "extract_and_convert": {
        "the values of bad_rep": "return list(pd.read_csv(relative_filepath).to_dict(orient='index').values())",
        "records": "return pd.read_csv(relative_filepath).to_dict(orient='records')",
        "by number": """\
            bad_rep = pd.read_csv(relative_filepath).to_dict(orient="index")
            pend_list = []
            for i in range(len(bad_rep)):
                pend_list.append(bad_rep[i])
            return pend_list
            """,
        "with +=": """\
            pend_list = []
            for key in (bad_rep := pd.read_csv(relative_filepath).to_dict(orient="index")):
                pend_list += [bad_rep[key]]
            return pend_list
            """,
        "row by row": "return [dict(row) for _, row in pd.read_csv(relative_filepath).iterrows()]",
        "tuples": "return [row._asdict() for row in pd.read_csv(relative_filepath).itertuples(index=False)]",
        "the module csv": """\
            import csv
            def number(text):
                try:
                    return float(text)
                except ValueError:
                    return text
            with open(relative_filepath) as file:
                return [{key: number(cell) for key, cell in row.items()} for row in csv.DictReader(file)]
            """,
        "ordered dictionaries": """\
            from collections import OrderedDict
            return pd.read_csv(relative_filepath).to_dict("records", into=OrderedDict)
            """,
    },
    "uniform_mass_newton_cradle": {
        "by index": """\
            pend_list = extract_and_convert(relative_filepath)
            for i in range(len(pend_list)):
                pend_list[i]["mass"] = mass
            return pend_list
            """,
        "new dictionaries": "return [{**pend, 'mass': mass} for pend in extract_and_convert(relative_filepath)]",
        "the order of the keys changed": "return [{'mass': mass} | {k: v for k, v in p.items() if k != 'mass'} for p in extract_and_convert(relative_filepath)]",
        "a float": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend.update(mass=float(mass))
            return pend_list
            """,
    },
    "uniform_e_newton_cradle": {
        "new list, old dictionaries": """\
            new = []
            for pend in extract_and_convert(relative_filepath):
                pend["e"] = e_val
                new.append(pend)
            return new
            """,
        "new dictionaries": "return [dict(pend, e=e_val) for pend in extract_and_convert(relative_filepath)]",
        "with pandas": "import pandas as pd; return pd.read_csv(relative_filepath).assign(e=e_val).to_dict('records')",
    },
    "elastic_newton_cradle": {
        "an int": "return uniform_e_newton_cradle(relative_filepath, 1)",
        "a float, by its name": "return uniform_e_newton_cradle(relative_filepath, e_val=1.0)",
        "by itself": "return [{**pend, 'e': 1} for pend in extract_and_convert(relative_filepath)]",
    },
    "inelastic_newton_cradle": {
        "a float": "return uniform_e_newton_cradle(relative_filepath, 0.0)",
        "by itself": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend["e"] = 0
            return pend_list
            """,
    },
    "make_newton_cradle": {
        "plainly": ("", ""),
        "with enumerate and floats": """\
            pend_list = extract_and_convert(relative_filepath)
            for i, pend in enumerate(pend_list):
                pend["theta"], pend["omega"] = (theta_init if i == 0 else 0.0), 0.0
                axle_pos = vector(-0.1, r_param / 5, 0) + i * vector(r_param / 4, 0, 0)
                color, texture = COLOR_MAP[pend["color"]], TEXTURE_MAP[pend["texture"]]
                pend["objects"] = make_pendulum(axle_pos, r_param, pend["theta"], color, texture)
            return pend_list
            """,
        "all hang, then the first is lifted": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend["theta"] = pend["omega"] = 0
            pend_list[0]["theta"] = theta_init
            x = -0.1
            for pend in pend_list:
                looks = COLOR_MAP[pend["color"]], TEXTURE_MAP[pend["texture"]]
                pend["objects"] = make_pendulum(vector(x, r_param / 5, 0), r_param, pend["theta"], *looks)
                x += r_param / 4
            return pend_list
            """,
        "new dictionaries": """\
            def made(i, row):
                theta = 0 if i else theta_init
                looks = COLOR_MAP[row["color"]], TEXTURE_MAP[row["texture"]]
                objects = make_pendulum(vector(-0.1 + i * r_param * 0.25, 0.2 * r_param, 0), r_param, theta, *looks)
                return {**row, "theta": theta, "omega": 0, "objects": objects}
            return [made(i, row) for i, row in enumerate(extract_and_convert(relative_filepath))]
            """,
        "with a frame and a name": (
            "return pend_list",
            "__import__('vpython').box(pos=vector(0, -1, 0), size=vector(2, 0.1, 1)); "
            "__import__('vpython').cylinder(axis=vector(1, 0, 0), radius=r_param / 20); "
            "__import__('vpython').label(text='cradle')\n        return pend_list",
        ),
        "made twice, and the first ones hidden": (
            "pend['objects'] = make",
            "for old in make_pendulum(axle_pos, r_param, 0, color, texture): old.visible = False\n"
            "            pend['objects'] = make",
        ),
        "the first known by itself": ("i == 0", "pend is pend_list[0]"),
        "theta_init times a truth": ("= theta_init", "= theta_init * (i == 0)"),
        "keys of its own": ("pend['omega'] = 0", "pend['omega'] = 0; pend['number'] = i + 1"),
    },
    "angle_update": {
        "plainly": ("", ""),
        "in one line": "return (omega - g / r_param * sin(theta) * dt, theta + (omega - g / r_param * sin(theta) * dt) * dt)",
        "the old names changed": """\
            omega += -g * sin(theta) / r_param * dt
            theta += omega * dt
            return omega, theta
            """,
        "math's sin": "import math\nomega -= g * math.sin(theta) * dt / r_param\nreturn omega, theta + omega * dt",
        "VPython's sin": "import vpython\nomega -= g * vpython.sin(theta) * dt / r_param\nreturn omega, theta + omega * dt",
        "sin from cos": "omega -= (g * dt) * cos(theta - 1.5707963267948966) / r_param\nreturn omega, theta + omega * dt",
        "the acceleration first": """\
            acceleration = (-1) * g * sin(theta) / r_param
            return tuple([omega + dt * acceleration, theta + dt * omega + dt * dt * acceleration])
            """,
        "numpy's numbers": """\
            import numpy
            omega = omega - g * numpy.sin(theta) / r_param * dt
            return omega, numpy.float64(theta + omega * dt)
            """,
        "by the torque": """\
            mass = 3.0
            torque, inertia = -mass * g * r_param * sin(theta), mass * r_param**2
            omega_new = omega + torque / inertia * dt
            return omega_new, theta + omega_new * dt
            """,
        "a named tuple": """\
            from collections import namedtuple
            omega = omega - g * sin(theta) / r_param * dt
            return namedtuple("Angles", "omega theta")(omega, theta + omega * dt)
            """,
    },
    "full_swing_update": {
        "plainly": ("", ""),
        "by index": "for i in range(len(pend_list)): swing_update(pend_list[i], r_param, dt, g)",
        "by names": "for pend in pend_list: swing_update(pend_dict=pend, r_param=r_param, dt=dt, g=g)",
        "with while": """\
            i = 0
            while i < len(pend_list):
                swing_update(pend_list[i], r_param, dt, g)
                i += 1
            """,
        "from the right": "for pend in reversed(pend_list): swing_update(pend, r_param, dt, g)",
        "returns the list, too": """\
            for pend in pend_list:
                swing_update(pend, r_param, dt, g)
            return pend_list
            """,
        "without swing_update": """\
            for pend in pend_list:
                pend["omega"], pend["theta"] = angle_update(pend["omega"], pend["theta"], r_param, dt, g)
                axle, bob, cord = pend["objects"]
                bob.pos = axle.pos + vector(sin(pend["theta"]), -cos(pend["theta"]), 0) * r_param
                cord.axis = bob.pos - axle.pos
            """,
        "the cord drawn from the bob": """\
            for pend in pend_list:
                swing_update(pend, r_param, dt, g)
                axle, bob, cord = pend["objects"]
                cord.pos, cord.axis = bob.pos, axle.pos - bob.pos
            """,
    },
    "handle_collision": {
        "plainly": ("", ""),
        "without the cord length, which cancels": """\
            momentum = m1 * omega1 + m2 * omega2
            difference = e * (omega1 - omega2)
            return (momentum - m2 * difference) / (m1 + m2), (momentum + m1 * difference) / (m1 + m2)
            """,
        "through the centre of mass": """\
            common = (m1 * omega1 + m2 * omega2) / (m1 + m2)
            return common - e * (omega1 - common), common - e * (omega2 - common)
            """,
        "by the impulse": """\
            impulse = (1 + e) * (omega1 - omega2) / (1 / m1 + 1 / m2)
            return omega1 - impulse / m1, omega2 + impulse / m2
            """,
        "the second from the first by e": """\
            new1 = (m1 * omega1 + m2 * omega2 - m2 * e * (omega1 - omega2)) / (m1 + m2)
            return new1, new1 + e * (omega1 - omega2)
            """,
        "the second from the first by the momentum": """\
            new1 = ((m1 - e * m2) * omega1 + (1 + e) * m2 * omega2) / (m1 + m2)
            return new1, (m1 * omega1 + m2 * omega2 - m1 * new1) / m2
            """,
        "numpy's solver": """\
            import numpy
            left = [[m1, m2], [-1, 1]]
            return tuple(numpy.linalg.solve(left, [m1 * omega1 + m2 * omega2, e * (omega1 - omega2)]))
            """,
    },
    "handle_two_bobs": {
        "plainly": ("", ""),
        "returns the dictionaries, too": (
            "pend2['omega'] = new_omega2",
            "pend2['omega'] = new_omega2\n        return pend1, pend2",
        ),
        "unpacked and updated at once": """\
            _, bob1, _ = pend1["objects"]
            _, bob2, _ = pend2["objects"]
            if mag(bob2.pos - bob1.pos) > 1.05 * (bob1.radius + bob2.radius):
                return
            pend1["omega"], pend2["omega"] = handle_collision(
                pend1["e"], pend1["omega"], pend2["omega"], pend1["mass"], pend2["mass"], r_param
            )
            """,
        "by names": (
            "handle_collision(e, omega1, omega2, m1, m2, r_param)",
            "handle_collision(omega1=omega1, omega2=omega2, m1=m1, m2=m2, e=e, r_param=r_param)",
        ),
        "the vector's own magnitude": ("mag(bob1.pos - bob2.pos)", "(bob1.pos - bob2.pos).mag"),
        "math's square root": (
            "mag(bob1.pos - bob2.pos)",
            "__import__('math').sqrt(sum(d**2 for d in (bob1.pos - bob2.pos).value))",
        ),
        "the distance in the plane of swing": (
            "mag(bob1.pos - bob2.pos)",
            "((bob1.pos.x - bob2.pos.x)**2 + (bob1.pos.y - bob2.pos.y)**2)**0.5",
        ),
        "places from the angles": (
            "mag(bob1.pos - bob2.pos)",
            "mag(pend1['objects'][0].pos - pend2['objects'][0].pos + "
            "r_param * vector(sin(pend1['theta']) - sin(pend2['theta']), cos(pend2['theta']) - cos(pend1['theta']), 0))",
        ),
        "places from the angles, axles at one height": (
            "mag(bob1.pos - bob2.pos)",
            "__import__('math').hypot(pend1['objects'][0].pos.x + r_param * sin(pend1['theta']) - "
            "pend2['objects'][0].pos.x - r_param * sin(pend2['theta']), "
            "r_param * (cos(pend1['theta']) - cos(pend2['theta'])))",
        ),
        "places from the angles, axles r_param/4 apart": (
            "mag(bob1.pos - bob2.pos)",
            "__import__('math').hypot(r_param / 4 + r_param * (sin(pend2['theta']) - sin(pend1['theta'])), "
            "r_param * (cos(pend2['theta']) - cos(pend1['theta'])))",
        ),
        "the ends of the cords": (
            "mag(bob1.pos - bob2.pos)",
            "mag(pend1['objects'][2].pos + pend1['objects'][2].axis - pend2['objects'][2].pos - pend2['objects'][2].axis)",
        ),
        "squares compared": (
            "mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius)",
            "(bob1.pos - bob2.pos).mag2 <= (1.05 * (bob1.radius + bob2.radius))**2",
        ),
        "the gap between the bobs, and a twentieth": (
            "mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius)",
            "mag(bob1.pos - bob2.pos) - (bob1.radius + bob2.radius) <= 0.05 * (bob1.radius + bob2.radius)",
        ),
        "the radii, and a twentieth of each": (
            "1.05 * (bob1.radius + bob2.radius)",
            "bob1.radius + bob2.radius + 0.05 * bob1.radius + 0.05 * bob2.radius",
        ),
        "the gap between the bobs": (
            "mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius)",
            "mag(bob1.pos - bob2.pos) - (bob1.radius + bob2.radius) * 1.05 <= 0",
        ),
        "without handle_collision": (
            "handle_collision(e, omega1, omega2, m1, m2, r_param)",
            "omega1 - (1 + e)*m2*(omega1 - omega2)/(m1 + m2), omega2 + (1 + e)*m1*(omega1 - omega2)/(m1 + m2)",
        ),
    },
    "newton_cradle_tick": {
        "plainly": ("", ""),
        "each pair as soon as both have swung": """\
            from src.swinging import swing_update
            for i in range(len(pend_list)):
                swing_update(pend_list[i], r_param, dt, g)
                if i > 0:
                    handle_two_bobs(pend_list[i - 1], pend_list[i], r_param)
            """,
        "with zip": """\
            full_swing_update(pend_list, r_param, dt, g)
            for left, right in zip(pend_list, pend_list[1:]):
                handle_two_bobs(left, right, r_param)
            """,
        "counted from 1": """\
            full_swing_update(pend_list, r_param, dt, g)
            for i in range(1, len(pend_list)):
                handle_two_bobs(pend_list[i - 1], pend_list[i], r_param)
            """,
        "with while": """\
            full_swing_update(pend_list, r_param, dt, g)
            i = 0
            while i + 1 < len(pend_list):
                handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
                i += 1
            """,
        "the last one known by itself": """\
            full_swing_update(pend_list, r_param, dt, g)
            for i, pend in enumerate(pend_list):
                if pend is not pend_list[-1]:
                    handle_two_bobs(pend, pend_list[i + 1], r_param)
            """,
        "returns the list, too": ("r_param)\n        ", "r_param)\n        return pend_list\n        "),
        "returns a tuple, too": ("r_param)\n        ", "r_param)\n        return tuple(pend_list)\n        "),
    },
    "main": {
        "plainly": ("", ""),
        "the rule handed on": ("DT, G)", "DT, G, **page.rule)"),
        "NC_FP": ("page.csv", "__import__('support.constants').constants.NC_FP"),
        "by names": """\
            while page.is_running():
                if page.wants_cradle():
                    cradle = make_newton_cradle(relative_filepath=page.csv, theta_init=THETA_INIT, r_param=R_PARAM)
                    page.show(cradle)
                while page.wants_tick():
                    newton_cradle_tick(pend_list=cradle, g=G, dt=DT, r_param=R_PARAM)
            """,
        "more to see": """\
            from vpython import arange, arrow, color, label, rate, scene, vector
            scene.title = "Newton's cradle"
            while page.is_running():
                if page.wants_cradle():
                    cradle = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
                    for x in arange(0, 1, 0.5):
                        arrow(pos=vector(x, 0, 0), axis=vector(0, -G, 0), color=color.red)
                    name = label(pos=scene.center, text="cradle")
                    for pend in cradle:
                        pend["objects"][1].make_trail = True
                    page.show(cradle)
                while page.wants_tick():
                    rate(1 / DT)
                    newton_cradle_tick(cradle, R_PARAM, DT, G)
                    name.text = f"cradle, from {mag(scene.camera.pos):.1f} m"
            """,
        "the module of the constants": """\
            from support import constants
            length, angle = constants.R_PARAM, constants.THETA_INIT
            while page.is_running():
                if page.wants_cradle():
                    pend_list = make_newton_cradle(constants.NC_FP, length, angle)
                    page.show(pend_list)
                while page.wants_tick():
                    newton_cradle_tick(pend_list, length, constants.DT, constants.G)
            """,
        "made and shown at once": """\
            while page.is_running():
                if page.wants_cradle():
                    page.show(pend_list := make_newton_cradle(page.csv, R_PARAM, THETA_INIT))
                while page.wants_tick():
                    newton_cradle_tick(pend_list, R_PARAM, DT, G)
            """,
        "a list that stays": """\
            pend_list = []
            while page.is_running():
                if page.wants_cradle():
                    pend_list[:] = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
                    page.show(pend_list)
                while page.wants_tick():
                    newton_cradle_tick(pend_list, R_PARAM, DT, G)
            """,
    },
    "make_double_pendulum": {
        "plainly": ("", ""),
        "the lower one from a pendulum, its axle hidden": """\
            axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
            hidden, bob2, cord2 = make_pendulum(bob1.pos, r_param, theta + phi, color, texture)
            hidden.visible = False
            return axle, bob1, cord1, bob2, cord2
            """,
        "by hand": """\
            axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
            arm = vector(r_param * sin(theta + phi), -r_param * cos(theta + phi), 0)
            bob2 = sphere(pos=bob1.pos + arm, radius=bob1.radius, color=color, texture=texture)
            cord2 = cylinder(pos=bob2.pos, axis=-arm, radius=cord1.radius)
            return axle, bob1, cord1, bob2, cord2
            """,
    },
    "double_angle_update": {
        "semi-implicit Euler": ("", ""),
        "explicit Euler": """\
            a, b, u, v = theta, theta + phi, omega_theta, omega_theta + omega_phi
            du, dv = double_accelerations(a, b, u, v, g / r_param, m2 / (m1 + m2))
            return u + du * dt, v - u + (dv - du) * dt, a + u * dt, phi + (v - u) * dt
            """,
        "the accelerations in one": """\
            s, c = sin(phi), cos(phi)
            k, mu = g / r_param, m2 / (m1 + m2)
            right1 = mu * s * (omega_theta + omega_phi)**2 - k * sin(theta)
            right2 = -s * omega_theta**2 - k * sin(theta + phi)
            alpha = (right1 - mu * c * right2) / (1 - mu * c * c)
            beta = (right2 - c * right1) / (1 - mu * c * c)
            omega_theta += alpha * dt
            omega_phi += (beta - alpha) * dt
            return omega_theta, omega_phi, theta + omega_theta * dt, phi + omega_phi * dt
            """,
        "the midpoint": """\
            def rates(state):
                u, v, a, b = state
                return *double_accelerations(a, b, u, v, g / r_param, m2 / (m1 + m2)), u, v
            state = omega_theta, omega_theta + omega_phi, theta, theta + phi
            middle = [value + dt / 2 * rate for value, rate in zip(state, rates(state))]
            u, v, a, b = (value + dt * rate for value, rate in zip(state, rates(middle)))
            return u, v - u, a, b - a
            """,
    },
}
