"""A cradle in motion: its time, energy and impacts; the player's frames, and their pace."""

import re
from collections import ChainMap
from itertools import chain
from unittest.mock import patch

import pytest
from vpython import cylinder, mag2
from whole_cradles import make_live, PERIOD, velocities

from grading.cradles import MIXED_CSV
from src import visualize_cradle_run
from support.constants import DT, G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.double_cradle import DoubleCradle
from support.cradle.impacts import Impacts
from support.cradle.player import Player, run
from support.cradle.real_time import FRAME, MAX_BEHIND, RealTime
from support.files.cradle_csv import Snapshot
from support.start.mistake import MistakeError


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
        # Bobs that stay together from swing to swing take one line, with those that join them.
        ([[0, 1], LIE, [*LIE, *[2] * 100], LIE], ["0.10 s  1 to 4 stay together", "0.00 s  1-2-3"]),
        ([LIE, [SLOW[0]], LIE], ["0.00 s  1 to 3 stay together"]),
        ([LIE, [SLOW[3]] * 21], ["0.00 s  1 to 3, 4 and 5 stay together"]),
        ([[*LIE, 3]] * 25, ["0.00 s  1 to 3 stay together"]),  # 4 hits 5 once in each swing
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


# --- the pace -----------------------------------------------------------------------------------


class Timed(Player):
    """Plays five pendula on a clock of the test until its time `until`.

    Only ticks, calls of the fast path, and sleeps take time.
    """

    def __init__(self, csv, until, tick=0.0, call=0.0, speed=1.0, hiccup=0.0):
        """A tick costs `tick`, a call of the fast path `call`; hiccup delays frame 60 (s)."""
        super().__init__(make_live(), Snapshot(csv), [None], None, 4, 100 * DT)
        self.until, self.tick, self.call, self.hiccup = until, tick, call, hiccup
        self.now = self.slept = 0.0
        self.frames = 0
        self.pace = RealTime(DT, lambda: self.now, self.sleep)
        self.pace.speed = speed
        self.cradle.many_ticks = self.do_call if call else None

    def do_tick(self, *_, **__):
        self.now += self.tick

    def do_call(self, scope, pend_list, ticks, rule):
        self.now += self.call + ticks * self.tick
        return []

    def sleep(self, seconds):
        assert seconds >= 0
        self.frames += 1
        self.slept += seconds
        self.now += seconds
        if self.frames == 60:
            self.now += self.hiccup

    def frame(self):
        self.pace.rest()
        self.keep_time()
        self.is_over = self.now >= self.until

    def run(self):
        """Run until the time `until`; return the simulated time (s)."""
        self.is_over = False
        with patch.object(visualize_cradle_run, "newton_cradle_tick", self.do_tick):
            run(visualize_cradle_run.main, self)
        return self.motion.ticks * DT


@pytest.mark.parametrize(("tick", "speed"), [(0, 1), (10e-6, 0.1), (30e-6, 2)])
def test_a_simulated_second_lasts_a_second_at_speed_1(csv, tick, speed):
    timed = Timed(csv, until=5, tick=tick, speed=speed)
    assert timed.run() == pytest.approx(5 * speed, abs=2 * FRAME * speed)
    assert timed.pace.kept_up == pytest.approx(1, abs=0.02)
    assert timed.frames == pytest.approx(5 / FRAME, rel=0.01)
    # Whenever nothing is to do
    assert timed.slept == pytest.approx(5 * (1 - tick * speed / DT), rel=0.01)


@pytest.mark.parametrize("tick", [200e-6, 1e-3, 5e-3])
def test_a_slow_machine_shows_slow_motion(csv, tick):
    """Pictures keep coming, the simulation moves on steadily.

    The threads of the page get time, too.
    """
    timed = Timed(csv, until=20, tick=tick)
    assert timed.run() == pytest.approx(0.75 * 20 / tick * DT, rel=0.35)
    assert timed.frames == pytest.approx(20 / FRAME, rel=0.2)
    assert timed.slept > 20 / 6
    assert timed.pace.kept_up == pytest.approx(timed.motion.ticks * DT / 20, rel=0.1)
    assert timed.pace.remark() == f"{timed.pace.kept_up:.2g}x real time"


