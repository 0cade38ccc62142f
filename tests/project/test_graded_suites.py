"""The graded suites reject wrong solutions, accept correct ones, and name the mistake."""

import os
import re
import sys
from contextlib import contextmanager
from functools import cache, partial
from importlib import import_module
from inspect import Signature, signature
from math import ceil, cos, sin
from pathlib import Path
from textwrap import dedent, indent

import pytest
import watch
from programs import slow_but_for
from right_solutions import RIGHT
from vpython import vector
from wrong_solutions import PLAIN, WRONG

from grading import grader, limits
from grading.grader import check, checks, expect, FAILED, FAULT, Grading, module_of, Outcome, PASSED, WAITING
from grading.handout import FUNCTIONS, HONOR, needed, SUITES
from grading.telling import own_lines, ROOT
from support.constants import NC_FP
from support.start.command_line import command_line
from support.terminal.picture import TextPicture

# Import all modules first: a module that is imported later would keep a solution of a test.
MODULES = {name: import_module(module_of(of.file)) for name, of in FUNCTIONS.items()}

CHECKS = [check for tier in SUITES for check in checks(tier=tier)]
WRONG_ROWS = [(function, mistake) for function, mistakes in WRONG.items() for mistake in mistakes]
RIGHT_ROWS = [(function, way) for function, ways in RIGHT.items() for way in ways]


def put(monkeypatch, function, version):
    """Replace a function by a version from the tables, in all modules that use it."""
    of_module = vars(MODULES[function])
    before = dict(of_module)

    @contextmanager
    def imported_again():
        """Do the same as in the grader, for a version that is in no file."""
        kept = dict(of_module)
        of_module.clear()
        of_module.update(before)
        try:
            with pytest.MonkeyPatch.context() as again:
                put_once(again, function, version)
                yield
        finally:
            of_module.clear()
            of_module.update(kept)

    put_once(monkeypatch, function, version)
    monkeypatch.setattr(grader, "imported_again", imported_again)


def put_once(monkeypatch, function, version):
    """Do the same, but without the second import of the grader."""
    if isinstance(version, tuple):
        assert version[0] in PLAIN[function]
        version = PLAIN[function].replace(*version)
    for name, value in {"cos": cos, "sin": sin, "vector": vector}.items():  # the student's file imports them
        if not hasattr(MODULES[function], name):
            monkeypatch.setattr(MODULES[function], name, value, raising=False)
    made: dict = {}
    original = getattr(MODULES[function], function)
    # The student's function has the parameters of the handout; for the honor roll, the handout names none.
    is_said = FUNCTIONS[function].tier != HONOR
    own = signature(original).replace(return_annotation=Signature.empty)
    parameters = f"({FUNCTIONS[function].parameters})" if is_said else own
    exec(f"def {function}{parameters}:\n{indent(dedent(version), '    ')}", vars(MODULES[function]), made)
    for name, user in list(sys.modules.items()):
        if name.startswith("src.") and getattr(user, function, None) is original:
            monkeypatch.setattr(user, function, made[function])


@pytest.fixture
def solve(monkeypatch):
    return partial(put, monkeypatch)


def judge_from(tier, alone=False):
    """Return the outcome of each check of this tier and the tiers above it, by (function, name). alone: only this tier.

    The other tiers count as passed: the tiers below use the project's own functions.
    """
    grading, tiers = Grading(), list(SUITES)
    judged = tiers[tiers.index(tier) :][: 1 if alone else None]
    grading.outcomes = {check.name: Outcome(PASSED) for check in CHECKS if check.tier not in judged}
    return {(check.function, check.name): grading.judge(check) for check in CHECKS if check.tier in judged}


HINTS_TRIED: set = set()  # all hints that the checks tried


@cache
def outcomes_of(function, mistake, alone):
    """Return the outcomes of the checks with this wrong solution; alone: only those of its tier."""

    def hint(came, gives, hints):
        HINTS_TRIED.update(sentence for _, sentence in hints)
        return original(came, gives, hints)

    original = grader.hint
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(grader, "hint", hint)
        put(monkeypatch, function, WRONG[function][mistake])
        return judge_from(FUNCTIONS[function].tier, alone)


# --- wrong solutions fail, and a mistake costs points once -----------------------------------------------------------

