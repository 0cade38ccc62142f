"""The viewer, its panel and its graph on the stand-in. Time passes only when a test moves its own wall clock."""

import re
from itertools import pairwise
from math import hypot
from unittest.mock import Mock

import pytest
from vpython import baseObj, cylinder, scene, vector, wtext
from wall import Wall
from whole_cradles import FIVE_CSV, GOOD, HEADER, PERIOD, thetas

from src import visualize_cradle_run
from support.constants import COLOR_MAP, G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.real_time import FRAME
from support.energy import bob_motions, momentum
from support.files.cradle_csv import POLL
from support.files.data_file import EVERY
from support.page.marks import ARROW_TIME, FLAT, STILL
from support.page.motion_graph import ENERGIES, ENERGY, MOST_DRAWN, NOTHING, PHASE, PHASE_SPAN, SPANS
from support.page.scenery import FORWARD


def test_pause_and_run(wall):
    wall.wait(1)
    wall.click(wall.panel.pause)
    assert (wall.panel.pause.text, wall.panel.step.disabled) == ("Run", False)
    paused = wall.thetas()
    wall.wait(1)
    assert wall.thetas() == paused
    wall.panel.pause.bind()
    assert not wall.viewer.running  # it only queues: VPython calls it in another thread, in the middle of a tick
    wall.wait(1)
    assert (wall.panel.pause.text, wall.panel.step.disabled) == ("Pause", True)
    assert wall.time() == pytest.approx(2, abs=4 * FRAME)  # the simulation does not catch up after the pause


@pytest.mark.parametrize("speed", [0.1, 1, 2])
def test_speed_and_slow_motion(wall, speed):
    """While paused, a step moves the cradle by one frame."""
    wall.use(wall.panel.speed.slider, value=speed)
    wall.wait(2)
    assert wall.time() == pytest.approx(2 * speed, abs=0.05 * speed)
    assert f">{speed:.1f}x<" in wall.panel.speed.text.text
    assert wall.readout()["t"].endswith(" s")
    wall.viewer.pace.kept_up = 0.4
    wall.wait()
    assert wall.readout()["t"].endswith(f" s {0.4 * speed:.1f}x real time")
    wall.click(wall.panel.pause)
    ticks = wall.viewer.motion.ticks
    wall.panel.step.bind()
    wall.wait(1)
    assert wall.viewer.motion.ticks - ticks == round(speed * FRAME / wall.viewer.cradle.dt)


def test_bobs_lifted(wall):
    """The slider goes from none to all, and always snaps to a whole number of bobs. A digit lifts this number."""
    wall.use(wall.panel.lifted.slider, value=0.55)
    assert wall.lifts() == [30, 30, 30, 0, 0]
    assert wall.panel.lifted.slider.value == 0.6
    assert ">3 of 5<" in wall.panel.lifted.text.text
    for digit, lifted in (("2", 2), ("9", 5)):
        wall.press(digit)
        assert wall.lifts() == [30] * lifted + [0] * (5 - lifted)


def test_the_box_of_a_fixed_rule_is_fixed_and_says_so(csv, monkeypatch):
    tick, texts = visualize_cradle_run.newton_cradle_tick, []
    monkeypatch.setattr("support.page.panel.add_hint", texts.append)
    box = Wall(csv).panel.separating
    assert (box.checked, box.disabled) == (False, False)
    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", lambda p, r, dt, g: tick(p, r, dt, g))
    box = Wall(csv).panel.separating
    assert (box.checked, box.disabled) == (True, True)
    assert "Your functions have no parameter approaching_only, so this rule is fixed." in texts


@pytest.mark.parametrize(("key", "command"), [(" ", "pause"), ("right", "step"), ("r", "restart")])
def test_keys_do_what_the_buttons_do(wall, monkeypatch, key, command):
    monkeypatch.setattr(wall.viewer, "give", Mock())
    wall.press(key)
    wall.press("x")
    wall.press(key, ctrl=True)  # that is the browser's
    wall.press(key, alt=True)
    wall.viewer.give.assert_called_once_with(command, None)


