"""The viewer and its state on the stand-in; test_graph.py has its graph.

Time passes only when a test moves its own clock.
"""

from itertools import pairwise
from unittest.mock import Mock

import pytest
from rig import Rig
from vpython import scene, vector
from whole_cradles import FIVE_CSV, GOOD, HEADER, PERIOD, thetas, velocities

from src import visualize_cradle_run
from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.player import run
from support.cradle.real_time import FRAME
from support.energy import momentum
from support.files.cradle_csv import POLL
from support.page.graph import ENERGY, NOTHING
from support.page.scene.marks import ARROW_TIME, FLAT, YELLOW
from support.page.scene.slow_hits import EACH

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
    assert not rig.viewer.running
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
    assert rig.state["motion"]["t"].endswith(" s")
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


def test_each_angle_of_a_double_cradle_has_its_slider_and_its_graphs(csv):
    csv.write_text(HEADER + GOOD * 2)
    rig = Rig(csv, 30, 10, kind=DoubleCradle)
    for name, least in (("angle theta", 0), ("angle phi", -180)):
        assert rig.control(name)["label"] == name.capitalize()
        assert rig.control(name)["min"] == least
        assert rig.control(name)["max"] == 180
    assert "separating" not in rig.state["controls"]
    rig.set_release_angle(75)
    rig.set_release_angle(-12.5, cord=1)
    assert rig.release_angles() == [75, -12.5]
    theta, phi = thetas([75, -12.5])
    assert rig.values("theta")[0] == pytest.approx(theta)
    assert rig.values("phi")[0] == pytest.approx(phi)
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
    assert rig.state["sound"][0] == 4  # a hit in each half of a period, 0.9 s


def test_a_hit_is_heard_with_its_speed_and_bobs_that_rest_on_each_other_are_not(rig):
    """From 30 degrees, a bob comes down at sqrt(2 g R (1 - cos 30 degrees)) = 0.73 m/s."""
    assert rig.state["sound"] == [0, 0]
    rig.wait(0.4)
    assert rig.state["sound"] == [1, pytest.approx(0.73, abs=0.01)]
    rig.give("collision", INELASTIC)
    rig.wait(5)
    sound = rig.state["sound"]
    rig.cradle.pend_list[0]["omega"] = 0.02  # rad/s: 4 mm/s
    rig.wait(2)
    assert rig.state["sound"] == sound
    assert rig.state["impacts"]


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
    rig.tabs.is_seen = Mock(**{"is_set.return_value": False, "wait.side_effect": [None] * 3})
    rig.tabs.are_gone = True
    rig.viewer.pace.sleep = Mock(side_effect=[None] * 3)
    run(visualize_cradle_run.main, rig.viewer)
    assert rig.viewer.is_over


# --- arrows and slow hits --------------------------------------------------------------------


def visible(rig, name):
    return [shape for shape in rig.viewer.marks.shapes.get(name, []) if shape.visible]


def lowest(rig):
    """Return the height (m) of the lowest point that each camera shows."""
    return min(y for _, y, _ in rig.state["view"]["points"])


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_the_velocities_of_the_bobs_that_move_and_bars_all_momenta(csv, kind):
    """Also for a later cradle; the view has room for the bars, and for the words beside them."""
    rig = Rig(csv, *[30] * len(kind.angle_keys), kind=kind)
    ground = lowest(rig)
    rig.give("arrows", True)
    rig.save(HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD)
    rig.give("restart")
    rig.wait(0.15)  # the first pendulum is on its way to the second one
    cradle = rig.cradle
    marks = rig.viewer.marks
    arrows = visible(rig, "arrows")
    moves = velocities(cradle.pend_list[0])
    assert len(arrows) == len(moves)
    assert pytest.approx(PERIOD / 9) == ARROW_TIME
    for arrow, bob, velocity in zip(arrows, cradle.bobs(), moves, strict=False):
        assert arrow.pos.value[:2] == bob.pos.value[:2]
        assert arrow.axis.value == pytest.approx((ARROW_TIME * velocity).value)

    bars = visible(rig, "bars")
    momenta = [momentum([pend], R_PARAM) for pend in cradle.pend_list]
    momenta.append(sum(momenta))  # its bar is the last one
    for bar, p in zip(bars, momenta, strict=True):
        height = marks.height * p / marks.largest
        assert bar.size.y == pytest.approx(max(abs(height), FLAT * marks.height))
        assert bar.pos.y == pytest.approx(marks.level + height / 2)
    axles = [axle.pos.x for axle in cradle.axles()]
    assert [bar.pos.x for bar in bars[:-1]] == axles
    assert [bar.color for bar in bars[:-1]] == cradle.colors()
    (left, _, text), (right, level, _) = rig.state["view"]["labels"]
    assert text == "momentum\n(up = right)"
    assert left < axles[0] < axles[1] < bars[-1].pos.x < right
    assert level == marks.level
    assert lowest(rig) < marks.level - marks.height
    assert marks.level + marks.height < ground

    rig.give("arrows", False)
    assert not any(shape.visible for shape in arrows + bars)
    assert rig.state["view"]["labels"] == []
    assert lowest(rig) == ground


