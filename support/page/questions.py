"""The question of an experiment: asked before the release, if you want it, and what happened after
it.
"""

from math import pi, radians, sin, sqrt

from support.constants import G
from support.cradle.prediction import Measurement

LETTERS = "ABCDE"  # of the answers
NUMBERS = {
    "before": "largest speed before the hits (m/s)",
    "speed": "largest speed after them (m/s)",
}


class Questions:
    """The question of the present run, and its measurement.

    Nothing is stored, and nobody gets a score.
    """

    def __init__(self):
        self.ask_first = False
        # said, votes and slowly, for a run that repeats the last one
        self.again: tuple | None = None
        self.drop()

    def drop(self) -> None:
        """Ask nothing, and measure nothing."""
        self.is_asking = False  # whether the cradle waits for an answer
        self.said: int | None = None  # the index of the answer
        self.votes: list[int] = []  # for each answer
        self.slowly = False  # whether this run is in slow motion, until its measurement is over
        # Of the experiment whose question is asked, or was answered
        self.measurement: Measurement | None = None

    def begin(self, experiment, motion) -> None:
        """Begin a run of this Motion, of this experiment or of none: ask its question, if Predict
        first is ticked.
        """
        again, self.again = self.again, None
        self.drop()
        if experiment and self.ask_first:
            self.is_asking, self.measurement = again is None, Measurement(experiment, motion)
            self.said, self.votes, self.slowly = again or (
                None,
                [0] * len(experiment.answers),
                False,
            )

    def is_asked(self, key, number) -> bool:
        """Return whether this question (the key of its experiment) is asked now, and has this
        answer (an index).
        """
        asked = self.measurement.experiment if self.measurement and self.is_asking else None
        return asked is not None and asked.key == key and number in range(len(asked.answers))

    def answer(self, key, number) -> bool:
        """Take an answer (its index, or None) to the question with this key; return False if it is
        over.
        """
        if not self.is_asked(key, number or 0):
            return False
        self.is_asking, self.said = False, number
        return True

    def vote(self, key, number) -> None:
        """Count one more hand for this answer (its index) to the question with this key."""
        if self.is_asked(key, number):
            self.votes[number] += 1

    def is_measuring(self) -> bool:
        """Return whether the present run is measured, and its measurement is not yet over."""
        return self.measurement is not None and not self.measurement.is_over

    def is_measured_now(self) -> bool:
        """Measure this moment; return whether the measurement ends with it."""
        if self.measurement is None or self.measurement.is_over:
            return False
        self.measurement.measure()
        return self.measurement.is_over

    def predicted(self, time) -> list[float]:
        """Return the angles (rad) that the answer predicts for this time (s), until the measurement
        is over.

        From the first hit on, they grow along a sine, as in a small swing.
        """
        measured = self.measurement
        if not measured or self.said is None or time < measured.hit_time:
            return []
        if measured.is_over and time > measured.end:
            return []
        phase = sqrt(G / measured.cradle.reach) * (time - measured.hit_time)  # rad
        return [
            radians(swing) * sin(min(phase, pi / 2))
            for swing in measured.experiment.answers[self.said].swings
        ]

    def state(self) -> dict | None:
        """Return the question, what was said, and what happened, in words; None without a question."""
        if not self.measurement:
            return None
        experiment = self.measurement.experiment
        said = "" if self.said is None else f"You said: {in_words(experiment, self.said)}. "
        hands = ", ".join(
            f"{letter} {count}" for letter, count in zip(LETTERS, self.votes, strict=False)
        )
        return {
            "key": experiment.key,
            "name": experiment.name,
            "question": experiment.question,
            "answers": [answer.text for answer in experiment.answers],
            "votes": list(self.votes),
            "asking": self.is_asking,
            "said": "" if self.is_asking else (said + f"Hands: {hands}." * any(self.votes)).strip(),
            "happened": what_happened(self.measurement, self.said)
            if self.measurement.is_over
            else None,
        }


def in_words(experiment, answer) -> str:
    """Return the letter and the text of this answer (an index) to the question of an experiment."""
    return f"{LETTERS[answer]}, {experiment.answers[answer].text}"


def what_happened(measured, said) -> dict:
    """Return what happened, why, and a table of the measured figures; said is the index of the
    answer, or None.
    """
    outcome = measured.outcome()
    numbers = measured.numbers()
    bobs = range(1, len(measured.swings) + 1)
    words = "none of these answers" if outcome is None else in_words(measured.experiment, outcome)
    rows = [["bob" if len(measured.experiment.angles[0]) == 1 else "upper bob", *map(str, bobs)]]
    rows += [
        [title, *(numbers[f"{kind}_{bob}"] for bob in bobs)] for kind, title in NUMBERS.items()
    ]
    rows.append(["swung to (degrees)", *(f"{round(swing)}" for swing in measured.swings)])
    is_right = said is not None and said == outcome
    title = "That is what happened." if is_right else f"What happened: {words}."
    return {"title": title, "why": measured.explanation(), "rows": rows}
