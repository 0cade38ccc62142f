"""The functions of the double cradle: its objects, its laws of motion, and its hits."""

from math import inf, nan, pi
from unittest.mock import patch

import pytest
from strategies import DOUBLE_HITS, random_examples
from vpython import mag
from whole_cradles import check_places, distances, energy, hang_double, PERIOD, velocities

from grading.cradles import left_over, MIXED, MIXED_CSV, shapes
from src.double_collisions import handle_two_double_bobs, keep_apart, ROUNDING
from src.double_cradle import (
    collide_pairs,
    double_angle_update,
    double_cradle_tick,
    double_swing_update,
    make_double_newton_cradle,
)
from support.constants import COLOR_MAP, DOUBLE_DT, G, PHI_INIT, R_PARAM, TEXTURE_MAP, THETA_INIT
from support.energy import energies
from support.pendulum import BUFFER

RATES = ["omega", "phi_omega"]
ANGLES = ["theta", "phi"]
NEAR = 0.999 * R_PARAM / 4  # m: bobs of pendula this far apart touch as they hang


def make_row(count, theta=0.0, phi=0.0, apart=R_PARAM / 4):
    """Return double pendula: the first one at theta and phi (rad), the others straight down."""
    row = [hang_double(axle=(i * apart, 0)) for i in range(count)]
    row[0].update(theta=theta, phi=phi)
    return row


def values(pend_list, keys):
    return [pend[key] for pend in pend_list for key in keys]


def tick(pend_list, ticks, dt=DOUBLE_DT):
    """Do `ticks` ticks; return the hits as (tick from 0, left, right), with indices of pendula."""
    hits = []

    def record(*given):
        pairs = collide_pairs(*given)
        hits.extend((number, *pair) for pair in pairs)
        return pairs

    with patch("src.double_cradle.collide_pairs", record):
        for number in range(ticks):  # noqa: B007  for the hits
            double_cradle_tick(pend_list, R_PARAM, dt, G)
    return hits


def test_make_double_newton_cradle(tmp_path):
    """The first pendulum starts at (theta_init, phi_init), the others hang.

    No shape of the single cradle is left.
    """
    file = tmp_path / "mixed.csv"
    file.write_text(MIXED_CSV)
    old = shapes()
    pend_list = make_double_newton_cradle(str(file), 0.4, 0.6, -0.4)
    assert not left_over(old, [shape for pend in pend_list for shape in pend["objects"]])
    assert values(pend_list, ANGLES) == [0.6, -0.4, 0, 0, 0, 0]
    assert values(pend_list, RATES) == [0] * 6
    for i, (pend, row) in enumerate(zip(pend_list, MIXED, strict=True)):
        check_places(pend, (-0.1 + 0.4 / 4 * i, 0.4 / 5), 0.4)
        assert pend.keys() == {*row, *ANGLES, *RATES, "objects"}
        for key in ("mass", "e", "color", "texture"):
            assert pend[key] == row[key]
        for bob in pend["objects"][1::2]:
            assert bob.color == COLOR_MAP[row["color"]]
            assert bob.texture == TEXTURE_MAP[row["texture"]]


def test_a_tick_has_more_steps_only_if_a_cord_turns_far(monkeypatch):
    steps = []

    def record(*given):
        steps.append(given[5])
        return double_angle_update(*given)

    monkeypatch.setattr("src.double_cradle.double_angle_update", record)
    tick(make_row(5, -2.5, 0.5), 1500)  # equal masses, from far up
    assert steps == [DOUBLE_DT] * 7500
    steps.clear()
    double_swing_update(hang_double(omega=-500.0, phi_omega=300.0), R_PARAM, DOUBLE_DT, G)
    assert len(steps) == 3
    assert sum(steps) == pytest.approx(DOUBLE_DT)


@pytest.mark.parametrize("rates", [(inf, 0.0), (0.0, nan)])
def test_a_pendulum_that_is_too_fast_is_named(rates):
    message = "^a pendulum with omega = .* and phi_omega = .* rad/s is too fast$"
    with pytest.raises(ValueError, match=message):
        double_swing_update(hang_double(0, 0, *rates), R_PARAM, DOUBLE_DT, G)


def let_touch(pair, bobs, apart=0.99):
    """Give a bob of each pendulum (0 upper, 1 lower) the radius with which the two touch.

    Their distance is `apart` of the largest one at which they touch. The other two bobs touch
    nothing. Return the unit vector from one to the other.
    """
    for pend in pair:
        for bob in pend["objects"][1::2]:
            bob.radius = -9 * R_PARAM
    left, right = (pend["objects"][1 + 2 * bob] for pend, bob in zip(pair, bobs, strict=True))
    reach = mag(right.pos - left.pos) / (BUFFER * apart)
    left.radius, right.radius = 0.4 * reach, 0.6 * reach
    return (right.pos - left.pos).hat


