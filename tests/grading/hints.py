"""What is known about an error of Python's: facts of its file, its line and the handout.

What the values were at the error stands in the table of the code.
"""

import linecache
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from types import FrameType
from typing import Any

from grading.handout import FUNCTIONS, IMPORTS, is_students, PROGRAM

KEYS = "mass", "e", "theta", "omega", "color", "texture", "objects"
PARTS = "axle", "bob", "cord", "pos", "radius", "axis"
TUPLE = "The bob is in the tuple objects of a pendulum: axle, bob, cord = pend['objects']."

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
# A kind of error, a pattern of Python's own text, and the hint; the first one that fits is taken.
# A row is a line:
# fmt: off
ROWS: list[tuple[Any, str, str]] = [
    (SyntaxError, "invalid non-printable character", "A character that you cannot see stands at the mark. Delete it, and type a space if one belongs there."),
    (SyntaxError, "invalid character", "Python reads this character only in comments and in quotes. Type quotes, a minus or a comma on your keyboard. In Python, * multiplies, and ** is a power."),
    ((SyntaxError, ValueError), "null bytes|codec can't decode", "This file is not saved in UTF-8. Save it with the encoding UTF-8."),
    (SyntaxError, r"indent|'return' outside|\btabs?\b", "The lines of a function begin with four spaces, those of a loop or an if in it with four more."),
    (SyntaxError, "^invalid syntax$", "Python cannot read this line, or the one above it. Look at its signs, words and brackets: one is missing, or does not belong."),
    (TypeError, r"for \^", "In Python, ** is a power, and ^ is something else."),
    (ImportError, "circular import", "Your files import each other in a circle. Remove the import in this file."),
    (RecursionError, "", "Your function calls itself, without end."),
    (NameError, "is not defined", "No line that ran has given this name a value. A name comes from the def line, from a line above, or from an import."),
    (IndexError, "", "The first element has the index 0, the last one the length minus 1."),
    (FileNotFoundError, "", "There is no such file. The parameter has the path of the file to read; in the program, NC_FP has it."),
    (ZeroDivisionError, "", "The value behind / is 0 here."),
]
# fmt: on


def of_error(error: BaseException, frames: list[tuple[FrameType, int]], function: str) -> str:
    """Return what is known about an error of Python's in a function, or "".

    frames are the student's (frame, line) pairs that it has passed. A called function of the
    handout is right.
    """
    last = last_of_student(frames, function)
    if last + 1 < len(frames) and last >= 0 and not isinstance(error, FileNotFoundError):
        code = frames[last + 1][0].f_code
        names = ", ".join(code.co_varnames[: code.co_argcount])
        call = f"This line calls {code.co_name} with a value that it cannot use."
        return f"{call} It takes, in this order: {names}."
    text = str(error.msg if isinstance(error, SyntaxError) else error)
    hints = [other_form(error)] if isinstance(error, SyntaxError) else []
    hints += facts_of(error, text, *(frames[-1] if frames else (None, 0)))
    for kinds, pattern, hint in ROWS:
        if isinstance(error, kinds) and re.search(pattern, text):
            hints.append(hint)
    return next(filter(None, hints), "")


def facts_of(error: Any, text: str, frame: FrameType | None, line: int) -> Iterator[str]:
    """Yield what is known from the file and the line of an error, each fact or ""."""
    code = (getattr(error, "text", None) or "").strip()
    if frame and not code:
        code = linecache.getline(frame.f_code.co_filename, line).strip()
    name = f"{getattr(error, 'name', None) or ''}"
    if isinstance(error, KeyError) and error.args:
        name = f"{error.args[0]}"
    if isinstance(error, NameError) and frame:
        yield key_or_import(name, code, frame)
    if isinstance(error, KeyError) and name in PARTS or "'tuple' object has no attribute" in text:
        yield TUPLE
    key = re.search(r"'dict' object has no attribute '(\w+)'", text)
    if key and key[1] in KEYS:
        yield f"A dictionary needs brackets and quotes, not a dot: ['{key[1]}']."
    method = re.match(r"(\w+)\.(\w+)\(\) takes", text)
    if isinstance(error, TypeError) and method and frame:
        yield without_self(frame.f_globals.get(method[1]), method[2])
    if isinstance(error, ModuleNotFoundError):
        if any(function.file == f"src/{name}.py" for function in FUNCTIONS.values()):
            yield f"Write src. in front of the file in the import: src.{name}."
        yield f"There is no module {name} for this Python. The imports of the file are enough."


def other_form(error: Any) -> str:
    """Return what a file is that Python cannot read, if it is no Python, and what to do, or ""."""
    found = ""
    with suppress(OSError, TypeError):
        source = Path(error.filename).read_text(encoding="utf-8", errors="replace")
        text = source.lstrip("\ufeff \n\t")
        compact = "".join(text[:100].split())
        for start, form in OTHER_FORMS.items():
            if compact.startswith(start):
                found = form
        if any(line.startswith(CONFLICT) for line in text.splitlines()):
            found = BOTH_VERSIONS
    return f"This file is no Python: it is {found}." if found else ""


def key_or_import(name: str, code: str, frame: FrameType) -> str:
    """Return a sentence about a name that is a key, or that the handout's file imports, or ""."""
    if name in KEYS and f"[{name}]" in code:
        return f"A key is text. Write it in quotes: ['{name}']."
    function = frame.f_code.co_name
    if function == "<module>":
        function = PROGRAM
    imported = IMPORTS[FUNCTIONS[function].file].split() if function in FUNCTIONS else []
    if name in imported and name not in frame.f_globals:
        source = "comes from another file, or from a package"
        return f"The name {name} {source}. Put its import back, at the top of the file."
    return ""


def without_self(owner: Any, name: str) -> str:
    """Return a sentence about a method of a class that has no self, or ""."""
    code = getattr(getattr(owner, name, None), "__code__", None)
    if not code or "self" in code.co_varnames[: code.co_argcount]:
        return ""
    return f"The def line of {name} has no self: Python gives the object as the first value."


def last_of_student(frames: list[tuple[FrameType, int]], function: str) -> int:
    """Return the index of the last frame in a function that the student wrote, -1 without one."""
    found = -1
    for i, (frame, _) in enumerate(frames):
        if is_students(frame.f_code.co_name, function):
            found = i
    return found
