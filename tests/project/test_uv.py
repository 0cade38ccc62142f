"""With uv, a program and pytest install what they need: from PyPI, with an empty cache."""

import shutil
import signal
import sys

import pytest
from programs import copy_project, end, first_lines, needs_vpython, python, QUIETLY, ROOT, running
from students import COUNTS
from whole_cradles import FIVE_CSV

pytestmark = [pytest.mark.slow, *needs_vpython]


def test_the_page_and_the_checks_of_a_project_and_of_a_starter_need_uv_alone(tmp_path, starter):
    done = python("-m", "pip", "install", "-q", "--target", tmp_path / "uv", "uv")
    if done.returncode != 0:
        pytest.skip(f"pip cannot install uv: {done.stderr.splitlines()[-1]}")
    uv = tmp_path / "uv" / "bin" / "uv"
    environment = {
        "UV_CACHE_DIR": str(tmp_path / "cache"),
        "UV_PYTHON": sys.executable,
        "UV_PYTHON_DOWNLOADS": "never",
    }

    project = copy_project(tmp_path / "project", FIVE_CSV)
    shutil.copy(ROOT / "pyproject.toml", project)
    shutil.copytree(ROOT / "tests", project / "tests")
    page = ("src/visualize_cradle_run.py", "--no-browser")
    with running("run", "-q", *page, folder=project, python=uv, **environment) as process:
        first_lines(process)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
    installed = [*project.glob(".venv/lib/*/site-packages/*.dist-info")]
    assert 0 < len(installed) <= 25  # with Jupyter, more than a hundred

    checks = ("run", "-q", "pytest")
    with running(*checks, folder=project, python=uv, **environment) as process:
        stdout, stderr = process.communicate()
    assert stderr == ""
    assert "type uv run --extra tests pytest -n 2 tests\n" in stdout
    assert "\nGrade: Honor roll.\n" in stdout

    checks = ("run", "-q", "pytest", "--tier", "D")
    with running(*checks, folder=starter, python=uv, **environment) as process:
        stdout, stderr = process.communicate()
    assert stderr == ""
    assert f"{COUNTS['D']} waiting" in stdout
