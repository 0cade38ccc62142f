"""All words for mistakes, as rows with names. evidence.py chooses among them.

ERRORS  a row for an error of Python: its type, a pattern of Python's own words or "", a test of what is seen or None
        (evidence.Seen), and the words; {0} is the first group of the pattern, {name} the name or key of the error
MEANING what an error means, if no row fits
RESULTS the result of a known mistake (a value, or a test of it) in a check; it is never the unchanged input
FORMS   a pattern of the sentence that says what is wrong
CODE    a fact about the tree of the function (evidence.py finds it by the row's name)
STEPS   of each function, and the numbers of a check; PYTHON has lines about books for these
"""

import re

from vpython import sphere

from grading.cradles import MIXED, R

KEYS = "mass", "e", "theta", "omega", "color", "texture", "objects"
TUPLE = "The bob is in the tuple objects of a pendulum: axle, bob, cord = pend['objects']."

# A row is a line:
# fmt: off
ERRORS = {
    "look-alike": (SyntaxError, r"invalid (?:non-printable )?character", None, "This character only looks like the right one. Delete it, and type it on your keyboard."),
    "encoding": ((SyntaxError, ValueError), "null bytes|codec can't decode", None, "This file is not saved in UTF-8. Save it with the encoding UTF-8."),
    "misspelled": (SyntaxError, "", lambda seen: seen.misspelled, "Python has no word {seen.misspelled[0]}. Is it {seen.misspelled[1]}?"),
    "no sign": (SyntaxError, "", lambda seen: seen.side_by_side, "A sign is missing between {seen.side_by_side[0]} and {seen.side_by_side[1]}: * multiplies them, a comma separates them."),
    "turned sign": (SyntaxError, "", lambda seen: re.search("= [<>]", " ".join(seen.tokens)), "In Python, = comes last in this sign: <= or >=."),
    "curly": (SyntaxError, "", lambda seen: re.search(r"[\])] {", " ".join(seen.tokens)), "A key stands in [ ], not in {{ }}."),
    "indent": ((IndentationError, SyntaxError), r"indent|'return' outside|\btabs?\b", None, "The lines of a function begin with four spaces, those of a loop or an if in it with four more."),
    "equation": (SyntaxError, r"cannot assign to (?:expression|function call|literal)|cannot contain assignment", None, "Only a name, or a key in [ ], can get a value: on the left of = , or between for and in."),
    "outside": (NameError, "", lambda seen: seen.function == "<module>", "This line stands outside of all functions. Delete it, or indent it if it belongs to one."),
    "import": (NameError, "", lambda seen: seen.is_given and not seen.is_taken, "The name {name} comes from another file, or from a package. Put its import back, at the top of the file."),
    "key is a name": (NameError, "", lambda seen: seen.name in KEYS and seen.in_brackets, "A key is text. Write it in quotes: ['{name}']."),
    "name taken": (UnboundLocalError, "", lambda seen: seen.is_taken, "The name of a function is taken: {name}. Give your own value another name."),
    "bob": (KeyError, "", lambda seen: seen.name in ("axle", "bob", "cord", "pos", "radius", "bob1", "bob2"), TUPLE),
    "word": (KeyError, "", lambda seen: seen.has_map and seen.name in ("color", "texture"), "You looked for the word {name}. Between [ ] belongs the pendulum's own {name}."),
    "map": (KeyError, "", lambda seen: seen.has_map, "The key of COLOR_MAP is the color of the pendulum, and that of TEXTURE_MAP its texture."),
    "last": (IndexError, "", lambda seen: seen.adds, "The last pendulum has none after it. The loop goes one step too far."),
    "append": (IndexError, "list assignment", None, "A list has no place for a new element. Add it with append."),
    "too many": (AttributeError, "'list' object has no", lambda seen: seen.name in (*KEYS, "values", "items", "keys"), "This is the whole list. Take one pendulum first, for example in a for loop."),
    "no dot": (AttributeError, "'dict' object has no", lambda seen: seen.name in KEYS, "A dictionary needs brackets and quotes, not a dot: ['{name}']."),
    "no bob": ((AttributeError, TypeError), "'(?:dict|tuple)' object has no attribute '(?:pos|radius|axis)'|tuple indices .* not str", None, TUPLE),
    "nothing": ((AttributeError, TypeError), "NoneType", None, "One value in this line is None. A function without return gives None, and append gives None, too: do not store its result."),
    "color": (AttributeError, "color must be a vector", None, "COLOR_MAP has the vector of a color. make_pendulum takes axle_pos, r_param, theta, color, texture, in this order."),
    "pendulum as index": (TypeError, "list indices .* not dict|unhashable type: '(?:dict|list)'", None, "You use a whole pendulum as an index or a key. A loop over the list gives the pendulum itself: it needs no [ ]."),
    "key of a list": (TypeError, "list indices .* not str", None, "A list has no keys: each of its pendula has. Take one pendulum, for example in a for loop."),
    "text with a key": (TypeError, "string indices|byte indices", None, "This is text (a key, or the name of a file), and no pendulum: it has no keys."),
    "no keys": (TypeError, r"'(?:int|float|numpy\.\w+)' object (?:is not subscriptable|does not support)", None, "A number has no keys and no elements: it is no pendulum. range( ) gives numbers, and a loop over a dictionary gives its keys."),
    "one number": (TypeError, "'(?:int|float)' object is not iterable|cannot unpack non-iterable (?:int|float)", None, "This is one number. A loop, or two names before = , need several values. A loop that counts takes range( )."),
    "number called": (TypeError, "'(?:int|float|vector)' object is not callable", None, "A value with ( ) behind it is called as a function, and a number cannot be called. A product needs * ."),
    "not callable": (TypeError, "'(?:list|dict|tuple|str|dict_values)' object is not callable", None, "Only functions are called with ( ). A list, a dictionary or a tuple needs [ ] behind its name."),
    "round brackets": (TypeError, "'(?:function|builtin_function_or_method|method|type)' object is not subscriptable|type '.*' is not subscriptable", None, "A function needs ( ), not [ ]."),
    "not called": (TypeError, "'?(?:function|builtin_function_or_method|method)\\b", None, "You named a function, but did not call it. Put ( ) behind its name, with its values in them."),
    "length": (TypeError, "'[<>]=?' not supported .*'vector'", None, "A vector is no length. mag(...) is the length of a vector."),
    "object": (TypeError, "operand.*'(?:sphere|box|cylinder)'|'(?:sphere|box|cylinder)' object is not subscriptable", None, "An object of VPython is no number and no vector. Its position is .pos, and a bob's radius is .radius."),
    "vector": (TypeError, "'vector' object is not|vector needs 3", None, "A vector has x, y and z: vector(x, y, z), and bob.pos.x. It has no elements."),
    "mixed": (TypeError, "operand.*'vector'|number.*'?vector'?", None, "A vector stands beside a number, or in its place. The positions of both bobs are vectors."),
    "more text": (TypeError, "must be str|operand.*'str'|number, not '?str|between.*'str'|by non-int of type|concatenate str", None, "You calculate with text, or with several values at once. In quotes, a name is only text; [ ] or a comma make several values."),
    "several": (TypeError, "operand.*'(?:tuple|list)'|number, not '?(?:tuple|list)|between.*'(?:tuple|list)'|concatenate", None, "You calculate with a list or a tuple. [ ] make a list, also in a formula: its brackets are ( ). Commas make a tuple. Take its numbers one by one."),
    "next": (TypeError, r"\+: 'dict' and 'int'", None, "A pendulum plus 1 is not the next pendulum: + 1 needs an index. A loop over range(...) gives i, and pend_list[i] is a pendulum."),
    "whole pendulum": (TypeError, "operand.*'dict'|number, not '?dict|between.*'dict'", None, "You calculate with a whole pendulum. A key gives one of its values; range(len(...)) counts pendula."),
    "arguments": (TypeError, r"(\w+)\(\) (?:missing|takes|got)", lambda seen: seen.takes, "{seen.takes}"),
    "three parts": (ValueError, "unpack", lambda seen: "objects" in seen.texts, "objects has three parts: axle, bob, cord = pend['objects']."),
    "path": ((ValueError, TypeError), r"file path|os\.PathLike", None, "The path of a file belongs here: relative_filepath."),
    "path in quotes": (FileNotFoundError, "", lambda seen: seen.name in ("relative_filepath", "page.csv", "NC_FP"), "Write {name} without quotes: it is a name, not text."),
    "circle": (ImportError, "circular import", None, "Your files import each other in a circle. Remove the import in this file."),
    "file gone": (ModuleNotFoundError, "", lambda seen: seen.name.startswith("src."), "There is no file {seen.file}. Put it back."),
    "src": (ModuleNotFoundError, "", lambda seen: seen.name in ("pds_helper", "special_cradles", "swinging", "visualize_cradle_run", "double_cradle"), "Write src. in front of the file in the import: src.{name}."),
    "itself": (RecursionError, "", None, "Your function calls itself, without end. Delete this call, or call the function that you need in its place."),
}
MEANING = {
    UnboundLocalError: "At this line, your function has no value for {name} yet. The line that gives it one is below, or in an if that is not true.",
    NameError: "There is no name {name} here. Use a parameter, or give {name} a value in a line above, with = .",
    KeyError: "There is no key {name} here. A pendulum has mass, e, theta, omega, color and texture, and later objects.",
    IndexError: "There is no element with this index. The first one has 0, the last one the length minus 1.",
    AttributeError: "The value in front of the dot has no part with the name {name}. Which line gave it this value?",
    ModuleNotFoundError: "There is no module {name} for this Python. The imports at the top of the file are enough.",
    FileNotFoundError: "There is no such file. The parameter has the path of the file to read.",
    ZeroDivisionError: "The value below / is 0 here. In the handout, no formula divides by a value that may be 0.",
    SyntaxError: "Python cannot read this line, or the one above it. Look at its signs, words and brackets: one is missing, or does not belong.",
    ValueError: "The values in this line are not those that Python needs here. Which line gave them?",
    TypeError: "Python cannot do this with values of these kinds. Which line gave them?",
}

