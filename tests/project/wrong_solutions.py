"""Wrong solutions with the mistakes of beginners. The graded suites must reject them all.

WRONG has the mistakes of each function of the handout, and for each mistake the wrong version: the body of the function,
or a pair (old text, new text) that puts the mistake into the right body in PLAIN. Add a line, and
tests/project/test_graded_suites.py covers it. A body can use all names of the function's file, and
`from ... import ...`. right_solutions.py has the correct versions.
"""

PLAIN = {
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
        return pend_list
        """,
    "angle_update": """\
        omega_new = omega + -g * sin(theta) / r_param * dt
        theta_new = theta + omega_new * dt
        return (omega_new, theta_new)
        """,
    "full_swing_update": """\
        for pend in pend_list:
            swing_update(pend, r_param, dt, g)
        """,
    "handle_collision": """\
        v1 = r_param * omega1
        v2 = r_param * omega2
        v1_new = (m1*v1 + m2*v2 - m2*e*(v1 - v2)) / (m1 + m2)
        v2_new = (m1*v1 + m2*v2 + m1*e*(v1 - v2)) / (m1 + m2)
        return (v1_new / r_param, v2_new / r_param)
        """,
    "handle_two_bobs": """\
        m1, m2 = pend1['mass'], pend2['mass']
        bob1, bob2 = pend1['objects'][1], pend2['objects'][1]
        omega1, omega2 = pend1['omega'], pend2['omega']
        e = pend1['e']
        if mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius):
            new_omega1, new_omega2 = handle_collision(e, omega1, omega2, m1, m2, r_param)
            pend1['omega'] = new_omega1
            pend2['omega'] = new_omega2
        """,
    "newton_cradle_tick": """\
        full_swing_update(pend_list, r_param, dt, g)
        for i in range(len(pend_list) - 1):
            handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
        """,
    "main": """\
        while page.is_running():
            if page.wants_cradle():
                pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
                page.show(pend_list)
            while page.wants_tick():
                newton_cradle_tick(pend_list, R_PARAM, DT, G)
        """,
    "make_double_pendulum": """\
        axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
        bob2, cord2 = make_bob_and_cord(bob1.pos, r_param, theta + phi, color, texture)
        return (axle, bob1, cord1, bob2, cord2)
        """,
    "double_angle_update": """\
        a, b, u, v = theta, theta + phi, omega_theta, omega_theta + omega_phi
        du, dv = double_accelerations(a, b, u, v, g / r_param, m2 / (m1 + m2))
        u = u + du * dt
        v = v + dv * dt
        a = a + u * dt
        b = b + v * dt
        return (u, v - u, a, b - a)
        """,
}

WRONG = {
    "extract_and_convert": {
        "returns nothing": "pd.read_csv(relative_filepath).to_dict(orient='records')",
        "returns bad_rep": "return pd.read_csv(relative_filepath).to_dict(orient='index')",
        "returns the dataframe": "return pd.read_csv(relative_filepath)",
        "returns pandas' default dictionary": "return pd.read_csv(relative_filepath).to_dict()",
        "a dictionary of lists": "return pd.read_csv(relative_filepath).to_dict(orient='list')",
        "the values, not as a list": "return pd.read_csv(relative_filepath).to_dict(orient='index').values()",
        "an empty list": "pend_list = []; pd.read_csv(relative_filepath).to_dict(orient='index'); return pend_list",
        "a tuple": "return tuple(pd.read_csv(relative_filepath).to_dict(orient='records'))",
        "a generator": "return (pend for pend in pd.read_csv(relative_filepath).to_dict(orient='records'))",
        "the keys of bad_rep": "return list(pd.read_csv(relative_filepath).to_dict(orient='index'))",
        "keys and values of bad_rep": "return list(pd.read_csv(relative_filepath).to_dict(orient='index').items())",
        "bad_rep in a list": "return [pd.read_csv(relative_filepath).to_dict(orient='index')]",
        "a number as a key of each": "return [{i: pend} for i, pend in pd.read_csv(relative_filepath).T.to_dict().items()]",
        "lists of values": "return pd.read_csv(relative_filepath).values.tolist()",
        "lists of keys": "return [list(pend) for pend in pd.read_csv(relative_filepath).to_dict(orient='records')]",
        "a list in the list": "return [pd.read_csv(relative_filepath).to_dict(orient='records')]",
        "the first pendulum alone": "return pd.read_csv(relative_filepath).to_dict(orient='records')[:1]",
        "return inside the loop": """\
            pend_list = []
            for pend in pd.read_csv(relative_filepath).to_dict(orient='index').values():
                pend_list.append(pend)
                return pend_list
            """,
        "the list made inside the loop": """\
            for pend in pd.read_csv(relative_filepath).to_dict(orient='index').values():
                pend_list = []
                pend_list.append(pend)
            return pend_list
            """,
        "one dictionary for all rows": """\
            pend_list, pend_dict = [], {}
            for pend in pd.read_csv(relative_filepath).to_dict(orient='index').values():
                pend_dict.update(pend)
                pend_list.append(pend_dict)
            return pend_list
            """,
        "counts from 1": """\
            bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
            return [bad_rep[i] for i in range(1, len(bad_rep))]
            """,
        "counts to the last but one": """\
            bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
            return [bad_rep[i] for i in range(len(bad_rep) - 1)]
            """,
        "counts too far": """\
            bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
            return [bad_rep[i] for i in range(len(bad_rep) + 1)]
            """,
        "always five pendula": """\
            bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
            return [bad_rep[i] for i in range(5)]
            """,
        "always three pendula": """\
            bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
            return [bad_rep[i] for i in range(3)]
            """,
        "in reverse order": "return pd.read_csv(relative_filepath).to_dict(orient='records')[::-1]",
        "the file given is ignored": "return pd.read_csv(NC_FP).to_dict(orient='records')",
        "all values as text": "return pd.read_csv(relative_filepath, dtype=str).to_dict(orient='records')",
        "the header as a pendulum": "return pd.read_csv(relative_filepath, header=None).to_dict(orient='records')",
        "the keys written down": """\
            keys = ['mass', 'e', 'theta', 'omega', 'color', 'texture']
            return [{key: pend[key] for key in keys} for pend in pd.read_csv(relative_filepath).to_dict('records')]
            """,
        "without the texture": "return pd.read_csv(relative_filepath).iloc[:, :5].to_dict(orient='records')",
        "whole numbers": "return pd.read_csv(relative_filepath).astype(int, errors='ignore').round().to_dict(orient='records')",
        "the attributes sorted": "return [sorted(pend) for pend in pd.read_csv(relative_filepath).to_dict(orient='records')]",
        "the first five rows": "return pd.read_csv(relative_filepath).head().to_dict('records')",
        "equal rows once": "return pd.read_csv(relative_filepath).drop_duplicates().to_dict('records')",
        "rounded": "return pd.read_csv(relative_filepath).round(2).to_dict('records')",
        "zeros left out": "return [{k: v for k, v in p.items() if v} for p in pd.read_csv(relative_filepath).to_dict('records')]",
        "zeros as None": "return [{k: v or None for k, v in p.items()} for p in pd.read_csv(relative_filepath).to_dict('records')]",
        "the list appended to itself": """\
            pend_list = []
            for pend in pd.read_csv(relative_filepath).to_dict(orient='index').values():
                pend_list.append(pend_list)
            return pend_list
            """,
        "appended once for each key": """\
            pend_list = []
            for pend in pd.read_csv(relative_filepath).to_dict(orient='index').values():
                for key in pend:
                    pend_list.append(pend)
            return pend_list
            """,
        "one list for all calls": """\
            pend_list = extract_and_convert.__dict__.setdefault('pend_list', [])
            pend_list[:] = pd.read_csv(relative_filepath).to_dict('records')
            return pend_list
            """,
        "remembers what it has read": """\
            cache = extract_and_convert.__dict__.setdefault('cache', {})
            if relative_filepath not in cache:
                cache[relative_filepath] = pd.read_csv(relative_filepath).to_dict('records')
            return [dict(pend) for pend in cache[relative_filepath]]
            """,
        "only prints": "print(list(pd.read_csv(relative_filepath).to_dict(orient='index').values()))",
        "row numbers sorted as text": "return [p for _, p in sorted(pd.read_csv(relative_filepath).T.to_dict().items(), key=lambda of: str(of[0]))]",
        "ten at most": "return pd.read_csv(relative_filepath).head(10).to_dict('records')",
    },
    "uniform_mass_newton_cradle": {
        "changes nothing": "return extract_and_convert(relative_filepath)",
        "returns nothing": "for pend in extract_and_convert(relative_filepath): pend['mass'] = mass",
        "only the first": """\
            pend_list = extract_and_convert(relative_filepath)
            pend_list[0]['mass'] = mass
            return pend_list
            """,
        "only the last": """\
            pend_list = extract_and_convert(relative_filepath)
            pend_list[-1]['mass'] = mass
            return pend_list
            """,
        "all but the first": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list[1:]:
                pend['mass'] = mass
            return pend_list
            """,
        "return inside the loop": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend['mass'] = mass
                return pend_list
            """,
        "returns one pendulum": """\
            for pend in extract_and_convert(relative_filepath):
                pend['mass'] = mass
            return pend
            """,
        "as text": "return [{**pend, 'mass': str(mass)} for pend in extract_and_convert(relative_filepath)]",
        "returns the first pendulum": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend['mass'] = mass
            return pend_list[0]
            """,
        "the name as a text": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend['mass'] = 'mass'
            return pend_list
            """,
        "always 1": "return [{**pend, 'mass': 1.0} for pend in extract_and_convert(relative_filepath)]",
        "a misspelt key": "return [{**pend, 'Mass': mass} for pend in extract_and_convert(relative_filepath)]",
        "e instead": "return [{**pend, 'e': mass} for pend in extract_and_convert(relative_filepath)]",
        "mass alone": "return [{'mass': mass} for pend in extract_and_convert(relative_filepath)]",
        "multiplied": "return [{**pend, 'mass': pend['mass'] * mass} for pend in extract_and_convert(relative_filepath)]",
        "added": "return [{**pend, 'mass': pend['mass'] + mass} for pend in extract_and_convert(relative_filepath)]",
        "the file given is ignored": "from support.constants import NC_FP; return [{**pend, 'mass': mass} for pend in extract_and_convert(NC_FP)]",
        "whole numbers": "return [{**pend, 'mass': int(mass)} for pend in extract_and_convert(relative_filepath)]",
        "at most three": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list[:3]:
                pend['mass'] = mass
            return pend_list
            """,
        "rounded": "return [{**pend, 'mass': round(mass, 2)} for pend in extract_and_convert(relative_filepath)]",
        "writes the shipped file": """\
            from src.pds_helper import write_to_csv
            pend_list = [{**pend, 'mass': mass} for pend in extract_and_convert(relative_filepath)]
            write_to_csv(pend_list)
            return pend_list
            """,
        "compared, not assigned": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend['mass'] == mass
            return pend_list
            """,
        "the loop's name assigned": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend = {**pend, 'mass': mass}
            return pend_list
            """,
        "writes the file": """\
            from src.pds_helper import write_to_csv
            pend_list = [{**pend, 'mass': mass} for pend in extract_and_convert(relative_filepath)]
            write_to_csv(pend_list, relative_filepath)
            return pend_list
            """,
        "the first column, whatever its name": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend[list(pend)[0]] = mass
            return pend_list
            """,
        "counts on a first pendulum": """\
            pend_list = extract_and_convert(relative_filepath)
            pend_list[0]['mass'] = mass
            for pend in pend_list[1:]:
                pend['mass'] = mass
            return pend_list
            """,
        "the mass of the first call": """\
            mass = uniform_mass_newton_cradle.__dict__.setdefault('mass', mass)
            return [{**pend, 'mass': mass} for pend in extract_and_convert(relative_filepath)]
            """,
    },
    "uniform_e_newton_cradle": {
        "changes nothing": "return extract_and_convert(relative_filepath)",
        "returns nothing": "for pend in extract_and_convert(relative_filepath): pend['e'] = e_val",
        "only the first": """\
            pend_list = extract_and_convert(relative_filepath)
            pend_list[0]['e'] = e_val
            return pend_list
            """,
        "return inside the loop": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend['e'] = e_val
                return pend_list
            """,
        "only the last": """\
            pend_list = extract_and_convert(relative_filepath)
            pend_list[-1]['e'] = e_val
            return pend_list
            """,
        "a new key": "return [{**pend, 'e_val': e_val} for pend in extract_and_convert(relative_filepath)]",
        "always 1": "return [{**pend, 'e': 1} for pend in extract_and_convert(relative_filepath)]",
        "mass instead": "return uniform_mass_newton_cradle(relative_filepath, e_val)",
        "e and mass": "return [{**pend, 'e': e_val, 'mass': e_val} for pend in extract_and_convert(relative_filepath)]",
        "only where e is larger": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                pend['e'] = min(pend['e'], e_val)
            return pend_list
            """,
        "only where e is not 0": """\
            pend_list = extract_and_convert(relative_filepath)
            for pend in pend_list:
                if pend['e']:
                    pend['e'] = e_val
            return pend_list
            """,
        "0 counts as none": "return [{**pend, 'e': e_val or pend['e']} for pend in extract_and_convert(relative_filepath)]",
        "as text": "return [{**pend, 'e': str(e_val)} for pend in extract_and_convert(relative_filepath)]",
        "the file given is ignored": "from support.constants import NC_FP; return [{**pend, 'e': e_val} for pend in extract_and_convert(NC_FP)]",
    },
    "elastic_newton_cradle": {
        "e is 0": "return uniform_e_newton_cradle(relative_filepath, 0)",
        "e is 100": "return uniform_e_newton_cradle(relative_filepath, 100)",
        "e is nearly 1": "return uniform_e_newton_cradle(relative_filepath, 0.99)",
        "e is a text": "return uniform_e_newton_cradle(relative_filepath, '1')",
        "mass is 1": "return uniform_mass_newton_cradle(relative_filepath, 1)",
        "returns nothing": "uniform_e_newton_cradle(relative_filepath, 1)",
        "arguments exchanged": "return uniform_e_newton_cradle(1, relative_filepath)",
        "returns the function": "return uniform_e_newton_cradle",
        "the file given is ignored": "from support.constants import NC_FP; return uniform_e_newton_cradle(NC_FP, 1)",
        "as in the file": "return extract_and_convert(relative_filepath)",
    },
    "inelastic_newton_cradle": {
        "e is 1": "return uniform_e_newton_cradle(relative_filepath, 1)",
        "e is -1": "return uniform_e_newton_cradle(relative_filepath, -1)",
        "e is 0.5": "return uniform_e_newton_cradle(relative_filepath, 0.5)",
        "e is None": "return uniform_e_newton_cradle(relative_filepath, None)",
        "mass is 0": "return uniform_mass_newton_cradle(relative_filepath, 0)",
        "returns nothing": "uniform_e_newton_cradle(relative_filepath, 0)",
        "arguments exchanged": "return uniform_e_newton_cradle(0.0, relative_filepath)",
        "the file given is ignored": "from support.constants import NC_FP; return uniform_e_newton_cradle(NC_FP, 0)",
        "e is taken away": "return [{k: v for k, v in p.items() if k != 'e'} for p in extract_and_convert(relative_filepath)]",
    },
    "make_newton_cradle": {
        "returns nothing": ("return pend_list", ""),
        "returns one pendulum": ("return pend_list", "return pend"),
        "return inside the loop": ("        return", "            return"),
        "returns the objects": ("return pend_list", "return [pend['objects'] for pend in pend_list]"),
        "returns an empty list": ("return pend_list", "return []"),
        "the file given is ignored": (
            "pend_list = extract_and_convert(relative_filepath)",
            "from support.constants import NC_FP; pend_list = extract_and_convert(NC_FP)",
        ),
        "always elastic": ("extract_and_convert(", "elastic_newton_cradle("),
        "one list for all cradles": (
            "pend_list = extract_and_convert(relative_filepath)",
            "pend_list = globals().setdefault('_cradle', extract_and_convert(relative_filepath))",
        ),
        "the angles of the file": ("pend['theta'] = 0", "pass"),
        "theta is not set": (
            "if i == 0:\n                pend['theta'] = theta_init\n            else:\n                pend['theta'] = 0",
            "pass",
        ),
        "theta and omega mixed up": ("pend['omega'] = 0", "pend['omega'], pend['theta'] = pend['theta'], 0"),
        "all are lifted": ("pend['theta'] = 0", "pend['theta'] = theta_init"),
        "none is lifted": ("pend['theta'] = theta_init", "pend['theta'] = 0"),
        "the last is lifted": ("i == 0", "i == len(pend_list) - 1"),
        "the second is lifted": ("i == 0", "i == 1"),
        "all but the first are lifted": ("i == 0", "i != 0"),
        "0 counts as no angle": ("= theta_init", "= theta_init or pend['theta']"),
        "at most 90 degrees": ("= theta_init", "= max(-1.5707963, min(1.5707963, theta_init))"),
        "not if it is alone": ("= theta_init", "= theta_init if len(pend_list) > 1 else 0"),
        "counted by its mass": ("* i)", "* [other['mass'] for other in pend_list].index(pend['mass']))"),
        "five at most": ("return pend_list", "return pend_list[:5]"),
        "bobs that cannot be seen": (
            "texture)\n        return",
            "texture)\n            pend['objects'][1].visible = False\n        return",
        ),
        "itself as its objects": (
            "texture)\n        return",
            "texture)\n            pend['objects'] = pend\n        return",
        ),
        "degrees": ("= theta_init", "= __import__('math').degrees(theta_init)"),
        "always the shipped angle": ("= theta_init", "= __import__('support.constants').constants.THETA_INIT"),
        "to the other side": ("= theta_init", "= -theta_init"),
        "the omegas of the file": ("pend['omega'] = 0", "pass"),
        "omega is taken away": ("pend['omega'] = 0", "del pend['omega']"),
        "omega is None": ("pend['omega'] = 0", "pend['omega'] = None"),
        "omega is theta_init": ("pend['omega'] = 0", "pend['omega'] = theta_init"),
        "omega compared, not assigned": ("pend['omega'] = 0", "pend['omega'] == 0"),
        "no objects": ("pend['objects'] = make_pendulum", "make_pendulum"),
        "objects under another key": ("pend['objects']", "pend['object']"),
        "objects as a list": (
            "texture)\n        return",
            "texture)\n            pend['objects'] = [*pend['objects']]\n        return",
        ),
        "objects in another order": ("texture)\n        return", "texture)[::-1]\n        return"),
        "the bob alone": ("texture)\n        return", "texture)[1]\n        return"),
        "the same objects for all": ("pend['objects'] = ", "pend['objects'] = pend_list[0].get('objects') or "),
        "axles from 0 on": ("-0.1 + ", ""),
        "axles from +0.1 on": ("-0.1 +", "0.1 +"),
        "axles counted from 1": ("* i", "* (i + 1)"),
        "all axles in one place": ("* i", ""),
        "axles r_param apart": ("r_param/4", "r_param"),
        "axles half as far apart": ("r_param/4", "r_param/8"),
        "axles by the shipped cord": ("r_param/4 * i", "0.05 * i"),
        "axles from right to left": ("-0.1 + r_param/4 * i", "0.1 - r_param/4 * i"),
        "i multiplies all": ("(-0.1 + r_param/4 * i)", "(-0.1 + r_param/4) * i"),
        "r_param/4 and r_param/5 mixed up": ("r_param/4 * i), r_param/5", "r_param/5 * i), r_param/4"),
        "axles to the left of the first": ("-0.1 + r_param/4", "-0.1 - r_param/4"),
        "axles at height 0": ("r_param/5, 0)", "0, 0)"),
        "axles below": ("r_param/5, 0)", "-r_param/5, 0)"),
        "axles at the height of the shipped ones": ("r_param/5, 0)", "0.04, 0)"),
        "axles along y": ("vector((-0.1 + r_param/4 * i), r_param/5, 0)", "vector(r_param/5, -0.1 + r_param/4 * i, 0)"),
        "axles along z": ("vector((-0.1 + r_param/4 * i), r_param/5, 0)", "vector(0, r_param/5, -0.1 + r_param/4 * i)"),
        "the position as a tuple": (
            "= vector((-0.1 + r_param/4 * i), r_param/5, 0)",
            "= (-0.1 + r_param/4 * i, r_param/5, 0)",
        ),
        "bobs all hang": ("r_param, pend['theta']", "r_param, 0"),
        "bobs all lifted": ("r_param, pend['theta']", "r_param, theta_init"),
        "objects made before theta is set": """\
            pend_list = extract_and_convert(relative_filepath)
            for i, pend in enumerate(pend_list):
                axle_pos = vector(-0.1 + r_param/4 * i, r_param/5, 0)
                color, texture = COLOR_MAP[pend['color']], TEXTURE_MAP[pend['texture']]
                pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)
                pend['theta'], pend['omega'] = theta_init if i == 0 else 0, 0
            return pend_list
            """,
        "cords of the shipped length": ("axle_pos, r_param", "axle_pos, 0.2"),
        "angle and length exchanged": ("r_param, pend['theta']", "pend['theta'], r_param"),
        "the name of the color": ("COLOR_MAP[pend['color']]", "pend['color']"),
        "the name of the texture": ("TEXTURE_MAP[pend['texture']]", "pend['texture']"),
        "no texture": ("TEXTURE_MAP[pend['texture']]", "None"),
        "always red": ("COLOR_MAP[pend['color']]", "COLOR_MAP['red']"),
        "always metal": ("TEXTURE_MAP[pend['texture']]", "TEXTURE_MAP['metal']"),
        "the looks of the first row": ("COLOR_MAP[pend['color']]", "COLOR_MAP[pend_list[0]['color']]"),
        "the looks of the last row": (
            "[pend['color']], TEXTURE_MAP[pend[",
            "[pend_list[-1]['color']], TEXTURE_MAP[pend_list[-1][",
        ),
        "color and texture exchanged": (
            "r_param, pend['theta'], color, texture",
            "r_param, pend['theta'], texture, color",
        ),
        "the color replaced by its vector": ("pend['objects'] =", "pend['color'], pend['objects'] = color,"),
        "the last left out": ("range(len(pend_list))", "range(len(pend_list) - 1)"),
        "the first left out": ("range(len(pend_list))", "range(1, len(pend_list))"),
        "five pendula, whatever the file has": ("range(len(pend_list))", "range(5)"),
        "made twice": (
            "pend['objects'] = make",
            "make_pendulum(axle_pos, r_param, pend['theta'], color, texture); pend['objects'] = make",
        ),
        "made first with the angles of the file": (
            "pend_list = extract_and_convert(relative_filepath)",
            "pend_list = extract_and_convert(relative_filepath)\n        for p in pend_list: "
            "p['objects'] = make_pendulum(vector(0, 0, 0), r_param, p['theta'], COLOR_MAP[p['color']], None)",
        ),
        "axle, bob and cord each from its own pendulum": (
            "make_pendulum(axle_pos, r_param, pend['theta'], color, texture)",
            "tuple(make_pendulum(axle_pos, r_param, pend['theta'], color, texture)[part] for part in range(3))",
        ),
        "the first known by its mass": ("i == 0", "pend['mass'] == pend_list[0]['mass']"),
        "the first known by its color": ("i == 0", "pend['color'] == pend_list[0]['color']"),
        "the first known by its row": (
            "i == 0",
            "extract_and_convert(relative_filepath)[i] == extract_and_convert(relative_filepath)[0]",
        ),
        "counted by its row": (
            "* i)",
            "* extract_and_convert(relative_filepath).index(extract_and_convert(relative_filepath)[i]))",
        ),
        "at most half a round": ("= theta_init", "= max(-3.1415926, min(3.1415926, theta_init))"),
        "at most one round": ("= theta_init", "= __import__('math').fmod(theta_init, 6.283185307179586)"),
        "a small angle is 0": ("= theta_init", "= theta_init if abs(theta_init) > 1e-6 else 0"),
        "sorted by mass": ("for i in", "pend_list.sort(key=lambda pend: pend['mass'])\n        for i in"),
        "twenty at most": ("return pend_list", "return pend_list[:20]"),
        "a few colors": (
            "COLOR_MAP[pend['color']]",
            "COLOR_MAP[pend['color'] if pend['color'] != 'orange' else 'white']",
        ),
        "the cord of the first straight down": (
            "return pend_list",
            "pend_list[0]['objects'][2].axis = vector(0, -r_param, 0)\n        return pend_list",
        ),
    },
    "angle_update": {
        "the old omega": ("theta + omega_new", "theta + omega"),
        "theta first, then omega by the new theta": "theta += omega * dt; return omega - g * sin(theta) / r_param * dt, theta",
        "the sign of gravity": ("+ -g", "+ g"),
        "the sign of theta's change": ("theta + omega_new", "theta - omega_new"),
        "degrees": ("sin(theta)", "sin(theta * 3.141592653589793 / 180)"),
        "degrees the other way": ("sin(theta)", "sin(theta * 180 / 3.141592653589793)"),
        "cos": ("sin(theta)", "cos(theta)"),
        "tan": ("sin(theta)", "(sin(theta) / cos(theta))"),
        "theta itself": ("sin(theta)", "theta"),
        "theta's sign lost": ("sin(theta)", "abs(sin(theta))"),
        "omega for theta": ("sin(theta)", "sin(omega)"),
        "r_param as a factor": ("/ r_param", "* r_param"),
        "r_param missing": ("/ r_param", ""),
        "r_param squared": ("/ r_param", "/ r_param**2"),
        "the shipped r_param": ("/ r_param", "/ 0.2"),
        "g missing": ("-g *", "-1 *"),
        "the shipped g": ("-g *", "-9.81 *"),
        "dt missing in omega": ("/ r_param * dt", "/ r_param"),
        "dt missing in theta": ("omega_new * dt", "omega_new"),
        "the shipped dt": ("omega_new * dt", "omega_new * 0.0001"),
        "half a dt": ("/ r_param * dt", "/ r_param * dt / 2"),
        "dt squared": ("omega_new * dt", "omega_new * dt**2"),
        "dt as a divisor": ("omega_new * dt", "omega_new / dt"),
        "the acceleration returned": ("(omega_new, theta_new)", "(-g * sin(theta) / r_param, theta_new)"),
        "old omega forgotten": ("omega + -g", "-g"),
        "old theta forgotten": ("theta + omega_new", "omega_new"),
        "theta not moved": ("= theta + omega_new * dt", "= theta"),
        "omega not changed": ("= omega + -g * sin(theta) / r_param * dt", "= omega"),
        "the old values": ("(omega_new, theta_new)", "(omega, theta)"),
        "the order of the result": ("(omega_new, theta_new)", "(theta_new, omega_new)"),
        "a list": ("(omega_new, theta_new)", "[omega_new, theta_new]"),
        "a dictionary": ("(omega_new, theta_new)", "{'omega': omega_new, 'theta': theta_new}"),
        "a vector": ("(omega_new, theta_new)", "vector(omega_new, theta_new, 0)"),
        "theta alone": ("(omega_new, theta_new)", "theta_new"),
        "three values": ("(omega_new, theta_new)", "(omega_new, theta_new, dt)"),
        "nothing": ("return", "result ="),
        "prints the result": ("return (", "print("),
        "rounded": ("(omega_new, theta_new)", "(round(omega_new, 2), round(theta_new, 2))"),
        "at most 90 degrees": ("(omega_new, theta_new)", "(omega_new, max(-1.57, min(1.57, theta_new)))"),
        "not below -90 degrees": ("(omega_new, theta_new)", "(omega_new, max(-1.5707963, theta_new))"),
        "never beyond once round": "from math import fmod, pi; omega -= g * sin(theta) / r_param * dt; return omega, fmod(theta + omega * dt, 2 * pi)",
        "stops if slow": ("(omega_new, theta_new)", "(omega_new if abs(omega_new) > 1e-3 else 0, theta_new)"),
        "g and dt missing": ("-g * sin(theta) / r_param * dt", "-sin(theta) / r_param"),
        "never negative": ("(omega_new, theta_new)", "(omega_new, abs(theta_new))"),
        "damped": ("(omega_new, theta_new)", "(omega_new * 0.999, theta_new)"),
        "a small angle's sine": ("sin(theta)", "(theta - theta**3 / 6)"),
        "cut to whole numbers": ("(omega_new, theta_new)", "(int(omega_new), theta_new)"),
        "a name misspelt": ("return (omega_new, theta_new)", "return (omega_nwe, theta_new)"),
        "dt multiplies the old omega, too": (
            "omega + -g * sin(theta) / r_param * dt",
            "(omega + -g * sin(theta) / r_param) * dt",
        ),
        "dt multiplies the old theta, too": ("theta + omega_new * dt", "(theta + omega_new) * dt"),
        "theta divided by r_param": ("sin(theta) / r_param", "sin(theta / r_param)"),
        "rounded down": ("/ r_param", "// r_param"),
        "very slow is 0": ("(omega_new, theta_new)", "(omega_new if abs(omega_new) > 1e-7 else 0, theta_new)"),
        "a small angle is 0": ("(omega_new, theta_new)", "(omega_new, theta_new if abs(theta_new) > 1e-7 else 0)"),
        "one round taken away": ("return (", "theta_new -= (theta_new > 100) * 6.283185307179586; return ("),
        "counts its calls": (
            "return (omega_new, theta_new)",
            "calls = angle_update.__dict__.setdefault('calls', []); calls.append(1); return (omega_new, theta_new + (len(calls) > 3))",
        ),
        "theta itself for small angles": ("sin(theta)", "(sin(theta) if abs(theta) > 0.1 else theta)"),
        "at most 100 rad/s": ("return (", "omega_new = min(100, omega_new); return ("),
    },
    "full_swing_update": {
        "does nothing": "pass",
        "not written": "raise NotImplementedError",
        "return inside the loop": "for pend in pend_list: return swing_update(pend, r_param, dt, g)",
        "break inside the loop": """\
            for pend in pend_list:
                swing_update(pend, r_param, dt, g)
                break
            """,
        "only the first": "swing_update(pend_list[0], r_param, dt, g)",
        "only the last": "swing_update(pend_list[-1], r_param, dt, g)",
        "all but the first": ("in pend_list", "in pend_list[1:]"),
        "all but the last": ("in pend_list", "in pend_list[:-1]"),
        "every second one": ("in pend_list", "in pend_list[::2]"),
        "the first again and again": ("swing_update(pend,", "swing_update(pend_list[0],"),
        "twice": ("in pend_list", "in pend_list + pend_list"),
        "five at most": ("in pend_list", "in pend_list[:5]"),
        "collides, too": """\
            from src.visualize_cradle_run import handle_two_bobs
            for pend in pend_list:
                swing_update(pend, r_param, dt, g)
            for left, right in zip(pend_list, pend_list[1:]):
                handle_two_bobs(left, right, r_param)
            """,
        "bobs that shrink": ("r_param, dt, g)", "r_param, dt, g); pend['objects'][1].radius *= 0.99"),
        "sorted by mass": "pend_list.sort(key=lambda pend: pend['mass'])\nfor pend in pend_list: swing_update(pend, r_param, dt, g)",
        "the whole list at once": "swing_update(pend_list, r_param, dt, g)",
        "copies": ("swing_update(pend,", "swing_update(dict(pend),"),
        "only those that move": ("swing_update(", "if pend['omega']: swing_update("),
        "the shipped r_param": ("r_param, dt", "0.2, dt"),
        "the shipped g": ("dt, g", "dt, 9.81"),
        "the shipped dt": ("dt, g", "0.0001, g"),
        "dt and g exchanged": ("dt, g", "g, dt"),
        "r_param and dt exchanged": ("r_param, dt", "dt, r_param"),
        "an argument too few": ("dt, g", "dt"),
        "angles only": "for pend in pend_list: pend['omega'], pend['theta'] = angle_update(pend['omega'], pend['theta'], r_param, dt, g)",
        "angles exchanged": "for pend in pend_list: pend['theta'], pend['omega'] = angle_update(pend['omega'], pend['theta'], r_param, dt, g)",
        "angle_update in place of swing_update": ("swing_update", "angle_update"),
        "angles thrown away": "for pend in pend_list: angle_update(pend['omega'], pend['theta'], r_param, dt, g)",
        "stops at the first that is at rest": """\
            for pend in pend_list:
                if pend['theta'] == 0:
                    return
                swing_update(pend, r_param, dt, g)
            """,
        "lets the first two collide": """\
            for pend in pend_list:
                swing_update(pend, r_param, dt, g)
            first, second, *_ = pend_list
            first['omega'], second['omega'] = second['omega'], first['omega']
            """,
        "sorted by angle": "pend_list.sort(key=lambda pend: pend['theta'])\nfor pend in pend_list: swing_update(pend, r_param, dt, g)",
        "the slow ones stopped": ("dt, g)", "dt, g); pend['omega'] *= abs(pend['omega']) > 1e-7"),
        "twenty at most": ("in pend_list", "in pend_list[:20]"),
        "made again, and left in the scene": (
            "dt, g)",
            "dt, g); from support.pendulum import make_pendulum; "
            "make_pendulum(pend['objects'][0].pos, r_param, pend['theta'], pend['objects'][1].color, None)",
        ),
        "an angle of one round at most": (
            "dt, g)",
            "dt, g); pend['theta'] = __import__('math').fmod(pend['theta'], 6.283185307179586)",
        ),
        "sorted by place": "pend_list.sort(key=lambda pend: pend['objects'][0].pos.x)\nfor pend in pend_list: swing_update(pend, r_param, dt, g)",
        "sorted by e": "pend_list.sort(key=lambda pend: -pend['e'])\nfor pend in pend_list: swing_update(pend, r_param, dt, g)",
        "found by its mass": (
            "swing_update(pend,",
            "swing_update(next(p for p in pend_list if p['mass'] == pend['mass']),",
        ),
        "found by its angle": (
            "swing_update(pend,",
            "swing_update(next(p for p in pend_list if p['theta'] == pend['theta']),",
        ),
        "one that equals the one before is left out": (
            "swing_update(pend,",
            "i = [p is pend for p in pend_list].index(True)\n            "
            "if i and pend['theta'] == pend_list[i - 1].get('was'): continue\n            "
            "pend['was'] = pend['theta']; swing_update(pend,",
        ),
    },
    "handle_collision": {
        "elastic always": ("v1 = r_param", "e = 1; v1 = r_param"),
        "inelastic always": "return (m1*omega1 + m2*omega2) / (m1 + m2), (m1*omega1 + m2*omega2) / (m1 + m2)",
        "velocities exchanged": "return omega2, omega1",
        "velocities exchanged times e": "return e * omega2, e * omega1",
        "nothing changed": "return omega1, omega2",
        "both turned round": "return -e * omega1, -e * omega2",
        "masses exchanged": ("v1 = r_param", "m1, m2 = m2, m1; v1 = r_param"),
        "m1 in both": ("- m2*e", "- m1*e"),
        "m2 in both": ("+ m1*e", "+ m2*e"),
        "the masses of the e-terms exchanged": "p, u = m1*omega1 + m2*omega2, e*(omega1 - omega2); return (p - m1*u)/(m1 + m2), (p + m2*u)/(m1 + m2)",
        "the sign of e in the first": ("- m2*e", "+ m2*e"),
        "the sign of e in the second": ("+ m1*e", "- m1*e"),
        "the sign of e in both": ("v1 = r_param", "e = -e; v1 = r_param"),
        "e missing in the first": ("- m2*e*", "- m2*"),
        "e missing in the second": ("+ m1*e*", "+ m1*"),
        "v1 + v2 in the first": ("m2*e*(v1 - v2)", "m2*e*(v1 + v2)"),
        "v1 + v2 in the second": ("m1*e*(v1 - v2)", "m1*e*(v1 + v2)"),
        "v1 + v2 in both": ("(v1 - v2)", "(v1 + v2)"),
        "the speed's sign lost": ("m1*e*(v1 - v2)", "m1*e*abs(v1 - v2)"),
        "momentum with a minus": ("v1_new = (m1*v1 + m2*v2", "v1_new = (m1*v1 - m2*v2"),
        "masses missing in the momentum": ("v1_new = (m1*v1 + m2*v2", "v1_new = (v1 + v2"),
        "divided by one mass": ("/ (m1 + m2)\n        v2", "/ m1\n        v2"),
        "divided by the product": ("/ (m1 + m2)\n        return", "/ (m1 * m2)\n        return"),
        "neither divided": ("/ (m1 + m2)", ""),
        "both divided by the product": ("(m1 + m2)", "(m1 * m2)"),
        "not divided": ("/ (m1 + m2)\n        return", "\n        return"),
        "brackets forgotten": ("(m1*v1 + m2*v2 - m2*e*(v1 - v2))", "m1*v1 + m2*v2 - m2*e*(v1 - v2)"),
        "brackets forgotten in the second": ("(m1*v1 + m2*v2 + m1*e*(v1 - v2))", "m1*v1 + m2*v2 + m1*e*(v1 - v2)"),
        "brackets forgotten in both": """\
            v1 = r_param * omega1
            v2 = r_param * omega2
            v1_new = m1*v1 + m2*v2 - m2*e*(v1 - v2) / (m1 + m2)
            v2_new = m1*v1 + m2*v2 + m1*e*(v1 - v2) / (m1 + m2)
            return (v1_new / r_param, v2_new / r_param)
            """,
        "brackets of the sum forgotten": ("/ (m1 + m2)\n        return", "/ m1 + m2\n        return"),
        "the new v1 in the second": ("m1*e*(v1 - v2)", "m1*e*(v1_new - v2)"),
        "not converted back": ("(v1_new / r_param, v2_new / r_param)", "(v1_new, v2_new)"),
        "only the first converted back": ("v2_new / r_param)", "v2_new)"),
        "never converted to": ("r_param * omega", "omega"),
        "only the first converted to": ("v2 = r_param * omega2", "v2 = omega2"),
        "converted the wrong way round": (
            "(v1_new / r_param, v2_new / r_param)",
            "(v1_new * r_param, v2_new * r_param)",
        ),
        "the shipped r_param": ("(v1_new / r_param, v2_new / r_param)", "(v1_new / 0.2, v2_new / 0.2)"),
        "the order of the result": ("(v1_new / r_param, v2_new / r_param)", "(v2_new / r_param, v1_new / r_param)"),
        "a list": ("(v1_new / r_param, v2_new / r_param)", "[v1_new / r_param, v2_new / r_param]"),
        "one value": ("(v1_new / r_param, v2_new / r_param)", "v1_new / r_param"),
        "the first twice": ("(v1_new / r_param, v2_new / r_param)", "(v1_new / r_param, v1_new / r_param)"),
        "nothing": ("return (v1_new / r_param, v2_new / r_param)", ""),
        "only approaching": (
            "v1 = r_param * omega1\n",
            "v1 = r_param * omega1\n        if omega1 <= omega2: return omega1, omega2\n",
        ),
        "nothing if the first is at rest": (
            "v1 = r_param",
            "if omega1 == 0: return omega1, omega2\n        v1 = r_param",
        ),
        "nothing if both go to the left": (
            "v1 = r_param",
            "if max(omega1, omega2) < 0: return omega1, omega2\n        v1 = r_param",
        ),
        "a small e as 0": ("v1 = r_param", "e = e if e > 0.2 else 0; v1 = r_param"),
        "a heavy one as a wall": ("v1 = r_param", "if m2 > 50 * m1: return -e * omega1, omega2\n        v1 = r_param"),
        "e in place of 1 + e": "p = e*m1*m2*(omega1 - omega2)/(m1 + m2); return omega1 - p/m1, omega2 + p/m2",
        "only if e is 1": "return (omega2, omega1) if e == 1 else (omega1, omega2)",
        "absolute values": ("(v1_new / r_param, v2_new / r_param)", "(abs(v1_new / r_param), abs(v2_new / r_param))"),
        "rounded": ("(v1_new / r_param, v2_new / r_param)", "(round(v1_new / r_param, 1), round(v2_new / r_param, 1))"),
        "equal masses taken for granted": "u = e*(omega1 - omega2); return (omega1 + omega2 - u)/2, (omega1 + omega2 + u)/2",
        "energy lost by e, not speed": ("v1 = r_param", "e = e**0.5; v1 = r_param"),
        "only the second moved": "return 0.0, (m1*omega1 + m2*omega2) / m2",
        "rounded down": ("/ (m1 + m2)", "// (m1 + m2)"),
        "rounded down on the way back": (
            "(v1_new / r_param, v2_new / r_param)",
            "(v1_new // r_param, v2_new // r_param)",
        ),
        "multiplied by the sum of the masses": ("/ (m1 + m2)", "* (m1 + m2)"),
        "divided by m1 alone": ("/ (m1 + m2)", "/ m1 + m2"),
        "divided by r_param both ways": ("r_param * omega", "1 / r_param * omega"),
        "1 - e for e": ("v1 = r_param", "e = 1 - e; v1 = r_param"),
        "e times the first velocity alone": ("e*(v1 - v2)", "e*v1"),
        "very slow is at rest": ("v1 = r_param", "omega1 = omega1 if abs(omega1) > 1e-7 else 0; v1 = r_param"),
        "nearly equal is equal": (
            "v1 = r_param",
            "if abs(omega1 - omega2) < 1e-7: return omega1, omega2\n        v1 = r_param",
        ),
        "a very heavy one is not slowed": (
            "v1 = r_param",
            "if m1 > 100 * m2: return omega1, (1 + e)*omega1 - e*omega2\n        v1 = r_param",
        ),
        "at most 20 rad/s": (
            "(v1_new / r_param, v2_new / r_param)",
            "(max(-20, min(20, v1_new / r_param)), max(-20, min(20, v2_new / r_param)))",
        ),
    },
    "handle_two_bobs": {
        "does nothing": "pass",
        "never compares": ("if mag(bob1.pos - bob2.pos) <= 1.05 * (bob1.radius + bob2.radius):", "if True:"),
        "without the buffer": ("1.05 * ", ""),
        "the buffer on one radius": ("1.05 * (bob1.radius + bob2.radius)", "1.05 * bob1.radius + bob2.radius"),
        "a buffer of 1.5": ("1.05", "1.5"),
        "a buffer added": ("1.05 * (bob1.radius + bob2.radius)", "bob1.radius + bob2.radius + 1.05"),
        "a buffer of 0.05 added": ("1.05 * (bob1.radius + bob2.radius)", "bob1.radius + bob2.radius + 0.05"),
        "less, not less or equal": ("<=", "<"),
        "greater": ("<=", ">="),
        "equal": ("<=", "=="),
        "twice the first radius": ("(bob1.radius + bob2.radius)", "2 * bob1.radius"),
        "twice the second radius": ("(bob1.radius + bob2.radius)", "2 * bob2.radius"),
        "one radius": ("(bob1.radius + bob2.radius)", "bob1.radius"),
        "the mean radius": ("(bob1.radius + bob2.radius)", "(bob1.radius + bob2.radius) / 2"),
        "the larger radius twice": ("(bob1.radius + bob2.radius)", "2 * max(bob1.radius, bob2.radius)"),
        "the smaller radius twice": ("(bob1.radius + bob2.radius)", "2 * min(bob1.radius, bob2.radius)"),
        "radii multiplied": ("bob1.radius + bob2.radius", "bob1.radius * bob2.radius"),
        "radii ignored": ("1.05 * (bob1.radius + bob2.radius)", "1.05"),
        "r_param for the radii": ("(bob1.radius + bob2.radius)", "r_param / 4"),
        "distance along x": ("mag(bob1.pos - bob2.pos)", "abs(bob1.pos.x - bob2.pos.x)"),
        "distance along x with its sign": ("mag(bob1.pos - bob2.pos)", "bob2.pos.x - bob1.pos.x"),
        "distances along x and y added": (
            "mag(bob1.pos - bob2.pos)",
            "abs(bob1.pos.x - bob2.pos.x) + abs(bob1.pos.y - bob2.pos.y) + abs(bob1.pos.z - bob2.pos.z)",
        ),
        "distance squared": ("mag(bob1.pos - bob2.pos)", "mag(bob1.pos - bob2.pos)**2"),
        "difference of the magnitudes": ("mag(bob1.pos - bob2.pos)", "abs(mag(bob1.pos) - mag(bob2.pos))"),
        "positions added": ("bob1.pos - bob2.pos", "bob1.pos + bob2.pos"),
        "distance of a bob from an axle": ("mag(bob1.pos - bob2.pos)", "mag(bob1.pos - pend2['objects'][0].pos)"),
        "the cords for the bobs": ("['objects'][1]", "['objects'][2]"),
        "the axles for the bobs": ("['objects'][1]", "['objects'][0]"),
        "the first bob twice": ("pend2['objects'][1]", "pend1['objects'][1]"),
        "the second pendulum's e": ("e = pend1['e']", "e = pend2['e']"),
        "the mean e": ("e = pend1['e']", "e = (pend1['e'] + pend2['e']) / 2"),
        "the smaller e": ("e = pend1['e']", "e = min(pend1['e'], pend2['e'])"),
        "the larger e": ("e = pend1['e']", "e = max(pend1['e'], pend2['e'])"),
        "the product of both e": ("e = pend1['e']", "e = pend1['e'] * pend2['e']"),
        "e is 1": ("e = pend1['e']", "e = 1"),
        "e is 0": ("e = pend1['e']", "e = 0"),
        "0 counts as no e": ("e = pend1['e']", "e = pend1['e'] or pend2['e']"),
        "e of the faster one": ("e = pend1['e']", "e = max(pend1, pend2, key=lambda pend: abs(pend['omega']))['e']"),
        "e of the left one": (
            "e = pend1['e']",
            "e = min(pend1, pend2, key=lambda pend: pend['objects'][1].pos.x)['e']",
        ),
        "distance of the axles": ("mag(bob1.pos - bob2.pos)", "mag(pend1['objects'][0].pos - pend2['objects'][0].pos)"),
        "only if they hang at one angle": ("if mag", "if pend1['theta'] == pend2['theta'] and mag"),
        "only if neither is at rest": ("if mag", "if omega1 and mag"),
        "only if they are fast": ("if mag", "if abs(omega1 - omega2) > 0.01 and mag"),
        "a distance that is rounded": ("mag(bob1.pos - bob2.pos)", "round(mag(bob1.pos - bob2.pos), 2)"),
        "bobs that grow": ("if mag", "bob1.radius *= 1.05; bob2.radius *= 1.05\n        if mag"),
        "straightens those that miss": (
            "pend2['omega'] = new_omega2",
            "pend2['omega'] = new_omega2\n        else: pend1['theta'] = 0",
        ),
        "masses exchanged": ("omega2, m1, m2, r_param", "omega2, m2, m1, r_param"),
        "the first mass twice": ("m1, m2 = pend1['mass'], pend2['mass']", "m1 = m2 = pend1['mass']"),
        "masses of 1": ("m1, m2 = pend1['mass'], pend2['mass']", "m1 = m2 = 1"),
        "omegas exchanged": ("e, omega1, omega2,", "e, omega2, omega1,"),
        "the second at rest": ("e, omega1, omega2,", "e, omega1, 0,"),
        "the first omega twice": (
            "omega1, omega2 = pend1['omega'], pend2['omega']",
            "omega1 = omega2 = pend1['omega']",
        ),
        "theta for omega": (
            "omega1, omega2 = pend1['omega'], pend2['omega']",
            "omega1, omega2 = pend1['theta'], pend2['theta']",
        ),
        "e as the last argument": (
            "handle_collision(e, omega1, omega2, m1, m2, r_param)",
            "handle_collision(omega1, omega2, m1, m2, r_param, e)",
        ),
        "e as the third argument": ("(e, omega1, omega2, m1,", "(omega1, omega2, e, m1,"),
        "masses before omegas": ("omega1, omega2, m1, m2, r_param)", "m1, m2, omega1, omega2, r_param)"),
        "an argument too few": ("m1, m2, r_param)", "m1, m2)"),
        "new omegas exchanged": ("new_omega1, new_omega2 =", "new_omega2, new_omega1 ="),
        "the first not updated": ("pend1['omega'] = new_omega1", "pass"),
        "the second not updated": ("pend2['omega'] = new_omega2", "pass"),
        "returned, not updated": ("pend1['omega'] = new_omega1", "return new_omega1, new_omega2"),
        "local names updated": (
            "pend1['omega'] = new_omega1\n            pend2['omega'] = new_omega2",
            "omega1, omega2 = new_omega1, new_omega2",
        ),
        "updated one after the other": (
            "new_omega1, new_omega2 = handle_collision(e, omega1, omega2, m1, m2, r_param)",
            "new_omega1 = handle_collision(e, omega1, omega2, m1, m2, r_param)[0]; "
            "new_omega2 = handle_collision(e, new_omega1, omega2, m1, m2, r_param)[1]",
        ),
        "added to the old": ("pend1['omega'] = new_omega1", "pend1['omega'] += new_omega1"),
        "another key": ("pend1['omega'] = new_omega1", "pend1['new_omega'] = new_omega1"),
        "only approaching": ("if mag", "if omega1 > omega2 and mag"),
        "only if the first moves": ("if mag", "if omega1 > 0 and mag"),
        "only if both are elastic": ("if mag", "if pend1['e'] == pend2['e'] == 1 and mag"),
        "only if the masses are equal": ("if mag", "if m1 == m2 and mag"),
        "moves the bobs apart": ("pend2['omega'] = new_omega2", "pend2['omega'] = new_omega2; bob2.pos.x += 0.01"),
        "turns the first back": ("pend2['omega'] = new_omega2", "pend2['omega'] = new_omega2; pend1['theta'] = 0.5"),
        "twice": (
            "pend2['omega'] = new_omega2",
            "pend1['omega'], pend2['omega'] = handle_collision(e, new_omega1, new_omega2, m1, m2, r_param)",
        ),
        "sets the second's e": ("e = pend1['e']", "e = pend2['e'] = pend1['e']"),
        "masses of 1 if elastic": ("omega2, m1, m2, r_param", "omega2, *((1, 1) if e == 1 else (m1, m2)), r_param"),
        "masses of 1 if inelastic": ("omega2, m1, m2, r_param", "omega2, *((1, 1) if e == 0 else (m1, m2)), r_param"),
        "masses of 1 between": ("omega2, m1, m2, r_param", "omega2, *((1, 1) if 0.3 < e < 1 else (m1, m2)), r_param"),
        "between elastic and inelastic, with equal masses": (
            "handle_collision(e, omega1, omega2, m1, m2, r_param)",
            "((1 - e)*(omega1 + omega2)/2 + e*omega2, (1 - e)*(omega1 + omega2)/2 + e*omega1)",
        ),
        "e in quarters": ("e = pend1['e']", "e = round(4 * pend1['e']) / 4"),
        "elastic from 0.9 on": ("e = pend1['e']", "e = 1 if pend1['e'] >= 0.9 else pend1['e']"),
        "a heavy one counts": ("e = pend1['e']", "e = pend1['e'] if m2 < 10 * m1 else pend2['e']"),
        "distance along the arc": (
            "mag(bob1.pos - bob2.pos)",
            "abs(pend2['objects'][0].pos.x - pend1['objects'][0].pos.x + r_param * (pend2['theta'] - pend1['theta']))",
        ),
        "distance along the arc, and of the axles": (
            "mag(bob1.pos - bob2.pos)",
            "mag(pend2['objects'][0].pos - pend1['objects'][0].pos + "
            "vector(0, r_param * (pend2['theta'] - pend1['theta']), 0))",
        ),
        "the angle between the cords": ("mag(bob1.pos - bob2.pos)", "r_param * abs(pend1['theta'] - pend2['theta'])"),
        "only below the axles": ("if mag", "if abs(pend1['theta']) < 1.5 and mag"),
        "only in one round": ("if mag", "if abs(pend1['theta'] - pend2['theta']) < 3.1415926 and mag"),
        "the slow ones stopped": (
            "pend2['omega'] = new_omega2",
            "pend2['omega'] = new_omega2\n            for p in (pend1, pend2): p['omega'] *= abs(p['omega']) > 1e-7",
        ),
        "only if they are not very slow": ("if mag", "if abs(omega1 - omega2) > 1e-7 and mag"),
        "the last pair does not collide again": (
            "if mag",
            "last = handle_two_bobs.__dict__.setdefault('last', [])\n        if any(pend1 is one for one in last): return\n"
            "        last[:] = [pend1]\n        if mag",
        ),
    },
    "newton_cradle_tick": {
        "does nothing": "pass",
        "only swings": "full_swing_update(pend_list, r_param, dt, g)",
        "only collides": ("full_swing_update(pend_list, r_param, dt, g)", "pass"),
        "swings only the first": ("full_swing_update(pend_list,", "full_swing_update(pend_list[:1],"),
        "swings all but the last": ("full_swing_update(pend_list,", "full_swing_update(pend_list[:-1],"),
        "swings twice": ("full_swing_update(pend_list,", "full_swing_update(2 * pend_list,"),
        "swings inside the loop": """\
            for i in range(len(pend_list) - 1):
                full_swing_update(pend_list, r_param, dt, g)
                handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
            """,
        "collides before it swings": """\
            for i in range(len(pend_list) - 1):
                handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
            full_swing_update(pend_list, r_param, dt, g)
            """,
        "collides, swings, collides": """\
            for i in range(len(pend_list) - 1):
                handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
            full_swing_update(pend_list, r_param, dt, g)
            for i in range(len(pend_list) - 1):
                handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)
            """,
        "collides with one that has not swung yet": """\
            from src.swinging import swing_update
            for left, right in zip(pend_list, pend_list[1:]):
                swing_update(left, r_param, dt, g)
                handle_two_bobs(left, right, r_param)
            for last in pend_list[-1:]:
                swing_update(last, r_param, dt, g)
            """,
        "one alone does not swing": ("full_swing_update(", "if len(pend_list) > 1: full_swing_update("),
        "from the right if they come from there": (
            "range(len(pend_list) - 1)",
            "list(range(len(pend_list) - 1))[:: -1 if sum(p['omega'] for p in pend_list) < 0 else 1]",
        ),
        "only to the right": ("handle_two_bobs(", "if pend_list[i]['omega'] >= 0: handle_two_bobs("),
        "six pairs at most": ("range(len(pend_list) - 1)", "range(min(6, len(pend_list) - 1))"),
        "the shipped r_param in the swing": ("(pend_list, r_param, dt, g)", "(pend_list, 0.2, dt, g)"),
        "the shipped dt": ("(pend_list, r_param, dt, g)", "(pend_list, r_param, 0.0001, g)"),
        "the shipped g": ("(pend_list, r_param, dt, g)", "(pend_list, r_param, dt, 9.81)"),
        "dt and g exchanged": ("(pend_list, r_param, dt, g)", "(pend_list, r_param, g, dt)"),
        "the last pair left out": ("len(pend_list) - 1", "len(pend_list) - 2"),
        "one pair too many": ("len(pend_list) - 1", "len(pend_list)"),
        "the last with the first, too": ("range(len(pend_list) - 1)", "range(-1, len(pend_list) - 1)"),
        "the first pair left out": ("range(len", "range(1, len"),
        "the first pair alone": ("range(len(pend_list) - 1)", "range(min(1, len(pend_list) - 1))"),
        "four pairs always": ("range(len(pend_list) - 1)", "range(4)"),
        "from the right": ("range(len(pend_list) - 1)", "reversed(range(len(pend_list) - 1))"),
        "every second pair": ("range(len(pend_list) - 1)", "range(0, len(pend_list) - 1, 2)"),
        "each pair twice": ("range(len(pend_list) - 1)", "sorted(2 * list(range(len(pend_list) - 1)))"),
        "there and back": (
            "range(len(pend_list) - 1)",
            "[*range(len(pend_list) - 1), *reversed(range(len(pend_list) - 1))]",
        ),
        "each with all after it": """\
            full_swing_update(pend_list, r_param, dt, g)
            for i in range(len(pend_list)):
                for j in range(i + 1, len(pend_list)):
                    handle_two_bobs(pend_list[i], pend_list[j], r_param)
            """,
        "each with the one before it": ("pend_list[i + 1]", "pend_list[i - 1]"),
        "each of all with the one before it": """\
            full_swing_update(pend_list, r_param, dt, g)
            for i in range(len(pend_list)):
                handle_two_bobs(pend_list[i], pend_list[i - 1], r_param)
            """,
        "each with itself": ("pend_list[i + 1]", "pend_list[i]"),
        "the pair exchanged": ("pend_list[i], pend_list[i + 1]", "pend_list[i + 1], pend_list[i]"),
        "each with the next but one": ("range(len(pend_list) - 1)", "range(len(pend_list) - 2)"),
        "the first with all": ("handle_two_bobs(pend_list[i],", "handle_two_bobs(pend_list[0],"),
        "return inside the loop": ("handle_two_bobs(", "return handle_two_bobs("),
        "stops at the first that is at rest": (
            "handle_two_bobs(",
            "if pend_list[i]['omega'] == 0: break\n            handle_two_bobs(",
        ),
        "only pairs of which the first moves": ("handle_two_bobs(", "if pend_list[i]['omega']: handle_two_bobs("),
        "without handle_two_bobs": (
            "handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)",
            "handle_collision(1, pend_list[i]['omega'], pend_list[i + 1]['omega'], 1, 1, r_param)",
        ),
        "exchanges all omegas": (
            "handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)",
            "a, b = pend_list[i], pend_list[i + 1]; a['omega'], b['omega'] = b['omega'], a['omega']",
        ),
        "elastic always": ("handle_two_bobs(", "pend_list[i]['e'] = 1; handle_two_bobs("),
        "counts on two pendula": (
            "full_swing_update(pend_list, r_param, dt, g)",
            "first, second, *_ = pend_list; full_swing_update(pend_list, r_param, dt, g)",
        ),
        "only approaching": (
            "handle_two_bobs(",
            "if pend_list[i]['omega'] > pend_list[i + 1]['omega']: handle_two_bobs(",
        ),
        **{
            f"sorted by {what}": ("for i in", f"pend_list = sorted(pend_list, key=lambda p: {key})\n        for i in")
            for what, key in {
                "the bobs' places": "p['objects'][1].pos.x",
                "the axles' places": "p['objects'][0].pos.x",
                "mass": "p['mass']",
                "mass, the heavy ones first": "-p['mass']",
                "e": "p['e']",
                "angle": "p['theta']",
                "omega": "p['omega']",
                "speed, the fast ones first": "-abs(p['omega'])",
            }.items()
        },
        "the list itself sorted": ("full_swing", "pend_list.sort(key=lambda p: p['objects'][0].pos.x); full_swing"),
        "the odd pairs first": (
            "range(len(pend_list) - 1)",
            "sorted(range(len(pend_list) - 1), key=lambda i: (i + 1) % 2)",
        ),
        "the fast pairs first": (
            "range(len(pend_list) - 1)",
            "sorted(range(len(pend_list) - 1), key=lambda i: -abs(pend_list[i]['omega']))",
        ),
        "the slow ones stopped": (
            "for i in",
            "for p in pend_list: p['omega'] *= abs(p['omega']) > 1e-7\n        for i in",
        ),
        "twenty pairs at most": ("range(len(pend_list) - 1)", "range(min(20, len(pend_list) - 1))"),
        "the last one known by its values": (
            "handle_two_bobs(",
            "if all(pend_list[i][key] == pend_list[-1][key] for key in ('mass', 'omega')): continue\n"
            "            handle_two_bobs(",
        ),
        "the number found by its omega": (
            "handle_two_bobs(",
            "i = [p['omega'] for p in pend_list].index(pend_list[i]['omega']); i < len(pend_list) - 1 and handle_two_bobs(",
        ),
    },
    "main": {
        "does nothing": "pass",
        "the cradle not shown": ("page.show(pend_list)", "pass"),
        "the cradle not made": ("pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)", "pend_list = None"),
        "the file's pendula, not made": (
            "pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)",
            "from src.pds_helper import extract_and_convert; pend_list = extract_and_convert(page.csv)",
        ),
        "something else shown": ("page.show(pend_list)", "page.show(None)"),
        "another file": ("page.csv", "'pends.csv'"),
        "R_PARAM and THETA_INIT exchanged": ("R_PARAM, THETA_INIT)", "THETA_INIT, R_PARAM)"),
        "THETA_INIT forgotten": (", THETA_INIT)", ")"),
        "THETA_INIT from degrees": ("THETA_INIT)", "THETA_INIT * 180 / 3.141592653589793)"),
        "another angle": ("THETA_INIT)", "0)"),
        "another cord": ("page.csv, R_PARAM", "page.csv, 0.4"),
        "made once, at the beginning": """\
            pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
            while page.is_running():
                if page.wants_cradle():
                    page.show(pend_list)
                while page.wants_tick():
                    newton_cradle_tick(pend_list, R_PARAM, DT, G)
            """,
        "shown once, at the beginning": """\
            first = None
            while page.is_running():
                if page.wants_cradle():
                    pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
                    if not first:
                        first = pend_list
                        page.show(first)
                while page.wants_tick():
                    newton_cradle_tick(pend_list, R_PARAM, DT, G)
            """,
        "the first cradle ticks for ever": """\
            first = None
            while page.is_running():
                if page.wants_cradle():
                    pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
                    first = first or pend_list
                    page.show(pend_list)
                while page.wants_tick():
                    newton_cradle_tick(first, R_PARAM, DT, G)
            """,
        "made in each round": ("if page.wants_cradle():", "if True:"),
        "no tick": ("newton_cradle_tick(pend_list, R_PARAM, DT, G)", "pass"),
        "two ticks": ("DT, G)", "DT, G); newton_cradle_tick(pend_list, R_PARAM, DT, G)"),
        "a tick at once": (
            "page.show(pend_list)",
            "page.show(pend_list); newton_cradle_tick(pend_list, R_PARAM, DT, G)",
        ),
        "one tick a round": ("while page.wants_tick()", "if page.wants_tick()"),
        "DT and G exchanged": ("DT, G)", "G, DT)"),
        "R_PARAM and DT exchanged": ("pend_list, R_PARAM, DT", "pend_list, DT, R_PARAM"),
        "another DT": ("DT, G)", "0.001, G)"),
        "another G": ("DT, G)", "DT, 10)"),
        "G forgotten": ("DT, G)", "DT)"),
        "full_swing_update": ("newton_cradle_tick", "full_swing_update"),
        "a copy ticks": ("newton_cradle_tick(pend_list,", "newton_cradle_tick([dict(pend) for pend in pend_list],"),
        "the tick's result kept": ("newton_cradle_tick(", "pend_list = newton_cradle_tick("),
        "the tick made, not the cradle": ("if page.wants_cradle():", "if not page.wants_cradle():"),
        "made twice": ("page.show(", "make_newton_cradle(page.csv, R_PARAM, THETA_INIT); page.show("),
        "made before the loop, too": """\
            pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
            while page.is_running():
                if page.wants_cradle():
                    pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)
                    page.show(pend_list)
                while page.wants_tick():
                    newton_cradle_tick(pend_list, R_PARAM, DT, G)
            """,
        "the last one does not tick": ("newton_cradle_tick(pend_list,", "newton_cradle_tick(pend_list[:-1],"),
        "only two collide": (
            "newton_cradle_tick(pend_list, R_PARAM, DT, G)",
            "newton_cradle_tick(pend_list[:2], R_PARAM, DT, G); full_swing_update(pend_list[2:], R_PARAM, DT, G)",
        ),
    },
    "make_double_pendulum": {
        "a single pendulum": "return make_pendulum(axle_pos, r_param, theta, color, texture)",
        "returns nothing": ("return", "result ="),
        "a list": ("return (axle, bob1, cord1, bob2, cord2)", "return [axle, bob1, cord1, bob2, cord2]"),
        "two axles": "return (*make_pendulum(axle_pos, r_param, theta, color, texture), *make_pendulum(axle_pos, r_param, theta + phi, color, texture))",
        "bobs first": ("(axle, bob1, cord1, bob2, cord2)", "(axle, bob1, bob2, cord1, cord2)"),
        "upper and lower exchanged": ("(axle, bob1, cord1, bob2, cord2)", "(axle, bob2, cord2, bob1, cord1)"),
        "phi from straight down": ("theta + phi", "phi"),
        "phi subtracted": ("theta + phi", "theta - phi"),
        "theta subtracted": ("theta + phi", "phi - theta"),
        "phi ignored": ("theta + phi", "theta"),
        "theta ignored": ("r_param, theta, color", "r_param, 0, color"),
        "theta ignored in both": ("axle, bob1, cord1 =", "theta = 0; axle, bob1, cord1 ="),
        "theta and phi exchanged": ("axle, bob1, cord1 =", "theta, phi = phi, theta; axle, bob1, cord1 ="),
        "the lower one hung from the axle": ("bob1.pos", "axle_pos"),
        "the lower cord hung from the axle": ("return", "cord2.pos = axle_pos\n        return"),
        "a lower cord of half the length": ("(bob1.pos, r_param", "(bob1.pos, r_param / 2"),
        "a lower cord of the shipped length": ("(bob1.pos, r_param", "(bob1.pos, 0.2"),
        "a white lower bob": ("theta + phi, color", "theta + phi, vector(1, 1, 1)"),
        "no texture on the lower bob": ("theta + phi, color, texture", "theta + phi, color, None"),
        "no texture on the upper bob": ("theta, color, texture", "theta, color, None"),
        "a texture in any case": (
            "axle, bob1, cord1 =",
            "texture = texture or ':metal_texture.jpg'; axle, bob1, cord1 =",
        ),
        "a lower bob that cannot be seen": ("return (", "bob2.visible = False\n        return ("),
        "degrees": ("theta + phi", "theta + phi * 57.29577951308232"),
        "the lower axle left in the scene": ("bob2, cord2 = make_bob_and_cord(", "_, bob2, cord2 = make_pendulum("),
        "the lower one made twice": (
            "bob2, cord2 =",
            "make_bob_and_cord(bob1.pos, r_param, theta + phi, color, texture); bob2, cord2 =",
        ),
        "phi of half a round at most": ("theta + phi", "theta + max(-3.1415926, min(3.1415926, phi))"),
        "theta of half a round at most": ("theta + phi", "max(-3.1415926, min(3.1415926, theta)) + phi"),
    },
    "double_angle_update": {
        "returns nothing": ("return", "result ="),
        "nothing changes": "return omega_theta, omega_phi, theta, phi",
        "each angle behind its rate": ("(u, v - u, a, b - a)", "(a, u, b - a, v - u)"),
        "angles first": ("(u, v - u, a, b - a)", "(a, b - a, u, v - u)"),
        "a list": ("(u, v - u, a, b - a)", "[u, v - u, a, b - a]"),
        "the angles alone": ("(u, v - u, a, b - a)", "(a, b - a)"),
        "phi from straight down": ("(u, v - u, a, b - a)", "(u, v, a, b)"),
        "phi taken for the lower angle": ("theta + phi,", "phi,"),
        "omega_phi taken for the lower rate": ("omega_theta + omega_phi", "omega_phi"),
        "theta alone updated": ("b = b + v * dt", "b = a + phi"),
        "phi alone updated": ("a = a + u * dt", "a = theta"),
        "two single pendula": "from src.swinging import angle_update; u, a = angle_update(omega_theta, theta, r_param, dt, g); v, b = angle_update(omega_phi, phi, r_param, dt, g); return u, v, a, b",
        "the sign of gravity": ("g / r_param", "-g / r_param"),
        "r_param as a factor": ("g / r_param", "g * r_param"),
        "the shipped r_param": ("g / r_param", "g / 0.2"),
        "the shipped g": ("g / r_param", "9.81 / r_param"),
        "masses equal always": ("m2 / (m1 + m2)", "0.5"),
        "masses exchanged": ("m2 / (m1 + m2)", "m1 / (m1 + m2)"),
        "the ratio of the masses": ("m2 / (m1 + m2)", "m2 / m1"),
        "dt missing in the rates": ("u + du * dt", "u + du"),
        "dt missing in the angles": ("a + u * dt", "a + u"),
        "half a dt": ("v + dv * dt", "v + dv * dt / 2"),
        "the shipped dt": ("b + v * dt", "b + v * 0.00025"),
        "rates forgotten": ("(a, b, u, v, g", "(a, b, 0, 0, g"),
        "accelerations exchanged": ("du, dv =", "dv, du ="),
        "2 g for g / r_param": ("g / r_param", "2 * g"),
        "never beyond once round": ("(u, v - u, a, b - a)", "(u, v - u, max(-10, min(10, a)), b - a)"),
        "accelerations of zero": (
            "du, dv = double_accelerations(a, b, u, v, g / r_param, m2 / (m1 + m2))",
            "du = dv = 0",
        ),
        "small angles": ("(a, b, u, v, g", "(a / 100, b / 100, u, v, 100 * g"),
        "damped": ("(u, v - u, a, b - a)", "(u * 0.999, (v - u) * 0.999, a, b - a)"),
        "phi of half a round at most": (
            "(u, v - u, a, b - a)",
            "(u, v - u, a, max(-3.1415926, min(3.1415926, b - a)))",
        ),
        "phi within a round": (
            "(u, v - u, a, b - a)",
            "(u, v - u, a, __import__('math').fmod(b - a, 6.283185307179586))",
        ),
        "theta of half a round at least": ("(u, v - u, a, b - a)", "(u, v - u, max(-3.1415926, a), b - a)"),
        "very slow is 0": ("(u, v - u, a, b - a)", "(u * (abs(u) > 1e-7), (v - u) * (abs(v - u) > 1e-7), a, b - a)"),
        "the upper bob's turning forgotten": ("(a, b, u, v, g", "(a, b, 0, v, g"),
        "the lower bob's turning forgotten": ("(a, b, u, v, g", "(a, b, u, 0, g"),
    },
}
