"""The names that the page and the program share, and the modules of the page."""

import re

import pytest

from support.page.lesson import ASKED, EXPLAINED, SEEN
from support.page.names import COMMANDS, Texts, VALUES
from support.page.server.web_files import PAGE, WEB

HTML = PAGE.read_text(encoding="utf-8")
SCRIPTS = {path.stem: path.read_text(encoding="utf-8") for path in WEB.glob("*.js")}
# Which names an attribute of page.html, data-..., can have.
NAMES = {"do": COMMANDS, "text": [*VALUES, *Texts.__annotations__]}


def in_the_page(attribute):
    """Return the names in these attributes of the page, data-..."""
    return {*re.findall(rf'data-{attribute}="(\w+)"', HTML)}


def in_scripts(pattern):
    """Return the names that this pattern finds in the scripts."""
    return {*re.findall(pattern, "\n".join(SCRIPTS.values()))}


@pytest.mark.parametrize("attribute", NAMES)
def test_each_name_in_the_page_is_declared(attribute):
    names = in_the_page(attribute)
    assert names
    assert names <= {*NAMES[attribute]}


def test_each_command_is_given_by_the_page():
    """The type checker of the scripts finds a command that is not declared."""
    assert {*COMMANDS} <= in_the_page("do") | in_scripts('"([a-z_]+)"')


def test_each_value_is_shown_by_the_page():
    shown = in_the_page("text") | in_scripts(r'show\("(\w+)"') | in_scripts(r"state\.(\w+)")
    assert {*VALUES} <= shown


def test_each_control_that_the_page_knows_is_declared_and_each_has_its_place(rig):
    """The gallery is the experiments' control."""
    known = in_scripts(r"\bcontrols\??\.(\w+)") | in_scripts(r'(?<!\.)\bset\("(\w+)"')
    controls = rig.state["controls"]
    assert known
    assert known <= {*controls}
    places = {control["place"] for name, control in controls.items() if name != "experiment"}
    assert places == in_the_page("place")


def test_each_state_of_the_lesson_that_the_page_knows_is_declared():
    known = in_scripts(r"replies\.(\w+)") | in_scripts(r'state === "(\w+)"')
    assert known == {ASKED, SEEN, EXPLAINED}


def test_no_script_makes_elements_of_a_text():
    """So each text of a file is shown as a text."""
    assert not in_scripts(r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|srcdoc")
