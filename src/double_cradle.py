"""The double Newton's cradle: each element is a double pendulum.

A second pendulum hangs from the first one's bob.

Words
    theta        the upper cord's angle from straight down (rad), positive to the right
    omega        the rate of theta (rad/s)
    phi          the lower cord's angle from the direction of the upper one (rad)
    phi_omega    the rate of phi (rad/s)
    alpha, beta  the angles of the two cords from straight down: alpha = theta, beta = theta + phi
    m1, m2       the masses of the upper and the lower bob (kg)
    R            the length of each cord (m)
    '            d/dt

Swing
    The upper bob moves along its arc with the velocity R alpha'. The lower bob has the same
    velocity, plus R beta' along its own arc. The angle between these two velocities is beta - alpha
    = phi. By the law of cosines, the energies are
        T = (m1 + m2) R^2 alpha'^2 / 2  +  m2 R^2 beta'^2 / 2  +  m2 R^2 alpha' beta' cos(phi)
        V = -(m1 + m2) g R cos(alpha)  -  m2 g R cos(beta)
    Lagrange's equations are d/dt dL/dq' = dL/dq with L = T - V, for q = alpha and for q = beta. For
    alpha,
        dL/dalpha' = (m1 + m2) R^2 alpha' + m2 R^2 beta' cos(phi)
        dL/dalpha  = m2 R^2 alpha' beta' sin(phi) - (m1 + m2) g R sin(alpha)
    With d/dt cos(phi) = -sin(phi) (beta' - alpha'), the terms with alpha' beta' cancel; for beta
    likewise. Divide the first equation by (m1 + m2) R^2, the second by m2 R^2. With mu = m2 / (m1 +
    m2), this gives
        alpha''           + mu cos(phi) beta'' =  mu sin(phi) beta'^2 - g/R sin(alpha)
        cos(phi) alpha''  +             beta'' =    - sin(phi) alpha'^2 - g/R sin(beta)
    double_accelerations solves these two linear equations for alpha'' and beta''. Source of L:
    Landau and Lifshitz, Mechanics, section 5, problem 1, with both lengths R.
"""

from collections.abc import Sequence
from math import ceil, cos, hypot, isnan, sin
from typing import TypeAlias

from vpython import box, cylinder, sphere, vector

from src.double_collisions import handle_two_double_bobs, keep_apart, SWEEPS, touching_pairs
from src.special_cradles import make_newton_cradle
from support.pendulum import (
    discard,
    DoublePendulumEntry,
    make_bob_and_cord,
    make_pendulum,
    show_double_pendulum,
)

# The cords of a pendulum turn at most about this far in one step (rad). With equal masses, they
# turn much less.
MOST_TURN = 0.05
MOST_STEPS = 1e6  # in one tick; if a pendulum needs more, a number is wrong

State: TypeAlias = tuple[float, float, float, float]  # alpha, beta, alpha', beta'


def make_double_pendulum(
    axle_pos: vector, r_param: float, theta: float, phi: float, color: vector, texture: str | None
) -> tuple[box, sphere, cylinder, sphere, cylinder]:
    """Return the VPython objects (axle, bob1, cord1, bob2, cord2) of a double pendulum.

    It hangs from axle_pos, a vector (m). r_param is the length of each cord (m), theta and
    phi are the angles (rad), color is a VPython color (a vector), and texture a VPython texture or
    None.
    """
    axle, bob1, cord1 = make_pendulum(axle_pos, r_param, theta, color, texture)
    bob2, cord2 = make_bob_and_cord(bob1.pos, r_param, theta + phi, color, texture)
    return axle, bob1, cord1, bob2, cord2


def make_double_newton_cradle(
    relative_filepath: str, r_param: float, theta_init: float, phi_init: float
) -> list[DoublePendulumEntry]:
    """Return the pend_list of a CSV as double pendula, ready to swing.

    Each one also gets theta, omega, phi, phi_omega and its five objects. It is the cradle of
    make_newton_cradle, with a second pendulum that hangs from each bob. phi_init (rad) bends the
    first double pendulum; the others are straight. Both bobs have the mass of the row. r_param (m)
    is the length of each cord.
    """
    pend_list: list = make_newton_cradle(relative_filepath, r_param, theta_init)
    phis = [phi_init] + [0] * (len(pend_list) - 1)
    for pend_dict, phi in zip(pend_list, phis, strict=True):
        axle, bob, _ = pend_dict["objects"]
        axle_pos = vector(axle.pos)
        color = vector(bob.color)
        texture = bob.texture
        discard(pend_dict["objects"])  # make_double_pendulum uses them again
        objects = make_double_pendulum(axle_pos, r_param, pend_dict["theta"], phi, color, texture)
        pend_dict.update(phi=phi, phi_omega=0, objects=objects)
    return pend_list


def double_accelerations(
    alpha: float, beta: float, alpha_rate: float, beta_rate: float, k: float, mu: float
) -> tuple[float, float]:
    """Return alpha'' and beta'' (rad/s^2), from the two equations above.

    alpha and beta are in rad, their rates in rad/s, k = g/R in 1/s^2, and mu = m2/(m1 + m2) has no
    unit.
    """
    s, c = sin(beta - alpha), cos(beta - alpha)
    right1 = mu * s * beta_rate * beta_rate - k * sin(alpha)
    right2 = -s * alpha_rate * alpha_rate - k * sin(beta)
    determinant = 1 - mu * c * c
    return (right1 - mu * c * right2) / determinant, (right2 - c * right1) / determinant


