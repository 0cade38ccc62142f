"""advance_cradle: what many calls of newton_cradle_tick do, on plain numbers, and the contacts on the way."""

import json
import random
import subprocess
import sys
from importlib.machinery import PathFinder
from math import cos, pi, sin

import pytest
from cradles import hang, R, row
from programs import ROOT
from whole_cradles import components, FIVE_CSV

from src import visualize_cradle_run
from src.swinging import angle_update
from src.visualize_cradle_run import advance_cradle, free_ticks, newton_cradle_tick

SEEDS = 30
DT, G = 1e-4, 9.81  # s, m/s^2: what comes when, below, is to stay so whatever becomes of the shipped ones


def random_cradle(seed):
    """Return pendula of any mass, e, angle, radius and place, in a row of 1 to 12, and what they are advanced by.

    In every second cradle each pendulum swings almost like the one before it, as bobs do that were lifted together.
    """
    dice = random.Random(seed)
    pend_list = []
    for i in range(dice.randint(1, 12)):
        theta, omega = dice.uniform(-1, 1), dice.choice([1, 1, 20]) * dice.uniform(-5, 5)
        if seed % 2 and i:
            before, spread = pend_list[-1], dice.choice([0, 1e-6, 1e-3])
            theta, omega = (before[key] + dice.uniform(-spread, spread) for key in ("theta", "omega"))
        values = {"theta": theta, "omega": omega, "e": dice.choice([0, 1, dice.random()])}
        axle = (i * R / 4, dice.choice([0, 0.01]), dice.choice([0, 0.01]))
        pend_list.append(hang(**values, mass=10 ** dice.uniform(-2, 2), axle=axle))
        pend_list[-1]["objects"][1].radius *= dice.choice([1, dice.uniform(0.5, 1.1)])
    ticks = dice.choice([1, 10, 500, 2000, 5000])
    usual = [(DT, G), (DT, G), (10 * DT, G), (DT, 1000)]
    dt, g = dice.choice([*usual, *usual, (1000 * DT, G), (DT, 0), (DT, -G), (0, G), (-DT, G)])
    return pend_list, {"r_param": dice.choice([R, R, R, -R]), "dt": dt, "g": g, "ticks": ticks}


def hair_breadth(seed):
    """Return two bobs far from the origin that swing side by side, as far apart as they reach, but for rounding."""
    dice = random.Random(seed)
    theta, x = dice.uniform(-1, 1), dice.choice([1, 10, 100])
    pend_list = [hang(theta, mass=mass, axle=(x + i * R / 4, 0, 0)) for i, mass in enumerate([1, 3])]
    for pend in pend_list:
        pend["objects"][1].radius = R / 8 / 1.05 * (1 + dice.choice([0, 1e-15, 1e-14, -1e-15, -1e-14]))
    return pend_list


def state(pend_list):
    """Return all numbers that a tick changes."""
    shown = [[components(shape.pos), components(shape.axis)] for pend in pend_list for shape in pend["objects"]]
    return [(pend["theta"], pend["omega"]) for pend in pend_list], shown


@pytest.mark.parametrize("approaching_only", [False, True])
@pytest.mark.parametrize("seed", range(SEEDS))
def test_it_does_to_the_last_bit_what_so_many_ticks_do(seed, approaching_only, monkeypatch):
    hits = []  # the left bobs of one tick

    def handle_two_bobs(pend1, pend2, r_param, approaching_only):
        before = pend1["omega"], pend2["omega"]
        original(pend1, pend2, r_param, approaching_only)
        if (pend1["omega"], pend2["omega"]) != before:
            hits.append(next(i for i, pend in enumerate(one_by_one) if pend is pend1))

    original = visualize_cradle_run.handle_two_bobs
    monkeypatch.setattr(visualize_cradle_run, "handle_two_bobs", handle_two_bobs)
    at_once, by = random_cradle(seed)
    told = advance_cradle(at_once, **by, approaching_only=approaching_only)
    one_by_one, by = random_cradle(seed)
    contacts = []
    for tick in range(by.pop("ticks")):
        newton_cradle_tick(one_by_one, **by, approaching_only=approaching_only)
        contacts += [(tick, left, left + 1) for left in hits]
        hits.clear()
    assert state(at_once) == state(one_by_one)
    assert told == contacts


@pytest.mark.parametrize("seed", range(20))
def test_so_it_does_where_bobs_are_out_of_reach_by_a_rounding_error(seed):
    at_once, one_by_one = hair_breadth(seed), hair_breadth(seed)
    advance_cradle(at_once, R, DT, G, 300)
    for _ in range(300):
        newton_cradle_tick(one_by_one, R, DT, G)
    assert state(at_once) == state(one_by_one)


def test_the_random_cradles_are_worth_it():
    """In many of them bobs hit, and in some of them two that part do, so that the two rules differ."""
    hits = differ = 0
    for seed in range(SEEDS):
        ends = []
        for approaching_only in (False, True):
            pend_list, by = random_cradle(seed)
            hits += bool(advance_cradle(pend_list, **by, approaching_only=approaching_only))
            ends.append(state(pend_list))
        differ += ends[0] != ends[1]
    assert hits > 20
    assert differ > 5


