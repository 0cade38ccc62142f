"""The choice of the words for a mistake: what is seen and proved, in one order. hints.py has the words.

No student's text is read by pattern. Code is looked at as a syntax tree, without what changes no result: comments,
docstrings, prints, and an if that only raises an error.
"""

import ast
import inspect
import io
import keyword
import linecache
import re
import tokenize
from contextlib import suppress
from difflib import get_close_matches
from itertools import pairwise
from textwrap import dedent

from grading.handout import FUNCTIONS, IMPORTS
from grading.hints import CODE, ERRORS, FORMS, MEANING, OTHER_VALUE

LOOPS = ast.For, ast.While
ENDS = ast.Return, ast.Raise, ast.Break, ast.Continue
IN_LOOPS = {"full_swing_update": "tick in a loop", "make_newton_cradle": "new cradle"}
CONSTANTS = {"R_PARAM": "r_param", "DT": "dt", "G": "g", "THETA_INIT": "theta_init"}
MOST_CODE = 8_000  # characters of a function in which facts are looked for


def words_for(error, result, wrong, code, function, search) -> tuple[str, int]:
    """Return the words for a mistake, and the line that they name, or 0: from the first evidence that there is.

    error is the StoppedError of the function, or None; result has the words for its exact result, and wrong is the
    sentence that says what is wrong. code is the function's, and search() looks for a change. A file that cannot be
    compiled, or a function that is not written, has its words before.
    """
    found = (
        of_parameters(code.parameters, function, error)  # the check's own call does not fit
        or (error and error.hint)  # Python raised an error: its type, its own attributes, the line's tree
        or result  # the exact result of a known mistake
        or search()  # one change with which all checks pass
        or (error and error.meaning)
        or of_code(code, function)
        or next((words for pattern, words in FORMS.values() if re.search(pattern, wrong)), "")
        or (OTHER_VALUE if not error and FUNCTIONS[function].tier == "D" and " of pend_list[" in wrong else "")
    )
    return (found, 0) if isinstance(found, str) else (found[1], found[0])


def of_parameters(parameters, function, error) -> str:
    """Return the words for a line def that has other parameters than the handout."""
    own, given = parameters.split(", "), FUNCTIONS[function].parameters.split(", ")
    is_moved = sorted(own) == sorted(given) and own != given
    is_unfit = error and error.kind == "TypeError" and not error.places and f"{function}()" in (error.text or "")
    return f"The line def has changed. It must be: def {function}({', '.join(given)}):" if is_moved or is_unfit else ""


class Seen:
    """What an error says of itself, and what is in the line of the student's that raised it."""

    def __init__(self, error, frame, line):
        self.error, self.frame = error, frame
        self.text = str(error.msg if isinstance(error, SyntaxError) else error)
        nodes = nodes_of(frame, line) if frame else []
        self.function = frame.f_code.co_name if frame else ""
        key = f"{error.args[0]}" if isinstance(error, KeyError) and error.args else getattr(error, "filename", None)
        quoted = re.search(r"(?:name|variable|attribute) '(\w+)'", self.text)  # if the error itself has no name
        self.name = str(getattr(error, "name", None) or key or (quoted[1] if quoted else ""))
        self.file = self.name.replace(".", "/") + ".py"
        brackets = [node for node in nodes if isinstance(node, ast.Subscript)]
        self.in_brackets = any(getattr(node.slice, "id", "") == self.name for node in brackets)
        self.has_map = any(getattr(node.value, "id", "") in ("COLOR_MAP", "TEXTURE_MAP") for node in brackets)
        self.adds = any(isinstance(getattr(node.slice, "op", None), ast.Add) for node in brackets)
        self.texts = [node.value for node in nodes if isinstance(node, ast.Constant)]
        self.is_taken = frame is not None and callable(frame.f_globals.get(self.name))
        self.is_given = self.function in FUNCTIONS and self.name in IMPORTS[FUNCTIONS[self.function].file].split()

    @property
    def takes(self) -> str:
        """Which values the function takes that was called with others, if the student's code knows it."""
        name = self.text.partition("(")[0].rpartition(".")[2]
        called = self.frame.f_globals.get(name) if self.frame else None
        with suppress(TypeError, ValueError):
            names = [*inspect.signature(called).parameters]
            return f"{name} takes {len(names)} value{'s' * (len(names) != 1)}, in this order: {', '.join(names)}."
        return ""

    @property
    def tokens(self) -> list[str]:
        """The names, numbers and signs of a line that Python cannot read."""
        found: list[str] = []
        with suppress(tokenize.TokenError, SyntaxError):
            for token in tokenize.generate_tokens(io.StringIO((self.error.text or "").strip()).readline):
                found += [token.string] * (token.type in (tokenize.NAME, tokenize.NUMBER, tokenize.OP))
        return found if self.text.startswith("invalid syntax") else []

    @property
    def side_by_side(self) -> tuple:
        """Two values without a sign between them; between for and in, this is another mistake."""
        for one, other in pairwise(self.tokens) if self.tokens[:1] != ["for"] else ():
            if not {one, other} & {*keyword.kwlist} and other[0].isalnum() and (one[-1].isalnum() or one in ")]"):
                return one, other
        return ()

    @property
    def misspelled(self) -> tuple:
        """The first word of the line, and the word of Python that it may be, if it stands before another name."""
        first = self.tokens[:1] if self.tokens[:2] == [*self.side_by_side] else []
        near = get_close_matches(first[0].lower(), keyword.kwlist, n=1, cutoff=0.7) if first else []
        return (first[0], near[0]) if near else ()


