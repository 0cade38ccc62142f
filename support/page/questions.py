"""The question of an experiment: what you predict, what you have seen, and what happened."""

from collections.abc import Callable
from math import pi, radians, sin, sqrt
from typing import Any, NamedTuple

from support.constants import G
from support.cradle.motion import Motion
from support.cradle.prediction import Measurement
from support.files.experiments import Experiment
from support.page.names import State

PREDICTED = "predicted"  # asked before the release
SEEN = "seen"  # asked after the first swing
REST = 3.0  # s that the picture rests when an experiment has been measured
WAITS = "The cradle waits for your answer. Choose one."
OVER = (
    "You have changed the cradle, so its question is over. To ask it again, choose the experiment."
)

Replies = dict[str, int | None]  # to PREDICTED and SEEN: the index of an answer


class Again(NamedTuple):
    """What a run that repeats the last one takes from it, and whether it is in slow motion."""

    replies: Replies
    slowly: bool


class Questions:
    """The question of the present run, and its measurement.

    Nothing is stored, and nobody gets a score.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        """Begin without a question; clock() returns a time (s)."""
        self.clock = clock
        self.ask_first = True  # what you predict
        self.ask_seen = True
        # About your last command, which the question does not allow, or has ended it.
        self.word = ""
        self.again: Again | None = None  # for the next run
        self.drop()

    def drop(self) -> None:
        """Ask nothing, and measure nothing."""
        self.asking: str | None = None  # PREDICTED or SEEN: the cradle waits for an answer
        self.replies: Replies = {PREDICTED: None, SEEN: None}
        self.slowly = False  # whether this run is in slow motion, until its measurement is over
        self.rest_end: float | None = None  # on the clock: until then, the picture rests
        # Of the experiment whose question is asked, or was answered.
        self.measurement: Measurement | None = None

    def end(self) -> None:
        """Ask and measure nothing any more, and say so: the cradle has been changed."""
        if self.measurement is not None:
            self.word = OVER
        self.drop()

    def repeat(self, slowly: bool) -> None:
        """Let the next run keep the answers of this one."""
        self.again = Again(self.replies, slowly)

    def begin(self, experiment: Experiment | None, motion: Motion) -> None:
        """Begin a run of this Motion, and ask the question of its experiment, if it has one.

        What you predict is asked only if Predict first is ticked, and not again in a run that
        repeats another.
        """
        again = self.again
        self.again = None
        self.drop()
        if experiment is None or not experiment.question:
            if self.word != OVER:  # there is no question any more
                self.word = ""
            return
        self.measurement = Measurement(experiment, motion)
        if again:
            self.replies, self.slowly = again
        elif self.ask_first:
            self.asking = PREDICTED

    def answer(self, key: str, number: int) -> None:
        """Take an answer (its index) to the question of the experiment with this key.

        Do nothing if this question is not asked now, or has no such answer.
        """
        if self.measurement is None or self.asking is None:
            return
        experiment = self.measurement.experiment
        if experiment.key != key or number >= len(experiment.answers):
            return
        self.replies[self.asking] = number
        self.leave_seen()
        self.asking = None
        self.word = ""

    def leave_seen(self) -> None:
        """Ask no more what you have seen, if it is asked; the picture rests for some time."""
        if self.asking == SEEN:
            self.rest_end = self.clock() + REST
            self.asking = None

    def is_measuring(self) -> bool:
        """Return whether the present run is measured, and its measurement is not yet over."""
        return self.measurement is not None and not self.measurement.is_over

    def rests_after_measurement(self) -> bool:
        """Return whether the picture rests after a measurement."""
        return self.asking == SEEN or self.rest_end is not None

    def measure(self) -> bool:
        """Measure this moment; return whether the measurement ends with it.

        The picture then rests, for some time, or until you have said what you have seen.
        """
        if self.measurement is None or self.measurement.is_over:
            return False
        self.measurement.measure()
        if not self.measurement.is_over:
            return False
        if self.ask_seen and self.replies[SEEN] is None:
            self.asking = SEEN
        else:
            self.rest_end = self.clock() + REST
        return True

    def end_rest(self) -> None:
        """End the rest, and slow motion."""
        self.rest_end = None
        self.slowly = False

    def end_rest_in_time(self) -> None:
        """End the rest if it is time."""
        if self.rest_end is not None and self.clock() >= self.rest_end:
            self.end_rest()

    def ghosts(self, time: float) -> list[dict[int, list[float]]]:
        """Return the angles (rad) of upper cords that each answer predicts for this time (s).

        From the first hit on, they grow along a sine, as in a small swing. There are none before
        it, and when the measurement is over.
        """
        measurement = self.measurement
        if measurement is None or time <= measurement.hit_time:
            return []
        if measurement.is_over and time > measurement.end:
            return []
        phase = sqrt(G / measurement.cradle.cords_length) * (time - measurement.hit_time)  # rad
        part = sin(min(phase, pi / 2))
        ghosts = []
        for answer in measurement.experiment.answers:
            angles = [part * radians(swing) for swing in answer.swings]
            ghosts.append({index: [angle] for index, angle in enumerate(angles)})
        return ghosts

    def state(self) -> State:
        """Return what the page must know of the question, and of your last command about it."""
        return {"question": self.question(), "word": self.word}

    def question(self) -> dict[str, Any] | None:
        """Return the question, the replies, and what happened; None without a question."""
        if self.measurement is None:
            return None
        experiment = self.measurement.experiment
        happened = None
        if self.measurement.is_over:
            happened = {
                "outcome": self.measurement.outcome(),
                "why": self.measurement.explanation(),
            }
        return {
            "key": experiment.key,
            "question": experiment.question,
            "answers": [answer.text for answer in experiment.answers],
            "asking": self.asking,
            "replies": dict(self.replies),
            "happened": happened,
        }
