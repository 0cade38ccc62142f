"""The graded suites reject wrong solutions, accept correct ones, and name the mistake."""

import ast
import linecache
import os
import re
import sys
from importlib import import_module
from inspect import Signature, signature
from math import ceil, cos, sin
from pathlib import Path
from textwrap import dedent, indent

from grading.begin import ROOT

import pytest
from programs import slow_but_for
from right_solutions import RIGHT
from vpython import vector
from wrong_solutions import HINTED, OTHERS, PLAIN

from grading import comparing, grader, hints, limits, students_code
from grading.grader import check, checks, expect
from grading.handout import FUNCTIONS, HONOR, needed, SUITES
from grading.outcomes import FAILED, FAULT, Grading, Outcome, PASSED, WAITING
from grading.raised import own_places
from grading.students_code import module_of
from support.constants import NC_FP

# Import all modules first: a module that is imported later would keep a solution of a test.
MODULES = {name: import_module(module_of(function.file)) for name, function in FUNCTIONS.items()}

CHECKS = [check for tier in SUITES for check in checks(tier=tier)]
STUB = 'raise NotImplementedError("{} is not written yet")'


@pytest.fixture(autouse=True)
def patient(monkeypatch):
    """A busy machine can stall for seconds. The tests of the limit set their own."""
    monkeypatch.setattr(limits, "PATIENCE", 60.0)


@pytest.fixture
def solve(monkeypatch):
    """A function that replaces a function by a version from the tables, in all modules that use it."""
    modules = [module for name, module in sys.modules.items() if name.startswith("src.")]
    shipped = str(grader.runner.shipped)
    monkeypatch.setattr("support.constants.NC_FP", shipped)
    monkeypatch.setattr(import_module("src.pds_helper").write_to_csv, "__defaults__", (shipped,))

    def put(function, version):
        if isinstance(version, tuple):
            assert version[0] in PLAIN[function]
            version = PLAIN[function].replace(*version)
        scope, made = vars(MODULES[function]), {}
        # No row needs to import them
        for name, value in {"cos": cos, "sin": sin, "vector": vector, **scope}.items():
            monkeypatch.setitem(scope, name, value)
        original = getattr(MODULES[function], function)
        # The student's function has the parameters of the handout; for the honor roll, the handout
        # names none.
        own = signature(original).replace(return_annotation=Signature.empty)
        parameters = (
            own if FUNCTIONS[function].tier == HONOR else f"({FUNCTIONS[function].parameters})"
        )
        source = f"def {function}{parameters}:\n{indent(dedent(version), '    ')}"
        file = str(ROOT / "src" / f"my_{function}.py")  # there is none, but messages have its lines
        linecache.cache[file] = len(source), None, source.splitlines(keepends=True), file
        exec(compile(source, file, "exec"), scope, made)
        for module in modules:
            if vars(module).get(function) is original:
                monkeypatch.setattr(module, function, made[function])

    return put


def outcomes_of(function, users=True) -> dict:
    """Return the outcome of each check of this function, and of the functions that use it; all
    others are passed.
    """
    grading = Grading()
    made = [
        check
        for check in CHECKS
        if function in (check.function, *(needed(check.function) if users else ()))
    ]
    grading.outcomes = {check.name: Outcome(PASSED) for check in CHECKS if check not in made}
    return {check: grading.judge(check) for check in made}


def failures(function) -> list:
    return [
        outcome
        for outcome in outcomes_of(function, users=False).values()
        if outcome.state == FAILED
    ]


# The form of a failure: a sentence, the call, the result, the expected result, and the place in the
# handout.
FORM = r"(?s)wrong       .+\.\ncalled      .+?\n(came back|it raised)   .+?\nexpected    .+?\nread        handout, .+"

