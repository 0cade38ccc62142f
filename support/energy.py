"""What the laws of motion say about a cradle: its energy and momentum, and exact figures to hold a tick against."""

from math import cos, pi, sqrt


def kinetic_energy(pend_list, r_param) -> float:
    """Return the sum of m v^2 / 2 (J) over the bobs, with v = r_param omega; r_param is the cord length (m)."""
    return sum(pend["mass"] * (r_param * pend["omega"]) ** 2 / 2 for pend in pend_list)


def potential_energy(pend_list, r_param, g) -> float:
    """Return the sum of m g h (J) over the bobs, h = r_param (1 - cos theta) being the height above hanging at rest.

    r_param is the cord length (m), g the gravitational acceleration (m/s^2).
    """
    return sum(pend["mass"] * g * r_param * (1 - cos(pend["theta"])) for pend in pend_list)


def momentum(pend_list, r_param) -> float:
    """Return the sum of m v cos(theta) (kg m/s) over the bobs: the momentum to the right, with v = r_param omega."""
    return sum(pend["mass"] * r_param * pend["omega"] * cos(pend["theta"]) for pend in pend_list)


def double_kinetic_energy(pend_list, r_param) -> float:
    """Return the kinetic energy (J) of double pendula, the bobs of each having one mass.

    With the rates a and b of the two cords' angles from straight down, m v^2 / 2 is m r_param^2 a^2 / 2 for the upper
    bob, and m r_param^2 (a^2 + b^2 + 2 a b cos(phi)) / 2 for the lower one; r_param (m) is the length of each cord.
    """
    total = 0.0
    for pend in pend_list:
        a, b = pend["omega"], pend["omega"] + pend["phi_omega"]
        total += pend["mass"] * r_param**2 * (2 * a**2 + b**2 + 2 * a * b * cos(pend["phi"])) / 2
    return total


def double_potential_energy(pend_list, r_param, g) -> float:
    """Return the sum of m g h (J) over the bobs of double pendula, h being the height above hanging at rest.

    The upper cord lifts both bobs, the lower one only its own; r_param (m) is the length of each, g (m/s^2) the
    gravitational acceleration.
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
    """Return the time (s) in which a pendulum that is let go at theta_max (rad) comes back, at any theta_max below pi.

    It is 4 sqrt(R / g) K(sin(theta_max / 2)), K being the complete elliptic integral of the first kind, and
    K(k) = pi / (2 M(1, sqrt(1 - k^2))), M being the arithmetic-geometric mean: https://dlmf.nist.gov/19.8.E5.
    r_param (m) is the cord length R, g (m/s^2) the gravitational acceleration.
    """
    arithmetic, geometric = 1.0, cos(theta_max / 2)
    while arithmetic - geometric > 1e-15:
        arithmetic, geometric = (arithmetic + geometric) / 2, sqrt(arithmetic * geometric)
    return 2 * pi * sqrt(r_param / g) / arithmetic


def energy_left(e, hits) -> float:
    """Return which part of the energy two equal bobs have after so many hits, if one comes down on the other at rest.

    Half of it is in their common motion, which a hit does not change; of the other half each hit leaves e squared, as
    it makes them part at e times the speed at which they met: 1/2 + e^(2 hits) / 2.
    """
    return 1 / 2 + e ** (2 * hits) / 2
