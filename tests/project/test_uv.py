"""With uv, a program and pytest install what they need, from PyPI, with an empty cache."""

import shutil
import signal
import sys

import pytest
from programs import (
    copy_project,
    end,
    first_lines,
    half_written,
    needs_vpython,
    QUIETLY,
    ROOT,
    running,
)
from whole_cradles import FIVE_CSV

UV = shutil.which("uv")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(UV is None, reason="uv is not installed"),
    *needs_vpython,
]


def test_the_page_and_the_checks_need_uv_alone(tmp_path):
    """A folder around the project is a workspace of uv."""
    environment = {
        "UV_CACHE_DIR": str(tmp_path / "cache"),
        "UV_PYTHON": sys.executable,
        "UV_PYTHON_DOWNLOADS": "never",
    }

    workspace = '[project]\nname = "other"\nversion = "0"\n[tool.uv.workspace]\nmembers = ["*"]\n'
    (tmp_path / "pyproject.toml").write_text(workspace)
    project = copy_project(tmp_path / "project", FIVE_CSV)
    shutil.copy(ROOT / "pyproject.toml", project)
    shutil.copytree(ROOT / "tests", project / "tests", ignore=half_written)
    page = ("src/visualize_cradle_run.py", "--no-browser")
    with running("run", "-q", *page, folder=project, python=UV, **environment) as process:
        first_lines(process)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
    installed = [*project.glob(".venv/lib/*/site-packages/*.dist-info")]
    assert 0 < len(installed) <= 25  # with Jupyter, it is more than a hundred

    checks = ("run", "-q", "pytest")
    with running(*checks, folder=project, python=UV, **environment) as process:
        stdout, stderr = process.communicate()
    assert stderr == ""
    assert "type pytest -n 2 tests\n" in stdout
    assert "\nGrade: Honor roll.\n" in stdout
