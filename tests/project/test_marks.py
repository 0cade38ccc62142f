"""What pytest leaves out by default, and what it says of that."""

import subprocess
import sys

import pytest
from programs import ROOT

LINE = 'To run them: .venv/bin/pytest -m "browser or slow"'


@pytest.mark.parametrize(
    ("options", "kept", "left_out"),
    [
        (["-k", "dragged"], 0, "Left out (browser, slow): 4."),
        (["-k", "dragged", "-m", "browser or slow"], 4, None),
        (["-k", "nothing_of_that_name"], 0, None),
    ],
)
def test_what_is_left_out_is_said_only_where_no_m_has_chosen(options, kept, left_out):
    command = [sys.executable, "-m", "pytest", "--collect-only", "-q", "tests/project/test_page.py", *options]
    said = subprocess.run(command, cwd=ROOT, capture_output=True, text=True).stdout
    assert said.count("test_page.py::") == kept
    assert f"{left_out} {LINE}" in said if left_out else "Left out" not in said
