"""A student's functions in place of the project's, and the outcomes of their checks.

conftest.py takes over the fixture.
"""

import ast
import linecache
import sys
from importlib import import_module
from inspect import Signature, signature
from math import cos, sin
from pathlib import Path
from textwrap import dedent, indent

from grading.begin import ROOT

import pytest
from right_solutions import PLAIN
from vpython import vector

from grading import grader, limits
from grading.grader import checks
from grading.handout import FUNCTIONS, HONOR, needed, PROGRAM, SUITES
from grading.outcomes import FAILED, Grading, Outcome, PASSED
from grading.students_code import module_of
from support.files import source_files

# All modules are imported first: one that is imported later would keep a solution of a test.
MODULES = {name: import_module(module_of(function.file)) for name, function in FUNCTIONS.items()}

# No row of the tables needs to import these names. The text of a file follows in the same line.
IMPORTS = "from math import cos, sin; from vpython import vector; "

CHECKS = [check for tier in SUITES for check in checks(tier=tier)]


class Sources:
    """The files of src/ with the versions of a test in them, as a run of the program finds them."""

    def __init__(self, monkeypatch):
        self.monkeypatch = monkeypatch
        self.texts = {}
        self.plain_code_of = source_files.code_of
        monkeypatch.setattr(source_files, "code_of", self.code_of)

    def code_of(self, file):
        if file not in self.texts:
            return self.plain_code_of(file)
        self.keep_lines(file, self.texts[file])
        return compile(self.texts[file], file, "exec", dont_inherit=True)

    def keep_lines(self, file, source):
        """Let messages have the lines of a source."""
        entry = len(source), None, source.splitlines(keepends=True), file
        self.monkeypatch.setitem(linecache.cache, file, entry)

    def put(self, function, source):
        """Put a function, or the program's block, into the text of its file."""
        file = str(ROOT / FUNCTIONS[function].file)
        text = self.texts.get(file) or IMPORTS + Path(file).read_text(encoding="utf-8")
        nodes = {getattr(node, "name", PROGRAM): node for node in ast.parse(text).body}
        node = nodes[function]  # of those without a name, it is the last one
        lines = text.splitlines()
        lines[node.lineno - 1 : node.end_lineno] = source.splitlines()
        self.texts[file] = "\n".join(lines)


@pytest.fixture
def solve(monkeypatch):
    """A function that replaces a function by a version from the tables, wherever it is used.

    PROGRAM stands for the program's block.
    """
    monkeypatch.setattr(limits, "PATIENCE", 60.0)  # a busy machine can stall for seconds
    modules = [module for name, module in sys.modules.items() if name.startswith("src.")]
    shipped = str(grader.runner.shipped)
    monkeypatch.setattr("support.constants.NC_FP", shipped)
    monkeypatch.setattr(import_module("src.pds_helper").write_to_csv, "__defaults__", (shipped,))
    sources = Sources(monkeypatch)

    def solve(function, version):
        body = version
        if isinstance(version, tuple):
            old, new = version
            assert old in PLAIN[function]
            body = PLAIN[function].replace(old, new)
        body = indent(dedent(body), "    ")
        if function == PROGRAM:
            sources.put(PROGRAM, f'if __name__ == "__main__":\n{body}')
            return
        parameters = f"({FUNCTIONS[function].parameters})"
        original = getattr(MODULES[function], function)
        if FUNCTIONS[function].tier == HONOR:  # some of its parameters have a default value
            parameters = signature(original).replace(return_annotation=Signature.empty)
        source = f"def {function}{parameters}:\n{body}"
        sources.put(function, source)
        file = str(ROOT / "src" / f"my_{function}.py")  # there is none, but messages have its lines
        sources.keep_lines(file, source)
        scope = vars(MODULES[function])
        for name, value in {"cos": cos, "sin": sin, "vector": vector, **scope}.items():
            monkeypatch.setitem(scope, name, value)
        defined = {}
        exec(compile(source, file, "exec"), scope, defined)
        for module in modules:
            if vars(module).get(function) is original:
                monkeypatch.setattr(module, function, defined[function])

    return solve


def outcomes_of(function, users=True) -> dict:
    """Return the outcome of each check of this function; all others are passed.

    users: also those of the functions that use it.
    """
    judged = [
        check
        for check in CHECKS
        if check.function == function or users and function in needed(check.function)
    ]
    grading = Grading()
    grading.outcomes = {check.name: Outcome(PASSED) for check in CHECKS if check not in judged}
    return {check: grading.judge(check) for check in judged}


def failures(function) -> list:
    outcomes = outcomes_of(function, users=False).values()
    return [outcome for outcome in outcomes if outcome.state == FAILED]
