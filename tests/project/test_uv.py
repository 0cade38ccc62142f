"""With uv, a program and pytest install what they need: from PyPI, with an empty cache."""

import shutil
import signal
import sys

import pytest
from programs import copy_project, end, first_lines, needs_vpython, python, QUIETLY, ROOT, running
from students import COUNTS
from whole_cradles import FIVE_CSV

pytestmark = [pytest.mark.slow, *needs_vpython]


def uv(folder, version):
    """Install this version of uv in a folder; return its path."""
    done = python("-m", "pip", "install", "-q", "--target", folder, version)
    if done.returncode != 0:
        pytest.skip(f"pip cannot install uv: {done.stderr.splitlines()[-1]}")
    return folder / "bin" / "uv"


def installed(folder):
    """Return how many packages there are; with Jupyter, it is more than a hundred."""
    return len([*folder.glob(".venv/lib/*/site-packages/*.dist-info")])


def test_the_page_and_the_checks_of_a_project_and_of_a_starter_need_uv_alone(tmp_path, starter):
    """A folder around the project is a workspace of uv; for the checks, an old uv does."""
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
    new = uv(tmp_path / "new", "uv")
    with running("run", "-q", *page, folder=project, python=new, **environment) as process:
        first_lines(process)
        process.send_signal(signal.SIGINT)
        assert end(process) == QUIETLY
    assert 0 < installed(project) <= 25

    checks = ("run", "-q", "pytest")
    with running(*checks, folder=project, python=new, **environment) as process:
        stdout, stderr = process.communicate()
    assert stderr == ""
    assert "type uv run --extra tests pytest -n 2 tests\n" in stdout
    assert "\nGrade: Honor roll.\n" in stdout

    checks = ("run", "-q", "pytest", "--tier", "D")
    old = uv(tmp_path / "old", "uv==0.4.30")
    with running(*checks, folder=starter, python=old, **environment) as process:
        stdout, stderr = process.communicate()
    assert stderr == ""
    assert 0 < installed(starter) <= 25
    assert f"{COUNTS['D']} waiting" in stdout