def reversed_order(pend_list, r_param, dt, g):
    """Let the pairs collide from right to left, as a student may have written it."""
    visualize_cradle_run.full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in reversed([*pairwise(pend_list)]):
        visualize_cradle_run.handle_two_bobs(pend1, pend2, r_param, approaching_only=True)


@pytest.mark.parametrize(
    ("tick", "pairs"),
    [
        (visualize_cradle_run.newton_cradle_tick, "23 12 34 23 45 34"),
        (reversed_order, "23 34 12 45 23 34"),
    ],
)
def test_slow_hits_show_each_pair_in_the_order_of_the_calls_and_then_the_swing_goes_on(
    csv, monkeypatch, tick, pairs
):
    """With its speeds, its halos and the arrows after it."""
    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", tick)
    rig = Rig(csv, 45, lifted=2)
    rig.give("slow hits", True)
    rig.give("arrows", True)
    pendula = [id(pend) for pend in rig.cradle.pend_list]
    rig.wait(PERIOD / 4 + EACH / 4)
    moving = {1, 2}
    for number, pair in enumerate(pairs.split(), start=1):
        left, right = map(int, pair)
        assert rig.state["hit"] == {
            "title": f"Hit {number}: bobs {left} and {right}",
            "lines": [f"bob {left}: +1.07 → +0.00 m/s", f"bob {right}: +0.00 → +1.07 m/s"],
            "note": "This order is the model's: a tick takes one pair after the other.",
        }
        places = [bob.pos.x for bob in rig.cradle.bobs()]
        assert [halo.pos.x for halo in visible(rig, "halos")] == places[left - 1 : right]
        moving.remove(left)
        moving.add(right)
        arrows = [arrow.pos.x for arrow in visible(rig, "arrows")]
        assert arrows == [places[bob - 1] for bob in sorted(moving)]
        ticks = rig.viewer.motion.ticks
        rig.wait(EACH / 2)
        assert rig.viewer.motion.ticks == ticks  # the time holds
        rig.wait(EACH / 2)
    assert rig.state["hit"] is None
    assert not any(shape.color == YELLOW for shape in scene.objects)
    assert rig.viewer.motion.ticks > ticks
    assert [id(pend) for pend in rig.cradle.pend_list] == pendula  # no copies


def test_a_step_goes_on_to_the_next_of_the_slow_hits(rig):
    rig.give("slow hits", True)
    rig.wait(0.4)
    rig.give("pause")
    for number in (1, 2, 3):
        rig.wait(3)
        assert f"Hit {number}:" in rig.state["hit"]["title"]
        rig.give("step")
    rig.give("pause")
    rig.wait(1.5)
    assert rig.state["hit"] is None
    assert rig.time() > 0.4


# --- dragging --------------------------------------------------------------------------------

# The direction of the view: onto the row, along it, and slanting
AHEAD = (0, 0, -1)
ALONG = (-1, 0, 0)
SLANTING = (-0.3, -0.2, -1)


