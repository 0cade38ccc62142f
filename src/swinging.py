"""Swing the pendula by one time step."""

from math import sin

from support.pendulum import PendulumEntry, show_pendulum


def angle_update(
    omega: float, theta: float, r_param: float, dt: float, g: float
) -> tuple[float, float]:
    """Return (omega_new, theta_new) of a pendulum after dt (s).

    omega (rad/s) and theta (rad) are the values before, r_param (m) the cord length, g (m/s^2) the
    gravitational acceleration.
    """
    # Newton's second law for the bob along its arc, m R omega' = -m g sin(theta), in steps of
    # semi-implicit Euler: the new omega moves theta.
    omega_new = omega - g * sin(theta) / r_param * dt
    theta_new = theta + omega_new * dt
    return omega_new, theta_new


def swing_update(pend_dict: PendulumEntry, r_param: float, dt: float, g: float) -> None:
    """Swing one pendulum for dt (s).

    This updates its omega and theta, and moves its bob and cord to the new angle.
    """
    omega, theta = angle_update(pend_dict["omega"], pend_dict["theta"], r_param, dt, g)
    pend_dict["omega"] = omega
    pend_dict["theta"] = theta
    show_pendulum(pend_dict, r_param)


def full_swing_update(pend_list: list[PendulumEntry], r_param: float, dt: float, g: float) -> None:
    """Swing every pendulum of the cradle for dt (s)."""
    for pend_dict in pend_list:
        swing_update(pend_dict, r_param, dt, g)
