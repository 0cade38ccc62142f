"""The viewer, its state and its graph on the stand-in.

Time passes only when a test moves its own wall clock.
"""

import re
from itertools import pairwise
from math import hypot
from unittest.mock import Mock

import pytest
from vpython import scene, vector
from wall import Wall
from whole_cradles import FIVE_CSV, go_on, GOOD, HEADER, PERIOD, thetas

from src import visualize_cradle_run
from support.constants import COLOR_MAP, G, R_PARAM
from support.cradle.cradle import Cradle, DoubleCradle
from support.cradle.player import run
from support.cradle.real_time import FRAME
from support.energy import bob_motions, momentum
from support.files.cradle_csv import POLL
from support.files.data_file import EVERY
from support.page.graph import ENERGIES, ENERGY, MOST_DRAWN, NOTHING, PHASE_SPAN, SPANS
from support.page.scene.marks import ARROW_TIME, FLAT, STILL, YELLOW

INELASTIC = "perfectly inelastic, e = 0"


def test_pause_and_run(wall):
    """A command only queues: it comes in another thread, in the middle of a tick."""
    wall.wait(1)
    wall.give("pause")
    assert not wall.state["running"]
    paused, state = wall.thetas(), wall.viewer.state()
    wall.wait(1)
    assert (wall.thetas(), wall.viewer.state()) == (paused, state)  # so nothing is sent
    wall.tabs.give("pause")
    assert not wall.viewer.running
    wall.wait(1)
    assert wall.state["running"]
    # The simulation does not catch up after the pause
    assert wall.time() == pytest.approx(2, abs=4 * FRAME)


@pytest.mark.parametrize("speed", [0.1, 1, 2])
def test_speed_and_slow_motion(wall, speed):
    """While paused, a step moves the cradle by one frame."""
    wall.give("speed", speed)
    wall.wait(2)
    assert wall.time() == pytest.approx(2 * speed, abs=0.05 * speed)
    assert (wall.state["speed"], wall.state["motion"]["t"][-2:]) == (speed, " s")
    wall.viewer.pace.kept_up = 0.4
    wall.wait()
    assert wall.state["motion"]["t"].endswith(f" s {0.4 * speed:.2g}x real time")
    for running, moved in ((True, 0), (False, round(speed * FRAME / wall.viewer.cradle.dt))):
        ticks = wall.viewer.motion.ticks
        wall.give("step")
        assert wall.viewer.motion.ticks - ticks == moved
        wall.give("pause") if running else None


def test_the_box_of_a_fixed_rule_is_fixed(csv, monkeypatch):
    tick = visualize_cradle_run.newton_cradle_tick
    state = Wall(csv).state
    assert (state["has rule"], state["separating"]) == (True, False)
    monkeypatch.setattr(
        visualize_cradle_run, "newton_cradle_tick", lambda p, r, dt, g: tick(p, r, dt, g)
    )
    fixed = Wall(csv)
    fixed.give("separating", False)
    assert (fixed.state["has rule"], fixed.state["separating"]) == (False, True)


def test_each_angle_of_a_double_cradle_has_its_slider_and_its_graphs(csv):
    csv.write_text(HEADER + GOOD * 2)
    wall = Wall(csv, 30, 10, kind=DoubleCradle)
    assert wall.state["angles"] == [["Angle theta", 0, 180], ["Angle phi", -180, 180]]
    wall.give("lift", 0, 75)
    wall.give("lift", 1, -12.5)
    assert [wall.values(key)[0] for key in ("theta", "phi")] == pytest.approx(thetas([75, -12.5]))
    assert (wall.state["lifts"], wall.state["keys"]) == (
        [75, -12.5],
        ["theta", "phi", "omega", "phi_omega"],
    )
    assert wall.state["graphs"] == [
        *(ENERGY, "Angles theta", "Angles phi", "Velocities omega", "Velocities phi_omega"),
        *("Phase 1, theta", "Phase 1, phi", "Phase 2, theta", "Phase 2, phi", NOTHING),
    ]
    wall.give("graph", "Angles phi")
    assert drawn(wall)["1"][0] == [0, pytest.approx(wall.viewer.angles[1], abs=1e-6)]


