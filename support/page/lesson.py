"""The lesson: its state is free, asked, running, asked again (seen), or explained.

    asked       you predict what will happen; the cradle waits at its release
    running     the first swing, which is measured
    seen        you say what you saw; the cradle stands at its release again
    explained   the page says what happened, and why; the cradle swings once more, and rests
    free        there is no question

With Ask, the states asked and seen are among them; without Ask, they are left out.
Again slowly repeats the swing, and changes nothing else. The lesson also owns pause, rest and
speed, and the word about your last command. Nothing is stored, and nobody gets a score.
"""

from collections.abc import Callable
from itertools import chain
from math import inf, pi, radians, sin, sqrt
from typing import Any

from support.constants import G
from support.cradle.motion import Motion
from support.cradle.real_time import FRAME, RealTime
from support.files.experiments import Experiment
from support.page.chooser import Chooser
from support.page.names import State
from support.page.prediction import Measurement
from support.page.scene.slow_hits import SlowHits

FREE, ASKED, RUNNING, SEEN, EXPLAINED = "free", "asked", "running", "seen", "explained"
REST = 3.0  # s that the picture rests after the first swing
SLOWLY = 0.1  # times real time
WAITS = "The cradle waits for your answer. Choose one."
OVER = (
    "You have changed the cradle, so its question is over. To ask it again, choose the experiment."
)


