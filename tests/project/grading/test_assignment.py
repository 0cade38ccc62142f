"""The assignment: each function has its part, and the examples are true."""

import re
from doctest import DocTestParser, DocTestRunner, ELLIPSIS

from grading.assignment import FUNCTIONS
from support.root import ROOT

TEXT = (ROOT / "tests/starter/ASSIGNMENT.md").read_text(encoding="utf-8")


def test_each_function_has_a_part_with_an_example():
    """The parts are in the order of the functions."""
    parts = dict(re.findall(r"^### (.+)\n((?:(?!##).*\n)*)", TEXT, re.MULTILINE))
    assert [*parts] == [*FUNCTIONS]
    for part in parts.values():
        assert "\n>>> " in part


def test_each_example_gives_its_result():
    names = {}
    exec(re.search("```python\n(.+?)```", TEXT, re.DOTALL)[1], names)  # try.py
    text = TEXT.replace("```", "")  # it would be a part of the result above it
    examples = DocTestParser().get_doctest(text, names, "ASSIGNMENT.md", None, 0)
    failures = []
    DocTestRunner(optionflags=ELLIPSIS).run(examples, out=failures.append)
    assert not failures, "".join(failures)
