"""The double cradle of the programs: releasing, holding, dragging, recording."""

from collections import defaultdict
from itertools import pairwise, product
from math import copysign, radians

import pytest
from programs import slow_but_for
from whole_cradles import components, distances, FIVE_CSV, GOOD, HEADER, PERIOD, Swing, thetas

from grading.cradles import MIXED_CSV
from src import visualize_double_cradle_run
from src.beyond.live_double_cradle import LiveDoubleCradle
from src.double_cradle import double_cradle_tick
from support import shapes
from support.constants import BUFFER, DOUBLE_DT, G, R_PARAM, THETA_INIT
from support.energy import double_kinetic_energy, double_momentum, double_potential_energy
from support.files.cradle_csv import Snapshot
from support.playback.player import GRIP

OUTWARDS = copysign(1, THETA_INIT)


@pytest.fixture
def live(tmp_path):
    """A function that returns the double cradle of this CSV, released from 30 and 20 degrees."""

    def live(text=FIVE_CSV, angles=(30, 20), lifted=1, **options):
        path = tmp_path / "cradle.csv"
        path.write_text(text)
        return Swing(Snapshot(path), angles, lifted, kind=LiveDoubleCradle, **options)

    return live


def values(player, key):
    return [pend[key] for pend in player.cradle.pend_list]


@pytest.mark.parametrize(("lifted", "expected"), [(0, 0), (2, 2), (9, 3)])
def test_release_lifts_both_cords_of_the_first_pendula_outwards(live, lifted, expected):
    player = live(MIXED_CSV)
    player.swing(500)
    player.cradle.release(thetas([30, -20]), lifted)
    for key, angle in (("theta", 30), ("phi", -20)):
        assert values(player, key) == pytest.approx([OUTWARDS * radians(angle)] * expected + [0] * (3 - expected))
    for key in ("omega", "phi_omega"):
        assert values(player, key) == [0, 0, 0]


INTO_OTHERS = product([1, 2], [(45, -120), (0, -14), (0, -20), (10, -40), (30, -110)])


@pytest.mark.parametrize(("lifted", "angles"), slow_but_for([(1, (0, -14)), (2, (10, -40))], INTO_OTHERS))
def test_a_release_into_those_that_hang_pushes_them_aside(live, lifted, angles):
    """Otherwise, inelastic bobs would jump apart."""
    player = live(inelastic=True)
    player.cradle.release(thetas(angles), lifted)
    assert min(distances(player.cradle.pend_list)) > 0.98
    least = sum(player.cradle.energies())
    for _ in range(100):
        player.swing(40)
        assert sum(player.cradle.energies()) <= least * (1 + 1e-6)
        least = min(least, sum(player.cradle.energies()))


def test_a_pendulum_that_pushes_others_aside_is_itself_where_it_was_to_be(live):
    player = live()
    player.cradle.release(thetas([0, -20]), 1)
    assert values(player, "phi")[0] == pytest.approx(OUTWARDS * radians(-20))
    assert any(values(player, "phi")[1:])


def test_bobs_and_cords_are_those_of_each_pendulum_from_above(live):
    player = live()
    objects = [pend["objects"] for pend in player.cradle.pend_list]
    assert player.cradle.axles() == [five[0] for five in objects]
    assert player.cradle.bobs() == [bob for five in objects for bob in (five[1], five[3])]
    assert player.cradle.cords() == [cord for five in objects for cord in (five[2], five[4])]
    assert player.cradle.thetas() == values(player, "theta")
    cradle = player.cradle
    lowest = max(axle.pos.y - bob.pos.y for axle, bob in zip(cradle.axles()[1:], cradle.bobs()[3::2], strict=True))
    assert lowest == pytest.approx(cradle.reach)


def test_the_options_change_the_cradle(live):
    player = live(MIXED_CSV, e=0.25, mass=2.0)
    assert (values(player, "e"), values(player, "mass")) == ([0.25] * 3, [2.0] * 3)


@pytest.mark.parametrize("approaching_only", [True, False])
def test_ticks_are_those_of_the_double_cradle_and_the_hits_are_noted(live, approaching_only):
    player, same = live(e=0.8), live(e=0.8)
    player.separating = not approaching_only
    ticks = round(0.6 * PERIOD / DOUBLE_DT)
    player.swing(ticks)
    for _ in range(ticks):
        double_cradle_tick(same.cradle.pend_list, R_PARAM, DOUBLE_DT, G, approaching_only)
    assert values(player, "phi") == values(same, "phi")
    assert player.motion.trains.trains[0].runs[0][:2] == [1, 2]


@pytest.mark.parametrize(("theta", "phi"), [(30, 0), (30, 40), (60, -50), (10, 120)])
def test_the_speed_of_a_hit_is_that_at_which_the_nearest_bobs_approach_each_other(live, theta, phi):
    player = live(HEADER + GOOD * 2, angles=(theta, phi))
    left, right = player.cradle.pend_list
    gaps = [distances([left, right])]
    while not player.motion.fastest:
        player.swing(1)
        gaps.append(distances([left, right]))
    shortest = min(range(4), key=gaps[-1].__getitem__)
    touching = BUFFER * 2 * left["objects"][1].radius
    closer = (gaps[-2][shortest] - gaps[-1][shortest]) * touching / DOUBLE_DT
    assert player.motion.take_fastest() == pytest.approx(closer, rel=0.01)


