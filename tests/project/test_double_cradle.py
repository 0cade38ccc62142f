"""The double cradle: its objects, its laws of motion, and its hits; test_requirements.py has its
page.
"""

import random
from itertools import combinations
from math import inf, pi
from unittest.mock import patch

import pytest
from programs import slow_but_for
from vpython import mag
from whole_cradles import check_places, distances, energy, hang_double, PERIOD, velocities

from grading.cradles import left_over, MIXED, MIXED_CSV, shapes
from src.double_collisions import collide_pairs, handle_two_double_bobs, keep_apart, touching_pairs
from src.double_cradle import (
    double_angle_update,
    double_cradle_tick,
    double_swing_update,
    make_double_newton_cradle,
)
from support.constants import COLOR_MAP, DOUBLE_DT, G, PHI_INIT, R_PARAM, TEXTURE_MAP, THETA_INIT
from support.energy import energies
from support.files.valid_cradle import MOST_TIMES
from support.pendulum import BUFFER

RATES, ANGLES = ["omega", "phi_omega"], ["theta", "phi"]
NEAR = 0.999 * R_PARAM / 4  # m: bobs of pendula this far apart touch as they hang


def make_row(count, theta=0.0, phi=0.0, apart=R_PARAM / 4):
    """Return a row of double pendula, the first one at theta and phi (rad), the others straight
    down.
    """
    row = [hang_double(axle=(i * apart, 0)) for i in range(count)]
    row[0].update(theta=theta, phi=phi)
    return row


def values(pend_list, keys):
    return [pend[key] for pend in pend_list for key in keys]


def tick(pend_list, ticks, dt=DOUBLE_DT):
    """Do `ticks` ticks; return the hits as (tick, left, right): ticks from 0, and indices of
    pendula.
    """
    hits = []
    with patch(
        "src.double_cradle.collide_pairs",
        lambda *given: hits.append(collide_pairs(*given)) or hits[-1],
    ):
        for _ in range(ticks):
            double_cradle_tick(pend_list, R_PARAM, dt, G)
    return [(number, *pair) for number, pairs in enumerate(hits) for pair in pairs]


def follow(pend_list, samples, ticks):
    """Return the largest gain of energy (J) since a sample of `ticks` ticks, the least distance,
    and all hits.
    """
    least, gain, nearest, hits = energy(pend_list), 0.0, inf, 0
    for _ in range(samples):
        hits += len(tick(pend_list, ticks))
        gain, least = max(gain, energy(pend_list) - least), min(least, energy(pend_list))
        nearest = min(nearest, *distances(pend_list))
    return gain, nearest, hits


def test_make_double_newton_cradle(tmp_path):
    """The first pendulum starts at (theta_init, phi_init), the others hang; no shape of the single
    cradle is left.
    """
    file = tmp_path / "mixed.csv"
    file.write_text(MIXED_CSV)
    old = shapes()
    pend_list = make_double_newton_cradle(str(file), 0.4, 0.6, -0.4)
    assert not left_over(old, [shape for pend in pend_list for shape in pend["objects"]])
    for i, (pend, row) in enumerate(zip(pend_list, MIXED, strict=True)):
        angles = {"theta": 0.6, "phi": -0.4} if i == 0 else {"theta": 0, "phi": 0}
        assert pend == {**row, **angles, "omega": 0, "phi_omega": 0, "objects": pend["objects"]}
        check_places(pend, (-0.1 + 0.4 / 4 * i, 0.4 / 5), 0.4)
        for bob in pend["objects"][1::2]:
            assert (bob.visible, bob.color, bob.texture) == (
                True,
                COLOR_MAP[row["color"]],
                TEXTURE_MAP[row["texture"]],
            )


def test_a_tick_has_more_steps_only_if_a_cord_turns_far(monkeypatch):
    steps, update = [], "src.double_cradle.double_angle_update"
    monkeypatch.setattr(
        update, lambda *given: steps.append(given[5]) or double_angle_update(*given)
    )
    tick(make_row(5, -2.5, 0.5), 1500)  # equal masses, from far up
    assert steps == [DOUBLE_DT] * 7500
    steps.clear()
    double_swing_update(hang_double(omega=-500.0), R_PARAM, DOUBLE_DT, G)
    assert len(steps) > 1
    assert sum(steps) == pytest.approx(DOUBLE_DT)


