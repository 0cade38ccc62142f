"""A wrong call, line by line: the trace table of the student's code, and the sentences below it."""

from textwrap import dedent

import pytest
from graded import failures, outcomes_of
from programs import slow_but_for
from right_solutions import RIGHT
from wrong_solutions import PLAIN, WRONG

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
    for _, lines in first.rows:
        text += " ".join(lines) + " "
    return first, " ".join(text.split())


# A function, a wrong version, and rows of its tables; the numbers of the lines are those of the
# function
ROWS = {
    "a row has the turns in which its line ran": (
        "make_newton_cradle",
        """\
        pend_list = extract_and_convert(relative_filepath)
        i = 0
        for pend in pend_list:
            pend['omega'] = 0
            if i == 0:
                pend['theta'] = theta_init
                i += 1
            else:
                pend['theta'] = 0
            axle_pos = vector((-0.1+r_param/4 * i), r_param/5, 0)
            color, texture = COLOR_MAP[pend['color']], TEXTURE_MAP[pend['texture']]
            pend['objects'] = make_pendulum(axle_pos, r_param, pend['theta'], color, texture)
        return pend_list""",
        [
            "3 i = 0 i = 0",
            "4 for pend in pend_list: pend_list[0] | pend_list[1] | pend_list[2]",
            "6 if i == 0: 0 == 0 True | 1 == 0 False | 1 == 0 False",
            "8 i += 1 1 | - | -",
            "(-0.025, 0.06, 0), in each turn",
        ],
    ),
    "of many turns the first two, the one in question, and the last one": (
        "full_swing_update",
        """\
        for i in range(len(pend_list)):
          if i != 5: swing_update(pend_list[i], r_param, dt, g)""",
        [
            "2 for i in range(len(pend_list)): 0 | 1 | ... | 5 | ... | 9 (10 turns)",
        ],
    ),
    "what a called function got and gave": (
        "handle_two_bobs",
        ("e = pend1", "e = pend2"),
        [
            "handle_collision got e = 1, omega1 = 4, omega2 = 0, m1 = 1, m2 = 1",
            "8 pend1['omega'] = new_omega1 0",
        ],
    ),
    "what a called function has changed": (
        "newton_cradle_tick",
        ("pend_list[i + 1]", "pend_list[i]"),
        [
            "turn 1: handle_two_bobs got pend1 = pend_list[0], pend2 = pend_list[0]; it set omega",
        ],
    ),
    "lines that never ran": (
        "handle_collision",
        """\
        if m1 < m2:
            return omega1, omega2
        else:
            w = 5
        return omega2, omega1""",
        [
            "2 if m1 < m2: 2 < 8 True",
            "5 w = 5 (never ran)",
            "6 return omega2, omega1 (never ran)",
        ],
    ),
    "the line that stopped, and the values in it": (
        "handle_two_bobs",
        """\
        for i in range(3):
            bob = pend1['objects']['bob']""",
        [
            "2 for i in range(3): 0",
            "3 bob = pend1['objects']['bob'] <- stops here: TypeError",
        ],
    ),
    "the keys of a dictionary that lacks one": (
        "handle_two_bobs",
        "return pend1['radius']",
        [
            "the keys of pend1 are 'mass', 'e', 'theta', 'omega', 'color', 'texture', 'objects'",
        ],
    ),
    "a value that was not taken apart": (
        "handle_two_bobs",
        "axle, bob = pend1['objects']",
        [
            "the value is (axle, bob, cord)",
        ],
    ),
    "a guard, and a loop in a loop": (
        "angle_update",
        """\
        a, n = None, 0
        if a is not None and a['x'] > 1: pass
        for i in range(2):
            for j in range(2): n += 1
        else: n = 0
        return n, theta""",
        [
            "3 if a is not None and a['x'] > 1: pass None is not None False",
            "5 for j in range(2): n += 1 0 | 1 | 0 | 1; 1 | 2 | 3 | 4",
            "n = 0",
        ],
    ),
    "the else of a loop": (
        "angle_update",
        """\
        n = 0
        for i in range(3):
            n += i
        else:
            n = 7
        return n, theta""",
        [
            "6 n = 7 n = 7",
        ],
    ),
    "a call in a turn that an except ended is no call of the next turn": (
        "angle_update",
        """\
        def part(x): return 6 / x
        r = 0
        for i in range(2):
            try:
                r += part(i)
            except ZeroDivisionError:
                pass
        return r, theta""",
        [
            "6 r += part(i) - | 6 turn 2: part got x = 1; it gave 6 7 except",
        ],
    ),
    "an index that changes with its value": (
        "angle_update",
        """\
        a, i = [0, 0], 0
        a[i], i = 5, 1
        return i, theta""",
        [
            "3 a[i], i = 5, 1 i = 1",
        ],
    ),
    "the last call of a helper": (
        "angle_update",
        """\
        def same(x):
            y = x
            return y
        w = same(1) + same(2)
        return w, theta""",
        [
            "Your function same, called there: 3 y = x y = 2",
        ],
    ),
    "no turn": (
        "angle_update",
        """\
        for i in range(0): g = i
        return omega, theta""",
        [
            "2 for i in range(0): g = i no turn",
        ],
    ),
    "match": (
        "angle_update",
        """\
        match g:
            case 8:
                a = 1
            case _:
                a = 2
        return a, theta""",
        [
            "2 match g: 4 a = 1 a = 1 6 a = 2 (never ran)",
        ],
    ),
    "an error in a print": (
        "angle_update",
        """\
        a = 5
        print(a / 0)""",
        [
            "2 a = 5 a = 5 3 print(a / 0) <- stops here: ZeroDivisionError",
        ],
    ),
    "an error that nobody told": (
        "angle_update",
        """\
        from contextlib import suppress
        with suppress(Exception):
            a = g / 0
        return 1, 1""",
        [
            "4 a = g / 0 (did not come to its end)",
        ],
    ),
    "a long loop": (
        "angle_update",
        """\
        for i in range(20000): a = i
        return a, theta""",
        [
            "turns: not watched further)",
            "3 return a, theta (not watched further)",
        ],
    ),
    "a helper has a table of its own": (
        "angle_update",
        """\
        def pull(a):
            return g * sin(a)
        new = omega - pull(theta)
        return new, theta + new * dt""",
        [
            "pull got a = 2.61799",
            "Your function pull, called there:",
            "3 return g * sin(a) gives 4",
        ],
    ),
    "the helper that stopped": (
        "angle_update",
        """\
        def pull(a):
            b = None
            return b * a
        return omega + pull(theta), theta""",
        [
            "5 return omega + pull(theta), theta <- stops here: TypeError",
            "4 return b * a <- stops here: TypeError",
            "b is None",
        ],
    ),
    "an error that an except hides": (
        "angle_update",
        """\
        try:
            a = omega / 0
        except ZeroDivisionError:
            a = 0
        return a, theta""",
        [
            "2 try: 3 a = omega / 0 stopped: ZeroDivisionError",
            "line 3 stopped with ZeroDivisionError: float division by zero; this except takes it",
        ],
    ),
    "conditions": (
        "angle_update",
        """\
        a = []
        while not a and 2 > len(a) > -1:
            a.append(g)
        if a:
            pass
        return a[0], theta""",
        [
            "not [ ], empty and 2 > 0 > -1 True | not [8] False",
            "5 if a: [8], so True",
            "4 a.append(g) [8]",
        ],
    ),
    "a value that no name gets": (
        "elastic_newton_cradle",
        """\
        uniform_e_newton_cradle(relative_filepath, 1)
        return []""",
        [
            "gives a list of 3 pendula, and no name gets it",
        ],
    ),
    "the same dictionary again and again": (
        "extract_and_convert",
        """\
        pend, pend_list = {}, []
        for i in range(3):
            pend['mass'] = i
            pend_list.append(pend)
        return pend_list""",
        [
            (
                "a list of 1 pendulum | a list of 2 pendula, all the same one | "
                "a list of 3 pendula, all the same one"
            ),
        ],
    ),
    "a function that is not called": (
        "main",
        """\
        pend_list = make_newton_cradle
        page.show(pend_list)""",
        [
            "the function make_newton_cradle: a call has ( )",
        ],
    ),
    "the first value that is certainly not the formula's": (
        "angle_update",
        ("-g * sin(theta) / r_param * dt", "0 * dt"),
        [
            "2 omega_new = omega + 0 * dt omega_new = 3 <- 2 is right here",
        ],
    ),
}


