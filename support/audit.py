"""What the laws of motion say about a cradle: its energy and its momentum, from theta, omega and the masses."""

from math import cos


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
