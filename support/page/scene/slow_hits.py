"""Slow hits: when a series of hits comes, the time holds, and you see one hit after the other."""

from collections import deque
from collections.abc import Sequence
from math import inf
from typing import NamedTuple

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.hits import Hit
from support.cradle.motion import digits_for, signed
from support.energy import energies
from support.pendulum import Pendulum

EACH = 1.2  # s that each hit is shown
FAINTEST = 0.3  # of the arrows of a hit
PINK = "Pink: the changes of momentum. "
CAPTION = "The program computes the hits pair by pair."
# Headings of the table; those WITH_MASS would tell a hidden value.
VELOCITY = "velocity (m/s)"
MEAN_VELOCITY = "mean velocity (m/s)"  # of a double pendulum's two bobs
WITH_MASS = "change of momentum (kg m/s)", "kinetic energy (J)"


class SlowHit(NamedTuple):
    """A hit to show."""

    hit: Hit
    number: int  # in its series
    pend_list: list[Pendulum]  # all pendula as after it


class SlowHits:
    """The hits to show, in the order in which a tick has made them."""

    def __init__(self, cradle: Cradle) -> None:
        self.cradle = cradle
        self.is_on = False
        self.clear()

    def switch(self, is_on: bool) -> None:
        """Show the hits slowly, or not."""
        self.is_on = is_on
        self.clear()

    def clear(self) -> None:
        """Forget waiting hits: for a new cradle, or when Slow hits is switched."""
        self.waiting: deque[SlowHit] = deque()
        self.current: SlowHit | None = None
        self.until = 0.0  # the time on the pace's clock at which the next one comes
        # Of this series: the number and the time (s) of its last hit.
        self.count = 0
        self.last = -inf

    def add(self, hits: Sequence[Hit], time: float, fast_speed: float) -> None:
        """Take the hits of the last few ticks that are not slower than fast_speed (m/s).

        time (s) is the simulated time.
        """
        pend_list = list(self.cradle.pend_list)
        for hit in reversed(hits):  # back to the velocities before them
            pend_list[hit.left], pend_list[hit.right] = hit.before
        for hit in hits:
            pend_list[hit.left], pend_list[hit.right] = hit.after
            if hit.speed < fast_speed:
                continue
            if time - self.last > 2 * self.cradle.series_pause:  # a new series
                self.count = 0
            self.count += 1
            self.last = time
            self.waiting.append(SlowHit(hit, self.count, list(pend_list)))

    def go_on(self, now: float, is_running: bool) -> None:
        """Go on to the next hit if it is due now (s), on the pace's clock.

        While the cradle is paused, a hit stays.
        """
        is_due = is_running and now >= self.until
        if self.current is None or is_due:
            self.show_next(now)

    def show_next(self, now: float) -> None:
        """Show the next hit from now (s) on, or none if there is none left."""
        self.current = self.waiting.popleft() if self.waiting else None
        self.until = now + EACH

    def shown_pendula(self) -> list[Pendulum]:
        """Return the pendula as they are shown: as after the hit, or as they are now."""
        return self.current.pend_list if self.current else self.cradle.pend_list

    def fade(self, now: float, is_running: bool) -> float:
        """Return how strong the arrows of a hit still are; 1 is full, as while paused.

        now (s) is on the pace's clock.
        """
        if self.current is None or not is_running:
            return 1.0
        return max(FAINTEST, round((self.until - now) / EACH, 2))

    def state(self) -> dict | None:
        """Return what the page says of the hit: rows of a table and a caption; or None."""
        if not self.current:
            return None
        hit = self.current.hit
        is_single = self.cradle.cord_count == 1
        is_hidden = bool(self.cradle.hidden)
        digits = digits_for(max(self.cradle.top_speeds()))
        heading = [f"Hit {self.current.number}", VELOCITY if is_single else MEAN_VELOCITY]
        if not is_hidden:
            heading += WITH_MASS
        rows = [heading]
        for i, old, new in zip((hit.left, hit.right), hit.before, hit.after, strict=True):
            before, after = self.shown_velocity(old), self.shown_velocity(new)
            row = [
                f"{'bob' if is_single else 'pendulum'} {i + 1}",
                f"{signed(before, digits)} → {signed(after, digits)}",
            ]
            if not is_hidden:
                change = self.cradle.whole_mass(new) * (after - before)
                row += [signed(change), f"{kinetic_as_text(old)} → {kinetic_as_text(new)}"]
            rows.append(row)
        return {"rows": rows, "caption": CAPTION if is_hidden else PINK + CAPTION}

    def shown_velocity(self, pend: Pendulum) -> float:
        """Return the velocity of a bob along its arc (m/s), as handle_collision has it.

        Of a double pendulum, it is the mean velocity of its bobs to the right.
        """
        if self.cradle.cord_count == 1:
            return R_PARAM * pend["omega"]
        return self.cradle.velocity(pend)


def kinetic_as_text(pend: Pendulum) -> str:
    """Return the kinetic energy of a pendulum (J) as text."""
    kinetic, _ = energies([pend], R_PARAM, G)
    return f"{kinetic:.3f}" if kinetic < 1e4 else f"{kinetic:.2e}"
