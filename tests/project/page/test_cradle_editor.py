"""Which cradle the page plays: what its sliders set, and what you choose."""

from math import pi

import pytest
from rig import Rig
from vpython import vector
from whole_cradles import GOOD, HEADER, thetas

MAKE = "make_newton_cradle"
CSV = "My cradle"
TWO = "Two bobs"


@pytest.mark.parametrize(
    ("name", "value", "key", "values"),
    [
        ("e", 0.35, "e", [0.35] * 5),
        ("mass", 5, "mass", [5, 1, 1, 1, 1]),
        ("release_angle", 10, "theta", thetas([10, 0, 0, 0, 0])),
    ],
)
def test_a_slider_changes_the_cradle_and_my_cradle_chosen_again_is_as_at_the_start(
    rig, name, value, key, values
):
    first = rig.control(name)
    rig.give("separating", True)
    rig.wait(0.1)
    rig.give(name, value)
    assert (rig.state[name], rig.state["changed"], rig.time()) == (value, True, 0)
    assert rig.values(key) == pytest.approx(values)
    rig.give("experiment", CSV)
    assert rig.control(name) == first
    assert not (rig.state["separating"] or rig.state["changed"])


def test_a_second_bob_that_is_dragged_out_counts_as_lifted(rig):
    """It pushes the first one. The last one is out; hits have left the others a little."""
    rig.wait(1.25)
    rig.mouse("grab", rig.cradle.bobs()[1].pos)
    rig.mouse("drag", rig.cradle.axles()[1].pos - vector(1, 0, 0))
    rig.give("let_go")
    assert rig.control("lifted")["text"] == "3 of 5"
    rig.give("restart")
    assert rig.state["lifted"] == 1


def test_bobs_are_added_and_taken_away_at_the_right_end(csv):
    """First those of the file come back; an added one is like the last one, except for its color.

    The file stays as it is.
    """
    before = f"{HEADER}2.0,0.5,0,0,white,wood\n{GOOD}"
    csv.write_text(before)
    rig = Rig(csv, 30, lifted=2)
    colors = ["white", "red", "cyan", "blue", "purple", "red"]
    for count in (6, 1, 4):
        rig.give("count", count)
        assert rig.values("mass") == [2, 1, 1, 1, 1, 1][:count]
        assert rig.values("color") == colors[:count]
        assert rig.bob_angles() == [30, 30, 0, 0, 0, 0][:count]
        assert rig.control("lifted")["text"] == f"{min(count, 2)} of {count}"
    assert csv.read_text() == before


def test_an_experiment_with_another_number_of_bobs_is_changed(rig):
    """The bobs are then lifted as the sliders say; a CSV with more bobs has a wider slider."""
    rig.give("experiment", TWO)
    rig.give("count", 3)
    assert rig.state["changed"]
    assert rig.bob_angles() == [45, 45, 0]
    rig.give("experiment", TWO)
    assert rig.state["count"] == 5
    rig.save(HEADER + GOOD * 12)
    rig.give("count", 11)
    assert len(rig.values("theta")) == 11
    assert rig.control("count")["max"] == 12  # the file has them


def test_the_programs_own_angle_holds_in_each_cradle(csv, write):
    """An experiment has its angles."""
    write(MAKE, "pend_list = make_newton_cradle(NC_FP, R_PARAM, -1.0)")
    rig = Rig(csv, None, lifted=None)
    rig.give("count", 3)
    for name, angles in ((TWO, [-pi / 4] * 2 + [0] * 3), (CSV, [-1, 0, 0])):
        rig.give("experiment", name)
        assert rig.values("theta") == pytest.approx(angles)


def test_a_program_that_writes_your_csv_does_not_start_itself_again(csv, write):
    save = "from src.pds_helper import *; write_to_csv(pend_list)"
    write(MAKE, f"pend_list[0]['mass'] += 1; {save}")
    rig = Rig(csv)
    for mass in (2, 3):
        rig.wait(1)
        assert rig.time() > 0.9
        assert rig.values("mass")[0] == mass
        rig.give("restart")


def test_a_program_that_lifts_no_bob_says_how_many_the_slider_lifts(csv, write):
    write(MAKE, "pend_list[0]['theta'] = 0.0")
    rig = Rig(csv, None, lifted=None)
    assert rig.state["lifted"] == 0
    rig.give("release_angle", 30)
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    assert rig.state["lifted"] == 1
