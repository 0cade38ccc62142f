"""What the graded suites do with a solution without end, and with one that waits."""

import re
import sys
from importlib import import_module
from pathlib import Path
from textwrap import dedent

from grading.begin import ROOT

import pytest
from graded import failures, outcomes_of
from programs import on_posix
from right_solutions import PLAIN, RIGHT
from students import LOOP, MAKE, TICK

from grading import grader, limits, students_code
from grading.grader import check, checks, expect
from grading.handout import PROGRAM
from grading.outcomes import FAULT, Grading, WAITING
from support.constants import NC_FP

BUSY = 1000  # for WAITING: a busy machine may give this test little processor time
STUB = 'raise NotImplementedError("{} is not written yet")'


def require_stopped(message):
    """Require that angle_update is stopped with this message, and not called again."""
    first, second, *_ = outcomes_of("angle_update", users=False).values()
    assert f"came back   nothing; it {message} and was stopped" in first.message
    assert f"angle_update {message}." in first.message
    assert second.message == "waits for angle_update"


@pytest.mark.parametrize(
    ("body", "patience", "waiting", "message"),
    [
        ("import time; time.sleep(100)", 0.03, 10, "waited longer than 0.3 s"),
        # Python catches nothing in a loop right below try.
        (
            "try:\n omega = 0\n while True: omega += 1\nexcept: pass\nwhile True: pass",
            0.3,
            BUSY,
            "took longer than 0.3 s",
        ),
    ],
)
def test_what_takes_too_long_is_stopped(
    solve, monkeypatch, capsys, body, patience, waiting, message
):
    monkeypatch.setattr(limits, "PATIENCE", patience)
    monkeypatch.setattr(limits, "WAITING", waiting)
    solve("angle_update", f"print('called')\n{body}")
    require_stopped(message)
    assert capsys.readouterr().out == "called\n"


@pytest.mark.skipif(not limits.MEMORY_IN_USE.exists(), reason="the memory is limited on Linux")
def test_what_takes_too_much_memory_is_stopped(solve, monkeypatch):
    """Its lines are not watched, and the grader has its memory back."""
    resource = import_module("resource")
    before = resource.getrlimit(resource.RLIMIT_DATA)
    monkeypatch.setattr(limits, "MOST_MEMORY", 20)
    solve("angle_update", "rows = [omega]\nfor row in rows: rows.append(row)")
    require_stopped("took more than 20 MB of memory")
    assert not any(part.is_row for part in failures("angle_update")[0].parts)
    assert resource.getrlimit(resource.RLIMIT_DATA) == before


# A child that went on would run the tests a second time.
FORK = "import os\nchild = os.fork()\nif not child: os._exit(0)\nos.waitpid(child, 0)"


@pytest.mark.parametrize(
    "lines",
    [
        "import time; g == 8 and time.sleep(0.5)",
        "breakpoint()",
        "import pdb; pdb.set_trace()",
        pytest.param(FORK, marks=on_posix),
    ],
)
def test_what_takes_no_processor_time_is_not_stopped(solve, monkeypatch, lines):
    """On a busy machine, the clock goes on while nothing runs.

    Without a terminal, nobody can debug.
    """
    monkeypatch.setattr(limits, "PATIENCE", 0.3)
    monkeypatch.setattr(limits, "HAS_TERMINAL", False)
    solve("angle_update", f"{lines}\n{dedent(PLAIN['angle_update'])}")
    assert failures("angle_update") == []


def test_a_file_that_never_ends_is_stopped_once(monkeypatch):
    code = compile("\nwhile True: pass", str(ROOT / "src" / "swinging.py"), "exec")

    def import_endless(name):
        if name == "src.swinging":
            exec(code, {})
        return import_module(name)

    monkeypatch.setattr(limits, "PATIENCE", 0.3)
    monkeypatch.setattr(limits, "WAITING", BUSY)
    monkeypatch.delitem(sys.modules, "src.swinging")
    monkeypatch.setattr(students_code.importlib, "import_module", import_endless)
    grading = Grading()
    first, *others = checks(function="angle_update") + checks(function="full_swing_update")
    message = grading.judge(first).message
    assert message.startswith("src/swinging.py, line 2:\n")
    assert message.endswith("took longer than 0.3 s.\nDoes a loop in it ever end?")
    assert {grading.judge(other).message for other in others} == {"waits for src/swinging.py"}


@pytest.mark.parametrize("catches", ["{}", "try: {}\nexcept BaseException: pass"])
def test_ctrl_c_ends_the_run_also_if_the_solution_catches_it(solve, catches):
    solve("angle_update", catches.format("__import__('signal').raise_signal(2)"))
    with pytest.raises(KeyboardInterrupt):
        Grading().judge(checks(function="angle_update")[0])


