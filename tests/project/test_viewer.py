"""The viewer and its state on the stand-in; test_graph.py has its graph.

Time passes only when a test moves its own clock.
"""

from unittest.mock import Mock

import pytest
from rig import Rig
from whole_cradles import FIVE_CSV, GOOD, HEADER, PERIOD

from src import visualize_cradle_run
from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.player import run
from support.cradle.real_time import FRAME
from support.files.cradle_csv import POLL
from support.page.graph import ENERGY, NOTHING
from support.pendulum import outwards_to_angle

TWO = "Two bobs"
INELASTIC = "perfectly inelastic, e = 0"


def test_pause_and_run(rig):
    """A command only queues: it comes in another thread, in the middle of a tick."""
    rig.wait(1)
    rig.give("pause")
    paused = dict(rig.state)
    assert not paused["running"]
    rig.wait(1)
    assert rig.state == paused  # so nothing is sent
    rig.tabs.give("pause")
    assert not rig.viewer.is_time_running()
    rig.wait(1)
    assert rig.state["running"]
    # The simulation does not catch up after the pause
    assert rig.time() == pytest.approx(2, abs=4 * FRAME)


@pytest.mark.parametrize("speed", [0.1, 2])
def test_speed_and_slow_motion(rig, speed):
    """A step moves the cradle by one frame, but only while it is paused."""
    rig.give("speed", speed)
    rig.wait(2)
    assert rig.state["speed"] == speed
    assert rig.time() == pytest.approx(2 * speed, abs=0.05 * speed)
    rig.viewer.pace.kept_up = 0.4
    rig.wait()
    assert rig.state["motion"]["t"].endswith(f" s {0.4 * speed:.2g}x real time")
    ticks = rig.viewer.motion.ticks
    rig.give("step")
    assert rig.viewer.motion.ticks == ticks
    rig.give("pause")
    rig.give("step")
    assert rig.viewer.motion.ticks - ticks == round(speed * FRAME / rig.cradle.dt)


def test_the_box_of_a_fixed_rule_is_fixed(rig, csv, monkeypatch):
    assert rig.control("separating")["enabled"]
    assert not rig.state["separating"]
    monkeypatch.setattr(
        visualize_cradle_run, "newton_cradle_tick", lambda pend_list, r_param, dt, g: None
    )
    fixed = Rig(csv)
    fixed.give("separating", False)
    assert not fixed.control("separating")["enabled"]
    assert fixed.state["separating"]


def test_the_menu_of_collisions_has_the_present_one(rig):
    names = rig.control("collision")["choices"]
    rig.viewer.actions.set_collision(rig.cradle.uniform_e(0.3))
    rig.wait()
    assert rig.state["collision"] == "e = 0.3"
    assert rig.values("e") == [0.3] * 5
    assert rig.control("collision")["choices"] == [*names, "e = 0.3"]
    rig.give("collision", names[0])
    assert rig.control("collision")["choices"] == names
    assert rig.values("e") == [1.0] * 5


def test_one_e_for_all_bobs_has_the_names_of_the_menu(rig):
    """The slider shows what they have; the last bob's e counts, too."""
    names = rig.control("collision")["choices"]
    for e, name in ((1, "elastic, e = 1"), (0.35, "e = 0.35"), (0, INELASTIC)):
        rig.give("e", e)
        assert rig.values("e") == [e] * 5
        assert rig.state["e"] == e
        assert rig.state["collision"] == name
        assert rig.control("collision")["choices"] == [*dict.fromkeys([*names, name])]
        assert rig.control("e")["text"] == f"{e:g}"
    rig.give("edit", 4, "e", "0.5")
    assert rig.state["e"] == 0.5
    assert rig.control("e")["text"] == "0 to 0.5"
    rig.give("experiment", TWO)
    rig.give("e", 0.8)
    assert rig.state["changed"]


@pytest.mark.parametrize("is_written", [True, False])
def test_no_tab_sets_e_before_its_function_is_written(csv, monkeypatch, is_written):
    stubs = {} if is_written else {"uniform_e_newton_cradle": None}
    monkeypatch.setattr("support.cradle.cradle.unwritten_in", lambda module: stubs)
    rig = Rig(csv)
    assert rig.control("e")["enabled"] == is_written
    rig.give("e", 0.5)
    assert rig.state["e"] == (0.5 if is_written else 1)


