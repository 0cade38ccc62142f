"""Slow hits: at a series of hits, the time stands, and each hit waits until you go on."""

from collections.abc import Sequence
from math import inf
from reprlib import Repr
from typing import Any, NamedTuple

from support.cradle.hits import Hit
from support.cradle.motion import Motion, signed
from support.pendulum import Pendulum

MOST = 50  # hits in the table
VELOCITY = "velocity (m/s)"  # of a double pendulum, the mean one of its bobs

SHORT = Repr()  # writes a list of dictionaries as [{...}, {...}]
SHORT.maxlevel = 1


class SlowHit(NamedTuple):
    """A hit to show."""

    hit: Hit
    pend_list: list[Pendulum]  # all pendula as after it
    row: dict[str, Any]  # its texts


class SlowHits:
    """The hits of one series, in the order in which the ticks have made them."""

    def __init__(self, motion: Motion) -> None:
        self.motion = motion
        self.cradle = motion.cradle
        self.is_on = False
        self.clear()

    def switch(self, is_on: bool) -> None:
        self.is_on = is_on
        self.clear()

    def clear(self) -> None:
        """Forget all hits: for a new series, or a new cradle, or when Slow hits is switched."""
        self.series: list[SlowHit] = []
        self.place = 0  # in the series: of the hit that is shown, or of the next one that comes
        self.count = 0  # hits of the series
        self.last = -inf  # s: the time of its last hit
        self.is_left = False  # whether its hits do not wait any more

    def add(self, hits: Sequence[Hit]) -> None:
        """Take the fast ones of these hits of the last few ticks.

        No tick is done while a hit waits: so none waits now.
        """
        time = self.motion.time()  # s
        pend_list = list(self.cradle.pend_list)
        for hit in reversed(hits):  # back to the velocities before them
            pend_list[hit.left], pend_list[hit.right] = hit.before
        for hit in hits:
            pend_list[hit.left], pend_list[hit.right] = hit.after
            if hit.speed < self.motion.fast_speed:
                continue
            if time - self.last > 2 * self.cradle.series_pause:
                self.clear()
            self.last = time
            self.count += 1
            self.series.append(SlowHit(hit, list(pend_list), self.row(hit)))
        if self.is_left:
            self.leave()

    @property
    def current(self) -> SlowHit | None:
        """The hit that is shown, and waits until you go on."""
        return self.series[self.place] if self.place < len(self.series) else None

    def show_next(self) -> None:
        """Show the next hit; after the last one, none."""
        if self.current:
            self.place += 1

    def leave(self) -> None:
        """Take the rest of this series into the table, and show none of it."""
        self.is_left = True
        del self.series[:-MOST]
        self.place = len(self.series)

    def shown_pendula(self) -> list[Pendulum]:
        """Return the pendula as they are shown: as after the hit, or as they are now."""
        return self.current.pend_list if self.current else self.cradle.pend_list

    def state(self) -> list[dict[str, Any]]:
        """Return the hits of this series so far, at most MOST: a row of the table for each."""
        shown = self.series[: self.place + 1]
        return [{**hit.row, "now": hit is self.current} for hit in shown[-MOST:]]

    # --- texts ---------------------------------------------------------------------------------

    def row(self, hit: Hit) -> dict[str, Any]:
        """Return the call of a hit, and what it did to both bobs, as texts."""
        arguments = [self.argument_as_text(value) for value in hit.arguments]
        for name, value in hit.named.items():
            arguments.append(f"{name}={self.argument_as_text(value)}")
        bobs = [*map(self.changes, (hit.left, hit.right), hit.before, hit.after)]
        call = f"{self.cradle.collide_name}({', '.join(arguments)})"
        return {"call": f"{self.count}. {call}", "bobs": bobs}

    def argument_as_text(self, value: Any) -> str:
        """Return an argument as a programmer reads it: the place of a pendulum, or a value."""
        index = self.cradle.index_of(value)
        return SHORT.repr(value) if index is None else f"pend_list[{index}]"

    def changes(self, index: int, old: Pendulum, new: Pendulum) -> dict[str, str]:
        """Return what a hit did to a pendulum, by the headings of the table."""
        cradle, motion = self.cradle, self.motion
        texts = {"no.": str(index + 1)}
        for key in cradle.rate_keys:
            texts[f"{key} (rad/s)"] = change(old[key], new[key], motion.digits)
        texts[VELOCITY] = change(cradle.velocity(old), cradle.velocity(new), motion.digits)
        before, after, _ = motion.momenta([old, new])
        texts["momentum (kg m/s)"] = change(before, after, motion.momentum_digits)
        return texts


def change(old: float, new: float, digits: int) -> str:
    """Return a number before and after a hit, with this number of digits behind the point."""
    return f"{signed(old, digits)} → {signed(new, digits)}"
