"""The cradle of the programs: options, reloading, releasing, holding, and the functions that make and move it."""

import re
from collections import defaultdict
from math import radians

import pytest
from vpython import vector
from whole_cradles import components, FIVE_CSV, GOOD, HEADER, PERIOD, Swing, thetas

from grading.cradles import MIXED_CSV
from src import visualize_cradle_run
from src.beyond.dragging import move
from src.visualize_cradle_run import newton_cradle_tick
from support import shapes
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.files.cradle_csv import Snapshot
from support.playback.mistake import MistakeError


@pytest.fixture
def csv(tmp_path):
    """A function that returns a Snapshot of a CSV with this text."""

    def csv(text):
        path = tmp_path / "cradle.csv"
        path.write_text(text)
        return Snapshot(path)

    return csv


def live(csv, angle=30, lifted=1, **options):
    """Return a player with the cradle of this CSV and these options, released from 30 degrees."""
    return Swing(csv, [angle], lifted, **options)


def values(player, key):
    return [pend[key] for pend in player.cradle.pend_list]


@pytest.mark.parametrize(
    ("options", "e", "mass"),
    [
        ({}, [0.9, 0.8, 0.7], [1.5, 2.5, 0.5]),
        ({"elastic": True}, [1, 1, 1], [1.5, 2.5, 0.5]),
        ({"inelastic": True, "mass": 2.0}, [0, 0, 0], [2.0, 2.0, 2.0]),
        ({"e": 0.25}, [0.25, 0.25, 0.25], [1.5, 2.5, 0.5]),
    ],
)
def test_the_options_change_the_cradle_and_not_the_file(csv, options, e, mass):
    snapshot = csv(MIXED_CSV)
    player = live(snapshot, **options)
    assert (values(player, "e"), values(player, "mass")) == (e, mass)
    assert Snapshot(snapshot.filepath).data == MIXED_CSV.encode()


def test_collisions_can_be_changed_in_full_swing_and_survive_a_reload(csv):
    player = live(csv(MIXED_CSV), e=0.25)
    player.swing(100)
    thetas, cradle = values(player, "theta"), player.cradle
    es = []
    for collision in cradle.collisions:
        player.collide(collision)
        es.append(values(player, "e"))
    assert es == [[0.9, 0.8, 0.7], [1, 1, 1], [0, 0, 0], [0.25, 0.25, 0.25]]
    assert values(player, "theta") == thetas
    player.read(csv(FIVE_CSV))
    assert values(player, "e") == [0.25] * 5
    player.collide("as in the CSV")
    assert values(player, "e") == [1.0] * 5


@pytest.mark.parametrize(("lifted", "expected"), [(0, 0), (1, 1), (2, 2), (3, 3), (9, 3)])
def test_release_lifts_the_first_bobs_outwards_and_all_are_at_rest(csv, lifted, expected):
    player = live(csv(MIXED_CSV))
    player.swing(500)
    cradle = player.cradle
    cradle.release(thetas([30]), lifted)
    theta = radians(30) * (-1 if THETA_INIT < 0 else 1)
    assert values(player, "theta") == pytest.approx([theta] * expected + [0] * (3 - expected))
    assert values(player, "omega") == [0, 0, 0]
    for axle, bob, theta in zip(cradle.axles(), cradle.bobs(), values(player, "theta"), strict=True):
        arm = vector(0, -R_PARAM, 0).rotate(theta)
        assert components(bob.pos - axle.pos) == pytest.approx(components(arm))


def test_ticks_are_those_of_the_handout_and_the_hits_are_noted(csv):
    """Same result as `ticks` calls of newton_cradle_tick with the shipped constants."""
    player, same = live(csv(FIVE_CSV)), live(csv(FIVE_CSV))
    ticks = round(0.3 * PERIOD / DT)
    player.swing(ticks)
    for _ in range(ticks):
        newton_cradle_tick(same.cradle.pend_list, R_PARAM, DT, G, approaching_only=True)
    assert [*map(str, player.motion.trains.trains)] == ["1-2-3-4-5"]
    assert values(player, "theta") == values(same, "theta")


def test_a_restart_makes_each_pendulum_of_its_own_shapes(csv):
    """The page keeps the objects of each bob, even if a different cradle came between."""
    player = live(csv(FIVE_CSV))
    before = [pend["objects"] for pend in player.cradle.pend_list]
    player.read(csv(HEADER + GOOD * 2))
    player.read(csv(FIVE_CSV))
    assert [pend["objects"] for pend in player.cradle.pend_list] == before


