"""Measure an experiment, and compare it with the answers to its question."""

from math import degrees, inf

from support.constants import R_PARAM
from support.files.experiments import Experiment

NEAR = 10.0  # degrees: an answer is right if no bob swings farther from what it predicts


class Measurement:
    """What the bobs of an experiment do from their release to the time of the measurement."""

    def __init__(self, experiment: Experiment):
        self.experiment = experiment
        count = len(experiment.angles)
        self.swings, self.speeds, self.befores = ([0.0] * count for _ in range(3))  # degrees, m/s, m/s
        self.energy = 100.0  # % that is left
        self.start_energy = 0.0  # J
        self.has_hit = self.is_over = False
        self.hit_time = inf  # s: the first sample after a hit
        self.end = experiment.seconds  # s: the last sample

    def note(self, sample, has_hit) -> None:
        """Measure a sample of Motion; has_hit says whether two bobs have hit each other by then."""
        if self.is_over:
            return
        self.start_energy = self.start_energy or sample["total"]
        self.energy = 100 * sample["total"] / self.start_energy if self.start_energy else 100.0
        fastest = self.speeds if has_hit else self.befores
        for i in range(len(self.swings)):
            fastest[i] = max(fastest[i], R_PARAM * abs(sample[f"omega_{i + 1}"]))
            if has_hit:
                self.swings[i] = max(self.swings[i], degrees(sample[f"theta_{i + 1}"]), key=abs)
        if has_hit and not self.has_hit:
            self.hit_time = sample["t"]
        self.has_hit = has_hit
        if sample["t"] >= self.experiment.seconds:
            self.is_over, self.end = True, sample["t"]

    def outcome(self) -> int | None:
        """Return the index of the answer that comes nearest to what the bobs did; None if none is near, or none hit."""
        predicted = [answer.swings for answer in self.experiment.answers]
        errors = [max(abs(a - b) for a, b in zip(swings, self.swings, strict=True)) for swings in predicted]
        return errors.index(min(errors)) if self.has_hit and min(errors) <= NEAR else None

    def explanation(self) -> str:
        """Return why that happened, or, if something else happened than the experiment explains, that it did."""
        experiment, outcome = self.experiment, self.outcome()
        if outcome == experiment.explained:
            return experiment.why.format(**self.numbers())
        if not self.has_hit:
            return "No two bobs hit each other."
        swings = ", ".join(f"{swing:.0f}" for swing in self.swings)
        expected = experiment.answers[experiment.explained].text
        words = f"After the first hit, the bobs swung to {swings} degrees. The experiment expects: {expected}. "
        return words + "So a function in src/, or a setting, is different."

    def numbers(self) -> dict[str, str]:
        """Return the measured numbers as text, by the names that the text of an experiment can have in braces."""
        numbers = {"energy": f"{self.energy:.0f}"}
        for i, (swing, speed, before) in enumerate(zip(self.swings, self.speeds, self.befores, strict=True), start=1):
            numbers |= {f"swing_{i}": f"{abs(swing):.0f}", f"speed_{i}": f"{speed:.2f}", f"before_{i}": f"{before:.2f}"}
        return numbers
