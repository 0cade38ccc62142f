"""A student's file that Python cannot read: what pytest says about it."""

import pytest
from programs import slow_except
from students import change, pytest_in, write

from grading.handout import FUNCTIONS
from grading.hints import of_error
from support.start.other_tools import of_other_tool

CIRCLE = "from src.visualize_cradle_run import handle_two_bobs"
MAIN = 'if __name__ == "__main__":\n    from'
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
    "a call of main": (
        "src/visualize_cradle_run.py",
        MAIN,
        f"main(5)\n{MAIN}",
        "src/visualize_cradle_run.py, line {}: main(5) AttributeError: 'int' object has no "
        "attribute 'csv' This line stands outside of all functions, so it runs when Python reads "
        "the file. Remove it.",
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


WEB = "This line is for Web VPython (GlowScript). Delete it."
NOTEBOOK = "This line is for a notebook (Jupyter, Colab). Delete it."
TERMINAL = "This line is a command for a terminal. Delete it."
PROMPT = "{} is a prompt, and no part of a program. Delete it in front of each line."
OTHER_TOOLS = {
    "Web VPython 3.2": WEB,
    "GlowScript 3.0 RapydScript": WEB,
    "!pip install vpython": NOTEBOOK,
    "    %matplotlib inline": NOTEBOOK,
    "%%writefile swinging.py": NOTEBOOK,
    "get_ipython().system('ls')": NOTEBOOK,
    "pip install vpython": TERMINAL,
    "(base) ann@laptop:~$ python src/swinging.py": TERMINAL,
    ">>> x = 1": PROMPT.format(">>>"),
    "...     return x": PROMPT.format("..."),
    "   ...:     return x": PROMPT.format("...:"),
    "In [1]: x = 1": PROMPT.format("In [1]:"),
    "```python": "``` marks code in a chat or a web page. Delete this line.",
    "x = !found": "",
    "pip = omega dt": "",
    "Python stands here": "",
}


@pytest.mark.parametrize("line", OTHER_TOOLS)
def test_a_line_of_another_tool_is_named(line):
    assert of_other_tool(line) == OTHER_TOOLS[line]
