"""Measure an experiment, and compare it with the answers to its question."""

from math import degrees, inf

from support.constants import R_PARAM
from support.cradle.motion import LEAST
from support.files.experiments import Experiment

NEAR = 10.0  # degrees: an answer is right if no bob swings farther from what it predicts
# Of the fastest bob's speed: a slower bob does not move, but for the gap to the next one
STILL = 1e-3
MOST_SWINGS = 3  # small swings: a measurement takes no longer than these


class Measurement:
    """What the bobs of an experiment do, from their release until those that have left turn back.

    The bobs come in until the first fast hit. They leave when this train of hits is over, and no
    fast bob falls. They have turned back when they fall again. No time is given: it depends on the
    cord, on gravity, and on the angles.
    """

    def __init__(self, experiment: Experiment, motion):
        """Begin with the cradle of this Motion, which has just been released."""
        self.experiment = experiment
        self.motion = motion
        self.cradle = motion.cradle
        count = len(experiment.angles)
        self.befores = [0.0] * count  # m/s: the largest speeds before the first fast hit
        self.speeds = [0.0] * count  # m/s: the largest speeds after the last hit of the train
        self.swings = [0.0] * count  # degrees: the largest angles after the train
        self.energy = 100.0  # % that is left
        self.hit_time = inf  # s: the first look after a fast hit
        self.left_time = inf  # s: the first look after the train
        self.end = 0.0  # s: the last look
        self.is_over = False
        self.heights = self.cradle.heights()  # m, at the last look
        self.hits = 0  # at the last look
        self.has_turned = [False] * count
        self.fastest = max(self.cradle.top_speeds())  # m/s

    def measure(self) -> None:
        """Measure this moment, until is_over: about a thousand times in a swing."""
        self.end, self.energy = self.motion.time(), self.motion.percents()["energy"]
        heights, self.heights = self.heights, self.cradle.heights()
        falls = [now < before for now, before in zip(self.heights, heights, strict=True)]
        speeds = [R_PARAM * abs(omega) for omega in self.cradle.values("omega")]
        if self.motion.last_fast == -inf:
            self.befores = [*map(max, self.befores, speeds)]
        elif self.left_time == inf:
            self.measure_train(speeds, falls)
        else:
            self.speeds = [*map(max, self.speeds, speeds)]
            self.measure_swing(falls)
        if self.end > MOST_SWINGS * self.cradle.period:
            self.is_over = True

    def measure_train(self, speeds, falls) -> None:
        """Measure the speeds (m/s) after a hit, and find out whether the train is over; falls says
        which bobs fall.
        """
        self.hit_time = min(self.hit_time, self.end)
        if self.motion.hits > self.hits:
            self.speeds = [0.0] * len(speeds)
        self.hits = self.motion.hits
        self.speeds = [*map(max, self.speeds, speeds)]
        tops = self.cradle.top_speeds()
        fast_one_falls = any(
            fall and top >= LEAST * max(tops) for fall, top in zip(falls, tops, strict=True)
        )
        if self.end - self.motion.last_fast > self.cradle.gap and not fast_one_falls:
            self.left_time = self.end

    def measure_swing(self, falls) -> None:
        """Measure how far the bobs have swung out, and find out whether they have turned back;
        falls as above.
        """
        for i, pend in enumerate(self.cradle.pend_list):
            self.swings[i] = max(self.swings[i], degrees(pend["theta"]), key=abs)
        tops = self.cradle.top_speeds()
        for i, fall in enumerate(falls):
            if fall or tops[i] <= STILL * self.fastest:
                self.has_turned[i] = True
        hits_again = self.motion.last_fast > self.left_time
        self.is_over = hits_again or all(self.has_turned)

    def outcome(self) -> int | None:
        """Return the index of the answer that comes nearest to what the bobs did; None if none is
        near.
        """
        if self.left_time == inf:
            return None
        errors = [farthest_apart(answer.swings, self.swings) for answer in self.experiment.answers]
        return errors.index(min(errors)) if min(errors) <= NEAR else None

    def explanation(self) -> str:
        """Return why that happened, or, if something else happened than the experiment explains,
        that it did.
        """
        experiment, outcome = self.experiment, self.outcome()
        if outcome == experiment.explained:
            return experiment.why.format(**self.numbers())
        if self.hit_time == inf:
            return f"In {self.end:.2f} s, no two bobs hit each other."
        if self.left_time == inf:
            return f"After {self.end:.2f} s, the bobs still hit each other."
        swings = ", ".join(f"{swing:.0f}" for swing in self.swings)
        expected = experiment.answers[experiment.explained].text
        words = f"After the hits, the bobs swung to {swings} degrees. The experiment expects: {expected}. "
        return words + "So a function in src/, or a setting, is different."

    def numbers(self) -> dict[str, str]:
        """Return the measured numbers as text, by the names that the text of an experiment can have
        in braces.
        """
        numbers = {"energy": f"{self.energy:.0f}"}
        digits = 2  # behind the point; slow cradles need more
        while 0 < self.fastest * 10**digits < 50:
            digits += 1
        for i, (swing, speed, before) in enumerate(
            zip(self.swings, self.speeds, self.befores, strict=True), start=1
        ):
            numbers |= {f"swing_{i}": f"{abs(swing):.0f}", f"speed_{i}": f"{speed:.{digits}f}"}
            numbers[f"before_{i}"] = f"{before:.{digits}f}"
        return numbers


def farthest_apart(angles, others) -> float:
    """Return the largest difference of two angles, one from each of these lists."""
    return max(abs(angle - other) for angle, other in zip(angles, others, strict=True))