def test_settings_stay_after_a_restart_and_for_a_saved_csv(wall):
    wall.give("speed", 0.5)
    wall.give("separating", True)
    wall.give("collision", INELASTIC)
    wall.give("pause")
    for does in (lambda: wall.give("restart"), lambda: wall.save(HEADER + GOOD * 3)):
        does()
        kept = [wall.state[name] for name in ("speed", "separating", "running", "collision")]
        assert (kept, wall.values("e")) == ([0.5, True, False, INELASTIC], [0] * len(wall.thetas()))
    assert len(wall.thetas()) == 3


def test_numbers_change_ten_times_a_second_and_what_is_in_step_with_the_bobs_in_each_frame(wall):
    """Nothing is shown while no tab has room, as it would only wait; no hit is lost then."""
    wall.tabs.show = Mock()
    for has_room, all_of_it, frames in ((True, (8, 9, 10), 60), (False, (0,), 0)):
        wall.tabs.show.reset_mock()
        wall.tabs.have_room = lambda has_room=has_room: has_room
        for _ in range(60):
            wall.now += FRAME
            wall.do_frame()
        states = [call.args[0] for call in wall.tabs.show.mock_calls]
        assert sum("motion" in state for state in states) in all_of_it
        assert sum({"sound", "view"} <= state.keys() for state in states) == frames
    wall.tabs.show, wall.tabs.have_room = wall.take, lambda: True
    wall.wait()
    assert wall.state["sound"][0] == 4  # a hit in each half of a period, 0.9 s


def test_a_hit_is_heard_with_its_speed_and_bobs_that_rest_on_each_other_are_not(wall):
    """From 30 degrees, a bob comes down at sqrt(2 g R (1 - cos 30 degrees)) = 0.73 m/s."""
    assert wall.state["sound"] == [0, 0]
    wall.wait(0.4)
    assert wall.state["sound"] == [1, pytest.approx(0.73, abs=0.01)]
    wall.give("collision", INELASTIC)
    wall.wait(5)
    count = wall.state["sound"][0]
    wall.viewer.cradle.pend_list[0]["omega"] = 0.02  # rad/s: 4 mm/s
    wall.wait(2)
    assert (wall.state["sound"][0], len(wall.state["impacts"]) > 0) == (count, True)


def test_the_first_cradle_is_released_when_a_tab_has_drawn_it(wall):
    """Else nobody would see the release. The time until then does not count."""
    viewer, wait = wall.viewer, lambda seconds: setattr(wall, "now", wall.now + 5)
    for looks, time in (([False, False, False, True], 15), ([True], 0)):
        start = wall.now
        wall.tabs.is_seen = Mock(**{"wait.side_effect": wait, "is_set.side_effect": looks})
        viewer.want_cradle()
        go_on(viewer)
        wall.wait()
        assert (wall.now - start, viewer.motion.ticks) == (time, 0)


@pytest.mark.parametrize(
    "moment", ["while it runs", "while it is paused", "before a tab has drawn a picture"]
)
def test_the_loop_ends_when_the_last_tab_is_closed(wall, moment):
    if "paused" in moment:
        wall.give("pause")
    elif "before" in moment:
        wall.tabs.is_seen = Mock(**{"is_set.return_value": False, "wait.side_effect": [None] * 3})
    wall.tabs.are_gone = True
    wall.viewer.pace.sleep = Mock(side_effect=[None] * 3)
    run(visualize_cradle_run.main, wall.viewer)
    assert wall.viewer.is_over


# --- arrows and slow hits --------------------------------------------------------------------------------------------


def visible(wall, name):
    return [shape for shape in wall.viewer.marks.shapes.get(name, []) if shape.visible]


