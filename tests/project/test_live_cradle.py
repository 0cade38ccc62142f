"""The cradle as the viewer plays with it: options, reloading, releasing, holding."""

from collections import defaultdict
from math import radians
from types import SimpleNamespace

import pytest
from cradles import MIXED_CSV
from vpython import vector
from whole_cradles import components, FIVE_CSV, GOOD, HEADER, PERIOD

from src.live_cradle import LiveCradle
from src.visualize_cradle_run import advance_cradle, newton_cradle_tick
from support import shapes
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.cradle_csv import Snapshot


@pytest.fixture
def csv(tmp_path):
    """A function that returns a Snapshot of a CSV with this text."""

    def csv(text):
        path = tmp_path / "cradle.csv"
        path.write_text(text)
        return Snapshot(path)

    return csv


def live(csv, **options):
    """Return the cradle of this CSV with these options, let go from 30 degrees."""
    none = {"elastic": False, "inelastic": False, "e": None, "mass": None}
    cradle = LiveCradle(advance_cradle, SimpleNamespace(**{**none, **options}))
    cradle.load(csv)
    cradle.release([30], 1)
    return cradle


def values(cradle, key):
    return [pend[key] for pend in cradle.pend_list]


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
    cradle = live(snapshot, **options)
    assert (values(cradle, "e"), values(cradle, "mass")) == (e, mass)
    assert Snapshot(snapshot.filepath).data == MIXED_CSV.encode()


def test_collisions_can_be_changed_in_full_swing_and_survive_a_reload(csv):
    cradle = live(csv(MIXED_CSV), e=0.25)
    cradle.advance(100, True)
    thetas, as_in_csv = values(cradle, "theta"), next(iter(cradle.collisions))
    es = []
    for collision in cradle.collisions:
        cradle.collide(collision)
        es.append(values(cradle, "e"))
    assert es == [[0.9, 0.8, 0.7], [1, 1, 1], [0, 0, 0], [0.25, 0.25, 0.25]]
    assert values(cradle, "theta") == thetas
    cradle.load(csv(FIVE_CSV))
    assert values(cradle, "e") == [0.25] * 5
    cradle.collide(as_in_csv)
    assert values(cradle, "e") == [1.0] * 5


@pytest.mark.parametrize(("lifted", "expected"), [(0, 0), (1, 1), (2, 2), (3, 3), (9, 3)])
def test_release_lifts_the_first_bobs_outwards_and_all_are_at_rest(csv, lifted, expected):
    cradle = live(csv(MIXED_CSV))
    cradle.advance(500, True)
    cradle.release([30], lifted)
    theta = radians(30) * (-1 if THETA_INIT < 0 else 1)
    assert values(cradle, "theta") == pytest.approx([theta] * expected + [0] * (3 - expected))
    assert values(cradle, "omega") == [0, 0, 0]
    for axle, bob, theta in zip(cradle.axles(), cradle.bobs(), values(cradle, "theta"), strict=True):
        arm = vector(0, -R_PARAM, 0).rotate(theta)
        assert components(bob.pos - axle.pos) == pytest.approx(components(arm))


def test_advance_ticks_and_tells_of_contacts(csv):
    """As many ticks of newton_cradle_tick, at the shipped constants."""
    cradle, same = live(csv(FIVE_CSV)), live(csv(FIVE_CSV))
    ticks = round(0.3 * PERIOD / DT)
    contacts = cradle.advance(ticks, True)
    for _ in range(ticks):
        newton_cradle_tick(same.pend_list, R_PARAM, DT, G, approaching_only=True)
    assert [pair for _, *pair in contacts] == [[0, 1], [1, 2], [2, 3], [3, 4]]
    assert values(cradle, "theta") == values(same, "theta")


def test_a_reload_takes_new_pendula_of_the_old_shapes(csv, monkeypatch):
    monkeypatch.setattr(shapes, "discarded", defaultdict(list))
    cradle = live(csv(FIVE_CSV))
    old = {id(shape) for pend in cradle.pend_list for shape in pend["objects"]}
    cradle.load(csv(HEADER + "2,0.5,0,0,blue,wood\n" * 2))
    new = {id(shape) for pend in cradle.pend_list for shape in pend["objects"]}
    assert len(cradle.axles()) == len(cradle.bobs()) == 2
    assert new < old
    left = [shape for kind in shapes.discarded.values() for shape in kind]
    assert len(left) == 3 * 3
    assert not any(shape.visible for shape in left)
    assert values(cradle, "mass") == [2, 2]


