"""The energy and the momentum of a cradle, and exact results to compare its ticks with."""

from math import cos, pi, sqrt


def kinetic_energy(pend_list, r_param) -> float:
    """Return the sum of m v^2 / 2 (J) over the bobs, with v = r_param omega; r_param is the cord length (m)."""
    return sum(pend["mass"] * (r_param * pend["omega"]) ** 2 / 2 for pend in pend_list)


def potential_energy(pend_list, r_param, g) -> float:
    """Return the sum of m g h (J) over the bobs, with the height h = r_param (1 - cos theta) above hanging at rest.

    r_param is the cord length (m), g the gravitational acceleration (m/s^2).
    """
    return sum(pend["mass"] * g * r_param * (1 - cos(pend["theta"])) for pend in pend_list)


def momentum(pend_list, r_param) -> float:
    """Return the sum of m v cos(theta) (kg m/s) over the bobs: the momentum to the right, with v = r_param omega."""
    return sum(pend["mass"] * r_param * pend["omega"] * cos(pend["theta"]) for pend in pend_list)


def double_kinetic_energy(pend_list, r_param) -> float:
    """Return the kinetic energy (J) of double pendula; both bobs of a pendulum have its mass.

    a and b are the rates (rad/s) of the two cords' angles from straight down. m v^2 / 2 is m r_param^2 a^2 / 2 for the
    upper bob, and m r_param^2 (a^2 + b^2 + 2 a b cos(phi)) / 2 for the lower one. r_param (m) is the length of a cord.
    """
    total = 0.0
    for pend in pend_list:
        a, b = pend["omega"], pend["omega"] + pend["phi_omega"]
        total += pend["mass"] * r_param**2 * (2 * a**2 + b**2 + 2 * a * b * cos(pend["phi"])) / 2
    return total


def double_potential_energy(pend_list, r_param, g) -> float:
    """Return the sum of m g h (J) over the bobs of double pendula, with the height h above hanging at rest.

    The upper cord lifts both bobs, the lower cord only the lower bob. r_param (m) is the length of each cord, g (m/s^2)
    the gravitational acceleration.
    """
    lifts = [(2 * (1 - cos(pend["theta"])) + 1 - cos(pend["theta"] + pend["phi"])) * pend["mass"] for pend in pend_list]
    return g * r_param * sum(lifts)


def double_momentum(pend_list, r_param) -> float:
    """Return the momentum of double pendula's bobs to the right (kg m/s); r_param (m) is the length of each cord."""
    total = 0.0
    for pend in pend_list:
        alpha, beta, b = pend["theta"], pend["theta"] + pend["phi"], pend["omega"] + pend["phi_omega"]
        total += pend["mass"] * r_param * (2 * pend["omega"] * cos(alpha) + b * cos(beta))
    return total


def exact_period(theta_max, r_param, g) -> float:
    """Return the period (s) of a pendulum with the amplitude theta_max (rad), for any theta_max below pi.

    It is 4 sqrt(R / g) K(sin(theta_max / 2)), with the complete elliptic integral of the first kind,
    K(k) = pi / (2 M(1, sqrt(1 - k^2))). M is the arithmetic-geometric mean (https://dlmf.nist.gov/19.8.E5).
    r_param (m) is the cord length R, g (m/s^2) the gravitational acceleration.
    """
    arithmetic, geometric = 1.0, cos(theta_max / 2)
    while arithmetic - geometric > 1e-15:
        arithmetic, geometric = (arithmetic + geometric) / 2, sqrt(arithmetic * geometric)
    return 2 * pi * sqrt(r_param / g) / arithmetic


def energy_left(e, hits) -> float:
    """Return the part of the energy that two equal bobs keep after `hits` hits; one of them hangs at rest first.

    Half of the energy is in their common motion, which a hit does not change. The other half is in their relative
    motion. A hit multiplies the relative speed by e, and so this half by e^2: the result is 1/2 + e^(2 hits) / 2.
    """
    return 1 / 2 + e ** (2 * hits) / 2
