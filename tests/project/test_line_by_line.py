"""A wrong call, line by line: the trace table of the student's code, and the sentences below it."""

from textwrap import dedent

import pytest
from graded import failures, outcomes_of
from line_facts import FACTS
from line_rows import ROWS
from programs import slow_except
from right_solutions import PLAIN, RIGHT
from wrong_solutions import WRONG

from grading import limits
from grading.grader import runner
from grading.instrument import watched
from grading.outcomes import PASSED
from grading.watch import Watch


def explained(solve, function, version):
    """Return the first failure of a wrong solution, and its tables as a text with single spaces."""
    solve(function, version)
    first = failures(function)[0]
    text = ""
    for row in first.rows:
        text += " ".join(row.lines) + " "
    return first, " ".join(text.split())


@pytest.mark.parametrize("name", ROWS)
def test_the_rows_say_what_each_line_gave(solve, name):
    function, version, rows = ROWS[name]
    _, found = explained(solve, function, version)
    assert [row for row in rows if row not in found] == [], found


@pytest.mark.parametrize("name", FACTS)
def test_a_sentence_says_where_the_value_in_question_comes_from(solve, name):
    function, version, line, fact = FACTS[name]
    first, _ = explained(solve, function, version)
    if fact:
        assert fact in first.facts
    else:
        assert "was set" not in " ".join(first.facts)
    assert first.place.endswith(f", line {line}")


WATCHED = [(name, way) for name in PLAIN for way in ("plainly", *RIGHT[name])]


@pytest.mark.parametrize(("function", "way"), slow_except(WATCHED[::4], WATCHED))
def test_a_watched_function_does_what_it_does_unwatched(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    watch = Watch()
    with watched(function, watch):
        outcomes = outcomes_of(function, users=False)
    assert {outcome.state for outcome in outcomes.values()} == {PASSED}
    assert watch.calls


HARMLESS = f"""\
'A docstring about sin, cos, round and return.'
# {" ".join(PLAIN)}: R_PARAM, THETA_INIT, DT and G are constants; pend_list[i + 1] == append = while
print(1.05, "and never")
"""


@pytest.mark.parametrize(("function", "words"), slow_except([*WRONG][::9], WRONG))
def test_harmless_lines_change_no_word(solve, function, words):
    version = WRONG[function, words]
    source = dedent(version if isinstance(version, str) else PLAIN[function].replace(*version))
    outcomes = []
    for lines in ("\n" * HARMLESS.count("\n"), HARMLESS):
        first, rows = explained(solve, function, lines + source)
        outcomes.append([first.hint, first.wrong, rows, first.facts])
    assert outcomes[0] == outcomes[1]


def test_an_endless_loop_is_shown_at_its_line_and_its_prints_appear_once(
    solve, monkeypatch, capsys
):
    monkeypatch.setattr(limits, "PATIENCE", 0.5)
    body = f"""\
        print('begin')
        i = 0
        while i < 3:
            j = i{" + abs(-1)" * 7}
        return i, j"""
    _, rows = explained(solve, "angle_update", body)
    line = "4 while i < 3: 0 < 3 True, in each turn (1000 turns) <- still here after 1000 turns"
    assert line in rows
    assert "6 return i, j (never ran)" in rows
    assert capsys.readouterr().out == "begin\n"


def test_a_call_that_gives_something_else_the_second_time_has_no_table(solve):
    first, _ = explained(solve, "angle_update", "import random; return random.random(), theta")
    assert (first.rows, first.facts) == ([], [])


def test_under_a_debugger_there_is_no_table(solve, monkeypatch):
    monkeypatch.setattr(limits, "is_debugged", lambda: True)
    first, _ = explained(solve, "angle_update", "return 1, 1")
    assert (first.rows, first.facts) == ([], [])


def test_with_no_room_the_lines_that_matter_stay(solve):
    others = "".join(f"    a{i} = {i}\n" for i in range(20))
    first, _ = explained(solve, "angle_update", f"w = 5\nif True:\n{others}return w, theta")
    ranks = {row.lines[0].split()[1]: row.rank for row in first.rows}
    assert ranks["w"] < ranks["a0"]


ODD = """\
class Odd:
    def __eq__(self, other): raise ValueError
    __hash__ = None
    def __bool__(self): raise ValueError
    def __repr__(self): raise ValueError
    def __getattr__(self, name): raise ValueError
odd = Odd()
row = {1: odd}
row[2] = [odd] * 9
{}
return odd, row"""


@pytest.mark.parametrize(
    "line", ["if row[1] is odd: pass", "row[1] == 5", "if odd: pass", "odd.x", "def f(a=odd): pass"]
)
def test_values_that_say_nothing_of_themselves_change_nothing(solve, line):
    """The table is there, and the failure is that of the student's code."""
    first, rows = explained(solve, "angle_update", ODD.replace("{}", line))
    assert rows
    assert "fault" not in first.message


def test_nothing_is_left_of_the_watch(solve):
    first, _ = explained(solve, "angle_update", "return 1, 1")
    function = runner.find("angle_update")
    assert first.rows
    assert "__watch__" not in function.__globals__
    assert "__watch__" not in function.__code__.co_names
