"""The energy and the momentum of a cradle. Both bobs of a double pendulum have its mass."""

from itertools import accumulate
from math import cos, sin

from support.pendulum import cord_angles


def bob_motions(pend, r_param):
    """Yield (height, vx, vy) of each bob of a pendulum, the upper one first; r_param (m) is the
    length of each cord.

    height (m) is that above hanging at rest, vx and vy (m/s) are the velocities to the right and
    upwards. A cord at the angle a from straight down, with the rate b, adds R (1 - cos a) to the
    height of the bobs below it, R b cos a to their vx, and R b sin a to their vy.
    """
    height = vx = vy = 0.0
    angles = cord_angles(pend)
    rates = accumulate(pend[key] for key in ("omega", "phi_omega")[: len(angles)])
    for angle, rate in zip(angles, rates, strict=True):
        height += r_param * (1 - cos(angle))
        vx += r_param * rate * cos(angle)
        vy += r_param * rate * sin(angle)
        yield height, vx, vy


def energies(pend_list, r_param, g) -> tuple[float, float]:
    """Return the kinetic and the potential energy (J): the sums of m v^2 / 2 and of m g h over the
    bobs.

    h is above hanging at rest, r_param (m) the length of each cord, g (m/s^2) gravity's
    acceleration.
    """
    bobs = [(pend["mass"], *motion) for pend in pend_list for motion in bob_motions(pend, r_param)]
    return sum(m * (vx**2 + vy**2) / 2 for m, _, vx, vy in bobs), sum(
        m * g * height for m, height, _, _ in bobs
    )


def momentum(pend_list, r_param) -> float:
    """Return the momentum of the bobs to the right (kg m/s); r_param (m) is the length of each
    cord.
    """
    return sum(pend["mass"] * vx for pend in pend_list for _, vx, _ in bob_motions(pend, r_param))