WRONG = {
    (function, words): version
    for table in (HINTED, OTHERS)
    for function, mistakes in table.items()
    for words, version in mistakes.items()
}
KNOWN = [(function, words) for function, mistakes in HINTED.items() for words in mistakes]
# It fails in a check in which no mistake with a hint fails
ALONE = ("handle_two_bobs", "moves the bobs apart")


@pytest.mark.parametrize(("function", "words"), slow_but_for([*KNOWN, ALONE], WRONG))
def test_a_wrong_solution_fails_its_own_checks_and_its_mistake_is_named(solve, function, words):
    """The functions that use it wait: the other mistakes show this."""
    solve(function, WRONG[function, words])
    outcomes = outcomes_of(function, users=(function, words) not in KNOWN)
    first, *failed = [outcome for outcome in outcomes.values() if outcome.state == FAILED]
    others = {outcome[:2] for check, outcome in outcomes.items() if check.function != function}
    assert others in (set(), {(WAITING, f"waits for {function}")})
    for outcome in (first, *failed):
        assert re.fullmatch(FORM, outcome.message), outcome.message
        assert "grader" not in outcome.message
    # With 20 rows, pytest prints at most 40 (tests/project/test_grader_output.py).
    assert sum(ceil(len(line) / 80) for line in first.message.splitlines()) <= 20, first.message
    assert first.hint.startswith(words if (function, words) in KNOWN else "")
    assert {outcome.hint for outcome in failed} <= {""}


@pytest.mark.parametrize("users", slow_but_for([False], [False, True]))
@pytest.mark.parametrize(
    ("function", "way"), [(name, way) for name in FUNCTIONS for way in ("plainly", *RIGHT[name])]
)
def test_a_right_solution_passes(solve, function, way, users):
    """users: the checks of the functions that use it pass, too."""
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    outcomes = outcomes_of(function, users)
    assert {
        check.name: outcome for check, outcome in outcomes.items() if outcome.state != PASSED
    } == {}


def test_a_right_solution_for_these_columns_only_has_a_note(solve):
    solve("extract_and_convert", RIGHT["extract_and_convert"]["the columns named"])
    notes = [
        outcome.hint
        for outcome in outcomes_of("extract_and_convert", users=False).values()
        if outcome.hint
    ]
    (note,) = notes
    assert note.startswith("Your extract_and_convert does not convert a CSV with other columns.")


@pytest.mark.parametrize(
    ("name", "value", "note"),
    [
        (
            "csv",
            0,
            "main always reads NC_FP. With page.csv, experiments and the CSV of a command would work, too.",
        ),
        ("THETA_INIT", 45, "THETA_INIT is 45 radians. Is it in degrees?"),
        (
            "DT",
            0.01,
            "DT is 0.01 s. Such long ticks are not exact, and bobs pass through each other.",
        ),
    ],
)
def test_a_right_main_with_a_trap_has_a_note(solve, monkeypatch, name, value, note):
    if name == "csv":
        solve("main", RIGHT["main"]["NC_FP"])
    for module in ("test_a", "src.visualize_cradle_run") if value else ():
        monkeypatch.setattr(f"{module}.{name}", value)
    notes = [outcome.hint for outcome in outcomes_of("main").values() if outcome.state == PASSED]
    assert [hint for hint in notes if hint] == [note]


# --- hints -----------------------------------------------------------------------------------------------------------


