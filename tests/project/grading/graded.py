"""A student's functions in place of the project's, and the outcomes of their checks.

conftest.py takes over the fixture.
"""

import ast
import linecache
from functools import partial
from textwrap import dedent, indent

from grading.begin import ROOT

import pytest
from right_solutions import PLAIN

from grading.assignment import FUNCTIONS, needed, PROGRAM
from grading.grader import Grader
from grading.limits import Limits
from grading.outcomes import FAILED, Grading, Outcome, PASSED
from line_by_line.trace import Trace
from support.files import source_files

# No row of the tables needs to import these names.
IMPORTS = "from math import cos, sin; from vpython import vector"

GRADER = Grader()
CHECKS = [*GRADER.checks.values()]


def with_body(text, function, body):
    """Return the text of a file of src/ with another body of a function, or of the program's block.

    A function stands at the top, so that its def line is line 1.
    """
    nodes = {getattr(node, "name", PROGRAM): node for node in ast.parse(text).body}
    node = nodes[function]  # of those without a name, it is the last one
    lines = text.splitlines()
    del lines[node.lineno - 1 : node.end_lineno]
    body = indent(dedent(body), "    ")
    if function == PROGRAM:
        return "\n".join([IMPORTS, *lines, 'if __name__ == "__main__":', body])
    for parameter in node.args.args:
        parameter.annotation = None  # the imports stand below
    return "\n".join([f"def {function}({ast.unparse(node.args)}):", body, IMPORTS, *lines])


@pytest.fixture
def solve(monkeypatch):
    """A function that puts a version from the tables in place of a function, wherever it is used.

    PROGRAM stands for the program's block. No trace may have a fault: a student would not see it.
    """
    texts = {}
    faults = []
    code_of = source_files.code_of

    def code_of_text(file):
        if file not in texts:
            return code_of(file)
        entry = len(texts[file]), None, texts[file].splitlines(keepends=True), file
        monkeypatch.setitem(linecache.cache, file, entry)  # the lines in messages
        return compile(texts[file], file, "exec", dont_inherit=True)

    def solve(function, version):
        if isinstance(version, tuple):
            assert version[0] in PLAIN[function]
            version = PLAIN[function].replace(*version)
        path = ROOT / FUNCTIONS[function].file
        text = texts.get(f"{path}") or path.read_text(encoding="utf-8")
        texts[f"{path}"] = with_body(text, function, version)
        source_files.forget(source_files.source_modules())

    monkeypatch.setattr(source_files, "code_of", code_of_text)
    fault = property(lambda _: None, lambda _, fault: faults.append(fault))
    monkeypatch.setattr(Trace, "fault", fault, raising=False)
    with source_files.fresh_modules():
        yield solve
    for fault in filter(None, faults):
        raise fault


def new_grading(**limits):
    """Return a Grading with these limits; the others are wide: a busy machine can stall."""
    wide = {"end": pytest.fail, "patience": 60, "waiting": 600}
    GRADER.new_limits = partial(Limits, False, **{**wide, **limits})
    return Grading(GRADER)


def outcomes_of(function, users=True, **limits) -> dict:
    """Return the outcome of each check of this function; all others are passed.

    users: also those of the functions that use it.
    """
    judged = [
        check
        for check in CHECKS
        if check.function == function or users and function in needed(check.function)
    ]
    grading = new_grading(**limits)
    grading.outcomes = {check.name: Outcome(PASSED) for check in CHECKS if check not in judged}
    return {check: grading.judge(check) for check in judged}


def failures(function, **limits) -> list:
    outcomes = outcomes_of(function, users=False, **limits).values()
    return [outcome for outcome in outcomes if outcome.state == FAILED]
