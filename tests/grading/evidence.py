"""The choice of the words for a mistake: what is seen and proved, in one order. hints.py has the
words.

The line of an error is looked at as a syntax tree.
"""

import ast
import inspect
import io
import keyword
import linecache
import re
import sys
import tokenize
import traceback
from contextlib import suppress
from difflib import get_close_matches
from itertools import pairwise
from pathlib import Path

from grading.handout import FUNCTIONS, IMPORTS, is_students
from grading.hints import BOTH_VERSIONS, CONFLICT, ERRORS, FORMS, MEANING, NEWER, OTHER_FORMS


def words_for(error, result, wrong, code, function) -> str:
    """Return the words for a mistake: from the first evidence that there is.

    error is the StoppedError of the function, or None; result has the words for its exact result,
    and wrong is the sentence that says what is wrong. code is the function's.
    """
    return (
        of_parameters(code.parameters, function, error)  # the check's own call does not fit
        # Python raised an error: its type, its own attributes, the line's tree
        or (error and error.hint)
        or result  # the exact result of a known mistake
        or (error and error.meaning)
        or next((words for pattern, words in FORMS.values() if re.search(pattern, wrong)), "")
    )


def of_parameters(parameters, function, error) -> str:
    """Return the words for a line def that has other parameters than the handout."""
    own, given = parameters.split(", "), FUNCTIONS[function].parameters.split(", ")
    is_moved = sorted(own) == sorted(given) and own != given
    is_unfit = (
        error
        and error.kind == "TypeError"
        and not error.places
        and f"{function}()" in (error.text or "")
    )
    return (
        f"The line def has changed. It must be: def {function}({', '.join(given)}):"
        if is_moved or is_unfit
        else ""
    )


def nearest_name(error) -> str:
    """Return which name is nearest to one that does not exist, in the words of Python 3.12, or ""."""
    name, names = getattr(error, "name", None) or "", []
    if isinstance(error, NameError) and error.__traceback__:
        frame = [frame for frame, _ in traceback.walk_tb(error.__traceback__)][-1]
        names = [*frame.f_locals, *frame.f_globals]
    elif isinstance(error, AttributeError):
        names = dir(error.obj)
    lower = {each.lower(): each for each in reversed(names)}
    near = get_close_matches(name.lower(), lower, n=1, cutoff=0.8)
    return f". Did you mean: '{lower[near[0]]}'?" if near else ""


