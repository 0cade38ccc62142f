"""Hits of pendula: how they are noted while the loop does single ticks.

The list of impacts, Slow hits and the sound all read the same record, Hit. The fast path
(many_ticks.py) makes it, too.
"""

from collections.abc import Callable, Sequence
from contextlib import ExitStack, suppress
from functools import partial
from inspect import signature
from itertools import accumulate
from math import isnan, sin
from typing import Any, NamedTuple

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.held_bob import HeldBob
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
    """Notes the hits of single ticks, and calls of functions: it stands in their places.

    It hears each call of the function that lets two pendula collide. If a tick does not call this
    function, the velocities after the tick show the hits.
    """

    def __init__(self, cradle: Cradle, held_bob: HeldBob):
        self.cradle = cradle
        self.held_bob = held_bob
        self.rate_keys = cradle.rate_keys
        self.noted: list[Hit] = []  # since the last call of forget
        self.calls: list[str] = []  # of the collision function, since then, as text
        self.tick = 0  # the number of the present tick
        self.has_heard = False  # whether it has called the function that lets two pendula collide
        self.thetas: list[Any] = []  # of single pendula before it (rad)
        self.omegas: list[Any] = []  # (rad/s)
        self.replaced = ExitStack()  # puts the functions back

    def forget(self) -> None:
        """Forget the hits and calls of the last batch of ticks."""
        self.noted.clear()
        self.calls.clear()

    def listen(self, with_calls: bool = False) -> None:
        """Note the hits from now on, until stop, but not of a held bob.

        Also note each call of shown_name, if with_calls is true: after many hits in one tick, inner
        bobs have their old velocity again.
        """
        if with_calls:
            self.replace(self.cradle.shown_name, self.note_call)
        if self.held_bob.index is None:
            self.replace(self.cradle.collide_name, self.note_hit)

    def stop(self) -> None:
        """Put the functions back."""
        self.replaced.close()

    def replace(self, name: str, wrapper: Callable) -> None:
        """Call wrapper in place of the function with this name, by all names that it has.

        wrapper gets this function as its first argument.
        """
        function = self.cradle.scope.get(name)
        if function is None:
            return
        for names in self.cradle.scope.maps:
            aliases = [alias for alias, value in names.items() if value is function]
            for alias in aliases:
                self.replaced.callback(names.__setitem__, alias, function)
                names[alias] = partial(wrapper, function)

    # --- a tick that calls the function --------------------------------------------------------

    def note_hit(self, collide: Callable, /, *arguments: Any, **named: Any) -> Any:
        """Return the result of collide, and note a hit of two pendula among its arguments."""
        self.has_heard = True
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
        return [pend.get(key) for pend in pendula for key in self.rate_keys]

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

    # --- a tick that does not call it ----------------------------------------------------------

    def begin_tick(self, tick: int) -> None:
        """Keep the state of single pendula before this tick."""
        self.tick = tick
        self.has_heard = False
        if len(self.rate_keys) == 1:
            self.thetas = [pend.get("theta") for pend in self.cradle.pend_list]
            self.omegas = [pend.get("omega") for pend in self.cradle.pend_list]

    def end_tick(self) -> None:
        """Note the hits of a tick of single pendula in which no function was heard."""
        pendula = self.cradle.pend_list
        is_held = self.held_bob.index is not None
        has_states = len(self.omegas) == len(pendula)  # not of double pendula
        if self.has_heard or is_held or not has_states:
            return
        # If a value is no number, require_same_pendula says so after these ticks.
        with suppress(KeyError, TypeError):
            self.add_seen_hits(pendula, self.without_hits())

    def without_hits(self) -> list[Pendulum]:
        """Return the pendula as they are after the tick if no bob was hit.

        omega becomes omega - g sin(theta) / R dt (handout, appendix).
        """
        pull = G / R_PARAM * self.cradle.dt
        states = zip(self.cradle.pend_list, self.thetas, self.omegas, strict=True)
        return [{**pend, "omega": omega - pull * sin(theta)} for pend, theta, omega in states]

    def add_seen_hits(self, pendula: list[Pendulum], unhit: list[Pendulum]) -> None:
        """Note the hits that have made the pendula of `unhit`, which nobody has hit yet.

        A hit keeps the momentum of its two bobs. So the hit of a bob and its right neighbour has
        passed on the momentum that all bobs up to this one have lost. All bobs together have lost
        none, except for rounding.
        """
        losses = [
            old["mass"] * (old["omega"] - new["omega"])
            for old, new in zip(unhit, pendula, strict=True)
        ]
        *passed_on, lost = accumulate(losses)  # kg/s: momentum, divided by r_param
        rounding = 1e-12 * sum(abs(pend["mass"] * pend["omega"]) for pend in unhit)
        if abs(lost) > rounding or isnan(lost):
            return  # this tick is not that of the handout
        for left, momentum in enumerate(passed_on):
            if abs(momentum) > rounding:
                before = unhit[left : left + 2]
                after = [dict(pend) for pend in before]
                after[0]["omega"] -= momentum / after[0]["mass"]
                after[1]["omega"] += momentum / after[1]["mass"]
                unhit[left : left + 2] = after
                self.add((left, left + 1), before, after)

    # --- One tick ------------------------------------------------------------------------------

    def note_call(self, collide: Callable, /, *arguments: Any, **named: Any) -> Any:
        """Return the result of collide, and note the call as text."""
        result = collide(*arguments, **named)
        bound = signature(collide).bind(*arguments, **named).arguments
        texts = [f"{name}={self.in_short(value)}" for name, value in bound.items()]
        call = f"{self.cradle.shown_name}({', '.join(texts)})"
        self.calls.append(f"{call} returned {self.in_short(result)}")
        return result

    def in_short(self, value: Any) -> str:
        """Return a value as short text; a pendulum is pend_list[...]."""
        if isinstance(value, dict):
            return f"pend_list[{self.index_of(value)}]"
        if isinstance(value, tuple):
            return f"({', '.join(map(self.in_short, value))})"
        return f"{value:.6g}" if isinstance(value, float) else repr(value)
