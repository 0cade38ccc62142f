"""The table of the pendula, and all commands that the page refuses."""

from math import inf, nan

import pytest
from rig import Rig
from whole_cradles import FIVE_CSV, GOOD, HEADER

from support.constants import R_PARAM
from support.cradle.double_cradle import DoubleCradle
from support.page.chooser import STILL_THERE


def test_the_table_shows_pend_list_as_it_is_now(rig):
    rig.wait(0.3)
    names = [f"{key}_{number}" for key in ("theta", "omega") for number in range(1, 6)]
    numbers = [float(rig.state["now"][name]) for name in names]
    assert numbers == pytest.approx(rig.values("theta") + rig.values("omega"), abs=5e-7)


def test_main_makes_the_cradle_of_an_edited_cell_with_the_masses_and_e_that_are_shown(rig, csv):
    """They came from --mass and from a slider: nothing else may change with the edit."""
    rig.viewer.next_cradle.want(mass=3.0)
    rig.give("e", 0)
    rig.give("edit", 1, "mass", "2.50")
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    rig.give("edit", 4, "e", "0.5")
    rig.give("restart")
    assert rig.state["table"]["mass"] == rig.values("mass") == [3, 2.5, 3, 3, 3]
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


# --- commands that are none ------------------------------------------------------------------

# The third bob's middle: a ray from here grabs it, and drags it a little
RAY = [[R_PARAM / 20, -0.8 * R_PARAM, 0], [0, 0, -1]]
# Values for each command of an honest page, but of the controls only one of each kind.
# No question is open, no run to repeat.
ALLOWED = {
    "pause": [],
    "let_go": [],
    "arrows": [True],
    "repeat": [True],
    "speed": [0.5],
    "lifted": [2],
    "graph": ["Angles theta"],
    "answer": ["2_two_bobs", 0],
    "check": ["2.7"],
    "grab": RAY,
    "drag": RAY,
}
HUGE = 10**400
WRONG = [None, True, nan, inf, HUGE, -HUGE, "1", "x" * 10**6]
WRONG += [{}, [], [0, 0], [0, 0, 0, 0], [0, 0, nan], [0, 0, "1"], [[]] * 3]
REFUSED = [
    ("speed", 0.09),
    ("speed", 2.01),
    ("lifted", -1),
    ("lifted", 6),
    ("count", 0),
    ("count", 1.0),
    ("count", 10),
    ("e", 1.05),
    ("release_angle", 180.5),
    ("release_angle", -0.5),
    ("angle_phi", 30),
    ("arrows", 1),
    ("drag", RAY[0], [0, 0, 0]),
    ("drag", RAY[0], [1e-9] * 3),
    ("edit", 0, "color", ""),
    ("edit", 0, ["e"], "0"),
    ("edit", 0, "e", "0" * 1000),
    ("edit", -1, "e", "0"),
    ("edit", HUGE, "e", "0"),
    ("__init__",),
    (None,),
    (nan,),
    (["pause"],),
    ({"pause": 1},),
]


def wrong_values(values):
    """Return lists like this one with a value more, without one, and with a wrong one."""
    yield [*values, True]
    for place, value in enumerate(values):
        before, after = values[:place], values[place + 1 :]
        yield before + after
        for wrong in WRONG:
            if wrong is not value:
                yield [*before, wrong, *after]


for command, values in ALLOWED.items():
    REFUSED += [(command, *wrong) for wrong in wrong_values(values)]


def test_a_command_with_other_values_does_nothing(rig):
    """Anyone with the key can send anything that is JSON. None of it may end the program."""
    rig.give("pause")
    rig.give("grab", *RAY)
    before = dict(rig.state)
    for command in REFUSED:
        rig.give(*command)
        assert rig.state == before, command
        assert rig.viewer.held_bob.index == 2, command
    rig.give("drag", *RAY)
    assert rig.bob_angles()[2] == 3  # atan(1 / 20)
