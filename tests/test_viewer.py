"""The viewer, its panel and its graph on the stand-in: what the widgets, keys and mouse do, and what is to be read.

The wall clock is the test's, so that time passes only when a test lets it.
"""

import re
from itertools import pairwise
from math import pi
from types import SimpleNamespace

import pytest
from cradles import components, FIVE_CSV, GOOD, HEADER
from vpython import scene, vector

from src.live_cradle import LiveCradle
from src.visualize_cradle_run import advance_cradle
from support.commands import Command
from support.constants import R_PARAM
from support.energy_graph import HIDING, SPAN
from support.live_file import LiveFile, POLL
from support.real_time import FRAME, RealTime
from support.viewer import Viewer


class Wall:
    """The wall clock, and the viewer that lives by it."""

    def __init__(self, csv, angle=30, lifted=1):
        self.now = 100.0
        self.file = csv
        options = SimpleNamespace(elastic=False, inelastic=False, e=None, mass=None)
        live_file = LiveFile(csv, self.clock)
        self.viewer = Viewer(LiveCradle(advance_cradle, options), live_file, angle, lifted)
        self.viewer.pace = RealTime(self.viewer.cradle.dt, self.clock, sleep=None)
        self.panel = self.viewer.panel

    def clock(self):
        return self.now

    def wait(self, seconds=0.0):
        """Let this time pass, frame by frame."""
        for _ in range(max(1, round(seconds / FRAME))):
            self.now += seconds and FRAME
            self.viewer.next_refresh = 0
            self.viewer.frame()

    def thetas(self):
        return [pend["theta"] for pend in self.viewer.cradle.pend_list]

    def lifts(self):
        """Return how far the bobs are lifted, in whole degrees."""
        return [round(abs(theta) * 180 / pi) for theta in self.thetas()]

    def time(self):
        return float(re.search(r"t = ([\d.]+) s", self.panel.readout.text)[1])

    def press(self, key, **modifiers):
        scene.bound["keydown"](SimpleNamespace(**{"key": key, "ctrl": False, "alt": False, **modifiers}))
        self.wait()

    def mouse(self, kind, point):
        """Move the mouse to where this point is seen, straight from the front, and let this happen."""
        scene.mouse.ray = vector(0, 0, -1)
        event = SimpleNamespace(pos=point + vector(0, 0, 0.5))
        function = scene.bound[kind]
        function() if kind == "mouseup" else function(event)
        self.wait()


@pytest.fixture
def csv(tmp_path):
    path = tmp_path / "cradle.csv"
    path.write_text(FIVE_CSV)
    return path


@pytest.fixture
def wall(csv):
    return Wall(csv)


def set_slider(setting, value):
    """Move a slider as a person does: VPython sets its value, and calls what is bound to it."""
    setting.slider.value = value
    setting.slider.bind(setting.slider)


def test_it_keeps_time(wall):
    wall.wait(2)
    assert wall.time() == pytest.approx(2, abs=2 * FRAME)
    assert any(wall.thetas())


def test_pause_and_run(wall):
    wall.wait(1)
    wall.panel.pause.bind()
    wall.wait()
    assert (wall.panel.pause.text, wall.panel.step.disabled) == ("Run", False)
    paused = wall.thetas()
    wall.wait(3)
    assert wall.thetas() == paused
    wall.panel.pause.bind()
    wall.wait(1)
    assert (wall.panel.pause.text, wall.panel.step.disabled) == ("Pause", True)
    assert wall.time() == pytest.approx(2, abs=4 * FRAME)  # the pause is not made up for


@pytest.mark.parametrize("speed", [0.1, 1, 2])
def test_step_moves_by_one_frame_while_paused(wall, speed):
    set_slider(wall.panel.speed, speed)
    wall.panel.pause.bind()
    wall.wait()
    ticks = wall.viewer.ticks
    wall.panel.step.bind()
    wall.wait(1)
    assert wall.viewer.ticks - ticks == round(speed * FRAME / wall.viewer.cradle.dt)