def test_each_angle_of_a_double_cradle_has_its_slider_and_its_graphs(csv, monkeypatch):
    csv.write_text(HEADER + GOOD * 2)
    texts = []
    monkeypatch.setattr("support.page.panel.wtext", lambda text="": texts.append(text) or wtext(text=text))
    wall = Wall(csv, 30, 10, kind=DoubleCradle)
    theta, phi = wall.panel.angles
    ranges = [(setting.slider.min, setting.slider.max, setting.slider.step) for setting in (theta, phi)]
    assert ranges == [(0, 180, 1), (-180, 180, 1)]
    labels = ", ".join(re.findall('<span class="label">(.*?)</span>', "".join(texts)))
    assert labels == "Experiment, Speed, Bobs lifted, Angle theta, Angle phi, Collisions, Graph, Time of the graph"
    wall.use(theta.slider, value=75)
    wall.use(phi.slider, value=-12.5)
    assert wall.viewer.angles == thetas([75, -12.5])
    assert [wall.values(key)[0] for key in ("theta", "phi")] == pytest.approx(thetas([75, -12.5]))
    assert ">75&deg;<" in theta.text.text and ">-12.5&deg;<" in phi.text.text
    assert wall.panel.graph.choices == [
        *(ENERGY, "Angles theta", "Angles phi", "Velocities omega", "Velocities phi_omega"),
        *("Phase 1, theta", "Phase 1, phi", "Phase 2, theta", "Phase 2, phi", NOTHING),
    ]
    choose(wall, "Angles phi")
    assert drawn(wall)["1"][0] == [0, pytest.approx(wall.viewer.angles[1])]


def test_settings_stay_after_a_restart_on_a_reloaded_page_and_for_a_saved_csv(wall):
    wall.use(wall.panel.speed.slider, value=0.5)
    wall.use(wall.panel.separating, checked=True)
    wall.use(wall.panel.collisions, selected="perfectly inelastic, e = 0")
    wall.press(" ")
    for does in (lambda: wall.press("r"), lambda: wall.give("show again"), lambda: wall.save(HEADER + GOOD * 3)):
        does()
        assert (wall.viewer.pace.speed, wall.viewer.separating, wall.viewer.running) == (0.5, True, False)
        assert (wall.values("e"), wall.panel.pause.text) == ([0] * len(wall.thetas()), "Run")
    assert len(wall.thetas()) == 3


def test_the_program_ends_after_its_last_message_is_sent(wall, monkeypatch):
    """VPython's list of changes is empty before they are sent."""
    monkeypatch.setattr(baseObj, "sent", False)
    send = Mock(side_effect=lambda _: setattr(baseObj, "sent", True))
    monkeypatch.setattr("support.page.viewer.time.sleep", send)
    wall.viewer.end("NameError")
    send.assert_called_once()


# --- arrows and slow hits --------------------------------------------------------------------------------------------


def visible(wall, name):
    return [shape for shape in wall.viewer.marks.shapes.get(name, []) if shape.visible]


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_arrows_show_each_velocity_and_bars_the_momenta_and_their_sum(csv, kind):
    """Also for other pendula; they stay on a reloaded page, and the view has room for them."""
    wall = Wall(csv, *[30] * len(kind.angle_keys), kind=kind)
    scene.width, scene.height = 1000, 400
    wall.give("resize")
    near = scene.range
    wall.use(wall.panel.arrows, checked=True)
    assert scene.range > 1.05 * near
    for csv_text in ("", HEADER + "3.0,1.0,0,0,blue,metal\n" + GOOD):
        wall.save(csv_text) if csv_text else None
        wall.give("show again")
        wall.wait(0.15)
        cradle, bars = wall.viewer.cradle, visible(wall, "bars")
        moves = [(vx, vy) for pend in cradle.pend_list for _, vx, vy in bob_motions(pend, R_PARAM)]
        shown = [(*bob.pos.value[:2], *v) for bob, v in zip(cradle.bobs(), moves, strict=True) if hypot(*v) > STILL]
        arrows = [(*arrow.pos.value[:2], *(arrow.axis / ARROW_TIME).value[:2]) for arrow in visible(wall, "arrows")]
        assert arrows == [pytest.approx(each) for each in shown] and len(shown) == len(kind.angle_keys)
        momenta = [momentum([pend], R_PARAM) for pend in cradle.pend_list]
        marks, momenta = wall.viewer.marks, [*momenta, sum(momenta)]
        unit, flat = marks.height / max(marks.largest, *map(abs, momenta)), FLAT * marks.height
        for bar, x, p in zip(bars, marks.xs, momenta, strict=True):
            expected = [x, marks.level + p * unit / 2, max(flat, abs(p * unit))]
            assert [bar.pos.x, bar.pos.y, bar.size.y] == pytest.approx(expected)
        assert marks.xs[:-1] == [axle.pos.x for axle in cradle.axles()]
        assert [bar.color for bar in bars[:-1]] == [pend["objects"][1].color for pend in cradle.pend_list]
    wall.use(wall.panel.arrows, checked=False)
    assert (visible(wall, "arrows"), visible(wall, "bars"), visible(wall, "words")) == ([], [], [])