# The form of a failure: a sentence, the call, the result, the expected result, a hint, the place in the handout, and
# the command to watch it.
FORM = re.compile(
    r"wrong       [^\n]+\.\ncalled      .+?\n(came back|it raised)   .+?\nexpected    .+?\n(hint        [^\n]+\n)?"
    r"read        handout, [^\n]+(\nwatch       [^\n]+ tests[/\\]watch\.py \w+)?",
    re.DOTALL,
)


def test_the_tables_are_large_and_name_each_function():
    assert len(WRONG_ROWS) >= 100
    assert len(RIGHT_ROWS) >= 20
    assert set(WRONG) == set(RIGHT) == set(FUNCTIONS) == {check.function for check in CHECKS}


@pytest.mark.parametrize("alone", slow_but_for([True], [True, False]))
@pytest.mark.parametrize(("function", "mistake"), WRONG_ROWS)
def test_nothing_wrong_passes(function, mistake, alone):
    """It fails only its own checks. The checks of functions that use it wait, and all others pass.

    The tiers below cannot use it. The test skips them, as they take the most time.
    """
    outcomes = outcomes_of(function, mistake, alone)
    assert {of for (of, _), outcome in outcomes.items() if outcome.state == FAILED} == {function}
    for (of, name), outcome in outcomes.items():
        if outcome.state == FAILED:
            assert FORM.fullmatch(outcome.message), outcome.message
            assert "grader" not in outcome.message
        elif of != function:
            waits = function in needed(of)
            assert outcome[:2] == ((WAITING, f"waits for {function}") if waits else (PASSED, "")), name


@pytest.mark.parametrize("alone", slow_but_for([True], [True, False]))
@pytest.mark.parametrize(("function", "way"), RIGHT_ROWS)
def test_nothing_right_fails(solve, function, way, alone):
    """It fails in no tier."""
    solve(function, RIGHT[function][way])
    outcomes = judge_from(FUNCTIONS[function].tier, alone=True) if alone else judge_from("D")
    assert {key: outcome for key, outcome in outcomes.items() if outcome.state != PASSED} == {}


# --- messages --------------------------------------------------------------------------------------------------------


def test_each_check_has_a_sentence_of_its_own():
    titles = [check.title() for check in CHECKS]
    assert len(set(titles)) == len(titles)
    assert not set(titles) & {check.name for check in CHECKS}


def first_failure(function):
    grading = Grading()
    return next(outcome for check in checks(function=function) if (outcome := grading.judge(check)).state == FAILED)


def test_a_failure_says_it_all_in_order(solve):
    solve("handle_two_bobs", WRONG["handle_two_bobs"]["the second pendulum's e"])
    assert first_failure("handle_two_bobs").message.splitlines() == [
        "wrong       omega of pend1 and omega of pend2 are wrong.",
        "called      handle_two_bobs(pend1, pend2, r_param=4)",
        "            pend1: mass 1, e 0.5, omega 4, bob (0, -4, 0), radius 0.5",
        "            pend2: mass 1, e 1, omega 0, bob (1, -4, 0), radius 0.5",
        "came back   omega of pend1, omega of pend2: (0, 4)",
        "expected    omega of pend1, omega of pend2: (1, 3)",
        "hint        This is the result with e = 1, but e of pend1 is 0.5.",
        "read        handout, Handling Collisions (B Tests), and Appendix: Conservation Laws: handle_two_bobs",
        f"watch       {command_line('tests/watch.py', ROOT)} test_e_is_the_first_pendulums",
    ]


