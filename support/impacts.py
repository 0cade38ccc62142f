"""The trains of impacts that run through a cradle, put together from the single contacts of two bobs."""

from collections import deque

GAP = 0.005  # s: contacts that follow one another within this time belong to one train
MOST = 12  # runs in a train: bobs that stay together go on touching for ever
LONGEST = 22  # characters of a train
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

    def add(self, time, left, rightwards) -> None:
        """Add the contact, at time (s), of the bob with this index (from 0) with its neighbour to the right.

        rightwards tells which one hits the other: whether the cradle's momentum is to the right.
        """
        if not self.trains or time - self.trains[-1][1] > GAP:
            self.trains.append([time, time, None, []])
        train = self.trains[-1]
        runs, hit = train[3], [left + 1, left + 2] if rightwards else [left + 2, left + 1]
        if train[2] != left:  # two bobs that touch tick after tick are one impact
            for run in runs:
                if run[-1] == hit[0] and run[-2] != hit[1]:
                    run.append(hit[1])
                    break
            else:
                if len(runs) < MOST:
                    runs.append(hit)
        train[1:3] = time, left

    def lines(self) -> list[str]:
        """Return a line for each train, the latest first: t = 0.71 s  1-2-3-4-5."""
        return [f"t = {start:.2f} s  {written(runs)}" for start, _, _, runs in reversed(self.trains)]


def written(runs) -> str:
    """Return these runs of bobs' numbers as text, cut off where it gets too long."""
    numbers = [list(map(str, run)) for run in runs]
    text = "  ".join("-".join(run if len(run) <= WHOLE else [*run[:3], "...", run[-1]]) for run in numbers)
    return text if len(text) <= LONGEST else text[:LONGEST] + "..."