def reversed_order(pend_list, r_param, dt, g):
    """Let the pairs collide from right to left, as a student may have written it, without approaching_only."""
    visualize_cradle_run.full_swing_update(pend_list, r_param, dt, g)
    for pend1, pend2 in reversed([*pairwise(pend_list)]):
        visualize_cradle_run.handle_two_bobs(pend1, pend2, r_param, approaching_only=True)


@pytest.mark.parametrize(("tick", "pairs"), [(None, "23 12 34 23 45 34"), (reversed_order, "23 34 12 45 23 34")])
def test_slow_hits_show_each_pair_in_the_order_of_the_calls_and_then_the_swing_goes_on(csv, monkeypatch, tick, pairs):
    """With its speeds, its halos and the arrows after it."""
    if tick:
        monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", tick)
    wall = Wall(csv, 45, lifted=2)
    for _ in range(3):
        wall.press("h")
    assert wall.panel.slow_hits.checked
    wall.use(wall.panel.arrows, checked=True)
    shown = []
    while len(shown) < 6:
        wall.wait(0.1)
        hit, words = wall.viewer.slow_hits.shown, wall.panel.hit_words.text
        assert bool(hit) == bool(words) == bool(visible(wall, "halos"))
        if not hit or f"Hit {len(shown)}:" in words:
            continue
        left, right = map(int, re.search(rf"Hit {len(shown) + 1}: bobs (\d) and (\d)<", words).groups())
        shown.append(f"{left}{right}")
        exchange = f"bob {left}: +1.07 &rarr; +0.00 m/s</span><span>bob {right}: +0.00 &rarr; +1.07 m/s"
        assert exchange in words and "order is the model's: handle_two_bobs takes" in words
        assert len(visible(wall, "arrows")) == 2
        bobs = wall.viewer.cradle.bobs()[left - 1 : right]
        assert [halo.pos.x for halo in visible(wall, "halos")] == [bob.pos.x for bob in bobs]
        ticks = wall.viewer.motion.ticks
    assert " ".join(shown) == pairs
    wall.wait(1)
    assert wall.viewer.motion.ticks == ticks
    wall.wait(0.5)
    ticks, same = wall.viewer.motion.ticks - ticks, Wall(csv, 45, lifted=2).viewer  # nothing else has moved the bobs
    for _ in range(wall.viewer.motion.ticks):
        visualize_cradle_run.newton_cradle_tick(same.cradle.pend_list, R_PARAM, same.cradle.dt, G, **same.rule)
    assert (ticks > 0, same.cradle.values("theta")) == (True, wall.thetas())


def test_a_step_goes_on_to_the_next_of_the_slow_hits(wall):
    wall.press("h")
    wall.wait(0.4)
    wall.click(wall.panel.pause)
    for number in (1, 2, 3):
        wall.wait(3)
        assert f"Hit {number}:" in wall.panel.hit_words.text
        wall.press("right")
    wall.click(wall.panel.pause)
    wall.wait(1.5)
    assert (wall.panel.hit_words.text, wall.time() > 0.4) == ("", True)


# --- dragging --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("paused", [False, True])
@pytest.mark.parametrize(("kind", "bob", "cords"), [(Cradle, 4, 1), (DoubleCradle, 8, 1), (DoubleCradle, 9, 2)])
def test_a_bob_is_dragged_along_its_arc_let_go_and_swings_on_with_no_speed(csv, kind, bob, cords, paused):
    wall = Wall(csv, *[0] * len(kind.angles), kind=kind)
    cradle, pend = wall.viewer.cradle, wall.viewer.cradle.pend_list[4]
    axle, bob = cradle.axles()[4].pos, cradle.bobs()[bob]
    if paused:
        wall.panel.pause.bind()
    pend.update(dict.fromkeys(kind.rate_keys, 1.0))
    wall.mouse("mousedown", vector(bob.pos) + vector(bob.radius / 2, 0, 0))
    assert not any(pend[key] for key in kind.rate_keys)
    wall.mouse("mousemove", axle + vector(3, -3, 0))  # far away
    for after in (lambda: wall.wait(0.5), lambda: wall.mouse("mouseup", axle), lambda: wall.mouse("mousemove", axle)):
        assert wall.lifts() == [0, 0, 0, 0, 45]
        assert (bob.pos - axle).value == pytest.approx([cords * R_PARAM * 0.5**0.5, -cords * R_PARAM * 0.5**0.5, 0])
        assert wall.readout()["energy"] == "100.00 %"
        assert not any(pend[key] for key in kind.rate_keys)
        after()
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.wait(0.1)
    assert (wall.lifts()[4] == 45) == paused


