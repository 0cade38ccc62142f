"""What functions did, line by line. No course is needed for it."""

import linecache
import re
import sys
from contextlib import suppress
from textwrap import dedent
from unittest.mock import Mock

import pytest
from programs import python, ROOT

from line_by_line.table import fitting, Row, rows_of, Wanted
from line_by_line.trace import Trace
from line_by_line.words import Words

FILE = "lists.py"
HEAD = "    def first(a):\n"
# The lines below HEAD; a is [[1], [2]]. A comment has the values of a row, or the call of a helper.
# A line without a comment has no row. Wrong are a[1][0] and 2.5.
ROWS = {
    "values": """\
     s = Shelf(0.1 + 0.2)  # s = Shelf(n=0.3)
     a[1][0] = half(4) + s.n  # a[1][0] = 2.3 half(n=4) gives 2
     b = {}  # b = {}
     b["n"] = s.add(a.pop())  # b["n"] = None, s.n = 2.3, a = [[1]]
     b["s"] = s  # b["s"] = Shelf(n=2.3)
     o = s  # o = s, Shelf(n=2.3)
    class Shelf:
     def __init__(self, n):  # Shelf.__init__(n=0.3)
      self.n = n  # self.n = 0.3
     def add(self, more):  # Shelf.add(more=a[1])
      self.n = self.n  # self.n = 0.3
      self.n += 2  # self.n = 2.3
    def half(n): return n / 2""",
    "conditions": """\
     n = iter(a)  # n = a list_iterator
     def unused():
      return n
     if [1] in n:  # True
      n = 3  # n = 3
     if n < 3 or n:  # 3 < 3 or 3: True
      n = (  #! n = n + 2 n = 5
       n + 2)
     w, x, y, z = 1, 2, 3, 4  # w = 1, x = 2, y = 3, ...
     b = {}  # b = {}
     b[0] = half(14)  # b[0] = 7 half(n=14)
     if not n < 5 and n < 5:  # not 5 < 5 and 5 < 5: False
      n = 1  # (never ran)
     elif round(n) == a.pop(): n = 1  # 5 == a.pop(), a = [[1]]
    def half(n): return n / 2""",
    "turns": """\
     one() or two()  #
     for i in range(9):  # i = 0 | 1 | ... | 8
      put(a[i < 7], i)  # a[1][0] = 0 | a[1][0] = 1 | ... | a[1][0] = 6 | ... | a[0][0] = 8
      n = 0  # n = 0, 9 times
    def put(b, i):  # put(b=a[1], i=6)
     b[0] = i  # b[0] = 6
    def one():  # one()
     return 0  # gives 0
    def two():
     return 2""",
    "errors": """\
     try:
      n = 6 / 0  # stopped: ZeroDivisionError
     except ZeroDivisionError:
      n = 6  # n = 6
     fail(n)  # <- stops here: TypeError
    def fail(n):  # fail(n=6)
     return n * None  # <- stops here: TypeError""",
    "functions": """\
     b = [*map(lambda n: n / 1, [n for [n] in a])]  # b = [1, 2]
     c = Pool().submit(list, more([8])).result()  # c = [8.5]
     return [*more(b)]  # gives [1.5, 2.5]
    from concurrent.futures import ThreadPoolExecutor as Pool
    def each(f):
     def of(all):  # of(all=b)
      for n in all:  # n = 1 | 2
       yield f(n)  # gives 1.5 | gives 2.5
     return of
    @each
    def more(n):  # more(n=2)
     return n + 0.5  # gives 2.5""",
    "900 calls": """\
     return len(a) < 900 and first([*a, 1])  # gives False""",
    "no end": """\
     return first(a)  # <- stops here: RecursionError""",
    "100,000 turns": """\
     one()  #
     for i in range(100_000): pass  # i = 0 | 1 | ... | 9995 <- not watched further
     return i  #
    def one():  # one()
     return 1  # gives 1""",
}


def expected_words(source):
    """Return the words of the rows that the comments of a source want."""
    words = []
    for number, line in enumerate(source.splitlines(), 2):
        code, has_row, values = line.partition("#")
        row = f"{number} {code} {values}"
        if values.startswith("!"):  # the code is written in another form
            row = f"{number} {values[1:]}"
        if "def " in code:
            row = f"Your function{values}, called there:"
        if has_row:
            words += row.split()
    return words


def trace_of(source, a):
    """Return the Trace of a call of the first function."""
    source = dedent(HEAD + re.sub("#.*", "", source))
    linecache.cache[FILE] = len(source), None, source.splitlines(True), FILE
    scope = {"__name__": "lists"}
    exec(compile(source, FILE, "exec"), scope)
    trace = Trace(
        Words(),
        lambda code: code.co_filename == FILE and code.co_name != "half",
        lambda code: code.co_name == "half",
    )
    with suppress(Exception), trace.on():
        scope["first"](a)
    return trace


def rows_in(name):
    """Return the rows of one of ROWS."""
    a = [[1], [2]]
    key = id(a[1]), 0
    trace = trace_of(ROWS[name], a)
    assert trace.fault is None
    return rows_of(trace, Wanted({key}, {0}, lambda value: value == 2.5))


@pytest.mark.parametrize("name", ROWS)
def test_the_rows_say_what_each_line_did(name):
    lines, _ = fitting(rows_in(name), 99)
    assert " ".join(lines).split() == expected_words(ROWS[name])


@pytest.mark.parametrize(
    ("name", "height", "kept"),
    [
        ("values", 4, "2 3 7"),
        ("conditions", 4, "2 12 14 15"),
        ("turns", 5, "4 5 7"),
        ("errors", 1, "6 8"),
        ("functions", 1, ""),
        ("functions", 4, "9 13"),
    ],
)
def test_left_out_are_helpers_then_what_is_not_like_the_wrong_value_from_the_middle(
    name, height, kept
):
    """What has set a wrong value, or has stopped, is never left out."""
    lines, _ = fitting(rows_in(name), height)
    assert re.findall(r"^ +(\d+)  ", "\n".join(lines), re.MULTILINE) == kept.split()


def test_a_row_becomes_shorter_before_it_is_left_out():
    assert fitting([Row(["1", "2", "3"], 2)], 2) == (["1", "2 ..."], 0)
    assert fitting([Row(["1"], 1), Row(["2"], 0)], 0) == (["2"], 1)


def test_a_fault_of_the_trace_is_not_the_functions(monkeypatch):
    fault = ZeroDivisionError()
    monkeypatch.setattr(Trace, "look_at", Mock(side_effect=fault))
    a = []
    assert trace_of("     a.append(3)", a).fault is fault
    assert a == [3]


def test_a_trace_function_that_was_there_before_works_on():
    """As of a debugger, or for the coverage of tests."""
    before, other = sys.gettrace(), Mock()
    sys.settrace(other)
    try:
        trace_of("     return", [])
        assert sys.gettrace() is other
    finally:
        sys.settrace(before)


README = (ROOT / "tests/line_by_line/README.md").read_text(encoding="utf-8")


def test_the_readme_shows_what_its_lines_print(tmp_path):
    """For functions about books, with nothing but this package."""
    books, program, shown = map(dedent, re.findall(r"(?:    .*\n|\n(?=    ))+", README))
    (tmp_path / "books.py").write_text(books.lstrip())
    done = python("-c", program, folder=tmp_path, PYTHONPATH=f"{ROOT / 'tests'}")
    assert (done.stderr, dedent(done.stdout)) == ("", shown.lstrip("\n"))