def test_the_mass_of_the_first_bob_is_set_as_in_the_table(rig, csv):
    rig.give("mass", 5)
    assert rig.values("mass") == [5, 1, 1, 1, 1]
    assert rig.control("mass")["text"] == "5 kg"
    assert rig.state["collision"] == "as changed"
    assert csv.read_text() == FIVE_CSV
    limits = {"min": 0.5, "max": 10}
    assert rig.control("mass") == rig.control("mass") | limits
    for mass, name in ((0.25, "min"), (12.5, "max")):
        rig.give("edit", 0, "mass", str(mass))
        assert rig.control("mass") == rig.control("mass") | limits | {name: mass}
        assert rig.state["mass"] == mass


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_bobs_are_added_and_taken_away_at_the_right_end(csv, kind):
    """An added one is like the last one, but for its color; the file stays as it is."""
    before = "2.0,0.5,0,0,white,wood\n" + GOOD
    csv.write_text(HEADER + before)
    rig = Rig(csv, *[30, 0][: kind.cord_count], kind=kind)
    rig.give("pause")
    rig.give("lifted", 2)
    assert rig.control("count") == rig.control("count") | {"min": 1, "max": 9, "text": "2"}
    rig.give("count", 6)
    assert rig.state["count"] == 6
    assert rig.values("mass") == [2, 1, 1, 1, 1, 1]
    assert rig.values("e") == [0.5, 1, 1, 1, 1, 1]
    colors = ["white", "red", "cyan", "blue", "purple", "red"]
    assert rig.values("color") == colors
    assert rig.values("texture") == ["wood", *["metal"] * 5]
    assert rig.bob_angles() == [30, 30, 0, 0, 0, 0]
    assert rig.control("lifted")["max"] == 6
    assert rig.state["collision"] == "as changed"
    rig.give("edit", 3, "mass", "no mass")
    rig.give("count", 1)
    assert rig.values("color") == ["white"]
    assert rig.state["lifted"] == 1
    rig.give("count", 2)
    assert rig.values("mass") == [2, 2]
    assert rig.state["lifted"] == 2
    rig.give("count", 4)
    assert rig.state["refused"] == {}  # it was another bob's
    assert csv.read_text() == HEADER + before


def test_an_experiment_with_another_number_of_bobs_is_changed(rig):
    """The bobs are then lifted as the sliders say; a CSV with more bobs has a wider slider."""
    rig.give("ask first", True)
    rig.give("experiment", TWO)
    rig.give("count", 3)
    assert rig.state["changed"]
    assert rig.state["question"] is None
    assert rig.bob_angles() == [45, 45, 0]
    rig.give("experiment", TWO)
    assert rig.state["count"] == 5
    rig.save(HEADER + GOOD * 12)
    rig.give("count", 11)
    assert len(rig.thetas()) == 11
    assert rig.control("count")["max"] == 11


def test_a_cradle_of_which_main_lifts_no_bob_says_how_many_the_slider_lifts(csv, monkeypatch):
    monkeypatch.setattr("whole_cradles.THETA_INIT", 0.0)
    rig = Rig(csv, None, lifted=None)
    assert rig.state["lifted"] == 0
    rig.give("release angle", 30)
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    assert rig.state["lifted"] == 1


def test_each_angle_of_a_double_cradle_has_its_slider_and_its_graphs(csv):
    csv.write_text(HEADER + GOOD * 2)
    rig = Rig(csv, 30, 10, kind=DoubleCradle)
    assert "separating" not in rig.state["controls"]
    for key, least, angle in (("theta", 0, 75), ("phi", -180, -12.5)):
        name = f"angle {key}"
        assert rig.control(name)["label"] == name.capitalize()
        assert rig.control(name)["min"] == least
        assert rig.control(name)["max"] == 180
        rig.give(name, angle)
        assert rig.state[name] == angle
        assert rig.values(key)[0] == pytest.approx(outwards_to_angle(angle))
    assert rig.state["angle theta"] == 75
    assert rig.state["keys"] == ["theta", "phi", "omega", "phi_omega"]
    assert rig.control("graph")["choices"] == [
        ENERGY,
        "Angles theta",
        "Angles phi",
        "Velocities omega",
        "Velocities phi_omega",
        "Phase 1, theta",
        "Phase 1, phi",
        "Phase 2, theta",
        "Phase 2, phi",
        NOTHING,
    ]
    rig.give("graph", "Angles phi")
    assert rig.state["curves"]["y"] == "phi (rad)"
    phi = outwards_to_angle(-12.5)
    assert rig.state["curves"]["rows"][0] == pytest.approx([0, phi, 0], abs=1e-6)


def test_settings_stay_after_a_restart_and_for_a_saved_csv(rig):
    """Also while paused."""
    rig.wait(0.1)
    settings = {"speed": 0.5, "separating": True, "collision": INELASTIC, "running": False}
    for name in ("speed", "separating", "collision"):
        rig.give(name, settings[name])
    rig.give("pause")
    rig.give("restart")
    assert rig.state == rig.state | settings
    rig.save(HEADER + GOOD * 3)
    assert rig.state == rig.state | settings
    assert rig.values("e") == [0] * 3
    assert rig.time() == 0


def test_numbers_change_ten_times_a_second_and_what_is_in_step_with_the_bobs_in_each_frame(rig):
    states = []
    rig.tabs.show = states.append
    for _ in range(60):
        rig.now += FRAME
        rig.do_frame()
    assert len(states) == 60
    assert all({"sound", "view"} <= state.keys() for state in states)
    assert 8 <= sum("motion" in state for state in states) <= 10


def test_while_no_tab_has_room_nothing_is_shown_and_no_hit_is_lost(rig):
    rig.tabs.have_room = lambda: False
    before = dict(rig.state)
    rig.wait(2)
    assert rig.state == before  # it would only wait
    rig.tabs.have_room = lambda: True
    rig.wait()
    assert rig.state["sound"]["count"] == 4  # a hit in each half of a period, 0.9 s