AHEAD, ALONG = (0, 0, -1), (-1, 0, 0)  # the direction of the view: onto the row, and along it


@pytest.mark.parametrize(
    ("bob", "radii", "ray", "taken"), [(4, 1.4, AHEAD, 4), (4, -1.4, AHEAD, 3), (2, 0, ALONG, 4), (4, 1.6, AHEAD, None)]
)
def test_the_nearest_bob_is_taken_or_the_foremost_one_or_none_far_away(wall, bob, radii, ray, taken):
    """A finger may be beside it. A click that takes none begins no new 100 %."""
    wall.panel.pause.bind()
    wall.use(wall.panel.lifted.slider, value=0)
    wall.viewer.cradle.pend_list[0]["omega"] = 3.0
    bob = wall.viewer.cradle.bobs()[bob]
    wall.mouse("mousedown", vector(bob.pos) + vector(radii * bob.radius, 0, 0), ray)
    assert wall.viewer.cradle.hand.held == taken
    assert (wall.viewer.motion.start_energy == 0) == (taken is None)


def test_a_bob_follows_the_mouse_in_a_slanting_view_too(wall):
    wall.use(wall.panel.lifted.slider, value=0)
    wall.click(wall.panel.pause)
    axle, ray = wall.viewer.cradle.axles()[0], (-0.3, -0.2, -1)
    wall.mouse("mousedown", axle.pos + vector(0, -R_PARAM, 0), ray)
    wall.mouse("mousemove", axle.pos + vector(-1, -1, 0), ray)
    wall.mouse("mousemove", vector(1, 1, 1), (-1, 0, 0))  # no point in the plane of swing is under the mouse
    assert wall.lifts() == [45, 0, 0, 0, 0]