HINTS = [
    ("extract_and_convert", "returns nothing", "Does your function reach a return with a value?"),
    ("extract_and_convert", "returns bad_rep", "You returned bad_rep."),
    ("extract_and_convert", "return inside the loop", "Your list has only the first pendulum. Is your"),
    ("extract_and_convert", "the list made inside the loop", "Your list has only the last pendulum. Do you make"),
    ("extract_and_convert", "one dictionary for all rows", "Your list has the last pendulum three times."),
    ("extract_and_convert", "counts from 1", "The first pendulum is missing."),
    ("extract_and_convert", "the file given is ignored", "Do you read the file at relative_filepath?"),
    ("uniform_mass_newton_cradle", "only the first", "You changed mass only in the first pendulum."),
    ("uniform_mass_newton_cradle", "compared, not assigned", "mass has not changed. These are the values"),
    ("uniform_e_newton_cradle", "mass instead", "You changed mass, not e."),
    ("elastic_newton_cradle", "e is 0", "You set e = 0. That is perfectly inelastic."),
    ("make_newton_cradle", "all are lifted", "You lifted all pendula. Lift only the first one."),
    ("make_newton_cradle", "the second is lifted", "You lifted the second pendulum. A list counts from 0."),
    ("elastic_newton_cradle", "arguments exchanged", "uniform_e_newton_cradle takes relative_filepath first"),
    ("make_newton_cradle", "return inside the loop", "Only the first theta is new. The others are from the file."),
    ("make_newton_cradle", "angle and length exchanged", "make_pendulum takes r_param first, then theta."),
    ("make_newton_cradle", "axles from 0 on", "You forgot the -0.1."),
    ("make_newton_cradle", "axles counted from 1", "You counted the pendula from 1."),
    ("make_newton_cradle", "cords of the shipped length", "Do you give r_param to make_pendulum"),
    ("make_newton_cradle", "the name of the texture", "You used the name of a texture."),
    ("angle_update", "the old omega", "You used the old omega; theta moves with the new one."),
    ("angle_update", "degrees", "This is the result with degrees. sin() takes radians."),
    ("angle_update", "the sign of gravity", "The sign of gravity is wrong."),
    ("angle_update", "the order of the result", "The values are right, but in the wrong order."),
    ("angle_update", "a list", "You returned a list. Return a tuple."),
    ("angle_update", "dt multiplies the old omega, too", "In the first formula, multiply only the acceleration"),
    ("angle_update", "dt multiplies the old theta, too", "In the second formula, multiply only the new omega"),
    ("angle_update", "theta divided by r_param", "You divided theta by r_param. Divide its sine."),
    ("angle_update", "rounded down", "This is the result with //, which rounds down."),
    ("full_swing_update", "return inside the loop", "Only the first pendulum has swung"),
    ("full_swing_update", "angle_update in place of swing_update", "angle_update takes no pendulum."),
    ("full_swing_update", "angles thrown away", "omega and theta have not changed. swing_update"),
    ("full_swing_update", "r_param and dt exchanged", "Check the order of the arguments of swing_update"),
    ("full_swing_update", "dt and g exchanged", "Check the order of the arguments of swing_update"),
    ("handle_collision", "masses exchanged", "You exchanged the masses."),
    ("handle_collision", "not converted back", "These are the linear velocities"),
    ("handle_collision", "the new v1 in the second", "In the second formula, you used the new velocity"),
    ("handle_collision", "brackets forgotten", "In the first formula, brackets are missing"),
    ("handle_collision", "rounded down", "This is the result with //, which rounds down."),
    ("handle_collision", "rounded down on the way back", "This is the result with //, which rounds down."),
    ("handle_collision", "multiplied by the sum of the masses", "You multiplied by the sum of the masses."),
    ("handle_collision", "divided by r_param both ways", "You divided by r_param twice."),
    ("handle_two_bobs", "e as the last argument", "Check the order of the arguments of handle_collision"),
    ("handle_two_bobs", "e as the third argument", "Check the order of the arguments of handle_collision"),
    ("handle_two_bobs", "masses before omegas", "Check the order of the arguments of handle_collision"),
    ("handle_two_bobs", "new omegas exchanged", "You exchanged the new omegas"),
    ("handle_two_bobs", "masses exchanged", "You exchanged the masses."),
    ("handle_two_bobs", "without the buffer", "These bobs are 1.02 times the sum of their radii apart."),
    ("handle_two_bobs", "less, not less or equal", "These bobs are exactly 1.05 times the sum"),
    ("handle_two_bobs", "distance along x", "These bobs are 1.15 times the sum of their radii apart"),
    ("handle_two_bobs", "only approaching", "These bobs move apart, but they touch."),
    ("newton_cradle_tick", "swings twice", "All pendula have swung twice."),
    ("newton_cradle_tick", "collides before it swings", "These bobs touch only after the swing."),
    ("newton_cradle_tick", "each with the one before it", "Only the first two bobs have collided."),
    ("newton_cradle_tick", "each of all with the one before it", "The velocities have not changed. Do you handle"),
    ("newton_cradle_tick", "the pair exchanged", "The e of the right pendulum was used."),
    ("newton_cradle_tick", "dt and g exchanged", "Do you pass on r_param, dt and g, in this order?"),
    ("main", "the cradle not shown", "You showed no cradle."),
    ("main", "R_PARAM and THETA_INIT exchanged", "make_newton_cradle takes R_PARAM first, then THETA_INIT."),
    ("main", "THETA_INIT from degrees", "THETA_INIT is in radians already."),
    ("main", "made once, at the beginning", "Your second cradle goes on where the first one was."),
    ("main", "the first cradle ticks for ever", "Your second cradle does not tick."),
    ("main", "two ticks", "Your cradle ticks twice when the page wants one tick."),
    ("main", "DT and G exchanged", "Check the order of the arguments of newton_cradle_tick"),
    ("main", "one tick a round", "Tick as long as page.wants_tick() is True: while, not if."),
    ("main", "made in each round", "You made the cradle again, but the page did not want one."),
    ("main", "the file's pendula, not made", "Your pendula have no objects. make_newton_cradle makes them."),
    ("main", "full_swing_update", "Your bobs do not collide. full_swing_update only swings them."),
    ("make_double_pendulum", "phi from straight down", "The lower cord's angle from straight down is theta + phi."),
    ("make_newton_cradle", "made twice", "Axles, bobs or cords stay in the scene without use."),
    ("angle_update", "counts its calls", "This call is right when it is made alone."),
    ("uniform_mass_newton_cradle", "the mass of the first call", "This call is right when it is made alone."),
    ("handle_collision", "1 - e for e", None),
    ("handle_collision", "e times the first velocity alone", None),
    ("handle_two_bobs", "a heavy one counts", None),
    ("double_angle_update", "accelerations exchanged", None),
    ("double_angle_update", "the upper bob's turning forgotten", None),
    ("double_angle_update", "the lower bob's turning forgotten", None),
    ("double_angle_update", "the sign of gravity", "Both accelerations have the wrong sign."),
]


