"""The viewer, its state and its graph on the stand-in.

Time passes only when a test moves its own clock.
"""

import re
from itertools import pairwise
from math import hypot
from unittest.mock import Mock

import pytest
from rig import Rig
from vpython import scene, vector
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


def test_pause_and_run(rig):
    """A command only queues: it comes in another thread, in the middle of a tick."""
    rig.wait(1)
    rig.give("pause")
    assert not rig.state["running"]
    paused, state = rig.thetas(), rig.viewer.state()
    rig.wait(1)
    assert (rig.thetas(), rig.viewer.state()) == (paused, state)  # so nothing is sent
    rig.tabs.give("pause")
    assert not rig.viewer.running
    rig.wait(1)
    assert rig.state["running"]
    # The simulation does not catch up after the pause
    assert rig.time() == pytest.approx(2, abs=4 * FRAME)


@pytest.mark.parametrize("speed", [0.1, 1, 2])
def test_speed_and_slow_motion(rig, speed):
    """While paused, a step moves the cradle by one frame."""
    rig.give("speed", speed)
    rig.wait(2)
    assert rig.time() == pytest.approx(2 * speed, abs=0.05 * speed)
    assert (rig.state["speed"], rig.state["motion"]["t"][-2:]) == (speed, " s")
    rig.viewer.pace.kept_up = 0.4
    rig.wait()
    assert rig.state["motion"]["t"].endswith(f" s {0.4 * speed:.2g}x real time")
    for running, moved in ((True, 0), (False, round(speed * FRAME / rig.viewer.cradle.dt))):
        ticks = rig.viewer.motion.ticks
        rig.give("step")
        assert rig.viewer.motion.ticks - ticks == moved
        rig.give("pause") if running else None


def test_the_box_of_a_fixed_rule_is_fixed(csv, monkeypatch):
    tick = visualize_cradle_run.newton_cradle_tick
    state = Rig(csv).state
    assert (state["has rule"], state["separating"]) == (True, False)
    monkeypatch.setattr(
        visualize_cradle_run, "newton_cradle_tick", lambda p, r, dt, g: tick(p, r, dt, g)
    )
    fixed = Rig(csv)
    fixed.give("separating", False)
    assert (fixed.state["has rule"], fixed.state["separating"]) == (False, True)


def test_each_angle_of_a_double_cradle_has_its_slider_and_its_graphs(csv):
    csv.write_text(HEADER + GOOD * 2)
    rig = Rig(csv, 30, 10, kind=DoubleCradle)
    assert rig.state["angles"] == [["Angle theta", 0, 180], ["Angle phi", -180, 180]]
    rig.give("lift", 0, 75)
    rig.give("lift", 1, -12.5)
    assert [rig.values(key)[0] for key in ("theta", "phi")] == pytest.approx(thetas([75, -12.5]))
    assert (rig.state["lifts"], rig.state["keys"]) == (
        [75, -12.5],
        ["theta", "phi", "omega", "phi_omega"],
    )
    assert rig.state["graphs"] == [
        *(ENERGY, "Angles theta", "Angles phi", "Velocities omega", "Velocities phi_omega"),
        *("Phase 1, theta", "Phase 1, phi", "Phase 2, theta", "Phase 2, phi", NOTHING),
    ]
    rig.give("graph", "Angles phi")
    assert drawn(rig)["1"][0] == [0, pytest.approx(rig.viewer.angles[1], abs=1e-6)]


def test_settings_stay_after_a_restart_and_for_a_saved_csv(rig):
    rig.give("speed", 0.5)
    rig.give("separating", True)
    rig.give("collision", INELASTIC)
    rig.give("pause")
    for does in (lambda: rig.give("restart"), lambda: rig.save(HEADER + GOOD * 3)):
        does()
        kept = [rig.state[name] for name in ("speed", "separating", "running", "collision")]
        assert (kept, rig.values("e")) == ([0.5, True, False, INELASTIC], [0] * len(rig.thetas()))
    assert len(rig.thetas()) == 3


def test_numbers_change_ten_times_a_second_and_what_is_in_step_with_the_bobs_in_each_frame(rig):
    """Nothing is shown while no tab has room, as it would only wait; no hit is lost then."""
    rig.tabs.show = Mock()
    for has_room, all_of_it, frames in ((True, (8, 9, 10), 60), (False, (0,), 0)):
        rig.tabs.show.reset_mock()
        rig.tabs.have_room = lambda has_room=has_room: has_room
        for _ in range(60):
            rig.now += FRAME
            rig.do_frame()
        states = [call.args[0] for call in rig.tabs.show.mock_calls]
        assert sum("motion" in state for state in states) in all_of_it
        assert sum({"sound", "view"} <= state.keys() for state in states) == frames
    rig.tabs.show, rig.tabs.have_room = rig.take, lambda: True
    rig.wait()
    assert rig.state["sound"][0] == 4  # a hit in each half of a period, 0.9 s


