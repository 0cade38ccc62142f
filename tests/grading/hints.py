"""Hints for errors of Python and for values of a wrong form, as rows with names.

ERRORS  a Hint for each known error of Python; of those that fit, the first one is taken
MEANING what an error means, if no row fits
FORMS   a pattern of the sentence that says what is wrong, and the hint

evidence.py chooses from ERRORS and MEANING, and choosing.py from FORMS. Other hints stand where
their mistake is found: those for exact results in the suites, the rest in choosing.py, grader.py,
outcomes.py and raised.py.
"""

import re
from collections.abc import Callable
from typing import Any, NamedTuple

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


class Hint(NamedTuple):
    """A hint, and the errors of Python that it is for."""

    kinds: type[BaseException] | tuple[type[BaseException], ...]
    # {name} is the subject_name of the evidence, {evidence} the evidence.Evidence
    hint: str
    pattern: str = ""  # of Python's own text
    fits: Callable[[Any], Any] | None = None  # a test of the evidence.Evidence


# The first row that fits gives the hint. So a row stands above those that would fit as well, but
# say less: "misspelled" names the word and is above "no sign", and the rows for one kind of object
# are above those for any.
# A row is a line:
# fmt: off
ERRORS = {
    "unseen": Hint(SyntaxError, pattern="invalid non-printable character", hint="A character that you cannot see stands at the mark. Delete it, and type a space if one belongs there."),
    "sign": Hint(SyntaxError, pattern="invalid character", hint="Python reads this character only in comments and in quotes. Type quotes, a minus or a comma on your keyboard. In Python, * multiplies, and ** is a power."),
    "encoding": Hint((SyntaxError, ValueError), pattern="null bytes|codec can't decode", hint="This file is not saved in UTF-8. Save it with the encoding UTF-8."),
    "no Python": Hint(SyntaxError, fits=lambda evidence: evidence.other_form_in_words, hint="This file is no Python: it is {evidence.other_form_in_words}."),
    "other tool": Hint((SyntaxError, NameError), fits=lambda evidence: evidence.other_tool_in_words, hint="{evidence.other_tool_in_words}"),
    "newer": Hint(SyntaxError, fits=lambda evidence: evidence.newer_python_in_words, hint="{evidence.newer_python_in_words}"),
    "plus plus": Hint(SyntaxError, fits=lambda evidence: re.search(r"\+ \+( |$)", " ".join(evidence.tokens)), hint="Python has no ++: i += 1 adds 1."),
    "no brackets": Hint(SyntaxError, fits=lambda evidence: evidence.side_by_side and evidence.side_by_side[0] in CALLED, hint="A function needs ( ) around its values: {evidence.side_by_side[0]}({evidence.side_by_side[1]})."),
    "misspelled": Hint(SyntaxError, fits=lambda evidence: evidence.misspelled, hint="Python has no word {evidence.misspelled[0]}. Is it {evidence.misspelled[1]}?"),
    "no sign": Hint(SyntaxError, fits=lambda evidence: evidence.side_by_side, hint="There is no sign between {evidence.side_by_side[0]} and {evidence.side_by_side[1]}: * multiplies two values, a comma separates them."),
    "turned sign": Hint(SyntaxError, fits=lambda evidence: re.search("= [<>]", " ".join(evidence.tokens)), hint="In Python, = comes last in this sign: <= or >=."),
    "curly": Hint(SyntaxError, fits=lambda evidence: re.search(r"[\])] {", " ".join(evidence.tokens)), hint="A key stands in [ ], not in {{ }}."),
    "indent": Hint((IndentationError, SyntaxError), pattern=r"indent|'return' outside|\btabs?\b", hint="The lines of a function begin with four spaces, those of a loop or an if in it with four more."),
    "equation": Hint(SyntaxError, pattern=r"cannot assign to (?:expression|function call|literal)|cannot contain assignment", hint="Only a name, or a key in [ ], can get a value: on the left of = , or between for and in."),
    "outside": Hint(NameError, fits=lambda evidence: evidence.function == "<module>", hint="This line stands outside of all functions. Delete it, or indent it if it belongs to one."),
    "in front": Hint(NameError, fits=lambda evidence: evidence.behind_dot in evidence.globals, hint="{evidence.behind_dot} is there without {name}. in front of it: write {evidence.behind_dot}( )."),
    "import": Hint(NameError, fits=lambda evidence: evidence.is_imported_by_handout and evidence.subject_name not in evidence.globals, hint="The name {name} comes from another file, or from a package. Put its import back, at the top of the file."),
    "key is a name": Hint(NameError, fits=lambda evidence: evidence.subject_name in KEYS and evidence.in_brackets, hint="A key is text. Write it in quotes: ['{name}']."),
    "end": Hint(NameError, fits=lambda evidence: evidence.subject_name == "end", hint="Python has no end: delete this line. A block ends where its indentation ends."),
    "power": Hint(TypeError, pattern=r"for \^", hint="In Python, ** is a power, and ^ is something else."),
    "R": Hint(NameError, fits=lambda evidence: evidence.subject_name == "R", hint="The R of the handout is r_param."),
    "csv": Hint(NameError, fits=lambda evidence: evidence.subject_name == "NC_FP", hint="page.csv has the path of the file."),
    "near": Hint(NameError, fits=lambda evidence: evidence.nearest, hint="No line that ran has given {name} a value."),
    "name taken": Hint(UnboundLocalError, fits=lambda evidence: evidence.is_name_of_function, hint="The name of a function is taken: {name}. Give your own value another name."),
    "bob": Hint(KeyError, fits=lambda evidence: evidence.subject_name in ("axle", "bob", "cord", "pos", "radius", "bob1", "bob2"), hint=TUPLE),
    "word": Hint(KeyError, fits=lambda evidence: evidence.has_map and evidence.subject_name in ("color", "texture"), hint="You looked for the word {name}. Between [ ] belongs the pendulum's own {name}."),
    "map": Hint(KeyError, fits=lambda evidence: evidence.has_map, hint="The key of COLOR_MAP is the color of the pendulum, and that of TEXTURE_MAP its texture."),
    "last": Hint(IndexError, fits=lambda evidence: evidence.adds_in_brackets, hint="The last pendulum has none after it. The loop goes one step too far."),
    "append": Hint(IndexError, pattern="list assignment", hint="A list has no place for a new element. Add it with append."),
    "too many": Hint(AttributeError, pattern="'list' object has no", fits=lambda evidence: evidence.subject_name in (*KEYS, "values", "items", "keys"), hint="This is the whole list. Take one pendulum first, for example in a for loop."),
    "add": Hint(AttributeError, pattern="'list' object has no", fits=lambda evidence: evidence.subject_name in ("add", "push", "put", "plus", "Append", "insertLast"), hint="A list has append: it puts one more element at the end."),
    "no dot": Hint(AttributeError, pattern="'dict' object has no", fits=lambda evidence: evidence.subject_name in KEYS, hint="A dictionary needs brackets and quotes, not a dot: ['{name}']."),
    "no bob": Hint((AttributeError, TypeError), pattern="'(?:dict|tuple)' object has no attribute '(?:pos|radius|axis)'|tuple indices .* not str", hint=TUPLE),
    "nothing": Hint((AttributeError, TypeError), pattern="NoneType", hint="One value in this line is None. A function without return gives None, and append gives None, too: do not store its result."),
    "color": Hint(AttributeError, pattern="color must be a vector", hint="COLOR_MAP has the vector of a color. make_pendulum takes axle_pos, r_param, theta, color, texture, in this order."),
    "pendulum as index": Hint(TypeError, pattern="list indices .* not dict|unhashable type: '(?:dict|list)'", hint="You use a whole pendulum as an index or a key. A loop over the list gives the pendulum itself: it needs no [ ]."),
    "key of a list": Hint(TypeError, pattern="list indices .* not str", hint="A list has no keys: each of its pendula has. Take one pendulum, for example in a for loop."),
    "text with a key": Hint(TypeError, pattern="string indices|byte indices", hint="This is text (a key, or the name of a file), and no pendulum: it has no keys."),
    "no keys": Hint(TypeError, pattern=r"'(?:int|float|numpy\.\w+)' object (?:is not subscriptable|does not support)", hint="A number has no keys and no elements: it is no pendulum. range( ) gives numbers, and a loop over a dictionary gives its keys."),
    "keys of a loop": Hint(TypeError, pattern="cannot unpack non-iterable", fits=lambda evidence: evidence.goes_through_dictionary, hint="A loop over a dictionary gives its keys. .values() gives its values, and .items() both."),
    "one number": Hint(TypeError, pattern="'(?:int|float)' object is not iterable|cannot unpack non-iterable (?:int|float)", hint="This is one number. A loop, or two names before = , need several values. A loop that counts takes range( )."),
    "number called": Hint(TypeError, pattern="'(?:int|float|vector)' object is not callable", hint="A value with ( ) behind it is called as a function, and a number cannot be called. A product needs * ."),
    "not callable": Hint(TypeError, pattern="'(?:list|dict|tuple|str|dict_values)' object is not callable", hint="Only functions are called with ( ). A list, a dictionary or a tuple needs [ ] behind its name."),
    "round brackets": Hint(TypeError, pattern="'(?:function|builtin_function_or_method|method|type)' object is not subscriptable|type '.*' is not subscriptable", hint="A function needs ( ), not [ ]."),
    "not called": Hint(TypeError, pattern="'?(?:function|builtin_function_or_method|method)\\b", hint="You named a function, but did not call it. Put ( ) behind its name, with its values in them if it takes any."),
    "length": Hint(TypeError, pattern="'[<>]=?' not supported .*'vector'", hint="A vector is no length. mag(...) is the length of a vector."),
    "object": Hint(TypeError, pattern="operand.*'(?:sphere|box|cylinder)'|'(?:sphere|box|cylinder)' object is not subscriptable", hint="An object of VPython is no number and no vector. Its position is .pos, and a bob's radius is .radius."),
    "vector": Hint(TypeError, pattern="'vector' object is not|vector needs 3", hint="A vector has x, y and z: vector(x, y, z), and bob.pos.x. It has no elements."),
    "mixed": Hint(TypeError, pattern="operand.*'vector'|number.*'?vector'?", hint="A vector stands next to a number, or in its place. The positions of both bobs are vectors."),
    "more text": Hint(TypeError, pattern="must be str|operand.*'str'|number, not '?str|between.*'str'|by non-int of type|concatenate str", hint="You calculate with text, or with several values at once. In quotes, a name is only text; [ ] or a comma make several values."),
    "several": Hint(TypeError, pattern="operand.*'(?:tuple|list)'|number, not '?(?:tuple|list)|between.*'(?:tuple|list)'|concatenate", hint="You calculate with a list or a tuple. [ ] make a list, also in a formula: its brackets are ( ). Commas make a tuple. Take its numbers one by one."),
    "next": Hint(TypeError, pattern=r"\+: 'dict' and 'int'", hint="A pendulum plus 1 is not the next pendulum: + 1 needs an index. A loop over range(...) gives i, and pend_list[i] is a pendulum."),
    "whole pendulum": Hint(TypeError, pattern="operand.*'dict'|number, not '?dict|between.*'dict'", hint="You calculate with a whole pendulum. A key gives one of its values; range(len(...)) counts pendula."),
    "arguments": Hint(TypeError, pattern=r"(\w+)\(\) (?:missing|takes|got)", fits=lambda evidence: evidence.signature_in_words, hint="{evidence.signature_in_words}"),
    "three parts": Hint(ValueError, pattern="unpack", fits=lambda evidence: "objects" in evidence.constants, hint="objects has three parts: axle, bob, cord = pend['objects']."),
    "path": Hint((ValueError, TypeError), pattern=r"file path|os\.PathLike", hint="The path of a file belongs here: relative_filepath."),
    "path in quotes": Hint(FileNotFoundError, fits=lambda evidence: evidence.subject_name in ("relative_filepath", "page.csv", "NC_FP"), hint="Write {name} without quotes: it is a name, not text."),
    "circle": Hint(ImportError, pattern="circular import", hint="Your files import each other in a circle. Remove the import in this file."),
    "file gone": Hint(ModuleNotFoundError, fits=lambda evidence: evidence.subject_name.startswith("src."), hint="There is no file {evidence.module_file}. Put it back."),
    "src": Hint(ModuleNotFoundError, fits=lambda evidence: evidence.subject_name in ("pds_helper", "special_cradles", "swinging", "visualize_cradle_run", "double_cradle"), hint="Write src. in front of the file in the import: src.{name}."),
    "itself": Hint(RecursionError, hint="Your function calls itself, without end. Delete this call, or call the function that you need in its place."),
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
    "no key": ("has no key|has taken a key", "Keep all keys of each pendulum, and add the new ones. Compare them with the handout, letter by letter."),
    "text": ("is text, not a number", "This is text: a name in quotes, for example, or a key of a dictionary. A number belongs in its place."),
    "lost": ("has lost a pendulum", "A pendulum became something else. A function that returns nothing gives None: do not store its result."),
    "no pendulum": (r"pend_list\[\d+\] is [^,]*, not a dictionary", "Each element must be a whole pendulum: a dictionary with all of its keys."),
}
