"""A hidden value: nothing shows it, and the page says how far yours is off."""

import json

import pages
import pytest
from pages import press, violations
from rig import Rig
from students import put_files
from whole_cradles import PERIOD

from support.page.scene.slow_hits import VELOCITY

TEXT = """\
name = "Unknown"
theta = [-45, 0, 0]
{}
hidden = "{}"
question = "Find it."
why = "So it is found."
"""
DIGITS = "777377"  # of the hidden values: no time or angle has them
MASS = TEXT.format("mass = [3.777377, 1, 1]", "mass 1")
MIDDLE = TEXT.format("mass = [1, 3.777377, 1]", "mass 2")
E = TEXT.format("e = [0.777377, 0.777377, 0.777377]", "e")


@pytest.fixture
def unknown(csv, tmp_path, monkeypatch):
    """A function that returns a viewer whose only experiment has this text."""

    def unknown(text):
        folder = put_files(tmp_path / "experiments", {"single/one.toml": text})
        monkeypatch.setattr("support.page.chooser.EXPERIMENTS", folder)
        rig = Rig(csv)
        for name in ("arrows", "momenta", "measure", "slow_hits"):
            rig.give(name, True)
        rig.give("next")
        rig.give("pause")  # it waits
        return rig

    return unknown


@pytest.mark.parametrize("text", [MASS, MIDDLE, E], ids=["mass", "in the middle", "e"])
def test_nothing_on_the_page_shows_a_hidden_value(unknown, text):
    """Before the first hit, the page with another value is the same.

    Nor what tells it at once: energies and momenta. Angles and speeds are there.
    """
    seen = []
    for digits in ("5", DIGITS):
        rig = unknown(text.replace(DIGITS, digits))
        rig.give("release_angle", 20)  # it stays hidden
        rig.wait(PERIOD / 5)
        seen.append([dict(rig.state), [label.text for label in rig.marks("below")]])
    assert seen[0] == seen[1]
    assert rig.state["unknown"]["question"] == "Find it."
    while not rig.state["hits"]:
        rig.wait(0.05)
    assert DIGITS not in json.dumps(rig.state)
    assert [*rig.state["hits"][0]["bobs"][0]] == ["no.", "omega (rad/s)", VELOCITY]
    assert rig.marks("changes") == rig.marks("belts") == []
    assert [*rig.state["motion"]] == ["t", "half swings"]
    assert rig.state["bars"] is None
    assert rig.control("graph")["choices"] == ["Angles theta", "Velocities omega", "Phase theta"]


def test_while_a_value_is_hidden_only_the_release_can_be_changed(unknown):
    """Else its question would be untrue; and an added bob would have the mass of the last one."""
    rig = unknown(MIDDLE)
    before = dict(rig.state)
    off = [name for name, control in rig.state["controls"].items() if not control["enabled"]]
    assert off == ["count", "mass", "e"]
    for name in off:
        rig.tell(name, rig.control(name)["max"])
    rig.tell("edit", 1, "mass", 1)
    rig.give("save_csv", 1)
    assert rig.state == before
    assert rig.state["cells"][0] == ["1.0", "?", "1.0"]
    rig.give("lifted", 2)
    assert rig.bob_angles() == [45, 45, 0]
    assert rig.state["graph"] == "Angles theta"
    rig.give("experiment", "My cradle")
    assert rig.state["unknown"] is None
    assert rig.state["graph"] == "Momenta"


@pytest.mark.parametrize(
    ("text", "typed", "word"),
    [
        (MASS, "4", "4 is 5.9 % too large."),
        (MASS, " 3.7\n", "3.7 is 2.0 % too small. It is 3.77738 kg. So it is found."),
        (E, "0,72", "0.72 is 7.4 % too small."),
        (E, "0.5", "0.5 is more than 10 % too small."),  # or one guess would tell the value
        (E, "2", "Allowed is a number from 0 to 1, such as 0.9."),
    ],
)
def test_your_value_is_told_how_far_it_is_off(unknown, text, typed, word):
    rig = unknown(text)
    rig.give("check", typed)
    assert rig.state["checked"] == word
    rig.give("restart")
    assert rig.state["checked"] == ""


def test_a_value_that_is_found_is_shown_until_the_next_run(unknown):
    """So the next group can find it, too."""
    rig = unknown(MASS)
    for typed, label in (("4", "? kg"), ("3.7", "3.77738 kg")):
        rig.give("check", typed)
        assert rig.marks("below")[0].text.startswith(label)
    assert "energy" in rig.state["motion"]
    rig.give("restart")
    assert rig.marks("below")[0].text.startswith("? kg")


def test_a_value_for_a_hidden_mass_is_checked(shared):
    pages.choose(shared, "An unknown mass")
    value = shared.get_by_label("mass of bob 1 =")
    value.fill("2.7")
    press(shared, "Check")
    shared.get_by_text("Bob 2 gets the momentum that bob 1 loses").wait_for()
    assert violations(shared) == {}
