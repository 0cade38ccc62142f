"""The story of a student's mistake: which line, what was seen there, and what is right."""

from textwrap import dedent

import pytest
from graded import failures, outcomes_of
from programs import slow_except
from right_solutions import PLAIN, RIGHT
from wrong_solutions import WRONG

from grading import limits
from grading.grader import runner
from grading.handout import PROGRAM
from grading.outcomes import PASSED
from grading.students_code import own_functions
from line_by_line.instrument import watched
from line_by_line.watch import Watch


def story_of(function):
    """Return the first failure of a function, and its screen as a text with single spaces."""
    first = failures(function)[0]
    lines = []
    for part in first.parts:
        lines += part.lines
    return first, " ".join(" ".join(lines).split())


# A function, a wrong version, the line that is certain ("" without one), and parts of the screen
STORIES = {
    "an argument changed": (
        "make_double_pendulum",
        """\
        joint = axle_pos
        axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
        joint.x = joint.x + r_param
        bob2, cord2 = make_bob_and_cord(joint, r_param, theta + phi, color, texture)
        return axle, bob1, cord1, bob2, cord2""",
        "5",
        ["axle_pos=vector(0.3, 0.1, 0)", "Your function has changed axle_pos."],
    ),
    "one dictionary in a list": (
        "extract_and_convert",
        """\
        rows = pd.read_csv(relative_filepath).to_dict('records')
        pend_list = [{}] * len(rows)
        for i in range(len(rows)):
            for key in rows[i]: pend_list[i][key] = rows[i][key]
        return pend_list""",
        "5",
        [
            "Line 3 puts one dictionary in the list 3 times.",
            "mass of pend_list[0] was set to 1.5, then to 2.5, then to 0.5, in line 5.",
        ],
    ),
    "a list that lives on": (
        "extract_and_convert",
        """\
        def collect(found=vars(pd).setdefault('found', [])):
            for pend in pd.read_csv(relative_filepath).to_dict('records'): found.append(pend)
            return found
        KEPT.extend(collect())
        return KEPT""",
        "5",
        ["KEPT lives on from call to call: it was a list of 9 pendula when this call began"],
    ),
    "degrees, and the minus": (
        "angle_update",
        """\
        angle = theta * 180 / 3.141592653589793
        acceleration = g * sin(angle) / r_param
        omega = omega + acceleration * dt
        return omega, theta + omega * dt""",
        "3",
        ["-14.2975 <- -10 is right here", "acceleration = -10, omega_new = 2"],
    ),
    "a right value, used wrongly": (
        "angle_update",
        """\
        pull = g * sin(theta) / r_param
        omega_new = omega + pull * dt
        return omega_new, theta + omega_new * dt""",
        "3",
        ["pull = 10 3 omega_new"],
    ),
    "a helper's value": (
        "angle_update",
        """\
        def pull(a):
            return -g * sin(a) * r_param
        omega = omega + pull(theta) * dt
        return omega, theta + omega * dt""",
        "3",
        ["Your function pull, called there: 3 return -g * sin(a) * r_param gives -1.6 <- -10 is"],
    ),
    "set twice": (
        "full_swing_update",
        """\
        for p in pend_list:
            p['omega'] = 5
            p['omega'] = 6""",
        "",
        ["omega of pend_list[0] was set to 5 in line 3, then to 6 in line 4."],
    ),
    "set in a helper": (
        "handle_two_bobs",
        """\
        def put(p):
            p['omega'] = 7
        put(pend1)""",
        "3",
        ["put got p = pend1", "3 p['omega'] = 7 7", "No line of your function calls handle_coll"],
    ),
    "not set": (
        "handle_two_bobs",
        "pend2['omega'] = 6",
        "",
        ["omega of pend1 is still 3, as before the call."],
    ),
    "as it was given": (
        "elastic_newton_cradle",
        "return uniform_e_newton_cradle(relative_filepath, 0)",
        "",
        ["e of pend_list[0] is still 0, as uniform_e_newton_cradle gave it."],
    ),
    "too few values": (
        "angle_update",
        "return (omega,)",
        "2",
        ["The result has 1 element, not 2.", "gives (3,)", "gave (1.5,), wrong"],
    ),
    "a return in a loop": (
        "uniform_mass_newton_cradle",
        ("        return", "            return"),
        "",
        ["Line 5 returns in turn 1 of the loop in line 3, and so ends it."],
    ),
    "no return": (
        "uniform_mass_newton_cradle",
        ("        return pend_list", ""),
        "",
        ["No return with a value has run."],
    ),
}


@pytest.mark.parametrize("name", STORIES)
def test_the_story_says_what_was_seen(solve, monkeypatch, name):
    function, version, line, expected = STORIES[name]
    monkeypatch.setattr("src.pds_helper.KEPT", [], raising=False)
    solve(function, version)
    first, screen = story_of(function)
    assert [text for text in expected if text not in screen] == [], screen
    assert first.place.partition(", line ")[2] == line