DEGREES = "This is the result with degrees. theta is in radians already, as sin() takes it. Do not convert it."
# Mistakes in the formulas of handle_collision: the wrong first result, and the wrong second one.
FORMULAS = {
    "e is missing.": (-8.2, -1.2),
    "the sign before e is wrong.": (1.32, -3.58),
    "the mass before e is wrong: m2 in the first one, m1 in the second one.": (-3.58, 1.32),
    "the mass before e is missing.": (-3.09, -2.11),
    "e must multiply the whole difference of the velocities. It needs brackets.": (-3.88, -1.78),
    "brackets are missing: divide all of it by the sum of the masses.": (-29.92, -25.02),
    "the sum of the masses needs brackets: you divided only by m1.": (-12.6, 11.9),
    "both divisions must count for all of it: it needs brackets.": (-14.32, -9.42),
    "you forgot to divide by the sum of the masses.": (-65.2, -16.2),
    "the velocity is linear. Convert it back to an angular one.": (-2.608, -0.648),
    "you exchanged v1 and v2 in the momenta.": (-2.32, 2.58),
}
RESULTS = {
    "test_angle_update": {
        "old omega": ((2.0, 2.917993878), "You used the old omega; theta moves with the new one."),
        "sign of gravity": ((4.0, 3.017993878), "The sign of gravity is wrong. Gravity pulls the bob back down."),
        "to radians": ((2.908647, 2.908858878), DEGREES),
        "to degrees": ((4.429753, 3.060968878), DEGREES),
        "cos": ((4.732051, 3.091198878), "You used cos in place of sin."),
        "no sin": ((-2.235988, 2.394394878), "You used theta in place of its sine."),
        "no dt for omega": ((-7.0, 1.917993878), "You forgot dt in the change of omega."),
        "no dt for theta": ((2.0, 4.617993878), "You forgot dt in the change of theta."),
        "no r_param": ((2.6, 2.877993878), "You forgot to divide by r_param."),
        "times r_param": ((2.84, 2.901993878), "You multiplied by r_param. Divide by it."),
        "theta first": ((2.55652, 2.917993878), "You changed theta first. Change omega first, then theta."),
        "only the change": ((-1.0, 2.517993878), "You forgot to add the old omega: the new one is the old one plus its change."),
        "acceleration": ((-10.0, 1.617993878), "This is the acceleration, and not yet the new omega. Multiply it by dt, and add the old omega."),
        "average": ((2.0, 2.867993878), "Only the new omega moves theta: no 1/2 a t^2, no average."),
    },
    "test_handle_collision": {
        **{f"first: {words}": ((first, -1.62), f"In the first formula, {words}") for words, (first, _) in FORMULAS.items()},
        **{f"second: {words}": ((-6.52, second), f"In the second formula, {words}") for words, (_, second) in FORMULAS.items()},
        **{f"both: {words}": (both, f"In both formulas, {words}") for words, both in FORMULAS.items()},
        **{f"{name} not converted": (both, f"{name} is not converted: multiply it by r_param, too.") for name, both in {"omega1": (-8.14, -0.09), "omega2": (-14.68, -5.58)}.items()},
        "only back": ((-16.3, -4.05), "You forgot to convert to linear velocities. You only converted back."),
        "converted twice": ((-1.0432, -0.2592), "You converted to linear velocities twice. The second time, convert back: divide by r_param."),
        "one result twice": ((-6.52, -6.52), "Both results belong to the first bob. Look at the second formula, with + m1 e, and at the line that converts its result."),
        "new v1": ((-6.52, -2.9528), "In the second formula, you used the new velocity of the first bob. Use the old one."),
        "v1 overwritten": ((-6.52, -4.8568), "Your second formula has the new velocity of the first bob. Do not overwrite the old one: give the new one another name."),
        "exchange": ((-4.0, 3.0), "This is the result for equal masses and e = 1. Do not set these values yourself: they come from the call."),
    },
    "test_masses_and_omegas_are_those_of_each": {
        "twice": ((1.125, 1.0390625), "You called handle_collision again after pend1 had changed. Call it once, for both."),
        "both e": ((1.40625, 1.53125), "This is the result with the product of both e. Use only that of pend1."),
    },
    "test_a_tick_swings_all_pendula": {"twice": ([(-0.167920715, 0.606806704)] * 3, "All pendula have swung twice. Call full_swing_update once, and outside of the loop.")},
    "test_only_neighbours_are_pairs": {"all pairs": ([3.0, 2.0, 1.0], "These large bobs all touch, but only neighbours are pairs.")},
    "test_swings_come_before_collisions": {
        "swing last": ([1.0, 0.0], "These bobs touch only after the swing. Swing first, then handle the pairs."),
        "swing between": ([0.0, -1.0], "Here the second bob swings to the first one. All must swing before any collide."),
    },
    "test_pend_list_is_a_list_of_dictionaries": {
        "keys of bad_rep": ([0, 1, 2], "Your list has the keys of bad_rep. The pendula are its values."),
        "single values": ([value for row in MIXED for value in row.values()], "Your list has the single values of the file. A value of bad_rep is a whole pendulum already: append that one."),
        "a dictionary each": ([{key: value} for row in MIXED for key, value in row.items()], "Your list has a dictionary for each value. A value of bad_rep is a whole pendulum already: append that one."),
    },
    "test_bobs_hang_from_their_axles": {"all": (lambda found: len({(round(one.x, 6), round(one.y, 6)) for one in found}) == 1 and 0.2 < found[1].x < R, "All bobs are lifted. make_pendulum must get the theta of each pendulum, and not theta_init each time.")},
    "test_objects_are_axle_bob_and_cord": {"shared": (lambda found: isinstance(found[0], tuple) and isinstance(found[0][1], sphere) and found[0][1] is found[-1][1], "All pendula have the same objects. Make them inside the loop.")},
    "test_the_accelerations_are_those_of_the_laws_of_motion": {
        **{name: (found, "These are two single pendula. But each one pulls at the other: call double_accelerations.") for name, found in {"two single": (-10.0, -17.32), "lower alone": (-10.0, -10.0)}.items()},
        "beta": ((-5.71, -17.14), "double_accelerations gives the accelerations of alpha and beta. phi is beta - alpha: subtract that of alpha for omega_phi."),
    },
    "test_both_angles_are_updated": {"phi from straight down": ((3.0, 1.0, 0.6, 0.2), "phi counts from the upper cord, not from straight down; omega_phi, too.")},
}

