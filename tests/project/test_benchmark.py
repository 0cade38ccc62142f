"""The benchmark, which nothing else starts, finds what it needs."""

import os

from programs import python, ROOT


def test_it_starts_in_any_folder_and_has_help():
    done = python(ROOT / "tests" / "benchmark.py", "--help", folder=os.sep)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("usage: benchmark.py ")