def test_an_error_of_the_program_is_shown_with_the_line_of_its_block(solve):
    solve(PROGRAM, ("(pend_list, R_PARAM, DT, G)", "(0, pend_list, R_PARAM, DT, G)"))
    first, screen = story_of(PROGRAM)
    line = f"{first.place}, in <module> newton_cradle_tick(0, pend_list, R_PARAM, DT, G) expected"
    assert f"called the program, for 3 ticks {line}" in screen
    assert first.place.startswith("src/visualize_cradle_run.py, line ")


FUNCTIONS = [name for name in PLAIN if name != PROGRAM]
WATCHED = [(name, way) for name in FUNCTIONS for way in ("plainly", *RIGHT[name])]


@pytest.mark.parametrize(("function", "way"), slow_except(WATCHED[::16], WATCHED[::4]))
def test_a_watched_function_does_what_it_does_unwatched(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    watch = Watch()
    with watched(own_functions(function), watch):
        outcomes = outcomes_of(function, users=False)
    assert {outcome.state for outcome in outcomes.values()} == {PASSED}
    assert watch.calls
    assert "__watch__" not in runner.find(function).__globals__


HARMLESS = f"""\
'A docstring about sin, cos, round and return.'
# {" ".join(PLAIN)}: R_PARAM, THETA_INIT, DT and G are constants; pend_list[i + 1] == append = while
print(1.05, "and never")
"""


@pytest.mark.parametrize(("function", "words"), slow_except([*WRONG][::36], [*WRONG][::9]))
def test_harmless_lines_change_no_word(solve, function, words):
    version = WRONG[function, words]
    source = dedent(version if isinstance(version, str) else PLAIN[function].replace(*version))
    stories = []
    for lines in ("\n" * HARMLESS.count("\n"), HARMLESS):
        solve(function, lines + source)
        stories.append(story_of(function))
    assert stories[0] == stories[1]


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
    solve("angle_update", body)
    _, screen = story_of("angle_update")
    line = "4 while i < 3: 0 < 3 True, in each turn (1000 turns) <- still here after 1000 turns"
    assert line in screen
    assert "6 return i, j (never ran)" in screen
    assert capsys.readouterr().out == "begin\n"


def test_a_right_value_with_which_the_function_never_ends_is_no_mark(solve, monkeypatch):
    monkeypatch.setattr(limits, "PATIENCE", 0.3)
    solve("angle_update", "a = 7\nwhile a == -10: pass\nreturn omega + a * dt, theta")
    _, screen = story_of("angle_update")
    assert "omega_new is 3.7, not 2." in screen
    assert "is right here" not in screen


def test_another_call_that_never_ends_is_no_other_call_and_ends_nothing(solve, monkeypatch):
    """Otherwise each call of the check would wait for its interrupt, and the last end pytest."""
    monkeypatch.setattr(limits, "PATIENCE", 0.3)
    monkeypatch.setattr(limits, "NEXT_INTERRUPT", 0.05)
    monkeypatch.setattr(limits, "MOST_INTERRUPTS", 3)
    monkeypatch.setattr(limits, "end_process", pytest.fail)
    solve("angle_update", "while g == 10: pass\nreturn 1, 1")
    _, screen = story_of("angle_update")
    assert "omega_new is 1, not 2." in screen


def test_ctrl_c_ends_the_run_also_when_the_check_is_watched(solve, monkeypatch):
    monkeypatch.setattr("src.swinging.CALLS", [], raising=False)
    line = "if len(CALLS) == 2: __import__('signal').raise_signal(2)"
    solve("angle_update", f"CALLS.append(1)\n{line}\nreturn 1, 1")
    with pytest.raises(KeyboardInterrupt):
        failures("angle_update")


def test_a_result_that_is_right_the_second_time_is_told_so(solve, monkeypatch):
    monkeypatch.setattr("src.swinging.CALLS", [], raising=False)
    right = dedent(PLAIN["angle_update"])
    solve("angle_update", f"CALLS.append(1)\nif len(CALLS) == 1: return 1, 1\n{right}")
    first, screen = story_of("angle_update")
    assert "Called again with the same values, it gave the right result." in screen


def test_under_a_debugger_there_is_no_table(solve, monkeypatch):
    monkeypatch.setattr(limits, "is_debugged", lambda: True)
    solve("angle_update", "return 1, 1")
    first, _ = story_of("angle_update")
    assert not any(part.is_row for part in first.parts)


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


@pytest.mark.parametrize("line", ["row[1] == 5", "if odd: pass", "odd.x"])
def test_values_that_say_nothing_of_themselves_change_nothing(solve, line):
    """The table is there, and the failure is that of the student's code."""
    solve("angle_update", ODD.replace("{}", line))
    first, _ = story_of("angle_update")
    assert any(part.is_row for part in first.parts)
    assert "fault" not in first.message