@pytest.mark.parametrize(("tick", "call", "part"), [(0.1, 0.0, 1), (1e-6, 0.1, 100)])
def test_a_tick_or_a_call_longer_than_a_frame_ends_in_no_spiral(csv, tick, call, part):
    """Each frame does one tick, or one whole part in a call."""
    timed = Timed(csv, until=20, tick=tick, call=call)
    timed.run()
    # The threads of the page get time, too
    assert timed.frames == pytest.approx(20 / (0.1 + FRAME / 4), abs=3)
    assert timed.motion.ticks == pytest.approx(part * timed.frames, rel=0.02)


@pytest.mark.parametrize(
    ("hiccup", "made_up"), [(0.2, 0.2), (5, MAX_BEHIND), (8 * 3600.0, MAX_BEHIND)]
)
@pytest.mark.parametrize("speed", [0.1, 2])
def test_a_short_delay_is_made_up_for_and_a_long_one_is_not(csv, speed, hiccup, made_up):
    timed = Timed(csv, until=3 + hiccup, tick=1e-6, speed=speed, hiccup=hiccup)
    assert timed.run() == pytest.approx((3 + made_up) * speed, abs=3 * FRAME * speed)


def test_after_a_pause_or_a_change_of_the_speed_slow_motion_is_forgotten(csv):
    timed = Timed(csv, until=5, tick=1e-3)
    timed.run()
    timed.now += 100
    timed.pace.restart()
    assert timed.pace.kept_up == 1
    assert timed.pace.due() == 0
    timed.tick = 10e-6
    for speed, seconds in ((0.1, 3.5), (2, 1.1)):
        timed.pace.speed = speed
        timed.until = timed.now + seconds
        timed.run()
        assert timed.pace.kept_up == pytest.approx(1, abs=0.02)
        assert timed.pace.remark() == ""


# --- a main that is no loop of ticks ------------------------------------------------------------

PROGRAM = """
def newton_cradle_tick(*_):
    pass

def main(page):
    def make():
        return make_newton_cradle(page.csv, R_PARAM, THETA_INIT)

    def tick():
        newton_cradle_tick(pend_list, R_PARAM, DT, G)

    pend_list = make()
"""
SHOWS_NOTHING = """
    while page.is_running():
        tick()
"""
LEAVES_ITS_LOOP = """
    page.show(pend_list)
    while page.is_running():
        tick()
        break
"""
DOES_NOT_HEAR_THE_ANSWER = """
    page.show(pend_list)
    while True:
        page.is_running()
        tick()
"""
MAKES_IT_AGAIN = """
    page.show(pend_list)
    while page.is_running():
        pend_list = make()
"""
SHOWS_IT_AGAIN = """
    page.show(pend_list)
    while page.is_running():
        page.show(pend_list)
"""


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        (SHOWS_NOTHING, "asked page.is_running() before page.show(pend_list)."),
        ("", "showed no cradle: page.show(pend_list) is missing."),
        (LEAVES_ITS_LOOP, "ended, but the simulation still runs. Tick while page.is_running() is"),
        (DOES_NOT_HEAR_THE_ANSWER, "went on after"),
        (MAKES_IT_AGAIN, "used page.csv after page.show. Make the cradle"),
        (SHOWS_IT_AGAIN, "called page.show again. Show the cradle once,"),
    ],
)
def test_a_main_that_is_no_loop_of_ticks_is_named_with_its_mistake(csv, rest, message):
    timed = Timed(csv, until=1)
    scope = dict(vars(visualize_cradle_run))
    timed.cradle.scope = ChainMap(scope)
    exec(PROGRAM + rest, scope)
    with pytest.raises(MistakeError, match=re.escape(f"main {message}")):
        run(scope["main"], timed)
    assert scope["newton_cradle_tick"].__name__ == "newton_cradle_tick"  # it is in its place again