@pytest.mark.parametrize(("function", "mistake", "hint"), HINTS)
def test_a_mistake_is_recognised(solve, function, mistake, hint):
    solve(function, WRONG[function][mistake])
    message = first_failure(function).message
    assert f"\nhint        {hint}" in message if hint else "\nhint" not in message


# Beginnings of hints that are true of several mistakes of a function: they say what has happened, not why.
FACTS = (
    *(
        "All axles are in one place",
        "Axles, bobs or cords stay",
        "Do you",
        "Does your function reach",
        "Check the order",
    ),
    *("Here bob 2 is", "The bobs ", "The sum of the radii is", "The velocities", "These bobs", "These are the old"),
    *("This call is right", "This is the result", "No pendulum", "Only the", "All pendula have swung", "All your bobs"),
    *("omega and theta have not changed", "omega of pend", "The cradle that you showed", "The last pendulum has not"),
    *(
        "mass has not changed",
        "e has not changed",
        "You changed mass only",
        "You changed e only",
        "These are the angular",
    ),
    *(
        "Your list has only the first pendulum.",
        "You gave page.show",
        "You returned the old",
        "You showed no cradle",
        "You did not lift",
    ),
)


def test_a_hint_names_the_mistake_of_one_solution():
    """Otherwise, it could be a wrong guess. Judge the new solution, and reword the hint or add it to FACTS."""
    named = {}
    for function, mistake in WRONG_ROWS:
        message = next(of.message for of in outcomes_of(function, mistake, True).values() if of.state == FAILED)
        for line in message.split("\n"):
            if line.startswith("hint ") and not line.removeprefix("hint        ").startswith(FACTS):
                named.setdefault((function, line), []).append(mistake)
    assert {key: mistakes for key, mistakes in named.items() if len(mistakes) > 1} == {}


def test_if_two_mistakes_give_the_same_there_is_no_hint():
    first, second = (2.0, "You doubled it."), (2.0, "You added 1.")
    assert grader.hint(2.0, 1.0, [first]) == grader.hint(2.0, 1.0, [first, first]) == [("hint", "You doubled it.")]
    assert grader.hint(2.0, 1.0, [first, second]) == grader.hint(3.0, 1.0, [first]) == []


@pytest.mark.parametrize("function", FUNCTIONS)
def test_only_what_must_return_a_value_is_asked_for_its_return(solve, function):
    """A function that returns nothing leaves the pendula as they were."""
    solve(function, "pass")
    asks = any("Does your function reach a return" in of.message for of in judge_from("D").values())
    assert asks == bool(FUNCTIONS[function].returns)


