"""The player: its frames in step with the clock, and a main that is no loop of ticks."""

import re
import signal
from contextlib import suppress
from types import SimpleNamespace
from unittest.mock import patch

import pytest
from whole_cradles import make_live, settings_for

from src import visualize_cradle_run
from support.constants import DT
from support.cradle.player import Player, run
from support.cradle.real_time import FRAME, MAX_BEHIND, RealTime
from support.start.end import ended_quietly, SignalError
from support.start.mistake import MistakeError

# --- the pace -----------------------------------------------------------------------------------


class Timed(Player):
    """Plays five pendula on a clock of the test until its time `until`.

    Only ticks, calls of the fast path, and sleeps take time.
    """

    def __init__(self, csv, until, tick=0.0, call=0.0, speed=1.0, hiccup=0.0):
        """A tick costs `tick`, a call of the fast path `call`; hiccup delays frame 60 (s)."""
        cradle = make_live()
        super().__init__(cradle, settings_for(cradle, csv), 100 * DT)
        self.until, self.tick, self.call, self.hiccup = until, tick, call, hiccup
        self.now = self.slept = 0.0
        self.frames = 0
        self.pace = RealTime(DT, lambda: self.now, self.sleep)
        self.pace.speed = speed
        self.cradle.many_ticks = SimpleNamespace(many_ticks=self.do_call) if call else None

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


@pytest.mark.parametrize(("tick", "speed"), [(10e-6, 0.1), (30e-6, 2)])
def test_a_simulated_second_lasts_a_second_at_speed_1(csv, tick, speed):
    timed = Timed(csv, until=2, tick=tick, speed=speed)
    assert timed.run() == pytest.approx(2 * speed, abs=2 * FRAME * speed)
    assert timed.pace.kept_up == pytest.approx(1, abs=0.02)
    assert timed.frames == pytest.approx(2 / FRAME, rel=0.01)
    # Whenever nothing is to do
    assert timed.slept == pytest.approx(2 * (1 - tick * speed / DT), abs=2 * FRAME)


@pytest.mark.parametrize("tick", [1e-3, 5e-3])
def test_a_slow_machine_shows_slow_motion(csv, tick):
    """Pictures keep coming, the simulation moves on steadily.

    The threads of the page get time, too.
    """
    timed = Timed(csv, until=10, tick=tick)
    assert timed.run() == pytest.approx(0.75 * 10 / tick * DT, rel=0.35)
    assert timed.frames == pytest.approx(10 / FRAME, rel=0.2)
    assert timed.slept > 10 / 6
    assert timed.pace.kept_up == pytest.approx(timed.motion.ticks * DT / 10, rel=0.1)
    assert timed.pace.remark() == f"{timed.pace.kept_up:.2g}x real time"


@pytest.mark.parametrize(("tick", "call", "part"), [(0.1, 0.0, 1), (1e-6, 0.1, 100)])
def test_a_tick_or_a_call_longer_than_a_frame_ends_in_no_spiral(csv, tick, call, part):
    """Each frame does one tick, or one whole part in a call."""
    timed = Timed(csv, until=20, tick=tick, call=call)
    timed.run()
    # The threads of the page get time, too
    assert timed.frames == pytest.approx(20 / (0.1 + FRAME / 4), abs=3)
    assert timed.motion.ticks == pytest.approx(part * timed.frames, rel=0.02)


@pytest.mark.parametrize(("hiccup", "made_up"), [(0.2, 0.2), (8 * 3600.0, MAX_BEHIND)])
def test_a_short_delay_is_made_up_for_and_a_long_one_is_not(csv, hiccup, made_up):
    timed = Timed(csv, until=3 + hiccup, tick=1e-6, speed=0.5, hiccup=hiccup)
    assert timed.run() == pytest.approx((3 + made_up) * 0.5, abs=1.5 * FRAME)


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
    exec(PROGRAM + rest, scope)
    with pytest.raises(MistakeError, match=re.escape(f"main {message}")):
        run(scope["main"], timed)


class Loses(Timed):
    """Gets a signal in its first frame, and loses the error, as Python does in a callback."""

    def frame(self):
        super().frame()
        if self.frames == 1:
            with suppress(SignalError):
                signal.raise_signal(signal.SIGTERM)


def test_a_signal_ends_the_loop_also_if_its_error_is_lost(csv):
    player = Loses(csv, until=1)
    with pytest.raises(SignalError), ended_quietly():
        player.run()
    assert player.frames == 1