def test_a_bad_file_leaves_the_cradle_as_it_was(csv):
    cradle = live(csv(FIVE_CSV))
    cradle.advance(100, True)
    pend_list, thetas = cradle.pend_list, values(cradle, "theta")
    with pytest.raises(ValueError, match="cradle.csv, line 7, column mass: found 'x', allowed is a number above 0"):
        cradle.load(csv(FIVE_CSV + GOOD.replace("1.0", "x", 1)))
    assert cradle.pend_list is pend_list
    assert values(cradle, "theta") == thetas
    assert all(bob.visible for bob in cradle.bobs())


def test_after_a_bad_file_the_collisions_of_the_good_one_can_be_chosen(csv):
    cradle = live(csv(FIVE_CSV))
    with pytest.raises(ValueError, match="found 'x'"):
        cradle.load(csv(HEADER + GOOD.replace("1.0", "x", 1)))
    cradle.collide("inelastic, e = 0")
    assert values(cradle, "e") == [0] * 5


@pytest.mark.parametrize("approaching_only", [False, True])
def test_a_held_bob_stays_and_throws_others_back(csv, approaching_only):
    cradle = live(csv(FIVE_CSV))
    cradle.hold(1)
    axle, bob = cradle.axles()[1], cradle.bobs()[1]
    cradle.drag(1, axle.pos.x + 1, axle.pos.y - 1)
    assert values(cradle, "theta")[1] == pytest.approx(radians(45))
    rest = components(bob.pos)
    cradle.release([30], 1)
    cradle.hold(1)
    masses, energy = values(cradle, "mass"), sum(cradle.energies())
    hit = False
    for _ in range(round(0.5 * PERIOD / DT / 100)):
        assert cradle.advance(100, approaching_only) == []
        hit = hit or cradle.pend_list[0]["omega"] < 0 < energy
        assert values(cradle, "theta")[1:] == [0, 0, 0, 0]
    assert hit  # it came back as from a wall
    assert sum(cradle.energies()) == pytest.approx(energy, rel=0.01)
    assert values(cradle, "mass") == masses
    assert components(bob.pos) != rest


def test_a_bob_that_is_held_has_no_speed(csv):
    """However fast it was when it was taken, paused or not."""
    cradle = live(csv(FIVE_CSV))
    cradle.advance(1000, True)
    assert cradle.pend_list[0]["omega"] != 0
    cradle.hold(0)
    assert cradle.pend_list[0]["omega"] == 0


def test_velocities_and_momentum_are_those_to_the_right(csv):
    """At 60 degrees half of what goes along the arc, and below 0 to the left."""
    cradle = live(csv(FIVE_CSV))
    cradle.pend_list[0].update(theta=radians(60), omega=-2.0)
    assert cradle.velocities() == pytest.approx([-R_PARAM, 0, 0, 0, 0])
    assert cradle.momentum() == pytest.approx(-R_PARAM)


def test_thetas_and_cords_are_those_from_left_to_right(csv):
    cradle = live(csv(FIVE_CSV))
    assert cradle.thetas() == values(cradle, "theta")
    assert cradle.cords() == [pend["objects"][2] for pend in cradle.pend_list]


def test_a_bob_that_is_let_go_swings_from_where_it_is_with_no_speed(csv):
    cradle = live(csv(FIVE_CSV))
    cradle.release([0], 0)
    cradle.hold(4)
    axle = cradle.axles()[4].pos
    cradle.drag(4, axle.x + 3, axle.y)  # along its arc, however far away the mouse is
    cradle.let_go()
    assert (values(cradle, "theta")[4], values(cradle, "omega")[4]) == (pytest.approx(radians(90)), 0)
    cradle.advance(100, True)
    assert 0 < values(cradle, "theta")[4] < radians(90)
