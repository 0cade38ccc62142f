"""Make cradles from a CSV: with one mass or one restitution for all pendula, and ready to swing."""

from vpython import vector

from src.pds_helper import extract_and_convert
from support.constants import COLOR_MAP, TEXTURE_MAP
from support.pendulum import make_pendulum, PendulumEntry


def uniform_mass_newton_cradle(relative_filepath: str, mass: float) -> list[PendulumEntry]:
    """Return the pend_list of a CSV with every pendulum's mass set to mass (kg)."""
    pend_list = extract_and_convert(relative_filepath)
    for pend_dict in pend_list:
        pend_dict["mass"] = mass
    return pend_list


def uniform_e_newton_cradle(relative_filepath: str, e_val: float) -> list[PendulumEntry]:
    """Return the pend_list of a CSV with every pendulum's e set to e_val.

    e is the coefficient of restitution, from 0 to 1.
    """
    pend_list = extract_and_convert(relative_filepath)
    for pend_dict in pend_list:
        pend_dict["e"] = e_val
    return pend_list


def elastic_newton_cradle(relative_filepath: str) -> list[PendulumEntry]:
    """Return the pend_list of a CSV with perfectly elastic pendula.

    A hit keeps the kinetic energy.
    """
    # e of an elastic collision
    return uniform_e_newton_cradle(relative_filepath, 1)


def inelastic_newton_cradle(relative_filepath: str) -> list[PendulumEntry]:
    """Return the pend_list of a CSV with perfectly inelastic pendula.

    After a hit, both bobs have the same velocity.
    """
    # e of an inelastic collision
    return uniform_e_newton_cradle(relative_filepath, 0)


def make_newton_cradle(
    relative_filepath: str, r_param: float, theta_init: float
) -> list[PendulumEntry]:
    """Return the pend_list of a CSV, ready to swing.

    Each pendulum also gets theta, omega and objects (axle, bob, cord). The first pendulum is lifted
    to theta_init (rad), the others hang straight down; all are at rest. r_param (m) is the cord
    length.
    """
    pend_list = extract_and_convert(relative_filepath)
    for i, pend_dict in enumerate(pend_list):
        pend_dict["theta"] = theta_init if i == 0 else 0
        pend_dict["omega"] = 0
        axle_pos = vector(-0.1 + r_param / 4 * i, r_param / 5, 0)
        color, texture = COLOR_MAP[pend_dict["color"]], TEXTURE_MAP[pend_dict["texture"]]
        pend_dict["objects"] = make_pendulum(axle_pos, r_param, pend_dict["theta"], color, texture)
    return pend_list
