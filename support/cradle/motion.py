"""The motion of a cradle: the time since its release, its hits, and its energy; also as data."""

from math import degrees, inf, pi, remainder

from support.constants import G, R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.hits import Hit
from support.energy import energies, momentum
from support.pendulum import Pendulum

Sample = dict[str, float]  # the data of a moment, by the names of the columns of a data file

# Of the speed of the fastest bob: a slower hit is not shown, for instance one of bobs that hang.
FAST_PART = 0.1
TOGETHER = 0.1  # bobs whose angles differ by less than this part swing together
DIGITS = 2  # of a speed or a momentum behind the point; slow cradles need more
KEPT = 1e-3  # of the momenta in a hit: a smaller change of their sum does not count


class Motion:
    """Keeps the time, the energy of a cradle, and what its hits have done."""

    def __init__(self, cradle: Cradle):
        self.cradle = cradle
        self.restart()

    def restart(self) -> None:
        """Begin again at time 0, with the energy of this moment as 100 %."""
        self.ticks = 0
        self.loudest = 0.0  # m/s: the speed of the fastest hit that the page has not sounded yet
        self.hit_count = 0  # the number of hits
        self.has_kept_momentum = True  # whether each hit has kept the momentum of its pendula
        self.last_fast = -inf  # s: the time of the last fast hit
        self.set_start()

    def set_start(self) -> None:
        """Take the energy of this moment as 100 %, and find out how large all numbers can be."""
        self.start_energy = sum(self.cradle.energies())
        top_speed = max(self.cradle.top_speeds(), default=0.0)  # m/s
        self.fast_speed = FAST_PART * top_speed
        self.most_momentum = self.cradle.most_momentum() or 1.0  # kg m/s
        # Behind the point: of the speeds, and of the momenta.
        self.digits = digits_for(top_speed)
        self.momentum_digits = digits_for(self.most_momentum)

    def time(self) -> float:
        """Return the simulated time since the start (s)."""
        return round(self.ticks * self.cradle.dt, 9)  # 0.3, not 0.30000000000000004

    def note_hit(self, hit: Hit) -> None:
        """Count a hit; keep its speed, its time if it was fast, and whether it kept momentum."""
        self.hit_count += 1
        self.has_kept_momentum = self.has_kept_momentum and keeps_momentum(hit)
        if hit.speed >= self.fast_speed:
            self.last_fast = hit.tick * self.cradle.dt
        self.loudest = max(self.loudest, hit.speed)

    def summary(self) -> str:
        """Return the farthest bobs and their angle, for a screen reader."""
        angles = [degrees(remainder(theta, 2 * pi)) for theta in self.cradle.values("theta")]
        angle = max(angles, key=abs)
        farthest = []
        for bob, other in enumerate(angles, start=1):
            if abs(other - angle) <= TOGETHER * abs(angle):
                farthest.append(str(bob))
        noun = self.cradle.theta_bob if len(farthest) == 1 else f"{self.cradle.theta_bob}s"
        bobs = f"{noun} {', '.join(farthest)}"
        side = "left" if angle < 0 else "right"
        return f"{bobs} at {abs(angle):.0f} degrees {side}"

    def energy_percent(self, pend_list: list[Pendulum] | None = None) -> float:
        """Return the energy of these pendula in percent of that at the start.

        None stands for those of the cradle. Without energy at the start, it is 0.
        """
        energy = sum(energies(pend_list or self.cradle.pend_list, R_PARAM, G))
        return 100 * energy / self.start_energy if self.start_energy else 0.0

    def momenta(self, pend_list: list[Pendulum]) -> list[float]:
        """Return the horizontal momentum of each of these pendula, and the sum (kg m/s)."""
        momenta = [momentum([pend], R_PARAM) for pend in pend_list]
        return [*momenta, momentum(pend_list, R_PARAM)]

    def sample(self) -> Sample:
        """Return the data of this moment by the names of the columns of a data file.

        They are t (s), the coordinates (rad, rad/s), the three energies (J), and the momentum to
        the right (kg m/s).
        """
        kinetic, potential = self.cradle.energies()
        return {
            "t": self.time(),
            **self.cradle.coordinates(),
            "kinetic": kinetic,
            "potential": potential,
            "total": kinetic + potential,
            "momentum": momentum(self.cradle.pend_list, R_PARAM),
        }


def keeps_momentum(hit: Hit) -> bool:
    """Return whether a hit has kept the momentum of its pendula."""
    size = sum(abs(momentum([pend], R_PARAM)) for pend in (*hit.before, *hit.after))
    change = momentum([*hit.after], R_PARAM) - momentum([*hit.before], R_PARAM)
    return abs(change) <= KEPT * size


def percent_as_text(percent: float) -> str:
    """Return a percentage as text.

    More decimals would show the errors of the tick.
    """
    return f"{percent:.1f} %" if percent < 1000 else "> 999 %"


def digits_for(largest: float) -> int:
    """Return how many digits behind the point the speeds, or the momenta, of a cradle need."""
    digits = DIGITS
    while 0 < largest * 10**digits < 50:
        digits += 1
    return digits


def signed(number: float, digits: int) -> str:
    """Return a momentum, or a velocity, as text with its sign; 0 has none."""
    if abs(number) >= 1e4:
        return f"{number:+.2e}"
    number = round(number, digits)
    return f"{number:+.{digits}f}" if number else f"{0:.{digits}f}"
