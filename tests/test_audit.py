"""Energy and momentum, against figures worked out by hand for masses, angles and velocities that differ."""

from math import pi

import pytest
from cradles import hang

from support.audit import kinetic_energy, momentum, potential_energy

LENGTH, G = 0.5, 10.0  # m, m/s^2
PENDULA = [hang(theta=pi / 3, omega=4.0, mass=3.0), hang(theta=pi / 2, omega=-2.0, mass=1.0), hang(mass=5.0)]


def test_kinetic_energy():
    """v is 2 m/s and -1 m/s."""
    assert kinetic_energy(PENDULA, LENGTH) == pytest.approx(3 * 2**2 / 2 + 1 * 1**2 / 2)


def test_potential_energy():
    """The first bob is half a cord higher than at rest, the second a whole one."""
    assert potential_energy(PENDULA, LENGTH, G) == pytest.approx(3 * G * 0.25 + 1 * G * 0.5)


def test_momentum():
    """To the right: half of the first bob's velocity, and nothing of the second one's, which moves straight down."""
    assert momentum(PENDULA, LENGTH) == pytest.approx(3 * 2 * 0.5)
