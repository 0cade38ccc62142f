"""The double cradle as the viewer plays with it: releasing, holding, dragging, what is recorded."""

from collections import defaultdict
from itertools import pairwise
from math import copysign, radians
from types import SimpleNamespace

import pytest
from cradles import MIXED_CSV
from whole_cradles import components, distances, FIVE_CSV, PERIOD

from src.double_cradle import double_cradle_tick
from src.live_double_cradle import LiveDoubleCradle
from support import shapes
from support.audit import double_kinetic_energy, double_momentum, double_potential_energy
from support.constants import DOUBLE_DT, G, R_PARAM, THETA_INIT
from support.cradle_csv import Snapshot

OUTWARDS = copysign(1, THETA_INIT)


@pytest.fixture
def live(tmp_path):
    """A function that returns the double cradle of this CSV, let go from 30 and 20 degrees."""

    def live(text=FIVE_CSV, **options):
        path = tmp_path / "cradle.csv"
        path.write_text(text)
        none = {"elastic": False, "inelastic": False, "e": None, "mass": None}
        cradle = LiveDoubleCradle(SimpleNamespace(**{**none, **options}))
        cradle.load(Snapshot(path))
        cradle.release([30, 20], 1)
        return cradle

    return live


def values(cradle, key):
    return [pend[key] for pend in cradle.pend_list]


@pytest.mark.parametrize(("lifted", "expected"), [(0, 0), (2, 2), (9, 3)])
def test_release_lifts_both_cords_of_the_first_pendula_outwards(live, lifted, expected):
    cradle = live(MIXED_CSV)
    cradle.advance(500, True)
    cradle.release([30, -20], lifted)
    for key, angle in (("theta", 30), ("phi", -20)):
        assert values(cradle, key) == pytest.approx([OUTWARDS * radians(angle)] * expected + [0] * (3 - expected))
    for key in ("omega", "phi_omega"):
        assert values(cradle, key) == [0, 0, 0]


@pytest.mark.parametrize(("theta", "phi"), [(45, -120), (0, -14), (0, -20), (10, -40), (30, -110)])
@pytest.mark.parametrize("lifted", [1, 2])
def test_a_release_into_those_that_hang_pushes_them_aside(live, theta, phi, lifted):
    """Inelastic, they would otherwise be thrown out of one another."""
    cradle = live(inelastic=True)
    cradle.release([theta, phi], lifted)
    assert min(distances(cradle.pend_list)) > 0.98
    least = sum(cradle.energies())
    for _ in range(100):
        cradle.advance(40, True)
        assert sum(cradle.energies()) <= least * (1 + 1e-6)
        least = min(least, sum(cradle.energies()))


def test_a_pendulum_that_pushes_others_aside_is_itself_where_it_was_to_be(live):
    cradle = live()
    cradle.release([0, -20], 1)
    assert values(cradle, "phi")[0] == pytest.approx(OUTWARDS * radians(-20))
    assert any(values(cradle, "phi")[1:])


def test_bobs_and_cords_are_those_of_each_pendulum_from_above(live):
    cradle = live()
    objects = [pend["objects"] for pend in cradle.pend_list]
    assert cradle.axles() == [five[0] for five in objects]
    assert cradle.bobs() == [bob for five in objects for bob in (five[1], five[3])]
    assert cradle.cords() == [cord for five in objects for cord in (five[2], five[4])]
    assert cradle.thetas() == values(cradle, "theta")
    lowest = max(axle.pos.y - bob.pos.y for axle, bob in zip(cradle.axles()[1:], cradle.bobs()[3::2], strict=True))
    assert lowest == pytest.approx(cradle.reach)


def test_the_options_change_the_cradle(live):
    cradle = live(MIXED_CSV, e=0.25, mass=2.0)
    assert (values(cradle, "e"), values(cradle, "mass")) == ([0.25] * 3, [2.0] * 3)


@pytest.mark.parametrize("approaching_only", [True, False])
def test_advance_ticks_and_tells_of_contacts(live, approaching_only):
    cradle, same = live(e=0.8), live(e=0.8)
    ticks = round(0.6 * PERIOD / DOUBLE_DT)
    contacts = cradle.advance(ticks, approaching_only)
    for _ in range(ticks):
        double_cradle_tick(same.pend_list, R_PARAM, DOUBLE_DT, G, approaching_only)
    assert values(cradle, "phi") == values(same, "phi")
    assert contacts[0][1:] == (0, 1)