def rates(state: State, k: float, mu: float) -> State:
    """Return alpha', beta', alpha'' and beta'' of a state; k and mu are as above."""
    alpha, beta, alpha_rate, beta_rate = state
    return alpha_rate, beta_rate, *double_accelerations(alpha, beta, alpha_rate, beta_rate, k, mu)


def moved(state: State, its_rates: Sequence[float], dt: float) -> State:
    """Return the state after dt (s), if it changes at these rates."""
    alpha, beta, alpha_rate, beta_rate = state
    d1, d2, d3, d4 = its_rates
    return alpha + dt * d1, beta + dt * d2, alpha_rate + dt * d3, beta_rate + dt * d4


def double_angle_update(
    omega_theta: float,
    omega_phi: float,
    theta: float,
    phi: float,
    r_param: float,
    dt: float,
    g: float,
    m1: float = 1.0,
    m2: float = 1.0,
) -> tuple[float, float, float, float]:
    """Return (omega_theta, omega_phi, theta, phi) of a double pendulum after dt (s).

    They are in rad/s and rad. The first four arguments are the values before. r_param (m) is the
    length of each cord, g (m/s^2) the gravitational acceleration, m1 and m2 (kg) are the masses of
    the upper and the lower bob. You may use any method whose error gets smaller with dt.
    """
    # The motion is chaotic. Semi-implicit Euler has an error of order dt, and does not keep the
    # energy to 1e-6. So this is a step of the classical Runge-Kutta method, which has an error of
    # order dt^4. It averages four rates, with the weights 1, 2, 2, 1; six_rates has six times this
    # average. The new state is given by a formula, without the results of earlier ticks, which a
    # hit would make useless. If a cord turns far in a step, the step adds energy. This happens to
    # light bobs: between two bobs of a million times the mass, a bob can become a thousand times
    # as fast. double_swing_update divides such a tick.
    k, mu = g / r_param, m2 / (m1 + m2)
    state = theta, theta + phi, omega_theta, omega_theta + omega_phi
    k1 = rates(state, k, mu)
    k2 = rates(moved(state, k1, dt / 2), k, mu)
    k3 = rates(moved(state, k2, dt / 2), k, mu)
    k4 = rates(moved(state, k3, dt), k, mu)
    six_rates = [r1 + 2 * (r2 + r3) + r4 for r1, r2, r3, r4 in zip(k1, k2, k3, k4, strict=True)]
    alpha, beta, alpha_rate, beta_rate = moved(state, six_rates, dt / 6)
    return alpha_rate, beta_rate - alpha_rate, alpha, beta - alpha


def double_swing_update(
    pend_dict: DoublePendulumEntry, r_param: float, dt: float, g: float
) -> None:
    """Swing one double pendulum for dt (s).

    Update its angles and their rates, and move its bobs and cords there. A tick has more than
    one step only if a cord would turn further than MOST_TURN in it. Raises a ValueError if it would
    have more than MOST_STEPS.
    """
    mass = pend_dict["mass"]
    omega, phi_omega = pend_dict["omega"], pend_dict["phi_omega"]
    needed = hypot(omega, omega + phi_omega) * abs(dt) / MOST_TURN
    if isnan(needed) or needed > MOST_STEPS:
        speeds = f"omega = {omega:g} and phi_omega = {phi_omega:g} rad/s"
        raise ValueError(f"a pendulum with {speeds} is too fast")
    steps = max(1, ceil(needed))
    theta, phi = pend_dict["theta"], pend_dict["phi"]
    for _ in range(steps):
        omega, phi_omega, theta, phi = double_angle_update(
            omega, phi_omega, theta, phi, r_param, dt / steps, g, mass, mass
        )
    pend_dict.update(  # type: ignore[call-arg]
        omega=omega, phi_omega=phi_omega, theta=theta, phi=phi
    )
    show_double_pendulum(pend_dict, r_param)


def collide_pairs(pend_list: list[DoublePendulumEntry], r_param: float) -> list[tuple[int, int]]:
    """Let touching double pendula collide, pair by pair from left to right.

    Not only neighbours touch: a lower bob swings past its neighbour's cord to the bobs behind it.
    The pairs collide again while there are hits, up to SWEEPS times. Return the pairs that
    collided, in the order of their hits, as (left, right), indices into pend_list.
    """
    pairs = touching_pairs(pend_list, r_param)
    hits: list[tuple[int, int]] = []
    for _ in range(SWEEPS):
        sweep = [
            (left, right)
            for left, right in pairs
            if handle_two_double_bobs(pend_list[left], pend_list[right], r_param)
        ]
        if not sweep:
            break
        hits += sweep
    return hits


def double_cradle_tick(
    pend_list: list[DoublePendulumEntry], r_param: float, dt: float, g: float
) -> None:
    """Advance the whole cradle by dt (s): swing all double pendula, then let touching bobs collide.

    The bobs of any two pendula can touch, not only those of neighbours.
    """
    for pend_dict in pend_list:
        double_swing_update(pend_dict, r_param, dt, g)
    hits = collide_pairs(pend_list, r_param)
    for left, right in sorted(set(hits)):  # a pair can hit more than once
        if keep_apart(pend_list[left], pend_list[right], r_param):
            show_double_pendulum(pend_list[left], r_param)
            show_double_pendulum(pend_list[right], r_param)
