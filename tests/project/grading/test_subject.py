"""A student's file that Python cannot read: what pytest says about it."""

import pytest
from programs import slow_except
from students import change, COLUMNS, pytest_in, write

from grading.assignment import FUNCTIONS
from grading.raised import StoppedError

CIRCLE = "from src.visualize_cradle_run import handle_two_bobs"
FILE = "src/swinging.py"
# A line above the imports of the file, and what pytest prints about it
BROKEN = {
    "x = (1": "x = (1 ^ SyntaxError: '(' was never closed",
    CIRCLE: f"{CIRCLE} ImportError: cannot import name 'full_swing_update' from partially "
    "initialized module 'src.swinging' (most likely due to a circular import) ({}) Your files "
    "import each other in a circle. Remove the import in this file.",
    "(lambda: 1 / 0)()": "(lambda: 1 / 0)() ZeroDivisionError: division by zero This line stands "
    "outside of all functions, so it runs whenever Python reads the file. Remove it.",
}


@pytest.mark.parametrize("line", slow_except([*BROKEN][:2], BROKEN))
def test_of_a_file_that_python_cannot_read_pytest_says_this_and_the_grade(starter, line):
    """One check fails, and no function is named above the grade."""
    write(starter, *FUNCTIONS)
    change(starter / FILE, "\nfrom support", f"{line}\nfrom support")
    status, (_, title, *rows) = pytest_in(starter)
    assert status == 1
    end = rows.index(f"{' Grade ':=^{COLUMNS}}")
    message = f"{FILE}, line 7: {BROKEN[line]}".format(starter / FILE)
    found = f"{title.strip('_ ')}: {''.join(rows[:end])}"
    assert found.replace(" ", "") == message.replace(" ", "")  # wrapped at 80 columns
    assert "C             0 of 6 points: 1 failed, 5 wait for src/swinging.py" in rows
    assert "A            12 of 12 points" in rows  # the other files are judged without it
    assert rows[-1].startswith("1 failed, ")


def test_a_file_that_lacks_a_function_is_the_one_to_mend():
    """The file that imports the function is right."""
    error = ImportError("cannot import name 'angle_update' from 'src.swinging'")
    assert StoppedError(error, "", "").culprit == FILE