def test_a_hit_is_heard_with_its_speed_and_bobs_that_rest_on_each_other_are_not(rig):
    """From 30 degrees, a bob comes down at sqrt(2 g R (1 - cos 30 degrees)) = 0.73 m/s."""
    assert rig.state["sound"] == [0, 0]
    rig.wait(0.4)
    assert rig.state["sound"] == [1, pytest.approx(0.73, abs=0.01)]
    rig.give("collision", INELASTIC)
    rig.wait(5)
    count = rig.state["sound"][0]
    rig.viewer.cradle.pend_list[0]["omega"] = 0.02  # rad/s: 4 mm/s
    rig.wait(2)
    assert (rig.state["sound"][0], len(rig.state["impacts"]) > 0) == (count, True)


def test_the_first_cradle_is_released_when_a_tab_has_drawn_it(rig):
    """Else nobody would see the release. The time until then does not count."""
    viewer, wait = rig.viewer, lambda seconds: setattr(rig, "now", rig.now + 5)
    for looks, time in (([False, False, False, True], 15), ([True], 0)):
        start = rig.now
        rig.tabs.is_seen = Mock(**{"wait.side_effect": wait, "is_set.side_effect": looks})
        viewer.want_cradle()
        go_on(viewer)
        rig.wait()
        assert (rig.now - start, viewer.motion.ticks) == (time, 0)


@pytest.mark.parametrize(
    "moment", ["while it runs", "while it is paused", "before a tab has drawn a picture"]
)
def test_the_loop_ends_when_the_last_tab_is_closed(rig, moment):
    if "paused" in moment:
        rig.give("pause")
    elif "before" in moment:
        rig.tabs.is_seen = Mock(**{"is_set.return_value": False, "wait.side_effect": [None] * 3})
    rig.tabs.are_gone = True
    rig.viewer.pace.sleep = Mock(side_effect=[None] * 3)
    run(visualize_cradle_run.main, rig.viewer)
    assert rig.viewer.is_over


# --- arrows and slow hits --------------------------------------------------------------------------------------------


def visible(rig, name):
    return [shape for shape in rig.viewer.marks.shapes.get(name, []) if shape.visible]


