"""The programs' five equal elastic pendula as theory has them, and how far others are from them."""

from functools import partial
from math import cos, hypot, sin

import numpy as np
from scipy.integrate import solve_ivp

from grading.cradles import hang
from support.constants import G, R_PARAM, THETA_INIT
from support.pendulum import contact_distance

SAMPLE = 0.01  # s between two looks at a cradle

# A state has the thetas (rad) of all pendula, and then their omegas (rad/s).


def motion(_, state):
    """Return the rates of change of a state without hits."""
    thetas, omegas = np.split(state, 2)
    return np.concatenate([omegas, -G / R_PARAM * np.sin(thetas)])


def gap(left, contact, _, state):
    """Return the gap (m) between this bob and the next one: at 0, they hit each other."""
    theta1, theta2 = state[left : left + 2]
    x = R_PARAM * (1 / 4 + sin(theta2) - sin(theta1))
    y = R_PARAM * (cos(theta2) - cos(theta1))
    return hypot(x, y) - contact


def exact_outer_angles(seconds):
    """Return the outer_angles of the exact cradle, computed in steps of at most SAMPLE (s).

    Equal elastic bobs exchange their velocities, at the instant of their hit.
    """
    _, bob, _ = hang(r_param=R_PARAM)["objects"]
    contact = contact_distance(bob.radius, bob.radius)
    hits = [partial(gap, left, contact) for left in range(4)]
    for hit in hits:
        hit.terminal = True
        hit.direction = -1
    accuracy = {"method": "DOP853", "max_step": SAMPLE, "rtol": 1e-12, "atol": 1e-12}
    samples = SAMPLE * np.arange(1, round(seconds / SAMPLE) + 1)
    time, state = 0.0, np.array([THETA_INIT] + [0.0] * 9)
    pairs = []
    while len(pairs) < len(samples):
        ahead = samples[len(pairs) :]
        part = solve_ivp(motion, (time, samples[-1]), state, t_eval=ahead, events=hits, **accuracy)
        if len(part.t):
            pairs.extend(part.y[[0, 4]].T)
        for left, times in enumerate(part.t_events):
            if len(times):
                time, state = times[0], part.y_events[left][0]
                state[[5 + left, 6 + left]] = state[[6 + left, 5 + left]]
    return np.degrees(pairs)


def outer_angles(advance, seconds):
    """Return theta (degrees) of the first and the last pendulum at each SAMPLE.

    advance(SAMPLE) moves the cradle on, and returns all thetas (rad).
    """
    pairs = []
    for _ in range(round(seconds / SAMPLE)):
        first, *_, last = advance(SAMPLE)
        pairs.append((first, last))
    return np.degrees(pairs)


def apart(angles1, angles2):
    """Return the root of the mean square of the differences."""
    return np.sqrt(np.mean((angles1 - angles2) ** 2))
