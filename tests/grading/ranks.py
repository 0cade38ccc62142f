"""The ranks of what a student reads about a mistake: the whole scale, in its order.

If there is no room for all, the highest ranks are left out.
"""

ALWAYS = -1  # stays without room, too: the sentence that says what is wrong

# Lines of a trace table that lead to the mistake
IN_QUESTION = 0  # a line with the mistake, or the one that has stopped
ONE_STEP = 1  # a line that sets what such a line uses
FACTS = 2  # no line: sentences about the call, and about what was seen
TWO_STEPS = 3  # a line from which two steps lead there; with each more step, one higher
MANY_STEPS = 10

# The other lines of the table
CALLS = 11  # they call functions
VALUES = 12  # they give values
NO_END = 13  # they never ran to their ends, or have none: try
IDLE = 14  # they only ran, or are in the handout

IN_WORDS = 15  # the steps of a function
IN_PYTHON = 16  # lines of Python, with books, that show what it needs
NEVER = 100  # is left out, with room, too


def rank_after(steps: int) -> int:
    """Return the rank of a line from which this number of steps leads to a line in question."""
    if steps == 0:
        return IN_QUESTION
    if steps == 1:
        return ONE_STEP
    return min(TWO_STEPS + steps - 2, MANY_STEPS)
