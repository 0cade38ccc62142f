"""The list of impacts: a line for each series of hits.

support/__init__.py says what a series and a chain are. Two bobs that come in make two chains:
2-3-4-5  1-2-3-4.
"""

from collections import Counter, deque

MOST_CHAINS = 12  # in a series
TOUCHES = 20  # two bobs with more hits than this in one series keep touching
LINE_LENGTH = 44  # characters of a line on the page
LONGEST_CHAIN = 9  # bobs: of a longer chain, only the ends are written

Pair = tuple[int, int]  # the numbers of two bobs, counted from 1, the left one first


class Series:
    """One series of hits, or several that have become one; as text, its chains, or a sentence."""

    def __init__(self, start: float):
        self.start = start  # s: the time of its first hit
        self.end = start  # s: the time of its last hit
        self.chains: list[list[int]] = []
        self.hits: Counter[Pair] = Counter()
        self.last: Pair = (0, 0)  # the bobs of the last fast hit
        self.touching: set[Pair] = set()  # the pairs that keep touching

    def add(self, time: float, pair: Pair, rightwards: bool, is_fast: bool) -> None:
        """Add a hit; see Impacts. A chain has only fast hits."""
        if is_fast:
            if not self.is_written():
                self.start = time
            if pair != self.last:  # hits of the same two in a row are one
                self.pass_on(pair, rightwards)
                self.last = pair
        self.end = time
        self.hits[pair] += 1
        # n lifted bobs of a row hit the next one n times.
        if self.hits[pair] > max(TOUCHES, len(self.hits)):
            self.touching.add(pair)

    def pass_on(self, pair: Pair, rightwards: bool) -> None:
        """Continue the first chain that ends at each bob of the pair; if none does, begin one."""
        left, right = pair
        goes_on = False
        for end, other in ((left, right), (right, left)):
            chain = self.chain_to(end, other)
            if chain:
                chain.append(other)
                goes_on = True
        if not goes_on and len(self.chains) < MOST_CHAINS:
            self.chains.append([left, right] if rightwards else [right, left])

    def chain_to(self, end: int, other: int) -> list[int] | None:
        """Return the first chain that ends at the bob `end`, and has not come from `other`."""
        for chain in self.chains:
            if chain[-1] == end and chain[-2] != other:
                return chain
        return None

    def is_written(self) -> bool:
        """Return whether a hit was fast, or bobs keep touching."""
        return bool(self.chains or self.touching)

    def join(self, later: "Series") -> None:
        """Take over a later series; the bobs of both keep touching."""
        self.touching |= later.touching
        self.end = later.end
        self.last = later.last
        self.hits = later.hits

    def __str__(self) -> str:
        if self.touching:
            return ", ".join(map(group_as_text, groups_of(self.touching))) + " keep touching"
        return "  ".join(map(chain_as_text, self.chains))


class Impacts:
    """The last series, without hits of bobs that hardly move."""

    def __init__(self, count: int, pause: float):
        """Keep the last `count` series; pause (s) is the longest time between two hits of one."""
        self.series: deque[Series] = deque(maxlen=count)
        self.pause = pause
        self.clear()

    def clear(self) -> None:
        self.series.clear()
        # Also while all its hits are slow, and it is not written.
        self.latest: Series | None = None

    def add(
        self, time: float, left: int, right: int, rightwards: bool, is_fast: bool = True
    ) -> None:
        """Add the hit, at time (s), of these pendula (indices), which moved rightwards, or not."""
        if not self.latest or time - self.latest.end > self.pause:
            self.latest = Series(time)
        self.latest.add(time, (left + 1, right + 1), rightwards, is_fast)
        if self.latest.is_written() and self.latest not in self.series:
            self.series.append(self.latest)
        if self.latest.touching and len(self.series) > 1 and self.series[-2].touching:
            self.series.pop()
            self.series[-1].join(self.latest)
            self.latest = self.series[-1]

    def lines(self, longest: int = LINE_LENGTH) -> list[str]:
        """Return a line for each series, the latest one first: t = 0.71 s  1-2-3-4-5.

        A line has at most `longest` characters.
        """
        return [
            in_line(f"t = {series.start:.2f} s  {series}", longest)
            for series in reversed(self.series)
        ]


def in_line(text: str, longest: int) -> str:
    """Return a text with at most `longest` characters: of a longer one the start, and dots."""
    return text if len(text) <= longest else text[: longest - 3] + "..."


def chain_as_text(chain: list[int]) -> str:
    """Return the numbers of a chain with dashes between them."""
    numbers = [str(number) for number in chain]
    if len(numbers) > LONGEST_CHAIN:
        numbers[3:-1] = ["..."]
    return "-".join(numbers)


def group_as_text(group: Pair) -> str:
    """Return the first and the last number of a group of bobs: 1 and 2, or 1 to 5."""
    first, last = group
    return f"{first} and {last}" if last == first + 1 else f"{first} to {last}"


def groups_of(pairs: set[Pair]) -> list[Pair]:
    """Return the first and the last number of each group of bobs that keep touching."""
    groups: list[Pair] = []
    for left, right in sorted(pairs):
        if groups and left <= groups[-1][1]:
            first, last = groups.pop()
            groups.append((first, max(last, right)))
        else:
            groups.append((left, right))
    return groups
