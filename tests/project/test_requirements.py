"""What has to be installed: the short list, held against pyproject.toml, and environments with no more than that."""

import json
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import make_requirements
import pytest
from make_requirements import bounds, imported, lines, REQUIREMENTS
from programs import BOBS, copy_project, end, first_lines, on_posix, open_cradle, QUIETLY, ROOT, running, with_vpython
from whole_cradles import FIVE_CSV

from support.constants import R_PARAM

PANDAS = ["numpy", "pandas", "python-dateutil", "pytz", "six"]  # what pandas itself imports is among these
PYTEST = ["exceptiongroup", "iniconfig", "packaging", "pluggy", "pygments", "pytest", "tomli", "typing_extensions"]


def listed():
    """Return the names of the short list, each with its bounds."""
    text = REQUIREMENTS.read_text(encoding="utf-8")
    return dict(re.findall(r"^([\w-]+)(.*)$", text, re.MULTILINE))


@pytest.fixture
def environment(tmp_path):
    """A function that makes a virtual environment with these packages and no others, and returns its Python.

    The packages are those of the Python that runs the tests; one that it does not have is left out.
    """

    def environment(names):
        folder = tmp_path / "environment"
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder], check=True)
        python = folder / "bin" / "python"
        show = "import json, sysconfig; print(json.dumps(sysconfig.get_path('purelib')))"
        place = json.loads(subprocess.run([python, "-c", show], stdout=subprocess.PIPE, check=True).stdout)
        for name in names:
            try:
                package = metadata.distribution(name)
            except metadata.PackageNotFoundError:
                continue
            for part in {file.parts[0] for file in package.files} - {"..", "__pycache__"}:
                Path(place, part).symlink_to(package.locate_file(part))
        return str(python)

    return environment


def test_the_short_list_has_what_pyproject_names_within_its_bounds():
    given = bounds()
    assert given.keys() == {"vpython", "pandas", "setuptools", "autobahn"}
    for name, bound in given.items():
        assert bound in listed()[name].split(",")


def test_the_short_list_is_bounded_so_that_no_package_grows_unseen():
    assert all("<" in bound for bound in listed().values())


@pytest.mark.parametrize(
    ("found", "expected"),
    [
        ([("six", "1.17.0")], ["six<2"]),
        ([("numpy", "2.2.6"), ("idna", "3.20"), ("numpy", "3.0")], ["idna<4", "numpy<4"]),
        ([("pandas", "3.1.1")], ["pandas>=2.1,<4"]),
        ([("setuptools", "65.5.0")], ["setuptools<80.9"]),
    ],
)
def test_the_bounds_that_are_written(monkeypatch, found, expected):
    monkeypatch.setattr(make_requirements, "bounds", lambda: {"pandas": ">=2.1", "setuptools": "<80.9"})
    assert lines(found) == expected


@with_vpython
@on_posix
@pytest.mark.slow
def test_what_the_program_imports_is_found(environment):
    found = imported(environment(listed()))
    assert {"autobahn", "hyperlink", "numpy", "pandas", "vpython"} <= found.keys() <= listed().keys()
    assert found == {name: metadata.version(name) for name in found}


@with_vpython
@on_posix
def test_the_page_works_with_the_short_list_alone(page, program, environment):
    python = environment(listed())
    done = subprocess.run([python, "-c", "import ipykernel"], capture_output=True, text=True)
    assert "ModuleNotFoundError" in done.stderr  # not even by way of the Python that runs the tests
    with running(program, python=python) as process:
        open_cradle(page, first_lines(process))
        page.wait_for_function(f"() => ({BOBS})()[4][0] > {-0.1 + 5 / 4 * R_PARAM}")
        page.close()
        assert end(process) == QUIETLY


@on_posix
@pytest.mark.slow
def test_what_shows_nothing_in_a_browser_needs_pandas_only(environment, tmp_path):
    python, project = environment([*PANDAS, *PYTEST]), copy_project(tmp_path / "project", FIVE_CSV)

    def run(folder, *arguments):
        return subprocess.run([python, *arguments], cwd=folder, capture_output=True, text=True)

    assert "pend_list: the result of extract_and_convert" in run(project, "pds_tester.py").stdout
    assert "t = 0.10 s" in run(project, "src/text_cradle_run.py", "--seconds", "0.1").stdout
    graded = run(
        ROOT,
        "-m",
        "pytest",
        "-p",
        "no:cacheprovider",
        *(f"tests/test_{suite}.py" for suite in ("d", "c", "b", "a", "honor_roll")),
    )
    assert graded.returncode == 0
    assert "Next:  nothing is left to write" in graded.stdout
