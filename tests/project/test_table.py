"""The table of the pendula on the stand-in: masses and e to change, live numbers, one tick; and
refused commands.
"""

from math import inf, nan

import pytest
from rig import Rig
from whole_cradles import FIVE_CSV, GOOD, HEADER

from src import visualize_cradle_run
from support.constants import DT, R_PARAM
from support.cradle.cradle import Cradle, DoubleCradle


def test_the_table_shows_pend_list_as_it_is_now(rig):
    rig.give("lifted", 2)
    rig.wait(0.3)
    now = rig.state["now"]
    assert list(now) == [f"{key}_{i}" for key in ("theta", "omega") for i in range(1, 6)]
    assert [*map(float, now.values())] == pytest.approx(
        rig.values("theta") + rig.values("omega"), abs=5e-7
    )
    assert any(rig.values("omega"))
    assert [rig.state[name] for name in ("keys", "mass", "e")] == [
        ["theta", "omega"],
        [1] * 5,
        [1] * 5,
    ]


def test_main_makes_the_cradle_of_an_edited_cell_with_the_masses_and_e_that_are_shown(rig, csv):
    """They came from --mass and from the menu: nothing else may change with the edit."""
    rig.viewer.chooser.set(mass=3.0)
    rig.give("restart")
    rig.give("collision", "perfectly inelastic, e = 0")
    assert (rig.state["mass"], rig.state["e"]) == ([3] * 5, [0] * 5)
    rig.wait(0.3)
    rig.give("edit", 1, "mass", "2.50")
    assert (rig.time(), rig.lifts(), rig.values("e")) == (0, [30, 0, 0, 0, 0], [0] * 5)
    assert (rig.state["mass"], rig.state["collision"]) == ([3, 2.5, 3, 3, 3], "as in the CSV")
    rig.give("edit", 4, "e", "0.5")
    for _ in range(2):
        assert (rig.values("mass"), rig.values("e")) == ([3, 2.5, 3, 3, 3], [0, 0, 0, 0, 0.5])
        rig.give("restart")
    assert csv.read_text() == FIVE_CSV


def test_a_bad_value_says_the_allowed_ones_and_the_cradle_swings_on(rig):
    rig.wait(0.3)
    rig.give("edit", 3, "mass", "<b>")
    mistake = {"3,mass": ["<b>", "mass: allowed is a number from 1e-300 to 1e6 (kg), such as 1.5"]}
    assert (rig.state["refused"], rig.time() > 0.2) == (mistake, True)
    rig.give("edit", 0, "e", "0.25")  # another cell does not hide the mistake
    assert rig.state["refused"] == mistake
    rig.give("edit", 3, "mass", " 0.5 ")
    assert (rig.state["refused"], rig.values("mass")[3], rig.values("e")[0]) == ({}, 0.5, 0.25)
    rig.give("edit", 1, "e", "2")
    rig.save(HEADER + GOOD * 3)  # a saved file replaces it all
    rig.give("edit", 3, "mass", "2")  # of a row that is no longer there
    assert (rig.values("mass"), rig.values("e"), rig.state["refused"]) == ([1] * 3, [1] * 3, {})


def test_masses_too_far_apart_are_refused_only_in_the_double_cradle(rig, csv):
    """In the table, and in a saved file: the old cradle stays."""
    rig.give("edit", 3, "mass", "1e-7")
    assert rig.values("mass")[3] == 1e-7
    double = Rig(csv, 30, 10, kind=DoubleCradle)
    double.give("pause")  # it then needs no ticks
    double.give("edit", 3, "mass", "9e-7 ")
    words = "mass: allowed is at most 1e6 times the smallest mass, in a double cradle"
    assert double.state["refused"] == {"3,mass": ["9e-7 ", words]}
    double.give("edit", 3, "mass", "1e-6")
    double.save(
        HEADER + "".join(GOOD.replace("1.0", mass, 1) for mass in ("0.5", "500000", "3", ".4"))
    )
    assert double.values("mass") == [1, 1, 1, 1e-6, 1]
    assert (
        "line 3, column mass: found '500000', and '.4' in line 5, allowed is at most"
        in double.state["error"]
    )


# --- commands that are none ------------------------------------------------------------------------------------------

