"""All hints for mistakes, as rows with names. evidence.py chooses among them.

ERRORS  a row for an error of Python: its type, a pattern of Python's own text or "", a test of the
        evidence (evidence.Evidence) or None, and the hint; {0} is the first group of the pattern,
        {name} the name or key of the error
MEANING what an error means, if no row fits
FORMS   a pattern of the sentence that says what is wrong, and the hint
"""

import re

KEYS = "mass", "e", "theta", "omega", "color", "texture", "objects"
TUPLE = "The bob is in the tuple objects of a pendulum: axle, bob, cord = pend['objects']."

CALLED = (
    "sin",
    "cos",
    "mag",
    "vector",
    "len",
    "range",
    "make_pendulum",
    "angle_update",
    "swing_update",
    "handle_collision",
    "handle_two_bobs",
)

# Other kinds of files than Python: by the first characters, the kind.
OTHER_FORMS = {
    "<": "a web page. Download the file itself",
    "{\\rtf": "a text of a word processor (RTF). Save it as plain text",
    "PK\x03\x04": "a .zip, or a document of a word processor. Save it as plain text",
    "%PDF": "a PDF. Save it as plain text",
    '{"cells"': "a notebook of Jupyter. Save its code as a .py",
}
CONFLICT = "<<<<<<< ", ">>>>>>> "  # git writes lines that begin so
BOTH_VERSIONS = (
    "two versions, which git has put together. Choose one, and delete the lines with <<<, === "
    "and >>>"
)
# What only newer Pythons read: from which one on, a pattern of the line, and what it is.
NEWER = [
    ((3, 11), r"^except\s*\*", "except*"),
    ((3, 12), r"""f(["']).*\{[^}]*\1.*\}""", "the same quotes inside of the { } of an f-string"),
    ((3, 12), r"^(def|class) \w+\[", "[ ] behind the name in this line"),
    ((3, 12), r"^type \w+", "a line that begins with type"),
    ((3, 14), r"^except \w+ *,", "except with commas, and no ( )"),
    ((3, 14), r"""\bt["']""", "t-strings"),
]

