"""The numbers of the graph: curves over the last swings, or the phase picture of a pendulum."""

from collections import deque
from collections.abc import Sequence
from math import degrees, isfinite
from typing import Any, NamedTuple

from vpython import vector

SWINGS = 3  # small ones: a graph shows the time that they take
MOST_DRAWN = 20  # pendula in the graph: more curves could not be told apart

# Three colors of Okabe and Ito's palette, which look different to color-blind people, too.
ENERGIES = {"kinetic": "rgb(213, 94, 0)", "potential": "rgb(0, 114, 178)", "total": "rgb(0, 0, 0)"}
ENERGY, MOMENTA, NOTHING = "Energies", "Momenta", "no graph"
TIME = "t (s)"
DEGREES = degrees(1)  # in a rad


class Curve(NamedTuple):
    """A curve: its label in the legend, the name of its numbers in a sample, and its color."""

    label: str
    name: str
    color: str


class Choice(NamedTuple):
    """A graph that you can choose."""

    x: str  # the names of the axes
    y: str
    along: str  # the name of the numbers along x in a sample
    curves: list[Curve]
    # The drawn numbers are those of the sample times these.
    x_scale: float = 1.0
    y_scale: float = 1.0


class Graph:
    """Keeps the last samples of Motion, and gives the numbers of the chosen graph to graph.js."""

    def __init__(self, angle_keys: Sequence[str], rate_keys: Sequence[str], period: float) -> None:
        """Begin without samples; angle_keys and rate_keys are those of a pendulum.

        period (s) is that of a small swing.
        """
        self.angle_keys = angle_keys
        self.rate_keys = rate_keys
        self.seconds = SWINGS * period  # of the past that a graph shows
        self.rows: deque[dict[str, float]] = deque()  # the samples of this time
        self.chosen = ENERGY  # a key of choices, unless the present cradle has no such choice
        self.begin([], is_hidden=False)

    def begin(self, colors: Sequence[vector], is_hidden: bool) -> None:
        """Forget all samples, and take the colors (VPython's) of a new cradle's pendula.

        With is_hidden, there are only angles and their rates.
        """
        self.rows.clear()
        hues = [to_css(color) for color in colors[:MOST_DRAWN]]
        # By the name in the menu.
        self.choices: dict[str, Choice] = {}
        if not is_hidden:
            energies = [Curve(name, name, hue) for name, hue in ENERGIES.items()]
            self.choices[ENERGY] = Choice(TIME, "%", "t", energies)
            momenta = over_time("momentum", "kg m/s", hues, scale=1.0)
            momenta.curves.append(Curve("sum", "momentum", ENERGIES["total"]))
            self.choices[MOMENTA] = momenta
        for key in self.angle_keys:
            self.choices[f"Angles {key}"] = over_time(key, "degrees", hues)
        for key in self.rate_keys:
            self.choices[f"Velocities {key}"] = over_time(key, "degrees/s", hues)
        for number, hue in enumerate(hues, start=1):
            for angle, rate in zip(self.angle_keys, self.rate_keys, strict=True):
                name = f"Phase {number}"
                if len(self.angle_keys) > 1:
                    name += f", {angle}"
                self.choices[name] = phase_picture(angle, rate, number, hue)
        self.choices[NOTHING] = Choice("", "", "t", [])
        self.names = {"t"}  # of the numbers that a row has
        for choice in self.choices.values():
            self.names |= {choice.along, *(curve.name for curve in choice.curves)}

    def name(self) -> str:
        """Return the name of what is shown: your choice, if the present cradle has it."""
        return self.chosen if self.chosen in self.choices else next(iter(self.choices))

    def add(self, sample: dict[str, float]) -> None:
        """Add a sample, in place of one of the same time; forget those that are too old."""
        if self.rows and self.rows[-1]["t"] == sample["t"]:
            self.rows.pop()
        self.rows.append({name: sample[name] for name in self.names})
        while self.rows[0]["t"] < sample["t"] - self.seconds:
            self.rows.popleft()

    def show(self, name: str) -> None:
        """Show this one of the choices."""
        self.chosen = name

    def state(self, start_energy: float) -> dict[str, Any]:
        """Return the axes, the curves, and the rows; start_energy (J) is 100 %.

        A row has the number along x, and one for each curve. The x axis goes from "from" to "to",
        the y axis from "bottom" to "top"; where these are missing, graph.js lets flot choose them.
        """
        choice = self.choices[self.name()]
        if self.name() == ENERGY:
            choice = choice._replace(y_scale=100 / (start_energy or 1))
        state: dict[str, Any] = {
            "x": choice.x,
            "y": choice.y,
            "curves": [curve._asdict() for curve in choice.curves],
            "rows": [],
        }
        if choice.curves and self.rows:
            state["rows"] = self.numbers(choice)
            state |= self.limits(choice, state["rows"])
        return state

    def numbers(self, choice: Choice) -> list[list[float]]:
        """Return the rows of a graph; none that is not finite."""
        found = []
        for row in self.rows:
            numbers = [choice.x_scale * row[choice.along]]
            numbers += [choice.y_scale * row[curve.name] for curve in choice.curves]
            if all(map(isfinite, numbers)):
                found.append([round(number, 6) for number in numbers])
        return found

    def limits(self, choice: Choice, rows: list[list[float]]) -> dict[str, float]:
        """Return the ends of the axes that flot must not choose."""
        if choice.along != "t":  # a phase picture: the bob at rest is in its middle
            right = most(rows, 0)
            top = most(rows, 1)
            return {"from": -right, "to": right, "bottom": -top, "top": top}
        end = max(self.seconds, self.rows[-1]["t"])
        limits = {"from": end - self.seconds, "to": end}
        if self.name() == ENERGY:
            limits |= {"bottom": 0.0, "top": most(rows, len(choice.curves))}  # of the total
        return limits


def most(rows: Sequence[Sequence[float]], column: int) -> float:
    """Return the end of an axis that has room for all numbers in a column, and for some more."""
    return 1.05 * max([0.01, *(abs(row[column]) for row in rows)])


def to_css(color: vector) -> str:
    """Return a color of VPython, a vector, as CSS has it."""
    parts = [str(round(255 * part)) for part in color.value]
    return f"rgb({', '.join(parts)})"


def over_time(key: str, unit: str, hues: Sequence[str], scale: float = DEGREES) -> Choice:
    """Return the graph of numbers of all pendula, times a scale, in the colors of their bobs."""
    curves = []
    for number, hue in enumerate(hues, start=1):
        curves.append(Curve(str(number), f"{key}_{number}", hue))
    return Choice(TIME, f"{key} ({unit})", "t", curves, y_scale=scale)


def phase_picture(angle: str, rate: str, number: int, hue: str) -> Choice:
    """Return the graph of an angle and its rate, of the pendulum with this number."""
    curve = Curve("", f"{rate}_{number}", hue)
    x, y = f"{angle} (degrees)", f"{rate} (degrees/s)"
    return Choice(x, y, f"{angle}_{number}", [curve], DEGREES, DEGREES)