FORMS = {
    "function": ("is a (?:function|builtin_function_or_method|method), not", "A name without ( ) is the function itself, and not what a call of it gives. Store the result of the call, with = , and use that."),
    "tuple": ("is a tuple, not a number", "These are several values at once. Take them apart: a, b = ..."),
    "not a tuple": ("is (?:a number|text|a dictionary|a list|a set), not a tuple", "Return the values themselves, with commas between them: no list, no dictionary."),
    "one": ("pend_list is a [^,]*, not a list", "pend_list must be a list of all pendula. [ ] makes an empty list, append adds a pendulum to it, and { } makes a dictionary."),
    "other keys": (r"pend_list\[\d+\] (?:misses|must not have) the key", "The keys must be those of the file, letter by letter: all of them, and no others."),
    "no key": ("has no key", "Keep all keys of each pendulum, and add the new ones. Compare them with the handout, letter by letter."),
    "text": ("is text, not a number", "This is text: a name in quotes, for example, or a key of a dictionary. A number belongs in its place."),
    "no pendulum": (r"pend_list\[\d+\] is [^,]*, not a dictionary", "Each element must be a whole pendulum: a dictionary with all of its keys."),
}
OTHER_VALUE = "Compare this value in each pendulum with the file and with the handout: which value must each pendulum have?"

