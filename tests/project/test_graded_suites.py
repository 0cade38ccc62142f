"""The graded suites reject wrong solutions, accept correct ones, and name the mistake."""

import ast
import re
from importlib import import_module
from math import ceil

from grading.begin import ROOT

import pytest
from graded import CHECKS, failures, outcomes_of
from programs import slow_except
from right_solutions import PLAIN, RIGHT
from wrong_solutions import HINTED, WRONG

from grading import comparing, grader
from grading.handout import FUNCTIONS, PROGRAM
from grading.messages import Call, PlainFile
from grading.outcomes import FAILED, PASSED, WAITING
from grading.raised import own_places
from grading.subject import Subject

# A sentence, the call, the result, and the expected one.
FORM = re.compile(
    r"""wrong[ ]{7}.+\.\n
    called[ ]{6}.+?\n
    (came[ ]back[ ]{3}.+?\n)?  # of an error, the first line says it
    expected[ ]{4}.+""",
    re.VERBOSE | re.DOTALL,
)

KNOWN = [(function, words) for function, mistakes in HINTED.items() for words in mistakes]


@pytest.mark.parametrize(("function", "words"), slow_except(KNOWN[::3], WRONG))
def test_a_wrong_solution_fails_its_own_checks_and_its_mistake_is_named(solve, function, words):
    """The functions that use it wait."""
    solve(function, WRONG[function, words])
    failed = []
    for judged, outcome in outcomes_of(function).items():
        if judged.function != function:
            assert outcome[:2] == (WAITING, f"waits for {function}")
        elif outcome.state == FAILED:
            failed.append(outcome)
    for outcome in failed:
        assert FORM.fullmatch(outcome.message), outcome.message
        assert "grader" not in outcome.message
    # With 20 rows, pytest prints at most 40 (tests/project/test_grader_output.py).
    lines = failed[0].message.splitlines()
    assert sum(ceil(len(line) / 80) for line in lines) <= 20, lines
    assert [outcome.hint for outcome in failed[1:]] == [""] * len(failed[1:])
    if (function, words) in KNOWN:
        assert failed[0].hint.startswith(words)


WAYS = [(name, way) for name in FUNCTIONS for way in ("plainly", *RIGHT[name])]


