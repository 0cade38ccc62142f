"""The graded suites reject wrong solutions, accept correct ones, and name the mistake."""

import re

from grading.begin import ROOT

import pytest
from graded import CHECKS, GRADER, new_grading, outcomes_of
from programs import slow_except
from right_solutions import PLAIN, RIGHT
from wrong_solutions import WRONG

from grading import comparing, grader
from grading.assignment import FUNCTIONS
from grading.hints import ROWS
from grading.outcomes import FAILED, PASSED, WAITING
from grading.students_code import is_watched
from grading.words import WORDS
from line_by_line.trace import Trace


def explained(outcome):
    """Return what a student reads, without the table, as a text with single spaces."""
    return " ".join(" ".join([*outcome.explanation.wrong, *outcome.explanation.below]).split())


@pytest.mark.parametrize(("function", "words"), slow_except([*WRONG][2::5], WRONG))
def test_a_wrong_solution_fails_its_own_checks_and_its_mistake_is_named(solve, function, words):
    """The functions that use it are right: stand-ins take its place."""
    solve(function, WRONG[function, words])
    failed = []
    for judged, outcome in outcomes_of(function).items():
        if judged.function != function:
            assert outcome.state == PASSED
        elif outcome.state == FAILED:
            failed.append(outcome)
    if function in GRADER.alone and not words.startswith("shapes"):
        assert new_grading().perform(GRADER.alone[function]).state != PASSED
    for outcome in failed:
        assert "grader" not in outcome.message
        assert len(outcome.explanation.wrong) <= 20
        assert outcome is failed[0] or not outcome.explanation.below
    assert words in explained(failed[0])


@pytest.mark.slow
def test_each_check_and_each_hint_has_a_wrong_solution(solve, monkeypatch):
    # test_subject.py shows files that import each other
    hints = {hint.partition("\\1")[0] for kind, _, hint in ROWS if kind is not ImportError}
    compared = grader.compared

    def noting(*arguments, results=(), **options):
        # A mistake in a formula has a hint for the first one, the second one and both
        hints.update(re.split("formulas?, ", hint)[-1] for _, hint in results)
        return compared(*arguments, results=results, **options)

    monkeypatch.setattr(grader, "compared", noting)
    failed = set()
    stories = ""
    for (function, _), version in WRONG.items():
        solve(function, version)
        for check, outcome in outcomes_of(function, users=False).items():
            if outcome.state == FAILED:
                failed.add(check)
                stories += explained(outcome)
        solve(function, PLAIN[function])
    assert {*CHECKS} - failed == set()
    assert {hint for hint in hints if hint not in stories} == set()


WAYS = [(name, way) for name in FUNCTIONS for way in ("plainly", *RIGHT[name])]
# They do the work of the function that they could call
BY_ITSELF = "with pandas", "by itself", "without handle_collision", "each pair when both swung"


@pytest.mark.parametrize(("function", "way"), WAYS)
def test_a_right_solution_passes_and_with_stand_ins_it_passes_or_waits(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    for outcome in outcomes_of(function).values():
        assert outcome.state == PASSED, outcome
    if function in GRADER.alone:
        outcome = new_grading().perform(GRADER.alone[function])
        assert outcome.state == (WAITING if way in BY_ITSELF else PASSED)


def test_beside_a_wrong_function_another_one_is_told_once(solve):
    """One that has not called the stand-in waits for what is wrong."""
    solve("extract_and_convert", "return []")
    solve("elastic_newton_cradle", "return 7")
    solve("make_newton_cradle", "return extract_and_convert(relative_filepath)")
    outcomes = outcomes_of("extract_and_convert").items()
    waits = {check.function: outcome.waits_for for check, outcome in outcomes if outcome.waits_for}
    assert waits["elastic_newton_cradle"] == "extract_and_convert"
    assert waits["make_newton_cradle"] == "make_newton_cradle"  # all its checks but the first one


@pytest.mark.slow
@pytest.mark.parametrize(("function", "way"), WAYS[::2])
def test_a_traced_function_does_what_it_does_untraced(solve, function, way):
    solve(function, RIGHT[function].get(way, PLAIN[function]))
    new_grading()
    for check in GRADER.checks_of(function):
        GRADER.perform(check, Trace(WORDS, lambda code: is_watched(code, function)))


def test_two_mistakes_with_the_same_result_have_no_hint():
    first = (2.0, "You doubled it.")
    second = (2.0, "You added 1.")
    assert comparing.hint_for_result(2.0, 1.0, [first, first]) == "You doubled it."
    assert comparing.hint_for_result(2.0, 1.0, [first, second]) == ""