# The names of functions to which a fact belongs ("" for all), and the words: {0} is what was found, {line} its line.
CODE = {
    "never runs": ("", "Line {line} never runs: a line above it leaves the function or the loop first."),
    "no return": ("", "Your function has no return with a value. Its last line gives the result back with return."),
    "compared": ("", "Line {line} only compares, and stores nothing. One = stores a value."),
    "only named": ("", "Line {line} names {0}, and does nothing with it. A function runs only with ( ) behind its name, and its values in them."),
    "new value": ("", "Line {line} gives the name {0} another value, and the pendulum in the list stays as it was. Store each value in the pendulum, under its key: {0}['omega'] = ..., for example."),
    "one element": ("", "Line {line} loops over {0}: that is one element of the list. A loop over the list itself gives all of them."),
    "counter": ("make_newton_cradle newton_cradle_tick", "Line {line} gives {0} its value, and the loop never changes it. A counter gets + 1 at the end of each turn."),
    "two loops": ("newton_cradle_tick", "Line {line} begins a loop in a loop. One loop that counts i is enough: pendulum i meets the next one, i + 1, and the last one has none after it."),
    "lost parameter": ("", "Line {line} gives {0} another value. The value of a parameter comes from the call: delete this line, or take another name."),
    "constant": ("", "Line {line} has the constant {0}. Use the parameter: the checks call your function with other values."),
    "read again": ("uniform_mass_newton_cradle uniform_e_newton_cradle elastic_newton_cradle inelastic_newton_cradle make_newton_cradle", "Line {line} reads the file again, without your changes. Store the list from the first call with = , change that list, and return it."),
    "late theta": ("make_newton_cradle", "Line {line} stores theta after make_pendulum has made the objects. make_pendulum needs the new theta before."),
    "no swing": ("full_swing_update", "No line calls swing_update. It swings one pendulum: it changes theta and omega, and moves the objects. Call it for each pendulum."),
    "no tick": ("newton_cradle_tick", "No line calls full_swing_update: no pendulum swings. Call it once, before the loop."),
    "tick in a loop": ("newton_cradle_tick", "Line {line} calls full_swing_update in a loop. It swings all pendula: call it once, above the loop."),
    "not stored": ("handle_two_bobs", "No line stores a new omega in a pendulum, and a plain name changes no pendulum: pend1['omega'] = ..., and the same for pend2."),
    "no radius": ("handle_two_bobs", "No line uses the radius of a bob: bob.radius. The sum of both radii decides whether they touch."),
    "no 1.05": ("handle_two_bobs", "In the handout, bobs touch up to 1.05 times the sum of their radii. No line has 1.05."),
    "new cradle": ("main", "Line {line} makes a new cradle in the loop. The loop must tick the one that is shown: pend_list from above."),
    "no parameter": ("", "Your code does not use the parameter {0}."),
}