def lowest(rig):
    """Return the height (m) of the lowest point that each camera shows."""
    return min(y for _, y, _ in rig.state["view"]["points"])


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_each_velocity_and_bars_the_momenta_and_their_sum(csv, kind):
    """Also for other pendula; the view has room for the bars, and for the labels beside them."""
    rig = Rig(csv, *[30] * len(kind.angle_keys), kind=kind)
    ground = lowest(rig)
    rig.give("arrows", True)
    for csv_text in ("", HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD):
        rig.save(csv_text) if csv_text else None
        rig.give("restart")
        rig.wait(0.15)
        cradle, bars = rig.viewer.cradle, visible(rig, "bars")
        moves = [(vx, vy) for pend in cradle.pend_list for _, vx, vy in bob_motions(pend, R_PARAM)]
        shown = [
            (*bob.pos.value[:2], *v)
            for bob, v in zip(cradle.bobs(), moves, strict=True)
            if hypot(*v) > STILL
        ]
        arrows = [
            (*arrow.pos.value[:2], *(arrow.axis / ARROW_TIME).value[:2])
            for arrow in visible(rig, "arrows")
        ]
        assert arrows == [pytest.approx(each) for each in shown] and len(shown) == len(
            kind.angle_keys
        )
        momenta = [momentum([pend], R_PARAM) for pend in cradle.pend_list]
        marks, momenta = rig.viewer.marks, [*momenta, sum(momenta)]
        unit, flat = marks.height / max(marks.largest, *map(abs, momenta)), FLAT * marks.height
        for bar, x, p in zip(bars, marks.xs, momenta, strict=True):
            expected = [x, marks.level + p * unit / 2, max(flat, abs(p * unit))]
            assert [bar.pos.x, bar.pos.y, bar.size.y] == pytest.approx(expected)
        assert marks.xs[:-1] == [axle.pos.x for axle in cradle.axles()]
        assert [bar.color for bar in bars[:-1]] == [
            pend["objects"][1].color for pend in cradle.pend_list
        ]
        (left, level, text), (right, *_) = rig.state["view"]["labels"]
        assert (left < marks.xs[0], right > marks.xs[-1]) == (True, True)
        assert (level, text) == (marks.level, "momentum\n(up = right)")
        assert lowest(rig) < marks.level - marks.height < marks.level + marks.height < ground
    rig.give("arrows", False)
    assert (visible(rig, "arrows"), visible(rig, "bars"), rig.state["view"]["labels"]) == (
        [],
        [],
        [],
    )
    assert lowest(rig) == ground


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
    rig = Rig(csv, 45, lifted=2)
    for command in ("slow hits", "arrows"):
        rig.give(command, True)
    shown, moving = [], {1, 2}
    while len(shown) < 6:
        rig.wait(0.1)
        hit, words = rig.viewer.slow_hits.shown, rig.state["hit"]
        assert bool(hit) == bool(words) == bool(visible(rig, "halos"))
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
        moving, places = moving - {left} | {right}, [bob.pos.x for bob in rig.viewer.cradle.bobs()]
        assert [arrow.pos.x for arrow in visible(rig, "arrows")] == [
            places[number - 1] for number in sorted(moving)
        ]
        assert [halo.pos.x for halo in visible(rig, "halos")] == places[left - 1 : right]
        ticks = rig.viewer.motion.ticks
    assert " ".join(shown) == pairs
    rig.wait(1)
    assert rig.viewer.motion.ticks == ticks
    rig.wait(0.5)
    assert not any(shape.color == YELLOW for shape in scene.objects)
    # Nothing else has moved the bobs
    ticks, same = rig.viewer.motion.ticks - ticks, Rig(csv, 45, lifted=2).viewer
    for _ in range(rig.viewer.motion.ticks):
        visualize_cradle_run.newton_cradle_tick(
            same.cradle.pend_list, R_PARAM, same.cradle.dt, G, **same.rule
        )
    assert (ticks > 0, same.cradle.values("theta")) == (True, rig.thetas())


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
    assert (rig.state["hit"], rig.time() > 0.4) == (None, True)


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
    rig, slanting = Rig(csv, *[0] * len(kind.angles), kind=kind), (-0.3, -0.2, -1)
    cradle, pend = rig.viewer.cradle, rig.viewer.cradle.pend_list[4]
    axle, bob = cradle.axles()[4].pos, cradle.bobs()[bob]
    if paused:
        rig.tabs.give("pause")
    pend.update(dict.fromkeys(kind.rate_keys, 1.0))
    rig.mouse("grab", vector(bob.pos) + vector(bob.radius / 2, 0, 0), slanting)
    assert not any(pend[key] for key in kind.rate_keys)
    rig.mouse("drag", axle + vector(3, -3, 0), slanting)  # far away
    rig.mouse("drag", vector(1, 1, 1), ALONG)
    for after in (
        lambda: rig.wait(0.5),
        lambda: rig.give("let go"),
        lambda: rig.mouse("drag", axle),
    ):
        assert rig.lifts() == [0, 0, 0, 0, 45]
        assert (bob.pos - axle).value == pytest.approx(
            [cords * R_PARAM * 0.5**0.5, -cords * R_PARAM * 0.5**0.5, 0]
        )
        assert rig.state["motion"]["energy"] == "100.00 %"
        # The graph has the same scale
        assert not paused or drawn(rig)["total"][-1][1] == pytest.approx(100)
        assert len({*recorded(rig, "total")}) == len(rig.viewer.graph.rows)  # a row for each time
        assert not any(pend[key] for key in kind.rate_keys)
        after()
    assert rig.lifts() == [0, 0, 0, 0, 45]
    rig.wait(0.1)
    assert (rig.lifts()[4] == 45) == paused


@pytest.mark.parametrize(
    ("bob", "radii", "ray", "taken"),
    [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)],
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(rig, bob, radii, ray, taken):
    """A finger may be beside it. A click that takes none begins no new 100 %."""
    rig.tabs.give("pause")
    rig.give("lifted", 0)
    rig.viewer.cradle.pend_list[0]["omega"] = 3.0
    bob = rig.viewer.cradle.bobs()[bob]
    rig.mouse("grab", vector(bob.pos) + vector(radii * bob.radius, 0, 0), ray)
    assert rig.viewer.cradle.hand.held == taken
    assert (rig.viewer.motion.start_energy == 0) == (taken is None)