def of_error(error, frames, function) -> tuple[str, str]:
    """Return the words for an error of Python in a function, and what it means.

    frames are the student's (frame, line) pairs that it has passed. What the function calls is right.
    """
    names = [frame.f_code.co_name for frame, _ in frames]
    own = len(names) - 1 - names[::-1].index(function) if function in names else len(names) - 1
    called = names[own + 1] if own + 1 < len(names) else ""
    if called in FUNCTIONS or called == "swing_update":
        code = frames[own + 1][0].f_code
        given = ", ".join(code.co_varnames[: code.co_argcount])
        return "", f"This line calls {called} with a value that it cannot use. It takes, in this order: {given}."
    seen = Seen(error, *(frames[-1] if frames else (None, 0)))
    meaning = next((words for kind, words in MEANING.items() if isinstance(error, kind)), "")
    if isinstance(error, SyntaxError) and seen.text != "invalid syntax":
        meaning = ""  # Python says it better
    for kinds, pattern, test, words in ERRORS.values():
        found = isinstance(error, kinds) and re.search(pattern, seen.text)
        if found and (test is None or test(seen)):
            return words.format(*found.groups(), name=seen.name, seen=seen), ""
    return "", meaning.format(name=seen.name)


def nodes_of(frame, line) -> list:
    """Return the nodes of the innermost statement at a frame's line (of a block, its first line), outer ones first."""
    nodes = [*ast.walk(ast.parse("".join(linecache.getlines(frame.f_code.co_filename))))]
    around = [node for node in nodes if isinstance(node, ast.stmt) and node.lineno <= line <= node.end_lineno]
    if not around:
        return []
    first, last = (line, line) if hasattr(around[-1], "body") else (around[-1].lineno, around[-1].end_lineno)
    return [node for node in nodes if first <= getattr(node, "lineno", 0) <= last]


def of_code(code, function) -> str:
    """Return the first fact of hints.CODE about a function, or ""."""
    with suppress(SyntaxError, ValueError, IndexError, AttributeError, RecursionError, MemoryError):  # also no function
        tree = ast.parse(dedent(code.source[:MOST_CODE])).body[0]
        found = {name: (line, what) for name, line, what in [*facts(tree, function)][::-1]}
        for name, (names, words) in CODE.items():
            if name in found and function in (names.split() or [function]):
                line, what = found[name]
                return words.format(what, line=line + code.line - 1)
    return ""


def is_idle(node) -> bool:
    """Return whether a statement changes no result: a docstring, a print, or an if that only raises an error."""
    if isinstance(node, ast.If):
        return not node.orelse and isinstance(node.body[0], ast.Raise)
    value = node.value if isinstance(node, ast.Expr) else None
    return isinstance(value, ast.Constant) or getattr(getattr(value, "func", None), "id", "") == "print"


def working(node, above=()):
    """Yield the nodes in a node that change something, each with the nodes around it."""
    for child in ast.iter_child_nodes(node):
        if not is_idle(child):
            yield child, (*above, node)
            yield from working(child, (*above, node))