def test_a_hit_is_heard_with_its_speed_and_bobs_that_rest_on_each_other_are_not(rig):
    """From 30 degrees, a bob comes down at sqrt(2 g R (1 - cos 30 degrees)) = 0.73 m/s."""
    assert rig.state["sound"] == {"count": 0, "speed": 0}
    rig.wait(0.4)
    assert rig.state["sound"] == {"count": 1, "speed": pytest.approx(0.73, abs=0.01)}
    rig.give("collision", INELASTIC)
    rig.wait(5)
    sound = rig.state["sound"]
    rig.cradle.pend_list[0]["omega"] = 0.02  # rad/s: 4 mm/s
    rig.wait(2)
    assert rig.state["sound"] == sound


def test_the_first_cradle_is_released_when_a_tab_has_drawn_it(rig):
    """Else nobody would see the release. The time until then does not count."""
    is_seen = rig.tabs.is_seen
    is_seen.clear()
    times = []

    def wait(seconds):
        rig.now += 5
        times.append(rig.now)
        if len(times) == 3:
            is_seen.set()

    is_seen.wait = wait
    rig.begin()
    assert len(times) == 3
    assert rig.viewer.motion.ticks == 0


@pytest.mark.parametrize("is_paused", [False, True])
def test_the_loop_ends_when_the_last_tab_is_closed(rig, is_paused):
    """Also if no tab has drawn a picture."""
    if is_paused:
        rig.give("pause")
    rig.tabs.is_seen.clear()
    rig.tabs.are_gone = True
    rig.viewer.pace.sleep = Mock(side_effect=[None] * 3)
    run(visualize_cradle_run.main, rig.viewer)
    assert rig.viewer.is_over


def test_a_saved_csv_makes_a_new_cradle(rig):
    rig.wait(1)
    rig.give("lifted", 3)
    rig.save(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    assert rig.values("mass") == [2, 2]
    assert rig.state["lifted"] == rig.control("lifted")["max"] == 2
    assert rig.time() < 3 * POLL
    rig.save(FIVE_CSV)
    assert rig.state["lifted"] == 3  # the old settings, where they are possible again


def test_a_swing_above_the_frame_widens_the_view_until_the_next_restart(rig):
    near = rig.state["view"]
    rig.give("release angle", 150)
    assert rig.state["view"] != near
    rig.give("release angle", 45)
    assert rig.state["view"] == near


# --- the texts -------------------------------------------------------------------------------


def test_a_key_that_the_handout_does_not_have_is_named(csv):
    """Columns of the CSV are no such keys."""
    csv.write_text("name," + HEADER + f"a,{GOOD}b,{GOOD}")
    rig = Rig(csv, remark="Write next: main.")
    assert rig.state["remark"] == "Write next: main."
    rig.cradle.pend_list[1]["Theta"] = 0.5
    rig.wait()
    message = "Write next: main. Pendulum 2 has the key 'Theta', which the handout does not have."
    assert rig.state["remark"] == message


@pytest.mark.parametrize(
    ("omega", "text"),
    [
        (3, "+{:.3f} kg m/s →"),
        (-3, "-{:.3f} kg m/s ←"),
        (0, "+{:.3f} kg m/s"),
        (1e154, "+{:.2e} kg m/s →"),
    ],
)
def test_the_readout(rig, omega, text):
    """The momentum has the arrow of its sign.

    A percentage is at most 999, also if it has no end, and 0 of 0 is 0.
    """
    rig.give("pause")
    rig.cradle.pend_list[0].update(theta=0.0, omega=omega)
    rig.wait()
    start = G * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg at 30 degrees
    percent = 100 * (omega * R_PARAM) ** 2 / 2 / start
    assert rig.state["motion"] == {
        "t": "0.00 s",
        "energy": "> 999 %" if percent > 999 else f"{percent:.1f} %",
        "momentum": text.format(abs(omega) * R_PARAM),
    }
    rig.give("lifted", 0)
    assert rig.state["motion"]["energy"] == "0.0 %"


def test_the_page_says_that_gravity_and_the_cord_are_constants_and_where(rig):
    words = rig.state["constants"]
    assert words.startswith(f"Gravity (G = {G} m/s^2), the length of a cord (R_PARAM = {R_PARAM} ")
    assert " are constants of the program, in support/constants.py. The page cannot " in words
    assert words.endswith(": main has the handout's line, which takes them from there.")


def test_the_impacts_until_a_restart(rig):
    rig.wait(0.9 * PERIOD)
    last, first = rig.state["impacts"]
    assert last.endswith(" s  5-4-3-2-1")
    assert first.startswith(f"t = {PERIOD / 4:.1f}")
    assert first.endswith(" s  1-2-3-4-5")
    assert rig.state["colors"] == ["rgb(255, 0, 0)"] * 5
    rig.give("restart")
    assert rig.time() == 0
    assert rig.bob_angles() == [30, 0, 0, 0, 0]
    assert rig.state["impacts"] == []
