"""The viewer, its panel and its graph on the stand-in: widgets, keys, mouse, and texts.

Time passes only when a test moves its own wall clock.
"""

import os
import re
from itertools import pairwise
from math import copysign, pi
from threading import Event
from types import SimpleNamespace

import pandas as pd
import pytest
from programs import SECONDS, wait_until
from vpython import cylinder, scene, vector, wtext
from wall import set_slider, Wall
from whole_cradles import components, FIVE_CSV, go_on, GOOD, HEADER, PERIOD, thetas

from src import visualize_cradle_run
from src.beyond.live_double_cradle import LiveDoubleCradle
from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.files.live_file import POLL
from support.files.recording import EVERY
from support.page.commands import Command
from support.page.scenery import FORWARD
from support.playback.real_time import FRAME


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
    assert wall.time() == pytest.approx(2, abs=4 * FRAME)  # the simulation does not catch up after the pause


@pytest.mark.parametrize("speed", [0.1, 1, 2])
def test_step_moves_by_one_frame_while_paused(wall, speed):
    set_slider(wall.panel.speed, speed)
    wall.panel.pause.bind()
    wall.wait()
    ticks = wall.viewer.motion.ticks
    wall.panel.step.bind()
    wall.wait(1)
    assert wall.viewer.motion.ticks - ticks == round(speed * FRAME / wall.viewer.cradle.dt)


def test_step_does_nothing_while_running(wall):
    wall.panel.step.bind()
    wall.wait()
    assert wall.viewer.motion.ticks == 0


def test_restart(wall):
    at_start = wall.thetas()
    wall.wait(PERIOD)
    assert wall.viewer.motion.trains.lines()
    wall.panel.restart.bind()
    wall.wait()
    assert (wall.thetas(), wall.time(), wall.viewer.motion.trains.lines()) == (at_start, 0, [])


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
    """The slider goes from none to all, and always snaps to a whole number of bobs."""
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


def test_separating_bobs(wall):
    rules = []
    for checked in (False, True, False):
        wall.panel.separating.checked = checked
        wall.panel.separating.bind(wall.panel.separating)
        wall.wait(0.1)
        rules.append(wall.viewer.rule)
    assert rules == [{"approaching_only": rule} for rule in (True, False, True)]


def test_where_the_rule_cannot_be_chosen_the_box_says_so_and_is_fixed(csv, monkeypatch):
    tick, texts = visualize_cradle_run.newton_cradle_tick, []
    monkeypatch.setattr("support.page.panel.add_hint", texts.append)
    box = Wall(csv).panel.separating
    assert (box.checked, box.disabled) == (False, False)
    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", lambda p, r, dt, g: tick(p, r, dt, g))
    box = Wall(csv).panel.separating
    assert (box.checked, box.disabled) == (True, True)
    assert "Your functions have no parameter approaching_only, so this rule is fixed." in texts


@pytest.mark.parametrize(
    ("key", "command"),
    [(" ", Command.PAUSE), ("right", Command.STEP), ("r", Command.RESTART)],
)
def test_keys_do_what_the_buttons_do(wall, monkeypatch, key, command):
    done = []
    monkeypatch.setattr(wall.viewer, "carry_out", lambda *given: done.append(given) or iter(()))
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
    """The event comes in another thread, in the middle of a tick."""
    thetas = wall.thetas()
    set_slider(wall.panel.angles[0], 75)
    wall.panel.pause.bind()
    assert (wall.thetas(), wall.viewer.running) == (thetas, True)
    wall.wait()
    assert (wall.lifts()[0], wall.viewer.running) == (75, False)


def test_the_ranges_of_the_sliders(wall):
    settings = [wall.panel.speed, *wall.panel.angles, wall.panel.lifted]
    assert [(setting.slider.min, setting.slider.max) for setting in settings] == [(0.1, 2), (0, 180), (0, 1)]


def test_an_angle_is_shown_to_its_last_digit(csv):
    assert ">12.5&deg;<" in Wall(csv, 12.5).panel.angles[0].text.text