class Lesson:
    """Owns the state of the lesson, which the other parts show."""

    def __init__(
        self,
        chooser: Chooser,
        slow_hits: SlowHits,
        pace: RealTime,
        plan: Callable[..., None],
    ):
        """Let the time go on; plan(ticks) plans the ticks of a frame, as Player.plan does."""
        self.chooser = chooser
        self.next_cradle = chooser.next_cradle
        self.slow_hits = slow_hits
        self.pace = pace
        self.plan = plan
        self.asks = True  # the box Ask
        self.speed = 1.0  # that you have set, times real time
        self.word = ""  # about your last command
        self.enter(FREE)
        self.run_or_wait()

    def enter(self, state: str) -> None:
        """Enter the first state of a lesson."""
        self.state = state
        self.replies: dict[str, int | None] = {ASKED: None, SEEN: None}  # the indices of answers
        self.measurement: Measurement | None = None  # of this swing
        self.explained: Measurement | None = None  # that of the last whole swing
        self.is_slow = False  # whether the swing is in slow motion
        self.stands = state == ASKED  # whether the cradle waits at its release for an answer
        self.repeats = False  # whether the next run repeats this one
        self.rest_end = 0.0  # on the pace's clock: until then, the end of the swing stands still

    # --- a run ---------------------------------------------------------------------------------

    def experiment(self, motion: Motion) -> Experiment | None:
        """Return the experiment with a question whose cradle this Motion has, or None.

        The program may have read another file, with another number of pendula.
        """
        experiment = self.chooser.experiment
        if not experiment or not experiment.answers or self.chooser.is_changed:
            return None
        is_its_cradle = len(experiment.poses) == len(motion.cradle.pend_list)
        return experiment if is_its_cradle else None

    def begin(self, motion: Motion) -> None:
        """Begin a run of this Motion: ask its question, or repeat the last run."""
        experiment = self.experiment(motion)
        self.rest_end = 0.0
        if not experiment:
            self.enter(FREE)
            if self.word != OVER:
                self.word = ""
            return
        if not self.repeats:
            self.enter(ASKED if self.asks else RUNNING)
        self.repeats = False
        if self.stands:
            self.is_paused = False  # so the cradle runs when you have answered
        self.measurement = Measurement(experiment, motion)

    def repeat_run(self, stands: bool) -> None:
        """Let the next run repeat this one; it stands at its release, or swings at once."""
        self.repeats = True
        self.stands = stands
        self.is_paused = False
        self.next_cradle.want()

    def is_measuring(self) -> bool:
        """Return whether the first swing of this run is not yet over."""
        return self.measurement is not None and not self.measurement.is_over

    def measure(self) -> bool:
        """Measure this moment; return whether the first swing ends with it.

        Then ask what you have seen, or explain it: while you read, the picture rests, until you go
        on. Without Ask, it rests for a moment.
        """
        if not self.measurement or self.measurement.is_over:
            return False
        self.measurement.measure()
        if not self.measurement.is_over:
            return False
        self.explained = self.measurement
        self.is_slow = False
        if self.state == RUNNING:
            self.state = SEEN if self.asks else EXPLAINED
        if self.state == SEEN:
            self.repeat_run(stands=True)
        else:
            self.rest_end = inf if self.asks else self.pace.clock() + REST
        return True

    def end_if_changed(self) -> None:
        """End the question if the cradle was changed."""
        if self.chooser.is_changed and self.state != FREE:
            if self.state == ASKED:  # what follows would give the answer away
                self.is_paused = True
            self.enter(FREE)
            self.word = OVER

    def is_running(self) -> bool:
        """Return whether the time goes on."""
        waits = self.stands or self.is_resting() or self.slow_hits.current
        return not (self.is_paused or waits)

    def is_resting(self) -> bool:
        """Return whether the picture rests after the first swing."""
        return self.pace.clock() < self.rest_end

    def speed_now(self) -> float:
        """Return the speed of this run, times real time."""
        return SLOWLY if self.is_slow else self.speed

    # --- commands ------------------------------------------------------------------------------

    def choose(self, name: str) -> None:
        """Let the program make the cradle with this name; it runs at once."""
        self.chooser.choose(name)
        self.enter(FREE)
        self.word = ""
        self.run_or_wait()

    def run_or_wait(self) -> None:
        """Let the time go on, but not with a hidden value: its first hit is the clearest."""
        experiment = self.chooser.experiment
        self.is_paused = bool(experiment and experiment.hidden)

    def run(self) -> None:
        """Let the time go on."""
        self.is_paused = False

    def skip_question(self) -> None:
        """Give the first answer, and do not rest after the swing."""
        if self.measurement:
            self.answer(self.measurement.experiment.stem, 0)
            self.rest_end = 0.0

    def choose_neighbour(self, step: int) -> None:
        """Choose the next experiment (step 1), or the one before this (-1); all are in a ring."""
        names = self.chooser.names()
        place = names.index(self.chooser.name()) + step
        self.choose(names[place % len(names)])

    def set_asks(self, asks: bool) -> None:
        """Ask the questions of experiments, or not; begin the present one again."""
        self.asks = asks
        self.word = ""
        if self.state != FREE:
            self.repeats = False
            self.next_cradle.want()

    def answer(self, stem: str, number: int) -> None:
        """Take an answer (its index) to the question of the experiment with this stem.

        Do nothing if this question is not asked now, or has no such answer.
        """
        if not self.measurement or self.state not in (ASKED, SEEN):
            return
        experiment = self.measurement.experiment
        if experiment.stem == stem and number < len(experiment.answers):
            self.replies[self.state] = number
            self.state = RUNNING if self.state == ASKED else EXPLAINED
            self.stands = False
            self.word = ""

    def repeat(self) -> None:
        """Show the last swing again, slowly."""
        if self.explained:
            self.is_slow = True
            self.word = ""
            self.repeat_run(stands=False)

    def can_go_on(self) -> bool:
        """Return False, and say why, while the cradle waits for an answer; else return True."""
        if self.stands:
            self.word = WAITS
        return not self.stands

    def pause(self) -> None:
        """Stop the time, or let it go on; slow hits that still wait are left out."""
        if not self.can_go_on():
            return
        self.is_paused = self.is_running()
        self.rest_end = 0.0
        self.slow_hits.leave()

    def step(self) -> None:
        """Go on to the next hit with Slow hits; else, while paused, do the ticks of a frame."""
        if not self.can_go_on():
            return
        was_running = self.is_running()
        self.rest_end = 0.0
        if self.slow_hits.is_on:
            self.slow_hits.show_next()
            self.is_paused = False
        elif not was_running:
            self.is_paused = True
            self.plan(round(FRAME * self.speed_now() / self.pace.dt))

    def set_speed(self, speed: float) -> None:
        """Let the time go on at this speed, times real time, also if a run is in slow motion."""
        self.speed = speed
        self.is_slow = False

    # --- what it shows -------------------------------------------------------------------------

    def ghosts(self, time: float) -> list[dict[int, list[float]]]:
        """Return the angles (rad) of upper cords that each answer predicts for this time (s).

        From the first hit on until the swing is measured, they grow along a sine, as in a small
        swing. A bob that does not swing has none.
        """
        measurement = self.measurement
        if not measurement or time <= measurement.hit_time:
            return []
        if measurement.is_over and time > measurement.end:
            return []
        phase = sqrt(G / measurement.cradle.cords_length) * (time - measurement.hit_time)  # rad
        part = sin(min(phase, pi / 2))
        ghosts = []
        for answer in measurement.experiment.answers:
            swings = enumerate(answer.swings)
            ghosts.append({index: [part * radians(swing)] for index, swing in swings if swing})
        return ghosts

    def largest_swing(self) -> float:
        """Return the largest angle (rad) that the answers predict, 0 without answers."""
        answers = self.measurement.experiment.answers if self.measurement else []
        swings = chain.from_iterable(answer.swings for answer in answers)
        return radians(max(map(abs, swings), default=0.0))

    def view(self) -> State:
        return {
            "paused": self.is_paused,
            "running": self.is_running(),
            "word": self.word,
            "question": self.question(),
        }

    def question(self) -> dict[str, Any] | None:
        """Return the question and your replies, and when it is explained, what happened and why."""
        if not self.measurement:
            return None
        experiment = self.measurement.experiment
        question: dict[str, Any] = {
            "state": self.state,
            "stem": experiment.stem,
            "question": experiment.question,
            "answers": [answer.text for answer in experiment.answers],
            "replies": dict(self.replies),
        }
        if self.state == EXPLAINED and self.explained:
            question["outcome"] = self.explained.outcome()
            question["why"] = self.explained.explanation()
        return question
