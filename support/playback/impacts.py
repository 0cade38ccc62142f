"""The trains of impacts that run through a cradle, put together from the single contacts of two bobs."""

from collections import deque

GAP = 0.005  # s: contacts that follow one another within this time belong to one train
MOST = 12  # runs in a train: bobs that stay together go on touching for ever
LINE = 36  # characters, beside the panel
WHOLE = 9  # bobs: of a longer run only its ends are written


class ImpactTrains:
    """The last trains of impacts, as the numbers of the bobs in the order in which they were hit, as in 1-2-3-4-5.

    Where two bobs come in, two such runs go through the row in one train: 2-3-4-5  1-2-3-4.
    """

    def __init__(self, count):
        """Remember up to count trains."""
        # each [time of its first contact, of its last (s), last contact, runs]
        self.trains: deque[list] = deque(maxlen=count)

    def clear(self) -> None:
        """Forget all trains."""
        self.trains.clear()

    def add(self, time, left, right, rightwards) -> None:
        """Add the contact, at time (s), of the pendula with these indices (from 0).

        A run that has come to one of the two goes on to the other. Where none has, a new run begins, to the right or to
        the left as the two were moving before.
        """
        if not self.trains or time - self.trains[-1][1] > GAP:
            self.trains.append([time, time, None, []])
        train = self.trains[-1]
        if train[2] != (left, right):  # two that touch tick after tick are one impact
            pass_on(train[3], left + 1, right + 1, rightwards)
        train[1:3] = time, (left, right)

    def lines(self, longest=LINE) -> list[str]:
        """Return a line for each train, the latest first, of so many characters at most: t = 0.71 s  1-2-3-4-5."""
        times = [f"t = {train[0]:.2f} s  " for train in reversed(self.trains)]
        lines = [time + runs for time, runs in zip(times, self.runs(), strict=True)]
        return [line if len(line) <= longest else line[: longest - 3] + "..." for line in lines]

    def runs(self) -> list[str]:
        """Return the same without the times: 1-2-3-4-5."""
        return ["  ".join(map(written, train[3])) for train in reversed(self.trains)]


def written(run) -> str:
    """Return a run of bobs' numbers as text."""
    numbers = list(map(str, run))
    return "-".join(numbers if len(run) <= WHOLE else [*numbers[:3], "...", numbers[-1]])


def pass_on(runs, left, right, rightwards) -> None:
    """Pass a hit between the bobs with these numbers on: in each direction the first run that has come to them."""
    directions = (left, right), (right, left)
    ends = [next((run for run in runs if run[-1] == a and run[-2] != b), None) for a, b in directions]
    for run, (_, b) in zip(ends, directions, strict=True):
        if run:
            run.append(b)
    if not any(ends) and len(runs) < MOST:
        runs.append([left, right] if rightwards else [right, left])