@pytest.mark.parametrize("bob", [2, 3])
def test_a_held_bob_stays_with_its_pendulum_and_throws_others_back(live, bob):
    player = live()
    player.cradle.hold(bob)
    masses = values(player, "mass")
    thrown_back = False
    for _ in range(100):
        player.swing(50)
        assert player.motion.trains.lines() == []
        assert (values(player, "theta")[1:], values(player, "phi")[1:]) == ([0.0] * 4, [0.0] * 4)
        thrown_back = thrown_back or double_momentum(player.cradle.pend_list[:1], R_PARAM) * OUTWARDS > 0.2
    assert thrown_back
    assert values(player, "mass") == masses


@pytest.mark.parametrize("bob", [8, 9])
def test_a_bob_is_dragged_let_go_and_swings_on_with_no_speed(live, bob):
    player = live()
    player.cradle.release([0, 0], 0)
    player.cradle.hold(bob)
    axle = player.cradle.axles()[4].pos
    player.cradle.drag(bob, axle.x + 3, axle.y - 3)
    cords = 1 if bob == 8 else 2
    at = (cords * R_PARAM * 0.5**0.5, -cords * R_PARAM * 0.5**0.5, 0)
    assert components(player.cradle.bobs()[bob].pos - axle) == pytest.approx(at)
    player.swing(100)
    assert components(player.cradle.bobs()[bob].pos - axle) == pytest.approx(at)
    player.cradle.let_go()
    assert (values(player, "omega")[4], values(player, "phi_omega")[4]) == (0, 0)
    player.swing(100)
    assert player.cradle.bobs()[bob].pos.x - axle.x < at[0]


def test_the_others_swing_on_as_fast_while_a_bob_is_held(live):
    player, same = live(), live()
    player.cradle.hold(9)
    for one in (player, same):
        one.swing(405)  # no multiple of GRIP
    assert values(player, "theta")[0] == values(same, "theta")[0]


def test_separating_bobs_collide_too_while_another_is_held_if_they_are_to(live):
    omegas = []
    for approaching_only in (True, False):
        player = live(e=0.5)
        player.cradle.hold(9)
        player.separating = not approaching_only
        player.swing(round(0.45 * PERIOD / DOUBLE_DT))
        omegas.append(values(player, "omega")[1])
    assert omegas[0] != omegas[1]


def test_a_raised_bob_that_is_held_is_put_back_every_few_ticks(live, monkeypatch):
    player = live()
    player.cradle.hold(0)
    tick, starts = visualize_double_cradle_run.double_cradle_tick, []

    def watched(pend_list, *arguments, **rule):
        starts.append((pend_list[0]["theta"], pend_list[0]["phi"]))
        tick(pend_list, *arguments, **rule)

    monkeypatch.setattr(visualize_double_cradle_run, "double_cradle_tick", watched)
    player.swing(64)
    assert len(starts) == 64
    assert set(starts[::GRIP]) == {starts[0]}


def test_a_bob_that_is_held_has_no_speed(live):
    player = live()
    player.swing(300)
    assert player.cradle.pend_list[0]["phi_omega"] != 0
    player.cradle.hold(1)
    assert (player.cradle.pend_list[0]["omega"], player.cradle.pend_list[0]["phi_omega"]) == (0, 0)


def test_a_reload_lets_go(live):
    player = live()
    player.cradle.hold(9)
    player.read(player.snapshot)
    assert player.cradle.held is None


def test_the_axles_are_a_quarter_of_a_cord_apart(live):
    x = [axle.pos.x for axle in live().cradle.axles()]
    assert [b - a for a, b in pairwise(x)] == pytest.approx([R_PARAM / 4] * 4)


def test_what_is_shown_and_recorded(live):
    player = live(MIXED_CSV)
    player.swing(2000)  # until all had a hit
    pend_list = player.cradle.pend_list
    energies = double_kinetic_energy(pend_list, R_PARAM), double_potential_energy(pend_list, R_PARAM, G)
    assert player.cradle.energies() == energies
    assert player.cradle.momentum() == double_momentum(pend_list, R_PARAM)
    names = [f"{key}_{i}" for key in ("theta", "phi", "omega", "phi_omega") for i in (1, 2, 3)]
    assert list(player.cradle.coordinates()) == names
    assert player.cradle.coordinates()["phi_omega_3"] == pend_list[2]["phi_omega"]


def test_a_reload_uses_the_old_shapes_again(live, tmp_path, monkeypatch):
    monkeypatch.setattr(shapes, "discarded", defaultdict(list))
    player = live()
    old = {id(shape) for pend in player.cradle.pend_list for shape in pend["objects"]}
    (tmp_path / "cradle.csv").write_text(MIXED_CSV)
    player.read(Snapshot(tmp_path / "cradle.csv"))
    assert all(shape.visible for pend in player.cradle.pend_list for shape in pend["objects"])
    new = {id(shape) for pend in player.cradle.pend_list for shape in pend["objects"]}
    assert new < old