def lowest(wall):
    """Return the height (m) of the lowest point that each camera shows."""
    return min(y for _, y, _ in wall.state["view"]["points"])


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_each_velocity_and_bars_the_momenta_and_their_sum(csv, kind):
    """Also for other pendula; the view has room for the bars, and for the words beside them."""
    wall = Wall(csv, *[30] * len(kind.angle_keys), kind=kind)
    ground = lowest(wall)
    wall.give("arrows", True)
    for csv_text in ("", HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD):
        wall.save(csv_text) if csv_text else None
        wall.give("restart")
        wall.wait(0.15)
        cradle, bars = wall.viewer.cradle, visible(wall, "bars")
        moves = [(vx, vy) for pend in cradle.pend_list for _, vx, vy in bob_motions(pend, R_PARAM)]
        shown = [
            (*bob.pos.value[:2], *v)
            for bob, v in zip(cradle.bobs(), moves, strict=True)
            if hypot(*v) > STILL
        ]
        arrows = [
            (*arrow.pos.value[:2], *(arrow.axis / ARROW_TIME).value[:2])
            for arrow in visible(wall, "arrows")
        ]
        assert arrows == [pytest.approx(each) for each in shown] and len(shown) == len(
            kind.angle_keys
        )
        momenta = [momentum([pend], R_PARAM) for pend in cradle.pend_list]
        marks, momenta = wall.viewer.marks, [*momenta, sum(momenta)]
        unit, flat = marks.height / max(marks.largest, *map(abs, momenta)), FLAT * marks.height
        for bar, x, p in zip(bars, marks.xs, momenta, strict=True):
            expected = [x, marks.level + p * unit / 2, max(flat, abs(p * unit))]
            assert [bar.pos.x, bar.pos.y, bar.size.y] == pytest.approx(expected)
        assert marks.xs[:-1] == [axle.pos.x for axle in cradle.axles()]
        assert [bar.color for bar in bars[:-1]] == [
            pend["objects"][1].color for pend in cradle.pend_list
        ]
        (left, level, words), (right, *_) = wall.state["view"]["words"]
        assert (left < marks.xs[0], right > marks.xs[-1]) == (True, True)
        assert (level, words) == (marks.level, "momentum\n(up = right)")
        assert lowest(wall) < marks.level - marks.height < marks.level + marks.height < ground
    wall.give("arrows", False)
    assert (visible(wall, "arrows"), visible(wall, "bars"), wall.state["view"]["words"]) == (
        [],
        [],
        [],
    )
    assert lowest(wall) == ground


def reversed_order(pend_list, r_param, dt, g):
    """Let the pairs collide from right to left, as a student may have written it, without
    approaching_only.
    """
    visualize_cradle_run.full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in reversed([*pairwise(pend_list)]):
        visualize_cradle_run.handle_two_bobs(pend1, pend2, r_param, approaching_only=True)


@pytest.mark.parametrize(
    ("tick", "pairs"), [(None, "23 12 34 23 45 34"), (reversed_order, "23 34 12 45 23 34")]
)
def test_slow_hits_show_each_pair_in_the_order_of_the_calls_and_then_the_swing_goes_on(
    csv, monkeypatch, tick, pairs
):
    """With its speeds, its halos and the arrows after it."""
    if tick:
        monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", tick)
    wall = Wall(csv, 45, lifted=2)
    for command in ("slow hits", "arrows"):
        wall.give(command, True)
    shown, moving = [], {1, 2}
    while len(shown) < 6:
        wall.wait(0.1)
        hit, words = wall.viewer.slow_hits.shown, wall.state["hit"]
        assert bool(hit) == bool(words) == bool(visible(wall, "halos"))
        if not hit or f"Hit {len(shown)}:" in words["title"]:
            continue
        left, right = map(
            int, re.fullmatch(rf"Hit {len(shown) + 1}: bobs (\d) and (\d)", words["title"]).groups()
        )
        shown.append(f"{left}{right}")
        assert words["lines"] == [
            f"bob {left}: +1.07 → +0.00 m/s",
            f"bob {right}: +0.00 → +1.07 m/s",
        ]
        assert words["note"].startswith("This order is the model's: a tick takes")
        moving, places = moving - {left} | {right}, [bob.pos.x for bob in wall.viewer.cradle.bobs()]
        assert [arrow.pos.x for arrow in visible(wall, "arrows")] == [
            places[number - 1] for number in sorted(moving)
        ]
        assert [halo.pos.x for halo in visible(wall, "halos")] == places[left - 1 : right]
        ticks = wall.viewer.motion.ticks
    assert " ".join(shown) == pairs
    wall.wait(1)
    assert wall.viewer.motion.ticks == ticks
    wall.wait(0.5)
    assert not any(shape.color == YELLOW for shape in scene.objects)
    # Nothing else has moved the bobs
    ticks, same = wall.viewer.motion.ticks - ticks, Wall(csv, 45, lifted=2).viewer
    for _ in range(wall.viewer.motion.ticks):
        visualize_cradle_run.newton_cradle_tick(
            same.cradle.pend_list, R_PARAM, same.cradle.dt, G, **same.rule
        )
    assert (ticks > 0, same.cradle.values("theta")) == (True, wall.thetas())