def facts(function, name):
    """Yield facts about a function (its tree): the name of the row, the line, and what is named."""
    pairs = [*working(function)]
    nodes = [node for node, _ in pairs]
    stores = [node for node in nodes if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store)]
    yield from line_facts(pairs)
    yield from name_facts(function, [node for node in nodes if isinstance(node, ast.Name)])
    names = {*(one.attr for one in nodes if isinstance(one, ast.Attribute)), *map(id_of, nodes)}
    calls = [one for one in nodes if isinstance(one, ast.Call)]
    called = {id_of(one.func) or getattr(one.func, "attr", "") for one in calls}
    reads = [one.lineno for one in calls if id_of(one.func) == "extract_and_convert"]
    yield from (("read again", line, "") for line in reads[1:])
    made = max((one.lineno for one in calls if id_of(one.func) == "make_pendulum"), default=1e9)
    late = [one.lineno for one in stores if getattr(one.slice, "value", "") == "theta" and one.lineno > made]
    yield from (("late theta", line, "") for line in late)
    numbers = {one.value for one in nodes if isinstance(one, ast.Constant)}
    returned = [one.value for one in nodes if isinstance(one, ast.Return)]
    for row, is_so in (
        ("no return", FUNCTIONS[name].returns and all(getattr(one, "value", one) is None for one in returned)),
        ("no swing", "swing_update" not in called),
        ("no tick", not {"full_swing_update", "swing_update"} & called),
        ("not stored", "update" not in names and "omega" not in {getattr(one.slice, "value", "") for one in stores}),
        ("no radius", "radius" not in names),
        ("no 1.05", not {1.05, 0.05} & numbers and "BUFFER" not in names),
    ):
        if is_so:
            yield row, function.lineno, ""


def id_of(node) -> str:
    """Return the name that a node is, or ""."""
    return getattr(node, "id", "")


def line_facts(pairs):
    """Yield facts about lines, blocks and loops, as facts does."""
    stores = [one.id for one, _ in pairs if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store)]
    inside = [one for loop, _ in pairs if isinstance(loop, LOOPS) for one in ast.walk(loop)]
    used = {id_of(one) for use in inside if isinstance(use, (ast.Compare, ast.Subscript)) for one in ast.walk(use)}
    for node, above in pairs:
        value, loops = getattr(node, "value", None), [one for one in above if isinstance(one, LOOPS)]
        if isinstance(node, ast.Expr) and isinstance(value, ast.Compare):
            yield "compared", node.lineno, ""
        if isinstance(node, ast.Expr) and isinstance(value, (ast.Name, ast.Attribute)):
            yield "only named", node.lineno, ast.unparse(value)
        if isinstance(node, LOOPS) and loops:
            yield "two loops", node.lineno, ""
        if isinstance(node, ast.For) and isinstance(getattr(getattr(node.iter, "slice", None), "value", None), int):
            yield "one element", node.lineno, ast.unparse(node.iter)
        called = id_of(node.func) if isinstance(node, ast.Call) else ""
        if called in IN_LOOPS and loops:
            yield IN_LOOPS[called], node.lineno, ""
        block = getattr(above[-1], "body", ()) if isinstance(node, ast.stmt) else ()
        if node in block and any(isinstance(one, ENDS) for one in block[: block.index(node)]):
            yield "never runs", node.lineno, ""
        name = id_of(node.targets[0]) if isinstance(node, ast.Assign) else ""
        elements = [one for one in loops if name and name == id_of(getattr(one, "target", None))]
        is_pend = any("range" not in ast.unparse(one.iter) for one in elements)
        if is_pend or name and isinstance(value, ast.Dict) and name in map(id_of, value.values):
            yield "new value", node.lineno, name
        if stores.count(name) == 1 and name in used and isinstance(value, ast.Constant) and not loops:
            yield "counter", node.lineno, name


def name_facts(function, names):
    """Yield facts about the names in a function, as facts does."""
    arguments = [one.arg for one in function.args.args]
    for one in arguments:
        first = {type(node.ctx): node.lineno for node in sorted(names, key=lambda node: -node.lineno) if node.id == one}
        if ast.Load not in first and not (one == "r_param" and function.name.startswith("handle")):
            yield "no parameter", function.lineno, one
        if first.get(ast.Store, 1e9) < first.get(ast.Load, 1e9):
            yield "lost parameter", first[ast.Store], one
    for node in names:
        if CONSTANTS.get(node.id) in arguments:
            yield "constant", node.lineno, node.id
