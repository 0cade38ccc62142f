"""The pace of the simulation, on a clock of the test: only ticks and sleeps take time."""

import pytest

from support.playback.real_time import FRAME, MAX_BEHIND, RealTime

DT = 1e-4  # s per tick


class Wall:
    """A wall clock; a RealTime runs on it frame by frame until the time `until`."""

    def __init__(self, cost, until, fixed=0.0, least=1):
        """cost is that of a tick (s), fixed that of a call of advance (s); least is for RealTime.due."""
        self.now, self.cost, self.until = 0.0, cost, until
        self.fixed, self.least = fixed, least
        self.ticks, self.slept, self.frames = 0, 0.0, 0
        self.interruptions = {}  # frame -> s that its sleep is too long
        self.pace = RealTime(DT, self.clock, self.sleep)

    def clock(self):
        return self.now

    def advance(self, ticks):
        assert ticks > 0
        self.ticks += ticks
        self.now += self.fixed + ticks * self.cost

    def sleep(self, seconds):
        assert seconds >= 0
        self.frames += 1
        self.slept += seconds
        self.now += seconds + self.interruptions.get(self.frames, 0)

    def frame(self):
        """Run one frame."""
        ticks = self.pace.due(self.least)
        if ticks:
            self.advance(ticks)
            self.pace.did(ticks)

    def run(self):
        """Run all frames; return the simulated time (s)."""
        while self.now < self.until:
            self.frame()
            self.pace.rest()
        return self.ticks * DT


@pytest.mark.parametrize("speed", [0.1, 1, 2])
@pytest.mark.parametrize("cost", [0, 10e-6, 30e-6])
def test_a_simulated_second_lasts_a_second_at_speed_1(cost, speed):
    wall = Wall(cost, until=60)
    wall.pace.speed = speed
    assert wall.run() == pytest.approx(60 * speed, abs=2 * FRAME * speed)
    assert wall.pace.kept_up == pytest.approx(1, abs=0.02)


def test_it_sleeps_when_there_is_nothing_to_do():
    wall = Wall(cost=20e-6, until=60)
    wall.run()
    assert wall.slept == pytest.approx(60 * 0.8, rel=0.01)  # 10,000 ticks per second of 20 us take a fifth of the time
    assert wall.frames == pytest.approx(60 / FRAME, rel=0.01)


@pytest.mark.parametrize("cost", [200e-6, 1e-3, 5e-3])
def test_a_slow_machine_shows_slow_motion(cost):
    """Pictures keep coming, the simulation moves on steadily, and the threads of the page get time too."""
    wall = Wall(cost, until=60)
    assert wall.run() == pytest.approx(0.75 * 60 / cost * DT, rel=0.35)
    assert wall.frames == pytest.approx(60 / FRAME, rel=0.15)
    assert wall.slept > 5
    assert wall.pace.kept_up == pytest.approx(wall.ticks * DT / 60, rel=0.1)


def test_a_tick_longer_than_a_frame_ends_in_no_spiral():
    wall = Wall(cost=0.1, until=60)
    wall.run()
    assert wall.ticks == wall.frames - 1  # one per frame, except the first, before any time has passed
    assert wall.ticks == pytest.approx(60 / (0.1 + FRAME / 4), abs=2)  # the threads of the page get time, too


@pytest.mark.parametrize("fixed", [5e-3, 20e-3])
def test_a_call_that_costs_much_does_many_ticks(fixed):
    """It would do one tick, if its cost counted as that of a tick; and a frame stays short."""
    wall = Wall(cost=100e-6, until=60, fixed=fixed, least=100)
    wall.run()
    assert wall.ticks / wall.frames == pytest.approx(100, rel=0.01)
    assert 60 / wall.frames == pytest.approx(fixed + 10e-3 + FRAME / 4, rel=0.15)
    assert wall.pace.remark() == ("x0.5" if fixed == 5e-3 else "x0.3")


def test_a_call_that_costs_much_does_no_more_than_is_due():
    wall = Wall(cost=1e-6, until=60, fixed=5e-3, least=1000)
    assert wall.run() == pytest.approx(60, abs=2 * FRAME)
    assert wall.frames == pytest.approx(60 / FRAME, rel=0.01)