def test_a_step_goes_on_to_the_next_of_the_slow_hits(wall):
    wall.give("slow hits", True)
    wall.wait(0.4)
    wall.give("pause")
    for number in (1, 2, 3):
        wall.wait(3)
        assert f"Hit {number}:" in wall.state["hit"]["title"]
        wall.give("step")
    wall.give("pause")
    wall.wait(1.5)
    assert (wall.state["hit"], wall.time() > 0.4) == (None, True)


# --- dragging --------------------------------------------------------------------------------------------------------

AHEAD, ALONG = (0, 0, -1), (-1, 0, 0)  # the direction of the view: onto the row, and along it


@pytest.mark.parametrize("paused", [False, True])
@pytest.mark.parametrize(
    ("kind", "bob", "cords"), [(Cradle, 4, 1), (DoubleCradle, 8, 1), (DoubleCradle, 9, 2)]
)
def test_a_bob_is_dragged_along_its_arc_let_go_and_swings_on_with_no_speed(
    csv, kind, bob, cords, paused
):
    """Also in a slanting view, and where no point in the plane of swing is under the mouse."""
    wall, slanting = Wall(csv, *[0] * len(kind.angles), kind=kind), (-0.3, -0.2, -1)
    cradle, pend = wall.viewer.cradle, wall.viewer.cradle.pend_list[4]
    axle, bob = cradle.axles()[4].pos, cradle.bobs()[bob]
    if paused:
        wall.tabs.give("pause")
    pend.update(dict.fromkeys(kind.rate_keys, 1.0))
    wall.mouse("grab", vector(bob.pos) + vector(bob.radius / 2, 0, 0), slanting)
    assert not any(pend[key] for key in kind.rate_keys)
    wall.mouse("drag", axle + vector(3, -3, 0), slanting)  # far away
    wall.mouse("drag", vector(1, 1, 1), ALONG)
    for after in (
        lambda: wall.wait(0.5),
        lambda: wall.give("let go"),
        lambda: wall.mouse("drag", axle),
    ):
        assert wall.lifts() == [0, 0, 0, 0, 45]
        assert (bob.pos - axle).value == pytest.approx(
            [cords * R_PARAM * 0.5**0.5, -cords * R_PARAM * 0.5**0.5, 0]
        )
        assert wall.state["motion"]["energy"] == "100.00 %"
        # The graph has the same scale
        assert not paused or drawn(wall)["total"][-1][1] == pytest.approx(100)
        assert len({*recorded(wall, "total")}) == len(wall.viewer.graph.rows)  # a row for each time
        assert not any(pend[key] for key in kind.rate_keys)
        after()
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.wait(0.1)
    assert (wall.lifts()[4] == 45) == paused


@pytest.mark.parametrize(
    ("bob", "radii", "ray", "taken"),
    [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)],
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(
    wall, bob, radii, ray, taken
):
    """A finger may be beside it. A click that takes none begins no new 100 %."""
    wall.tabs.give("pause")
    wall.give("lifted", 0)
    wall.viewer.cradle.pend_list[0]["omega"] = 3.0
    bob = wall.viewer.cradle.bobs()[bob]
    wall.mouse("grab", vector(bob.pos) + vector(radii * bob.radius, 0, 0), ray)
    assert wall.viewer.cradle.hand.held == taken
    assert (wall.viewer.motion.start_energy == 0) == (taken is None)


