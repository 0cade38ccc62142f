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


# One with its cords at 60 and 150 degrees, and one that hangs straight down.
DOUBLES = [
    hang_double(theta=pi / 3, phi=pi / 2, omega=4.0, phi_omega=2.0, mass=3.0),
    hang_double(omega=2.0, phi_omega=2.0),
]


def test_the_kinetic_energy_of_double_pendula():
    """Upper bobs: 2 and 1 m/s. Lower bobs relative to them: 3 m/s at a right angle, and 2 m/s in the same direction."""
    assert double_kinetic_energy(DOUBLES, LENGTH) == pytest.approx(3 * (2**2 + 2**2 + 3**2) / 2 + (1**2 + 3**2) / 2)


def test_the_potential_energy_of_double_pendula():
    """The bobs of the first one are higher than at rest: by 0.25 m, and by 0.25 + 0.5 (1 + cos 30 degrees) m."""
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
