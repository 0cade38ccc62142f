"""How true the shipped cradle is: the figures of theory in tests/project/README.md."""

from functools import partial
from itertools import pairwise
from math import degrees, radians, sin, sqrt

import pytest
from exact_cradle import apart, exact_outer_angles, outer_angles, SAMPLE
from programs import slow_except
from scipy.special import ellipk
from whole_cradles import advance, energy, hits_in, make_row

from support.constants import DT, G, R_PARAM, THETA_INIT


def exact_period(amplitude):
    """Return the period (s) of a pendulum with this amplitude (rad)."""
    return 4 * sqrt(R_PARAM / G) * ellipk(sin(amplitude / 2) ** 2)


@pytest.mark.parametrize("amplitude", slow_except([30], [5, 30, 60, 90, 120, 150, 170]))  # degrees
def test_the_period_of_one_pendulum_over_twenty_swings(amplitude):
    pend_list = make_row(1, radians(amplitude))
    expected = exact_period(radians(amplitude))
    thetas = [advance(pend_list, SAMPLE)[0] for _ in range(round(20.5 * expected / SAMPLE))]
    crossings = []  # times (s) at the lowest point, from the right
    for sample, (before, after) in enumerate(pairwise(thetas)):
        if before > 0 >= after:
            crossings.append((sample + before / (before - after)) * SAMPLE)
    assert len(crossings) == 21
    assert (crossings[-1] - crossings[0]) / 20 == pytest.approx(expected, rel=0.0005)


@pytest.mark.parametrize("e", slow_except([0.9], [0.99, 0.9, 0.5, 0.1]))
def test_two_equal_bobs_keep_part_of_the_energy(e):
    """A hit keeps the half of the energy in the common motion.

    It multiplies the relative speed by e.
    """
    pend_list = make_row(2, THETA_INIT, e=e)
    at_start = energy(pend_list)
    hits = 0
    for _ in range(round(3 * exact_period(THETA_INIT) / 1e-3)):  # with two hits in a period
        hits += len(hits_in(pend_list, 1e-3))
        part = 1 / 2 + e ** (2 * hits) / 2
        assert energy(pend_list) / at_start == pytest.approx(part, rel=0.005)
    assert hits >= 5


@pytest.mark.parametrize(
    ("release", "seconds"), slow_except([(45, 10)], [(45, 10), (5, 60), (60, 60)])
)
def test_five_equal_elastic_bobs_keep_the_energy(release, seconds):
    """From release (degrees), the last bob rises as high as the first one was.

    Those between hardly move.
    """
    pend_list = make_row(5, -radians(release))
    at_start = energy(pend_list)
    thetas = []
    for _ in range(round(seconds / SAMPLE)):
        thetas.append(advance(pend_list, SAMPLE))
        assert energy(pend_list) == pytest.approx(at_start, rel=0.001)
    _, *between, last = [degrees(max(map(abs, of_bob))) for of_bob in zip(*thetas, strict=True)]
    assert last == pytest.approx(release, rel=0.001)
    assert max(between) < 1.5


EXACT = [(DT, 10, 0.6), (DT / 10, 5, 0.03)]


@pytest.mark.parametrize(("dt", "seconds", "most"), slow_except(EXACT[:1], EXACT))
def test_the_outer_bobs_are_where_an_exact_cradle_has_them(dt, seconds, most):
    """With ticks of dt (s), they are off by at most `most` degrees, root mean square."""
    move = partial(advance, make_row(5, THETA_INIT), dt=dt)
    assert apart(outer_angles(move, seconds), exact_outer_angles(seconds)) <= most
