"""Hits: how they are noted while the loop does ticks, and the list of impacts, with a line for each
train.

support/__init__.py says what a hit, a train and a path are. Two bobs that come in make two paths: 2-3-4-5  1-2-3-4.
"""

from collections import Counter, deque
from contextlib import ExitStack, suppress
from functools import partial
from inspect import signature
from itertools import accumulate
from math import isnan, sin
from typing import NamedTuple

from support.constants import G, R_PARAM

MOST_PATHS = 12  # in a train
TOGETHER = 20  # two bobs with more hits than this in one train stay together
LINE = 44  # characters of a line on the page
LONGEST_PATH = 9  # bobs: of a longer path, only the ends are shown


class Hit(NamedTuple):
    """A hit of two pendula; each of them is a copy of its dictionary."""

    left: int  # indices of pendula
    right: int
    rightwards: bool  # whether the two moved to the right before it
    speed: float  # at which they approached each other (m/s)
    before: list[dict]
    after: list[dict]


class Hits:
    """Notes the hits of single ticks, and calls of functions: it stands in their places, and calls
    them.

    It hears each call of the function that lets two pendula collide. If a tick does without this
    function, it sees the hits in the velocities after the tick.
    """

    def __init__(self, cradle):
        self.cradle, self.rate_keys = cradle, cradle.rate_keys
        self.new = list[Hit]()  # hits that are not yet in the list of impacts
        self.kept = list[Hit]()  # all hits since the last call of listen
        self.calls: list[str] = []  # of the collision function, as text
        # Whether the present tick has called the function that lets two pendula collide
        self.has_heard = False
        # theta (rad) and omega (rad/s) of each pendulum before the tick
        self.states: list[tuple] = []
        self.replaced = ExitStack()  # puts the functions back

    def listen(self, calls=False) -> None:
        """Note the hits from now on, until stop, but not of a held bob; with calls, also those of
        shown_name.

        After a train in one tick, inner bobs have their old velocity: so each call is noted.
        """
        self.calls.clear()
        self.kept.clear()
        if calls:
            self.replace(self.cradle.shown_name, self.note_call)
        if self.cradle.hand.held is None:
            self.replace(self.cradle.collide_name, self.note_hit)

    def stop(self) -> None:
        """Put the functions back."""
        self.replaced.close()

    def replace(self, name, stand_in) -> None:
        """Let stand_in, which gets the function with this name first, take its place, by all names
        that it has.
        """
        function = self.cradle.scope.get(name)
        if function is None:
            return
        for module in self.cradle.scope.maps:
            for own_name in [own_name for own_name, value in module.items() if value is function]:
                self.replaced.callback(module.__setitem__, own_name, function)
                module[own_name] = partial(stand_in, function)

    def note_hit(self, collide, /, *given, **named):
        """Call collide, and add a hit of two pendula to new and to kept."""
        self.has_heard = True
        pends = [value for value in (*given, *named.values()) if isinstance(value, dict)]
        before = [dict(pend) for pend in pends]
        result = collide(*given, **named)
        if self.rates(pends) != self.rates(before):
            places = [self.place_of(pend) for pend in pends]
            if len({*places}) == 2 and None not in places:
                self.add(places, before, [dict(pend) for pend in pends])
        return result

    def rates(self, pends) -> list:
        """Return the angular velocities (rad/s) of these pendula."""
        return [pend.get(key) for pend in pends for key in self.rate_keys]

    def place_of(self, pend) -> int | None:
        """Return the index of a pendulum, also of a copy of its dictionary, by the place of its
        axle.
        """
        axle, *_ = pend.get("objects") or [None]
        return self.cradle.places.get(tuple(axle.pos.value)) if axle else None

    def add(self, places, before, after) -> None:
        """Add a hit of two pendula, in any order: their indices, and copies of their dictionaries."""
        if places[0] > places[1]:
            places, before, after = places[::-1], before[::-1], after[::-1]
        left, right = places
        rightwards = sum(map(self.cradle.velocity, before)) > 0
        hit = Hit(left, right, rightwards, self.cradle.approach(*before), before, after)
        self.new.append(hit)
        self.kept.append(hit)

    def begin_tick(self) -> None:
        """Keep the state of a single cradle before a tick."""
        self.has_heard = False
        if self.rate_keys == ("omega",):
            self.states = [(pend.get("theta"), pend.get("omega")) for pend in self.cradle.pend_list]

    def end_tick(self) -> None:
        """Add the hits of a tick of single pendula that has not called the function that lets two
        pendula collide.
        """
        pends = self.cradle.pend_list
        is_seen = (
            not self.has_heard and self.cradle.hand.held is None and len(self.states) == len(pends)
        )
        if is_seen:
            # A value is no number: Cradle.check says so after these ticks
            with suppress(KeyError, TypeError):
                self.add_seen_hits(pends, self.without_hits())

    def without_hits(self) -> list[dict]:
        """Return the pendula as they are after the tick if no bob was hit.

        omega becomes omega - g sin(theta) / R dt (handout, appendix).
        """
        pull = G / R_PARAM * self.cradle.dt
        omegas = [omega - pull * sin(theta) for theta, omega in self.states]
        return [
            {**pend, "omega": omega}
            for pend, omega in zip(self.cradle.pend_list, omegas, strict=True)
        ]

    def add_seen_hits(self, pends, now) -> None:
        """Add the hits that have made the pendula `pends` of the pendula `now`, which nobody has
        hit yet.

        A hit keeps the momentum of its two bobs. So the hit of a bob and its right neighbour has
        passed on the momentum that all bobs up to this one have lost. All bobs together have lost
        none, except for rounding.
        """
        losses = [
            old["mass"] * (old["omega"] - new["omega"]) for old, new in zip(now, pends, strict=True)
        ]
        *passed_on, lost = accumulate(losses)  # kg/s: momentum, divided by r_param
        rounding = 1e-12 * sum(abs(pend["mass"] * pend["omega"]) for pend in now)
        if abs(lost) > rounding or isnan(lost):
            return  # this tick is not that of the handout
        for left, momentum in enumerate(passed_on):
            if abs(momentum) > rounding:
                before = now[left : left + 2]
                after = [dict(pend) for pend in before]
                after[0]["omega"] -= momentum / after[0]["mass"]
                after[1]["omega"] += momentum / after[1]["mass"]
                now[left : left + 2] = after
                self.add((left, left + 1), before, after)

    def note_call(self, collide, /, *given, **named):
        """Call collide, and add the call to calls."""
        result = collide(*given, **named)
        arguments = signature(collide).bind(*given, **named).arguments
        texts = [f"{name}={self.in_short(value)}" for name, value in arguments.items()]
        self.calls.append(
            f"{self.cradle.shown_name}({', '.join(texts)}) returned {self.in_short(result)}"
        )
        return result

    def in_short(self, value) -> str:
        """Return a value as short text; a pendulum is pend_list[...]."""
        if isinstance(value, dict):
            return f"pend_list[{self.place_of(value)}]"
        if isinstance(value, tuple):
            return f"({', '.join(map(self.in_short, value))})"
        return f"{value:.6g}" if isinstance(value, float) else repr(value)