# A row is a line:
# fmt: off
ERRORS = {
    "look-alike": (SyntaxError, r"invalid (?:non-printable )?character", None, "This character only looks like the right one. Delete it, and type it on your keyboard."),
    "encoding": ((SyntaxError, ValueError), "null bytes|codec can't decode", None, "This file is not saved in UTF-8. Save it with the encoding UTF-8."),
    "no Python": (SyntaxError, "", lambda evidence: evidence.other_form, "This file is no Python: it is {evidence.other_form}."),
    "newer": (SyntaxError, "", lambda evidence: evidence.newer, "{evidence.newer}"),
    "plus plus": (SyntaxError, "", lambda evidence: re.search(r"\+ \+( |$)", " ".join(evidence.tokens)), "Python has no ++: i += 1 adds 1."),
    "no brackets": (SyntaxError, "", lambda evidence: evidence.side_by_side and evidence.side_by_side[0] in CALLED, "A function needs ( ) around its values: {evidence.side_by_side[0]}({evidence.side_by_side[1]})."),
    "misspelled": (SyntaxError, "", lambda evidence: evidence.misspelled, "Python has no word {evidence.misspelled[0]}. Is it {evidence.misspelled[1]}?"),
    "no sign": (SyntaxError, "", lambda evidence: evidence.side_by_side, "A sign is missing between {evidence.side_by_side[0]} and {evidence.side_by_side[1]}: * multiplies them, a comma separates them."),
    "turned sign": (SyntaxError, "", lambda evidence: re.search("= [<>]", " ".join(evidence.tokens)), "In Python, = comes last in this sign: <= or >=."),
    "curly": (SyntaxError, "", lambda evidence: re.search(r"[\])] {", " ".join(evidence.tokens)), "A key stands in [ ], not in {{ }}."),
    "indent": ((IndentationError, SyntaxError), r"indent|'return' outside|\btabs?\b", None, "The lines of a function begin with four spaces, those of a loop or an if in it with four more."),
    "equation": (SyntaxError, r"cannot assign to (?:expression|function call|literal)|cannot contain assignment", None, "Only a name, or a key in [ ], can get a value: on the left of = , or between for and in."),
    "outside": (NameError, "", lambda evidence: evidence.function == "<module>", "This line stands outside of all functions. Delete it, or indent it if it belongs to one."),
    "in front": (NameError, "", lambda evidence: evidence.behind_dot in evidence.globals, "{evidence.behind_dot} is there without {name}. in front of it: write {evidence.behind_dot}( )."),
    "import": (NameError, "", lambda evidence: evidence.is_given and evidence.name not in evidence.globals, "The name {name} comes from another file, or from a package. Put its import back, at the top of the file."),
    "key is a name": (NameError, "", lambda evidence: evidence.name in KEYS and evidence.in_brackets, "A key is text. Write it in quotes: ['{name}']."),
    "end": (NameError, "", lambda evidence: evidence.name == "end", "Python has no end: delete this line. A block ends where its indentation ends."),
    "power": (TypeError, r"for \^", None, "In Python, ** is a power, and ^ is something else."),
    "R": (NameError, "", lambda evidence: evidence.name == "R", "The R of the handout is r_param."),
    "csv": (NameError, "", lambda evidence: evidence.name == "NC_FP", "page.csv has the path of the file."),
    "near": (NameError, "", lambda evidence: evidence.nearest, "No line that ran has given {name} a value."),
    "name taken": (UnboundLocalError, "", lambda evidence: evidence.is_taken, "The name of a function is taken: {name}. Give your own value another name."),
    "bob": (KeyError, "", lambda evidence: evidence.name in ("axle", "bob", "cord", "pos", "radius", "bob1", "bob2"), TUPLE),
    "word": (KeyError, "", lambda evidence: evidence.has_map and evidence.name in ("color", "texture"), "You looked for the word {name}. Between [ ] belongs the pendulum's own {name}."),
    "map": (KeyError, "", lambda evidence: evidence.has_map, "The key of COLOR_MAP is the color of the pendulum, and that of TEXTURE_MAP its texture."),
    "last": (IndexError, "", lambda evidence: evidence.adds, "The last pendulum has none after it. The loop goes one step too far."),
    "append": (IndexError, "list assignment", None, "A list has no place for a new element. Add it with append."),
    "too many": (AttributeError, "'list' object has no", lambda evidence: evidence.name in (*KEYS, "values", "items", "keys"), "This is the whole list. Take one pendulum first, for example in a for loop."),
    "add": (AttributeError, "'list' object has no", lambda evidence: evidence.name in ("add", "push", "put", "plus", "Append", "insertLast"), "A list has append: it puts one more element at the end."),
    "no dot": (AttributeError, "'dict' object has no", lambda evidence: evidence.name in KEYS, "A dictionary needs brackets and quotes, not a dot: ['{name}']."),
    "no bob": ((AttributeError, TypeError), "'(?:dict|tuple)' object has no attribute '(?:pos|radius|axis)'|tuple indices .* not str", None, TUPLE),
    "nothing": ((AttributeError, TypeError), "NoneType", None, "One value in this line is None. A function without return gives None, and append gives None, too: do not store its result."),
    "color": (AttributeError, "color must be a vector", None, "COLOR_MAP has the vector of a color. make_pendulum takes axle_pos, r_param, theta, color, texture, in this order."),
    "pendulum as index": (TypeError, "list indices .* not dict|unhashable type: '(?:dict|list)'", None, "You use a whole pendulum as an index or a key. A loop over the list gives the pendulum itself: it needs no [ ]."),
    "key of a list": (TypeError, "list indices .* not str", None, "A list has no keys: each of its pendula has. Take one pendulum, for example in a for loop."),
    "text with a key": (TypeError, "string indices|byte indices", None, "This is text (a key, or the name of a file), and no pendulum: it has no keys."),
    "no keys": (TypeError, r"'(?:int|float|numpy\.\w+)' object (?:is not subscriptable|does not support)", None, "A number has no keys and no elements: it is no pendulum. range( ) gives numbers, and a loop over a dictionary gives its keys."),
    "keys of a loop": (TypeError, "cannot unpack non-iterable", lambda evidence: evidence.goes_through_dictionary, "A loop over a dictionary gives its keys. .values() gives its values, and .items() both."),
    "one number": (TypeError, "'(?:int|float)' object is not iterable|cannot unpack non-iterable (?:int|float)", None, "This is one number. A loop, or two names before = , need several values. A loop that counts takes range( )."),
    "number called": (TypeError, "'(?:int|float|vector)' object is not callable", None, "A value with ( ) behind it is called as a function, and a number cannot be called. A product needs * ."),
    "not callable": (TypeError, "'(?:list|dict|tuple|str|dict_values)' object is not callable", None, "Only functions are called with ( ). A list, a dictionary or a tuple needs [ ] behind its name."),
    "round brackets": (TypeError, "'(?:function|builtin_function_or_method|method|type)' object is not subscriptable|type '.*' is not subscriptable", None, "A function needs ( ), not [ ]."),
    "not called": (TypeError, "'?(?:function|builtin_function_or_method|method)\\b", None, "You named a function, but did not call it. Put ( ) behind its name, with its values in them if it takes any."),
    "length": (TypeError, "'[<>]=?' not supported .*'vector'", None, "A vector is no length. mag(...) is the length of a vector."),
    "object": (TypeError, "operand.*'(?:sphere|box|cylinder)'|'(?:sphere|box|cylinder)' object is not subscriptable", None, "An object of VPython is no number and no vector. Its position is .pos, and a bob's radius is .radius."),
    "vector": (TypeError, "'vector' object is not|vector needs 3", None, "A vector has x, y and z: vector(x, y, z), and bob.pos.x. It has no elements."),
    "mixed": (TypeError, "operand.*'vector'|number.*'?vector'?", None, "A vector stands beside a number, or in its place. The positions of both bobs are vectors."),
    "more text": (TypeError, "must be str|operand.*'str'|number, not '?str|between.*'str'|by non-int of type|concatenate str", None, "You calculate with text, or with several values at once. In quotes, a name is only text; [ ] or a comma make several values."),
    "several": (TypeError, "operand.*'(?:tuple|list)'|number, not '?(?:tuple|list)|between.*'(?:tuple|list)'|concatenate", None, "You calculate with a list or a tuple. [ ] make a list, also in a formula: its brackets are ( ). Commas make a tuple. Take its numbers one by one."),
    "next": (TypeError, r"\+: 'dict' and 'int'", None, "A pendulum plus 1 is not the next pendulum: + 1 needs an index. A loop over range(...) gives i, and pend_list[i] is a pendulum."),
    "whole pendulum": (TypeError, "operand.*'dict'|number, not '?dict|between.*'dict'", None, "You calculate with a whole pendulum. A key gives one of its values; range(len(...)) counts pendula."),
    "arguments": (TypeError, r"(\w+)\(\) (?:missing|takes|got)", lambda evidence: evidence.takes, "{evidence.takes}"),
    "three parts": (ValueError, "unpack", lambda evidence: "objects" in evidence.texts, "objects has three parts: axle, bob, cord = pend['objects']."),
    "path": ((ValueError, TypeError), r"file path|os\.PathLike", None, "The path of a file belongs here: relative_filepath."),
    "path in quotes": (FileNotFoundError, "", lambda evidence: evidence.name in ("relative_filepath", "page.csv", "NC_FP"), "Write {name} without quotes: it is a name, not text."),
    "circle": (ImportError, "circular import", None, "Your files import each other in a circle. Remove the import in this file."),
    "file gone": (ModuleNotFoundError, "", lambda evidence: evidence.name.startswith("src."), "There is no file {evidence.file}. Put it back."),
    "src": (ModuleNotFoundError, "", lambda evidence: evidence.name in ("pds_helper", "special_cradles", "swinging", "visualize_cradle_run", "double_cradle"), "Write src. in front of the file in the import: src.{name}."),
    "itself": (RecursionError, "", None, "Your function calls itself, without end. Delete this call, or call the function that you need in its place."),
}
MEANING = {
    UnboundLocalError: "A line of this function gives {name} a value, so {name} is a name of this function alone. When this line runs, it has no value yet.",
    NameError: "No line that ran has given {name} a value. A name comes from the line def, from a line above, or from an import.",
    KeyError: "There is no key {name} here. A pendulum has mass, e, theta, omega, color and texture, and later objects.",
    IndexError: "There is no element with this index. The first one has 0, the last one the length minus 1.",
    AttributeError: "The value in front of the dot has no part with the name {name}.",
    ModuleNotFoundError: "There is no module {name} for this Python. The imports at the top of the file are enough.",
    FileNotFoundError: "There is no such file. The parameter has the path of the file to read.",
    ZeroDivisionError: "The value below / is 0 here. In the handout, no formula divides by a value that may be 0.",
    SyntaxError: "Python cannot read this line, or the one above it. Look at its signs, words and brackets: one is missing, or does not belong.",
    ValueError: "The values in this line are not those that Python needs here.",
    TypeError: "Python cannot do this with values of these kinds.",
}

FORMS = {
    "function": ("is a (?:function|builtin_function_or_method|method), not", "A name without ( ) is the function itself, and not what a call of it gives. Store the result of the call, with = , and use that."),
    "tuple": ("is a tuple, not a number", "These are several values, with a comma between them. A decimal number has a point; a, b = ... takes several values apart."),
    "not a tuple": ("is (?:a number|text|a dictionary|a list|a set), not a tuple", "Return all values, with commas between them: no list, no dictionary."),
    "one": ("The result is a [^,]*, not a list", "The result must be the list of all pendula."),
    "other keys": (r"pend_list\[\d+\] (?:misses|must not have) the key", "The keys must be those of the file, letter by letter: all of them, and no others."),
    "no key": ("has no key", "Keep all keys of each pendulum, and add the new ones. Compare them with the handout, letter by letter."),
    "text": ("is text, not a number", "This is text: a name in quotes, for example, or a key of a dictionary. A number belongs in its place."),
    "lost": ("has lost a pendulum", "A pendulum became something else. A function that returns nothing gives None: do not store its result."),
    "no pendulum": (r"pend_list\[\d+\] is [^,]*, not a dictionary", "Each element must be a whole pendulum: a dictionary with all of its keys."),
}