@pytest.mark.parametrize("name", ROWS)
def test_the_rows_say_what_each_line_gave(solve, name):
    function, version, rows = ROWS[name]
    _, found = explained(solve, function, version)
    assert [row for row in rows if row not in found] == [], found


# A function, a wrong version, the line to look at, and a sentence about what the grader has noted
FACTS = {
    "set": (
        "full_swing_update",
        """\
        for p in pend_list:
            p['omega'] = 5
            p['omega'] = 5.0""",
        3,
        "omega of pend_list[0] was set to 5 in line 3, then to 5 in line 4.",
    ),
    "set in a helper": (
        "handle_two_bobs",
        """\
        def put(p):
            p['omega'] = 7
        put(pend1)""",
        3,
        "omega of pend1 was set to 7 in line 3.",
    ),
    "set again, unseen": (
        "elastic_newton_cradle",
        """\
        pends = uniform_e_newton_cradle(relative_filepath, 0)
        for p in pends: p['e'] = 1
        [p.update(e=0.3) for p in pends]
        return pends""",
        3,
        None,
    ),
    "the other pendulum": (
        "handle_two_bobs",
        """\
        if pend1['e'] > 5:
            pend1['omega'] = 5
        pend2['omega'] = 6""",
        2,
        "No line of your function has set omega of pend1: it is still 3, as before the call.",
    ),
    "not set": (
        "handle_two_bobs",
        "omega = 5",
        1,
        "No line of your function has set omega of pend1: it is still 3, as before the call.",
    ),
    "given": (
        "uniform_e_newton_cradle",
        ("['e'] = e_val", "['mass'] = e_val"),
        4,
        "mass of pend_list[0] was set to 0.0625 in line 4.",
    ),
    "as it was": (
        "elastic_newton_cradle",
        "return uniform_e_newton_cradle(relative_filepath, 0)",
        2,
        (
            "No line of your function has set e of pend_list[0]: it is still 0, as "
            "uniform_e_newton_cradle gave it."
        ),
    ),
    "a parameter": (
        "handle_collision",
        "return omega1, omega2",
        2,
        "new_omega1 is your omega1, and no line of your function has set it.",
    ),
    "perhaps set": (
        "elastic_newton_cradle",
        """\
        pend_list = uniform_e_newton_cradle(relative_filepath, 0)
        [p.update(e=0) for p in pend_list]
        return pend_list""",
        3,
        "e of pend_list[0] is still 0, as uniform_e_newton_cradle gave it.",
    ),
    "a return in a loop": (
        "uniform_mass_newton_cradle",
        ("        return", "            return"),
        4,
        "Line 5 returns in turn 1 of the loop in line 3, and so ends it.",
    ),
    "no return": (
        "uniform_mass_newton_cradle",
        ("        return pend_list", ""),
        2,
        "Your function has no return with a value.",
    ),
    "no call": (
        "full_swing_update",
        "pass",
        1,
        "No line of your function calls swing_update.",
    ),
    "the formula": (
        "angle_update",
        "return 1, 1",
        2,
        ("Right here: sin(theta) = 0.5, acceleration = -10, omega_new = 2, theta_new = 2.81799."),
    ),
}


