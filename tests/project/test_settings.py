"""Which cradle the page plays: what its sliders set, and what you choose."""

from math import degrees, pi

import pytest
from rig import Rig
from whole_cradles import GOOD, HEADER

from grading.cradles import MIXED_CSV
from support.cradle.double_cradle import DoubleCradle
from support.files.experiments import EXPERIMENTS
from support.page.graph import ENERGY, MOMENTA, NOTHING
from support.pendulum import outwards_to_angle

MAKE = "make_newton_cradle"
CSV = "My cradle"
TWO = "Two bobs"
FROM_BOTH_SIDES = "From both sides"
HEAVY = "A heavy one hits light ones"


def test_each_change_of_the_cradle_releases_it_again_and_reset_all_takes_it_back(rig):
    first = {name: rig.state[name] for name in rig.state["controls"]}
    changes = {
        "e": 0.5,
        "mass": 2,
        "release_angle": 10,
        "count": 4,
        "lifted": 2,
        "separating": True,
    }
    for name, value in changes.items():
        rig.wait(0.1)
        rig.give(name, value)
        assert rig.time() == 0, name
        assert rig.state["changed"]
    for name in ("arrows", "measure", "slow_hits"):
        rig.give(name, True)
    for name in ("ask_first", "ask_seen"):
        rig.give(name, False)
    rig.give("speed", 2)
    rig.give("next")
    rig.give("reset")
    assert {name: rig.state[name] for name in first} == first
    assert not rig.state["changed"]


def test_the_slider_of_e_sets_that_of_all_bobs_and_shows_all(rig):
    rig.give("e", 0.35)
    assert rig.values("e") == [0.35] * 5
    assert rig.state["e"] == 0.35
    assert rig.control("e")["text"] == "0.35"
    rig.give("edit", 4, "e", "0.5")
    assert rig.state["e"] == 0.5
    assert rig.control("e")["text"] == "0.35 to 0.5"


def test_the_mass_of_the_first_bob_is_set_as_in_the_table(rig):
    rig.give("mass", 5)
    assert rig.values("mass") == [5, 1, 1, 1, 1]
    assert rig.control("mass")["text"] == "5 kg"
    limits = {"min": 0.5, "max": 10}
    for mass, name in ((0.25, "min"), (12.5, "max")):
        rig.give("edit", 0, "mass", str(mass))
        assert rig.control("mass") == rig.control("mass") | limits | {name: mass}
        assert rig.state["mass"] == mass


def test_bobs_are_added_and_taken_away_at_the_right_end(csv):
    """First those of the file come back; an added one is like the last one, except for its color.

    The file stays as it is.
    """
    before = "2.0,0.5,0,0,white,wood\n" + GOOD
    csv.write_text(HEADER + before)
    rig = Rig(csv, 30, lifted=2)
    rig.give("pause")
    assert rig.control("count") == rig.control("count") | {"min": 1, "max": 9, "text": "2"}
    rig.give("count", 6)
    assert rig.state["count"] == 6
    assert rig.values("mass") == [2, 1, 1, 1, 1, 1]
    assert rig.values("color") == ["white", "red", "cyan", "blue", "purple", "red"]
    assert rig.values("texture") == ["wood", *["metal"] * 5]
    assert rig.bob_angles() == [30, 30, 0, 0, 0, 0]
    assert rig.control("lifted")["max"] == 6
    rig.give("edit", 3, "mass", "no mass")
    rig.give("count", 1)
    assert rig.values("color") == ["white"]
    assert rig.state["lifted"] == 1
    rig.give("count", 4)
    assert rig.values("color") == ["white", "red", "cyan", "blue"]
    assert rig.state["lifted"] == 2
    assert rig.state["refused"] == {}  # it was another bob's
    assert csv.read_text() == HEADER + before


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
    assert len(rig.thetas()) == 11
    assert rig.control("count")["max"] == 12  # the file has them


def test_the_programs_own_angle_and_masses_hold_in_each_cradle(csv, write):
    """An experiment has its angles."""
    made = "pend_list = make_newton_cradle(NC_FP, R_PARAM, -1.0)"
    write(MAKE, f"{made}; pend_list[1]['mass'] = 7")
    rig = Rig(csv, None, lifted=None)
    rig.give("count", 3)
    rig.give("e", 0.5)
    for name, thetas in ((TWO, [-pi / 4] * 2 + [0] * 3), (CSV, [-1, 0, 0])):
        rig.give("experiment", name)
        assert rig.thetas() == pytest.approx(thetas)
        assert rig.values("mass")[:3] == [1, 7, 1]
        assert rig.state["remark"] == "The program does not take mass from NC_FP."


def test_a_slider_that_springs_back_says_why(csv, write):
    write(MAKE, "pend_list[0]['e'] = 0.5")
    rig = Rig(csv, None, lifted=None)
    assert rig.state["remark"] == ""
    rig.give("e", 1)  # as in the CSV
    assert rig.state["remark"] == "The program does not take e from NC_FP."