def test_a_saved_csv_makes_a_new_cradle_also_while_paused(rig):
    rig.wait(1)
    rig.give("lifted", 3)
    rig.save(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    assert (rig.values("mass"), rig.state["lifted"], rig.time() < 3 * POLL) == (
        [2, 2],
        [2, 2],
        True,
    )
    rig.save(FIVE_CSV)
    assert rig.state["lifted"] == [3, 5]  # the old settings, where they are possible again
    rig.give("pause")
    rig.save(HEADER + GOOD * 9)
    assert (len(rig.viewer.cradle.bobs()), len(rig.state["view"]["numbers"]), rig.time()) == (
        9,
        9,
        0,
    )


def test_a_broken_csv_shows_its_error_until_it_is_good_again(rig):
    """Also while an experiment is shown, which stays."""
    rig.give("experiment", "A heavy one hits light ones")
    rig.save(FIVE_CSV + GOOD.replace("red", "<b>pink"))
    assert "cradle.csv, line 7, column color: found '<b>pink', allowed" in rig.state["error"]
    # The old one swings on
    assert (rig.time() > 0.3, rig.values("mass")) == (True, [5, 1, 1, 1, 1])
    rig.save(FIVE_CSV)
    assert (rig.state["error"], rig.values("mass")) == ("", [1] * 5)


def test_a_swing_above_the_frame_widens_the_view_until_the_next_restart(rig):
    near = rig.state["view"]
    rig.give("lift", 0, 150)
    assert rig.state["view"] != near
    rig.give("lift", 0, 45)
    assert rig.state["view"] == near


# --- the texts -------------------------------------------------------------------------------------------------------


def test_a_key_that_the_handout_does_not_have_is_named(csv):
    """Columns of the CSV are no such keys."""
    csv.write_text("name," + HEADER + f"a,{GOOD}b,{GOOD}")
    rig = Rig(csv, remark="Write next: main.")
    assert rig.state["remark"] == "Write next: main."
    rig.viewer.cradle.pend_list[1]["Theta"] = 0.5
    rig.wait()
    words = "Write next: main. Pendulum 2 has the key 'Theta', which the handout does not have."
    assert rig.state["remark"] == words


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
    rig.viewer.cradle.pend_list[0].update(theta=0.0, omega=omega)
    rig.viewer.note()
    rig.wait()
    start = G * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg at 30 degrees
    percent = 100 * (omega * R_PARAM) ** 2 / 2 / start
    energy = "> 999 %" if percent > 999 else f"{percent:.2f} %"
    assert rig.state["motion"] == {
        "t": "0.00 s",
        "energy": energy,
        "momentum": text.format(abs(omega) * R_PARAM),
    }
    rig.give("lifted", 0)
    assert rig.state["motion"]["energy"] == "0.00 %"


def test_the_impacts_until_a_restart(rig):
    at_start = rig.thetas()
    rig.wait(0.9 * PERIOD)
    last, *lines = rig.state["impacts"]
    assert re.fullmatch(r"t = \d\.\d\d s  5-4-3-2-1", last)
    assert lines == [f"t = {rig.viewer.motion.trains.trains[0].begin:.2f} s  1-2-3-4-5"]
    assert rig.viewer.motion.trains.trains[0].begin == pytest.approx(PERIOD / 4, rel=0.05)
    rig.give("restart")
    assert (rig.thetas(), rig.time(), rig.state["impacts"]) == (at_start, 0, [])


# --- the graph -------------------------------------------------------------------------------------------------------

ANGLES, VELOCITIES = "Angles theta", "Velocities omega"
ON_THE_PAGE = {
    name: f"rgb({', '.join(f'{255 * part:.0f}' for part in v.value)})"
    for name, v in COLOR_MAP.items()
}


def drawn(rig):
    """Return the points of the curves by the curves' labels."""
    curves, rows = rig.state["curves"]["curves"], rig.state["curves"]["rows"]
    return {
        label: [[row[0], row[at]] for row in rows] for at, (label, _) in enumerate(curves, start=1)
    }


def colors(rig):
    """Return the colors of the curves as a page has them."""
    return [color for _, color in rig.state["curves"]["curves"]]


def recorded(rig, column):
    """Return the recorded values of a column, by their times (s)."""
    at = rig.viewer.graph.names.index(column)
    return {round(row[0], 6): round(row[at], 6) for row in rig.viewer.graph.rows}


@pytest.mark.parametrize("span", SPANS)
def test_the_graph_shows_the_energies_of_the_last_seconds(rig, span):
    """In percent. Its points are always at the same times, so they do not shake."""
    shown, interval = SPANS[span]
    rig.give("span", span)
    rig.wait(shown + 2)
    assert (rig.state["span"], rig.state["graph"]) == (span, ENERGY)
    assert list(drawn(rig)) == ["kinetic", "potential", "total"]
    kinetic, potential, total = drawn(rig).values()
    begin, end = rig.state["curves"]["from"], rig.state["curves"]["to"]
    assert end - begin == pytest.approx(shown)
    times = [t for t, _ in total]
    assert times[:-1] == pytest.approx([interval * round(t / interval) for t in times[:-1]])
    assert times[0] == pytest.approx(begin, abs=2 * interval)
    assert times[-1] == pytest.approx(shown + 2, abs=2 * interval)
    for (t, k), (_, p), (_, both) in zip(kinetic, potential, total, strict=True):
        assert k + p == pytest.approx(both, abs=1e-5)
        assert both == pytest.approx(100, abs=0.1)
        assert 0 <= t - begin <= shown
    assert len({*colors(rig)}) == 3


@pytest.mark.parametrize("dt", [3e-4, 7e-4])
def test_the_time_axis_is_full_with_any_tick(csv, monkeypatch, dt):
    monkeypatch.setattr(Cradle, "dt", dt)
    rig = Rig(csv)
    rig.wait(12)
    for span, (_, interval) in SPANS.items():
        rig.give("span", span)
        times = [rig.state["curves"]["from"], *(t for t, _ in drawn(rig)["total"]), rig.time()]
        assert max(after - before for before, after in pairwise(times)) < 2 * interval


def test_the_angles_and_velocities_of_all_bobs_are_drawn_in_their_colors(rig):
    names = ["red", "cyan", "orange"]
    rig.save(HEADER + "".join(GOOD.replace("red", name) for name in names))
    for choice, key, unit in ((ANGLES, "theta", "rad"), (VELOCITIES, "omega", "rad/s")):
        rig.give("graph", choice)
        rig.wait(0.5)
        assert (rig.state["curves"]["x"], rig.state["curves"]["y"]) == (
            "t (s)",
            f"{key} ({unit})",
        )
        assert list(drawn(rig)) == ["1", "2", "3"]
        for number in "123":
            values = recorded(rig, f"{key}_{number}")
            assert all(values[t] == value for t, value in drawn(rig)[number])
        assert colors(rig) == [ON_THE_PAGE[name] for name in names]


def test_the_phase_picture_is_that_of_one_bob(rig):
    rig.give("graph", "Phase 1")
    rig.wait(PHASE_SPAN[0] + 1)
    curves, [points] = rig.state["curves"], drawn(rig).values()
    assert (curves["x"], curves["y"]) == ("theta (rad)", "omega (rad/s)")
    for first, last, column in (("from", "to", 0), ("bottom", "top", 1)):
        farthest = max(abs(point[column]) for point in points)
        assert [curves[first], curves[last]] == pytest.approx([-1.05 * farthest, 1.05 * farthest])
    assert len(points) == pytest.approx(PHASE_SPAN[0] / EVERY, abs=2)
    assert points[-1] == [[*recorded(rig, f"{key}_1").values()][-1] for key in ("theta", "omega")]
    assert colors(rig) == [ON_THE_PAGE["red"]]


def test_a_new_cradle_has_its_own_choices_and_keeps_the_present_one_if_it_can(rig):
    rig.give("graph", ANGLES)
    rig.save(HEADER + GOOD.replace("red", "green") * (MOST_DRAWN + 3))
    assert rig.state["graph"] == ANGLES
    # The first ones
    assert list(drawn(rig)) == [str(number) for number in range(1, MOST_DRAWN + 1)]
    assert {*colors(rig)} == {ON_THE_PAGE["green"]}
    rig.give("graph", "Phase 7")
    rig.save(HEADER + GOOD * 2)
    assert (rig.state["graph"], drawn(rig).keys()) == (ENERGY, ENERGIES.keys())


def test_no_graph_sends_nothing_and_a_restart_empties_it(rig):
    rig.wait(1)
    rig.give("graph", NOTHING)
    rig.wait(1)
    assert rig.state["curves"] == {"x": "", "y": "", "curves": [], "rows": []}
    rig.give("graph", ENERGY)
    # It shows what was recorded meanwhile
    assert len(drawn(rig)["total"]) == pytest.approx(2 / EVERY, abs=2)
    rig.give("restart")
    assert [len(points) for points in drawn(rig).values()] == [1, 1, 1]
