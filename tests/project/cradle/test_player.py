"""The player: its frames in step with the clock, and the programs that it runs."""

import re
import signal

import pytest
from programs import call
from whole_cradles import settings_for

from src.special_cradles import make_newton_cradle
from support import constants
from support.constants import DT, R_PARAM, THETA_INIT
from support.cradle.cradle import Cradle
from support.cradle.player import Player, run_for_each_cradle
from support.cradle.real_time import BUSY, FRAME, MAX_BEHIND, RealTime
from support.start.end import ended_quietly
from support.start.mistake import MistakeError

# --- the pace -----------------------------------------------------------------------------------


REST = FRAME - BUSY  # s, for the threads of the page


class Timed(Player):
    """Plays five pendula on a clock of the test until its time `until`.

    Only ticks and sleeps take time.
    """

    def __init__(self, csv, until, tick, speed=1.0, hiccup=0.0):
        """A tick takes `tick` (s); hiccup (s) delays frame 60."""
        super().__init__(Cradle(), settings_for(csv), 100 * DT)
        self.until, self.tick, self.hiccup = until, tick, hiccup
        self.now = 0.0
        self.frames = 0
        self.pace = RealTime(DT, lambda: self.now, self.sleep)
        self.pace.speed = speed
        self.begin()
        self.pend_list = make_newton_cradle(csv, R_PARAM, THETA_INIT)

    def sleep(self, seconds):
        assert seconds >= 0
        self.frames += 1
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
        while self.is_running(self.pend_list):
            self.now += self.tick
        return self.motion.ticks * DT


@pytest.mark.parametrize(("tick", "frame", "ticks"), [(3e-3, FRAME, 5), (0.1, 0.1 + REST, 1)])
def test_a_slow_machine_shows_slow_motion(csv, tick, frame, ticks):
    """Pictures keep coming, each after this number of ticks, also if a tick is longer than a frame.

    The threads of the page get time, too.
    """
    timed = Timed(csv, until=20, tick=tick)
    assert timed.run() == pytest.approx(ticks * timed.frames * DT, rel=0.05)
    assert timed.frames == pytest.approx(20 / frame, rel=0.05)
    assert timed.pace.kept_up == pytest.approx(timed.motion.ticks * DT / 20, rel=0.1)


@pytest.mark.parametrize(("hiccup", "made_up"), [(0.2, 0.2), (8 * 3600.0, MAX_BEHIND)])
def test_a_short_delay_is_made_up_for_and_a_long_one_is_not(csv, hiccup, made_up):
    timed = Timed(csv, until=3 + hiccup, tick=1e-6, speed=0.1, hiccup=hiccup)
    assert timed.run() == pytest.approx((3 + made_up) * 0.1, abs=0.15 * FRAME)
    assert timed.frames == pytest.approx(3 / FRAME, rel=0.02)


def test_after_a_pause_slow_motion_is_forgotten(csv):
    timed = Timed(csv, until=5, tick=1e-3)
    timed.run()
    timed.now += 100
    timed.pace.restart()
    assert timed.pace.remark() == ""
    assert timed.pace.due() == 0


# --- a program ----------------------------------------------------------------------------------

PROGRAM = """
from src.special_cradles import make_newton_cradle
from src.visualize_cradle_run import newton_cradle_tick
from support.constants import DT, G, NC_FP, R_PARAM, THETA_INIT
from support.simulation import is_running

pend_list = make_newton_cradle(NC_FP, R_PARAM, THETA_INIT)
"""
LOOP = """
while is_running(pend_list):
    newton_cradle_tick(pend_list, R_PARAM, DT, G)
"""


class Ticks(Player):
    """Plays five ticks, and then another cradle, `again` times."""

    def __init__(self, csv, again=0):
        super().__init__(Cradle(), settings_for(csv), 1.0)
        self.again = again
        self.seen = []  # each cradle's thetas at the end

    def frame(self):
        self.plan(5 - self.motion.ticks)
        if not self.planned:
            self.seen.append(self.cradle.values("theta"))
            self.is_over = len(self.seen) > self.again
            if not self.is_over:
                self.next_cradle.want()


@pytest.fixture
def play(tmp_path):
    """A function that runs PROGRAM with this end; it returns the player."""

    def play(player, end):
        file = tmp_path / "program.py"
        file.write_text(PROGRAM + end)
        run_for_each_cradle(file, player)
        return player

    return play


def test_a_program_runs_again_from_its_top_for_each_cradle(csv, play, capsys):
    before = constants.NC_FP
    player = play(Ticks(csv, again=2), f"print(NC_FP){LOOP}")
    assert capsys.readouterr().out == f"{csv}\n" * 3
    assert player.seen[0] == player.seen[1] == player.seen[2]
    assert before == constants.NC_FP


@pytest.mark.parametrize("end", ["", f"{LOOP}    break", "exit()"])
def test_a_program_that_ends_before_the_simulation_is_told_to_tick_on(csv, play, end):
    message = "The program has ended, but the simulation goes on. Tick while is_running(pend_list)"
    with pytest.raises(MistakeError, match=f"^{re.escape(message)}"):
        play(Ticks(csv), end)


class Callback:
    """Gets a signal where Python loses errors."""

    def __del__(self):
        signal.raise_signal(signal.SIGTERM)


class Loses(Timed):
    """Gets a signal in a callback in its first frame."""

    def frame(self):
        super().frame()
        if self.frames == 1:
            Callback()


def test_a_signal_ends_the_loop_also_if_python_loses_its_error_without_words(csv, capsys):
    player = Loses(csv, until=1, tick=1e-4)
    main = ended_quietly()(player.run)
    assert call(main, capsys) == (128 + signal.SIGTERM, "", "")
    assert player.frames == 1
