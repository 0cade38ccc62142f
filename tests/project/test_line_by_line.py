"""What functions did, line by line: here, functions about books. No course is needed for it."""

import linecache
import os
from textwrap import dedent

import pytest
from programs import python, ROOT

from line_by_line import words
from line_by_line.instrument import put_back, watched
from line_by_line.state import state_of
from line_by_line.table import rows_of
from line_by_line.watch import Watch
from line_by_line.words import Noun

BOOKS = [{"pages": 100}, {"pages": 50}, {"pages": 80}]


def functions_in(source, file="books.py"):
    """Return the functions of a source, by their names."""
    source = f"{dedent(source)}\n"
    linecache.cache[file] = len(source), None, source.splitlines(keepends=True), file
    scope = {"__name__": "books"}
    exec(compile(source, file, "exec"), scope)
    return {name: value for name, value in scope.items() if hasattr(value, "__code__")}


def watch_call(source, *arguments, index=None):
    """Call the first function of a source; return its Watch, and its rows with single spaces."""
    functions = [*functions_in(source).values()]
    watch = Watch()
    with watched(functions, watch):
        watch.begin(arguments)
        try:
            functions[0](*arguments)
        except Exception as error:
            watch.error = error
    first: dict = {}
    for call in watch.calls.values():
        first.setdefault(call.definition, call)
    rows = rows_of(watch, [*first.values()], index=index)
    return watch, " ".join(" ".join(" ".join(row.texts) for row in rows).split())


# The source, and a part of the rows; the first function gets BOOKS
ROWS = {
    "the turns in which a line ran": (
        """\
        def first(books):
            result = []
            for i in range(len(books)):
                if i == 1:
                    result.append(books[i])
                else:
                    result = result
            return result""",
        "3 for i in range(len(books)): 0 | 1 | 2 4 if i == 1: 0 == 1 False | 1 == 1 True | 2 == 1 "
        "False 5 result.append(books[i]) - | a list of 1 dictionary | - 7 result = result "
        "[ ], empty | - | a list of 1 dictionary 8 return result gives a list of 1 dictionary",
    ),
    "equal turns once": (
        """\
        def first(books):
            for book in books:
                book["price"] = price(book)
        def price(book):
            return 5""",
        '3 book["price"] = price(book) 5, in each turn turn 1: price got book = books[0]',
    ),
    "equal calls once": (
        """\
        def first(books):
            for book in books: total(books)
        def total(shelf): return shelf[0]["pages"]""",
        "total got shelf = books, a list of 3 dictionaries, in each turn",
    ),
    "a function of a name of its own": (
        """\
        def first(books):
            def half(x):
                return x / 2
            return half(books[0]["pages"])""",
        "gives 50 half got x = 100 Your function half, called there: 3 return x / 2 gives 50",
    ),
    "conditions with their values": (
        """\
        def first(books):
            found = []
            while not found and 2 > len(found) > -1:
                found.append(5)
            return found[0]""",
        "not [ ], empty and 2 > 0 > -1 True | not [5] False",
    ),
    "no turn, and the else of a loop": (
        """\
        def first(books):
            for i in range(0): g = i
            else: g = 7
            return g""",
        "2 for i in range(0): no turn 2 g = i (never ran) 3 g = 7 g = 7",
    ),
    "where it stopped, the values there, and who gave them": (
        """\
        def first(books):
            list = []
            if list: return 1
            print(5)
            return list(books)""",
        "5 return list(books) <- stops here: TypeError list is [ ], empty, a list: line 2 gave it "
        "this value; Python's own list has this name, too books is a list of 3 dictionaries",
    ),
    "a name that has no value yet": (
        """\
        def first(books):
            total = total + len(books)""",
        "books is a list of 3 dictionaries total has no value yet: line 2 gives it one, so total "
        "is a name of this function alone",
    ),
    "the keys of a dictionary that lacks one": (
        """\
        def first(books):
            return books[0]["price"]""",
        "stops here: KeyError the keys of books[0] are 'pages'",
    ),
    "a value that was not taken apart": (
        """\
        def first(books):
            a, b = books""",
        "stops here: ValueError the value is a list of 3 dictionaries",
    ),
    "the helper that stopped": (
        """\
        def first(books):
            for book in books: price(book)
        def price(book):
            b = None
            return b * book["pages"]""",
        "2 price(book) <- stops here: TypeError price got book = books[0] Your function price, "
        'called there: 4 b = None b = None 5 return b * book["pages"] <- stops here: TypeError '
        "b is None: line 4 gave it this value book['pages'] is 100",
    ),
    "an error that an except takes": (
        """\
        def first(books):
            try:
                a = 1 / 0
            except ZeroDivisionError:
                a = 0
            return a""",
        "3 a = 1 / 0 stopped: ZeroDivisionError 4 except ZeroDivisionError: line 3 stopped with "
        "ZeroDivisionError: division by zero; this except takes it",
    ),
    "an error that nobody told": (
        """\
        def first(books):
            from contextlib import suppress
            with suppress(Exception):
                a = 1 / 0
            return 1""",
        "4 a = 1 / 0 (did not come to its end)",
    ),
    "a call in a turn that an except ended is no call of the next turn": (
        """\
        def first(books):
            r = 0
            for i in range(2):
                try: r += part(i)
                except ZeroDivisionError: pass
        def part(x): return 6 / x""",
        "4 r += part(i) - | 6 turn 2: part got x = 1; it gave 6",
    ),
    "a long loop": (
        """\
        def first(books):
            for i in range(20000): a = i
            return a""",
        "turns: not watched further) 2 a = i 0 | 1 | ... |",
    ),
    "a value that is not stored": (
        """\
        def first(books):
            sorted([2, 1])""",
        "2 sorted([2, 1]) gives [1, 2], which is not stored",
    ),
    "an object that would answer otherwise if it was asked again": (
        """\
        def first(books):
            c = Count()
            c["x"] = 4
            return c.n
        class Count(dict):
            n = 0
            def __getitem__(self, key): self.n += 1""",
        "4 return c.n gives 0",
    ),
    "as much of a long line as there is room for, and a sign that it goes on": (
        f"""\
        def first(books):
            w = {" + ".join(["len(books)"] * 30)}""",
        "+ len(books) + ... w = 90",
    ),
}


