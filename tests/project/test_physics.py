"""The laws of motion, held against the exact figures of support/energy.py, at the shipped constants.

All of it is done by many_ticks, which test_many_ticks.py holds to newton_cradle_tick.
"""

import random
from math import cos, degrees, isfinite, radians, sqrt

import numpy as np
import pytest
from programs import slow_but_for
from whole_cradles import do_at_once

from grading.cradles import hang
from src import visualize_cradle_run
from src.beyond import many_ticks
from support.constants import DT, G, R_PARAM, THETA_INIT
from support.energy import energy_left, exact_period, kinetic_energy, potential_energy

SAMPLE = 0.01  # s between two looks at a cradle


def make_row(count, theta=0.0, **values):
    """Return pendula with these values (as for hang), the first one at theta (rad), the others hanging."""
    row = [hang(axle=(i * R_PARAM / 4, 0, 0), r_param=R_PARAM, **values) for i in range(count)]
    row[0]["theta"] = theta
    return row


def energy(pend_list):
    """Return the total energy (J)."""
    return kinetic_energy(pend_list, R_PARAM) + potential_energy(pend_list, R_PARAM, G)


def after_hits(pend_list, hits):
    """Advance the cradle, and yield right after each of its first hits, of which there are two in a period."""
    for _ in range(round(hits * exact_period(1, R_PARAM, G) / DT)):
        if hits and do_at_once(pend_list, R_PARAM, DT, G, 1, approaching_only=True):
            hits -= 1
            yield
    assert hits == 0


@pytest.mark.parametrize("release", slow_but_for([45], range(5, 65, 5)))  # degrees
def test_five_equal_elastic_bobs_for_a_minute(release):
    pend_list = make_row(5, -radians(release))
    at_start = energy(pend_list)
    energies, highest = [], [[], [], [], [], []]
    for _ in range(round(60 / SAMPLE)):
        do_at_once(pend_list, R_PARAM, DT, G, round(SAMPLE / DT), approaching_only=True)
        energies.append(energy(pend_list) / at_start)
        for angles, pend in zip(highest, pend_list, strict=True):
            angles.append(abs(degrees(pend["theta"])))
    assert 0.999 < min(energies) <= max(energies) < 1.001
    first_peak = max(highest[4][: round(exact_period(radians(release), R_PARAM, G) / SAMPLE)])
    assert first_peak == pytest.approx(release, rel=0.001)
    assert max(map(max, highest[1:4])) < 1.5


@pytest.mark.parametrize("amplitude", slow_but_for([30], [5, 30, 60, 90, 120, 150, 170]))  # degrees
def test_the_period_of_one_pendulum_over_twenty_swings(amplitude):
    theta_max = radians(amplitude)
    pend_list = make_row(1, theta_max)
    expected = exact_period(theta_max, R_PARAM, G)
    crossings = []  # times (s) at the lowest point, from the right
    for tick in range(0, round(20.5 * expected / DT), 10):
        before = pend_list[0]["theta"]
        do_at_once(pend_list, R_PARAM, DT, G, 10)
        after = pend_list[0]["theta"]
        if before > 0 >= after:
            crossings.append((tick + 10 * before / (before - after)) * DT)
    assert len(crossings) == 21
    assert (crossings[-1] - crossings[0]) / 20 == pytest.approx(expected, rel=0.0005)


@pytest.mark.parametrize("e", slow_but_for([0.9], [0.99, 0.9, 0.5, 0.1]))
def test_the_energy_that_two_equal_bobs_have_left(e):
    pend_list = make_row(2, THETA_INIT, e=e)
    at_start = energy(pend_list)
    for hits, _ in enumerate(after_hits(pend_list, 5), start=1):
        assert energy(pend_list) / at_start == pytest.approx(energy_left(e, hits), rel=0.005)


@pytest.mark.parametrize(
    ("masses", "theta", "speeds"),
    [
        # They part with 1/2 of the speed at the lowest point each, come back together, and then the first has it all.
        ((1, 3), THETA_INIT, [(1 / 2, 1 / 2), (1, 0)]),
        # 1/2 and 3/2. So unlike each other they come back together only from a small angle.
        ((3, 1), -0.05, [(1 / 2, 3 / 2), (1, 0)]),
    ],
)
def test_the_speeds_of_masses_1_and_3_after_each_hit(masses, theta, speeds):
    pend_list = make_row(2, theta)
    for pend, mass in zip(pend_list, masses, strict=True):
        pend["mass"] = mass
    lowest = sqrt(2 * G * R_PARAM * (1 - cos(theta)))  # m/s, of the first bob as it comes down
    for hits, _ in enumerate(after_hits(pend_list, 6)):
        found = [abs(R_PARAM * pend["omega"]) / lowest for pend in pend_list]
        assert found == pytest.approx(speeds[hits % 2], rel=0, abs=0.001)


@pytest.mark.parametrize("cradles", slow_but_for([30], [30, 300]))
def test_random_cradles_keep_the_laws_in_each_contact_by_both_rules(monkeypatch, cradles):
    contacts, cradles_with_contacts = [], 0  # each the masses, and the velocities (rad/s) before and after

    def handle_collision(e, omega1, omega2, m1, m2, r_param):
        after = original(e, omega1, omega2, m1, m2, r_param)
        contacts.append((m1, m2, omega1, omega2, *after))
        return after

    original, known_law = visualize_cradle_run.handle_collision, many_ticks.known_law
    # Of a function that is another, the fast path knows nothing: it is told so behind its back.
    monkeypatch.setattr(many_ticks, "known_law", lambda of: known_law(of)._replace(handle_collision=handle_collision))
    dice = random.Random(2)
    for number in range(cradles):
        pend_list = make_row(dice.randint(2, 10))
        thetas = sorted(dice.choice([0, dice.uniform(-1, 1)]) for _ in pend_list)  # so that no bob is within another
        for pend, pend["theta"] in zip(pend_list, thetas, strict=True):
            pend["mass"], pend["e"] = 10 ** dice.uniform(-6, 6), dice.choice([0, 1, dice.random()])
        do_at_once(pend_list, R_PARAM, DT, G, round(1 / DT), approaching_only=number % 3)
        assert all(isfinite(pend[key]) for pend in pend_list for key in ("theta", "omega"))
        m1, m2, before1, before2, after1, after2 = np.array(contacts).reshape(-1, 6).T
        cradles_with_contacts += bool(contacts)
        contacts.clear()
        momentum = m1 * before1 + m2 * before2  # but for the cord, and below twice the energy
        scale = m1 * abs(before1) + m2 * abs(before2)
        assert np.all(abs(m1 * after1 + m2 * after2 - momentum) <= 1e-12 * scale)
        before, after = m1 * before1**2 + m2 * before2**2, m1 * after1**2 + m2 * after2**2
        assert np.all(after <= before * (1 + 1e-12))
    assert cradles_with_contacts > 0.8 * cradles