STEPS = {
    "test_angle_update": "With omega = 3, theta = 2.61799, r_param = 0.4, dt = 0.1 and g = 8: sin(theta) is 0.5, the acceleration is -10, the new omega is 2, and theta changes by 0.2. Compare these with the values in your code.",
    "test_handle_collision": "With e = 0.7, omega1 = 3, omega2 = -4, m1 = 2, m2 = 8 and r_param = 0.4: v1 is 1.2, v2 is -1.6, m1 v1 + m2 v2 is -10.4, and v1 - v2 is 2.8. The new v are -2.608 and -0.648. Compare these with the values in your code.",
    "test_masses_and_omegas_are_those_of_each": "With e = 0.25, omega1 = 3, omega2 = 1, m1 = 2, m2 = 6 and r_param = 4, handle_collision gives 1.125 and 1.625. Compare these with the values in your code.",
    "test_axle_positions": "With r_param = 0.3, the axles are r_param/4 = 0.075 apart, and r_param/5 = 0.06 high. Compare these with the values in your code.",
    "extract_and_convert": "The steps: read_csv gives df, to_dict gives bad_rep, and pend_list gets each value of bad_rep. Return pend_list.",
    **{f"uniform_{key}_newton_cradle": f"The steps: pend_list comes from extract_and_convert; each pendulum gets the new {key}; pend_list is returned." for key in ("mass", "e")},
    **{f"{kind}_newton_cradle": f"The steps: uniform_e_newton_cradle makes the pend_list, with the e of an {kind} collision; pend_list is returned." for kind in ("elastic", "inelastic")},
    "make_newton_cradle": "The steps for each pendulum: theta, omega, axle_pos, color, texture, and objects (from make_pendulum).",
    "angle_update": "The steps: the acceleration from g, theta and r_param; omega plus its change in dt; theta plus its change, with the new omega; return both.",
    "full_swing_update": "The step: one loop over pend_list calls swing_update for each pendulum.",
    "handle_collision": "The steps: both omegas become linear velocities; the two formulas of the appendix use these, never each other; both results become angular again.",
    "handle_two_bobs": "The steps: mass, omega and bob of both, e of pend1; if the bobs are close, handle_collision gives the new omegas; each pendulum stores its own.",
    "newton_cradle_tick": "The steps: full_swing_update once; then a loop, in which handle_two_bobs gets each pendulum and the next one.",
    "main": "The steps: make_newton_cradle makes pend_list; page.show shows it, once; in the while loop, newton_cradle_tick moves it.",
    "make_double_pendulum": "The steps: make_pendulum for the upper one; make_bob_and_cord from the upper bob, with the angle from straight down; five objects are returned.",
    "double_angle_update": "The steps: alpha, beta and their rates; double_accelerations; the new rates, then the new angles; back to theta and phi.",
}
PYTHON = {
    "books.append(book)  # puts one more element at the end of the list": "extract_and_convert",
    "shelf.values()  # all values of a dictionary, without its keys": "extract_and_convert",
    "for book in books:  # the indented lines below run once for each book": "uniform_mass_newton_cradle uniform_e_newton_cradle full_swing_update",
    "books = read_all(path)  # calls a function, and stores its result": "main",
    "for i in range(len(books)):  # i is 0, then 1, ...; books[i] is a book": "make_newton_cradle newton_cradle_tick",
    "book['pages'] = 160  # stores a value in a key; == only compares": "uniform_mass_newton_cradle uniform_e_newton_cradle make_newton_cradle",
    "return prices(path, 20)  # returns the result of a call": "elastic_newton_cradle inelastic_newton_cradle",
    "area = 2 * (width + height)  # each product needs its *": "angle_update handle_collision",
    "sort_pages(book, 3)  # nothing comes back: the call changes the book": "full_swing_update newton_cradle_tick main",
    "title, pages, price = book['facts']  # takes a tuple apart": "handle_two_bobs make_double_pendulum",
    "low, high = prices(book)  # stores the two results of one call": "handle_two_bobs double_angle_update",
    "return low, high  # gives two values back, in this order": "angle_update handle_collision make_double_pendulum double_angle_update",
}