@pytest.mark.parametrize("bob", [2, 3])
def test_a_held_bob_stays_with_its_pendulum_and_throws_others_back(live, bob):
    cradle = live()
    cradle.hold(bob)
    masses = values(cradle, "mass")
    thrown_back = False
    for _ in range(100):
        assert cradle.advance(50, True) == []
        assert (values(cradle, "theta")[1:], values(cradle, "phi")[1:]) == ([0.0] * 4, [0.0] * 4)
        thrown_back = thrown_back or cradle.velocities()[0] * OUTWARDS > 0.1
    assert thrown_back
    assert values(cradle, "mass") == masses


@pytest.mark.parametrize("bob", [8, 9])
def test_a_bob_is_dragged_let_go_and_swings_on_with_no_speed(live, bob):
    cradle = live()
    cradle.release([0, 0], 0)
    cradle.hold(bob)
    axle = cradle.axles()[4].pos
    cradle.drag(bob, axle.x + 3, axle.y - 3)
    cords = 1 if bob == 8 else 2
    at = (cords * R_PARAM * 0.5**0.5, -cords * R_PARAM * 0.5**0.5, 0)
    assert components(cradle.bobs()[bob].pos - axle) == pytest.approx(at)
    cradle.advance(100, True)
    assert components(cradle.bobs()[bob].pos - axle) == pytest.approx(at)
    cradle.let_go()
    assert (values(cradle, "omega")[4], values(cradle, "phi_omega")[4]) == (0, 0)
    cradle.advance(100, True)
    assert cradle.bobs()[bob].pos.x - axle.x < at[0]


def test_the_others_swing_on_as_fast_while_a_bob_is_held(live):
    cradle, same = live(), live()
    cradle.hold(9)
    for one in (cradle, same):
        one.advance(405, True)  # no multiple of GRIP
    assert values(cradle, "theta")[0] == values(same, "theta")[0]


def test_separating_bobs_collide_too_while_another_is_held_if_they_are_to(live):
    omegas = []
    for approaching_only in (True, False):
        cradle = live(e=0.5)
        cradle.hold(9)
        cradle.advance(round(0.45 * PERIOD / DOUBLE_DT), approaching_only)
        omegas.append(values(cradle, "omega")[1])
    assert omegas[0] != omegas[1]


def test_a_raised_bob_that_is_held_is_put_back_every_few_ticks(live):
    cradle = live()
    cradle.hold(0)
    advance, before = cradle.advance_pendula, []

    def watched(pend_list, *arguments):
        before.append((pend_list[0]["theta"], pend_list[0]["phi"]))
        return advance(pend_list, *arguments)

    cradle.advance_pendula = watched
    cradle.advance(64, True)
    assert len(before) == 7
    assert set(before) == {before[0]}


def test_a_bob_that_is_held_has_no_speed(live):
    cradle = live()
    cradle.advance(300, True)
    assert cradle.pend_list[0]["phi_omega"] != 0
    cradle.hold(1)
    assert (cradle.pend_list[0]["omega"], cradle.pend_list[0]["phi_omega"]) == (0, 0)


def test_a_reload_lets_go(live):
    cradle = live()
    cradle.hold(9)
    cradle.load(cradle.csv)
    assert cradle.held is None


def test_the_axles_are_a_quarter_of_a_cord_apart(live):
    x = [axle.pos.x for axle in live().axles()]
    assert [b - a for a, b in pairwise(x)] == pytest.approx([R_PARAM / 4] * 4)


def test_what_is_shown_and_recorded(live):
    cradle = live(MIXED_CSV)
    cradle.advance(2000, True)  # until all have been hit
    pend_list = cradle.pend_list
    energies = double_kinetic_energy(pend_list, R_PARAM), double_potential_energy(pend_list, R_PARAM, G)
    assert cradle.energies() == energies
    assert cradle.momentum() == double_momentum(pend_list, R_PARAM)
    by_pendulum = [2 * pend["mass"] * v for pend, v in zip(pend_list, cradle.velocities(), strict=True)]
    assert sum(by_pendulum) == pytest.approx(cradle.momentum())
    names = [f"{key}_{i}" for key in ("theta", "phi", "omega", "phi_omega") for i in (1, 2, 3)]
    assert list(cradle.coordinates()) == names
    assert cradle.coordinates()["phi_omega_3"] == pend_list[2]["phi_omega"]


def test_a_reload_uses_the_old_shapes_again(live, tmp_path, monkeypatch):
    monkeypatch.setattr(shapes, "discarded", defaultdict(list))
    cradle = live()
    old = {id(shape) for pend in cradle.pend_list for shape in pend["objects"]}
    (tmp_path / "cradle.csv").write_text(MIXED_CSV)
    cradle.load(Snapshot(tmp_path / "cradle.csv"))
    assert all(shape.visible for pend in cradle.pend_list for shape in pend["objects"])
    new = {id(shape) for pend in cradle.pend_list for shape in pend["objects"]}
    assert new < old