class Train:
    """One train, or several that have become one; as text, its paths, or words."""

    def __init__(self, begin):
        self.begin = self.end = begin  # the times of its first and its last hit (s)
        self.paths: list[list[int]] = []
        self.hits: Counter[tuple[int, int]] = Counter()  # of each two bobs
        self.last = (0, 0)  # the bobs of the last fast hit
        self.together: set[tuple[int, int]] = set()  # each two that stay together

    def add(self, time, left, right, rightwards, is_fast) -> None:
        """Add a hit of two bobs, by their numbers; see ImpactTrains. A path has only fast hits."""
        pair = left, right
        if is_fast and not self.is_shown():
            self.begin = time
        if is_fast and pair != self.last:  # hits of the same two in a row count as one
            self.pass_on(left, right, rightwards)
            self.last = pair
        self.end = time
        self.hits[pair] += 1
        # N lifted bobs of a row hit the next one n times
        if self.hits[pair] > max(TOGETHER, len(self.hits)):
            self.together.add(pair)

    def pass_on(self, left, right, rightwards) -> None:
        """Continue the first path that ends at left, and the first one that ends at right; if none
        does, begin one.
        """
        goes_on = False
        # No path goes straight back to the bob before its last one
        for end, other in ((left, right), (right, left)):
            path = next(
                (path for path in self.paths if path[-1] == end and path[-2] != other), None
            )
            if path:
                path.append(other)
                goes_on = True
        if not goes_on and len(self.paths) < MOST_PATHS:
            self.paths.append([left, right] if rightwards else [right, left])

    def is_shown(self) -> bool:
        """Return whether a hit was fast, or bobs stay together."""
        return bool(self.paths or self.together)

    def join(self, later) -> None:
        """Take over a later train; the bobs of both stay together."""
        self.together |= later.together
        self.end, self.last, self.hits = later.end, later.last, later.hits

    def __str__(self):
        if self.together:
            groups = [
                f"{a} {'and' if b == a + 1 else 'to'} {b}" for a, b in first_and_last(self.together)
            ]
            return ", ".join(groups) + " stay together"
        paths = [[str(number) for number in path] for path in self.paths]
        return "  ".join(
            "-".join(p if len(p) <= LONGEST_PATH else [*p[:3], "...", p[-1]]) for p in paths
        )


class ImpactTrains:
    """The last trains, without hits of bobs that hardly move; bobs that stay together have a line
    of words.
    """

    def __init__(self, count, gap):
        """Keep the last `count` trains; gap (s) is the longest time between two hits of one train."""
        self.trains: deque[Train] = deque(maxlen=count)
        self.gap = gap
        self.clear()

    def clear(self) -> None:
        self.trains.clear()
        # Also while all its hits are slow, and it is not in trains
        self.latest: Train | None = None

    def add(self, time, left, right, rightwards, is_fast=True) -> None:
        """Add the hit, at time (s), of these pendula (indices); rightwards: whether they moved to
        the right before.
        """
        if not self.latest or time - self.latest.end > self.gap:
            self.latest = Train(time)
        self.latest.add(time, left + 1, right + 1, rightwards, is_fast)
        if self.latest.is_shown() and self.latest not in self.trains:
            self.trains.append(self.latest)
        if self.latest.together and len(self.trains) > 1 and self.trains[-2].together:
            self.trains.pop()
            self.trains[-1].join(self.latest)
            self.latest = self.trains[-1]

    def lines(self, longest=LINE) -> list[str]:
        """Return a line for each train, the latest first, with at most `longest` characters: t =
        0.71 s  1-2-3-4-5.
        """
        return [
            in_line(f"t = {train.begin:.2f} s  {train}", longest) for train in reversed(self.trains)
        ]


def in_line(text, longest) -> str:
    """Return a text with at most `longest` characters: of a longer one the beginning, and three
    dots.
    """
    return text if len(text) <= longest else text[: longest - 3] + "..."


def first_and_last(pairs) -> list[list[int]]:
    """Return the first and the last number of each group of bobs, from the pairs that stay
    together.
    """
    groups: list[list[int]] = []
    for left, right in sorted(pairs):
        if groups and left <= groups[-1][1]:
            groups[-1][1] = max(groups[-1][1], right)
        else:
            groups.append([left, right])
    return groups
