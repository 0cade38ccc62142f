"""Hits of pendula, and the rule of the programs: only bobs that approach each other collide.

Slow hits, the sound and the measurement of an experiment all read the same record, Hit.
"""

from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from math import cos
from typing import Any, NamedTuple

from support.cradle.cradle import Cradle
from support.cradle.settings import NextCradle
from support.pendulum import Pendulum


class Hit(NamedTuple):
    """A hit of two neighbouring pendula, or of two double pendula."""

    tick: int  # the number of ticks since the release, with the one that made the hit
    left: int  # indices of pendula
    right: int
    speed: float  # at which they approached each other (m/s)
    # Copies of the two pendula, the left one first.
    before: tuple[Pendulum, Pendulum]
    after: tuple[Pendulum, Pendulum]
    # Of the call that made it
    arguments: tuple
    named: dict[str, Any]


class Hits:
    """Stands in the place of the function that lets two pendula collide, while a program runs.

    The function gets only single pendula whose bobs approach each other. Hits are noted.
    """

    def __init__(self, cradle: Cradle, next_cradle: NextCradle):
        """The settings of next_cradle say whether the function gets separating bobs, too."""
        self.cradle = cradle
        self.next_cradle = next_cradle
        self.noted: list[Hit] = []  # of this batch
        self.has_rule = cradle.cord_count == 1
        self.replaced = ExitStack()  # puts the function back

    def listen(self) -> None:
        """Stand in for the function from now on, until stop; a run begins with this."""
        cradle = self.cradle
        names = cradle.tick_names
        name = cradle.collide_name
        self.tick = 0  # the number of this tick
        self.was_asked = False  # whether a tick of this run has called the function
        # Of each id of a pendulum with which the run began -> its index, and the pendulum
        self.known = {id(pend): (i, pend) for i, pend in enumerate(cradle.pend_list)}
        if name in names:
            self.replaced.callback(names.__setitem__, name, names[name])
            names[name] = partial(self.collide, names[name])

    def stop(self) -> None:
        """Put the function back."""
        self.replaced.close()

    def collide(self, function: Callable, /, *arguments: Any, **named: Any) -> Any:
        """Return the result of the function, and note a hit of two pendula.

        Do not call it for two pendula whose bobs do not approach each other. If its arguments are
        not two pendula, the function shows what is wrong.
        """
        self.was_asked = True
        try:  # the handout's call is the usual one, and must be quick
            pend1, pend2, _ = arguments
            pair = [self.known[id(pend1)], self.known[id(pend2)]]
        except (KeyError, ValueError):
            pair = self.pendula_among([*arguments, *named.values()])
        if len(pair) != 2 or pair[0] is pair[1]:
            return function(*arguments, **named)
        (index1, left), (index2, right) = pair
        if index1 > index2:
            index1, left, index2, right = index2, right, index1, left
        separating = self.next_cradle.settings.separating
        if self.has_rule and not separating and not are_approaching(left, right):
            return None
        before = dict(left), dict(right)
        result = function(*arguments, **named)
        for key in self.cradle.rate_keys:
            if left.get(key) != before[0].get(key) or right.get(key) != before[1].get(key):
                speed = self.cradle.approach(*before)
                after = dict(left), dict(right)
                self.noted.append(
                    Hit(self.tick, index1, index2, speed, before, after, arguments, named)
                )
                break
        return result

    def pendula_among(self, values: list) -> list[tuple[int, Pendulum]]:
        """Return the indices of the pendula among these values, and the pendula."""
        found: dict[Any, Pendulum] = {self.cradle.index_of(value): value for value in values}
        found.pop(None, None)
        return [*found.items()]


def are_approaching(left: Pendulum, right: Pendulum) -> bool:
    """Return whether the bobs of two pendula approach each other, also if these are no pendula.

    Touching bobs hang side by side, at nearly the same angle. So this compares their velocities
    along x, r_param omega cos(theta).
    """
    try:
        return left["omega"] * cos(left["theta"]) > right["omega"] * cos(right["theta"])
    except (ArithmeticError, LookupError, TypeError, ValueError):
        return True