def test_a_file_is_imported_again_to_make_a_call_alone():
    module = MODULES["angle_update"]
    with grader.imported_again():
        again = import_module("src.swinging")
        assert again is not module
        assert again.angle_update is not module.angle_update
    assert import_module("src.swinging") is module


def test_each_hint_is_what_some_mistake_gives():
    messages = [outcome.message for row in WRONG_ROWS for outcome in outcomes_of(*row, True).values()]
    given = {line.removeprefix("hint        ") for text in messages for line in text.split("\n")}
    assert HINTS_TRIED - given == set()


ROWS = 17  # of a message; then pytest prints at most 45 (tests/project/test_grader_output.py)


@pytest.mark.parametrize(("function", "mistake"), WRONG_ROWS)
def test_the_first_message_is_short(function, mistake):
    """On a screen of 80 columns."""
    message = next(of.message for of in outcomes_of(function, mistake, True).values() if of.state == FAILED)
    assert sum(ceil(len(line) / 80) for line in message.splitlines()) <= ROWS, message


def test_of_pendula_and_files_only_what_matters_is_told(solve):
    solve("full_swing_update", WRONG["full_swing_update"]["five at most"])
    assert first_failure("full_swing_update").message.splitlines()[:6] == [
        "wrong       omega and theta of pend_list[5], ... are wrong.",
        "called      full_swing_update(pend_list, r_param=0.5, dt=0.1, g=10)",
        "            pend_list[0]: theta 0.523599, omega 2",
        "            pend_list[1]: theta -0.523599, omega 2",
        "            pend_list[2]: theta 1.5708, omega 0",
        "            ... (10 in all)",
    ]
    solve("extract_and_convert", WRONG["extract_and_convert"]["rounded"])
    assert [line.strip() for line in first_failure("extract_and_convert").message.splitlines()] == [
        "wrong       mass and theta of pend_list[0] are wrong.",
        "called      extract_and_convert(relative_filepath)",
        "relative_filepath is the path of seven.csv:",
        "mass,e,theta,omega,color,texture",
        "12.625,1.0,0.4375,0.0,white,none",
        "0.25,0.0,0.0,0.0,red,rug",
        "... (8 lines in all)",
        "came back   at index 0:",
        "{'mass': 12.62, 'e': 1, 'theta': 0.44, 'omega': 0,",
        "'color': 'white', 'texture': 'none'}",
        "expected    at index 0:",
        "{'mass': 12.625, 'e': 1, 'theta': 0.4375, 'omega': 0,",
        "'color': 'white', 'texture': 'none'}",
        "read        handout, A CVS to pend_list converter (D Tests): extract_and_convert",
    ]


def test_no_two_mistakes_give_the_same():
    """Otherwise, a hint could name the wrong mistake."""
    for suite in ("test_c", "test_b"):
        results = [result for result, _ in import_module(suite).MISTAKES]
        for i, result in enumerate(results):
            for other in results[:i]:
                assert max(abs(a - b) for a, b in zip(result, other, strict=True)) > 1e-4


@pytest.mark.parametrize(
    "body",
    [
        "while True: pass",
        "import time; time.sleep(100)",
        "while True:\n try:\n  while True: pass\n except: break\nwhile True: pass",
    ],
)
def test_what_never_comes_back_is_stopped_and_not_called_again(solve, monkeypatch, capsys, body):
    monkeypatch.setattr(grader, "PATIENCE", 0.2)
    solve("angle_update", f"print('called')\n{body}")
    messages = [outcome.message for (_, _), outcome in judge_from("D").items() if outcome.state == FAILED]
    assert "came back   nothing, within 0.2 s; it was stopped here:" in messages[0]
    assert [message.splitlines()[0] for message in messages[1:]] == [
        "not called  angle_update took longer than 0.2 s in an earlier check."
    ]
    assert capsys.readouterr().out == "called\n"


def test_a_file_that_never_ends_is_stopped_once(monkeypatch):
    def import_module(name):
        if name == "src.swinging":
            exec(compile("\nwhile True: pass", str(ROOT / "src" / "swinging.py"), "exec"), {})
        return original(name)

    original = grader.importlib.import_module
    monkeypatch.setattr(grader, "PATIENCE", 0.2)
    monkeypatch.setattr(grader.importlib, "import_module", import_module)
    grading = Grading()
    first, second = (grading.judge(check) for check in checks(function="angle_update"))
    assert [line.strip() for line in first.message.splitlines()[2:4]] == [
        "came back   nothing, within 0.2 s; it was stopped here:",
        "src/swinging.py, line 2, in <module>",
    ]
    assert second.message.startswith("not called  src/swinging.py took longer than 0.2 s in an earlier check.")
    assert {grading.judge(check).message for check in checks(function="full_swing_update")} == {
        "waits for angle_update"
    }


