"""That the lists of packages agree; test_uv.py starts the page with no more than the short one."""

import json
import re

from programs import ROOT

from support.start.options import CLOSED_VARIABLE, PORT_VARIABLE


def bounds(file, pattern=r"^([\w-]+)([^ \n]*)"):
    """Return the bounds of each package in this file of the project."""
    return dict(re.findall(pattern, (ROOT / file).read_text(), re.MULTILINE))


LISTED = bounds("support/requirements.txt")


def test_the_lists_for_pip_have_what_pyproject_names_and_each_package_has_both_bounds():
    named = bounds("pyproject.toml", r'^    "([\w-]+)([<>=][^"]+)",')
    of_tests = bounds("tests/requirements.txt")
    assert named.keys() == {"vpython", "pandas", "setuptools", "tornado", "autobahn", *of_tests}
    assert named.items() <= {**LISTED, **of_tests}.items()
    assert bounds("pyproject.toml", r'^dev = \["(\w+)(.*)"\]') == {"pytest": of_tests["pytest"]}
    for versions in [*LISTED.values(), *of_tests.values()]:
        assert re.fullmatch(r"==[\d.]+|>=[\d.]+,<[\d.]+", versions)


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