def approach(pair, bobs, direction):
    """Return the speed (m/s) at which a bob of each pendulum approach each other."""
    v1, v2 = (velocities(pend)[bob] for pend, bob in zip(pair, bobs, strict=True))
    return (v1 - v2).dot(direction)


@random_examples(100, hit=DOUBLE_HITS)
def test_touching_bobs_that_approach_separate_with_e_times_their_speed(hit):
    """The energy stays the same at e = 1, and never grows below.

    This determines the hit: with another ratio of the changes, some hits would not keep the energy.
    """
    left, right, bobs, apart = hit
    pair = [hang_double(*left), hang_double(*right, axle=(R_PARAM, 0))]
    direction = let_touch(pair, bobs, apart)
    e = pair[0]["e"]
    before = values(pair, RATES)
    angles = values(pair, ANGLES)
    speed = approach(pair, bobs, direction)
    kinetic, _ = energies(pair, R_PARAM, G)
    collided = apart < 1 and speed > ROUNDING
    assert handle_two_double_bobs(*pair, R_PARAM) == collided
    assert values(pair, ANGLES) == angles
    if not collided:
        assert values(pair, RATES) == before
        return
    rounding = 1e-9 * R_PARAM * max(map(abs, before + values(pair, RATES)))
    assert approach(pair, bobs, direction) == pytest.approx(-e * speed, rel=0, abs=rounding)
    now, _ = energies(pair, R_PARAM, G)
    assert now <= kinetic * (1 + 1e-9)
    if e == 1:
        assert now == pytest.approx(kinetic, rel=1e-9)


@pytest.mark.parametrize(
    ("rates", "apart", "after"),
    [
        ([-1, 3, 0, 0], NEAR, [-1, 2, 0, 1]),  # the upper bobs separate, the lower ones approach
        ([1, 0, 0, 0], 0.0, None),  # in one place, there is no line from centre to centre
    ],
)
def test_each_two_touching_bobs_of_two_pendula_collide(rates, apart, after):
    pair = hang_double(0, 0, *rates[:2]), hang_double(0, 0, *rates[2:], axle=(apart, 0))
    assert handle_two_double_bobs(*pair, R_PARAM) == (after is not None)
    assert values(pair, RATES) == pytest.approx(after or rates)


def test_five_elastic_double_pendula_keep_the_energy_and_do_not_pass_through_each_other():
    """Bobs come closest in the first second: to hardly less than 0.98, where 1 is a touch."""
    row = make_row(5, THETA_INIT, PHI_INIT)
    at_start = energy(row)
    hits = 0
    for _ in range(round(1 / DOUBLE_DT / 8)):
        hits += len(tick(row, 8))
        assert energy(row) == pytest.approx(at_start, rel=1e-6)
        assert min(distances(row)) > 0.979
    assert hits > 13.5 / PERIOD


@pytest.mark.parametrize(
    ("e", "apart", "expected"), [(0.5, 0.97, 0.98), (1, 0.97, 0.97), (0.5, 0.9, 0.9)]
)
def test_bobs_that_lie_on_each_other_are_moved_apart(e, apart, expected):
    """To 0.98 of the distance at which they touch.

    Elastic bobs are not moved, nor are bobs that a person put closer.
    """
    pair = hang_double(0.3, 0.4, 0.1, e=e), hang_double(0.3, -0.5, -0.1, axle=(1.5 * R_PARAM, 0))
    let_touch(pair, (1, 1), apart)
    tick(pair, 1, 1e-9)
    assert max(distances(pair)) == pytest.approx(expected, abs=1e-4)


def test_bobs_that_their_cords_hold_back_are_not_moved_apart():
    """One hangs straight down above the other, which stands on its cord.

    Only a large turn would separate them.
    """
    pair = hang_double(1e-3, pi, e=0.0), hang_double(pi, pi, axle=(0, -3 * R_PARAM))
    let_touch(pair, (0, 0), 0.97)
    assert not keep_apart(*pair, R_PARAM)


def test_a_tick_handles_each_pair_from_left_to_right():
    """A hit to the right runs through a whole row in one tick.

    One to the left moves on by one pair in each sweep.
    """
    row = make_row(5, apart=NEAR)
    row[0]["omega"] = 1.0
    assert tick(row, 1, 1e-7) == [(0, 0, 1), (0, 1, 2), (0, 2, 3), (0, 3, 4)]
    assert values(row, ["omega"]) == pytest.approx([0, 0, 0, 0, 1], abs=1e-3)
    row = make_row(3, apart=NEAR)
    row[2]["omega"] = -1.0
    assert tick(row, 1, 1e-7) == [(0, 1, 2), (0, 0, 1)]