@pytest.mark.parametrize("name", ROWS)
def test_the_rows_say_what_each_line_did(name):
    source, expected = ROWS[name]
    _, found = watch_call(source, [dict(book) for book in BOOKS])
    assert expected in found


def test_of_many_turns_some_are_shown_and_the_one_in_question():
    source = """\
        def first(books):
            for i in range(9): a = i + 0.25"""
    _, found = watch_call(source, BOOKS, index=5)
    assert "2 for i in range(9): 0 | 1 | ... | 5 | ... | 8 (9 turns)" in found


REMARKS = {
    "n = 7 // 2": "Line 2 cuts off the digits after the point: // gives 3, / gives 3.5.",
    "shelf = [{}] * 3": "Line 2 puts one dictionary in the list 3 times.",
    "books = books.sort(key=len)": "Line 2 stores None: books.sort gives nothing back.",
    "i = [{}, books[0], dict(books[0])].index(books[0])": None,
    "shelf = [books[0], dict(books[0])]; i = shelf.index(shelf[1])": (
        "Line 2 gets 0: index finds the first equal element. This one has 1."
    ),
    "n = 6 // 2; m = [1] * 3; books.sort(key=len)": None,
}


@pytest.mark.parametrize("line", REMARKS)
def test_what_few_expect_has_a_sentence(line):
    watch, _ = watch_call(f"def first(books):\n    {line}", [dict(BOOKS[0])])
    assert [*watch.remarks] == [remark for remark in [REMARKS[line]] if remark]


def test_an_interrupt_does_not_leave_other_code_in_the_functions():
    class Interrupted:
        __globals__: dict = {}
        codes: list = []

        def __setattr__(self, name, code):
            self.codes.append(code)
            if len(self.codes) == 1:
                raise KeyboardInterrupt

    first, second = Interrupted(), Interrupted()
    with pytest.raises(KeyboardInterrupt):
        put_back({first: 1, second: 2})
    assert Interrupted.codes == [2, 2, 1]


README = (ROOT / "tests/line_by_line/README.md").read_text(encoding="utf-8")


def test_the_readme_shows_what_its_lines_print(tmp_path):
    """For functions about books, with nothing but this package."""
    source = """\
def total(books):
    result = 0
    for book in books:
        result = result + price(book)
    return result

def price(book):
    return book["pages"] / 10
"""
    (tmp_path / "books.py").write_text(source)
    code, _, shown = README.partition("prints, for two")
    lines = [line[4:] for line in code.splitlines() if line.startswith("    ") or not line]
    path = f"{ROOT / 'tests'}{os.pathsep}{tmp_path}"
    done = python("-c", "\n".join(lines), PYTHONPATH=path)
    assert done.stderr == ""
    assert shown.partition("How it works")[0].split("\n\n")[1] == done.stdout.rstrip()


def test_values_that_live_on_have_names():
    source = """\
        SHELF = []
        class Counter:
            n = 3
        def first(book, books=[], size=5):
            SHELF.append(Counter.n)
            len(book)"""
    expected = {"the default of books": "[ ], empty", "the default of size": "5"}
    assert state_of(functions_in(source).values()) == expected | {
        "SHELF": "[ ], empty",
        "Counter.n": "3",
    }


def test_another_course_has_its_own_words(monkeypatch):
    monkeypatch.setattr(words, "NOUNS", [Noun("pages", "book", "books"), *words.NOUNS])
    monkeypatch.setitem(words.TEXTS, range, lambda value, digits: f"{len(value)} pages")
    source = """\
        def first(books):
            read = range(7)
            return books"""
    _, found = watch_call(source, BOOKS)
    assert "2 read = range(7) read = 7 pages 3 return books gives a list of 3 books" in found
