"""A stopwatch that counts half swings: the times from one stop of the bobs to the next one."""

from math import inf

# Parts of the energy that are kinetic: the bobs have nearly stopped, or are fast again.
SLOW = 0.3
FAST = 0.6


class Stopwatch:
    """Counts the moments at which the kinetic energy is least, as at the release."""

    def restart(self, time: float) -> None:
        """Begin at this time (s)."""
        self.count = -1  # half swings; the first stop only begins the first one
        self.start = time  # s: the first stop
        self.last_stop = time  # s: the end of the last half swing
        self.is_slow = False
        # Of this slow time: the least part, and when it was (s).
        self.least = inf
        self.least_time = time

    def measure(self, time: float, kinetic: float, total: float) -> None:
        """Take the energies (J) at this time (s)."""
        part = kinetic / total if total > 0 else 0.0
        if part < SLOW:
            if not self.is_slow:
                self.is_slow = True
                self.least = inf
            if part < self.least:
                self.least = part
                self.least_time = time
        elif part > FAST and self.is_slow:
            self.is_slow = False
            self.count += 1
            self.last_stop = self.least_time
            if self.count == 0:
                self.start = self.least_time

    def __str__(self) -> str:
        return f"{max(0, self.count)} in {self.last_stop - self.start:.2f} s"
