"""The search for one change that makes all checks pass, and the words for a mistake in code with harmless lines."""

import ast
import linecache
import re
from contextlib import ExitStack
from textwrap import dedent
from unittest.mock import patch

import pytest
from programs import slow_but_for
from students import change, write
from test_graded_suites import MODULES, patient, solve, WRONG  # noqa: F401  two of them are fixtures
from test_grader_output import run
from wrong_solutions import FOUND, PLAIN

from grading import grader, limits, search
from grading.grader import checks, Grading
from grading.handout import FUNCTIONS
from grading.own_process import working_in

pytestmark = pytest.mark.filterwarnings("ignore::SyntaxWarning")  # of a change, such as (1, 2)["mass"]


def searched(check, line):
    """Do what search.one_change does, in this process, with the function that solve has put into its module."""
    scope, runner = vars(MODULES[check.function]), search.Quick()
    kept = scope[check.function]
    own = ast.parse("".join(linecache.getlines(kept.__code__.co_filename))).body[0]
    with ExitStack() as stack:
        for each in (patch.object(grader, "runner", runner), working_in(runner.folder.name), limits.without_ends()):
            stack.enter_context(each)
        stack.callback(scope.__setitem__, check.function, kept)
        return search.first_change(own, scope, check.name, line)


def first_failure(function, look=searched):
    grading = Grading(look)
    return next(one for one in map(grading.judge, checks(function=function)) if one.state == grader.FAILED)


def body(function, version):
    return dedent(version if isinstance(version, str) else PLAIN[function].replace(*version))


def test_a_print_that_changes_the_result_is_named(solve):  # noqa: F811
    solve("uniform_mass_newton_cradle", ("return", "print(pend_list.pop())\n        return"))
    assert first_failure("uniform_mass_newton_cradle").hint.startswith("Without your prints, all checks pass")


def test_a_change_that_loops_is_stopped(solve, monkeypatch):  # noqa: F811
    monkeypatch.setattr(search, "A_CHANGE", 0.2)
    loop = "i = 0\nwhile i < len(pend_list):\n    swing_update(pend_list[i], r_param, g, dt)\n    i += 1"
    solve("full_swing_update", loop)
    assert "another order belongs in the ( ) of swing_update" in first_failure("full_swing_update").hint


HARMLESS = f"""\
'A docstring about sin, cos, round and return.'
# {" ".join(FUNCTIONS)}: R_PARAM, THETA_INIT, DT and G are constants; pend_list[i + 1] == append = while
print(round(1.25, 1), cos(0), "and", 1.05)
if len("never") < 1:
    raise ValueError("omega")
"""


def told(solve, function, source, look=None):  # noqa: F811
    """Return what the first check that fails says, without the numbers of lines."""
    solve(function, source)
    first = first_failure(function, look)
    return [re.sub(r"\b([Ll]ines?) \d+(, \d+)*", r"\1", text) for text in (first.hint, first.wrong, first.values)]


@pytest.mark.parametrize(("function", "words"), slow_but_for([*WRONG][::9], WRONG))
def test_harmless_lines_change_no_word(solve, function, words):  # noqa: F811
    source = body(function, WRONG[function, words])
    assert told(solve, function, HARMLESS + source) == told(solve, function, source)


@pytest.mark.parametrize(("function", "version", "words"), slow_but_for(FOUND[::3], FOUND))
def test_a_change_with_which_all_checks_pass_is_named_and_not_shown(solve, monkeypatch, function, version, words):  # noqa: F811
    """Also with harmless lines. No other words come first."""
    monkeypatch.setattr(grader, "words_for", lambda *known: known[-1]()[::-1])
    monkeypatch.setattr(search, "A_CHANGE", 5.0)  # s: a busy machine can stall
    source = body(function, version)
    (hint, *others), harmless = (told(solve, function, lines + source, searched) for lines in ("", HARMLESS))
    assert re.match(r"One change.* makes all checks pass: ", hint)
    assert words in hint
    assert [hint, *others] == harmless
    right = [line.strip() for line in PLAIN[function].split("\n") if line.strip() not in source]
    assert not [line for line in right if line in hint]


def test_pytest_looks_for_a_change_in_a_process_of_its_own_and_leaves_nothing_behind(starter, tmp_path, monkeypatch):
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    change(starter / "tests/grading/search.py", "SECONDS, A_CHANGE = 6.0,", "SECONDS, A_CHANGE = 60.0,")
    write(starter, *FUNCTIONS, angle_update="print('noise')\n" + body("angle_update", ("sin(theta)", "sin(omega)")))
    number = 1 + (starter / "src/swinging.py").read_text().partition("sin(omega)")[0].count("\n")

    def files():
        return {path: path.read_bytes() for path in starter.rglob("*") if path.is_file() and path.suffix != ".pyc"}

    before = files()
    for options in ([], ["--no-search"], ["--grade-json", str(tmp_path / "grade.json")]):
        _, rows = run(starter, *options)
        lines, words = "\n".join(rows), " ".join(" ".join(rows).split())
        assert ("Looking for one change with which all checks of angle_update pass ..." in lines) == (not options)
        assert ("another name belongs in place of omega." in words) == (not options)
        assert (f"Next: angle_update in src/swinging.py, line {number}." in words) == (not options)
        assert lines.count("noise") == 1
    assert files() == before
    assert [*temporary.iterdir()] == []