def test_each_release_angle_of_a_double_cradle_has_its_slider(csv, monkeypatch):
    texts = []
    monkeypatch.setattr("support.page.widgets.wtext", lambda text="": texts.append(text) or wtext(text=text))
    wall = Wall(csv, 30, 10, kind=LiveDoubleCradle)
    theta, phi = wall.panel.angles
    ranges = [(setting.slider.min, setting.slider.max, setting.slider.step) for setting in (theta, phi)]
    assert ranges == [(0, 180, 1), (-180, 180, 1)]
    labels = re.findall('<span class="label">(.*?)</span>', "".join(texts))
    assert labels == ["Experiment", "Speed", "Bobs lifted", "Angle theta", "Angle phi", "Collisions", "Graph"]
    set_slider(theta, 75)
    set_slider(phi, -40)
    wall.wait()
    assert wall.viewer.angles == thetas([75, -40])
    first = wall.viewer.cradle.pend_list[0]
    outwards = copysign(1, THETA_INIT)
    assert (first["theta"], first["phi"]) == pytest.approx((outwards * 75 * pi / 180, -outwards * 40 * pi / 180))


@pytest.mark.parametrize("after", ["restart", "reload", "page"])
def test_what_is_set_stays_set(wall, csv, after):
    set_slider(wall.panel.speed, 0.5)
    for widget, value in ((wall.panel.separating, "checked"), (wall.panel.collisions, "selected")):
        setattr(widget, value, True if value == "checked" else "inelastic, e = 0")
        widget.bind(widget)
    wall.press(" ")
    if after == "reload":
        csv.write_text(HEADER + GOOD * 2)
        wall.wait(3 * POLL)
    elif after == "page":
        wall.viewer.give(Command.SHOW_AGAIN)
        wall.wait()
    else:
        wall.press("r")
    assert (wall.viewer.pace.speed, wall.viewer.separating, wall.viewer.running) == (0.5, True, False)
    assert [pend["e"] for pend in wall.viewer.cradle.pend_list] == [0] * (2 if after == "reload" else 5)
    assert wall.panel.pause.text == "Run"


def test_what_passed_before_it_ran_is_not_owed(wall, monkeypatch):
    """The page opens slowly."""

    def wait_for_page():
        wall.now += 5

    monkeypatch.setattr(wall.viewer, "wait_for_page", wait_for_page)
    go_on(wall.viewer, wall.viewer.open())
    wall.wait()
    assert wall.viewer.motion.ticks == 0


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
    assert wall.percents() == ["100.0 %", "0.0 %", "100.0 %"]
    wall.wait(0.5)
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.mouse("mouseup", axle.pos)
    assert wall.viewer.cradle.pend_list[4]["omega"] == 0
    assert wall.percents() == ["100.0 %", "0.0 %", "100.0 %"]
    wall.mouse("mousemove", axle.pos)
    assert wall.lifts() == [0, 0, 0, 0, 45]
    wall.wait(0.1)
    assert (wall.lifts()[4] == 45) == paused


def test_a_click_beside_the_bobs_takes_none(wall):
    axle, bob = wall.viewer.cradle.axles()[4], wall.viewer.cradle.bobs()[4]
    before = wall.thetas()
    wall.mouse("mousedown", vector(bob.pos) + vector(1.6 * bob.radius, 0, 0))
    wall.mouse("mousemove", axle.pos + vector(1, 0, 0))
    wall.mouse("mouseup", axle.pos)
    assert wall.thetas() == before


@pytest.mark.parametrize(("radii", "taken"), [(1.4, 4), (-1.4, 3)])
def test_a_finger_beside_a_bob_takes_the_nearest_one(wall, radii, taken):
    wall.panel.pause.bind()
    set_slider(wall.panel.lifted, 0)
    wall.wait()
    bob = wall.viewer.cradle.bobs()[4]
    wall.mouse("mousedown", vector(bob.pos) + vector(radii * bob.radius, 0, 0))
    assert wall.viewer.cradle.held == taken


