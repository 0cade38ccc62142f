"""A student's file that Python cannot read: what pytest says about it."""

import pytest
from programs import slow_except
from students import change, pytest_in, write

from grading.handout import FUNCTIONS
from grading.hints import of_error

CIRCLE = "from src.visualize_cradle_run import handle_two_bobs"
# A file, an old and a new text in it, and all that pytest prints about it: {} is the line
BROKEN = {
    "a bracket": (
        "src/special_cradles.py",
        "r_param/5, 0)",
        "r_param/5, 0",
        "src/special_cradles.py, line {}: axle_pos = vector((-0.1 + r_param/4 * i), r_param/5, 0 "
        "^ SyntaxError: '(' was never closed",
    ),
    "a circle": (
        "src/swinging.py",
        "from support.p",
        f"{CIRCLE}\nfrom support.p",
        f"src/swinging.py, line {{}}: {CIRCLE} ImportError: cannot import name 'full_swing_update' "
        "from partially initialized module 'src.swinging' (most likely due to a circular import) "
        "({file}) Your files import each other in a circle. Remove the import in this file.",
    ),
    "a call": (
        "src/visualize_cradle_run.py",
        "def handle_two_bobs",
        "full_swing_update(7, 1, 1, 1)\n\n\ndef handle_two_bobs",
        "src/visualize_cradle_run.py, line {}: full_swing_update(7, 1, 1, 1) TypeError: 'int' "
        "object is not iterable This line stands outside of all functions, so it runs whenever "
        "Python reads the file. Remove it, or put it below if __name__ == '__main__'.",
    ),
}


@pytest.mark.parametrize("name", slow_except(["a bracket", "a circle"], BROKEN))
def test_of_a_file_that_python_cannot_read_pytest_says_nothing_but_this(starter, name):
    """One check fails, and no function is named. Also if a thread of the solution does not end."""
    file, old, new, message = BROKEN[name]
    write(starter, *FUNCTIONS)
    with (starter / "src/pds_helper.py").open("a") as source:
        source.write("import threading\nthreading.Thread(target=threading.Event().wait).start()\n")
    number = (starter / file).read_text().partition(old)[0].count("\n") + 1
    change(starter / file, old, new)
    status, (_, title, *rows, last) = pytest_in(starter)
    assert status == 1
    message = message.format(number, file=starter / file)
    found = f"{title.strip('_ ')}: {''.join(rows)}"
    assert found.replace(" ", "") == message.replace(" ", "")  # wrapped at 80 columns
    assert last.startswith("1 failed, ")


NO_PYTHON = {  # the content of a file, and the hint
    "<!DOCTYPE html>\n<html>": "This file is no Python: it is a web page.",
    "{\\rtf1 def": "This file is no Python: it is a text of a word processor (RTF).",
    "x = 1\n<<<<<<< HEAD\nx = 2\n=======\n": "This file is no Python: it is two versions",
}


@pytest.mark.parametrize("content", NO_PYTHON)
def test_a_file_that_is_no_python_is_named_as_what_it_is(tmp_path, content):
    file = tmp_path / "swinging.py"
    file.write_text(content)
    with pytest.raises(SyntaxError) as raised:
        compile(content, file, "exec")
    assert of_error(raised.value, [], "").startswith(NO_PYTHON[content])
