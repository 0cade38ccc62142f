"""Measure an experiment, and compare it with the answers to its question."""

from math import degrees, inf

from support.constants import R_PARAM
from support.cradle.motion import FAST_PART, Motion
from support.files.experiments import Experiment

NEAR = 10.0  # degrees: an answer is right if no bob is farther from its predicted angle
# Of the fastest bob's speed: a slower bob only crosses the gap to the next one, and does not swing.
MOVING_PART = 1e-3
MOST_SWINGS = 3  # small swings: a measurement takes no longer than these


class Measurement:
    """What the bobs of an experiment do, from their release until those that have left turn back.

    The bobs come in until the first fast hit. They leave when this series of hits is over, and no
    fast bob falls. They have turned back when they fall again. No time is given: it depends on the
    cord, on gravity, and on the angles.
    """

    def __init__(self, experiment: Experiment, motion: Motion):
        """Begin with the cradle of this Motion, which has just been released."""
        self.experiment = experiment
        self.motion = motion
        self.cradle = motion.cradle
        count = len(experiment.poses)
        self.befores = [0.0] * count  # m/s: the largest speeds before the first fast hit
        self.speeds = [0.0] * count  # m/s: the largest speeds after the last hit of the series
        self.swings = [0.0] * count  # degrees: the largest angles after the series
        self.energy = 100.0  # % that is left
        self.hit_time = inf  # s: the first look after a fast hit
        self.left_time = inf  # s: the first look after the series
        self.end = 0.0  # s: the last look
        self.is_over = False
        self.heights = self.cradle.heights()  # m, at the last look
        self.hit_count = 0  # at the last look
        self.has_turned = [False] * count
        self.fastest = max(self.cradle.top_speeds())  # m/s

    def measure(self) -> None:
        """Measure this moment, until is_over: about a thousand times in a swing."""
        self.end = self.motion.time()
        self.energy = self.motion.energy_percent()
        before = self.heights
        self.heights = self.cradle.heights()
        falls = [now < old for now, old in zip(self.heights, before, strict=True)]
        speeds = [R_PARAM * abs(omega) for omega in self.cradle.values("omega")]
        if self.motion.last_fast == -inf:
            self.befores = largest(self.befores, speeds)
        elif self.left_time == inf:
            self.measure_series(speeds, falls)
        else:
            self.speeds = largest(self.speeds, speeds)
            self.measure_swing(falls)
        if self.end > MOST_SWINGS * self.cradle.period:
            self.is_over = True

    def measure_series(self, speeds: list[float], falls: list[bool]) -> None:
        """Measure the speeds (m/s) after a hit, and find out whether the series is over.

        falls says which bobs fall.
        """
        self.hit_time = min(self.hit_time, self.end)
        if self.motion.hit_count > self.hit_count:
            self.speeds = speeds
        else:
            self.speeds = largest(self.speeds, speeds)
        self.hit_count = self.motion.hit_count
        tops = self.cradle.top_speeds()
        fast = FAST_PART * max(tops)
        fast_one_falls = any(fall and top >= fast for fall, top in zip(falls, tops, strict=True))
        is_quiet = self.end - self.motion.last_fast > self.cradle.series_pause
        if is_quiet and not fast_one_falls:
            self.left_time = self.end

    def measure_swing(self, falls: list[bool]) -> None:
        """Measure how far the bobs have swung out, and find out whether they have turned back."""
        tops = self.cradle.top_speeds()
        for i, theta in enumerate(self.cradle.values("theta")):
            self.swings[i] = max(self.swings[i], degrees(theta), key=abs)
            if falls[i] or tops[i] <= MOVING_PART * self.fastest:
                self.has_turned[i] = True
        hits_again = self.motion.last_fast > self.left_time
        self.is_over = hits_again or all(self.has_turned)

    def outcome(self) -> int | None:
        """Return the index of the answer nearest to what the bobs did; None if none is near."""
        if self.left_time == inf:
            return None
        errors = [farthest_apart(answer.swings, self.swings) for answer in self.experiment.answers]
        return errors.index(min(errors)) if min(errors) <= NEAR else None

    def explanation(self) -> str:
        """Return why that happened, or, if the experiment expects something else, that it did."""
        experiment = self.experiment
        if self.outcome() == experiment.explained:
            return experiment.why.format(**self.numbers())
        if self.hit_time == inf:
            return f"In {self.end:.2f} s, no hit was seen."
        if self.left_time == inf:
            return f"After {self.end:.2f} s, the bobs still hit each other."
        swings = ", ".join(f"{swing:.0f}" for swing in self.swings)
        expected = experiment.answers[experiment.explained].text
        return (
            f"After the hits, the bobs swung to {swings} degrees. "
            f"The experiment expects: {expected}. "
            "So a function in src/, or a setting, is different."
        )

    def numbers(self) -> dict[str, str]:
        """Return the measured numbers as text, by the names that an experiment's text can have."""
        digits = self.motion.digits
        numbers = {"energy": f"{self.energy:.0f}", "hits": f"{self.hit_count}"}
        for i in range(len(self.swings)):
            numbers[f"swing_{i + 1}"] = f"{abs(self.swings[i]):.0f}"
            numbers[f"speed_{i + 1}"] = f"{self.speeds[i]:.{digits}f}"
            numbers[f"before_{i + 1}"] = f"{self.befores[i]:.{digits}f}"
        return numbers


def largest(numbers: list[float], others: list[float]) -> list[float]:
    """Return the larger number of each pair, one from each list."""
    return [*map(max, numbers, others)]


def farthest_apart(numbers: list[float], others: list[float]) -> float:
    """Return the largest difference of a pair, one number from each list."""
    return max(abs(number - other) for number, other in zip(numbers, others, strict=True))