def test_a_hiccup_is_made_up_for():
    wall = Wall(cost=10e-6, until=60)
    wall.interruptions[600] = 0.2
    assert wall.run() == pytest.approx(60, abs=2 * FRAME)


def test_a_machine_that_is_busy_now_and_then_keeps_up():
    """If another program slows down a tick, this says nothing about the next tick."""
    wall = Wall(cost=10e-6, until=60)
    advance = wall.advance

    def sometimes_interrupted(ticks):
        advance(ticks)
        if wall.frames % 10 == 0:
            wall.now += 0.06

    wall.advance = sometimes_interrupted
    assert wall.run() == pytest.approx(60, abs=0.1)


@pytest.mark.parametrize(("before", "after"), [(1, 2), (0.1, 2), (2, 0.1)])
def test_another_speed_is_no_slow_motion(before, after):
    wall = Wall(cost=10e-6, until=10.5)
    wall.pace.speed = before
    wall.run()
    wall.pace.speed, wall.until = after, 11.6
    wall.run()
    assert wall.pace.kept_up == pytest.approx(1, abs=0.03)


def test_a_night_of_sleep_is_not_simulated():
    night = 8 * 3600.0
    wall = Wall(cost=10e-6, until=night + 60)
    wall.interruptions[600] = night
    assert 60 <= wall.run() < 61


def test_after_a_pause_nothing_is_owed_and_a_slow_past_forgotten():
    wall = Wall(cost=1e-3, until=10)
    wall.run()
    assert wall.pace.kept_up < 0.5
    ticks = wall.ticks
    wall.now += 100
    wall.pace.restart()
    assert wall.pace.kept_up == 1
    wall.frame()
    assert wall.ticks == ticks
    wall.cost, wall.until = 10e-6, wall.now + 3.1
    wall.run()
    assert wall.pace.kept_up == pytest.approx(1, abs=0.02)


@pytest.mark.parametrize("speed", [0.1, 2])
@pytest.mark.parametrize(("hiccup", "made_up"), [(0.2, 0.2), (5, MAX_BEHIND)])
def test_at_any_speed_the_same_hiccup_is_made_up_for(speed, hiccup, made_up):
    wall = Wall(cost=1e-6, until=10)
    wall.pace.speed = speed
    wall.interruptions[60] = hiccup
    assert wall.run() == pytest.approx((10 - hiccup + made_up) * speed, abs=3 * FRAME * speed)


@pytest.mark.parametrize(("kept_up", "remark"), [(1.0, ""), (0.96, ""), (0.9, "x0.9"), (0.4, "x0.4")])
def test_slow_motion_is_remarked_on(kept_up, remark):
    pace = RealTime(DT)
    pace.speed, pace.kept_up = 2.0, kept_up
    assert pace.remark() == remark


@pytest.mark.parametrize(("cost", "speed", "too_slow"), [(45e-6, 1, False), (55e-6, 1, True), (30e-6, 2, True)])
def test_ticks_that_cost_more_than_there_is_time_are_too_slow(cost, speed, too_slow):
    """Single ticks get half of the time: at speed 1, that is 50 us for a tick of 0.1 ms."""
    wall = Wall(cost, until=60)
    wall.pace.speed = speed
    wall.run()
    assert wall.pace.is_too_slow() == too_slow


def test_a_busy_machine_does_not_make_ticks_too_slow():
    wall = Wall(cost=30e-6, until=2)
    advance = wall.advance

    def disturbed(ticks):
        advance(ticks)
        wall.now += 0.05 if wall.frames % 10 else 0

    wall.advance = disturbed
    wall.run()
    assert wall.pace.kept_up < 0.9
    assert not wall.pace.is_too_slow()


def test_what_ticks_cost_is_learned_anew():
    wall = Wall(cost=1e-3, until=10)
    wall.run()
    assert wall.pace.is_too_slow()
    wall.pace.forget_costs()
    wall.cost, wall.until = 10e-6, wall.now + 1
    wall.run()
    assert not wall.pace.is_too_slow()
