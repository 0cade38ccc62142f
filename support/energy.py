"""The energy and the momentum of a cradle. Both bobs of a double pendulum have its mass."""

from collections.abc import Iterator
from itertools import accumulate
from math import cos, sin
from typing import NamedTuple

from support.pendulum import cord_angles, Pendulum


class BobMotion(NamedTuple):
    """The motion of one bob at a moment."""

    height: float  # above hanging at rest (m)
    vx: float  # velocity to the right (m/s)
    vy: float  # velocity upwards (m/s)


def bob_motions(pend: Pendulum, r_param: float) -> Iterator[BobMotion]:
    """Yield the motion of each bob of a pendulum, the upper one first.

    r_param (m) is the length of each cord. A cord at the angle a from straight down, with the rate
    b, adds R (1 - cos a) to the height of the bobs below it, R b cos a to their vx, and R b sin a
    to their vy.
    """
    height = vx = vy = 0.0
    angles = cord_angles(pend)
    rates = accumulate(pend[key] for key in ("omega", "phi_omega")[: len(angles)])
    for angle, rate in zip(angles, rates, strict=True):
        height += r_param * (1 - cos(angle))
        vx += r_param * rate * cos(angle)
        vy += r_param * rate * sin(angle)
        yield BobMotion(height, vx, vy)


def energies(pend_list: list[Pendulum], r_param: float, g: float) -> tuple[float, float]:
    """Return the kinetic and the potential energy (J).

    They are the sums of m v^2 / 2 and of m g h over the bobs; h is above hanging at rest. r_param
    (m) is the length of each cord, g (m/s^2) gravity's acceleration.
    """
    kinetic = []
    potential = []
    for pend in pend_list:
        for bob in bob_motions(pend, r_param):
            kinetic.append(pend["mass"] * (bob.vx**2 + bob.vy**2) / 2)
            potential.append(pend["mass"] * g * bob.height)
    return sum(kinetic), sum(potential)


def momentum(pend_list: list[Pendulum], r_param: float) -> float:
    """Return the momentum of the bobs to the right (kg m/s); r_param (m) is a cord's length."""
    return sum(pend["mass"] * bob.vx for pend in pend_list for bob in bob_motions(pend, r_param))
