"""The judge and the solver: they say the same as pytest in one process, and a solution reaches nothing else."""

import ast
import importlib
import sys
from textwrap import dedent, indent

import pytest
from grade_class import given_files
from programs import slow_but_for
from right_solutions import RIGHT
from students import put_files
from wrong_solutions import HINTED, PLAIN, UNHINTED

from grading import grader, own_process, raised
from grading.grader import checks, Grading, Outcome, PASSED
from grading.handout import FUNCTIONS
from teacher.judge import Solver

SOLUTIONS = {
    (function, words): version
    for table in (HINTED, UNHINTED, RIGHT)
    for function, versions in table.items()
    for words, version in versions.items()
}


def with_body(files, function, body):
    """Return the files of a solution with another body of a function."""
    name = FUNCTIONS[function].file
    lines = files[name].decode().splitlines()
    (node,) = (node for node in ast.parse(files[name]).body if getattr(node, "name", "") == function)
    lines[node.body[0].end_lineno : node.end_lineno] = indent(dedent(body).strip("\n"), "    ").splitlines()
    names = "from math import cos, sin", "from vpython import mag, vector"  # so that no row needs to import them
    return {**files, name: "\n".join([*names, *lines, ""]).encode()}


@pytest.fixture
def files(made, solved):
    """The files of a complete solution, by their paths in the project."""
    return {**given_files(made), **{f"src/{name}": content for name, content in solved.items()}}


def outcomes_of(function):
    """Return the outcomes of the checks of this function, without the calls. All others count as passed."""
    grading = Grading()
    grading.outcomes = {check.name: Outcome(PASSED) for check in grader.CHECKS.values() if check.function != function}
    return {check.name: grading.judge(check)._replace(call=None) for check in checks(function=function)}


@pytest.fixture
def judged(process, monkeypatch):
    """A function that returns the outcomes of a solution of this function in a solver."""

    def judged(files, function):
        solver = Solver(files, process)
        monkeypatch.setattr(grader, "runner", solver)
        try:
            solver.open()
            return outcomes_of(function)
        finally:
            process.end()

    return judged


@pytest.fixture
def graded_here(tmp_path, monkeypatch):
    """A function that returns the outcomes of a solution of this function in this process."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.syspath_prepend(tmp_path)
    for module in (own_process, raised):
        monkeypatch.setattr(module, "ROOT", tmp_path)

    def graded_here(files, function):
        put_files(tmp_path, files)
        own = own_process.OwnProcess()
        own.watch = Solver.watch
        monkeypatch.setattr(grader, "runner", own)
        importlib.invalidate_caches()
        with own.again():
            return outcomes_of(function)

    return graded_here


@pytest.mark.parametrize(("function", "words"), slow_but_for([*SOLUTIONS][::9], [*SOLUTIONS]))
def test_a_solver_gives_the_same_outcomes_and_words_as_one_process(files, judged, graded_here, function, words):
    version = SOLUTIONS[function, words]
    body = PLAIN[function].replace(*version) if isinstance(version, tuple) else version
    files = with_body(files, function, body)
    assert judged(files, function) == graded_here(files, function)
