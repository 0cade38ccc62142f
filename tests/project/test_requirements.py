"""That the lists of packages agree; test_uv.py starts the page with no more than the short one."""

import json
import re
import tomllib

from packaging.requirements import Requirement
from programs import ROOT

from support.start.options import CLOSED_VARIABLE, PORT_VARIABLE

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())


def listed(file):
    """Return what each line of this file requires."""
    lines = (line.partition("#")[0].strip() for line in (ROOT / file).read_text().splitlines())
    return [Requirement(line) for line in lines if line]


def test_the_lock_has_one_exact_version_within_the_bounds_for_each_python():
    lock = listed("support/requirements.txt")
    for version in ("3.11", "3.12", "3.13", "3.14", "3.15"):
        python = {"python_version": version}
        locked = [line for line in lock if not line.marker or line.marker.evaluate(python)]
        versions = {line.name: str(line.specifier) for line in locked}
        assert len(versions) == len(locked)
        assert all(re.fullmatch(r"==[\d.]+", exact) for exact in versions.values())
        for line in map(Requirement, PROJECT["project"]["dependencies"]):
            assert versions[line.name][2:] in line.specifier


def test_pip_and_uv_install_the_same_for_the_tests():
    of_tests = listed("tests/requirements.txt")
    extra = PROJECT["project"]["optional-dependencies"]["tests"]
    assert of_tests == [*map(Requirement, extra)]
    [of_checks] = map(Requirement, PROJECT["dependency-groups"]["dev"])
    assert of_checks in of_tests
    assert all(len(line.specifier) == 2 for line in of_tests)  # both bounds


def test_the_container_forwards_the_port_of_the_page_and_the_program_opens_no_browser():
    container = json.loads((ROOT / ".devcontainer/devcontainer.json").read_text())
    [port] = container["forwardPorts"]
    assert container["containerEnv"] == {PORT_VARIABLE: str(port), CLOSED_VARIABLE: "1"}
    assert container["portsAttributes"].keys() == {str(port)}


def test_the_workflow_has_the_lines_of_the_readme():
    """The README has a command for Linux and macOS, and lines for Windows."""
    workflow = (ROOT / ".github/workflows/test.yml").read_text()
    readme = (ROOT / "README.md").read_text()
    pattern = re.search(r"sed -n 's/(.*)/\\1/p' README.md", workflow)[1]
    pattern = pattern.replace(r"\(", "(").replace(r"\)", ")")
    assert len(re.findall(pattern, readme, re.MULTILINE)) == 1
    installs = re.findall(r"^    (\.venv\\Scripts\\p(?:ip|ytest).*)$", readme, re.MULTILINE)
    assert re.findall(r"^ +(\.venv\\.*)$", workflow, re.MULTILINE) == installs
