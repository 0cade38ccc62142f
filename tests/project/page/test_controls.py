"""The page's controls and commands, by their table: each takes its values, and refuses others.

Anyone with the key can send anything. None of it may end the program.
"""

from math import nan

import pytest
from rig import Rig

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.page.names import COMMANDS

JUNK = [None, nan, 10**400, [], {}, [0, 0, 10**400]]
# A ray through the third bob's middle: it grabs the bob, and drags it a little.
POINT, DIRECTION = [R_PARAM / 20, -0.8 * R_PARAM, 0], [0, 0, -1]
STEM = "02_two_bobs"
TAKEN = {  # values that a command takes; the others take none
    "set": ["lifted", 2],
    "answer": [STEM, 0],
    "check": ["2.7"],
    "edit": [0, "mass", 2],
    "save_csv": [0.25],
    "grab": [POINT, DIRECTION],
    "drag": [POINT, DIRECTION],
    "load_ghosts": ["a.csv", "t,theta_1\n0,0\n"],
}
REFUSED = {  # values that are beside them
    "set": [["angle_phi", 30], ["lifted", 1.5]],  # the first one is of the double cradle
    "answer": [[STEM, -1], [STEM, 0.5]],
    "edit": [[-1, "e", 0], [5, "e", 0], [0, "color", 1], [0, "mass", 0], [0, "e", 2]],
    "grab": [[POINT, [0, 0, 0]]],
    "drag": [[POINT, [0, 0, 0]]],
}


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_each_control_takes_what_it_shows_as_possible_and_nothing_else(csv, kind):
    rig = Rig(csv, *[30] * kind.cord_count, kind=kind)
    assert ("separating" in rig.state["controls"]) == (kind is Cradle)
    for name in rig.state["controls"]:
        control = rig.control(name)
        if control["kind"] == "Slider":
            possible = [control["max"], control["min"]]
            beside = [possible[0] + 0.1, possible[1] - 0.1, True, "1"]
        else:
            possible = control.get("choices", [False, True])[::-1]
            beside = [0, "nonsense"]
        for value in possible:
            rig.give(name, value)
            assert rig.state[name] == pytest.approx(value), name
        for other in [*beside, *JUNK]:
            rig.tell(name, other)
        rig.wait()
        assert rig.state[name] == pytest.approx(value), name


@pytest.mark.parametrize("command", [*COMMANDS, "nonsense", 5])
def test_a_command_does_nothing_with_other_values(rig, command):
    rig.give("pause")
    rig.give("grab", POINT, DIRECTION)
    before = dict(rig.state)
    values = TAKEN.get(command, [])
    if command in COMMANDS:
        assert rig.viewer.commands[command].takes(values)
    rig.tell(command, *values, 0)
    for refused in REFUSED.get(command, []):
        rig.tell(command, *refused)
    for place in range(len(values)):
        for junk in JUNK:
            rig.tell(command, *values[:place], junk, *values[place + 1 :])
    rig.wait()
    assert rig.state == before
    rig.give("drag", POINT, DIRECTION)  # it is still held
    assert rig.bob_angles()[2] == 3  # atan(1 / 20)