def test_of_two_bobs_under_the_mouse_the_nearer_one_is_taken(wall):
    """The view is along the row."""
    set_slider(wall.panel.lifted, 0)
    wall.wait()
    bob = wall.viewer.cradle.bobs()[2]
    scene.mouse.ray = vector(-1, 0, 0)
    scene.bound["mousedown"](SimpleNamespace(pos=vector(bob.pos)))
    wall.wait()
    assert wall.viewer.cradle.held == 4
    scene.bound["mousemove"](SimpleNamespace(pos=vector(1, 1, 1)))  # no point in the plane of swing is under the mouse
    wall.wait()
    assert wall.lifts() == [0] * 5


def test_a_bob_is_dragged_to_where_a_slanting_view_shows_the_mouse(wall):
    set_slider(wall.panel.lifted, 0)
    wall.panel.pause.bind()
    wall.wait()
    axle, ray = wall.viewer.cradle.axles()[0], vector(-0.3, -0.2, -1)

    def seen(x, y):  # a point in front of the plane of swing
        return SimpleNamespace(pos=axle.pos + vector(x, y, 0) - 0.3 * ray)

    scene.mouse.ray = ray
    scene.bound["mousedown"](seen(0, -R_PARAM))
    scene.bound["mousemove"](seen(-1, -1))
    wall.wait(0.5)
    assert wall.lifts() == [45, 0, 0, 0, 0]


@pytest.mark.parametrize("dragged", [False, True])
def test_a_click_beside_the_bobs_begins_no_new_hundred_percent(wall, dragged):
    bob = vector(wall.viewer.cradle.bobs()[4].pos)
    if dragged:
        wall.mouse("mousedown", bob)
        wall.mouse("mouseup", bob)
    start = wall.viewer.motion.start_energy
    wall.viewer.collide("inelastic, e = 0")
    wall.wait(1)
    wall.mouse("mousedown", bob + vector(1, 0, 0))
    wall.mouse("mouseup", bob + vector(1, 0, 0))
    assert wall.viewer.motion.start_energy == start


def test_restart_lets_go_of_the_bob(wall):
    wall.mouse("mousedown", vector(wall.viewer.cradle.bobs()[4].pos))
    wall.press("r")
    assert wall.viewer.cradle.held is None


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
    assert ">3 of 5<" in wall.panel.lifted.text.text  # the old settings, where they are possible again


def test_a_csv_saved_while_paused_is_shown(wall, csv):
    wall.panel.pause.bind()
    wall.wait()
    csv.write_text(HEADER + GOOD * 9)
    wall.wait(3 * POLL)
    assert (len(wall.viewer.cradle.bobs()), wall.time()) == (9, 0)
    axles = wall.viewer.cradle.axles()
    rails = [shape for shape in wall.viewer.scenery.frame if type(shape) is cylinder and shape.axis.y == 0]
    assert all(rail.axis.x > axles[-1].pos.x - axles[0].pos.x for rail in rails)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such pipes")
def test_a_pipe_in_place_of_the_csv_is_an_error_and_the_cradle_goes_on(wall, csv):
    csv.unlink()
    os.mkfifo(csv)
    wall.wait(1)
    assert wall.panel.error.text.endswith("found a pipe or a device, allowed is a file</div>")
    assert wall.time() == pytest.approx(1, abs=2 * FRAME)
    csv.unlink()
    csv.write_text(HEADER + GOOD * 2)
    wall.wait(3 * POLL)
    assert (wall.panel.error.text, len(wall.thetas())) == ("", 2)


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


# --- saved data ------------------------------------------------------------------------------------------------------


def saved(wall):
    """Press the button, and return the data of the file that the page names."""
    wall.panel.save.bind()
    wait_for_saved(wall)
    count, path = re.fullmatch(
        r'<span class="hint saved">(\d+) rows are in (.*)</span>', wall.panel.saved.text
    ).groups()
    data = pd.read_csv(path)
    assert len(data) == int(count)
    return data


def wait_for_saved(wall):
    """Let no time pass, but frames, until the thread that saves has ended."""

    def has_saved():
        wall.wait()
        return wall.viewer.saving is None

    wait_until(has_saved)