def test_a_saved_csv_makes_a_new_cradle_also_while_paused(wall):
    wall.wait(1)
    wall.press("3")
    wall.save(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    assert wall.values("mass") == [2, 2]
    assert wall.time() < 3 * POLL
    assert ">2 of 2<" in wall.panel.lifted.text.text
    wall.save(FIVE_CSV)
    assert ">3 of 5<" in wall.panel.lifted.text.text  # the old settings, where they are possible again
    wall.click(wall.panel.pause)
    wall.save(HEADER + GOOD * 9)
    assert (len(wall.viewer.cradle.bobs()), wall.time()) == (9, 0)
    axles = wall.viewer.cradle.axles()
    rails = [shape for shape in wall.viewer.scenery.frame if type(shape) is cylinder and shape.axis.y == 0]
    assert all(rail.axis.x > axles[-1].pos.x - axles[0].pos.x for rail in rails)


def test_a_broken_csv_shows_its_error_until_it_is_good_again(wall):
    """Also while an experiment is shown, which stays."""
    wall.give("experiment", 5)
    wall.save(FIVE_CSV + GOOD.replace("red", "<b>pink"))
    assert "cradle.csv, line 7, column color: found &#x27;&lt;b&gt;pink&#x27;, allowed" in wall.panel.error.text
    assert (wall.time() > 0.3, wall.values("mass")) == (True, [5, 1, 1, 1, 1])  # the old one swings on
    wall.save(FIVE_CSV)
    assert (wall.panel.error.text, wall.values("mass")) == ("", [1] * 5)


# --- the texts -------------------------------------------------------------------------------------------------------

ARROWS = [(3, "+{:.3f} kg m/s &rarr;"), (-3, "-{:.3f} kg m/s &larr;"), (0, "+{:.3f} kg m/s")]


@pytest.mark.parametrize(("omega", "text"), [*ARROWS, (1e6, "+{:.2e} kg m/s &rarr;")])
def test_the_readout(wall, omega, text):
    """The momentum has the arrow of its sign. A percentage is at most 999, and 0 of 0 is 0."""
    wall.click(wall.panel.pause)
    wall.viewer.cradle.pend_list[0].update(theta=0.0, omega=omega)
    wall.wait()
    start = G * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg at 30 degrees
    percent = 100 * (omega * R_PARAM) ** 2 / 2 / start
    assert wall.readout()["energy"] == ("&gt; 999 %" if omega == 1e6 else f"{percent:.2f} %")
    assert wall.readout()["momentum"] == text.format(abs(omega) * R_PARAM)
    wall.use(wall.panel.lifted.slider, value=0)
    assert wall.readout()["energy"] == "0.00 %"


def test_the_impacts_until_a_restart(wall):
    at_start = wall.thetas()
    wall.wait(0.9 * PERIOD)
    title, *lines = re.sub("<.*?>", "", wall.panel.impacts.text).splitlines()
    assert title == "Impacts"
    assert re.fullmatch(r"t = \d\.\d\d s  5-4-3-2-1", lines[0])
    assert lines[1:] == [f"t = {wall.viewer.motion.trains.trains[0].begin:.2f} s  1-2-3-4-5"]
    assert wall.viewer.motion.trains.trains[0].begin == pytest.approx(PERIOD / 4, rel=0.05)
    wall.click(wall.panel.restart)
    assert (wall.thetas(), wall.time(), wall.viewer.motion.trains.lines()) == (at_start, 0, [])


def test_unchanged_texts_are_not_sent_again(wall):
    wall.panel.pause.bind()
    wall.wait(0.5)
    texts = [wall.panel.readout, wall.panel.impacts, wall.panel.error, wall.panel.speed.text]
    before = [id(text.text) for text in texts]
    wall.wait(1)
    assert [id(text.text) for text in texts] == before


# --- the view --------------------------------------------------------------------------------------------------------


def test_the_view_is_reset_with_a_button_and_a_key_and_comes_back_from_far_away(wall):
    for reset in (lambda: wall.click(wall.panel.view), lambda: wall.press("v")):
        assert wall.panel.view.disabled  # panel.css hides it
        scene.forward, scene.range = vector(0, 0, -1), 1.5 * scene.range
        wall.wait()
        assert not wall.panel.view.disabled
        reset()
        assert scene.forward == FORWARD
        assert scene.range == wall.viewer.scenery.home[1]
    scene.range = 1e3
    wall.wait()
    assert scene.range < 10


def test_a_reloaded_page_shows_the_first_view_and_restarts(wall, monkeypatch):
    """The page opens slowly: this time does not count."""
    wall.wait(1)
    first = (vector(scene.forward), vector(scene.center), scene.range)
    monkeypatch.setattr(wall.viewer, "wait_for_page", lambda: setattr(wall, "now", wall.now + 5))
    scene.forward, scene.center, scene.range = vector(1, 0, -1), vector(1, 1, 1), 5
    wall.give("show again")
    assert (scene.forward, scene.center, scene.range) == first
    wall.wait()
    assert wall.viewer.motion.ticks == 0


def test_a_resized_canvas_is_filled_and_a_swing_above_the_frame_widens_the_view_until_the_next_restart(wall):
    scene.width, scene.height = 1000, 400
    scene.bound["resize"]()
    wall.wait()
    near, scenery = scene.range, wall.viewer.scenery
    wall.use(wall.panel.angles[0].slider, value=150)
    assert scene.range > 1.2 * near
    wall.use(wall.panel.angles[0].slider, value=45)
    assert scene.range == near
    scenery.space = scenery.space._replace(reach=0)
    wall.press("r")
    assert scene.range == near


def test_a_remark_stands_above_the_widgets(monkeypatch, csv):
    texts = []
    monkeypatch.setattr("support.page.panel.wtext", lambda text="": texts.append(text) or wtext(text=text))
    Wall(csv, remark="Write next: <main>.")
    assert '<div class="remark" role="note">Write next: &lt;main&gt;.</div>' in texts
    texts.clear()
    Wall(csv)
    assert not [text for text in texts if "remark" in text]


def test_numbers_change_ten_times_a_second(wall):
    seen = []
    for _ in range(60):
        wall.now += FRAME
        wall.do_frame()
        seen.append((wall.panel.readout.text, wall.viewer.graph.curves["total"].data))
    assert 8 <= sum(now[0] != before[0] and now[1] != before[1] for before, now in pairwise(seen)) <= 10


# --- the graph -------------------------------------------------------------------------------------------------------

ANGLES, VELOCITIES = "Angles theta", "Velocities omega"


def choose(wall, choice):
    """Choose a graph as a person does."""
    assert choice in wall.panel.graph.choices
    wall.use(wall.panel.graph, selected=choice)


def drawn(wall):
    """Return the points of the curves that have any, by the curves' labels."""
    return {curve.label: curve.data for curve in wall.viewer.graph.curves.values() if curve.data}


def recorded(wall, column):
    """Return the recorded values of a column, by their times (s)."""
    at = wall.viewer.graph.names.index(column)
    return {row[0]: row[at] for row in wall.viewer.graph.rows}


@pytest.mark.parametrize("span", SPANS)
def test_the_graph_shows_the_energies_of_the_last_seconds(wall, span):
    """In percent. Its points are always at the same times, so they do not shake."""
    shown, interval = SPANS[span]
    wall.use(wall.panel.span, selected=span)
    wall.wait(shown + 2)
    assert wall.panel.graph.selected == ENERGY
    assert list(drawn(wall)) == ["kinetic", "potential", "total"]
    kinetic, potential, total = drawn(wall).values()
    graph = wall.viewer.graph.graph
    assert graph.xmax - graph.xmin == pytest.approx(shown)
    times = [t for t, _ in total]
    assert times == pytest.approx([interval * round(t / interval) for t in times])
    assert times[0] == pytest.approx(graph.xmin, abs=2 * interval)
    assert times[-1] == pytest.approx(shown + 2, abs=2 * interval)
    for (t, k), (_, p), (_, both) in zip(kinetic, potential, total, strict=True):
        assert k + p == pytest.approx(both)
        assert both == pytest.approx(100, abs=0.1)
        assert 0 <= t - graph.xmin <= shown
    assert len({(*wall.viewer.graph.curves[name].color.value,) for name in ENERGIES}) == 3


def test_the_angles_and_velocities_of_all_bobs_are_drawn_in_their_colors(wall):
    colors = ["red", "cyan", "orange"]
    wall.save(HEADER + "".join(GOOD.replace("red", color) for color in colors))
    for choice, key in ((ANGLES, "theta"), (VELOCITIES, "omega")):
        choose(wall, choice)
        wall.wait(0.5)
        assert list(drawn(wall)) == ["1", "2", "3"]
        for number, color in zip("123", colors, strict=True):
            values = recorded(wall, f"{key}_{number}")
            assert all(values[t] == value for t, value in drawn(wall)[number])
            assert wall.viewer.graph.curves[number].color == COLOR_MAP[color]


def test_the_phase_picture_is_that_of_one_bob(wall):
    choose(wall, "Phase 1")
    wall.wait(PHASE_SPAN[0] + 1)
    assert re.findall('"axis">(.*?)<', wall.panel.chosen.text) == ["theta (rad)", "omega (rad/s)"]
    assert list(drawn(wall)) == [PHASE]
    points = drawn(wall)[PHASE]
    assert len(points) == pytest.approx(PHASE_SPAN[0] / EVERY, abs=2)
    assert points[-1] == [[*recorded(wall, f"{key}_1").values()][-1] for key in ("theta", "omega")]
    assert wall.viewer.graph.curves[PHASE].color == COLOR_MAP["red"]


def test_a_new_cradle_has_its_own_choices_and_keeps_the_present_one_if_it_can(wall):
    choose(wall, ANGLES)
    wall.save(HEADER + GOOD.replace("red", "green") * (MOST_DRAWN + 3))
    assert wall.panel.graph.selected == ANGLES
    assert list(drawn(wall)) == [str(number) for number in range(1, MOST_DRAWN + 1)]  # the first ones
    assert wall.viewer.graph.curves["1"].color == COLOR_MAP["green"]
    choose(wall, "Phase 7")
    wall.save(HEADER + GOOD * 2)
    assert wall.panel.graph.selected == ENERGY
    assert set(drawn(wall)) == set(ENERGIES)


def test_no_graph_is_hidden_and_sends_nothing_and_a_restart_empties_it(wall):
    wall.wait(1)
    choose(wall, NOTHING)
    wall.wait(1)
    assert wall.panel.chosen.text.startswith('<i class="chosen" data-name="no graph"></i>')  # panel.css hides it
    assert not drawn(wall)
    choose(wall, ENERGY)
    assert len(drawn(wall)["total"]) == pytest.approx(2 / EVERY, abs=2)  # it shows what was recorded meanwhile
    wall.click(wall.panel.restart)
    assert [len(points) for points in drawn(wall).values()] == [1, 1, 1]
