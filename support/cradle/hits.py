"""Hits of pendula: how they are noted while the loop does single ticks.

Slow hits, the sound and the measurement of an experiment all read the same record, Hit. The fast
path (many_ticks.py) makes it, too.
"""

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from functools import partial
from typing import Any, NamedTuple

from support.cradle.cradle import Cradle
from support.pendulum import Pendulum


class Hit(NamedTuple):
    """A hit of two neighbouring pendula, or of two double pendula."""

    tick: int  # the number of ticks since the release, with the one that made the hit
    left: int  # indices of pendula
    right: int
    speed: float  # at which they approached each other (m/s)
    # Copies of the two pendula, the left one first. The fast path makes none.
    before: tuple[Pendulum, ...] = ()
    after: tuple[Pendulum, ...] = ()


class Hits:
    """Notes the hits of single ticks: it stands in the place of the function that collides."""

    def __init__(self, cradle: Cradle):
        self.cradle = cradle
        self.noted: list[Hit] = []  # of the present batch
        self.tick = 0  # the number of the present tick
        self.replaced = ExitStack()  # puts the function back

    def listen(self) -> None:
        """Note the hits from now on, until stop."""
        names = self.cradle.tick_names
        name = self.cradle.collide_name
        if name in names:
            self.replaced.callback(names.__setitem__, name, names[name])
            names[name] = partial(self.note_hit, names[name])

    def stop(self) -> None:
        """Put the function back."""
        self.replaced.close()

    def note_hit(self, collide: Callable, /, *arguments: Any, **named: Any) -> Any:
        """Return the result of collide; note a hit if it changes the velocities of two pendula."""
        values = (*arguments, *named.values())
        pendula = [value for value in values if isinstance(value, dict)]
        before = [dict(pend) for pend in pendula]
        result = collide(*arguments, **named)
        if self.rates(pendula) != self.rates(before):
            indices = [self.index_of(pend) for pend in pendula]
            if len(set(indices)) == 2 and None not in indices:
                self.add(indices, before, [dict(pend) for pend in pendula])
        return result

    def rates(self, pendula: list[Pendulum]) -> list:
        """Return the angular velocities (rad/s) of these pendula."""
        return [pend.get(key) for pend in pendula for key in self.cradle.rate_keys]

    def index_of(self, pend: Pendulum) -> int | None:
        """Return the index of a pendulum by the place of its axle: so it can also be a copy."""
        objects = pend.get("objects")
        if not objects:
            return None
        return self.cradle.places.get(tuple(objects[0].pos.value))

    def add(self, indices: Sequence, before: Sequence[Pendulum], after: Sequence[Pendulum]) -> None:
        """Note a hit of two pendula, in any order: their indices, and copies of them."""
        left, right = indices
        if left > right:
            left, right = right, left
            before, after = before[::-1], after[::-1]
        speed = self.cradle.approach(*before)
        self.noted.append(Hit(self.tick, left, right, speed, tuple(before), tuple(after)))