STUB = 'raise NotImplementedError("{} is not written yet")'


def test_what_is_not_written_waits(solve):
    """Functions that use it wait too, if they are written themselves."""
    for name in ("angle_update", "full_swing_update"):
        solve(name, STUB.format(name))
    messages = {(of, outcome.state, outcome.message) for (of, _), outcome in judge_from("C").items()}
    assert {row for row in messages if row[1] != PASSED} == {
        ("angle_update", WAITING, "waits for you to write angle_update in src/swinging.py"),
        ("full_swing_update", WAITING, "waits for you to write full_swing_update in src/swinging.py"),
        ("newton_cradle_tick", WAITING, "waits for angle_update, full_swing_update"),
        ("main", WAITING, "waits for angle_update, full_swing_update"),
    }


def test_whether_it_is_written_is_judged_by_calling(solve):
    solve("angle_update", f"{dedent(PLAIN['angle_update'])}\n{STUB.format('angle_update')}")
    solve("full_swing_update", f"{dedent(PLAIN['full_swing_update'])}\n{STUB.format('full_swing_update')}")
    assert {of for (of, _), outcome in judge_from("C").items() if outcome.state == FAILED} == {"full_swing_update"}
    message = first_failure("full_swing_update").message
    assert "\nit raised   NotImplementedError: full_swing_update is not written yet" in message
    assert "\nhint        Your code ran up to this line. Now delete it." in message


def test_a_function_waits_for_one_that_it_need_not_use(solve):
    solve("uniform_mass_newton_cradle", STUB.format("uniform_mass_newton_cradle"))
    solve("uniform_e_newton_cradle", "return uniform_mass_newton_cradle(relative_filepath, e_val)")
    outcome = Grading().judge(checks(function="uniform_e_newton_cradle")[0])
    assert outcome[:2] == (WAITING, "waits for uniform_mass_newton_cradle")


def test_a_solution_that_writes_the_shipped_file_fails_and_the_file_is_put_back(solve):
    before = Path(NC_FP).read_bytes()
    solve("uniform_mass_newton_cradle", WRONG["uniform_mass_newton_cradle"]["writes the shipped file"])
    message = first_failure("uniform_mass_newton_cradle").message
    assert "came back   Your code changed newton_cradle_pends.csv. It is restored now." in message
    assert Path(NC_FP).read_bytes() == before


@pytest.mark.parametrize(
    ("body", "line"),
    [
        (
            "return angle_update(omega, theta, r_param, dt, g)",
            "it raised   RecursionError: maximum recursion depth exceeded",
        ),
        ("a = []; a.append(a); return a", "came back   a list that contains itself"),
        (
            "return list(range(10**5))",
            "came back   [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,\n"
            "             19, ... (100000 in all)]",
        ),
        ("class Odd:\n    def __repr__(self): return 1 / 0\nreturn Odd()", "came back   a Odd that has no text"),
        ("class Odd(Exception):\n    def __str__(self): return 1 / 0\nraise Odd", "it raised   Odd, which has no text"),
        ("return 1 + 1e-12j, 2", "came back   ((1+1e-12j), 2)"),
        ("return float('nan'), float('inf')", "came back   (nan, inf)"),
    ],
)
def test_strange_values_are_told_in_a_few_lines(solve, body, line):
    solve("angle_update", body)
    message = first_failure("angle_update").message
    assert "\n" + line in message
    assert message.count("\n") < 15


def test_what_differs_beyond_six_digits_is_shown_with_more(solve):
    solve("angle_update", "return omega + 0.00002, theta")
    expected = "came back   (3.00002, 2.61799387799149)"
    assert expected.replace("2.61799387799149", "2.61799") in first_failure("angle_update").message
    solve("angle_update", "return 2.000004, 5 * 3.141592653589793 / 6 + 0.2")
    assert "came back   (2.000004, 2.81799387799149)" in first_failure("angle_update").message