def test_a_saved_csv_makes_a_new_cradle_also_while_paused(wall):
    wall.wait(1)
    wall.give("lifted", 3)
    wall.save(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    assert (wall.values("mass"), wall.state["lifted"], wall.time() < 3 * POLL) == (
        [2, 2],
        [2, 2],
        True,
    )
    wall.save(FIVE_CSV)
    assert wall.state["lifted"] == [3, 5]  # the old settings, where they are possible again
    wall.give("pause")
    wall.save(HEADER + GOOD * 9)
    assert (len(wall.viewer.cradle.bobs()), len(wall.state["view"]["numbers"]), wall.time()) == (
        9,
        9,
        0,
    )


def test_a_broken_csv_shows_its_error_until_it_is_good_again(wall):
    """Also while an experiment is shown, which stays."""
    wall.give("experiment", "A heavy one hits light ones")
    wall.save(FIVE_CSV + GOOD.replace("red", "<b>pink"))
    assert "cradle.csv, line 7, column color: found '<b>pink', allowed" in wall.state["error"]
    # The old one swings on
    assert (wall.time() > 0.3, wall.values("mass")) == (True, [5, 1, 1, 1, 1])
    wall.save(FIVE_CSV)
    assert (wall.state["error"], wall.values("mass")) == ("", [1] * 5)


def test_a_swing_above_the_frame_widens_the_view_until_the_next_restart(wall):
    near = wall.state["view"]
    wall.give("lift", 0, 150)
    assert wall.state["view"] != near
    wall.give("lift", 0, 45)
    assert wall.state["view"] == near


# --- the texts -------------------------------------------------------------------------------------------------------


def test_a_key_that_the_handout_does_not_have_is_named(csv):
    """Columns of the CSV are no such keys."""
    csv.write_text("name," + HEADER + f"a,{GOOD}b,{GOOD}")
    wall = Wall(csv, remark="Write next: main.")
    assert wall.state["remark"] == "Write next: main."
    wall.viewer.cradle.pend_list[1]["Theta"] = 0.5
    wall.wait()
    words = "Write next: main. Pendulum 2 has the key 'Theta', which the handout does not have."
    assert wall.state["remark"] == words


@pytest.mark.parametrize(
    ("omega", "text"),
    [
        (3, "+{:.3f} kg m/s →"),
        (-3, "-{:.3f} kg m/s ←"),
        (0, "+{:.3f} kg m/s"),
        (1e154, "+{:.2e} kg m/s →"),
    ],
)
def test_the_readout(wall, omega, text):
    """The momentum has the arrow of its sign.

    A percentage is at most 999, also if it has no end, and 0 of 0 is 0.
    """
    wall.give("pause")
    wall.viewer.cradle.pend_list[0].update(theta=0.0, omega=omega)
    wall.viewer.note()
    wall.wait()
    start = G * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg at 30 degrees
    percent = 100 * (omega * R_PARAM) ** 2 / 2 / start
    energy = "> 999 %" if percent > 999 else f"{percent:.2f} %"
    assert wall.state["motion"] == {
        "t": "0.00 s",
        "energy": energy,
        "momentum": text.format(abs(omega) * R_PARAM),
    }
    wall.give("lifted", 0)
    assert wall.state["motion"]["energy"] == "0.00 %"


def test_the_impacts_until_a_restart(wall):
    at_start = wall.thetas()
    wall.wait(0.9 * PERIOD)
    last, *lines = wall.state["impacts"]
    assert re.fullmatch(r"t = \d\.\d\d s  5-4-3-2-1", last)
    assert lines == [f"t = {wall.viewer.motion.trains.trains[0].begin:.2f} s  1-2-3-4-5"]
    assert wall.viewer.motion.trains.trains[0].begin == pytest.approx(PERIOD / 4, rel=0.05)
    wall.give("restart")
    assert (wall.thetas(), wall.time(), wall.state["impacts"]) == (at_start, 0, [])


# --- the graph -------------------------------------------------------------------------------------------------------

ANGLES, VELOCITIES = "Angles theta", "Velocities omega"
ON_THE_PAGE = {
    name: f"rgb({', '.join(f'{255 * part:.0f}' for part in v.value)})"
    for name, v in COLOR_MAP.items()
}


def drawn(wall):
    """Return the points of the curves by the curves' labels."""
    curves, rows = wall.state["curves"]["curves"], wall.state["curves"]["rows"]
    return {
        label: [[row[0], row[at]] for row in rows] for at, (label, _) in enumerate(curves, start=1)
    }


def colors(wall):
    """Return the colors of the curves as a page has them."""
    return [color for _, color in wall.state["curves"]["curves"]]


def recorded(wall, column):
    """Return the recorded values of a column, by their times (s)."""
    at = wall.viewer.graph.names.index(column)
    return {round(row[0], 6): round(row[at], 6) for row in wall.viewer.graph.rows}


@pytest.mark.parametrize("span", SPANS)
def test_the_graph_shows_the_energies_of_the_last_seconds(wall, span):
    """In percent. Its points are always at the same times, so they do not shake."""
    shown, interval = SPANS[span]
    wall.give("span", span)
    wall.wait(shown + 2)
    assert (wall.state["span"], wall.state["graph"]) == (span, ENERGY)
    assert list(drawn(wall)) == ["kinetic", "potential", "total"]
    kinetic, potential, total = drawn(wall).values()
    begin, end = wall.state["curves"]["from"], wall.state["curves"]["to"]
    assert end - begin == pytest.approx(shown)
    times = [t for t, _ in total]
    assert times[:-1] == pytest.approx([interval * round(t / interval) for t in times[:-1]])
    assert times[0] == pytest.approx(begin, abs=2 * interval)
    assert times[-1] == pytest.approx(shown + 2, abs=2 * interval)
    for (t, k), (_, p), (_, both) in zip(kinetic, potential, total, strict=True):
        assert k + p == pytest.approx(both, abs=1e-5)
        assert both == pytest.approx(100, abs=0.1)
        assert 0 <= t - begin <= shown
    assert len({*colors(wall)}) == 3


@pytest.mark.parametrize("dt", [3e-4, 7e-4])
def test_the_time_axis_is_full_with_any_tick(csv, monkeypatch, dt):
    monkeypatch.setattr(Cradle, "dt", dt)
    wall = Wall(csv)
    wall.wait(12)
    for span, (_, interval) in SPANS.items():
        wall.give("span", span)
        times = [wall.state["curves"]["from"], *(t for t, _ in drawn(wall)["total"]), wall.time()]
        assert max(after - before for before, after in pairwise(times)) < 2 * interval


def test_the_angles_and_velocities_of_all_bobs_are_drawn_in_their_colors(wall):
    names = ["red", "cyan", "orange"]
    wall.save(HEADER + "".join(GOOD.replace("red", name) for name in names))
    for choice, key, unit in ((ANGLES, "theta", "rad"), (VELOCITIES, "omega", "rad/s")):
        wall.give("graph", choice)
        wall.wait(0.5)
        assert (wall.state["curves"]["x"], wall.state["curves"]["y"]) == (
            "t (s)",
            f"{key} ({unit})",
        )
        assert list(drawn(wall)) == ["1", "2", "3"]
        for number in "123":
            values = recorded(wall, f"{key}_{number}")
            assert all(values[t] == value for t, value in drawn(wall)[number])
        assert colors(wall) == [ON_THE_PAGE[name] for name in names]


def test_the_phase_picture_is_that_of_one_bob(wall):
    wall.give("graph", "Phase 1")
    wall.wait(PHASE_SPAN[0] + 1)
    curves, [points] = wall.state["curves"], drawn(wall).values()
    assert (curves["x"], curves["y"], "from" in curves) == ("theta (rad)", "omega (rad/s)", False)
    assert len(points) == pytest.approx(PHASE_SPAN[0] / EVERY, abs=2)
    assert points[-1] == [[*recorded(wall, f"{key}_1").values()][-1] for key in ("theta", "omega")]
    assert colors(wall) == [ON_THE_PAGE["red"]]


def test_a_new_cradle_has_its_own_choices_and_keeps_the_present_one_if_it_can(wall):
    wall.give("graph", ANGLES)
    wall.save(HEADER + GOOD.replace("red", "green") * (MOST_DRAWN + 3))
    assert wall.state["graph"] == ANGLES
    # The first ones
    assert list(drawn(wall)) == [str(number) for number in range(1, MOST_DRAWN + 1)]
    assert {*colors(wall)} == {ON_THE_PAGE["green"]}
    wall.give("graph", "Phase 7")
    wall.save(HEADER + GOOD * 2)
    assert (wall.state["graph"], drawn(wall).keys()) == (ENERGY, ENERGIES.keys())


def test_no_graph_sends_nothing_and_a_restart_empties_it(wall):
    wall.wait(1)
    wall.give("graph", NOTHING)
    wall.wait(1)
    assert wall.state["curves"] == {"x": "", "y": "", "curves": [], "rows": []}
    wall.give("graph", ENERGY)
    # It shows what was recorded meanwhile
    assert len(drawn(wall)["total"]) == pytest.approx(2 / EVERY, abs=2)
    wall.give("restart")
    assert [len(points) for points in drawn(wall).values()] == [1, 1, 1]