@pytest.mark.parametrize("name", FACTS)
def test_a_sentence_says_where_the_value_in_question_comes_from(solve, name):
    function, version, line, fact = FACTS[name]
    first, _ = explained(solve, function, version)
    if fact:
        assert fact in first.facts
    else:
        assert "was set" not in " ".join(first.facts)
    assert first.place.endswith(f", line {line}")


@pytest.mark.parametrize(
    ("function", "way"), [(name, way) for name in PLAIN for way in ("plainly", *RIGHT[name])]
)
def test_a_watched_function_does_what_it_does_unwatched(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    watch = Watch()
    with watched(function, watch):
        outcomes = outcomes_of(function, users=False)
    assert {outcome.state for outcome in outcomes.values()} == {PASSED}
    assert watch.runs


HARMLESS = f"""\
'A docstring about sin, cos, round and return.'
# {" ".join(PLAIN)}: R_PARAM, THETA_INIT, DT and G are constants; pend_list[i + 1] == append = while
print(1.05, "and never")
"""


@pytest.mark.parametrize(("function", "words"), slow_but_for([*WRONG][::9], WRONG))
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


def test_an_object_of_the_students_class_is_not_asked_again(solve):
    """Here, the second question would give something else."""
    body = """\
        class Count(dict):
            n = 0
            def __getitem__(self, key): self.n += 1; return 5
        c = Count()
        c['x'] = 4
        n = c.n
        return n, theta"""
    _, rows = explained(solve, "angle_update", body)
    assert "n = c.n n = 0" in rows


def test_with_no_room_the_lines_that_matter_stay(solve):
    others = "".join(f"    a{i} = {i}\n" for i in range(20))
    first, _ = explained(solve, "angle_update", f"w = 5\nif True:\n{others}return w, theta")
    ranks = {lines[0].split()[1]: rank for rank, lines in first.rows}
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