@pytest.mark.parametrize("is_paused", [False, True])
@pytest.mark.parametrize(
    ("kind", "bob", "cords"), [(Cradle, 4, 1), (DoubleCradle, 8, 1), (DoubleCradle, 9, 2)]
)
def test_a_bob_is_dragged_along_its_arc_let_go_and_swings_on_with_no_speed(
    csv, kind, bob, cords, is_paused
):
    """Also in a slanting view, and where no point in the plane of swing is under the mouse."""
    rig = Rig(csv, *[0] * kind.cord_count, kind=kind)
    pend = rig.cradle.pend_list[4]
    axle = rig.cradle.axles()[4].pos
    bob = rig.cradle.bobs()[bob]
    if is_paused:
        rig.tabs.give("pause")
    for key in kind.rate_keys:
        pend[key] = 1.0
    rig.mouse("grab", bob.pos + vector(bob.radius / 2, 0, 0), SLANTING)
    rig.mouse("drag", axle + vector(3, -3, 0), SLANTING)  # far away
    rig.mouse("drag", vector(1, 1, 1), ALONG)
    rig.wait(0.5)
    assert rig.bob_angles() == [0, 0, 0, 0, 45]
    side = cords * R_PARAM / 2**0.5
    assert (bob.pos - axle).value == pytest.approx([side, -side, 0])
    assert rig.state["motion"]["energy"] == "100.00 %"
    assert not any(pend[key] for key in kind.rate_keys)
    if is_paused:  # the graph has the same scale, and one row for this time
        [(_, _, _, total)] = rig.state["curves"]["rows"]
        assert total == pytest.approx(100)
    rig.give("let go")
    rig.mouse("drag", axle)
    assert rig.bob_angles() == [0, 0, 0, 0, 45]
    rig.wait(0.1)
    assert (rig.bob_angles()[4] == 45) == is_paused


def test_a_drag_and_its_end_in_one_picture_are_in_the_graph(rig):
    """The energy is then that of 100 %."""
    rig.give("pause")
    rig.mouse("grab", rig.cradle.bobs()[4].pos)
    far = rig.cradle.axles()[4].pos + vector(3, -3, 0)
    rig.tabs.give("drag", far.value, [0, 0, -1])
    rig.give("let go")
    assert rig.bob_angles()[4] == 45
    assert rig.state["curves"]["rows"][-1][3] == pytest.approx(100)


@pytest.mark.parametrize(
    ("bob", "radii", "direction", "taken"),
    [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)],
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(
    rig, bob, radii, direction, taken
):
    """A finger may be beside it. A click that takes none begins no new 100 %."""
    rig.tabs.give("pause")
    rig.give("lifted", 0)
    rig.cradle.pend_list[0]["omega"] = 3.0
    bob = rig.cradle.bobs()[bob]
    rig.mouse("grab", bob.pos + vector(radii * bob.radius, 0, 0), direction)
    assert rig.cradle.held_bob.index == taken
    assert (rig.viewer.motion.start_energy == 0) == (taken is None)


def test_a_saved_csv_makes_a_new_cradle(rig):
    rig.wait(1)
    rig.give("lifted", 3)
    rig.save(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    assert rig.values("mass") == [2, 2]
    assert rig.state["lifted"] == rig.control("lifted")["max"] == 2
    assert rig.time() < 3 * POLL
    rig.save(FIVE_CSV)
    assert rig.state["lifted"] == 3  # the old settings, where they are possible again


def test_a_broken_csv_shows_its_error_until_it_is_good_again(rig):
    """The cradle swings on, here that of an experiment."""
    rig.give("experiment", "A heavy one hits light ones")
    rig.save(FIVE_CSV + GOOD.replace("red", "<b>pink"))
    assert "cradle.csv, line 7, column color: found '<b>pink', allowed" in rig.state["error"]
    assert rig.time() > 0.3
    assert rig.values("mass") == [5, 1, 1, 1, 1]
    rig.save(FIVE_CSV)
    assert rig.state["error"] == ""
    assert rig.values("mass") == [1] * 5


def test_a_swing_above_the_frame_widens_the_view_until_the_next_restart(rig):
    near = rig.state["view"]
    rig.set_release_angle(150)
    assert rig.state["view"] != near
    rig.set_release_angle(45)
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
        "energy": "> 999 %" if percent > 999 else f"{percent:.2f} %",
        "momentum": text.format(abs(omega) * R_PARAM),
    }
    rig.give("lifted", 0)
    assert rig.state["motion"]["energy"] == "0.00 %"


def test_the_impacts_until_a_restart(rig):
    at_start = rig.thetas()
    rig.wait(0.9 * PERIOD)
    last, first = rig.state["impacts"]
    assert last.endswith(" s  5-4-3-2-1")
    assert first.startswith(f"t = {PERIOD / 4:.1f}")
    assert first.endswith(" s  1-2-3-4-5")
    rig.give("restart")
    assert rig.thetas() == at_start
    assert rig.time() == 0
    assert rig.state["impacts"] == []