def test_a_reload_takes_new_pendula_of_the_old_shapes(csv, monkeypatch):
    monkeypatch.setattr(shapes, "discarded", defaultdict(list))
    player = live(csv(FIVE_CSV))
    old = {id(shape) for pend in player.cradle.pend_list for shape in pend["objects"]}
    player.read(csv(HEADER + "2,0.5,0,0,blue,wood\n" * 2))
    new = {id(shape) for pend in player.cradle.pend_list for shape in pend["objects"]}
    assert len(player.cradle.axles()) == len(player.cradle.bobs()) == 2
    assert new < old
    left = [shape for kind in shapes.discarded.values() for shape in kind]
    assert len(left) == 3 * 3
    assert not any(shape.visible for shape in left)
    assert values(player, "mass") == [2, 2]


@pytest.mark.parametrize(
    ("bob", "angle", "through"),
    [(0, -90, False), (0, 20, False), (0, 45, True), (0, 100, False), (4, -45, True), (4, -100, False)],
)
def test_a_bob_swings_through_others_if_it_is_on_the_wrong_side_of_one_that_is_no_neighbour(csv, bob, angle, through):
    """Not above the axles, where it comes over the top."""
    cradle = live(csv(FIVE_CSV), lifted=0).cradle
    move(cradle.pend_list[bob], [radians(angle)], R_PARAM)
    assert cradle.swings_through() == through


# --- the first picture -----------------------------------------------------------------------------------------------


def made_otherwise(monkeypatch, change):
    """Replace make_newton_cradle: it calls change(pend_list) on each new cradle."""
    make = visualize_cradle_run.make_newton_cradle

    def make_newton_cradle(*given):
        pend_list = make(*given)
        return change(pend_list) or pend_list

    monkeypatch.setattr(visualize_cradle_run, "make_newton_cradle", make_newton_cradle)


def test_what_make_newton_cradle_made_is_seen_first(csv, monkeypatch):
    made_otherwise(monkeypatch, lambda pend_list: pend_list[1].update(theta=0.25, omega=-2.0))
    player = live(csv(FIVE_CSV), None, None)
    assert values(player, "theta") == [THETA_INIT, 0.25, 0, 0, 0]
    assert values(player, "omega") == [0, -2.0, 0, 0, 0]
    assert player.cradle.as_made() == ([pytest.approx(THETA_INIT)], 2)


@pytest.mark.parametrize(
    ("angle", "lifted", "degrees_"), [(20, None, [20, 20, 0]), (None, 3, [10, 10, 10]), (5, 1, [5, 0, 0])]
)
def test_an_angle_or_a_number_that_is_set_takes_its_place(csv, monkeypatch, angle, lifted, degrees_):
    """The other value stays as make_newton_cradle made it: two bobs at 10 degrees."""

    def change(pend_list):
        for pend in pend_list[:2]:
            pend["theta"] = radians(10) * (-1 if THETA_INIT < 0 else 1)

    made_otherwise(monkeypatch, change)
    player = live(csv(MIXED_CSV), angle, lifted)
    assert [abs(theta) for theta in values(player, "theta")] == pytest.approx([radians(angle) for angle in degrees_])


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda pend_list: pend_list.clear(), "returned an empty list; a cradle has at least one pendulum."),
        (lambda pend_list: tuple(pend_list), "returned a tuple; it must return a list of dictionaries."),
        (lambda pend_list: ["pendulum"], "returned a list; it must return a list of dictionaries."),
        (lambda pend_list: pend_list[1].update(theta="0"), "set theta of pendulum 2 to '0'; it must be a number."),
        (lambda pend_list: pend_list[4].pop("omega") and None, "set omega of pendulum 5 to nothing; it must be"),
        (
            lambda pend_list: pend_list[0].update(objects=[]),
            "set objects of pendulum 1 to a list; it must be a tuple of parts.",
        ),
    ],
)
def test_what_is_no_cradle_is_told_of_by_the_function_that_made_it(csv, monkeypatch, change, words):
    made_otherwise(monkeypatch, change)
    with pytest.raises(MistakeError, match=f"^make_newton_cradle {re.escape(words)}"):
        live(csv(FIVE_CSV))


def test_a_missing_return_is_told_of(csv, monkeypatch):
    monkeypatch.setattr(visualize_cradle_run, "make_newton_cradle", lambda *given: None)
    with pytest.raises(MistakeError, match="returned None; it must return a list of dictionaries. Is a return miss"):
        live(csv(FIVE_CSV))


@pytest.mark.parametrize("value", [None, float("nan"), (1, 2), "0.5"])
def test_a_tick_that_leaves_no_number_is_told_of(csv, monkeypatch, value):
    def newton_cradle_tick(pend_list, r_param, dt, g):
        pend_list[2]["omega"] = value

    monkeypatch.setattr(visualize_cradle_run, "newton_cradle_tick", newton_cradle_tick)
    player = live(csv(FIVE_CSV))
    words = f"newton_cradle_tick set omega of pendulum 3 to {value!r}; it must be a finite number."
    with pytest.raises(MistakeError, match=re.escape(words)):
        player.swing(1)