def test_step_does_nothing_while_running(wall):
    wall.panel.step.bind()
    wall.wait()
    assert wall.viewer.ticks == 0


def test_restart(wall):
    at_start = wall.thetas()
    wall.wait(1)
    assert wall.viewer.trains.lines()
    wall.panel.restart.bind()
    wall.wait()
    assert (wall.thetas(), wall.time(), wall.viewer.trains.lines()) == (at_start, 0, [])


@pytest.mark.parametrize("speed", [0.1, 2])
def test_speed(wall, speed):
    set_slider(wall.panel.speed, speed)
    wall.wait(3)
    assert wall.time() == pytest.approx(3 * speed, abs=0.05 * speed)
    assert f">{speed:.1f}x<" in wall.panel.speed.text.text


def test_release_angle(wall):
    wall.wait(1)
    set_slider(wall.panel.angles[0], 75)
    wall.wait()
    assert (wall.lifts(), wall.time()) == ([75, 0, 0, 0, 0], 0)
    assert ">75&deg;<" in wall.panel.angles[0].text.text


def test_bobs_lifted(wall):
    """The slider goes from none to all; whatever it is put to, it snaps to a whole number of bobs."""
    set_slider(wall.panel.lifted, 0.55)
    wall.wait()
    assert wall.lifts() == [30, 30, 30, 0, 0]
    assert wall.panel.lifted.slider.value == 0.6
    assert ">3 of 5<" in wall.panel.lifted.text.text


def test_collisions(wall):
    choices = wall.panel.collisions.choices
    assert choices == list(wall.viewer.cradle.collisions)
    assert wall.panel.collisions.selected == choices[0]
    wall.panel.collisions.selected = choices[2]
    wall.panel.collisions.bind(wall.panel.collisions)
    wall.wait(1)
    assert [pend["e"] for pend in wall.viewer.cradle.pend_list] == [0] * 5
    assert max(wall.thetas()) - min(wall.thetas()) < 0.05  # they hang together


def test_separating_bobs(wall, monkeypatch):
    rules = []
    monkeypatch.setattr(
        wall.viewer.cradle, "advance", lambda ticks, approaching_only: rules.append(approaching_only) or []
    )
    for checked in (False, True, False):
        wall.panel.separating.checked = checked
        wall.panel.separating.bind(wall.panel.separating)
        wall.wait(0.1)
    assert [rule for rule, following in pairwise([*rules, None]) if rule is not following] == [True, False, True]


@pytest.mark.parametrize(
    ("key", "command"),
    [(" ", Command.PAUSE), ("right", Command.STEP), ("r", Command.RESTART)],
)
def test_keys_do_what_the_buttons_do(wall, monkeypatch, key, command):
    done = []
    monkeypatch.setattr(wall.viewer, "carry_out", lambda *given: done.append(given))
    wall.press(key)
    wall.press("x")
    wall.press(key, ctrl=True)  # that is the browser's
    wall.press(key, alt=True)
    assert done == [(command, None)]


@pytest.mark.parametrize(("digit", "lifted"), [("1", 1), ("2", 2), ("5", 5), ("9", 5)])
def test_digits_lift_that_many(wall, digit, lifted):
    wall.press(digit)
    assert wall.lifts() == [30] * lifted + [0] * (5 - lifted)


def test_a_callback_only_queues(wall):
    """It comes in another thread, in the middle of a tick."""
    thetas = wall.thetas()
    set_slider(wall.panel.angles[0], 75)
    wall.panel.pause.bind()
    assert (wall.thetas(), wall.viewer.running) == (thetas, True)
    wall.wait()
    assert (wall.lifts()[0], wall.viewer.running) == (75, False)


