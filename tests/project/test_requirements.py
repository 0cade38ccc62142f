"""What has to be installed: the short list, VPython's names behind it, and no more than that."""

import json
import re
import venv
from importlib import metadata
from importlib.machinery import PathFinder
from pathlib import Path

import pytest
from pages import BOBS, open_cradle
from programs import end, first_lines, QUIETLY, ROOT, running, with_vpython

from support.constants import R_PARAM
from support.start.options import CLOSED_VARIABLE, PORT_VARIABLE


def bounds(file, pattern=r"^([\w-]+)([^ \n]*)"):
    """Return the bounds of each package in this file of the project."""
    return dict(re.findall(pattern, (ROOT / file).read_text(), re.MULTILINE))


LISTED = bounds("support/requirements.txt")

# The private names of VPython that support/page uses, each as VPython's file has it.
PRIVATE = {
    "vpython.py": [
        "_view_constructed = ",
        "object_registry = ",
        "updates = {",
        "attrs = set()",
        "def handle_attach(cls)",
        "def initialize(cls)",
        "def package(cls, objdata)",
    ],
    "vpython_libraries/glowcomm.html": [
        "window.__GSlang =",
        "var glowObjs",
        "function decode(data)",
        "function handler(data)",
    ],
    "vpython_libraries/glow.min.js": [
        "$.plot=",
        ".color.parse=",
        "__update:function(ev)",
        "__canvas_element=",
        "__overlay_element=",
        "window.__context",
        "window.Jupyter_VPython",
        "glowscript-canvas-wrapper",
        "userspin:",
        ".resizable(",
        'trigger("draw_complete"',
        'cvs.waitfor_textures=false;cvs.trigger("textures"',
        "userzoom:",
        "tickLabel",
        "legendColorBox",
    ],
}


@with_vpython
@pytest.mark.parametrize("file", PRIVATE)
def test_vpython_has_its_private_names_that_the_page_uses(file):
    [folder] = PathFinder.find_spec("vpython").submodule_search_locations
    text = Path(folder, file).read_text(encoding="utf-8")
    assert [name for name in PRIVATE[file] if name not in text] == []


def test_the_lists_for_pip_have_what_pyproject_names_and_each_package_has_both_bounds():
    named = bounds("pyproject.toml", r'^    "([\w-]+)([<>=][^"]+)",')
    of_tests = bounds("tests/requirements.txt")
    assert named.keys() == {"vpython", "pandas", "setuptools", "autobahn", *of_tests}
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


@pytest.mark.parametrize(
    ("name", "bobs"), [("visualize_cradle_run.py", 5), ("visualize_double_cradle_run.py", 10)]
)
def test_each_page_works_with_the_short_list_alone_until_the_tab_is_closed(
    page, program, tmp_path, name, bobs
):
    """In an environment with these packages of the Python that runs the tests, if it has them."""
    environment = tmp_path / "environment"
    venv.create(environment, symlinks=True)
    [place] = environment.glob("lib/python*/site-packages")
    for package in metadata.distributions():
        if package.name.lower() in LISTED:
            parts = {file.parts[0] for file in package.files or ()}
            for part in parts - {"..", "__pycache__"}:
                (place / part).symlink_to(package.locate_file(part))
    python = str(environment / "bin" / "python")
    with running(program.with_name(name), python=python) as process:
        open_cradle(page, first_lines(process), bobs)
        # To the right: only a hit brings a bob that far
        farthest = f"Math.max(...({BOBS})().map(bob => bob[0]))"
        page.wait_for_function(f"() => {farthest} > {-0.1 + 5 / 4 * R_PARAM}")
        page.close()
        assert end(process) == QUIETLY
