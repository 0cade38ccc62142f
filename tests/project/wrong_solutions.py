"""Wrong solutions with the mistakes of beginners. The graded suites must reject them all, and name the mistake.

A version of a function is the body, or a pair (old text, new text) that puts a mistake into the right body in PLAIN. It
can use all names of the function's file, and `from ... import ...`. Add a row, and
tests/project/test_graded_suites.py covers it. right_solutions.py has the correct versions.
"""

PLAIN = {
    "extract_and_convert": """\
        bad_rep = pd.read_csv(relative_filepath).to_dict(orient='index')
        pend_list = []
        for pend in bad_rep.values():
            pend_list.append(pend)
        return pend_list
        """,
    "uniform_mass_newton_cradle": """\
        pend_list = extract_and_convert(relative_filepath)
        for pend in pend_list:
            pend['mass'] = mass
        return pend_list
        """,
    "uniform_e_newton_cradle": """\
        pend_list = extract_and_convert(relative_filepath)
        for pend in pend_list:
            pend['e'] = e_val
        return pend_list
        """,
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
        w1, w2 = v1_new / r_param, v2_new / r_param
        return (w1, w2)
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

# A row is a line:
# fmt: off
# The first words of each hint, by function, and a mistake that gets it.
HINTED = {
    "extract_and_convert": {
        "In quotes, the name of the loop": ("append(pend)", "append(bad_rep['pend'])"),
        "In each turn of the inner loop, pend_dict": ("pend_list.append(pend)", "for key in pend:\n                pend_dict = {}\n                pend_dict[key] = pend[key]\n            pend_list.append(pend_dict)"),
        "Each element must be a whole pendulum:": ("append(pend)", "append(str(pend))"),
        "All values of bad_rep are one element": ("for pend in bad_rep.values():\n            pend_list.append(pend)", "pend_list.append(bad_rep.values())"),
        "In a loop, = replaces the whole": ("pend_list.append(pend)", "pend_list = [pend]"),
        "The while loop never changes i,": ("pend_list = []", "i = 5\n        while i < 5: break\n        pend_list = [1]"),
        "Your list has the keys of bad_rep, too.": ("append(pend)", "extend([len(pend_list) // 2, pend])"),
        "Your function has no return.": ("return pend_list", "pass"),
        "Your return is alone: write": ("return pend_list", "return"),
        "append returns None. Append first,": ("return pend_list", "return pend_list.append(pend)"),
        "Your return is inside an if or": ("return pend_list", "if pend_list == pend:\n            return pend_list"),
        "A name alone does nothing: ": ("return pend_list", "pend_list"),
        "Does your function reach a return with a value? (append returns None.)": ("return pend_list", "return pend_list.reverse()"),
        "You returned bad_rep. You need a list, without the keys 0, 1, 2.": ("return pend_list", "return bad_rep"),
        "You returned the dataframe df.": ("return pend_list", "return pd.read_csv(relative_filepath)"),
        "These are the values of bad_rep, but not yet a list.": ("return pend_list", "return bad_rep.values()"),
        "Your list is empty. Do you append to the list that you return?": ("pend_list.append(pend)", "pass"),
        "You returned a tuple. You need a list.": ("return pend_list", "return tuple(pend_list)"),
        "Your list has the keys of bad_rep. The pendula are its values.": ("bad_rep.values()", "bad_rep"),
        "Your list has the keys and the values of bad_rep. You need only the": ("bad_rep.values()", "bad_rep.items()"),
        "You put bad_rep into a list. You need only its values.": ("return pend_list", "return [bad_rep]"),
        "You kept the keys of bad_rep. You need only its values.": ("append(pend)", "append({len(pend_list): pend})"),
        "You kept only the values of each pendulum, without keys.": ("append(pend)", "append(list(pend.values()))"),
        "You kept only the keys of each pendulum, without values.": ("append(pend)", "append(list(pend))"),
        "Equal rows are different pendula.": ("filepath)", "filepath).drop_duplicates()"),
        "You added the keys of each pendulum. Use append,": ("pend_list.append(pend)", "pend_list += pend"),
        "A number here is text.": ("append(pend)", "append({key: str(value) for key, value in pend.items()})"),
        "print only shows a value. Give it": ("return pend_list", "print(pend_list)"),
        "A list has no place for a new element.": ("pend_list.append(pend)", "pend_list[len(pend_list)] = pend"),
        "append changes the list and returns": ("pend_list.append(pend)", "pend_list = pend_list.append(pend)"),
        "The keys must be those of the": ("append(pend)", "append({**pend, 'name': 0})"),
        "You named a function, but did not call it.": ("return pend_list", "return len"),
        "Write relative_filepath without quotes:": ("(relative_filepath)", "('relative_filepath')"),
        "You put the right list into another list.": ("return pend_list", "return [pend_list]"),
        "Your list has only the first pendulum. Is your return": ("return pend_list", "return pend_list[:1]"),
        "Your return is inside the loop: it ends": ("    return pend_list", "        return pend_list"),
        "In the handout, a CSV may be about assistants, too.": ("append(pend)", "append({key: pend[key] for key in ('mass', 'e', 'theta', 'omega', 'color', 'texture')})"),
        "You returned the old rows. Read the file in each call.": ("pd.read_csv(relative_filepath)", "globals().setdefault(relative_filepath, pd.read_csv(relative_filepath))"),
        "Your list has only the last pendulum. Do you make": ("pend_list.append", "pend_list = []; pend_list.append"),
        "Your list has the last pendulum three times.": ("append(pend)", "append(bad_rep[len(bad_rep) - 1])"),
        "The first pendulum is missing.": ("return pend_list", "return pend_list[1:]"),
        "The last pendulum is missing.": ("return pend_list", "return pend_list[:-1]"),
        "Your pendula are in reverse order.": ("return pend_list", "return pend_list[::-1]"),
        "Do you read the file at relative_filepath?": ("relative_filepath", "NC_FP"),
        "Your list has each pendulum six times: once for each key.": ("append(pend)", "extend([pend] * len(pend))"),
        "Your second call has changed the list": ("= []", "= globals().setdefault('_list', []); pend_list.clear()"),
    },
    "uniform_mass_newton_cradle": {
        "This line calls nothing: map only": ("for pend in pend_list:\n            pend['mass'] = mass", "map(lambda pend: pend.update(mass=mass), pend_list)"),
        "The sides of = are exchanged.": ("pend['mass'] = mass", "mass = pend['mass']"),
        "A new dictionary has only the keys": ("return pend_list", "return [{'mass': mass} for pend in pend_list]"),
        "You changed too much: theta must": ("pend['mass'] = mass", "pend['mass'] = mass; pend['theta'] = 0"),
        "In the loop, ": ("pend['mass'] = mass", "pend = {'mass': mass}"),
        "In each pendulum, mass must be": ("= mass", "= mass / len(pend_list)"),
        "The parameter loses the value": ("pend['mass'] = mass", "mass = len(pend)\n            pend['mass'] = mass"),
        "mass has not changed: these are from": ("pend['mass'] = mass", "pend.setdefault('mass', mass)"),
        "== only compares. One = stores": ("pend['mass'] = ", "pend['mass'] == "),
        "You changed mass only in the first pendulum.": ("in pend_list", "in pend_list[:1]"),
        "You changed mass only in the last pendulum.": ("in pend_list", "in pend_list[-1:]"),
        "You returned only the last pendulum. You need the whole pend_list.": ("return pend_list", "return pend"),
        "You stored mass as text. You need a number.": ("= mass", "= str(mass)"),
        "You returned only the first pendulum. You need the whole": ("return pend_list", "return pend_list[0]"),
        "You changed e, not mass.": ("['mass']", "['e']"),
        "In quotes, mass is only a word.": ("= mass", "= 'mass'"),
        "With = , the name pend gets another": ("pend['mass'] = mass", "pend = mass"),
        "This line computes with 'mass', but stores": ("pend['mass'] = mass", "pend['mass'] + mass"),
        "You multiplied the old mass. Replace it.": ("= mass", "*= mass"),
        "You rounded mass. Store it as": ("= mass", "= int(mass)"),
        "Your list is empty. Give the whole": ("return pend_list", "return []"),
        "A comma at the end of a line": ("= mass", "= mass,"),
        "Take one pendulum first: pend_list is a list": ("pend['mass']", "pend_list['mass']"),
    },
    "uniform_e_newton_cradle": {
        "e has not changed: these are from": ("pend['e'] = e_val", "pend.setdefault('e', e_val)"),
        "You changed e only in the first pendulum.": ("in pend_list", "in pend_list[:1]"),
        "You changed e only in the last pendulum.": ("in pend_list", "in pend_list[-1:]"),
        "You changed mass, not e.": ("['e']", "['mass']"),
        "You stored e as text. You need a number.": ("= e_val", "= str(e_val)"),
        "0 is a value, too. Do not": ("= e_val", "= e_val or 1"),
        "You multiplied the old e.": ("= e_val", "*= e_val"),
        "You rounded e.": ("= e_val", "= int(e_val)"),
        "A key is text. Write it in quotes: ['e'].": ("['e']", "[e]"),
    },
    "elastic_newton_cradle": {
        "None is no number.": (", 1)", ", None)"),
        "Here, e is 0. That is perfectly inelastic.": ("1)", "0)"),
        "uniform_e_newton_cradle takes relative_filepath first, then": ("relative_filepath, 1", "1, relative_filepath"),
        "You changed mass, not e.": ("uniform_e", "uniform_mass"),
        "The call of uniform_e_newton_cradle stands alone:": "uniform_e_newton_cradle(relative_filepath, 1)\nreturn extract_and_convert(relative_filepath)",
        "e must be exactly 1.": (", 1)", ", 0.99)"),
    },
    "inelastic_newton_cradle": {
        "Perfectly inelastic is the": (", 0)", ", None)"),
        "Here, e is 1. That is perfectly elastic.": ("0)", "1)"),
        "e must be exactly 0.": (", 0)", ", 1e-3)"),
        "The path of a file belongs here:": ("(relative_filepath", "(extract_and_convert(relative_filepath)"),
    },
    "make_newton_cradle": {
        "The word in the file must stay: color": ("return", "for pend in pend_list: pend['color'] = COLOR_MAP[pend['color']]\n        return"),
        "Each element must be a whole pendulum:": ("return pend_list", "return [*pend_list, axle_pos]"),
        "In this loop, ": ("for i in range(len(pend_list)):\n            pend = pend_list[i]\n            if i == 0", "for i, pend in enumerate(pend_list):\n            pass\n        for pend in pend_list:\n            if pend == 0"),
        "Store one number here,": ("pend['omega'] = 0", "pend['omega'] = [0]"),
        "Each turn of the loop does the same: ": ("return pend_list", "for p in pend_list:\n            pend_list[-1]['theta'] += 1\n        return pend_list"),
        "You returned one pendulum. You need the whole pend_list.": ("return pend_list", "return pend"),
        "Only the first theta is new. The others are from the file.": ("pend['theta'] = 0", "pass"),
        "These are the rows of an earlier call. Read the file in each call.": ("= extract_and_convert(relative_filepath)", "= globals().setdefault('_list', extract_and_convert(relative_filepath))"),
        "You used the constant TH": ("= theta_init", "= __import__('support.constants').constants.THETA_INIT"),
        "theta_init is in radians already. Do not": ("= theta_init", "= __import__('math').radians(theta_init)"),
        "All pendula have the same objects. Make them": ("pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)", "pend['objects'] = pend_list[0].get('objects') or make_pendulum(axle_pos, r_param, theta_init, color, texture)"),
        "Keep the order axle, bob, cord.": ("texture)\n        return", "texture)[::-1]\n        return"),
        "Keep all keys of each pendulum, and": ("pend['objects']", "pend['object']"),
        "You used the constant R": ("vector((-0.1 + r_param/4 * i), r_param/5", "vector((-0.1 + 0.05 * i), 0.04"),
        "These are the angles from the file.": ("pend['theta'] = ", "pend['angle'] = "),
        "Your bobs hang at": ("r_param, pend['theta']", "r_param, extract_and_convert(relative_filepath)[i]['theta']"),
        "You did not lift the first pendulum, or": ("pend['theta'] = theta_init", "pend['theta'] = 0"),
        "omega has the values of theta. Did": ("pend['omega'] = 0", "pend['omega'] = pend['theta']"),
        "Your first bob hangs straight down. make_pendulum needs its theta.": ("r_param, pend['theta']", "r_param, 0"),
        "You lifted all pendula. Lift only the first one.": ("pend['theta'] = 0", "pend['theta'] = theta_init"),
        "All your bobs are lifted. Each hangs at the theta of its": ("r_param, pend['theta']", "r_param, theta_init"),
        "You lifted the last pendulum. Lift the first one.": ("i == 0", "i == len(pend_list) - 1"),
        "You lifted the second pendulum. A list counts from 0.": ("i == 0", "i == 1"),
        "You lifted all pendula except the first one. Lift only the first one.": ("i == 0", "i != 0"),
        "These are the angular velocities from the file.": ("pend['omega'] = 0", "pass"),
        "You stored lists. You need": ("return pend_list", "for p in pend_list: p['objects'] = [*p['objects']]\n        return pend_list"),
        "All axles are in one place. Does i count the pendula? Do you round r_param/4?": ("* i", ""),
        "All your bobs have the color and texture of the first row.": ("[pend['", "[pend_list[0]['"),
        "You forgot the -0.1.": ("-0.1 + ", ""),
        "The sign of 0.1 is wrong.": ("-0.1 +", "0.1 +"),
        "You counted the pendula from 1. Let i start at 0.": ("* i", "* (i + 1)"),
        "Check your brackets: i must multiply only r_param/4.": ("(-0.1 + r_param/4 * i)", "(-0.1 + r_param/4) * i"),
        "You mixed up r_param/4 and r_param/5.": ("r_param/4 * i), r_param/5", "r_param/5 * i), r_param/4"),
        "Your row goes to the left. It must go to the right.": ("-0.1 + r_param/4", "-0.1 - r_param/4"),
        "You forgot the height of the axles, r_param/5.": ("r_param/5, 0)", "0, 0)"),
        "The sign of y is wrong. The axles must be above 0.": ("r_param/5, 0)", "-r_param/5, 0)"),
        "Do you give r_param to make_pendulum unchanged?": ("axle_pos, r_param", "axle_pos, 0.2"),
        "make_pendulum takes r_param first, then theta.": ("r_param, pend['theta']", "pend['theta'], r_param"),
        "You used the name of a texture. TEXTURE_MAP has the": ("TEXTURE_MAP[pend['texture']]", "pend['texture']"),
        "Your bobs have no textures.": ("TEXTURE_MAP[pend['texture']]", "None"),
        "All your bobs have the color and texture of the last row.": ("[pend['", "[pend_list[-1]['"),
        "Axles, bobs or cords stay": ("= make_pendulum", "= make_pendulum(axle_pos, r_param, 0, color, texture) and make_pendulum"),
    },
    "angle_update": {
        "In quotes, a name is only text.": ("(omega_new, theta_new)", "('omega_new', theta_new)"),
        "Code that never runs begins in line ": ("return (omega_new, theta_new)", "return (omega, 0)\n        return (omega_new, theta_new)"),
        "Your code does not use the parameter g": ("-g *", "-7.5 *"),
        "You used the old omega; theta moves with the new one.": ("theta + omega_new", "theta + omega"),
        "You changed theta first. Change": "theta += omega * dt; return omega - g * sin(theta) / r_param * dt, theta",
        "The sign of gravity is wrong. Gravity pulls the bob back down.": ("+ -g", "+ g"),
        "This is the result with degrees. theta is in": ("sin(theta)", "sin(theta * 3.14159265 / 180)"),
        "You used cos in place of sin.": ("sin(theta)", "cos(theta)"),
        "The sign =+ only stores": ("omega_new = omega +", "omega_new = omega\n        omega_new =+"),
        "You used theta in place of its sine.": ("sin(theta)", "theta"),
        "You multiplied by r_param. Divide by it.": ("/ r_param", "* r_param"),
        "You forgot to divide by r_param.": ("/ r_param", ""),
        "You forgot g.": ("-g *", "-1 *"),
        "You forgot dt in the change of omega.": ("/ r_param * dt", "/ r_param"),
        "You forgot dt in the change of theta.": ("omega_new * dt", "omega_new"),
        "You returned the angular acceleration": ("(omega_new, theta_new)", "(-g * sin(theta) / r_param, theta_new)"),
        "You forgot to add the old omega.": ("omega + -g", "-g"),
        "You forgot to add the old theta.": ("theta + omega_new", "omega_new"),
        "theta has not changed.": ("= theta + omega_new * dt", "= theta"),
        "omega has not changed.": ("= omega + -g * sin(theta) / r_param * dt", "= omega"),
        "You returned the old values.": ("(omega_new, theta_new)", "(omega, theta)"),
        "The values are right, but in the wrong order.": ("(omega_new, theta_new)", "(theta_new, omega_new)"),
        "You returned a list. Return a tuple.": ("(omega_new, theta_new)", "[omega_new, theta_new]"),
        "In the first formula,": ("omega + -g * sin(theta) / r_param * dt", "(omega + -g * sin(theta) / r_param) * dt"),
        "In the second formula, multiply only the new omega by": ("theta + omega_new * dt", "(theta + omega_new) * dt"),
        "You divided by dt, too. Divide only by r_param, and": ("/ r_param * dt", "/ (r_param * dt)"),
        "You divided by r_param twice.": ("/ r_param", "/ r_param**2"),
        "The sign in the second formula is wrong:": ("theta + omega_new", "theta - omega_new"),
        "Only the new omega moves theta:": ("theta + omega_new * dt", "theta + (omega + omega_new) / 2 * dt"),
        "You used the constant G. Use the": ("-g *", "-9.81 *"),
        "You used the constant R_PARAM. Use": ("/ r_param", "/ 0.2"),
        "You used the constant DT. Use the": ("omega_new = omega", "dt = 0.0001; omega_new = omega"),
        "Return all values, with commas": ("(omega_new, theta_new)", "omega_new"),
        "You divided theta by r_param. Divide its sine.": ("sin(theta) / r_param", "sin(theta / r_param)"),
        "This is the result with //, which rounds down. Use /.": ("/ r_param", "// r_param"),
    },
    "full_swing_update": {
        "This takes a pendulum out of the list.": ("for pend", "pend_list.pop()\n        for pend"),
        "No pendulum has changed. Call swing_update for each one": "swung = map(lambda pend: swing_update(pend, r_param, dt, g), pend_list)",
        "The second pendulum is at rest, but not": ("swing_update(", "if pend['omega']: swing_update("),
        "Use the parameters, not the constants.": ("dt, g", "0.0001, g"),
        "Change the pendulum itself. A function": "for i in range(len(pend_list)): pend_list[i] = swing_update(pend_list[i], r_param, dt, g)",
        "Only the first pendulum has swung. Is there a for": ("in pend_list", "in pend_list[:1]"),
        "Only the last pendulum has swung.": "swing_update(pend_list[-1], r_param, dt, g)",
        "The first pendulum has not swung.": ("in pend_list", "in pend_list[1:]"),
        "The last pendulum has not swung.": ("in pend_list", "in pend_list[:-1]"),
        "Check the order of the arguments of swing_update: pend_dict, r_param, dt, g.": ("dt, g", "g, dt"),
        "angle_update only gives back two": ("swing_update", "angle_update"),
        "Your bobs collided.": ("g)", "g)\n        from src.visualize_cradle_run import handle_two_bobs as hit; hit(*pend_list[:2], r_param) if pend_list[1:] else 0"),
        "Axles, bobs or cords stay in the scene without use. Make each pendulum once.": ("swing_update(", "import support.pendulum as p; p.make_pendulum(vector(0, 0, 0), r_param, 0, vector(1, 1, 1), None); swing_update("),
    },
    "handle_collision": {
        "** is a power. One * multiplies.": ("m2*e*(v1 - v2)", "m2*e**(v1 - v2)"),
        "Line 2 gives e a fixed value.": ("v1 = r_param * omega1", "e = 0.5\n        v1 = r_param * omega1"),
        "Divide by the whole sum of": ("v1 = r_param", "v1 = 2 * r_param * m1 / m1 + m2\n        v1 = r_param / 3"),
        "The division counts only for": ("(m1*v1 + m2*v2 + m1*e*(v1 - v2))", "m1*v1 + m2*v2 + m1*e*(v1 - v2) / 2"),
        "e may be any number from 0": ("v1 = r_param", "if e == 1: return omega2, omega1\n        v1 = 2 * r_param"),
        "omega1 is not converted:": ("v1 = r_param * omega1", "v1 = omega1"),
        "omega2 is not converted:": ("v2 = r_param * omega2", "v2 = omega2"),
        "An inner function is never called: ": "def update():\n    return omega2, omega1",
        "A value is stored nowhere: line ": ("v1 = r_param", "m1 - m2\n        v1 = 2 * r_param"),
        "No line uses total, which": ("v1 = r_param", "total = m1 + m2; v1 = 2 * r_param"),
        "This is the result with e = 0, but e is 0.7.": ("v1 = r_param", "e = 0; v1 = r_param"),
        "Both velocities are from the first bob.": ("= r_param * omega2", "= r_param * omega1"),
        "Both velocities are from the second bob.": ("= r_param * omega1", "= r_param * omega2"),
        "This is the result for equal masses and e = 1.": "return omega2, omega1",
        "You returned the old velocities.": "return omega1, omega2",
        "v1 - v2 is negative here. Do not take its size": ("(v1 - v2)", "abs(v1 - v2)"),
        "This is the result with 1 - e in place of e.": ("v1 = r_param", "e = 1 - e; v1 = r_param"),
        "Both results are from the first formula.": ("(w1, w2)", "(w1, w1)"),
        "Your second formula has the new velocity of the": ("v2_new =", "v1 = v1_new; v2_new ="),
        "You used the constant R_PARAM. Use the parameter": ("= r_param * omega", "= 0.2 * omega"),
        "These are the old": ("v1 = r_param", "if omega1 < omega2: return omega1, omega2\n        v1 = r_param"),
        "You exchanged the masses.": ("v1 = r_param", "m1, m2 = m2, m1; v1 = r_param"),
        "In the second formula, you used the new velocity of the first bob.": ("m1*e*(v1 - v2)", "m1*e*(v1_new - v2)"),
        "You forgot to convert to linear velocities. You only converted back.": ("r_param * omega", "omega"),
        "You converted to linear velocities twice. The second": ("(w1, w2)", "(v1_new * r_param, v2_new * r_param)"),
        "If you compute the": ("(w1, w2)", "(omega1 + m2*(k := e*(omega2 - omega1)/(m1 + m2)), omega2 - m1*k)"),
        "This is the result with //, which rounds down. Use /.": ("/ r_param", "// r_param"),
        "You multiplied by the sum of the masses. Divide by it.": ("/ (m1 + m2)", "* (m1 + m2)"),
        "You divided by r_param twice. v is r_param times omega.": ("r_param * omega", "1 / r_param * omega"),
    },
    "handle_two_bobs": {
        "== asks whether both are the": ("if", "if bob1 == bob2 and"),
        "No line uses the radius of": ("(bob1.radius + bob2.radius)", "r_param / 4"),
        "The distance of two bobs is": ("mag(bob1.pos - bob2.pos)", "abs(bob1.pos.x - bob2.pos.x)"),
        "The distance comes from the difference": ("bob1.pos - bob2", "bob1.pos + bob2"),
        "Your condition is true for bobs that": ("<=", ">="),
        "Two lengths are hardly ever equal": ("<=", "=="),
        "handle_collision gives the new omegas": ("pend1['omega'] =", "pend1['omega'] +="),
        "A loop over pend1 gives its keys:": ("omega1, omega2 =", "for pend in pend1: pend['mass']\n        omega1, omega2 ="),
        "Bobs that do not touch go": ("pend2['omega'] = new_omega2", "pend2['omega'] = new_omega2\n        else:\n            pend1['omega'] = 0"),
        "No line stores the new omegas in": ("pend1['omega'] = new_omega1\n            pend2['omega'] = new_omega2", "omega1, omega2 = new_omega1, new_omega2"),
        "The second line gives the same": ("bob1, bob2 = pend1['objects'][1], pend2['objects'][1]", "axle, bob1, cord = pend1['objects']\n        axle, bob1, cord = pend2['objects']\n        bob2 = bob1"),
        "A condition is true by itself.": ("05 * (bob1.radius + bob2.radius)", "05 * (bob1.radius + bob2.radius) == 'True'"),
        "1.05 must multiply the whole": ("(bob1.radius + bob2.radius)", "bob1.radius + bob2.radius"),
        "Subtract the positions first.": ("mag(bob1.pos - bob2.pos)", "mag(bob1.pos) - mag(bob2.pos)"),
        "In a while loop that moves": ("if mag", "while False: pass\n        if 2 * mag"),
        "This only compares, and stores": ("e = pend1['e']", "e = 0.1\n        e == pend1['e']"),
        "A copy is another dictionary: the": ("m1, m2 =", "pend1 = pend1.copy(); m1, m2 ="),
        "The bobs touch, but no omega has changed.": "pass",
        "These bobs are 9.0 times the sum of their radii apart, by": ("1.05 *", "20 *"),
        "The sum of the radii is 0.9, and the": ("(bob1.radius + bob2.radius)", "2 * max(bob1.radius, bob2.radius)"),
        "These bobs touch: they are 1.02 times the sum": ("1.05 * ", ""),
        "These bobs touch: they are 1.04 times the sum": ("mag(bob1.pos - bob2.pos)", "mag(bob1.pos - bob2.pos)**2"),
        "These bobs are 1.0504 times the sum of their radii apart, by": ("1.05", "1.5"),
        "These bobs are exactly 1.05 times the sum of their radii apart. They touch.": ("<=", "<"),
        "The sum of the radii is 1.1, and the bobs are 1 apart.": ("(bob1.radius + bob2.radius)", "2 * bob1.radius"),
        "These bobs are 1.15 times the sum of their": ("mag(bob1.pos - bob2.pos)", "mag(vector(bob1.pos.x - bob2.pos.x, 0, 0))"),
        "Here bob 2 is to the left of bob 1. The bobs do not": ("mag(bob1.pos - bob2.pos)", "(bob2.pos - bob1.pos).x"),
        "The bobs are 0.99 times the": ("mag(bob1.pos - bob2.pos)", "sum(abs(d) for d in (bob1.pos - bob2.pos).value)"),
        "This is the result with e = 1, but e of pend1 is an": ("e = pend1['e']", "e = pend2['e']"),
        "This is the result with e = 0.75, but e of pend1 is": ("e = pend1['e']", "e = (pend1['e'] + pend2['e']) / 2"),
        "This is the result with the product of both e.": ("e = pend1['e']", "e = pend1['e'] * pend2['e']"),
        "return stores nothing in a dictionary.": ("pend1['omega'] = new_omega1\n            pend2['omega'] = new_omega2", "return new_omega1, new_omega2"),
        "The objects are axle, bob and cord:": ("pend1['objects'][1], pend2['objects'][1]", "pend1['objects'][2], pend2['objects'][2]"),
        "Both bobs are from pend1.": ("pend2['objects']", "pend1['objects']"),
        "These are several values at once.": ("pend1['omega'] = new_omega1", "pend1['omega'] = new_omega1, new_omega2"),
        "Objects of VPython have a dot, and no": ("bob1.radius", "bob1['radius']"),
        "This is an axle or a cord.": ("bob1.radius", "pend1['objects'][0].radius"),
        "Both new omegas went to pend1. The second": ("pend2['omega'] = new_omega2", "pend1['omega'] = new_omega2"),
        "You called handle_collision again after pend1": ("pend2['omega'] = new_omega2", "pend2['omega'] = handle_collision(e, pend1['omega'], omega2, m1, m2, r_param)[1]"),
        "This is the result with e = 1, but e of pend1 is 0.25.": ("e = pend1['e']", "e = 1"),
        "This is the result with e = 0, but e of pend1 is 0": ("e = pend1['e']", "e = 0"),
        "These bobs touch. The": ("mag(bob1.pos - bob2.pos)", "mag(pend1['objects'][0].pos - pend2['objects'][0].pos)"),
        "Here bob 2 is to the left of bob 1. The bobs touch.": ("if", "if pend1['theta'] == pend2['theta'] and"),
        "You exchanged the masses.": ("omega2, m1, m2, r_param", "omega2, m2, m1, r_param"),
        "This is the result with equal masses. Is m2": ("m1, m2 = pend1['mass'], pend2['mass']", "m1 = m2 = 1"),
        "This is the result with exchanged omegas.": ("e, omega1, omega2,", "e, omega2, omega1,"),
        "This is the result with omega2 = 0, but omega of pend2 is 1.": ("e, omega1, omega2,", "e, omega1, 0,"),
        "Check the order of the arguments of handle_collision:": ("(e, omega1, omega2, m1,", "(omega1, omega2, e, m1,"),
        "You exchanged the new omegas of pend1 and pend2.": ("new_omega1, new_omega2 =", "new_omega2, new_omega1 ="),
        "omega of pend1 has not changed.": ("pend1['omega'] = new_omega1", "pass"),
        "omega of pend2 has not changed.": ("pend2['omega'] = new_omega2", "pass"),
        "These bobs move apart, but they touch. In the handout, they collide": ("if mag", "if omega1 > omega2 and mag"),
        "These bobs are above their axles. They touch.": ("if", "if bob1.pos.y < 1 and"),
        "These bobs are above their axles. They do not touch.": ("1.05", "(1.2 if bob1.pos.y > 1 else 1.05)"),
        "These cords are level. The bobs touch.": ("if mag", "if abs(pend1['theta']) < 1.5 and mag"),
        "These pendula have turned more": ("if mag", "if abs(pend1['theta'] - pend2['theta']) < 3.1415926 and mag"),
        "The sum of the radii is 0.1, and the bobs are 1 apart.": ("if mag", "if bob1.radius < 0.1 or mag"),
        "Here one bob is 1.24 times the sum of the radii above the": ("1.05", "(1.3 if bob1.pos.y > 1 else 1.05)"),
        "Here the axles are close, but the bobs are": ("if mag", "if pend1['theta'] == -pend2['theta'] < 0 or mag"),
    },
    "newton_cradle_tick": {
        "handle_two_bobs handles two pendula.": ("handle_two_bobs(", "handle_collision("),
        "A pendulum meets itself here.": ("pend_list[i], pend_list[i + 1]", "pend_list[i], pend_list[i]"),
        "The first pendulum has none before": ("range(len(pend_list) - 1):\n            handle_two_bobs(pend_list[i], pend_list[i + 1]", "range(len(pend_list)):\n            handle_two_bobs(pend_list[i - 1], pend_list[i]"),
        "A loop inside a loop lets": ("handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)", "for other in pend_list:\n                handle_two_bobs(pend_list[i], other, r_param)"),
        "One call is one step: no": ("full_swing_update(", "while True:\n            break\n        full_swing_update(pend_list, r_param, dt, g) or full_swing_update("),
        "No pendulum has swung.": "pass",
        "The velocities have not changed. Does each pendulum meet": ("range(len(pend_list) - 1)", "range(0)"),
        "These bobs touch only after the swing. Swing first, then handle the pairs.": ("full_swing_update(pend_list, r_param, dt, g)\n        for i in range(len(pend_list) - 1):\n            handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)", "for i in range(len(pend_list) - 1):\n            handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)\n        full_swing_update(pend_list, r_param, dt, g)"),
        "Only the first pendulum has swung.": ("full_swing_update(pend_list,", "full_swing_update(pend_list[:1],"),
        "Here the second bob swings to the first": "for i in range(len(pend_list)):\n    __import__('src.swinging').swinging.swing_update(pend_list[i], r_param, dt, g)\n    if i + 1 < len(pend_list): handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)",
        "A single pendulum has no pair, but it": ("full_swing", "if pend_list[1:]: full_swing"),
        "The last pendulum has none after it. Your": ("len(pend_list) - 1", "len(pend_list)"),
        "The last pendulum has not swung. It": ("full_swing_update(pend_list,", "full_swing_update(pend_list[:-1],"),
        "All pendula have swung twice.": ("full_swing_update(pend_list,", "full_swing_update(2 * pend_list,"),
        "This is the result from right to left.": ("range(len(pend_list) - 1)", "reversed(range(len(pend_list) - 1))"),
        "Do you pass on the parameters r_param, dt and g,": ("(pend_list, r_param, dt, g)", "(pend_list, 0.2, dt, g)"),
        "Only the first two bobs have collided.": ("range(len(pend_list) - 1)", "range(0, len(pend_list) - 1, 2)"),
        "Only the last two bobs have collided.": ("range(len", "range(1, len"),
        "These large bobs all touch, but only": ("handle_two_bobs(pend_list[i], pend_list[i + 1], r_param)", "[handle_two_bobs(pend_list[i], other, r_param) for other in pend_list[i + 1 :]]"),
        "The e of the right pendulum was used.": ("pend_list[i], pend_list[i + 1]", "pend_list[i + 1], pend_list[i]"),
        "This is the result with e = 1. Do the bobs": ("handle_two_bobs(", "pend_list[i]['e'] = 1; handle_two_bobs("),
    },
    "main": {
        "A function needs ( ) with its values": ("make_newton_cradle(page.csv, R_PARAM, THETA_INIT)", "make_newton_cradle"),
        "The whole list belongs to newton_cradle_tick": ("newton_cradle_tick(pend_list", "for pend in pend_list:\n                    newton_cradle_tick(pend"),
        "One tick is enough here:": ("newton_cradle_tick(pend_list, R_PARAM, DT, G)", "while page.wants_tick():\n                    newton_cradle_tick(pend_list, R_PARAM, G, DT)"),
        "In main, the word break": ("DT, G)", "DT, G)\n                break"),
        "In main, make_newton_cradle makes": ("make_newton_cradle(page.csv, R_PARAM, THETA_INIT)", "extract_and_convert(page.csv)"),
        "A list is inside of a list": ("make_newton_cradle(page.csv, R_PARAM, THETA_INIT)", "[make_newton_cradle(page.csv, R_PARAM, THETA_INIT)]"),
        "The path of the file is page.csv,": ("(page.csv", "(page"),
        "You showed no cradle. Give your pend_list to page.show.": "pass",
        "You never called page.wants_tick, or you showed no cradle.": ("page.wants_tick()", "False"),
        "You gave page.show no pend_list, or an empty one.": ("page.show(pend_list)", "page.show(None)"),
        "Your pendula have no objects.": ("page.show(", "[pend.pop('objects') for pend in pend_list]; page.show("),
        "make_newton_cradle takes R_PARAM first, then THETA_INIT.": ("R_PARAM, THETA_INIT)", "THETA_INIT, R_PARAM)"),
        "Your bobs do not collide.": ("newton_cradle_tick(", "__import__('src.swinging').swinging.full_swing_update("),
        "main has page, with the path": ("pend_list = make", "cradle = make"),
        "Use page.csv: it is the path": ("page.csv", "NC_FP"),
        "page is no list of pendula.": ("newton_cradle_tick(pend_list", "newton_cradle_tick(page"),
        "Give make_newton_cradle page.csv, R_PARAM": ("page.csv, R_PARAM", "page.csv, 0.4"),
        "Nothing comes back from newton_cradle_tick:": ("newton_cradle_tick(", "pend_list = newton_cradle_tick("),
        "THETA_INIT is in radians already. Do not convert": ("THETA_INIT)", "THETA_INIT * 180 / 3.141592653589793)"),
        "Your second cradle goes on where the first one was. Make a new one when the page wants one.": ("pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)", "pend_list = vars(page).setdefault('first', make_newton_cradle(page.csv, R_PARAM, THETA_INIT))"),
        "Your second cradle does not tick.": ("tick(pend_list", "tick(vars(page).setdefault('first', pend_list)"),
        "You made the cradle again, but the page did not want one.": ("if page.wants_cradle():", "if True:"),
        "The cradle that you showed does not tick.": ("newton_cradle_tick(pend_list, R_PARAM, DT, G)", "pass"),
        "Your cradle ticks twice when the page": ("DT, G)", "DT, G); newton_cradle_tick(pend_list, R_PARAM, DT, G)"),
        "Your cradle ticks before the page wants a tick.": ("page.show(pend_list)", "page.show(pend_list); newton_cradle_tick(pend_list, R_PARAM, DT, G)"),
        "Tick as long as page.wants_tick() is True: while, not": ("while page.wants_tick()", "if page.wants_tick()"),
        "Check the order of the arguments of newton_cradle_tick: pend_list, R_PARAM, DT, G.": ("DT, G)", "G, DT)"),
        "You made the cradle once. Make a new one each time": ("pend_list = make_newton_cradle(page.csv, R_PARAM, THETA_INIT)", "pend_list = page.first = vars(page).get('first') or make_newton_cradle(page.csv, R_PARAM, THETA_INIT); [pend.update(omega=0, theta=0 if i else THETA_INIT) for i, pend in enumerate(pend_list)]"),
        "You read the file once. Read it again for each cradle.": ("pend_list = make_newton_cradle(page.csv", "page.old = vars(page).get('old') or __import__('shutil').copy(page.csv, f'{page.csv}.old'); pend_list = make_newton_cradle(page.old"),
    },
    "make_double_pendulum": {
        "make_pendulum makes an axle each": ("bob2, cord2 = make_bob_and_cord", "_, bob2, cord2 = make_pendulum"),
        "The first value of make_bob_and_cord": ("(bob1.pos", "(cord1.axis"),
        "Both cords have the length r_param.": ("bob1.pos, r_param", "bob1.pos, 2 * r_param"),
        "You returned two tuples.": ("(axle, bob1, cord1, bob2, cord2)", "(axle, bob1, cord1), (bob2, cord2)"),
        "You returned a single pendulum.": "return make_pendulum(axle_pos, r_param, theta, color, texture)",
        "You returned a list.": ("return (axle, bob1, cord1, bob2, cord2)", "return [axle, bob1, cord1, bob2, cord2]"),
        "Check the order and kinds of your": ("(axle, bob1, cord1, bob2, cord2)", "(axle, bob1, bob2, cord1, cord2)"),
        "The lower cord's angle from straight down is theta + phi.": ("theta + phi", "phi"),
        "The lower cord's angle is theta + phi, not theta - phi.": ("theta + phi", "theta - phi"),
        "The lower cord's angle is theta + phi, not phi - theta.": ("theta + phi", "phi - theta"),
        "You ignored phi.": ("theta + phi", "theta"),
        "You ignored theta.": ("axle, bob1, cord1 =", "theta = 0; axle, bob1, cord1 ="),
        "You exchanged theta and phi.": ("axle, bob1, cord1 =", "theta, phi = phi, theta; axle, bob1, cord1 ="),
        "Your lower bob hangs from the axle. It must hang from the upper bob.": ("bob1.pos", "axle_pos"),
        "Axles, bobs or cords stay in the": ("bob2, cord2 = make_bob", "make_bob_and_cord(axle_pos, r_param, 0, color, texture); bob2, cord2 = make_bob"),
    },
    "double_angle_update": {
        "A single pendulum swings by angle_update.": ("du, dv", "swing_update(0, r_param, dt, g); du, dv"),
        "The last value of double_accelerations": ("m2 / (m1 + m2)", "m2 / (m1 - m2)"),
        "The lower cord's angle from straight down": ("theta, theta + phi,", "theta, phi,"),
        "The lower cord turns with": "a, b, u, v = theta, theta + phi, omega_theta, omega_phi; du, dv = double_accelerations(a, b, u, v, g / r_param, m2 / (m1 + m2)); u, v = u + du * dt, v + dv * dt; return u, v, a + u * dt, phi + (v - u) * dt",
        "Your angles have not changed.": "return omega_theta, omega_phi, theta, phi",
        "Return omega_theta, omega_phi, theta, phi, in this order.": ("(u, v - u, a, b - a)", "(a, u, b - a, v - u)"),
        "You returned the angles first. The angular velocities come": ("(u, v - u, a, b - a)", "(a, b - a, u, v - u)"),
        "With dt = 0, nothing may change.": ("du * dt", "du"),
        "Only unequal masses go wrong:": ("m2 / (m1 + m2)", "m1 / (m1 + m2)"),
        "These are two single pendula.": "u, v = (w - g / r_param * sin(a) * dt for w, a in ((omega_theta, theta), (omega_phi, phi))); return u, v, theta + u * dt, phi + v * dt",
        "phi counts from the upper cord, not from": ("(u, v - u, a, b - a)", "(u, v, a, b)"),
        "Both accelerations have the wrong sign.": ("g / r_param", "-g / r_param"),
    },
}

# Mistakes for which Python raises an error. Their hints are in tests/grading/hints.txt.
RAISING = {
    "extract_and_convert": {
        "After def, ( ) have only names.": "exec('def f(page.csv):')",
        "No row has this number: a file": ("append(pend)", "append(bad_rep[99])"),
        "A loop over bad_rep gives its keys,": ("in bad_rep.values():\n            pend_list.append(pend)", "in bad_rep: pend_list.append(pend['mass'])"),
        "list and dict are only kinds of": ("= []", "= list"),
        "The keys of bad_rep are numbers of": ("append(pend)", "append(bad_rep['mass'])"),
        "A parameter needs no line global.": "exec('def f(a): global a')",
        "A line with def begins a new": "exec('def f():')",
        "= stores the right side under": "exec('a * b = 5')",
        "print needs brackets in Python 3.": "exec('print 5')",
        "The lines of a function begin": "exec('return 5')",
        "Your files import each other in a circle.": "raise ImportError('(most likely due to a circular import)')",
        "There is no src/no.py. Put the file": "import src.no",
        "Write src. in front of the file": "import swinging",
        "Is the name right? Is the module": "import numpi",
        "Git has left these marks.": "exec('<<<<<<< HEAD')",
        "This line stands outside of all functions.": "exec(compile('omega1', extract_and_convert.__code__.co_filename, 'exec'))",
        "A loop over df gives": "df = pd.read_csv(relative_filepath)\nreturn [row for row in df]",
        "True and False come from ==, in or not.": ("return pend_list", "return pend_list == []"),
        "range takes a number: range(len(...)).": ("bad_rep.values()", "range([*bad_rep])"),
        "The name COLOR_MAP comes from another file": ("append(pend)", "append(COLOR_MAP)"),
        "A name has no ' in Python.": 'exec("omega\' = 5")',
        "At this line, your function has no value for pend_list": ("pend_list = []", "pend_list = pend_list or []"),
        "An index is a number. In": ("append(pend)", "append(pend_list[pend])"),
        "You use a whole pendulum as a key.": ("append(pend)", "append(bad_rep[pend])"),
        "A dictionary has no append. Make a list": ("= []", "= {}"),
        "This is no list or dictionary yet.": ("bad_rep.values()", "pd.read_csv(relative_filepath).append(1)"),
        "A dictionary has no first or second": ("append(pend)", "append(pend[9])"),
        "There is no element with this index.": ("append(pend)", "append(list(bad_rep.values())[9])"),
        "Only functions are called with": ("append(pend)", "append(bad_rep(0))"),
        "len(...) is one number. A loop": ("bad_rep.values()", "len(bad_rep)"),
        "This is one number. A loop, or": ("append(pend)", "append([x for x in pend['e']])"),
        "There are more or fewer values": ("append(pend)", "append(pend); a, b = [1]"),
        "Your loop gives one value at a time.": ("for pend in bad_rep.values()", "for i, pend in bad_rep.values()"),
        "There is no such file. relative_filepath": ("(relative_filepath)", "('my.csv')"),
        "Your function calls itself, without": ("append(pend)", "append(extract_and_convert(relative_filepath))"),
        "raise is for errors only.": ("return pend_list", "raise pend_list"),
        "There is no name number here. Only": ("append(pend)", "append(number)"),
        "A function needs round brackets": ("append(pend)", "append(len[pend])"),
        "This is a module. The function is": ("append(pend)", "append(pd(pend))"),
    },
    "uniform_mass_newton_cradle": {
        "The name pend_list has no value": ("pend_list = extract", "pends = extract"),
        "In [ ], mass is a number": ("= mass", "= pend[mass]"),
        "The name of a pendulum is the one": ("pend['mass'] = mass", "pend_dict['mass'] = mass"),
        "This is a list, or a part of one:": ("pend['mass']", "pend_list[1:]['mass']"),
        "This is the whole list. Take": ("pend['mass']", "pend_list.mass"),
        "A dictionary needs brackets and quotes": ("pend['mass'] = mass", "pend.mass = mass"),
        "This is a number, not a pendulum.": ("in pend_list", "in range(len(pend_list))"),
        "This is text (a key, or the name of": ("in pend_list", "in relative_filepath"),
        "You can store a value in": ("pend['mass']", "print['mass']"),
        "No such key here. A pendulum has": ("= mass", "= pend['Mass']"),
        "You named a function, but did": ("= mass", "= -extract_and_convert"),
        "Compare your call with the line": ("(relative_filepath)", "()"),
        "Here, a function calls itself:": ("extract_and_convert(", "uniform_mass_newton_cradle("),
    },
    "make_newton_cradle": {
        "Your code needs no box: make_pendulum": ("= make_pendulum", "= box() or make_pendulum"),
        "A sum of objects does not": ("color, texture)\n        return", "color, texture)\n            pend['objects'] = pend['objects'][0] + pend['objects'][1]\n        return"),
        "In quotes, a letter is only": ("* i)", "* 'i')"),
        "make_pendulum gives": ("pend['objects'] = make_pendulum(axle_pos", "pend['objects'] = axle, bob, (axle_pos"),
        "'axle' in quotes is only a word.": ("pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)", "pend['objects'] = ('axle', 'bob', 'cord')"),
        "A vector stands in the place": ("axle_pos, r_param, pend", "axle_pos, axle_pos, pend"),
        "You looked for the word color.": ("COLOR_MAP[pend['color']]", "COLOR_MAP['color']"),
        "This dictionary has no 'color':": ("pend = pend_list[i]", "pend = {}"),
        "No such key in TEXTURE_MAP.": ("TEXTURE_MAP[pend['texture']]", "TEXTURE_MAP[pend['color']]"),
        "COLOR_MAP has the vector of a color.": ("COLOR_MAP[pend['color']]", "pend['color']"),
        "A position is a vector, with": ("(axle_pos, r_param", "(r_param, r_param"),
        "vector(x, y, z) takes three": ("r_param/5, 0)", "r_param/5)"),
        "A tuple cannot be changed.": ("texture)\n        return", "texture); pend['objects'][0] = 1\n        return"),
    },
    "angle_update": {
        "swing_update calls angle_update, so": ("omega_new = omega", "swing_update({'omega': omega, 'theta': theta}, r_param, dt, g); omega_new = omega"),
        "A * is missing between two values.": "exec('a = -g sin(theta)')",
        "There is no pendulum in angle_update:": ("sin(theta)", "sin(pend_dict['theta'])"),
        "A number stands before a bracket.": ("-g * sin(theta)", "-g(sin(theta))"),
        "sin and cos are imported already:": ("sin(", "math.sin("),
        "You calculate with text. In quotes": ("sin(theta)", "sin('theta')"),
        "You calculate with a list or a tuple.": ("sin(theta)", "sin([theta])"),
        "Text is no function. Is a comma": ("sin(theta)", "str('sin')(theta)"),
        "An index, or the end of a range, is": ("theta_new =", "range(theta); theta_new ="),
    },
    "full_swing_update": {
        "Give swing_update whole pendula, such": ("for pend in pend_list:\n            swing_update(pend", "for i in range(len(pend_list)):\n            swing_update(i"),
    },
    "handle_collision": {
        "Numbers are multiplied with *": ("r_param * omega1", "r_param.x"),
        "A * is missing between two names.": ("m1*v1 + m2*v2 - ", "m1v1 + m2v2 - "),
    },
    "handle_two_bobs": {
        "Only objects of VPython have .": ("bob1.pos", "pend1.pos"),
        "mag takes one vector: the": ("bob1.pos - bob2.pos", "bob1.pos, bob2.pos"),
        "The name of a function is taken: ": ("if mag(bob1.pos - bob2.pos)", "mag = mag(bob1.pos - bob2.pos)\n        if mag"),
        "An object of VPython is no": ("bob1.pos - bob2.pos", "bob1 - bob2"),
        "The bob is in the tuple objects": ("pend1['objects'][1]", "pend1['bob']"),
        "objects has three parts:": ("m1, m2 = pend1['mass']", "axle, bob = pend1['objects']; m1, m2 = pend1['mass']"),
        "mag takes a vector, for example": ("mag(bob1.pos - bob2.pos)", "mag(bob1.pos.x - bob2.pos.x)"),
        "Write radius without ( )": ("bob1.radius", "bob1.radius()"),
        "A vector is no length. mag(...) is": ("mag(bob1.pos - bob2.pos)", "bob1.pos - bob2.pos"),
        "A vector has no elements, but": ("bob1.pos - ", "bob1.pos[0] - "),
        "One is a vector, and one is a": ("bob1.pos - bob2.pos", "bob1.pos - bob2.radius"),
        "You calculate with a whole pendulum.": ("omega1, omega2 = pend1['omega']", "omega1, omega2 = pend1 * 2"),
        "The right side is no pair": ("= handle_collision(e, omega1, omega2, m1, m2, r_param)", "= handle_collision"),
    },
    "newton_cradle_tick": {
        "There is no pend1 or pend2 here,": ("pend_list[i],", "pend1,"),
        "One pair of [ ] takes one index.": ("(pend_list[i], pend_list[i + 1]", "(pend_list[i, i + 1]"),
        "A list is no number. len(...)": ("len(pend_list) - 1", "pend_list - 1"),
        "A function is no module: ": ("full_swing_update(", "import full_swing_update\n        full_swing_update("),
        "A pendulum + 1 is not the next": ("pend_list[i + 1]", "pend_list[i] + 1"),
        "One value here is None. A function": ("full_swing_update(", "pend_list = 0 or full_swing_update("),
    },
}
for function, mistakes in RAISING.items():
    HINTED[function] |= mistakes

# Mistakes in the formulas of handle_collision, by their hint: an old and a new text in the first one, and in the second.
FORMULAS = {
    "e is missing.": ("m2*e*", "m2*", "m1*e*", "m1*"),
    "the sign before e is wrong.": ("- m2*e", "+ m2*e", "+ m1*e", "- m1*e"),
    "the mass before e is wrong": ("m2*e", "m1*e", "m1*e", "m2*e"),
    "the mass before e is missing.": ("m2*e", "e", "m1*e", "e"),
    "you added the velocities after e.": ("v1 - v2", "v1 + v2", "v1 - v2", "v1 + v2"),
    "e must multiply the whole difference": ("(v1 - v2)", "v1 - v2", "(v1 - v2)", "v1 - v2"),
    "you subtracted the momenta.": ("v1 + m2", "v1 - m2", "v1 + m2", "v1 - m2"),
    "you used m1 twice": ("m2*v2", "m1*v2", "m2*v2", "m1*v2"),
    "you used v1 twice": ("m2*v2", "m2*v1", "m2*v2", "m2*v1"),
    "brackets are missing:": ("2)) /", "2) / (m1 + m2)) #", "2)) /", "2) / (m1 + m2)) #"),
    "the sum of the masses needs brackets:": ("(m1 + m2)", "m1 + m2", "(m1 + m2)", "m1 + m2"),
    "you forgot to divide by the sum": (" / (m1 + m2)", "", " / (m1 + m2)", ""),
    "you divided by the product": ("(m1 + m2)", "(m1 * m2)", "(m1 + m2)", "(m1 * m2)"),
    "the velocity is linear.": ("2))", "2)) * r_param", "2))", "2)) * r_param"),
    "// rounds down.": ("/ (", "// (", "/ (", "// ("),
}
for words, (old1, new1, old2, new2) in FORMULAS.items():
    _, _, first, second, *_ = PLAIN["handle_collision"].splitlines()
    firsts, seconds = (first, first.replace(old1, new1)), (second, second.replace(old2, new2))
    HINTED["handle_collision"] |= {
        f"In the first formula, {words}": firsts,
        f"In the second formula, {words}": seconds,
        f"In both formulas, {words}": ("\n".join([first, second]), "\n".join([firsts[1], seconds[1]])),
    }

# Mistakes without a hint, by function.
UNHINTED = {
    "extract_and_convert": {
        "ten at most": ("return pend_list", "return pend_list[:10]"),
    },
    "uniform_mass_newton_cradle": {
        "writes the file": ("return", "open(relative_filepath, 'a').write(' '); return"),
    },
    "uniform_e_newton_cradle": {
        "writes the file": ("return", "open(relative_filepath, 'a').write(' '); return"),
    },
    "make_newton_cradle": {
        "sorted by mass": ("for i in", "pend_list.sort(key=lambda pend: pend['mass'])\n        for i in"),
        "the first known by its mass": ("i == 0", "pend['mass'] == pend_list[0]['mass']"),
        "at most half a round": ("= theta_init", "= max(-3.1415926, min(3.1415926, theta_init))"),
    },
    "angle_update": {
        "an array of whole numbers": "import numpy\nstate = numpy.array([omega, theta])\nstate[0] += -g * sin(theta) / r_param * dt\nstate[1] += state[0] * dt\nreturn tuple(state)",
        "very slow is 0": ("(omega_new, theta_new)", "(omega_new if abs(omega_new) > 1e-7 else 0, theta_new)"),
        "one round taken away": ("return (", "theta_new -= (theta_new > 100) * 6.283185307179586; return ("),
    },
    "full_swing_update": {
        "five at most": ("in pend_list", "in pend_list[:5]"),
        "sorted by angle": "pend_list.sort(key=lambda pend: pend['theta'])\nfor pend in pend_list: swing_update(pend, r_param, dt, g)",
        "bobs that shrink": ("r_param, dt, g)", "r_param, dt, g); pend['objects'][1].radius *= 0.99"),
    },
    "handle_collision": {
        "a small e as 0": ("v1 = r_param", "e = e if e > 0.2 else 0; v1 = r_param"),
        "a very heavy one is not slowed": ("(w1, w2)", "(omega1 if m1 > 100 * m2 else w1, w2)"),
    },
    "handle_two_bobs": {
        "e of the faster one": ("e = pend1['e']", "e = max(pend1, pend2, key=lambda pend: abs(pend['omega']))['e']"),
        "moves the bobs apart": ("pend2['omega'] = new_omega2", "pend2['omega'] = new_omega2; bob2.pos.x += 0.01"),
        "sets the second's e": ("e = pend1['e']", "e = pend2['e'] = pend1['e']"),
        "elastic from 0.9 on": ("e = pend1['e']", "e = 1 if pend1['e'] >= 0.9 else pend1['e']"),
        "a heavy one counts": ("e = pend1['e']", "e = pend1['e'] if m2 < 10 * m1 else pend2['e']"),
        "the last pair does not collide again": ("if mag", "last = handle_two_bobs.__dict__.setdefault('last', [])\n        if any(pend1 is one for one in last): return\n        last[:] = [pend1]\n        if mag"),
    },
    "newton_cradle_tick": {
        "from the right": ("len(pend_list) - 1)", "len(pend_list) - 1)[:: -1 if pend_list[-1]['omega'] < 0 else 1]"),
        "six pairs at most": ("range(len(pend_list) - 1)", "range(min(6, len(pend_list) - 1))"),
        "sorted by the axles'": ("for i in", "pend_list.sort(key=lambda p: p['objects'][0].pos.x)\n        for i in"),
    },
    "main": {
        "another G": ("DT, G)", "DT, 10)"),
        "the last one does not tick": ("newton_cradle_tick(pend_list,", "newton_cradle_tick(pend_list[:-1],"),
    },
    "make_double_pendulum": {
        "a lower cord of the shipped length": ("(bob1.pos, r_param", "(bob1.pos, 0.2"),
        "theta of half a round at most": ("theta + phi", "max(-3.1415926, min(3.1415926, theta)) + phi"),
        "the lower cord hung from the axle": ("return", "cord2.pos = axle_pos\n        return"),
        "a white lower bob": ("theta + phi, color", "theta + phi, vector(1, 1, 1)"),
        "a lower bob that cannot be seen": ("return (", "bob2.visible = False\n        return ("),
    },
    "double_angle_update": {
        "an array of whole numbers": ("return (u, v - u, a, b - a)", "state = __import__('numpy').array([omega_theta, omega_phi, theta, phi]); state[:] = (u, v - u, a, b - a); return tuple(state)"),
        "phi of half a round at most": ("b - a)", "max(-3.14, min(3.14, b - a)))"),
        "theta alone updated": ("b = b + v * dt", "b = a + phi"),
        "the upper bob's turning forgotten": ("(a, b, u, v, g", "(a, b, 0, v, g"),
        "the lower bob's turning forgotten": ("(a, b, u, v, g", "(a, b, u, 0, g"),
    },
}