@pytest.mark.parametrize("rates", [(float("inf"), 0.0), (0.0, float("nan")), (1.0, 1e300)])
def test_a_pendulum_that_is_too_fast_is_named(rates):
    with pytest.raises(
        ValueError, match="^a pendulum with omega = .* and phi_omega = .* rad/s is too fast$"
    ):
        double_swing_update(hang_double(0, 0, *rates), R_PARAM, DOUBLE_DT, G)


def let_touch(pair, bob1, bob2, apart=0.99):
    """Give two bobs (0 upper, 1 lower) the radius with which they touch; return the unit vector
    from one to the other.

    Their distance is `apart` of the largest one at which they touch. The other two bobs touch
    nothing.
    """
    for pend in pair:
        pend["objects"][1].radius = pend["objects"][3].radius = -9 * R_PARAM
    one, other = pair[0]["objects"][1 + 2 * bob1], pair[1]["objects"][1 + 2 * bob2]
    one.radius = other.radius = mag(other.pos - one.pos) / (2 * BUFFER * apart)
    return (other.pos - one.pos).hat


def approach(pair, bobs, direction):
    """Return the speed (m/s) at which two bobs (0 upper, 1 lower) of a pair approach each other in
    this direction.
    """
    v1, v2 = (velocities(pend)[bob] for pend, bob in zip(pair, bobs, strict=True))
    return (v1 - v2).dot(direction)


@pytest.mark.parametrize("pairs", slow_but_for([500], [500, 5000]))
def test_random_hits(pairs):
    """Bobs separate with e times the speed of approach.

    The energy stays the same at e = 1, and never grows below.

    This determines the hit: with another ratio of the changes, some hits would not keep the energy.
    Touching bobs that approach collide; by the other rule, separating ones collide too.
    """
    dice = random.Random(3)
    for _ in range(pairs):
        pair = [
            hang_double(*(dice.uniform(-9, 9) for _ in range(4)), axle=(axle, 0))
            for axle in (0, R_PARAM)
        ]
        for pend in pair:
            pend.update(mass=10 ** dice.uniform(-3, 3), e=dice.choice([0, 1, dice.random()]))
        bobs, e = (dice.choice([0, 1]), dice.choice([0, 1])), pair[0]["e"]
        apart = dice.choice([0.99, 0.99, 1.01])
        direction = let_touch(pair, *bobs, apart)
        before = values(pair, RATES)
        angles = values(pair, ANGLES)
        speed, kinetic = approach(pair, bobs, direction), energies(pair, R_PARAM, G)[0]
        collided = apart < 1 and speed > 0
        assert handle_two_double_bobs(*pair, R_PARAM) == collided
        assert values(pair, ANGLES) == angles
        if collided:
            rounding = 1e-9 * R_PARAM * max(map(abs, before + values(pair, RATES)))
            assert approach(pair, bobs, direction) == pytest.approx(-e * speed, rel=0, abs=rounding)
            assert energies(pair, R_PARAM, G)[0] <= kinetic * (1 + 1e-9)
            assert e < 1 or energies(pair, R_PARAM, G)[0] == pytest.approx(kinetic, rel=1e-9)
        else:
            assert values(pair, RATES) == before


@pytest.mark.parametrize(
    ("rates", "apart", "after"),
    [
        ([-1, 3, 0, 0], NEAR, [-1, 2, 0, 1]),  # the upper bobs separate, the lower ones approach
        ([1, 0, 1, 0], NEAR, None),  # they move together
        ([1, 0, 0, 0], 0.0, None),  # in one place, there is no line from centre to centre
    ],
)
def test_each_two_touching_bobs_of_two_pendula_collide(rates, apart, after):
    pair = hang_double(0, 0, *rates[:2]), hang_double(0, 0, *rates[2:], axle=(apart, 0))
    assert handle_two_double_bobs(*pair, R_PARAM) == (after is not None)
    assert values(pair, RATES) == pytest.approx(after or rates)


