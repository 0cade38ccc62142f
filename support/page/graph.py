"""The numbers of the graph: curves over the last swings, or the phase picture of a cord."""

from math import degrees, isfinite
from typing import Any, NamedTuple

from vpython import vector

from support.constants import R_PARAM
from support.cradle.cradle import Cradle
from support.cradle.motion import Sample
from support.energy import momentum

SWINGS = 3  # small ones: a graph shows the time that they take
MOST_DRAWN = 20  # pendula in the graph: more curves could not be told apart

# Three colors of Okabe and Ito's palette, which look different to color-blind people, too.
ENERGY = "Energies"
SUM = "rgb(0, 0, 0)"
ENERGIES = {"kinetic": "rgb(213, 94, 0)", "potential": "rgb(0, 114, 178)", "total": SUM}
DEGREES = degrees(1)  # in a rad


class Curve(NamedTuple):
    """A curve: its label in the legend, the names of its numbers in a sample, and its color."""

    label: int | str
    x: str
    y: str
    color: str


class Graph:
    """Keeps the last samples of Motion, and gives the curves of the chosen graph to graph.js."""

    def __init__(self, cradle: Cradle) -> None:
        self.cradle = cradle
        self.span = SWINGS * cradle.period  # s of the past that a graph shows
        self.chosen = "Momenta"

    def begin(self) -> None:
        """Begin with a new cradle, without samples."""
        self.samples: dict[float, Sample] = {}  # by their time (s)
        cradle = self.cradle
        colored = [*enumerate(map(legible, cradle.colors()[:MOST_DRAWN]), start=1)]

        def curves(x: str, y: str) -> list[Curve]:
            """Return a curve for each pendulum; its number takes the place of {} in x and y."""
            return [Curve(i, x.format(i), y.format(i), color) for i, color in colored]

        momenta = [*curves("t", "momentum_{}"), Curve("sum", "t", "momentum", SUM)]
        energies = [Curve(name, "t", name, color) for name, color in ENERGIES.items()]
        # By the name in the menu: the names of the axes, the curves, and a factor for their
        # numbers, but not for t.
        self.choices: dict[str, tuple[str, list[Curve], float]] = {
            "Momenta": ("horizontal momentum (kg m/s) over t (s)", momenta, 1),
            ENERGY: ("energy (%) over t (s)", energies, 100),
        }
        for angle, rate in zip(cradle.angle_keys, cradle.rate_keys, strict=True):
            angles, rates = angle + "_{}", rate + "_{}"
            in_degrees, in_rates = f"{angle} (degrees)", f"{rate} (degrees/s)"
            over_time = curves("t", angles)
            self.choices[f"Angles {angle}"] = f"{in_degrees} over t (s)", over_time, DEGREES
            over_time = curves("t", rates)
            self.choices[f"Velocities {rate}"] = f"{in_rates} over t (s)", over_time, DEGREES
            phases = curves(angles, rates)
            self.choices[f"Phase {angle}"] = f"{in_rates} over {in_degrees}", phases, DEGREES

    def names(self) -> list[str]:
        return [*self.cradle.without_hidden(self.choices)]

    def name(self) -> str:
        """Return the name of the graph: the one you chose, or the angles while it is hidden."""
        return self.chosen if self.chosen in self.names() else "Angles theta"

    def add(self, sample: Sample) -> None:
        """Add a sample of this moment, in place of one of the same time; forget those too old."""
        pendula = enumerate(self.cradle.pend_list, start=1)
        momenta = {f"momentum_{i}": momentum([pend], R_PARAM) for i, pend in pendula}
        now = sample["t"]
        while (oldest := next(iter(self.samples), now)) < now - self.span:
            del self.samples[oldest]
        self.samples[now] = sample | momenta

    def state(self, start_energy: float) -> dict[str, Any]:
        """Return the names of the axes, the curves, and columns of numbers by name.

        start_energy (J) is 100 %. A number that is not finite is None. The x axis goes from "from"
        to "to", the y axis begins at "bottom"; where these are missing, flot chooses them.
        """
        axes, curves, scale = self.choices[self.name()]
        state: dict[str, Any] = {"axes": axes, "curves": curves}
        if self.name() == ENERGY:
            scale /= start_energy or 1
            state["bottom"] = 0
        names = {name for curve in curves for name in (curve.x, curve.y)}
        if "t" in names:
            end = max(self.span, *self.samples)
            state |= {"from": end - self.span, "to": end}
        state["columns"] = {name: self.column(name, scale) for name in names}
        state["columns"]["t"] = [*self.samples]
        return state

    def column(self, name: str, scale: float) -> list[float | None]:
        """Return the numbers of the samples with this name, times a scale."""
        numbers = [scale * sample[name] for sample in self.samples.values()]
        return [round(number, 4) if isfinite(number) else None for number in numbers]


def legible(color: vector) -> str:
    """Return a color as to_css does, but half as light if one can hardly see it on white."""
    is_pale = 0.3 * color.x + 0.59 * color.y + 0.11 * color.z > 0.75
    return to_css(color / 2 if is_pale else color)


def to_css(color: vector) -> str:
    """Return a color of VPython, a vector, as CSS has it."""
    return f"rgb{tuple(round(255 * part) for part in color.value)}"