class Evidence:
    """What an error says of itself, and what is in the line of the student's that raised it."""

    def __init__(self, error, frame, line):
        self.error, self.frame = error, frame
        self.text = str(error.msg if isinstance(error, SyntaxError) else error)
        nodes = nodes_of(frame, line) if frame else []
        self.function = frame.f_code.co_name if frame else ""
        key = (
            f"{error.args[0]}"
            if isinstance(error, KeyError) and error.args
            else getattr(error, "filename", None)
        )
        # If the error itself has no name
        quoted = re.search(r"(?:name|variable|attribute) '(\w+)'", self.text)
        self.name = str(getattr(error, "name", None) or key or (quoted[1] if quoted else ""))
        self.file = self.name.replace(".", "/") + ".py"
        brackets = [node for node in nodes if isinstance(node, ast.Subscript)]
        self.in_brackets = any(getattr(node.slice, "id", "") == self.name for node in brackets)
        self.has_map = any(
            getattr(node.value, "id", "") in ("COLOR_MAP", "TEXTURE_MAP") for node in brackets
        )
        self.adds = any(isinstance(getattr(node.slice, "op", None), ast.Add) for node in brackets)
        parts = [node for node in nodes if isinstance(node, ast.Attribute)]
        self.behind_dot = next(
            (one.attr for one in parts if getattr(one.value, "id", "") == self.name), ""
        )
        loops = [node.iter for node in nodes if isinstance(node, ast.For)]
        values = [frame.f_locals.get(getattr(one, "id", "")) for one in loops] if frame else []
        self.goes_through_dictionary = any(isinstance(value, dict) for value in values)
        self.globals = frame.f_globals if frame else {}
        self.nearest = nearest_name(error)
        self.texts = [node.value for node in nodes if isinstance(node, ast.Constant)]
        self.is_taken = frame is not None and callable(frame.f_globals.get(self.name))
        self.is_given = (
            self.function in FUNCTIONS
            and self.name in IMPORTS[FUNCTIONS[self.function].file].split()
        )

    @property
    def other_form(self) -> str:
        """What the file is that Python cannot read, if it is no Python."""
        with suppress(OSError, TypeError):
            text = (
                Path(self.error.filename)
                .read_text(encoding="utf-8", errors="replace")
                .lstrip("\ufeff \n\t")
            )
            if any(line.startswith(CONFLICT) for line in text.splitlines()):
                return BOTH_VERSIONS
            compact = "".join(text[:100].split())
            return next(
                (words for begin, words in OTHER_FORMS.items() if compact.startswith(begin)), ""
            )
        return ""

    @property
    def newer(self) -> str:
        """What in the line only a newer Python reads."""
        line, own = (self.error.text or "").strip(), f"{sys.version_info[0]}.{sys.version_info[1]}"
        for version, pattern, words in NEWER:
            if sys.version_info < version and re.search(pattern, line):
                return f"Python {version[0]}.{version[1]} and later ones read {words}. This is Python {own}."
        return ""

    @property
    def takes(self) -> str:
        """Which values the function takes that was called with others, if the student's code knows
        it.
        """
        name = self.text.partition("(")[0].rpartition(".")[2]
        called = {**self.frame.f_globals, **self.frame.f_locals}.get(name) if self.frame else None
        with suppress(TypeError, ValueError):
            names = [*inspect.signature(called).parameters]
            if len(names) == 1:
                return f"{name} takes 1 value: {names[0]}."
            return f"{name} takes {len(names)} values, in this order: {', '.join(names)}."
        return ""

    @property
    def tokens(self) -> list[str]:
        """The names, numbers and signs of a line that Python cannot read."""
        found: list[str] = []
        with suppress(tokenize.TokenError, SyntaxError):
            for token in tokenize.generate_tokens(
                io.StringIO((self.error.text or "").strip()).readline
            ):
                if token.type in (tokenize.NAME, tokenize.NUMBER, tokenize.OP):
                    found.append(token.string)
        return found if self.text.startswith("invalid syntax") else []

    @property
    def side_by_side(self) -> tuple:
        """Two values without a sign between them; between for and in, this is another mistake."""
        for one, other in pairwise(self.tokens) if self.tokens[:1] != ["for"] else ():
            if (
                not {one, other} & {*keyword.kwlist}
                and other[0].isalnum()
                and (one[-1].isalnum() or one in ")]")
            ):
                return one, other
        return ()

    @property
    def misspelled(self) -> tuple:
        """The first word of the line, and the word of Python that it may be, if it stands before
        another name.
        """
        first = self.tokens[:1] if self.tokens[:2] == [*self.side_by_side] else []
        near = get_close_matches(first[0].lower(), keyword.kwlist, n=1, cutoff=0.7) if first else []
        return (first[0], near[0]) if near else ()


def of_error(error, frames, function) -> tuple[str, str]:
    """Return the words for an error of Python in a function, and what it means.

    frames are the student's (frame, line) pairs that it has passed. What the function calls is
    right.
    """
    own = [i for i, (frame, _) in enumerate(frames) if is_students(frame.f_code.co_name, function)]
    if own and own[-1] + 1 < len(frames) and not isinstance(error, FileNotFoundError):
        code = frames[own[-1] + 1][0].f_code
        given = ", ".join(code.co_varnames[: code.co_argcount])
        return (
            "",
            f"This line calls {code.co_name} with a value that it cannot use. It takes, in this order: {given}.",
        )
    seen = Evidence(error, *(frames[-1] if frames else (None, 0)))
    meaning = next((words for kind, words in MEANING.items() if isinstance(error, kind)), "")
    if isinstance(error, SyntaxError) and seen.text != "invalid syntax":
        meaning = ""  # Python says it better
    for kinds, pattern, test, words in ERRORS.values():
        found = isinstance(error, kinds) and re.search(pattern, seen.text)
        if found and (test is None or test(seen)):
            return words.format(*found.groups(), name=seen.name, seen=seen), ""
    return "", meaning.format(name=seen.name)


def nodes_of(frame, line) -> list:
    """Return the nodes of the innermost statement at a frame's line (of a block, its first line),
    outer ones first.
    """
    nodes = [*ast.walk(ast.parse("".join(linecache.getlines(frame.f_code.co_filename))))]
    around = [
        node
        for node in nodes
        if isinstance(node, ast.stmt) and node.lineno <= line <= node.end_lineno
    ]
    if not around:
        return []
    first, last = (
        (line, line) if hasattr(around[-1], "body") else (around[-1].lineno, around[-1].end_lineno)
    )
    return [node for node in nodes if first <= getattr(node, "lineno", 0) <= last]
