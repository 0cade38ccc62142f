"""A cradle in motion: its time, energy and impacts."""

from itertools import chain

import pytest
from vpython import cylinder, mag2
from whole_cradles import PERIOD, velocities

from grading.cradles import MIXED_CSV
from support.constants import DT, G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.impacts import Impacts


@pytest.mark.parametrize("kind", [Cradle, DoubleCradle])
def test_a_sample_has_all_figures_of_the_moment_by_their_names(swing, kind):
    """The energies and the momentum are sums over the bobs of three unequal pendula."""
    player = swing(MIXED_CSV, kind=kind)
    ticks = round(PERIOD / kind.dt)  # until all bobs move
    player.swing(ticks)
    expected = {"t": ticks * kind.dt}
    pend_list = player.cradle.pend_list
    for key in (*kind.angle_keys, *kind.rate_keys):
        for i, pend in enumerate(pend_list, start=1):
            expected[f"{key}_{i}"] = pend[key]
    kinetic, potential, momentum = 0.0, 0.0, 0.0
    for pend in pend_list:
        axle, *bobs = (part.pos.y for part in pend["objects"] if type(part) is not cylinder)
        for cords, (y, v) in enumerate(zip(bobs, velocities(pend), strict=True), start=1):
            kinetic += pend["mass"] * mag2(v) / 2
            potential += pend["mass"] * G * (y - axle + cords * R_PARAM)
            momentum += pend["mass"] * v.x
    expected["kinetic"] = kinetic
    expected["potential"] = potential
    expected["total"] = kinetic + potential
    expected["momentum"] = momentum
    sample = player.motion.sample()
    assert sample == pytest.approx(expected, rel=1e-12)
    assert list(sample) == list(expected)


# --- impacts ------------------------------------------------------------------------------------

GAP = 0.005  # s, between two series
SLOW = [(left, left + 1, False) for left in range(4)]
LIE = [SLOW[0], SLOW[1]] * 100  # three bobs that lie on each other


def lines(*all_series, pause=DT):
    """Return the lines after these series, 0.1 s apart: lists of hits, `pause` (s) apart.

    A hit is (from, to), indices of bobs, and maybe False for a slow one; 2 is short for (2, 3).
    """
    impacts = Impacts(5, GAP)
    for i, series in enumerate(all_series):
        for number, hit in enumerate(series):
            start, end, *is_fast = hit if isinstance(hit, tuple) else (hit, hit + 1)
            time = 0.1 * i + number * pause
            impacts.add(time, min(start, end), max(start, end), start < end, *is_fast)
    return impacts.lines()


def test_a_long_pause_ends_a_series():
    """The latest series comes first."""
    assert lines([0, 1, 2], pause=0.9 * GAP) == ["t = 0.00 s  1-2-3-4"]
    ended = ["t = 0.02 s  3-4", "t = 0.01 s  2-3", "t = 0.00 s  1-2"]
    assert lines([0, 1, 2], pause=2 * GAP) == ended


def test_a_series_begins_with_its_first_fast_hit():
    assert lines([SLOW[0], SLOW[0], 0, 1, 2], pause=0.9 * GAP) == ["t = 0.01 s  1-2-3-4"]


@pytest.mark.parametrize(
    ("all_series", "expected"),
    [
        # A chain has its bobs in the order of the hits.
        # Two bobs come in from the left, two go out.
        ([[1, 0, 2, 1, 3, 2]], ["0.00 s  2-3-4-5  1-2-3-4"]),
        # The first and the last bob come in.
        ([[0, (4, 3), (3, 2), 1, 0, 2, 3]], ["0.00 s  1-2-3-4-5  5-4-3-2-1"]),
        # In a double cradle, a hit goes past a neighbour.
        ([[(0, 2), 2, (2, 4)]], ["0.00 s  1-3-4  3-5"]),
        ([[0, 0, 0, 0]], ["0.00 s  1-2"]),  # two bobs that touch for a moment
        ([range(9)], ["0.00 s  1-2-3-...-10"]),
        ([[0, 1, 2, 3] * 15], ["0.00 s  1-2-3-4-5  1-2-3-4-5  1-2-3-4..."]),
        # Half of a hundred bobs are lifted: the two in the middle hit fifty times.
        (
            [chain(*[range(i, i + 50) for i in reversed(range(50))])],
            ["0.00 s  50-51-52-...-100  49-50-51-....."],
        ),
        # Slow hits have no line, and no place in a chain.
        (
            [[SLOW[0]], [0, SLOW[3], 1], [SLOW[2]], [SLOW[1]], [SLOW[0], 0, 1, 2]],
            ["0.40 s  1-2-3-4", "0.10 s  1-2-3"],
        ),
        # Bobs that keep touching from swing to swing take one line, with those that join them.
        ([[0, 1], LIE, [*LIE, *[2] * 100], LIE], ["0.10 s  1 to 4 keep touching", "0.00 s  1-2-3"]),
        ([LIE, [SLOW[0]], LIE], ["0.00 s  1 to 3 keep touching"]),
        ([LIE, [SLOW[3]] * 21], ["0.00 s  1 to 3, 4 and 5 keep touching"]),
        ([[*LIE, 3]] * 25, ["0.00 s  1 to 3 keep touching"]),  # 4 hits 5 once in each swing
        ([*[[0, 1]] * 5, *[[SLOW[1]]] * 20], [f"0.{i}0 s  1-2-3" for i in (4, 3, 2, 1, 0)]),
    ],
)
def test_each_series_has_a_line_but_those_that_would_fill_the_list_share_one(all_series, expected):
    assert lines(*all_series) == [f"t = {line}" for line in expected]


def test_bobs_that_touch_for_ever_take_no_more_memory():
    impacts = Impacts(5, GAP)
    for tick in range(10_000):
        impacts.add(tick * DT, tick % 4, tick % 4 + 1, True)
    assert sum(map(len, impacts.series[0].chains)) < 100


def test_bobs_that_hang_have_no_impacts_although_each_series_leaves_them_in_slight_motion(swing):
    player = swing(lift=3)
    player.swing(round(5 * PERIOD / DT))
    assert player.motion.hit_count > 60  # that is, more than six in each of ten series
    chains = [line.partition(" s  ")[2] for line in player.impacts()]
    assert chains == ["3-2-1  4-3-2  5-4-3", "3-4-5  2-3-4  1-2-3"] * 2
