"""The rooms (folders) of the project import only allowed rooms: a test of every import in src/ and
support/.
"""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from programs import ROOT

# The handout's modules in its order: a module may import only earlier ones.
HANDOUT = (
    *("src.pds_helper", "src.special_cradles", "src.swinging", "src.visualize_cradle_run"),
    *("src.double_collisions", "src.double_cradle", "src.visualize_double_cradle_run"),
)
PROGRAM = "src.text_cradle_run"
# The other rooms that the modules of a room, or one module, may import.
MAY_IMPORT = {
    "support": set(),
    "support.__init__": {"support.start"},
    "support.files": {"support"},
    "support.start": {"support", "support.files"},
    "support.cradle": {"support", "support.files", "support.start"},
    "support.page": {
        "support",
        "support.files",
        "support.cradle",
        "support.start",
        "support.page.scene",
    },
    "support.page.scene": {"support", "support.cradle"},
    "support.terminal": {"support", "support.files", "support.cradle", "support.start"},
    "src": {"support", "support.files"},
    PROGRAM: {"support", "support.files", "support.cradle", "support.start", "support.terminal"},
}
FILES = [
    file for folder in ("src", "support") for file in sorted((ROOT / folder).rglob("[!.]*.py"))
]
MODULES = {".".join(file.relative_to(ROOT).with_suffix("").parts): file for file in FILES}


def imports_of(name) -> set[str]:
    """Return the project's modules that this module imports, without those for a start as a
    program.
    """
    tree, names = ast.parse(MODULES[name].read_text(encoding="utf-8")), set()
    tree.body = [
        node
        for node in tree.body
        if not (isinstance(node, ast.If) and "__main__" in ast.unparse(node.test))
    ]
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "the project's imports say where they start"
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return {other for other in MODULES if other.removesuffix(".__init__") in names}


def room_of(name) -> str:
    return name.rpartition(".")[0]


@pytest.mark.parametrize("name", sorted(MODULES))
def test_a_module_imports_only_allowed_rooms(name):
    """So a starting point knows one way of showing a cradle: in the browser, or in the terminal."""
    rooms = {room_of(other) for other in imports_of(name)}
    assert rooms <= MAY_IMPORT.get(name, MAY_IMPORT[room_of(name)]) | {room_of(name)}


def test_a_module_of_the_handout_imports_earlier_ones_and_only_one_program_is_no_module_of_it():
    earlier = {"src.__init__"}
    for name in HANDOUT:
        assert {other for other in imports_of(name) if room_of(other) == "src"} <= earlier, name
        earlier.add(name)
    assert {name for name in MODULES if room_of(name) == "src"} == {*earlier, PROGRAM}


def test_imports_have_no_circle():
    graph = {name: imports_of(name) for name in MODULES}
    # A CycleError names the circle
    assert len(list(TopologicalSorter(graph).static_order())) == len(MODULES)


def test_only_a_start_as_a_program_changes_the_path():
    files = [
        file for folder in ("src", "support", "tests") for file in (ROOT / folder).rglob("[!.]*.py")
    ]
    changing = [
        file.relative_to(ROOT) for file in files if "\nsys.path" in file.read_text(encoding="utf-8")
    ]
    assert [*map(str, changing)] == [str(Path("tests/grading/begin.py"))]
