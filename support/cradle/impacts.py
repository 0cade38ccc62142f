"""Hits: how they are noted while the loop does ticks, and the list of impacts, with a line for each train.

support/__init__.py says what a hit, a train and a path are. Two bobs that come in make two paths: 2-3-4-5  1-2-3-4.
"""

from collections import Counter, deque
from contextlib import ExitStack
from functools import partial
from inspect import signature
from typing import NamedTuple

from support.start.mistake import MistakeError

GAP = 0.005  # s: the longest time between two hits of one train
MOST_PATHS = 12  # in a train
TOGETHER = 20  # two bobs with more hits than this in one train stay together
STRIP_WIDTH = 44  # characters
LONGEST_PATH = 9  # bobs: of a longer path, only the ends are shown
UNASKED = 100_000  # ticks that a loop may do without asking whether the cradle runs: more than one does on purpose


class Hit(NamedTuple):
    """A hit of two pendula; each of them is a copy of its dictionary."""

    left: int  # indices of pendula
    right: int
    rightwards: bool  # whether the two moved to the right before it
    speed: float  # at which they approached each other (m/s)
    before: list[dict]
    after: list[dict]


class Hits:
    """Notes hits, and calls of the function that lets two pendula collide: it stands in its place, and calls it."""

    def __init__(self, cradle):
        self.cradle = cradle
        self.new = list[Hit]()  # hits that are not yet in the list of impacts
        self.kept = list[Hit]()  # all hits since the last call of listen
        self.calls: list[str] = []  # of the collision function, as text
        self.unasked = 0  # ticks of the loop since it was last told to do one
        self.replaced = ExitStack()  # puts the functions back

    def listen(self, calls=False) -> None:
        """Note the hits from now on, until stop, but not of a held bob; with calls, also those of shown_name.

        To compare before and after a whole tick would miss hits: after a train, the inner bobs have their old velocity.
        """
        self.calls.clear()
        self.kept.clear()
        scope = self.cradle.collision_scope()
        if calls:
            self.replace(scope, self.cradle.shown_name, self.note_call)
        if self.cradle.hand.held is None:
            self.replace(scope, self.cradle.collide_name, self.note_hit)

    def count_ticks(self, loop) -> None:
        """Only count the ticks of the loop from now on, until stop; raise a MistakeError after UNASKED."""
        self.stop()
        self.replace(self.cradle.scope, self.cradle.tick_name, partial(self.count_tick, loop))

    def stop(self) -> None:
        """Put the functions back."""
        self.replaced.close()

    def replace(self, scope, name, stand_in) -> None:
        """Let stand_in, which gets the function with this name in scope first, take its place, if there is one."""
        if name in scope:
            self.replaced.callback(scope.__setitem__, name, scope[name])
            scope[name] = partial(stand_in, scope[name])

    def count_tick(self, loop, tick, /, *given, **named):
        """Call tick, or raise the error of count_ticks."""
        self.unasked += 1
        if self.unasked > UNASKED:
            words = f"called {tick.__name__} {UNASKED} times, and page.is_running() was not True in between."
            raise MistakeError(loop, words)
        return tick(*given, **named)

    def note_hit(self, collide, /, *given, **named):
        """Call collide, and add a hit of two pendula to new and to kept."""

        def rates(pends):
            return [pend.get(key) for pend in pends for key in self.cradle.rate_keys]

        cradle, numbers = self.cradle, self.cradle.numbers
        pends = [pend for pend in (*given, *named.values()) if id(pend) in numbers]
        pends.sort(key=lambda pend: numbers[id(pend)])  # the left one comes first
        before = [dict(pend) for pend in pends]
        result = collide(*given, **named)
        if len(pends) == 2 and rates(pends) != rates(before):
            left, right = (numbers[id(pend)] for pend in pends)
            rightwards = sum(map(cradle.velocity, before)) > 0
            hit = Hit(left, right, rightwards, cradle.approach(*before), before, [dict(pend) for pend in pends])
            self.new.append(hit)
            self.kept.append(hit)
        return result

    def note_call(self, collide, /, *given, **named):
        """Call collide, and add the call to calls."""
        result = collide(*given, **named)
        arguments = signature(collide).bind(*given, **named).arguments
        texts = [f"{name}={self.in_short(value)}" for name, value in arguments.items()]
        self.calls.append(f"{self.cradle.shown_name}({', '.join(texts)}) returned {self.in_short(result)}")
        return result

    def in_short(self, value) -> str:
        """Return a value as short text; a pendulum is pend_list[...]."""
        if id(value) in self.cradle.numbers:
            return f"pend_list[{self.cradle.numbers[id(value)]}]"
        if isinstance(value, tuple):
            return f"({', '.join(map(self.in_short, value))})"
        return f"{value:.6g}" if isinstance(value, float) else repr(value)