def test_each_row_has_a_mistake_each_function_its_steps_and_each_check_a_title_of_its_own(
    monkeypatch,
):
    """In the words of a row, a place for a value is any word."""
    rows = [
        words for name, (*_, words) in hints.ERRORS.items() if name not in ("no Python", "newer")
    ]  # files have them
    rows += [words for _, words in hints.FORMS.values()]
    rows += hints.MEANING.values()
    compared = grader.compared

    def note(*arguments, results=(), **options):
        rows.extend(words for _, words in results)
        return compared(*arguments, **options)

    monkeypatch.setattr(grader, "compared", note)
    assert {Grading().judge(check).state for check in CHECKS} == {PASSED}
    begins = [words.split() for mistakes in HINTED.values() for words in mistakes]
    for words in rows:
        pairs = [
            zip(words.replace("{{ }}", "{ }").split(), begin, strict=False) for begin in begins
        ]
        assert any(
            all(word == said or re.search("{.", word) for word, said in each) for each in pairs
        ), words
    assert {*grader.STEPS} == {*FUNCTIONS}
    lines = [line for steps in grader.STEPS.values() for line in steps.python]
    assert max(map(len, lines)) <= 80 - 9  # one row of the screen
    assert [ast.parse(line + "\n  ..." * (":  #" in line)) for line in lines]
    titles = [check.title for check in CHECKS]
    assert len({*titles, *(check.name for check in CHECKS)}) == 2 * len(titles)


def test_the_parts_of_the_formulas_are_those_of_the_appendix(solve):
    """They follow from the results, which were found by hand; here, they come from the formulas."""
    solve("angle_update", "return 1, 1")
    assert failures("angle_update")[0].facts == [
        "Right here: sin(theta) = 0.5, acceleration = -10, omega_new = 2, theta_new = 2.81799."
    ]
    solve("handle_collision", "return 1, 1")
    v1, v2 = 0.4 * 3, 0.4 * -4
    momentum = 2 * v1 + 8 * v2
    new = [(momentum + part * 0.7 * (v1 - v2)) / 10 for part in (-8, 2)]
    parts = re.findall(r" = (-?[\d.]*\d)", failures("handle_collision")[0].facts[0])
    assert [*map(float, parts)] == pytest.approx([v1, v2, momentum, v1 - v2, *new])


def test_two_mistakes_with_the_same_result_have_no_hint():
    first, second = (2.0, "You doubled it."), (2.0, "You added 1.")
    assert (
        comparing.hint_for_result(2.0, [first])
        == comparing.hint_for_result(2.0, [first, first])
        == "You doubled it."
    )
    assert (
        comparing.hint_for_result(2.0, [first, second])
        == comparing.hint_for_result(3.0, [first])
        == ""
    )


# --- messages --------------------------------------------------------------------------------------------------------