def test_a_solution_that_writes_the_shipped_file_fails_and_the_file_is_put_back(solve):
    before = Path(NC_FP).read_bytes()
    writes = "from src.pds_helper import write_to_csv; write_to_csv(pend_list)\n        return"
    solve("uniform_mass_newton_cradle", ("return", writes))
    message = failures("uniform_mass_newton_cradle")[0].message
    assert "uniform_mass_newton_cradle writes into a file." in message
    assert Path(NC_FP).read_bytes() == before


def test_a_program_that_never_asks_is_stopped_once_and_its_line_is_named(solve, monkeypatch):
    monkeypatch.setattr(limits, "PATIENCE", 0.3)
    monkeypatch.setattr(limits, "WAITING", BUSY)
    solve(PROGRAM, ("is_running(pend_list)", "True"))
    first, *others = outcomes_of(PROGRAM, users=False).values()
    assert first.message.startswith("wrong       the program took longer than 0.3 s. ")
    assert first.hint == "Does a loop in it go on without is_running, and without rate?"
    assert re.search(r"and was stopped here:\n +src/visualize_cradle_run\.py, line", first.message)
    assert {other.message for other in others} == {"waits for the program"}


@pytest.mark.parametrize(
    ("function", "line", "mode"),
    [("uniform_mass_newton_cradle", "return", "r"), (PROGRAM, "pend_list =", "a")],
)
def test_a_solution_cannot_reach_the_real_csv(solve, function, line, mode):
    """Nor when a test of the student's has imported its function before."""
    solve(function, (line, f"open({NC_FP!r}, {mode!r})\n        {line}"))
    message = " ".join(failures(function)[0].message.split())
    assert "checks have a CSV of their own: use the path that they give" in message


def test_a_fault_of_the_grader_is_marked_as_such(monkeypatch):
    monkeypatch.setattr(grader, "CHECKS", {})

    @check("angle_update")
    def test_with_a_fault():
        """A sentence."""
        expect("angle_update", 1 / 0, expected=None)

    outcome = Grading().judge(grader.CHECKS["test_with_a_fault"])
    assert outcome.state == FAULT
    assert outcome.message.startswith("This is a fault of the grader, not of your code.")
    assert outcome.message.endswith("ZeroDivisionError: division by zero")


def test_a_function_that_is_not_written_waits_and_so_do_written_functions_that_use_it(solve):
    waits = {}
    for name in ("newton_cradle_tick", PROGRAM):
        waits[name] = "waits for angle_update, full_swing_update"
    for name in ("angle_update", "full_swing_update"):
        solve(name, STUB.format(name))
        waits[name] = f"waits for you to write {name} in src/my_{name}.py, line 2"
    messages = {}
    for waiting_check, outcome in outcomes_of("angle_update").items():
        assert outcome.state == WAITING
        messages[waiting_check.function] = outcome.message
    assert messages == waits


# A function, its body, and whether there is code beside the raise
STUBS = [
    ("extract_and_convert", "df = pd.read_csv(relative_filepath)\nRAISE", False),
    ("angle_update", "'What it returns.'\nRAISE", False),
    ("angle_update", "omega_new = omega\nRAISE\nreturn omega_new, theta", True),
    (PROGRAM, f"RAISE\n{LOOP}\n    RAISE", False),
    (PROGRAM, f"{MAKE}\n{LOOP}\n    RAISE", False),
    (PROGRAM, f"{MAKE}\nRAISE\n{LOOP}\n    {TICK}", True),
]


@pytest.mark.parametrize(("function", "body", "has_code"), STUBS)
def test_a_function_with_code_beside_its_raise_is_written(solve, function, body, has_code):
    solve(function, body.replace("RAISE", STUB.format(function)))
    first, *others = outcomes_of(function, users=False).values()
    assert any(outcome.is_unwritten for outcome in (first, *others)) == (not has_code)
    end = f", raise NotImplementedError: it stops {function} before its end."
    assert first.hint.startswith("Delete line ") == first.hint.endswith(end) == has_code


def test_a_function_waits_for_one_that_it_need_not_use(solve):
    solve("uniform_mass_newton_cradle", STUB.format("uniform_mass_newton_cradle"))
    solve("uniform_e_newton_cradle", "return uniform_mass_newton_cradle(relative_filepath, e_val)")
    outcome = Grading().judge(checks(function="uniform_e_newton_cradle")[0])
    assert outcome[:2] == (WAITING, "waits for uniform_mass_newton_cradle")


def test_the_program_waits_for_one_that_it_need_not_use(solve):
    solve("elastic_newton_cradle", "return None")
    solve(PROGRAM, RIGHT[PROGRAM]["an elastic cradle first"])
    outcome = Grading().judge(checks(function=PROGRAM)[0])
    assert outcome[:2] == (WAITING, "waits for elastic_newton_cradle")


def test_a_mistake_has_its_table_also_if_other_checks_run_first(solve):
    solve("uniform_e_newton_cradle", "return uniform_mass_newton_cradle(relative_filepath, e_val)")
    outcome = Grading().judge(checks(function="uniform_e_newton_cradle")[0])
    assert sum(part.is_row for part in outcome.parts) == 1