HUGE, AHEAD = 10**400, [0, 0, -1]
# The third bob's middle: a ray from here grabs it, and drags it a little
BESIDE = [R_PARAM / 20, -0.8 * R_PARAM, 0]
NO_TEXTS = [
    None,
    True,
    1,
    nan,
    ["Angles theta"],
    {"Energies": 1},
    "",
    "nobody",
    "__class__",
    "x" * 10**6,
]
NO_COUNTS = [None, True, -1, 1.0, 1e400, nan, "1", [1], {}, HUGE]
NO_NUMBERS = [None, True, "1", [1], {}, nan, inf, -inf, HUGE, -HUGE, 1e300]
NO_POINTS = [
    *NO_NUMBERS,
    [],
    [0, 0],
    [0, 0, 0, 0],
    {"x": 0},
    [[[[]]]] * 3,
    *([0, 0, value] for value in NO_NUMBERS),
]
NO_RAYS = [[], [BESIDE], [BESIDE, AHEAD, AHEAD], [BESIDE, [0, 0, 0]], [BESIDE, [1e-9] * 3]]
NO_RAYS += [ray for point in NO_POINTS for ray in ([point, AHEAD], [BESIDE, point])]
REFUSED = {  # lists of values, for each command that an honest page gives with others
    **{
        name: [["x"], [1], [[]], [False, 1]]
        for name in ("pause", "step", "tick", "restart", "next", "let go")
    },
    **{
        name: [["x"], [1], [0], [None], [[True]], [], [True, True]]
        for name in ("arrows", "slow hits", "ask first")
    },
    "separating": [[1], [], ["true"], [True, True]],
    "again": [[1], [], [None], [True], [False]],  # there is no run to repeat
    "speed": [[0], [0.09], [2.01], [-1], [], [1, 1], *([value] for value in NO_NUMBERS)],
    "lifted": [[6], [], [1, 1], *([value] for value in NO_COUNTS)],
    "lift": [
        [0],
        [1, 30],
        [0, 180.5],
        *([0, n] for n in NO_NUMBERS),
        *([n, 30] for n in NO_COUNTS),
    ],
    **{
        name: [[], *([value] for value in NO_TEXTS)]
        for name in ("collision", "graph", "span", "experiment")
    },
    "edit": [
        [0, "color", ""],
        [0, "e", 0],
        [0, "e", "0" * 1000],
        [0, ["e"], "0"],
        *([n, "e", "0"] for n in NO_COUNTS),
    ],
    "answer": [
        ["2_two_bobs", 0],
        ["2_two_bobs"],
        [[], 0],
        ["", None],
        *(["", n] for n in NO_COUNTS),
    ],
    "vote": [["2_two_bobs", 0], ["", 0], ["2_two_bobs", None]],
    **dict.fromkeys(("grab", "drag"), NO_RAYS),
    **{name: [[1]] for name in ("", "nobody", "__init__", "make_actions", "reload", "frame")},
}


@pytest.mark.parametrize("command", REFUSED)
def test_a_command_with_other_values_does_nothing(rig, command):
    """Anyone with the key can send anything that is JSON. None of it may end the program."""
    rig.give("pause")
    if command == "drag":
        rig.give("grab", BESIDE, AHEAD)
    before = rig.viewer.state(), rig.viewer.cradle.hand.held
    for values in REFUSED[command]:
        rig.give(command, *values)
        assert (rig.viewer.state(), rig.viewer.cradle.hand.held) == before, values
    for name in (None, 1, nan, [command], {command: 1}, True):
        rig.give(name, *REFUSED[command][0])
    assert rig.viewer.state() == before[0]
    rig.give("grab", BESIDE, AHEAD)
    rig.give("drag", BESIDE, AHEAD)
    assert (rig.viewer.cradle.hand.held, rig.lifts()[2]) == (2, 3)  # atan(1 / 20)


# --- one tick --------------------------------------------------------------------------------------------------------


def test_one_tick_shows_each_pendulum_before_and_after_while_paused(rig, monkeypatch):
    """Also before handle_collision is written."""
    rig.give("tick")
    assert rig.state["tick"] == []
    rig.give("pause")
    theta = rig.values("theta")[0]
    rig.give("tick")
    assert rig.viewer.motion.ticks == 1
    first, *pendula, last = rig.state["tick"]
    angle = f"[0] theta {theta:.6g} -> {rig.values('theta')[0]:.6g}"
    assert first == f"One tick, {DT:g} s: before -> after"
    assert pendula[0] == angle.ljust(34) + f"omega 0 -> {rig.values('omega')[0]:.6g}"
    assert [line[:9] for line in pendula] == [f"[{i}] theta" for i in range(5)]
    assert last == "No call of handle_collision was seen."
    rig.give("restart")
    assert rig.state["tick"] == []
    monkeypatch.delattr(visualize_cradle_run, "handle_collision")
    rig.give("tick")
    assert rig.state["tick"][-1] == last


CALLS = {
    Cradle: f"handle_collision(e=1, omega1=2, omega2=0, m1=1, m2=1, r_param={R_PARAM:g}) returned (0, 2)",
    DoubleCradle: "handle_two_double_bobs(pend1=pend_list[0], pend2=pend_list[1], "
    f"r_param={R_PARAM:g}) returned True",
}


@pytest.mark.parametrize("kind", CALLS)
def test_one_tick_shows_each_call_of_the_collision_function(csv, kind):
    """Two pendula hang so that they touch, and the first one moves towards the second one."""
    csv.write_text(HEADER + GOOD * 2)
    rig = Rig(csv, *[0] * len(kind.angle_keys), kind=kind)
    rig.give("pause")
    first = rig.viewer.cradle.pend_list[0]
    first["objects"][1].radius *= 1.5
    first["omega"] = 2.0
    rig.give("tick")
    _, *pendula, call = rig.state["tick"][:4]
    assert call == CALLS[kind]
    assert [line.count("->") for line in pendula] == [2 * len(kind.angle_keys)] * 2