# --- the rule --------------------------------------------------------------------------------------------------------


def test_functions_with_the_handouts_own_parameters_work(csv, monkeypatch):
    """main passes no approaching_only if one of the two functions does not take it."""
    tick, meet = visualize_cradle_run.newton_cradle_tick, visualize_cradle_run.handle_two_bobs
    player = live(csv(FIVE_CSV))
    assert (player.cradle.takes_rule, player.separating, player.rule) == (True, False, {"approaching_only": True})
    by_the_handout = live(csv(FIVE_CSV))
    by_the_handout.separating = True
    by_the_handout.swing(5000)
    for name, function in [
        ("newton_cradle_tick", lambda pend_list, r_param, dt, g: tick(pend_list, r_param, dt, g)),
        ("handle_two_bobs", lambda pend1, pend2, r_param: meet(pend1, pend2, r_param)),
    ]:
        with monkeypatch.context() as patches:
            patches.setattr(visualize_cradle_run, name, function)
            player = live(csv(FIVE_CSV))
            assert (player.cradle.takes_rule, player.separating, player.rule) == (False, True, {})
            player.swing(5000)
            assert values(player, "theta") == values(by_the_handout, "theta")
            assert player.motion.trains.lines() == by_the_handout.motion.trains.lines()


def test_a_train_is_noted_though_it_leaves_the_inner_bobs_as_they_were(csv):
    """In one tick, an equal bob in the middle gets its old velocity back."""
    player = live(csv(FIVE_CSV), lifted=0)
    for bob in player.cradle.bobs():
        bob.radius *= 1.01
    player.cradle.pend_list[0]["omega"] = 2.0
    player.swing(1)
    assert values(player, "omega") == pytest.approx([0, 0, 0, 0, 2.0], abs=1e-9)
    assert [*map(str, player.motion.trains.trains)] == ["1-2-3-4-5"]


def test_the_functions_are_themselves_again_after_the_ticks(csv):
    meet = visualize_cradle_run.handle_two_bobs
    player = live(csv(FIVE_CSV))
    player.swing(10)
    assert visualize_cradle_run.handle_two_bobs is meet


# --- holding ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("approaching_only", [False, True])
def test_a_held_bob_stays_and_throws_others_back(csv, approaching_only):
    player = live(csv(FIVE_CSV))
    player.separating = not approaching_only
    cradle = player.cradle
    cradle.hold(1)
    axle, bob = cradle.axles()[1], cradle.bobs()[1]
    cradle.drag(1, axle.pos.x + 1, axle.pos.y - 1)
    assert values(player, "theta")[1] == pytest.approx(radians(45))
    rest = components(bob.pos)
    cradle.release(thetas([30]), 1)
    cradle.hold(1)
    masses, energy = values(player, "mass"), sum(cradle.energies())
    hit = False
    for _ in range(round(0.5 * PERIOD / DT / 100)):
        player.swing(100)
        assert player.motion.trains.lines() == []
        hit = hit or cradle.pend_list[0]["omega"] < 0 < energy
        assert values(player, "theta")[1:] == [0, 0, 0, 0]
    assert hit  # it came back, as from a wall
    assert sum(cradle.energies()) == pytest.approx(energy, rel=0.01)
    assert values(player, "mass") == masses
    assert components(bob.pos) != rest


def test_a_bob_that_is_held_has_no_speed(csv):
    """At every speed before, paused or not."""
    player = live(csv(FIVE_CSV))
    player.swing(1000)
    cradle = player.cradle
    assert cradle.pend_list[0]["omega"] != 0
    cradle.hold(0)
    assert cradle.pend_list[0]["omega"] == 0


def test_momentum_is_that_to_the_right(csv):
    """At 60 degrees, it is half of the momentum along the arc; to the left, it is negative."""
    cradle = live(csv(FIVE_CSV)).cradle
    cradle.pend_list[0].update(theta=radians(60), omega=-2.0)
    assert cradle.momentum() == pytest.approx(-R_PARAM)


def test_thetas_and_cords_are_those_from_left_to_right(csv):
    player = live(csv(FIVE_CSV))
    cradle = player.cradle
    assert cradle.thetas() == values(player, "theta")
    assert cradle.cords() == [pend["objects"][2] for pend in cradle.pend_list]


def test_a_bob_that_is_let_go_swings_from_where_it_is_with_no_speed(csv):
    player = live(csv(FIVE_CSV), lifted=0)
    cradle = player.cradle
    cradle.hold(4)
    axle = cradle.axles()[4].pos
    cradle.drag(4, axle.x + 3, axle.y)  # along its arc, even if the mouse is far away
    cradle.let_go()
    assert (values(player, "theta")[4], values(player, "omega")[4]) == (pytest.approx(radians(90)), 0)
    player.swing(100)
    assert 0 < values(player, "theta")[4] < radians(90)
