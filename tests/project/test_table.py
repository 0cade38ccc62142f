"""The table of the pendula, and messages of a tab that are no command."""

import pytest
from rig import Rig
from whole_cradles import FIVE_CSV, GOOD, HEADER

from support.constants import R_PARAM
from support.cradle.double_cradle import DoubleCradle
from support.page.chooser import STILL_THERE
from support.page.server.tabs import Tabs


def test_the_table_shows_pend_list_as_it_is_now(rig):
    rig.wait(0.3)
    names = [f"{key}_{number}" for key in ("theta", "omega") for number in range(1, 6)]
    numbers = [float(rig.state["now"][name]) for name in names]
    assert numbers == pytest.approx(rig.values("theta") + rig.values("omega"), abs=5e-7)


def test_the_cradle_of_an_edited_cell_has_the_masses_and_e_that_are_shown(rig, csv):
    """They came from sliders: nothing else may change with the edit."""
    rig.give("mass", 3)
    rig.give("e", 0)
    rig.give("edit", 1, "mass", "2.50")
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    rig.give("edit", 4, "e", "0.5")
    rig.give("restart")
    assert rig.state["table"]["mass"] == rig.values("mass") == [3, 2.5, 1, 1, 1]
    assert rig.state["table"]["e"] == rig.values("e") == [0, 0, 0, 0, 0.5]
    assert csv.read_text() == FIVE_CSV


def test_a_bad_value_says_the_allowed_ones_and_the_cradle_swings_on(rig):
    rig.wait(0.3)
    rig.give("edit", 3, "mass", "<b>")
    assert rig.time() > 0.2
    rig.give("edit", 0, "e", "0.25")  # another cell does not hide the mistake
    [(cell, refusal)] = rig.state["refused"].items()
    assert cell == "3,mass"
    assert refusal["text"] == "<b>"
    assert refusal["message"].startswith("mass: allowed is a number from ")
    rig.give("edit", 3, "mass", " 0.5 ")
    assert rig.state["refused"] == {}
    assert rig.values("mass")[3] == 0.5
    rig.give("edit", 1, "e", "2")
    rig.save("no cradle")
    assert rig.state["error"].endswith(STILL_THERE)
    assert rig.values("e") == [0.25, 1, 1, 1, 1]
    rig.save(HEADER + GOOD * 3)  # a saved file replaces it all
    rig.give("edit", 3, "mass", "2")  # of a row that is no longer there
    assert rig.state["refused"] == {}
    assert rig.values("mass") == rig.values("e") == [1] * 3


def test_masses_too_far_apart_are_refused_only_in_the_double_cradle(rig, csv):
    """In the table, and in a saved file: the old cradle stays."""
    rig.give("edit", 3, "mass", "1e-7")
    assert rig.values("mass")[3] == 1e-7
    double = Rig(csv, 30, 10, kind=DoubleCradle)
    double.give("pause")  # it then needs no ticks
    double.give("edit", 3, "mass", "9e-7 ")
    message = "mass: allowed is at most 1e6 times the smallest mass, in a double cradle"
    assert double.state["refused"] == {"3,mass": {"text": "9e-7 ", "message": message}}
    double.give("edit", 3, "mass", "1e-6")
    double.save(HEADER + GOOD.replace("1.0", "500000", 1) + GOOD.replace("1.0", ".4", 1))
    assert double.values("mass") == [1, 1, 1, 1e-6, 1]


# --- messages that are no command ----------------------------------------------------------------

# The third bob's middle: a ray from here grabs it, and drags it a little
RAY = [[R_PARAM / 20, -0.8 * R_PARAM, 0], [0, 0, -1]]


@pytest.mark.parametrize(
    "message",
    [
        "",
        "[",
        "5",
        '{"nonsense": 1}',
        '["pause", 1]',
        '["set", ["speed"], 1]',
        '["set", "speed", 2.01]',
        '["set", "speed", NaN]',
        '["set", "lifted", 1.5]',
        '["set", "graph", "nonsense"]',
        '["set", "angle_phi", 30]',  # of the double cradle
        '["answer", "2_two_bobs", -1]',
        '["edit", -1, "e", "0"]',
        '["edit", 0, "color", "red"]',
        '["grab", [0, 0, 0], [0, 0, 0]]',
        f'["drag", [0, 0, 0], [0, 0, {10**400}]]',
    ],
)
def test_a_message_that_is_no_command_does_nothing(rig, message):
    """Anyone with the key can send anything. None of it may end the program."""
    rig.give("pause")
    rig.give("grab", *RAY)
    before = dict(rig.state)
    tabs = Tabs(None)
    tabs.holder = 1
    tabs.receive(1, message.encode())
    while not tabs.commands.empty():
        rig.give(*tabs.commands.get())
    assert rig.state == before
    assert rig.viewer.held_bob.index == 2
    rig.give("drag", *RAY)
    assert rig.bob_angles()[2] == 3  # atan(1 / 20)
