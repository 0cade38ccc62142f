"""Energy, momentum and exact figures, compared with values by hand or from tables."""

from math import pi, radians, sqrt

import pytest
from whole_cradles import hang_double

from grading.cradles import hang
from support.energy import (
    double_kinetic_energy,
    double_momentum,
    double_potential_energy,
    energy_left,
    exact_period,
    kinetic_energy,
    momentum,
    potential_energy,
)

LENGTH, G = 0.5, 10.0  # m, m/s^2
PENDULA = [hang(theta=pi / 3, omega=4.0, mass=3.0), hang(theta=pi / 2, omega=-2.0, mass=1.0), hang(mass=5.0)]


def test_kinetic_energy():
    """v is 2 m/s and -1 m/s."""
    assert kinetic_energy(PENDULA, LENGTH) == pytest.approx(3 * 2**2 / 2 + 1 * 1**2 / 2)


def test_potential_energy():
    """The first bob is half a cord higher than at rest, the second one a whole cord."""
    assert potential_energy(PENDULA, LENGTH, G) == pytest.approx(3 * G * 0.25 + 1 * G * 0.5)


def test_momentum():
    """To the right: half of the velocity of the first bob; the second one moves straight down."""
    assert momentum(PENDULA, LENGTH) == pytest.approx(3 * 2 * 0.5)


# The upper cord at 60 degrees, the lower one at a right angle to it, at 150 degrees; and one that hangs down.
DOUBLES = [
    hang_double(theta=pi / 3, phi=pi / 2, omega=4.0, phi_omega=2.0, mass=3.0),
    hang_double(omega=2.0, phi_omega=2.0),
]


def test_the_kinetic_energy_of_double_pendula():
    """The upper bobs move at 2 and 1 m/s, the lower ones relative to them at 3 m/s, square to that, and 2 m/s along."""
    assert double_kinetic_energy(DOUBLES, LENGTH) == pytest.approx(3 * (2**2 + 2**2 + 3**2) / 2 + (1**2 + 3**2) / 2)


def test_the_potential_energy_of_double_pendula():
    """The first one's upper bob is 0.25 m higher than at rest, its lower one that and 0.5 m (1 + cos 30 degrees)."""
    assert double_potential_energy(DOUBLES, LENGTH, G) == pytest.approx(3 * G * (0.25 + 0.25 + 0.5 * (1 + sqrt(3) / 2)))


def test_the_momentum_of_double_pendula():
    """First pendulum: 1 m/s for each bob, and 3 m/s times cos 150 degrees for the lower one; second: 1 and 3 m/s."""
    assert double_momentum(DOUBLES, LENGTH) == pytest.approx(3 * (1 + 1 - 3 * sqrt(3) / 2) + 1 + 3)


def test_the_period_of_a_small_swing():
    assert exact_period(1e-9, LENGTH, G) == pytest.approx(2 * pi * sqrt(LENGTH / G), rel=1e-15)


@pytest.mark.parametrize(
    ("degrees", "k"),
    [
        (60, 1.685750354812596),  # K(sin 30 degrees), and so on: Abramowitz and Stegun, table 17.2
        (90, 1.854074677301372),
        (170, 3.831741999784),
    ],
)
def test_the_period_of_a_large_swing(degrees, k):
    assert exact_period(radians(degrees), LENGTH, G) == pytest.approx(4 * sqrt(LENGTH / G) * k, rel=1e-12)


@pytest.mark.parametrize(
    ("e", "hits", "left"), [(0.5, 0, 1), (1, 9, 1), (0, 1, 0.5), (0.5, 1, 0.625), (0.5, 2, 0.53125)]
)
def test_the_energy_that_two_equal_bobs_have_left(e, hits, left):
    assert energy_left(e, hits) == left
