"""Combine single contacts of two bobs into the trains of impacts that run through a cradle."""

from collections import deque

GAP = 0.005  # s: the longest time between two contacts of one train
MOST = 12  # runs in a train, at most: bobs that stay together touch for ever
STRIP_WIDTH = 36  # characters, beside the panel
WHOLE = 9  # bobs: only the ends of a longer run are shown


class ImpactTrains:
    """The last trains of impacts. A train consists of runs: the numbers of bobs in the order of their hits, 1-2-3-4-5.

    If two bobs come in, one train has two runs: 2-3-4-5  1-2-3-4.
    """

    def __init__(self, count):
        """Remember up to count trains."""
        # each is [time of its first contact (s), time of its last contact (s), last contact, runs]
        self.trains: deque[list] = deque(maxlen=count)

    def clear(self) -> None:
        """Forget all trains."""
        self.trains.clear()

    def add(self, time, left, right, rightwards) -> None:
        """Add the contact, at time (s), of the pendula with these indices (from 0).

        A run that ends at one of the two continues to the other. If there is none, a new run begins: to the right if
        rightwards is True, which means that the two moved to the right before, otherwise to the left.
        """
        if not self.trains or time - self.trains[-1][1] > GAP:
            self.trains.append([time, time, None, []])
        train = self.trains[-1]
        if train[2] != (left, right):  # contacts of the same two in a row are one impact
            pass_on(train[3], left + 1, right + 1, rightwards)
        train[1:3] = time, (left, right)

    def lines(self, longest=STRIP_WIDTH) -> list[str]:
        """Return a line for each train, the latest first, with at most `longest` characters: t = 0.71 s  1-2-3-4-5."""
        times = [f"t = {train[0]:.2f} s  " for train in reversed(self.trains)]
        lines = [time + runs for time, runs in zip(times, self.runs(), strict=True)]
        return [line if len(line) <= longest else line[: longest - 3] + "..." for line in lines]

    def runs(self) -> list[str]:
        """Return the runs of each train, the latest first, without times: 1-2-3-4-5."""
        return ["  ".join(map(written, train[3])) for train in reversed(self.trains)]


def written(run) -> str:
    """Return a run of bobs' numbers as text."""
    numbers = list(map(str, run))
    return "-".join(numbers if len(run) <= WHOLE else [*numbers[:3], "...", numbers[-1]])


def pass_on(runs, left, right, rightwards) -> None:
    """Add the hit of two bobs, by their numbers, to the first run in each direction that ends at one of them."""
    directions = (left, right), (right, left)
    ends = [next((run for run in runs if run[-1] == a and run[-2] != b), None) for a, b in directions]
    for run, (_, b) in zip(ends, directions, strict=True):
        if run:
            run.append(b)
    if not any(ends) and len(runs) < MOST:
        runs.append([left, right] if rightwards else [right, left])