def test_a_program_that_writes_your_csv_does_not_start_itself_again(csv, write):
    save = "from src.pds_helper import *; write_to_csv(pend_list)"
    write(MAKE, f"pend_list[0]['mass'] += 1; {save}")
    rig = Rig(csv)
    for mass in (2, 3):
        rig.wait(1)
        assert rig.time() > 0.9
        assert rig.state["table"]["mass"][0] == mass
        rig.give("restart")


def test_a_program_that_lifts_no_bob_says_how_many_the_slider_lifts(csv, write):
    write(MAKE, "pend_list[0]['theta'] = 0.0")
    rig = Rig(csv, None, lifted=None)
    assert rig.state["lifted"] == 0
    rig.give("release_angle", 30)
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    assert rig.state["lifted"] == 1


def test_each_angle_of_a_double_cradle_has_its_slider_and_its_graphs(csv):
    csv.write_text(HEADER + GOOD)
    rig = Rig(csv, 30, 10, kind=DoubleCradle)
    assert "separating" not in rig.state["controls"]
    rig.give("angle_theta", 75)
    rig.give("angle_phi", -12.5)
    assert rig.state["angle_theta"] == 75
    assert rig.values("theta") == pytest.approx([outwards_to_angle(75)])
    assert rig.values("phi") == pytest.approx([outwards_to_angle(-12.5)])
    assert rig.control("angle_phi")["label"] == "Angle phi"
    assert rig.control("angle_phi")["min"] == -180
    assert rig.control("graph")["choices"] == [
        ENERGY,
        MOMENTA,
        "Angles theta",
        "Angles phi",
        "Velocities omega",
        "Velocities phi_omega",
        "Phase 1, theta",
        "Phase 1, phi",
        NOTHING,
    ]
    rig.give("graph", "Angles phi")
    assert rig.state["curves"]["y"] == "phi (degrees)"
    assert rig.state["curves"]["rows"] == [[0, 12.5]]


def test_the_picture_of_a_choice_has_its_colors_masses_and_angles(rig):
    """Those of your CSV follow the file, and hang."""
    rig.save("mass,e,color,texture,note\n3,1,blue,metal,x\n1,1,red,metal\n")  # a short row
    pictures = rig.state["pictures"]
    assert list(pictures) == rig.control("experiment")["choices"]
    assert [bob["mass"] for bob in pictures[CSV]] == [3, 1]
    assert pictures[CSV][0]["color"] == "rgb(0, 0, 255)"
    assert [bob["angles"] for bob in pictures[CSV]] == [[0], [0]]
    assert [bob["mass"] for bob in pictures[HEAVY]] == [5, 1, 1, 1, 1]
    angles = [round(degrees(bob["angles"][0])) for bob in pictures[FROM_BOTH_SIDES]]
    assert angles == [-45, 0, 0, 0, 45]


@pytest.mark.parametrize("is_saved", [False, True])
def test_back_at_your_csv_all_is_as_you_had_set_it(rig, is_saved):
    """If the file was saved meanwhile, it comes back with its own masses and e."""
    rig.give("edit", 1, "mass", "3")
    rig.give("release_angle", 20)
    rig.give("lifted", 2)
    rig.give("e", 0)
    rig.give("experiment", FROM_BOTH_SIDES)
    rig.give("lifted", 5)
    if is_saved:
        rig.save(HEADER + GOOD * 6)
        rig.give("restart")
    else:
        rig.give("experiment", CSV)
    assert rig.state["experiment"] == CSV
    assert rig.values("mass") == ([1] * 6 if is_saved else [1, 3, 1, 1, 1])
    assert {*rig.values("e")} == {1 if is_saved else 0}
    assert rig.bob_angles()[:3] == [20, 20, 0]


# --- options ---------------------------------------------------------------------------------

BUILT_IN = str(EXPERIMENTS / "single" / "2_two_bobs.txt")


def test_ghosts_of_a_file_leave_an_experiment_as_it_is(start, tmp_path):
    (tmp_path / "film.csv").write_text("start,0,-20\nt,theta_1\n0,1\n")
    viewer = start("single", f"--experiment {BUILT_IN} --ghosts film.csv").viewer
    assert viewer.chooser.whole_experiment()


@pytest.mark.parametrize(("words", "e"), [("--e 0.25", 0.25), ("--elastic", 1), ("--inelastic", 0)])
def test_options_for_all_bobs_hold_in_each_saved_file(rig, start, words, e):
    rig.viewer.chooser.prepare = start("single", f"{words} --mass 2").viewer.chooser.prepare
    rig.save(MIXED_CSV)
    assert rig.values("mass") == [2] * 3
    assert rig.values("e") == [e] * 3


def test_an_experiment_by_its_file_takes_the_place_of_one_with_its_name(start, tmp_path):
    """Without a question, nothing is asked."""
    names = start("single", "").viewer.chooser.names()
    (tmp_path / "two.txt").write_text("name = Two bobs\ntheta = 0 -10")
    for path, count in ((BUILT_IN, 5), ("two.txt", 2)):
        viewer = start("single", f"--experiment {path}").viewer
        assert (viewer.chooser.name(), viewer.chooser.names()) == ("Two bobs", names)
        assert len(viewer.cradle.pend_list) == count
        assert bool(viewer.questions.asking) == (path == BUILT_IN)