# --- dragging --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("paused", [False, True])
def test_a_bob_is_dragged_along_its_arc_and_let_go(wall, paused):
    if paused:
        wall.panel.pause.bind()
    set_slider(wall.panel.lifted, 0)
    wall.wait()
    axle, bob = wall.viewer.cradle.axles()[4], wall.viewer.cradle.bobs()[4]
    wall.mouse("mousedown", vector(bob.pos) + vector(bob.radius / 2, 0, 0))
    wall.mouse("mousemove", axle.pos + vector(1, -1, 0))
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.wait(0.5)
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.mouse("mouseup", axle.pos)
    assert wall.viewer.cradle.pend_list[4]["omega"] == 0
    assert "energy 100.00 % (kinetic   0.00 %, potential 100.00 %)" in wall.panel.readout.text
    wall.mouse("mousemove", axle.pos)
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.wait(0.1)
    assert (wall.lifts()[4] == 45) == paused


def test_a_click_beside_the_bobs_takes_none(wall):
    axle, bob = wall.viewer.cradle.axles()[4], wall.viewer.cradle.bobs()[4]
    before = wall.thetas()
    wall.mouse("mousedown", vector(bob.pos) + vector(1.1 * bob.radius, 0, 0))
    wall.mouse("mousemove", axle.pos + vector(1, 0, 0))
    wall.mouse("mouseup", axle.pos)
    assert wall.thetas() == before


def test_of_two_bobs_under_the_mouse_the_nearer_one_is_taken(wall):
    """Seen along the row."""
    set_slider(wall.panel.lifted, 0)
    wall.wait()
    bob = wall.viewer.cradle.bobs()[2]
    scene.mouse.ray = vector(-1, 0, 0)
    scene.bound["mousedown"](SimpleNamespace(pos=vector(bob.pos)))
    wall.wait()
    assert wall.viewer.cradle.held == 4
    scene.bound["mousemove"](SimpleNamespace(pos=vector(1, 1, 1)))  # in the plane of swing there is no such place
    wall.wait()
    assert wall.lifts() == [0] * 5


# --- the file --------------------------------------------------------------------------------------------------------


def test_a_saved_csv_makes_a_new_cradle(wall, csv):
    wall.wait(1)
    wall.press("3")
    csv.write_text(HEADER + "2.0,0.5,0,0,blue,wood\n" * 2)
    wall.wait(3 * POLL)
    assert [pend["mass"] for pend in wall.viewer.cradle.pend_list] == [2, 2]
    assert wall.time() < 3 * POLL
    assert ">2 of 2<" in wall.panel.lifted.text.text
    csv.write_text(FIVE_CSV)
    wall.wait(3 * POLL)
    assert ">3 of 5<" in wall.panel.lifted.text.text  # what was set, where it is possible again


def test_a_broken_csv_shows_its_error_until_it_is_good_again(wall, csv):
    good = csv.read_text()
    csv.write_text(good + GOOD.replace("red", "<b>pink"))
    wall.wait(1)
    assert (
        "cradle.csv, line 7, column color: found &#x27;&lt;b&gt;pink&#x27;, allowed is one of" in wall.panel.error.text
    )
    assert wall.time() == pytest.approx(1, abs=2 * FRAME)  # the old one swings on
    csv.write_text(good)
    wall.wait(1)
    assert wall.panel.error.text == ""


def test_a_cradle_that_is_made_anew_lets_go_of_the_bob(wall, csv):
    wall.mouse("mousedown", vector(wall.viewer.cradle.bobs()[4].pos))
    assert wall.viewer.cradle.held == 4
    csv.write_text(HEADER + GOOD)
    wall.wait(3 * POLL)
    wall.mouse("mousemove", vector(1, 1, 0))
    assert wall.viewer.cradle.held is None


# --- what is to be read ----------------------------------------------------------------------------------------------


def test_the_readout(wall):
    wall.panel.pause.bind()
    wall.wait()
    wall.viewer.cradle.pend_list[0].update(theta=0.0, omega=3.0)
    wall.wait()
    text = re.sub("<.*?>", "", wall.panel.readout.text)
    start = 9.81 * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg lifted by 30 degrees
    percent = 100 * (3 * R_PARAM) ** 2 / 2 / start
    assert f"energy {percent:6.2f} % (kinetic {percent:6.2f} %, potential   0.00 %)   momentum  +0.600 kg m/s" in text


