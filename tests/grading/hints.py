"""What is known about an error of Python's, and Python does not say.

What the values were at the error stands in the table of the code.
"""

import linecache
import re
from pathlib import Path
from types import FrameType
from typing import Any

from grading.assignment import FUNCTIONS, GIVEN, IMPORTS, is_students

KEYS = "mass|e|theta|omega|color|texture|objects"
PARTS = "axle|bob|cord|pos|radius|axis"
FILES = "|".join({Path(function.file).stem for function in FUNCTIONS.values()})
TUPLE = "The bob is in the tuple objects of a pendulum: axle, bob, cord = pend['objects']."

# A kind of error, a pattern of Python's own text with the line of code below it, and the hint; \1
# in a hint is the group of the pattern. The first one that fits is taken. A row is a line:
# fmt: off
ROWS: list[tuple[Any, str, str]] = [
    (SyntaxError, "^invalid .*character", "Delete the character at the mark (you may not see it), and type what belongs there. In Python, * multiplies, and ** is a power."),
    ((SyntaxError, ValueError), "null bytes|codec can't decode", "This file is not saved in UTF-8. Save it with the encoding UTF-8."),
    (TypeError, "'(int|float)' object is not callable", "A number stands in front of the brackets, and a number is no function. To multiply, write *."),
    (TypeError, "cannot unpack non-iterable NoneType", "This function returns nothing. Call it without =."),
    (TypeError, "'int' object is not iterable", "A for loop goes through a list, or through range of a number."),
    (TypeError, "list indices must be integers or slices, not dict", "A for loop over a list gives its elements, not their numbers."),
    (TypeError, "'<=' not supported between instances of 'vector'", "mag gives the length of a vector: a number."),
    (AttributeError, "'str' object has no attribute 'x'", "COLOR_MAP has the vector for the name of a color."),
    (TypeError, r"for \^", "In Python, ** is a power, and ^ is something else."),
    (NameError, rf"name '({KEYS})' .*\n.*\[\1\]", r"A key is text. Write it in quotes: ['\1']."),
    (AttributeError, f"'dict' object has no attribute '({KEYS})'", r"A dictionary needs brackets and quotes, not a dot: ['\1']."),
    (AttributeError, "'tuple' object has no attribute", TUPLE),
    (KeyError, f"^KeyError: '({PARTS})'", TUPLE),
    (ImportError, "circular import", "Your files import each other in a circle. Remove the import in this file."),
    (ModuleNotFoundError, f"'({FILES})'", r"Write src. in front of the file in the import: src.\1."),
    (FileNotFoundError, "", "A check works in a folder of its own: relative_filepath has the path of the file to read (in the program: NC_FP)."),
]
# fmt: on


def of_error(
    error: BaseException, text: str, frames: list[tuple[FrameType, int]], function: str
) -> str:
    """Return what is known about an error of Python's in a function, or "".

    text is that of the error. frames are the student's (frame, line) pairs that it has passed.
    function is "" if the error stopped the import of a file.
    """
    if isinstance(error, SyntaxError):
        return hint_of_row(error, error.msg)
    call = wrong_call(frames, function)
    if call and not isinstance(error, FileNotFoundError):
        return call
    imported = IMPORTS.get(FUNCTIONS[function].file, "").split() if function else []
    if isinstance(error, NameError) and error.name in {*imported} - GIVEN:
        source = "comes from another file, or from a package"
        return f"The name {error.name} {source}. Put its import back, at the top of the file."
    code = ""
    if frames:
        frame, line = frames[-1]
        code = linecache.getline(frame.f_code.co_filename, line)
    return hint_of_row(error, f"{text}\n{code}")


def hint_of_row(error: BaseException, text: str) -> str:
    """Return the hint of the first row that fits an error and its text, or ""."""
    for kinds, pattern, hint in ROWS:
        found = re.search(pattern, text)
        if found and isinstance(error, kinds):
            return found.expand(hint)
    return ""


def wrong_call(frames: list[tuple[FrameType, int]], function: str) -> str:
    """Return a sentence about a student's call of a function of the handout that fails, or "".

    The called function is right, so its arguments are wrong.
    """
    last = -1
    for i, (frame, _) in enumerate(frames):
        if is_students(frame.f_code.co_name, function):
            last = i
    if last in (-1, len(frames) - 1):
        return ""
    code = frames[last + 1][0].f_code
    names = ", ".join(code.co_varnames[: code.co_argcount])
    call = f"This line calls {code.co_name} with a value that it cannot use."
    return f"{call} It takes, in this order: {names}."