def test_ctrl_c_is_none_of_the_solutions_doing(solve):
    solve("angle_update", "import signal; signal.raise_signal(signal.SIGINT)")
    with pytest.raises(KeyboardInterrupt):
        Grading().judge(checks(function="angle_update")[0])


@pytest.mark.parametrize(
    ("ending", "raises"),
    [
        ("exit()", "SystemExit: None"),
        ("raise SystemExit", "SystemExit: "),
        ("import sys; sys.exit('the end')", "SystemExit: the end"),
        ("raise KeyboardInterrupt", "KeyboardInterrupt: "),
        ("import os; os._exit(0)", "SystemExit: os._exit(0)"),
        ("from os import abort; abort()", "SystemExit: os.abort()"),
        ("import os; os.kill(os.getpid(), 9)", "SystemExit: os.kill({process}, 9)"),
    ],
)
def test_a_solution_that_ends_the_program_ends_its_check_only(solve, ending, raises):
    solve("angle_update", ending)
    lines = first_failure("angle_update").message.splitlines()
    assert f"it raised   {raises.format(process=os.getpid())}" in lines
    assert "hint        This line ends the whole program. Remove it; return ends a function." in lines


@pytest.mark.parametrize("ending", ["raise GeneratorExit", "import pytest; pytest.skip()"])
def test_an_unusual_error_ends_its_check_only(solve, ending):
    solve("angle_update", ending)
    assert re.search("it raised   (GeneratorExit|Skipped): ", first_failure("angle_update").message)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="only Linux and macOS have fork")
def test_a_process_that_a_solution_starts_can_end(solve):
    """A child that went on would run the tests a second time."""
    swing = "omega -= g * sin(theta) * dt / r_param\nreturn omega, theta + omega * dt"
    solve("angle_update", f"import os\nchild = os.fork()\nif not child: os._exit(0)\nos.waitpid(child, 0)\n{swing}")
    assert {Grading().judge(check).state for check in checks(function="angle_update")} == {PASSED}


def test_nobody_is_asked(solve):
    solve("angle_update", "return float(input('omega? '))")
    message = first_failure("angle_update").message
    assert "it raised   EOFError: input() waits for somebody, but nobody answers in a check" in message


@pytest.mark.skipif(not limits.MEMORY_IN_USE.exists(), reason="the memory is limited on Linux")
@pytest.mark.parametrize(
    "body",
    [
        "rows = [0] * 10**9",
        "rows = [omega]\nfor row in rows: rows.append(row)",
        "rows = [[]]\nfor row in rows: rows.append([row])",
        "import numpy; numpy.ones(10**9)",
    ],
)
def test_what_takes_all_memory_is_stopped_and_not_called_again(solve, monkeypatch, body):
    """Its limits are as before, and the other functions are checked."""
    before = limits.resource.getrlimit(limits.resource.RLIMIT_DATA)
    monkeypatch.setattr(limits, "MOST_MEMORY", 20)
    monkeypatch.setattr(grader, "PATIENCE", 60.0)
    solve("angle_update", body)
    outcomes = judge_from("D")
    failed = [outcome.message for outcome in outcomes.values() if outcome.state == FAILED]
    assert "came back   nothing; it took more than 20 MB of memory and was stopped here:" in failed[0]
    assert [message.splitlines()[0] for message in failed[1:]] == [
        "not called  angle_update took more than 20 MB of memory in an earlier check."
    ]
    assert {outcome.state for (of, _), outcome in outcomes.items() if of == "handle_collision"} == {PASSED}
    assert limits.resource.getrlimit(limits.resource.RLIMIT_DATA) == before


@pytest.mark.skipif(not limits.MEMORY_IN_USE.exists(), reason="the memory is limited on Linux")
def test_what_goes_on_without_memory_is_stopped_by_the_time(solve, monkeypatch):
    monkeypatch.setattr(limits, "MOST_MEMORY", 20)
    monkeypatch.setattr(grader, "PATIENCE", 0.5)
    solve("angle_update", "rows = []\nwhile True:\n try: rows.append([])\n except: pass")
    assert "came back   nothing, within 0.5 s; it was stopped here:" in first_failure("angle_update").message


@pytest.mark.parametrize("code", ["1 / 0", "import nothing_of_that_name"])
def test_only_lines_of_files_are_a_students(monkeypatch, code):
    """Not "<string>", and not Python's import code, even if the tests start in src/."""
    monkeypatch.chdir(ROOT / "src")
    try:
        exec(code)
    except (ZeroDivisionError, ModuleNotFoundError) as error:
        assert own_lines(error) == []