@pytest.mark.parametrize(("function", "way"), WAYS)
def test_a_right_solution_passes(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    for outcome in outcomes_of(function, users=False).values():
        assert outcome.state == PASSED, outcome


@pytest.mark.slow
@pytest.mark.parametrize(("function", "way"), WAYS[1::4])
def test_the_functions_that_use_a_right_solution_pass(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    assert {outcome.state for outcome in outcomes_of(function).values()} == {PASSED}


def advice_of(function):
    outcomes = outcomes_of(function, users=False).values()
    return [outcome.advice for outcome in outcomes if outcome.advice]


def test_a_right_solution_with_a_trap_has_a_note(solve):
    solve("extract_and_convert", RIGHT["extract_and_convert"]["the columns named"])
    (advice,) = {*advice_of("extract_and_convert")}
    assert advice.startswith("Your extract_and_convert does not convert a CSV with other columns.")


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [("THETA_INIT", 45, "THETA_INIT is 45 radians."), ("DT", 0.01, "DT is 0.01 s.")],
)
def test_a_constant_with_a_trap_has_a_note(monkeypatch, name, value, words):
    monkeypatch.setattr(f"test_a.{name}", value)
    monkeypatch.setattr(f"support.constants.{name}", value)
    (advice,) = advice_of(PROGRAM)
    assert advice.startswith(words)


# --- hints ---------------------------------------------------------------------------------------


def test_each_function_has_steps_in_lines_that_python_can_read():
    assert grader.STEPS.keys() == FUNCTIONS.keys()
    for steps in grader.STEPS.values():
        for line in steps.python:
            assert len(line) <= 80 - 9  # one row of the screen
            is_head = ":  #" in line
            ast.parse(f"{line}\n  ..." if is_head else line)


def test_each_check_has_a_title_of_its_own():
    assert len({check.title for check in CHECKS}) == len(CHECKS)


def test_two_mistakes_with_the_same_result_have_no_hint():
    first = (2.0, "You doubled it.")
    second = (2.0, "You added 1.")
    assert comparing.hint_for_result(2.0, 1.0, [first, first]) == "You doubled it."
    assert comparing.hint_for_result(2.0, 1.0, [first, second]) == ""


def test_what_is_wrong_is_said_as_it_is(solve):
    spoilt = "return pend_list", "return [pend.get('no') for pend in pend_list]"
    solve("make_newton_cradle", spoilt)
    message = failures("make_newton_cradle")[0].message
    assert message.startswith("wrong       pend_list[0] is None, not a dictionary.")


# Mistakes in the places of objects, and what a sentence says about the first one that is wrong
PLACES = {
    ("make_double_pendulum", "cord2.axis = vector(0.1, 0.4, 0)"): (
        "end at the lower bob of cord2 is vector(0.722109, 0.117579, 0), not vector(1.06771"
    ),
    ("make_double_pendulum", "cord2.pos = cord2.pos + cord2.axis; cord2.axis = vector(1, 1, 0)"): (
        "end at the upper bob of cord2 is vector(2.06771, 0.490781, 0), not vector(0.622109"
    ),
    ("make_double_pendulum", "bob2.visible = False"): "visible of bob2 is False, not True.",
    ("make_newton_cradle", "pend['objects'][2].axis = vector(0.1, 0.3, 0)"): (
        "end at the bob (m from the axle) of cord[2] is vector(0.1, 0.3, 0), not vector(0, -0.4"
    ),
    ("full_swing_update", "pend['objects'] = pend_list[0]['objects']"): (
        "axle of pend_list[1] is not the same one as before."
    ),
    ("handle_two_bobs", "bob2.pos.x += 0.01"): (
        "position of the bob of pend2 is vector(1.08999, -3.9992, 0), not vector(1.07999"
    ),
}
LAST = {
    "make_newton_cradle": "return pend_list",
    "make_double_pendulum": "return (",
    "full_swing_update": "swing_update(",
    "handle_two_bobs": "pend1['omega'] = new_omega1",
}


@pytest.mark.parametrize(("function", "line"), PLACES)
def test_a_wrong_place_is_said_with_its_object(solve, function, line):
    """Of a cord, with the wrong end, from whichever end it is drawn."""
    solve(function, (LAST[function], f"{line}; {LAST[function]}"))
    sentences = [" ".join(outcome.message.split()) for outcome in failures(function)]
    assert any(f"wrong {PLACES[function, line]}" in sentence for sentence in sentences), sentences


@pytest.mark.parametrize(
    ("subject", "object_name", "attribute"),
    [
        (Subject("color", "bob", 0), "bob", "color"),
        (Subject("color", "pend_list", 0), "", ""),
        (Subject("radius of the bob", "pend1"), "bob", "radius"),
        (Subject("position from the axle (m)", "bob", 1), "bob", "pos"),
        (Subject("end at the upper bob", "cord2"), "cord2", "pos"),
        (Subject("end at the bob of the cord", "pend_list", 2), "cord", "axis"),
        (Subject("momentum"), "", ""),
    ],
)
def test_a_key_and_an_attribute_are_two_things(subject, object_name, attribute):
    assert (subject.object_name, subject.attribute) == (object_name, attribute)


# --- messages ------------------------------------------------------------------------------------


def test_a_failure_says_it_all_in_order(solve):
    solve("handle_two_bobs", ("e = pend1", "e = pend2"))
    assert failures("handle_two_bobs")[0].message.splitlines() == [
        "wrong       omega of pend1 is 0, not 1.",
        "called      handle_two_bobs(pend1, pend2, r_param=4)",
        "            pend1: mass 1, e 0.5, omega 4, bob (0, -4, 0), radius 0.5",
        "            pend2: mass 1, e 1, omega 0, bob (1, -4, 0), radius 0.5",
        "came back   omega of pend1, omega of pend2: (0, 4)",
        "expected    omega of pend1, omega of pend2: (1, 3)",
    ]


def test_a_message_shows_the_part_of_pendula_and_files_that_matters(solve):
    solve("full_swing_update", ("in pend_list", "in pend_list[:5]"))
    assert failures("full_swing_update")[0].message.splitlines()[2:6] == [
        "            pend_list[0]: theta 0.523599, omega 2",
        "            pend_list[1]: theta 1.5708, omega 0",
        "            pend_list[5]: theta 0, omega 4e-08",
        "            ... (10 in all)",
    ]
    solve("extract_and_convert", ("filepath)", "filepath).round(2)"))
    message = " ".join(failures("extract_and_convert")[0].message.split())
    file = " ".join(import_module("test_d").FILES["seven.csv"].split())
    assert f" is the path of seven.csv: {file} came back" in message
    assert " expected at index 0: {'mass': 12.625, 'e': 1," in message


def test_a_call_with_a_file_says_how_often_it_was_made():
    arguments = PlainFile("bobs/seven.csv", "mass\n"), 0.4, 0.5
    assert Call("make_newton_cradle", arguments, times=2).lines() == [
        "make_newton_cradle(relative_filepath, r_param=0.4, theta_init=0.5)",
        "2 times in a row",
        "relative_filepath is the path of seven.csv",
    ]


# What a body returns or raises, and how a message shows it
STRANGE = {
    "a = []; a.append(a); return a": "came back   a list that contains itself",
    "return list(range(10**5))": (
        "came back   [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,\n"
        "             19, ... (100000 in all)]"
    ),
    """
    class Odd:
        def __repr__(self): return 1 / 0
    return Odd()""": "came back   a Odd that has no text",
    """
    class Odd(Exception):
        def __str__(self): return 1 / 0
    raise Odd""": "wrong       src.swinging.angle_update.<locals>.Odd: <exception str() failed>.",
    # Both values would look the same with six digits.
    "return 2.000004, 5 * 3.141592653589793 / 6 + 0.2": "came back   (2.000004, 2.81799387799149)",
    "return float(input('omega? '))": "wrong       EOFError: input() waits for somebody",
    "raise GeneratorExit": "wrong       GeneratorExit.\n",
}
ENDS = {
    "import sys; sys.exit('the end')": "wrong       SystemExit: the end.",
    "raise KeyboardInterrupt": "wrong       KeyboardInterrupt.",
    "import os; os._exit(0)": "wrong       SystemExit: os._exit(0).",
}


@pytest.mark.parametrize("body", STRANGE | ENDS)
def test_a_strange_result_is_shown_in_a_few_lines(solve, body):
    """What would end the program ends its check only."""
    solve("angle_update", body)
    first = failures("angle_update")[0]
    assert (STRANGE | ENDS)[body] in first.message
    assert first.message.count("\n") < 15
    assert ("ends the whole program" in first.hint) == (body in ENDS)


@pytest.mark.parametrize("code", ["1 / 0", "import nothing_of_that_name"])
def test_only_lines_of_files_are_a_students(monkeypatch, code):
    """Not "<string>", and not Python's import code, even if the tests start in src/."""
    monkeypatch.chdir(ROOT / "src")
    with pytest.raises((ZeroDivisionError, ModuleNotFoundError)) as raised:
        exec(code)
    assert own_places(raised.value) == ((), [])
