"""The motion of a cradle: the time since its release, its impacts, its energy, and all these as
data.
"""

from math import inf

from support.cradle.cradle import Cradle
from support.cradle.impacts import ImpactTrains

# Of the speed of the fastest bob: a slower hit is not shown, for instance one of bobs that hang
LEAST = 0.1


class Motion:
    """Keeps the time, the impacts and the energy of a cradle."""

    def __init__(self, cradle: Cradle, impacts):
        """Begin at time 0; keep the last `impacts` trains of impacts."""
        self.cradle, self.trains = cradle, ImpactTrains(impacts, cradle.gap)
        self.restart()

    def restart(self) -> None:
        """Begin again at time 0, with the energy of this moment as 100 %."""
        # The speed (m/s) of the fastest hit that the page has not sounded yet
        self.ticks = 0
        self.fastest = 0.0
        # The number of hits, and the time (s) of the last fast one
        self.hits = 0
        self.last_fast = -inf
        self.trains.clear()
        self.set_start()

    def set_start(self) -> None:
        """Take the energy of this moment as 100 %, and find out which hits are fast."""
        self.start_energy = sum(self.cradle.energies())
        self.least = LEAST * max(self.cradle.top_speeds(), default=0.0)  # m/s

    def time(self) -> float:
        """Return the simulated time since the start (s)."""
        return round(self.ticks * self.cradle.dt, 9)  # 0.3, not 0.30000000000000004

    def note_hit(self, ticks, left, right, rightwards, speed) -> None:
        """Add a hit to the trains. ticks is its time, in ticks since the start; Hit explains the
        other arguments.
        """
        time = ticks * self.cradle.dt
        self.hits += 1
        if speed >= self.least:
            self.last_fast = time
        self.trains.add(time, left, right, rightwards, speed >= self.least)
        self.fastest = max(self.fastest, speed)

    def reading(self) -> str:
        """Return the time and the energy as text of constant width."""
        total, kinetic, potential = map(in_words, self.percents().values())
        return (
            f"t = {self.time():.2f} s".ljust(16)
            + f"energy {total} (kinetic {kinetic}, potential {potential})"
        )

    def percents(self) -> dict[str, float]:
        """Return the energy, and its kinetic and potential parts, in percent of the energy at the
        start.
        """
        kinetic, potential = self.cradle.energies()
        energies = {"energy": kinetic + potential, "kinetic": kinetic, "potential": potential}
        unit = self.start_energy / 100
        return {name: energy / unit if unit else 0.0 for name, energy in energies.items()}

    def sample(self) -> dict[str, float]:
        """Return the data of this moment by the names of the columns of a data file.

        They are t (s), the coordinates (rad, rad/s), the three energies (J), and the momentum to
        the right (kg m/s).
        """
        kinetic, potential = self.cradle.energies()
        energies = {"kinetic": kinetic, "potential": potential, "total": kinetic + potential}
        return {
            "t": self.time(),
            **self.cradle.coordinates(),
            **energies,
            "momentum": self.cradle.momentum(),
        }


def in_words(percent) -> str:
    """Return a percentage as text of constant width."""
    return f"{percent:6.2f} %" if percent < 1000 else " > 999 %"