class ImpactTrains:
    """The last trains, without single hits of bobs that hardly move; bobs that stay together have a line of words."""

    def __init__(self, count):
        self.trains: deque[Train] = deque(maxlen=count)
        self.clear()

    def clear(self) -> None:
        self.trains.clear()
        self.has_path = False  # whether a hit has gone on to a third bob; with two pendula, all hits are single

    def add(self, time, left, right, rightwards) -> None:
        """Add the hit, at time (s), of these pendula (indices); rightwards: whether they moved to the right before."""
        if not self.trains or time - self.trains[-1].end > GAP:
            if self.trains and self.is_noise(self.trains[-1]):  # not earlier: a hit that was single could go on
                self.trains.pop()
            self.trains.append(Train(time))
        train = self.trains[-1]
        train.add(time, left + 1, right + 1, rightwards)
        self.has_path = self.has_path or not train.is_single()
        if train.together and len(self.trains) > 1 and self.trains[-2].together:
            self.trains.pop()
            self.trains[-1].join(train)

    def is_noise(self, train) -> bool:
        """Return whether a train is a single hit of a cradle whose hits can go on to a third bob."""
        return self.has_path and train.is_single()

    def lines(self, longest=STRIP_WIDTH) -> list[str]:
        """Return a line for each train, the latest first, with at most `longest` characters: t = 0.71 s  1-2-3-4-5."""
        lines = [f"t = {train.begin:.2f} s  {train}" for train in reversed(self.trains) if not self.is_noise(train)]
        return [line if len(line) <= longest else line[: longest - 3] + "..." for line in lines]


class Train:
    """One train, or several that have become one; as text, its paths, or words."""

    def __init__(self, begin):
        self.begin = self.end = begin  # the times of its first and its last hit (s)
        self.paths: list[list[int]] = []
        self.hits: Counter[tuple[int, int]] = Counter()  # of each two bobs
        self.last = (0, 0)  # the bobs of the last hit
        self.together: set[tuple[int, int]] = set()  # each two that stay together

    def add(self, time, left, right, rightwards) -> None:
        """Add a hit of two bobs, by their numbers; see ImpactTrains."""
        pair = left, right
        if pair != self.last:  # hits of the same two in a row count as one
            self.pass_on(left, right, rightwards)
        self.end, self.last = time, pair
        self.hits[pair] += 1
        if self.hits[pair] > max(TOGETHER, len(self.hits)):  # n lifted bobs of a row hit the next one n times
            self.together.add(pair)

    def pass_on(self, left, right, rightwards) -> None:
        """Continue the first path that ends at left, and the first one that ends at right; if none does, begin one."""
        goes_on = False
        for end, other in ((left, right), (right, left)):  # no path goes straight back to the bob before its last one
            path = next((path for path in self.paths if path[-1] == end and path[-2] != other), None)
            if path:
                path.append(other)
                goes_on = True
        if not goes_on and len(self.paths) < MOST_PATHS:
            self.paths.append([left, right] if rightwards else [right, left])

    def is_single(self) -> bool:
        """Return whether no hit has gone on to a third bob, and all bobs have parted again."""
        return not self.together and all(len(path) == 2 for path in self.paths)

    def join(self, later) -> None:
        """Take over a later train; the bobs of both stay together."""
        self.together |= later.together
        self.end, self.last, self.hits = later.end, later.last, later.hits

    def __str__(self):
        if self.together:
            groups = [f"{a} {'and' if b == a + 1 else 'to'} {b}" for a, b in first_and_last(self.together)]
            return ", ".join(groups) + " stay together"
        paths = [[str(number) for number in path] for path in self.paths]
        return "  ".join("-".join(p if len(p) <= LONGEST_PATH else [*p[:3], "...", p[-1]]) for p in paths)


def first_and_last(pairs) -> list[list[int]]:
    """Return the first and the last number of each group of bobs, from the pairs that stay together."""
    groups: list[list[int]] = []
    for left, right in sorted(pairs):
        if groups and left <= groups[-1][1]:
            groups[-1][1] = max(groups[-1][1], right)
        else:
            groups.append([left, right])
    return groups