def test_any_two_bobs_of_two_pendula_touch():
    """As a comparison of all of them says: not only neighbours, and also an upper bob and a lower
    one.
    """
    dice, found = random.Random(4), set()
    for _ in range(100):
        row = [
            hang_double(dice.uniform(-2, 2), dice.uniform(-3, 3), axle=(i * R_PARAM / 4, 0))
            for i in range(4)
        ]
        for bob in (bob for pend in row for bob in pend["objects"][1::2]):
            bob.radius *= dice.uniform(0.5, 2)
        near = {pair: min(distances([row[i] for i in pair])) for pair in combinations(range(4), 2)}
        assert touching_pairs(row, R_PARAM) == [pair for pair in near if near[pair] <= 1]
        found |= {*touching_pairs(row, R_PARAM)}
    assert len(found) == 6


STARTS = [(THETA_INIT, PHI_INIT, 1), (THETA_INIT, PHI_INIT, 10), (-0.8, -0.8, 6), (-1.2, 0.5, 6)]


@pytest.mark.parametrize(("theta", "phi", "seconds"), slow_but_for(STARTS[:1], STARTS))
def test_five_elastic_double_pendula_keep_the_energy_and_do_not_pass_through_each_other(
    theta, phi, seconds
):
    """Bobs come closest in the first seconds: to hardly less than 0.98 of the distance at which
    they touch.
    """
    row = make_row(5, theta, phi)
    at_start, (gain, nearest, hits) = energy(row), follow(row, round(seconds / DOUBLE_DT / 8), 8)
    assert gain <= 1e-6 * at_start
    assert energy(row) == pytest.approx(at_start, rel=1e-6)
    assert nearest > 0.979
    assert hits > 13.5 * seconds / PERIOD


@pytest.mark.parametrize("seed", slow_but_for([2], range(30)))
def test_random_masses_in_the_range_of_a_csv_gain_nothing(seed):
    """The masses of neighbours often differ by the largest ratio."""
    dice = random.Random(seed)
    row = make_row(dice.randint(3, 5), -dice.uniform(0.8, 2.5), dice.uniform(-1, 1))
    for pend in row:
        pend.update(
            mass=MOST_TIMES ** dice.choice([0, 1, dice.random()]),
            e=dice.choice([1, 1, dice.random()]),
        )
    at_start, (gain, _, _) = energy(row), follow(row, 1500, 1)
    assert gain <= 1e-4 * at_start


@pytest.mark.parametrize(
    ("e", "apart", "expected"), [(0.5, 0.97, 0.98), (1, 0.97, 0.97), (0.5, 0.9, 0.9)]
)
def test_bobs_that_lie_on_each_other_are_moved_apart(e, apart, expected):
    """To 0.98 of the distance at which they touch, but not elastic bobs, and not bobs that a person
    put closer.
    """
    pair = hang_double(0.3, 0.4, 0.1, e=e), hang_double(0.3, -0.5, -0.1, axle=(1.5 * R_PARAM, 0))
    let_touch(pair, 1, 1, apart)
    tick(pair, 1, 1e-9)
    assert max(distances(pair)) == pytest.approx(expected, abs=1e-4)


def test_bobs_that_their_cords_hold_back_are_not_moved_apart():
    """One hangs straight down above the other, which stands on its cord: only a large turn would
    separate them.
    """
    pair = hang_double(1e-3, pi, e=0.0), hang_double(pi, pi, axle=(0, -3 * R_PARAM))
    let_touch(pair, 0, 0, 0.97)
    assert not keep_apart(*pair, R_PARAM)


def test_a_tick_handles_each_pair_from_left_to_right():
    """A hit to the right runs through a whole row in one tick; one to the left moves on by one pair
    in each sweep.
    """
    row = make_row(5, apart=NEAR)
    row[0]["omega"] = 1.0
    assert tick(row, 1, 1e-7) == [(0, 0, 1), (0, 1, 2), (0, 2, 3), (0, 3, 4)]
    assert values(row, ["omega"]) == pytest.approx([0, 0, 0, 0, 1], abs=1e-3)
    for i, pend in enumerate(row):
        check_places(pend, (i * NEAR, 0))
    row = make_row(3, apart=NEAR)
    row[2]["omega"] = -1.0
    assert tick(row, 1, 1e-7) == [(0, 1, 2), (0, 0, 1)]
