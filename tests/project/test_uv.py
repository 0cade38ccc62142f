"""With uv, a program and pytest install what they need, from PyPI, with an empty cache."""

import shutil
import signal
import sys

import pytest
from programs import copy_project, end, first_lines, needs_vpython, python, QUIETLY, ROOT, running
from whole_cradles import FIVE_CSV

pytestmark = [pytest.mark.slow, *needs_vpython]


def uv(folder):
    """Return the path of uv: that of this machine, or one that pip installs in this folder."""
    path = shutil.which("uv")
    if path:
        return path
    done = python("-m", "pip", "install", "-q", "--target", folder, "uv")
    if done.returncode != 0:
        pytest.skip(f"pip cannot install uv: {done.stderr.splitlines()[-1]}")
    return folder / "bin" / "uv"


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
    shutil.copytree(ROOT / "tests", project / "tests")
    page = ("src/visualize_cradle_run.py", "--no-browser")
    program = uv(tmp_path / "uv")
    with running("run", "-q", *page, folder=project, python=program, **environment) as process:
        first_lines(process)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
    installed = [*project.glob(".venv/lib/*/site-packages/*.dist-info")]
    assert 0 < len(installed) <= 25  # with Jupyter, it is more than a hundred

    checks = ("run", "-q", "pytest")
    with running(*checks, folder=project, python=program, **environment) as process:
        stdout, stderr = process.communicate()
    assert stderr == ""
    assert "type pytest -n 2 tests\n" in stdout
    assert "\nGrade: Honor roll.\n" in stdout
