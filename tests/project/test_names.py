"""The names that the page and the program share, and the modules of the page."""

import re
from graphlib import TopologicalSorter

import pytest

from support.page.names import COMMANDS, Texts, VALUES
from support.page.web_files import PAGE, WEB

HTML = PAGE.read_text(encoding="utf-8")
SCRIPTS = {path.stem: path.read_text(encoding="utf-8") for path in WEB.glob("*.js")}
# Which names an attribute of page.html, data-..., can have.
NAMES = {
    "do": COMMANDS,
    "control": [*COMMANDS, *VALUES],
    "text": [*VALUES, *Texts.__annotations__],
}


@pytest.mark.parametrize("attribute", NAMES)
def test_each_name_in_the_page_is_declared(attribute):
    names = re.findall(rf'data-{attribute}="(\w+)"', HTML)
    assert names
    assert {*names} <= {*NAMES[attribute]}


def test_each_command_is_given_by_the_page():
    assert [name for name in COMMANDS if not is_used(name, "do|control", '"{}"')] == []


def test_each_value_is_shown_by_the_page():
    in_a_script = r'show\("{0}"|state\.{0}\b|\["keys", .*"{0}"'
    assert [name for name in VALUES if not is_used(name, "control|text", in_a_script)] == []


def is_used(name, attributes, in_a_script):
    """Return whether a name stands in one of these attributes of the page, or in a script."""
    in_the_page = re.search(rf'data-({attributes})="{name}"', HTML)
    in_scripts = re.search(in_a_script.format(name), "\n".join(SCRIPTS.values()))
    return bool(in_the_page or in_scripts)


def imports(text):
    """Return the names of the modules that a script imports."""
    return re.findall(r'^import (?:.* from )?"(\w+)";$', text, re.MULTILINE)


def test_imports_between_the_modules_have_no_circle():
    modules = {name: imports(text) for name, text in SCRIPTS.items()}
    assert modules["canvas"]
    assert "names" in TopologicalSorter(modules).static_order()  # it raises CycleError
