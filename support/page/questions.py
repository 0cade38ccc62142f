"""The question of an experiment: asked before the release, if you want it; and what happened."""

from math import pi, radians, sin, sqrt
from typing import Any, NamedTuple

from support.constants import G
from support.cradle.motion import Motion
from support.cradle.prediction import Measurement
from support.files.experiments import Experiment
from support.page.names import State

LETTERS = "ABCDE"  # of the answers
REST = 3.0  # s that the picture rests when an experiment has been measured
WAITS = "The cradle waits for your answer. Choose one, or “Run it without an answer”."
OVER = (
    "You have changed the cradle, so its question is over. To ask it again, choose the experiment."
)
FIGURES = {
    "before": "largest speed before the hits (m/s)",
    "speed": "largest speed after them (m/s)",
}


class Again(NamedTuple):
    """What a run that repeats the last one takes from it, and whether it is in slow motion."""

    reply: int | None
    votes: list[int]
    slowly: bool


class Questions:
    """The question of the present run, and its measurement.

    Nothing is stored, and nobody gets a score.
    """

    def __init__(self) -> None:
        self.ask_first = False
        self.word = (
            ""  # about your last command, which the question does not allow, or has ended it
        )
        self.again: Again | None = None  # for the next run
        self.drop()

    def drop(self) -> None:
        """Ask nothing, and measure nothing."""
        self.is_asking = False  # whether the cradle waits for an answer
        self.reply: int | None = None  # the index of the answer
        self.votes: list[int] = []  # for each answer
        self.slowly = False  # whether this run is in slow motion, until its measurement is over
        # On the pace's clock: until then, the picture rests after a measurement.
        self.rest_end: float | None = None
        # Of the experiment whose question is asked, or was answered.
        self.measurement: Measurement | None = None

    def end(self) -> None:
        """Ask and measure nothing any more, and say so: the cradle has been changed."""
        if self.measurement is not None:
            self.word = OVER
        self.drop()

    def repeat(self, slowly: bool) -> None:
        """Let the next run keep the answer and the votes of this one."""
        self.again = Again(self.reply, self.votes, slowly)

    def begin(self, experiment: Experiment | None, motion: Motion) -> None:
        """Begin a run of this Motion, and ask the question of its experiment, if it has one.

        It is asked only if Predict first is ticked, and not again in a run that repeats another.
        """
        again = self.again
        self.again = None
        self.drop()
        if experiment is None or not experiment.question or not self.ask_first:
            if self.word == WAITS:  # there is no question any more
                self.word = ""
            return
        self.measurement = Measurement(experiment, motion)
        if again is None:
            self.is_asking = True
            self.votes = [0] * len(experiment.answers)
        else:
            self.reply = again.reply
            self.votes = again.votes
            self.slowly = again.slowly

    def is_asked(self, key: str, number: int) -> bool:
        """Return whether this question is asked now, and has this answer (an index).

        key is that of its experiment.
        """
        if self.measurement is None or not self.is_asking:
            return False
        experiment = self.measurement.experiment
        return experiment.key == key and number in range(len(experiment.answers))

    def answer(self, key: str, number: int | None) -> None:
        """Take an answer (its index, or None) to this question, unless it is over."""
        is_known = self.is_asked(key, 0 if number is None else number)  # None is always allowed
        if is_known:
            self.is_asking = False
            self.reply = number
            self.word = ""

    def vote(self, key: str, number: int, is_more: bool) -> None:
        """Count one hand more for this answer (its index) to this question, or one fewer."""
        if self.is_asked(key, number):
            change = 1 if is_more else -1
            self.votes[number] = max(0, self.votes[number] + change)

    def ghost_name(self) -> str:
        """Return the name of the ghosts: they show your answer, or that of the hands for it."""
        if self.reply is None or not self.votes[self.reply]:
            return "your answer"
        return f"{self.votes[self.reply]} of you"

    def is_measuring(self) -> bool:
        """Return whether the present run is measured, and its measurement is not yet over."""
        return self.measurement is not None and not self.measurement.is_over

    def measure(self, now: float) -> bool:
        """Measure this moment, now (s) on the pace's clock.

        Return whether the measurement ends with it; the picture then rests.
        """
        if self.measurement is None or self.measurement.is_over:
            return False
        self.measurement.measure()
        if self.measurement.is_over:
            self.rest_end = now + REST
        return self.measurement.is_over

    def end_rest(self, now: float) -> None:
        """End the rest, and slow motion, if it is time (s, on the pace's clock)."""
        if self.rest_end is not None and now >= self.rest_end:
            self.rest_end = None
            self.slowly = False

    def predicted(self, time: float) -> dict[int, list[float]]:
        """Return the angle (rad) of each upper cord that the answer predicts for this time (s).

        From the first hit on, they grow along a sine, as in a small swing. There are none before
        it, and when the measurement is over.
        """
        measurement = self.measurement
        if measurement is None or self.reply is None or time <= measurement.hit_time:
            return {}
        if measurement.is_over and time > measurement.end:
            return {}
        phase = sqrt(G / measurement.cradle.cords_length) * (time - measurement.hit_time)  # rad
        part = sin(min(phase, pi / 2))
        answer = measurement.experiment.answers[self.reply]
        return {index: [part * radians(swing)] for index, swing in enumerate(answer.swings)}

    def state(self) -> State:
        """Return what the page must know of the question, and of your last command about it."""
        return {"question": self.question(), "word": self.word}

    def question(self) -> dict[str, Any] | None:
        """Return the question, the reply, and what happened; None without a question."""
        if self.measurement is None:
            return None
        experiment = self.measurement.experiment
        happened = None
        if self.measurement.is_over:
            happened = what_happened(self.measurement, self.reply)
        return {
            "key": experiment.key,
            "name": experiment.name,
            "question": experiment.question,
            "answers": [answer.text for answer in experiment.answers],
            "votes": list(self.votes),
            "asking": self.is_asking,
            "reply": reply_text(experiment, self.reply),
            "happened": happened,
        }


def with_letter(experiment: Experiment, answer: int) -> str:
    """Return the letter and the text of this answer (an index) to the question of an experiment."""
    return f"{LETTERS[answer]}, {experiment.answers[answer].text}"


def reply_text(experiment: Experiment, reply: int | None) -> str:
    """Return the answer (an index, or None) in a sentence, or nothing."""
    return "" if reply is None else f"You said: {with_letter(experiment, reply)}."


def what_happened(measurement: Measurement, reply: int | None) -> dict:
    """Return what happened, why, and a table of the measured figures.

    reply is the index of the answer, or None.
    """
    experiment = measurement.experiment
    outcome = measurement.outcome()
    if outcome is None:
        title = "What happened: none of these answers."
    elif outcome == reply:
        title = "That is what happened."
    else:
        title = f"What happened: {with_letter(experiment, outcome)}."
    bobs = [str(number) for number in range(1, len(measurement.swings) + 1)]
    numbers = measurement.numbers()
    rows = [["bob" if len(experiment.poses[0]) == 1 else "upper bob", *bobs]]
    for kind, name in FIGURES.items():
        rows.append([name, *(numbers[f"{kind}_{bob}"] for bob in bobs)])
    rows.append(["swung to (degrees)", *(f"{round(swing)}" for swing in measurement.swings)])
    return {"title": title, "why": measurement.explanation(), "rows": rows}
