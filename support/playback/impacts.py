"""Combine single contacts of two bobs into the trains of impacts that run through a cradle."""

from collections import Counter, deque

GAP = 0.005  # s: the longest time between two contacts of one train
MOST = 12  # runs in a train, at most
TOGETHER = 20  # two bobs with more contacts than this in one train stay together
STRIP_WIDTH = 44  # characters
WHOLE = 9  # bobs: only the ends of a longer run are shown


class ImpactTrains:
    """The last trains of impacts. A train consists of runs: the numbers of bobs in the order of their hits, 1-2-3-4-5.

    If two bobs come in, one train has two runs: 2-3-4-5  1-2-3-4. Words sum up two things, which would otherwise push
    the trains out: single hits that follow each other, and bobs that stay together.
    """

    def __init__(self, count):
        """Remember up to count trains."""
        self.trains: deque[Train] = deque(maxlen=count)
        self.clear()

    def clear(self) -> None:
        """Forget all trains."""
        self.trains.clear()
        self.has_run = False  # whether a hit has run on to a third bob; two pendula have nothing but single hits

    def add(self, time, left, right, rightwards) -> None:
        """Add the contact, at time (s), of the pendula with these indices (from 0).

        A run that ends at one of the two continues to the other. If there is none, a new run begins: to the right if
        rightwards is True, which means that the two moved to the right before, otherwise to the left.
        """
        if not self.trains or time - self.trains[-1].end > GAP:
            self.sum_up()  # only now, because a single hit may have become a train
            self.trains.append(Train(time))
        train = self.trains[-1]
        train.add(time, left + 1, right + 1, rightwards)
        self.has_run = self.has_run or not train.is_single()
        if train.together:
            self.sum_up()

    def sum_up(self) -> None:
        """Make the last two trains one if both are single hits, or bobs that stay together."""
        if len(self.trains) < 2:
            return
        before, latest = self.trains[-2], self.trains[-1]
        if (before.together and latest.together) or (self.has_run and before.is_single() and latest.is_single()):
            before.take(self.trains.pop())

    def lines(self, longest=STRIP_WIDTH) -> list[str]:
        """Return a line for each train, the latest first, with at most `longest` characters: t = 0.71 s  1-2-3-4-5."""
        lines = [f"t = {train.begin:.2f} s  {train}" for train in reversed(self.trains)]
        return [line if len(line) <= longest else line[: longest - 3] + "..." for line in lines]


class Train:
    """A train of impacts, or several that are summed up; as text, 1-2-3-4-5, or the words that sum it up."""

    def __init__(self, begin):
        """Begin at the time of the first contact (s)."""
        self.begin = self.end = begin  # the times of its first and its last contact (s)
        self.runs: list[list[int]] = []
        self.contacts: Counter[tuple[int, int]] = Counter()  # of two bobs
        self.last = (0, 0)  # the last two
        self.together: set[tuple[int, int]] = set()  # each two that stay together
        self.singles = 0  # the single hits that it sums up

    def add(self, time, left, right, rightwards) -> None:
        """Add a contact of two bobs, by their numbers; see ImpactTrains."""
        pair = left, right
        if pair != self.last:  # contacts of the same two in a row are one impact
            pass_on(self.runs, left, right, rightwards)
        self.end, self.last = time, pair
        self.contacts[pair] += 1
        if self.contacts[pair] > max(TOGETHER, len(self.contacts)):  # a row of n lifted bobs gives n contacts
            self.together.add(pair)

    def is_single(self) -> bool:
        """Return whether no hit has run on to a third bob, and all bobs have parted again."""
        return not self.together and all(len(run) == 2 for run in self.runs)

    def take(self, later) -> None:
        """Sum up a later train of the same kind with this one."""
        if self.is_single():
            self.singles = (self.singles or len(self.runs)) + len(later.runs)
        self.together |= later.together
        self.end, self.last, self.contacts = later.end, later.last, later.contacts

    def __str__(self):
        if self.together:
            groups = [f"{a} {'and' if b == a + 1 else 'to'} {b}" for a, b in joined(self.together)]
            return ", ".join(groups) + " stay together"
        return f"{self.singles} single hits" if self.singles else "  ".join(map(written, self.runs))


def joined(pairs) -> list[list[int]]:
    """Return the first and the last number of each group of bobs, from the pairs that stay together."""
    groups: list[list[int]] = []
    for left, right in sorted(pairs):
        if groups and left <= groups[-1][1]:
            groups[-1][1] = max(groups[-1][1], right)
        else:
            groups.append([left, right])
    return groups


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