def test_the_readout_is_steady(wall):
    """It has the same width at all times, and whatever stands in it stays in its place."""
    texts = set()
    for _ in range(100):
        wall.wait(0.1)
        texts.add(wall.panel.readout.text)
    assert len(texts) > 90
    assert len({len(text) for text in texts}) == 1
    assert len({text.index("momentum") for text in texts}) == 1


def test_a_cradle_at_rest_has_no_percentages_of_nothing(wall):
    set_slider(wall.panel.lifted, 0)
    wall.wait(1)
    assert "energy   0.00 % (kinetic   0.00 %, potential   0.00 %)" in wall.panel.readout.text


def test_slow_motion_is_admitted(wall, monkeypatch):
    advance = wall.viewer.cradle.advance

    def slow(ticks, approaching_only):
        wall.now += ticks * wall.viewer.cradle.dt / 0.45
        return advance(ticks, approaching_only)

    wall.wait(2)
    assert "x0." not in wall.panel.readout.text
    monkeypatch.setattr(wall.viewer.cradle, "advance", slow)
    wall.wait(3)
    # In a frame 0.75 of its length is spent on ticks, at 0.45 of real time; and the test's frames come on top of that.
    assert f"   x{0.75 * 0.45 / 1.75:.1f}<" in wall.panel.readout.text


def test_the_contact_strip(wall):
    wall.wait(1)
    lines = re.sub("<.*?>", "", wall.panel.impacts.text).splitlines()
    assert lines[0] == "Impacts"
    assert re.fullmatch(r"t = 0\.\d\d s  5-4-3-2-1", lines[1])
    assert re.fullmatch(r"t = 0\.2\d s  1-2-3-4-5", lines[-1])


def test_what_has_not_changed_is_not_sent_again(wall):
    """Or a person could not select it."""
    wall.panel.pause.bind()
    wall.wait(0.5)
    texts = [wall.panel.readout, wall.panel.impacts, wall.panel.error, wall.panel.speed.text]
    before = [id(text.text) for text in texts]
    wall.wait(1)
    assert [id(text.text) for text in texts] == before


# --- the graph -------------------------------------------------------------------------------------------------------


def test_the_graph_shows_the_last_ten_seconds(wall):
    wall.wait(SPAN + 2)
    graph = wall.viewer.graph
    kinetic, potential, total = (curve.data for curve in graph.curves)
    assert [curve.label for curve in graph.curves] == ["kinetic", "potential", "total"]
    assert graph.graph.xmax - graph.graph.xmin == SPAN
    assert graph.graph.xmin <= total[0][0] < graph.graph.xmin + 0.5
    assert total[-1][0] == pytest.approx(SPAN + 2, abs=0.1)
    for (t, k), (_, p), (_, both) in zip(kinetic, potential, total, strict=True):
        assert k + p == pytest.approx(both)
        assert 0 <= t - graph.graph.xmin <= SPAN
    assert len({tuple(components(curve.color)) for curve in graph.curves}) == 3


def test_restart_empties_the_graph(wall):
    wall.wait(1)
    wall.panel.restart.bind()
    wall.wait()
    assert [len(curve.data) for curve in wall.viewer.graph.curves] == [1, 1, 1]


def test_the_graph_can_be_switched_off_and_then_takes_and_sends_nothing(wall):
    graph, box = wall.viewer.graph, wall.panel.graph
    wall.wait(1)
    box.checked = False
    box.bind(box)
    wall.wait()
    sent = [curve.data for curve in graph.curves]
    wall.wait(1)
    assert graph.style.text == HIDING
    assert not graph.points
    assert all(curve.data is data for curve, data in zip(graph.curves, sent, strict=True))
    box.checked = True
    box.bind(box)
    wall.wait(1)
    assert graph.style.text == ""
    assert graph.curves[0].data[0][0] > 2


def test_a_resized_canvas_is_filled(wall):
    near = scene.range
    scene.width, scene.height = 300, 420
    scene.bound["resize"]()
    wall.wait()
    assert scene.range != near
