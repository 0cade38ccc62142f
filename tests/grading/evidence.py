"""The evidence for a hint: what an error says of itself, and what is in the line that raised it.

hints.py has the hints. The line of an error is looked at as a syntax tree.
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
from types import FrameType
from typing import Any

from grading.handout import FUNCTIONS, IMPORTS, is_students
from grading.hints import BOTH_VERSIONS, CONFLICT, ERRORS, MEANING, NEWER, OTHER_FORMS
from support.start.other_tools import of_other_tool

MAPS = "COLOR_MAP", "TEXTURE_MAP"


def nearest_name(error: BaseException) -> str:
    """Return which name is nearest to one that does not exist, as Python 3.12 says it, or ""."""
    name = getattr(error, "name", None) or ""
    names = []
    if isinstance(error, NameError) and error.__traceback__:
        frame = [frame for frame, _ in traceback.walk_tb(error.__traceback__)][-1]
        names = [*frame.f_locals, *frame.f_globals]
    elif isinstance(error, AttributeError):
        names = dir(error.obj)
    by_lower = {candidate.lower(): candidate for candidate in reversed(names)}
    near = get_close_matches(name.lower(), by_lower, n=1, cutoff=0.8)
    return f". Did you mean: '{by_lower[near[0]]}'?" if near else ""


def id_of(node: Any) -> str:
    """Return the name that a node of the syntax tree is, or ""."""
    return getattr(node, "id", "")


class Evidence:
    """What an error says of itself, and what is in the student's line that raised it."""

    def __init__(self, error: BaseException, frame: FrameType | None, line: int):
        """frame is the student's, None if no code of the student has run."""
        self.error: Any = error
        self.text = str(error.msg if isinstance(error, SyntaxError) else error)
        self.subject_name = self.found_subject_name()
        self.function = frame.f_code.co_name if frame else ""
        self.globals = frame.f_globals if frame else {}
        self.locals = frame.f_locals if frame else {}
        self.nearest = nearest_name(error)
        self.nodes = nodes_of(frame, line) if frame else []
        # The line that Python cannot read, or that raised the error
        self.code = (getattr(error, "text", None) or "").strip()
        if frame and not self.code:
            self.code = linecache.getline(frame.f_code.co_filename, line).strip()
        self.subscripts = [node for node in self.nodes if isinstance(node, ast.Subscript)]

    def found_subject_name(self) -> str:
        """Return the name, key or file that the error is about, or ""."""
        name = getattr(self.error, "name", None)
        if name:
            return str(name)
        key = getattr(self.error, "filename", None)
        if isinstance(self.error, KeyError) and self.error.args:
            key = f"{self.error.args[0]}"
        if key:
            return str(key)
        quoted = re.search(r"(?:name|variable|attribute) '(\w+)'", self.text)
        return quoted[1] if quoted else ""

    @property
    def module_file(self) -> str:
        """The file of the module that Python cannot find."""
        return self.subject_name.replace(".", "/") + ".py"

    @property
    def in_brackets(self) -> bool:
        """Whether the name stands in [ ]."""
        return any(id_of(node.slice) == self.subject_name for node in self.subscripts)

    @property
    def has_map(self) -> bool:
        """Whether the line looks something up in COLOR_MAP or TEXTURE_MAP."""
        return any(id_of(node.value) in MAPS for node in self.subscripts)

    @property
    def adds_in_brackets(self) -> bool:
        """Whether the line adds something in [ ]."""
        operations = [getattr(node.slice, "op", None) for node in self.subscripts]
        return any(isinstance(operation, ast.Add) for operation in operations)

    @property
    def behind_dot(self) -> str:
        """What stands behind the name and a dot, or ""."""
        for node in self.nodes:
            if isinstance(node, ast.Attribute) and id_of(node.value) == self.subject_name:
                return node.attr
        return ""

    @property
    def goes_through_dictionary(self) -> bool:
        """Whether a loop in the line takes its values from a dictionary."""
        loops = [node for node in self.nodes if isinstance(node, ast.For)]
        values = [self.locals.get(id_of(loop.iter)) for loop in loops]
        return any(isinstance(value, dict) for value in values)

    @property
    def constants(self) -> list:
        """The constants in the line."""
        return [node.value for node in self.nodes if isinstance(node, ast.Constant)]

    @property
    def is_name_of_function(self) -> bool:
        """Whether the name is that of a function outside of this one."""
        return callable(self.globals.get(self.subject_name))

    @property
    def is_imported_by_handout(self) -> bool:
        """Whether the handout's file of this function imports the name."""
        if self.function not in FUNCTIONS:
            return False
        return self.subject_name in IMPORTS[FUNCTIONS[self.function].file].split()

    @property
    def other_form_in_words(self) -> str:
        """What the file is that Python cannot read, if it is no Python, and what to do, or ""."""
        with suppress(OSError, TypeError):
            source = Path(self.error.filename).read_text(encoding="utf-8", errors="replace")
            text = source.lstrip("\ufeff \n\t")
            if any(line.startswith(CONFLICT) for line in text.splitlines()):
                return BOTH_VERSIONS
            compact = "".join(text[:100].split())
            for start, form in OTHER_FORMS.items():
                if compact.startswith(start):
                    return form
        return ""

    @property
    def other_tool_in_words(self) -> str:
        """A sentence that says for which other tool the line is, or ""."""
        return of_other_tool(self.code)

    @property
    def newer_python_in_words(self) -> str:
        """A sentence that says what in the line only a newer Python reads, or ""."""
        for version, pattern, form in NEWER:
            if sys.version_info < version and re.search(pattern, self.code):
                newer = f"Python {version[0]}.{version[1]} and later ones read {form}."
                return f"{newer} This is Python {sys.version_info[0]}.{sys.version_info[1]}."
        return ""

    @property
    def signature_in_words(self) -> str:
        """A sentence that says which values the function takes that was called with others.

        It is "" if this is not known.
        """
        name = self.text.partition("(")[0].rpartition(".")[2]
        function: Any = {**self.globals, **self.locals}.get(name)
        with suppress(TypeError, ValueError):
            names = [*inspect.signature(function).parameters]
            if len(names) == 1:
                return f"{name} takes 1 value: {names[0]}."
            return f"{name} takes {len(names)} values, in this order: {', '.join(names)}."
        return ""

    @property
    def tokens(self) -> list[str]:
        """The names, numbers and signs of a line that Python cannot read."""
        if not self.text.startswith("invalid syntax"):
            return []
        found: list[str] = []
        with suppress(tokenize.TokenError, SyntaxError):
            for token in tokenize.generate_tokens(io.StringIO(self.code).readline):
                if token.type in (tokenize.NAME, tokenize.NUMBER, tokenize.OP):
                    found.append(token.string)
        return found

    @property
    def side_by_side(self) -> tuple:
        """Two values without a sign between them; between for and in, this is another mistake."""
        if self.tokens[:1] == ["for"]:
            return ()
        for left, right in pairwise(self.tokens):
            has_keyword = left in keyword.kwlist or right in keyword.kwlist
            ends_value = left[-1].isalnum() or left in ")]"
            if ends_value and right[0].isalnum() and not has_keyword:
                return left, right
        return ()

    @property
    def misspelled(self) -> tuple:
        """The first word of the line, and the word of Python that it may be.

        It stands before another name.
        """
        if not self.tokens or self.tokens[:2] != [*self.side_by_side]:
            return ()
        first = self.tokens[0]
        near = get_close_matches(first.lower(), keyword.kwlist, n=1, cutoff=0.7)
        return (first, near[0]) if near else ()


