"""Your CSV and the experiments: which one the page plays, and with which settings."""

import pytest
from rig import Rig
from students import put_files
from whole_cradles import FIVE_CSV, HEADER

from grading.cradles import MIXED_CSV
from support.files.experiments import EXPERIMENTS
from support.page.lesson import ASKED

CSV = "My cradle"
FROM_BOTH_SIDES = "From both sides"
BUILT_IN = str(EXPERIMENTS / "single" / "02_two_bobs.toml")


def test_a_saved_csv_ends_an_experiment_and_the_settings_stay(rig):
    """Also while paused. Its own masses and e count."""
    settings = {"ask": False, "speed": 0.5, "separating": True}
    for name, value in {**settings, "e": 0, "lifted": 3}.items():
        rig.give(name, value)
    rig.give("experiment", FROM_BOTH_SIDES)
    rig.give("pause")
    rig.save(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    assert rig.state == rig.state | settings | {"experiment": CSV, "running": False}
    assert rig.values("mass") == [2, 2]
    assert rig.values("e") == [0.5, 0.5]
    assert rig.state["lifted"] == rig.control("lifted")["max"] == 2
    rig.save(FIVE_CSV)
    assert rig.state["lifted"] == 3  # the old settings, where they are possible again


def test_back_at_your_csv_all_is_as_you_had_set_it(rig):
    rig.give("edit", 1, "mass", 3)
    rig.give("release_angle", 20)
    rig.give("lifted", 2)
    rig.give("e", 0)
    rig.give("experiment", FROM_BOTH_SIDES)
    rig.give("lifted", 5)
    rig.give("experiment", CSV)
    assert rig.values("mass") == [1, 3, 1, 1, 1]
    assert rig.values("e") == [0] * 5
    assert rig.bob_angles() == [20, 20, 0, 0, 0]


@pytest.mark.parametrize(("words", "e"), [("--e 0.25", 0.25), ("--elastic", 1), ("--inelastic", 0)])
def test_options_for_all_bobs_hold_in_each_saved_file(rig, start, words, e):
    rig.viewer.chooser.prepare = start("single", f"{words} --mass 2").viewer.chooser.prepare
    rig.save(MIXED_CSV)
    assert rig.values("mass") == [2] * 3
    assert rig.values("e") == [e] * 3


def test_an_experiment_by_its_file_takes_the_place_of_one_with_its_name(start, tmp_path):
    """Without a question, nothing is asked."""
    names = start("single", "").viewer.chooser.names()
    (tmp_path / "two.toml").write_text("name = 'Two bobs'\ntheta = [0, -10]")
    for path, count in ((BUILT_IN, 5), ("two.toml", 2)):
        viewer = start("single", f"--experiment {path}").viewer
        assert (viewer.chooser.name(), viewer.chooser.names()) == ("Two bobs", names)
        assert len(viewer.cradle.pend_list) == count
        assert (viewer.lesson.state == ASKED) == (path == BUILT_IN)
    hidden = BUILT_IN.replace("02_two_bobs", "16_an_unknown_mass")
    assert start("single", f"--experiment {hidden}").viewer.lesson.is_paused


def test_a_mistake_in_an_experiment_is_named(csv, tmp_path, monkeypatch):
    folder = put_files(tmp_path, {"single/one.toml": "theta = 'far'"})
    monkeypatch.setattr("support.page.chooser.EXPERIMENTS", folder)
    rig = Rig(csv)
    assert rig.control("experiment")["choices"] == [CSV]
    [mistake] = rig.state["mistakes"]
    assert "one.toml: " in mistake