def test_a_failure_says_it_all_in_order(solve):
    solve("handle_two_bobs", ("e = pend1", "e = pend2"))
    assert failures("handle_two_bobs")[0].message.splitlines() == [
        "wrong       omega of pend1 is 0, not 1.",
        "called      handle_two_bobs(pend1, pend2, r_param=4)",
        "            pend1: mass 1, e 0.5, omega 4, bob (0, -4, 0), radius 0.5",
        "            pend2: mass 1, e 1, omega 0, bob (1, -4, 0), radius 0.5",
        "came back   omega of pend1, omega of pend2: (0, 4)",
        "expected    omega of pend1, omega of pend2: (1, 3)",
        "read        handout, Handling Collisions (B Tests), and Appendix: Conservation",
        "            Laws: handle_two_bobs",
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
    words = " ".join(failures("extract_and_convert")[0].message.split())
    file = " ".join(import_module("test_d").FILES["seven.csv"].split())
    assert (
        f" is the path of seven.csv: {file} came back at index 0: {{'mass': 12.62, 'e': 1," in words
    )
    assert " 'texture': 'none'} expected at index 0: {'mass': 12.625, 'e': 1," in words


STRANGE = {  # what a body returns or raises
    "return angle_update(omega, theta, r_param, dt, g)": "it raised   RecursionError: maximum recursion depth exceeded",
    "a = []; a.append(a); return a": "came back   a list that contains itself",
    "return list(range(10**5))": "came back   [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18,\n"
    "             19, ... (100000 in all)]",
    "class Odd:\n    def __repr__(self): return 1 / 0\nreturn Odd()": "came back   a Odd that has no text",
    "class Odd(Exception):\n    def __str__(self): return 1 / 0\nraise Odd": "it raised   Odd, which has no text",
    # Both values would look the same with six digits.
    "return 2.000004, 5 * 3.141592653589793 / 6 + 0.2": "came back   (2.000004, 2.81799387799149)",
    "raise GeneratorExit": "it raised   GeneratorExit:\n",
    "import sys; sys.exit('the end')": "it raised   SystemExit: the end\n",
    "raise KeyboardInterrupt": "it raised   KeyboardInterrupt:\n",
    "import os; os._exit(0)": "it raised   SystemExit: os._exit(0)\n",
    "return float(input('omega? '))": "it raised   EOFError: input() waits for somebody, but nobody answers in a",
}


@pytest.mark.parametrize("body", STRANGE)
def test_a_strange_result_is_shown_in_a_few_lines(solve, body):
    """What would end the program ends its check only."""
    solve("angle_update", body)
    first = failures("angle_update")[0]
    assert "\n" + STRANGE[body] in first.message
    assert first.message.count("\n") < 15
    is_end = first.hint == "This line ends the whole program. Remove it; return ends a function."
    assert is_end == ("SystemExit" in STRANGE[body] or "KeyboardInterrupt" in STRANGE[body])


@pytest.mark.parametrize("code", ["1 / 0", "import nothing_of_that_name"])
def test_only_lines_of_files_are_a_students(monkeypatch, code):
    """Not "<string>", and not Python's import code, even if the tests start in src/."""
    monkeypatch.chdir(ROOT / "src")
    with pytest.raises((ZeroDivisionError, ModuleNotFoundError)) as raised:
        exec(code)
    assert own_places(raised.value) == ((), [])


# --- limits ----------------------------------------------------------------------------------------------------------

on_linux = pytest.mark.skipif(
    not limits.MEMORY_IN_USE.exists(), reason="the memory is limited on Linux"
)
MEMORY = 60.0, "took more than 20 MB of memory"


@pytest.mark.parametrize(
    ("body", "patience", "words"),
    [
        ("import time; time.sleep(100)", 0.1, "waited longer than 1 s"),
        # Python 3.11 catches nothing in a loop right below try.
        (
            "try:\n omega = 0\n while True: omega += 1\nexcept: pass\nwhile True: pass",
            0.3,
            "took longer than 0.3 s",
        ),
        pytest.param("rows = [omega]\nfor row in rows: rows.append(row)", *MEMORY, marks=on_linux),
    ],
)
def test_what_takes_too_much_is_stopped_and_not_called_again(
    solve, monkeypatch, capsys, body, patience, words
):
    monkeypatch.setattr(limits, "PATIENCE", patience)
    monkeypatch.setattr(limits, "MOST_MEMORY", 20)
    resource = import_module("resource") if os.name == "posix" else None
    before = resource and resource.getrlimit(resource.RLIMIT_DATA)
    solve("angle_update", f"print('called')\n{body}")
    first, second, *_ = outcomes_of("angle_update", users=False).values()
    assert f"came back   nothing; it {words} and was stopped" in first.message
    assert f"angle_update {words}." in first.message
    assert (second.message, capsys.readouterr().out) == ("waits for angle_update", "called\n")
    assert before == (resource and resource.getrlimit(resource.RLIMIT_DATA))


@pytest.mark.parametrize(
    "line",
    ["import time; g == 8 and time.sleep(0.5)", "breakpoint()", "import pdb; pdb.set_trace()"],
)
def test_what_takes_no_processor_time_is_not_stopped(solve, monkeypatch, line):
    """On a busy machine, the clock goes on while nothing runs.

    Without a terminal, nobody can debug.
    """
    monkeypatch.setattr(limits, "PATIENCE", 0.3)
    monkeypatch.setattr(limits, "HAS_TERMINAL", False)
    solve("angle_update", f"{line}\n{dedent(PLAIN['angle_update'])}")
    assert failures("angle_update") == []


def test_a_file_that_never_ends_is_stopped_once(monkeypatch):
    code = compile("\nwhile True: pass", str(ROOT / "src" / "swinging.py"), "exec")
    imports = {"src.swinging": lambda _: exec(code, {})}
    monkeypatch.setattr(limits, "PATIENCE", 1.0)
    monkeypatch.delitem(sys.modules, "src.swinging")
    monkeypatch.setattr(
        students_code.importlib,
        "import_module",
        lambda name: imports.get(name, import_module)(name),
    )
    grading = Grading()
    first, second, *_ = (grading.judge(check) for check in checks(function="angle_update"))
    assert first.message.splitlines()[0] == "src/swinging.py, line 2:"
    assert first.message.endswith("took longer than 1 s\nDoes a loop in it ever end?")
    waiting = {
        second.message,
        *(grading.judge(check).message for check in checks(function="full_swing_update")),
    }
    assert waiting == {"waits for src/swinging.py"}


@pytest.mark.parametrize("catches", ["{}", "try: {}\nexcept BaseException: pass"])
def test_ctrl_c_ends_the_run_also_if_the_solution_catches_it(solve, catches):
    solve("angle_update", catches.format("__import__('signal').raise_signal(2)"))
    with pytest.raises(KeyboardInterrupt):
        Grading().judge(checks(function="angle_update")[0])
    limits.PRESSED.clear()  # for the tests that follow


@pytest.mark.skipif(not hasattr(os, "fork"), reason="only Linux and macOS have fork")
def test_a_process_that_a_solution_starts_can_end(solve):
    """A child that went on would run the tests a second time."""
    fork = "import os\nchild = os.fork()\nif not child: os._exit(0)\nos.waitpid(child, 0)"
    solve("angle_update", f"{fork}\n{dedent(PLAIN['angle_update'])}")
    assert failures("angle_update") == []


def test_a_solution_that_writes_the_shipped_file_fails_and_the_file_is_put_back(solve):
    before = Path(NC_FP).read_bytes()
    writes = "from src.pds_helper import write_to_csv; write_to_csv(pend_list)\n        return"
    solve("uniform_mass_newton_cradle", ("return", writes))
    assert (
        failures("uniform_mass_newton_cradle")[0].wrong
        == "uniform_mass_newton_cradle writes into a file."
    )
    assert Path(NC_FP).read_bytes() == before


def test_a_fault_of_the_grader_is_marked_as_such(monkeypatch):
    monkeypatch.setattr(grader, "CHECKS", {})

    @check("angle_update")
    def test_with_a_fault():
        """A sentence."""
        expect("angle_update", 1 / 0, wanted=None)

    outcome = Grading().judge(grader.CHECKS["test_with_a_fault"])
    first, *others = outcome.message.splitlines()
    assert (
        first == "This is a fault of the grader, not of your code. Please show it to your teacher."
    )
    assert (outcome.state, others[-1]) == (FAULT, "ZeroDivisionError: division by zero")


def test_a_function_that_is_not_written_waits_and_so_do_written_functions_that_use_it(solve):
    waits = dict.fromkeys(
        ["newton_cradle_tick", "main"], "waits for angle_update, full_swing_update"
    )
    for name in ("angle_update", "full_swing_update"):
        solve(name, STUB.format(name))
        waits[name] = f"waits for you to write {name} in src/my_{name}.py, line 2"
    outcomes = {
        (check.function, *outcome[:2]) for check, outcome in outcomes_of("angle_update").items()
    }
    assert outcomes == {(name, WAITING, words) for name, words in waits.items()}


def test_a_function_waits_for_one_that_it_need_not_use(solve):
    solve("uniform_mass_newton_cradle", STUB.format("uniform_mass_newton_cradle"))
    solve("uniform_e_newton_cradle", "return uniform_mass_newton_cradle(relative_filepath, e_val)")
    outcome = Grading().judge(checks(function="uniform_e_newton_cradle")[0])
    assert outcome[:2] == (WAITING, "waits for uniform_mass_newton_cradle")