def test_no_ticks_change_nothing():
    pend_list, _ = random_cradle(1)
    before = state(pend_list)
    assert advance_cradle(pend_list, R, DT, G, 0) == []
    assert state(pend_list) == before


def test_it_tells_of_contacts_in_their_order():
    """The first bob runs through the row; the tick of a contact is the one in which omega changes."""
    pend_list = row(4)
    pend_list[0]["theta"] = -0.2
    contacts = advance_cradle(pend_list, R, DT, G, 4000, approaching_only=True)
    assert [pair for _, *pair in contacts] == [[0, 1], [1, 2], [2, 3]]
    first = contacts[0][0]
    again = row(4)
    again[0]["theta"] = -0.2
    assert advance_cradle(again, R, DT, G, first, approaching_only=True) == []
    assert advance_cradle(again, R, DT, G, 1, approaching_only=True)[0] == (0, 0, 1)


def test_bobs_that_touch_without_a_change_are_no_contact():
    pair = hang(omega=1.0), hang(omega=1.0, axle=(R / 8, 0, 0))
    assert advance_cradle(list(pair), R, DT, 0, 10) == []


def test_bobs_that_move_together_have_no_contacts_from_rounding():
    for masses in ((0.1, 0.7), (0.3, 0.1)):
        pair = [hang(0.3, 0.1, mass=mass, axle=(i * R / 8, 0, 0)) for i, mass in enumerate(masses)]
        assert advance_cradle(pair, R, DT, G, 300, approaching_only=True) == []


def test_a_contact_that_only_the_right_bob_notices_is_told():
    pair = [hang(omega=1.0, mass=1e20), hang(axle=(R / 8, 0, 0))]
    assert advance_cradle(pair, R, DT, 0, 1, approaching_only=True) == [(0, 0, 1)]
    assert [pend["omega"] for pend in pair] == [1, pytest.approx(2)]


@pytest.mark.parametrize("g", [0, G])
@pytest.mark.parametrize(("angle", "velocity"), [(1e-6, 1e-6), (0.1, 0.1), (3, 0.001), (1, 5), (0.01, 5), (3, 50)])
def test_no_two_bobs_touch_while_they_are_said_to_be_free(angle, velocity, g):
    """Bobs that fly straight at each other, and come closer by so much in so many ticks, are free for fewer ticks.

    Slow ones without gravity, side by side, are free for one tick fewer: there is no time to be lost.
    """
    dice = random.Random(1)
    for _ in range(50):
        theta1, theta2 = (dice.choice([0, pi / 2, pi]) + angle * dice.uniform(-1, 1) for _ in range(2))
        omega1, omega2 = (velocity * dice.choice([0, 1, dice.uniform(-1, 1)]) for _ in range(2))
        state = theta1, theta2, omega1, omega2
        before = arm(theta2) - arm(theta1)
        for tick in range(1, 150):
            omega1, theta1 = angle_update(omega1, theta1, R, DT, g)
            omega2, theta2 = angle_update(omega2, theta2, R, DT, g)
            closer = abs(arm(theta2) - arm(theta1) - before)
            free = free_ticks(closer, *state, R, DT, g)
            assert free < tick, (tick, state)
            if velocity == 1e-6 and g == 0 and abs(theta1 - theta2) < 0.1 and closer > 1e-6 * R:
                assert free == tick - 1


def arm(theta):
    """Return where a bob is, as seen from its axle (m), as a complex number."""
    return R * (sin(theta) - 1j * cos(theta))


PROGRAM = """
import json, sys, vpython
vpython.baseObj._view_constructed = True  # "the page is there": no server, no browser
from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import advance_cradle, newton_cradle_tick
from support.constants import DT, G, R_PARAM

ends = []
for many in (True, False):
    pend_list = make_newton_cradle(sys.argv[1], R_PARAM, -0.5)
    if many:
        advance_cradle(pend_list, R_PARAM, DT, G, 5000, True)
    else:
        for _ in range(5000):
            newton_cradle_tick(pend_list, R_PARAM, DT, G, True)
    ends.append([[p["theta"], p["omega"], *p["objects"][1].pos.value, *p["objects"][2].axis.value] for p in pend_list])
json.dump(ends, sys.stdout)
"""


@pytest.mark.skipif(PathFinder.find_spec("vpython") is None, reason="VPython is not installed")
def test_so_it_does_on_vpython_itself(tmp_path):
    (tmp_path / "cradle.csv").write_text(FIVE_CSV)
    command = [sys.executable, "-c", PROGRAM, str(tmp_path / "cradle.csv")]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    at_once, one_by_one = json.loads(done.stdout)
    for pend, same in zip(at_once, one_by_one, strict=True):
        assert pend == pytest.approx(same, rel=0, abs=1e-12)
