"""The energy and the momentum of a cradle."""

from math import cos


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