def of_error(
    error: BaseException, frames: list[tuple[FrameType, int]], function: str
) -> tuple[str, str]:
    """Return the hint for an error of Python in a function, and what the error means.

    frames are the student's (frame, line) pairs that it has passed. A called function of the
    handout is right.
    """
    last = last_of_student(frames, function)
    if last + 1 < len(frames) and last >= 0 and not isinstance(error, FileNotFoundError):
        code = frames[last + 1][0].f_code
        names = ", ".join(code.co_varnames[: code.co_argcount])
        call = f"This line calls {code.co_name} with a value that it cannot use."
        return "", f"{call} It takes, in this order: {names}."
    frame, line = frames[-1] if frames else (None, 0)
    evidence = Evidence(error, frame, line)
    for row in ERRORS.values():
        if not isinstance(error, row.kinds) or not re.search(row.pattern, evidence.text):
            continue
        if row.fits is None or row.fits(evidence):
            return row.hint.format(name=evidence.subject_name, evidence=evidence), ""
    if isinstance(error, SyntaxError) and evidence.text != "invalid syntax":
        return "", ""  # Python says it better
    for kind, meaning in MEANING.items():
        if isinstance(error, kind):
            return "", meaning.format(name=evidence.subject_name)
    return "", ""


def last_of_student(frames: list[tuple[FrameType, int]], function: str) -> int:
    """Return the index of the last frame in a function that the student wrote, -1 without one."""
    found = -1
    for i, (frame, _) in enumerate(frames):
        if is_students(frame.f_code.co_name, function):
            found = i
    return found


def nodes_of(frame: FrameType, line: int) -> list:
    """Return the nodes of the innermost statement at a frame's line, outer ones first.

    Of a block, these are the nodes of its first line.
    """
    nodes: list[Any] = [*ast.walk(ast.parse("".join(linecache.getlines(frame.f_code.co_filename))))]
    statements: list[Any] = [node for node in nodes if isinstance(node, ast.stmt)]
    around = [node for node in statements if node.lineno <= line <= node.end_lineno]
    if not around:
        return []
    innermost = around[-1]
    if hasattr(innermost, "body"):
        first = last = line
    else:
        first, last = innermost.lineno, innermost.end_lineno
    return [node for node in nodes if first <= getattr(node, "lineno", 0) <= last]
