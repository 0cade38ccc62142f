"""The energy and the momentum of a cradle. Both bobs of a double pendulum have its mass."""

from math import cos, sin

from support.pendulum import cord_angles, cord_rates


def bob_motions(pend, r_param):
    """Yield (height, vx, vy) of each bob of a pendulum, the upper one first; r_param (m) is the length of each cord.

    height (m) is that above hanging at rest, vx and vy (m/s) are the velocities to the right and upwards. A cord at the
    angle a from straight down, with the rate b, adds R (1 - cos a) to the height of the bobs below it, R b cos a to
    their vx, and R b sin a to their vy.
    """
    height = vx = vy = 0.0
    for angle, rate in zip(cord_angles(pend), cord_rates(pend), strict=True):
        height += r_param * (1 - cos(angle))
        vx += r_param * rate * cos(angle)
        vy += r_param * rate * sin(angle)
        yield height, vx, vy


def kinetic_energy(pend_list, r_param) -> float:
    """Return the sum of m v^2 / 2 (J) over the bobs; r_param (m) is the length of each cord."""
    return sum(pend["mass"] * (vx**2 + vy**2) / 2 for pend in pend_list for _, vx, vy in bob_motions(pend, r_param))


def potential_energy(pend_list, r_param, g) -> float:
    """Return the sum of m g h (J) over the bobs; h is above hanging at rest, g (m/s^2) gravity's acceleration."""
    return sum(pend["mass"] * g * height for pend in pend_list for height, _, _ in bob_motions(pend, r_param))


def momentum(pend_list, r_param) -> float:
    """Return the momentum of the bobs to the right (kg m/s); r_param (m) is the length of each cord."""
    return sum(pend["mass"] * vx for pend in pend_list for _, vx, _ in bob_motions(pend, r_param))