def test_what_has_been_seen_is_saved_where_the_program_was_started(wall, csv, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    wall.wait(2)
    data = saved(wall)
    assert sorted(os.listdir(tmp_path)) == ["cradle.csv", "cradle_data_1.csv"]
    assert data["t"].to_list() == pytest.approx([EVERY * i for i in range(len(data))])
    assert data["t"].iloc[-1] == pytest.approx(2, abs=3 * FRAME)
    pend_list = make_newton_cradle(csv, R_PARAM, copysign(pi / 6, THETA_INIT))
    for _ in range(round(EVERY / DT) * 70):
        newton_cradle_tick(pend_list, R_PARAM, DT, G, approaching_only=True)
    for i, pend in enumerate(pend_list, start=1):
        assert data.loc[70, [f"theta_{i}", f"omega_{i}"]].to_list() == pytest.approx([pend["theta"], pend["omega"]])


def test_saving_begins_at_the_last_restart_and_never_takes_an_older_file(wall, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    wall.wait(2)
    longer = saved(wall)
    wall.press("r")
    wall.wait(1)
    shorter = saved(wall)
    assert shorter["t"].to_list() == pytest.approx([EVERY * i for i in range(len(shorter))])
    assert shorter["t"].iloc[-1] == pytest.approx(1, abs=4 * FRAME)
    assert len(pd.read_csv("cradle_data_1.csv")) == len(longer)
    assert wall.panel.saved.text.endswith("cradle_data_2.csv</span>")


def test_saving_works_while_paused_and_in_another_folder(wall, tmp_path, monkeypatch):
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    wall.wait(1)
    wall.press(" ")
    assert len(saved(wall)) > 0.8 / EVERY
    assert os.listdir() == ["cradle_data_1.csv"]


@pytest.fixture
def slow_disk(monkeypatch):
    """A disk that waits for this event before it has a file."""
    ready, fsync = Event(), os.fsync

    def wait(descriptor):
        assert ready.wait(SECONDS)
        fsync(descriptor)

    monkeypatch.setattr("os.fsync", wait)
    yield ready
    ready.set()


def test_the_cradle_swings_on_while_its_data_are_saved(wall, tmp_path, monkeypatch, slow_disk):
    """The file has the data of the moment in which the button was pressed. A second press does nothing."""
    monkeypatch.chdir(tmp_path)
    wall.wait(1)
    rows = len(wall.viewer.recording.rows)
    for _ in range(2):
        wall.panel.save.bind()
        wall.wait(1)
        assert wall.panel.saved.text == f'<span class="hint saved">Saving {rows} rows ...</span>'
    wall.press("r")
    wall.wait(1)
    assert wall.time() == pytest.approx(1, abs=2 * FRAME)
    slow_disk.set()
    wait_for_saved(wall)
    assert wall.panel.saved.text.endswith(f">{rows} rows are in {tmp_path / 'cradle_data_1.csv'}</span>")
    assert len(pd.read_csv("cradle_data_1.csv")) == rows
    assert len(saved(wall)) < rows + 10
    assert sorted(os.listdir(tmp_path)) == ["cradle.csv", "cradle_data_1.csv", "cradle_data_2.csv"]


def test_a_program_that_ends_completes_the_file(wall, tmp_path, monkeypatch, slow_disk):
    monkeypatch.chdir(tmp_path)
    wall.wait(1)
    wall.panel.save.bind()
    wall.wait()
    monkeypatch.setattr(wall.viewer, "wait_for_page", lambda *_: slow_disk.set())
    wall.viewer.end("it had a mistake")
    assert wall.panel.saved.text.endswith(f" rows are in {tmp_path / 'cradle_data_1.csv'}</span>")
    assert sorted(os.listdir(tmp_path)) == ["cradle.csv", "cradle_data_1.csv"]


def test_the_name_of_a_folder_is_shown_as_text(wall):
    wall.panel.show_saved("in <b>x & y")
    assert "in &lt;b&gt;x &amp; y</span>" in wall.panel.saved.text


def test_what_the_button_saves_is_told_beforehand(wall):
    assert "since the last restart, at most ten minutes" in wall.panel.saved.text


def test_saving_again_after_another_cradle_has_its_columns(wall, csv, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    csv.write_text(HEADER + GOOD * 2)
    wall.wait(3 * POLL)
    assert [name for name in saved(wall).columns if name.startswith("theta")] == ["theta_1", "theta_2"]


def test_a_folder_that_cannot_be_written_to_is_named_on_the_page(wall, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("os.fsync", lambda descriptor: (_ for _ in ()).throw(OSError(28, "No space left on device")))
    wall.wait(1)
    wall.panel.save.bind()
    wait_for_saved(wall)
    file = tmp_path / "cradle_data_1.csv"
    text = f"{file}: cannot be written: No space left on device"
    assert wall.panel.saved.text == f'<span class="failed saved">{text}</span>'
    assert os.listdir(tmp_path) == ["cradle.csv"]
    time = wall.time()
    wall.wait(1)
    assert wall.time() > time  # and the cradle swings on


# --- the texts -------------------------------------------------------------------------------------------------------


def test_the_readout(wall):
    wall.panel.pause.bind()
    wall.wait()
    wall.viewer.cradle.pend_list[0].update(theta=0.0, omega=3.0)
    wall.wait()
    start = G * R_PARAM * (1 - 3**0.5 / 2)  # J: 1 kg at 30 degrees
    percent = 100 * (3 * R_PARAM) ** 2 / 2 / start
    assert wall.percents() == [f"{percent:.1f} %", f"{percent:.1f} %", "0.0 %"]
    assert f'<span class="exact">{percent:.4f} %</span>' in wall.panel.readout.text
    assert wall.readout()["momentum"] == f"+{3 * R_PARAM:.3f} kg m/s &rarr;"


@pytest.mark.parametrize(
    ("omega", "text"), [(-3.0, "-{:.3f} kg m/s &larr;"), (0.0, "+{:.3f} kg m/s"), (1e6, "+{:.2e} kg m/s &rarr;")]
)
def test_the_momentum_has_the_arrow_of_its_sign(wall, omega, text):
    wall.panel.pause.bind()
    wall.wait()
    wall.viewer.cradle.pend_list[0].update(theta=0.0, omega=omega)
    wall.wait()
    assert wall.readout()["momentum"] == text.format(abs(omega) * R_PARAM)


def test_an_elastic_cradle_has_100_percent(single):
    for _ in range(50):
        single.wait(0.1)
        assert single.readout()["energy"] == "100.0 %"


def test_a_thousand_percent_is_not_counted(wall):
    wall.viewer.motion.start_energy = 1e-6 * wall.viewer.motion.start_energy
    wall.wait(0.1)
    assert wall.readout()["energy"] == "&gt; 999 %"


def test_a_cradle_at_rest_has_no_percentages_of_nothing(wall):
    set_slider(wall.panel.lifted, 0)
    wall.wait(1)
    assert wall.percents() == ["0.0 %", "0.0 %", "0.0 %"]


@pytest.mark.slow
def test_slow_motion_is_admitted(wall, monkeypatch):
    """The fast path is off, because a function has changed."""
    wall.wait(2)
    assert wall.readout()["t"].endswith(" s")
    tick = visualize_cradle_run.newton_cradle_tick

    def slow(*given, **rule):
        wall.now += wall.viewer.cradle.dt / 0.45
        tick(*given, **rule)

    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", slow)
    wall.wait(3)
    # Ticks take 0.75 of a frame, at 0.45 of real time; the frames of the test come on top of that.
    assert wall.readout()["t"].endswith(f" s x{0.75 * 0.45 / 1.75:.1f}")


@pytest.mark.parametrize(("cost", "at_once"), [(45e-6, False), (55e-6, True)])
def test_ticks_are_done_at_once_only_where_single_ones_are_too_slow(wall, monkeypatch, cost, at_once):
    """A tick must not take longer than half of 0.1 ms."""
    tick, single = visualize_cradle_run.newton_cradle_tick, []

    def slow(*given, **rule):
        wall.now += cost
        single.append(given)
        tick(*given, **rule)

    many = wall.viewer.cradle.many_ticks

    def many_ticks(scope, *given):  # the fast path sees the shipped function
        return many({**scope, "newton_cradle_tick": tick}, *given)

    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", slow)
    monkeypatch.setattr(wall.viewer.cradle, "many_ticks", many_ticks)
    wall.viewer.try_single_ticks()
    wall.wait(1)
    assert wall.viewer.at_once == at_once
    single.clear()
    wall.wait(0.5)
    assert bool(single) == (not at_once)
    set_slider(wall.panel.speed, 0.5)  # at half the speed they are fast enough
    wall.wait(1)
    assert not wall.viewer.at_once
    assert len(single) > 0.4 / DT


def test_a_call_that_costs_more_than_a_frame_does_the_ticks_to_the_next_sample(wall, monkeypatch):
    """As with a thousand pendula: the cost of the call is no reason to do one tick in a frame."""
    many, calls = wall.viewer.cradle.many_ticks, []

    def dear(scope, pend_list, ticks, rule):
        wall.now += 2 * FRAME
        calls.append(ticks)
        return many(scope, pend_list, ticks, rule)

    monkeypatch.setattr(wall.viewer.cradle, "many_ticks", dear)
    wall.wait(1)
    frames = round(1 / FRAME)
    assert len(calls) < frames + 3
    assert calls[-frames + 3 :] == [round(EVERY / DT)] * (frames - 3)


def test_the_contact_strip(wall):
    wall.wait(0.9 * PERIOD)
    lines = re.sub("<.*?>", "", wall.panel.impacts.text).splitlines()
    assert lines[0] == "Impacts"
    assert re.fullmatch(r"t = \d\.\d\d s  5-4-3-2-1", lines[1])
    assert lines[-1] == f"t = {wall.viewer.motion.trains.trains[0].begin:.2f} s  1-2-3-4-5"
    assert wall.viewer.motion.trains.trains[0].begin == pytest.approx(PERIOD / 4, rel=0.05)


def test_the_contact_strip_where_hits_come_from_both_sides(wall):
    wall.panel.pause.bind()
    wall.wait()
    wall.viewer.cradle.pend_list[4]["theta"] = -wall.thetas()[0] * 1.001
    wall.panel.pause.bind()
    wall.wait(0.4 * PERIOD)
    assert re.search(r"t = \d\.\d\d s  (1-2-3-4-5  5-4-3-2-1|5-4-3-2-1  1-2-3-4-5)", wall.panel.impacts.text)


def over_the_top(wall):
    """Let the first bob fall to the right from nearly straight up, as if someone had dragged it over the top."""
    wall.viewer.cradle.pend_list[0]["theta"] = 0.9 * pi


def test_a_note_says_that_a_bob_swings_through_others(wall):
    """It stays until the restart."""
    assert "neighbours" not in wall.panel.impacts.text
    over_the_top(wall)
    wall.wait(PERIOD)
    assert "only neighbours collide" in wall.panel.impacts.text
    wall.viewer.cradle.pend_list[0]["theta"] = 0.0
    wall.wait(0.1)
    assert "neighbours" in wall.panel.impacts.text
    wall.panel.restart.bind()
    wall.wait()
    assert "neighbours" not in wall.panel.impacts.text


@pytest.mark.parametrize("lifted", [1, 3, 5])
@pytest.mark.parametrize("angle", [45, 120, 179])
def test_there_is_no_such_note_while_the_bobs_keep_their_order(csv, angle, lifted):
    wall = Wall(csv, angle)
    wall.press(str(lifted))
    wall.wait(PERIOD)
    assert "neighbours" not in wall.panel.impacts.text


def test_there_is_no_such_note_for_a_double_cradle(csv):
    wall = Wall(csv, 30, 10, kind=LiveDoubleCradle)
    over_the_top(wall)
    wall.wait(0.5)
    assert "neighbours" not in wall.panel.impacts.text


def test_what_has_not_changed_is_not_sent_again(wall):
    """Otherwise, a person could not select it."""
    wall.panel.pause.bind()
    wall.wait(0.5)
    texts = [wall.panel.readout, wall.panel.impacts, wall.panel.error, wall.panel.speed.text]
    before = [id(text.text) for text in texts]
    wall.wait(1)
    assert [id(text.text) for text in texts] == before


# --- the view --------------------------------------------------------------------------------------------------------


def test_a_resized_canvas_is_filled(wall):
    """The view is the same as for a cradle with this size from the start."""
    scene.width, scene.height = 300, 420
    scene.bound["resize"]()
    wall.wait()
    resized = scene.range
    wall.viewer.scenery.room = None
    wall.press("r")
    assert scene.range == resized


def test_the_view_is_reset_with_a_button_and_a_key(wall):
    for reset in (wall.panel.view.bind, lambda: wall.press("v")):
        scene.forward, scene.range = vector(0, 0, -1), 1.5 * scene.range
        reset()
        wall.wait()
        assert components(scene.forward) == components(FORWARD)
        assert scene.range == wall.viewer.scenery.home[1]


def test_a_view_far_away_comes_back_by_itself(wall):
    scene.range = 1e3
    wall.wait()
    assert scene.range < 10


def test_a_page_that_was_loaded_again_shows_the_first_view_and_restarts(wall):
    wall.wait(1)
    first = (components(scene.forward), components(scene.center), scene.range)
    scene.forward, scene.center, scene.range = vector(1, 0, -1), vector(1, 1, 1), 5
    wall.viewer.give(Command.SHOW_AGAIN)
    wall.wait()
    assert (components(scene.forward), components(scene.center), scene.range) == first
    assert wall.time() == 0


def test_a_swing_above_the_frame_is_in_view_until_the_bobs_start_anew(wall):
    scene.width, scene.height = 1000, 400
    scene.bound["resize"]()
    wall.wait()
    near = scene.range
    set_slider(wall.panel.angles[0], 150)
    wall.wait()
    assert scene.range > 1.2 * near
    set_slider(wall.panel.angles[0], 45)
    wall.wait()
    assert scene.range == near


def test_the_panel_says_what_the_keys_do_and_what_the_handouts_rule_does(monkeypatch, csv):
    texts = []
    monkeypatch.setattr("support.page.widgets.wtext", lambda text="": texts.append(text) or wtext(text=text))
    Wall(csv)
    said = re.sub("<.*?>", "", " ".join(texts))
    assert "1 to 9 lift that many bobs, V resets the view, F presents. Drag a bob." in said
    assert "The handout lets two bobs collide in each tick in which they touch" in said


def test_a_remark_stands_above_the_widgets(monkeypatch, csv):
    texts = []
    monkeypatch.setattr("support.page.panel.wtext", lambda text="": texts.append(text) or wtext(text=text))
    Wall(csv, remark="Write next: <main>.")
    assert '<div class="remark" role="note">Write next: &lt;main&gt;.</div>' in texts
    texts.clear()
    Wall(csv)
    assert not [text for text in texts if "remark" in text]


def test_the_page_says_that_the_program_has_ended(wall):
    wall.viewer.end("NameError: name '<b>' is not defined (src/swinging.py, line 17)")
    assert re.sub("<.*?>", "", wall.panel.error.text) == (
        "The program has ended. NameError: name &#x27;&lt;b&gt;&#x27; is not defined (src/swinging.py, line 17)"
    )


def test_numbers_change_ten_times_a_second(wall):
    """The graph too; not with each picture, because nobody could read that."""
    seen = []
    for _ in range(60):
        wall.now += FRAME
        go_on(wall.viewer, wall.viewer.frame())
        seen.append((wall.panel.readout.text, wall.viewer.graph.curves["total"].data))
    assert 8 <= sum(now[0] != before[0] and now[1] != before[1] for before, now in pairwise(seen)) <= 10
