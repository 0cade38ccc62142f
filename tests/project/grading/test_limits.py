"""What the graded suites do with a solution without end, and with one that waits."""

from pathlib import Path

from grading.begin import ROOT

import pytest
from graded import CHECKS, failures, GRADER, new_grading, outcomes_of
from right_solutions import RIGHT
from students import LOOP, MAKE

from grading import limits
from grading.assignment import PROGRAM, SWINGING
from grading.outcomes import FAULT
from support.constants import NC_FP
from support.files import source_files

STUB = 'raise NotImplementedError("{} is not written yet")'


CAUGHT = """\
try:
    while True: pass
except BaseException: return 2.0, 2.817993878"""
# A function, a body that takes too long or too much, its limits, and what is said
STOPPED = [
    ("angle_update", "import time; time.sleep(100)", {"waiting": 0.3}, "waited longer than 0.3 s"),
    ("angle_update", "while True: omega += 1", {"patience": 0.3}, "took longer than 0.3 s"),
    pytest.param(
        "angle_update",
        "rows = []\nwhile True: rows.append(b'1' * 10**6)",
        {"memory": 20},
        "took more than 20 MB of memory",
        marks=pytest.mark.skipif(not limits.MEMORY_IN_USE.exists(), reason="Linux limits it"),
    ),
    (PROGRAM, "while True: pass", {"patience": 0.3}, "took longer than 0.3 s"),
    ("angle_update", CAUGHT, {"patience": 0.3}, "took longer than 0.3 s"),
]


@pytest.mark.parametrize(("function", "body", "within", "message"), STOPPED)
def test_what_takes_too_much_is_stopped_and_not_called_again(
    solve, capsys, function, body, within, message
):
    """The lines of what waits are not watched."""
    solve(function, f"print('called')\n{body}")
    first, second, *_ = outcomes_of(function, users=False, **within).values()
    assert f"{function} {message}." in first.message
    assert ("rate?" in first.message) == (function == PROGRAM)
    assert bool(first.explanation.rows) == ("waiting" not in within)
    assert second.message == f"waits for {function}"
    assert capsys.readouterr().out == "called\n"
    bytearray(10**8)  # the memory is limited no longer


def test_a_file_that_never_ends_is_stopped_once(solve, monkeypatch):
    endless = compile("\nwhile True: pass", ROOT / SWINGING, "exec")
    monkeypatch.setattr(source_files, "code_of", lambda file: endless)
    grading = new_grading(patience=0.3)
    first, *others = [grading.judge(check) for check in CHECKS if check.tier == "C"]
    message = first.message
    assert message.startswith("src/swinging.py, line 2:\n")
    assert message.endswith("took longer than 0.3 s.\nDoes a loop in it ever end?")
    assert {other.message for other in others} == {"waits for src/swinging.py"}


AGAIN = """\
angle_update.calls = getattr(angle_update, 'calls', 0) + 1
if angle_update.calls == 2: {}
return 1, 1"""


# Python loses an error in such a callback, and pytest warns of it
FREED = """\
import signal, weakref
class Thing: pass
weakref.finalize(Thing(), signal.raise_signal, 2)
return 1, 1"""


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("catches", ["{}", "try: {}\nexcept BaseException: pass", AGAIN, FREED])
def test_ctrl_c_ends_the_run_also_if_the_solution_catches_it(solve, catches):
    solve("angle_update", catches.format("__import__('signal').raise_signal(2)"))
    with pytest.raises(KeyboardInterrupt):
        outcomes_of("angle_update")


def test_a_program_may_write_the_shipped_file_and_the_students_own_stays_as_it_is(solve):
    before = Path(NC_FP).read_bytes()
    solve(PROGRAM, RIGHT[PROGRAM]["pendula of its own first"])
    assert not failures(PROGRAM)
    assert Path(NC_FP).read_bytes() == before


def test_a_fault_of_the_grader_is_marked_as_such():
    outcome = new_grading().perform(CHECKS[0]._replace(ask=lambda: 1 / 0))
    assert outcome.state == FAULT
    assert outcome.message.startswith("This is a fault of the grader")
    assert outcome.message.endswith("ZeroDivisionError: division by zero")


def test_a_function_that_is_not_written_waits_and_those_that_use_it_are_judged(solve):
    messages = {"newton_cradle_tick": "", PROGRAM: ""}
    for name, line in (("angle_update", 5), ("full_swing_update", 2)):
        solve(name, STUB.format(name))
        messages[name] = f"waits for you to write {name} in src/swinging.py, line {line}"
    outcomes = outcomes_of("angle_update")
    assert {check.function: outcome.message for check, outcome in outcomes.items()} == messages


def test_a_function_that_calls_one_that_is_not_written_waits_for_it(solve):
    solve("elastic_newton_cradle", "return extract_and_convert(relative_filepath)")
    solve("extract_and_convert", STUB.format("extract_and_convert"))
    (outcome,) = outcomes_of("elastic_newton_cradle", users=False).values()
    assert outcome.message == "waits for extract_and_convert"


# A function, its body, and whether there is code beside the raise
STUBS = [
    ("angle_update", "omega_new = omega\nRAISE\nreturn omega_new, theta", True),
    (PROGRAM, f"{MAKE}\n{LOOP}\n    RAISE", False),
]


@pytest.mark.parametrize(("function", "body", "has_code"), STUBS)
def test_a_function_with_code_beside_its_raise_is_written(solve, function, body, has_code):
    solve(function, body.replace("RAISE", STUB.format(function)))
    outcomes = [*outcomes_of(function, users=False).values()]
    assert any(outcome.is_unwritten for outcome in outcomes) != has_code
    end = f", raise NotImplementedError: it stops {function} before its end."
    assert (end in " ".join(outcomes[0].message.split())) == has_code


def test_a_mistake_has_its_table_also_if_other_checks_run_first(solve):
    solve("uniform_e_newton_cradle", "return uniform_mass_newton_cradle(relative_filepath, e_val)")
    outcome = new_grading().judge(GRADER.checks_of(function="uniform_e_newton_cradle")[0])
    assert len(outcome.explanation.rows) == 1
