"""Slow hits: when a train of hits comes, the time holds, and you see the hits one after another."""

from collections import deque
from math import inf

EACH = 1.2  # s that each hit is shown


class SlowHits:
    """The hits to show, in the order in which a tick has made them."""

    def __init__(self, cradle):
        self.cradle = cradle
        self.clear()

    def clear(self) -> None:
        """Forget all hits: the cradle is new, or its hits were not shown until now."""
        # Each is a Hit, its number in its train, and all pendula as after it
        self.waiting: deque[tuple] = deque()
        self.shown: tuple | None = None
        self.until = -inf  # the time on the pace's clock at which the next one comes
        # Of this train: the number and the time (s) of its last hit
        self.count = 0
        self.last = -inf

    def add(self, hits, time, least) -> None:
        """Take the hits of the last few ticks, at this simulated time (s), that are not slower than
        least (m/s).
        """
        pendula = list(self.cradle.pend_list)
        for hit in reversed(hits):  # back to the velocities before them
            pendula[hit.left], pendula[hit.right] = hit.before
        for hit in hits:
            pendula[hit.left], pendula[hit.right] = hit.after
            if hit.speed >= least:
                self.count = self.count + 1 if time - self.last <= 2 * self.cradle.gap else 1
                self.last = time
                self.waiting.append((hit, self.count, list(pendula)))

    def go_on(self, now) -> bool:
        """Go on to the next hit if it is due (now is the time on the pace's clock); return whether
        one is shown.
        """
        if not self.shown or now >= self.until:
            self.shown, self.until = (
                (self.waiting.popleft(), now + EACH) if self.waiting else (None, -inf)
            )
        return bool(self.shown)

    def words(self) -> dict | None:
        """Return what is shown now, in words: a title, lines and a note; or None."""
        if not self.shown:
            return None
        hit, number, _ = self.shown
        one, two = ("bob", "bobs") if len(self.cradle.angles) == 1 else ("pendulum", "pendula")
        moves = zip((hit.left, hit.right), hit.before, hit.after, strict=True)
        return {
            "title": f"Hit {number}: {two} {hit.left + 1} and {hit.right + 1}",
            "lines": [
                f"{one} {i + 1}: {self.velocity(old)} → {self.velocity(new)} m/s"
                for i, old, new in moves
            ],
            "note": "This order is the model's: a tick takes one pair after the other.",
        }

    def velocity(self, pend) -> str:
        """Return the (mean) velocity of a pendulum's bobs to the right (m/s)."""
        return f"{round(self.cradle.velocity(pend), 2) + 0.0:+.2f}"  # not -0.00