def test_a_fault_of_the_grader_is_marked_as_such(monkeypatch):
    monkeypatch.setattr(grader, "CHECKS", {})

    @check("angle_update")
    def test_with_a_fault():
        """A sentence."""
        expect("angle_update", 1 / 0, gives=None)

    grading = Grading()
    outcome = grading.judge(grader.CHECKS["test_with_a_fault"])
    assert outcome.state == FAULT
    first, *others = outcome.message.splitlines()
    assert first == "This is a fault of the grader, not of your code. Please show it to your teacher."
    assert others[-1] == "ZeroDivisionError: division by zero"


# --- watching --------------------------------------------------------------------------------------------------------


def test_of_a_check_that_passes_the_first_call_can_be_watched():
    grading = Grading()
    for one in CHECKS:
        call = grading.judge(one).call
        assert (call and call.function) == (one.function if one.watched else None)
    step = grading.outcomes["test_angle_update_of_other_swings"].call
    assert step.arguments == import_module("test_c").STEPS[0][0]


def outcome_of(name):
    return next(Grading().judge(one) for one in CHECKS if one.name == name)


@pytest.mark.parametrize(
    ("function", "mistake", "name", "is_offered"),
    [
        ("newton_cradle_tick", "only collides", "test_a_cradle_passes_the_swing_on", True),
        ("double_angle_update", "damped", "test_a_tenth_of_a_second_of_swinging", True),
        ("double_angle_update", "the angles alone", "test_a_tenth_of_a_second_of_swinging", False),
        ("make_newton_cradle", "angle and length exchanged", "test_bobs_hang_from_their_axles", True),
        ("make_newton_cradle", "the position as a tuple", "test_bobs_hang_from_their_axles", False),
    ],
)
def test_what_can_be_played_is_offered(solve, function, mistake, name, is_offered):
    solve(function, WRONG[function][mistake])
    outcome = outcome_of(name)
    assert outcome.state == FAILED
    assert (outcome.message.splitlines()[-1].startswith("watch ")) == (outcome.call is not None) == is_offered
    if is_offered:
        TextPicture().lines(watch.scene_of(outcome.call), 80, 20)


def test_there_is_a_scene_for_all_that_can_be_watched():
    assert set(watch.SCENES) == {check.function for check in CHECKS if check.watched}


@pytest.mark.parametrize(
    ("function", "mistake"),
    [
        ("make_newton_cradle", "all axles in one place"),
        ("angle_update", "the old omega"),
        ("full_swing_update", "only the first"),
        ("handle_collision", "the sign of e in both"),
        ("handle_two_bobs", "the second pendulum's e"),
        ("newton_cradle_tick", "only swings"),
        ("make_double_pendulum", "phi ignored"),
        ("double_angle_update", "the sign of gravity"),
    ],
)
def test_a_failure_that_can_be_watched_is_played_by_the_solution(solve, function, mistake):
    solve(function, WRONG[function][mistake])
    outcome = first_failure(function)
    assert re.fullmatch(r"watch       .+ tests[/\\]watch\.py test_\w+", outcome.message.splitlines()[-1])
    places = []
    for version in (WRONG[function][mistake], PLAIN[function]):
        solve(function, version)
        scene = watch.scene_of(outcome.call)
        seen = [[bob.pos.value for bob in scene.bobs()]]
        for _ in range(4 if scene.tick else 0):
            for _ in range(1000):
                scene.tick()
            seen.append([bob.pos.value for bob in scene.bobs()])
        places.append(seen)
        assert any("(" in line or "O" in line for line in TextPicture().lines(scene, 80, 20))
    assert places[0] != places[1]


def test_a_scene_tells_of_hits(solve):
    for mistake, hits in [
        ("the first pair alone", [(0, 1)]),
        ("from the right", [(1, 2), (0, 1)]),
        ("only swings", []),
    ]:
        solve("newton_cradle_tick", WRONG["newton_cradle_tick"][mistake])
        assert watch.scene_of(first_failure("newton_cradle_tick").call).tick() == hits
    solve("newton_cradle_tick", PLAIN["newton_cradle_tick"])
    solve("handle_two_bobs", WRONG["handle_two_bobs"]["the second pendulum's e"])
    assert watch.scene_of(first_failure("handle_two_bobs").call).tick() == [(0, 1)]
